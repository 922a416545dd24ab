//! A match written down: what was played, what was called and why, and by which fingerprints it is known again.
//!
//! Nothing of the play itself is kept: the scenario and its events decide every state, so whoever has the file plays the
//! match again and sees it whole. The fingerprints tell whether that was the same match, and the first one that differs,
//! when it parted.

use super::{Outcome, Run, Scenario, ScenarioError};
use crate::nearest::nearest;
use crate::parameter::shown;
use crate::soccer::pitch::Quadrant;
use crate::soccer::referee::{Entry, Rule};
use crate::soccer::{Colour, TeamEvent, World};
use serde_json::{Map, Value, json};
use std::fmt;

/// What the file says it is.
const FORMAT: &str = "swarm-playground-match/1";
/// Control frames between fingerprints: ten seconds of play.
const SPACING: u32 = 600;
const FIELDS: [&str; 8] = ["format", "version", "scenario", "ticks", "outcome", "calls", "events", "fingerprints"];

/// A match that was played to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Replay {
    /// What was played, with all changes made on the way.
    pub scenario: Scenario,
    /// The version that played it.
    pub version: String,
    /// Control frames of play.
    pub ticks: u32,
    /// Ticks with the fingerprint of the whole state, rising; the last one is the end.
    pub marks: Vec<(u32, u64)>,
    /// How it ended, as `run` prints it.
    outcome: Value,
    /// The referee's calls with their reasons, oldest first.
    calls: Vec<Value>,
    /// What the coaches did, oldest first.
    events: Vec<Value>,
}

/// Where a match that was played again parted from what was written down.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The path in the file, such as `fingerprints[3]`.
    pub path: String,
    /// What stands there.
    pub written: String,
    /// What was found when the match was played again.
    pub found: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: the file has {}, played again it is {}", self.path, self.written, self.found)
    }
}

fn fault<T>(path: impl Into<String>, message: impl Into<String>) -> Result<T, ScenarioError> {
    Err(ScenarioError { path: path.into(), message: message.into() })
}

