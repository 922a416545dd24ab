//! Saved populations: written, read and dealt out again.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use std::collections::BTreeSet;
use swarm_playground::geese::{Detail, GenomeSelection, Params, Population, PopulationForm, Query, SwapRule, World};
use swarm_playground::random::Seed;

fn world(change: impl Fn(&mut Params)) -> Result<World, (&'static str, String)> {
    let mut params = Params { agents: 30, swap_rule: SwapRule::Always, ..Params::default() };
    change(&mut params);
    World::new(&params, Seed::new(11).expect("small"))
}

fn evolved() -> World {
    let mut world = world(|_| {}).expect("it builds");
    (0..60).for_each(|_| world.step());
    world
}

/// The program of each agent that runs next.
fn programs(world: &mut World) -> Vec<String> {
    let text = |agent| {
        let detail = serde_json::to_value(Detail::of(world, &Query { agent: Some(agent), ..Query::default() }));
        let detail = detail.expect("it is JSON");
        let next = detail["agent"]["replaced_by"].as_str().or(detail["tree"]["text"].as_str());
        next.expect("an agent has a tree").to_owned()
    };
    (0..30).map(text).collect()
}

fn fixed(form: PopulationForm, share: f64) -> World {
    let saved = Population::of(&evolved()).write();
    world(|params| {
        (params.evolution, params.population_form, params.population_share) = (false, form, share);
        params.population.clone_from(&saved);
    })
    .expect("it builds")
}

#[test]
fn a_population_is_read_as_it_was_written_and_runs_the_same_programs() {
    let mut source = evolved();
    let population = Population::of(&source);
    assert!(Population::read(&population.write()) == Ok(population), "the same members");
    let mut again = fixed(PopulationForm::AsSaved, 0.5);
    let before = programs(&mut source);
    assert!(before.iter().collect::<BTreeSet<_>>().len() > 5);
    assert_eq!(programs(&mut again), before);
    (0..50).for_each(|_| again.step());
    assert_eq!(programs(&mut again), before, "nobody evolves");
}

#[test]
fn the_fittest_are_dealt_out_in_each_form() {
    let mut source = evolved();
    let fittest = {
        let members = Population::of(&source).members;
        let best = (0..30).max_by(|a, b| members[*a].fitness.total_cmp(&members[*b].fitness).then(b.cmp(a)));
        programs(&mut source)[best.expect("there are 30")].clone()
    };
    let homogeneous = programs(&mut fixed(PopulationForm::Homogeneous, 0.5));
    assert!(homogeneous.iter().all(|program| *program == fittest));

    // 20 % of 30 are six, dealt out in turns.
    let heterogeneous = programs(&mut fixed(PopulationForm::Heterogeneous, 0.2));
    assert_eq!(heterogeneous[0], fittest);
    assert_eq!(heterogeneous[..6], heterogeneous[6..12]);

    let blended = programs(&mut fixed(PopulationForm::Blended, 0.2));
    let mut orders = BTreeSet::new();
    for program in &blended {
        let mut parts: Vec<&str> = program.trim_start_matches("Seq[").split("ForceSuccess[").skip(1).collect();
        assert_eq!(parts.len(), 6, "{program}");
        orders.insert(parts.clone());
        parts.sort_unstable();
        for part in &heterogeneous[..6] {
            assert!(program.contains(&format!("ForceSuccess[{part}]")), "{part} is not in {program}");
        }
    }
    assert!(orders.len() > 10, "each agent has an order of its own");
}

#[test]
fn blended_programs_do_what_single_ones_cannot() {
    // One program finds and takes food, the other brings it home: neither delivers anything alone.
    let grammar = "<S> ::= Sel[IsCarrying Food Seq[NeighbourObjects Food CompositeSingleCarry Food] MoveTowards Sites] \
        | Seq[IsCarrying Food Sel[Seq[NeighbourObjects Hub CompositeDrop Food] MoveTowards Hub]]";
    let saved = |codons: &[u16]| {
        let members: Vec<Value> = codons.iter().map(|codon| json!({"fitness": 1.0, "genome": [codon]})).collect();
        json!({"format": "geese-population/1", "members": members}).to_string()
    };
    let delivered = |codons: &[u16]| {
        let mut world = world(|params| {
            (params.evolution, params.population_form, params.population_share) = (false, PopulationForm::Blended, 1.0);
            (params.population, params.grammar) = (saved(codons), grammar.to_owned());
            // Near enough to be known from the start.
            params.site_distance = 9.0;
        })
        .expect("it builds");
        (0..60).for_each(|_| world.step());
        world.outcome().delivered
    };
    assert_eq!((delivered(&[0]), delivered(&[1])), (0, 0));
    // All that lies within reach of the hub's centre.
    assert!(delivered(&[0, 1]) > 5, "{}", delivered(&[0, 1]));
}

#[test]
fn fresh_programs_are_drawn_without_any_selection() {
    let mut world = world(|params| params.genome_selection = GenomeSelection::Fresh).expect("it builds");
    (0..200).for_each(|_| world.step());
    let swaps: u32 = world.state().history().iter().map(|sample| sample.swaps).sum();
    assert!(swaps > 100, "{swaps}");
    let lengths: Vec<usize> = Population::of(&world).members.iter().map(|member| member.genome.len()).collect();
    assert!(lengths.iter().all(|length| *length == 100), "every genome is as it was drawn: {lengths:?}");
}

