//! What lies in the arena: hub, sites, boundary, obstacles, traps and items; and where the agents stand.

use super::grid::{Area, Grid, squared_distance};
use super::lattice::Lattice;
use super::leaf::Object;
use super::params::{ItemPlacement, Params, StartPositions, Task};
use super::switches::{Footprint, NestSink, Rounding, Sensing, SitePlacement};
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, Stream, direction, stream};
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

    fn feed(&self, hash: &mut Fingerprint) {
        for value in [self.centre[0], self.centre[1], self.radius] {
            hash.f64(value);
        }
    }

    /// True when the way from `from` to `to` touches the disc.
    #[must_use]
    pub fn meets(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let way = [to[0] - from[0], to[1] - from[1]];
        let aside = [self.centre[0] - from[0], self.centre[1] - from[1]];
        let squared = way[0] * way[0] + way[1] * way[1];
        let along = (way[0] * aside[0] + way[1] * aside[1]) / if squared > 0.0 { squared } else { 1.0 };
        let along = along.clamp(0.0, 1.0);
        self.contains([from[0] + along * way[0], from[1] + along * way[1]])
    }
}

/// Where an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemState {
    /// On the ground, to be picked up.
    Free,
    /// With an agent.
    Carried,
    /// Where it belongs, for good.
    Delivered,
    /// Swallowed, unscored, by the last of the places on the boundary.
    Lost,
}

/// The arena with all that agents sense and move.
#[derive(Clone, Debug)]
pub struct Field {
    /// What the swarm is to do.
    pub task: Task,
    /// Coordinates lie in `[-half, half]`.
    pub half: f64,
    /// Where agents start: at the origin. Foraging: where food is brought to; nest: where debris lies.
    pub hub: Disc,
    /// Where food lies at the start; none in the nest.
    pub sites: Vec<Disc>,
    /// Nest: debris belongs outside this disc around the origin, or in one of the sinks if there are any.
    pub inside: Disc,
    /// Nest: the places on the boundary that take debris; the last swallows it unscored.
    pub sinks: Vec<Disc>,
    /// The cells of the arena, and the ground that places take up.
    pub lattice: Lattice,
    /// Whether whoever sensed last sensed an item; only shared percepts set it.
    pub perceived: bool,
    /// What bars the way.
    pub obstacles: Vec<Disc>,
    /// What kills on contact.
    pub traps: Vec<Disc>,
    /// Where each agent stands.
    pub agents: Grid,
    /// Items on the ground.
    pub items: Grid,
    states: Vec<ItemState>,
    delivered: u32,
    carried: u32,
    lost: u32,
}

impl Field {
    /// Places sites, items in them (in the nest: in the hub), places that take debris, obstacles and traps, and the
    /// agents.
    ///
    /// # Errors
    /// The field's name and why: no room for so many obstacles or traps.
    ///
    /// Source: BeTr-GEESE, sections 4.2 and 4.3. How items lie is our choice, and so are obstacles and traps: the paper
    /// gives no numbers.
    pub fn new(params: &Params, seed: Seed) -> Result<Self, (&'static str, String)> {
        let placement = &mut stream(seed, Purpose::Placement, 0);
        let hub = Disc { centre: [0.0; 2], radius: params.hub_radius };
        let sites: Vec<Disc> = match params.task {
            Task::Nest => Vec::new(),
            Task::Forage => (0..params.sites)
                .map(|id| {
                    let [x, y] = match params.site_placement {
                        SitePlacement::Ring => direction(placement),
                        SitePlacement::Fixed => [[-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]][id as usize % 4],
                    };
                    Disc { centre: [x * params.site_distance, y * params.site_distance], radius: params.site_radius }
                })
                .collect(),
        };
        let mut items = Grid::new(params.half(), params.item_count());
        for id in 0..params.item_count() {
            let place = if sites.is_empty() { hub } else { sites[id as usize % sites.len()] };
            let point = match params.item_placement {
                ItemPlacement::Scattered => within(&place, placement),
                ItemPlacement::Stacked => place.centre,
            };
            items.put(id, point);
        }
        let mut agents = Grid::new(params.half(), params.agents);
        for id in 0..params.agents {
            let start = match params.start_positions {
                StartPositions::Hub => hub.centre,
                StartPositions::Uniform => [0, 1].map(|_| (placement.random::<f64>() * 2.0 - 1.0) * params.half()),
            };
            // On whole coordinates the upper edge is left out, as in the authors' code.
            let whole = |value: f64| value.floor().max(-params.half().floor());
            agents.put(id, if params.rounding == Rounding::None { start } else { start.map(whole) });
        }
        let lattice = Lattice::new(params);
        let sinks = match (params.task, params.nest_sink) {
            (Task::Nest, NestSink::Cells) => sinks(params, &lattice, &hub, placement),
            _ => Vec::new(),
        };
        let mut field = Self {
            task: params.task,
            half: params.half(),
            hub,
            sites,
            inside: Disc { centre: [0.0; 2], radius: params.boundary_radius },
            sinks,
            lattice,
            perceived: false,
            obstacles: Vec::new(),
            traps: Vec::new(),
            agents,
            items,
            states: vec![ItemState::Free; params.item_count() as usize],
            delivered: 0,
            carried: 0,
            lost: 0,
        };
        field.place_terrain(params, &mut stream(seed, Purpose::Terrain, 0))?;
        Ok(field)
    }

