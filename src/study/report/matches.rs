//! Matches of two teams: who won, how many goals fell, and whether one team is better, in the form of the paper's tables.
//!
//! Cells that differ in nothing but the sides are one pairing: their matches are counted together, and the two matches of
//! a seed are a pair, in which each team had the luck of each side once.
//!
//! Source: Haug et al. 2024, section 6.2, tables 1 and 2. The paper prints the one-sided p of its test beside a null
//! hypothesis that calls for the two-sided one; both stand here. Interval, effect, sign test and pairs are our additions.

use super::Section;
use super::words::number;
use crate::soccer::tournament::{Game, Standing, Table};
use crate::study::matches::PaperMatches;
use crate::study::metrics::{Metric, Soccer};
use crate::study::results::Results;
use crate::study::statistics::{Estimate, Summary, Z95, mean_interval, one_sample_t, sign_test, wilson};
use serde_json::Value;
use std::collections::BTreeMap;

const ENDS: &str =
    "Who scored more in a match, goals of a shoot-out left out, with Wilson's 95 % interval of each share.";
const GOALS: &str = "GPG: goals per game; GDPG: goal difference per game, for each team its own. Means stand with Student's \
    95 % interval.";
const DIFFERENCE: &str = "Whether blue's goal difference per game is 0 in the mean: a one-sample t-test, with one tail \
    (blue is better) and with both tails, d the mean over the standard deviation with its 95 % interval, and a sign test \
    of the decided games, both tails. A pair is the two matches of one seed, with the sides exchanged; its value is the \
    mean of both.";
const BESIDE: &str = "Who scored more in a match, goals of a shoot-out left out, with Wilson's 95 % interval of each share. \
    \"Reproduced\", here and in the next table, means that the paper's value lies within the 95 % interval of ours of at least 16 \
    matches.";
const TABLE: &str = "All games of the study. Pts: three for a victory, one for a tie; GP: games played; GS, GC, GD: goals scored, \
    conceded, and their difference. Equal points go by difference, goals scored, and the games among the equal.";
const ENOUGH: usize = 16;

/// Two teams and their matches, in the order of the runs.
struct Pairing {
    name: String,
    /// The teams of blue and yellow.
    teams: [String; 2],
    /// All parameters but teams and sides.
    settings: Value,
    /// Cells by their places.
    cells: Vec<usize>,
    /// Goals of blue and yellow.
    goals: Vec<[f64; 2]>,
    /// Mean goal differences of the seeds that were played with both sides; `None` where sides are not exchanged.
    pairs: Option<Vec<f64>>,
}

impl Pairing {
    fn differences(&self) -> Vec<f64> {
        self.goals.iter().map(|[ours, theirs]| ours - theirs).collect()
    }

    /// Matches that blue won, that nobody won, and that yellow won.
    fn ends(&self) -> [u32; 3] {
        let count = |is: fn(f64) -> bool| self.differences().into_iter().filter(|&gap| is(gap)).count() as u32;
        [count(|gap| gap > 0.0), count(|gap| gap == 0.0), count(|gap| gap < 0.0)]
    }
}

/// The sections, if both teams' goals are measured and there is a match.
pub fn sections(results: &Results) -> Vec<Section> {
    let pairings = pairings(results);
    if pairings.is_empty() {
        return Vec::new();
    }
    let paper = results.study().matches.as_ref();
    let own = [ends(&pairings, paper), goals(&pairings, paper), difference(&pairings, paper)];
    own.into_iter().chain(standings(&pairings)).collect()
}

/// The table of a tournament, where three teams or more play with the same settings.
fn standings(pairings: &[Pairing]) -> Option<Section> {
    let mut names: Vec<String> = Vec::new();
    for team in pairings.iter().flat_map(|pairing| &pairing.teams) {
        if !names.contains(team) {
            names.push(team.clone());
        }
    }
    if names.len() < 3 || pairings.iter().any(|pairing| pairing.settings != pairings[0].settings) {
        return None;
    }
    let games = pairings.iter().flat_map(|pairing| {
        pairing.goals.iter().map(|goals| Game { teams: pairing.teams.clone(), goals: goals.map(|goals| goals as u32) })
    });
    let table = Table::of(&names, &games.collect::<Vec<_>>()).ok()?;
    let row = |row: &Standing| {
        let numbers = [row.points, row.played, row.won, row.tied, row.lost, row.scored, row.conceded];
        let words = [row.team.clone()].into_iter().chain(numbers.map(|number| number.to_string()));
        words.chain([row.difference().to_string()]).collect()
    };
    let columns = vec!["Team", "Pts", "GP", "Vic", "Tie", "Def", "GS", "GC", "GD"];
    let rows = table.rows().iter().map(row).collect();
    Some(Section { name: "matches-table", title: "Final table", note: TABLE, columns, rows })
}

