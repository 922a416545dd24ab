//! The seven roles: which state they are in, and what the toy robot does in it.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{Toy, at, gap, with};
use std::f64::consts::TAU;
use swarm_playground::bt::Status::{Failure, Success};
use swarm_playground::soccer::team::Role;
use swarm_playground::soccer::view::{Pose, View, Wheels};

fn scene(role: Role, ball: [f64; 2], velocity: [f64; 2], me: [f64; 2]) -> Toy {
    let mut view = with(ball, velocity, [[-0.69, 0.0], me, [-0.2, -0.55]]);
    view.theirs = [at(0.69, 0.0), at(0.6, 0.6), at(0.6, -0.6)];
    Toy::new(role, &view)
}

/// Seconds of the toy, as many frames as that.
fn run(toy: &mut Toy, seconds: f64) {
    toy.run((seconds * 60.0) as u32, |_| false);
}

fn spins(toy: &mut Toy) -> bool {
    let told = toy.tell();
    (told.left + told.right).abs() < 1e-9 && told.left.abs() > 38.0
}

#[test]
fn goalkeeper_returns_to_its_line_and_follows_the_ball_on_it() {
    let mut keeper = scene(Role::Goalkeeper, [0.0, 0.1], [0.0; 2], [-0.40, 0.3]);
    run(&mut keeper, 2.0);
    assert!(gap(keeper.pose().at, [-0.69, 0.1]) < 0.015, "{:?}", keeper.pose());
    // Looking along its line, ready for both sides.
    assert!(libm::sin(keeper.pose().heading).abs() > 0.99);
    // Far balls are followed within the goal, close ones beside it.
    keeper.view.ball.at = [-0.3, 0.5];
    run(&mut keeper, 1.0);
    assert!(gap(keeper.pose().at, [-0.69, 0.20]) < 0.015, "{:?}", keeper.pose());
    keeper.view.ball.at = [-0.61, 0.5];
    run(&mut keeper, 1.0);
    assert!(gap(keeper.pose().at, [-0.69, 0.35]) < 0.015, "{:?}", keeper.pose());
    // The close state lasts up to -0.57.
    keeper.view.ball.at = [-0.58, 0.30];
    run(&mut keeper, 1.0);
    assert!(gap(keeper.pose().at, [-0.69, 0.30]) < 0.015, "{:?}", keeper.pose());
}

#[test]
fn goalkeeper_saves_where_the_ball_will_cross() {
    // From (0, 0.3) at (-1, -0.3): crosses x = -0.69 at y = 0.3 - 0.207 = 0.093 after 0.75 s or so.
    let mut keeper = scene(Role::Goalkeeper, [0.0, 0.3], [-1.0, -0.3], [-0.69, -0.15]);
    keeper.view.ours[1].heading = 1.6;
    let crossed = keeper.run(60, |toy| toy.view.ball.at[0] < -0.66).expect("the ball comes");
    assert!(crossed > 35);
    assert!((keeper.pose().at[1] - 0.093).abs() < 0.03, "{:?}", keeper.pose());
}

#[test]
fn goalkeeper_clears_beside_the_goal_with_one_turn_and_never_before_the_mouth() {
    // Beside the goal: 0.14 from the post at (-0.75, 0.2).
    let mut keeper = scene(Role::Goalkeeper, [-0.66, 0.31], [0.0; 2], [-0.69, 0.25]);
    assert!(spins(&mut keeper));
    // The ball lies ahead of the keeper: turned to the left, the side at the ball carries it outward.
    assert!(keeper.tell().left < 0.0);
    let mut mouth = scene(Role::Goalkeeper, [-0.66, 0.10], [0.0; 2], [-0.69, 0.05]);
    assert!(!spins(&mut mouth));
}

#[test]
fn spin_ends_after_one_turn() {
    let mut keeper = scene(Role::PenaltyDefender, [-0.66, 0.05], [0.0; 2], [-0.71, 0.05]);
    assert!(spins(&mut keeper));
    // 25 rad/s for 2 pi: 15.08 frames.
    let mut turned = 0.0;
    for _ in 0..16 {
        let before = keeper.pose().heading;
        keeper.frame();
        turned += (keeper.pose().heading - before).abs();
    }
    assert!(turned > TAU && turned < TAU + 0.6, "{turned}");
}

