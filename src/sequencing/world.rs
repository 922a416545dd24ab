//! A scenario carried out: the search when the world is built, then its plan, one tick a step of 0.1 s.
//!
//! Searching belongs to the start because what happens from tick 0 on depends on the whole plan. Pages and others that
//! want to watch or stop a search drive a [`Search`] themselves, in slices.

use super::dynamics::Kernel;
use super::params::Params;
use super::robust::{Robustness, robustness};
use super::search::{self, Options, Progress, Search};
use super::tasks::{Collision, Task, Touched};
use crate::fingerprint::Fingerprint;
use crate::random::Seed;
use serde::Serialize;

/// A task, what the search found, and how far the plan was carried out.
#[derive(Clone, Debug)]
pub struct World {
    task: Task,
    solution: Solution,
    plan: Vec<u8>,
    state: State,
    kernel: Kernel,
}

/// A world on its way: its search, which can be made in slices.
#[derive(Clone, Debug)]
pub struct Preparation {
    params: Params,
    seed: Seed,
    task: Task,
    search: Search,
}

/// The state at one tick.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    tick: u32,
    /// 3 M reals.
    swarm: Vec<f64>,
    marks: Vec<u64>,
    visited: u32,
    /// Metres each robot has gone.
    lengths: Vec<f64>,
}

/// What a search came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Solution {
    /// How the search ended; `None` while it goes on.
    #[serde(skip)]
    pub outcome: Option<search::Outcome>,
    /// The outcome in words, see [`search::Outcome::text`].
    pub result: &'static str,
    /// The letters of the plan.
    pub plan: Option<String>,
    /// The names of its behaviours.
    pub behaviours: Vec<String>,
    /// Path length and charges, metres.
    pub cost: Option<f64>,
    /// No plan costs less; absent where the method proves nothing, or when there is no plan.
    pub lower_bound: Option<f64>,
    /// Cost over lower bound.
    pub proven_ratio: Option<f64>,
    /// Whether the ratio is 1.
    pub optimal: bool,
    /// Whether Stops were kept for the end, which is faster and here loses nothing.
    pub stop_last: bool,
    /// Sequences extended.
    pub expanded: u64,
    /// Behaviours simulated for one interval.
    pub integrated: u64,
    /// Of these, those that collided.
    pub collided: u64,
    /// Entries left in the queue.
    pub open: usize,
    /// Entries in the queue when they were most.
    pub open_peak: usize,
    /// Sequences stored.
    pub nodes: usize,
    /// What the plan does from starts moved a little.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robustness: Option<Fragility>,
    /// Without a plan: what each behaviour of the library runs into in the first interval.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub first_interval: Vec<String>,
}

/// The share of replays that stayed feasible.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fragility {
    /// How far each robot was moved at the start, metres.
    pub jitter: f64,
    /// Replays made.
    pub runs: u32,
    /// Those that stayed feasible.
    pub feasible: u32,
}

/// How a run stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// What the search came to.
    #[serde(flatten)]
    pub solution: Solution,
    /// Metres gone so far by all robots.
    pub path_length: f64,
    /// Whether the present state is in the goal set.
    pub goal: bool,
    /// Visited cells; 0 without a grid.
    pub visited: u32,
}

impl World {
    /// Builds the task of a scenario and searches to the end or to the budget.
    ///
    /// # Errors
    /// As [`Params::tasks`], and when the fixed beginning collides.
    pub fn new(params: &Params, seed: Seed) -> Result<Self, (&'static str, String)> {
        Ok(Self::prepare(params, seed)?.world())
    }

    /// Builds the task of a scenario and begins its search.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn prepare(params: &Params, seed: Seed) -> Result<Preparation, (&'static str, String)> {
        let (task, wide) = params.tasks(seed)?;
        let search = params.search(&wide, false)?;
        Ok(Preparation { params: params.clone(), seed, task, search })
    }

    /// What the search came to.
    #[must_use]
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The plan, as indices of the library, one an interval; empty without one.
    #[must_use]
    pub fn plan(&self) -> &[u8] {
        &self.plan
    }

    /// The task, without margins.
    #[must_use]
    pub fn task(&self) -> &Task {
        &self.task
    }

    /// The state.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Goes to a state of this same world.
    pub fn restore(&mut self, state: &State) {
        self.state.clone_from(state);
    }

    /// Makes one step of the plan; nothing when it has ended.
    pub fn step(&mut self) {
        if self.finished().is_some() {
            return;
        }
        let state = &mut self.state;
        let behaviour = self.plan[(state.tick / self.task.steps()) as usize];
        state.tick += 1;
        if self.task.stop() == Some(behaviour) {
            return;
        }
        self.kernel.start();
        // The plan was simulated by this same step with margins of at least 0, so it runs into nothing.
        if let Ok(new) = self.task.step(behaviour, &mut state.swarm, &mut state.marks, &mut self.kernel) {
            state.visited += new;
        }
        for (length, more) in state.lengths.iter_mut().zip(self.kernel.lengths()) {
            *length += more;
        }
    }

    /// Why the run ended, in words; `None` while the plan goes on.
    #[must_use]
    pub fn finished(&self) -> Option<&'static str> {
        let end = self.plan.len() as u32 * self.task.steps();
        if self.plan.is_empty() {
            Some(self.solution.result)
        } else {
            (self.state.tick >= end).then_some("the plan was carried out")
        }
    }

    /// How the run stands.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        Outcome {
            solution: self.solution.clone(),
            path_length: self.state.lengths.iter().sum(),
            goal: self.task.is_goal(&self.state.swarm, self.state.visited),
            visited: self.state.visited,
        }
    }

    /// The fingerprint of state, plan and counts.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        let State { tick, swarm, marks, visited, lengths } = &self.state;
        hash.u32(*tick);
        swarm.iter().chain(lengths).for_each(|&real| hash.f64(real));
        for &word in marks {
            hash.u64(word);
        }
        hash.u32(*visited);
        for &behaviour in &self.plan {
            hash.u32(u32::from(behaviour));
        }
        hash.u64(self.solution.expanded);
        hash.u64(self.solution.integrated);
        hash.f64(self.solution.cost.unwrap_or(f64::INFINITY));
        hash.f64(self.solution.lower_bound.unwrap_or(0.0));
        hash.finish()
    }
}

