//! A whole team: its coach, its three robots, and what they remember.

use super::coach::machine::Machine;
use super::coach::{Program, TreeCoach};
use super::duties::{Duties, Formation, Role};
use super::geometry::{FRAMES_PER_SECOND, distance};
use super::kind::{Coached, TeamKind};
use super::margins::{Margins, MarginsError};
use super::organisation::{Checker, Violation};
use super::roles::{Player, Roles, Scene};
use super::roster::{Event, Roster};
use super::start;
use super::watch::Watch;
use crate::bt::xml::Problem;
use crate::bt::{Recorder, Silent, TickError};
use crate::fingerprint::Fingerprint;
use crate::random::Stream;
use crate::soccer::view::{Lineup, ROBOTS, Restart, Slot, Spot, View, Wheels, Whose};
use rand::RngExt;
use std::f64::consts::FRAC_PI_2;
use std::fmt;
use std::sync::Arc;

/// Why a team cannot play.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TeamError {
    /// A margin is out of its range.
    Margins(MarginsError),
    /// The coach tree is refused.
    Coach(Vec<Problem>),
    /// The trees of the roles are refused.
    Roles(Vec<Problem>),
    /// A coach tree was given to a team that has another coach, or none.
    NoTree(TeamKind),
}

impl fmt::Display for TeamError {
    /// One line for each problem.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, problems) = match self {
            Self::Margins(error) => return error.fmt(out),
            Self::NoTree(kind) => {
                return write!(
                    out,
                    "expected no coach tree for the team {:?}, which a tree does not coach",
                    kind.text()
                );
            }
            Self::Coach(problems) => ("coach", problems),
            Self::Roles(problems) => ("roles", problems),
        };
        for (index, problem) in problems.iter().filter(|problem| !problem.warning).enumerate() {
            let gap = if index > 0 { "\n" } else { "" };
            write!(out, "{gap}{what}, {problem}")?;
        }
        Ok(())
    }
}

impl std::error::Error for TeamError {}

/// The trees of a team; shared by its copies.
#[derive(Debug)]
struct Programs {
    coach: Option<Program>,
    roles: Roles,
}

/// Who gives out the roles.
#[derive(Clone, Debug)]
enum Coach {
    Tree(Box<TreeCoach>),
    Machine(Machine),
    Nobody(Formation),
}

/// A team in a match: answers calls with a lineup and views with wheel speeds. A copy goes on as the original would.
#[derive(Clone, Debug)]
pub struct Team {
    kind: TeamKind,
    margins: Margins,
    programs: Arc<Programs>,
    coach: Coach,
    roster: Roster,
    players: [Player; ROBOTS],
    /// The last call that was answered.
    call: u32,
    /// Frames played.
    frames: u32,
    first_striker: Option<usize>,
    penalty_side: f64,
    penalties: Stream,
    /// Why the motors are off until the next call.
    fault: Option<TickError>,
}

impl Team {
    /// Checks what a team is given, without making one; arguments and errors as for [`Team::new`].
    ///
    /// # Errors
    /// What is wrong with the margins or with a tree.
    pub fn check(kind: TeamKind, margins: Margins, coach: Option<&str>, roles: Option<&str>) -> Result<(), TeamError> {
        kind.margins(margins).check().map_err(TeamError::Margins)?;
        if let Some(text) = roles {
            Roles::read(text).map_err(TeamError::Roles)?;
        }
        match (kind.coached(), coach) {
            (Coached::ByTree(_), Some(text)) => Program::read(text).map(|_| ()).map_err(TeamError::Coach),
            (Coached::ByMachine { .. } | Coached::ByNobody(_), Some(_)) => Err(TeamError::NoTree(kind)),
            (_, None) => Ok(()),
        }
    }

    /// A team before its first call.
    ///
    /// - `margins`: of all conditions; [`TeamKind::TreeDoubleMargins`] doubles them.
    /// - `coach`, `roles`: XML to be used instead of the built-in trees; a coach only for teams that a tree coaches.
    /// - `penalties`: draws on which side of the ball a penalty kicker starts.
    ///
    /// # Errors
    /// What is wrong with the margins or with a tree.
    pub fn new(
        kind: TeamKind,
        margins: Margins,
        coach: Option<&str>,
        roles: Option<&str>,
        penalties: Stream,
    ) -> Result<Self, TeamError> {
        let margins = kind.margins(margins);
        margins.check().map_err(TeamError::Margins)?;
        let roster = Roster::default();
        let roles = Roles::read(roles.unwrap_or(kind.roles())).map_err(TeamError::Roles)?;
        let (program, coach) = match (kind.coached(), coach) {
            (Coached::ByTree(built_in), given) => {
                let program = Program::read(given.unwrap_or(built_in)).map_err(TeamError::Coach)?;
                let coach = TreeCoach::new(&program, roster.duties());
                (Some(program), Coach::Tree(Box::new(coach)))
            }
            (Coached::ByMachine { .. } | Coached::ByNobody(_), Some(_)) => return Err(TeamError::NoTree(kind)),
            (Coached::ByMachine { swaps }, None) => (None, Coach::Machine(Machine::new(swaps))),
            (Coached::ByNobody(formation), None) => (None, Coach::Nobody(formation)),
        };
        Ok(Self {
            kind,
            margins,
            programs: Arc::new(Programs { coach: program, roles }),
            coach,
            roster,
            players: Default::default(),
            call: 0,
            frames: 0,
            first_striker: None,
            penalty_side: 1.0,
            penalties,
            fault: None,
        })
    }

