//! A run: a world that follows a scenario, with its events.

use super::read::apply;
#[cfg(feature = "soccer")]
use super::read::intervention;
use super::{Event, Scenario, ScenarioError, WorldParams};
use crate::geese;
#[cfg(feature = "sequencing")]
use crate::sequencing;
#[cfg(feature = "soccer")]
use crate::soccer;
use serde::Serialize;
use serde_json::Value;

/// A world on its way through a scenario.
#[derive(Clone, Debug)]
pub struct Run {
    scenario: Scenario,
    /// The parameters in force, after the events so far.
    params: WorldParams,
    /// The first event that has not happened yet.
    next_event: usize,
    world: World,
}

/// A run on its way to tick 0: a world that plans before its first step can do so in slices.
#[derive(Clone, Debug)]
pub struct Start {
    scenario: Scenario,
    state: Starting,
}

#[derive(Clone, Debug)]
enum Starting {
    Ready(World),
    #[cfg(feature = "sequencing")]
    Planning(Box<sequencing::Preparation>),
}

#[derive(Clone, Debug)]
enum World {
    Geese(Box<geese::World>),
    #[cfg(feature = "sequencing")]
    Sequencing(Box<sequencing::World>),
    #[cfg(feature = "soccer")]
    Soccer(Box<soccer::World>),
}

/// The state of a world at one tick, without what its scenario says.
#[derive(Clone, Debug)]
pub(super) enum State {
    Geese(Box<geese::State>),
    #[cfg(feature = "sequencing")]
    Sequencing(Box<sequencing::State>),
    #[cfg(feature = "soccer")]
    Soccer(Box<soccer::State>),
}

/// How a run stands; its fields are those of the world's own outcome.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Outcome {
    /// Of the foraging swarm.
    Geese(geese::Outcome),
    /// Of a plan.
    #[cfg(feature = "sequencing")]
    Sequencing(Box<sequencing::Outcome>),
    /// Of a match.
    #[cfg(feature = "soccer")]
    Soccer(Box<soccer::Outcome>),
}

impl Run {
    /// Builds the world of a scenario, at tick 0.
    ///
    /// # Errors
    /// The scenario's world cannot be built, for example because random genomes give no program of its grammar.
    pub fn new(scenario: Scenario) -> Result<Self, ScenarioError> {
        Ok(Self::start(scenario)?.run())
    }

    /// Begins to build the world of a scenario.
    ///
    /// # Errors
    /// As [`Run::new`].
    pub fn start(scenario: Scenario) -> Result<Start, ScenarioError> {
        let state = match &scenario.world {
            WorldParams::Geese(params) => {
                geese::World::new(params, scenario.seed).map(|world| Starting::Ready(World::Geese(Box::new(world))))
            }
            #[cfg(feature = "sequencing")]
            WorldParams::Sequencing(params) => {
                sequencing::World::prepare(params, scenario.seed).map(|world| Starting::Planning(Box::new(world)))
            }
            #[cfg(feature = "soccer")]
            WorldParams::Soccer(params) => {
                soccer::World::new(params, scenario.seed).map(|world| Starting::Ready(World::Soccer(Box::new(world))))
            }
        };
        let state = state.map_err(|(field, message)| ScenarioError { path: field.to_owned(), message })?;
        Ok(Start { scenario, state })
    }

    /// What the run follows, with the changes made so far.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The foraging world, if that is what runs.
    #[must_use]
    pub fn geese(&self) -> Option<&geese::World> {
        match &self.world {
            World::Geese(world) => Some(world),
            #[cfg(feature = "sequencing")]
            World::Sequencing(_) => None,
            #[cfg(feature = "soccer")]
            World::Soccer(_) => None,
        }
    }

    /// As [`Run::geese`], to ask what needs its compiler.
    pub fn geese_mut(&mut self) -> Option<&mut geese::World> {
        match &mut self.world {
            World::Geese(world) => Some(world),
            #[cfg(feature = "sequencing")]
            World::Sequencing(_) => None,
            #[cfg(feature = "soccer")]
            World::Soccer(_) => None,
        }
    }

    /// The plan on its way, if that is what runs.
    #[cfg(feature = "sequencing")]
    #[must_use]
    pub fn sequencing(&self) -> Option<&sequencing::World> {
        match &self.world {
            World::Geese(_) => None,
            World::Sequencing(world) => Some(world),
            #[cfg(feature = "soccer")]
            World::Soccer(_) => None,
        }
    }

