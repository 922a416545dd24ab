//! The switches to the authors' published code: its grammars, its lattice, its formulas, and what single switches change.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use std::collections::BTreeSet;
use swarm_playground::evolution::{Genome, Grammar, Limits, RuleId, Symbol, grow};
use swarm_playground::geese::Blackboard::{Private, Shared};
use swarm_playground::geese::{
    Behaviours, Compiler, Detail, DiversityRule, DropPostcondition, DropRule, ExplorationRule, ExploreHeading,
    FeedbackRule, FitnessRule, Footprint, Init, ItemPlacement, LengthRule, MoveAwayPostcondition, Name, Neighbours,
    NestSink, Params, PerceptWipe, Population, PopulationForm, PopulationPool, Query, Sensing, SitePlacement,
    StorageContent, StorageValue, SwapRule, Task, World, fill_frame, grammar_text,
};
use swarm_playground::random::{Purpose, Seed, stream};
use swarm_playground::scenario::{Run, Scenario, WorldParams};

const FORAGING: &str = include_str!("../scenarios/published.json");
const NEST: &str = include_str!("../scenarios/published-nest.json");

fn params(preset: &str) -> Params {
    let WorldParams::Geese(params) = Scenario::read(preset).expect("the preset is valid").world else {
        panic!("a preset of the swarm");
    };
    params
}

fn compiler(text: &str, max_depth: u32) -> Compiler {
    let mut compiler = Compiler::new(text, Limits { max_wraps: 0, max_depth }).expect("the grammar is valid");
    compiler.count_by(DiversityRule::Leaves);
    compiler
}

fn diversity(text: &str, codons: &[u16]) -> f64 {
    let mut genome = Genome { codons: codons.to_vec(), used: 0 };
    compiler(text, 10).survey(&mut genome, None).expect("the genome is valid").diversity
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 1e-9
}

#[test]
fn diversity_is_that_of_the_worked_examples() {
    // Two names of the list, two and three leaves: 25 x 2 / 9, four decimals. CanMove is not on the list.
    let nominal = grammar_text("nominal", Task::Forage);
    assert!(close(diversity(&nominal, &[17, 4, 9, 30, 7, 13, 21, 26, 3]), 5.5556));
    let ppa = grammar_text("ppa", Task::Forage);
    let codons = [12, 3, 6, 8, 5, 9, 18, 11, 7, 2, 15, 21, 10, 33];
    assert!(close(diversity(&ppa, &codons), 5.5556));
    assert!(close(compiler(&ppa, 10).greatest_diversity(), 13.8889), "25 x 5 / 9");
}

#[test]
fn diversity_falls_with_every_nine_leaves_and_balances_the_full_list() {
    let one = |program: &str| diversity(&format!("<S> ::= Seq[{program}]"), &[0]);
    // Ten leaves of one name: 25 x 1 / (9 x 2).
    assert!(close(one(&"Explore ".repeat(10)), 1.3889));
    assert!(close(one(&"Explore ".repeat(9)), 2.7778));
    let all = "MoveTowards Hub Explore CompositeSingleCarry Food CompositeDrop Food MoveAway Hub NeighbourObjects Food \
               IsDropable Hub IsCarrying Food IsVisitedBefore Sites ";
    assert!(close(one(all), 25.0));
    assert!(close(one(&all.repeat(2)), 25.0), "all equally frequent");
    // One name three times, another twice: two above the smallest count, the second count is 2.
    assert!(close(one(&format!("{all}Explore Explore IsDropable Hub")), 25.0 * (1.0 - 2.0 * 2.0 / 100.0)));
    // With a name that is not on the list the list is not exact: nine names, ten leaves.
    assert!(close(one(&format!("{all}CanMove")), 12.5));
    assert!(close(one(&format!("{all}DummyNode")), 12.5));
}

