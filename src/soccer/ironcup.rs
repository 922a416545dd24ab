//! The IRONCup 2023 as the paper prints it.
//!
//! Source: Haug et al. 2024, tables 3 and 4. Table 4 contradicts itself: its goals scored sum to 227 and its goals conceded
//! to 196. Each row agrees with itself, and ThunderVolt's with its games of table 3, so the fault is in other rows and
//! cannot be located.

use super::tournament::{Game, Standing};

/// Team, points, games, victories, defeats, goals scored, goals conceded, goal difference; nobody tied.
type Printed = (&'static str, u32, u32, u32, u32, u32, u32, i64);

const TABLE_4: [Printed; 7] = [
    ("RobôCIn", 18, 6, 6, 0, 68, 17, 51),
    ("ThunderVolt", 15, 6, 5, 1, 32, 3, 29),
    ("Robotbulls", 12, 6, 4, 2, 34, 23, 11),
    ("ITAndroids", 9, 6, 3, 3, 36, 17, 19),
    ("Red Dragons", 6, 6, 2, 4, 36, 36, 0),
    ("Rinobot", 3, 6, 1, 5, 14, 54, -40),
    ("Neon", 0, 6, 0, 6, 7, 46, -39),
];

/// Blue, its goals, yellow's goals, yellow.
const TABLE_3: [(&str, u32, u32, &str); 6] = [
    ("ThunderVolt", 7, 0, "Red Dragons"),
    ("Neon", 0, 14, "ThunderVolt"),
    ("ThunderVolt", 4, 0, "ITAndroids"),
    ("Rinobot", 0, 5, "ThunderVolt"),
    ("RobôCIn", 3, 0, "ThunderVolt"),
    ("Robotbulls", 0, 2, "ThunderVolt"),
];

/// Table 4 in its printed order, with the printed goal difference of each row.
#[must_use]
pub fn table() -> Vec<(Standing, i64)> {
    let row = |&(team, points, played, won, lost, scored, conceded, difference): &Printed| {
        let tied = played - won - lost;
        (Standing { team: team.to_owned(), points, played, won, tied, lost, scored, conceded }, difference)
    };
    TABLE_4.iter().map(row).collect()
}

/// Table 3: the games of ThunderVolt.
#[must_use]
pub fn games() -> Vec<Game> {
    let game = |&(blue, ours, theirs, yellow): &(&str, u32, u32, &str)| Game {
        teams: [blue, yellow].map(str::to_owned),
        goals: [ours, theirs],
    };
    TABLE_3.iter().map(game).collect()
}
