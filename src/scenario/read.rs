//! Reading, checking and writing scenarios.

use super::{Event, Scenario, WorldParams};
use crate::geese;
use crate::nearest::nearest;
use crate::parameter::{Apply, Parameter, shown};
use crate::random::Seed;
#[cfg(feature = "sequencing")]
use crate::sequencing;
#[cfg(feature = "soccer")]
use crate::soccer;
use serde_json::{Map, Value, json};
use std::fmt;

/// Why a text is no scenario: one sentence with the field's path, or line and column where it is no JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScenarioError {
    /// The path of the field, such as `events[2].value`; empty where the text is no JSON.
    pub path: String,
    /// What was found and what is allowed.
    pub message: String,
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            write!(out, "{}", self.message)
        } else {
            write!(out, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for ScenarioError {}

fn fault<T>(path: impl Into<String>, message: impl Into<String>) -> Result<T, ScenarioError> {
    Err(ScenarioError { path: path.into(), message: message.into() })
}

/// Fields of every world's scenario.
const COMMON: [&str; 5] = ["world", "title", "about", "seed", "events"];
/// Bytes of a title or an about text.
const LONGEST_TEXT: usize = 2000;
const MOST_EVENTS: usize = 10_000;

/// Every parameter of every world as JSON, in the order in which the page shows them; the seed is first.
///
/// Each has `key`, `type`, `default`, bounds, `unit`, `apply`, `group`, `label`, `help` and `source`.
#[must_use]
pub fn schema() -> Value {
    let mut entries = vec![json!({
        "key": "seed", "type": "seed", "default": 1, "min": 0, "max": Seed::MAX, "hard_max": Seed::MAX, "step": 1,
        "unit": "", "scale": "linear", "apply": "restart", "group": "Run", "label": "Seed",
        "help": "Every random draw follows from it: the same seed gives the same run on every machine.",
        "source": "our choice",
    })];
    for world in WORLDS.iter().filter_map(|name| default_of(name)) {
        let (prefix, defaults) = (format!("{}.", world.name()), fields_of(&world));
        entries.extend(parameters(&world).map(|parameter| {
            let default = defaults.get(parameter.name).unwrap_or(&Value::Null);
            parameter.schema(&prefix, default)
        }));
    }
    Value::Array(entries)
}

/// The names of the worlds.
const WORLDS: &[&str] = &[
    "geese",
    #[cfg(feature = "sequencing")]
    "sequencing",
    #[cfg(feature = "soccer")]
    "soccer",
];

/// The world of this name with its defaults.
fn default_of(name: &str) -> Option<WorldParams> {
    match name {
        "geese" => Some(WorldParams::Geese(geese::Params::default())),
        #[cfg(feature = "sequencing")]
        "sequencing" => Some(WorldParams::Sequencing(sequencing::Params::default())),
        #[cfg(feature = "soccer")]
        "soccer" => Some(WorldParams::Soccer(Box::default())),
        _ => None,
    }
}

fn parameters(world: &WorldParams) -> impl Iterator<Item = &'static Parameter> + use<> {
    let lists = match world {
        WorldParams::Geese(_) => geese::parameters(),
        #[cfg(feature = "sequencing")]
        WorldParams::Sequencing(_) => sequencing::parameters(),
        #[cfg(feature = "soccer")]
        WorldParams::Soccer(_) => soccer::parameters(),
    };
    lists.iter().copied().flatten()
}

/// The parameters as JSON fields.
fn fields_of(world: &WorldParams) -> Map<String, Value> {
    match world {
        WorldParams::Geese(params) => params.fields(),
        #[cfg(feature = "sequencing")]
        WorldParams::Sequencing(params) => written(params),
        #[cfg(feature = "soccer")]
        WorldParams::Soccer(params) => written(params),
    }
}

/// The fields of parameters that are written as they stand.
#[cfg(any(feature = "sequencing", feature = "soccer"))]
fn written(params: &impl serde::Serialize) -> Map<String, Value> {
    match serde_json::to_value(params) {
        Ok(Value::Object(fields)) => fields,
        _ => Map::new(),
    }
}

/// Sets one parameter to a value that has passed its check.
fn set(world: &mut WorldParams, name: &str, value: &Value) -> bool {
    match world {
        WorldParams::Geese(params) => params.set(name, value),
        #[cfg(feature = "sequencing")]
        WorldParams::Sequencing(params) => params.set(name, value),
        #[cfg(feature = "soccer")]
        WorldParams::Soccer(params) => params.set(name, value),
    }
}

/// The checks that concern several parameters.
fn check(world: &WorldParams) -> Result<(), ScenarioError> {
    let checked = match world {
        WorldParams::Geese(params) => params.check().map(|_| ()),
        #[cfg(feature = "sequencing")]
        WorldParams::Sequencing(params) => params.check(),
        #[cfg(feature = "soccer")]
        WorldParams::Soccer(params) => params.check(),
    };
    checked.map_err(|(field, message)| ScenarioError { path: field.to_owned(), message })
}

impl Scenario {
    /// Reads a scenario.
    ///
    /// # Errors
    /// One clear sentence: no JSON (with line and column), an unknown field or world, a value out of its bounds or
    /// of the wrong type, parameters that do not fit together, an event out of order or of a parameter that needs a
    /// restart.
    ///
    /// ```
    /// use swarm_playground::scenario::Scenario;
    /// assert!(Scenario::read(r#"{"world": "geese", "seed": 42}"#).is_ok());
    /// let error = Scenario::read(r#"{"world": "geese", "agents": 0}"#).unwrap_err();
    /// assert_eq!(error.to_string(), "agents: expected a whole number from 1 to 10000 robots, found 0");
    /// ```
    pub fn read(text: &str) -> Result<Self, ScenarioError> {
        match serde_json::from_str(text) {
            Ok(value) => Self::from_value(&value),
            Err(error) => fault("", format!("expected a scenario as JSON: {error}")),
        }
    }

    /// Reads a scenario from JSON that was parsed already.
    ///
    /// # Errors
    /// As [`Scenario::read`].
    pub fn from_value(value: &Value) -> Result<Self, ScenarioError> {
        let Value::Object(given) = value else {
            return fault("", format!("expected a scenario, an object with a field \"world\", found {}", shown(value)));
        };
        let expected = || {
            let names: Vec<String> = WORLDS.iter().map(|name| format!("\"{name}\"")).collect();
            format!("expected one of {}", names.join(", "))
        };
        let named = given.get("world");
        let mut world = match (named.and_then(Value::as_str).and_then(default_of), named) {
            (Some(world), _) => world,
            (None, Some(other)) => return fault("world", format!("{}, found {}", expected(), shown(other))),
            (None, None) => return fault("world", format!("{}, found no such field", expected())),
        };
        for (name, value) in given {
            if COMMON.contains(&name.as_str()) {
                continue;
            }
            let Some(parameter) = parameters(&world).find(|parameter| parameter.name == name) else {
                let known = parameters(&world).map(|parameter| parameter.name).chain(COMMON);
                return match nearest(name, known) {
                    Some(near) => fault(name, format!("unknown field, did you mean \"{near}\"?")),
                    None => fault(name, "unknown field; `swarm-playground schema` lists all"),
                };
            };
            let value = parameter
                .kind
                .check(value, parameter.unit)
                .map_err(|message| ScenarioError { path: name.clone(), message })?;
            let known = set(&mut world, name, &value);
            debug_assert!(known, "{name} is in the schema, but no field takes its values");
        }
        check(&world)?;
        let scenario = Self {
            title: read_text(given, "title")?,
            about: read_text(given, "about")?,
            seed: read_seed(given.get("seed"))?,
            events: read_events(given.get("events"), &world)?,
            world,
        };
        scenario.check_events()?;
        Ok(scenario)
    }

    /// The scenario as JSON with every field, so that reading it gives the same scenario.
    #[must_use]
    pub fn to_value(&self) -> Value {
        let mut fields = Map::new();
        fields.insert("world".to_owned(), Value::from(self.world.name()));
        fields.insert("title".to_owned(), Value::from(self.title.as_str()));
        fields.insert("about".to_owned(), Value::from(self.about.as_str()));
        fields.insert("seed".to_owned(), Value::from(self.seed.value()));
        fields.extend(fields_of(&self.world));
        let events = self.events.iter();
        let events = events.map(|event| json!({"tick": event.tick, "key": event.key, "value": event.value}));
        fields.insert("events".to_owned(), Value::Array(events.collect()));
        Value::Object(fields)
    }

    /// The same scenario with a parameter set to `value` from the start.
    ///
    /// # Errors
    /// As [`Scenario::read`]; the path is `key`.
    pub fn with(&self, key: &str, value: &Value) -> Result<Self, ScenarioError> {
        let mut changed = self.to_value();
        let prefix = format!("{}.", self.world.name());
        if let Value::Object(fields) = &mut changed {
            fields.insert(key.strip_prefix(&prefix).unwrap_or(key).to_owned(), value.clone());
        }
        Self::from_value(&changed)
    }

    /// Checks that the parameters fit together after every event.
    fn check_events(&self) -> Result<(), ScenarioError> {
        let mut world = self.world.clone();
        for (index, event) in self.events.iter().enumerate() {
            world = apply(&world, event).map_err(|error| at_event(index, error))?;
        }
        Ok(())
    }
}

fn at_event(index: usize, error: ScenarioError) -> ScenarioError {
    ScenarioError { path: format!("events[{index}].value"), message: error.message }
}

/// The world's parameters after `event`.
///
/// # Errors
/// The key is unknown or needs a restart, the value is out of its bounds, or the parameters no longer fit together.
pub(super) fn apply(world: &WorldParams, event: &Event) -> Result<WorldParams, ScenarioError> {
    #[cfg(feature = "soccer")]
    if let Some(read) = intervention(world, event) {
        return read.map(|_| world.clone()).map_err(|message| ScenarioError { path: event.key.clone(), message });
    }
    let parameter = live_parameter(world, &event.key)?;
    let value = parameter
        .kind
        .check(&event.value, parameter.unit)
        .map_err(|message| ScenarioError { path: event.key.clone(), message })?;
    let mut changed = world.clone();
    set(&mut changed, parameter.name, &value);
    // The grammar needs a restart, so it need not be compiled again: every seek applies all events before its tick.
    let checked = match &changed {
        WorldParams::Geese(params) => params.check_fit(),
        #[cfg(feature = "sequencing")]
        WorldParams::Sequencing(params) => params.check(),
        #[cfg(feature = "soccer")]
        WorldParams::Soccer(params) => params.check(),
    };
    match checked {
        Ok(()) => Ok(changed),
        Err((field, message)) => fault(field, message),
    }
}

/// What an event does to a match from outside; `None` when it changes a parameter.
#[cfg(feature = "soccer")]
pub(super) fn intervention(world: &WorldParams, event: &Event) -> Option<Result<soccer::Intervention, String>> {
    let WorldParams::Soccer(params) = world else { return None };
    soccer::Intervention::read(event.key.strip_prefix("soccer.")?, &event.value, params)
}

/// Checks that an event can have this key.
fn check_key(world: &WorldParams, key: &str) -> Result<(), ScenarioError> {
    #[cfg(feature = "soccer")]
    if matches!(world, WorldParams::Soccer(_)) {
        let name = key.strip_prefix("soccer.").unwrap_or_default();
        if soccer::Intervention::NAMES.contains(&name) {
            return Ok(());
        }
        if parameters(world).all(|parameter| parameter.name != name) {
            let keys = soccer::Intervention::NAMES.map(|name| format!("soccer.{name}"));
            return match nearest(key, keys.iter().map(String::as_str)) {
                Some(near) => fault(key, format!("unknown event, did you mean \"{near}\"?")),
                None => fault(key, format!("unknown event, expected one of {}", keys.join(", "))),
            };
        }
    }
    live_parameter(world, key).map(|_| ())
}

fn live_parameter(world: &WorldParams, key: &str) -> Result<&'static Parameter, ScenarioError> {
    let name = key.strip_prefix(world.name()).and_then(|rest| rest.strip_prefix('.'));
    let live = || parameters(world).filter(|parameter| parameter.apply == Apply::Live);
    match name.and_then(|name| parameters(world).find(|parameter| parameter.name == name)) {
        Some(parameter) if parameter.apply == Apply::Live => Ok(parameter),
        Some(_) => fault(key, "expected a parameter that can change during a run, found one that needs a restart"),
        None => {
            let names: Vec<String> = live().map(|parameter| format!("{}.{}", world.name(), parameter.name)).collect();
            match nearest(key, names.iter().map(String::as_str)) {
                Some(near) => fault(key, format!("unknown parameter, did you mean \"{near}\"?")),
                None => match names.first() {
                    Some(first) => fault(key, format!("unknown parameter, expected one such as \"{first}\"")),
                    None => fault(key, "unknown parameter; nothing of this world can change during a run"),
                },
            }
        }
    }
}

