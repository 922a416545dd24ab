//! The foraging swarm: its language, the worked examples of the mapping, known counts, and the laws of its world.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::evolution::{Genome, Limits};
use swarm_playground::geese::{
    Compiler, Detail, Finished, Layout, Params, Query, SwapRule, Task, World, fill_frame, grammar_text,
};
use swarm_playground::random::{Purpose, Seed, stream};

/// The built-in nominal grammar for foraging.
fn nominal() -> String {
    grammar_text("nominal", Task::Forage).into_owned()
}

/// The built-in PPA grammar for foraging.
fn ppa() -> String {
    grammar_text("ppa", Task::Forage).into_owned()
}

fn compiler(grammar: &str, max_depth: u32) -> Compiler {
    Compiler::new(grammar, Limits { max_wraps: 0, max_depth }).expect("the grammar is valid")
}

fn derive(compiler: &mut Compiler, codons: &[u16]) -> serde_json::Value {
    serde_json::to_value(swarm_playground::geese::Derived::of(compiler, codons)).expect("it is JSON")
}

#[test]
fn worked_example_of_the_nominal_grammar() {
    let found = derive(&mut compiler(&nominal(), 10), &[17, 4, 9, 30, 7, 13, 21, 26, 3]);
    assert_eq!(found["phenotype"], "Seq[Cond(not IsVisitedBefore Sites) Act(Explore)]");
    assert_eq!((found["used"].as_u64(), found["depth"].as_u64()), (Some(8), Some(8)));
    // Two distinct names of nine.
    assert!((found["diversity"].as_f64().expect("valid") - 2.0 / 9.0).abs() < 1e-15);
}

#[test]
fn worked_example_of_the_ppa_grammar() {
    let mut compiler10 = compiler(&ppa(), 10);
    let codons = [12, 3, 6, 8, 5, 9, 18, 11, 7, 2, 15, 21, 10, 33];
    let found = derive(&mut compiler10, &codons);
    let expected = "Sel[Sel[Seq[Post(IsCarrying Food)] Seq[Seq[Con(CanMove)] Act(MoveTowards Sites)]]]";
    assert_eq!(found["phenotype"], expected);
    assert_eq!((found["used"].as_u64(), found["depth"].as_u64()), (Some(14), Some(9)));
    assert!((found["diversity"].as_f64().expect("valid") - 3.0 / 11.0).abs() < 1e-15);
    // Codon 33 chose the argument of the action, the last leaf of seven nodes.
    assert_eq!(found["steps"][13]["node"], 7);
    assert_eq!(found["nodes"][7]["label"], "MoveTowards Sites");

    let cut = derive(&mut compiler10, &codons[..13]);
    assert_eq!((cut["valid"].as_bool(), cut["reason"].as_str()), (Some(false), Some("codons used up")));

    let deep = [12, 3, 6, 8, 5, 9, 18, 11, 6, 2, 15, 22, 10, 33, 10, 33];
    assert_eq!(derive(&mut compiler10, &deep)["reason"], "depth limit 10 exceeded");
    let found = derive(&mut compiler(&ppa(), 11), &deep);
    assert_eq!(found["used"], 16);
    let expected = "Sel[Sel[Seq[Post(IsCarrying Food)] Seq[Seq[Pre(NeighbourObjects Sites)] Act(MoveTowards Sites)]]]";
    assert_eq!(found["phenotype"], expected);
}

/// The share of genomes of 400 uniform codons, an endless supply at these depths, that map to a program.
fn valid_share(grammar: &str, max_depth: u32) -> f64 {
    let mut compiler = compiler(grammar, max_depth);
    let mut rng = stream(Seed::new(1).expect("small"), Purpose::Genesis, max_depth);
    let mut genome = Genome::default();
    let draws = 40_000;
    let valid = (0..draws).filter(|_| {
        genome.randomise(&mut rng, 400, 65_519); // 65,520 is a multiple of every number of alternatives here
        compiler.survey(&mut genome, None).is_some()
    });
    valid.count() as f64 / f64::from(draws)
}

