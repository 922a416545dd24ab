//! Whole matches between two plain teams: the same bits everywhere, and nothing that hangs.
#![expect(clippy::float_cmp, reason = "what is put somewhere stands exactly there, and what rests is exactly at rest")]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod soccer_teams;

use serde_json::{Value, json};
use soccer_teams::{PLAIN, STILL, play};
use std::f64::consts::PI;
use swarm_playground::random::Seed;
use swarm_playground::scenario::{Scenario, WorldParams};
use swarm_playground::soccer::physics::WHEEL_LIMIT;
use swarm_playground::soccer::pitch::Side;
use swarm_playground::soccer::referee::{Command, Kick, Rule};
use swarm_playground::soccer::view::{Ball, Spot, Wheels};
use swarm_playground::soccer::{Colour, Match, Params, parameters};

fn seed(value: u64) -> Seed {
    Seed::new(value).expect("test seeds are small")
}

fn exact() -> Params {
    Params { vision_noise: 0.0, heading_noise: 0.0, wheel_noise: 0.0, placement_noise: 0.0, ..Params::default() }
}

fn begun(params: &Params, value: u64) -> Match {
    let mut game = Match::new(params, seed(value));
    game.place(&[PLAIN; 2]);
    game
}

/// A change here is a change of every match that was ever published: explain it, and name it in the CHANGELOG.
#[test]
fn golden_fingerprints_of_matches_are_reached() {
    let noisy = Params {
        half_seconds: 30,
        lost_commands: 0.1,
        lost_detections: 0.1,
        command_delay: 3,
        substeps: 2,
        knockout: true,
        extra_seconds: 5,
        ..Params::default()
    };
    let found = [(exact(), 6000), (Params::default(), 36_000), (noisy, 9000)].map(|(params, frames)| {
        let mut game = Match::new(&params, seed(7));
        play(&mut game, frames);
        format!("{:016x} after {} frames", game.fingerprint(), game.frame())
    });
    assert_eq!(found, GOLDEN);
}

const GOLDEN: [&str; 3] =
    ["976a6fb82c6110e0 after 6000 frames", "f391e3f82ce70824 after 36000 frames", "886c23c946fad718 after 3600 frames"];

#[test]
fn a_match_ends_after_two_halves() {
    let mut game = Match::new(&Params { half_seconds: 20, ..Params::default() }, seed(1));
    play(&mut game, u32::MAX);
    assert_eq!(game.frame(), 2 * 20 * 60);
    let outcome = game.finished().expect("it is over");
    assert_eq!(outcome.score, game.score());
    assert_eq!(game.log().last().expect("a line").command, Command::Halt);
    assert!(!game.step(&STILL) && !game.place(&[PLAIN; 2]), "nothing happens after the end");
    assert!(!game.stage(Kick::KickOff, Side::Left));
    let statistics = game.statistics();
    assert!(statistics.possession.iter().sum::<u32>() <= game.frame());
    assert_eq!(statistics.calls[0][0] + statistics.calls[1][0], 2 + outcome.score[0] + outcome.score[1], "kick-offs");
}

#[test]
fn a_clone_goes_on_as_the_match_itself() {
    let mut game = Match::new(&Params::default(), seed(3));
    play(&mut game, 700);
    let mut copy = game.clone();
    play(&mut game, 900);
    play(&mut copy, 900);
    assert_eq!(game.fingerprint(), copy.fingerprint());
    assert_eq!(game.log(), copy.log());
}

#[test]
fn seeds_differ_by_noise_and_without_noise_by_the_coin_alone() {
    let after = |params: &Params, value| {
        let mut game = Match::new(params, seed(value));
        play(&mut game, 300);
        let robots = game.robots().map(|pose| pose.at);
        (game.log()[0].side, robots)
    };
    assert_ne!(after(&Params::default(), 1).1, after(&Params::default(), 2).1);
    let all: Vec<_> = (0..6).map(|value| after(&exact(), value)).collect();
    for (side, robots) in &all {
        let same = all.iter().find(|other| other.0 == *side).expect("at least itself");
        assert_eq!(same.1, *robots);
    }
}

#[test]
fn exchanged_sides_change_the_colours_and_nothing_else() {
    let exchanged = Params { sides_exchanged: true, ..Params::default() };
    let (mut one, mut other) = (Match::new(&Params::default(), seed(5)), Match::new(&exchanged, seed(5)));
    assert_eq!((one.side_of(Colour::Blue), one.side_of(Colour::Yellow)), (Side::Left, Side::Right));
    assert_eq!((other.side_of(Colour::Blue), other.side_of(Colour::Yellow)), (Side::Right, Side::Left));
    play(&mut one, 600);
    play(&mut other, 600);
    assert_eq!((one.arrangement(), one.log()), (other.arrangement(), other.log()));
}