    /// Which team it is.
    #[must_use]
    pub fn kind(&self) -> TeamKind {
        self.kind
    }

    /// Who plays what.
    #[must_use]
    pub fn duties(&self) -> &Duties {
        self.roster.duties()
    }

    /// The state machine, if it is the coach.
    #[must_use]
    pub fn machine(&self) -> Option<&Machine> {
        match &self.coach {
            Coach::Machine(machine) => Some(machine),
            Coach::Tree(_) | Coach::Nobody(_) => None,
        }
    }

    /// The coach tree and what it remembers, if a tree is the coach.
    #[must_use]
    pub fn tree(&self) -> Option<(&Program, &TreeCoach)> {
        match (&self.coach, &self.programs.coach) {
            (Coach::Tree(coach), Some(program)) => Some((program, coach)),
            _ => None,
        }
    }

    /// The trees of the roles.
    #[must_use]
    pub fn roles(&self) -> &Roles {
        &self.programs.roles
    }

    /// With two Strikers, the one that gets the ball.
    #[must_use]
    pub fn first_striker(&self) -> Option<usize> {
        self.first_striker
    }

    /// The edges that leave the machine's present state, by their place in its table, in the order in which they are
    /// tried, and whether each guard opens; empty for teams without a machine.
    #[must_use]
    pub fn guards(&self, view: &View) -> Vec<(usize, bool)> {
        self.machine().map_or_else(Vec::new, |machine| machine.guards(view, &self.roster, &self.margins))
    }

    /// The last change that broke the organisation and was refused.
    #[must_use]
    pub fn refused(&self) -> Option<&Violation> {
        self.roster.refused()
    }

    /// Changes that broke the organisation and were refused, since the start of the match.
    #[must_use]
    pub fn violations(&self) -> u32 {
        self.roster.violations()
    }

    /// What the coach did since it was asked last.
    pub fn take_events(&mut self) -> Vec<Event> {
        self.roster.take_events()
    }

    /// Why the motors are off until the next call: the tick of a tree ended with an error.
    #[must_use]
    pub fn fault(&self) -> Option<&TickError> {
        self.fault.as_ref()
    }

    /// Answers a call: gives out the roles of the start and says where the robots shall stand.
    ///
    /// - `view`: the robots and the ball as they are when the referee calls, before they are placed.
    pub fn called(&mut self, view: &View) -> Lineup {
        self.called_watched(view, &mut Silent)
    }

    /// As [`Team::called`], with a recorder that sees what the nodes of the coach tree return.
    pub fn called_watched<R: Recorder>(&mut self, view: &View, recorder: &mut R) -> Lineup {
        self.begin(view, recorder);
        let roles = self.roster.duties().roles;
        let own_place = |role: Role| match role {
            Role::PenaltyKicker => Some(self.penalty_spot()),
            // Ready to go along their lines, which they cannot when they look ahead as the table has them.
            Role::PenaltyDefender => Some(Spot { at: [-0.7125, 0.0], heading: FRAC_PI_2 }),
            Role::Goalkeeper if view.call.restart != Restart::GoalKick || view.call.taker != Whose::Ours => {
                Some(Spot { at: [-0.69, 0.0], heading: FRAC_PI_2 })
            }
            Role::Goalkeeper | Role::Striker | Role::Assistant | Role::Fullback | Role::Wingback => None,
        };
        Lineup { slots: self.slots(roles), spots: roles.map(own_place) }
    }

    /// The wheel speeds of a frame of play.
    pub fn play(&mut self, view: &View) -> [Wheels; ROBOTS] {
        self.play_watched(view, &mut Watch::<Silent>::default())
    }

    /// As [`Team::play`], with recorders that see what the nodes of the trees return.
    pub fn play_watched<R: Recorder>(&mut self, view: &View, watch: &mut Watch<R>) -> [Wheels; ROBOTS] {
        if view.call.number != self.call {
            self.begin(view, &mut watch.coach);
        }
        let passed = milliseconds(self.frames + 1) - milliseconds(self.frames);
        self.frames += 1;
        if self.fault.is_some() {
            return [Wheels::default(); ROBOTS];
        }
        self.coach(view, passed, &mut watch.coach);
        if self.fault.is_some() {
            return [Wheels::default(); ROBOTS];
        }
        if let Err(violation) = Checker::built_in().look(self.roster.duties()) {
            self.roster.refuse(view, violation);
        }
        self.choose_first_striker(view);
        let scene = Scene {
            view,
            roles: self.roster.duties().roles,
            first_striker: self.first_striker,
            penalty_side: self.penalty_side,
        };
        let mut wheels = [Wheels::default(); ROBOTS];
        for (me, recorder) in watch.roles.iter_mut().enumerate() {
            match self.players[me].play(&self.programs.roles, &scene, me, passed, recorder) {
                Ok(told) => wheels[me] = told,
                Err(error) => self.fault = Some(self.fault.take().unwrap_or(error)),
            }
        }
        if let Some(fault) = &self.fault {
            self.roster.fault(view, fault.to_string());
            return [Wheels::default(); ROBOTS];
        }
        wheels
    }