/// Every text that `rule` derives within `levels` levels below it, terminals counted; empty where there is none.
fn sentences(
    grammar: &Grammar,
    rule: RuleId,
    levels: u32,
    known: &mut Vec<Option<BTreeSet<String>>>,
) -> BTreeSet<String> {
    if levels == 0 {
        return BTreeSet::new();
    }
    let at = usize::from(rule.0) * 64 + levels as usize;
    if let Some(found) = &known[at] {
        return found.clone();
    }
    let mut all = BTreeSet::new();
    for alternative in grammar.alternatives(rule) {
        let mut texts = vec![String::new()];
        for (symbol, _) in grammar.symbols(alternative) {
            let ends: BTreeSet<String> = match symbol {
                Symbol::Terminal(id) => [grammar.terminals()[usize::from(id.0)].clone()].into(),
                Symbol::NonTerminal(inner) => sentences(grammar, *inner, levels - 1, known),
            };
            texts = texts.iter().flat_map(|text| ends.iter().map(move |end| format!("{text}{end}"))).collect();
        }
        all.extend(texts);
    }
    known[at] = Some(all.clone());
    all
}

#[test]
fn the_grammars_have_as_many_programs_as_those_of_the_authors() {
    for (word, task, count) in [
        ("ppa", Task::Forage, 48_160),
        ("ppa", Task::Nest, 48_160),
        ("published", Task::Nest, 82_560),
        ("published", Task::Forage, 157_680),
    ] {
        let grammar = Grammar::parse(&grammar_text(word, task)).expect("a grammar");
        let mut known = vec![None; usize::from(grammar.rule_count()) * 64];
        assert_eq!(sentences(&grammar, RuleId(0), 9, &mut known).len(), count, "{word} {task:?}");
    }
}

#[test]
fn grown_genomes_are_valid_and_about_24_codons_long() {
    let text = grammar_text("published", Task::Forage);
    let mut compiler = compiler(&text, 10);
    let mut rng = stream(Seed::new(4).expect("small"), Purpose::Genesis, 0);
    let (mut genome, mut pending) = (Genome::default(), Vec::new());
    let (mut codons, mut dummies, draws) = (0, 0, 3000);
    for _ in 0..draws {
        assert!(grow(compiler.grammar(), &mut rng, [10, 100], 2000, &mut genome, &mut pending));
        assert!((16..=37).contains(&genome.codons.len()), "{}", genome.codons.len());
        assert!(genome.codons.iter().all(|codon| *codon <= 2000));
        codons += genome.codons.len();
        let derived = swarm_playground::geese::Derived::of(&mut compiler, &genome.codons);
        let derived = serde_json::to_value(derived).expect("it is JSON");
        let program = derived["phenotype"].as_str().expect("every one is valid").to_owned();
        assert_eq!(genome.codons.len(), derived["used"].as_u64().map_or(0, |used| used as usize * 3 / 2));
        assert_eq!(program.matches("Act(").count(), 1, "one action at depth 10");
        dummies += program.matches("DummyNode").count();
    }
    let mean = codons as f64 / f64::from(draws);
    assert!((22.0..26.0).contains(&mean), "{mean}");
    // Half of the starts do nothing at all; five standard errors of 3,000 draws are 0.046.
    assert!((dummies as f64 / f64::from(draws) - 0.5).abs() < 0.046, "{dummies}");
    assert!(!grow(compiler.grammar(), &mut rng, [10, 8], 2000, &mut genome, &mut pending), "no program is that short");
}

/// A swarm of 20 whose only program is given, with the lattice and whatever `change` changes.
fn swarm(program: &str, change: impl Fn(&mut Params)) -> World {
    let mut params = Params {
        agents: 20,
        grammar: format!("<S> ::= {program}"),
        evolution: false,
        diversity: DiversityRule::Names,
        activation: swarm_playground::geese::Activation::Index,
        ..params(FORAGING)
    };
    change(&mut params);
    World::new(&params, Seed::new(3).expect("small")).expect("it builds")
}

fn positions(world: &World) -> Vec<[f64; 2]> {
    let mut frame = Vec::new();
    fill_frame(world, &mut frame);
    let agents = world.params().agents as usize;
    frame[8..8 + agents * 6].chunks(6).map(|agent| [f64::from(agent[0]), f64::from(agent[1])]).collect()
}

