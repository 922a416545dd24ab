//! The paper's claims beside what our studies found: the document on reproduction, made from results files.
//!
//! Claims are JSON, because they are data: which cell of which study stands for a sentence of the paper, and in which
//! profile. What is found is computed from the results each time; nothing is written by hand.

mod judge;

use super::fields::{Fields, StudyError, elements, entries, fault, name, one_of, text};
use super::metrics::Metric;
use super::report::table;
use super::results::Results;
use judge::{Judged, Verdict, judge};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// The claims of a paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Claims {
    title: String,
    about: String,
    list: Vec<Claim>,
}

#[derive(Clone, Debug, PartialEq)]
struct Claim {
    id: String,
    sentence: String,
    source: String,
    note: String,
    evidence: Vec<Evidence>,
}

/// What one study says of a claim in one profile.
#[derive(Clone, Debug, PartialEq)]
struct Evidence {
    /// Where in the file it stands, for messages.
    path: String,
    study: String,
    profile: String,
    metric: Metric,
    kind: Kind,
}

/// What is expected of the metric of one cell or two; cells by their names, or several together by a label's word.
#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// The paper's value.
    Equals(String, f64),
    /// Less than a value.
    Below(String, f64),
    /// More than a value.
    Above(String, f64),
    /// At most a value, in every single run.
    NeverAbove(String, f64),
    /// The first cell has more than the second.
    Greater(String, String),
    /// Both cells have one distribution, with means at most so far apart.
    Alike([String; 2], f64),
}

const MOST: usize = 200;
const RULES: &str = "How a verdict is found. **A value** is reproduced when it lies within the 95 % interval of ours (Wilson's \
    for shares of successes, Student's t for means) of at least 16 runs. **A bound** is reproduced when the whole interval lies on \
    its side. **A contrast** is reproduced when the test for it gives p below 0.05 (Fisher's exact test for successes, \
    the Mann-Whitney U test otherwise, one-sided); it is reversed when the opposite does. **A promise** is reproduced when none \
    of at least 16 runs breaks it. **A likeness** is reproduced when the means are as near as the table asks and an exact \
    Kolmogorov-Smirnov test gives p above 0.01. Anything else is open or not \
    reproduced, as the table says. p values are not corrected for the number of claims.";

impl Claims {
    /// Reads a claims file.
    ///
    /// # Errors
    /// One sentence with the path of the field; whether the cells exist shows only beside the results.
    pub fn read(json: &str) -> Result<Self, StudyError> {
        let value: Value = match serde_json::from_str(json) {
            Ok(value) => value,
            Err(error) => return fault("", format!("expected claims as JSON: {error}")),
        };
        let fields = Fields::of(&value, "", &["title", "about", "claims"])?;
        fields.need("claims", "a list of claims")?;
        let claims = fields.each("claims", MOST)?;
        Ok(Self {
            title: fields.text("title")?,
            about: fields.text("about")?,
            list: claims.into_iter().map(|(path, value)| read_claim(value, &path)).collect::<Result<_, _>>()?,
        })
    }

    /// The names of the studies whose results are asked for, each once.
    #[must_use]
    pub fn studies(&self) -> Vec<&str> {
        let all: BTreeSet<&str> = self.evidence().map(|evidence| evidence.study.as_str()).collect();
        all.into_iter().collect()
    }

    fn evidence(&self) -> impl Iterator<Item = &Evidence> {
        self.list.iter().flat_map(|claim| &claim.evidence)
    }

    /// The document, as Markdown.
    ///
    /// - `results`: by the names of their studies; a study without any is listed as not run.
    /// - `file`: where the claims stand, for the command that makes the document.
    ///
    /// # Errors
    /// A claim names a cell or a metric that its study does not have.
    pub fn document(&self, results: &BTreeMap<String, Results>, file: &str) -> Result<String, StudyError> {
        let judged: Vec<Vec<Judged>> = self
            .list
            .iter()
            .map(|claim| claim.evidence.iter().map(|evidence| judge(evidence, results)).collect())
            .collect::<Result<_, _>>()?;
        let mut parts = vec![format!("# {}", self.title)];
        parts.extend(Some(self.about.clone()).filter(|about| !about.is_empty()));
        parts.push(RULES.to_owned());
        parts.push(self.made_of(results, file));
        parts.push(format!("## At a glance\n\n{}", self.summary(&judged)));
        for (claim, judged) in self.list.iter().zip(&judged) {
            parts.push(format!("## {}: {}", claim.id, claim.sentence));
            parts.push(format!("Source: {}.", claim.source));
            parts.extend(Some(claim.note.clone()).filter(|note| !note.is_empty()));
            let columns = ["profile", "what", "paper", "ours", "95 % interval", "runs", "verdict", "study"];
            let rows: Vec<Vec<String>> =
                claim.evidence.iter().zip(judged).map(|(own, judged)| row(own, judged)).collect();
            parts.push(table(&columns, &rows));
        }
        Ok(parts.join("\n\n") + "\n")
    }

    /// Which studies, how much of each, and how to make them again.
    fn made_of(&self, results: &BTreeMap<String, Results>, file: &str) -> String {
        let rows: Vec<Vec<String>> = self
            .studies()
            .into_iter()
            .map(|name| match results.get(name) {
                None => vec![name.to_owned(), "not run".to_owned(), String::new(), String::new()],
                Some(results) => {
                    let study = results.study();
                    let cells = study.cells.len();
                    let seeds = results.rows().count() / cells;
                    let steps: BTreeSet<u32> = study.cells.iter().map(|cell| cell.scenario.world.steps()).collect();
                    let steps: Vec<String> = steps.iter().map(u32::to_string).collect();
                    let command = format!("study studies/{name}.json --seeds {seeds} --out results/{name}.csv");
                    vec![name.to_owned(), format!("{cells} x {seeds}"), steps.join(", "), format!("`{command}`")]
                }
            })
            .collect();
        let columns = ["study", "cells x seeds", "steps", "command, after `cargo run --release --`"];
        format!("{}\n\nThis document: `cargo run --release -- reproduction {file}`.", table(&columns, &rows))
    }