    /// The match, if that is what runs.
    #[cfg(feature = "soccer")]
    #[must_use]
    pub fn soccer(&self) -> Option<&soccer::World> {
        match &self.world {
            World::Soccer(world) => Some(world),
            World::Geese(_) => None,
            #[cfg(feature = "sequencing")]
            World::Sequencing(_) => None,
        }
    }

    /// Steps made so far.
    #[must_use]
    pub fn tick(&self) -> u32 {
        match &self.world {
            World::Geese(world) => world.state().tick(),
            #[cfg(feature = "sequencing")]
            World::Sequencing(world) => world.state().tick(),
            #[cfg(feature = "soccer")]
            World::Soccer(world) => world.state().tick(),
        }
    }

    /// How the run stands.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        match &self.world {
            World::Geese(world) => Outcome::Geese(world.outcome()),
            #[cfg(feature = "sequencing")]
            World::Sequencing(world) => Outcome::Sequencing(Box::new(world.outcome())),
            #[cfg(feature = "soccer")]
            World::Soccer(world) => Outcome::Soccer(Box::new(world.outcome())),
        }
    }

    /// Why the run ended, in words; `None` while it can go on.
    #[must_use]
    pub fn finished(&self) -> Option<&'static str> {
        match &self.world {
            World::Geese(world) => world.outcome().finished.map(geese::Finished::text),
            #[cfg(feature = "sequencing")]
            World::Sequencing(world) => world.finished(),
            #[cfg(feature = "soccer")]
            World::Soccer(world) => world.finished().map(soccer::Finished::text),
        }
    }

    /// The fingerprint of the whole state.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        match &self.world {
            World::Geese(world) => world.fingerprint(),
            #[cfg(feature = "sequencing")]
            World::Sequencing(world) => world.fingerprint(),
            #[cfg(feature = "soccer")]
            World::Soccer(world) => world.fingerprint(),
        }
    }

    /// The programs of the present moment as a population file; `None` in a world without any.
    #[must_use]
    pub fn population(&self) -> Option<String> {
        match &self.world {
            World::Geese(world) => {
                let Scenario { title, seed, .. } = &self.scenario;
                Some(geese::Population::of(world).write_with(title, *seed, self.tick()))
            }
            #[cfg(feature = "sequencing")]
            World::Sequencing(_) => None,
            #[cfg(feature = "soccer")]
            World::Soccer(_) => None,
        }
    }

    /// Makes up to `ticks` steps, events included; returns how many it made, fewer only when the run ended.
    pub fn advance(&mut self, ticks: u32) -> u32 {
        for done in 0..ticks {
            if self.finished().is_some() {
                return done;
            }
            self.apply_events();
            match &mut self.world {
                World::Geese(world) => world.step(),
                #[cfg(feature = "sequencing")]
                World::Sequencing(world) => world.step(),
                #[cfg(feature = "soccer")]
                World::Soccer(world) => world.step(),
            }
        }
        ticks
    }

    /// Changes a live parameter now, or does something to a match. The change becomes an event at this tick; later events are dropped, because
    /// what they belonged to will not happen.
    ///
    /// # Errors
    /// The key is unknown or needs a restart, or the value is not allowed; nothing changes then.
    pub fn set(&mut self, key: &str, value: &Value) -> Result<(), ScenarioError> {
        let tick = self.tick();
        let event = Event { tick, key: key.to_owned(), value: value.clone() };
        let keep = self.scenario.events.partition_point(|event| event.tick <= tick);
        let mut events = self.scenario.events[..keep].to_vec();
        // A slider that is dragged changes its mind many times in one tick: the last word counts.
        events.retain(|other| other.tick < tick || other.key != key);
        let mut params = self.params.clone();
        for pending in events[self.next_event.min(events.len())..].iter().chain([&event]) {
            params = apply(&params, pending)?;
        }
        events.push(event);
        self.scenario.events = events;
        Ok(())
    }

    /// Makes one step as [`Run::advance`] does and returns what there is to see of it; `None` when it is no match.
    #[cfg(feature = "soccer")]
    pub fn step_watched(&mut self) -> Option<soccer::Moment> {
        self.apply_events();
        match &mut self.world {
            World::Soccer(world) => Some(world.step_watched()),
            World::Geese(_) => None,
            #[cfg(feature = "sequencing")]
            World::Sequencing(_) => None,
        }
    }

    /// Lets the events of this tick happen, if they have not; a step does so first.
    pub(super) fn apply_events(&mut self) {
        let tick = self.tick();
        let before = self.next_event;
        while let Some(event) = self.scenario.events.get(self.next_event).filter(|event| event.tick <= tick) {
            // Every event was checked when it was read or set; one that fits no more changes nothing.
            if let Ok(params) = apply(&self.params, event) {
                self.params = params;
            }
            #[cfg(feature = "soccer")]
            if let (World::Soccer(world), Some(Ok(hand))) = (&mut self.world, intervention(&self.params, event)) {
                world.intervene(&hand);
            }
            self.next_event += 1;
        }
        if self.next_event > before {
            self.tune();
        }
    }

    fn tune(&mut self) {
        match (&mut self.world, &self.params) {
            (World::Geese(world), WorldParams::Geese(params)) => world.tune(params),
            // No parameter of a plan or a match can change while it goes on, and a run's parameters are of its own world.
            #[cfg(any(feature = "sequencing", feature = "soccer"))]
            _ => {}
        }
    }

    /// The present state, for a keyframe.
    pub(super) fn state(&self) -> State {
        match &self.world {
            World::Geese(world) => State::Geese(Box::new(world.state().clone())),
            #[cfg(feature = "sequencing")]
            World::Sequencing(world) => State::Sequencing(Box::new(world.state().clone())),
            #[cfg(feature = "soccer")]
            World::Soccer(world) => State::Soccer(Box::new(world.state().clone())),
        }
    }

    /// Goes to a state of this same run.
    pub(super) fn restore(&mut self, state: &State) {
        match (&mut self.world, state) {
            (World::Geese(world), State::Geese(state)) => world.restore(state),
            #[cfg(feature = "sequencing")]
            (World::Sequencing(world), State::Sequencing(state)) => world.restore(state),
            #[cfg(feature = "soccer")]
            (World::Soccer(world), State::Soccer(state)) => world.restore(state),
            // States come from this same run.
            #[cfg(any(feature = "sequencing", feature = "soccer"))]
            _ => {}
        }
        // Events at this very tick happen with the next step.
        let tick = self.tick();
        self.params = self.scenario.world.clone();
        self.next_event = 0;
        while let Some(event) = self.scenario.events.get(self.next_event).filter(|event| event.tick < tick) {
            if let Ok(params) = apply(&self.params, event) {
                self.params = params;
            }
            self.next_event += 1;
        }
        self.tune();
    }
}

