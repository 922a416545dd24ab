//! Finite-state machines as controllers: what GEESE evolved before there were trees.
//!
//! A machine is always in one state, and every state is a primitive behaviour, run as the trees run it. In each step the
//! machine evaluates the conditions that its rules test, each once; the first rule that fits its state and what it found
//! may take it to another state and set a variable; then the behaviour of its state runs.
//!
//! Source: GEESE's controllers were finite-state machines (BeTr-GEESE, section 1). Its grammar and its interpreter are not
//! public, so the rules and what they mean are our reading.

use super::leaf::{Leaf, Name};
use super::program::NO_LEAF;
use crate::fingerprint::Fingerprint;
use crate::random::{Stream, chance};
use std::fmt;

/// The names of the two variables, which are false at the start.
pub const VARIABLES: [&str; 2] = ["X", "Y"];

/// The bit of a variable in a set of tests; the bits below are those of [`Machine::tests`], of which there are fewer.
#[must_use]
pub fn variable_bit(variable: u8) -> u32 {
    1 << (30 + variable)
}

/// When a rule fires, and what it then may change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// The states in which it can fire, a bit each.
    pub from: u32,
    /// The tests that are to hold.
    pub holding: u32,
    /// The tests that are not to hold.
    pub failing: u32,
    /// Whether it fires when the tests are as wanted, or when they are not.
    pub equals: bool,
    /// How likely the state changes.
    pub goto_probability: f64,
    /// The state it then changes to, by place in [`Machine::states`].
    pub goto: u8,
    /// The variable it may set.
    pub set: Option<Setting>,
}

/// A variable that a rule may set.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Setting {
    /// By place in `VARIABLES`.
    pub variable: u8,
    /// The value it is given.
    pub value: bool,
    /// How likely.
    pub probability: f64,
}

impl Rule {
    /// A rule that never fires, to be filled.
    pub const EMPTY: Self =
        Self { from: 0, holding: 0, failing: 0, equals: true, goto_probability: 0.0, goto: 0, set: None };

    fn fits(&self, state: u8, holds: u32) -> bool {
        let as_wanted = holds & self.holding == self.holding && holds & self.failing == 0;
        self.from >> state & 1 == 1 && as_wanted == self.equals
    }
}

/// A machine and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// The behaviours it can be in: Explore, in which it starts, then the others in the order of the rules.
    pub states: Vec<Leaf>,
    /// The conditions that its rules test, in the order of the rules; none is negated.
    pub tests: Vec<Leaf>,
    /// In the order in which they are tried.
    pub rules: Vec<Rule>,
    /// The present state, by place in `states`.
    pub state: u8,
    /// The tests that held in the last step, with the variables as they are now.
    pub holds: u32,
    /// The step in which each rule last fired (0: never).
    pub fired: Vec<u32>,
    /// The last step (0: none).
    pub tick: u32,
    /// Whether the behaviour succeeded in it.
    pub succeeded: bool,
}

const START: Leaf = Leaf { name: Name::Explore, ..NO_LEAF };

impl Default for Machine {
    /// A machine without rules: it explores for ever.
    fn default() -> Self {
        Self {
            states: vec![START],
            tests: Vec::new(),
            rules: Vec::new(),
            state: 0,
            holds: 0,
            fired: Vec::new(),
            tick: 0,
            succeeded: false,
        }
    }
}

impl Machine {
    /// Forgets the rules, to be filled with others; keeps the memory.
    pub fn clear(&mut self) {
        self.states.truncate(1);
        self.tests.clear();
        self.rules.clear();
        self.restart();
    }

    /// Goes back to the first state, with both variables false, and forgets what happened.
    pub fn restart(&mut self) {
        (self.state, self.holds, self.tick, self.succeeded) = (0, 0, 0, false);
        self.fired.clear();
        self.fired.resize(self.rules.len(), 0);
    }

    /// The place of a state, which is added when it is new.
    pub fn state_of(&mut self, leaf: Leaf) -> u8 {
        place_of(&mut self.states, leaf)
    }

    /// The place of a test, which is added when it is new.
    pub fn test_of(&mut self, leaf: Leaf) -> u8 {
        place_of(&mut self.tests, leaf)
    }

    /// Makes one step.
    ///
    /// - `run`: runs a condition or a behaviour and says whether it succeeded.
    /// - `luck`: asked when a rule fires: first whether the state changes, then whether the variable is set.
    /// - `tick`: the number of the step, above 0.
    pub fn step(&mut self, mut run: impl FnMut(Leaf) -> bool, luck: &mut Stream, tick: u32) {
        let mut holds = self.holds & (variable_bit(0) | variable_bit(1));
        for (place, test) in self.tests.iter().enumerate() {
            holds |= u32::from(run(*test)) << place;
        }
        if let Some(at) = self.rules.iter().position(|rule| rule.fits(self.state, holds)) {
            let rule = &self.rules[at];
            if chance(luck, rule.goto_probability) {
                self.state = rule.goto;
            }
            if let Some(set) = rule.set
                && chance(luck, set.probability)
            {
                let bit = variable_bit(set.variable);
                holds = if set.value { holds | bit } else { holds & !bit };
            }
            self.fired[at] = tick;
        }
        self.holds = holds;
        self.tick = tick;
        self.succeeded = run(self.states[usize::from(self.state)]);
    }

