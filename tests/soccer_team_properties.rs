//! Laws of the teams over random views.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use swarm_playground::random::{Purpose, Seed, stream};
use swarm_playground::soccer::team::conditions::{Condition, Form, Scene};
use swarm_playground::soccer::team::organisation::{Checker, Member};
use swarm_playground::soccer::team::{Duties, EventKind, Margins, Role, Team, TeamKind};
use swarm_playground::soccer::view::{Ball, Call, Lineup, Pose, Restart, Slot, View, Whose};

fn place() -> impl Strategy<Value = [f64; 2]> {
    (-0.75..0.75, -0.65..0.65).prop_map(|(x, y)| [x, y])
}

fn pose() -> impl Strategy<Value = Pose> {
    (place(), -3.1..3.1, -30.0..30.0).prop_map(|(at, heading, spin)| Pose { at, heading, spin, velocity: [0.0; 2] })
}

fn call() -> impl Strategy<Value = (Restart, Whose)> {
    let restart = prop_oneof![
        Just(Restart::KickOff),
        Just(Restart::FreeBall),
        Just(Restart::GoalKick),
        Just(Restart::PenaltyKick)
    ];
    (restart, prop_oneof![Just(Whose::Ours), Just(Whose::Theirs)])
}

/// A view, how many frames pass before it, and a call that may come with it.
#[derive(Clone, Debug)]
struct Moment {
    view: View,
    passes: u32,
    call: Option<(Restart, Whose)>,
}

fn moment() -> impl Strategy<Value = Moment> {
    let ball = (place(), -1.5..1.5, -1.5..1.5).prop_map(|(at, x, y)| Ball { at, velocity: [x, y] });
    let poses = (prop::array::uniform3(pose()), prop::array::uniform3(pose()));
    (ball, poses, 1..40_u32, prop::option::weighted(0.1, call())).prop_map(|(ball, (ours, theirs), passes, call)| {
        let none = Call { restart: Restart::KickOff, taker: Whose::Ours, quadrant: 0, number: 0 };
        Moment { view: View { frame: 0, since: 0, call: none, ball, ours, theirs }, passes, call }
    })
}

/// The views of a whole game in which everything jumps about; calls come after the first view as they are drawn.
fn views(moments: &[Moment]) -> Vec<View> {
    let mut views = Vec::new();
    let mut call = Call { restart: Restart::KickOff, taker: Whose::Ours, quadrant: 0, number: 1 };
    let (mut frame, mut since) = (0, 0);
    for moment in moments {
        (frame, since) = (frame + moment.passes, since + moment.passes);
        if let Some((restart, taker)) = moment.call {
            let quadrant = match (restart, taker) {
                (Restart::FreeBall, Whose::Ours) => 4,
                (Restart::FreeBall, Whose::Theirs) => 2,
                _ => 0,
            };
            call = Call { restart, taker, quadrant, number: call.number + 1 };
            since = 0;
        }
        views.push(View { frame, since, call, ..moment.view });
    }
    views
}

fn team(kind: TeamKind) -> Team {
    let penalties = stream(Seed::new(3).expect("below 2^53"), Purpose::Jitter, 0);
    Team::new(kind, Margins::default(), None, None, penalties).expect("a built-in team")
}

/// Each slot once, and the goalkeeper's for whoever keeps the goal.
fn fits(lineup: &Lineup, duties: &Duties) -> bool {
    let once = |slot| lineup.slots.iter().filter(|other| **other == slot).count() == 1;
    let keeper = duties.roles.iter().position(|role| role.keeps_goal());
    [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter].into_iter().all(once)
        && keeper.is_some_and(|keeper| lineup.slots[keeper] == Slot::Goalkeeper)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_game_makes_a_built_in_coach_break_the_organisation(moments in prop::collection::vec(moment(), 1..120)) {
        let checker = Checker::built_in();
        for kind in TeamKind::ALL {
            let mut team = team(kind);
            for view in views(&moments) {
                let before = *team.duties();
                let called = view.since == 0;
                if called {
                    let lineup = team.called(&view);
                    prop_assert!(fits(&lineup, team.duties()), "{kind:?} {lineup:?}");
                }
                let started = *team.duties();
                for wheels in team.play(&view) {
                    prop_assert!(wheels.left.abs() <= 46.0 + 1e-9 && wheels.right.abs() <= 46.0 + 1e-9);
                }
                let after = *team.duties();
                prop_assert_eq!(checker.look(&after), Ok(()));
                let roles = if called { started.roles } else { before.roles };
                // The first view is answered without a call of its own: that is a start too.
                if !team.take_events().iter().any(|event| matches!(event.kind, EventKind::Start { .. })) {
                    prop_assert!(checker.change(Member::Coach, roles, after.roles).is_ok(), "{:?} {:?}", roles, after.roles);
                }
                prop_assert_eq!(team.violations(), 0);
                prop_assert!(team.fault().is_none());
            }
        }
    }

    #[test]
    fn leave_form_holds_wherever_the_enter_form_does(moment in moment(), order in 0..6_usize, since in 0..400_u32) {
        let view = View { since, frame: since, ..moment.view };
        let margins = Margins::default();
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        for group in [[Role::Goalkeeper, Role::Striker, Role::Assistant], [Role::Goalkeeper, Role::Fullback, Role::Wingback]] {
            let scene = Scene { view: &view, roles: orders[order].map(|index: usize| group[index]), margins: &margins, group_changed: None };
            for condition in Condition::ALL {
                prop_assert!(!scene.holds(condition, Form::Enter) || scene.holds(condition, Form::Leave), "{}", condition.id());
            }
        }
    }

    #[test]
    fn roles_do_not_flutter(moments in prop::collection::vec(moment(), 1..120)) {
        // However the views jump: between two swaps of one pair, and two changes of group, lie the dwells.
        for kind in [TeamKind::Tree, TeamKind::Machine] {
            let mut team = team(kind);
            let (mut swapped, mut changed) = ([None; 3], None);
            for view in views(&moments) {
                team.play(&view);
                for event in team.take_events() {
                    match event.kind {
                        EventKind::Start { .. } => (swapped, changed) = ([None; 3], None),
                        EventKind::Swap(pair) => {
                            let last: Option<u32> = swapped[pair as usize].replace(event.frame);
                            prop_assert!(last.is_none_or(|last| event.frame - last >= 15), "{kind:?} {pair:?}");
                        }
                        EventKind::ChangeGroup(_) => {
                            let last: Option<u32> = changed.replace(event.frame);
                            prop_assert!(last.is_none_or(|last| event.frame - last >= 30), "{kind:?}");
                        }
                        EventKind::Become { .. } | EventKind::Written(_) | EventKind::Refused(_) | EventKind::Fault(_) => {}
                    }
                }
            }
        }
    }
}
