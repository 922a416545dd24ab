//! The conditions, row by row: just inside, just outside, and the leave form.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{at, view, with};
use swarm_playground::soccer::team::conditions::{Condition, Form, Scene};
use swarm_playground::soccer::team::{Margins, Role};
use swarm_playground::soccer::view::View;

use Condition::{
    KickOver, LostBall, PenaltyOver, SwapFullbackWingback, SwapGoalkeeperWingback, SwapStrikerAssistant,
    TwoStrikersOver, WonBall,
};

const ATTACK: [Role; 3] = [Role::Goalkeeper, Role::Striker, Role::Assistant];
const DEFENSE: [Role; 3] = [Role::Goalkeeper, Role::Fullback, Role::Wingback];

fn roles_of(condition: Condition) -> [Role; 3] {
    match condition {
        SwapFullbackWingback | SwapGoalkeeperWingback | WonBall | PenaltyOver => DEFENSE,
        SwapStrikerAssistant | LostBall | TwoStrikersOver | KickOver => ATTACK,
    }
}

fn scene<'a>(condition: Condition, view: &'a View, margins: &'a Margins) -> Scene<'a> {
    Scene { view, roles: roles_of(condition), margins, group_changed: None }
}

/// Enter form and leave form.
fn forms(condition: Condition, view: &View) -> (bool, bool) {
    let margins = Margins::default();
    let scene = scene(condition, view, &margins);
    (scene.holds(condition, Form::Enter), scene.holds(condition, Form::Leave))
}

/// What a row has to give: both forms, the leave form only, or neither.
const BOTH: (bool, bool) = (true, true);
const LEAVE: (bool, bool) = (false, true);
const NEITHER: (bool, bool) = (false, false);

const KEEPER: [f64; 2] = [-0.69, 0.0];

#[test]
fn striker_and_assistant_swap_in_the_four_cases_of_the_table() {
    // s = 0.075: s/2 = 0.0375, halved 0.01875; 1.5 s = 0.1125.
    let rows = [
        // (a) Assistant behind the ball, ahead of the Striker, on the ball's line.
        ("a", [0.0, 0.0], [-0.15, 0.3], [-0.10, 0.07], BOTH),
        ("a, ahead of the Striker by less than s/2", [0.0, 0.0], [-0.13, 0.3], [-0.10, 0.07], LEAVE),
        ("a, ahead of the Striker by less than s/4", [0.0, 0.0], [-0.11, 0.3], [-0.10, 0.07], NEITHER),
        ("a, beside the ball by more than s", [0.0, 0.0], [-0.15, 0.3], [-0.10, 0.08], LEAVE),
        ("a, beside the ball by more than 1.5 s", [0.0, 0.0], [-0.15, 0.3], [-0.10, 0.12], NEITHER),
        ("a, behind the ball by less than s/2", [0.0, 0.0], [-0.15, 0.3], [-0.03, 0.0], LEAVE),
        // (b) the Striker has run past the ball.
        ("b", [0.3, 0.0], [0.35, 0.0], [0.25, 0.0], BOTH),
        ("b, ball in the own half", [-0.01, 0.0], [0.04, 0.0], [-0.06, 0.0], NEITHER),
        ("b, ball deep in the other half", [0.58, 0.3], [0.63, 0.3], [0.53, 0.3], LEAVE),
        ("b, Striker hardly past the ball", [0.3, 0.3], [0.32, 0.3], [0.25, 0.3], LEAVE),
        // (c) the Striker is wide, the Assistant central.
        ("c", [0.25, 0.1], [0.30, 0.40], [0.15, 0.1], BOTH),
        ("c, Striker not so wide", [0.25, 0.1], [0.26, 0.30], [0.15, 0.1], LEAVE),
        ("c, Striker central", [0.25, 0.1], [0.25, 0.15], [0.24, 0.1], NEITHER),
        ("c, ball at the halfway line", [0.15, 0.1], [0.16, 0.40], [0.14, 0.1], LEAVE),
        ("c, ball wide", [0.25, 0.31], [0.26, 0.40], [0.24, 0.31], NEITHER),
        // (d) both past the ball, the Assistant nearer to it.
        ("d", [-0.2, 0.0], [0.0, 0.5], [-0.1, -0.5], BOTH),
        ("d, Striker nearer", [-0.2, 0.0], [-0.1, 0.5], [0.0, -0.5], NEITHER),
        ("d, Assistant hardly past the ball", [-0.2, 0.0], [0.0, 0.5], [-0.17, -0.5], LEAVE),
    ];
    for (name, ball, striker, assistant, wanted) in rows {
        assert_eq!(forms(SwapStrikerAssistant, &with(ball, [0.0; 2], [KEEPER, striker, assistant])), wanted, "{name}");
    }
}