#[test]
fn validity_agrees_with_the_exact_probabilities() {
    // Counted exactly from the grammars; five standard errors of 40,000 draws are at most 0.0125.
    let (nominal, ppa) = (nominal(), ppa());
    for (grammar, depth, exact) in [
        (&ppa, 10, 0.0723),
        (&ppa, 11, 0.1397),
        (&ppa, 12, 0.2024),
        (&nominal, 10, 0.2994),
        (&nominal, 11, 0.3499),
        (&nominal, 12, 0.3856),
    ] {
        let found = valid_share(grammar, depth);
        assert!((found - exact).abs() < 0.0125, "depth {depth}: {found} is not {exact}");
    }
}

#[test]
fn at_depth_10_no_program_has_more_than_six_names_and_one_action() {
    let mut compiler = compiler(&ppa(), 10);
    assert_eq!(compiler.vocabulary().count(), 11);
    assert!((compiler.greatest_diversity() - 6.0 / 11.0).abs() < 1e-15);
    let mut rng = stream(Seed::new(2).expect("small"), Purpose::Genesis, 0);
    let mut genome = Genome::default();
    let mut most = 0;
    for _ in 0..20_000 {
        genome.randomise(&mut rng, 100, 255);
        if let Some(survey) = compiler.survey(&mut genome, None) {
            most = most.max(survey.names.count_ones());
            let actions = derive(&mut compiler, &genome.codons)["phenotype"].to_string().matches("Act(").count();
            assert_eq!(actions, 1);
        }
    }
    assert!((5..=6).contains(&most), "{most}");
}

fn language_error(from: &str, to: &str) -> String {
    let text = ppa().replacen(from, to, 1);
    assert_ne!(text, ppa(), "{from} is in the grammar");
    Compiler::new(&text, Limits { max_wraps: 0, max_depth: 10 }).expect_err("no language").to_string()
}

#[test]
fn language_errors_name_the_place() {
    assert_eq!(
        language_error("IsCarrying <d> | IsVisitedBefore <s>", "IsCarying <d> | IsVisitedBefore <s>"),
        "line 8, column 79: unknown word \"IsCarying\", did you mean \"IsCarrying\"?"
    );
    assert_eq!(
        language_error("<k> ::= CanMove | IsCarryable <d>", "<k> ::= CanMove | IsCarryable <s>"),
        "line 17, column 31: expected an item after IsCarryable, found <s>, a place"
    );
    assert_eq!(
        language_error("<ppa> ::= Sel[<postconditions> <ppasequence>]", "<ppa> ::= Sel[<postconditions> <ppasequence>"),
        "line 5, column 32: expected ], found the end of the alternative"
    );
    assert_eq!(
        language_error("<s> ::= Hub | Sites", "<s> ::= Hub | Explore"),
        "line 20, column 15: expected a place like the other alternatives of <s>, found a condition or action"
    );
    assert_eq!(
        language_error("Post(<pc>) | Post(<pc>)", "Post[<pc>) | Post(<pc>)"),
        "line 7, column 37: expected ( after Post"
    );
    assert_eq!(
        Compiler::new("<s> ::= Hub", Limits { max_wraps: 0, max_depth: 10 }).expect_err("no tree").to_string(),
        "line 1, column 1: expected the first rule to stand for nodes, found a place"
    );
}

fn small(seed: u64, change: impl Fn(&mut Params)) -> World {
    let mut params = Params { agents: 30, swap_rule: SwapRule::Always, ..Params::default() };
    change(&mut params);
    World::new(&params, Seed::new(seed).expect("small")).expect("the parameters are valid")
}

