//! A study file: what is run, what is measured, and what the report says of it.

use super::cells::{Cell, Presets, parameter_keys, plain, read_cells, with};
use super::fields::{Fields, StudyError, elements, fault};
use super::matches::{PaperMatches, read_matches};
use super::metrics::Metric;
use super::plan::{Figure, PaperSeconds, PaperValue, Test, read_figure, read_paper, read_seconds, read_tests};
use crate::fingerprint::Fingerprint;
use crate::nearest::nearest;
use crate::parameter::shown;
use crate::random::Seed;
use crate::scenario::{Scenario, WorldParams};
use serde_json::{Map, Value, json};

/// A study, read and complete: it needs no presets any more.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// Its name, in small letters, digits and hyphens.
    pub name: String,
    /// The title of report and figure.
    pub title: String,
    /// What the study is about, for people.
    pub about: String,
    /// What is compared, at least one.
    pub cells: Vec<Cell>,
    /// The seed of the first run of every cell.
    pub first_seed: u64,
    /// Runs of every cell: seeds count up from the first.
    pub seeds: u32,
    /// What is measured, at least one.
    pub metrics: Vec<Metric>,
    /// The tests of the report.
    pub tests: Vec<Test>,
    /// The figure of the report.
    pub figure: Option<Figure>,
    /// What the paper says.
    pub paper: Vec<PaperValue>,
    /// How long its searches took, and on what.
    pub seconds: Option<PaperSeconds>,
    /// What it counted in its matches.
    pub matches: Option<PaperMatches>,
    /// The smaller sizes that the file gives.
    sizes: [Option<Smaller>; 2],
}

/// How much of a study is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Seconds.
    Glance,
    /// Minutes.
    Class,
    /// All that the paper did; may take hours.
    Paper,
}

impl Size {
    /// The sizes with their names.
    pub const ALL: [(&'static str, Self); 3] =
        [("glance", Self::Glance), ("class", Self::Class), ("paper", Self::Paper)];
}

/// What a smaller size replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Smaller {
    seeds: Option<u32>,
    values: [Option<u32>; SMALLER.len()],
}

/// The parameters that a smaller size may replace: what decides how long a run takes. The budget is one of integrations,
/// in worlds that plan; half-seconds are the length of a half of a match.
const SMALLER: [&str; 3] = ["steps", "budget", "half-seconds"];

/// The version whose results these are; results of different versions never mix.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

const FIELDS: [&str; 15] = [
    "study", "title", "about", "scenario", "cells", "grid", "seeds", "steps", "metrics", "sizes", "tests", "figure",
    "paper", "seconds", "matches",
];
const MOST_SEEDS: u32 = 10_000;
/// Parameters that came after results were made, each with the value that means what was done before.
const LATER: [(&str, i32); 1] = [("forecast", 0)];

impl Study {
    /// Reads a study.
    ///
    /// - `presets`: the scenarios that it may name, because the library reads no files.
    ///
    /// # Errors
    /// One sentence with the path of the field: no JSON (with line and column), an unknown field or name, a value that does
    /// not fit, two cells of one name.
    ///
    /// ```
    /// use swarm_playground::study::Study;
    /// let text = r#"{"study": "small", "scenario": {"world": "geese", "agents": 10}, "grid": {"geese.children": [2, 8]},
    ///     "seeds": {"first": 1, "count": 3}, "steps": 50, "metrics": ["share"]}"#;
    /// let study = Study::read(text, &[])?;
    /// assert_eq!(study.cells[1].name, "children 8");
    /// assert_eq!(study.run_count(), 6);
    /// let error = Study::read(&text.replace("children", "childern"), &[]).unwrap_err().to_string();
    /// assert_eq!(error, "grid.geese.childern: unknown name \"geese.childern\", did you mean \"geese.children\"?");
    /// # Ok::<(), swarm_playground::study::StudyError>(())
    /// ```
    pub fn read(text: &str, presets: &Presets) -> Result<Self, StudyError> {
        match serde_json::from_str(text) {
            Ok(value) => Self::from_value(&value, presets),
            Err(error) => fault("", format!("expected a study as JSON: {error}")),
        }
    }

