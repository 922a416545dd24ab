//! The two coaches: every edge of the machine, the same decisions of the tree, and where they differ.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{at, call, started, with};
use swarm_playground::soccer::team::coach::machine::{Guard, Machine, State, TRANSITIONS};
use swarm_playground::soccer::team::{EventKind, Formation, Mode, Pair, Role, Team, TeamKind};
use swarm_playground::soccer::view::{Restart, View, Whose};

const KEEPER: [f64; 2] = [-0.69, 0.0];
/// Robot 0 keeps the goal, 1 plays the ball, 2 supports, whatever the call.
const PLACES: [[f64; 2]; 3] = [KEEPER, [-0.1, 0.0], [-0.4, 0.4]];

fn begin(kind: TeamKind, restart: Restart, taker: Whose, quadrant: u8) -> Team {
    let view = View { call: call(restart, taker, quadrant, 1), ..with([0.0; 2], [0.0; 2], PLACES) };
    let mut team = started(kind, &view);
    team.take_events();
    team
}

fn attacking(kind: TeamKind) -> Team {
    begin(kind, Restart::KickOff, Whose::Ours, 0)
}

fn defending(kind: TeamKind) -> Team {
    begin(kind, Restart::KickOff, Whose::Theirs, 0)
}

/// Robot 1 Striker, 2 Assistant: case (a) of their swap.
fn striker_assistant(frame: u32) -> View {
    View { frame, since: frame, ..with([0.0, 0.0], [0.0; 2], [KEEPER, [-0.3, 0.3], [-0.1, 0.0]]) }
}

/// Robot 1 Wingback, 2 Fullback: the Fullback is nearer and goal side.
fn fullback_wingback(frame: u32) -> View {
    View { frame, since: frame, ..with([-0.2, 0.0], [0.0; 2], [KEEPER, [0.1, 0.0], [-0.3, 0.0]]) }
}

/// The Wingback is nearer to the goal than the keeper, who was pulled out; the Fullback is far.
fn goalkeeper_wingback(frame: u32, wingback: usize) -> View {
    let mut view = with([-0.68, 0.45], [0.0; 2], [[-0.65, 0.35], [-0.3, -0.5], [-0.3, -0.5]]);
    view.ours[wingback] = at(-0.70, 0.05);
    View { frame, since: frame, ..view }
}

fn ball_at(x: f64, frame: u32) -> View {
    View { frame, since: frame, ..with([x, 0.0], [0.0; 2], PLACES) }
}

fn roles(team: &Team) -> [Role; 3] {
    team.duties().roles
}

const TREE: TeamKind = TeamKind::Tree;
const MACHINE: TeamKind = TeamKind::Machine;

use Role::{Assistant, Fullback, Goalkeeper, PenaltyDefender, PenaltyKicker, Striker, Wingback};

#[test]
fn machine_has_the_eight_states_and_the_edges_of_the_table() {
    assert_eq!(State::ALL.iter().filter(|state| state.is_input()).count(), 5);
    let rows = [
        "AttackTwoStrikers -> Attack: two_strikers_over / striker becomes assistant",
        "PenaltyKick -> Attack: kick_over / penalty_kicker becomes striker",
        "PenaltyDefense -> Defense: penalty_over / penalty_defender becomes goalkeeper",
        "Attack -> Defense: lost_ball / change group",
        "Attack -> SwapStrikerAssistant: swap_st_as / exchange striker and assistant",
        "Defense -> Attack: won_ball / change group",
        "Defense -> SwapFullbackWingback: swap_fb_wb / exchange fullback and wingback",
        "Defense -> SwapGoalkeeperWingback: swap_gk_wb / exchange goalkeeper and wingback",
        "SwapStrikerAssistant -> Attack: not swap_st_as / none",
        "SwapFullbackWingback -> Defense: not swap_fb_wb / none",
        "SwapGoalkeeperWingback -> Defense: not swap_gk_wb / none",
    ];
    let drawn = TRANSITIONS.map(|edge| {
        format!("{} -> {}: {} / {}", edge.from.name(), edge.to.name(), edge.guard.text(), edge.function.text())
    });
    assert_eq!(drawn.as_slice(), rows);
    // Every swap state is left by the negation of the condition that leads into it.
    for into in TRANSITIONS.iter().filter(|edge| !edge.to.is_input()) {
        let Guard::When(condition) = into.guard else { panic!("a swap state is entered by a condition") };
        let out = TRANSITIONS.iter().find(|edge| edge.from == into.to).expect("a way out");
        assert_eq!((out.guard, out.to), (Guard::Unless(condition), into.from));
    }
}