#[test]
fn fullback_and_wingback_swap_when_the_fullback_is_nearer_and_goal_side() {
    let rows = [
        ("nearer by 0.20", [-0.30, 0.0], [-0.40, 0.0], [0.0, 0.0], BOTH),
        ("nearer by 0.10", [-0.30, 0.0], [-0.40, 0.0], [-0.10, 0.0], LEAVE),
        ("nearer by 0.05", [-0.30, 0.0], [-0.40, 0.0], [-0.15, 0.0], NEITHER),
        ("hardly goal side", [-0.30, 0.0], [-0.33, 0.0], [0.0, 0.0], LEAVE),
        ("not goal side", [-0.30, 0.0], [-0.29, 0.0], [0.0, 0.0], NEITHER),
    ];
    for (name, ball, fullback, wingback, wanted) in rows {
        assert_eq!(forms(SwapFullbackWingback, &with(ball, [0.0; 2], [KEEPER, fullback, wingback])), wanted, "{name}");
    }
}

#[test]
fn goalkeeper_and_wingback_swap_when_the_keeper_was_pulled_out() {
    let (out, near, far) = ([-0.65, 0.30], [-0.70, 0.05], [-0.52, -0.30]);
    let rows = [
        ("pulled out to the side", [-0.65, 0.40], out, near, BOTH),
        ("pulled out to the front", [-0.65, 0.40], [-0.55, 0.10], near, BOTH),
        // Within 0.90 of the halfway line everybody is "out": the leave form looks at the other parts only.
        ("in the goal", [-0.65, 0.40], [-0.62, 0.19], near, LEAVE),
        ("ball not deep", [-0.55, 0.40], out, near, LEAVE),
        ("ball in front of the goal", [-0.65, 0.10], out, near, NEITHER),
        ("ball less beside it", [-0.65, 0.20], out, near, LEAVE),
        ("Wingback no nearer", [-0.65, 0.40], out, far, NEITHER),
        // Keeper at 0.3162, Wingback at 0.26: nearer by 0.056, between s/2 and s.
        ("Wingback a little nearer", [-0.65, 0.40], out, [-0.75, 0.26], LEAVE),
    ];
    for (name, ball, keeper, wingback, wanted) in rows {
        let ours = [keeper, [-0.5, 0.2], wingback];
        assert_eq!(forms(SwapGoalkeeperWingback, &with(ball, [0.0; 2], ours)), wanted, "{name}");
    }
}

#[test]
fn ball_is_lost_and_won_at_the_halfway_line_or_by_the_nearer_team() {
    // x, speed, our nearest and their nearest robot's distance to the ball.
    let rows = [
        (LostBall, -0.13, 0.0, 0.3, 0.3, BOTH),
        (LostBall, -0.10, 0.0, 0.3, 0.3, LEAVE),
        (LostBall, -0.05, 0.0, 0.3, 0.3, NEITHER),
        // 0.25 s ahead: -0.13.
        (LostBall, 0.0, -0.52, 0.3, 0.3, BOTH),
        (LostBall, 0.09, 0.0, 0.3, 0.21, BOTH),
        (LostBall, 0.09, 0.0, 0.3, 0.23, LEAVE),
        (LostBall, 0.09, 0.0, 0.3, 0.27, NEITHER),
        (LostBall, 0.11, 0.0, 0.3, 0.21, LEAVE),
        (LostBall, 0.16, 0.0, 0.3, 0.1, NEITHER),
        (WonBall, 0.13, 0.0, 0.3, 0.3, BOTH),
        (WonBall, 0.10, 0.0, 0.3, 0.3, LEAVE),
        (WonBall, 0.05, 0.0, 0.3, 0.3, NEITHER),
        (WonBall, 0.0, 0.52, 0.3, 0.3, BOTH),
        (WonBall, -0.09, 0.0, 0.21, 0.3, BOTH),
        (WonBall, -0.09, 0.0, 0.23, 0.3, LEAVE),
        (WonBall, -0.11, 0.0, 0.21, 0.3, LEAVE),
        (WonBall, -0.16, 0.0, 0.1, 0.3, NEITHER),
    ];
    for (condition, x, speed, ours, theirs, wanted) in rows {
        let far = [-0.75, 0.6];
        let mut view = with([x, 0.0], [speed, 0.0], [far, [x, ours], far]);
        view.theirs = [at(x, -theirs), at(0.75, 0.6), at(0.75, -0.6)];
        assert_eq!(forms(condition, &view), wanted, "{} at {x}, {speed}, {ours}, {theirs}", condition.id());
    }
}

