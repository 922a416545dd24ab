//! State machines as controllers: the interpreter step by step, the mapping, the language, and what the page is told.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use rand::RngExt;
use serde_json::{Value, json};
use swarm_playground::evolution::Limits;
use swarm_playground::geese::{
    Compiler, Controller, Derived, Detail, GenomeSelection, Machine, Params, Population, PopulationForm, Query,
    SwapRule, Task, World, export_query, grammar_text,
};
use swarm_playground::random::{Purpose, Seed, Stream, stream};

fn compiler(grammar: &str) -> Compiler {
    Compiler::new(grammar, Limits { max_wraps: 0, max_depth: 60 }).expect("the grammar is valid")
}

/// The machine of a genome; `None` when it maps to none.
fn machine_of(compiler: &mut Compiler, codons: &[u16]) -> Option<Machine> {
    let mut controller = Controller::default();
    compiler.compile(codons, &mut controller).ok()?;
    match controller {
        Controller::Machine(machine) => Some(*machine),
        Controller::Tree(_) => panic!("a tree where a machine was expected"),
    }
}

/// The machine that these rules write.
fn machine(rules: &str) -> Machine {
    machine_of(&mut compiler(&format!("<S> ::= {rules}")), &[0]).expect("one sentence")
}

fn luck() -> Stream {
    stream(Seed::new(5).expect("small"), Purpose::Luck, 0)
}

/// Makes one step in which the named conditions hold and every action succeeds; returns the action that ran.
fn step(machine: &mut Machine, holding: &[&str], tick: u32) -> String {
    let mut ran = String::new();
    let run = |leaf: swarm_playground::geese::Leaf| {
        if leaf.name.is_action() {
            ran = leaf.to_string();
            return true;
        }
        holding.contains(&leaf.to_string().as_str())
    };
    machine.step(run, &mut luck(), tick);
    ran
}

#[test]
fn a_machine_starts_exploring_and_the_new_state_runs_in_the_step_of_the_change() {
    let mut machine = machine("From(Explore) If(NeighbourObjects Food equals true) Goto(1, CompositeSingleCarry Food)");
    assert_eq!(step(&mut machine, &[], 1), "Explore");
    assert_eq!(machine.fired, [0]);
    assert_eq!(step(&mut machine, &["NeighbourObjects Food"], 2), "CompositeSingleCarry Food");
    assert_eq!((machine.fired.as_slice(), machine.tick, machine.succeeded), ([2].as_slice(), 2, true));
    // The rule does not hold in the new state, so nothing fires and the state stays.
    assert_eq!(step(&mut machine, &["NeighbourObjects Food"], 3), "CompositeSingleCarry Food");
    assert_eq!(machine.fired, [2]);
}

#[test]
fn the_first_rule_that_fits_fires_and_no_other() {
    let mut machine = machine(
        "From(MoveTowards Hub) If(- equals true) Goto(1, CompositeDrop Food) \
         From(Explore) If(IsCarrying Food equals true) Goto(1, MoveTowards Hub) \
         From(Explore) If(- equals true) Goto(1, MoveTowards Sites)",
    );
    // Rule 0 is not for Explore, rule 1 is and its test holds; rule 2 would fit too but comes later.
    assert_eq!(step(&mut machine, &["IsCarrying Food"], 1), "MoveTowards Hub");
    assert_eq!(machine.fired, [0, 1, 0]);
    // Now rule 0: `-` tests nothing.
    assert_eq!(step(&mut machine, &[], 2), "CompositeDrop Food");
    assert_eq!(machine.fired, [2, 1, 0]);
}

#[test]
fn equals_false_turns_the_whole_test_round() {
    let mut machine = machine(
        "From(Explore) If(NeighbourObjects Hub not IsCarrying Food equals false) Goto(1, MoveTowards Hub) \
         From(MoveTowards Hub) If(- equals false) Goto(1, Explore)",
    );
    // Hub sensed and nothing carried is the wanted pattern, so the rule does not fire; anything else fires it.
    assert_eq!(step(&mut machine, &["NeighbourObjects Hub"], 1), "Explore");
    assert_eq!(step(&mut machine, &["NeighbourObjects Hub", "IsCarrying Food"], 2), "MoveTowards Hub");
    // No test is always as wanted, so the last rule never fires.
    assert_eq!(step(&mut machine, &[], 3), "MoveTowards Hub");
    assert_eq!(machine.fired, [2, 0]);
}

