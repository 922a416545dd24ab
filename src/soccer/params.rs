//! The parameters of a match.

use super::referee::Times;
use super::schema::parameters;
use super::team::{Margins, TeamKind};
use super::world::World;
use crate::nearest::nearest;
use crate::parameter::shown;
use crate::random::Seed;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Every parameter; see `schema.rs` for bounds, meaning and source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "each field is described once, in the schema")]
pub struct Params {
    pub blue: TeamKind,
    pub yellow: TeamKind,
    pub blue_coach: String,
    pub yellow_coach: String,
    pub blue_roles: String,
    pub yellow_roles: String,
    pub enter: f64,
    pub leave_more: f64,
    pub leave_less: f64,
    pub swap_dwell: f64,
    pub group_dwell: f64,
    pub lock_out: f64,
    pub half_seconds: u32,
    pub knockout: bool,
    pub extra_seconds: u32,
    pub sides_exchanged: bool,
    pub vision_noise: f64,
    pub heading_noise: f64,
    pub lost_detections: f64,
    pub wheel_noise: f64,
    pub placement_noise: f64,
    pub lost_commands: f64,
    pub command_delay: u32,
    pub substeps: u32,
}

impl Default for Params {
    fn default() -> Self {
        let Margins { enter, leave_more, leave_less, swap_dwell, group_dwell, lock_out } = Margins::default();
        Self {
            blue: TeamKind::Tree,
            yellow: TeamKind::Machine,
            blue_coach: String::new(),
            yellow_coach: String::new(),
            blue_roles: String::new(),
            yellow_roles: String::new(),
            enter,
            leave_more,
            leave_less,
            swap_dwell,
            group_dwell,
            lock_out,
            half_seconds: 300,
            knockout: false,
            extra_seconds: 180,
            sides_exchanged: false,
            vision_noise: 1.5,
            heading_noise: 0.5,
            lost_detections: 0.0,
            wheel_noise: 1.0,
            placement_noise: 2.0,
            lost_commands: 0.0,
            command_delay: 1,
            substeps: 4,
        }
    }
}

/// Seconds of a shoot-out, at most: 20 pairs of attempts of 10 s.
const SHOOT_OUT: u32 = 400;

/// The path of a field and what is wrong with it.
type Fault = (String, String);

impl Params {
    /// Reads parameters; fields that are not there keep their defaults.
    ///
    /// - `value`: an object of fields in kebab case.
    /// - `path`: put before the names in errors, such as `match.`; may be empty.
    ///
    /// # Errors
    /// The path of the field, and what was found and is allowed: no object, an unknown field, a value of another type or
    /// out of its bounds.
    pub fn read(value: &Value, path: &str) -> Result<Self, Fault> {
        let Value::Object(given) = value else {
            let at = path.strip_suffix('.').unwrap_or(path).to_owned();
            return Err((at, format!("expected an object with parameters, found {}", shown(value))));
        };
        let mut params = Self::default();
        for (name, value) in given {
            let known = || parameters().iter().copied().flatten();
            let at = format!("{path}{name}");
            let Some(parameter) = known().find(|parameter| parameter.name == name) else {
                return Err(match nearest(name, known().map(|parameter| parameter.name)) {
                    Some(near) => (at, format!("unknown field, did you mean \"{near}\"?")),
                    None => (at, "unknown field".to_owned()),
                });
            };
            match parameter.kind.check(value, parameter.unit) {
                Ok(value) => {
                    let taken = params.set(name, &value);
                    debug_assert!(taken, "{name} is in the schema, but no field takes its values");
                }
                Err(message) => return Err((at, message)),
            }
        }
        Ok(params)
    }

    /// Sets the field of that name, in kebab case; returns false when there is none or the value is of another type.
    pub fn set(&mut self, name: &str, value: &Value) -> bool {
        let Ok(Value::Object(mut fields)) = serde_json::to_value(&*self) else { return false };
        if !fields.contains_key(name) {
            return false;
        }
        fields.insert(name.to_owned(), value.clone());
        serde_json::from_value(Value::Object(fields)).map(|changed| *self = changed).is_ok()
    }

    /// Checks the trees and the margins.
    ///
    /// # Errors
    /// The field's name and what is wrong with it.
    pub fn check(&self) -> Result<(), (&'static str, String)> {
        // Any seed: what is checked does not depend on it.
        Seed::new(1).map_or(Ok(()), |seed| World::new(self, seed).map(|_| ()))
    }

    /// The most control frames that a match can take: nobody knows before how long overtime and a shoot-out last.
    #[must_use]
    pub fn steps(&self) -> u32 {
        let halves = 2 * self.half_seconds + if self.knockout { 2 * self.extra_seconds + SHOOT_OUT } else { 0 };
        halves * 60
    }

    /// The margins of all conditions.
    #[must_use]
    pub fn margins(&self) -> Margins {
        let Self { enter, leave_more, leave_less, swap_dwell, group_dwell, lock_out, .. } = *self;
        Margins { enter, leave_more, leave_less, swap_dwell, group_dwell, lock_out }
    }

    /// How long the parts of a match last.
    #[must_use]
    pub fn times(&self) -> Times {
        Times { half: self.half_seconds, extra: self.extra_seconds, knockout: self.knockout }
    }
}
