//! The organisation as data, and what its checker refuses.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::soccer::team::organisation::{
    Checker, LinkKind, Member, Organisation, Relation, Scope, Violation,
};
use swarm_playground::soccer::team::{Duties, Formation, Mode, Role};

use Role::{Assistant, Fullback, Goalkeeper, PenaltyDefender, PenaltyKicker, Striker, Wingback};

#[test]
fn organisation_written_and_read_again_is_the_same() {
    let organisation = Organisation::built_in();
    let text = serde_json::to_string(organisation).unwrap();
    assert_eq!(Organisation::read(&text).as_ref(), Ok(organisation));
}

#[test]
fn coach_has_authority_over_all_seven_roles_and_every_role_an_obligation() {
    let organisation = Organisation::built_in();
    let authority: Vec<_> =
        organisation.structural.links.iter().filter(|link| link.kind == LinkKind::Authority).collect();
    assert_eq!(authority.len(), 1);
    assert_eq!((authority[0].from.as_slice(), authority[0].to.len()), ([Member::Coach].as_slice(), 7));
    assert_eq!(organisation.roles.len(), 8);
    for role in &organisation.roles {
        let duties = organisation.deontic.iter().filter(|duty| duty.role == *role);
        assert_eq!(duties.filter(|duty| duty.relation == Relation::Obliged).count(), 1, "{}", role.text());
    }
    assert_eq!(organisation.functional.missions.len(), 8);
}

#[test]
fn exactly_the_five_formations_are_allowed() {
    let checker = Checker::built_in();
    let mut allowed = Vec::new();
    for a in Role::ALL {
        for b in Role::ALL {
            for c in Role::ALL {
                if let Ok(formation) = checker.formation([a, b, c]) {
                    allowed.push(formation);
                }
            }
        }
    }
    // Orders of the three roles: 6 of three different ones, 3 of two equal ones.
    for formation in Formation::ALL {
        let orders = if formation == Formation::TwoStrikers { 3 } else { 6 };
        assert_eq!(allowed.iter().filter(|other| **other == formation).count(), orders, "{}", formation.text());
    }
    assert_eq!(allowed.len(), 27);
}

#[test]
fn compatibilities_are_those_of_the_table() {
    let within = [
        (Fullback, Wingback),
        (Wingback, Fullback),
        (Goalkeeper, Wingback),
        (Wingback, Goalkeeper),
        (Striker, Assistant),
        (Assistant, Striker),
        (PenaltyKicker, Striker),
        (PenaltyDefender, Goalkeeper),
    ];
    let between = [
        (Wingback, Striker),
        (Striker, Wingback),
        (Fullback, Assistant),
        (Assistant, Fullback),
        (Goalkeeper, Goalkeeper),
    ];
    let checker = Checker::built_in();
    for from in Role::ALL {
        for to in Role::ALL {
            let name = format!("{} to {}", from.text(), to.text());
            assert_eq!(checker.allows(from, to, Scope::IntraGroup), within.contains(&(from, to)), "{name}");
            assert_eq!(checker.allows(from, to, Scope::InterGroup), between.contains(&(from, to)), "{name}");
        }
    }
}

#[test]
fn changes_follow_links_and_their_texts_say_which_is_missing() {
    let checker = Checker::built_in();
    let change = |before, after| checker.change(Member::Coach, before, after);
    let defense = [Goalkeeper, Fullback, Wingback];
    assert_eq!(change(defense, [Goalkeeper, Wingback, Fullback]), Ok(Formation::FullbackWingback));
    assert_eq!(change(defense, [Goalkeeper, Assistant, Striker]), Ok(Formation::StrikerAssistant));
    assert_eq!(change([PenaltyDefender, Fullback, Wingback], defense), Ok(Formation::FullbackWingback));

    let text = |result: Result<Formation, Violation>| result.unwrap_err().to_string();
    assert_eq!(
        text(change(defense, [Fullback, Goalkeeper, Wingback])),
        "robot 0: no compatibility within a group leads from goalkeeper to fullback"
    );
    assert_eq!(
        text(change(defense, [Goalkeeper, Striker, Assistant])),
        "robot 1: no compatibility between the groups leads from fullback to striker"
    );
    assert_eq!(
        text(change(defense, [Striker, Fullback, Wingback])),
        "expected a formation of the organisation, found striker, fullback, wingback: nobody keeps the goal"
    );
    assert_eq!(
        text(change(defense, [Goalkeeper, Goalkeeper, Wingback])),
        "expected a formation of the organisation, found goalkeeper, goalkeeper, wingback"
    );
    // A penalty's formation ends; no way leads into it during play.
    assert_eq!(
        text(change(defense, [PenaltyDefender, Fullback, Wingback])),
        "robot 0: no compatibility within a group leads from goalkeeper to penalty_defender"
    );
}

