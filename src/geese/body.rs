//! An agent's body, and what its leaves do to it and to the world.

use super::field::{Disc, Field};
use super::grid::{Area, squared_distance};
use super::lattice::edge_along;
use super::leaf::{Leaf, Manner, Name, Object};
use super::params::{Behaviours, DropRule, ExploreHeading, IsDropable, MovesPerStep, Params};
use super::switches::{
    AvoidRule, Blackboard, DropPostcondition, EdgeRule, InitialMemory, MoveAwayPostcondition, PerceptWipe, Rounding,
    StepRule,
};
use crate::fingerprint::Fingerprint;
use crate::random::{Stream, direction, standard_normal};
use rand::RngExt;

/// The most places of one kind that an agent can remember: a byte of its memory.
pub const MOST_PLACES: i64 = 8;

/// What an agent is and knows, apart from its program. Its position is in [`Field::agents`].
#[derive(Clone, Debug)]
pub struct Body {
    /// Unit vector of the direction of movement.
    pub heading: [f64; 2],
    /// The item it carries.
    pub load: Option<u32>,
    /// The places it has sensed before, a bit each: sites, then obstacles, traps and places on the boundary. Memory of
    /// places is permanent.
    known: u32,
    /// Whether its last look found an item; only percepts of its own that outlast a tick set it.
    perceived: bool,
    /// False once it has touched a trap.
    pub alive: bool,
    /// The action that succeeded last in the last step.
    pub last_action: Option<Leaf>,
    /// The agent's own stream for headings and turns.
    walk: Stream,
}

impl Body {
    /// A body without load and without knowledge of any site, heading in a random direction.
    #[must_use]
    pub fn new(params: &Params, field: &Field, mut walk: Stream) -> Self {
        let parts = match params.initial_memory {
            InitialMemory::All => field.sinks.len() as u32,
            InitialMemory::FirstBoundary => field.sinks.len().min(1) as u32,
        };
        let known = ((1 << parts) - 1) << first_bit(Object::Boundary);
        let heading = direction(&mut walk);
        Self { heading, load: None, known, perceived: false, alive: true, last_action: None, walk }
    }

    /// Whether the agent remembers a place of that kind. Hub and boundary are known from the start (our choice).
    #[must_use]
    pub fn knows(&self, place: Object, field: &Field) -> bool {
        match place {
            Object::Hub => true,
            Object::Boundary if field.sinks.is_empty() => field.sink() == Object::Boundary,
            Object::Boundary | Object::Sites | Object::Obstacles | Object::Trap => self.known_of(place) != 0,
            Object::Food | Object::Debris | Object::Nothing => false,
        }
    }

    fn known_of(&self, place: Object) -> u32 {
        self.known >> first_bit(place) & 0xff
    }

    /// Feeds heading, load, knowledge and stream.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.heading.iter().for_each(|&value| hash.f64(value));
        hash.u64(self.load.map_or(0, |item| u64::from(item) + 1));
        hash.u64(u64::from(self.known) | u64::from(!self.alive) << 32 | u64::from(self.perceived) << 33);
        hash.u64(self.last_action.map_or(0, Leaf::number));
        hash.stream(&self.walk);
    }
}