#[test]
fn both_coaches_end_the_special_modes_as_the_table_says() {
    for kind in [TREE, MACHINE] {
        // The free ball was pulled back to x = 0: the second Striker is no longer needed, the farther one becomes Assistant.
        let mut team = begin(kind, Restart::FreeBall, Whose::Ours, 1);
        assert_eq!(team.duties().formation, Formation::TwoStrikers);
        team.play(&ball_at(0.3, 1));
        assert_eq!(team.duties().formation, Formation::TwoStrikers, "{kind:?}: the mode lasts");
        team.play(&ball_at(0.2, 2));
        assert_eq!(roles(&team), [Goalkeeper, Striker, Assistant], "{kind:?}");

        let mut team = begin(kind, Restart::PenaltyKick, Whose::Ours, 0);
        assert_eq!(roles(&team), [Goalkeeper, PenaltyKicker, Assistant]);
        team.play(&ball_at(0.4, 1));
        assert_eq!(roles(&team)[1], PenaltyKicker, "{kind:?}: the mode lasts");
        team.play(&ball_at(0.6, 2));
        assert_eq!(roles(&team), [Goalkeeper, Striker, Assistant], "{kind:?}");

        let mut team = begin(kind, Restart::PenaltyKick, Whose::Theirs, 0);
        assert_eq!(roles(&team), [PenaltyDefender, Wingback, Fullback]);
        team.play(&ball_at(-0.4, 1));
        assert_eq!(roles(&team)[0], PenaltyDefender, "{kind:?}: the mode lasts");
        team.play(&ball_at(-0.2, 2));
        assert_eq!(roles(&team), [Goalkeeper, Wingback, Fullback], "{kind:?}");
        assert_eq!(team.take_events().len(), 1);
        assert_eq!(team.violations(), 0);
    }
}

#[test]
fn neither_coach_changes_the_group_or_swaps_while_a_special_mode_runs() {
    let modes = [
        (Restart::FreeBall, Whose::Ours, 1, Formation::TwoStrikers, 0.3),
        (Restart::PenaltyKick, Whose::Ours, 0, Formation::PenaltyKick, 0.38),
        (Restart::PenaltyKick, Whose::Theirs, 0, Formation::PenaltyDefense, -0.38),
    ];
    for kind in [TREE, MACHINE] {
        for (restart, taker, quadrant, formation, x) in modes {
            let mut team = begin(kind, restart, taker, quadrant);
            // The ball runs at 4 m/s to where the other group would play.
            let speed = if formation.mode() == Mode::Attack { -4.0 } else { 4.0 };
            let mut view = ball_at(x, 40);
            view.since = 5;
            view.ball.velocity = [speed, 0.0];
            team.play(&view);
            assert_eq!(team.duties().formation, formation, "{kind:?}");
            assert_eq!(team.take_events(), []);
        }
    }
}

#[test]
fn both_coaches_change_the_group_with_the_ball_and_wait_for_the_dwell() {
    for kind in [TREE, MACHINE] {
        let mut team = attacking(kind);
        team.play(&ball_at(-0.2, 100));
        assert_eq!(roles(&team), [Goalkeeper, Wingback, Fullback], "{kind:?}");
        assert_eq!(team.duties().mode, Mode::Defend);
        // Half a second is 30 frames.
        for frame in 101..130 {
            team.play(&ball_at(0.2, frame));
            assert_eq!(team.duties().mode, Mode::Defend, "{kind:?} {frame}");
        }
        team.play(&ball_at(0.2, 130));
        assert_eq!(roles(&team), [Goalkeeper, Striker, Assistant], "{kind:?}");
        let kinds: Vec<_> = team.take_events().into_iter().map(|event| (event.frame, event.kind)).collect();
        let wanted = [(100, EventKind::ChangeGroup(Mode::Defend)), (130, EventKind::ChangeGroup(Mode::Attack))];
        assert_eq!(kinds, wanted, "{kind:?}");
        assert_eq!(team.duties().swap_count, 0, "a change of group is no swap");
    }
}