    /// One line a claim, one column a profile.
    fn summary(&self, judged: &[Vec<Judged>]) -> String {
        let mut profiles: Vec<&str> = Vec::new();
        for evidence in self.evidence() {
            if !profiles.contains(&evidence.profile.as_str()) {
                profiles.push(&evidence.profile);
            }
        }
        let rows: Vec<Vec<String>> = self
            .list
            .iter()
            .zip(judged)
            .map(|(claim, judged)| {
                let mut row = vec![format!("{}: {}", claim.id, claim.sentence)];
                row.extend(profiles.iter().map(|profile| {
                    let own = claim.evidence.iter().zip(judged).filter(|(evidence, _)| evidence.profile == *profile);
                    Verdict::of_all(&own.map(|(_, judged)| judged.verdict).collect::<Vec<_>>())
                }));
                row
            })
            .collect();
        let columns: Vec<&str> = std::iter::once("claim").chain(profiles.iter().copied()).collect();
        table(&columns, &rows)
    }
}

fn row(evidence: &Evidence, judged: &Judged) -> Vec<String> {
    let what = match &evidence.kind {
        Kind::Equals(cell, _) | Kind::Below(cell, _) | Kind::Above(cell, _) | Kind::NeverAbove(cell, _) => cell.clone(),
        Kind::Greater(first, second) => format!("{first} over {second}"),
        Kind::Alike([first, second], _) => format!("{first} like {second}"),
    };
    let metric = evidence.metric.label().to_lowercase();
    vec![
        evidence.profile.clone(),
        format!("{what}: {metric}"),
        judged.paper.clone(),
        judged.ours.clone(),
        judged.interval.clone(),
        judged.runs.clone(),
        judged.verdict.word().to_owned(),
        evidence.study.clone(),
    ]
}

fn read_claim(value: &Value, path: &str) -> Result<Claim, StudyError> {
    let fields = Fields::of(value, path, &["id", "claim", "source", "note", "evidence"])?;
    fields.need("evidence", "a list of evidence")?;
    let evidence = fields.each("evidence", MOST)?;
    Ok(Claim {
        id: name(fields.need("id", "a short name")?, &fields.at("id"))?,
        sentence: text(fields.need("claim", "a sentence")?, &fields.at("claim"))?,
        source: text(fields.need("source", "paper and section")?, &fields.at("source"))?,
        note: fields.text("note")?,
        evidence: evidence.into_iter().map(|(path, value)| read_evidence(value, path)).collect::<Result<_, _>>()?,
    })
}

fn read_evidence(value: &Value, path: String) -> Result<Evidence, StudyError> {
    const KINDS: [&str; 6] = ["equals", "below", "above", "greater", "never_above", "alike"];
    let known: Vec<&str> = ["study", "profile", "metric", "within"].into_iter().chain(KINDS).collect();
    let fields = Fields::of(value, &path, &known)?;
    let given: Vec<&str> = KINDS.into_iter().filter(|kind| fields.get(kind).is_some()).collect();
    let [kind] = given[..] else {
        return fault(path, format!("expected one of {}, found {}", KINDS.join(", "), given.len()));
    };
    let (at, expected) = (fields.at(kind), fields.need(kind, "what is expected")?);
    if kind != "alike" && fields.get("within").is_some() {
        return fault(fields.at("within"), "expected no such field: it says how near means are that are alike");
    }
    let kind = if ["greater", "alike"].contains(&kind) {
        let cells = elements(expected, &at, 2)?;
        let [(first_at, first), (second_at, second)] = &cells[..] else {
            return fault(at, "expected two cells, found one");
        };
        let (first, second) = (name(first, first_at)?, name(second, second_at)?);
        if kind == "greater" {
            Kind::Greater(first, second)
        } else {
            let within = fields.need("within", "how far the means may be apart")?;
            let positive = within.as_f64().filter(|within| *within >= 0.0);
            let Some(within) = positive else {
                let found = crate::parameter::shown(within);
                return fault(fields.at("within"), format!("expected a number of at least 0, found {found}"));
            };
            Kind::Alike([first, second], within)
        }
    } else {
        let all = entries(expected, &at)?;
        let [(own, value)] = all[..] else {
            return fault(at, format!("expected one cell with its value, found {}", all.len()));
        };
        let Some(number) = value.as_f64() else {
            return fault(
                format!("{at}.{own}"),
                format!("expected a number, found {}", crate::parameter::shown(value)),
            );
        };
        let own = own.to_owned();
        match kind {
            "equals" => Kind::Equals(own, number),
            "below" => Kind::Below(own, number),
            "never_above" => Kind::NeverAbove(own, number),
            _ => Kind::Above(own, number),
        }
    };
    let study = name(fields.need("study", "the name of a study")?, &fields.at("study"))?;
    let profile = name(fields.need("profile", "the name of a setting")?, &fields.at("profile"))?;
    let metric = *one_of(fields.need("metric", "a metric")?, &fields.at("metric"), &Metric::all())?;
    Ok(Evidence { path, study, profile, metric, kind })
}
