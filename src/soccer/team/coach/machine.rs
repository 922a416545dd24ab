//! The Coach as a finite state machine of eight states: five input states and three swap states.
//!
//! Paper: section 4.3 and Figure 3. The text fixes the numbers of states, that the start state is chosen before the machine
//! runs, that each edge has a guard and a transition function, and that a swap state is left by the negation of the swap
//! condition, which gives hysteresis. Names of the states, edges and guards are ours.

use crate::fingerprint::Fingerprint;
use crate::soccer::team::conditions::{Condition, Form, Scene};
use crate::soccer::team::duties::{Formation, Pair, Role};
use crate::soccer::team::margins::Margins;
use crate::soccer::team::roster::Roster;
use crate::soccer::team::start;
use crate::soccer::view::View;
use serde::Serialize;

/// A state of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub enum State {
    /// Goalkeeper, Striker, Assistant.
    Attack,
    /// Goalkeeper and two Strikers.
    AttackTwoStrikers,
    /// Goalkeeper, Penalty Kicker, Assistant.
    PenaltyKick,
    /// Goalkeeper, Fullback, Wingback.
    Defense,
    /// Penalty Defender, Fullback, Wingback.
    PenaltyDefense,
    /// Striker and Assistant have just swapped.
    SwapStrikerAssistant,
    /// Fullback and Wingback have just swapped.
    SwapFullbackWingback,
    /// Goalkeeper and Wingback have just swapped.
    SwapGoalkeeperWingback,
}

impl State {
    /// Every state.
    pub const ALL: [Self; 8] = [
        Self::Attack,
        Self::AttackTwoStrikers,
        Self::PenaltyKick,
        Self::Defense,
        Self::PenaltyDefense,
        Self::SwapStrikerAssistant,
        Self::SwapFullbackWingback,
        Self::SwapGoalkeeperWingback,
    ];

    /// The state in which play starts with a formation.
    #[must_use]
    pub fn of(formation: Formation) -> Self {
        match formation {
            Formation::TwoStrikers => Self::AttackTwoStrikers,
            Formation::StrikerAssistant => Self::Attack,
            Formation::PenaltyKick => Self::PenaltyKick,
            Formation::FullbackWingback => Self::Defense,
            Formation::PenaltyDefense => Self::PenaltyDefense,
        }
    }

    /// True for the states in which play can start.
    #[must_use]
    pub fn is_input(self) -> bool {
        match self {
            Self::Attack | Self::AttackTwoStrikers | Self::PenaltyKick | Self::Defense | Self::PenaltyDefense => true,
            Self::SwapStrikerAssistant | Self::SwapFullbackWingback | Self::SwapGoalkeeperWingback => false,
        }
    }

    /// The name in logs and drawings.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Attack => "Attack",
            Self::AttackTwoStrikers => "AttackTwoStrikers",
            Self::PenaltyKick => "PenaltyKick",
            Self::Defense => "Defense",
            Self::PenaltyDefense => "PenaltyDefense",
            Self::SwapStrikerAssistant => "SwapStrikerAssistant",
            Self::SwapFullbackWingback => "SwapFullbackWingback",
            Self::SwapGoalkeeperWingback => "SwapGoalkeeperWingback",
        }
    }
}

/// When a transition is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Guard {
    /// A condition holds in its enter form, and no lock is on.
    When(Condition),
    /// A condition does not hold even in its leave form, and the dwell after the swap is over.
    Unless(Condition),
}

impl Guard {
    /// The guard as it is drawn.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Self::When(condition) => condition.id().to_owned(),
            Self::Unless(condition) => format!("not {}", condition.id()),
        }
    }

    fn opens(self, scene: &Scene, roster: &Roster) -> bool {
        match self {
            Self::When(condition) => scene.enters(condition),
            Self::Unless(condition) => {
                scene.seconds_since(roster.duties().swap_time) >= scene.margins.swap_dwell
                    && !scene.holds(condition, Form::Leave)
            }
        }
    }
}

/// What a transition does to the roles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Nothing.
    Nothing,
    /// The two robots exchange their roles.
    Swap(Pair),
    /// Every robot takes the role that belongs to its own in the other group.
    ChangeGroup,
    /// The robot with the first role, of several the one farthest from the ball, takes the second.
    Become(Role, Role),
}

impl Function {
    /// The function as it is drawn.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Self::Nothing => "none".to_owned(),
            Self::Swap(pair) => {
                let [first, second] = pair.roles().map(Role::text);
                format!("exchange {first} and {second}")
            }
            Self::ChangeGroup => "change group".to_owned(),
            Self::Become(from, to) => format!("{} becomes {}", from.text(), to.text()),
        }
    }
}

/// An edge of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition {
    /// Where it leads from.
    pub from: State,
    /// Where it leads to.
    pub to: State,
    /// When it is taken.
    pub guard: Guard,
    /// What it does.
    pub function: Function,
}

