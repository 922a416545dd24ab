//! The referee: each rule of VSSSLeague/VSSReferee, staged.
#![expect(clippy::float_cmp, reason = "what is put somewhere stands exactly there, and what rests is exactly at rest")]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::PI;
use swarm_playground::random::Seed;
use swarm_playground::soccer::pitch::{Quadrant, Side};
use swarm_playground::soccer::referee::{Attempt, Command, Entry, Forced, KeeperSide, Kick, Phase, Rule};
use swarm_playground::soccer::referee::{ball_place, default_spot};
use swarm_playground::soccer::view::{Ball, Lineup, ROBOTS, Restart, Slot, Spot, Wheels, Whose};
use swarm_playground::soccer::{Arrangement, Match, Params};

const STILL: [[Wheels; ROBOTS]; 2] = [[Wheels { left: 0.0, right: 0.0 }; ROBOTS]; 2];
const PLAIN: Lineup = Lineup { slots: [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter], spots: [None; ROBOTS] };

fn exact() -> Params {
    Params { vision_noise: 0.0, heading_noise: 0.0, wheel_noise: 0.0, placement_noise: 0.0, ..Params::default() }
}

/// A match after its first kick-off.
fn begun(params: &Params, seed: u64) -> Match {
    let mut game = Match::new(params, Seed::new(seed).expect("small"));
    assert!(game.place(&[PLAIN; 2]));
    game
}

fn spot(x: f64, y: f64) -> Spot {
    Spot { at: [x, y], heading: 0.0 }
}

/// Robots out of the way in two rows, with some of them elsewhere: side, number and place.
fn scene(ball: [f64; 2], velocity: [f64; 2], moved: &[(Side, usize, Spot)]) -> Arrangement {
    let row = |y: f64| [spot(-0.2, y), spot(0.0, y), spot(0.2, y)];
    let mut scene = Arrangement { ball: Ball { at: ball, velocity }, robots: [row(-0.6), row(0.6)] };
    for &(side, robot, spot) in moved {
        scene.robots[side.index()][robot] = spot;
    }
    scene
}

/// Plays a scene until the referee decides; returns the frames it took and the line of the log.
fn decided(game: &mut Match, scene: &Arrangement, wheels: &[[Wheels; ROBOTS]; 2]) -> (u32, Entry) {
    game.arrange(scene).expect("the scene is possible");
    let start = game.frame();
    while game.pending(Side::Left).is_none() && game.finished().is_none() {
        assert!(game.frame() - start < 2000, "the referee never decides");
        game.step(wheels);
    }
    (game.frame() - start, *game.log().last().expect("a decision is logged"))
}

/// A scene in a new match.
fn call(ball: [f64; 2], velocity: [f64; 2], moved: &[(Side, usize, Spot)]) -> (u32, Entry, [u32; 2]) {
    let mut game = begun(&exact(), 1);
    let (frames, entry) = decided(&mut game, &scene(ball, velocity, moved), &STILL);
    (frames, entry, game.score())
}

#[test]
fn a_goal_counts_and_who_conceded_kicks_off() {
    let (_, entry, score) = call([0.70, 0.0], [1.0, 0.0], &[]);
    assert_eq!((entry.command, entry.side, score), (Command::KickOff, Some(Side::Right), [1, 0]));
    assert!(matches!(entry.rule, Rule::Goal { by: Side::Left, ball: [x, _], .. } if x > 0.7715), "{entry:?}");
    let (_, entry, score) = call([-0.70, 0.1], [-1.0, 0.0], &[]);
    assert_eq!((entry.command, entry.side, score), (Command::KickOff, Some(Side::Left), [0, 1]));
}

#[test]
fn a_ball_that_is_not_wholly_over_the_line_is_no_goal() {
    // At rest with its centre 0.021 behind the line, less than its radius: it is stuck there, and no goal.
    let (frames, entry, score) = call([0.771, 0.0], [0.0; 2], &[]);
    assert_eq!((frames, score), (300, [0, 0]));
    assert!(matches!(entry.rule, Rule::StuckBall { .. }));
    let (frames, _, score) = call([0.772, 0.0], [0.0; 2], &[]);
    assert_eq!((frames, score), (1, [1, 0]));
}

