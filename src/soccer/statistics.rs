//! What is counted in a match.

use super::physics::{BALL, Physics, ROLLING};
use super::pitch::{GOAL_HALF, HALF_LENGTH, Side};
use super::view::{ROBOTS, Restart};
use crate::fingerprint::Fingerprint;
use serde::Serialize;

/// Frames after the last touch when it is judged whether a ball is a shot.
const RELEASED: u32 = 3;

/// Counts; arrays hold the left and the right team's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub struct Statistics {
    /// Frames in which a team was the last one to touch the ball alone.
    pub possession: [u32; 2],
    /// Shots: a ball that a team let go so that it would roll into the goal; and goals that were pushed in.
    pub shots: [u32; 2],
    /// Restarts taken: kick-offs, free balls in the attacking half, goal kicks, penalties.
    pub calls: [[u32; 4]; 2],
    /// Commands that were no numbers.
    pub faults: [u32; 2],
    /// Placements in which a team's own wishes were not taken.
    pub forced: u32,
}

impl Statistics {
    /// Counts a restart.
    pub fn call(&mut self, restart: Restart, taker: Side) {
        let kind = match restart {
            Restart::KickOff => 0,
            Restart::FreeBall => 1,
            Restart::GoalKick => 2,
            Restart::PenaltyKick => 3,
        };
        self.calls[taker.index()][kind] += 1;
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        let pairs = [self.possession, self.shots, self.faults];
        let words = pairs.into_iter().flatten().chain(self.calls.into_iter().flatten());
        words.chain([self.forced]).for_each(|word| hash.u32(word));
    }
}

/// Who has the ball, and whether it is a shot.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ownership {
    last: Option<Side>,
    /// Frames since anybody touched the ball.
    free: u32,
    /// Whether the ball's present way was counted as a shot.
    shot: bool,
}

impl Ownership {
    /// Counts one frame of play.
    pub fn look(&mut self, physics: &Physics, statistics: &mut Statistics) {
        let touched = |side: Side| (0..ROBOTS).any(|robot| physics.touched_ball(side.index() * ROBOTS + robot));
        let touching = Side::BOTH.map(touched);
        match touching {
            [true, false] => self.last = Some(Side::Left),
            [false, true] => self.last = Some(Side::Right),
            [true, true] | [false, false] => {}
        }
        if touching == [false; 2] {
            self.free = self.free.saturating_add(1);
        } else {
            self.free = 0;
            self.shot = false;
        }
        let Some(side) = self.last else { return };
        statistics.possession[side.index()] += 1;
        if self.free == RELEASED && on_target(physics, side) {
            statistics.shots[side.index()] += 1;
            self.shot = true;
        }
    }

    /// Counts a goal as a shot unless it was counted already.
    pub fn goal(&mut self, by: Side, statistics: &mut Statistics) {
        if !self.shot || self.last != Some(by) {
            statistics.shots[by.index()] += 1;
        }
    }

    /// Takes the state in.
    pub fn absorb(self, hash: &mut Fingerprint) {
        hash.u32(self.last.map_or(0, |side| 1 + side.index() as u32));
        hash.u32(self.free);
        hash.u32(u32::from(self.shot));
    }
}

/// Whether the ball would roll straight into the goal that `by` attacks.
fn on_target(physics: &Physics, by: Side) -> bool {
    let ([x, y], [vx, vy]) = (physics.at(BALL), physics.velocity(BALL));
    let way = HALF_LENGTH - x * by.other().sign();
    let toward = vx * by.other().sign();
    if way <= 0.0 || toward <= 0.0 {
        return false;
    }
    // Along the line of flight the way is longer than along x, and the speed higher, in one ratio.
    let speed = (vx * vx + vy * vy).sqrt();
    let ratio = speed / toward;
    (y + vy / toward * way).abs() < GOAL_HALF && speed * speed > 2.0 * ROLLING * way * ratio
}
