//! A match as it is looked at: a frame of film for drawing, and everything that an inspector shows of one moment.

use super::game::Colour;
use super::team::coach::machine::{Machine, State as MachineState, TRANSITIONS};
use super::team::{Coached, Duties, Statuses, Watch};
use super::view::{Ball, ROBOTS, View};
use super::world::{Outcome, World};
use crate::bt::{Status, Value};
use serde::Serialize;

/// Reals in a frame of film.
///
/// Blue's three robots, then yellow's: x, y and heading; x and y of the ball; the six roles, 3 bits each, the first
/// lowest; goals, blue's plus 256 times yellow's; the part of the match, 0 for the first half; seconds of play in it; the
/// frames in which each team had the ball, the shots and the swaps of each.
pub const FRAME: usize = 30;

impl World {
    /// Adds the present frame to a film, see [`FRAME`].
    pub fn film(&self, out: &mut Vec<f32>) {
        let game = self.state().game();
        let sides = [Colour::Blue, Colour::Yellow].map(|colour| game.side_of(colour).index());
        let robots = game.robots();
        for side in sides {
            for robot in &robots[side * ROBOTS..(side + 1) * ROBOTS] {
                out.extend([robot.at[0], robot.at[1], robot.heading].map(|real| real as f32));
            }
        }
        out.extend(game.ball().at.map(|real| real as f32));
        let roles =
            [Colour::Blue, Colour::Yellow].into_iter().flat_map(|colour| self.state().team(colour).duties().roles);
        let packed = roles.enumerate().fold(0, |sum, (robot, role)| sum | (role as u32) << (3 * robot));
        let goals = sides.map(|side| game.score()[side].min(255));
        let statistics = game.statistics();
        out.extend([
            packed as f32,
            (goals[0] + 256 * goals[1]) as f32,
            game.phase() as u32 as f32,
            game.seconds() as f32,
        ]);
        let counts = [
            sides.map(|side| statistics.possession[side]),
            sides.map(|side| statistics.shots[side]),
            self.state().swaps(),
        ];
        out.extend(counts.into_iter().flatten().map(|count| count as f32));
    }

    /// Where everything is, as the value of an event `soccer.arrangement`: in millionths, since longer numbers may come back
    /// from a text as their neighbours.
    #[must_use]
    pub fn arrangement(&self) -> serde_json::Value {
        let game = self.state().game();
        let arrangement = game.arrangement();
        let spots = |colour: Colour| {
            arrangement.robots[game.side_of(colour).index()]
                .map(|spot| [spot.at[0], spot.at[1], spot.heading].map(millionths))
        };
        let Ball { at, velocity } = arrangement.ball;
        let ball = [at[0], at[1], velocity[0], velocity[1]].map(millionths);
        serde_json::json!({"ball": ball, "blue": spots(Colour::Blue), "yellow": spots(Colour::Yellow)})
    }
}

/// What an inspector shows of the frame that led to a tick.
#[derive(Clone, Debug, Serialize)]
pub struct Moment {
    /// Control frames of play.
    pub tick: u32,
    /// Blue, then yellow.
    pub teams: [TeamMoment; 2],
    /// How the match stands.
    pub outcome: Outcome,
}

