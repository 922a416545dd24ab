//! The parameters of a sequencing scenario, and the task and options they stand for.

use super::behaviours::{Behaviour, LETTERS, standard};
use super::costs::{Costs, Switches};
use super::cover::Cells;
use super::layout;
use super::lists::{area, found, numbers, read_behaviour, read_form};
use super::map::{Bounds, Form};
use super::parts::Goal;
use super::search::{Method, Options};
use super::tasks::Task;
use crate::random::Seed;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Every parameter; see `schema.rs` for bounds, meaning and source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "each field is described once, in the schema")]
pub struct Params {
    pub task: TaskKind,
    pub robots: u32,
    pub decisions: u16,
    pub interval: u32,
    pub map: Vec<Value>,
    pub target_x: f64,
    pub target_y: f64,
    pub target_radius: f64,
    pub cell_size: f64,
    pub coverage: f64,
    pub start_area: Vec<Value>,
    pub start_clearance: f64,
    pub start_list: Vec<Value>,
    pub obstacles: u32,
    pub obstacle_area: Vec<Value>,
    pub obstacle_least: f64,
    pub obstacle_most: f64,
    pub clear_of_start: f64,
    pub clear_of_target: f64,
    pub obstacle_list: Vec<Value>,
    pub library: String,
    pub own_behaviours: Vec<Value>,
    pub method: MethodKind,
    pub weight: f64,
    pub anchor_weight: f64,
    pub second_weight: f64,
    pub rounding: f64,
    pub eager: bool,
    pub geodesic: bool,
    pub forecast: u32,
    pub batch: u32,
    pub budget: u32,
    pub memory: u32,
    pub prefix: String,
    pub time_cost: f64,
    pub switch_rule: SwitchRule,
    pub switch_cost: f64,
    pub into_stop: f64,
    pub out_of_stop: f64,
    pub first_counts: bool,
    pub obstacle_margin: f64,
    pub target_margin: f64,
    pub coverage_margin: f64,
    pub jitter: f64,
    pub jitter_runs: u32,
}

/// What the swarm is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TaskKind {
    /// Go into the target disc.
    Navigate,
    /// Visit a share of the cells.
    Cover,
}

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MethodKind {
    /// Algorithm 1 word by word.
    Literal,
    /// Accelerated without losing a guarantee.
    Exact,
    /// From a large weight down to the wanted one.
    Anytime,
    /// Two queues.
    MultiHeuristic,
    /// Raises the lower bound and lowers the best plan's cost in turn.
    BothSides,
    /// States alike after rounding are left out; proves nothing.
    Approximate,
}

/// Which changes of behaviour are charged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SwitchRule {
    /// None.
    None,
    /// Between successive moving behaviours; Stops are looked through.
    StopTransparent,
    /// Every change, Stop included.
    EveryChange,
    /// Between moving behaviours and out of Stop, but not into it.
    LeavingStop,
    /// Each kind by its own charge.
    Own,
}

impl Default for Params {
    fn default() -> Self {
        let square = |low: i32, high: i32| [low, high, low, high].map(Value::from).to_vec();
        Self {
            task: TaskKind::Navigate,
            robots: 20,
            decisions: 15,
            interval: 10,
            map: square(-50, 50),
            target_x: 25.0,
            target_y: 25.0,
            target_radius: 12.0,
            cell_size: 1.0,
            coverage: 0.25,
            start_area: square(-44, -32),
            start_clearance: 3.0,
            start_list: Vec::new(),
            obstacles: 6,
            obstacle_area: square(-45, 45),
            obstacle_least: 3.0,
            obstacle_most: 8.0,
            clear_of_start: 14.0,
            clear_of_target: 13.0,
            obstacle_list: Vec::new(),
            library: LETTERS.to_owned(),
            own_behaviours: Vec::new(),
            method: MethodKind::Exact,
            weight: 1.5,
            anchor_weight: 1.25,
            second_weight: 1.6,
            rounding: 1.0,
            eager: false,
            geodesic: false,
            forecast: 0,
            batch: 1,
            budget: 30_000,
            memory: 256,
            prefix: String::new(),
            time_cost: 0.0,
            switch_rule: SwitchRule::None,
            switch_cost: 0.0,
            into_stop: 0.0,
            out_of_stop: 0.0,
            first_counts: false,
            obstacle_margin: 0.0,
            target_margin: 0.0,
            coverage_margin: 0.0,
            jitter: 0.001,
            jitter_runs: 50,
        }
    }
}

