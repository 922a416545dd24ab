//! The automatic referee: watches every frame of play and decides how it goes on.
//!
//! | question | choice | reason |
//! |---|---|---|
//! | two rules in one frame | the first in the order of the checkers decides | the real checkers overwrite each other |
//! | pause of 240 s between the halves | left out | nobody plays in it |
//! | both fouls in one play | the one that held for more frames of that play | "the longer timer" in VSSReferee |
//! | two restarts of one kind in a row | no rule against it | VSSReferee has none |
//! | overtime and shoot-out | only in knock-out games | as there |
//! | pairs of a shoot-out | 5, then until one is ahead after a pair, at most 20; then whoever lost the coin wins | no source says; ours ends |
//! | an attempt of a shoot-out | ends after 10 s at the latest | no source says |
//!
//! Source: VSSSLeague/VSSReferee, the league's own; order of checkers, times and decisions are those of it.

mod decision;
mod log;
mod placement;
mod shootout;
mod watch;

pub use decision::{Decision, Kick, Ruling};
pub use log::{Command, Entry, Forced, Phase, Rule};
pub use placement::{CLEARANCE, KeeperSide, ball_place, default_spot};
pub use shootout::Attempt;

use super::physics::{FRAMES_PER_SECOND, Physics, seconds};
use super::pitch::Side;
use super::view::ROBOTS;
use crate::fingerprint::Fingerprint;
use shootout::ShootOut;
use std::cmp::Ordering;
use watch::Watch;

/// Frames for which two attackers or two defenders may stand in an area with the ball: 3 s.
pub const CROWD_FRAMES: u32 = 3 * FRAMES_PER_SECOND;
/// Frames for which the ball may be stuck: 5 s.
pub const STUCK_FRAMES: u32 = 5 * FRAMES_PER_SECOND;
/// The ball counts as stuck up to this speed, metres per second.
pub const STUCK_SPEED: f64 = 0.1;
/// Robots nearer to a stuck ball than this fight for it, metres: one and a half of their lengths.
pub const FIGHT_DISTANCE: f64 = 0.1125;
/// Seconds between a decision and STOP, after a goal and otherwise.
pub const WAIT_AFTER_GOAL: u32 = 8;
/// See [`WAIT_AFTER_GOAL`].
pub const WAIT: u32 = 4;

/// How long the parts of a match last, and whether it must have a winner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Times {
    /// Seconds of play in a half.
    pub half: u32,
    /// Seconds of play in a half of overtime.
    pub extra: u32,
    /// Whether a tie leads to overtime and a shoot-out.
    pub knockout: bool,
}

/// What the referee knows.
#[derive(Clone, Debug)]
pub struct Referee {
    times: Times,
    /// The side that has the first kick-off.
    first: Side,
    phase: Phase,
    /// Frames of play in this phase.
    frames: u32,
    score: [u32; 2],
    watch: Watch,
    shoot_out: ShootOut,
}

impl Referee {
    /// The referee before the first kick-off.
    ///
    /// - `first`: the side that the coin gave it to.
    #[must_use]
    pub fn new(times: Times, first: Side) -> Self {
        Self {
            times,
            first,
            phase: Phase::FirstHalf,
            frames: 0,
            score: [0; 2],
            watch: Watch::default(),
            shoot_out: ShootOut::new(first),
        }
    }

    /// The first decision of a match.
    #[must_use]
    pub fn opening(&self) -> Decision {
        Decision { kick: Kick::KickOff, taker: self.first, rule: Rule::Coin }
    }

    /// Looks at one frame of play that has just passed.
    ///
    /// Returns what it decides, if anything; then it waits for a placement, see [`Referee::placed`].
    pub fn judge(&mut self, physics: &Physics) -> Option<Ruling> {
        self.frames += 1;
        if self.phase == Phase::ShootOut {
            let ruling = self.shoot_out.judge(physics)?;
            return Some(ruling);
        }
        self.watch.look(physics);
        if self.frames >= self.phase_frames() {
            return Some(self.phase_over());
        }
        let decision = self.watch.judge()?;
        if let Rule::Goal { by, .. } = decision.rule {
            self.score[by.index()] += 1;
        }
        Some(Ruling::Restart(decision))
    }

    /// Frames of play in a part of the match; the shoot-out has no end of its own.
    fn phase_frames(&self) -> u32 {
        match self.phase {
            Phase::FirstHalf | Phase::SecondHalf => self.times.half * FRAMES_PER_SECOND,
            Phase::FirstExtra | Phase::SecondExtra => self.times.extra * FRAMES_PER_SECOND,
            Phase::ShootOut => u32::MAX,
        }
    }

    fn phase_over(&mut self) -> Ruling {
        let seconds = self.seconds();
        let rule = Rule::TimeOver { seconds };
        let next = match self.phase {
            Phase::FirstHalf => Phase::SecondHalf,
            Phase::FirstExtra => Phase::SecondExtra,
            Phase::SecondHalf if self.tied() && self.times.knockout && self.times.extra > 0 => Phase::FirstExtra,
            Phase::SecondHalf | Phase::SecondExtra if self.tied() && self.times.knockout => Phase::ShootOut,
            Phase::SecondHalf | Phase::SecondExtra | Phase::ShootOut => return Ruling::Over(rule),
        };
        self.phase = next;
        self.frames = 0;
        let (kick, taker) = match next {
            Phase::FirstHalf | Phase::FirstExtra => (Kick::KickOff, self.first),
            Phase::SecondHalf | Phase::SecondExtra => (Kick::KickOff, self.first.other()),
            Phase::ShootOut => (Kick::Penalty, self.first),
        };
        Ruling::Restart(Decision { kick, taker, rule })
    }

    fn tied(&self) -> bool {
        self.score[0] == self.score[1]
    }

    /// Everything was placed: timers begin anew.
    pub fn placed(&mut self) {
        self.watch.restart();
        self.shoot_out.restart();
    }

    /// The robot of a side that spent the longest time in its own area; the lowest number of several.
    ///
    /// Source: VSSSLeague/VSSReferee, the checker of goalkeepers.
    #[must_use]
    pub fn goalie(&self, side: Side) -> usize {
        let frames = self.watch.at_home(side);
        (0..ROBOTS).rev().max_by_key(|&robot| frames[robot]).unwrap_or(0)
    }

    /// Which part of the match it is.
    #[must_use]
    pub fn phase(&self) -> Phase {
        self.phase
    }

    /// Seconds of play in this part.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        seconds(self.frames)
    }

    /// Goals of the left and the right team, without those of a shoot-out.
    #[must_use]
    pub fn score(&self) -> [u32; 2] {
        self.score
    }

    /// Goals of the shoot-out; `None` where there was none.
    #[must_use]
    pub fn shoot_out_score(&self) -> Option<[u32; 2]> {
        (self.phase == Phase::ShootOut).then_some(self.shoot_out.scored())
    }

    /// The side that won, or is ahead; `None` at a tie.
    #[must_use]
    pub fn ahead(&self) -> Option<Side> {
        let [left, right] = self.shoot_out_score().unwrap_or(self.score);
        match left.cmp(&right) {
            Ordering::Greater => Some(Side::Left),
            Ordering::Less => Some(Side::Right),
            Ordering::Equal if self.shoot_out.exhausted() => Some(self.first.other()),
            Ordering::Equal => None,
        }
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        hash.u32(self.first.index() as u32);
        hash.u32(self.phase as u32);
        hash.u32(self.frames);
        self.score.iter().for_each(|&goals| hash.u32(goals));
        self.watch.absorb(hash);
        self.shoot_out.absorb(hash);
    }
}