/// What is shown of a team.
#[derive(Clone, Debug, Serialize)]
pub struct TeamMoment {
    /// The team's name in files.
    pub kind: &'static str,
    /// Who plays what.
    pub duties: Duties,
    /// With two Strikers, the robot that gets the ball.
    pub first_striker: Option<usize>,
    /// Changes that broke the organisation and were refused.
    pub violations: u32,
    /// The last of them.
    pub refused: Option<String>,
    /// Why the motors are off.
    pub fault: Option<String>,
    /// `tree`, `machine` or `nobody`.
    pub coach: &'static str,
    /// What each node of the coach tree returned in the frame, in preorder, up to the last that was ticked.
    pub statuses: Vec<&'static str>,
    /// Likewise when the coach answered a call before that frame; empty without one.
    pub call: Vec<&'static str>,
    /// The tree's blackboard: name and value.
    pub board: Vec<(String, String)>,
    /// The machine's state after the frame.
    pub state: Option<&'static str>,
    /// The machine's last transition since the last call, by its place in the table, and its frame.
    pub last: Option<(usize, u32)>,
    /// The edges that were looked at in the frame, in their order, and whether the guard opened.
    pub guards: Vec<(usize, bool)>,
    /// What the nodes of each robot's role tree returned.
    pub roles: [Vec<&'static str>; ROBOTS],
}

/// What was seen of one team while a frame was played.
struct Seen {
    watch: Watch<Statuses>,
    guards: Vec<(usize, bool)>,
}

impl World {
    /// Plays one frame as [`World::step`] does and returns everything that there is to see of it.
    pub fn step_watched(&mut self) -> Moment {
        let mut watches = <[Watch<Statuses>; 2]>::default();
        let guards = self.play(&mut watches, |team, view: &View| team.guards(view));
        let [blue, yellow] = watches;
        let [blue_guards, yellow_guards] = guards;
        self.moment([Seen { watch: blue, guards: blue_guards }, Seen { watch: yellow, guards: yellow_guards }])
    }

    /// The present moment when no frame led to it.
    #[must_use]
    pub fn first_moment(&self) -> Moment {
        self.moment([(); 2].map(|()| Seen { watch: Watch::default(), guards: Vec::new() }))
    }

    fn moment(&self, seen: [Seen; 2]) -> Moment {
        let [blue, yellow] = seen;
        let teams = [self.team_moment(Colour::Blue, blue), self.team_moment(Colour::Yellow, yellow)];
        Moment { tick: self.state().tick(), teams, outcome: self.outcome() }
    }

    fn team_moment(&self, colour: Colour, seen: Seen) -> TeamMoment {
        let team = self.state().team(colour);
        let board = team.tree().map_or_else(Vec::new, |(_, coach)| {
            let entries = coach.memory().entries().filter(|(board, name, _)| *board <= 1 && !name.is_empty());
            entries.map(|(_, name, entry)| (name.to_owned(), shown(entry.value.as_ref()))).collect()
        });
        TeamMoment {
            kind: team.kind().text(),
            duties: *team.duties(),
            first_striker: team.first_striker(),
            violations: team.violations(),
            refused: team.refused().map(ToString::to_string),
            fault: team.fault().map(ToString::to_string),
            coach: match team.kind().coached() {
                Coached::ByTree(_) => "tree",
                Coached::ByMachine { .. } => "machine",
                Coached::ByNobody(_) => "nobody",
            },
            statuses: names(seen.watch.coach.list()),
            call: names(seen.watch.call.list()),
            board,
            state: team.machine().map(|machine| machine.state().name()),
            last: team.machine().and_then(Machine::last),
            guards: seen.guards,
            roles: [0, 1, 2].map(|robot: usize| names(seen.watch.roles[robot].list())),
        }
    }
}

fn millionths(real: f64) -> f64 {
    (real * 1e6).round() / 1e6
}

fn names(statuses: &[Status]) -> Vec<&'static str> {
    statuses.iter().map(|status| status.name()).collect()
}

fn shown(value: Option<&Value>) -> String {
    match value {
        Some(Value::Text(text)) => text.clone(),
        Some(Value::Number(number)) => crate::parameter::number(*number),
        Some(Value::Queue(_)) => "a queue".to_owned(),
        None => String::new(),
    }
}

/// An edge of the state machine as it is drawn.
#[derive(Clone, Debug, Serialize)]
pub struct ShownEdge {
    from: &'static str,
    to: &'static str,
    guard: String,
    function: String,
}

/// The edges of the state machine in the order in which guards are tried.
#[must_use]
pub fn machine_edges() -> Vec<ShownEdge> {
    let edges = TRANSITIONS.iter().map(|edge| ShownEdge {
        from: edge.from.name(),
        to: edge.to.name(),
        guard: edge.guard.text(),
        function: edge.function.text(),
    });
    edges.collect()
}

/// The names of the machine's states, the input states first.
#[must_use]
pub fn machine_states() -> Vec<(&'static str, bool)> {
    MachineState::ALL.map(|state| (state.name(), state.is_input())).to_vec()
}