#[test]
fn variables_are_false_first_and_count_in_the_step_after() {
    let mut machine = machine(
        "From(Explore) If(not X equals true) Goto(0, Explore) Set(X, true, 1) \
         From(Explore) If(X not Y equals true) Goto(1, MoveTowards Sites) Set(Y, true, 1) \
         From(MoveTowards Sites) If(X Y equals true) Goto(0, Explore) Set(X, false, 1)",
    );
    // Step 1: X false, rule 0 sets it. Step 2: X true, Y false, rule 1. Step 3: both true, rule 2 clears X but stays.
    assert_eq!(step(&mut machine, &[], 1), "Explore");
    assert_eq!(step(&mut machine, &[], 2), "MoveTowards Sites");
    assert_eq!(step(&mut machine, &[], 3), "MoveTowards Sites");
    // Step 4: X is false again, nothing fits.
    assert_eq!(step(&mut machine, &[], 4), "MoveTowards Sites");
    assert_eq!(machine.fired, [1, 2, 3]);
    machine.restart();
    assert_eq!((machine.state, machine.holds, machine.fired.as_slice()), (0, 0, [0, 0, 0].as_slice()));
}

#[test]
fn luck_is_asked_for_the_state_first_and_only_when_a_rule_fires() {
    let mut machine =
        machine("From(Explore) If(NeighbourObjects Hub equals true) Goto(0.5, MoveTowards Hub) Set(X, true, 0.25)");
    let mut rng = luck();
    machine.step(|_| false, &mut rng, 1);
    assert_eq!(rng, luck(), "nothing fired");
    let mut expected = luck();
    for tick in 2..40 {
        machine.restart();
        machine.step(|leaf| !leaf.name.is_action(), &mut rng, tick);
        let (goes, sets) = (expected.random_bool(0.5), expected.random_bool(0.25));
        // The one test has bit 0, X has bit 30.
        assert_eq!((machine.state, machine.holds), (u8::from(goes), 1 | u32::from(sets) << 30));
    }
    assert_eq!(rng, expected);
}

#[test]
fn only_states_that_some_rule_leads_to_can_be_reached() {
    // Explore to Sites; Hub only from Drop, and nothing leads to Drop; the last rule never changes the state.
    let machine = machine(
        "From(Explore) If(X equals true) Goto(0.1, MoveTowards Sites) \
         From(CompositeDrop Food) If(- equals true) Goto(1, MoveTowards Hub) \
         From(Explore) If(- equals true) Goto(0, CompositeDrop Food)",
    );
    assert_eq!((machine.states.len(), machine.reachable()), (4, 2));
}

