//! The skills of role trees: each tells the wheels something and goes on until its tree stops it.

use super::area;
use super::leaf::{Leaf, What};
use super::player::Robot;
use crate::bt::Status;
use crate::soccer::team::duties::Role;
use crate::soccer::team::geometry::{
    FRAMES_PER_SECOND, HALF, OWN_GOAL, POST, ROBOT, THEIR_GOAL, cross, distance, dot, in_area, left_of, length, minus,
    plus, side, time_to_line, times, unit,
};
use crate::soccer::team::motion::{Aim, Obstacle, keep_line, meet, spin};
use crate::soccer::view::{Pose, Wheels};
use std::f64::consts::PI;

/// The spirals lead so far behind the ball, ...
const BEHIND: f64 = 0.04;
/// ... where the robot is as fast as the approach limit allows at this distance.
const PAST: f64 = 0.06;
/// The greatest distance at which the Assistant keeps from the Striker.
const WIDEST: f64 = 0.25;
/// Shots aim so far from the middle of the goal at most.
const SHOT: f64 = 0.14;
/// A ball that is faster than this, metres per second, rolls on by itself.
const ROLLS: f64 = 0.3;
/// A spin that does not turn ends after so many frames.
const SPIN_FRAMES: u32 = 30;

/// Lets a robot do what a leaf says; RUNNING except for a spin that has made its turn.
pub(super) fn act(robot: &mut Robot, leaf: &Leaf) -> Status {
    let (me, view) = (robot.pose(), robot.scene.view);
    let ball = &view.ball;
    match leaf.what {
        What::ReturnToLine => {
            let [x, reach, ..] = leaf.numbers;
            go(robot, Aim::place([x, within(me.at[1], reach)]));
        }
        What::Save => save(robot, leaf),
        What::Spin => return turn(robot),
        What::DriveAtBall => {
            let way = minus(ball.at, me.at);
            straight(robot, unit(way, [1.0, 0.0]));
        }
        What::KeepLine => {
            let [x, reach, share, ..] = leaf.numbers;
            line(robot, x, within(share * ball.at[1], reach));
        }
        What::GuardCorner => {
            let [beside, ..] = leaf.numbers;
            let there = -aside(robot);
            go(robot, Aim::place([ball.at[0].max(0.05 - HALF[0]), there * beside]));
        }
        What::StandAside => {
            let [x, beside, ..] = leaf.numbers;
            let away = aside(robot);
            go(robot, Aim::place([x, away * beside]));
        }
        What::RunAtGoal => run(robot, leaf.numbers[0]),
        What::GetBall => {
            let [away_before, wide, ..] = leaf.numbers;
            let arrival = if ball.at[0] < away_before { minus(ball.at, OWN_GOAL) } else { minus(THEIR_GOAL, ball.at) };
            get(robot, meet(ball, me.at), unit(arrival, [1.0, 0.0]), wide);
        }
        What::GetBallAlongWall => get(robot, meet(ball, me.at), [1.0, 0.0], leaf.numbers[0]),
        What::WaitBeside => {
            let [x, beside, ..] = leaf.numbers;
            let towards = aside(robot);
            go(robot, Aim::place([x, ball.at[1] + towards * beside]));
        }
        What::Rebound => rebound(robot, leaf.numbers),
        What::RunBeside => {
            let [apart, wide, ..] = leaf.numbers;
            let arrival = unit(minus(THEIR_GOAL, ball.at), [1.0, 0.0]);
            let left = left_of(arrival);
            let beside = times(left, apart * side(dot(minus(me.at, ball.at), left)));
            let at = plus(meet(ball, me.at), beside);
            go(robot, Aim { at, arrival: Some(arrival), wide, past: 0.0 });
        }
        What::KickPenalty if ball.at[0] > leaf.numbers[0] => robot.wheels = Wheels::default(),
        What::KickPenalty => {
            let aim = [THEIR_GOAL[0], -robot.scene.penalty_side * 0.144];
            straight(robot, unit(minus(aim, me.at), [1.0, 0.0]));
        }
        What::GuardPenalty => guard_penalty(robot, leaf),
        What::OffLine
        | What::ShotComing
        | What::BallNear
        | What::BallBesideGoal
        | What::BallDeep
        | What::BallForward
        | What::BallAtWall
        | What::BallResting
        | What::BehindBall
        | What::GoalSide
        | What::FacingBall
        | What::BallInCone
        | What::ClearAhead
        | What::SecondStriker => {}
    }
    Status::Running
}

/// Goes to a place to stand on, or as near as the area rule lets it.
fn go(robot: &mut Robot, aim: Aim) {
    go_round(robot, aim, None);
}

fn go_round(robot: &mut Robot, aim: Aim, obstacle: Option<Obstacle>) {
    let aim = area::shut_out(robot.scene, robot.me, aim.at).map_or(aim, Aim::place);
    robot.wheels = robot.state.motion.go(robot.scene.view, robot.me, robot.front, aim, obstacle);
}

/// Goes to a ball so as to meet it in a direction.
fn get(robot: &mut Robot, ball: [f64; 2], arrival: [f64; 2], wide: f64) {
    let at = minus(ball, times(arrival, BEHIND));
    go(robot, Aim { at, arrival: Some(arrival), wide, past: PAST });
}