    /// How many of its behaviours a machine can come to, whatever the tests say.
    #[must_use]
    pub fn reachable(&self) -> u32 {
        let mut reached = 1_u32;
        loop {
            let possible = |rule: &&Rule| rule.from & reached != 0 && rule.goto_probability > 0.0;
            let next = self.rules.iter().filter(possible).fold(reached, |set, rule| set | 1 << rule.goto);
            if next == reached {
                return reached.count_ones();
            }
            reached = next;
        }
    }

    /// A number that equal machines share and different ones, for all practical purposes, do not.
    #[must_use]
    pub fn id(&self) -> u64 {
        let mut hash = Fingerprint::default();
        hash.u32(self.states.len() as u32);
        self.states.iter().chain(&self.tests).for_each(|leaf| hash.u64(leaf.number()));
        for rule in &self.rules {
            hash.u64(u64::from(rule.from) | u64::from(rule.goto) << 32 | u64::from(rule.equals) << 40);
            hash.u64(u64::from(rule.holding) | u64::from(rule.failing) << 32);
            hash.f64(rule.goto_probability);
            if let Some(Setting { variable, value, probability }) = rule.set {
                hash.u64(u64::from(variable) | u64::from(value) << 8 | 1 << 16);
                hash.f64(probability);
            }
        }
        hash.finish()
    }

    /// Feeds where the machine stands.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(u32::from(self.state) | self.holds & (variable_bit(0) | variable_bit(1)));
    }

    /// The states in which a rule can fire.
    #[must_use]
    pub fn from(&self, rule: &Rule) -> Vec<String> {
        let mut names = Vec::new();
        for (place, leaf) in self.states.iter().enumerate() {
            if rule.from >> place & 1 == 1 {
                names.push(leaf.to_string());
            }
        }
        names
    }

    /// The tests of a rule in words, such as `not IsCarrying Food`; those of the variables are last.
    #[must_use]
    pub fn wanted(&self, rule: &Rule) -> Vec<String> {
        let mut words = Vec::new();
        for place in 0..u32::BITS as usize {
            let name = match self.tests.get(place) {
                Some(leaf) => leaf.to_string(),
                None if place >= 30 => VARIABLES[place - 30].to_owned(),
                None => continue,
            };
            if rule.failing >> place & 1 == 1 {
                words.push(format!("not {name}"));
            }
            if rule.holding >> place & 1 == 1 {
                words.push(name);
            }
        }
        words
    }

    /// What a rule sets, in words such as `X, true`, and how likely.
    #[must_use]
    pub fn setting(rule: &Rule) -> Option<(String, f64)> {
        let Setting { variable, value, probability } = rule.set?;
        Some((format!("{}, {value}", VARIABLES[usize::from(variable)]), probability))
    }

    /// A rule as grammars write it.
    #[must_use]
    pub fn rule_text(&self, rule: &Rule) -> String {
        let (from, wanted) = (self.from(rule).join(" "), self.wanted(rule).join(" "));
        let wanted = if wanted.is_empty() { "-" } else { &wanted };
        let (equals, goto) = (rule.equals, self.states[usize::from(rule.goto)]);
        let likely = decimal(rule.goto_probability);
        let set =
            Self::setting(rule).map(|(what, likely)| format!(" Set({what}, {})", decimal(likely))).unwrap_or_default();
        format!("From({from}) If({wanted} equals {equals}) Goto({likely}, {goto}){set}")
    }
}

impl fmt::Display for Machine {
    /// The rules in one line, as grammars write them.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, rule) in self.rules.iter().enumerate() {
            out.write_str(if at == 0 { "" } else { " " })?;
            out.write_str(&self.rule_text(rule))?;
        }
        Ok(())
    }
}

/// A probability with as many of its six decimals as it needs.
fn decimal(probability: f64) -> String {
    let millionths = (probability * 1e6 + 0.5) as u32;
    let digits = format!("{}.{:06}", millionths / 1_000_000, millionths % 1_000_000);
    digits.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn place_of(list: &mut Vec<Leaf>, leaf: Leaf) -> u8 {
    let found = list.iter().position(|other| *other == leaf);
    // At most 24 leaves are conditions and 15 actions.
    found.unwrap_or_else(|| {
        list.push(leaf);
        list.len() - 1
    }) as u8
}
