//! The shoot-out of a knock-out game: penalties in turns.
//!
//! Source: VSSSLeague/VSSReferee: an attempt ends with a goal, when the ball leaves the goal area, crosses midfield
//! or is stuck. How many there are, and the longest time of one, are our choice; see the table in the module above.

use super::decision::{Decision, Kick, Ruling};
use super::log::Rule;
use super::{STUCK_FRAMES, STUCK_SPEED};
use crate::fingerprint::Fingerprint;
use crate::soccer::physics::{BALL, FRAMES_PER_SECOND, Physics, seconds};
use crate::soccer::pitch::{Side, goal_of};
use serde::Serialize;

/// Pairs of attempts before the first one ahead wins.
const PAIRS: u32 = 5;
/// Pairs of attempts, at most: then the side wins that did not get the first kick-off from the coin.
const MOST_PAIRS: u32 = 20;
/// Frames of one attempt, at most: 10 s.
const LONGEST: u32 = 10 * FRAMES_PER_SECOND;

/// How an attempt ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Attempt {
    /// With a goal.
    Goal,
    /// The ball left the goal area.
    LeftArea,
    /// The ball crossed midfield.
    CrossedMidfield,
    /// The ball was stuck.
    Stuck,
    /// It took too long.
    TooLong,
}

/// Whose turn it is, and what was scored.
#[derive(Clone, Debug)]
pub struct ShootOut {
    taker: Side,
    taken: [u32; 2],
    scored: [u32; 2],
    frames: u32,
    stuck: u32,
    in_area: bool,
}

impl ShootOut {
    /// A shoot-out that `first` begins.
    pub fn new(first: Side) -> Self {
        Self { taker: first, taken: [0; 2], scored: [0; 2], frames: 0, stuck: 0, in_area: false }
    }

    /// Everything was placed.
    pub fn restart(&mut self) {
        (self.frames, self.stuck, self.in_area) = (0, 0, false);
    }

    /// Goals so far.
    pub fn scored(&self) -> [u32; 2] {
        self.scored
    }

    /// Looks at a frame; returns what follows from it.
    pub fn judge(&mut self, physics: &Physics) -> Option<Ruling> {
        let ended = self.look(physics)?;
        let taker = self.taker;
        self.taken[taker.index()] += 1;
        self.scored[taker.index()] += u32::from(ended == Attempt::Goal);
        let seconds = seconds(self.frames);
        let rule = Rule::Attempt { by: taker, ended, seconds, scored: self.scored };
        if self.decided() {
            return Some(Ruling::Over(rule));
        }
        self.taker = taker.other();
        Some(Ruling::Restart(Decision { kick: Kick::Penalty, taker: self.taker, rule }))
    }

    fn look(&mut self, physics: &Physics) -> Option<Attempt> {
        self.frames += 1;
        let defender = self.taker.other();
        let ball = physics.at(BALL);
        let [vx, vy] = physics.velocity(BALL);
        self.stuck = if vx * vx + vy * vy <= STUCK_SPEED * STUCK_SPEED { self.stuck + 1 } else { 0 };
        let was_in_area = self.in_area;
        self.in_area = defender.has_in_area(ball);
        if goal_of(ball) == Some(defender) {
            Some(Attempt::Goal)
        } else if was_in_area && !self.in_area {
            Some(Attempt::LeftArea)
        } else if ball[0] * defender.sign() < 0.0 {
            Some(Attempt::CrossedMidfield)
        } else if self.stuck >= STUCK_FRAMES {
            Some(Attempt::Stuck)
        } else {
            (self.frames >= LONGEST).then_some(Attempt::TooLong)
        }
    }

    /// Whether one side is ahead by more than the other can still score, or nobody ever will be.
    fn decided(&self) -> bool {
        let pairs = PAIRS.max(self.taken[0]).max(self.taken[1]);
        let ahead = |side: Side| {
            let (own, other) = (side.index(), side.other().index());
            self.scored[own] > self.scored[other] + (pairs - self.taken[other])
        };
        Side::BOTH.into_iter().any(ahead) || self.exhausted()
    }

    /// Whether there were so many attempts that the coin decides.
    pub fn exhausted(&self) -> bool {
        self.taken == [MOST_PAIRS; 2]
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        let words = [self.taker.index() as u32, self.frames, self.stuck, u32::from(self.in_area)];
        words.into_iter().chain(self.taken).chain(self.scored).for_each(|word| hash.u32(word));
    }
}
