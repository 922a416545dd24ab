//! The cells of a study: every scenario that is run, with the names by which results tell them apart.

use super::fields::{Fields, StudyError, elements, entries, fault, name, one_of};
use super::metrics::Metric;
use crate::parameter::{number, shown};
use crate::scenario::{Scenario, schema};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Named scenario texts that a study may start from.
pub type Presets<'a> = [(&'a str, &'a str)];

/// One of the settings that a study compares.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Its name, which no other cell of the study has.
    pub name: String,
    /// Words that group cells in figures, such as an algorithm's name, by what they are about.
    pub labels: BTreeMap<String, String>,
    /// What is run; its seed is that of the job.
    pub scenario: Scenario,
}

/// What a cell says before the grid multiplies it.
struct Template<'a> {
    name: String,
    labels: BTreeMap<String, String>,
    scenario: Scenario,
    path: String,
    /// Parameters by field name, with the path they were given at.
    set: Vec<(String, String, &'a Value)>,
}

/// One combination of the grid: how cells are called after it, and what it sets.
type Combination<'a> = (Vec<String>, Vec<(String, String, &'a Value)>);

const MOST_CELLS: usize = 1000;
/// Letters of a value in a cell's name: a whole grammar may vary.
const LONGEST_WORD: usize = 40;
/// Columns of a results file besides labels, parameters and metrics.
pub(super) const COLUMNS: [&str; 7] = ["run", "cell", "seed", "version", "spec", "fingerprint", "reason"];

/// Reads `scenario`, `steps`, `cells` and `grid`. Cells come in the order of the file, each with every combination of the
/// grid, whose parameters stand in the order of their names; the last one varies fastest.
pub(super) fn read_cells(fields: &Fields, presets: &Presets, study: &str) -> Result<Vec<Cell>, StudyError> {
    let base = fields.get("scenario").map(|value| read_base(value, &fields.at("scenario"), presets)).transpose()?;
    let steps = fields.get("steps");
    let with_steps = |scenario: Scenario, path: String| match steps {
        Some(steps) => with(&scenario, &[("steps".to_owned(), fields.at("steps"), steps)], &path),
        None => Ok(scenario),
    };
    let mut templates = Vec::new();
    for (path, value) in fields.each("cells", MOST_CELLS)? {
        let cell = Fields::of(value, &path, &["name", "preset", "scenario", "set", "labels"])?;
        let own = match (cell.get("preset"), cell.get("scenario")) {
            (Some(_), Some(_)) => {
                return fault(cell.at("scenario"), "expected either a preset or a scenario, found both");
            }
            (Some(value), None) => Some(preset(value, &cell.at("preset"), presets)?),
            (None, Some(value)) => Some(read_base(value, &cell.at("scenario"), presets)?),
            (None, None) => None,
        };
        let Some(scenario) = own.or_else(|| base.clone()) else {
            return fault(fields.at("scenario"), "expected a preset or a scenario, found no such field");
        };
        let scenario = with_steps(scenario, path.clone())?;
        templates.push(Template {
            name: name(cell.need("name", "a name")?, &cell.at("name"))?,
            labels: read_labels(cell.get("labels"), &cell.at("labels"))?,
            set: read_set(cell.get("set"), &cell.at("set"), &scenario)?,
            scenario,
            path,
        });
    }
    if let Some(other) =
        templates.iter().find(|other| other.scenario.world.name() != templates[0].scenario.world.name())
    {
        let [first, found] = [&templates[0], other].map(|template| template.scenario.world.name());
        return fault(&other.path, format!("expected the world \"{first}\" of the first cell, found \"{found}\""));
    }
    if templates.is_empty() {
        let Some(scenario) = base else {
            return fault(fields.at("scenario"), "expected a preset or a scenario, found no such field");
        };
        let (name, labels, path, set) = (String::new(), BTreeMap::new(), fields.at("grid"), Vec::new());
        templates.push(Template { name, labels, scenario: with_steps(scenario, fields.at("steps"))?, path, set });
    }
    multiply(&templates, fields.get("grid"), &fields.at("grid"), study)
}

fn multiply(templates: &[Template], grid: Option<&Value>, path: &str, study: &str) -> Result<Vec<Cell>, StudyError> {
    let combinations = combinations(grid, path, &templates[0].scenario)?;
    if templates.len() * combinations.len() > MOST_CELLS {
        let found = templates.len() * combinations.len();
        return fault(path, format!("expected at most {MOST_CELLS} cells, found {found}"));
    }
    let mut cells: Vec<Cell> = Vec::new();
    for template in templates {
        for (words, set) in &combinations {
            let first = Some(template.name.clone()).filter(|name| !name.is_empty());
            let parts: Vec<String> = first.into_iter().chain(words.iter().cloned()).collect();
            let name = if parts.is_empty() { study.to_owned() } else { parts.join(", ") };
            if cells.iter().any(|cell| cell.name == name) {
                return fault(&template.path, format!("expected a name of its own, found \"{name}\" twice"));
            }
            let all: Vec<_> = template.set.iter().chain(set).cloned().collect();
            let scenario = with(&template.scenario, &all, &template.path)?;
            cells.push(Cell { name, labels: template.labels.clone(), scenario });
        }
    }
    Ok(cells)
}