    /// Obstacles and traps at random places, clear of hub, sites and each other by more than a step.
    fn place_terrain(&mut self, params: &Params, rng: &mut Stream) -> Result<(), (&'static str, String)> {
        let mut taken = [self.sites.as_slice(), &self.sinks, &[self.hub]].concat();
        if params.start_positions == StartPositions::Uniform {
            // Nobody starts in an obstacle or a trap.
            taken.extend((0..params.agents).map(|id| Disc { centre: self.agents.point(id), radius: 0.0 }));
        }
        let gap = 2.0 * params.step_length;
        for (name, count, radius) in
            [("obstacles", params.obstacles, params.obstacle_radius), ("traps", params.traps, params.trap_radius)]
        {
            for placed in 0..count {
                let side = self.half - radius;
                let found = (0..1000).find_map(|_| {
                    let centre = [0, 1].map(|_| (rng.random::<f64>() * 2.0 - 1.0) * side);
                    let clear = |other: &Disc| {
                        let apart = other.radius + radius + gap;
                        squared_distance(other.centre, centre) > apart * apart
                    };
                    let disc = Disc { centre, radius };
                    let apart = |other: &Disc| match params.footprint {
                        Footprint::Disc => clear(other),
                        Footprint::Cells => !self.lattice.share(other, &disc),
                    };
                    taken.iter().all(apart).then_some(disc)
                });
                let Some(disc) = found else {
                    return Err((name, format!("expected room for {count} of them, found room for {placed}")));
                };
                taken.push(disc);
                if name == "traps" { &mut self.traps } else { &mut self.obstacles }.push(disc);
            }
        }
        Ok(())
    }

    /// The item of the task.
    #[must_use]
    pub fn item(&self) -> Object {
        match self.task {
            Task::Forage => Object::Food,
            Task::Nest => Object::Debris,
        }
    }

    /// The place that takes the task's items.
    #[must_use]
    pub fn sink(&self) -> Object {
        match self.task {
            Task::Forage => Object::Hub,
            Task::Nest => Object::Boundary,
        }
    }

    /// True where an item that is put down is delivered.
    #[must_use]
    pub fn accepts(&self, place: [f64; 2]) -> bool {
        match self.task {
            Task::Forage => self.covers(&self.hub, place),
            Task::Nest if self.sinks.is_empty() => !self.inside.contains(place),
            Task::Nest => self.sinks.iter().any(|sink| self.covers(sink, place)),
        }
    }

    /// Whether a point is on the ground of a place.
    #[must_use]
    pub fn covers(&self, place: &Disc, point: [f64; 2]) -> bool {
        self.lattice.covers(place, point)
    }