#[test]
fn special_modes_end_by_place_or_time() {
    let at = |x: f64, y: f64, speed: f64, since: u32| View { since, ..with([x, y], [speed, 0.0], [KEEPER; 3]) };
    let rows = [
        (TwoStrikersOver, at(0.24, 0.0, 0.0, 0), BOTH),
        (TwoStrikersOver, at(0.30, 0.0, 0.0, 0), LEAVE),
        (TwoStrikersOver, at(0.40, 0.0, 0.0, 0), NEITHER),
        (TwoStrikersOver, at(0.40, 0.0, 0.0, 180), BOTH),
        (TwoStrikersOver, at(0.40, 0.0, 0.0, 100), LEAVE),
        (KickOver, at(0.375, 0.151, 0.0, 0), BOTH),
        (KickOver, at(0.375, 0.10, 0.0, 0), LEAVE),
        (KickOver, at(0.375, 0.05, 0.0, 0), NEITHER),
        (KickOver, at(0.375, 0.0, 0.0, 90), BOTH),
        (KickOver, at(0.375, 0.0, 0.0, 89), LEAVE),
        // On the way to the goal it goes on, rolling back or out of the strip before the goal it is over.
        (PenaltyOver, at(-0.50, 0.0, -1.0, 10), NEITHER),
        (PenaltyOver, at(-0.50, 0.0, 0.1, 10), BOTH),
        (PenaltyOver, at(-0.45, 0.0, 0.1, 10), LEAVE),
        (PenaltyOver, at(-0.50, 0.36, -1.0, 10), BOTH),
        (PenaltyOver, at(-0.27, 0.0, -1.0, 10), BOTH),
        (PenaltyOver, at(-0.375, 0.0, 0.0, 90), BOTH),
    ];
    for (condition, view, wanted) in rows {
        let [x, y] = view.ball.at;
        assert_eq!(forms(condition, &view), wanted, "{} at {x}, {y}, {}", condition.id(), view.since);
    }
}

#[test]
fn locks_hold_swaps_after_a_placement_and_groups_after_a_change() {
    let margins = Margins::default();
    let mut view = with([0.0, 0.0], [0.0; 2], [KEEPER, [-0.15, 0.3], [-0.10, 0.0]]);
    for (since, wanted) in [(0, false), (29, false), (30, true)] {
        view.since = since;
        assert_eq!(scene(SwapStrikerAssistant, &view, &margins).enters(SwapStrikerAssistant), wanted, "{since}");
    }
    let view = with([-0.3, 0.0], [0.0; 2], [KEEPER; 3]);
    for (changed, wanted) in [(None, true), (Some(600), false), (Some(571), false), (Some(570), true)] {
        let scene = Scene { group_changed: changed, ..scene(LostBall, &view, &margins) };
        assert_eq!(scene.enters(LostBall), wanted, "{changed:?}");
    }
}

#[test]
fn conditions_about_roles_that_nobody_plays_do_not_hold() {
    let (view, margins) = (view(), Margins::default());
    for condition in [SwapStrikerAssistant, SwapFullbackWingback, SwapGoalkeeperWingback] {
        let roles = if roles_of(condition) == ATTACK { DEFENSE } else { ATTACK };
        let scene = Scene { roles, ..scene(condition, &view, &margins) };
        assert!(!scene.holds(condition, Form::Enter) && !scene.holds(condition, Form::Leave), "{}", condition.id());
    }
}

#[test]
fn doubled_margins_ask_for_twice_the_difference_but_keep_places() {
    let margins = Margins::default().doubled();
    let holds = |condition, view: &View| scene(condition, view, &margins).holds(condition, Form::Enter);
    // Nearer by 0.20 is enough in the table, 0.31 here.
    assert!(!holds(SwapFullbackWingback, &with([-0.3, 0.0], [0.0; 2], [KEEPER, [-0.4, 0.0], [0.0, 0.0]])));
    assert!(holds(SwapFullbackWingback, &with([-0.3, 0.0], [0.0; 2], [KEEPER, [-0.4, 0.0], [0.12, 0.0]])));
    // "Within s of the ball's line" becomes within s/2.
    assert!(!holds(SwapStrikerAssistant, &with([0.0; 2], [0.0; 2], [KEEPER, [-0.3, 0.3], [-0.10, 0.05]])));
    assert!(holds(SwapStrikerAssistant, &with([0.0; 2], [0.0; 2], [KEEPER, [-0.3, 0.3], [-0.10, 0.03]])));
    // Deeper than 0.60 stays deeper than 0.60.
    assert!(holds(SwapGoalkeeperWingback, &with([-0.61, 0.3], [0.0; 2], [[-0.65, 0.4], [-0.5, 0.2], [-0.75, 0.1]])));
}

#[test]
fn margins_out_of_range_are_refused_by_name() {
    let fault = |margins: Margins| margins.check().unwrap_err().to_string();
    let margins = Margins::default();
    assert_eq!(margins.check(), Ok(()));
    assert_eq!(fault(Margins { enter: 0.0, ..margins }), "margins.enter: expected 0.1 to 10, found 0");
    assert_eq!(fault(Margins { leave_more: 1.5, ..margins }), "margins.leave_more: expected 0 to 1, found 1.5");
    assert_eq!(fault(Margins { leave_less: 0.5, ..margins }), "margins.leave_less: expected 1 to 10, found 0.5");
    assert_eq!(fault(Margins { swap_dwell: -1.0, ..margins }), "margins.swap_dwell: expected 0 to 60, found -1");
    assert_eq!(fault(Margins { lock_out: f64::NAN, ..margins }), "margins.lock_out: expected 0 to 60, found NaN");
}
