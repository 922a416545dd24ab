//! What a sequence costs besides path length: arrival time and switches, which the paper asks for (section VI).
//!
//! Where Stop is charged decides whether moving every Stop to the end, the largest saving of the search, stays exact.
//! Let d be the charge between two different moving behaviours, i that into Stop and o that out of it. Taking out a
//! run of Stops between a and b saves i + o - d, or i + o when a = b; one at the start saves o; and at most one charge
//! i is added at the end. So with o >= d and o >= i the form with all Stops last is never dearer. Otherwise a Stop
//! may be a cheap reset between two behaviours, and the search treats it as a behaviour like any other.

/// Charges besides path length, in metres of path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Per second before the final run of Stops.
    pub per_second: f64,
    /// What switching costs.
    pub switches: Switches,
}

/// When a change of behaviour is charged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Switches {
    /// Never.
    Free,
    /// Between successive moving behaviours that differ, whether or not there are Stops between them.
    Transparent(f64),
    /// Between neighbouring intervals that differ.
    Charged {
        /// From one moving behaviour to another: d.
        between: f64,
        /// From a moving behaviour to Stop: i.
        into_stop: f64,
        /// From Stop to a moving behaviour: o.
        out_of_stop: f64,
        /// Whether the robots stand still before the first interval, so that moving at once is a change.
        first: bool,
    },
}

impl Default for Costs {
    /// Path length alone, as in the paper.
    fn default() -> Self {
        Self { per_second: 0.0, switches: Switches::Free }
    }
}

/// What later charges depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Past {
    /// The last moving behaviour.
    pub moving: Option<u8>,
    /// How many Stops came after it, or after the beginning.
    pub idle: u16,
}

impl Past {
    /// The past after one more behaviour.
    #[must_use]
    pub fn then(self, next: u8, is_stop: bool) -> Self {
        if is_stop { Self { idle: self.idle + 1, ..self } } else { Self { moving: Some(next), idle: 0 } }
    }
}

impl Costs {
    /// Whether a plan with all Stops last is never dearer than the same plan with Stops elsewhere.
    #[must_use]
    pub fn stop_last_is_exact(&self) -> bool {
        match self.switches {
            Switches::Free | Switches::Transparent(_) => true,
            // With `first`, waiting at the beginning is free and saves the change into Stop at the end.
            Switches::Charged { between, into_stop, out_of_stop, first } => {
                out_of_stop >= between && out_of_stop >= into_stop && !(first && into_stop > 0.0)
            }
        }
    }

    /// Whether which behaviour came last changes later charges.
    #[must_use]
    pub fn depend_on_the_last(&self) -> bool {
        self.switches != Switches::Free
    }

    /// The charge for one more behaviour: its switch, and the time of its interval and of the Stops before it.
    ///
    /// A Stop costs no time until a moving behaviour follows it: the final run of Stops is free.
    ///
    /// - `interval`: seconds.
    #[must_use]
    pub fn charge(&self, past: Past, next: u8, is_stop: bool, interval: f64) -> f64 {
        let time = if is_stop { 0.0 } else { self.per_second * interval * f64::from(past.idle + 1) };
        time + self.switch(past, next, is_stop)
    }

    /// The charge for the change alone.
    #[must_use]
    pub fn switch(&self, past: Past, next: u8, is_stop: bool) -> f64 {
        let changed = past.moving.is_some_and(|moving| moving != next);
        match self.switches {
            Switches::Free => 0.0,
            Switches::Transparent(charge) => {
                if changed && !is_stop {
                    charge
                } else {
                    0.0
                }
            }
            Switches::Charged { between, into_stop, out_of_stop, first } => match (is_stop, past.idle > 0) {
                (true, true) => 0.0,
                (true, false) => {
                    if past.moving.is_some() {
                        into_stop
                    } else {
                        0.0
                    }
                }
                (false, true) => out_of_stop,
                (false, false) if past.moving.is_none() => {
                    if first {
                        out_of_stop
                    } else {
                        0.0
                    }
                }
                (false, false) => {
                    if changed {
                        between
                    } else {
                        0.0
                    }
                }
            },
        }
    }

    /// The charge for filling the rest of the horizon with Stops.
    #[must_use]
    pub fn closing(&self, past: Past) -> f64 {
        self.switch(past, u8::MAX, true)
    }

    /// All charges of a sequence together.
    ///
    /// - `stop`: the behaviour that stops. `interval`: seconds.
    #[must_use]
    pub fn of(&self, sequence: &[u8], stop: Option<u8>, interval: f64) -> f64 {
        let mut past = Past::default();
        let mut sum = 0.0;
        for &next in sequence {
            let is_stop = stop == Some(next);
            sum += self.charge(past, next, is_stop, interval);
            past = past.then(next, is_stop);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STOP: u8 = 0;

    /// All sequences of a length over Stop and three moving behaviours.
    fn sequences(length: u32) -> impl Iterator<Item = Vec<u8>> {
        (0..4_u32.pow(length)).map(move |number| (0..length).map(|at| (number >> (2 * at) & 3) as u8).collect())
    }

    fn stop_last(sequence: &[u8]) -> Vec<u8> {
        let moving = sequence.iter().copied().filter(|&next| next != STOP);
        moving.chain(std::iter::repeat(STOP)).take(sequence.len()).collect()
    }

    /// Whether moving Stops last makes no sequence up to length 6 dearer.
    fn is_exact(costs: &Costs) -> bool {
        let dearer = |sequence: Vec<u8>| {
            costs.of(&stop_last(&sequence), Some(STOP), 10.0) > costs.of(&sequence, Some(STOP), 10.0) + 1e-9
        };
        !(1..=6).flat_map(sequences).any(dearer)
    }

    #[test]
    fn stop_last_is_claimed_exact_only_where_enumeration_agrees() {
        let mut exact = 0;
        for [between, into_stop, out_of_stop] in
            sequences(3).map(|digits| [0, 1, 2].map(|at: usize| f64::from(digits[at]) * 2.0))
        {
            for first in [false, true] {
                for per_second in [0.0, 1.0] {
                    let switches = Switches::Charged { between, into_stop, out_of_stop, first };
                    let costs = Costs { per_second, switches };
                    if costs.stop_last_is_exact() {
                        exact += 1;
                        assert!(is_exact(&costs), "{costs:?}");
                    }
                }
            }
        }
        assert!(exact > 60, "{exact}");
        for switches in [Switches::Free, Switches::Transparent(5.0)] {
            assert!(is_exact(&Costs { per_second: 1.0, switches }));
        }
        let reset = Switches::Charged { between: 4.0, into_stop: 0.0, out_of_stop: 0.0, first: false };
        assert!(!is_exact(&Costs { per_second: 0.0, switches: reset }), "a Stop is a cheap reset");
    }

    #[test]
    fn every_change_is_charged_as_by_hand() {
        let switches = Switches::Charged { between: 5.0, into_stop: 5.0, out_of_stop: 5.0, first: false };
        let costs = Costs { per_second: 1.0, switches };
        // 1 1 . 2 .: changes 1-., .-2, 2-. are three; the time is that of four intervals.
        assert!((costs.of(&[1, 1, STOP, 2, STOP], Some(STOP), 10.0) - (15.0 + 40.0)).abs() < 1e-12);
        // . . .: no change, no time.
        assert_eq!(costs.of(&[STOP, STOP, STOP], Some(STOP), 10.0).to_bits(), 0.0_f64.to_bits());
    }
}