#[test]
fn what_is_no_population_is_refused_with_the_path() {
    let refused = |text: &str| {
        let (field, message) = world(|params| text.clone_into(&mut params.population)).expect_err("it is refused");
        assert_eq!(field, "population");
        message
    };
    let file = |members: Value| json!({"format": "geese-population/1", "members": members}).to_string();
    assert_eq!(refused("{\"format\": "), "expected JSON, found EOF while parsing a value at line 1 column 11");
    assert_eq!(refused("{}"), "format: expected \"geese-population/1\", found null");
    assert_eq!(refused(&file(json!([]))), "members: expected a list of 1 to 10000 members");
    assert_eq!(refused(&file(json!([{"genome": [1]}]))), "members[0].fitness: expected a number");
    assert_eq!(
        refused(&file(json!([{"fitness": 1, "genome": [70000]}]))),
        "members[0].genome: expected a list of whole numbers from 0 to 65535"
    );
    assert_eq!(
        refused(&file(json!([{"fitness": 1, "genome": vec![0; 1001]}]))),
        "members[0].genome: expected 1000 codons at most, found 1001"
    );
    assert_eq!(
        refused(&file(json!([{"fitness": 1, "genome": [0]}]))),
        "members[0].genome: expected codons of a program of the grammar, found none"
    );
}

#[test]
fn learning_ends_in_a_fresh_world_with_programs_of_the_swarm() {
    let mut one = world(|params| {
        params.learning_steps = 60;
        params.population_form = PopulationForm::Homogeneous;
    })
    .expect("it builds");
    (0..60).for_each(|_| one.step());
    let learned: BTreeSet<String> = programs(&mut one).into_iter().collect();
    one.step();
    let fixed: BTreeSet<String> = programs(&mut one).into_iter().collect();
    assert_eq!(fixed.len(), 1, "copies of one");
    assert!(fixed.is_subset(&learned), "a program that was learned");
    assert!(one.outcome().delivered == 0 && one.outcome().finished.is_none(), "the task starts afresh");
    (0..50).for_each(|_| one.step());
    assert_eq!(programs(&mut one).into_iter().collect::<BTreeSet<String>>(), fixed, "nobody evolves");
}

#[test]
fn programs_in_turns_are_those_of_the_population_and_change_as_often_as_the_turn_says() {
    let mut source = evolved();
    let known: BTreeSet<String> = programs(&mut source).into_iter().collect();
    let saved = Population::of(&source).write();
    let mut turns = world(|params| {
        (params.evolution, params.population_form, params.population_share) = (false, PopulationForm::Multiplexed, 1.0);
        (params.population, params.dwell) = (saved.clone(), 4.0);
    })
    .expect("it builds");
    let mut seen = BTreeSet::new();
    for _ in 0..200 {
        turns.step();
        seen.extend(programs(&mut turns));
    }
    assert!(seen.is_subset(&known), "no other program");
    assert!(seen.len() * 10 > known.len() * 9, "nearly all come up: {} of {}", seen.len(), known.len());
    // 30 agents in 200 steps take up a program with probability 1/4: 1500, deviation 33.5; five of those.
    let swaps: u32 = turns.state().history().iter().map(|sample| sample.swaps).sum();
    assert!((1332..=1668).contains(&swaps), "{swaps} changes");
}

#[test]
fn an_archive_holds_programs_of_the_whole_learning_and_no_others() {
    let mut one = world(|params| {
        params.learning_steps = 60;
        params.population_form = PopulationForm::Archive;
    })
    .expect("it builds");
    let start: BTreeSet<String> = programs(&mut one).into_iter().collect();
    let (mut held, mut last) = (BTreeSet::new(), BTreeSet::new());
    for _ in 0..60 {
        one.step();
        last = programs(&mut one).into_iter().collect();
        held.extend(last.iter().cloned());
    }
    let mut ran = BTreeSet::new();
    for _ in 0..300 {
        one.step();
        ran.extend(programs(&mut one));
    }
    let taken_up = held.difference(&start).count();
    assert!(ran.is_subset(&held), "no other program");
    // The sample is of everything that was taken up, so a program that came up once may be left out.
    assert!(ran.len() * 10 > taken_up * 7, "most come up: {} of {taken_up}", ran.len());
    assert!(ran.len() > 2 * last.len(), "more than the last ones: {} and {}", ran.len(), last.len());
}

#[test]
fn the_second_start_is_the_same_whatever_came_before_in_the_timeline() {
    for form in [PopulationForm::Multiplexed, PopulationForm::Archive] {
        let build = || {
            world(|params| {
                params.learning_steps = 40;
                params.population_form = form;
            })
            .expect("it builds")
        };
        let mut straight = build();
        (0..30).for_each(|_| straight.step());
        let keyframe = straight.state().clone();
        (0..40).for_each(|_| straight.step());
        let mut again = build();
        again.restore(&keyframe);
        (0..40).for_each(|_| again.step());
        assert_eq!(again.fingerprint(), straight.fingerprint());
    }
}

#[test]
fn a_file_says_where_it_comes_from_and_is_read_like_one_that_does_not() {
    let population = Population::of(&evolved());
    let text = population.write_with("A \"title\"", Seed::new(42).expect("small"), 60);
    let value: Value = serde_json::from_str(&text).expect("it is JSON");
    assert_eq!((&value["title"], &value["seed"], &value["tick"]), (&json!("A \"title\""), &json!(42), &json!(60)));
    assert!(Population::read(&text) == Ok(population), "the same members");
}

#[test]
fn what_the_end_of_learning_cannot_do_is_refused_at_the_start() {
    let refused = world(|params| {
        params.grammar = "machine".to_owned();
        params.learning_steps = 10;
        params.population_form = PopulationForm::Blended;
    });
    let (field, message) = refused.expect_err("machines cannot be blended");
    assert_eq!(
        (field, message.as_str()),
        ("population-form", "expected another form: only behaviour trees can be blended, found state machines")
    );
}
