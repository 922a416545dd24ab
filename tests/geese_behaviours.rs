//! What single behaviours do: swarms whose grammar knows one program, and that never evolve.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::geese::{
    Behaviours, Detail, DropRule, ExploreHeading, Finished, IsDropable, ItemPlacement, Layout, Params, Query, Task,
    World, fill_frame,
};
use swarm_playground::random::Seed;

/// A swarm of 20 with one program.
fn swarm(program: &str, change: impl Fn(&mut Params)) -> World {
    let mut params = Params {
        agents: 20,
        grammar: format!("<S> ::= {program}"),
        explore_heading: ExploreHeading::Turning,
        storage_threshold: 1000,
        steps: 100_000,
        ..Params::default()
    };
    change(&mut params);
    World::new(&params, Seed::new(3).expect("small")).expect("it builds")
}

fn steps(world: &mut World, count: u32) {
    (0..count).for_each(|_| world.step());
}

/// Position and whether it lives, for each agent.
fn agents(world: &World) -> Vec<([f64; 2], bool)> {
    let layout = serde_json::to_value(Layout::of(world)).expect("it is JSON");
    let mut frame = Vec::new();
    fill_frame(world, &mut frame);
    let block = |name: &str| layout["agents"][name].as_u64().expect("a number") as usize;
    let (offset, stride) = (block("offset"), block("stride"));
    let agent = |at: usize| ([f64::from(frame[at]), f64::from(frame[at + 1])], frame[at + 5] > 0.0);
    (0..block("count")).map(|id| agent(offset + id * stride)).collect()
}

