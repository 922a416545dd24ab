//! What lies in the arena: hub, site and items; and where the agents stand.

use super::grid::{Grid, squared_distance};
use super::params::Params;
use crate::fingerprint::Fingerprint;
use crate::random::{Stream, direction};
use rand::RngExt;

/// A disc on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// The centre, in arena units.
    pub centre: [f64; 2],
    /// The radius, in arena units.
    pub radius: f64,
}

impl Disc {
    /// True inside and on the rim.
    #[must_use]
    pub fn contains(&self, point: [f64; 2]) -> bool {
        squared_distance(self.centre, point) <= self.radius * self.radius
    }
}

/// Where an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemState {
    /// On the ground, to be picked up.
    Free,
    /// With an agent.
    Carried,
    /// In the hub, for good.
    Delivered,
}

/// The arena with all that agents sense and move.
#[derive(Clone, Debug)]
pub struct Field {
    /// Coordinates lie in `[-half, half]`.
    pub half: f64,
    /// Where food is brought to and agents start: at the origin.
    pub hub: Disc,
    /// Where food lies at the start.
    pub site: Disc,
    /// Where each agent stands.
    pub agents: Grid,
    /// Items on the ground.
    pub items: Grid,
    states: Vec<ItemState>,
    delivered: u32,
    carried: u32,
}

impl Field {
    /// Places the site at a random angle, the items uniformly in it, and the agents at the hub's centre.
    ///
    /// Source: BeTr-GEESE, sections 4.2 and 4.3. How items lie within the site is our choice.
    #[must_use]
    pub fn new(params: &Params, placement: &mut Stream) -> Self {
        let [x, y] = direction(placement);
        let centre = [x * params.site_distance, y * params.site_distance];
        let site = Disc { centre, radius: params.site_radius };
        let mut items = Grid::new(params.half(), params.item_count());
        for id in 0..params.item_count() {
            items.put(id, within(&site, placement));
        }
        let mut agents = Grid::new(params.half(), params.agents);
        (0..params.agents).for_each(|id| agents.put(id, [0.0; 2]));
        Self {
            half: params.half(),
            hub: Disc { centre: [0.0; 2], radius: params.hub_radius },
            site,
            agents,
            items,
            states: vec![ItemState::Free; params.item_count() as usize],
            delivered: 0,
            carried: 0,
        }
    }

    /// The nearest free item within `reach` of `place`; of equally near ones that with the smallest number.
    #[must_use]
    pub fn nearest_item(&self, place: [f64; 2], reach: f64) -> Option<u32> {
        let mut nearest: Option<(f64, u32)> = None;
        self.items.near(place, reach, |item, distance| {
            if nearest.is_none_or(|best| (distance, item) < best) {
                nearest = Some((distance, item));
            }
        });
        nearest.map(|(_, item)| item)
    }

    /// Takes a free item from the ground.
    pub fn pick_up(&mut self, item: u32) {
        self.items.remove(item);
        self.states[item as usize] = ItemState::Carried;
        self.carried += 1;
    }

    /// Puts a carried item down: in the hub it is delivered, elsewhere it lies on the ground again.
    pub fn put_down(&mut self, item: u32, place: [f64; 2]) {
        self.carried -= 1;
        if self.hub.contains(place) {
            self.states[item as usize] = ItemState::Delivered;
            self.delivered += 1;
        } else {
            self.states[item as usize] = ItemState::Free;
            self.items.put(item, place);
        }
    }

    /// Where each item is, by number.
    #[must_use]
    pub fn item_states(&self) -> &[ItemState] {
        &self.states
    }

    /// Items delivered so far.
    #[must_use]
    pub fn delivered(&self) -> u32 {
        self.delivered
    }

    /// Items with agents now.
    #[must_use]
    pub fn carried(&self) -> u32 {
        self.carried
    }

    /// Feeds places, items and the positions of the agents.
    pub fn feed(&self, hash: &mut Fingerprint) {
        for value in [self.site.centre[0], self.site.centre[1], self.site.radius, self.hub.radius, self.half] {
            hash.f64(value);
        }
        for (id, state) in self.states.iter().enumerate() {
            hash.u32(*state as u32);
            if *state == ItemState::Free {
                self.items.point(id as u32).iter().for_each(|&value| hash.f64(value));
            }
        }
        hash.u32(self.delivered);
    }
}

/// A point drawn uniformly from a disc.
fn within(disc: &Disc, rng: &mut Stream) -> [f64; 2] {
    loop {
        let x = rng.random::<f64>() * 2.0 - 1.0;
        let y = rng.random::<f64>() * 2.0 - 1.0;
        if x * x + y * y <= 1.0 {
            return [disc.centre[0] + x * disc.radius, disc.centre[1] + y * disc.radius];
        }
    }
}
