//! A match with its two teams.
//!
//! One tick is one control frame of play, 1/60 s; what the referee waits for takes no tick.

use super::game::{Colour, Match};
use super::hand::{Driven, Intervention};
use super::params::Params;
use super::team::{Event, EventKind, Team, TeamError, TeamKind, Watch};
use super::view::{ROBOTS, View, Wheels};
use crate::bt::{Recorder, Silent};
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, stream};
use serde::Serialize;

/// A match that plays itself.
#[derive(Clone, Debug)]
pub struct World {
    state: State,
}

/// The state at one tick.
#[derive(Clone, Debug)]
pub struct State {
    game: Match,
    /// Blue's, then yellow's.
    teams: [Team; 2],
    events: Vec<TeamEvent>,
    /// Swaps of roles and changes of group of each team.
    counts: [[u32; 2]; 2],
    /// The robot that somebody drives.
    driven: Option<Driven>,
}

/// Something that one of the coaches did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TeamEvent {
    /// Whose coach.
    pub team: Colour,
    /// What, and in which frame.
    pub event: Event,
}

/// The most events that are kept: a tree that errs in every frame must not fill the memory.
const MOST_EVENTS: usize = 20_000;

/// How a match came out; arrays hold blue's and yellow's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Goals, without those of a shoot-out.
    pub goals: [u32; 2],
    /// Goals of the shoot-out; absent where there was none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shoot_out: Option<[u32; 2]>,
    /// Seconds of play.
    pub seconds: f64,
    /// What was counted for blue.
    pub blue: TeamReport,
    /// What was counted for yellow.
    pub yellow: TeamReport,
    /// How it ended; `None` while it goes on.
    pub finished: Option<Finished>,
}

/// What was counted for one team.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub struct TeamReport {
    /// The team's name.
    pub team: &'static str,
    /// The share of the time in which it touched the ball last; 0 before anybody did.
    pub possession: f64,
    /// Balls let go toward the goal, and goals pushed in.
    pub shots: u32,
    /// Exchanges of roles within a group.
    pub swaps: u32,
    /// Changes between attack and defence.
    pub group_changes: u32,
    /// Kick-offs, free balls, goal kicks and penalties it took.
    pub calls: [u32; 4],
    /// Changes that broke the organisation and were refused.
    pub violations: u32,
    /// Commands that were no numbers.
    pub faults: u32,
}

/// How a match ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finished {
    /// Blue has won.
    Blue,
    /// Yellow has won.
    Yellow,
    /// Nobody has.
    Tie,
}

impl Finished {
    /// The end in words.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Blue => "full time, blue won",
            Self::Yellow => "full time, yellow won",
            Self::Tie => "full time, a tie",
        }
    }
}

impl World {
    /// A match before its first kick-off.
    ///
    /// # Errors
    /// The field's name and what is wrong with it: margins out of bounds, or a tree that is refused, with line and column.
    pub fn new(params: &Params, seed: Seed) -> Result<Self, (&'static str, String)> {
        let blue = team(params, seed, Colour::Blue)?;
        let yellow = team(params, seed, Colour::Yellow)?;
        let game = Match::new(params, seed);
        Ok(Self { state: State { game, teams: [blue, yellow], events: Vec::new(), counts: [[0; 2]; 2], driven: None } })
    }

    /// Everything that changes.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Goes to a state of this same match.
    pub fn restore(&mut self, state: &State) {
        self.state.clone_from(state);
    }

    /// Plays one control frame; nothing when the match is over.
    pub fn step(&mut self) {
        self.state.step(&mut <[Watch<Silent>; 2]>::default(), |_, _| ());
    }

    /// As [`World::step`], with recorders for blue's and yellow's trees.
    ///
    /// - `look`: asked for each team before it plays the frame, with what it is told.
    pub(super) fn play<R: Recorder, T>(
        &mut self,
        watches: &mut [Watch<R>; 2],
        look: impl Fn(&Team, &View) -> T,
    ) -> [T; 2] {
        self.state.step(watches, look)
    }