#[test]
fn events_are_told_in_words() {
    let mut team = attacking(MACHINE);
    team.play(&striker_assistant(100));
    // The Assistant, robot 1, is off the ball's line: the swap is over.
    let apart = with([0.3, 0.0], [0.0; 2], [KEEPER, [-0.5, 0.4], [0.0, 0.0]]);
    team.play(&View { frame: 200, since: 200, ..apart });
    team.play(&ball_at(-0.3, 201));
    let mut view = ball_at(0.3, 202);
    view.call = call(Restart::PenaltyKick, Whose::Theirs, 0, 2);
    view.since = 0;
    team.called(&view);
    team.play(&View { frame: 300, since: 98, ..view });
    let told: Vec<String> = team.take_events().iter().map(|event| event.kind.to_string()).collect();
    let wanted = [
        "striker and assistant swap",
        "changes to the group defense",
        "call 2: starts as penalty_defense",
        "penalty_defender becomes goalkeeper",
    ];
    assert_eq!(told, wanted);
}

#[test]
fn both_coaches_swap_the_three_pairs() {
    for kind in [TREE, MACHINE] {
        let mut team = attacking(kind);
        team.play(&striker_assistant(100));
        assert_eq!(roles(&team), [Goalkeeper, Assistant, Striker], "{kind:?}");
        assert_eq!(team.duties().swap_last, Some(Pair::StrikerAssistant));
        assert_eq!((team.duties().swap_time, team.duties().swap_count), (100, 1));

        let mut team = defending(kind);
        team.play(&fullback_wingback(100));
        assert_eq!(roles(&team), [Goalkeeper, Fullback, Wingback], "{kind:?}");

        let mut team = defending(kind);
        team.play(&goalkeeper_wingback(100, 1));
        assert_eq!(roles(&team), [Wingback, Goalkeeper, Fullback], "{kind:?}");
        assert_eq!(team.violations(), 0);
    }
}

#[test]
fn coaches_without_swaps_only_change_the_group() {
    for kind in [TeamKind::TreeWithoutSwaps, TeamKind::MachineWithoutSwaps] {
        let mut team = attacking(kind);
        team.play(&striker_assistant(100));
        assert_eq!(roles(&team), [Goalkeeper, Striker, Assistant], "{kind:?}");
        team.play(&ball_at(-0.2, 101));
        assert_eq!(roles(&team), [Goalkeeper, Wingback, Fullback], "{kind:?}");
        team.play(&goalkeeper_wingback(102, 1));
        assert_eq!(team.duties().swap_count, 0, "{kind:?}");
    }
}

#[test]
fn lost_ball_comes_before_a_swap_in_both() {
    for kind in [TREE, MACHINE] {
        let mut view = striker_assistant(100);
        view.ball.velocity = [-1.0, 0.0];
        let mut team = attacking(kind);
        team.play(&view);
        assert_eq!((team.duties().mode, team.duties().swap_count), (Mode::Defend, 0), "{kind:?}");
    }
}

#[test]
fn machine_waits_in_a_swap_state_where_the_tree_changes_the_group_at_once() {
    let (mut tree, mut machine) = (defending(TREE), defending(MACHINE));
    for team in [&mut tree, &mut machine] {
        team.play(&fullback_wingback(100));
        assert_eq!(team.duties().swap_count, 1);
    }
    assert_eq!(machine.machine().map(Machine::state), Some(State::SwapFullbackWingback));

    // The ball is won in the next frame. Robot 1, now Fullback, is far from it, so the leave form is false from then on,
    // but the dwell is a quarter of a second.
    let won = |frame| View { frame, since: frame, ..with([0.3, 0.0], [0.0; 2], [KEEPER, [-0.5, 0.4], [0.0, 0.0]]) };
    for team in [&mut tree, &mut machine] {
        team.play(&won(101));
    }
    assert_eq!(tree.duties().mode, Mode::Attack);
    assert_eq!(machine.duties().mode, Mode::Defend);
    for frame in 102..115 {
        machine.play(&won(frame));
        assert_eq!(machine.machine().map(Machine::state), Some(State::SwapFullbackWingback), "{frame}");
    }
    machine.play(&won(115));
    assert_eq!(machine.machine().map(Machine::state), Some(State::Defense));
    machine.play(&won(116));
    assert_eq!(machine.machine().map(Machine::state), Some(State::Attack));
    assert_eq!(machine.machine().and_then(Machine::last), Some((5, 116)), "Defense -> Attack");
}

