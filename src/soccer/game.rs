//! A match: the loop of physics, camera, radio and referee, without the teams.
//!
//! Whoever plays does this: while a call is pending, answer it for both sides with [`Match::place`]; otherwise look with
//! [`Match::view`] and drive with [`Match::step`]. Waits take no step.

use super::arrangement::{Arrangement, ArrangementError};
use super::noise::{Camera, Hands, Radio};
use super::params::Params;
use super::physics::{self, BALL, Physics, seconds};
use super::pitch::Side;
use super::placing;
use super::referee::{Command, Decision, Entry, KeeperSide, Kick, Phase, Referee, Rule, Ruling, WAIT, WAIT_AFTER_GOAL};
use super::statistics::{Ownership, Statistics};
use super::view::{Ball, Call, Lineup, Pose, ROBOTS, Restart, Slot, Spot, View, Wheels, Whose};
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, Stream, stream};
use rand::RngExt;

/// A team by its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Defends the left goal, unless the sides are exchanged.
    Blue,
    /// Defends the other one.
    Yellow,
}

/// How a match ended; arrays hold the left and the right team's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ending {
    /// Goals, without those of a shoot-out.
    pub score: [u32; 2],
    /// Goals of the shoot-out.
    pub shoot_out: Option<[u32; 2]>,
    /// Who won; `None` at a tie.
    pub winner: Option<Side>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    /// The decision waits for a placement.
    Pending(Decision),
    Playing,
    Over,
}

/// A match, as a state that can be cloned and gone on with.
#[derive(Clone, Debug)]
pub struct Match {
    exchanged: bool,
    physics: Physics,
    camera: Camera,
    radio: Radio,
    hands: Hands,
    referee: Referee,
    keepers: Stream,
    state: State,
    /// The last call, for the views.
    decision: Decision,
    calls: u32,
    frame: u32,
    since: u32,
    /// Seconds spent waiting for the referee.
    waited: u32,
    ownership: Ownership,
    statistics: Statistics,
    /// Bit i: a fault of robot i was noted.
    noted: u8,
    log: Vec<Entry>,
}

impl Match {
    /// A match before its first kick-off.
    #[must_use]
    pub fn new(params: &Params, seed: Seed) -> Self {
        let first = if stream(seed, Purpose::Coin, 0).random::<bool>() { Side::Left } else { Side::Right };
        let referee = Referee::new(params.times(), first);
        let decision = referee.opening();
        let mut game = Self {
            exchanged: params.sides_exchanged,
            physics: Physics::new(params.substeps),
            camera: Camera::new(params, seed),
            radio: Radio::new(params, seed),
            hands: Hands::new(params, seed),
            referee,
            keepers: stream(seed, Purpose::Coin, 1),
            state: State::Playing,
            decision,
            calls: 0,
            frame: 0,
            since: 0,
            waited: 0,
            ownership: Ownership::default(),
            statistics: Statistics::default(),
            noted: 0,
            log: Vec::new(),
        };
        // Until they are placed, robots wait where the table would have them, so that the pitch can be drawn.
        game.apply(&placing::place(&decision, &[PLAIN; 2], KeeperSide::Up, &game.referee).arrangement);
        game.call(decision);
        game
    }

    /// The call that a side has to answer; `None` while play runs and when the match is over.
    #[must_use]
    pub fn pending(&self, side: Side) -> Option<Call> {
        matches!(self.state, State::Pending(_)).then(|| self.call_for(side))
    }

    /// Answers the pending call: places robots and ball, and play begins.
    ///
    /// Returns whether a call was pending; otherwise nothing happens.
    ///
    /// - `lineups`: of the left and the right team. Slots that are not each named once, and places that cannot be taken,
    ///   are replaced by the referee's; the log says so.
    pub fn place(&mut self, lineups: &[Lineup; 2]) -> bool {
        let State::Pending(decision) = self.state else { return false };
        let keeper = match decision.kick {
            Kick::GoalKick if self.keepers.random::<bool>() => KeeperSide::Up,
            Kick::GoalKick => KeeperSide::Down,
            Kick::KickOff | Kick::FreeBall(_) | Kick::Penalty => KeeperSide::Up,
        };
        let placed = placing::place(&decision, lineups, keeper, &self.referee);
        for &forced in &placed.forced {
            self.note(command_of(decision.kick), Some(decision.taker), Rule::Forced(forced));
        }
        self.statistics.forced += u32::from(!placed.forced.is_empty());
        let mut arrangement = placed.arrangement;
        arrangement.ball.at = self.hands.put(BALL, arrangement.ball.at);
        for (robot, spot) in arrangement.robots.iter_mut().flatten().enumerate() {
            spot.at = self.hands.put(robot, spot.at);
        }
        self.apply(&arrangement);
        let after_goal = matches!(decision.rule, Rule::Goal { .. });
        self.waited += if after_goal { WAIT_AFTER_GOAL } else { WAIT };
        self.note(Command::Stop, None, Rule::Placed);
        self.waited += WAIT;
        self.note(Command::GameOn, None, Rule::WaitOver);
        self.state = State::Playing;
        true
    }

