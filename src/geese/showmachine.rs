//! A state machine as the page shows it: its states, its tests and its rules in order, with what happened last.

use super::machine::{Machine, VARIABLES};
use serde::Serialize;

/// A machine, of one agent or of all that run it.
#[derive(Clone, Debug, Serialize)]
pub struct ShownMachine {
    /// The first is the one in which a machine starts.
    states: Vec<Part>,
    /// The conditions tested, then the variables.
    tests: Vec<Part>,
    rules: Vec<ShownRule>,
}

/// A state or a test.
#[derive(Clone, Debug, Serialize)]
struct Part {
    label: String,
    /// Share of the agents shown that are in the state, or for which the test held, in the last step.
    now: f64,
    /// Share of them for which the state's behaviour succeeded, or the test held.
    succeeded: f64,
}

#[derive(Clone, Debug, Serialize)]
struct ShownRule {
    from: Vec<String>,
    wanted: Vec<String>,
    equals: bool,
    goto: String,
    goto_probability: f64,
    /// What is set, such as `X, true`, and how likely.
    set: Option<(String, f64)>,
    /// Share of the agents shown for which it fired in the last step.
    reached_now: f64,
    reached_recently: f64,
}

impl ShownMachine {
    /// A machine that nobody runs.
    #[must_use]
    pub fn of(machine: &Machine) -> Self {
        Self::running(machine, &[], 0, 0)
    }

    /// A machine with what the machines `shown`, equal to it, did in step `tick`, and within `recent` steps.
    #[must_use]
    pub fn running(machine: &Machine, shown: &[&Machine], tick: u32, recent: u32) -> Self {
        let share = |is: &dyn Fn(&Machine) -> bool| {
            let count = shown.iter().filter(|machine| is(machine)).count();
            count as f64 / shown.len().max(1) as f64
        };
        let ran = |machine: &Machine| tick > 0 && machine.tick == tick;
        let (mut states, mut tests, mut rules) = (Vec::new(), Vec::new(), Vec::new());
        for (leaf, place) in machine.states.iter().zip(0..) {
            let now = share(&|machine| machine.state == place);
            let succeeded = share(&|machine| machine.state == place && ran(machine) && machine.succeeded);
            states.push(Part { label: leaf.to_string(), now, succeeded });
        }
        for place in 0..u32::BITS as usize {
            let label = match machine.tests.get(place) {
                Some(leaf) => leaf.to_string(),
                None if place >= 30 => VARIABLES[place - 30].to_owned(),
                None => continue,
            };
            let now = share(&|machine| ran(machine) && machine.holds >> place & 1 == 1);
            tests.push(Part { label, now, succeeded: now });
        }
        for (at, rule) in machine.rules.iter().enumerate() {
            let within = |steps: u32| share(&|machine| machine.fired[at] > 0 && machine.fired[at] + steps > tick);
            rules.push(ShownRule {
                from: machine.from(rule),
                wanted: machine.wanted(rule),
                equals: rule.equals,
                goto: machine.states[usize::from(rule.goto)].to_string(),
                goto_probability: rule.goto_probability,
                set: Machine::setting(rule),
                reached_now: within(1),
                reached_recently: within(recent),
            });
        }
        Self { states, tests, rules }
    }
}