impl Start {
    /// Plans for up to `budget` integrations, in worlds that plan; returns whether the world is ready.
    #[cfg_attr(not(feature = "sequencing"), expect(unused_variables, reason = "no world of this build plans"))]
    pub fn advance(&mut self, budget: u32) -> bool {
        match &mut self.state {
            Starting::Ready(_) => {}
            #[cfg(feature = "sequencing")]
            Starting::Planning(world) => {
                world.advance(u64::from(budget));
            }
        }
        self.is_ready()
    }

    /// As [`Start::advance`] with the batches of a search made on all threads; the world is the same.
    #[cfg(feature = "cli")]
    pub fn advance_on_threads(&mut self, budget: u32) -> bool {
        match &mut self.state {
            Starting::Ready(_) => {}
            Starting::Planning(world) => {
                world.advance_on_threads(u64::from(budget));
            }
        }
        self.is_ready()
    }

    /// Whether the world is ready: at once where nothing is planned.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        match &self.state {
            Starting::Ready(_) => true,
            #[cfg(feature = "sequencing")]
            Starting::Planning(world) => world.progress().outcome.is_some(),
        }
    }

    /// What is being started.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Where the search for a plan stands; `None` in a world that does not plan.
    #[cfg(feature = "sequencing")]
    #[must_use]
    pub fn search(&self) -> Option<sequencing::Progress> {
        match &self.state {
            Starting::Ready(_) => None,
            Starting::Planning(world) => Some(world.progress()),
        }
    }

    /// The run at tick 0, after all planning that is still to be done.
    #[must_use]
    pub fn run(self) -> Run {
        let world = match self.state {
            Starting::Ready(world) => world,
            #[cfg(feature = "sequencing")]
            Starting::Planning(world) => World::Sequencing(Box::new(world.world())),
        };
        Run { params: self.scenario.world.clone(), scenario: self.scenario, next_event: 0, world }
    }
}

impl State {
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::Geese(state) => state.bytes(),
            #[cfg(feature = "sequencing")]
            Self::Sequencing(state) => state.bytes(),
            #[cfg(feature = "soccer")]
            Self::Soccer(state) => state.bytes(),
        }
    }
}
