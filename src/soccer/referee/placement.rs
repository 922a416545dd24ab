//! Where the ball and the robots are placed: the table of VSSReferee.

use super::decision::Kick;
use crate::soccer::pitch::{AREA_X, PENALTY_X, Side};
use crate::soccer::view::{Slot, Spot};
use std::f64::consts::PI;

/// Robots that would be placed closer than this force the table's places for both teams, metres.
pub const CLEARANCE: f64 = 0.0825;

/// The side of its goal on which the keeper takes a goal kick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeeperSide {
    /// y above 0.
    Up,
    /// y below 0.
    Down,
}

impl KeeperSide {
    fn sign(self) -> f64 {
        match self {
            Self::Up => 1.0,
            Self::Down => -1.0,
        }
    }
}

/// Where the ball is placed.
///
/// - `taker`: the side that takes the kick.
/// - `keeper`: matters for a goal kick alone.
#[must_use]
pub fn ball_place(kick: Kick, taker: Side, keeper: KeeperSide) -> [f64; 2] {
    match kick {
        Kick::KickOff => [0.0, 0.0],
        Kick::FreeBall(quadrant) => quadrant.cross(),
        Kick::Penalty => [taker.other().sign() * PENALTY_X, 0.0],
        Kick::GoalKick => [taker.sign() * AREA_X, keeper.sign() * 0.3535],
    }
}

/// Where the robot of a slot is placed if its team asks for nothing else.
///
/// - `side`, `slot`: the robot's.
/// - `taker`, `keeper`: as for [`ball_place`].
///
/// Source: VSSSLeague/VSSReferee, placements. The table is for the team that defends the right goal: for the left one
/// x changes its sign.
#[must_use]
pub fn default_spot(kick: Kick, taker: Side, keeper: KeeperSide, side: Side, slot: Slot) -> Spot {
    let own = side == taker;
    // A place of the table, and the same with the sign of x for this side.
    let mirrored = |[x, y]: [f64; 2]| [x * side.sign(), y];
    let at = match (kick, slot, own) {
        (Kick::KickOff | Kick::FreeBall(_), Slot::Goalkeeper, _) | (Kick::GoalKick, Slot::Goalkeeper, false) => {
            mirrored([0.675, 0.0])
        }
        (Kick::KickOff, Slot::Attacker, _) => mirrored([0.2, 0.0]),
        (Kick::KickOff, Slot::Supporter, _) => mirrored([0.4, 0.0]),
        (Kick::Penalty, Slot::Goalkeeper, true) => mirrored([0.65, 0.0]),
        (Kick::Penalty, Slot::Goalkeeper, false) => mirrored([0.7125, 0.0]),
        (Kick::Penalty, Slot::Attacker, true) => mirrored([-0.3, 0.0]),
        (Kick::Penalty, Slot::Attacker, false) => mirrored([-0.1, 0.25]),
        (Kick::Penalty, Slot::Supporter, true) => mirrored([0.1, 0.4]),
        (Kick::Penalty, Slot::Supporter, false) => mirrored([-0.1, -0.4]),
        (Kick::GoalKick, Slot::Goalkeeper, true) => mirrored([0.675, 0.27 * keeper.sign()]),
        (Kick::GoalKick, Slot::Attacker, true) => mirrored([0.45, 0.32]),
        (Kick::GoalKick, Slot::Attacker, false) => mirrored([-0.225, 0.1]),
        (Kick::GoalKick, Slot::Supporter, true) => mirrored([0.3, -0.47]),
        (Kick::GoalKick, Slot::Supporter, false) => mirrored([-0.15, -0.32]),
        (Kick::FreeBall(quadrant), Slot::Attacker, _) => {
            let [x, y] = quadrant.cross();
            [x + 0.2 * side.sign(), y]
        }
        (Kick::FreeBall(quadrant), Slot::Supporter, true) => mirrored([-0.1, -0.2 * quadrant.sign_y()]),
        (Kick::FreeBall(quadrant), Slot::Supporter, false) => mirrored([0.3, -0.1 * quadrant.sign_y()]),
    };
    let ball = ball_place(kick, taker, keeper);
    let heading = match (kick, slot, own, side) {
        (Kick::GoalKick, Slot::Goalkeeper, true, _) => libm::atan2(ball[1] - at[1], ball[0] - at[0]),
        (_, _, _, Side::Left) => 0.0,
        (_, _, _, Side::Right) => PI,
    };
    Spot { at, heading }
}