    /// Reads a study from JSON that was parsed already.
    ///
    /// # Errors
    /// As [`Study::read`].
    pub fn from_value(value: &Value, presets: &Presets) -> Result<Self, StudyError> {
        let fields = Fields::of(value, "", &FIELDS)?;
        let name = read_name(fields.need("study", "a name")?)?;
        let cells = read_cells(&fields, presets, &name)?;
        let (first_seed, seeds) = read_seeds(&fields)?;
        let metrics = read_metrics(&fields, &cells[0].scenario.world)?;
        let matches = read_matches(&fields, &metrics)?;
        let mut study = Self {
            name,
            title: fields.text("title")?,
            about: fields.text("about")?,
            cells,
            first_seed,
            seeds,
            metrics,
            tests: Vec::new(),
            figure: None,
            paper: Vec::new(),
            seconds: None,
            matches,
            sizes: read_sizes(&fields)?,
        };
        study.tests = read_tests(&fields, &study)?;
        study.figure = read_figure(&fields, &study)?;
        study.paper = read_paper(&fields, &study)?;
        study.seconds = read_seconds(&fields, &study)?;
        for (size, _) in Size::ALL.iter().filter(|size| size.1 != Size::Paper) {
            study.sized_as(size).map_or(Ok(()), |sized| sized.map(|_| ()))?;
        }
        Ok(study)
    }

    /// The study in one of its sizes; `paper` is all of it.
    ///
    /// # Errors
    /// The file does not say how large that size is.
    pub fn sized(&self, size: Size) -> Result<Self, StudyError> {
        let name = Size::ALL[size as usize].0;
        if size == Size::Paper {
            return Ok(self.clone());
        }
        self.sized_as(name).unwrap_or_else(|| {
            fault(format!("sizes.{name}"), "expected seeds and steps of this size, found no such field")
        })
    }

    fn sized_as(&self, name: &str) -> Option<Result<Self, StudyError>> {
        let at = Size::ALL.iter().position(|size| size.0 == name)?;
        let Smaller { seeds, values } = (*self.sizes.get(at)?)?;
        let mut sized = Self { sizes: [None; 2], seeds: seeds.unwrap_or(self.seeds), ..self.clone() };
        for (field, value) in SMALLER.into_iter().zip(values).filter(|(_, value)| value.is_some()) {
            let path = format!("sizes.{name}.{field}");
            for cell in &mut sized.cells {
                match with(&cell.scenario, &[(field.to_owned(), path.clone(), &json!(value))], &path) {
                    Ok(scenario) => cell.scenario = scenario,
                    Err(error) => return Some(Err(error)),
                }
            }
        }
        Some(Ok(sized))
    }

    /// The study with another number of seeds; its results are the beginning, or a continuation, of the same file.
    ///
    /// # Errors
    /// The number is not from 1 to 10,000.
    pub fn with_seeds(&self, seeds: u32) -> Result<Self, StudyError> {
        let (first_seed, seeds) =
            read_seeds(&Fields::of(&json!({"seeds": {"first": self.first_seed, "count": seeds}}), "", &["seeds"])?)?;
        Ok(Self { first_seed, seeds, ..self.clone() })
    }

    /// How many runs the study has.
    #[must_use]
    pub fn run_count(&self) -> u32 {
        self.cells.len() as u32 * self.seeds
    }

    /// How many runs it could have with more seeds.
    pub(super) fn most_runs(&self) -> u32 {
        let seeds = u64::from(MOST_SEEDS).min(Seed::MAX + 1 - self.first_seed);
        self.cells.len() as u32 * seeds as u32
    }

    /// The cell and the seed of a run. Round robin: all cells with the first seed, then all with the second, so that a
    /// study that was stopped is still balanced; every cell has the same seeds.
    ///
    /// - `run`: below [`Study::run_count`].
    #[must_use]
    pub fn job(&self, run: u32) -> (usize, u64) {
        let cells = self.cells.len() as u32;
        ((run % cells) as usize, self.first_seed + u64::from(run / cells))
    }