#[test]
fn machine_stays_in_a_swap_state_while_the_leave_form_holds() {
    let mut machine = defending(MACHINE);
    machine.play(&fullback_wingback(100));
    // The exchanged roles: robot 1 is Fullback, robot 2 Wingback. Nearer by 0.10 is between the two forms.
    let between =
        |frame| View { frame, since: frame, ..with([-0.2, 0.0], [0.0; 2], [KEEPER, [-0.3, 0.0], [0.0, 0.0]]) };
    for frame in 101..200 {
        machine.play(&between(frame));
        assert_eq!(machine.machine().map(Machine::state), Some(State::SwapFullbackWingback));
    }
    assert_eq!(machine.duties().swap_count, 1);
}

#[test]
fn another_swap_stays_possible_for_the_tree_but_not_for_the_machine() {
    for (kind, swaps) in [(TREE, 2), (MACHINE, 1)] {
        let mut team = defending(kind);
        team.play(&fullback_wingback(100));
        // Robot 2 is Wingback now.
        team.play(&goalkeeper_wingback(101, 2));
        assert_eq!(team.duties().swap_count, swaps, "{kind:?}");
    }
}

#[test]
fn tree_holds_a_pair_until_the_leave_form_was_false_and_the_dwell_is_over() {
    // After the swap robot 1 is Fullback; the same condition now asks for the swap back.
    let back = |frame| View { frame, since: frame, ..with([-0.2, 0.0], [0.0; 2], [KEEPER, [-0.3, 0.0], [0.1, 0.0]]) };
    let apart = |frame| View { frame, since: frame, ..with([-0.2, 0.0], [0.0; 2], [KEEPER, [-0.3, 0.2], [-0.1, 0.0]]) };
    let latch = |team: &Team| team.tree().expect("a tree").1.latches()[Pair::FullbackWingback as usize];
    let mut team = defending(TREE);
    team.play(&fullback_wingback(100));
    assert_eq!(latch(&team).swapped, Some(100));
    // The leave form never becomes false: no swap back, however long.
    for frame in 101..200 {
        team.play(&back(frame));
    }
    assert_eq!((team.duties().swap_count, latch(&team).released), (1, false));
    team.play(&apart(200));
    team.play(&back(201));
    assert_eq!((team.duties().swap_count, team.duties().swap_time), (2, 201));

    // Released at once, but the dwell of 15 frames is not over.
    let mut team = defending(TREE);
    team.play(&fullback_wingback(100));
    team.play(&apart(101));
    for frame in 102..115 {
        team.play(&back(frame));
        assert_eq!((team.duties().swap_count, latch(&team).released), (1, true), "{frame}");
    }
    team.play(&back(115));
    assert_eq!(team.duties().swap_count, 2);
}

#[test]
fn calls_stop_the_machine_and_open_the_latches() {
    for kind in [TREE, MACHINE] {
        let mut team = defending(kind);
        team.play(&fullback_wingback(100));
        let mut view = fullback_wingback(140);
        view.call = call(Restart::KickOff, Whose::Theirs, 0, 2);
        view.since = 0;
        team.called(&view);
        // Robot 2 is nearer to the ball, so it is Wingback; robot 1, far from it, is Fullback.
        assert_eq!(roles(&team), [Goalkeeper, Fullback, Wingback], "{kind:?}");
        assert_eq!(team.machine().map_or(State::Defense, Machine::state), State::Defense);
        assert!(team.tree().is_none_or(|(_, tree)| tree.latches().iter().all(|latch| latch.swapped.is_none())));
    }
}

#[test]
fn blackboard_shows_what_the_duties_say() {
    let mut team = defending(TREE);
    team.play(&fullback_wingback(100));
    team.play(&ball_at(0.3, 101));
    let memory = team.tree().expect("a tree").1.memory();
    let shown = |name: &str| memory.get(name).map(ToString::to_string).unwrap_or_default();
    let duties = team.duties();
    assert_eq!(shown("team_mode"), duties.mode.text());
    assert_eq!(shown("formation"), duties.formation.text());
    for (robot, role) in duties.roles.iter().enumerate() {
        assert_eq!(shown(&format!("role_{robot}")), role.text());
    }
    let names = ["ref_event", "ref_team", "ref_quadrant", "ref_seq", "swap_last", "swap_time", "swap_count"];
    let values = names.map(shown);
    assert_eq!(values, ["kick_off", "theirs", "0", "1", "fullback_wingback", "100", "1"]);
}