    /// What a side's team is told.
    #[must_use]
    pub fn view(&self, side: Side) -> View {
        let robots = |side: Side| -> [Pose; ROBOTS] {
            std::array::from_fn(|robot| self.camera.robots()[side.index() * ROBOTS + robot])
        };
        View {
            frame: self.frame,
            since: self.since,
            call: self.call_for(side),
            ball: side.turned_ball(self.camera.ball()),
            ours: robots(side).map(|pose| side.turned_pose(pose)),
            theirs: robots(side.other()).map(|pose| side.turned_pose(pose)),
        }
    }

    /// One control frame of play.
    ///
    /// Returns whether time passed; it does not while a call is pending, nor after the end.
    ///
    /// - `wheels`: of the left and the right team. A speed that is no finite number counts as 0 and as a fault.
    pub fn step(&mut self, wheels: &[[Wheels; ROBOTS]; 2]) -> bool {
        let State::Playing = self.state else { return false };
        let mut sent = [Wheels::default(); physics::ROBOTS];
        for (robot, wheels) in wheels.iter().flatten().enumerate() {
            sent[robot] = self.heard(robot, *wheels);
        }
        let drives = self.radio.send(&sent);
        self.physics.step(&drives);
        self.frame += 1;
        self.since += 1;
        self.camera.look(&self.physics, false);
        self.ownership.look(&self.physics, &mut self.statistics);
        match self.referee.judge(&self.physics) {
            None => {}
            Some(Ruling::Restart(decision)) => self.call(decision),
            Some(Ruling::Over(rule)) => {
                self.state = State::Over;
                self.note(Command::Halt, None, rule);
            }
        }
        true
    }

    /// A command with every speed a number.
    fn heard(&mut self, robot: usize, wheels: Wheels) -> Wheels {
        if wheels.left.is_finite() && wheels.right.is_finite() {
            return wheels;
        }
        self.statistics.faults[robot / ROBOTS] += 1;
        if self.noted >> robot & 1 == 0 {
            self.noted |= 1 << robot;
            self.note(Command::GameOn, Some(Arrangement::side(robot)), Rule::Fault { robot });
        }
        let number = |speed: f64| if speed.is_finite() { speed } else { 0.0 };
        Wheels { left: number(wheels.left), right: number(wheels.right) }
    }

    fn call(&mut self, decision: Decision) {
        self.decision = decision;
        self.calls += 1;
        self.state = State::Pending(decision);
        self.statistics.call(decision.kick.restart(), decision.taker);
        if let Rule::Goal { by, .. } = decision.rule {
            self.ownership.goal(by, &mut self.statistics);
        }
        self.note(command_of(decision.kick), Some(decision.taker), decision.rule);
    }

    fn call_for(&self, side: Side) -> Call {
        let Decision { kick, taker, .. } = self.decision;
        Call {
            restart: kick.restart(),
            taker: if taker == side { Whose::Ours } else { Whose::Theirs },
            quadrant: kick.quadrant().map_or(0, |quadrant| quadrant.seen_from(side).number()),
            number: self.calls,
        }
    }

    fn note(&mut self, command: Command, side: Option<Side>, rule: Rule) {
        let quadrant = if command == Command::FreeBall { self.decision.kick.quadrant() } else { None };
        self.log.push(Entry {
            frame: self.frame,
            phase: self.referee.phase(),
            seconds: self.referee.seconds(),
            elapsed: seconds(self.frame) + f64::from(self.waited),
            command,
            side,
            quadrant,
            rule,
        });
    }

    /// Puts everything somewhere, at rest but for the ball, and forgets what was going on.
    fn apply(&mut self, arrangement: &Arrangement) {
        for robot in 0..physics::ROBOTS {
            let Spot { at, heading } = arrangement.spot(robot);
            self.physics.put_robot(robot, at, heading);
        }
        let Ball { at, velocity } = arrangement.ball;
        self.physics.put_ball(at, velocity, velocity);
        self.radio.clear();
        self.camera.look(&self.physics, true);
        self.referee.placed();
        self.ownership = Ownership::default();
        self.since = 0;
    }

    /// Where everything is.
    #[must_use]
    pub fn arrangement(&self) -> Arrangement {
        let spot = |robot: usize| Spot { at: self.physics.at(robot), heading: self.physics.heading(robot) };
        Arrangement {
            ball: self.ball(),
            robots: [0, ROBOTS].map(|first| std::array::from_fn(|robot| spot(first + robot))),
        }
    }