#[test]
fn a_goal_with_two_attackers_is_void() {
    let attackers = [(Side::Left, 0, spot(0.65, 0.2)), (Side::Left, 1, spot(0.65, -0.2))];
    let (_, entry, score) = call([0.70, 0.0], [1.0, 0.0], &attackers);
    assert_eq!((entry.command, entry.side, score), (Command::GoalKick, Some(Side::Right), [0, 0]));
    assert!(matches!(entry.rule, Rule::PlayOfAttackers { area: Side::Right, goal: true, .. }), "{entry:?}");
}

#[test]
fn a_goal_with_two_defenders_counts() {
    let defenders = [(Side::Right, 0, spot(0.65, 0.2)), (Side::Right, 1, spot(0.65, -0.2))];
    let (_, entry, score) = call([0.70, 0.0], [1.0, 0.0], &defenders);
    assert_eq!((entry.command, score), (Command::KickOff, [1, 0]));
    assert!(matches!(entry.rule, Rule::Goal { defenders, .. } if defenders > 0.0), "{entry:?}");
}

const LEAVING: ([f64; 2], [f64; 2]) = ([0.65, 0.0], [-0.8, 0.0]);

#[test]
fn a_play_with_two_attackers_ends_in_a_goal_kick() {
    let attackers = [(Side::Left, 0, spot(0.65, 0.2)), (Side::Left, 1, spot(0.65, -0.2))];
    let (_, entry, _) = call(LEAVING.0, LEAVING.1, &attackers);
    assert_eq!((entry.command, entry.side), (Command::GoalKick, Some(Side::Right)));
    assert!(matches!(entry.rule, Rule::PlayOfAttackers { goal: false, .. }));
}

#[test]
fn a_play_with_two_defenders_ends_in_a_penalty() {
    let defenders = [(Side::Right, 0, spot(0.65, 0.2)), (Side::Right, 1, spot(0.65, -0.2))];
    let (_, entry, _) = call(LEAVING.0, LEAVING.1, &defenders);
    assert_eq!((entry.command, entry.side), (Command::PenaltyKick, Some(Side::Left)));
    assert!(matches!(entry.rule, Rule::PlayOfDefenders { area: Side::Right, .. }));
}

#[test]
fn a_play_without_a_foul_goes_on() {
    let one_each = [(Side::Left, 0, spot(0.65, 0.2)), (Side::Right, 0, spot(0.65, -0.2))];
    let mut game = begun(&exact(), 1);
    game.arrange(&scene(LEAVING.0, LEAVING.1, &one_each)).expect("possible");
    for _ in 0..60 {
        game.step(&STILL);
    }
    assert!(game.ball().at[0] < 0.6 && game.pending(Side::Left).is_none());
}

#[test]
fn of_both_fouls_in_a_play_the_longer_counts_and_of_equal_ones_the_defenders() {
    let all = [
        (Side::Left, 0, spot(0.65, 0.2)),
        (Side::Left, 1, spot(0.65, -0.2)),
        (Side::Right, 0, spot(0.72, 0.1)),
        (Side::Right, 1, Spot { at: [0.61, -0.1], heading: PI }),
    ];
    let (_, entry, _) = call(LEAVING.0, LEAVING.1, &all);
    assert_eq!((entry.command, entry.side), (Command::PenaltyKick, Some(Side::Left)));
    let Rule::PlayOfBoth { attackers, defenders, goal: false, .. } = entry.rule else { panic!("{entry:?}") };
    assert_eq!(attackers, defenders);

    // The second defender leaves the area at once, long before the ball does.
    let mut game = begun(&exact(), 1);
    let mut wheels = STILL;
    wheels[1][1] = Wheels { left: 46.0, right: 46.0 };
    let (_, entry) = decided(&mut game, &scene([0.70, 0.0], [-0.4, 0.0], &all), &wheels);
    assert_eq!((entry.command, entry.side), (Command::GoalKick, Some(Side::Right)));
    assert!(matches!(entry.rule, Rule::PlayOfBoth { attackers, defenders, .. } if attackers > defenders));
}

