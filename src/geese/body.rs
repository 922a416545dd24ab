//! An agent's body, and what its leaves do to it and to the world.

use super::field::Field;
use super::leaf::{Leaf, Name, Object};
use super::params::{DropRule, ExploreHeading, IsDropable, MovesPerStep, Params};
use crate::bt::{Host, NodeId, Ports, Status};
use crate::fingerprint::Fingerprint;
use crate::random::{Stream, direction, standard_normal};

/// What an agent is and knows, apart from its program. Its position is in [`Field::agents`].
#[derive(Clone, Debug)]
pub struct Body {
    /// Unit vector of the direction of movement.
    pub heading: [f64; 2],
    /// The item it carries.
    pub load: Option<u32>,
    /// Whether it has sensed the site before; memory of places is permanent.
    pub knows_site: bool,
    /// The action that succeeded last in the last step.
    pub last_action: Option<Leaf>,
    /// The agent's own stream for headings and turns.
    walk: Stream,
}

impl Body {
    /// A body without load and without knowledge of the site, heading in a random direction.
    #[must_use]
    pub fn new(mut walk: Stream) -> Self {
        Self { heading: direction(&mut walk), load: None, knows_site: false, last_action: None, walk }
    }

    /// Feeds heading, load, knowledge and stream.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.heading.iter().for_each(|&value| hash.f64(value));
        hash.u64(self.load.map_or(0, |item| u64::from(item) + 1));
        hash.u64(u64::from(self.knows_site));
        hash.u64(self.last_action.map_or(0, Leaf::number));
        hash.stream(&self.walk);
    }
}

/// One agent during its tick: runs the leaves of its tree.
///
/// Conditions and behaviours follow BeTr-GEESE, appendix A; where the paper is silent, our choices stand at each.
pub struct Actor<'a> {
    params: &'a Params,
    field: &'a mut Field,
    body: &'a mut Body,
    id: u32,
    position: [f64; 2],
    moved: bool,
}

impl<'a> Actor<'a> {
    /// Begins the tick of agent `id`.
    pub fn new(params: &'a Params, field: &'a mut Field, body: &'a mut Body, id: u32) -> Self {
        body.last_action = None;
        let position = field.agents.point(id);
        Self { params, field, body, id, position, moved: false }
    }

    /// Whether something of the kind is sensed; sensing the site makes it known.
    ///
    /// Places are sensed from inside their disc, items within the sensing radius (our choice).
    fn senses(&mut self, object: Object) -> bool {
        match object {
            Object::Hub => self.field.hub.contains(self.position),
            Object::Sites => {
                let inside = self.field.site.contains(self.position);
                self.body.knows_site |= inside;
                inside
            }
            Object::Food => self.field.nearest_item(self.position, self.params.sense_radius).is_some(),
            // Any place, item or other agent: the argument-free form of the nominal grammar.
            Object::Nothing => {
                let (hub, site) = (self.senses(Object::Hub), self.senses(Object::Sites));
                hub || site || self.senses(Object::Food) || self.senses_agent()
            }
        }
    }

    fn senses_agent(&self) -> bool {
        let mut found = false;
        self.field.agents.near(self.position, self.params.sense_radius, |other, _| found |= other != self.id);
        found
    }

    fn is_known(&self, place: Object) -> bool {
        match place {
            Object::Hub => true,
            Object::Sites => self.body.knows_site,
            Object::Food | Object::Nothing => false,
        }
    }

    /// Whether the place takes drops. The paper does not say what the condition tests; since an item may be dropped
    /// at any place, it holds everywhere unless the scenario chooses another reading.
    fn is_dropable(&self, place: Object) -> bool {
        match self.params.is_dropable {
            IsDropable::Always => true,
            IsDropable::Kind => place == Object::Hub,
            IsDropable::Standing => place == Object::Hub && self.field.hub.contains(self.position),
        }
    }

    /// The unit vector towards the centre of a place: `None` when the place is unknown, the heading when the agent
    /// stands on it.
    fn bearing(&self, place: Object) -> Option<[f64; 2]> {
        if !self.is_known(place) {
            return None;
        }
        let centre = if place == Object::Hub { self.field.hub.centre } else { self.field.site.centre };
        let (dx, dy) = (centre[0] - self.position[0], centre[1] - self.position[1]);
        let length = (dx * dx + dy * dy).sqrt();
        Some(if length > 0.0 { [dx / length, dy / length] } else { self.body.heading })
    }

