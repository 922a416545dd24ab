//! Everything that decides a run of a tree, read from JSON with the path of each fault.

use crate::bt::Status;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt;

/// The longest timeline, in ticks.
pub const MOST_TICKS: u32 = 100_000;
/// The most script events of a setup.
pub const MOST_EVENTS: usize = 10_000;
/// The longest simulated time before a tick: an hour.
const MOST_MS: u64 = 3_600_000;
/// The most ticks a leaf may stay RUNNING; `then: RUNNING` is for ever.
const MOST_RUNNING: u64 = 1_000_000;

/// A tree, its script and how far it is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// The document.
    pub xml: String,
    /// What happens from outside, by tick; of one tick in the order given.
    pub script: Vec<Event>,
    /// Which call a tick is.
    pub mode: Mode,
    /// Simulated time that passes before each tick, milliseconds.
    pub ms: u64,
    /// Ticks to run at once.
    pub length: u32,
    /// The tick to show.
    pub at: u32,
}

/// The call that makes a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// `tickOnce`: again while the root is RUNNING and a wake-up is pending.
    #[default]
    Once,
    /// `tickExactlyOnce`: one pass.
    ExactlyOnce,
}

/// Something that happens after so many ticks.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Ticks made before it; 0 is the start.
    pub tick: u32,
    /// What happens.
    pub kind: EventKind,
}

/// What happens from outside.
#[derive(Clone, Debug, PartialEq)]
pub enum EventKind {
    /// All leaves of this instance name answer so from now on.
    Answer(String, Answer),
    /// An entry of the main tree's board, or with `@` of the global one, is written.
    Set(String, String),
    /// The whole tree is halted.
    Halt,
}

/// What a leaf does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Ticks it returns RUNNING after each start.
    pub running: u32,
    /// What it returns then; RUNNING is for ever.
    pub then: Status,
    /// What it writes to its output ports when it completes.
    pub writes: BTreeMap<String, String>,
}

impl Default for Answer {
    fn default() -> Self {
        Self { running: 0, then: Status::Success, writes: BTreeMap::new() }
    }
}

/// Why a value is no setup: the field's path, what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetupError(String);

impl fmt::Display for SetupError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl std::error::Error for SetupError {}

impl Setup {
    /// Reads a setup; fields that are absent get their defaults (`once`, 100 ms, no script, length 0).
    ///
    /// # Errors
    /// The path of the first field that does not fit, what it holds and what is allowed.
    pub fn from_value(value: &Value) -> Result<Self, SetupError> {
        let fields = Fields::of(value, "", &["xml", "script", "mode", "ms", "length", "at"])?;
        let xml = fields.text("xml")?.ok_or_else(|| missing("xml", "a text"))?.to_owned();
        let mode = match fields.text("mode")? {
            None | Some("once") => Mode::Once,
            Some("exactly_once") => Mode::ExactlyOnce,
            Some(other) => return Err(unfit("mode", "\"once\" or \"exactly_once\"", &Value::from(other))),
        };
        let length = fields.number("length", u64::from(MOST_TICKS))?.unwrap_or(0) as u32;
        let at = fields.number("at", u64::from(length))?.map_or(length, |at| at as u32);
        let mut script = match fields.get("script") {
            None => Vec::new(),
            Some(Value::Array(events)) if events.len() <= MOST_EVENTS => events
                .iter()
                .enumerate()
                .map(|(index, event)| Event::from_value(event, index))
                .collect::<Result<_, _>>()?,
            Some(other) => return Err(unfit("script", &format!("a list of at most {MOST_EVENTS} events"), other)),
        };
        script.sort_by_key(|event: &Event| event.tick);
        Ok(Self { xml, script, mode, ms: fields.number("ms", MOST_MS)?.unwrap_or(100), length, at })
    }
}

