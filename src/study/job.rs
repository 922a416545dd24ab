//! One run of a study on its way: it can be made in slices, and what it gives does not depend on them.

use super::cells::Cell;
use super::metrics::{Metric, Reached, advance, measure};
use super::row::Row;
use super::spec::Study;
use crate::scenario::{Run, Start, WorldParams};

/// A run of a study on its way.
#[derive(Clone, Debug)]
pub struct Job {
    metrics: Vec<Metric>,
    reached: Reached,
    state: State,
    run: u32,
}

#[derive(Clone, Debug)]
enum State {
    /// On its way to tick 0; taken out in the moment in which the run begins.
    Starting(Option<Box<Start>>),
    Running(Box<Run>),
    /// The row of a run whose world could not be built.
    Failed(Row),
}

impl Job {
    /// Makes up to `steps` steps, of the search for a plan first if there is one; returns whether the run is over.
    pub fn advance(&mut self, steps: u32) -> bool {
        match &mut self.state {
            State::Starting(start) => {
                if let Some(start) = start.take_if(|start| start.advance(steps)) {
                    self.state = State::Running(Box::new(start.run()));
                }
                false
            }
            State::Running(run) => advance(run, &self.metrics, &mut self.reached, steps),
            State::Failed(_) => true,
        }
    }

    /// The row of the run as it stands; what results keep once [`Job::advance`] has said that it is over.
    #[must_use]
    pub fn row(&self) -> Row {
        match &self.state {
            State::Running(run) => {
                let metrics = measure(run, &self.metrics, &self.reached);
                Row { run: self.run, metrics, end: Ok(run.fingerprint()) }
            }
            State::Starting(_) => {
                let metrics = vec![None; self.metrics.len()];
                Row { run: self.run, metrics, end: Err("the search is not over".to_owned()) }
            }
            State::Failed(row) => row.clone(),
        }
    }
}

impl Study {
    /// A run at its start.
    ///
    /// - `run`: below [`Study::run_count`].
    #[must_use]
    pub fn start(&self, run: u32) -> Job {
        let (cell, seed) = self.job(run);
        let state = match Run::start(self.cells[cell].scenario_of(seed)) {
            Ok(start) if start.is_ready() => State::Running(Box::new(start.run())),
            Ok(start) => State::Starting(Some(Box::new(start))),
            Err(error) => State::Failed(Row::failed(self, run, &error.to_string())),
        };
        Job { metrics: self.metrics.clone(), reached: Reached::default(), state, run }
    }

    /// Makes a run.
    ///
    /// - `run`: below [`Study::run_count`].
    #[must_use]
    pub fn make(&self, run: u32) -> Row {
        let mut job = self.start(run);
        while !job.advance(u32::MAX) {}
        job.row()
    }

    /// Robots times steps over all runs, if none ends early: a measure of how long they take.
    #[must_use]
    pub fn robot_steps(&self) -> u64 {
        self.cells.iter().map(Cell::robot_steps).sum::<u64>() * u64::from(self.seeds)
    }
}

impl Cell {
    /// Robots times steps of one run, if it does not end early.
    #[must_use]
    pub fn robot_steps(&self) -> u64 {
        match &self.scenario.world {
            WorldParams::Geese(params) => u64::from(params.agents) * u64::from(params.steps),
            // Of the plan's replay alone; how long the search before it takes, nobody knows.
            #[cfg(feature = "sequencing")]
            WorldParams::Sequencing(params) => u64::from(params.robots) * u64::from(self.scenario.world.steps()),
            #[cfg(feature = "soccer")]
            WorldParams::Soccer(params) => 6 * u64::from(params.steps()),
        }
    }
}