#[test]
fn two_attackers_for_3_seconds_give_a_goal_kick() {
    let attackers = [(Side::Right, 0, spot(-0.65, 0.2)), (Side::Right, 1, spot(-0.65, -0.2))];
    let (frames, entry, _) = call([-0.65, 0.0], [0.0; 2], &attackers);
    assert_eq!((frames, entry.command, entry.side), (180, Command::GoalKick, Some(Side::Left)));
    assert_eq!(entry.rule, Rule::TwoAttackers { area: Side::Left, seconds: 3.0 });
}

#[test]
fn two_defenders_for_3_seconds_give_a_penalty() {
    let defenders = [(Side::Left, 0, spot(-0.65, 0.2)), (Side::Left, 1, spot(-0.65, -0.2))];
    let (frames, entry, _) = call([-0.65, 0.0], [0.0; 2], &defenders);
    assert_eq!((frames, entry.command, entry.side), (180, Command::PenaltyKick, Some(Side::Right)));
    assert_eq!(entry.rule, Rule::TwoDefenders { area: Side::Left, seconds: 3.0 });
}

#[test]
fn two_attackers_go_before_two_defenders() {
    let all = [
        (Side::Left, 0, spot(0.65, 0.2)),
        (Side::Left, 1, spot(0.65, -0.2)),
        (Side::Right, 0, spot(0.71, 0.1)),
        (Side::Right, 1, spot(0.71, -0.1)),
    ];
    let (frames, entry, _) = call([0.65, 0.0], [0.0; 2], &all);
    assert_eq!((frames, entry.command), (180, Command::GoalKick));
}

#[test]
fn a_crowd_that_parts_for_a_moment_starts_its_3_seconds_again() {
    // The second attacker drives out of the area and stays out: nothing happens until the ball is stuck.
    let mut game = begun(&exact(), 1);
    let attackers = [(Side::Left, 0, spot(0.65, 0.2)), (Side::Left, 1, Spot { at: [0.65, -0.2], heading: PI })];
    let mut wheels = STILL;
    wheels[0][1] = Wheels { left: 10.0, right: 10.0 };
    let (frames, entry) = decided(&mut game, &scene([0.65, 0.0], [0.0; 2], &attackers), &wheels);
    assert_eq!(frames, 300);
    assert!(matches!(entry.rule, Rule::StuckBall { .. }));
}

#[test]
fn a_crowd_without_the_ball_is_no_foul() {
    let attackers = [(Side::Left, 0, spot(0.65, 0.2)), (Side::Left, 1, spot(0.65, -0.2))];
    let (frames, entry, _) = call([0.0, 0.0], [0.0; 2], &attackers);
    assert_eq!((frames, entry.command), (300, Command::FreeBall));
}

#[test]
fn a_ball_stuck_outside_the_areas_gives_a_free_ball_in_its_quadrant() {
    for (x, y, number, taker) in [
        (0.2, 0.2, 1, Side::Left),
        (-0.2, 0.2, 2, Side::Right),
        (-0.2, -0.2, 3, Side::Right),
        (0.2, -0.2, 4, Side::Left),
    ] {
        let (frames, entry, _) = call([x, y], [0.0; 2], &[]);
        assert_eq!((frames, entry.command, entry.side), (300, Command::FreeBall, Some(taker)));
        assert_eq!(entry.quadrant.map(Quadrant::number), Some(number));
    }
}

#[test]
fn a_ball_stuck_in_an_area_gives_a_penalty_unless_both_teams_fight_for_it() {
    let fight = [(Side::Left, 0, spot(0.65, 0.1)), (Side::Right, 0, spot(0.65, -0.1))];
    let (_, entry, _) = call([0.65, 0.0], [0.0; 2], &fight);
    assert_eq!((entry.command, entry.quadrant), (Command::FreeBall, Some(Quadrant::Fourth)));
    let Rule::StuckBall { area, seconds, speed, nearest } = entry.rule else { panic!("{entry:?}") };
    assert_eq!((area, seconds, speed), (Some(Side::Right), 5.0, 0.0));
    assert!(nearest.iter().all(|distance| (distance - 0.1).abs() < 1e-12));

    // One robot 0.12 away instead of 0.1125: nobody fights.
    let alone = [(Side::Left, 0, spot(0.65, 0.12)), (Side::Right, 0, spot(0.65, -0.1))];
    let (_, entry, _) = call([0.65, 0.0], [0.0; 2], &alone);
    assert_eq!((entry.command, entry.side), (Command::PenaltyKick, Some(Side::Left)));
}

