//! One run of a study on its way: it can be made in slices, and what it gives does not depend on them.

use super::cells::Cell;
use super::metrics::{Metric, Reached, advance, measure};
use super::row::Row;
use super::spec::Study;
use crate::scenario::{Run, WorldParams};

/// A run of a study on its way.
#[derive(Clone, Debug)]
pub struct Job {
    metrics: Vec<Metric>,
    reached: Reached,
    /// The world, or the row of a run whose world could not be built.
    state: Result<Box<Run>, Row>,
    run: u32,
}

impl Job {
    /// Makes up to `steps` steps; returns whether the run is over.
    pub fn advance(&mut self, steps: u32) -> bool {
        match &mut self.state {
            Ok(world) => advance(world, &self.metrics, &mut self.reached, steps),
            Err(_) => true,
        }
    }

    /// The row of the run as it stands; what results keep once [`Job::advance`] has said that it is over.
    #[must_use]
    pub fn row(&self) -> Row {
        match &self.state {
            Ok(world) => {
                let metrics = measure(world, &self.metrics, &self.reached);
                Row { run: self.run, metrics, end: Ok(world.fingerprint()) }
            }
            Err(row) => row.clone(),
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
        let state = Run::new(self.cells[cell].scenario_of(seed)).map(Box::new);
        let state = state.map_err(|error| Row::failed(self, run, &error.to_string()));
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
