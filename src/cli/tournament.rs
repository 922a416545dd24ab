//! `tournament`: everyone against everyone, and the table.

use super::study::replace;
use super::{Failure, in_file, print, read_file};
use clap::Args;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::Value;
use std::path::{Path, PathBuf};
use swarm_playground::random::Seed;
use swarm_playground::scenario::{Outcome, Run, Scenario};
use swarm_playground::soccer::ironcup;
use swarm_playground::soccer::team::TeamKind;
use swarm_playground::soccer::tournament::{Balance, Game, Standing, Table, pairings};
use swarm_playground::study::VERSION;

/// Arguments of `tournament`.
#[derive(Args)]
pub struct TournamentArguments {
    /// The match that is played, a scenario file; its teams and sides do not count
    #[arg(default_value = "scenarios/match.json")]
    scenario: PathBuf,
    /// The teams: words of the parameter soccer.blue, or NAME=FILE for a coach tree of your own [default: all words]
    #[arg(long, value_delimiter = ',')]
    teams: Vec<String>,
    /// How often everyone plays everyone; colours and sides are exchanged from round to round
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Use this seed for the first match in place of the scenario's; every match has the next one
    #[arg(long)]
    seed: Option<u64>,
    /// Matches that go on at once [default: one for each processor]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Set a parameter of every match, such as soccer.half-seconds=60; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Also write every game into this file, as comma-separated values
    #[arg(long)]
    out: Option<PathBuf>,
    /// Also print the table of the IRONCup 2023 as the paper has it
    #[arg(long)]
    paper: bool,
}

/// A team that takes part.
struct Entrant {
    name: String,
    kind: TeamKind,
    /// Its coach tree; empty for the built-in one.
    coach: String,
}

/// A match to be played.
struct Fixture {
    round: u32,
    seed: u64,
    /// Blue and yellow, by their places.
    teams: [usize; 2],
    scenario: Scenario,
}

const MOST_TEAMS: usize = 64;

/// Plays the tournament and prints games and table.
pub fn tournament(arguments: &TournamentArguments) -> Result<(), Failure> {
    let entrants = entrants(&arguments.teams)?;
    let fixtures = fixtures(arguments, &entrants)?;
    let threads = rayon::ThreadPoolBuilder::new().num_threads(arguments.jobs.map_or(0, usize::from)).build();
    let threads = threads.map_err(|error| Failure::Input(format!("--jobs: {error}")))?;
    // In the order of the fixtures, however many are played at once.
    let played: Result<Vec<_>, Failure> = threads.install(|| fixtures.par_iter().map(play).collect());
    let played = played?;
    let names: Vec<String> = entrants.iter().map(|entrant| entrant.name.clone()).collect();
    let games: Vec<Game> = fixtures
        .iter()
        .zip(&played)
        .map(|(fixture, (goals, _))| Game { teams: fixture.teams.map(|team| names[team].clone()), goals: *goals })
        .collect();
    let table = Table::of(&names, &games).map_err(|error| Failure::Input(error.to_string()))?;
    if let Some(path) = &arguments.out {
        replace(path, &rows(&fixtures, &games, &played))?;
    }
    print("| round | blue team | goals | | goals | yellow team |\n|---:|---|---:|:-:|---:|---|")?;
    for (Fixture { round, .. }, Game { teams: [blue, yellow], goals: [ours, theirs] }) in fixtures.iter().zip(&games) {
        print(&format!("| {} | {blue} | {ours} | x | {theirs} | {yellow} |", round + 1))?;
    }
    print("")?;
    print_table(table.rows(), true)?;
    let Balance { scored, conceded } = table.balance();
    print(&format!("\n{} games of {}; goals scored {scored}, conceded {conceded}.", games.len(), entrants.len()))?;
    if arguments.paper { paper() } else { Ok(()) }
}

fn refused<T>(message: &str) -> Result<T, Failure> {
    Err(Failure::Input(format!("--teams: {message}")))
}

fn kinds() -> Vec<String> {
    TeamKind::ALL.iter().map(|kind| kind.text().to_owned()).collect()
}

/// A team of the playground, or a coach tree of the user's.
fn entrant(word: &str) -> Result<Entrant, Failure> {
    if let Some((name, file)) = word.split_once('=') {
        let coach = read_file(Path::new(file))?;
        return Ok(Entrant { name: name.trim().to_owned(), kind: TeamKind::Tree, coach });
    }
    if let Some(kind) = TeamKind::from_text(word) {
        return Ok(Entrant { name: word.to_owned(), kind, coach: String::new() });
    }
    let all = kinds().join(", ");
    refused(&format!("expected {all}, or NAME=FILE with a coach tree, found \"{word}\""))
}

fn entrants(words: &[String]) -> Result<Vec<Entrant>, Failure> {
    let mut entrants: Vec<Entrant> = Vec::new();
    for word in if words.is_empty() { kinds() } else { words.to_vec() } {
        let entrant = entrant(&word)?;
        if entrant.name.is_empty() || entrant.name.contains(|letter: char| letter.is_control() || letter == '|') {
            return refused(&format!("expected a name of one line without \"|\", found \"{}\"", entrant.name));
        }
        if entrants.iter().any(|other| other.name == entrant.name) {
            return refused(&format!("expected each team once, found \"{}\" twice", entrant.name));
        }
        entrants.push(entrant);
    }
    if !(2..=MOST_TEAMS).contains(&entrants.len()) {
        return refused(&format!("expected 2 to {MOST_TEAMS} teams, found {}", entrants.len()));
    }
    Ok(entrants)
}