fn combinations<'a>(
    grid: Option<&'a Value>,
    path: &str,
    scenario: &Scenario,
) -> Result<Vec<Combination<'a>>, StudyError> {
    let mut combinations: Vec<Combination> = vec![Default::default()];
    for (key, values) in grid.map_or_else(|| Ok(Vec::new()), |grid| entries(grid, path))? {
        let field = field_of(key, &format!("{path}.{key}"), scenario)?;
        let values = elements(values, &format!("{path}.{key}"), MOST_CELLS)?;
        if combinations.len() * values.len() > MOST_CELLS {
            return fault(path, format!("expected at most {MOST_CELLS} cells, found more"));
        }
        let longer = combinations.iter().flat_map(|(words, set)| {
            values.iter().map(|(path, value)| {
                let word = format!("{field} {}", plain(value).chars().take(LONGEST_WORD).collect::<String>());
                let words = words.iter().cloned().chain([word]).collect();
                let set = set.iter().cloned().chain([(field.clone(), path.clone(), *value)]).collect();
                (words, set)
            })
        });
        combinations = longer.collect();
    }
    Ok(combinations)
}

/// A whole scenario, or `{"preset": NAME}` with a `set` of changes if wanted.
fn read_base(value: &Value, path: &str, presets: &Presets) -> Result<Scenario, StudyError> {
    if value.get("preset").is_none() {
        return Scenario::from_value(value).map_err(|error| {
            let path = if error.path.is_empty() { path.to_owned() } else { format!("{path}.{}", error.path) };
            StudyError { path, message: error.message }
        });
    }
    let fields = Fields::of(value, path, &["preset", "set"])?;
    let scenario = preset(fields.need("preset", "a preset's name")?, &fields.at("preset"), presets)?;
    let set = read_set(fields.get("set"), &fields.at("set"), &scenario)?;
    with(&scenario, &set, path)
}

fn preset(value: &Value, path: &str, presets: &Presets) -> Result<Scenario, StudyError> {
    let text = one_of(value, path, presets)?;
    Scenario::read(text).or_else(|error| fault(path, format!("the preset is no scenario: {error}")))
}

fn read_labels(value: Option<&Value>, path: &str) -> Result<BTreeMap<String, String>, StudyError> {
    let mut labels = BTreeMap::new();
    for (key, value) in value.map_or_else(|| Ok(Vec::new()), |value| entries(value, path))? {
        let path = format!("{path}.{key}");
        name(&Value::from(key), &path)?;
        let is_taken =
            COLUMNS.contains(&key) || key.contains('.') || Metric::all().iter().any(|metric| metric.0 == key);
        if is_taken {
            return fault(path, "expected a label that is no column of the results and has no point in it");
        }
        labels.insert(key.to_owned(), name(value, &path)?);
    }
    Ok(labels)
}

fn read_set<'a>(
    value: Option<&'a Value>,
    path: &str,
    scenario: &Scenario,
) -> Result<Vec<(String, String, &'a Value)>, StudyError> {
    let entries = value.map_or_else(|| Ok(Vec::new()), |value| entries(value, path))?;
    let set = entries.into_iter().map(|(key, value)| {
        let path = format!("{path}.{key}");
        Ok((field_of(key, &path, scenario)?, path, value))
    });
    set.collect()
}

/// The field's name of a parameter's key such as `geese.agents`.
fn field_of(key: &str, path: &str, scenario: &Scenario) -> Result<String, StudyError> {
    let keys = parameter_keys(scenario);
    let choices: Vec<(&str, ())> = keys.iter().map(|key| (key.as_str(), ())).collect();
    one_of(&Value::from(key), path, &choices)?;
    Ok(key.split_once('.').map_or(key, |(_, field)| field).to_owned())
}

/// The keys of the parameters of a scenario's world, in the order of the schema.
pub(super) fn parameter_keys(scenario: &Scenario) -> Vec<String> {
    let schema = schema();
    let prefix = format!("{}.", scenario.world.name());
    let keys = schema.as_array().into_iter().flatten().filter_map(|entry| entry["key"].as_str());
    keys.filter(|key| key.starts_with(&prefix)).map(str::to_owned).collect()
}

/// The scenario with all of `set` at once, so that it need not fit together on the way.
pub(super) fn with(scenario: &Scenario, set: &[(String, String, &Value)], path: &str) -> Result<Scenario, StudyError> {
    if set.is_empty() {
        return Ok(scenario.clone());
    }
    let mut fields = match scenario.to_value() {
        Value::Object(fields) => fields,
        _ => Map::new(),
    };
    for (field, _, value) in set {
        fields.insert(field.clone(), (*value).clone());
    }
    Scenario::from_value(&Value::Object(fields)).or_else(|error| {
        match set.iter().rev().find(|(field, _, _)| *field == error.path) {
            Some((_, path, _)) => fault(path, error.message),
            None => fault(path, error.to_string()),
        }
    })
}

/// A parameter's value as words of one line.
pub(super) fn plain(value: &Value) -> String {
    let words = match value {
        Value::String(text) => text.clone(),
        // So that 0 and 0.0 are called alike.
        Value::Number(real) => real.as_f64().map(number).unwrap_or_default(),
        _ => shown(value),
    };
    let words = words.split(|letter: char| letter.is_whitespace() || letter.is_control());
    words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}
