//! Who plays what when play starts again: shared by both coaches.
//!
//! Source: our choice, rows and costs, except that penalty defence is played by Penalty Defender, Fullback and Wingback:
//! that is the paper's (section 4.3).

use super::duties::{Formation, Role};
use super::geometry::{OWN_GOAL, distance};
use crate::soccer::view::{Call, ROBOTS, Restart, Slot, View, Whose};

/// The formation with which the team starts after a call.
#[must_use]
pub fn formation(call: &Call) -> Formation {
    match (call.restart, call.taker) {
        (Restart::KickOff, Whose::Ours) | (Restart::GoalKick, Whose::Theirs) => Formation::StrikerAssistant,
        (Restart::FreeBall, Whose::Ours) => Formation::TwoStrikers,
        (Restart::PenaltyKick, Whose::Ours) => Formation::PenaltyKick,
        (Restart::KickOff | Restart::FreeBall, Whose::Theirs) | (Restart::GoalKick, Whose::Ours) => {
            Formation::FullbackWingback
        }
        (Restart::PenaltyKick, Whose::Theirs) => Formation::PenaltyDefense,
    }
}

/// The roles of a formation: who keeps the goal, who plays the ball, and who supports.
#[must_use]
pub fn roles(formation: Formation) -> [Role; ROBOTS] {
    match formation {
        Formation::TwoStrikers => [Role::Goalkeeper, Role::Striker, Role::Striker],
        Formation::StrikerAssistant => [Role::Goalkeeper, Role::Striker, Role::Assistant],
        Formation::PenaltyKick => [Role::Goalkeeper, Role::PenaltyKicker, Role::Assistant],
        Formation::FullbackWingback => [Role::Goalkeeper, Role::Wingback, Role::Fullback],
        Formation::PenaltyDefense => [Role::PenaltyDefender, Role::Wingback, Role::Fullback],
    }
}

/// Every order of three robots, ties going to the earlier one.
const ORDERS: [[usize; ROBOTS]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// The slot of each robot: the one that keeps the goal, the one that plays the ball, and the third.
///
/// Returns the order of the least cost: 0.7 times the way of the keeper to its goal and 0.3 times the way of the ball
/// player to the ball; ties go to the smaller numbers.
#[must_use]
pub fn slots(view: &View) -> [Slot; ROBOTS] {
    let keeping: [f64; ROBOTS] = std::array::from_fn(|robot| 0.7 * distance(view.ours[robot].at, OWN_GOAL));
    let playing: [f64; ROBOTS] = std::array::from_fn(|robot| 0.3 * distance(view.ours[robot].at, view.ball.at));
    let mut best = (f64::INFINITY, ORDERS[0]);
    for order in ORDERS {
        let cost = keeping[order[0]] + playing[order[1]];
        if cost < best.0 {
            best = (cost, order);
        }
    }
    let mut slots = [Slot::Supporter; ROBOTS];
    slots[best.1[0]] = Slot::Goalkeeper;
    slots[best.1[1]] = Slot::Attacker;
    slots
}

/// The roles of the robots in their slots.
///
/// - `given`: the role of goalkeeper, ball player and supporter, as [`roles`] has them.
#[must_use]
pub fn assign(slots: [Slot; ROBOTS], given: [Role; ROBOTS]) -> [Role; ROBOTS] {
    slots.map(|slot| match slot {
        Slot::Goalkeeper => given[0],
        Slot::Attacker => given[1],
        Slot::Supporter => given[2],
    })
}
