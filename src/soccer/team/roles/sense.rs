//! The conditions of role trees.

use super::leaf::{Leaf, What};
use super::player::Robot;
use crate::bt::NodeId;
use crate::soccer::team::geometry::{
    HALF, POST, THEIR_GOAL, cross, distance, dot, in_area, length, minus, side, time_to_line, unit,
};

/// How far out of the goal area a goalkeeper follows a ball that it kicks out.
const KICKED: f64 = 0.15;

/// Whether a condition holds for a robot now.
pub(super) fn sense(robot: &mut Robot, node: NodeId, leaf: &Leaf) -> bool {
    let numbers = leaf.numbers;
    let (me, ball) = (robot.pose(), &robot.scene.view.ball);
    let to_ball = minus(ball.at, me.at);
    match leaf.what {
        What::OffLine => {
            let [x, reach, on, off, _] = numbers;
            let gap = distance(me.at, [x, me.at[1].min(reach).max(-reach)]);
            robot.latch(node, gap > on, gap > off)
        }
        What::ShotComing => {
            let [x, within, on, off, _] = numbers;
            let speed = ball.velocity[0];
            // The time costs a root: only when the speed is worth it.
            let comes = speed < off && time_to_line(ball, x).is_some_and(|seconds| seconds <= within);
            robot.latch(node, comes && speed < on, comes)
        }
        What::BallNear => {
            let gap = length(to_ball);
            robot.latch(node, gap < numbers[0], gap < numbers[1])
        }
        What::BallBesideGoal => {
            let ([deep, clear, ..], [x, y]) = (numbers, ball.at);
            x < deep && y.abs() > POST && distance(ball.at, [-HALF[0], side(y) * POST]) > clear
        }
        What::BallDeep => robot.latch(node, ball.at[0] < numbers[0], ball.at[0] < numbers[1]),
        What::BallForward => robot.latch(node, ball.at[0] > numbers[0], ball.at[0] > numbers[1]),
        What::BallAtWall => {
            let gap = HALF[1] - ball.at[1].abs();
            robot.latch(node, gap < numbers[0], gap < numbers[1])
        }
        What::BallResting => {
            let speed = length(ball.velocity);
            let begins = speed < numbers[0] && in_area(ball.at, true, 0.0);
            robot.latch(node, begins, speed < numbers[1] && in_area(ball.at, true, KICKED))
        }
        What::BehindBall => robot.latch(node, to_ball[0] > numbers[0], to_ball[0] > numbers[1]),
        What::GoalSide => {
            let by = side(ball.at[1]) * to_ball[1];
            robot.latch(node, by > numbers[0], by > numbers[1])
        }
        What::FacingBall => {
            let cosine = dot(unit(to_ball, [1.0, 0.0]), robot.front).abs();
            robot.latch(node, cosine > numbers[0], cosine > numbers[1])
        }
        What::BallInCone => {
            let [on_cosine, on_sine, off_cosine, off_sine, _] = numbers;
            let begins = in_cone(me.at, to_ball, [on_cosine, on_sine]);
            let lasts = in_cone(me.at, to_ball, [off_cosine, off_sine]);
            robot.latch(node, begins, lasts)
        }
        What::ClearAhead => {
            let [cosine, within, ..] = numbers;
            let ahead = unit(minus(THEIR_GOAL, me.at), [1.0, 0.0]);
            robot.scene.view.theirs.iter().all(|other| {
                let way = minus(other.at, me.at);
                let far = length(way);
                far > within || dot(way, ahead) < cosine * far
            })
        }
        What::SecondStriker => robot.scene.first_striker.is_some_and(|first| first != robot.me),
        What::ReturnToLine
        | What::Save
        | What::Spin
        | What::DriveAtBall
        | What::KeepLine
        | What::GuardCorner
        | What::StandAside
        | What::RunAtGoal
        | What::GetBall
        | What::GetBallAlongWall
        | What::WaitBeside
        | What::Rebound
        | What::RunBeside
        | What::KickPenalty
        | What::GuardPenalty => false,
    }
}

/// Whether a direction lies between the other goal's posts as they are seen from `at`, or not farther beyond them than an
/// angle of which `beyond` has cosine and sine.
fn in_cone(at: [f64; 2], way: [f64; 2], beyond: [f64; 2]) -> bool {
    let [cosine, sine] = beyond;
    let [x, y] = way;
    // Turning the way towards the middle of the cone is the same as opening the cone.
    let right = [x * cosine + y * sine, y * cosine - x * sine];
    let left = [x * cosine - y * sine, x * sine + y * cosine];
    let post = |y: f64| minus([THEIR_GOAL[0], y], at);
    x > 0.0 && cross(right, post(POST)) >= 0.0 && cross(post(-POST), left) >= 0.0
}