#[test]
fn the_right_team_sees_the_pitch_turned() {
    let mut game = begun(&exact(), 1);
    play(&mut game, 200);
    let [left, right] = Side::BOTH.map(|side| game.view(side));
    let turned = |[x, y]: [f64; 2]| [-x, -y];
    assert_eq!((right.ball.at, right.ball.velocity), (turned(left.ball.at), turned(left.ball.velocity)));
    for (ours, theirs) in left.ours.iter().zip(&right.theirs) {
        assert_eq!((theirs.at, theirs.velocity, theirs.spin), (turned(ours.at), turned(ours.velocity), ours.spin));
        assert!(((theirs.heading - ours.heading).abs() - PI).abs() < 1e-12);
    }
    assert_eq!((left.frame, left.since), (200, 200));
}

#[test]
fn the_camera_errs_as_much_as_it_is_told() {
    let mut game = begun(&Params::default(), 1);
    let frames = 4000;
    let (mut place, mut heading) = (0.0, 0.0);
    for _ in 0..frames {
        if game.pending(Side::Left).is_some() {
            game.place(&[PLAIN; 2]);
        }
        game.step(&STILL);
        let (seen, is) = (game.view(Side::Left).ours[1], game.robots()[1]);
        place += (seen.at[0] - is.at[0]) * (seen.at[0] - is.at[0]);
        heading += (seen.heading - is.heading) * (seen.heading - is.heading);
    }
    // Five standard errors of a deviation from 4000 draws: 5 / sqrt(8000) = 5.6 %.
    let deviation = |sum: f64| (sum / f64::from(frames)).sqrt();
    assert!((deviation(place) / 0.0015 - 1.0).abs() < 0.056, "{}", deviation(place));
    assert!((deviation(heading) / (0.5 * PI / 180.0) - 1.0).abs() < 0.056, "{}", deviation(heading));
}

#[test]
fn what_the_camera_misses_stays_where_it_was_seen() {
    let mut game = begun(&Params { lost_detections: 1.0, ..exact() }, 1);
    let start = game.view(Side::Left).ours[1];
    let full = Wheels { left: 46.0, right: 46.0 };
    for _ in 0..20 {
        game.step(&[[full; 3], [Wheels::default(); 3]]);
    }
    assert!(game.robots()[1].at[0] > start.at[0] + 0.05);
    assert_eq!(game.view(Side::Left).ours[1], start);
}

#[test]
fn commands_arrive_as_many_frames_later_as_they_are_delayed() {
    for delay in [0, 1, 5, 30] {
        let mut game = begun(&Params { command_delay: delay, ..exact() }, 1);
        let mut frames = 0;
        while game.robots()[0].velocity[0] == 0.0 {
            game.step(&[[Wheels { left: 20.0, right: 20.0 }; 3], [Wheels::default(); 3]]);
            frames += 1;
        }
        assert_eq!(frames, delay + 1);
    }
}

#[test]
fn lost_commands_leave_robots_with_the_one_before() {
    let mut game = begun(&Params { lost_commands: 1.0, ..exact() }, 1);
    for _ in 0..20 {
        game.step(&[[Wheels { left: 20.0, right: 20.0 }; 3]; 2]);
    }
    assert!(game.robots().iter().all(|pose| pose.velocity == [0.0; 2]), "nothing ever arrives");
}

#[test]
fn speeds_that_are_no_numbers_count_as_zero_and_as_faults() {
    let mut game = begun(&exact(), 1);
    let bad = Wheels { left: f64::NAN, right: f64::INFINITY };
    for _ in 0..10 {
        game.step(&[[Wheels::default(), bad, bad], [Wheels { left: 1e300, right: 1e300 }; 3]]);
    }
    assert_eq!(game.statistics().faults, [20, 0]);
    let noted: Vec<Rule> =
        game.log().iter().map(|entry| entry.rule).filter(|rule| matches!(rule, Rule::Fault { .. })).collect();
    assert_eq!(noted, [Rule::Fault { robot: 1 }, Rule::Fault { robot: 2 }], "once for each robot");
    let robots = game.robots();
    assert_eq!(robots[1].velocity, [0.0; 2]);
    assert!(robots.iter().all(|pose| pose.at.iter().all(|place| place.is_finite())));
    assert!(robots[3].velocity[0].abs() <= WHEEL_LIMIT * 0.026 + 1e-9, "motors have their limit");
}