    /// Does what somebody outside wants, before the next frame. Places were checked when they were read; those that cannot
    /// be taken change nothing.
    pub fn intervene(&mut self, intervention: &Intervention) {
        match intervention {
            Intervention::Arrange(arrangement) => {
                self.state.answer(&mut <[Watch<Silent>; 2]>::default());
                let _ = self.state.game.arrange(&arrangement.keeping(&self.state.game.arrangement()));
            }
            Intervention::Restart(kick, taker) => {
                self.state.game.stage(*kick, *taker);
            }
            Intervention::Drive(driven) => self.state.driven = *driven,
        }
    }

    /// How the match stands.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        let State { game, teams, counts, .. } = &self.state;
        let sides = [Colour::Blue, Colour::Yellow].map(|colour| game.side_of(colour).index());
        let statistics = game.statistics();
        let owned: u32 = statistics.possession.iter().sum();
        let report = |team: usize| {
            let side = sides[team];
            TeamReport {
                team: teams[team].kind().text(),
                possession: f64::from(statistics.possession[side]) / f64::from(owned.max(1)),
                shots: statistics.shots[side],
                swaps: counts[team][0],
                group_changes: counts[team][1],
                calls: statistics.calls[side],
                violations: teams[team].violations(),
                faults: statistics.faults[side],
            }
        };
        let ours = |goals: [u32; 2]| sides.map(|side| goals[side]);
        Outcome {
            goals: ours(game.score()),
            shoot_out: game.shoot_out_score().map(ours),
            seconds: f64::from(game.frame()) / 60.0,
            blue: report(0),
            yellow: report(1),
            finished: game.finished().map(|end| match end.winner {
                None => Finished::Tie,
                Some(side) if side.index() == sides[0] => Finished::Blue,
                Some(_) => Finished::Yellow,
            }),
        }
    }

    /// How the match ended; `None` while it goes on.
    #[must_use]
    pub fn finished(&self) -> Option<Finished> {
        self.state.game.finished()?;
        self.outcome().finished
    }

    /// The fingerprint of the whole state.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let State { game, teams, counts, .. } = &self.state;
        let mut hash = Fingerprint::default();
        hash.u64(game.fingerprint());
        for team in teams {
            team.feed(&mut hash);
        }
        for &count in counts.iter().flatten() {
            hash.u32(count);
        }
        if let Some(Driven { team, robot, wheels }) = self.state.driven {
            hash.u32(1 + index(team) as u32);
            hash.u32(robot as u32);
            hash.f64(wheels.left);
            hash.f64(wheels.right);
        }
        hash.finish()
    }
}

impl State {
    /// Control frames of play since the match began.
    #[must_use]
    pub fn tick(&self) -> u32 {
        self.game.frame()
    }

    /// The match without its teams.
    #[must_use]
    pub fn game(&self) -> &Match {
        &self.game
    }

    /// The team of that colour.
    #[must_use]
    pub fn team(&self, colour: Colour) -> &Team {
        &self.teams[index(colour)]
    }

    /// What the coaches did, oldest first.
    #[must_use]
    pub fn events(&self) -> &[TeamEvent] {
        &self.events
    }

    /// Swaps of roles of each team since the match began.
    #[must_use]
    pub fn swaps(&self) -> [u32; 2] {
        self.counts.map(|[swaps, _]| swaps)
    }

    /// The robot that somebody drives.
    #[must_use]
    pub fn driven(&self) -> Option<Driven> {
        self.driven
    }

    /// Lets the teams answer the pending call, if there is one.
    fn answer<R: Recorder>(&mut self, watches: &mut [Watch<R>; 2]) {
        let Self { game, teams, .. } = self;
        let sides = [Colour::Blue, Colour::Yellow].map(|colour| game.side_of(colour));
        if game.pending(sides[0]).is_none() {
            return;
        }
        let mut lineups =
            [0, 1].map(|team| teams[team].called_watched(&game.view(sides[team]), &mut watches[team].call));
        // By side, which is what a match takes.
        if sides[0].index() == 1 {
            lineups.swap(0, 1);
        }
        game.place(&lineups);
    }