#[test]
fn nobody_but_the_coach_changes_roles() {
    let checker = Checker::built_in();
    let (before, after) = ([Goalkeeper, Fullback, Wingback], [Goalkeeper, Wingback, Fullback]);
    for role in Role::ALL {
        let by = Member::Player(role);
        let refused = checker.change(by, before, after).unwrap_err();
        assert_eq!(refused, Violation::NoAuthority { by, over: Fullback });
        assert_eq!(checker.start(by, before, [Goalkeeper, Striker, Assistant]).unwrap_err(), refused);
        // A change that changes nothing needs no authority.
        assert_eq!(checker.change(by, before, before), Ok(Formation::FullbackWingback));
    }
    assert_eq!(
        checker.change(Member::Player(Striker), before, after).unwrap_err().to_string(),
        "striker has no authority over fullback: only the coach changes roles"
    );
}

#[test]
fn starts_need_no_link_but_a_formation() {
    let checker = Checker::built_in();
    let before = [Goalkeeper, Fullback, Wingback];
    assert_eq!(checker.start(Member::Coach, before, [Assistant, Goalkeeper, Striker]), Ok(Formation::StrikerAssistant));
    assert!(checker.start(Member::Coach, before, [Striker; 3]).is_err());
}

#[test]
fn duties_that_contradict_themselves_are_seen() {
    let checker = Checker::built_in();
    let duties = Duties::default();
    assert_eq!(checker.look(&duties), Ok(()));
    let wrong = Duties { mode: Mode::Attack, ..duties };
    assert_eq!(
        checker.look(&wrong).unwrap_err().to_string(),
        "expected team_mode 'defend' with the formation fullback_wingback, found 'attack'"
    );
    let wrong = Duties { formation: Formation::TwoStrikers, ..duties };
    assert_eq!(
        checker.look(&wrong).unwrap_err().to_string(),
        "expected formation 'fullback_wingback', which is what the roles are, found 'two_strikers'"
    );
}

#[test]
fn organisations_that_contradict_themselves_are_refused() {
    let text = serde_json::to_string_pretty(Organisation::built_in()).unwrap();
    let fault = |old: &str, new: &str| {
        let changed = text.replacen(old, new, 1);
        assert_ne!(changed, text, "{old} is there");
        Organisation::read(&changed).unwrap_err().to_string()
    };
    assert_eq!(
        fault("\"parts\": [\n          \"score\"", "\"parts\": [\n          \"dance\""),
        "goal win: expected a declared goal, found \"dance\""
    );
    assert_eq!(
        fault("\"mission\": \"m0\"", "\"mission\": \"m9\""),
        "deontic, coach: expected a declared mission, found \"m9\""
    );
    assert_eq!(
        fault("\"name\": \"two_strikers\"", "\"name\": \"penalty_defense\""),
        "group attack, formation penalty_defense: expected a formation of this group"
    );
    assert_eq!(
        fault(
            "\"role\": \"striker\",\n            \"least\": 0,\n            \"most\": 2",
            "\"role\": \"striker\",\n            \"least\": 0,\n            \"most\": 1"
        ),
        "group attack, formation two_strikers: expected 0 to 1 of striker, found 2"
    );
    assert_eq!(fault("\"coach\",", "\"trainer\","), "expected coach or a role, found \"trainer\" at line 4 column 4");
}