fn pairings(results: &Results) -> Vec<Pairing> {
    let study = results.study();
    let place = |wanted: Soccer| study.metrics.iter().position(|metric| *metric == Metric::Soccer(wanted));
    let Some((ours, theirs)) = place(Soccer::GoalsBlue).zip(place(Soccer::GoalsYellow)) else { return Vec::new() };
    let mut found: Vec<(Value, Pairing)> = Vec::new();
    for (at, cell) in study.cells.iter().enumerate() {
        let mut key = cell.scenario.to_value();
        let team = |colour: &str| key[colour].as_str().unwrap_or_default().to_owned();
        let teams = [team("blue"), team("yellow")];
        for field in ["sides-exchanged", "title", "about", "seed"] {
            key[field] = Value::Null;
        }
        if let Some((_, pairing)) = found.iter_mut().find(|(other, _)| *other == key) {
            pairing.cells.push(at);
            continue;
        }
        let words = cell.name.split(", ").filter(|word| !word.starts_with("sides-exchanged "));
        let name = words.collect::<Vec<_>>().join(", ");
        let name = if name.is_empty() { study.name.clone() } else { name };
        let mut settings = key.clone();
        for field in ["blue", "yellow"] {
            settings[field] = Value::Null;
        }
        found.push((key, Pairing { name, teams, settings, cells: vec![at], goals: Vec::new(), pairs: None }));
    }
    let mut pairings: Vec<Pairing> = found.into_iter().map(|(_, pairing)| pairing).collect();
    for pairing in &mut pairings {
        let mut of_seeds: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
        for row in results.rows() {
            let (cell, seed) = study.job(row.run);
            let goals = row.metrics[ours].zip(row.metrics[theirs]).filter(|_| pairing.cells.contains(&cell));
            let Some((blue, yellow)) = goals else { continue };
            pairing.goals.push([blue, yellow]);
            of_seeds.entry(seed).or_default().push(blue - yellow);
        }
        let sides = |cell: &usize| study.cells[*cell].scenario.to_value()["sides-exchanged"].clone();
        if let [one, other] = &pairing.cells[..]
            && sides(one) != sides(other)
        {
            let both = of_seeds.values().filter(|gaps| gaps.len() == 2);
            pairing.pairs = Some(both.map(|gaps| f64::midpoint(gaps[0], gaps[1])).collect());
        }
    }
    pairings.retain(|pairing| !pairing.goals.is_empty());
    pairings
}

fn per_cent(share: f64) -> String {
    format!("{:.2} %", share * 100.0)
}

fn with_interval(estimate: &Estimate, word: fn(f64) -> String) -> String {
    format!("{} ({} to {})", word(estimate.value), word(estimate.low), word(estimate.high))
}

/// Whether the paper's value lies within our interval, with the gap.
fn verdict(ours: Option<&Estimate>, paper: f64, games: usize, gap: impl Fn(f64) -> String) -> String {
    let Some(ours) = ours else { return "open".to_owned() };
    let word = match (ours.holds(paper), games >= ENOUGH) {
        (_, false) => "open",
        (true, true) => "reproduced",
        (false, true) => "not reproduced",
    };
    format!("{word} ({})", gap(ours.value - paper))
}

/// A p value with as many digits as the paper's.
fn p(value: f64) -> String {
    if value < 0.0001 { format!("{value:.1e}") } else { format!("{value:.5}") }
}

fn signed(value: f64) -> String {
    format!("{}{value:.3}", if value > 0.0 { "+" } else { "" })
}

fn ends(pairings: &[Pairing], paper: Option<&PaperMatches>) -> Section {
    let columns = vec!["match", "games", "wins", "ties", "losses", "wins of blue", "ties of all", "wins of yellow"];
    let mut rows = Vec::new();
    for pairing in pairings {
        let (counts, all) = (pairing.ends(), pairing.goals.len());
        let mut row = vec![pairing.name.clone(), all.to_string()];
        row.extend(counts.map(|count| count.to_string()));
        row.extend(counts.map(|count| with_interval(&wilson(count, all as u32), per_cent)));
        rows.push(row);
    }
    if let Some(paper) = paper {
        let share = |count: u32| f64::from(count) / f64::from(paper.games());
        let mut row = vec![paper.source.clone(), paper.games().to_string()];
        row.extend(paper.ends.map(|count| count.to_string()));
        row.extend(paper.ends.map(|count| per_cent(share(count))));
        rows.push(row);
        for pairing in pairings {
            let mut row = vec![format!("{} beside the paper", pairing.name)];
            row.resize(5, String::new());
            let points = |gap: f64| format!("{}{:.1} points", if gap > 0.0 { "+" } else { "" }, gap * 100.0);
            let all = pairing.goals.len();
            row.extend(
                pairing
                    .ends()
                    .into_iter()
                    .zip(paper.ends)
                    .map(|(ours, theirs)| verdict(Some(&wilson(ours, all as u32)), share(theirs), all, points)),
            );
            rows.push(row);
        }
    }
    let note = if paper.is_some() { BESIDE } else { ENDS };
    Section { name: "matches-ends", title: "Wins, ties and losses", note, columns, rows }
}