#[test]
fn fullback_guards_its_line_and_the_corner_where_the_ball_is() {
    let mut fullback = scene(Role::Fullback, [0.2, 0.5], [0.0; 2], [-0.3, 0.0]);
    run(&mut fullback, 2.0);
    assert!(gap(fullback.pose().at, [-0.50, 0.30]) < 0.015, "{:?}", fullback.pose());
    fullback.view.ball.at = [-0.65, 0.6];
    run(&mut fullback, 3.0);
    assert!(gap(fullback.pose().at, [-0.65, 0.46]) < 0.02, "{:?}", fullback.pose());
    fullback.view.ball.at = [-0.65, 0.52];
    assert!(spins(&mut fullback));
}

#[test]
fn fullback_stays_out_of_its_own_area_while_the_keeper_is_in_it() {
    let mut fullback = scene(Role::Fullback, [-0.65, 0.0], [0.0; 2], [-0.45, 0.1]);
    let mut entered = false;
    fullback.run(240, |toy| {
        let [x, y] = toy.pose().at;
        entered |= x < -0.60 && y.abs() < 0.35;
        false
    });
    assert!(!entered);
}

#[test]
fn wingback_steps_aside_counters_and_chases() {
    let mut wingback = scene(Role::Wingback, [-0.62, 0.4], [0.0; 2], [-0.2, 0.2]);
    run(&mut wingback, 2.0);
    assert!(gap(wingback.pose().at, [-0.52, -0.30]) < 0.02, "{:?}", wingback.pose());
    // Behind the ball with nobody ahead: at full speed at the goal.
    let mut counter = scene(Role::Wingback, [0.0, 0.0], [0.0; 2], [-0.07, 0.0]);
    assert!(counter.tell().left > 40.0);
    // An opponent in the cone: the ball is got, slowly at the last.
    counter = scene(Role::Wingback, [0.0, 0.0], [0.0; 2], [-0.07, 0.0]);
    counter.view.theirs[1] = at(0.2, 0.02);
    assert!(counter.tell().left < 20.0);
    // Deep in the own half it aims away from the own goal: at (-0.4, 0.3) along (0.35, 0.3).
    let mut chase = scene(Role::Wingback, [-0.4, 0.3], [0.0; 2], [-0.1, 0.5]);
    chase.run(200, |toy| gap(toy.pose().at, toy.view.ball.at) < 0.065).expect("it gets the ball");
    let way = [-0.4 - chase.pose().at[0], 0.3 - chase.pose().at[1]];
    assert!((way[0] * 0.35 + way[1] * 0.3) / (gap(way, [0.0; 2]) * gap([0.35, 0.3], [0.0; 2])) > 0.8, "{way:?}");
}

#[test]
fn striker_gets_behind_the_ball_and_shoots() {
    for start in [[0.4, 0.2], [0.3, -0.3], [-0.3, 0.1], [0.2, 0.0]] {
        let mut striker = scene(Role::Striker, [0.1, 0.1], [0.0; 2], start);
        let shoots =
            |toy: &Toy| gap(toy.pose().at, toy.view.ball.at) < 0.078 && gap(toy.pose().velocity, [0.0; 2]) > 1.1;
        striker.run(240, shoots).unwrap_or_else(|| panic!("{start:?}"));
        // Arrival toward the goal centre: from (0.1, 0.1) along (0.65, -0.1).
        let way = [0.1 - striker.pose().at[0], 0.1 - striker.pose().at[1]];
        assert!(way[0] / gap(way, [0.0; 2]) > 0.85, "{start:?}: {way:?}");
    }
}

#[test]
fn striker_waits_beside_a_deep_ball_towards_the_middle() {
    let mut striker = scene(Role::Striker, [-0.55, 0.3], [0.0; 2], [0.0, 0.0]);
    run(&mut striker, 2.0);
    assert!(gap(striker.pose().at, [-0.425, 0.075]) < 0.02, "{:?}", striker.pose());
    // The side changes only once the ball is a robot's length beyond the middle.
    striker.view.ball.at = [-0.55, -0.05];
    run(&mut striker, 2.0);
    assert!(gap(striker.pose().at, [-0.425, -0.275]) < 0.02, "{:?}", striker.pose());
    striker.view.ball.at = [-0.55, -0.10];
    run(&mut striker, 2.0);
    assert!(gap(striker.pose().at, [-0.425, 0.125]) < 0.02, "{:?}", striker.pose());
}