const fn edge(from: State, to: State, guard: Guard, function: Function) -> Transition {
    Transition { from, to, guard, function }
}

/// All edges; of one state, the guards are tried in this order.
///
/// Source: our choice; the paper prints no edges. That a Wingback becomes Striker when the group changes is the paper's.
pub const TRANSITIONS: [Transition; 11] = {
    use Condition as C;
    use Function::{Become, ChangeGroup, Nothing, Swap};
    use Guard::{Unless, When};
    use Pair::{FullbackWingback, GoalkeeperWingback, StrikerAssistant};
    use Role::{Assistant, Goalkeeper, PenaltyDefender, PenaltyKicker, Striker};
    use State as S;
    [
        edge(S::AttackTwoStrikers, S::Attack, When(C::TwoStrikersOver), Become(Striker, Assistant)),
        edge(S::PenaltyKick, S::Attack, When(C::KickOver), Become(PenaltyKicker, Striker)),
        edge(S::PenaltyDefense, S::Defense, When(C::PenaltyOver), Become(PenaltyDefender, Goalkeeper)),
        edge(S::Attack, S::Defense, When(C::LostBall), ChangeGroup),
        edge(S::Attack, S::SwapStrikerAssistant, When(C::SwapStrikerAssistant), Swap(StrikerAssistant)),
        edge(S::Defense, S::Attack, When(C::WonBall), ChangeGroup),
        edge(S::Defense, S::SwapFullbackWingback, When(C::SwapFullbackWingback), Swap(FullbackWingback)),
        edge(S::Defense, S::SwapGoalkeeperWingback, When(C::SwapGoalkeeperWingback), Swap(GoalkeeperWingback)),
        edge(S::SwapStrikerAssistant, S::Attack, Unless(C::SwapStrikerAssistant), Nothing),
        edge(S::SwapFullbackWingback, S::Defense, Unless(C::SwapFullbackWingback), Nothing),
        edge(S::SwapGoalkeeperWingback, S::Defense, Unless(C::SwapGoalkeeperWingback), Nothing),
    ]
};

/// The machine while it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    state: State,
    /// Without it, no edge into a swap state is tried.
    swaps: bool,
    last: Option<(usize, u32)>,
}

impl Machine {
    /// A machine before its first call.
    ///
    /// - `swaps`: false leaves out the three swap states.
    #[must_use]
    pub fn new(swaps: bool) -> Self {
        Self { state: State::Defense, swaps, last: None }
    }

    /// The present state.
    #[must_use]
    pub fn state(&self) -> State {
        self.state
    }

    /// The last transition since the last call, as index into [`TRANSITIONS`], and its control frame.
    #[must_use]
    pub fn last(&self) -> Option<(usize, u32)> {
        self.last
    }

    /// Starts after a call: gives out the roles and chooses the input state, outside the machine.
    pub fn start(&mut self, view: &View, roster: &mut Roster) {
        let formation = start::formation(&view.call);
        if roster.start(view, start::roles(formation)) {
            roster.set_mode(formation.mode());
            self.state = State::of(formation);
            self.last = None;
        }
    }

    /// Whether an edge leaves the present state of this machine.
    fn leaves(&self, edge: Transition) -> bool {
        edge.from == self.state && (self.swaps || edge.to.is_input())
    }

    /// The edges that leave the present state, as indices into [`TRANSITIONS`] in the order in which they are tried, and
    /// whether each guard opens.
    #[must_use]
    pub fn guards(&self, view: &View, roster: &Roster, margins: &Margins) -> Vec<(usize, bool)> {
        let scene = roster.scene(view, margins);
        let edges = TRANSITIONS.iter().enumerate().filter(|(_, edge)| self.leaves(**edge));
        edges.map(|(index, edge)| (index, edge.guard.opens(&scene, roster))).collect()
    }

    /// Makes at most one transition.
    pub fn step(&mut self, view: &View, roster: &mut Roster, margins: &Margins) {
        let scene = roster.scene(view, margins);
        let found = TRANSITIONS.iter().position(|edge| self.leaves(*edge) && edge.guard.opens(&scene, roster));
        let Some(index) = found else { return };
        let edge = TRANSITIONS[index];
        let done = match edge.function {
            Function::Nothing => true,
            Function::Swap(pair) => roster.swap(view, pair),
            Function::ChangeGroup => roster.change_group(view),
            Function::Become(from, to) => roster.transfer(view, from, to),
        };
        if done {
            self.state = edge.to;
            self.last = Some((index, view.frame));
            roster.set_mode(roster.duties().formation.mode());
        }
    }

    /// Takes everything that decides what follows into a fingerprint.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(self.state as u32);
        hash.u32(u32::from(self.swaps));
        hash.u64(self.last.map_or(u64::MAX, |(index, frame)| (index as u64) << 32 | u64::from(frame)));
    }
}