#[test]
fn the_timer_of_a_stuck_ball_starts_again_when_it_moves_or_crosses_a_border() {
    // From 0.3 m/s it rolls for (0.3 - 0.1) / 0.14 = 1.43 s before it is slow enough, 86 frames.
    let (frames, _, _) = call([0.0, 0.0], [0.3, 0.0], &[]);
    assert!((384..=388).contains(&frames), "{frames}");
    // At 0.09 m/s it is slow from the start, and leaves the area after (0.605 - 0.600) / 0.09 = 0.06 s.
    let (frames, entry, _) = call([0.605, 0.0], [-0.09, 0.0], &[]);
    assert!((303..=305).contains(&frames), "{frames}");
    assert_eq!(entry.command, Command::FreeBall);
}

#[test]
fn the_clock_ends_a_half_before_anything_else_and_the_other_team_kicks_off() {
    let params = Params { half_seconds: 2, ..exact() };
    let mut game = begun(&params, 1);
    let first = game.log()[0].side.expect("somebody kicks off");
    // The ball is over the line in the very frame in which the half ends: no goal.
    for _ in 0..119 {
        game.step(&STILL);
    }
    let (frames, entry) = decided(&mut game, &scene([0.772, 0.0], [0.0; 2], &[]), &STILL);
    assert_eq!((frames, game.score()), (1, [0, 0]));
    assert_eq!((entry.command, entry.side), (Command::KickOff, Some(first.other())));
    assert_eq!((entry.phase, entry.rule), (Phase::SecondHalf, Rule::TimeOver { seconds: 2.0 }));
}

#[test]
fn the_coin_falls_on_both_sides() {
    let firsts: Vec<Option<Side>> = (0..20).map(|seed| begun(&exact(), seed).log()[0].side).collect();
    let left = firsts.iter().filter(|&&side| side == Some(Side::Left)).count();
    assert!((4..=16).contains(&left), "{left} of 20");
}

#[test]
fn waits_are_logged_and_take_no_play() {
    let mut game = begun(&exact(), 1);
    let elapsed: Vec<f64> = game.log().iter().map(|entry| entry.elapsed).collect();
    assert_eq!(elapsed, [0.0, 4.0, 8.0], "kick-off, stop, game on");
    decided(&mut game, &scene([0.772, 0.0], [0.0; 2], &[]), &STILL);
    game.place(&[PLAIN; 2]);
    let commands: Vec<Command> = game.log()[3..].iter().map(|entry| entry.command).collect();
    assert_eq!(commands, [Command::KickOff, Command::Stop, Command::GameOn]);
    let elapsed: Vec<f64> = game.log()[3..].iter().map(|entry| entry.elapsed - 8.0 - 1.0 / 60.0).collect();
    assert!((elapsed[1] - 8.0).abs() < 1e-9 && (elapsed[2] - 12.0).abs() < 1e-9, "8 s after a goal: {elapsed:?}");
    assert_eq!(game.frame(), 1);
}

/// Slot, side, and where the table has it.
type Row = (Slot, Side, [f64; 2]);