#[test]
fn striker_takes_the_ball_along_the_wall_and_crosses_in_the_far_corner() {
    let mut wall = scene(Role::Striker, [0.2, 0.60], [0.0; 2], [-0.1, 0.3]);
    wall.run(240, |toy| gap(toy.pose().at, toy.view.ball.at) < 0.065).expect("it gets the ball");
    assert!(wall.pose().at[1] > 0.55 && wall.pose().at[0] < 0.2, "{:?}", wall.pose());
    let mut corner = scene(Role::Striker, [0.62, 0.60], [0.0; 2], [0.56, 0.58]);
    assert!(spins(&mut corner));
    // Across, towards the goal: the ball is ahead of the robot and has to go right.
    assert!(corner.tell().left > 0.0);
}

#[test]
fn second_striker_goes_beside_the_ball() {
    let mut second = scene(Role::Striker, [0.1, 0.1], [0.0; 2], [-0.2, 0.3]);
    second.first_striker = Some(2);
    run(&mut second, 2.0);
    assert!((gap(second.pose().at, [0.1, 0.1]) - 0.15).abs() < 0.02, "{:?}", second.pose());
}

#[test]
fn assistant_waits_behind_the_striker_on_the_other_side() {
    let mut assistant = scene(Role::Assistant, [0.3, 0.2], [0.0; 2], [-0.2, 0.0]);
    assistant.told = [Role::Goalkeeper, Role::Assistant, Role::Striker];
    assistant.view.ours[2] = at(0.25, 0.2);
    run(&mut assistant, 2.5);
    // x = 0.8 * 0.25 - 0.15 = 0.05, y = 0.2 - 0.7 * 0.2 = 0.06
    assert!(gap(assistant.pose().at, [0.05, 0.06]) < 0.02, "{:?}", assistant.pose());
    // The Striker in the area: x would be 0.41; never above 0.50, never in the area.
    assistant.view.ball.at = [0.70, 0.1];
    assistant.view.ours[2] = at(0.66, 0.1);
    run(&mut assistant, 2.5);
    assert!(assistant.pose().at[0] < 0.55, "{:?}", assistant.pose());
}

#[test]
fn only_the_nearest_field_player_enters_the_other_area() {
    for (other, enters) in [([0.69, 0.02], false), ([0.2, 0.5], true)] {
        let mut striker = scene(Role::Striker, [0.66, 0.0], [0.0; 2], [0.3, 0.2]);
        striker.told = [Role::Goalkeeper, Role::Striker, Role::Assistant];
        striker.view.ours[2] = Pose { at: other, ..Pose::default() };
        striker.view.theirs[0] = at(0.7, 0.3);
        let entered = striker.run(180, |toy| toy.pose().at[0] > 0.60 && toy.pose().at[1].abs() < 0.35).is_some();
        assert_eq!(entered, enters, "{other:?}");
    }
}

#[test]
fn penalty_kicker_drives_straight_through_the_ball_at_full_speed() {
    let mut kicker = scene(Role::PenaltyKicker, [0.375, 0.0], [0.0; 2], [0.285, 0.0225]);
    kicker.view.ours[1].heading = libm::atan2(-0.144 - 0.0225, 0.75 - 0.285);
    let told = kicker.tell();
    assert!(told.left > 45.0 && told.right > 45.0, "{told:?}");
    let frames = kicker.run(10, |toy| toy.pose().at[0] > 0.375).expect("at 1.2 m/s it needs 5 frames");
    assert!(frames < 6);
    assert!(kicker.pose().at[1].abs() < 0.0215);
}

#[test]
fn penalty_defender_follows_the_line_of_the_kicker() {
    let mut defender = scene(Role::PenaltyDefender, [-0.375, 0.0], [0.0; 2], [-0.7125, 0.0]);
    // Kicker at (-0.275, 0.03): the line goes on to y = -0.03 * 0.3375 / 0.1 = -0.101 at x = -0.7125.
    defender.view.theirs[1] = at(-0.275, 0.03);
    run(&mut defender, 1.0);
    assert!(gap(defender.pose().at, [-0.7125, -0.101]) < 0.015, "{:?}", defender.pose());
    // Never more than 0.15 out of the middle.
    defender.view.theirs[1] = at(-0.275, 0.09);
    run(&mut defender, 1.0);
    assert!(gap(defender.pose().at, [-0.7125, -0.15]) < 0.015, "{:?}", defender.pose());
}