#[test]
fn items_are_never_lost_and_agents_never_leave_the_arena() {
    for seed in 0..4 {
        let mut world = small(seed, |params| params.items = 17);
        let mut frame = Vec::new();
        for _ in 0..300 {
            world.step();
            fill_frame(&world, &mut frame);
            let [_, delivered, carried, free, items, ..] = frame[..] else { panic!("the frame has counts") };
            assert!((delivered + carried + free - items).abs() < 1e-6 && (items - 17.0).abs() < 1e-6);
            for agent in frame[8..8 + 30 * 6].chunks(6) {
                assert!(agent[0].abs() <= 50.0 && agent[1].abs() <= 50.0);
            }
        }
        assert_eq!(frame.len(), Layout::of(&world).length);
    }
}

#[test]
fn a_group_alone_with_the_food_ends_early() {
    // Hub and site on one spot and a reach over all of it: picking up and dropping is all there is to do.
    let mut world = small(1, |params| {
        (params.site_distance, params.site_radius, params.items) = (0.0, 4.0, 5);
    });
    for _ in 0..2000 {
        world.step();
    }
    let outcome = world.outcome();
    assert_eq!((outcome.delivered, outcome.success), (5, true));
    assert_eq!(outcome.finished.map(Finished::text), Some("all food delivered"));
    let before = world.fingerprint();
    world.step();
    assert_eq!(world.fingerprint(), before, "a finished world stands still");
}

#[test]
fn groups_count_every_agent_once() {
    let mut world = small(3, |_| {});
    for _ in 0..40 {
        world.step();
    }
    let detail = serde_json::to_value(Detail::of(&mut world, &Query::default())).expect("it is JSON");
    let count = detail["programs"]["count"].as_u64().expect("a number");
    assert_eq!(u64::from(world.state().program_count()), count);
    let held = detail["tree"]["agents"].as_array().expect("a list").len() as u64;
    assert_eq!(held, detail["programs"]["top"][0]["agents"].as_u64().expect("a number"));
    let agent = held_first(&detail);
    let query = Query { agent: Some(agent), node: Some(0), ..Query::default() };
    let detail = serde_json::to_value(Detail::of(&mut world, &query)).expect("it is JSON");
    assert_eq!(detail["agent"]["id"].as_u64(), Some(u64::from(agent)));
    assert_eq!(detail["reached"].as_array().expect("a list").len() as u64, held, "the root is ticked in every step");
    let beyond = Query { agent: Some(999), ..Query::default() };
    let detail = serde_json::to_value(Detail::of(&mut world, &beyond)).expect("it is JSON");
    assert!(detail["agent"].is_null());
}

fn held_first(detail: &serde_json::Value) -> u32 {
    detail["tree"]["agents"][0].as_u64().expect("a number") as u32
}

#[test]
fn the_shown_parts_of_fitness_add_up_to_it() {
    let params = Params {
        agents: 30,
        swap_rule: SwapRule::Always,
        fitness_prospective: true,
        fitness_task: true,
        fitness_memory: 0.8,
        site_distance: 0.0, // food is carried home in a few steps
        ..Params::default()
    };
    let mut world = World::new(&params, Seed::new(5).expect("small")).expect("it builds");
    let mut before = [0.0; 30];
    let mut summed = 0;
    while world.state().tick() < 120 {
        world.step();
        for id in 0..30 {
            let query = Query { agent: Some(id), ..Query::default() };
            let agent = serde_json::to_value(Detail::of(&mut world, &query)).expect("it is JSON")["agent"].clone();
            let part = |name: &str| agent[name].as_f64().expect("a number");
            let counts = agent["counts"].as_array().expect("a list");
            let sum: f64 = counts.iter().map(|name| part(name.as_str().expect("a name"))).sum();
            if part("since_swap") > 0.0 {
                let expected = part("memory") * before[id as usize] + sum;
                assert!((part("fitness") - expected).abs() < 1e-9, "agent {id}: {agent}"); // sums in another order
                summed += 1;
            }
            before[id as usize] = part("fitness");
        }
    }
    assert!(summed > 100 && world.outcome().delivered > 0, "{summed} sums");
}