#[test]
fn robots_are_placed_by_the_table_and_mirrored_for_the_left_team() {
    use Side::{Left, Right};
    use Slot::{Attacker, Goalkeeper, Supporter};
    let tables: [(Kick, Side, [f64; 2], [Row; 6]); 6] = [
        (
            Kick::KickOff,
            Left,
            [0.0, 0.0],
            [
                (Goalkeeper, Left, [-0.675, 0.0]),
                (Attacker, Left, [-0.2, 0.0]),
                (Supporter, Left, [-0.4, 0.0]),
                (Goalkeeper, Right, [0.675, 0.0]),
                (Attacker, Right, [0.2, 0.0]),
                (Supporter, Right, [0.4, 0.0]),
            ],
        ),
        (
            Kick::Penalty,
            Right,
            [-0.375, 0.0],
            [
                (Goalkeeper, Right, [0.65, 0.0]),
                (Attacker, Right, [-0.3, 0.0]),
                (Supporter, Right, [0.1, 0.4]),
                (Goalkeeper, Left, [-0.7125, 0.0]),
                (Attacker, Left, [0.1, 0.25]),
                (Supporter, Left, [0.1, -0.4]),
            ],
        ),
        (
            Kick::Penalty,
            Left,
            [0.375, 0.0],
            [
                (Goalkeeper, Left, [-0.65, 0.0]),
                (Attacker, Left, [0.3, 0.0]),
                (Supporter, Left, [-0.1, 0.4]),
                (Goalkeeper, Right, [0.7125, 0.0]),
                (Attacker, Right, [-0.1, 0.25]),
                (Supporter, Right, [-0.1, -0.4]),
            ],
        ),
        (
            Kick::GoalKick,
            Left,
            [-0.60, 0.3535],
            [
                (Goalkeeper, Left, [-0.675, 0.27]),
                (Attacker, Left, [-0.45, 0.32]),
                (Supporter, Left, [-0.3, -0.47]),
                (Goalkeeper, Right, [0.675, 0.0]),
                (Attacker, Right, [-0.225, 0.1]),
                (Supporter, Right, [-0.15, -0.32]),
            ],
        ),
        (
            Kick::FreeBall(Quadrant::First),
            Left,
            [0.375, 0.4],
            [
                (Goalkeeper, Left, [-0.675, 0.0]),
                (Attacker, Left, [0.175, 0.4]),
                (Supporter, Left, [0.1, -0.2]),
                (Goalkeeper, Right, [0.675, 0.0]),
                (Attacker, Right, [0.575, 0.4]),
                (Supporter, Right, [0.3, -0.1]),
            ],
        ),
        (
            Kick::FreeBall(Quadrant::Third),
            Right,
            [-0.375, -0.4],
            [
                (Goalkeeper, Left, [-0.675, 0.0]),
                (Attacker, Left, [-0.575, -0.4]),
                (Supporter, Left, [-0.3, 0.1]),
                (Goalkeeper, Right, [0.675, 0.0]),
                (Attacker, Right, [-0.175, -0.4]),
                (Supporter, Right, [-0.1, 0.2]),
            ],
        ),
    ];
    let same = |found: [f64; 2], expected: [f64; 2]| (0..2).all(|axis| (found[axis] - expected[axis]).abs() < 1e-12);
    for (kick, taker, ball, rows) in tables {
        assert!(same(ball_place(kick, taker, KeeperSide::Up), ball), "{kick:?}");
        for (slot, side, at) in rows {
            let found = default_spot(kick, taker, KeeperSide::Up, side, slot);
            assert!(same(found.at, at), "{kick:?} {slot:?} {side:?}: expected {at:?}, found {:?}", found.at);
            if (kick, slot, side) != (Kick::GoalKick, Goalkeeper, taker) {
                assert_eq!(found.heading, if side == Left { 0.0 } else { PI });
            }
        }
    }
    let keeper = default_spot(Kick::GoalKick, Right, KeeperSide::Down, Right, Goalkeeper);
    assert!(
        same(keeper.at, [0.675, -0.27]) && same(ball_place(Kick::GoalKick, Right, KeeperSide::Down), [0.60, -0.3535])
    );
    // From (0.675, -0.27) to (0.60, -0.3535).
    assert!((keeper.heading - libm::atan2(-0.0835, -0.075)).abs() < 1e-12);
}