fn line(robot: &mut Robot, x: f64, y: f64) {
    let pose = robot.pose();
    robot.wheels = keep_line(&mut robot.state.motion, pose, robot.front, x, y);
}

fn straight(robot: &mut Robot, course: [f64; 2]) {
    robot.wheels = robot.state.motion.drive(robot.front, course, 0.0, f64::INFINITY);
}

/// The nearest number to `y` within `reach` of 0.
fn within(y: f64, reach: f64) -> f64 {
    // Not clamp, which panics when a user's reach is negative.
    y.min(reach).max(-reach)
}

/// The keeper goes to where the ball will cross its line, and a little farther when it has to hurry.
fn save(robot: &mut Robot, leaf: &Leaf) {
    let [x, reach, fast, overshoot, _] = leaf.numbers;
    let (me, ball) = (robot.pose(), &robot.scene.view.ball);
    let y = time_to_line(ball, x).map_or(within(ball.at[1], reach), |seconds| {
        let crossing = ball.at[1] + ball.velocity[1] / ball.velocity[0] * (x - ball.at[0]);
        let target = within(crossing, reach);
        let gap = target - me.at[1];
        if gap.abs() > fast * seconds { within(target + side(gap) * overshoot, reach) } else { target }
    });
    line(robot, x, y);
}

/// The penalty defender stands where the line from the nearest opponent through the ball meets its own.
fn guard_penalty(robot: &mut Robot, leaf: &Leaf) {
    let [x, reach, ..] = leaf.numbers;
    let view = robot.scene.view;
    let ball = view.ball.at;
    let way = |pose: &&Pose| distance(pose.at, ball);
    let nearest = view.theirs.iter().min_by(|one, other| way(one).total_cmp(&way(other)));
    let y = nearest.map_or(0.0, |kicker| {
        let kick = minus(ball, kicker.at);
        // Only from behind the ball does the line lead to the goal.
        if kick[0] < -0.005 { ball[1] + kick[1] / kick[0] * (x - ball[0]) } else { ball[1] }
    });
    line(robot, x, within(y, reach));
}

/// Runs at the goal with the ball in front: where the line through the ball meets the goal, or the nearest place within
/// it; the farther the ball is off the way there, the more the robot turns towards it.
fn run(robot: &mut Robot, release: f64) {
    let (me, ball) = (robot.pose().at, robot.scene.view.ball.at);
    if ball[0] > release && length(robot.scene.view.ball.velocity) > ROLLS {
        robot.wheels = Wheels::default();
        return;
    }
    if let Some(place) = area::shut_out(robot.scene, robot.me, ball) {
        go(robot, Aim::place(place));
        return;
    }
    let way = minus(ball, me);
    let y = if way[0] > 0.005 { ball[1] + way[1] / way[0] * (THEIR_GOAL[0] - ball[0]) } else { 0.0 };
    let shot = unit(minus([THEIR_GOAL[0], y.clamp(-SHOT, SHOT)], ball), [1.0, 0.0]);
    let off = minus(way, times(shot, dot(way, shot)));
    straight(robot, unit(plus(shot, times(off, 8.0)), shot));
}

/// The Assistant's place.
fn rebound(robot: &mut Robot, [share, lag, least, most, part]: [f64; 5]) {
    let (view, roles) = (robot.scene.view, &robot.scene.roles);
    let ball = view.ball.at;
    let leads = |role: &Role| matches!(role, Role::Striker | Role::PenaltyKicker);
    let leader = roles.iter().position(leads).filter(|leader| *leader != robot.me);
    let ahead = leader.map_or(ball, |leader| view.ours[leader].at);
    let room = HALF[1] - 0.05;
    let x = (share * ahead[0] - lag).max(least).min(most);
    let y = within(ahead[1] - part * ball[1], room);
    let mut aim = Aim::place([x, y]);
    if in_area(ahead, false, 0.0) {
        aim.at = area::outside(aim.at, false);
    }
    let obstacle = leader.map(|robot| Obstacle { robot, radius: distance(ahead, ball).min(WIDEST) });
    go_round(robot, aim, obstacle);
}

/// The side away from the ball; it changes once the ball is a robot's length on the other side.
fn aside(robot: &mut Robot) -> f64 {
    let y = robot.scene.view.ball.at[1];
    if robot.state.aside == 0.0 || y * robot.state.aside > ROBOT {
        robot.state.aside = -side(y);
    }
    robot.state.aside
}

/// Turns so that the side at the ball carries it away from the own goal, or in the other half towards the other one.
fn turn(robot: &mut Robot) -> Status {
    let (me, ball) = (robot.pose(), robot.scene.view.ball.at);
    let wanted = if ball[0] < 0.0 { minus(ball, OWN_GOAL) } else { minus(THEIR_GOAL, ball) };
    // A point at `arm` from the centre moves to the left of `arm` when the robot turns to the left.
    let arm = minus(ball, me.at);
    robot.wheels = spin(cross(arm, wanted));
    robot.state.turned += me.spin.abs() / FRAMES_PER_SECOND;
    robot.state.spinning += 1;
    if robot.state.turned < 2.0 * PI && robot.state.spinning < SPIN_FRAMES {
        return Status::Running;
    }
    (robot.state.turned, robot.state.spinning) = (0.0, 0);
    Status::Success
}

const _: () = assert!(SHOT < POST, "shots go into the goal");
