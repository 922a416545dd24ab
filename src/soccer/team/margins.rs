//! How much more is asked for entering a condition than for leaving it, and how long nothing may change.

use crate::fingerprint::Fingerprint;
use std::fmt;

/// The margins of the conditions; a study of hysteresis varies them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// How much clearer than in the table a difference between robots, or to the halfway line, must be to enter: "more
    /// than" is multiplied by it, "less than" divided; 1 is the table. Places on the pitch and times stay.
    pub enter: f64,
    /// What "more than" is multiplied by in the leave form.
    pub leave_more: f64,
    /// What "less than" is multiplied by in the leave form.
    pub leave_less: f64,
    /// Seconds after a swap before the same pair may swap again, or the swap state be left.
    pub swap_dwell: f64,
    /// Seconds after a change of group before the next one.
    pub group_dwell: f64,
    /// Seconds after a placement without any swap.
    pub lock_out: f64,
}

impl Default for Margins {
    /// The margins that a match begins with.
    ///
    /// Source: our choice; the paper prints none.
    fn default() -> Self {
        Self { enter: 1.0, leave_more: 0.5, leave_less: 1.5, swap_dwell: 0.25, group_dwell: 0.5, lock_out: 0.5 }
    }
}

/// Why margins cannot be played with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarginsError(String);

impl fmt::Display for MarginsError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl std::error::Error for MarginsError {}

impl Margins {
    /// Checks every field.
    ///
    /// # Errors
    /// The first field out of its range: factors for entering from 0.1 to 10, of the leave form such that it holds more
    /// easily, and times from 0 to 60 seconds.
    pub fn check(&self) -> Result<(), MarginsError> {
        let fields = [
            ("enter", self.enter, 0.1, 10.0),
            ("leave_more", self.leave_more, 0.0, 1.0),
            ("leave_less", self.leave_less, 1.0, 10.0),
            ("swap_dwell", self.swap_dwell, 0.0, 60.0),
            ("group_dwell", self.group_dwell, 0.0, 60.0),
            ("lock_out", self.lock_out, 0.0, 60.0),
        ];
        for (name, value, least, most) in fields {
            if !(least..=most).contains(&value) {
                return Err(MarginsError(format!("margins.{name}: expected {least} to {most}, found {value}")));
            }
        }
        Ok(())
    }

    /// The same with every entry twice as clear.
    #[must_use]
    pub fn doubled(self) -> Self {
        Self { enter: 2.0 * self.enter, ..self }
    }

    /// Takes everything into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        let Self { enter, leave_more, leave_less, swap_dwell, group_dwell, lock_out } = *self;
        for value in [enter, leave_more, leave_less, swap_dwell, group_dwell, lock_out] {
            hash.f64(value);
        }
    }
}