fn first_bit(place: Object) -> u32 {
    match place {
        Object::Obstacles => 8,
        Object::Trap => 16,
        Object::Boundary => 24,
        _ => 0,
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
    /// Whether the task's item was sensed in this tick (or in the last look): nominal carrying looks at nothing else.
    perceived: bool,
}

impl<'a> Actor<'a> {
    /// Begins the tick of agent `id`.
    pub fn new(params: &'a Params, field: &'a mut Field, body: &'a mut Body, id: u32) -> Self {
        body.last_action = None;
        let position = field.agents.point(id);
        let perceived = match (params.percept_wipe, params.blackboard) {
            (PerceptWipe::Tick, _) => false,
            (PerceptWipe::Sense, Blackboard::Private) => body.perceived,
            (PerceptWipe::Sense, Blackboard::Shared) => field.perceived,
        };
        Self { params, field, body, id, position, moved: false, perceived }
    }

    /// Notes whether a look found the task's item: for the rest of the tick, or until the next look.
    fn note(&mut self, sensed: bool) {
        match self.params.percept_wipe {
            PerceptWipe::Tick => self.perceived |= sensed,
            PerceptWipe::Sense => {
                self.perceived = sensed;
                *match self.params.blackboard {
                    Blackboard::Private => &mut self.body.perceived,
                    Blackboard::Shared => &mut self.field.perceived,
                } = sensed;
            }
        }
    }

    /// Whether something of the kind is sensed; a place that is sensed becomes known.
    ///
    /// Places are sensed from inside their disc, items within the sensing radius; obstacles and traps, which nobody
    /// enters, when their rim is within it (our choices). In the authors' code all is sensed from the same cell, and each
    /// look makes the agent forget what the one before found.
    fn senses(&mut self, object: Object) -> bool {
        let sensing = self.params.sensing;
        let forgets = self.params.percept_wipe == PerceptWipe::Sense;
        match object {
            Object::Food | Object::Debris | Object::Nothing => {}
            _ => self.note(false),
        }
        match object {
            Object::Hub => self.field.lattice.senses(sensing, &self.field.hub, self.position, 0.0),
            Object::Boundary if self.field.sinks.is_empty() => {
                self.field.sink() == Object::Boundary && self.field.accepts(self.position)
            }
            Object::Boundary | Object::Sites | Object::Obstacles | Object::Trap => {
                let is_barred = matches!(object, Object::Obstacles | Object::Trap);
                let margin = if is_barred { self.params.sense_radius } else { 0.0 };
                let (position, lattice) = (self.position, self.field.lattice);
                let near = |disc: &Disc| lattice.senses(sensing, disc, position, margin);
                let found: u32 =
                    self.places(object).iter().zip(0..).map(|(disc, bit)| u32::from(near(disc)) << bit).sum();
                self.body.known |= found << first_bit(object);
                found != 0
            }
            Object::Food | Object::Debris => {
                let sensed = object == self.field.item() && self.sensed_item().is_some();
                self.note(sensed);
                sensed
            }
            // Any place, item or other agent: the argument-free form of the nominal grammar.
            Object::Nothing => {
                let mut any = false;
                for place in Object::PLACES {
                    any |= self.senses(place);
                }
                // Of all that is found the item is remembered (our choice: the code keeps the last, in no fixed order).
                any |= forgets && self.senses(self.field.item());
                any || self.senses(self.field.item()) || self.senses_agent()
            }
        }
    }

    /// Where items and other agents are sensed.
    fn area(&self) -> Area {
        self.field.area(self.params.sensing, self.position, self.params.sense_radius)
    }

    fn sensed_item(&self) -> Option<u32> {
        self.field.nearest_item(self.position, self.area())
    }

    fn places(&self, kind: Object) -> &[Disc] {
        match kind {
            Object::Sites => &self.field.sites,
            Object::Obstacles => &self.field.obstacles,
            Object::Trap => &self.field.traps,
            Object::Boundary => &self.field.sinks,
            _ => &[],
        }
    }

    fn senses_agent(&self) -> bool {
        let mut found = false;
        self.field.agents.near(self.position, self.area(), |other, _| found |= other != self.id);
        found
    }

    /// Whether the place takes drops. The paper does not say what the condition tests; since an item may be dropped
    /// at any place, it holds everywhere unless the scenario chooses another reading.
    fn is_dropable(&self, place: Object) -> bool {
        let takes = place == self.field.sink();
        match self.params.is_dropable {
            IsDropable::Always => true,
            IsDropable::Kind => takes,
            IsDropable::Standing => takes && self.field.accepts(self.position),
        }
    }

    /// The unit vector towards a place: `None` when none is known, the heading when the agent stands on its centre. Of
    /// several known ones, one at random. The boundary lies outward from the origin.
    fn bearing(&mut self, place: Object) -> Option<[f64; 2]> {
        if !self.body.knows(place, self.field) {
            return None;
        }
        let [x, y] = self.position;
        let way = match place {
            Object::Boundary if self.field.sinks.is_empty() => [x, y],
            Object::Hub => [self.field.hub.centre[0] - x, self.field.hub.centre[1] - y],
            _ => {
                let known = self.one_known(place);
                let centre = self.places(place)[known].centre;
                [centre[0] - x, centre[1] - y]
            }
        };
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        Some(if length > 0.0 { way.map(|value| value / length) } else { self.body.heading })
    }

    /// One of the known places of a kind, of which there is at least one.
    fn one_known(&mut self, place: Object) -> usize {
        let mut known = self.body.known_of(place);
        if known.count_ones() > 1 {
            for _ in 0..self.body.walk.random_range(0..known.count_ones()) {
                known &= known - 1;
            }
        }
        known.trailing_zeros() as usize
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

    /// One step along the heading, half as long with a load if the scenario says so. At the edge the agent stays on it and
    /// turns round (our choice; in the authors' code it is set back by two units and turns round once for each axis); an
    /// obstacle bars the way, a trap kills.
    fn advance(&mut self) -> bool {
        if self.moved && self.params.moves_per_step == MovesPerStep::One || !self.body.alive {
            return false;
        }
        self.moved = true;
        let length = match self.params.step_rule {
            StepRule::ByLoad if self.body.load.is_some() => self.params.step_length / 2.0,
            StepRule::ByLoad | StepRule::Constant => self.params.step_length,
        };
        let wanted = [0, 1].map(|axis| self.position[axis] + self.body.heading[axis] * length);
        let (wanted, edge) = match self.params.rounding {
            Rounding::None => (wanted, self.field.half),
            Rounding::Nearest => (wanted.map(f64::round_ties_even), self.field.half.floor()),
            Rounding::Truncate => (wanted.map(f64::trunc), self.field.half.floor()),
        };
        let beyond = wanted.iter().filter(|value| value.abs() > edge).count();
        let (reached, turns) = match self.params.edge_rule {
            // Not `clamp`, whose panic brings the printing of floats into the wasm.
            EdgeRule::Clamp => (wanted.map(|value| value.max(-edge).min(edge)), beyond > 0),
            EdgeRule::Bounce => {
                let back = |value: f64| if value.abs() > edge { (edge - 2.0).copysign(value) } else { value };
                (wanted.map(back), beyond == 1)
            }
        };
        let lattice = self.field.lattice;
        if self.field.obstacles.iter().any(|disc| lattice.crosses(disc, self.position, reached)) {
            return false;
        }
        if turns {
            self.body.heading = self.body.heading.map(|value| -value);
        }
        let killed = self.field.traps.iter().any(|disc| lattice.crosses(disc, self.position, reached));
        self.position = reached;
        self.field.agents.put(self.id, reached);
        if killed {
            self.die();
        }
        true
    }

    /// The dead neither tick nor meet anyone, and what they carried lies on the ground (our choices).
    fn die(&mut self) {
        self.body.alive = false;
        self.field.agents.remove(self.id);
        if let Some(item) = self.body.load.take() {
            self.field.put_down(item, self.position);
        }
    }

    /// The nearest obstacle that the look-ahead meets, else the nearest trap: the order of the behaviour's branches.
    fn ahead(&self) -> Option<Disc> {
        let (lattice, length) = (self.field.lattice, self.params.look_ahead);
        let rim = |disc: &Disc| squared_distance(disc.centre, self.position).sqrt() - disc.radius;
        let nearest = |discs: &[Disc]| {
            let in_sight = discs.iter().filter(|disc| lattice.in_sight(disc, self.position, self.body.heading, length));
            in_sight.min_by(|a, b| rim(a).total_cmp(&rim(b))).copied()
        };
        nearest(&self.field.obstacles).or_else(|| nearest(&self.field.traps))
    }

    /// Bug following: one step parallel to the surface of what is ahead, to the side that needs the smaller turn.
    ///
    /// Source: BeTr-GEESE, appendix A, after Lumelsky and Stepanov (1987). The tangent of a disc at its nearest point is
    /// at right angles to the line to its centre. In the authors' code the way leads along the edge of the bounding box
    /// that the look ahead cuts.
    fn avoid(&mut self, disc: &Disc) -> bool {
        if self.params.avoid_rule == AvoidRule::Box {
            let far = [0, 1].map(|axis| self.position[axis] + self.body.heading[axis] * self.params.look_ahead);
            let along = edge_along(self.field.lattice.bounds(disc), self.position, far);
            self.body.heading = along.unwrap_or(self.body.heading);
            return self.advance();
        }
        let away = [self.position[0] - disc.centre[0], self.position[1] - disc.centre[1]];
        let length = (away[0] * away[0] + away[1] * away[1]).sqrt();
        if length <= 0.0 {
            return false;
        }
        let left = [-away[1] / length, away[0] / length];
        let turn = left[0] * self.body.heading[0] + left[1] * self.body.heading[1];
        self.body.heading = if turn >= 0.0 { left } else { left.map(|value| -value) };
        self.advance()
    }

    /// The last part of every moving behaviour: a plain move, or in PPA form one that keeps clear of what is ahead.
    ///
    /// - `ready`: whether the heading was found; PPA forms keep clear of what is ahead even without.
    fn go(&mut self, ready: bool, manner: Manner) -> bool {
        let looks = self.params.behaviours == Behaviours::Ppa && manner == Manner::Avoid;
        if looks {
            self.note(false);
        }
        match if looks { self.ahead() } else { None } {
            Some(disc) => self.avoid(&disc),
            None => ready && self.advance(),
        }
    }

    /// MoveTowards: turn towards the place and move; in PPA form done when the place is sensed.
    fn move_towards(&mut self, place: Object, manner: Manner) -> bool {
        if self.params.behaviours == Behaviours::Ppa && self.senses(place) {
            return true;
        }
        let bearing = self.bearing(place);
        self.body.heading = bearing.unwrap_or(self.body.heading);
        self.go(bearing.is_some(), manner)
    }

    /// MoveAway: turn away from the place and move; in PPA form done when the place is not sensed, which the paper leaves
    /// open (in the authors' code: when it is, so it never leaves a place).
    fn move_away(&mut self, place: Object, manner: Manner) -> bool {
        let goal = self.params.moveaway_postcondition == MoveAwayPostcondition::Sensed;
        if self.params.behaviours == Behaviours::Ppa && self.senses(place) == goal {
            return true;
        }
        let bearing = self.bearing(place);
        self.body.heading = bearing.map_or(self.body.heading, |bearing| bearing.map(|value| -value));
        self.go(bearing.is_some(), manner)
    }

    /// CompositeSingleCarry: picks up the nearest item within reach, one at a time (our choice; the paper gives no
    /// weights). In PPA form done when carrying; in nominal form only what another node has sensed in this tick.
    fn carry(&mut self, item: Object) -> bool {
        let ready = match self.params.behaviours {
            Behaviours::Ppa if self.body.load.is_some() => return true,
            Behaviours::Ppa => item == self.field.item(),
            Behaviours::Nominal => self.perceived && self.body.load.is_none() && item == self.field.item(),
        };
        if !ready {
            return false;
        }
        if self.params.behaviours == Behaviours::Ppa && self.params.percept_wipe == PerceptWipe::Sense {
            self.senses(item);
        }
        let Some(found) = self.sensed_item() else { return false };
        self.field.pick_up(found);
        self.body.load = Some(found);
        true
    }

    /// CompositeDrop: puts the item down where the drop rule allows it; in PPA form done when not carrying. In the authors'
    /// code that postcondition is missing, and the agent looks around first.
    fn put_down(&mut self, item: Object) -> bool {
        let is_ppa = self.params.behaviours == Behaviours::Ppa;
        let has_goal = self.params.drop_postcondition == DropPostcondition::NotCarrying;
        if is_ppa && !has_goal {
            self.senses(Object::Nothing);
        }
        let Some(item) = self.body.load.filter(|_| item == self.field.item()) else {
            return is_ppa && has_goal;
        };
        let is_refused = match self.params.drop_rule {
            DropRule::Anywhere => false,
            DropRule::Sink => !self.field.accepts(self.position),
            DropRule::OutsideHub => self.field.refuses(self.position),
        };
        if is_refused {
            return false;
        }
        self.body.load = None;
        self.field.put_down(item, self.position);
        true
    }

    fn run(&mut self, leaf: Leaf) -> bool {
        match leaf.name {
            Name::IsVisitedBefore => self.body.knows(leaf.object, self.field),
            Name::IsCarrying => self.body.load.is_some() && leaf.object == self.field.item(),
            // What the last look found, wherever it was.
            Name::IsCarryable if self.params.percept_wipe == PerceptWipe::Sense => {
                self.perceived && leaf.object == self.field.item()
            }
            // What is sensed is within reach.
            Name::NeighbourObjects | Name::IsCarryable => self.senses(leaf.object),
            Name::IsDropable => self.is_dropable(leaf.object),
            Name::DummyNode => true,
            Name::CanMove => self.body.alive,
            _ if !self.body.alive => false,
            Name::MoveTowards => self.move_towards(leaf.object, leaf.manner),
            Name::MoveAway => self.move_away(leaf.object, leaf.manner),
            Name::Explore => {
                self.turn();
                self.go(true, leaf.manner)
            }
            Name::CompositeSingleCarry => self.carry(leaf.object),
            Name::CompositeDrop => self.put_down(leaf.object),
        }
    }
}

impl Actor<'_> {
    /// Runs a leaf, of a tree or of a machine; true when it succeeds.
    pub fn act(&mut self, leaf: Leaf) -> bool {
        let success = self.run(leaf) != leaf.negated;
        if success && leaf.name.is_action() {
            self.body.last_action = Some(leaf);
        }
        success
    }
}