#[test]
fn goal_kicks_are_taken_on_either_side_of_the_goal() {
    let mut up = 0;
    for seed in 0..20 {
        let mut game = begun(&exact(), seed);
        assert!(game.stage(Kick::GoalKick, Side::Left) && game.place(&[PLAIN; 2]));
        assert!((game.ball().at[0] + 0.60).abs() < 1e-12);
        up += u32::from(game.ball().at[1] > 0.0);
    }
    assert!((4..=16).contains(&up), "{up} of 20");
}

/// Places a penalty of the left team with line-ups; returns the match and what was forced.
fn lined_up(left: Lineup, right: Lineup) -> (Match, Vec<Forced>) {
    let mut game = begun(&exact(), 1);
    assert!(game.stage(Kick::Penalty, Side::Left) && game.place(&[left, right]));
    let forced = game.log().iter().filter_map(|entry| match entry.rule {
        Rule::Forced(forced) => Some(forced),
        _ => None,
    });
    let forced = forced.collect();
    (game, forced)
}

fn with_spot(robot: usize, at: [f64; 2]) -> Lineup {
    let mut lineup = PLAIN;
    lineup.spots[robot] = Some(Spot { at, heading: 0.5 });
    lineup
}

#[test]
fn teams_may_stand_where_they_like_in_their_own_frame() {
    let (game, forced) = lined_up(with_spot(1, [0.285, 0.0225]), with_spot(2, [-0.3, 0.4]));
    assert_eq!(forced, []);
    let arrangement = game.arrangement();
    assert_eq!(arrangement.robots[0][1].at, [0.285, 0.0225]);
    assert_eq!(arrangement.robots[1][2].at, [0.3, -0.4], "turned for the right team");
    assert!((arrangement.robots[0][1].heading - 0.5).abs() < 1e-12);
    assert!((arrangement.robots[1][2].heading - (0.5 - PI)).abs() < 1e-12);
}

#[test]
fn robots_too_close_are_all_placed_by_the_table() {
    // The attacker of the left team stands at (0.3, 0) by the table; (-0.38, 0) of the right team is (0.38, 0), on the
    // ball, so the supporter asks for (0.3, 0.08), 0.08 away.
    let (game, forced) = lined_up(PLAIN, with_spot(2, [-0.3, -0.08]));
    let [Forced::Close { robots: [1, 5], distance }] = forced[..] else { panic!("{forced:?}") };
    assert!((distance - 0.08).abs() < 1e-9);
    assert_eq!(game.arrangement().robots[1][2].at, [-0.1, -0.4]);
    assert_eq!(game.statistics().forced, 1);
}

#[test]
fn impossible_places_put_only_their_own_team_by_the_table() {
    let left = with_spot(1, [0.285, 0.0225]);
    for (at, expected) in [
        ([0.75, 0.5], Forced::OffPitch { robot: 4 }),
        ([f64::NAN, 0.0], Forced::OffPitch { robot: 4 }),
        ([1e300, 0.0], Forced::OffPitch { robot: 4 }),
        ([-0.40, 0.0], Forced::OnBall { robot: 4 }),
    ] {
        let (game, forced) = lined_up(left, with_spot(1, at));
        assert_eq!(forced, [expected], "{at:?}");
        assert_eq!(game.arrangement().robots[1][1].at, [-0.1, 0.25]);
        assert_eq!(game.arrangement().robots[0][1].at, [0.285, 0.0225]);
    }
}

#[test]
fn a_slot_named_twice_is_dealt_by_who_was_longest_at_home() {
    let mut game = begun(&exact(), 1);
    // Robot 2 of the left team stands in its own area for a while.
    game.arrange(&scene([0.0, 0.0], [0.0; 2], &[(Side::Left, 2, spot(-0.65, 0.0))])).expect("possible");
    for _ in 0..30 {
        game.step(&STILL);
    }
    game.stage(Kick::KickOff, Side::Left);
    let twice = Lineup { slots: [Slot::Attacker; 3], ..PLAIN };
    game.place(&[twice, PLAIN]);
    assert!(game.log().iter().any(|entry| entry.rule == Rule::Forced(Forced::Slots { side: Side::Left })));
    assert_eq!(game.arrangement().robots[0].map(|spot| spot.at[0]), [-0.2, -0.4, -0.675]);
}