/// The places of a kind: centre and radius.
fn places(world: &World, kind: &str) -> Vec<([f64; 2], f64)> {
    let layout = serde_json::to_value(Layout::of(world)).expect("it is JSON");
    let all = layout["places"].as_array().expect("a list").clone();
    let number = |place: &Value, name: &str| place[name].as_f64().expect("a number");
    let of_kind = all.iter().filter(|place| place["kind"] == kind);
    of_kind.map(|place| ([number(place, "x"), number(place, "y")], number(place, "radius"))).collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

fn root_status(world: &mut World) -> String {
    let query = Query { agent: Some(0), ..Query::default() };
    let detail = serde_json::to_value(Detail::of(world, &query)).expect("it is JSON");
    detail["tree"]["nodes"][0]["status"].as_str().expect("a status").to_owned()
}

#[test]
fn debris_is_carried_out_of_the_boundary() {
    let program = "Seq[CompositeSingleCarry Debris MoveTowards Boundary CompositeDrop Debris]";
    for behaviours in [Behaviours::Ppa, Behaviours::Nominal] {
        // Nominal carrying needs to be told that there is something.
        let program = program
            .replace("Seq[", "Seq[Sel[IsCarrying Debris NeighbourObjects Debris] Sel[IsCarrying Debris ")
            .replace(" MoveTowards", "] MoveTowards");
        let mut world = swarm(&program, |params| {
            (params.task, params.drop_rule, params.behaviours) = (Task::Nest, DropRule::Sink, behaviours);
            params.item_placement = ItemPlacement::Stacked;
        });
        assert_eq!(places(&world, "boundary"), [([0.0, 0.0], 30.0)]);
        steps(&mut world, 2000);
        // Everybody walks out with a piece within 15 steps; PPA robots stay where the boundary is sensed.
        let outcome = world.outcome();
        assert_eq!((outcome.delivered, outcome.finished), (20, Some(Finished::AllRemoved)), "{behaviours:?}");
    }
}

#[test]
fn nobody_enters_an_obstacle_and_ppa_behaviours_walk_around_it() {
    for behaviours in [Behaviours::Ppa, Behaviours::Nominal] {
        let mut world = swarm("Explore", |params| (params.obstacles, params.behaviours) = (6, behaviours));
        let obstacles = places(&world, "obstacle");
        assert_eq!(obstacles.len(), 6);
        for _ in 0..600 {
            world.step();
            for (position, _) in agents(&world) {
                let inside = obstacles.iter().find(|(centre, radius)| distance(*centre, position) < radius - 1e-3);
                assert!(inside.is_none(), "{position:?} in {inside:?}");
            }
        }
    }
    // Straight out of the nest: who meets an obstacle gets past it only in PPA form.
    let out = |behaviours| {
        let mut world = swarm("MoveTowards Boundary", |params| {
            (params.task, params.hub_radius, params.obstacles) = (Task::Nest, 3.0, 8);
            (params.obstacle_radius, params.behaviours) = (6.0, behaviours);
        });
        steps(&mut world, 300);
        agents(&world).iter().filter(|(position, _)| distance(*position, [0.0, 0.0]) > 29.9).count()
    };
    let (ppa, nominal) = (out(Behaviours::Ppa), out(Behaviours::Nominal));
    assert!(ppa == 20 && nominal < 20, "{ppa} with PPA, {nominal} without");
}

#[test]
fn traps_kill_and_the_dead_stay_where_they_fell() {
    let deaths = |behaviours| {
        let mut world = swarm("Explore", |params| (params.traps, params.behaviours) = (6, behaviours));
        let mut before = agents(&world);
        for _ in 0..800 {
            world.step();
            let now = agents(&world);
            for ((old, lived), (new, lives)) in before.iter().zip(&now) {
                assert!(*lived || (!lives && distance(*old, *new) <= 0.0), "the dead neither rise nor move");
            }
            before = now;
        }
        before.iter().filter(|(_, lives)| !lives).count()
    };
    let (ppa, nominal) = (deaths(Behaviours::Ppa), deaths(Behaviours::Nominal));
    assert!(nominal >= 10 && ppa * 2 <= nominal, "{ppa} of 20 with PPA, {nominal} without");
}

#[test]
fn a_swarm_that_has_died_out_ends_the_run() {
    let mut world = swarm("Explore", |params| {
        (params.traps, params.behaviours, params.agents, params.items) = (8, Behaviours::Nominal, 2, 5);
    });
    while world.outcome().finished.is_none() {
        world.step();
    }
    assert_eq!(world.outcome().finished, Some(Finished::AllDead));
}

#[test]
fn nominal_carrying_takes_only_what_was_sensed_in_the_same_tick() {
    let carried = |program: &str, behaviours| {
        let mut world = swarm(program, |params| {
            (params.site_distance, params.behaviours) = (0.0, behaviours);
            params.item_placement = ItemPlacement::Stacked;
        });
        world.step();
        let mut frame = Vec::new();
        fill_frame(&world, &mut frame);
        frame[2] as u32
    };
    assert_eq!(carried("CompositeSingleCarry Food", Behaviours::Nominal), 0);
    assert_eq!(carried("Seq[NeighbourObjects Food CompositeSingleCarry Food]", Behaviours::Nominal), 20);
    assert_eq!(carried("CompositeSingleCarry Food", Behaviours::Ppa), 20);
    assert_eq!(carried("CompositeSingleCarry Debris", Behaviours::Ppa), 0, "there is none");
}

#[test]
fn postconditions_make_the_difference_between_ppa_and_nominal() {
    let status = |program: &str, behaviours| {
        let mut world = swarm(program, |params| params.behaviours = behaviours);
        world.step();
        (root_status(&mut world), agents(&world)[0].0 == [0.0, 0.0])
    };
    let (success, failure) = ("SUCCESS".to_owned(), "FAILURE".to_owned());
    // In the hub already: done without a move; a nominal robot moves all the same.
    assert_eq!(status("MoveTowards Hub", Behaviours::Ppa), (success.clone(), true));
    assert_eq!(status("MoveTowards Hub", Behaviours::Nominal), (success.clone(), false));
    // Nothing to drop.
    assert_eq!(status("CompositeDrop Food", Behaviours::Ppa), (success, true));
    assert_eq!(status("CompositeDrop Food", Behaviours::Nominal), (failure, true));
}

#[test]
fn each_fitness_type_counts_only_when_it_is_chosen() {
    let fitness = |chosen: [bool; 5]| {
        let program = "Sel[Con(IsDropable Sites) Seq[Post(NeighbourObjects Food) Act(CompositeSingleCarry Food)]]";
        let mut world = swarm(program, |params| {
            params.site_distance = 0.0;
            params.item_placement = ItemPlacement::Stacked;
            params.is_dropable = IsDropable::Kind;
            [
                params.fitness_diversity,
                params.fitness_exploration,
                params.fitness_prospective,
                params.fitness_task,
                params.fitness_feedback,
            ] = chosen;
        });
        world.step();
        let query = Query { agent: Some(0), ..Query::default() };
        serde_json::to_value(Detail::of(&mut world, &query)).expect("it is JSON")["agent"]["fitness"].clone()
    };
    let only = |which: usize| fitness(std::array::from_fn(|index| index == which));
    assert_eq!(only(0), json!(1.0), "all three names of the grammar");
    assert_eq!(only(1), json!(1.0), "one square");
    assert_eq!(only(2), json!(1.0), "one item carried");
    assert_eq!(only(3), json!(0.0), "nothing delivered");
    // The constraint fails (-2), the postcondition holds (+1), the root selector succeeds (+1).
    assert_eq!(only(4), json!(0.0));
    assert_eq!(fitness([false; 5]), json!(0.0));
    assert_eq!(fitness([true; 5]), json!(3.0));
}

#[test]
fn food_is_shared_out_among_the_sites() {
    let world = swarm("Explore", |params| (params.sites, params.items) = (3, 9));
    let sites = places(&world, "site");
    assert_eq!(sites.len(), 3);
    for (centre, _) in &sites {
        assert!((distance(*centre, [0.0, 0.0]) - 30.0).abs() < 1e-9);
    }
    let mut frame = Vec::new();
    fill_frame(&world, &mut frame);
    let items: Vec<[f64; 2]> =
        frame[frame.len() - 27..].chunks(3).map(|item| [f64::from(item[0]), f64::from(item[1])]).collect();
    for (id, item) in items.iter().enumerate() {
        assert!(distance(*item, sites[id % 3].0) <= 10.0 + 1e-4, "item {id}");
    }
}

#[test]
fn terrain_that_does_not_fit_is_refused() {
    let params = Params { obstacles: 8, obstacle_radius: 20.0, ..Params::default() };
    let (field, message) = World::new(&params, Seed::new(1).expect("small")).expect_err("no room");
    assert_eq!(field, "obstacles");
    assert!(message.starts_with("expected room for 8 of them, found room for "), "{message}");
}
