//! One run of a study, and how it stands in a results file.

use super::cells::COLUMNS;
use super::spec::{Study, VERSION};

/// What one run gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The number of the run.
    pub run: u32,
    /// The study's metrics in their order; `None` for what never came about, and for all of a failed run.
    pub metrics: Vec<Option<f64>>,
    /// The fingerprint of the last state, or why the run failed.
    pub end: Result<u64, String>,
}

impl Row {
    /// The row of a run that gave no numbers.
    ///
    /// - `reason`: what happened; a row is one line, so control characters become spaces.
    #[must_use]
    pub fn failed(study: &Study, run: u32, reason: &str) -> Self {
        let reason = reason.replace(|letter: char| letter.is_control(), " ");
        let reason = Some(reason.trim().to_owned()).filter(|reason| !reason.is_empty());
        let end = Err(reason.unwrap_or_else(|| "no reason was given".to_owned()));
        Self { run, metrics: vec![None; study.metrics.len()], end }
    }
}

/// The columns of a study's results, with what each cell has in all its rows.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The name of each cell and its factors.
    cells: Vec<Vec<String>>,
    pub hash: String,
}

impl Layout {
    pub fn of(study: &Study) -> Self {
        let [run, cell, seed, version, spec, fingerprint, reason] = COLUMNS.map(str::to_owned);
        let factors = study.factors();
        let of_cell = |at: usize| {
            let factors = factors.iter().map(|factor| study.factor(at, factor));
            [study.cells[at].name.clone()].into_iter().chain(factors).collect()
        };
        let cells = (0..study.cells.len()).map(of_cell).collect();
        let metrics = study.metrics.iter().map(|metric| metric.name().to_owned());
        let columns = [run, cell].into_iter().chain(factors).chain([seed]).chain(metrics);
        let columns = columns.chain([version, spec, fingerprint, reason]).collect();
        Self { columns, cells, hash: format!("{:016x}", study.hash()) }
    }

    /// The fields of a row, as many as there are columns.
    pub fn fields(&self, study: &Study, row: &Row) -> Vec<String> {
        let (cell, seed) = study.job(row.run);
        let mut fields = vec![row.run.to_string()];
        fields.extend(self.cells[cell].iter().cloned());
        fields.push(seed.to_string());
        fields.extend(row.metrics.iter().map(|value| value.map(|value| value.to_string()).unwrap_or_default()));
        fields.extend([VERSION.to_owned(), self.hash.clone()]);
        fields.extend(match &row.end {
            Ok(fingerprint) => [format!("{fingerprint:016x}"), String::new()],
            Err(reason) => [String::new(), reason.clone()],
        });
        fields
    }
}

/// One line of comma-separated values, with its line feed; quoted where needed, after RFC 4180.
pub(super) fn line(fields: &[String]) -> String {
    let quoted = fields.iter().map(|field| {
        if field.contains([',', '"']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field.clone() }
    });
    quoted.collect::<Vec<_>>().join(",") + "\n"
}

/// The fields of a line with their columns, counted in characters from 1; where and why it is none, otherwise.
pub(super) fn split(line: &str) -> Result<Vec<(u32, String)>, (u32, String)> {
    let mut fields = Vec::new();
    let mut letters = (1_u32..).zip(line.chars()).peekable();
    let mut last = 1;
    loop {
        let mut field = String::new();
        let begin = letters.peek().map_or(last, |letter| letter.0);
        let is_quoted = letters.next_if(|letter| letter.1 == '"').is_some();
        if is_quoted {
            loop {
                match letters.next() {
                    Some((_, '"')) if letters.next_if(|letter| letter.1 == '"').is_some() => field.push('"'),
                    Some((_, '"')) => break,
                    Some((_, letter)) => field.push(letter),
                    None => return Err((begin, "expected a closing quote, found the end of the line".to_owned())),
                }
            }
        } else {
            while let Some((at, letter)) = letters.next_if(|letter| letter.1 != ',') {
                if letter == '"' {
                    return Err((at, "expected a quote only around a whole field, found one within".to_owned()));
                }
                field.push(letter);
            }
        }
        fields.push((begin, field));
        match letters.next() {
            None => return Ok(fields),
            Some((at, ',')) => last = at + 1,
            Some((at, found)) => {
                return Err((at, format!("expected a comma after the closing quote, found '{found}'")));
            }
        }
    }
}