#[test]
fn thresholds_of_a_state_hold_it_between_on_and_off() {
    // The keeper's return state: begins beyond 0.165 of its line, lasts beyond 0.10.
    let far = |x: f64| -> View {
        let mut view = with([0.3, 0.0], [0.0; 2], [[0.0, 0.5], [x, 0.0], [0.0, -0.5]]);
        view.ours[1].heading = 0.0;
        view
    };
    // On the line the keeper would face along it; returning it drives straight back.
    let drives_back = |toy: &mut Toy| {
        let told = toy.tell();
        told.left < -10.0 && (told.left - told.right).abs() < 1.0
    };
    let mut toy = Toy::new(Role::Goalkeeper, &far(-0.50));
    assert!(drives_back(&mut toy), "0.19 away");
    toy.view = far(-0.57);
    assert!(drives_back(&mut toy), "0.12 away, still returning");
    let mut statuses = Vec::new();
    let mut watch = |toy: &mut Toy, x: f64| {
        toy.view = far(x);
        let scene = swarm_playground::soccer::team::roles::Scene {
            view: &toy.view,
            roles: toy.told,
            first_striker: None,
            penalty_side: 1.0,
        };
        statuses.clear();
        toy.player.play(&toy.roles, &scene, 1, 16, &mut statuses).expect("no error");
        // The first node that returns is the condition OffLine.
        statuses[0].1
    };
    let found = [-0.50, -0.57, -0.60, -0.57, -0.50].map(|x| watch(&mut toy, x));
    assert_eq!(found, [Success, Success, Failure, Failure, Success]);
}

#[test]
fn goalkeeper_kicks_a_resting_ball_out_of_the_area() {
    let mut keeper = scene(Role::Goalkeeper, [-0.64, 0.1], [0.0; 2], [-0.69, 0.1]);
    assert!(keeper.run(20, |toy| toy.pose().at[0] > -0.66).is_some(), "{:?}", keeper.pose());
    // It does not leave its line for a ball outside the area, nor for one behind it.
    for ball in [[-0.64, 0.45], [-0.72, 0.1]] {
        let mut keeper = scene(Role::Goalkeeper, ball, [0.0; 2], [-0.69, 0.1]);
        run(&mut keeper, 1.0);
        assert!((keeper.pose().at[0] + 0.69).abs() < 0.02, "{:?}", keeper.pose());
    }
}

#[test]
fn goalkeeper_gets_between_the_goal_and_a_ball_beside_it() {
    let mut keeper = scene(Role::Goalkeeper, [-0.72, 0.26], [0.0; 2], [-0.66, 0.30]);
    assert!(keeper.run(60, |toy| toy.pose().at[1] < 0.24).is_some(), "{:?}", keeper.pose());
    // Then it drives at the ball, outward.
    let outward = keeper.run(60, |toy| toy.pose().velocity[1] > 0.2);
    assert!(outward.is_some(), "{:?}", keeper.pose());
}

#[test]
fn runs_at_the_goal_end_with_a_rolling_ball() {
    let shot = |ball: [f64; 2], velocity: [f64; 2]| {
        let mut striker = scene(Role::Striker, ball, velocity, [ball[0] - 0.06, ball[1]]);
        striker.tell()
    };
    let runs = shot([0.36, 0.0], [1.0, 0.0]);
    assert!(runs.left > 40.0 && runs.right > 40.0, "{runs:?}");
    assert_eq!(shot([0.42, 0.0], [1.0, 0.0]), Wheels::default());
    // A ball that rests there is kicked first.
    let kicks = shot([0.42, 0.0], [0.1, 0.0]);
    assert!(kicks.left > 40.0 && kicks.right > 40.0, "{kicks:?}");
}

#[test]
fn nobody_pushes_an_opponent_that_has_the_ball_in_its_area() {
    for (keeper, enters) in [([0.72, 0.0], false), ([0.69, 0.30], true)] {
        let mut striker = scene(Role::Striker, [0.67, 0.0], [0.0; 2], [0.3, 0.2]);
        striker.view.theirs[0] = at(keeper[0], keeper[1]);
        let entered = striker.run(180, |toy| toy.pose().at[0] > 0.60).is_some();
        assert_eq!(entered, enters, "{keeper:?}");
    }
}

#[test]
fn ways_lead_round_the_own_area_while_a_goalkeeper_is_in_it() {
    // From one side of the area to the other.
    let mut fullback = scene(Role::Fullback, [-0.66, 0.55], [0.0; 2], [-0.68, -0.46]);
    let entered = fullback.run(300, |toy| toy.pose().at[0] < -0.60 && toy.pose().at[1].abs() < 0.35);
    assert_eq!(entered, None, "{:?}", fullback.pose());
    assert!(fullback.pose().at[1] > 0.40, "{:?}", fullback.pose());
}