#[test]
fn worked_example_of_the_machine_grammar() {
    let codons = [0, 4, 7, 5, 11, 5, 2, 5, 4, 3, 8, 2, 6, 2, 9, 13, 1, 4, 15, 200];
    // S; 4 mod 4 = 0: one rule; 7 mod 1; states 5, 11, 5 mod 5 = Explore, MoveTowards Sites, Explore again.
    // Tests mod 3: 2 -, 5 -, 4 = 1 item sensed, 3 = 0 not carrying, 8 -, 2 -, 6 = 0 not Y; 2 mod 2 = 0 true.
    // 9 mod 5 = 4: probability 1; 13 mod 5 = 3: carry; 1 mod 2: Y; 4 mod 2 = 0: true; 15 mod 8 = 7: probability 1.
    let mut compiler = compiler(&grammar_text("machine", Task::Forage));
    let found = serde_json::to_value(Derived::of(&mut compiler, &codons)).expect("it is JSON");
    let expected = "From(Explore MoveTowards Sites) If(NeighbourObjects Food not IsCarrying Food not Y equals true) \
                    Goto(1, CompositeSingleCarry Food) Set(Y, true, 1)";
    assert_eq!(found["phenotype"], expected);
    // S 1, rules 2, rule 3, state 4, its text 5.
    assert_eq!((found["used"].as_u64(), found["depth"].as_u64()), (Some(19), Some(5)));
    // Explore, MoveTowards, CompositeSingleCarry, NeighbourObjects, IsCarrying of these, CompositeDrop and IsVisitedBefore.
    assert!((found["diversity"].as_f64().expect("valid") - 5.0 / 7.0).abs() < 1e-15);
    assert_eq!((found["nodes"].is_null(), found["machine"]["rules"].as_array().map(Vec::len)), (true, Some(1)));
    assert_eq!(found["steps"][18]["node"], 0);

    // 17 codons a rule; 1 mod 4: a rule and what follows; the second is cut short.
    let cut: Vec<u16> = [0, 1].into_iter().chain(codons[2..19].iter().copied()).chain([0, 7, 5]).collect();
    let found = serde_json::to_value(Derived::of(&mut compiler, &cut)).expect("it is JSON");
    assert_eq!((found["valid"].as_bool(), found["reason"].as_str()), (Some(false), Some("codons used up")));
    let two: Vec<u16> = cut[..19].iter().chain(&codons[1..19]).copied().collect();
    let found = serde_json::to_value(Derived::of(&mut compiler, &two)).expect("it is JSON");
    assert_eq!(found["machine"]["rules"].as_array().map(Vec::len), Some(2));
    assert_eq!((&found["steps"][18]["node"], &found["steps"][21]["node"]), (&json!(0), &json!(1)));
}

#[test]
fn faults_of_a_machine_grammar_name_the_place() {
    let refused = |grammar: &str| match Compiler::new(grammar, Limits { max_wraps: 0, max_depth: 10 }) {
        Ok(_) => panic!("{grammar:?} was taken"),
        Err(error) => error.to_string(),
    };
    let rule = |from: &str, test: &str, goto: &str| format!("<S> ::= From({from}) If({test}) Goto({goto})");
    let sound = ["Explore", "X equals true", "1, Explore"];
    assert!(Compiler::new(&rule(sound[0], sound[1], sound[2]), Limits { max_wraps: 0, max_depth: 10 }).is_ok());
    for (grammar, message) in [
        (rule("IsCarrying Food", sound[1], sound[2]), "line 1, column 14: expected an action, found IsCarrying"),
        (rule("MoveTowards Food", sound[1], sound[2]), "line 1, column 26: expected a place, found Food"),
        (rule("", sound[1], sound[2]), "line 1, column 14: expected an action, found )"),
        (
            rule(sound[0], "Explore equals true", sound[2]),
            "line 1, column 26: expected a condition, X, Y or -, found Explore",
        ),
        (rule(sound[0], "not - equals true", sound[2]), "line 1, column 30: expected a condition, X or Y, found -"),
        (rule(sound[0], "X", sound[2]), "line 1, column 27: expected a condition, X, Y or -, found )"),
        (
            rule(sound[0], sound[1], "2, Explore"),
            "line 1, column 46: expected a probability from 0 to 1 with at most six decimals, found 2",
        ),
        (rule(sound[0], sound[1], "0.5 Explore"), "line 1, column 50: expected a comma, found Explore"),
        (
            rule(sound[0], sound[1], "1, Exploer"),
            "line 1, column 49: unknown word \"Exploer\", did you mean \"Explore\"?",
        ),
        (
            "<S> ::= From(Explore) If(<t> equals true) Goto(1, Explore)\n<t> ::= X | Explore".to_owned(),
            "line 2, column 13: expected a condition, X, Y or -, found Explore",
        ),
        (
            "<S> ::= From(Explore) If(X equals true) Goto(<p>, Explore) Set(X, <p>, 1)\n<p> ::= 1".to_owned(),
            "line 2, column 9: expected true or false, found 1",
        ),
        (
            "<S> ::= From(Explore) If(X equals true) Goto(1, Explore) Explore".to_owned(),
            "line 1, column 58: expected a rule that begins with From(, found Explore",
        ),
        (
            "<S> ::= From(Explore) If(X equals true) Goto(1, Explore) Seq[Explore]".to_owned(),
            "line 1, column 58: unknown word \"Seq\", did you mean \"Set\"?",
        ),
    ] {
        assert_eq!(refused(&grammar), message, "{grammar}");
    }
}

