//! Who plays what at a start.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{call, started, team, with};
use swarm_playground::soccer::team::coach::machine::State;
use swarm_playground::soccer::team::{EventKind, Formation, Mode, Role, TeamKind, start};
use swarm_playground::soccer::view::{Restart, Slot, View, Whose};

use Restart::{FreeBall, GoalKick, KickOff, PenaltyKick};
use Whose::{Ours, Theirs};

/// Section 8: the call, and what both coaches start with.
const CALLS: [(Restart, Whose, u8, Formation, State); 8] = [
    (KickOff, Ours, 0, Formation::StrikerAssistant, State::Attack),
    (GoalKick, Theirs, 0, Formation::StrikerAssistant, State::Attack),
    (FreeBall, Ours, 1, Formation::TwoStrikers, State::AttackTwoStrikers),
    (PenaltyKick, Ours, 0, Formation::PenaltyKick, State::PenaltyKick),
    (KickOff, Theirs, 0, Formation::FullbackWingback, State::Defense),
    (GoalKick, Ours, 0, Formation::FullbackWingback, State::Defense),
    (FreeBall, Theirs, 3, Formation::FullbackWingback, State::Defense),
    (PenaltyKick, Theirs, 0, Formation::PenaltyDefense, State::PenaltyDefense),
];

#[test]
fn both_coaches_start_as_the_table_says_after_every_call() {
    for (restart, taker, quadrant, formation, state) in CALLS {
        let name = format!("{restart:?} {taker:?}");
        let view = View {
            call: call(restart, taker, quadrant, 1),
            ..with([0.0; 2], [0.0; 2], [[-0.6, 0.0], [-0.1, 0.0], [-0.3, 0.3]])
        };
        let wanted = start::roles(formation);
        for kind in [TeamKind::Tree, TeamKind::Machine, TeamKind::TreeWithoutSwaps, TeamKind::MachineWithoutSwaps] {
            let mut team = started(kind, &view);
            let duties = team.duties();
            assert_eq!((duties.formation, duties.mode), (formation, formation.mode()), "{name} {kind:?}");
            // Robot 0 stands at the goal, 1 at the ball.
            assert_eq!(duties.roles, wanted, "{name} {kind:?}");
            assert_eq!(team.violations(), 0);
            let events: Vec<EventKind> = team.take_events().into_iter().map(|event| event.kind).collect();
            assert_eq!(events, [EventKind::Start { call: 1, formation }], "{name} {kind:?}");
            if let Some(machine) = team.machine() {
                assert_eq!(machine.state(), state, "{name}");
            }
        }
    }
}

#[test]
fn free_balls_in_both_quadrants_of_the_other_half_bring_two_strikers() {
    for (quadrant, taker, mode) in
        [(1, Ours, Mode::Attack), (4, Ours, Mode::Attack), (2, Theirs, Mode::Defend), (3, Theirs, Mode::Defend)]
    {
        let view = View {
            call: call(FreeBall, taker, quadrant, 1),
            ..with([0.0; 2], [0.0; 2], [[-0.6, 0.0], [-0.1, 0.0], [-0.3, 0.3]])
        };
        for kind in [TeamKind::Tree, TeamKind::Machine] {
            assert_eq!(started(kind, &view).duties().mode, mode, "{quadrant} {kind:?}");
        }
    }
}

#[test]
fn slots_are_given_out_at_the_least_cost_and_ties_go_by_number() {
    use Slot::{Attacker, Goalkeeper, Supporter};
    let rows = [
        // Robots at the goal, at the ball, and elsewhere, in all orders.
        ([[-0.7, 0.0], [0.1, 0.0], [-0.3, 0.4]], [Goalkeeper, Attacker, Supporter]),
        ([[0.1, 0.0], [-0.7, 0.0], [-0.3, 0.4]], [Attacker, Goalkeeper, Supporter]),
        ([[-0.3, 0.4], [0.1, 0.0], [-0.7, 0.0]], [Supporter, Attacker, Goalkeeper]),
        // Everybody at one place.
        ([[0.0, 0.3]; 3], [Goalkeeper, Attacker, Supporter]),
        // Robot 0 is nearest to both: as keeper it costs 0.7 * 0.25 + 0.3 * 0.9 = 0.445 with robot 1 at the ball; robot 1
        // as keeper and 0 at the ball 0.7 * 1.05 + 0.3 * 0.7 = 0.945.
        ([[-0.5, 0.0], [0.3, 0.7], [0.3, 0.9]], [Goalkeeper, Attacker, Supporter]),
    ];
    for (ours, wanted) in rows {
        assert_eq!(start::slots(&with([0.2, 0.0], [0.0; 2], ours)), wanted, "{ours:?}");
    }
}

#[test]
fn lineup_has_each_slot_once_and_puts_only_the_penalty_kicker_and_keepers_in_places_of_their_own() {
    for (restart, taker, quadrant, ..) in CALLS {
        for kind in TeamKind::ALL {
            let view = View {
                call: call(restart, taker, quadrant, 1),
                ..with([0.1, 0.2], [0.0; 2], [[-0.2, 0.1], [0.5, 0.0], [-0.5, 0.3]])
            };
            let mut team = team(kind);
            let lineup = team.called(&view);
            for slot in [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter] {
                assert_eq!(lineup.slots.iter().filter(|other| **other == slot).count(), 1, "{kind:?} {restart:?}");
            }
            for (role, (slot, spot)) in team.duties().roles.iter().zip(lineup.slots.iter().zip(lineup.spots)) {
                assert_eq!(role.keeps_goal(), *slot == Slot::Goalkeeper);
                // The table has the goalkeeper of a goal kick look at the ball.
                let kicks = *role == Role::Goalkeeper && (restart, taker) == (GoalKick, Ours);
                assert_eq!(spot.is_some(), *role == Role::PenaltyKicker || (role.keeps_goal() && !kicks));
            }
        }
    }
}

#[test]
fn penalty_kicker_stands_on_either_side_and_aims_through_the_ball() {
    let view = |number| View {
        call: call(PenaltyKick, Ours, 0, number),
        ..with([0.375, 0.0], [0.0; 2], [[-0.6, 0.0], [0.2, 0.0], [-0.3, 0.3]])
    };
    let mut team = team(TeamKind::Machine);
    let mut sides = [0, 0];
    for number in 1..=40 {
        let spot = team.called(&view(number)).spots[1].expect("the kicker's place");
        assert!((spot.at[0] - 0.285).abs() < 1e-12 && (spot.at[1].abs() - 0.0225).abs() < 1e-12);
        sides[usize::from(spot.at[1] < 0.0)] += 1;
        // The line passes the ball's centre at less than its radius, 0.0215.
        let beside = spot.at[1] + libm::tan(spot.heading) * 0.09;
        assert!(beside.abs() < 0.0215, "{beside}");
        // And meets the goal 0.144 from its middle, on the other side.
        let goal = spot.at[1] + libm::tan(spot.heading) * 0.465;
        assert!((goal + spot.at[1].signum() * 0.144).abs() < 1e-9, "{goal}");
    }
    assert!(sides[0] > 8 && sides[1] > 8, "{sides:?}");
}
