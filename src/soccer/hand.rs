//! What somebody outside does to a match while it goes on. In a scenario these are events, so that links, command line and
//! tests play the match with them.
//!
//! | key | value |
//! |---|---|
//! | `soccer.arrangement` | `{"ball": [x, y, vx, vy], "blue": [[x, y, heading], ...], "yellow": ...}`, in the frame of the pitch; the velocity of the ball may be left out |
//! | `soccer.restart` | `{"kind": "kick-off", "team": "blue"}`, likewise `goal-kick` and `penalty-kick`; `{"kind": "free-ball", "quadrant": 1}` |
//! | `soccer.drive` | `{"team": "blue", "robot": 1, "wheels": [left, right]}` for as long as no other event says otherwise; null ends it |

use super::arrangement::Arrangement;
use super::game::Colour;
use super::params::Params;
use super::physics::WHEEL_LIMIT;
use super::pitch::{Quadrant, Side};
use super::referee::Kick;
use super::view::{Ball, ROBOTS, Spot, Wheels};
use crate::nearest::nearest;
use crate::parameter::shown;
use serde::Deserialize;
use serde_json::Value;

/// Something done to a match from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intervention {
    /// Robots and ball are put somewhere. While a call waits for its placement, that comes first.
    Arrange(Arrangement),
    /// Play stops and starts again like this; of a free ball the side is decided by the quadrant.
    Restart(Kick, Side),
    /// One robot drives as it is told, whatever its team says; `None` gives it back.
    Drive(Option<Driven>),
}

/// A robot that somebody drives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// Its team.
    pub team: Colour,
    /// From 0.
    pub robot: usize,
    /// What its wheels are told.
    pub wheels: Wheels,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Places {
    ball: Vec<f64>,
    blue: [[f64; 3]; ROBOTS],
    yellow: [[f64; 3]; ROBOTS],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Start {
    kind: String,
    team: Option<String>,
    quadrant: Option<u8>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Drive {
    team: String,
    robot: usize,
    wheels: [f64; 2],
}

impl Intervention {
    /// The names of the events, without the world's.
    pub const NAMES: [&str; 3] = ["arrangement", "restart", "drive"];

    /// Reads the value of an event.
    ///
    /// - `name`: one of [`Intervention::NAMES`].
    /// - `params`: say which team defends which side.
    ///
    /// # Errors
    /// What was found and what is allowed: another form, a place off the pitch, overlaps, a team, kind, quadrant or robot
    /// that does not exist, wheels that no motor turns so fast. `None` for a name that is none.
    #[must_use]
    pub fn read(name: &str, value: &Value, params: &Params) -> Option<Result<Self, String>> {
        match name {
            "arrangement" => Some(arrangement(value, params)),
            "restart" => Some(restart(value, params)),
            "drive" => Some(drive(value)),
            _ => None,
        }
    }
}

fn taken<T: for<'a> Deserialize<'a>>(value: &Value, form: &str) -> Result<T, String> {
    if !value.is_object() {
        return Err(format!("expected {form}, found {}", shown(value)));
    }
    T::deserialize(value).map_err(|error| format!("expected {form}: {error}"))
}

fn side_of(colour: Colour, params: &Params) -> Side {
    match (colour, params.sides_exchanged) {
        (Colour::Blue, false) | (Colour::Yellow, true) => Side::Left,
        (Colour::Blue, true) | (Colour::Yellow, false) => Side::Right,
    }
}

fn colour(name: &str) -> Result<Colour, String> {
    match name {
        "blue" => Ok(Colour::Blue),
        "yellow" => Ok(Colour::Yellow),
        other => Err(format!("expected the team \"blue\" or \"yellow\", found {other:?}")),
    }
}

fn arrangement(value: &Value, params: &Params) -> Result<Intervention, String> {
    let places: Places = taken(value, "an object with ball, blue and yellow")?;
    let ball = match *places.ball.as_slice() {
        [x, y] => Ball { at: [x, y], velocity: [0.0; 2] },
        [x, y, vx, vy] => Ball { at: [x, y], velocity: [vx, vy] },
        _ => return Err(format!("expected 2 or 4 numbers for the ball, found {}", places.ball.len())),
    };
    let spots = |list: [[f64; 3]; ROBOTS]| list.map(|[x, y, heading]| Spot { at: [x, y], heading });
    let mut robots = [spots(places.blue), spots(places.yellow)];
    if side_of(Colour::Blue, params) == Side::Right {
        robots.swap(0, 1);
    }
    let arrangement = Arrangement { ball, robots };
    arrangement.check().map_err(|error| error.to_string())?;
    Ok(Intervention::Arrange(arrangement))
}

const KINDS: [&str; 4] = ["kick-off", "free-ball", "goal-kick", "penalty-kick"];

fn restart(value: &Value, params: &Params) -> Result<Intervention, String> {
    let start: Start = taken(value, "an object with kind and team, of a free ball with kind and quadrant")?;
    let kick = match start.kind.as_str() {
        "kick-off" => Kick::KickOff,
        "goal-kick" => Kick::GoalKick,
        "penalty-kick" => Kick::Penalty,
        "free-ball" => {
            let found = start.quadrant.unwrap_or(0);
            let quadrant = Quadrant::ALL.into_iter().find(|quadrant| quadrant.number() == found);
            let quadrant = quadrant.ok_or_else(|| format!("expected a quadrant from 1 to 4, found {found}"))?;
            return Ok(Intervention::Restart(Kick::FreeBall(quadrant), quadrant.side().other()));
        }
        other => {
            let near =
                nearest(other, KINDS.into_iter()).map_or(String::new(), |near| format!(", did you mean \"{near}\"?"));
            return Err(format!("expected one of {}, found {other:?}{near}", KINDS.join(", ")));
        }
    };
    let team = start.team.ok_or_else(|| format!("expected the team that takes the {}, found none", start.kind))?;
    Ok(Intervention::Restart(kick, side_of(colour(&team)?, params)))
}

fn drive(value: &Value) -> Result<Intervention, String> {
    if value.is_null() {
        return Ok(Intervention::Drive(None));
    }
    let drive: Drive = taken(value, "null or an object with team, robot and wheels")?;
    if !(1..=ROBOTS).contains(&drive.robot) {
        return Err(format!("expected a robot from 1 to {ROBOTS}, found {}", drive.robot));
    }
    let [left, right] = drive.wheels;
    if let Some(speed) = [left, right].into_iter().find(|speed| !(-WHEEL_LIMIT..=WHEEL_LIMIT).contains(speed)) {
        return Err(format!("expected wheels from {} to {WHEEL_LIMIT} rad/s, found {speed}", -WHEEL_LIMIT));
    }
    let (team, wheels) = (colour(&drive.team)?, Wheels { left, right });
    Ok(Intervention::Drive(Some(Driven { team, robot: drive.robot - 1, wheels })))
}