#[test]
fn lattice_coordinates_stay_whole_and_steps_are_those_of_the_authors() {
    for preset in [FORAGING, NEST] {
        let mut world = World::new(&params(preset), Seed::new(9).expect("small")).expect("it builds");
        for _ in 0..150 {
            world.step();
            for [x, y] in positions(&world) {
                assert!(x.fract().abs() <= 0.0 && y.fract().abs() <= 0.0 && x.abs() <= 50.0 && y.abs() <= 50.0);
            }
        }
    }
    // Away from the edge: 16 offsets without a load, the 8 neighbours with one.
    let offsets = |program: &str, loaded: bool| {
        let mut world = swarm(program, |params| {
            params.explore_heading = ExploreHeading::Uniform;
            params.start_positions = swarm_playground::geese::StartPositions::Hub;
            if loaded {
                params.site_distance = 4.0;
            }
        });
        let mut seen = BTreeSet::new();
        let mut before = positions(&world);
        for step in 0..25 {
            world.step();
            let now = positions(&world);
            for (old, new) in before.iter().zip(&now) {
                // The first step of the loaded goes to the item, before they have it.
                if step > 10 && new.iter().all(|value| value.abs() < 48.0) {
                    seen.insert([(new[0] - old[0]) as i32, (new[1] - old[1]) as i32]);
                }
            }
            before = now;
        }
        seen
    };
    let free = offsets("Explore", false);
    let squared = |[x, y]: &[i32; 2]| x * x + y * y;
    assert_eq!(free.len(), 16, "{free:?}");
    assert!(free.iter().all(|offset| [2, 4, 5].contains(&squared(offset))));
    // Each first walks to the items, which lie in the cell to the left of the hub.
    let program =
        "Seq[Sel[IsCarrying Food CompositeSingleCarry Food MoveTowards Sites Explore] IsCarrying Food Explore]";
    let loaded = offsets(program, true);
    assert!(loaded.iter().filter(|offset| squared(offset) <= 2 && squared(offset) > 0).count() == 8, "{loaded:?}");
}

#[test]
fn sites_of_the_published_code_lie_at_one_place_whatever_the_seed() {
    let mut at = BTreeSet::new();
    for seed in 0..3 {
        let world = World::new(&params(FORAGING), Seed::new(seed).expect("small")).expect("it builds");
        let layout = serde_json::to_value(swarm_playground::geese::Layout::of(&world)).expect("it is JSON");
        let places = layout["places"].as_array().expect("a list").clone();
        let site = places.iter().find(|place| place["kind"] == "site").expect("there is a site").clone();
        assert_eq!(site["square"], json!([[-30.0, 30.0], [-20.0, 40.0]]));
        at.insert(site.to_string());
    }
    assert_eq!(at.len(), 1);
    let ring =
        World::new(&Params { site_placement: SitePlacement::Ring, ..params(FORAGING) }, Seed::new(1).expect("1"));
    assert!(ring.is_ok());
}

fn root_status(world: &mut World, agent: u32) -> String {
    let detail = Detail::of(world, &Query { agent: Some(agent), ..Query::default() });
    let detail = serde_json::to_value(detail).expect("it is JSON");
    detail["tree"]["nodes"][0]["status"].as_str().expect("a status").to_owned()
}

#[test]
fn postconditions_of_the_published_code_succeed_and_fail_where_it_does() {
    let status = |program: &str, change: &dyn Fn(&mut Params)| {
        let mut world = swarm(program, |params| {
            params.start_positions = swarm_playground::geese::StartPositions::Hub;
            change(params);
        });
        world.step();
        (root_status(&mut world, 0), positions(&world)[0] == [0.0, 0.0])
    };
    let found = |status: &str, stands: bool| (status.to_owned(), stands);
    // In the hub: done without a move, where the paper's reading moves away.
    assert_eq!(status("MoveAway Hub", &|_| {}), found("SUCCESS", true));
    let paper = |params: &mut Params| params.moveaway_postcondition = MoveAwayPostcondition::NotSensed;
    assert_eq!(status("MoveAway Hub", &paper), found("SUCCESS", false));
    assert_eq!(status("CompositeDrop Food", &|_| {}), found("FAILURE", true));
    let paper = |params: &mut Params| params.drop_postcondition = DropPostcondition::NotCarrying;
    assert_eq!(status("CompositeDrop Food", &paper), found("SUCCESS", true));
    // Normal moves do not look ahead; what they do is the same where nothing is.
    assert_eq!(status("MoveTowards Sites Normal", &|_| {}), found("FAILURE", true));
}

