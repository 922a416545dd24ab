//! Running a file of cases (controls, vectors, searches, full-size plans, coverage) against the model and the planner.

mod model;
mod plans;

use super::behaviours::library;
use super::cover::Cells;
use super::map::{Bounds, Form};
use super::parts::{Goal, Parts};
use super::tasks::Task;
use crate::verdict::CaseVerdict;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// A cases file.
#[derive(Clone, Debug, Deserialize)]
pub struct Cases {
    #[serde(rename = "conventions")]
    _conventions: BTreeMap<String, Value>,
    controls: Vec<model::ControlCase>,
    vectors: Vec<model::VectorCase>,
    searches: Vec<plans::SearchCase>,
    full_size: Vec<plans::FullCase>,
    coverage: Vec<model::CoverageCase>,
}

/// Poses, one entry a robot in each list.
#[derive(Clone, Debug, Deserialize)]
struct Poses {
    x: Vec<f64>,
    y: Vec<f64>,
    theta: Vec<f64>,
}

#[derive(Clone, Debug, Deserialize)]
struct World {
    /// Least x, greatest x, least y, greatest y.
    map: [f64; 4],
    circles: Vec<[f64; 3]>,
    boxes: Vec<[f64; 4]>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
struct Grid {
    cell: f64,
    nx: u32,
    ny: u32,
    #[serde(default)]
    ratio: f64,
}

/// Seconds of an interval; the schema has no other.
const INTERVAL: u32 = 10;
/// The most decision points a case may have.
const MOST_INTERVALS: usize = 60;
/// The names that cases give the behaviours, in the library's order.
const NAMES: [&str; 10] = ["Flock", "FlockE", "FlockN", "FlockW", "FlockS", "Stop", "Rend", "Anti", "LineX", "LineY"];
/// How far controls may be from those expected, as the file's conventions say.
const CONTROLS: f64 = 1e-8;
/// How far costs and final states of plans may be from those expected, as the file's conventions say.
const PLANS: f64 = 1e-5;

impl Cases {
    /// Reads a cases file.
    ///
    /// # Errors
    /// A sentence with line and column where the text is no JSON of this schema.
    pub fn read(json: &str) -> Result<Self, String> {
        serde_json::from_str(json).map_err(|error| error.to_string())
    }

    /// Runs every case that concerns this model, in the file's order.
    #[must_use]
    pub fn run(&self) -> Vec<CaseVerdict> {
        let mut verdicts = self.run_model();
        let mut add = |id: String, fault: Result<(), String>| verdicts.push(CaseVerdict { id, fault: fault.err() });
        for case in &self.searches {
            add(format!("searches {}", case.name), case.run());
        }
        for case in &self.full_size {
            add(format!("full_size {}", case.name), case.run());
        }
        for case in &self.coverage {
            add(format!("coverage {}", case.name), case.run());
        }
        verdicts
    }

    /// Runs the cases of single steps and single behaviours only.
    #[must_use]
    pub fn run_model(&self) -> Vec<CaseVerdict> {
        let mut verdicts = Vec::new();
        let mut add = |id: String, fault: Result<(), String>| verdicts.push(CaseVerdict { id, fault: fault.err() });
        for case in &self.controls {
            add(format!("controls {}", case.name), case.run());
        }
        for case in self.vectors.iter().filter(|case| case.skipped().is_none()) {
            add(format!("vectors {}", case.name), case.run());
        }
        verdicts
    }

    /// The optional cases that concern what this model does not have, each with the reason.
    #[must_use]
    pub fn skipped(&self) -> Vec<String> {
        let skip = |case: &model::VectorCase| Some(format!("vectors {}: {}", case.name, case.skipped()?));
        self.vectors.iter().filter_map(skip).collect()
    }
}

impl Poses {
    fn robots(&self) -> Result<usize, String> {
        let robots = self.x.len();
        if robots == 0 || self.y.len() != robots || self.theta.len() != robots {
            let found = format!("{}, {} and {}", robots, self.y.len(), self.theta.len());
            return Err(format!("expected as many x, y and theta, at least one of each, found {found}"));
        }
        Ok(robots)
    }

    /// Each robot's x, y and heading.
    fn poses(&self) -> Result<Vec<[f64; 3]>, String> {
        let robots = self.robots()?;
        Ok((0..robots).map(|at| [self.x[at], self.y[at], self.theta[at]]).collect())
    }

    /// Compares with a state of 3 M reals.
    fn compare(&self, what: &str, state: &[f64], tolerance: f64) -> Result<(), String> {
        let robots = self.robots().map_err(|fault| format!("{what}: {fault}"))?;
        if state.len() != 3 * robots {
            return Err(format!("{what}: expected {robots} robots, found {}", state.len() / 3));
        }
        for (part, (name, expected)) in [("x", &self.x), ("y", &self.y), ("theta", &self.theta)].iter().enumerate() {
            near_all(&format!("{what}.{name}"), expected, &state[part * robots..(part + 1) * robots], tolerance)?;
        }
        Ok(())
    }
}

/// A task of the standard library.
fn task(world: Option<&World>, goal: Goal, start: &Poses, decisions: usize) -> Result<Task, String> {
    if decisions > MOST_INTERVALS {
        return Err(format!("intervals: expected at most {MOST_INTERVALS}, found {decisions}"));
    }
    // Vectors are in the open: no robot comes farther than this.
    let open = World { map: [-1e9, 1e9, -1e9, 1e9], circles: vec![], boxes: vec![] };
    let World { map: [left, right, bottom, top], circles, boxes } = world.unwrap_or(&open);
    let forms = circles.iter().map(|disc| Form::Disc(*disc)).chain(boxes.iter().map(|sides| Form::Box(*sides)));
    let parts = Parts {
        bounds: Bounds { left: *left, right: *right, bottom: *bottom, top: *top },
        obstacles: forms.collect(),
        goal,
        library: library(),
        start: start.poses().map_err(|fault| format!("start: {fault}"))?,
        decisions: decisions as u16,
        interval: INTERVAL,
    };
    Task::new(&parts).map_err(|error| error.to_string())
}

/// The goal of a case: a target or a grid.
fn goal(target: Option<[f64; 3]>, grid: Option<Grid>, world: &World) -> Result<Goal, String> {
    match (target, grid) {
        (Some([x, y, radius]), None) => Ok(Goal::Reach { centre: [x, y], radius }),
        (None, Some(grid)) => {
            let origin = [world.map[0], world.map[2]];
            let cells = Cells { origin, side: grid.cell, columns: grid.nx, rows: grid.ny };
            Ok(Goal::Cover { cells, ratio: grid.ratio })
        }
        _ => Err("expected either a target or a grid, found both or neither".to_owned()),
    }
}

fn near(what: &str, expected: f64, found: f64, tolerance: f64) -> Result<(), String> {
    if (expected - found).abs() <= tolerance {
        Ok(())
    } else {
        Err(format!("{what}: expected {expected} within {tolerance}, found {found}"))
    }
}

fn near_all(what: &str, expected: &[f64], found: &[f64], tolerance: f64) -> Result<(), String> {
    same(&format!("{what}, numbers"), &expected.len(), &found.len())?;
    let mut pairs = expected.iter().zip(found).enumerate();
    pairs.try_for_each(|(at, (expected, found))| near(&format!("{what}[{at}]"), *expected, *found, tolerance))
}

fn same<T: PartialEq + std::fmt::Debug + ?Sized>(what: &str, expected: &T, found: &T) -> Result<(), String> {
    if expected == found { Ok(()) } else { Err(format!("{what}: expected {expected:?}, found {found:?}")) }
}
