//! Where bodies touch: robots with robots and walls by separating axes, the ball by closest points.
//!
//! Walls are compared in the quarter of the pitch where both coordinates are positive, to which everything is mirrored:
//! no side of the pitch is treated in another way than the others.

use super::body::Body;
use super::{BALL, WALL};
use crate::soccer::pitch::{BALL_RADIUS, CORNER, GOAL_BACK, GOAL_HALF, HALF_LENGTH, HALF_WIDTH, ROBOT};

/// Half of a robot's side.
const HALF: f64 = ROBOT / 2.0;
/// Half of a robot's diagonal, rounded up: nothing of the robot is farther from its centre.
const REACH: f64 = 0.0531;
const ROOT_HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// A point where two bodies overlap.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// The bodies: robots 0 to 5, the ball, or the walls, which are always `b`.
    pub a: usize,
    /// The other body.
    pub b: usize,
    /// The unit vector from `a` to `b`, across the surface.
    pub normal: [f64; 2],
    /// The point, from the centre of `a`.
    pub from_a: [f64; 2],
    /// The point, from the centre of `b`; zero for walls.
    pub from_b: [f64; 2],
    /// How far they overlap, metres.
    pub depth: f64,
    /// Which corner, side or wall it is: the same as long as the bodies touch in the same way, and rising in the order in
    /// which touches are found.
    pub key: u32,
}

/// Keys of a pair of bodies begin with this.
fn pair(a: usize, b: usize) -> u32 {
    let order = match (a, b) {
        (BALL, _) => 96,
        (robot, BALL) => 80 + robot,
        (robot, WALL) => 64 + robot,
        (a, b) => 8 * a + b,
    };
    (order as u32) << 8
}

/// Finds every overlap, in a fixed order: robots with robots, robots with walls, the ball with robots, the ball with
/// walls. Most pairs are told apart by their distance alone.
pub fn find(bodies: &[Body; WALL + 1], touches: &mut Vec<Touch>) {
    for a in 0..BALL {
        for b in a + 1..BALL {
            let (dx, dy) = (bodies[b].at[0] - bodies[a].at[0], bodies[b].at[1] - bodies[a].at[1]);
            if dx * dx + dy * dy < 4.0 * REACH * REACH {
                robots(bodies, a, b, touches);
            }
        }
    }
    for (robot, body) in bodies[..BALL].iter().enumerate() {
        if near_wall(body.at, REACH) {
            robot_walls(robot, body, touches);
        }
    }
    let ball = bodies[BALL].at;
    for (robot, body) in bodies[..BALL].iter().enumerate() {
        let (dx, dy) = (ball[0] - body.at[0], ball[1] - body.at[1]);
        let reach = REACH + BALL_RADIUS;
        if dx * dx + dy * dy < reach * reach {
            ball_robot(robot, body, [dx, dy], touches);
        }
    }
    if near_wall(ball, BALL_RADIUS) {
        ball_walls(ball, touches);
    }
}