    /// Lets the coach deal with a new call.
    fn begin<R: Recorder>(&mut self, view: &View, recorder: &mut R) {
        self.call = view.call.number;
        self.fault = None;
        self.first_striker = None;
        self.players.iter_mut().for_each(Player::restart);
        if view.call.restart == Restart::PenaltyKick && view.call.taker == Whose::Ours {
            self.penalty_side = if self.penalties.random::<bool>() { 1.0 } else { -1.0 };
        }
        match &mut self.coach {
            Coach::Tree(coach) => coach.tell(&view.call),
            Coach::Machine(machine) => machine.start(view, &mut self.roster),
            Coach::Nobody(formation) => {
                if self.roster.start(view, start::roles(*formation)) {
                    self.roster.set_mode(formation.mode());
                }
            }
        }
        if matches!(self.coach, Coach::Tree(_)) {
            self.coach(view, 0, recorder);
        }
        self.choose_first_striker(view);
    }

    /// Lets the coach decide once.
    fn coach<R: Recorder>(&mut self, view: &View, passed: u64, recorder: &mut R) {
        match (&mut self.coach, &self.programs.coach) {
            (Coach::Tree(coach), Some(program)) => {
                if let Err(error) = coach.step(program, view, &mut self.roster, &self.margins, passed, recorder) {
                    self.roster.fault(view, error.to_string());
                    self.fault = Some(error);
                }
            }
            (Coach::Machine(machine), _) => machine.step(view, &mut self.roster, &self.margins),
            (Coach::Tree(_), None) | (Coach::Nobody(_), _) => {}
        }
    }

    /// Of two Strikers the nearer one to the ball gets it; they exchange when the other is nearer by more than 0.20.
    ///
    /// Source: our choice.
    fn choose_first_striker(&mut self, view: &View) {
        if self.roster.duties().formation != Formation::TwoStrikers {
            self.first_striker = None;
            return;
        }
        let roles = self.roster.duties().roles;
        let way = |robot: usize| distance(view.ours[robot].at, view.ball.at);
        let mut first = self.first_striker.filter(|first| roles[*first] == Role::Striker);
        let advantage = if first.is_some() { 0.20 } else { 0.0 };
        for robot in (0..ROBOTS).filter(|robot| roles[*robot] == Role::Striker) {
            if first.is_none_or(|first| way(robot) < way(first) - advantage) {
                first = Some(robot);
            }
        }
        self.first_striker = first;
    }

    /// The slot of each robot by its role; of two Strikers, the first one attacks.
    fn slots(&self, roles: [Role; ROBOTS]) -> [Slot; ROBOTS] {
        std::array::from_fn(|robot| match roles[robot] {
            Role::Goalkeeper | Role::PenaltyDefender => Slot::Goalkeeper,
            Role::Wingback | Role::PenaltyKicker => Slot::Attacker,
            Role::Striker if self.first_striker.is_none_or(|first| first == robot) => Slot::Attacker,
            Role::Striker | Role::Assistant | Role::Fullback => Slot::Supporter,
        })
    }

    /// Where the penalty kicker stands.
    ///
    /// Source: our choice.
    fn penalty_spot(&self) -> Spot {
        let at = [0.285, self.penalty_side * 0.0225];
        let aim = [0.75, -self.penalty_side * 0.144];
        Spot { at, heading: libm::atan2(aim[1] - at[1], aim[0] - at[0]) }
    }

    /// Takes everything that decides what follows into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(self.kind as u32);
        self.margins.feed(hash);
        match &self.coach {
            Coach::Tree(coach) => coach.feed(hash),
            Coach::Machine(machine) => machine.feed(hash),
            Coach::Nobody(formation) => hash.u32(*formation as u32),
        }
        self.roster.feed(hash);
        self.players.iter().for_each(|player| player.feed(hash));
        hash.u32(self.call);
        hash.u32(self.frames);
        hash.u64(self.first_striker.map_or(u64::MAX, |robot| robot as u64));
        hash.f64(self.penalty_side);
        hash.stream(&self.penalties);
        hash.u32(u32::from(self.fault.is_some()));
    }
}

/// Whole milliseconds that so many frames take.
fn milliseconds(frames: u32) -> u64 {
    u64::from(frames) * 1000 / FRAMES_PER_SECOND as u64
}
