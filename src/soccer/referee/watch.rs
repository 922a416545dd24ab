//! The checkers of play: goals, fouls of a play, crowds in a goal area, and a ball that is stuck.
//!
//! Source: VSSSLeague/VSSReferee, checkers.

use super::decision::{Decision, Kick};
use super::log::Rule;
use super::{CROWD_FRAMES, FIGHT_DISTANCE, STUCK_FRAMES, STUCK_SPEED};
use crate::fingerprint::Fingerprint;
use crate::soccer::physics::{BALL, Physics, seconds};
use crate::soccer::pitch::{Quadrant, Side, area_of, goal_of};
use crate::soccer::view::ROBOTS;

/// The time between the ball's coming into a goal area and its leaving it, or a goal.
#[derive(Clone, Copy, Debug)]
struct Play {
    /// Whose area it is.
    area: Side,
    /// Frames with two or more robots of the other side in the area.
    attackers: u32,
    /// Frames with two or more robots of the area's side in it.
    defenders: u32,
}

/// What is watched, frame by frame.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    ball: [f64; 2],
    speed: f64,
    /// The distance from the ball to the nearest robot of each side.
    nearest: [f64; 2],
    play: Option<Play>,
    /// The play whose last frame this was.
    ended: Option<Play>,
    /// Frames without a break with two or more attackers or defenders in the ball's area.
    crowd_attackers: u32,
    crowd_defenders: u32,
    /// Frames for which the ball has been stuck, and the area where that was.
    stuck: u32,
    stuck_in: Option<Side>,
    /// Frames that each robot has spent in its own area since the match began.
    at_home: [[u32; ROBOTS]; 2],
}

impl Watch {
    /// Takes one frame in.
    pub fn look(&mut self, physics: &Physics) {
        self.ball = physics.at(BALL);
        let [vx, vy] = physics.velocity(BALL);
        self.speed = (vx * vx + vy * vy).sqrt();
        let area = area_of(self.ball);
        // Robots of each side in the ball's area.
        let mut inside = [0; 2];
        for side in Side::BOTH {
            let mut nearest = f64::INFINITY;
            for robot in 0..ROBOTS {
                let at = physics.at(side.index() * ROBOTS + robot);
                let off = [at[0] - self.ball[0], at[1] - self.ball[1]];
                nearest = nearest.min(off[0] * off[0] + off[1] * off[1]);
                self.at_home[side.index()][robot] += u32::from(side.has_in_area(at));
                inside[side.index()] += u32::from(area.is_some_and(|area| area.has_in_area(at)));
            }
            self.nearest[side.index()] = nearest.sqrt();
        }
        self.ended = None;
        if let Some(side) = area {
            let attackers = inside[side.other().index()] >= 2;
            let defenders = inside[side.index()] >= 2;
            self.crowd_attackers = if attackers { self.crowd_attackers + 1 } else { 0 };
            self.crowd_defenders = if defenders { self.crowd_defenders + 1 } else { 0 };
            let play = self.play.get_or_insert(Play { area: side, attackers: 0, defenders: 0 });
            play.attackers += u32::from(attackers);
            play.defenders += u32::from(defenders);
            if goal_of(self.ball).is_some() {
                self.ended = self.play.take();
            }
        } else {
            self.crowd_attackers = 0;
            self.crowd_defenders = 0;
            self.ended = self.play.take();
        }
        if area != self.stuck_in {
            self.stuck = 0;
            self.stuck_in = area;
        }
        self.stuck = if self.speed > STUCK_SPEED { 0 } else { self.stuck + 1 };
    }

    /// What follows from the frame that was taken in last; the checkers in the order of their priority.
    pub fn judge(&self) -> Option<Decision> {
        self.play_over().or_else(|| self.crowd()).or_else(|| self.stuck_ball())
    }

    /// Priority 2: the end of a play, as in VSSReferee.
    fn play_over(&self) -> Option<Decision> {
        let Play { area, attackers, defenders } = self.ended?;
        let ball = self.ball;
        let goal = goal_of(ball).is_some();
        let [attack, defend] = [seconds(attackers), seconds(defenders)];
        let goal_kick = |rule| Some(Decision { kick: Kick::GoalKick, taker: area, rule });
        let penalty = |rule| Some(Decision { kick: Kick::Penalty, taker: area.other(), rule });
        match (goal, attackers > 0, defenders > 0) {
            (_, true, true) => {
                let rule = Rule::PlayOfBoth { area, goal, attackers: attack, defenders: defend };
                if attackers > defenders { goal_kick(rule) } else { penalty(rule) }
            }
            (_, true, false) => goal_kick(Rule::PlayOfAttackers { area, goal, seconds: attack }),
            (true, false, crowded) => {
                let by = area.other();
                let rule = Rule::Goal { by, ball, defenders: if crowded { defend } else { 0.0 } };
                Some(Decision { kick: Kick::KickOff, taker: area, rule })
            }
            (false, false, true) => penalty(Rule::PlayOfDefenders { area, seconds: defend }),
            (false, false, false) => None,
        }
    }

    /// Priority 1: two attackers, then two defenders, for 3 s without a break.
    fn crowd(&self) -> Option<Decision> {
        let area = self.play?.area;
        if self.crowd_attackers >= CROWD_FRAMES {
            let rule = Rule::TwoAttackers { area, seconds: seconds(self.crowd_attackers) };
            return Some(Decision { kick: Kick::GoalKick, taker: area, rule });
        }
        (self.crowd_defenders >= CROWD_FRAMES).then(|| {
            let rule = Rule::TwoDefenders { area, seconds: seconds(self.crowd_defenders) };
            Decision { kick: Kick::Penalty, taker: area.other(), rule }
        })
    }

    /// Priority 0: the ball does not move.
    fn stuck_ball(&self) -> Option<Decision> {
        if self.stuck < STUCK_FRAMES {
            return None;
        }
        let rule = Rule::StuckBall {
            area: self.stuck_in,
            seconds: seconds(self.stuck),
            speed: self.speed,
            nearest: self.nearest,
        };
        let fought = self.nearest.iter().all(|&distance| distance < FIGHT_DISTANCE);
        Some(match self.stuck_in {
            Some(area) if !fought => Decision { kick: Kick::Penalty, taker: area.other(), rule },
            Some(_) | None => Decision::free_ball(Quadrant::of(self.ball), rule),
        })
    }

    /// Everything was placed.
    pub fn restart(&mut self) {
        *self = Self { at_home: self.at_home, ..Self::default() };
    }

    /// Frames that each robot of a side has spent in its own area.
    pub fn at_home(&self, side: Side) -> [u32; ROBOTS] {
        self.at_home[side.index()]
    }

    /// Takes the state in.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        let [area, attackers, defenders] = match self.play {
            Some(play) => [1 + play.area.index() as u32, play.attackers, play.defenders],
            None => [0; 3],
        };
        let stuck_in = self.stuck_in.map_or(0, |side| 1 + side.index() as u32);
        let crowds = [self.crowd_attackers, self.crowd_defenders];
        let words = [area, attackers, defenders, self.stuck, stuck_in].into_iter().chain(crowds);
        words.chain(self.at_home.into_iter().flatten()).for_each(|word| hash.u32(word));
    }
}