/// Every match of every round, with its scenario checked before the first one is played.
fn fixtures(arguments: &TournamentArguments, entrants: &[Entrant]) -> Result<Vec<Fixture>, Failure> {
    let mut changes = super::run::changes(&arguments.set)?;
    changes.push(("seed", arguments.seed.map(Value::from)));
    let base = super::run::read_scenario(&arguments.scenario, &changes)?;
    if base.world.name() != "soccer" {
        let message = format!("world: expected \"soccer\", found \"{}\"", base.world.name());
        return Err(in_file(&arguments.scenario, &message));
    }
    let mut fixtures = Vec::new();
    for round in 0..arguments.rounds {
        for teams in pairings(entrants.len(), round) {
            let seed = base.seed.value() + fixtures.len() as u64;
            let Some(next) = Seed::new(seed) else {
                return Err(Failure::Input(format!("--seed: expected room for every match below {}", Seed::MAX)));
            };
            let mut scenario = base.clone();
            for (colour, team) in ["blue", "yellow"].into_iter().zip(teams) {
                let Entrant { name, kind, coach } = &entrants[team];
                let fault = |error: &dyn std::fmt::Display| Failure::Input(format!("team \"{name}\": {error}"));
                // First without any coach tree: one that is there may not fit the team.
                let coach_key = format!("{colour}-coach");
                for (key, value) in [(&coach_key, ""), (&colour.to_owned(), kind.text()), (&coach_key, coach)] {
                    scenario = scenario.with(key, &Value::from(value)).map_err(|error| fault(&error))?;
                }
            }
            // Two rounds give everyone both sides against everyone.
            scenario = scenario
                .with("sides-exchanged", &Value::from(false))
                .map_err(|error| Failure::Input(error.to_string()))?;
            scenario.seed = next;
            fixtures.push(Fixture { round, seed, teams, scenario });
        }
    }
    Ok(fixtures)
}

/// The goals of blue and yellow, and the fingerprint of the end.
fn play(fixture: &Fixture) -> Result<([u32; 2], u64), Failure> {
    let mut run = Run::new(fixture.scenario.clone()).map_err(|error| Failure::Input(error.to_string()))?;
    while run.advance(u32::MAX) > 0 {}
    match run.outcome() {
        Outcome::Soccer(outcome) => Ok((outcome.goals, run.fingerprint())),
        Outcome::Geese(_) | Outcome::Sequencing(_) => Err(Failure::Input("expected a match".to_owned())),
    }
}

fn rows(fixtures: &[Fixture], games: &[Game], played: &[([u32; 2], u64)]) -> String {
    let quoted = |name: &String| {
        if name.contains([',', '"']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name.clone() }
    };
    let mut text = "game,round,seed,blue,yellow,goals_blue,goals_yellow,version,fingerprint\n".to_owned();
    for (at, ((fixture, game), (_, fingerprint))) in fixtures.iter().zip(games).zip(played).enumerate() {
        let [blue, yellow] = [&game.teams[0], &game.teams[1]].map(quoted);
        let [ours, theirs] = game.goals;
        let Fixture { round, seed, .. } = fixture;
        let line = format!("{at},{},{seed},{blue},{yellow},{ours},{theirs},{VERSION},{fingerprint:016x}\n", round + 1);
        text.push_str(&line);
    }
    text
}

/// - `ties`: whether there is a column of ties, which the paper's table leaves out.
fn print_table(rows: &[Standing], ties: bool) -> Result<(), Failure> {
    let (head, rule) = if ties { (" Tie |", "---:|") } else { ("", "") };
    print(&format!("| Team | Pts | GP | Vic |{head} Def | GS | GC | GD |"))?;
    print(&format!("|---|---:|---:|---:|{rule}---:|---:|---:|---:|"))?;
    for row in rows {
        let Standing { team, points, played, won, tied, lost, scored, conceded } = row;
        let ties = if ties { format!(" {tied} |") } else { String::new() };
        let numbers = format!("{points} | {played} | {won} |{ties} {lost} | {scored} | {conceded}");
        print(&format!("| {team} | {numbers} | {} |", row.difference()))?;
    }
    Ok(())
}

/// The IRONCup 2023 as printed, and what is wrong with it.
fn paper() -> Result<(), Failure> {
    print("\n## IRONCup 2023, as printed in Haug et al. 2024, tables 3 and 4\n")?;
    print("| blue team | goals | | goals | yellow team |\n|---|---:|:-:|---:|---|")?;
    for Game { teams: [blue, yellow], goals: [ours, theirs] } in ironcup::games() {
        print(&format!("| {blue} | {ours} | x | {theirs} | {yellow} |"))?;
    }
    print("")?;
    let rows: Vec<Standing> = ironcup::table().into_iter().map(|(row, _)| row).collect();
    print_table(&rows, false)?;
    let balance @ Balance { scored, conceded } = Balance::of(&rows);
    if !balance.holds() {
        print(&format!(
            "\nThe printed table contradicts itself: goals scored sum to {scored}, goals conceded to {conceded}, though \
             every goal is both. Each row agrees with itself, and ThunderVolt's with its games above, so the fault is in \
             other rows and cannot be located. These were human teams; their numbers say nothing of ours."
        ))?;
    }
    Ok(())
}
