//! A team as a match has it: copies, fingerprints, events, what goes wrong, and what somebody sees of it.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::stage::{at, call, penalties, started, team, view, with};
use swarm_playground::bt::Status;
use swarm_playground::fingerprint::Fingerprint;
use swarm_playground::soccer::team::coach;
use swarm_playground::soccer::team::{EventKind, Margins, Role, Statuses, Team, TeamKind, Watch};
use swarm_playground::soccer::view::{Restart, View, Wheels, Whose};

fn fingerprint(team: &Team) -> u64 {
    let mut hash = Fingerprint::default();
    team.feed(&mut hash);
    hash.finish()
}

/// The ball on a tour of the pitch, opponents and ours following it by a simple rule: no physics, only variety.
fn tour(frame: u32) -> View {
    let t = f64::from(frame) / 60.0;
    let ball = [0.7 * libm::sin(0.9 * t), 0.6 * libm::sin(1.7 * t + 1.0)];
    let place = |k: f64| [ball[0] * 0.6 + 0.3 * libm::sin(2.3 * t + k), ball[1] * 0.6 + 0.3 * libm::cos(1.9 * t + k)];
    let mut view =
        with(ball, [0.63 * libm::cos(0.9 * t), libm::cos(1.7 * t + 1.0)], [[-0.69, 0.1], place(0.0), place(2.0)]);
    view.theirs = [at(0.69, 0.0), at(place(4.0)[0], place(4.0)[1]), at(0.2, -0.3)];
    for (robot, pose) in view.ours.iter_mut().enumerate() {
        pose.heading = libm::sin(t + robot as f64);
    }
    let number = 1 + frame / 300;
    let restart = [Restart::KickOff, Restart::FreeBall, Restart::PenaltyKick, Restart::GoalKick][number as usize % 4];
    let taker = if number.is_multiple_of(3) { Whose::Ours } else { Whose::Theirs };
    let quadrant = if restart == Restart::FreeBall { if taker == Whose::Ours { 1 } else { 2 } } else { 0 };
    View { frame, since: frame % 300, call: call(restart, taker, quadrant, number), ..view }
}

fn tell(team: &mut Team, frames: std::ops::Range<u32>) -> Vec<[Wheels; 3]> {
    frames.map(|frame| team.play(&tour(frame))).collect()
}

#[test]
fn copies_go_on_alike_and_fingerprints_tell_teams_apart() {
    let mut seen = Vec::new();
    for kind in TeamKind::ALL {
        let mut first = team(kind);
        tell(&mut first, 0..700);
        let mut copy = first.clone();
        assert_eq!(fingerprint(&copy), fingerprint(&first));
        assert_eq!(tell(&mut copy, 700..1300), tell(&mut first, 700..1300), "{kind:?}");
        assert_eq!(fingerprint(&copy), fingerprint(&first));
        assert_ne!(fingerprint(&first), fingerprint(&started(kind, &tour(0))));
        assert_eq!(first.violations(), 0, "{kind:?}");
        seen.push(fingerprint(&first));
    }
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), TeamKind::ALL.len());
}

#[test]
fn teams_give_the_same_bits_everywhere() {
    // Wheel speeds and state over 1200 frames; equal natively and in WebAssembly.
    let found = TeamKind::ALL.map(|kind| {
        let mut team = team(kind);
        let mut hash = Fingerprint::default();
        for wheels in tell(&mut team, 0..1200).into_iter().flatten() {
            hash.f64(wheels.left);
            hash.f64(wheels.right);
        }
        team.feed(&mut hash);
        format!("{:016x}", hash.finish())
    });
    assert_eq!(found, GOLDEN);
}

const GOLDEN: [&str; 7] = [
    "09da0116d1423482",
    "d9396eee32cb36e4",
    "1f90e193a2d3fe4e",
    "878a3fada32e492b",
    "17627901a6a3d578",
    "430672bd36fa237e",
    "2b9beba876635f72",
];

#[test]
fn names_of_teams_are_read_back() {
    for kind in TeamKind::ALL {
        assert_eq!(TeamKind::from_text(kind.text()), Some(kind));
        assert_eq!(serde_json::to_string(&kind).unwrap(), format!("{:?}", kind.text()));
    }
}

