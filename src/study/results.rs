//! The results file of a study: read strictly, continued, and written in the order of the runs.

use super::metrics::Form;
use super::row::{Layout, Row, line, split};
use super::spec::{Study, VERSION};
use crate::place::Place;
use std::collections::BTreeMap;
use std::fmt;

/// Why a text is no results file of a study.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResultsError {
    place: Place,
    message: String,
}

impl ResultsError {
    /// Where the fault lies.
    #[must_use]
    pub fn place(&self) -> Place {
        self.place
    }
}

impl fmt::Display for ResultsError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.place, self.message)
    }
}

impl std::error::Error for ResultsError {}

/// The results of a study, as far as there are any.
///
/// In a file, rows may stand in any order, and the header may come again: runs that go on at once write as they end, and
/// files of shards may be put one after the other. [`Results::text`] has the rows in the order of the runs.
#[derive(Clone, Debug)]
pub struct Results {
    study: Study,
    layout: Layout,
    rows: BTreeMap<u32, Row>,
}

impl Results {
    /// No results yet.
    #[must_use]
    pub fn new(study: Study) -> Self {
        Self { layout: Layout::of(&study), study, rows: BTreeMap::new() }
    }

    /// Reads a file; also returns how many of its bytes are whole lines. What follows them is a line that was cut short
    /// when its writer was killed, and is left out.
    ///
    /// # Errors
    /// The first fault with line and column: another study, version or seed, a field that is not written as
    /// [`Results::line`] writes it, a run that comes twice. Runs with later seeds than the study asks for are no fault:
    /// they are kept.
    pub fn read(study: Study, bytes: &[u8]) -> Result<(Self, usize), ResultsError> {
        let mut results = Self::new(study);
        let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        let header = results.header();
        if whole == 0 && !header.as_bytes().starts_with(bytes) {
            let expected = format!("expected the columns {}, found another text", header.trim_end());
            return Err(ResultsError { place: Place { line: 1, column: 1 }, message: expected });
        }
        let text = std::str::from_utf8(&bytes[..whole]).map_err(|error| {
            let before = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
            let column = before.rsplit('\n').next().map_or(0, |line| line.chars().count());
            let place = Place { line: before.matches('\n').count() as u32 + 1, column: column as u32 + 1 };
            ResultsError { place, message: "expected text in UTF-8, found other bytes".to_owned() }
        })?;
        let mut lines = BTreeMap::new();
        for (number, line) in (1_u32..).zip(text.split_terminator('\n')) {
            let at = |(column, message)| ResultsError { place: Place { line: number, column }, message };
            let fields = split(line).map_err(at)?;
            if number == 1 {
                results.check_header(&fields).map_err(at)?;
            } else if line != header.trim_end() {
                let row = results.read_row(&fields).map_err(at)?;
                if let Some(first) = lines.insert(row.run, number) {
                    let message = format!("expected each run once, found run {} of line {first} again", row.run);
                    return Err(at((1, message)));
                }
                results.rows.insert(row.run, row);
            }
        }
        Ok((results, whole))
    }

    /// The study.
    #[must_use]
    pub fn study(&self) -> &Study {
        &self.study
    }

    /// The rows, in the order of the runs.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.rows.values()
    }

    /// The row of a run, if it is there.
    #[must_use]
    pub fn row_of(&self, run: u32) -> Option<&Row> {
        self.rows.get(&run)
    }

    /// Takes in a row; one that is there already stays.
    pub fn add(&mut self, row: Row) {
        self.rows.entry(row.run).or_insert(row);
    }

    /// The runs that have no row yet.
    #[must_use]
    pub fn missing(&self) -> Vec<u32> {
        (0..self.study.run_count()).filter(|run| !self.rows.contains_key(run)).collect()
    }

    /// The line of the columns' names, with its line feed.
    #[must_use]
    pub fn header(&self) -> String {
        line(&self.layout.columns)
    }

    /// The line of a row, with its line feed.
    #[must_use]
    pub fn line(&self, row: &Row) -> String {
        line(&self.layout.fields(&self.study, row))
    }

    /// The whole file, with the rows in the order of the runs.
    #[must_use]
    pub fn text(&self) -> String {
        self.rows().fold(self.header(), |text, row| text + &self.line(row))
    }

    fn check_header(&self, found: &[(u32, String)]) -> Result<(), (u32, String)> {
        for (column, expected) in self.layout.columns.iter().enumerate() {
            match found.get(column) {
                Some((_, name)) if name == expected => {}
                Some((at, name)) => return Err((*at, format!("expected the column \"{expected}\", found \"{name}\""))),
                None => {
                    let end = found.last().map_or(1, |last| last.0);
                    return Err((end, format!("expected the column \"{expected}\" after this one, found no more")));
                }
            }
        }
        match found.get(self.layout.columns.len()) {
            Some((at, name)) => Err((*at, format!("expected no further column, found \"{name}\""))),
            None => Ok(()),
        }
    }

    /// Reads a row: what it says of metrics and end, and then that all else is what the study says.
    fn read_row(&self, found: &[(u32, String)]) -> Result<Row, (u32, String)> {
        let columns = &self.layout.columns;
        if found.len() != columns.len() {
            return Err((1, format!("expected {} fields, found {}", columns.len(), found.len())));
        }
        let count = columns.len();
        let [version, spec, fingerprint, reason] = [4, 3, 2, 1].map(|back| &found[count - back]);
        if version.1 != VERSION {
            return Err((version.0, format!("expected results of version {VERSION}, found version {}", version.1)));
        }
        let hash = &self.layout.hash;
        if spec.1 != *hash {
            return Err((spec.0, format!("expected results of the study with hash {hash}, found {}", spec.1)));
        }
        let most = self.study.most_runs() - 1;
        let run = found[0].1.parse::<u32>().ok().filter(|run| *run <= most);
        let Some(run) = run else {
            return Err((1, format!("expected a run from 0 to {most}, found \"{}\"", found[0].1)));
        };
        let end = match (u64::from_str_radix(&fingerprint.1, 16), fingerprint.1.is_empty(), reason.1.is_empty()) {
            (Ok(fingerprint), false, true) => Ok(fingerprint),
            (_, true, false) => Err(reason.1.clone()),
            _ => return Err((fingerprint.0, "expected either a fingerprint or a reason".to_owned())),
        };
        let first = count - 4 - self.study.metrics.len();
        let mut metrics = Vec::new();
        for ((at, text), metric) in found[first..].iter().zip(&self.study.metrics) {
            let value = match text.parse::<f64>() {
                _ if text.is_empty() => None,
                Ok(value) if value.is_finite() && end.is_ok() => Some(value),
                _ if end.is_err() => return Err((*at, format!("expected nothing in a failed run, found \"{text}\""))),
                _ => return Err((*at, format!("expected a number or nothing, found \"{text}\""))),
            };
            if metric.form() == Form::Flag && !["", "0", "1"].contains(&text.as_str()) {
                return Err((*at, format!("expected 0 or 1, found \"{text}\"")));
            }
            metrics.push(value);
        }
        let row = Row { run, metrics, end };
        for (((at, found), expected), column) in found.iter().zip(self.layout.fields(&self.study, &row)).zip(columns) {
            if *found != expected {
                return Err((*at, format!("expected {column} {expected} in run {run}, found \"{found}\"")));
            }
        }
        Ok(row)
    }
}