impl Event {
    fn from_value(value: &Value, index: usize) -> Result<Self, SetupError> {
        let path = format!("script[{index}]");
        let all = ["tick", "leaf", "running", "then", "writes", "set", "value", "halt"];
        let fields = Fields::of(value, &path, &all)?;
        let tick = fields.number("tick", u64::from(MOST_TICKS))?;
        let tick = tick.ok_or_else(|| missing(&fields.path("tick"), "a whole number"))? as u32;
        let kind = match (fields.text("leaf")?, fields.text("set")?, fields.get("halt")) {
            (Some(leaf), None, None) => EventKind::Answer(leaf.to_owned(), fields.answer()?),
            (None, Some(name), None) => {
                let value = fields.text("value")?.ok_or_else(|| missing(&fields.path("value"), "a text"))?;
                EventKind::Set(name.to_owned(), value.to_owned())
            }
            (None, None, Some(Value::Bool(true))) => EventKind::Halt,
            _ => return Err(unfit(&path, "exactly one of \"leaf\", \"set\" and \"halt\": true", value)),
        };
        Ok(Self { tick, kind })
    }
}

/// The fields of an object, with its path.
struct Fields<'a> {
    fields: &'a serde_json::Map<String, Value>,
    path: &'a str,
}

impl<'a> Fields<'a> {
    fn of(value: &'a Value, path: &'a str, known: &[&str]) -> Result<Self, SetupError> {
        let Value::Object(fields) = value else {
            return Err(unfit(if path.is_empty() { "setup" } else { path }, "an object", value));
        };
        let found = Self { fields, path };
        match fields.keys().find(|name| !known.contains(&name.as_str())) {
            Some(unknown) => {
                let known: Vec<String> = known.iter().map(|name| format!("\"{name}\"")).collect();
                Err(SetupError(format!("{}: expected one of {}", found.path(unknown), known.join(", "))))
            }
            None => Ok(found),
        }
    }

    fn path(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }

    fn get(&self, name: &str) -> Option<&'a Value> {
        self.fields.get(name)
    }

    fn text(&self, name: &str) -> Result<Option<&'a str>, SetupError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        value.as_str().map(Some).ok_or_else(|| unfit(&self.path(name), "a text", value))
    }

    fn number(&self, name: &str, most: u64) -> Result<Option<u64>, SetupError> {
        let Some(value) = self.get(name) else { return Ok(None) };
        let number = value.as_u64().filter(|number| *number <= most);
        number.map(Some).ok_or_else(|| unfit(&self.path(name), &format!("a whole number from 0 to {most}"), value))
    }

    fn answer(&self) -> Result<Answer, SetupError> {
        let then = match self.text("then")? {
            None | Some("SUCCESS") => Status::Success,
            Some("FAILURE") => Status::Failure,
            Some("RUNNING") => Status::Running,
            Some("SKIPPED") => Status::Skipped,
            Some(other) => {
                let allowed = "one of \"SUCCESS\", \"FAILURE\", \"RUNNING\", \"SKIPPED\"";
                return Err(unfit(&self.path("then"), allowed, &Value::from(other)));
            }
        };
        let mut writes = BTreeMap::new();
        if let Some(value) = self.get("writes") {
            let Value::Object(ports) = value else { return Err(unfit(&self.path("writes"), "an object", value)) };
            for (port, value) in ports {
                let Some(text) = value.as_str() else {
                    return Err(unfit(&self.path(&format!("writes.{port}")), "a text", value));
                };
                writes.insert(port.clone(), text.to_owned());
            }
        }
        Ok(Answer { running: self.number("running", MOST_RUNNING)?.unwrap_or(0) as u32, then, writes })
    }
}

fn missing(path: &str, allowed: &str) -> SetupError {
    SetupError(format!("{path}: expected {allowed}, found no such field"))
}

fn unfit(path: &str, allowed: &str, found: &Value) -> SetupError {
    let mut found = found.to_string();
    if let Some((end, _)) = found.char_indices().nth(60) {
        found.truncate(end);
        found.push_str("...");
    }
    SetupError(format!("{path}: expected {allowed}, found {found}"))
}