#[test]
fn views_that_are_no_numbers_neither_panic_nor_reach_the_motors() {
    for kind in TeamKind::ALL {
        let mut team = started(kind, &tour(0));
        for frame in 1..400 {
            let mut view = tour(frame);
            let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300][frame as usize % 4];
            match frame % 5 {
                0 => view.ball.at[0] = bad,
                1 => view.ball.velocity[0] = bad,
                2 => view.ours[frame as usize % 3].at = [bad; 2],
                3 => view.theirs[1].at[1] = bad,
                _ => (view.ours[1].heading, view.ours[1].spin) = (bad, bad),
            }
            for wheels in team.play(&view) {
                assert!(wheels.left.abs() <= 46.001 && wheels.right.abs() <= 46.001, "{kind:?} {frame} {wheels:?}");
            }
        }
    }
}

#[test]
fn watching_records_both_kinds_of_tree_and_changes_nothing() {
    let (mut watched, mut alone) = (started(TeamKind::Tree, &tour(0)), started(TeamKind::Tree, &tour(0)));
    let mut watch = Watch::<Statuses>::default();
    for frame in 1..200 {
        watch.clear();
        assert_eq!(watched.play_watched(&tour(frame), &mut watch), alone.play(&tour(frame)));
    }
    assert_eq!(watch.coach.list()[0], Status::Success, "the coach's root");
    assert_eq!(watch.coach.list()[2], Status::Failure, "no call is pending");
    for statuses in &watch.roles {
        assert_eq!(statuses.list()[0], Status::Running, "a role goes on");
    }
    assert_eq!(fingerprint(&watched), fingerprint(&alone));
}

#[test]
fn first_striker_changes_only_with_a_clear_advantage() {
    let free = |ours| View {
        call: call(Restart::FreeBall, Whose::Ours, 1, 1),
        since: 10,
        ..with([0.375, 0.4], [0.0; 2], ours)
    };
    let mut team = started(TeamKind::Machine, &free([[-0.7, 0.0], [0.2, 0.4], [0.0, 0.2]]));
    assert_eq!(team.first_striker(), Some(1));
    // Robot 2 is nearer by 0.175: not enough.
    team.play(&free([[-0.7, 0.0], [0.1, 0.4], [0.275, 0.4]]));
    assert_eq!(team.first_striker(), Some(1));
    team.play(&free([[-0.7, 0.0], [0.05, 0.4], [0.275, 0.4]]));
    assert_eq!(team.first_striker(), Some(2));
}

