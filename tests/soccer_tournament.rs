//! Tables of tournaments, on games made up for the purpose and on the paper's.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::soccer::ironcup;
use swarm_playground::soccer::tournament::{Balance, Game, Standing, Table, pairings};

fn names(words: &str) -> Vec<String> {
    words.split(' ').map(str::to_owned).collect()
}

/// Games such as `a 2:1 b`.
fn games(lines: &[&str]) -> Vec<Game> {
    let game = |line: &&str| {
        let words: Vec<&str> = line.split([' ', ':']).collect();
        let goals = [words[1], words[2]].map(|goals| goals.parse().expect("a number"));
        Game { teams: [words[0], words[3]].map(str::to_owned), goals }
    };
    lines.iter().map(game).collect()
}

fn order(teams: &str, lines: &[&str]) -> String {
    let table = Table::of(&names(teams), &games(lines)).expect("a table");
    assert!(table.balance().holds(), "every goal is scored and conceded");
    table.rows().iter().map(|row| row.team.as_str()).collect::<Vec<_>>().join(" ")
}

#[test]
fn three_points_one_point_and_none() {
    let table = Table::of(&names("a b c"), &games(&["a 2:1 b", "b 3:3 c", "c 0:4 a"])).expect("a table");
    let row = |team: &str, numbers: [u32; 7]| {
        let [points, played, won, tied, lost, scored, conceded] = numbers;
        Standing { team: team.to_owned(), points, played, won, tied, lost, scored, conceded }
    };
    let expected = [row("a", [6, 2, 2, 0, 0, 6, 1]), row("b", [1, 2, 0, 1, 1, 4, 5]), row("c", [1, 2, 0, 1, 1, 3, 7])];
    assert_eq!(table.rows(), expected);
    assert_eq!(table.balance(), Balance { scored: 13, conceded: 13 });
    assert_eq!(table.rows()[2].difference(), -4);
}

#[test]
fn equal_points_go_by_difference_then_goals_then_the_direct_result() {
    // b has the better difference of two with three points each.
    assert_eq!(order("a b c", &["a 1:0 c", "b 2:0 c"]), "b a c");
    // Equal differences: more goals first.
    assert_eq!(order("a b c d", &["a 1:0 c", "b 3:2 d"]), "b a d c");
    // a and b: 4 points, difference 0, 2 goals each, and b won against a, though a was named first.
    let lines = ["b 1:0 a", "c 1:0 b", "a 1:0 c", "a 1:1 d", "b 1:1 d"];
    assert_eq!(order("a b c d", &lines), "b a c d");
    // Nothing tells them apart: the order in which they were named.
    assert_eq!(order("b a", &["a 1:1 b"]), "b a");
}

#[test]
fn games_that_make_no_table_are_refused_with_their_place() {
    let refused =
        |teams: &str, lines: &[&str]| Table::of(&names(teams), &games(lines)).expect_err("it is refused").to_string();
    assert_eq!(refused("a b a", &[]), "teams: expected each team once, found \"a\" twice");
    let unknown = "games[1]: expected two of the teams of the tournament, found \"c\"";
    assert_eq!(refused("a b", &["a 1:0 b", "a 1:0 c"]), unknown);
    assert_eq!(refused("a b", &["b 1:0 b"]), "games[0]: expected two different teams, found \"b\" against itself");
}

#[test]
fn a_round_has_each_pair_once_and_the_next_one_exchanges_the_colours() {
    for teams in [2, 3, 7, 12] {
        let round = pairings(teams, 0);
        assert_eq!(round.len(), teams * (teams - 1) / 2);
        let next: Vec<[usize; 2]> = pairings(teams, 1).into_iter().map(|[blue, yellow]| [yellow, blue]).collect();
        assert_eq!(next, round);
        let mut all = round;
        all.sort_unstable();
        all.dedup();
        assert!(all.len() == teams * (teams - 1) / 2 && all.iter().all(|[first, second]| first < second));
    }
}

#[test]
fn the_printed_table_of_the_ironcup_contradicts_itself_and_its_rows_do_not() {
    let printed = ironcup::table();
    for (row, difference) in &printed {
        assert_eq!((row.points, row.played), (3 * row.won + row.tied, row.won + row.tied + row.lost), "{}", row.team);
        assert_eq!(row.difference(), *difference, "{}", row.team);
    }
    let rows: Vec<Standing> = printed.into_iter().map(|(row, _)| row).collect();
    let balance = Balance::of(&rows);
    assert_eq!((balance.scored, balance.conceded, balance.holds()), (227, 196, false));
    // The games of ThunderVolt give its row.
    let teams: Vec<String> = rows.iter().map(|row| row.team.clone()).collect();
    let table = Table::of(&teams, &ironcup::games()).expect("a table");
    let own = |rows: &[Standing]| rows.iter().find(|row| row.team == "ThunderVolt").cloned().expect("it took part");
    assert_eq!(own(table.rows()), own(&rows));
}
