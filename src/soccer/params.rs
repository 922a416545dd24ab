//! The parameters of a match.

use super::game::Colour;
use super::referee::Times;
use super::team::{Margins, TeamKind};
use super::world;
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

    /// Checks the trees and the margins.
    ///
    /// # Errors
    /// The field's name and what is wrong with it.
    pub fn check(&self) -> Result<(), (&'static str, String)> {
        [Colour::Blue, Colour::Yellow].into_iter().try_for_each(|colour| world::check(self, colour))
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