    /// Puts robots and ball somewhere by hand: what is moved stands, the ball rolls as it is told, and the rest goes on.
    ///
    /// # Errors
    /// As [`Arrangement::check`]; nothing is changed then.
    pub fn arrange(&mut self, arrangement: &Arrangement) -> Result<(), ArrangementError> {
        arrangement.check()?;
        let now = self.arrangement();
        for robot in 0..physics::ROBOTS {
            let spot = arrangement.spot(robot);
            if spot != now.spot(robot) {
                self.physics.put_robot(robot, spot.at, spot.heading);
            }
        }
        if arrangement.ball != now.ball {
            let Ball { at, velocity } = arrangement.ball;
            self.physics.put_ball(at, velocity, velocity);
        }
        self.camera.look(&self.physics, true);
        self.referee.placed();
        self.ownership = Ownership::default();
        Ok(())
    }

    /// Calls for a restart from outside the match, such as a penalty to look at.
    ///
    /// Returns whether it is pending now; it is not when the match is over or in its shoot-out.
    ///
    /// - `taker`: of a free ball it is decided by the quadrant instead.
    pub fn stage(&mut self, kick: Kick, taker: Side) -> bool {
        if matches!(self.state, State::Over) || self.referee.phase() == Phase::ShootOut {
            return false;
        }
        self.call(match kick {
            Kick::FreeBall(quadrant) => Decision::free_ball(quadrant, Rule::Staged),
            Kick::KickOff | Kick::GoalKick | Kick::Penalty => Decision { kick, taker, rule: Rule::Staged },
        });
        true
    }

    /// How it ended; `None` before.
    #[must_use]
    pub fn finished(&self) -> Option<Ending> {
        matches!(self.state, State::Over).then(|| Ending {
            score: self.referee.score(),
            shoot_out: self.referee.shoot_out_score(),
            winner: self.referee.ahead(),
        })
    }

    /// The side that a team defends.
    #[must_use]
    pub fn side_of(&self, colour: Colour) -> Side {
        match (colour, self.exchanged) {
            (Colour::Blue, false) | (Colour::Yellow, true) => Side::Left,
            (Colour::Blue, true) | (Colour::Yellow, false) => Side::Right,
        }
    }

    /// The ball as it is.
    #[must_use]
    pub fn ball(&self) -> Ball {
        Ball { at: self.physics.at(BALL), velocity: self.physics.velocity(BALL) }
    }

    /// The robots as they are: the left team's, then the right team's.
    #[must_use]
    pub fn robots(&self) -> [Pose; physics::ROBOTS] {
        std::array::from_fn(|robot| Pose {
            at: self.physics.at(robot),
            heading: self.physics.heading(robot),
            velocity: self.physics.velocity(robot),
            spin: self.physics.spin(robot),
        })
    }

    /// Goals of the left and the right team, without those of a shoot-out.
    #[must_use]
    pub fn score(&self) -> [u32; 2] {
        self.referee.score()
    }

    /// Goals of the shoot-out; `None` where there is none.
    #[must_use]
    pub fn shoot_out_score(&self) -> Option<[u32; 2]> {
        self.referee.shoot_out_score()
    }

    /// Which part of the match it is.
    #[must_use]
    pub fn phase(&self) -> Phase {
        self.referee.phase()
    }

    /// Seconds of play in this part.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.referee.seconds()
    }

    /// Control frames of play since the match began.
    #[must_use]
    pub fn frame(&self) -> u32 {
        self.frame
    }

    /// What was counted.
    #[must_use]
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// Every call and its reason, oldest first.
    #[must_use]
    pub fn log(&self) -> &[Entry] {
        &self.log
    }

    /// The fingerprint of the whole state, random streams included.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        self.physics.absorb(&mut hash);
        self.camera.absorb(&mut hash);
        self.radio.absorb(&mut hash);
        self.hands.absorb(&mut hash);
        self.referee.absorb(&mut hash);
        hash.stream(&self.keepers);
        let state = match self.state {
            State::Pending(_) => 1,
            State::Playing => 2,
            State::Over => 3,
        };
        let Decision { kick, taker, .. } = self.decision;
        let kick = match kick.restart() {
            Restart::KickOff => 1,
            Restart::FreeBall => 2,
            Restart::GoalKick => 3,
            Restart::PenaltyKick => 4,
        };
        let counts = [self.calls, self.frame, self.since, self.waited, u32::from(self.noted), self.log.len() as u32];
        let quadrant = self.decision.kick.quadrant().map_or(0, |quadrant| u32::from(quadrant.number()));
        let words = [state, kick, taker.index() as u32, quadrant, u32::from(self.exchanged)];
        words.into_iter().chain(counts).for_each(|word| hash.u32(word));
        self.ownership.absorb(&mut hash);
        self.statistics.absorb(&mut hash);
        hash.finish()
    }
}

/// Robot 0 keeps the goal, 1 attacks, 2 supports, all by the table.
const PLAIN: Lineup = Lineup { slots: [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter], spots: [None; ROBOTS] };

fn command_of(kick: Kick) -> Command {
    match kick {
        Kick::KickOff => Command::KickOff,
        Kick::FreeBall(_) => Command::FreeBall,
        Kick::GoalKick => Command::GoalKick,
        Kick::Penalty => Command::PenaltyKick,
    }
}
