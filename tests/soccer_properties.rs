//! Laws under any commands: nothing goes through anything, nothing explodes, and a match never hangs.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use swarm_playground::random::Seed;
use swarm_playground::soccer::physics::{BALL, Drive, Physics, ROBOTS};
use swarm_playground::soccer::pitch::Side;
use swarm_playground::soccer::view::{Lineup, Slot, Spot, Wheels};
use swarm_playground::soccer::{Match, Params};

/// Where all robots press toward, whether some of them spin instead, and for how many frames.
fn targets() -> impl Strategy<Value = Vec<([f64; 2], bool, u32)>> {
    prop::collection::vec((prop::array::uniform2(-0.8..0.8_f64), any::<bool>(), 10..120_u32), 8..24)
}

fn check(physics: &Physics, frame: u32) -> Result<(), TestCaseError> {
    for overlap in physics.overlaps() {
        prop_assert!(overlap.depth <= 0.002, "frame {frame}: {overlap:?}");
    }
    for body in 0..=BALL {
        let [x, y] = physics.at(body);
        prop_assert!(x.abs() < 0.85 && y.abs() < 0.65, "frame {frame}: body {body} is at {x}, {y}");
        let [vx, vy] = physics.velocity(body);
        let most = if body == BALL { 4.0 } else { 2.5 };
        prop_assert!(vx * vx + vy * vy <= most * most, "frame {frame}: body {body} moves at {vx}, {vy}");
    }
    Ok(())
}

fn start(substeps: u32) -> Physics {
    let mut physics = Physics::new(substeps);
    for robot in 0..ROBOTS {
        physics.put_robot(robot, [-0.5 + 0.2 * robot as f64, 0.1], 0.3 * robot as f64);
    }
    physics.put_ball([0.0, -0.1], [0.0; 2], [0.0; 2]);
    physics
}

/// Full speed toward a place, forward or backward; with `whirl` the first robot of each team spins instead.
fn toward(physics: &Physics, robot: usize, to: [f64; 2], whirl: bool) -> Drive {
    if whirl && robot.is_multiple_of(3) {
        return Drive::of(Wheels { left: -46.0, right: 46.0 }, 1.0);
    }
    let at = physics.at(robot);
    let heading = physics.heading(robot);
    let (sin, cos) = libm::sincos(heading);
    let (ahead, left) = ((to[0] - at[0]) * cos + (to[1] - at[1]) * sin, (to[1] - at[1]) * cos - (to[0] - at[0]) * sin);
    let turn = 20.0 * left.clamp(-1.0, 1.0);
    let speed = if ahead < 0.0 { -46.0 } else { 46.0 };
    Drive::of(Wheels { left: speed - turn, right: speed + turn }, 1.0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn pile_ups_at_one_place_stay_whole(
        targets in targets(),
        substeps in prop::sample::select(vec![2_u32, 4, 8]),
    ) {
        let mut physics = start(substeps);
        let mut frame = 0;
        for (to, whirl, frames) in targets {
            for _ in 0..frames {
                let drives = std::array::from_fn(|robot| toward(&physics, robot, to, whirl));
                physics.step(&drives);
                frame += 1;
                check(&physics, frame)?;
            }
        }
    }

    #[test]
    fn all_robots_on_the_ball_stay_whole(seconds in 20..40_u32, turn in -40.0..40.0_f64) {
        let mut physics = start(4);
        for frame in 0..seconds * 60 {
            let ball = physics.at(BALL);
            let mut drives: [Drive; ROBOTS] = std::array::from_fn(|robot| toward(&physics, robot, ball, false));
            drives[1].turn += turn;
            physics.step(&drives);
            check(&physics, frame)?;
        }
    }

    #[test]
    fn random_commands_keep_everything_on_the_pitch(
        commands in prop::collection::vec((prop::array::uniform12(-60.0..60.0_f64), 1..40_u32), 20..60),
    ) {
        let mut physics = start(4);
        let mut frame = 0;
        for (wheels, frames) in commands {
            let drives = std::array::from_fn(|robot| {
                Drive::of(Wheels { left: wheels[2 * robot], right: wheels[2 * robot + 1] }, 1.0)
            });
            for _ in 0..frames {
                physics.step(&drives);
                frame += 1;
                check(&physics, frame)?;
            }
        }
    }

    #[test]
    fn a_match_of_any_commands_and_line_ups_ends_in_time(
        seed in 0..1000_u64,
        knockout in any::<bool>(),
        wheels in prop::collection::vec(speed(), 60..200),
        lineups in prop::collection::vec(lineup(), 4..12),
    ) {
        let params = Params { half_seconds: 20, extra_seconds: 5, knockout, ..Params::default() };
        let mut game = Match::new(&params, Seed::new(seed).expect("small"));
        let most = 60 * (2 * 20 + 2 * 5 + 40 * 10);
        let mut call = 0;
        while game.finished().is_none() {
            if game.pending(Side::Left).is_some() {
                game.place(&[lineups[call % lineups.len()], lineups[(call + 1) % lineups.len()]]);
                call += 1;
            }
            let at = (game.frame() / 7) as usize;
            let of = |robot: usize| Wheels {
                left: wheels[(at + 3 * robot) % wheels.len()],
                right: wheels[(at + 5 * robot) % wheels.len()],
            };
            game.step(&[[of(0), of(1), of(2)], [of(3), of(4), of(5)]]);
            prop_assert!(game.frame() <= most);
            for pose in game.robots() {
                let [x, y] = pose.at;
                prop_assert!(x.abs() < 0.85 && y.abs() < 0.65, "frame {}: {pose:?}", game.frame());
            }
            let [x, y] = game.ball().at;
            prop_assert!(x.abs() < 0.85 && y.abs() < 0.65, "frame {}: the ball is at {x}, {y}", game.frame());
        }
        let outcome = game.finished().expect("it is over");
        prop_assert_eq!(outcome.winner.is_none(), !knockout && outcome.score[0] == outcome.score[1]);
    }
}

/// A wheel's speed; at times no number.
fn speed() -> impl Strategy<Value = f64> {
    prop_oneof![20 => -60.0..60.0_f64, 1 => Just(f64::NAN), 1 => Just(f64::INFINITY), 1 => Just(-1e300)]
}

/// A line-up; at times with slots named twice or places that cannot be.
fn lineup() -> impl Strategy<Value = Lineup> {
    let slot = prop_oneof![Just(Slot::Goalkeeper), Just(Slot::Attacker), Just(Slot::Supporter)];
    let place = prop_oneof![10 => -0.8..0.8_f64, 1 => Just(f64::NAN), 1 => Just(1e300)];
    let own = (prop::array::uniform2(place), -4.0..4.0_f64).prop_map(|(at, heading)| Spot { at, heading });
    let spots = prop::array::uniform3(prop::option::of(own));
    (prop::array::uniform3(slot), spots).prop_map(|(slots, spots)| Lineup { slots, spots })
}
