//! The area rule: at most one field player in a goal area while the ball is there.
//!
//! Source: VSSSLeague/VSSReferee for what the referee counts; the rest is our choice, see the table in `mod.rs`.

use super::player::Scene;
use crate::soccer::team::geometry::{AREA_X, AREA_Y, distance, in_area, minus, plus, side, times};
use crate::soccer::view::ROBOTS;

/// Nearer than this to the ball a robot has it.
const HELD: f64 = 0.12;
/// How far robots that may not enter a goal area stay out of it.
const CLEARANCE: f64 = 0.09;
/// The rule holds from so far in front of the other area on ...
const AHEAD: f64 = 0.10;
/// ... and of the own one, so that nobody is in it when a fast ball comes: the referee counts a single frame.
const OWN_AHEAD: f64 = 0.45;
/// Into so many parts a way is cut to see whether it crosses an area.
const PARTS: u32 = 8;

/// The place in front of a goal area where a robot has to stay, or to go round by, that may not enter it; `None` when its
/// way is free.
///
/// - `at`: where it wants to go.
pub(super) fn shut_out(scene: &Scene, me: usize, at: [f64; 2]) -> Option<[f64; 2]> {
    let (ball, here) = (scene.view.ball.at, scene.view.ours[me].at);
    let own = ball[0] < 0.0;
    let holds = if own { ball[0] < OWN_AHEAD - AREA_X } else { in_area(ball, own, AHEAD) };
    if !holds || scene.roles[me].keeps_goal() {
        return None;
    }
    // A little within the places that `outside` gives, so that a robot that waits there is not sent on.
    let enters = |place| in_area(place, own, CLEARANCE - 0.02);
    let crosses = |to: [f64; 2]| {
        let way = minus(to, here);
        (0..=PARTS).any(|part| enters(plus(here, times(way, f64::from(part) / f64::from(PARTS)))))
    };
    if !crosses(at) || may_enter(scene, me, own) {
        return None;
    }
    if enters(here) {
        return Some(outside(here, own));
    }
    let at = outside(at, own);
    if !crosses(at) {
        return Some(at);
    }
    let front = AREA_X - CLEARANCE;
    let corner = |y: f64| [if own { -front } else { front }, side(y) * (AREA_Y + CLEARANCE)];
    // The corner on the side of the place, or the other one first.
    Some(if crosses(corner(at[1])) { corner(here[1]) } else { corner(at[1]) })
}

/// Whether the robot is the one that may be in the area: in the own one nobody beside a goalkeeper, in the other one the
/// robot that is nearest to the ball, unless an opponent has it.
fn may_enter(scene: &Scene, me: usize, own: bool) -> bool {
    let (ours, ball) = (&scene.view.ours, scene.view.ball.at);
    if !own && scene.view.theirs.iter().any(|other| distance(other.at, ball) < HELD) {
        return false;
    }
    let way = |robot: usize| distance(ours[robot].at, ball);
    (0..ROBOTS).filter(|other| *other != me).all(|other| {
        if scene.roles[other].keeps_goal() {
            return !own || !in_area(ours[other].at, true, CLEARANCE);
        }
        way(me) < way(other) || (way(me) <= way(other) && me < other)
    })
}

/// The nearest place outside a goal area, at a distance from it.
pub(super) fn outside(at: [f64; 2], own: bool) -> [f64; 2] {
    if !in_area(at, own, CLEARANCE) {
        return at;
    }
    let (front, beside) = (AREA_X - CLEARANCE, AREA_Y + CLEARANCE);
    if at[0].abs() - front < beside - at[1].abs() {
        [if own { -front } else { front }, at[1]]
    } else {
        [at[0], side(at[1]) * beside]
    }
}