fn with_coach(xml: &str) -> Team {
    Team::new(TeamKind::Tree, Margins::default(), Some(xml), None, penalties())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn kinds(team: &mut Team) -> Vec<EventKind> {
    team.take_events().into_iter().map(|event| event.kind).collect()
}

#[test]
fn coach_trees_that_break_the_organisation_at_run_time_are_undone_and_counted() {
    let rows = [
        ("team_mode := 'dance'", "expected team_mode 'attack' with the formation striker_assistant, found 'dance'"),
        ("role_1 := 'wizard'", "robot 1: expected a role, found 'wizard'"),
        (
            "role_0 := 'striker'",
            "expected a formation of the organisation, found striker, striker, assistant: nobody keeps the goal",
        ),
        (
            "formation := 'two_strikers'",
            "expected formation 'striker_assistant', which is what the roles are, found 'two_strikers'",
        ),
        (
            "role_0 := 'assistant'; role_2 := 'goalkeeper'",
            "robot 0: no compatibility within a group leads from goalkeeper to assistant",
        ),
    ];
    let start = View { ..with([0.0; 2], [0.0; 2], [[-0.69, 0.0], [-0.1, 0.0], [-0.4, 0.4]]) };
    for (script, text) in rows {
        // The script stands where nothing else is to be done.
        let xml = coach::BUILT_IN.replacen("<AlwaysSuccess/>", &format!("<Script code=\"{script}\"/>"), 1);
        let mut team = with_coach(&xml);
        team.called(&start);
        kinds(&mut team);
        for frame in 601..604 {
            assert_ne!(team.play(&View { frame, ..start }), [Wheels::default(); 3], "{script}: the team plays on");
        }
        assert_eq!(team.duties().roles, [Role::Goalkeeper, Role::Striker, Role::Assistant], "{script}");
        assert_eq!(team.violations(), 3, "{script}");
        let events = kinds(&mut team);
        let [EventKind::Refused(violation)] = events.as_slice() else { panic!("{script}: noted once, {events:?}") };
        assert_eq!(violation.to_string(), text);
        let board = team.tree().expect("a tree").1.memory().get("role_0").map(ToString::to_string);
        assert_eq!(board.as_deref(), Some("goalkeeper"), "{script}: the board is put right");
    }
}

#[test]
fn scripts_may_change_roles_along_the_links() {
    let xml = coach::BUILT_IN.replacen(
        "<AlwaysSuccess/>",
        "<Script code=\"role_1 := 'assistant'; role_2 := 'striker'\"/>",
        1,
    );
    let start = with([0.0; 2], [0.0; 2], [[-0.69, 0.0], [-0.1, 0.0], [-0.4, 0.4]]);
    let mut team = with_coach(&xml);
    team.called(&start);
    team.play(&start);
    assert_eq!(team.duties().roles, [Role::Goalkeeper, Role::Assistant, Role::Striker]);
    assert_eq!(team.violations(), 0);
    let told = kinds(&mut team).last().map(ToString::to_string);
    assert_eq!(told.as_deref(), Some("writes the roles goalkeeper, assistant, striker"));
}

#[test]
fn errors_of_a_tick_stop_the_motors_until_the_next_call() {
    let xml = coach::BUILT_IN.replacen("<AlwaysSuccess/>", "<Script code=\"x = 1\"/>", 1);
    let start = with([0.0; 2], [0.0; 2], [[-0.69, 0.0], [-0.1, 0.0], [-0.4, 0.4]]);
    let mut team = with_coach(&xml);
    team.called(&start);
    kinds(&mut team);
    assert_eq!(team.play(&start), [Wheels::default(); 3]);
    assert_eq!(team.play(&start), [Wheels::default(); 3]);
    let text = team.fault().map(ToString::to_string).unwrap_or_default();
    assert!(
        text.ends_with("(Script): expected an existing entry for =, found none named \"x\"; := creates one"),
        "{text}"
    );
    assert_eq!(kinds(&mut team), [EventKind::Fault(text)]);
    // A defence has no such script: after the next call the team plays on.
    let next = View { call: call(Restart::KickOff, Whose::Theirs, 0, 2), ..start };
    team.called(&next);
    assert_ne!(team.play(&next), [Wheels::default(); 3]);

    let roles = swarm_playground::soccer::team::roles::BUILT_IN.replacen("<Rebound ", "<Rebound _post=\"y = 1\" ", 1);
    assert!(Team::new(TeamKind::Machine, Margins::default(), None, Some(&roles), penalties()).is_ok());
}

#[test]
fn coach_that_never_consumes_the_call_starts_only_once() {
    let xml = coach::BUILT_IN.replacen("<ConsumeEvent/>", "<AlwaysSuccess/>", 1);
    let mut team = with_coach(&xml);
    let start = with([0.0; 2], [0.0; 2], [[-0.69, 0.0], [-0.1, 0.0], [-0.4, 0.4]]);
    team.called(&start);
    for frame in 601..700 {
        team.play(&View { frame, ..start });
    }
    assert_eq!(kinds(&mut team).len(), 1);
    // A robot that is now nearer would be given the Striker's role: a change in play, along the links.
    team.play(&with([0.0; 2], [0.0; 2], [[-0.69, 0.0], [-0.4, 0.4], [-0.1, 0.0]]));
    assert_eq!(team.duties().roles, [Role::Goalkeeper, Role::Assistant, Role::Striker]);
}

#[test]
fn teams_without_a_tree_take_none() {
    for kind in [TeamKind::Machine, TeamKind::MachineWithoutSwaps, TeamKind::Chase, TeamKind::Formation] {
        let error = Team::new(kind, Margins::default(), Some(coach::BUILT_IN), None, penalties()).unwrap_err();
        let wanted = format!("expected no coach tree for the team {:?}, which a tree does not coach", kind.text());
        assert_eq!(error.to_string(), wanted);
    }
    let margins = Margins { enter: -1.0, ..Margins::default() };
    let error = Team::new(TeamKind::Tree, margins, None, None, penalties()).unwrap_err();
    assert_eq!(error.to_string(), "margins.enter: expected 0.1 to 10, found -1");
}

#[test]
fn teams_without_a_coach_keep_their_formation() {
    for (kind, roles) in [
        (TeamKind::Chase, [Role::Goalkeeper, Role::Striker, Role::Striker]),
        (TeamKind::Formation, [Role::Goalkeeper, Role::Wingback, Role::Fullback]),
    ] {
        let mut team = started(kind, &view());
        let mut wanted = roles;
        wanted.sort_unstable();
        for frame in 0..1200 {
            team.play(&tour(frame));
            let mut found = team.duties().roles;
            found.sort_unstable();
            assert_eq!(found, wanted, "{kind:?} {frame}");
        }
        assert_eq!(team.violations(), 0);
    }
}