fn world(change: impl Fn(&mut Params)) -> World {
    let mut params = Params { agents: 30, grammar: "machine".to_owned(), ..Params::default() };
    change(&mut params);
    World::new(&params, Seed::new(11).expect("small")).expect("it builds")
}

fn geese(params: &mut Params) {
    params.storage_threshold = 0;
    params.genome_selection = GenomeSelection::Tournament;
    params.swap_rule = SwapRule::Always;
    params.elite_size = 1;
}

fn asked(world: &mut World, query: &Query) -> Value {
    serde_json::to_value(Detail::of(world, query)).expect("it is JSON")
}

#[test]
fn with_threshold_0_every_meeting_breeds_and_nothing_is_stored() {
    let mut world = world(geese);
    (0..30).for_each(|_| world.step());
    let agents = (0..30).map(|agent| asked(&mut world, &Query { agent: Some(agent), ..Query::default() }));
    let agents: Vec<Value> = agents.collect();
    assert!(agents.iter().all(|detail| detail["agent"]["stored"].as_array().is_some_and(Vec::is_empty)));
    let swaps: u64 = agents.iter().filter_map(|detail| detail["agent"]["swaps"].as_u64()).sum();
    // All start in the hub, within reach of each other, so nearly every step of every agent is a meeting.
    assert!(swaps > 500, "{swaps}");
}

#[test]
fn the_inspector_shows_states_tests_and_rules_with_what_happened_last() {
    let mut world = world(|params| {
        params.grammar = "hand-machine".to_owned();
        params.evolution = false;
    });
    (0..60).for_each(|_| world.step());
    let all = asked(&mut world, &Query::default());
    assert_eq!((all["programs"]["count"].as_u64(), all["programs"]["top"][0]["agents"].as_u64()), (Some(1), Some(30)));
    let machine = &all["tree"]["machine"];
    assert_eq!(all["tree"]["nodes"], json!([]));
    let labels: Vec<&str> =
        machine["states"].as_array().expect("a list").iter().filter_map(|s| s["label"].as_str()).collect();
    assert_eq!(labels[0], "Explore");
    assert_eq!(labels.len(), 5);
    let shares: f64 = machine["states"].as_array().expect("a list").iter().filter_map(|s| s["now"].as_f64()).sum();
    assert!((shares - 1.0).abs() < 1e-12, "every robot is in one state");
    assert_eq!(machine["rules"].as_array().map(Vec::len), Some(5));

    let one = asked(&mut world, &Query { agent: Some(3), ..Query::default() });
    let now: Vec<&Value> =
        one["tree"]["machine"]["states"].as_array().expect("a list").iter().filter(|s| s["now"] == 1.0).collect();
    assert_eq!(now.len(), 1, "one robot is in one state");
    if let Some(action) = one["agent"]["last_action"].as_str() {
        assert_eq!(now[0]["label"], action);
    }
    // The robots for which a rule fired are those that the shares count.
    for rule in 0..5 {
        let reached = asked(&mut world, &Query { node: Some(rule), ..Query::default() });
        let count = reached["reached"].as_array().map_or(0, Vec::len) as f64;
        let share = machine["rules"][rule as usize]["reached_now"].as_f64().expect("a share");
        assert!((share - count / 30.0).abs() < 1e-12);
    }
    assert_eq!(asked(&mut world, &Query { node: Some(99), ..Query::default() })["reached"], json!([]));
}

#[test]
fn an_exported_machine_is_a_grammar_that_gives_the_same_machine() {
    let mut world = world(geese);
    (0..20).for_each(|_| world.step());
    for agent in 0..30 {
        let query = Query { agent: Some(agent), ..Query::default() };
        let written = export_query(&world, &query).expect("there is such an agent");
        let shown = asked(&mut world, &query);
        let read = machine_of(&mut compiler(&written), &[0; 200]).expect("one sentence");
        assert_eq!(read.to_string(), shown["tree"]["text"].as_str().expect("a text"), "{written}");
        assert_eq!(format!("{:016x}", read.id()), shown["tree"]["program"].as_str().expect("an id"));
    }
}