fn goals(pairings: &[Pairing], paper: Option<&PaperMatches>) -> Section {
    let mut columns = vec!["match", "team", "goals", "most in a game", "GPG", "GPG, sd", "GDPG", "GDPG, sd"];
    if paper.is_some() {
        columns.extend(["GPG beside the paper", "GDPG beside the paper"]);
    }
    let mut rows = Vec::new();
    for pairing in pairings {
        for (at, (colour, sign)) in [("blue", 1.0), ("yellow", -1.0)].into_iter().enumerate() {
            let scored: Vec<f64> = pairing.goals.iter().map(|goals| goals[at]).collect();
            let gaps: Vec<f64> = pairing.goals.iter().map(|goals| goals[at] - goals[1 - at]).collect();
            let Some((own, gap)) = Summary::of(&scored).zip(Summary::of(&gaps)) else { continue };
            let mean = |summary: &Summary| match mean_interval(summary) {
                Some(estimate) => with_interval(&estimate, |value| format!("{value:.3}")),
                None => format!("{:.3}", summary.mean),
            };
            let deviation = |summary: &Summary| match summary.count {
                1 => String::new(),
                _ => format!("{:.4}", summary.deviation),
            };
            let mut row = vec![pairing.name.clone(), format!("{colour}: {}", pairing.teams[at])];
            row.extend([number(scored.iter().sum()), number(own.greatest), mean(&own), deviation(&own)]);
            row.extend([mean(&gap), deviation(&gap)]);
            if let Some(paper) = paper {
                let beside = |summary: &Summary, value: f64| {
                    verdict(mean_interval(summary).as_ref(), value, pairing.goals.len(), signed)
                };
                row.extend([beside(&own, paper.means()[at]), beside(&gap, sign * paper.difference[0])]);
            }
            rows.push(row);
        }
    }
    if let Some(paper) = paper {
        for (at, (colour, sign)) in [("blue", 1.0), ("yellow", -1.0)].into_iter().enumerate() {
            let mut row = vec![paper.source.clone(), colour.to_owned()];
            row.extend([paper.goals[at].to_string(), paper.most[at].to_string()]);
            row.extend([format!("{:.4}", paper.means()[at]), format!("{:.4}", paper.deviations[at])]);
            row.extend([format!("{:.4}", sign * paper.difference[0]), format!("{:.4}", paper.difference[1])]);
            row.resize(columns.len(), String::new());
            rows.push(row);
        }
    }
    Section { name: "matches-goals", title: "Goals per game and goal difference", note: GOALS, columns, rows }
}

fn difference(pairings: &[Pairing], paper: Option<&PaperMatches>) -> Section {
    let columns = vec![
        "match",
        "what",
        "n",
        "mean",
        "sd",
        "95 % interval",
        "t",
        "df",
        "p, one tail",
        "p, both tails",
        "d (95 % interval)",
        "decided",
        "for blue",
        "p of signs",
    ];
    let mut rows = Vec::new();
    for pairing in pairings {
        let gaps = pairing.differences();
        let mut add = |what: &str, values: &[f64]| {
            let count = |is: fn(f64) -> bool| values.iter().filter(|&&gap| is(gap)).count() as u32;
            let signs = [count(|gap| gap > 0.0), count(|gap| gap < 0.0)];
            rows.extend(Summary::of(values).map(|summary| tested(&pairing.name, what, &summary, signs)));
        };
        add("games", &gaps);
        if let Some(pairs) = &pairing.pairs {
            add("pairs of a seed", pairs);
        }
    }
    if let Some(paper) = paper {
        let [mean, deviation] = paper.difference;
        // Only count, mean and deviation are known; the test asks for no more.
        let none =
            Summary { count: 0, mean, deviation, least: mean, lower: mean, median: mean, upper: mean, greatest: mean };
        let summary = Summary { count: paper.games() as usize, ..none };
        let [wins, _, losses] = paper.ends;
        rows.push(tested(&paper.source, "games", &summary, [wins, losses]));
    }
    Section { name: "matches-difference", title: "Is blue better", note: DIFFERENCE, columns, rows }
}

/// One row of the test.
///
/// - `signs`: how many values are above 0, and how many below.
fn tested(name: &str, what: &str, summary: &Summary, [more, less]: [u32; 2]) -> Vec<String> {
    let real = |value: f64| format!("{value:.4}");
    let mut row = vec![name.to_owned(), what.to_owned(), summary.count.to_string(), real(summary.mean)];
    row.push(if summary.count > 1 { real(summary.deviation) } else { String::new() });
    row.push(mean_interval(summary).map(|all| format!("{:.3} to {:.3}", all.low, all.high)).unwrap_or_default());
    match one_sample_t(summary, 0.0) {
        None => row.extend(["", "", "", "", ""].map(str::to_owned)),
        Some(test) => {
            let n = summary.count as f64;
            let d = summary.mean / summary.deviation;
            // The normal interval of Hedges and Olkin (1985).
            let half = Z95 * (1.0 / n + d * d / (2.0 * n)).sqrt();
            row.extend([number(test.t), number(test.freedom), p(test.p.greater), p(test.p.two_sided)]);
            row.push(format!("{d:.2} ({:.2} to {:.2})", d - half, d + half));
        }
    }
    row.extend([(more + less).to_string(), more.to_string(), p(sign_test(more, less).two_sided)]);
    row
}
