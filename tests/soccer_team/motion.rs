//! The laws of motion by numbers, and the field in the toy.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{at, gap, view, with};
use std::f64::consts::{FRAC_PI_2, PI};
use swarm_playground::soccer::team::geometry::{dot, time_to_line};
use swarm_playground::soccer::team::motion::{Aim, Field, Motion, meet, spin, wheels};
use swarm_playground::soccer::view::{Ball, Pose, View, Wheels};

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

fn is(told: Wheels, left: f64, right: f64) -> bool {
    near(told.left, left) && near(told.right, right)
}

#[test]
fn wheel_speeds_follow_the_law_and_keep_the_turn() {
    // (v -/+ 0.04 w) / 0.026
    assert!(is(wheels(0.52, 0.0), 20.0, 20.0));
    assert!(is(wheels(0.52, 6.5), 10.0, 30.0));
    assert!(is(spin(1.0), -25.0 * 0.04 / 0.026, 25.0 * 0.04 / 0.026));
    assert!(is(spin(-1.0), 25.0 * 0.04 / 0.026, -25.0 * 0.04 / 0.026));
    // 1.2 m/s would need 46.15 rad/s.
    assert!(is(wheels(1.2, 0.0), 46.0, 46.0));
    // At 18 rad/s the outer wheel has room for 46 * 0.026 - 0.72 = 0.476 m/s.
    let told = wheels(1.2, 18.0);
    assert!(is(told, (0.476 - 0.72) / 0.026, 46.0), "{told:?}");
    assert!(is(wheels(-1.2, 18.0), -46.0, (-0.476 + 0.72) / 0.026));
}

#[test]
fn driving_follows_the_turn_slip_and_approach_laws() {
    let mut motion = Motion::default();
    let course = |error: f64| [libm::cos(error), libm::sin(error)];
    // e = 0.25: w = 8 sqrt(0.25) = 4, slip limit 0.4 * 9.81 / 4 = 0.981, v = 0.981 exp(-0.0625 / 0.98).
    let told = motion.drive([1.0, 0.0], course(0.25), 0.0, f64::INFINITY);
    let v = 0.981 * libm::exp(-0.0625 / 0.98);
    assert!(is(told, (v - 0.16) / 0.026, (v + 0.16) / 0.026), "{told:?}");
    // To the other side; 0.05 from the target the approach limit is 0.25.
    let told = motion.drive([1.0, 0.0], course(-0.25), 0.0, 0.05);
    let v = 0.25 * libm::exp(-0.0625 / 0.98);
    assert!(is(told, (v + 0.16) / 0.026, (v - 0.16) / 0.026), "{told:?}");
    // Curvature 2 per metre at 1.2 m/s: w = 2.4; no error, no limit but the wheels'.
    let told = motion.drive([1.0, 0.0], [1.0, 0.0], 2.0, f64::INFINITY);
    assert!(near(told.right - told.left, 2.0 * 2.4 * 0.04 / 0.026) && near(told.right, 46.0), "{told:?}");
    // 90 degrees off: w = 8 sqrt(pi / 2), and hardly any speed.
    let told = motion.drive([1.0, 0.0], course(FRAC_PI_2), 0.0, f64::INFINITY);
    assert!(near((told.right - told.left) * 0.026 / 0.08, 8.0 * FRAC_PI_2.sqrt()), "{told:?}");
    assert!(told.left + told.right < 5.0);
}

#[test]
fn other_end_leads_beyond_100_degrees_and_not_again_for_half_a_second() {
    let mut motion = Motion::default();
    let course = |degrees: f64| [libm::cos(degrees.to_radians()), libm::sin(degrees.to_radians())];
    let sum = |told: Wheels| told.left + told.right;
    assert!(sum(motion.drive([1.0, 0.0], course(99.0), 0.0, f64::INFINITY)) > 0.0);
    assert!(sum(motion.drive([1.0, 0.0], course(180.0), 0.0, f64::INFINITY)) < -90.0, "backwards at full speed");
    for _ in 0..29 {
        motion.pass();
        assert!(sum(motion.drive([1.0, 0.0], course(0.0), 0.0, f64::INFINITY)) <= 0.0, "turns round rather");
    }
    motion.pass();
    assert!(sum(motion.drive([1.0, 0.0], course(0.0), 0.0, f64::INFINITY)) > 90.0, "forwards again");
}