/// A field and what is wrong with it.
type Fault = (&'static str, String);

impl Params {
    /// Sets the field of that name, in kebab case; returns false when there is none or the value is of another type.
    pub fn set(&mut self, name: &str, value: &Value) -> bool {
        let Ok(Value::Object(mut fields)) = serde_json::to_value(&*self) else { return false };
        if !fields.contains_key(name) {
            return false;
        }
        fields.insert(name.to_owned(), value.clone());
        serde_json::from_value(Value::Object(fields)).map(|changed| *self = changed).is_ok()
    }

    /// Steps until the horizon's end.
    #[must_use]
    pub fn steps(&self) -> u32 {
        u32::from(self.decisions) * self.interval * super::dynamics::STEPS_PER_SECOND
    }

    /// Checks what concerns several parameters and the insides of lists, for every seed alike.
    ///
    /// # Errors
    /// The field's name, what was found and what is allowed.
    pub fn check(&self) -> Result<(), Fault> {
        self.bounds()?;
        area("start-area", &self.start_area)?;
        area("obstacle-area", &self.obstacle_area)?;
        if self.obstacle_least > self.obstacle_most {
            let found = format!("{} and {}", self.obstacle_least, self.obstacle_most);
            return Err(("obstacle-least", format!("expected at most obstacle-most, found {found}")));
        }
        self.starts()?;
        self.forms()?;
        self.behaviours()?;
        if self.task == TaskKind::Cover {
            self.cells()?;
        }
        Ok(())
    }

    /// The task of a seed, and the same task with margins, which is what is planned for.
    ///
    /// # Errors
    /// As [`Params::check`]; there is no room for the obstacles or robots; a robot starts where it cannot.
    pub fn tasks(&self, seed: Seed) -> Result<(Task, Task), Fault> {
        let in_task = |error: super::parts::TaskError| match error.field {
            "start" if self.start_list.is_empty() => ("start-area", error.message),
            "start" => ("start-list", error.message),
            "obstacles" => ("obstacle-list", error.message),
            "target" => ("target-radius", error.message),
            "cells" => ("cell-size", error.message),
            "library" => ("own-behaviours", error.message),
            "map" => ("map", error.message),
            _ => ("robots", error.message),
        };
        let task = Task::new(&layout::parts(self, seed)?).map_err(in_task)?;
        let wide =
            task.with_margins(self.obstacle_margin, self.target_margin, self.coverage_margin).map_err(|error| {
                match error.field {
                    "start" => ("obstacle-margin", format!("with obstacles grown, {}", error.message)),
                    "target" => ("target-margin", error.message),
                    _ => in_task(error),
                }
            })?;
        Ok((task, wide))
    }

    /// How to search.
    #[must_use]
    pub fn options(&self) -> Options {
        let method = match self.method {
            MethodKind::Literal => Method::Literal,
            MethodKind::Exact => Method::Exact,
            MethodKind::Anytime => Method::Anytime,
            MethodKind::MultiHeuristic => {
                Method::MultiHeuristic { anchor: self.anchor_weight, second: self.second_weight }
            }
            MethodKind::BothSides => Method::BothSides,
            MethodKind::Approximate => Method::Approximate(self.rounding),
        };
        let charged = |between, into_stop, out_of_stop| Switches::Charged {
            between,
            into_stop,
            out_of_stop,
            first: self.first_counts,
        };
        let charge = self.switch_cost;
        let switches = match self.switch_rule {
            SwitchRule::None => Switches::Free,
            SwitchRule::StopTransparent => Switches::Transparent(charge),
            SwitchRule::EveryChange => charged(charge, charge, charge),
            SwitchRule::LeavingStop => charged(charge, 0.0, charge),
            SwitchRule::Own => charged(charge, self.into_stop, self.out_of_stop),
        };
        Options {
            method,
            weight: self.weight,
            eager: self.eager,
            geodesic: self.geodesic,
            forecast: self.forecast,
            batch: self.batch,
            integrations: u64::from(self.budget),
            nodes: u32::MAX,
            bytes: (self.memory as usize) << 20,
            costs: Costs { per_second: self.time_cost, switches },
            record: false,
        }
    }

    /// The map.
    pub(super) fn bounds(&self) -> Result<Bounds, Fault> {
        area("map", &self.map)
    }

    pub(super) fn goal(&self) -> Result<Goal, Fault> {
        Ok(match self.task {
            TaskKind::Navigate => Goal::Reach { centre: [self.target_x, self.target_y], radius: self.target_radius },
            TaskKind::Cover => Goal::Cover { cells: self.cells()?, ratio: self.coverage },
        })
    }

    fn cells(&self) -> Result<Cells, Fault> {
        let bounds = self.bounds()?;
        let count = |low: f64, high: f64| libm::ceil((high - low) / self.cell_size - 1e-9).max(1.0);
        let (columns, rows) = (count(bounds.left, bounds.right), count(bounds.bottom, bounds.top));
        if columns * rows > 1_048_576.0 {
            return Err(("cell-size", format!("expected at most 1048576 cells on the map, found {}", columns * rows)));
        }
        let origin = [bounds.left, bounds.bottom];
        Ok(Cells { origin, side: self.cell_size, columns: columns as u32, rows: rows as u32 })
    }

    /// The explicit starts.
    pub(super) fn starts(&self) -> Result<Vec<[f64; 3]>, Fault> {
        let read = |(at, pose): (usize, &Value)| {
            let expected = || format!("item {}: expected [x, y, heading], found {}", at + 1, found(pose));
            numbers(pose).ok_or_else(|| ("start-list", expected()))
        };
        self.start_list.iter().enumerate().map(read).collect()
    }

    /// The explicit obstacles.
    pub(super) fn forms(&self) -> Result<Vec<Form>, Fault> {
        let read = |(at, item): (usize, &Value)| {
            read_form(item).map_err(|message| ("obstacle-list", format!("item {}: {message}", at + 1)))
        };
        self.obstacle_list.iter().enumerate().map(read).collect()
    }

    /// The library: the standard behaviours of its letters, then the user's own.
    pub(super) fn behaviours(&self) -> Result<Vec<Behaviour>, Fault> {
        let mut library = Vec::new();
        for letter in self.library.chars() {
            let behaviour = standard(letter)
                .ok_or_else(|| ("library", format!("expected letters of \"{LETTERS}\", found {letter:?}")))?;
            library.push(behaviour);
        }
        for (at, item) in self.own_behaviours.iter().enumerate() {
            let behaviour =
                read_behaviour(item).map_err(|message| ("own-behaviours", format!("item {}: {message}", at + 1)))?;
            library.push(behaviour);
        }
        let field = if self.own_behaviours.is_empty() { "library" } else { "own-behaviours" };
        super::parts::check_library(&library).map_err(|error| (field, error.message))?;
        for letter in self.prefix.chars() {
            if !library.iter().any(|behaviour| behaviour.letter == letter) {
                return Err(("prefix", format!("expected letters of the library, found {letter:?}")));
            }
        }
        if self.prefix.chars().count() > usize::from(self.decisions) {
            return Err(("prefix", format!("expected at most {} letters, found more", self.decisions)));
        }
        Ok(library)
    }
}