impl Replay {
    /// Plays a match and writes it down.
    ///
    /// # Errors
    /// The scenario is of another world, or its world cannot be built.
    pub fn record(scenario: Scenario) -> Result<Self, ScenarioError> {
        let world = scenario.world.name();
        let mut run = Run::new(scenario)?;
        let mut marks = Vec::new();
        while run.soccer().is_some() && run.advance(SPACING) > 0 {
            marks.push((run.tick(), run.fingerprint()));
        }
        let (Some(played), Outcome::Soccer(outcome)) = (run.soccer(), run.outcome()) else {
            return fault("world", format!("expected \"soccer\", found \"{world}\""));
        };
        Ok(Self {
            scenario: run.scenario().clone(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            ticks: run.tick(),
            marks,
            outcome: serde_json::to_value(outcome).unwrap_or_default(),
            calls: calls(played),
            events: events(played),
        })
    }

    /// Goals of blue and yellow.
    #[must_use]
    pub fn goals(&self) -> [u64; 2] {
        [0, 1].map(|team| self.outcome["goals"][team].as_u64().unwrap_or_default())
    }

    /// Reads a file.
    ///
    /// # Errors
    /// One sentence with the path of the field: no JSON (with line and column), another format, an unknown or missing
    /// field, a scenario that is refused, ticks that do not rise to the end. Whether the calls and events are those of
    /// the match, [`Replay::check`] tells.
    pub fn read(text: &str) -> Result<Self, ScenarioError> {
        let value: Value = match serde_json::from_str(text) {
            Ok(value) => value,
            Err(error) => return fault("", format!("expected a match as JSON: {error}")),
        };
        let Value::Object(fields) = &value else {
            return fault("", format!("expected a match, an object with a field \"format\", found {}", shown(&value)));
        };
        match fields.get("format").and_then(Value::as_str) {
            Some(FORMAT) => {}
            _ => return fault("format", format!("expected \"{FORMAT}\", found {}", shown(&value["format"]))),
        }
        if let Some(name) = fields.keys().find(|name| !FIELDS.contains(&name.as_str())) {
            let near = nearest(name, FIELDS.into_iter());
            let instead = near.map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
            return fault(name, format!("unknown field{instead}"));
        }
        let missing = FIELDS.into_iter().find(|name| !fields.contains_key(*name));
        if let Some(name) = missing {
            return fault(name, "expected this field, found no such one");
        }
        let scenario = Scenario::from_value(&value["scenario"]).map_err(|error| ScenarioError {
            path: if error.path.is_empty() { "scenario".to_owned() } else { format!("scenario.{}", error.path) },
            message: error.message,
        })?;
        if scenario.world.name() != "soccer" {
            return fault("scenario.world", format!("expected \"soccer\", found \"{}\"", scenario.world.name()));
        }
        let Value::String(version) = &value["version"] else {
            return fault("version", format!("expected text, found {}", shown(&value["version"])));
        };
        let ticks = whole(&value["ticks"], "ticks")?;
        let marks = read_marks(&value["fingerprints"], ticks)?;
        if !value["outcome"].is_object() {
            return fault("outcome", format!("expected an object, found {}", shown(&value["outcome"])));
        }
        Ok(Self {
            scenario,
            version: version.clone(),
            ticks,
            marks,
            outcome: value["outcome"].clone(),
            calls: objects(fields, "calls")?,
            events: objects(fields, "events")?,
        })
    }

    /// The file as JSON, which [`Replay::read`] reads.
    #[must_use]
    pub fn to_value(&self) -> Value {
        let marks: Vec<Value> =
            self.marks.iter().map(|(tick, fingerprint)| json!([tick, format!("{fingerprint:016x}")])).collect();
        json!({"format": FORMAT, "version": self.version, "scenario": self.scenario.to_value(), "ticks": self.ticks,
            "outcome": self.outcome, "calls": self.calls, "events": self.events, "fingerprints": marks})
    }

    /// Plays the match again; `None` when it is the same to the last bit.
    ///
    /// # Errors
    /// As [`Replay::record`].
    pub fn check(&self) -> Result<Option<Difference>, ScenarioError> {
        let again = Self::record(self.scenario.clone())?;
        // Both through one text, because a real number may come back from a text in its nearest neighbour.
        let [written, found] = [self, &again].map(|replay| {
            let text = replay.to_value().to_string();
            serde_json::from_str::<Value>(&text).unwrap_or_default()
        });
        // The fingerprints first: they say when.
        let order = ["fingerprints", "ticks", "outcome", "calls", "events"];
        Ok(order.into_iter().find_map(|name| difference(&written[name], &found[name], name)))
    }
}

/// The first place in which two values differ.
fn difference(written: &Value, found: &Value, path: &str) -> Option<Difference> {
    match (written, found) {
        _ if written == found => None,
        (Value::Array(ours), Value::Array(theirs)) => {
            // Short lists such as a tick with its fingerprint are shown whole.
            if !ours.iter().chain(theirs).any(|value| value.is_array() || value.is_object()) {
                return Some(differ(path, &written.to_string(), &found.to_string()));
            }
            let parted = |(at, (ours, theirs))| difference(ours, theirs, &format!("{path}[{at}]"));
            let first = ours.iter().zip(theirs).enumerate().find_map(parted);
            let counts = [ours, theirs].map(|list| format!("{} entries", list.len()));
            first.or_else(|| Some(differ(path, &counts[0], &counts[1])))
        }
        (Value::Object(ours), Value::Object(theirs)) => {
            let names = ours.keys().chain(theirs.keys());
            let nothing = Value::Null;
            let field = |name: &String| {
                let [ours, theirs] = [ours, theirs].map(|fields| fields.get(name).unwrap_or(&nothing));
                difference(ours, theirs, &format!("{path}.{name}"))
            };
            names.into_iter().find_map(field)
        }
        _ => Some(differ(path, &written.to_string(), &found.to_string())),
    }
}

fn differ(path: &str, written: &str, found: &str) -> Difference {
    Difference { path: path.to_owned(), written: written.to_owned(), found: found.to_owned() }
}

fn whole(value: &Value, path: &str) -> Result<u32, ScenarioError> {
    match value.as_u64().and_then(|whole| u32::try_from(whole).ok()) {
        Some(whole) => Ok(whole),
        None => fault(path, format!("expected a whole number from 0 to {}, found {}", u32::MAX, shown(value))),
    }
}

fn read_marks(value: &Value, ticks: u32) -> Result<Vec<(u32, u64)>, ScenarioError> {
    let Value::Array(list) = value else {
        return fault("fingerprints", format!("expected a list, found {}", shown(value)));
    };
    let mut marks: Vec<(u32, u64)> = Vec::new();
    for (at, value) in list.iter().enumerate() {
        let path = format!("fingerprints[{at}]");
        let pair = value.as_array().filter(|pair| pair.len() == 2);
        let Some([tick, fingerprint]) = pair.map(Vec::as_slice) else {
            return fault(path, format!("expected a tick and its fingerprint, found {}", shown(value)));
        };
        let tick = whole(tick, &format!("{path}[0]"))?;
        let hex =
            fingerprint.as_str().filter(|text| text.len() == 16).and_then(|text| u64::from_str_radix(text, 16).ok());
        let Some(hex) = hex else {
            let message = format!("expected 16 hexadecimal digits, found {}", shown(fingerprint));
            return fault(format!("{path}[1]"), message);
        };
        let least = marks.last().map_or(0, |mark| mark.0 + 1);
        if !(least..=ticks).contains(&tick) {
            return fault(format!("{path}[0]"), format!("expected a tick from {least} to {ticks}, found {tick}"));
        }
        marks.push((tick, hex));
    }
    match marks.last() {
        Some(&(end, _)) if end == ticks => Ok(marks),
        Some(&(end, _)) => fault("fingerprints", format!("expected the last one at tick {ticks}, found {end}")),
        None => fault("fingerprints", "expected at least that of the end, found none"),
    }
}

fn objects(fields: &Map<String, Value>, name: &str) -> Result<Vec<Value>, ScenarioError> {
    let value = fields.get(name).unwrap_or(&Value::Null);
    let Value::Array(list) = value else { return fault(name, format!("expected a list, found {}", shown(value))) };
    match list.iter().enumerate().find(|(_, value)| !value.is_object()) {
        Some((at, value)) => fault(format!("{name}[{at}]"), format!("expected an object, found {}", shown(value))),
        None => Ok(list.clone()),
    }
}

fn colour(colour: Colour) -> &'static str {
    match colour {
        Colour::Blue => "blue",
        Colour::Yellow => "yellow",
    }
}

/// The referee's log, without what follows on every call: that robots were placed and the wait is over.
fn calls(world: &World) -> Vec<Value> {
    let game = world.state().game();
    let mut names = ["yellow"; 2];
    names[game.side_of(Colour::Blue).index()] = "blue";
    let told = game.log().iter().filter(|entry| !matches!(entry.rule, Rule::Placed | Rule::WaitOver));
    let call = |entry: &Entry| {
        json!({"tick": entry.frame, "phase": entry.phase, "seconds": entry.seconds, "elapsed": entry.elapsed,
            "command": entry.command, "team": entry.side.map(|side| names[side.index()]),
            "quadrant": entry.quadrant.map(Quadrant::number), "rule": entry.rule, "text": entry.text(names)})
    };
    told.map(call).collect()
}

fn events(world: &World) -> Vec<Value> {
    let event = |event: &TeamEvent| json!({"tick": event.event.frame, "team": colour(event.team), "text": event.event.kind.to_string()});
    world.state().events().iter().map(event).collect()
}