    /// True where the authors' code lets nobody put an item down: debris in the hub, where it comes from. Its other such
    /// places are those with an obstacle, which nobody enters, and for food the boundary, which foraging does not have.
    #[must_use]
    pub fn refuses(&self, place: [f64; 2]) -> bool {
        self.task == Task::Nest && !self.accepts(place) && self.covers(&self.hub, place)
    }

    /// Where an agent at `place` senses items and others: within `radius`, or in its cell.
    #[must_use]
    pub fn area(&self, sensing: Sensing, place: [f64; 2], radius: f64) -> Area {
        match sensing {
            Sensing::Disc => Area::Disc(radius),
            Sensing::Cell => Area::Cell(self.lattice.around(place)),
        }
    }

    /// The nearest free item of an area around `place`; of equally near ones that with the smallest number.
    #[must_use]
    pub fn nearest_item(&self, place: [f64; 2], area: Area) -> Option<u32> {
        self.items.nearest(place, area)
    }

    /// Takes a free item from the ground.
    pub fn pick_up(&mut self, item: u32) {
        self.items.remove(item);
        self.states[item as usize] = ItemState::Carried;
        self.carried += 1;
    }

    /// Puts a carried item down: where it belongs it is delivered, elsewhere it lies on the ground again.
    pub fn put_down(&mut self, item: u32, place: [f64; 2]) {
        self.carried -= 1;
        if self.accepts(place) {
            let scored = self.sinks.len().saturating_sub(1);
            let is_lost = scored > 0 && !self.sinks[..scored].iter().any(|sink| self.covers(sink, place));
            self.states[item as usize] = if is_lost { ItemState::Lost } else { ItemState::Delivered };
            *(if is_lost { &mut self.lost } else { &mut self.delivered }) += 1;
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

    /// Items swallowed so far without being scored.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost
    }

    /// Items with agents now.
    #[must_use]
    pub fn carried(&self) -> u32 {
        self.carried
    }

    /// Feeds places, items and the positions of the agents.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.sites.iter().for_each(|disc| disc.feed(hash));
        self.sinks.iter().for_each(|disc| disc.feed(hash));
        hash.f64(self.hub.radius);
        hash.f64(self.half);
        for disc in self.obstacles.iter().chain(&self.traps) {
            disc.feed(hash);
        }
        if self.task == Task::Nest {
            hash.f64(self.inside.radius);
        }
        for (id, state) in self.states.iter().enumerate() {
            hash.u32(*state as u32);
            if *state == ItemState::Free {
                self.items.point(id as u32).iter().for_each(|&value| hash.f64(value));
            }
        }
        hash.u64(u64::from(self.delivered) | u64::from(self.lost) << 32 | u64::from(self.perceived) << 63);
    }
}

/// The places on the boundary that take debris: five just outside the circle, in directions that are multiples of 10
/// degrees and in cells of their own, and one beyond the circle on the diagonal.
///
/// Source: the authors' code. Where an arena has too few cells, they share them (our choice).
fn sinks(params: &Params, lattice: &Lattice, hub: &Disc, rng: &mut Stream) -> Vec<Disc> {
    let around = params.boundary_radius + 1.0;
    let mut sinks: Vec<Disc> = Vec::new();
    for _ in 0..5 {
        let mut sink = Disc { centre: [around, 0.0], radius: SINK_RADIUS };
        for _ in 0..100 {
            let angle = f64::from(rng.random_range(0..36_u32)) * std::f64::consts::PI / 18.0;
            sink.centre = [(around * libm::cos(angle)).trunc(), (around * libm::sin(angle)).trunc()];
            if !lattice.share(hub, &sink) && !sinks.iter().any(|other| lattice.share(other, &sink)) {
                break;
            }
        }
        sinks.push(sink);
    }
    sinks.push(Disc { centre: [params.boundary_radius; 2], radius: SINK_RADIUS });
    sinks
}

/// A place on the boundary is one cell, or (our choice) a disc of that width.
const SINK_RADIUS: f64 = 5.0;

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