#[test]
fn spirals_arrive_along_the_wanted_direction() {
    let mut view = view();
    for other in view.ours.iter_mut().chain(&mut view.theirs) {
        other.at = [-0.7, -0.6];
    }
    let arrival = [1.0, 0.0];
    let aim = Aim { at: [0.1, 0.0], arrival: Some(arrival), wide: 0.05, past: 0.0 };
    let field = Field::new(&view, 1, aim, &mut Motion::default(), None);
    let is = |at: [f64; 2], wanted: [f64; 2], tolerance: f64| {
        let found = field.at(at);
        assert!(dot(found, wanted) > 1.0 - tolerance, "at {at:?}: {found:?}");
    };
    // Behind the target straight on; on the inner circles along them; in front of the target away from it, round about.
    is([-0.4, 0.0], arrival, 1e-9);
    is([0.1, 0.0], arrival, 1e-9);
    is([0.18, 0.08], [0.0, 1.0], 1e-9);
    is([0.18, -0.08], [0.0, -1.0], 1e-9);
    is([0.1, 0.16], [-1.0, 0.0], 1e-9);
    // Far out: turned by 90 degrees * (2 - 0.13 / (d + 0.05)) from the outward direction of the nearer centre.
    let d = 0.4;
    let turned = FRAC_PI_2 * (2.0 - 0.13 / (d + 0.05));
    is([0.1, 0.08 + d], [libm::cos(FRAC_PI_2 + turned), libm::sin(FRAC_PI_2 + turned)], 1e-9);
}

#[test]
fn obstacles_are_passed_and_walls_push_back() {
    let mut view = with([0.5, 0.0], [0.0; 2], [[-0.69, 0.0], [-0.4, 0.0], [-0.7, -0.6]]);
    view.theirs = [at(0.0, 0.01), at(0.7, 0.6), at(0.7, -0.6)];
    let field = Field::new(&view, 1, Aim::place([0.5, 0.0]), &mut Motion::default(), None);
    let before = field.at([-0.15, 0.0]);
    assert!(before[1] < -0.2 && before[0] > 0.0, "round the far side of an obstacle on the left: {before:?}");
    assert!(field.at([0.15, 0.0])[0] > 0.99, "past it the way is straight");
    assert!(field.at([0.3, 0.62])[1] < -0.9, "away from the wall");
    // A target at the wall is not pushed away from.
    let field = Field::new(&view, 1, Aim::place([0.5, 0.6]), &mut Motion::default(), None);
    assert!(field.at([0.3, 0.6])[0] > 0.999);
}

#[test]
fn near_a_side_wall_only_the_spiral_on_the_field_side_is_used() {
    let view = View { ours: [at(-0.7, -0.6); 3], theirs: [at(-0.7, -0.6); 3], ..view() };
    let mut motion = Motion::default();
    let aim = |y: f64| Aim { at: [0.0, y], arrival: Some([1.0, 0.0]), wide: 0.05, past: 0.0 };
    // Between target and wall: with both spirals the robot would go round by the wall.
    let above = |motion: &mut Motion, y: f64| Field::new(&view, 1, aim(y), motion, None).at([0.02, y + 0.05]);
    let free = above(&mut motion, 0.39);
    assert!(above(&mut motion, 0.41)[1] < free[1], "on beyond 0.40");
    assert!(above(&mut motion, 0.36)[1] < free[1], "still on above 0.35");
    assert!((above(&mut motion, 0.34)[1] - free[1]).abs() < 1e-6, "off below 0.35");
}

#[test]
fn rolling_balls_are_met_ahead_and_reach_lines_in_time() {
    let ball = Ball { at: [0.0, 0.0], velocity: [0.4, -0.2] };
    // 0.4 m away: half a second ahead.
    assert!(gap(meet(&ball, [-0.4, 0.0]), [0.2, -0.1]) < 1e-12);
    assert!(gap(meet(&Ball { velocity: [9.0, 9.0], ..ball }, [-0.4, 0.0]), [0.72, 0.62]) < 1e-12, "on the pitch");
    // v = 0.7, loss 0.14: way = 0.7 t - 0.07 t^2; after 1 s 0.63.
    let ball = Ball { at: [0.0, 0.3], velocity: [-0.7, 0.0] };
    assert!(near(time_to_line(&ball, -0.63).unwrap(), 1.0));
    // It stops after 0.7^2 / 0.28 = 1.75 m.
    assert!(time_to_line(&ball, -1.76).is_none() && time_to_line(&ball, -1.74).is_some());
    assert!(time_to_line(&ball, 0.1).is_none(), "it moves away");
}