#[test]
fn percepts_outlast_a_tick_and_are_shared_when_the_scenario_says_so() {
    // The first robot looks, the others only ask: with shared percepts they know of the food it found.
    let knowing = |wipe, blackboard| {
        let program = "Sel[IsCarryable Food NeighbourObjects Food]";
        let mut world = swarm(program, |params| {
            (params.percept_wipe, params.blackboard) = (wipe, blackboard);
            (params.agents, params.site_distance) = (2, 0.0);
            params.start_positions = swarm_playground::geese::StartPositions::Hub;
        });
        // Which child of the root succeeded says who had to look.
        let mut looked = Vec::new();
        for _ in 0..2 {
            world.step();
            for agent in 0..2 {
                let detail = Detail::of(&mut world, &Query { agent: Some(agent), ..Query::default() });
                let detail = serde_json::to_value(detail).expect("it is JSON");
                looked.push(detail["tree"]["nodes"][1]["status"] == "FAILURE");
            }
        }
        looked
    };
    assert_eq!(knowing(PerceptWipe::Tick, Private), [false; 4], "there IsCarryable looks itself");
    assert_eq!(knowing(PerceptWipe::Sense, Private), [true, true, false, false]);
    assert_eq!(knowing(PerceptWipe::Sense, Shared), [true, false, false, false]);
}

#[test]
fn debris_goes_only_into_the_places_on_the_boundary_and_not_back_into_the_hub() {
    let program = "Seq[Sel[IsCarrying Debris CompositeSingleCarry Debris MoveTowards Hub] IsCarrying Debris \
                   MoveTowards Boundary Normal NeighbourObjects Boundary CompositeDrop Debris]";
    let run = |known_all: bool| {
        let mut world = swarm(program, |params| {
            (params.task, params.nest_sink, params.steps) = (Task::Nest, NestSink::Cells, 5000);
            params.drop_rule = DropRule::OutsideHub;
            params.initial_memory = if known_all {
                swarm_playground::geese::InitialMemory::All
            } else {
                swarm_playground::geese::InitialMemory::FirstBoundary
            };
        });
        let layout = serde_json::to_value(swarm_playground::geese::Layout::of(&world)).expect("it is JSON");
        let places = layout["places"].as_array().expect("a list").clone();
        assert_eq!(places.iter().filter(|place| place["kind"] == "boundary").count(), 6);
        for _ in 0..400 {
            world.step();
        }
        world.outcome()
    };
    let first = run(false);
    assert_eq!((first.delivered, first.items), (20, 20), "one place is enough");
    // All walk to one of six at random each step; the sixth takes what it gets unscored.
    assert!(run(true).delivered <= 20);

    let mut world = swarm("Sel[CompositeDrop Debris CompositeSingleCarry Debris]", |params| {
        (params.task, params.drop_rule) = (Task::Nest, DropRule::OutsideHub);
        params.start_positions = swarm_playground::geese::StartPositions::Hub;
    });
    (0..3).for_each(|_| world.step());
    let mut frame = Vec::new();
    fill_frame(&world, &mut frame);
    assert_eq!(frame[2] as u32, 20, "they hold on to what they took from the hub");
}

#[test]
fn food_drops_anywhere_under_every_rule_but_that_of_the_sink() {
    // So the preset for foraging need not say which of the two it has.
    let fingerprint = |rule| {
        let mut run =
            World::new(&Params { drop_rule: rule, ..params(FORAGING) }, Seed::new(2).expect("2")).expect("ok");
        (0..800).for_each(|_| run.step());
        run.fingerprint()
    };
    assert_eq!(fingerprint(DropRule::Anywhere), fingerprint(DropRule::OutsideHub));
    assert_ne!(fingerprint(DropRule::Anywhere), fingerprint(DropRule::Sink));
}