#[test]
fn saved_machines_run_again_but_cannot_be_blended() {
    let mut source = world(geese);
    (0..40).for_each(|_| source.step());
    let saved = Population::of(&source).write();
    let fixed = |form| {
        let mut params = Params { agents: 30, grammar: "machine".to_owned(), evolution: false, ..Params::default() };
        (params.population_form, params.population) = (form, saved.clone());
        World::new(&params, Seed::new(2).expect("small"))
    };
    let mut again = fixed(PopulationForm::Homogeneous).expect("it builds");
    (0..10).for_each(|_| again.step());
    assert_eq!(asked(&mut again, &Query::default())["programs"]["count"], 1);
    let refused = fixed(PopulationForm::Blended).expect_err("machines have no root to stand under");
    assert_eq!(refused, ("population", "expected behaviour trees to blend, found state machines".to_owned()));
}

#[test]
fn programs_written_by_hand_bring_every_item_home() {
    for grammar in ["hand-tree", "hand-machine"] {
        for task in [Task::Forage, Task::Nest] {
            for seed in 1..4 {
                let params = Params { task, grammar: grammar.to_owned(), evolution: false, ..Params::default() };
                let mut world = World::new(&params, Seed::new(seed).expect("small")).expect("it builds");
                while world.outcome().finished.is_none() {
                    world.step();
                }
                assert!(
                    world.outcome().share >= 1.0 && world.state().tick() < 3000,
                    "{grammar}, {task:?}, seed {seed}"
                );
            }
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
mod laws {
    use super::{compiler, grammar_text, luck, machine_of};
    use proptest::prelude::*;
    use swarm_playground::evolution::Genome;
    use swarm_playground::geese::{Task, write_rules};

    proptest! {
        #[test]
        fn any_genome_gives_a_valid_machine_or_none(
            codons in prop::collection::vec(any::<u16>(), 1..400),
            nest in any::<bool>(),
            senses in any::<u64>(),
        ) {
            let mut compiler = compiler(&grammar_text("machine", if nest { Task::Nest } else { Task::Forage }));
            let mut genome = Genome { codons: codons.clone(), used: 0 };
            let surveyed = compiler.survey(&mut genome, None);
            let machine = machine_of(&mut compiler, &codons);
            prop_assert_eq!(surveyed.is_some(), machine.is_some());
            if let (Some(survey), Some(mut machine)) = (surveyed, machine) {
                let leaves = machine.states.iter().chain(&machine.tests);
                // Explore is a state even when no rule names it.
                let names = leaves.fold(0, |set, leaf| set | leaf.name.bit());
                prop_assert_eq!(names & !swarm_playground::geese::Name::Explore.bit() & !survey.names, 0);
                prop_assert!(!machine.rules.is_empty() && genome.used > 0);
                let mut read = super::machine_of(&mut super::compiler(&write_rules(&machine)), &[0; 100]);
                prop_assert_eq!(read.as_mut().map(|read| read.id()), Some(machine.id()));
                let (mut luck, mut asked) = (luck(), 0);
                for tick in 1..60 {
                    let sense = |_| {
                        asked += 1;
                        senses >> (asked % 64) & 1 == 1
                    };
                    machine.step(sense, &mut luck, tick);
                    prop_assert!(usize::from(machine.state) < machine.states.len());
                }
            }
        }

        #[test]
        fn no_text_makes_the_language_check_panic(text in "(<S> ::= )?(From\\(|If\\(|Goto\\(|Set\\(|[)<>,|\\-]|Explore|Hub|X|not|equals|true|0\\.5|<S>|[ \n]){0,24}") {
            let limits = swarm_playground::evolution::Limits { max_wraps: 1, max_depth: 12 };
            if let Ok(mut compiler) = swarm_playground::geese::Compiler::new(&text, limits) {
                let mut controller = swarm_playground::geese::Controller::default();
                let _ = compiler.compile(&[0, 1, 2, 3, 4, 5], &mut controller);
                let _ = controller.text();
            }
        }
    }
}