#[test]
fn robots_and_ball_can_be_moved_and_play_goes_on() {
    let mut game = begun(&exact(), 1);
    play(&mut game, 100);
    let before = game.robots();
    let mut scene = game.arrangement();
    scene.robots[0][0] = Spot { at: [-0.3, 0.5], heading: 1.0 };
    scene.ball = Ball { at: [0.1, -0.5], velocity: [0.5, 0.0] };
    game.arrange(&scene).expect("it is possible");
    assert_eq!(game.robots()[0].at, [-0.3, 0.5]);
    assert_eq!(game.robots()[1], before[1], "what is not moved goes on");
    assert_eq!(game.view(Side::Left).ball.at, [0.1, -0.5], "and everybody sees it");
    play(&mut game, 10);
    assert!(game.ball().at[0] > 0.15);
}

#[test]
fn impossible_arrangements_are_refused_in_words() {
    let mut game = begun(&exact(), 1);
    let fingerprint = game.fingerprint();
    let base = game.arrangement();
    let mut refused = |change: &dyn Fn(&mut swarm_playground::soccer::Arrangement)| {
        let mut scene = base;
        change(&mut scene);
        game.arrange(&scene).expect_err("it is refused").to_string()
    };
    assert_eq!(
        refused(&|scene| scene.robots[0][1].at = [-0.4, 0.05]),
        "robot 2 of the left team: expected a place apart from robot 3 of the left team, found an overlap of 25.0 mm"
    );
    assert_eq!(
        refused(&|scene| scene.robots[1][2].at = [0.73, 0.4]),
        "robot 3 of the right team: expected a place on the pitch, found one 17.5 mm into a wall"
    );
    assert_eq!(
        refused(&|scene| scene.ball.at = [-0.2, 0.05]),
        "robot 2 of the left team: expected a place apart from the ball, found an overlap of 9.0 mm"
    );
    assert_eq!(
        refused(&|scene| scene.ball.at = [3.0, 0.0]),
        "the ball: expected a place on the pitch, found one 2171.5 mm into a wall"
    );
    assert_eq!(refused(&|scene| scene.ball.velocity = [5.0, 0.0]), "the ball: expected at most 4 m/s, found 5.0");
    assert_eq!(
        refused(&|scene| scene.robots[1][0].heading = f64::NAN),
        "robot 1 of the right team: expected finite numbers, found one that is none"
    );
    assert_eq!(game.fingerprint(), fingerprint, "nothing was changed");
}

#[test]
fn shots_and_possession_are_counted() {
    let mut game = begun(&exact(), 1);
    let mut scene = game.arrangement();
    scene.robots[0][1] = Spot { at: [0.0, 0.0], heading: 0.0 };
    scene.robots[1] = [[0.3, 0.6], [0.4, 0.6], [0.5, 0.6]].map(|at| Spot { at, heading: PI });
    scene.ball.at = [0.1, 0.0];
    game.arrange(&scene).expect("possible");
    // The robot runs into the ball and brakes: the ball rolls into the goal.
    for frame in 0..90 {
        let speed = if frame < 15 { 46.0 } else { 0.0 };
        let run = Wheels { left: speed, right: speed };
        game.step(&[[Wheels::default(), run, Wheels::default()], [Wheels::default(); 3]]);
    }
    assert_eq!((game.score(), game.statistics().shots), ([1, 0], [1, 0]));
    assert!(game.statistics().possession[0] > 30 && game.statistics().possession[1] == 0);
}

#[test]
fn parameters_are_read_strictly() {
    let read = |mut value: Value| {
        value["world"] = json!("soccer");
        Scenario::read(&value.to_string())
    };
    let scenario = read(json!({"half-seconds": 60, "vision-noise": 0, "knockout": true})).expect("it is right");
    let WorldParams::Soccer(params) = scenario.world else { panic!("a match") };
    assert_eq!((params.half_seconds, params.vision_noise, params.knockout), (60, 0.0, true));
    for (value, path, message) in [
        (json!({"half-second": 60}), "half-second", "unknown field, did you mean \"half-seconds\"?"),
        (json!({"substeps": 0}), "substeps", "expected a whole number from 1 to 32 substeps, found 0"),
        (json!({"vision-noise": -1}), "vision-noise", "expected a number from 0 to 100 mm, found -1"),
        (json!({"knockout": 1}), "knockout", "expected true or false, found 1"),
        (json!({"command-delay": 1.5}), "command-delay", "expected a whole number from 0 to 30 frames, found 1.5"),
    ] {
        let error = read(value).expect_err(path).to_string();
        assert!(error.contains(path) && error.contains(message), "{error}");
    }
}

#[test]
fn every_parameter_is_described_and_its_default_is_allowed() {
    let Ok(Value::Object(fields)) = serde_json::to_value(Params::default()) else { panic!("an object") };
    let described: Vec<_> = parameters().iter().copied().flatten().collect();
    assert_eq!(fields.len(), described.len());
    for parameter in described {
        let default = &fields[parameter.name];
        assert_eq!(parameter.kind.check(default, parameter.unit).as_ref(), Ok(default), "{}", parameter.name);
        assert!(Params::default().set(parameter.name, default));
    }
}