    /// What the cells differ in: names of labels, then keys of parameters in the order of the schema.
    #[must_use]
    pub fn factors(&self) -> Vec<String> {
        let mut factors: Vec<String> = self.cells.iter().flat_map(|cell| cell.labels.keys().cloned()).collect();
        factors.sort();
        factors.dedup();
        let values: Vec<Value> = self.cells.iter().map(|cell| cell.scenario.to_value()).collect();
        let varies = |key: &String| {
            let field = key.split_once('.').map_or(key.as_str(), |(_, field)| field);
            values.iter().any(|value| value[field] != values[0][field])
        };
        factors.extend(parameter_keys(&self.cells[0].scenario).into_iter().filter(varies));
        factors
    }

    /// The value of a factor in a cell, as results have it; empty for a label that the cell does not have.
    #[must_use]
    pub fn factor(&self, cell: usize, factor: &str) -> String {
        let cell = &self.cells[cell];
        match factor.split_once('.') {
            Some((_, field)) => plain(&cell.scenario.to_value()[field]),
            None => cell.labels.get(factor).cloned().unwrap_or_default(),
        }
    }

    /// A fingerprint of all that decides a row of the results: each cell's name, labels and whole scenario, the first seed,
    /// and the metrics. Words, tests, figure, the paper's values, times and matches, and the number of seeds are left out:
    /// to change them costs no run. So is a parameter that came later (see `LATER`) where it has the value that means what was
    /// done before it came: rows made without it stay rows of this study.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let cells = self.cells.iter().map(|cell| {
            let mut scenario = cell.scenario.to_value();
            for field in ["title", "about", "seed"] {
                scenario[field] = Value::Null;
            }
            if let Some(fields) = scenario.as_object_mut() {
                fields.retain(|name, value| !LATER.iter().any(|(later, before)| name == later && *value == *before));
            }
            json!({"name": cell.name, "labels": cell.labels, "scenario": scenario})
        });
        let metrics: Vec<&str> = self.metrics.iter().map(|metric| metric.name()).collect();
        let decisive = json!({"study": self.name, "first": self.first_seed, "metrics": metrics,
            "cells": cells.collect::<Vec<_>>()});
        // The fields of a JSON object are sorted by name, so equal values give equal texts.
        let text = decisive.to_string();
        let mut hash = Fingerprint::default();
        text.bytes().for_each(|byte| hash.u32(u32::from(byte)));
        hash.finish()
    }

    /// The study as JSON that needs no presets, grid or sizes: what goes beside its results.
    #[must_use]
    pub fn to_value(&self) -> Value {
        let cells = self
            .cells
            .iter()
            .map(|cell| json!({"name": cell.name, "labels": cell.labels, "scenario": cell.scenario.to_value()}));
        let mut value = json!({
            "study": self.name, "title": self.title, "about": self.about, "cells": cells.collect::<Vec<_>>(),
            "seeds": {"first": self.first_seed, "count": self.seeds},
            "metrics": self.metrics.iter().map(|metric| metric.name()).collect::<Vec<_>>(),
        });
        if !self.tests.is_empty() {
            value["tests"] = self.tests.iter().map(|test| test.to_value(self)).collect();
        }
        if let Some(figure) = &self.figure {
            value["figure"] = figure.to_value();
        }
        if !self.paper.is_empty() {
            let mut cells: Map<String, Value> = Map::new();
            for PaperValue { cell, metric, value } in &self.paper {
                let metrics = cells.entry(self.cells[*cell].name.clone()).or_insert_with(|| json!({}));
                metrics[metric.name()] = json!(value);
            }
            value["paper"] = Value::Object(cells);
        }
        if let Some(PaperSeconds { machine, cells }) = &self.seconds {
            let cells = cells.iter().map(|(cell, seconds)| (self.cells[*cell].name.clone(), json!(seconds)));
            value["seconds"] = json!({"machine": machine, "cells": cells.collect::<Map<_, _>>()});
        }
        if let Some(matches) = &self.matches {
            value["matches"] = matches.to_value();
        }
        value
    }

    /// The place of a cell.
    pub(super) fn cell(&self, value: &Value, path: &str) -> Result<usize, StudyError> {
        let found = value.as_str().and_then(|name| self.cells.iter().position(|cell| cell.name == name));
        let Some(found) = found else {
            let names = || self.cells.iter().map(|cell| cell.name.as_str());
            let near = value.as_str().and_then(|name| nearest(name, names()));
            let near = near.or_else(|| names().next()).unwrap_or_default();
            return fault(path, format!("expected a cell's name such as \"{near}\", found {}", shown(value)));
        };
        Ok(found)
    }
}