#[test]
fn each_team_hears_a_call_in_its_own_frame() {
    let mut game = begun(&exact(), 1);
    game.stage(Kick::FreeBall(Quadrant::First), Side::Right);
    let [left, right] = Side::BOTH.map(|side| game.pending(side).expect("it is pending"));
    assert_eq!((left.restart, left.taker, left.quadrant, left.number), (Restart::FreeBall, Whose::Ours, 1, 2));
    assert_eq!((right.restart, right.taker, right.quadrant, right.number), (Restart::FreeBall, Whose::Theirs, 3, 2));
    game.place(&[PLAIN; 2]);
    assert_eq!(game.pending(Side::Left), None);
    assert_eq!((game.view(Side::Right).call, game.view(Side::Right).since), (right, 0));
}

fn knockout() -> Params {
    Params { half_seconds: 1, extra_seconds: 1, knockout: true, ..exact() }
}

/// Plays on without anybody moving until the shoot-out is pending.
fn shoot_out() -> (Match, Side) {
    let mut game = begun(&knockout(), 1);
    let first = game.log()[0].side.expect("somebody kicks off");
    while game.phase() != Phase::ShootOut {
        game.place(&[PLAIN; 2]);
        game.step(&STILL);
    }
    (game, first)
}

#[test]
fn a_tie_of_a_knock_out_game_leads_to_overtime_and_a_shoot_out() {
    let (game, first) = shoot_out();
    assert_eq!(game.frame(), 4 * 60);
    let phases: Vec<(Phase, Option<Side>)> = game
        .log()
        .iter()
        .filter(|entry| matches!(entry.command, Command::KickOff | Command::PenaltyKick))
        .map(|entry| (entry.phase, entry.side))
        .collect();
    let other = Some(first.other());
    let first = Some(first);
    assert_eq!(
        phases,
        [
            (Phase::FirstHalf, first),
            (Phase::SecondHalf, other),
            (Phase::FirstExtra, first),
            (Phase::SecondExtra, other),
            (Phase::ShootOut, first),
        ]
    );
}

#[test]
fn a_shoot_out_in_which_nobody_moves_ends_by_the_coin() {
    let (mut game, first) = shoot_out();
    let start = game.frame();
    while game.finished().is_none() {
        game.place(&[PLAIN; 2]);
        game.step(&STILL);
    }
    assert_eq!(game.frame() - start, 40 * 300, "20 pairs, each attempt stuck after 5 s");
    let outcome = game.finished().expect("it is over");
    assert_eq!((outcome.shoot_out, outcome.winner), (Some([0, 0]), Some(first.other())));
}

#[test]
fn attempts_end_with_a_goal_beyond_midfield_out_of_the_area_or_in_the_end() {
    let (mut game, first) = shoot_out();
    let goal = first.other().sign();
    let ends: [(_, _, Attempt); 3] = [
        ([goal * 0.70, 0.0], [goal, 0.0], Attempt::Goal),
        ([goal * 0.05, 0.0], [-goal, 0.0], Attempt::CrossedMidfield),
        ([goal * 0.65, 0.0], [-goal, 0.0], Attempt::LeftArea),
    ];
    for (number, (ball, velocity, end)) in ends.into_iter().enumerate() {
        // Attempts alternate: every second one is at the other goal.
        let turn = if number % 2 == 0 { 1.0 } else { -1.0 };
        game.place(&[PLAIN; 2]);
        let scene = scene(ball.map(|real| real * turn), velocity.map(|real| real * turn), &[]);
        let (_, entry) = decided(&mut game, &scene, &STILL);
        let Rule::Attempt { ended, by, .. } = entry.rule else { panic!("{entry:?}") };
        assert_eq!((ended, by), (end, if turn > 0.0 { first } else { first.other() }));
    }
    let scored = game.shoot_out_score().expect("it is one");
    assert_eq!((scored[first.index()], scored[first.other().index()], game.score()), (1, 0, [0, 0]));
}