/// Whether a disc could touch a wall.
fn near_wall([x, y]: [f64; 2], radius: f64) -> bool {
    let (x, y) = (x.abs(), y.abs());
    x > HALF_LENGTH - radius || y > HALF_WIDTH - radius || x + y > CORNER - radius / ROOT_HALF
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Two robots. They are squares of one size, so the sum of both extents is the same along all four axes that could
/// separate them: half (1 + |cos| + |sin|) of the angle between them.
fn robots(bodies: &[Body; WALL + 1], a: usize, b: usize, touches: &mut Vec<Touch>) {
    let [at_a, at_b] = [bodies[a].at, bodies[b].at];
    let [front_a, front_b] = [bodies[a].front, bodies[b].front];
    let between = [at_b[0] - at_a[0], at_b[1] - at_a[1]];
    let turned = [dot(front_a, front_b), front_a[0] * front_b[1] - front_a[1] * front_b[0]];
    let extent = HALF * (1.0 + turned[0].abs() + turned[1].abs());
    let left = |front: [f64; 2]| [-front[1], front[0]];
    let axes = [front_a, left(front_a), front_b, left(front_b)];
    let mut best = 0;
    let mut farthest = -1.0;
    for (axis, &along) in axes.iter().enumerate() {
        let distance = dot(between, along).abs();
        // The margin keeps the choice from changing with the last bits where two axes are alike.
        if distance > farthest + 1e-9 {
            farthest = distance;
            best = axis;
        }
    }
    if farthest >= extent {
        return;
    }
    // The robot whose face it is, and the one whose edge goes into that face.
    let of_a = best < 2;
    let (owner, other, towards) = if of_a { (at_a, at_b, between) } else { (at_b, at_a, [-between[0], -between[1]]) };
    let chosen = axes[best];
    let sign = if dot(towards, chosen) < 0.0 { -1.0 } else { 1.0 };
    let normal = [chosen[0] * sign, chosen[1] * sign];
    let along = left(normal);
    let edge_axes = if of_a { [axes[2], axes[3]] } else { [axes[0], axes[1]] };
    let facing = [dot(normal, edge_axes[0]), dot(normal, edge_axes[1])];
    let (out, side, facing) = if facing[0].abs() > facing[1].abs() {
        (edge_axes[0], edge_axes[1], facing[0])
    } else {
        (edge_axes[1], edge_axes[0], facing[1])
    };
    let half = if facing > 0.0 { -HALF } else { HALF };
    let middle = [other[0] - owner[0] + out[0] * half, other[1] - owner[1] + out[1] * half];
    // The edge's ends in the face's frame: across it and along it.
    let (across, across_step) = (dot(middle, normal), dot(side, normal) * HALF);
    let (place, place_step) = (dot(middle, along), dot(side, along) * HALF);
    for (number, end) in [-1.0, 1.0].into_iter().enumerate() {
        let (mut deep, mut place) = (across + end * across_step, place + end * place_step);
        if place.abs() > HALF && place_step != 0.0 {
            // Cut where the edge leaves the face.
            let cut = if place > 0.0 { HALF } else { -HALF };
            deep += (cut - place) / place_step * across_step;
            place = cut;
        }
        if deep < HALF {
            // Half way between the two surfaces.
            let out = (deep + HALF) * 0.5;
            let point = [owner[0] + normal[0] * out + along[0] * place, owner[1] + normal[1] * out + along[1] * place];
            touches.push(Touch {
                a,
                b,
                normal: if of_a { normal } else { [-normal[0], -normal[1]] },
                from_a: [point[0] - at_a[0], point[1] - at_a[1]],
                from_b: [point[0] - at_b[0], point[1] - at_b[1]],
                // Of two that meet corner to corner the cut may lie beyond the edge's end, where the edge's line is deeper
                // than the robot.
                depth: (HALF - deep).min(extent - farthest),
                key: pair(a, b) + (2 * best + number) as u32,
            });
        }
    }
}

/// A robot's corners against the walls, and the goal posts against its sides.
fn robot_walls(robot: usize, body: &Body, touches: &mut Vec<Touch>) {
    let [c, s] = body.front;
    let mut touch = |from: [f64; 2], normal: [f64; 2], depth: f64, number: u32| {
        let key = pair(robot, WALL) + number;
        touches.push(Touch { a: robot, b: WALL, normal, from_a: from, from_b: [0.0; 2], depth, key });
    };
    let corners = [[HALF, HALF], [-HALF, HALF], [-HALF, -HALF], [HALF, -HALF]];
    for (number, [ahead, left]) in (0..).zip(corners) {
        let from = [c * ahead - s * left, s * ahead + c * left];
        let corner = [body.at[0] + from[0], body.at[1] + from[1]];
        for_walls(corner, 0.0, |normal, depth, wall| touch(from, normal, depth, WALLS * number + wall));
    }
    if body.at[0].abs() > HALF_LENGTH - REACH && body.at[1].abs() < GOAL_HALF + REACH {
        let x = if body.at[0] > 0.0 { HALF_LENGTH } else { -HALF_LENGTH };
        for (number, y) in (4 * WALLS..).zip([-GOAL_HALF, GOAL_HALF]) {
            let from = [x - body.at[0], y - body.at[1]];
            let (ahead, left) = (dot(from, [c, s]), dot(from, [-s, c]));
            let depth = HALF - ahead.abs().max(left.abs());
            if depth > 0.0 {
                let axis = if ahead.abs() > left.abs() { [c, s] } else { [-s, c] };
                let sign = if dot(from, axis) < 0.0 { -1.0 } else { 1.0 };
                touch(from, [axis[0] * sign, axis[1] * sign], depth, number);
            }
        }
    }
}

/// Kinds of flat walls in a quarter of the pitch: side, corner, end, side of the goal, back of the goal.
const WALLS: u32 = 5;

/// Calls `touch` with the outward normal, the depth and the kind of each flat wall that a disc overlaps.
///
/// - `radius`: of the disc; 0 for a point.
fn for_walls([x, y]: [f64; 2], radius: f64, mut touch: impl FnMut([f64; 2], f64, u32)) {
    let (sign_x, sign_y) = (if x < 0.0 { -1.0 } else { 1.0 }, if y < 0.0 { -1.0 } else { 1.0 });
    let (x, y) = (x.abs(), y.abs());
    let mut wall = |kind: u32, normal: [f64; 2], depth: f64| {
        if depth > 0.0 {
            touch([normal[0] * sign_x, normal[1] * sign_y], depth, kind);
        }
    };
    wall(0, [0.0, 1.0], y + radius - HALF_WIDTH);
    wall(1, [ROOT_HALF, ROOT_HALF], (x + y - CORNER) * ROOT_HALF + radius);
    let (beyond_line, beside_mouth) = (x + radius - HALF_LENGTH, y + radius - GOAL_HALF);
    if x <= HALF_LENGTH {
        // On the pitch: the end wall, where it is. What is before the mouth meets no wall but the posts.
        if y > GOAL_HALF {
            wall(2, [1.0, 0.0], beyond_line);
        }
    } else if y > GOAL_HALF && beyond_line < beside_mouth {
        wall(2, [1.0, 0.0], beyond_line);
    } else {
        wall(3, [0.0, 1.0], beside_mouth);
        wall(4, [1.0, 0.0], x + radius - GOAL_BACK);
    }
}

/// The ball and a robot.
///
/// - `between`: from the robot's centre to the ball's.
fn ball_robot(robot: usize, body: &Body, between: [f64; 2], touches: &mut Vec<Touch>) {
    let [c, s] = body.front;
    let (ahead, left) = (dot(between, [c, s]), dot(between, [-s, c]));
    let (near_ahead, near_left) = (ahead.clamp(-HALF, HALF), left.clamp(-HALF, HALF));
    let (off_ahead, off_left) = (ahead - near_ahead, left - near_left);
    let square = off_ahead * off_ahead + off_left * off_left;
    if square >= BALL_RADIUS * BALL_RADIUS {
        return;
    }
    // In the robot's frame: the normal to the ball, the point on the robot and the depth.
    let ([normal_ahead, normal_left], [point_ahead, point_left], depth) = if square > 0.0 {
        let distance = square.sqrt();
        ([off_ahead / distance, off_left / distance], [near_ahead, near_left], BALL_RADIUS - distance)
    } else if ahead.abs() > left.abs() {
        // The ball's centre is in the robot: out by the nearest side.
        let sign = if ahead < 0.0 { -1.0 } else { 1.0 };
        ([sign, 0.0], [sign * HALF, left], BALL_RADIUS + HALF - ahead.abs())
    } else {
        let sign = if left < 0.0 { -1.0 } else { 1.0 };
        ([0.0, sign], [ahead, sign * HALF], BALL_RADIUS + HALF - left.abs())
    };
    let normal = [c * normal_ahead - s * normal_left, s * normal_ahead + c * normal_left];
    touches.push(Touch {
        a: robot,
        b: BALL,
        normal,
        from_a: [c * point_ahead - s * point_left, s * point_ahead + c * point_left],
        from_b: [-normal[0] * BALL_RADIUS, -normal[1] * BALL_RADIUS],
        depth,
        key: pair(robot, BALL),
    });
}

/// The ball against the walls and the goal posts.
fn ball_walls([x, y]: [f64; 2], touches: &mut Vec<Touch>) {
    let mut touch = |normal: [f64; 2], depth: f64, number: u32| {
        let from_a = [normal[0] * BALL_RADIUS, normal[1] * BALL_RADIUS];
        let key = pair(BALL, WALL) + number;
        touches.push(Touch { a: BALL, b: WALL, normal, from_a, from_b: [0.0; 2], depth, key });
    };
    for_walls([x, y], BALL_RADIUS, &mut touch);
    if x.abs() <= HALF_LENGTH && y.abs() <= GOAL_HALF {
        for (number, post) in (WALLS..).zip([-GOAL_HALF, GOAL_HALF]) {
            let to = [if x < 0.0 { -HALF_LENGTH } else { HALF_LENGTH } - x, post - y];
            let square = dot(to, to);
            if square < BALL_RADIUS * BALL_RADIUS && square > 0.0 {
                let distance = square.sqrt();
                touch([to[0] / distance, to[1] / distance], BALL_RADIUS - distance, number);
            }
        }
    }
}