fn read_name(value: &Value) -> Result<String, StudyError> {
    let fits = |name: &&str| {
        let fits = |letter: u8| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == b'-';
        (1..=60).contains(&name.len()) && name.bytes().all(fits)
    };
    if let Some(name) = value.as_str().filter(fits) {
        return Ok(name.to_owned());
    }
    fault("study", format!("expected 1 to 60 small letters, digits and hyphens, found {}", shown(value)))
}

fn read_seeds(fields: &Fields) -> Result<(u64, u32), StudyError> {
    let value = fields.need("seeds", "an object such as {\"first\": 1, \"count\": 64}")?;
    let seeds = Fields::of(value, "seeds", &["first", "count"])?;
    let count = seeds.whole("count", 1..=u64::from(MOST_SEEDS))?;
    let Some(count) = count else { return fault("seeds.count", "expected a whole number, found no such field") };
    let first = seeds.whole("first", 0..=Seed::MAX + 1 - count)?.unwrap_or(1);
    Ok((first, count as u32))
}

/// Reads `metrics`, all of them of the study's world.
fn read_metrics(fields: &Fields, world: &WorldParams) -> Result<Vec<Metric>, StudyError> {
    let known = Metric::of_world(world);
    let some: Vec<String> = known.iter().take(2).map(|(name, _)| format!("\"{name}\"")).collect();
    let value = fields.need("metrics", &format!("a list of metrics such as [{}]", some.join(", ")))?;
    let mut metrics = Vec::new();
    for (path, value) in elements(value, "metrics", known.len())? {
        let other = Metric::all().into_iter().find(|(name, metric)| value == name && metric.world() != world.name());
        if let Some((name, other)) = other {
            let names: Vec<String> = known.iter().map(|(name, _)| format!("\"{name}\"")).collect();
            let message = format!(
                "expected a metric of the world \"{}\", one of {}, found \"{name}\" of the world \"{}\"",
                world.name(),
                names.join(", "),
                other.world()
            );
            return fault(path, message);
        }
        let metric = *super::fields::one_of(value, &path, &known)?;
        if metrics.contains(&metric) {
            return fault(path, format!("expected each metric once, found \"{}\" twice", metric.name()));
        }
        metrics.push(metric);
    }
    Ok(metrics)
}

fn read_sizes(fields: &Fields) -> Result<[Option<Smaller>; 2], StudyError> {
    let mut sizes = [None; 2];
    let Some(value) = fields.get("sizes") else { return Ok(sizes) };
    let given = Fields::of(value, "sizes", &["glance", "class"])?;
    for (place, (name, _)) in sizes.iter_mut().zip(Size::ALL) {
        let Some(value) = given.get(name) else { continue };
        let known: Vec<&str> = ["seeds"].into_iter().chain(SMALLER).collect();
        let size = Fields::of(value, &given.at(name), &known)?;
        let seeds = size.whole("seeds", 1..=u64::from(MOST_SEEDS))?.map(|seeds| seeds as u32);
        let mut values = [None; SMALLER.len()];
        for (value, field) in values.iter_mut().zip(SMALLER) {
            *value = size.whole(field, 1..=u64::from(u32::MAX))?.map(|value| value as u32);
        }
        *place = Some(Smaller { seeds, values });
    }
    Ok(sizes)
}

impl Cell {
    /// The scenario of one run.
    #[must_use]
    pub fn scenario_of(&self, seed: u64) -> Scenario {
        let mut scenario = self.scenario.clone();
        scenario.seed = Seed::new(seed).unwrap_or(scenario.seed);
        scenario
    }
}
