//! Tournaments: results of games in, the table out.
//!
//! Source: Haug et al. 2024, table 4: three points for a victory, one for a tie. The paper gives no order for equal
//! points; ours is that of soccer leagues: goal difference, goals scored, direct result.

use std::cmp::{Ordering, Reverse};
use std::fmt;

/// A game that was played.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Game {
    /// The two teams; the blue one first.
    pub teams: [String; 2],
    /// The goals of each.
    pub goals: [u32; 2],
}

/// One row of the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// The team's name.
    pub team: String,
    /// Three for a victory, one for a tie.
    pub points: u32,
    /// Games played.
    pub played: u32,
    /// Victories.
    pub won: u32,
    /// Games that nobody won.
    pub tied: u32,
    /// Defeats.
    pub lost: u32,
    /// Goals scored.
    pub scored: u32,
    /// Goals conceded.
    pub conceded: u32,
}

/// Goals of all rows of a table. Every goal that is scored is conceded by somebody, so both sums are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Balance {
    /// Goals scored.
    pub scored: u32,
    /// Goals conceded.
    pub conceded: u32,
}

/// Why games make no table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TournamentError {
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Kind {
    Twice { team: String },
    Unknown { game: usize, team: String },
    Itself { game: usize, team: String },
}

impl fmt::Display for TournamentError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            Kind::Twice { team } => write!(out, "teams: expected each team once, found \"{team}\" twice"),
            Kind::Unknown { game, team } => {
                write!(out, "games[{game}]: expected two of the teams of the tournament, found \"{team}\"")
            }
            Kind::Itself { game, team } => {
                write!(out, "games[{game}]: expected two different teams, found \"{team}\" against itself")
            }
        }
    }
}

impl std::error::Error for TournamentError {}

/// A tournament's table, the best team first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    rows: Vec<Standing>,
}

impl Standing {
    /// A team before its first game.
    #[must_use]
    pub fn new(team: &str) -> Self {
        let team = team.to_owned();
        Self { team, points: 0, played: 0, won: 0, tied: 0, lost: 0, scored: 0, conceded: 0 }
    }

    /// Goals scored less goals conceded.
    #[must_use]
    pub fn difference(&self) -> i64 {
        i64::from(self.scored) - i64::from(self.conceded)
    }

    fn take(&mut self, scored: u32, conceded: u32) {
        self.played += 1;
        self.scored += scored;
        self.conceded += conceded;
        match scored.cmp(&conceded) {
            Ordering::Greater => {
                self.won += 1;
                self.points += 3;
            }
            Ordering::Equal => {
                self.tied += 1;
                self.points += 1;
            }
            Ordering::Less => self.lost += 1,
        }
    }
}

impl Table {
    /// The table of games: ordered by points, goal difference, goals scored, and then by the points of the games that
    /// those who are still equal played among themselves; who is equal even then stays in the order of `teams`.
    ///
    /// - `teams`: every team once; one without a game has zeros.
    /// - `games`: in any order, as many of a pair as were played.
    ///
    /// # Errors
    /// A team comes twice; a game, by its place, is of an unknown team or of a team against itself.
    ///
    /// ```
    /// use swarm_playground::soccer::tournament::{Game, Table};
    /// let teams = ["tree", "machine"].map(str::to_owned);
    /// let table = Table::of(&teams, &[Game { teams: teams.clone(), goals: [1, 2] }])?;
    /// assert_eq!((table.rows()[0].team.as_str(), table.rows()[0].points), ("machine", 3));
    /// # Ok::<(), swarm_playground::soccer::tournament::TournamentError>(())
    /// ```
    pub fn of(teams: &[String], games: &[Game]) -> Result<Self, TournamentError> {
        let mut rows: Vec<Standing> = Vec::new();
        for team in teams {
            if rows.iter().any(|row| row.team == *team) {
                return Err(TournamentError { kind: Kind::Twice { team: team.clone() } });
            }
            rows.push(Standing::new(team));
        }
        for (game, Game { teams: [first, second], goals: [ours, theirs] }) in games.iter().enumerate() {
            let place = |team: &String| {
                let found = rows.iter().position(|row| row.team == *team);
                found.ok_or_else(|| TournamentError { kind: Kind::Unknown { game, team: team.clone() } })
            };
            let (a, b) = (place(first)?, place(second)?);
            if a == b {
                return Err(TournamentError { kind: Kind::Itself { game, team: first.clone() } });
            }
            rows[a].take(*ours, *theirs);
            rows[b].take(*theirs, *ours);
        }
        let key = |row: &Standing| Reverse((row.points, row.difference(), row.scored));
        rows.sort_by_key(key);
        for tied in rows.chunk_by_mut(|a, b| key(a) == key(b)).filter(|tied| tied.len() > 1) {
            let names: Vec<String> = tied.iter().map(|row| row.team.clone()).collect();
            let among = |team: &str| direct_points(team, &names, games);
            tied.sort_by_key(|row| Reverse(among(&row.team)));
        }
        Ok(Self { rows })
    }

    /// The rows, the best first.
    #[must_use]
    pub fn rows(&self) -> &[Standing] {
        &self.rows
    }

    /// The goals of all rows.
    #[must_use]
    pub fn balance(&self) -> Balance {
        Balance::of(&self.rows)
    }
}

/// The points of a team in its games against the others of a few.
fn direct_points(team: &str, few: &[String], games: &[Game]) -> u32 {
    let mut own = Standing::new(team);
    for Game { teams: [first, second], goals: [ours, theirs] } in games {
        if first == team && few.contains(second) {
            own.take(*ours, *theirs);
        } else if second == team && few.contains(first) {
            own.take(*theirs, *ours);
        }
    }
    own.points
}

impl Balance {
    /// The goals of rows.
    #[must_use]
    pub fn of(rows: &[Standing]) -> Self {
        Self { scored: rows.iter().map(|row| row.scored).sum(), conceded: rows.iter().map(|row| row.conceded).sum() }
    }

    /// Whether as many goals were conceded as scored.
    #[must_use]
    pub fn holds(self) -> bool {
        self.scored == self.conceded
    }
}

/// The pairings of one round, everyone against everyone once, by the places of the teams: the earlier team is blue in
/// rounds of even number, counted from 0, and yellow in the others.
///
/// ```
/// use swarm_playground::soccer::tournament::pairings;
/// assert_eq!(pairings(3, 0), [[0, 1], [0, 2], [1, 2]]);
/// assert_eq!(pairings(3, 1), [[1, 0], [2, 0], [2, 1]]);
/// ```
#[must_use]
pub fn pairings(teams: usize, round: u32) -> Vec<[usize; 2]> {
    let pairs = (0..teams).flat_map(|first| (first + 1..teams).map(move |second| [first, second]));
    pairs.map(|[first, second]| if round.is_multiple_of(2) { [first, second] } else { [second, first] }).collect()
}