fn read_text(given: &Map<String, Value>, name: &str) -> Result<String, ScenarioError> {
    match given.get(name) {
        None => Ok(String::new()),
        Some(Value::String(text)) if text.len() <= LONGEST_TEXT => Ok(text.clone()),
        Some(Value::String(_)) => fault(name, format!("expected at most {LONGEST_TEXT} bytes of text, found more")),
        Some(other) => fault(name, format!("expected text, found {}", shown(other))),
    }
}

fn read_seed(value: Option<&Value>) -> Result<Seed, ScenarioError> {
    let Some(value) = value else { return Ok(Seed::new(1).unwrap_or_else(|| unreachable!("1 is a seed"))) };
    match value.as_u64().and_then(Seed::new) {
        Some(seed) => Ok(seed),
        None => fault("seed", format!("expected a whole number from 0 to {}, found {}", Seed::MAX, shown(value))),
    }
}

fn read_events(value: Option<&Value>, world: &WorldParams) -> Result<Vec<Event>, ScenarioError> {
    let events = match value {
        None => return Ok(Vec::new()),
        Some(Value::Array(events)) if events.len() <= MOST_EVENTS => events,
        Some(Value::Array(_)) => return fault("events", format!("expected at most {MOST_EVENTS} events, found more")),
        Some(other) => return fault("events", format!("expected a list of events, found {}", shown(other))),
    };
    let mut read: Vec<Event> = Vec::new();
    for (index, event) in events.iter().enumerate() {
        let path = |field: &str| format!("events[{index}]{field}");
        let Value::Object(fields) = event else {
            return fault(path(""), format!("expected an object with tick, key and value, found {}", shown(event)));
        };
        if let Some(name) = fields.keys().find(|name| !["tick", "key", "value"].contains(&name.as_str())) {
            return fault(path(&format!(".{name}")), "unknown field, expected tick, key and value");
        }
        let after = read.last().map_or(0, |event| event.tick);
        let tick = fields.get("tick").unwrap_or(&Value::Null);
        let Some(tick) = tick.as_u64().and_then(|tick| u32::try_from(tick).ok()).filter(|&tick| tick >= after) else {
            let expected = format!("expected a whole number of at least {after}, found {}", shown(tick));
            return fault(path(".tick"), expected);
        };
        let Some(Value::String(key)) = fields.get("key") else {
            return fault(path(".key"), "expected a parameter's key such as \"geese.mutation-probability\"");
        };
        check_key(world, key).map_err(|error| ScenarioError { path: path(".key"), message: error.message })?;
        let Some(value) = fields.get("value") else {
            return fault(path(".value"), "expected a value, found no such field");
        };
        read.push(Event { tick, key: key.clone(), value: value.clone() });
    }
    Ok(read)
}