    fn step<R: Recorder, T>(&mut self, watches: &mut [Watch<R>; 2], look: impl Fn(&Team, &View) -> T) -> [T; 2] {
        self.answer(watches);
        let Self { game, teams, events, counts, driven } = self;
        let sides = [Colour::Blue, Colour::Yellow].map(|colour| game.side_of(colour));
        let views = sides.map(|side| game.view(side));
        let seen = [0, 1].map(|team| look(&teams[team], &views[team]));
        let mut wheels = [[Wheels::default(); ROBOTS]; 2];
        for (((team, side), view), watch) in teams.iter_mut().zip(sides).zip(&views).zip(watches) {
            wheels[side.index()] = team.play_watched(view, watch);
        }
        if let Some(Driven { team, robot, wheels: told }) = *driven {
            wheels[sides[index(team)].index()][robot] = told;
        }
        game.step(&wheels);
        for ((colour, team), counts) in [Colour::Blue, Colour::Yellow].into_iter().zip(teams).zip(counts) {
            for event in team.take_events() {
                match event.kind {
                    EventKind::Swap(_) => counts[0] += 1,
                    EventKind::ChangeGroup(_) => counts[1] += 1,
                    EventKind::Start { .. }
                    | EventKind::Become { .. }
                    | EventKind::Refused(_)
                    | EventKind::Written(_)
                    | EventKind::Fault(_) => {}
                }
                if events.len() < MOST_EVENTS {
                    events.push(TeamEvent { team: colour, event });
                }
            }
        }
        seen
    }

    /// About how many bytes a copy takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.events.len() * size_of::<TeamEvent>() + size_of_val(self.game.log()) + 8192
    }
}

fn index(colour: Colour) -> usize {
    match colour {
        Colour::Blue => 0,
        Colour::Yellow => 1,
    }
}

/// What a team is made of.
struct Wishes<'a> {
    kind: TeamKind,
    coach: Option<&'a str>,
    roles: Option<&'a str>,
    /// The names of the fields of both.
    fields: [&'static str; 2],
}

impl<'a> Wishes<'a> {
    fn of(params: &'a Params, colour: Colour) -> Self {
        let (kind, trees, fields) = match colour {
            Colour::Blue => (params.blue, [&params.blue_coach, &params.blue_roles], ["blue-coach", "blue-roles"]),
            Colour::Yellow => {
                (params.yellow, [&params.yellow_coach, &params.yellow_roles], ["yellow-coach", "yellow-roles"])
            }
        };
        let [coach, roles] = trees.map(|text| (!text.trim().is_empty()).then_some(text.as_str()));
        Self { kind, coach, roles, fields }
    }

    /// The field that an error is about, and the error in words.
    fn fault(&self, error: &TeamError) -> (&'static str, String) {
        let field = match error {
            TeamError::Margins(_) => "enter",
            TeamError::Coach(_) | TeamError::NoTree(_) => self.fields[0],
            TeamError::Roles(_) => self.fields[1],
        };
        (field, error.to_string())
    }
}

/// Checks what a team was given, without making one.
pub(super) fn check(params: &Params, colour: Colour) -> Result<(), (&'static str, String)> {
    let wishes = Wishes::of(params, colour);
    Team::check(wishes.kind, params.margins(), wishes.coach, wishes.roles).map_err(|error| wishes.fault(&error))
}

fn team(params: &Params, seed: Seed, colour: Colour) -> Result<Team, (&'static str, String)> {
    let wishes = Wishes::of(params, colour);
    // With the side and not with the team, like all luck: a match with sides exchanged is fair to both.
    let luck = stream(seed, Purpose::Penalty, index(colour) as u32 ^ u32::from(params.sides_exchanged));
    Team::new(wishes.kind, params.margins(), wishes.coach, wishes.roles, luck).map_err(|error| wishes.fault(&error))
}