impl Preparation {
    /// Searches for up to `budget` integrations; returns where the search stands.
    pub fn advance(&mut self, budget: u64) -> Progress {
        self.search.advance(budget)
    }

    /// As [`Preparation::advance`], see [`Search::advance_on_threads`].
    #[cfg(feature = "cli")]
    pub fn advance_on_threads(&mut self, budget: u64) -> Progress {
        self.search.advance_on_threads(budget)
    }

    /// Where the search stands.
    #[must_use]
    pub fn progress(&self) -> Progress {
        self.search.progress()
    }

    /// Searches to the end or to the budget; returns the world at tick 0.
    #[must_use]
    pub fn world(mut self) -> World {
        self.search.advance(u64::MAX);
        let Self { params, seed, task, search } = self;
        let solution = Solution::of(&search, &task, &params, seed);
        let plan = search.best().map_or_else(Vec::new, |plan| plan.sequence.clone());
        let swarm = task.start().to_vec();
        let mut marks = vec![0; task.words()];
        let visited = task.mark_start(&swarm, &mut marks);
        let state = State { tick: 0, swarm, marks, visited, lengths: vec![0.0; task.robots()] };
        World { kernel: Kernel::new(task.robots()), task, solution, plan, state }
    }
}

impl State {
    /// Steps made so far.
    #[must_use]
    pub fn tick(&self) -> u32 {
        self.tick
    }

    /// x, y and heading of all robots, 3 M reals.
    #[must_use]
    pub fn swarm(&self) -> &[f64] {
        &self.swarm
    }

    /// Bytes taken, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + 8 * (self.swarm.len() + self.marks.len() + self.lengths.len())
    }
}

impl Params {
    /// The search for a task, after the fixed beginning.
    ///
    /// - `record`: whether integrations are kept for drawing.
    ///
    /// # Errors
    /// The fixed beginning collides.
    pub fn search(&self, task: &Task, record: bool) -> Result<Search, (&'static str, String)> {
        let sequence = task
            .sequence(&self.prefix)
            .map_err(|letter| ("prefix", format!("expected letters of the library, found {letter:?}")))?;
        let options = Options { record, ..self.options() };
        Search::new(task, options, &sequence).map_err(|(interval, collision)| {
            let what = words(task, sequence.get(interval as usize).copied().unwrap_or(0), &collision);
            ("prefix", format!("expected a beginning without collisions; in interval {}, {what}", interval + 1))
        })
    }
}

impl Solution {
    /// What a search came to.
    ///
    /// - `task`: the one without margins, on which the plan's robustness is tried.
    #[must_use]
    pub fn of(search: &Search, task: &Task, params: &Params, seed: Seed) -> Self {
        let progress = search.progress();
        let plan = search.best();
        let sequence = plan.map_or(&[][..], |plan| &plan.sequence);
        let names = sequence.iter().map(|&at| task.library()[usize::from(at)].name.clone());
        let proven_ratio = search.proven_ratio();
        let robustness = plan.filter(|_| params.jitter_runs > 0).map(|plan| {
            let found = robustness(task, &plan.sequence, params.jitter, params.jitter_runs, seed);
            let Robustness { runs, feasible, .. } = found;
            Fragility { jitter: params.jitter, runs, feasible }
        });
        Self {
            outcome: progress.outcome,
            result: progress.outcome.map_or("searching", search::Outcome::text),
            plan: plan.map(|plan| task.letters(&plan.sequence)),
            behaviours: names.collect(),
            cost: progress.cost,
            lower_bound: search.lower_bound().filter(|bound| bound.is_finite()),
            proven_ratio,
            optimal: proven_ratio.is_some_and(|ratio| ratio <= 1.0),
            stop_last: search.stop_last(),
            expanded: progress.counts.expanded,
            integrated: progress.counts.integrated,
            collided: progress.counts.collided,
            open: progress.open,
            open_peak: progress.open_peak,
            nodes: progress.nodes,
            robustness,
            first_interval: if plan.is_none() { first_interval(search.task()) } else { Vec::new() },
        }
    }
}

/// What each moving behaviour runs into when it is the first.
#[must_use]
pub fn first_interval(task: &Task) -> Vec<String> {
    let mut kernel = Kernel::new(task.robots());
    let hits = |behaviour: u8| {
        let (mut state, mut marks) = (task.start().to_vec(), vec![0; task.words()]);
        let collision = task.act(behaviour, &mut state, &mut marks, &mut kernel).err()?;
        Some(words(task, behaviour, &collision))
    };
    (0..task.library().len() as u8).filter_map(hits).collect()
}

/// A collision in words.
fn words(task: &Task, behaviour: u8, collision: &Collision) -> String {
    let name = &task.library()[usize::from(behaviour)].name;
    let what = match collision.touched {
        Touched::Obstacle(at) => format!("obstacle {}", at + 1),
        Touched::Edge => "the edge of the map".to_owned(),
    };
    let seconds = f64::from(collision.step) * super::dynamics::STEP;
    format!("{name}: robot {} hits {what} after {seconds:.1} s", collision.robot + 1)
}