#[test]
fn robot_reaches_a_place_from_anywhere_and_looks_in_the_arrival_direction() {
    let arrival = [libm::cos(0.6), libm::sin(0.6)];
    let aim = Aim { at: [0.1, -0.1], arrival: Some(arrival), wide: 0.06, past: 0.0 };
    for step in 0..24 {
        let angle = f64::from(step) * PI / 12.0;
        let mut view = View { ours: [at(-0.7, 0.6); 3], theirs: [at(0.7, -0.6); 3], ..view() };
        let start = [0.1 + 0.45 * libm::cos(angle), -0.1 + 0.45 * libm::sin(angle)];
        view.ours[1] = Pose { at: start, heading: 2.0 * angle, ..Pose::default() };
        let mut motion = Motion::default();
        let mut came = None;
        for frame in 0..240 {
            let pose = view.ours[1];
            let front = [libm::cos(pose.heading), libm::sin(pose.heading)];
            if came.is_none() && gap(pose.at, aim.at) < 0.02 {
                came = Some((frame, dot(pose.velocity, arrival) / libm::hypot(pose.velocity[0], pose.velocity[1])));
            }
            motion.pass();
            let told = motion.go(&view, 1, front, aim, None);
            let (speed, turn) = ((told.left + told.right) * 0.013, (told.right - told.left) * 0.026 / 0.08);
            let pose = &mut view.ours[1];
            pose.velocity = [speed * front[0], speed * front[1]];
            pose.spin = turn;
            pose.heading += turn / 60.0;
            pose.at = [pose.at[0] + pose.velocity[0] / 60.0, pose.at[1] + pose.velocity[1] / 60.0];
        }
        let (frame, along) = came.unwrap_or_else(|| panic!("from {step} it ends at {:?}", view.ours[1]));
        assert!(frame < 150 && along > 0.95, "from {step}: {frame} frames, cosine {along}");
        let pose = view.ours[1];
        assert!(gap(pose.at, aim.at) < 0.02, "{step}: {pose:?}");
        assert!((libm::cos(pose.heading - 0.6)).abs() > 0.99, "{step}: {pose:?}");
    }
}

#[test]
fn robots_that_are_held_back_off() {
    let held = |at: [f64; 2], front: [f64; 2], told: Wheels| {
        let mut motion = Motion::default();
        let pose = Pose { at, ..Pose::default() };
        let mut answers = (0..36).map(|_| motion.unstick(&pose, front, told));
        assert!(answers.by_ref().take(24).all(|answer| answer == told), "0.4 s of patience");
        let freeing: Vec<_> = answers.collect();
        assert!(freeing.iter().all(|answer| *answer == freeing[0] && near(answer.left, answer.right)));
        freeing[0].left
    };
    let ahead = Wheels { left: 20.0, right: 20.0 };
    // In the open: away from where it wanted to go.
    assert!(held([0.0, 0.0], [1.0, 0.0], ahead) < -20.0);
    assert!(held([0.0, 0.0], [1.0, 0.0], Wheels { left: -20.0, right: -20.0 }) > 20.0);
    // Flush against a wall it cannot turn: away from the wall, whatever it wanted.
    let turns = Wheels { left: -10.0, right: 12.0 };
    assert!(held([0.3, 0.61], [0.0, 1.0], turns) < -20.0);
    assert!(held([0.3, 0.61], [0.0, -1.0], turns) > 20.0);
    // Whoever rests is not held, and whoever moves is not either.
    let mut motion = Motion::default();
    let moving = Pose { velocity: [0.3, 0.0], ..Pose::default() };
    assert!((0..100).all(|_| motion.unstick(&moving, [1.0, 0.0], ahead) == ahead));
    let rests = Wheels::default();
    assert!((0..100).all(|_| motion.unstick(&Pose::default(), [1.0, 0.0], rests) == rests));
}