fn fitness(program: &str, change: impl Fn(&mut Params)) -> f64 {
    let mut world = swarm(program, |params| {
        params.start_positions = swarm_playground::geese::StartPositions::Hub;
        change(params);
    });
    world.step();
    let detail = Detail::of(&mut world, &Query { agent: Some(0), ..Query::default() });
    serde_json::to_value(detail).expect("it is JSON")["agent"]["fitness"].as_f64().expect("a number")
}

#[test]
fn fitness_of_the_published_code_counts_selectors_and_new_cells() {
    // Both selectors succeed; the constraint that fails is none of its business; no second cell was reached.
    let program = "Sel[Con(IsCarrying Food) Seq[Sel[Post(CanMove)] Explore]]";
    assert!(close(fitness(program, |_| {}), 2.0));
    assert!(close(fitness(program, |params| params.bt_feedback = FeedbackRule::Tags), 1.0 - 2.0 + 1.0));
    assert!(close(fitness(program, |params| params.exploration = ExplorationRule::Squares), 3.0));
    // At the start no program went before.
    assert!(close(fitness(program, |params| params.fitness = FitnessRule::Recurrence), 2.0));
}

#[test]
fn a_lonely_robot_breeds_when_it_gets_nowhere() {
    let swaps = |stagnation| {
        let lonely = Params { agents: 1, stagnation, steps: 2000, ..params(FORAGING) };
        let mut world = World::new(&lonely, Seed::new(5).expect("5")).expect("it builds");
        (0..2000).for_each(|_| world.step());
        world.state().history().iter().map(|sample| sample.swaps).sum::<u32>()
    };
    assert_eq!(swaps(0), 0, "its own genome is no second one");
    // Until it has a program that leaves its cell.
    assert!((1..=9).contains(&swaps(200)), "{}", swaps(200));
}

#[test]
fn children_that_are_too_long_are_drawn_again_or_cut() {
    let longest = |length_rule| {
        let short = Params { genome_length: 40, length_rule, ..params(FORAGING) };
        let mut world = World::new(&short, Seed::new(5).expect("5")).expect("it builds");
        (0..200).for_each(|_| world.step());
        let members = Population::of(&world).members;
        let at_limit = members.iter().filter(|member| member.genome.len() == 40).count();
        assert!(members.iter().all(|member| member.genome.len() <= 40));
        at_limit
    };
    let (cut, redrawn) = (longest(LengthRule::Cut), longest(LengthRule::Redraw));
    assert!(cut > redrawn, "cutting gives full lengths more often: {cut} against {redrawn}");
}

#[test]
fn stored_genomes_follow_their_donor_until_it_changes_its_program() {
    // Nobody breeds, so every stored fitness stays its donor's, or stays what it was.
    let stored = |storage_value| {
        let world = Params {
            agents: 12,
            storage_value,
            storage_content: StorageContent::Meetings,
            storage_threshold: 1000,
            stagnation: 0,
            fitness_diversity: true,
            fitness: FitnessRule::Recurrence,
            ..params(FORAGING)
        };
        let mut world = World::new(&world, Seed::new(8).expect("8")).expect("it builds");
        (0..80).for_each(|_| world.step());
        let agent = |world: &mut World, id: u64| {
            let query = Query { agent: Some(id as u32), ..Query::default() };
            serde_json::to_value(Detail::of(world, &query)).expect("it is JSON")["agent"].clone()
        };
        // The last robot's turn comes after all others': what it has stored is as they are now.
        let entries = agent(&mut world, 11)["stored"].as_array().expect("a list").clone();
        assert!(entries.len() > 10, "{}", entries.len());
        let live = |entry: &Value| {
            entry["fitness"] == agent(&mut world.clone(), entry["donor"].as_u64().expect("an id"))["fitness"]
        };
        entries.iter().filter(|entry| live(entry)).count() == entries.len()
    };
    assert!(stored(StorageValue::Live));
    assert!(!stored(StorageValue::Copied));
}