    /// Explore's turn: a new direction (the paper), or a small normal angle (the authors' code).
    fn turn(&mut self) {
        match self.params.explore_heading {
            ExploreHeading::Uniform => self.body.heading = direction(&mut self.body.walk),
            ExploreHeading::Turning => {
                let angle = self.params.turn_deviation * standard_normal(&mut self.body.walk);
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let [x, y] = self.body.heading;
                let turned = [x * cos - y * sin, x * sin + y * cos];
                // Rounding would slowly change the length.
                let length = (turned[0] * turned[0] + turned[1] * turned[1]).sqrt();
                self.body.heading = [turned[0] / length, turned[1] / length];
            }
        }
    }

    /// One step along the heading. At the edge the agent stays on it and turns round (our choice).
    fn advance(&mut self) -> bool {
        if self.moved && self.params.moves_per_step == MovesPerStep::One {
            return false;
        }
        self.moved = true;
        let half = self.field.half;
        let wanted = [0, 1].map(|axis| self.position[axis] + self.body.heading[axis] * self.params.step_length);
        let reached = wanted.map(|value| value.clamp(-half, half));
        if wanted.iter().any(|value| value.abs() > half) {
            self.body.heading = self.body.heading.map(|value| -value);
        }
        self.position = reached;
        self.field.agents.put(self.id, reached);
        true
    }

    /// MoveTowards: done when the place is sensed; otherwise turn towards it and move.
    fn move_towards(&mut self, place: Object) -> bool {
        if self.senses(place) {
            return true;
        }
        let Some(bearing) = self.bearing(place) else { return false };
        self.body.heading = bearing;
        self.advance()
    }

    /// MoveAway: done when the place is not sensed; otherwise turn away from it and move.
    fn move_away(&mut self, place: Object) -> bool {
        if !self.senses(place) {
            return true;
        }
        let Some(bearing) = self.bearing(place) else { return false };
        self.body.heading = bearing.map(|value| -value);
        self.advance()
    }

    /// CompositeSingleCarry: done when carrying; otherwise the nearest item within reach is picked up. One item
    /// at a time (our choice; the paper gives no weights).
    fn carry(&mut self) -> bool {
        if self.body.load.is_some() {
            return true;
        }
        let Some(item) = self.field.nearest_item(self.position, self.params.sense_radius) else { return false };
        self.field.pick_up(item);
        self.body.load = Some(item);
        true
    }

    /// CompositeDrop: done when not carrying; otherwise the item is put down where the drop rule allows it.
    fn put_down(&mut self) -> bool {
        let Some(item) = self.body.load else { return true };
        if self.params.drop_rule == DropRule::Hub && !self.field.hub.contains(self.position) {
            return false;
        }
        self.body.load = None;
        self.field.put_down(item, self.position);
        true
    }

    fn run(&mut self, leaf: Leaf) -> bool {
        match leaf.name {
            Name::IsVisitedBefore => self.is_known(leaf.object),
            Name::IsCarrying => self.body.load.is_some(),
            // What is sensed is within reach.
            Name::NeighbourObjects | Name::IsCarryable => self.senses(leaf.object),
            Name::IsDropable => self.is_dropable(leaf.object),
            // Nothing kills agents in this world.
            Name::CanMove | Name::DummyNode => true,
            Name::MoveTowards => self.move_towards(leaf.object),
            Name::MoveAway => self.move_away(leaf.object),
            Name::Explore => {
                self.turn();
                self.advance()
            }
            Name::CompositeSingleCarry => self.carry(),
            Name::CompositeDrop => self.put_down(),
        }
    }
}

impl Host<Leaf> for Actor<'_> {
    const PLAIN: bool = true;

    fn tick(&mut self, _node: NodeId, leaf: &Leaf, _ports: &mut Ports) -> Status {
        let success = self.run(*leaf) != leaf.negated;
        if success && leaf.name.is_action() {
            self.body.last_action = Some(*leaf);
        }
        Status::completed(success)
    }
}