#[test]
fn a_shoot_out_ends_when_nobody_can_catch_up() {
    let (mut game, first) = shoot_out();
    let goal = first.other().sign();
    // The first side always scores, the other never: 3 to 0 after three pairs, with two left.
    let mut attempts = 0;
    while game.finished().is_none() {
        game.place(&[PLAIN; 2]);
        let at = if attempts % 2 == 0 { [goal * 0.772, 0.0] } else { [goal * 0.05, 0.0] };
        let velocity = if attempts % 2 == 0 { [0.0; 2] } else { [goal, 0.0] };
        decided(&mut game, &scene(at, velocity, &[]), &STILL);
        attempts += 1;
    }
    assert_eq!(attempts, 6);
    assert_eq!(game.finished().expect("over").winner, Some(first));
}

#[test]
fn every_line_of_the_log_is_a_sentence() {
    let text = |rule| {
        let entry = Entry {
            frame: 4530,
            phase: Phase::FirstHalf,
            seconds: 75.5,
            elapsed: 90.0,
            command: Command::FreeBall,
            side: Some(Side::Left),
            quadrant: Some(Quadrant::Fourth),
            rule,
        };
        let text = entry.text(["blue", "yellow"]);
        let start = "first half, 1:15.5: free ball for blue in quadrant 4, because ";
        text.strip_prefix(start).unwrap_or_else(|| panic!("{text}")).to_owned()
    };
    let area = Side::Right;
    let robots = [1, 5];
    for (rule, expected) in [
        (Rule::Coin, "the coin gave it the first kick-off"),
        (Rule::TimeOver { seconds: 300.0 }, "300 s of play are over"),
        (
            Rule::Goal { by: Side::Left, ball: [0.7812, 0.1], defenders: 0.0 },
            "blue scored, with the ball at 0.781, 0.100",
        ),
        (
            Rule::Goal { by: Side::Left, ball: [0.7812, 0.1], defenders: 0.5 },
            "blue scored, with the ball at 0.781, 0.100; that two robots defended in their area for 0.50 s does not matter",
        ),
        (
            Rule::PlayOfAttackers { area, goal: true, seconds: 0.25 },
            "blue had two robots in the area of yellow for 0.25 s of this play, so the goal is void",
        ),
        (
            Rule::PlayOfDefenders { area, seconds: 0.25 },
            "yellow had two robots in its own area for 0.25 s of this play",
        ),
        (
            Rule::PlayOfBoth { area, goal: false, attackers: 0.25, defenders: 0.5 },
            "in the area of yellow blue had two robots for 0.25 s of this play, yellow for 0.50 s",
        ),
        (
            Rule::TwoAttackers { area, seconds: 3.0 },
            "blue had two robots in the area of yellow, with the ball, for 3.00 s",
        ),
        (Rule::TwoDefenders { area, seconds: 3.0 }, "yellow had two robots in its own area, with the ball, for 3.00 s"),
        (
            Rule::StuckBall { area: None, seconds: 5.0, speed: 0.02, nearest: [0.1, 0.25] },
            "the ball was stuck for 5.00 s, at 0.02 m/s, outside the areas, 0.100 m from blue and 0.250 m from yellow",
        ),
        (
            Rule::Attempt { by: Side::Left, ended: Attempt::Goal, seconds: 1.25, scored: [1, 0] },
            "the attempt of blue ended with a goal after 1.25 s: 1 to 0",
        ),
        (Rule::Staged, "somebody asked for it"),
        (Rule::Placed, "robots and ball were placed"),
        (Rule::WaitOver, "the wait is over"),
        (
            Rule::Forced(Forced::Close { robots, distance: 0.0812 }),
            "robot 2 of blue and robot 3 of yellow would be 0.0812 m apart, and all stand by the table",
        ),
        (
            Rule::Forced(Forced::OnBall { robot: 4 }),
            "the place asked for robot 2 of yellow is on the ball, and its team stands by the table",
        ),
        (Rule::Forced(Forced::Slots { side: Side::Left }), "blue named a slot twice, and the referee deals its slots"),
        (Rule::Fault { robot: 0 }, "robot 1 of blue was sent a speed that is no number, taken as 0"),
    ] {
        assert_eq!(text(rule), expected);
    }
}
