//! A state machine as the page shows it: its states, its tests and its rules in order, with what happened last.

use super::machine::{Machine, Rule, Setting, VARIABLES, variable_bit};
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
    /// Share of them for which the state's behaviour succeeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    succeeded: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct ShownRule {
    from: Vec<String>,
    wanted: Vec<String>,
    equals: bool,
    goto: String,
    goto_probability: f64,
    /// What is set, such as `X = true`, and how likely.
    set: Option<(String, f64)>,
    text: String,
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
        let states = machine.states.iter().zip(0..).map(|(leaf, place): (_, u8)| Part {
            label: leaf.to_string(),
            now: share(&|machine| machine.state == place),
            succeeded: Some(share(&|machine| machine.state == place && ran(machine) && machine.succeeded)),
        });
        let test = |label: String, bit: u32| {
            let now = share(&|machine| ran(machine) && machine.holds & bit != 0);
            Part { label, now, succeeded: None }
        };
        let tests = machine.tests.iter().zip(0..).map(|(leaf, place)| test(leaf.to_string(), 1 << place));
        let variables = VARIABLES.iter().zip(0..).map(|(name, place)| test((*name).to_owned(), variable_bit(place)));
        let rules = machine.rules.iter().enumerate().map(|(at, rule)| {
            let within = |steps: u32| share(&|machine| machine.fired[at] > 0 && machine.fired[at] + steps > tick);
            ShownRule { reached_now: within(1), reached_recently: within(recent), ..shown_rule(machine, rule) }
        });
        Self { states: states.collect(), tests: tests.chain(variables).collect(), rules: rules.collect() }
    }
}

fn shown_rule(machine: &Machine, rule: &Rule) -> ShownRule {
    let set = rule.set.map(|Setting { variable, value, probability }| {
        (format!("{} = {value}", VARIABLES[usize::from(variable)]), probability)
    });
    ShownRule {
        from: machine.from(rule).map(|leaf| leaf.to_string()).collect(),
        wanted: machine.wanted(rule),
        equals: rule.equals,
        goto: machine.states[usize::from(rule.goto)].to_string(),
        goto_probability: rule.goto_probability,
        set,
        text: machine.rule_text(rule),
        reached_now: 0.0,
        reached_recently: 0.0,
    }
}
