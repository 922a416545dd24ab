//! Robot soccer. The page films a match ahead in slices and asks for everything there is to see of one moment; frames cross
//! as a flat buffer of `f32` in wasm memory, of which the page makes a view after each call.

use super::{answer, error};
use crate::bt::xml::Problem;
use crate::scenario::{Film, Run, Scenario, schema};
use crate::soccer::pitch::walls;
use crate::soccer::team::{
    self, Role, coach, coach_nodes, coach_problems, organisation::Organisation, role_nodes, role_problems, roles,
};
use crate::soccer::{Colour, FRAME, World, machine_edges, machine_states};
use serde_json::{Map, Value, json};
use wasm_bindgen::prelude::*;

/// Bytes that keyframes may take.
const KEYFRAME_BYTES: usize = 32 << 20;

/// Every parameter of soccer scenarios as JSON.
#[wasm_bindgen]
#[must_use]
pub fn soccer_schema() -> String {
    let own = |entry: &&Value| {
        let key = entry["key"].as_str().unwrap_or_default();
        key == "seed" || key.starts_with("soccer.")
    };
    let entries = schema();
    answer(entries.as_array().map(|entries| entries.iter().filter(own).collect::<Vec<_>>()))
}

/// The scenario as JSON with every field present.
///
/// # Errors
/// The scenario is not valid; the message says where and why.
#[wasm_bindgen]
pub fn soccer_complete(scenario: &str) -> Result<String, JsError> {
    Ok(Scenario::read(scenario).map_err(|fault| error(&fault))?.to_value().to_string())
}

/// What does not change: walls, the reals of a frame, roles by their number, the state machine, the organisation and the
/// built-in trees, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn soccer_setting() -> String {
    let setting = json!({
        "frame": FRAME,
        "walls": walls(),
        "roles": Role::ALL.map(Role::text),
        "states": machine_states(),
        "edges": machine_edges(),
        "organisation": Organisation::built_in(),
        "coach": coach::BUILT_IN,
        "coach_without_swaps": coach::WITHOUT_SWAPS,
        "role_trees": roles::BUILT_IN,
        "chase_trees": roles::CHASE,
    });
    setting.to_string()
}

/// Faults and warnings of the text of a coach (`coach`) or of roles, and the nodes of its trees by name when it has no
/// fault, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn soccer_trees(what: &str, xml: &str) -> String {
    let problem = |problem: &Problem| {
        json!({"code": problem.code, "line": problem.place.line, "column": problem.place.column,
            "message": problem.message, "warning": problem.warning})
    };
    let (problems, trees) = if what == "coach" {
        (coach_problems(xml), coach_nodes(xml).map(|nodes| json!({ "coach": nodes })))
    } else {
        let trees = |list: Vec<(Role, Vec<team::ShownNode>)>| {
            list.into_iter().map(|(role, nodes)| (role.text().to_owned(), json!(nodes))).collect::<Map<_, _>>()
        };
        (role_problems(xml), role_nodes(xml).map(|list| Value::Object(trees(list))))
    };
    json!({"problems": problems.iter().map(problem).collect::<Vec<_>>(), "trees": trees.ok()}).to_string()
}

/// A match that is filmed ahead.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Match {
    film: Film,
}

#[wasm_bindgen]
impl Match {
    /// Builds the match of a scenario, given as JSON.
    ///
    /// # Errors
    /// The scenario is not valid or not of soccer.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &str) -> Result<Match, JsError> {
        let film = Scenario::read(scenario).and_then(Run::new).and_then(|run| Film::new(run, KEYFRAME_BYTES));
        Ok(Match { film: film.map_err(|fault| error(&fault))? })
    }

    /// Films up to `ticks` further; returns whether there is more to film.
    pub fn ahead(&mut self, ticks: u32) -> bool {
        self.film.ahead(ticks)
    }

    /// Plays up to `ticks` further without filming; returns whether there is more to play.
    pub fn skip(&mut self, ticks: u32) -> bool {
        self.film.skip(ticks)
    }

    /// The tick up to which it was filmed.
    #[must_use]
    pub fn front(&self) -> u32 {
        self.film.front()
    }

    /// Where the frames taken since [`Match::clear`] stand in memory.
    #[must_use]
    pub fn frames_pointer(&self) -> *const f32 {
        self.film.frames().as_ptr()
    }

    /// Reals of these frames.
    #[must_use]
    pub fn frames_length(&self) -> usize {
        self.film.frames().len()
    }

    /// Forgets the frames, which the page has.
    pub fn clear(&mut self) {
        self.film.clear();
    }

    /// The lines of the referee's log from number `log` on, what the coaches did from number `events` on, and how the match
    /// stands, as JSON. To be asked at the front.
    #[must_use]
    pub fn news(&self, log: usize, events: usize) -> String {
        answer(self.film.run().soccer().map(|world| news(world, log, events)))
    }

    /// Everything that there is to see at a tick, as JSON.
    pub fn look(&mut self, tick: u32) -> String {
        answer(self.film.look(tick))
    }

    /// The fingerprint at a tick, as 16 hex digits.
    pub fn fingerprint(&mut self, tick: u32) -> String {
        format!("{:016x}", self.film.fingerprint(tick))
    }

    /// Why the match ended, or `undefined`. To be asked at the front.
    #[must_use]
    pub fn finished(&self) -> Option<String> {
        self.film.run().finished().map(str::to_owned)
    }

    /// How the match stands, as JSON. To be asked at the front.
    #[must_use]
    pub fn outcome(&self) -> String {
        answer(self.film.run().soccer().map(World::outcome))
    }

    /// Does something to the match at a tick, as an event of its scenario; `value` is JSON. What was later is cut off.
    ///
    /// # Errors
    /// The key is unknown or the value is not allowed; nothing changes then.
    pub fn set(&mut self, tick: u32, key: &str, value: &str) -> Result<(), JsError> {
        let value: Value = serde_json::from_str(value).map_err(|fault| error(&fault))?;
        self.film.set(tick, key, &value).map_err(|fault| error(&fault))
    }

    /// Where everything is at a tick, as the value of an event, as JSON.
    pub fn arrangement(&mut self, tick: u32) -> String {
        self.film.arrangement(tick).to_string()
    }

    /// The scenario with everything done to the match so far, as JSON.
    #[must_use]
    pub fn scenario(&self) -> String {
        self.film.run().scenario().to_value().to_string()
    }
}

fn news(world: &World, log: usize, events: usize) -> Value {
    let state = world.state();
    let game = state.game();
    let mut names = ["blue", "yellow"];
    let exchanged = game.side_of(Colour::Blue).index() == 1;
    if exchanged {
        names.reverse();
    }
    let entry = |entry: &crate::soccer::referee::Entry| {
        json!({"frame": entry.frame, "phase": entry.phase, "seconds": entry.seconds, "elapsed": entry.elapsed,
            "command": entry.command, "team": entry.side.map(|side| names[side.index()]), "quadrant": entry.quadrant,
            "rule": entry.rule, "reason": entry.reason(names)})
    };
    let event = |event: &crate::soccer::TeamEvent| {
        let team = if event.team == Colour::Blue { "blue" } else { "yellow" };
        json!({"frame": event.event.frame, "team": team, "kind": event.event.kind.word(), "text": event.event.kind.to_string()})
    };
    json!({
        "log": game.log().iter().skip(log).map(entry).collect::<Vec<_>>(),
        "events": state.events().iter().skip(events).map(event).collect::<Vec<_>>(),
        "outcome": world.outcome(),
        "exchanged": exchanged,
    })
}
