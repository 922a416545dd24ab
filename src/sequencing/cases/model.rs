//! Cases of the model: commands, single behaviours, sequences over a grid.

use super::super::dynamics::Kernel;
use super::super::parts::Goal;
use super::super::replay::replay;
use super::super::tasks::Task;
use super::{CONTROLS, Grid, NAMES, PLANS, Poses, World, goal, near, near_all, same, task};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Commands of each behaviour from one state.
#[derive(Clone, Debug, Deserialize)]
pub struct ControlCase {
    pub name: String,
    start: Poses,
    controls: BTreeMap<String, Vec<[f64; 2]>>,
}

/// One behaviour in the open.
#[derive(Clone, Debug, Deserialize)]
pub struct VectorCase {
    pub name: String,
    behaviour: String,
    integrator: String,
    dt: f64,
    seconds: f64,
    neighbours: String,
    start: Poses,
    controls_t0: Vec<[f64; 2]>,
    after_1_step: Poses,
    after_10_s: Poses,
    path_length: Vec<f64>,
    cost: f64,
    tolerance: f64,
    #[serde(default)]
    optional: bool,
}

/// A sequence over a grid on an open map.
#[derive(Clone, Debug, Deserialize)]
pub struct CoverageCase {
    pub name: String,
    world: World,
    grid: Grid,
    start: Poses,
    sequence: String,
    visited_at_start: u32,
    visited_after_each_interval: Vec<u32>,
    interval_costs: Vec<f64>,
    cost: f64,
    #[serde(rename = "final")]
    end: Poses,
}

/// A goal that nothing depends on.
const ANYWHERE: Goal = Goal::Reach { centre: [0.0, 0.0], radius: 1.0 };

fn behaviour(name: &str) -> Result<u8, String> {
    let found = NAMES.iter().position(|known| *known == name);
    found.map(|at| at as u8).ok_or_else(|| format!("behaviour: expected one of {}, found {name:?}", NAMES.join(", ")))
}

fn check_commands(what: &str, task: &Task, name: &str, expected: &[[f64; 2]], tolerance: f64) -> Result<(), String> {
    let mut kernel = Kernel::new(task.robots());
    let law = task.library()[usize::from(behaviour(name)?)].law(task.robots());
    kernel.control(&law, task.start());
    same(&format!("{what}, robots"), &expected.len(), &task.robots())?;
    for (robot, expected) in expected.iter().enumerate() {
        near_all(&format!("{what}[{robot}]"), expected, &kernel.command(robot), tolerance)?;
    }
    Ok(())
}

impl ControlCase {
    pub fn run(&self) -> Result<(), String> {
        let task = task(None, ANYWHERE, &self.start, 1)?;
        for (name, expected) in &self.controls {
            check_commands(&format!("controls.{name}"), &task, name, expected, CONTROLS)?;
        }
        Ok(())
    }
}

impl VectorCase {
    /// Why an optional case does not concern this model.
    pub fn skipped(&self) -> Option<String> {
        let ours = self.integrator == "zoh_midheading" && self.neighbours == "all" && (self.dt - 0.1).abs() < 1e-12;
        (self.optional && !ours).then(|| {
            let Self { integrator, neighbours, dt, .. } = self;
            format!("optional, and the model has one integrator and one neighbour rule ({integrator}, {neighbours}, dt {dt})")
        })
    }

    pub fn run(&self) -> Result<(), String> {
        same("integrator", &"zoh_midheading", &self.integrator.as_str())?;
        same("neighbours", &"all", &self.neighbours.as_str())?;
        near("dt", 0.1, self.dt, 1e-12)?;
        near("seconds", 10.0, self.seconds, 1e-9)?;
        let task = task(None, ANYWHERE, &self.start, 1)?;
        check_commands("controls_t0", &task, &self.behaviour, &self.controls_t0, self.tolerance)?;
        let index = behaviour(&self.behaviour)?;
        let mut kernel = Kernel::new(task.robots());
        let mut state = task.start().to_vec();
        let stepped = task.step(index, &mut state, &mut [], &mut kernel);
        stepped.map_err(|_| "expected an open map, found its edge".to_owned())?;
        self.after_1_step.compare("after_1_step", &state, self.tolerance)?;
        let mut state = task.start().to_vec();
        let acted = task.act(index, &mut state, &mut [], &mut kernel);
        let (cost, _) = acted.map_err(|_| "expected an open map, found its edge".to_owned())?;
        self.after_10_s.compare("after_10_s", &state, self.tolerance)?;
        near_all("path_length", &self.path_length, kernel.lengths(), self.tolerance)?;
        near("cost", self.cost, cost, self.tolerance)
    }
}

impl CoverageCase {
    pub fn run(&self) -> Result<(), String> {
        let goal = goal(None, Some(self.grid), &self.world)?;
        let task = task(Some(&self.world), goal, &self.start, self.sequence.chars().count())?;
        let sequence =
            task.sequence(&self.sequence).map_err(|letter| format!("sequence: unknown letter {letter:?}"))?;
        let done = replay(&task, &sequence, task.start(), &mut Kernel::new(task.robots()));
        if let Some((interval, collision)) = done.collision {
            return Err(format!("expected no collision, found {collision:?} in interval {}", interval + 1));
        }
        same("visited_at_start", &self.visited_at_start, &done.visited[0])?;
        same("visited_after_each_interval", &self.visited_after_each_interval[..], &done.visited[1..])?;
        near_all("interval_costs", &self.interval_costs, &done.costs, PLANS)?;
        near("cost", self.cost, done.cost(), PLANS)?;
        self.end.compare("final", &done.state, PLANS)
    }
}
