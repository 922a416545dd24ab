//! What a paper says of its matches: not means of cells, but what its tables count.

use super::fields::{Fields, StudyError, elements, fault, text};
use super::metrics::Metric;
use crate::parameter::shown;
use serde_json::{Value, json};

/// The matches of a paper. Pairs are of the team that stands for our blue one, and of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct PaperMatches {
    /// Paper and tables, in words.
    pub source: String,
    /// Matches that blue won, that nobody won, and that yellow won.
    pub ends: [u32; 3],
    /// All goals.
    pub goals: [u32; 2],
    /// The most goals in one match.
    pub most: [u32; 2],
    /// Standard deviations of the goals per match.
    pub deviations: [f64; 2],
    /// Mean and standard deviation of blue's goal difference per match.
    pub difference: [f64; 2],
}

impl PaperMatches {
    /// How many there were.
    #[must_use]
    pub fn games(&self) -> u32 {
        self.ends.iter().sum()
    }

    /// Goals per match.
    #[must_use]
    pub fn means(&self) -> [f64; 2] {
        self.goals.map(|goals| f64::from(goals) / f64::from(self.games()))
    }

    pub(super) fn to_value(&self) -> Value {
        let Self { source, ends: [wins, ties, losses], goals, most, deviations, difference } = self;
        json!({"source": source, "wins": wins, "ties": ties, "losses": losses, "goals": goals, "most": most,
            "deviations": deviations, "difference": difference})
    }
}

const MOST: u64 = 1_000_000;

/// Reads `matches`, which needs the goals of both teams among the metrics.
pub(super) fn read_matches(fields: &Fields, metrics: &[Metric]) -> Result<Option<PaperMatches>, StudyError> {
    let Some(value) = fields.get("matches") else { return Ok(None) };
    for name in ["goals_blue", "goals_yellow"] {
        if !metrics.iter().any(|metric| metric.name() == name) {
            return fault("matches", format!("expected \"{name}\" among the metrics, found no such one"));
        }
    }
    let known = ["source", "wins", "ties", "losses", "goals", "most", "deviations", "difference"];
    let fields = Fields::of(value, "matches", &known)?;
    let count = |name: &str| {
        let count = fields.whole(name, 0..=MOST)?;
        count.map_or_else(|| fault(fields.at(name), "expected a whole number, found no such field"), |n| Ok(n as u32))
    };
    let pair = |name: &str| {
        let path = fields.at(name);
        let list = elements(fields.need(name, "a list of two numbers")?, &path, 2)?;
        let [first, second] = &list[..] else { return fault(path, "expected two numbers, found one") };
        let real = |(path, value): &(String, &Value)| match value.as_f64() {
            Some(real) => Ok(real),
            None => fault(path, format!("expected a number, found {}", shown(value))),
        };
        Ok([real(first)?, real(second)?])
    };
    let counts = |name: &str| {
        let [first, second] = pair(name)?;
        let whole = |real: f64| real >= 0.0 && real <= MOST as f64 && real % 1.0 == 0.0;
        if whole(first) && whole(second) {
            return Ok([first as u32, second as u32]);
        }
        fault(fields.at(name), format!("expected two whole numbers from 0 to {MOST}, found {first} and {second}"))
    };
    let matches = PaperMatches {
        source: text(fields.need("source", "paper and tables in words")?, &fields.at("source"))?,
        ends: [count("wins")?, count("ties")?, count("losses")?],
        goals: counts("goals")?,
        most: counts("most")?,
        deviations: pair("deviations")?,
        difference: pair("difference")?,
    };
    if matches.games() == 0 {
        return fault("matches.wins", "expected at least one match, found none");
    }
    Ok(Some(matches))
}