#[test]
fn a_share_of_the_programs_counts_each_program_once() {
    let members: Vec<Value> =
        [(9, 0), (8, 0), (7, 0), (6, 1)].map(|(fitness, codon)| json!({"fitness": fitness, "genome": [codon]})).into();
    let saved = json!({"format": "geese-population/1", "members": members}).to_string();
    let programs = |pool| {
        let mut world = swarm("Explore | CanMove", |params| {
            (params.population_form, params.population_share) = (PopulationForm::Heterogeneous, 1.0);
            (params.population_pool, params.max_depth) = (pool, 10);
            params.population.clone_from(&saved);
        });
        let detail = serde_json::to_value(Detail::of(&mut world, &Query::default())).expect("it is JSON");
        detail["programs"]["top"][0]["agents"].as_u64().expect("a number")
    };
    assert_eq!(programs(PopulationPool::Agents), 15, "three of four");
    assert_eq!(programs(PopulationPool::Programs), 10, "one of two");
}

#[test]
fn the_presets_differ_from_the_paper_in_every_field_they_name_and_run_the_same_twice() {
    let defaults = Scenario::read(r#"{"world": "geese"}"#).expect("valid").to_value();
    for preset in [FORAGING, NEST] {
        let given: Value = serde_json::from_str(preset).expect("it is JSON");
        for (name, value) in given.as_object().expect("an object") {
            assert!(name == "world" || &defaults[name] != value, "{name} is what it is anyway");
        }
        let run = || {
            let mut run = Run::new(Scenario::read(preset).expect("valid")).expect("it builds");
            run.advance(120);
            run.fingerprint()
        };
        assert_eq!(run(), run());
    }
}

#[test]
fn every_mixture_of_the_switches_runs_and_keeps_robots_in_the_arena() {
    let combine = |params: &mut Params, bits: u32| {
        let on = |bit: u32| bits >> bit & 1 == 1;
        params.footprint = if on(0) { Footprint::Cells } else { Footprint::Disc };
        params.sensing = if on(1) { Sensing::Cell } else { Sensing::Disc };
        params.neighbours = if on(2) { Neighbours::Cell } else { Neighbours::Radius };
        params.nest_sink = if on(3) { NestSink::Cells } else { NestSink::Ring };
        params.init = if on(4) { Init::DerivationTree } else { Init::RandomBits };
        params.storage_value = if on(5) { StorageValue::Live } else { StorageValue::Copied };
        params.own_in_pool = on(6);
        (params.obstacles, params.traps) = (bits % 3, bits % 2);
        params.task = if on(7) { Task::Nest } else { Task::Forage };
        params.behaviours = if on(8) { Behaviours::Nominal } else { Behaviours::Ppa };
        params.item_placement = if on(9) { ItemPlacement::Stacked } else { ItemPlacement::Scattered };
    };
    for mixture in 0..64_u32 {
        let bits = mixture.wrapping_mul(0x9E37_79B9) >> 22;
        let mut changed =
            Params { agents: 30, arena_size: 63, site_distance: 15.0, swap_rule: SwapRule::Always, ..params(NEST) };
        combine(&mut changed, bits);
        let mut world = World::new(&changed, Seed::new(u64::from(mixture)).expect("small")).expect("it builds");
        for _ in 0..60 {
            world.step();
            assert!(positions(&world).iter().flatten().all(|value| value.abs() <= 31.0), "{bits:010b}");
        }
    }
    assert!(Name::MoveAway.moves() && !Name::CompositeDrop.moves());
}

#[test]
fn every_choice_of_the_schema_is_written_as_it_was_read() {
    let default = Scenario::read(r#"{"world": "geese"}"#).expect("valid");
    let schema = swarm_playground::scenario::schema();
    let mut checked = 0;
    for entry in schema.as_array().expect("a list").iter().filter(|entry| entry["type"] == "choice") {
        let key = entry["key"].as_str().expect("a key");
        let Some(name) = key.strip_prefix("geese.") else { continue };
        for choice in entry["choices"].as_array().expect("a list") {
            let changed = default.with(key, &choice["value"]).expect("every choice is allowed").to_value();
            assert_eq!(changed[name], choice["value"], "{key}");
            checked += 1;
        }
    }
    assert!(checked > 80, "{checked}");
}
