//! The model by hand, the search on small tasks, error texts, and golden fingerprints.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use std::f64::consts::PI;
use swarm_playground::random::Seed;
use swarm_playground::sequencing::{
    Behaviour, Bounds, Costs, Form, Goal, Kernel, Limit, Meta, Method, Options, Params, Parts, Search, SearchOutcome,
    Shape, Switches, TURN_LIMIT, Task, World, library, replay, robustness,
};

fn parts(start: &[[f64; 3]]) -> Parts {
    Parts {
        bounds: Bounds { left: -50.0, right: 50.0, bottom: -50.0, top: 50.0 },
        obstacles: vec![],
        goal: Goal::Reach { centre: [25.0, 0.0], radius: 6.0 },
        library: library(),
        start: start.to_vec(),
        decisions: 4,
        interval: 10,
    }
}

fn task(start: &[[f64; 3]]) -> Task {
    Task::new(&parts(start)).expect("a valid task")
}

/// Commands of a behaviour at the start of a task.
fn commands(task: &Task, meta: Meta) -> Vec<[f64; 2]> {
    let mut kernel = Kernel::new(task.robots());
    let behaviour = Behaviour { letter: 'Q', name: String::new(), meta };
    kernel.control(&behaviour.law(task.robots()), task.start());
    (0..task.robots()).map(|robot| kernel.command(robot)).collect()
}

fn near(found: [f64; 2], expected: [f64; 2]) {
    assert!(
        (found[0] - expected[0]).abs() < 1e-12 && (found[1] - expected[1]).abs() < 1e-12,
        "{found:?}, {expected:?}"
    );
}

#[test]
fn two_robots_flock_as_by_hand() {
    // 4 m apart, both heading east: repulsion. v_0 = -b/d^2 = (-1/16, 0), so uv = max(-1/16, 1) = 1. The first turns
    // from the other, phi(b, -b_ij) = +-pi, saturated; the second is already turned away: phi = 0.
    let flock = |radii| Meta::Flock { bias: [0.0, 0.0], radii, least: 1.0 };
    let found = commands(&task(&[[0.0, 0.0, 0.0], [4.0, 0.1, 0.0]]), flock([5.0, 10.0, 20.0]));
    assert!((found[0][1].abs() - TURN_LIMIT).abs() < 1e-15 && (found[0][0] - 1.0).abs() < 1e-15);
    // 15 m apart: attraction. v_0 = (15, 0), so uv = 15, saturated; the angle is 0 for the first.
    let far = task(&[[0.0, 0.0, 0.0], [15.0, 0.0, 0.3]]);
    near(commands(&far, flock([5.0, 10.0, 20.0]))[0], [2.0, 0.0]);
    // With a smaller attraction radius nobody is near: forward at the least speed.
    near(commands(&far, flock([5.0, 10.0, 14.9]))[0], [1.0, 0.0]);
    // 8 m apart: alignment. v = 0; the first turns towards the other's heading, 0.3 rad.
    near(commands(&task(&[[0.0, 0.0, 0.0], [8.0, 0.0, 0.3]]), flock([5.0, 10.0, 20.0]))[0], [1.0, 0.3]);
    // A bias north with the heading east: uv = max(q.b, 1) = 1, uw = pi/2, saturated.
    let north = Meta::Flock { bias: [0.0, 1.0], radii: [5.0, 10.0, 20.0], least: 1.0 };
    near(commands(&task(&[[0.0, 0.0, 0.0]]), north)[0], [1.0, TURN_LIMIT]);
}

#[test]
fn consensus_and_lines_as_by_hand() {
    let pair = task(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.1]]);
    // pdot_0 = Kp (0, 1): uv = b.pdot = 0, uw = pi/2, saturated; with Kp = -1 the other way.
    near(commands(&pair, Meta::Consensus(1.0))[0], [0.0, TURN_LIMIT]);
    near(commands(&pair, Meta::Consensus(-1.0))[0], [0.0, -TURN_LIMIT]);
    // Row of 2 m along x: pdot_0 = (0, 1) - (2, 0) = (-2, 1): uv = -2, in reverse.
    near(commands(&pair, Meta::Formation(Shape::Row([2.0, 0.0])))[0], [-2.0, TURN_LIMIT]);
    // Any formation: where they stand already is where they stay.
    near(commands(&pair, Meta::Formation(Shape::Points(vec![[7.0, 7.0], [7.0, 8.0]])))[0], [0.0, 0.0]);
    // Robots on one point have nowhere to go, exactly.
    let heap = task(&[[0.1, 0.7, 0.3]; 5]);
    assert!(commands(&heap, Meta::Consensus(1.0)).iter().all(|command| *command == [0.0, 0.0]));
}

#[test]
fn one_step_is_an_arc_with_the_heading_of_its_middle() {
    let task = task(&[[0.0, 0.0, 0.0]]);
    let north = task.sequence("N").expect("known")[0];
    let mut state = task.start().to_vec();
    let mut kernel = Kernel::new(1);
    kernel.start();
    task.step(north, &mut state, &mut [], &mut kernel).expect("free");
    // uv = 1, uw = pi/8: half a step turns by pi/160.
    assert!((state[0] - 0.1 * libm::cos(PI / 160.0)).abs() < 1e-15);
    assert!((state[1] - 0.1 * libm::sin(PI / 160.0)).abs() < 1e-15);
    assert!((state[2] - PI / 80.0).abs() < 1e-15);
    assert!((kernel.lengths()[0] - 0.1).abs() < 1e-15);
}

#[test]
fn stop_changes_no_bit_and_costs_nothing() {
    let task = task(&[[-0.0, 1.0, 700.0], [3.0, 2.0, -5.0]]);
    let stop = task.stop().expect("the library has one");
    let mut state = task.start().to_vec();
    let acted = task.act(stop, &mut state, &mut [], &mut Kernel::new(2)).expect("nothing is hit");
    assert_eq!((acted.0.to_bits(), acted.1), (0, 0));
    let bits = |state: &[f64]| state.iter().map(|real| real.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&state), bits(task.start()));
}

/// A single robot heading east, 25 m west of the target's middle: E goes 10 m an interval.
fn straight(decisions: u16) -> Task {
    // Behaviours that let a single robot stand are Stops by another name.
    let library = library().into_iter().filter(|behaviour| "FENWS.".contains(behaviour.letter)).collect();
    Task::new(&Parts { decisions, library, ..parts(&[[0.0, 0.0, 0.0]]) }).expect("valid")
}

fn search(task: &Task, options: Options) -> Search {
    let mut search = Search::new(task, options, &[]).expect("no prefix");
    search.advance(u64::MAX);
    search
}

#[test]
fn the_straight_way_is_the_plan_and_padding_is_stops() {
    let task = straight(4);
    let found = search(&task, Options { weight: 1.0, ..Options::default() });
    let plan = found.best().expect("there is one");
    // 25 - 6 = 19 m are missing: two intervals. Flock without a bias goes straight on as well, and is tried first.
    assert_eq!(task.letters(&plan.sequence), "FF..");
    assert!((plan.cost - 20.0).abs() < 1e-9);
    assert_eq!(found.progress().outcome, Some(SearchOutcome::Solved));
    assert_eq!(found.proven_ratio(), Some(1.0));
}

#[test]
fn a_library_without_stop_must_be_in_the_goal_at_the_end() {
    let without = library().into_iter().filter(|behaviour| !behaviour.is_stop()).collect();
    let base = Parts { library: without, decisions: 2, ..parts(&[[0.0, 0.0, 0.0]]) };
    let solved = search(&Task::new(&base).expect("valid"), Options { weight: 1.0, ..Options::default() });
    assert_eq!(solved.progress().outcome, Some(SearchOutcome::Solved));
    // With five intervals the robot has to stay busy: only behaviours that let a single robot stand can wait.
    let longer = Task::new(&Parts { decisions: 5, ..base }).expect("valid");
    let found = search(&longer, Options { weight: 1.0, ..Options::default() });
    let plan = found.best().expect("rendezvous of one robot stands still");
    assert_eq!(plan.sequence.len(), 5);
    assert!((plan.cost - 20.0).abs() < 1e-9);
    assert!(replay(&longer, &plan.sequence, longer.start(), &mut Kernel::new(1)).is_feasible());
}

#[test]
fn outcomes_are_kept_apart() {
    // Out of reach: 4 intervals of 20 m at most, 120 m to go. Nothing needs to be simulated to know it.
    let far = Parts { goal: Goal::Reach { centre: [45.0, 45.0], radius: 1.0 }, ..parts(&[[-45.0, -45.0, 0.0]]) };
    let far = search(&Task::new(&far).expect("valid"), Options::default());
    assert_eq!(far.progress().outcome, Some(SearchOutcome::Infeasible));
    assert_eq!(far.progress().counts.integrated, 0);
    // Walled in: found out by trying everything.
    let wall = Form::Box([18.0, -50.0, 18.5, 49.9]);
    let walled = Task::new(&Parts { obstacles: vec![wall], ..parts(&[[0.0, 0.0, 0.0]]) }).expect("valid");
    let all = search(&walled, Options::default());
    assert_eq!(all.progress().outcome, Some(SearchOutcome::Infeasible));
    assert!(all.progress().counts.collided > 0);
    // The same with too few integrations proves nothing, and says how far it came.
    let some = search(&walled, Options { integrations: 20, ..Options::default() });
    assert_eq!(some.progress().outcome, Some(SearchOutcome::GaveUp(Limit::Integrations)));
    assert!(some.lower_bound().is_some_and(|bound| bound.is_finite() && bound >= 19.0 - 1e-9));
    let rounded = search(&walled, Options { method: Method::Approximate(1.0), ..Options::default() });
    assert_eq!(rounded.progress().outcome, Some(SearchOutcome::GaveUp(Limit::Rounding)));
    assert_eq!(rounded.lower_bound(), None);
    // Already there: nothing to do.
    let there = Task::new(&parts(&[[24.0, 0.0, 0.0]])).expect("valid");
    let there = search(&there, Options::default());
    assert_eq!(there.best().map(|plan| (there.task().letters(&plan.sequence), plan.cost)), Some(("....".into(), 0.0)));
    assert_eq!(there.proven_ratio(), Some(1.0));
    // Given more afterwards, it is the search that had as much from the start.
    let mut on = some.clone();
    on.extend(100_000, 0);
    on.advance(u64::MAX);
    assert_eq!(on.progress(), all.progress());
    let mut ended = all.clone();
    ended.extend(100_000, 0);
    assert_eq!(ended.progress().outcome, Some(SearchOutcome::Infeasible));
    let mut cancelled = Search::new(&walled, Options::default(), &[]).expect("no prefix");
    cancelled.advance(7);
    cancelled.cancel();
    assert_eq!(cancelled.advance(100).outcome, Some(SearchOutcome::Cancelled));
    assert_eq!(cancelled.progress().counts.integrated, 7);
}

#[test]
fn slices_of_any_size_give_the_same_search() {
    let task = Params::default().tasks(seed(3)).expect("there is room").0;
    for options in [
        Options { weight: 2.0, batch: 4, ..Options::default() },
        Options { weight: 3.0, eager: true, ..Options::default() },
        Options { method: Method::BothSides, weight: 1.25, batch: 8, forecast: 4, ..Options::default() },
    ] {
        let options = Options { integrations: 300, ..options };
        let whole = search(&task, options);
        let mut sliced = Search::new(&task, options, &[]).expect("no prefix");
        while sliced.advance(7).outcome.is_none() {}
        assert_eq!(whole.progress(), sliced.progress());
        assert_eq!(whole.best(), sliced.best());
        // As several workers would: the last slot first.
        let mut backwards = Search::new(&task, options, &[]).expect("no prefix");
        while backwards
            .advance_with(1, &mut |task, slots| slots.iter_mut().rev().for_each(|slot| slot.integrate(task)))
            .outcome
            .is_none()
        {}
        assert_eq!(whole.progress(), backwards.progress());
        assert_eq!(whole.best(), backwards.best());
    }
}

/// As in the browser, where the slots of a batch are worked off one after another.
#[cfg(feature = "cli")]
#[test]
fn any_number_of_threads_gives_the_same_search() {
    let task = Params::default().tasks(seed(4)).expect("there is room").0;
    let both = Options { method: Method::BothSides, weight: 1.25, geodesic: true, ..Options::default() };
    for options in [Options { batch: 8, ..both }, Options { batch: 16, weight: 2.0, ..Options::default() }] {
        let options = Options { integrations: 400, ..options };
        let alone = search(&task, options);
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let mut together = Search::new(&task, options, &[]).expect("no prefix");
            while pool.install(|| together.advance_on_threads(20)).outcome.is_none() {}
            assert_eq!(alone.progress(), together.progress(), "{threads} threads");
            assert_eq!(alone.best(), together.best());
            assert_eq!(alone.lower_bound(), together.lower_bound());
        }
    }
}

#[test]
fn from_both_sides_a_ratio_is_proven_that_one_side_does_not_reach() {
    // Layout 10 of the navigation scenario; the numbers of integrations are those of docs/search-from-both-sides.md.
    let task = Params::default().tasks(seed(10)).expect("there is room").0;
    let base = Options { weight: 1.25, integrations: 200, ..Options::default() };
    let one = search(&task, Options { method: Method::Anytime, ..base });
    assert!(one.proven_ratio().is_some_and(|ratio| ratio > 1.3));
    let both = search(&task, Options { method: Method::BothSides, geodesic: true, batch: 8, ..base });
    assert_eq!(both.progress().outcome, Some(SearchOutcome::Solved));
    assert!(both.proven_ratio().is_some_and(|ratio| ratio <= 1.25));
    assert_eq!(both.progress().counts.integrated, 80);
}

#[test]
fn a_forecast_saves_integrations_in_coverage() {
    let changes = json!({"task": "cover", "map": [0, 100, 0, 100], "start-area": [20, 80, 20, 80], "obstacles": 1,
        "obstacle-area": [10, 90, 10, 90], "clear-of-start": 0, "weight": 5});
    let params = changed(&changes);
    let mut integrated = [0, 0];
    for layout in 1..=10 {
        let task = params.tasks(seed(layout)).expect("there is room").1;
        for (sum, forecast) in integrated.iter_mut().zip([0, 4]) {
            let found = search(&task, Options { forecast, ..params.options() });
            assert_eq!(found.progress().outcome, Some(SearchOutcome::Solved));
            *sum += found.progress().counts.integrated;
        }
    }
    // Ten layouts together; 130 each are wanted.
    assert_eq!(integrated, [1403, 528]);
}

#[test]
fn a_fixed_beginning_is_part_of_the_plan_and_its_cost() {
    let task = straight(5);
    let prefix = task.sequence("N").expect("known");
    let mut search = Search::new(&task, Options { weight: 1.0, ..Options::default() }, &prefix).expect("free");
    search.advance(u64::MAX);
    let plan = search.best().expect("there is one");
    assert_eq!(plan.sequence[0], prefix[0]);
    let done = replay(&task, &plan.sequence, task.start(), &mut Kernel::new(1));
    assert!(done.is_feasible() && (done.cost() - plan.cost).abs() < 1e-9);
    assert!(search.proven_ratio() == Some(1.0) && plan.cost > 20.0);
}

#[test]
fn a_stop_that_resets_switches_is_searched_as_a_behaviour() {
    // Switching costs 100 between behaviours and nothing through a Stop. F is taken out, so that a turn is needed.
    let task = Parts {
        goal: Goal::Reach { centre: [14.0, 14.0], radius: 6.0 },
        library: library().into_iter().filter(|behaviour| "EN.".contains(behaviour.letter)).collect(),
        ..parts(&[[0.0, 0.0, 0.0]])
    };
    let task = Task::new(&task).expect("valid");
    let switches = Switches::Charged { between: 100.0, into_stop: 0.0, out_of_stop: 0.0, first: false };
    let options =
        |method| Options { method, weight: 1.0, costs: Costs { per_second: 0.0, switches }, ..Options::default() };
    let found = search(&task, options(Method::Exact));
    assert!(!found.stop_last());
    let literal = search(&task, options(Method::Literal));
    let (found, literal) = (found.best().expect("solved"), literal.best().expect("solved"));
    assert!((found.cost - literal.cost).abs() < 1e-9 && found.cost < 100.0, "{found:?}");
    assert!(task.letters(&found.sequence).contains(".N") || task.letters(&found.sequence).contains(".E"));
}

#[test]
fn a_plan_is_tried_from_moved_starts() {
    let task = straight(4);
    let plan = task.sequence("EE..").expect("known");
    let seed = Seed::new(1).expect("small");
    let found = robustness(&task, &plan, 0.5, 20, seed);
    assert_eq!((found.runs, found.feasible), (20, 20), "a metre is to spare");
    assert!((found.mean_cost - 20.0).abs() < 1e-9);
    // Moved by 3 m, about a third of the starts are more than 1 m farther away.
    let found = robustness(&task, &plan, 3.0, 200, seed);
    assert!((100..180).contains(&found.feasible), "{found:?}");
}

#[test]
fn what_is_no_task_is_refused_with_its_reason() {
    let refused = |parts: &Parts| Task::new(parts).expect_err("it is refused").to_string();
    let one = [[0.0, 0.0, 0.0]];
    assert_eq!(refused(&parts(&[])), "robots: expected at least one robot, found none");
    assert_eq!(refused(&parts(&[[60.0, 0.0, 0.0]])), "start: robot 1 at (60, 0): expected a place on the map");
    assert_eq!(refused(&parts(&[[50.0, 0.0, 0.0]])), "start: robot 1 at (50, 0): expected a place on the map");
    assert_eq!(
        refused(&Parts { obstacles: vec![Form::Disc([1.0, 0.0, 1.0])], ..parts(&one) }),
        "start: robot 1 at (0, 0): expected a free place, found obstacle 1"
    );
    assert_eq!(refused(&Parts { library: vec![], ..parts(&one) }), "library: expected 1 to 64 behaviours, found 0");
    assert_eq!(
        refused(&Parts { obstacles: vec![Form::Polygon(vec![[0.0, 0.0], [1.0, 1.0]])], ..parts(&one) }),
        "obstacles: obstacle 1: expected at least 3 corners, found 2"
    );
}

fn seed(value: u64) -> Seed {
    Seed::new(value).expect("small")
}

fn changed(changes: &Value) -> Params {
    let mut params = Params::default();
    for (name, value) in changes.as_object().expect("an object") {
        assert!(params.set(name, value), "{name}");
    }
    params
}

#[test]
fn lists_are_refused_item_by_item() {
    let refused = |changes: Value| {
        let (field, message) = changed(&changes).check().expect_err("it is refused");
        format!("{field}: {message}")
    };
    assert_eq!(
        refused(json!({"obstacle-list": [{"disc": [0, 0, 1]}, {"ring": [0, 0, 1]}]})),
        "obstacle-list: item 2: expected {\"disc\": [x, y, radius]}, {\"box\": [left, bottom, right, top]} or \
         {\"polygon\": [[x, y], ...]}, found {\"ring\":[0,0,1]}"
    );
    assert_eq!(
        refused(json!({"obstacle-list": [{"disc": [0, 0, -1]}]})),
        "obstacle-list: item 1: expected a radius of at least 0 m, found -1"
    );
    assert_eq!(refused(json!({"start-list": [[0, 0]]})), "start-list: item 1: expected [x, y, heading], found [0,0]");
    assert_eq!(
        refused(json!({"map": [0, 0, 1, 2]})),
        "map: expected [left, right, bottom, top] with an inside, found [0,0,1,2]"
    );
    assert_eq!(refused(json!({"library": "FQ"})), "library: expected letters of \"FENWS.RAXY\", found 'Q'");
    assert_eq!(refused(json!({"library": ""})), "library: expected 1 to 64 behaviours, found 0");
    assert_eq!(refused(json!({"library": "EE"})), "library: expected a letter for each behaviour, found 'E' twice");
    assert_eq!(
        refused(json!({"own-behaviours": [{"letter": "Z", "consensus": 0}]})),
        "own-behaviours: expected at most one behaviour that stops, found '.' and 'Z'"
    );
    assert_eq!(
        refused(json!({"own-behaviours": [{"letter": "Z"}]})),
        "own-behaviours: item 1: expected exactly one of flock, consensus, row, points"
    );
    assert_eq!(refused(json!({"prefix": "EQ"})), "prefix: expected letters of the library, found 'Q'");
    assert_eq!(
        refused(json!({"task": "cover", "cell-size": 0.01})).split(',').next(),
        Some("cell-size: expected at most 1048576 cells on the map")
    );
    assert!(
        changed(&json!({"own-behaviours": [
            {"letter": "Z", "name": "North-east", "flock": {"bias": [0.7, 0.7], "least-speed": 0.5}},
            {"letter": "V", "points": [[0, 0], [1, 2], [2, 4]]},
        ]}))
        .check()
        .is_ok()
    );
}

#[test]
fn scenarios_that_cannot_be_built_say_why() {
    let refused = |changes: Value| {
        let (field, message) = World::new(&changed(&changes), seed(1)).expect_err("it is refused");
        format!("{field}: {message}")
    };
    assert_eq!(
        refused(json!({"obstacles": 0, "obstacle-list": [{"disc": [-38, -38, 30]}]})),
        "start-area: expected room for 20 robots, found it for 0"
    );
    assert_eq!(
        refused(json!({"start-list": [[0, 99, 0]]})),
        "start-list: robot 1 at (0, 99): expected a place on the map"
    );
    assert_eq!(
        refused(json!({"target-margin": 12})),
        "target-margin: expected a margin below the radius 12 m, found 12 m"
    );
    let collides = refused(json!({"prefix": "WWWW", "jitter-runs": 0}));
    assert!(collides.starts_with("prefix: expected a beginning without collisions; in interval "), "{collides}");
    assert!(collides.contains("hits the edge of the map after "), "{collides}");
}

/// Fingerprint of a world some ticks on.
fn fingerprint(changes: &Value, number: u64, ticks: u32) -> String {
    let mut world = World::new(&changed(changes), seed(number)).expect("it can be built");
    for _ in 0..ticks {
        world.step();
    }
    format!("{:016x}", world.fingerprint())
}

#[test]
fn golden_fingerprints_are_reached_natively_and_in_wasm() {
    let golden: Value = serde_json::from_str(include_str!("cases/sequencing_golden.json")).expect("the file is JSON");
    let cases = golden["cases"].as_array().expect("cases");
    let found: Vec<String> = (cases.iter())
        .map(|case| {
            let [seed, tick] = [&case["seed"], &case["tick"]].map(|value| value.as_u64().expect("a number"));
            fingerprint(&case["parameters"], seed, tick as u32)
        })
        .collect();
    let expected: Vec<&str> = cases.iter().map(|case| case["fingerprint"].as_str().expect("a text")).collect();
    assert_eq!(found, expected);
}

/// Algorithm 1 on thousands of sequences is for machines' own code.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_presets_of_the_figures_show_plans_of_the_papers_kind() {
    use swarm_playground::scenario::{Scenario, WorldParams};
    let plan = |text: &str| {
        let scenario = Scenario::read(text).expect("presets are valid");
        let WorldParams::Sequencing(params) = scenario.world else { panic!("a world of sequencing") };
        let params = Params { jitter_runs: 0, ..params };
        World::new(&params, scenario.seed).expect("it builds").solution().plan.clone().expect("it has a plan")
    };
    // The paper: NNNEEENENEN...R, which has north and east in turns, idle Stops and a rendezvous at the end.
    assert_eq!(plan(include_str!("../scenarios/plan-figure-1.json")), "ENENEENNEN....R");
    // The paper: WNSAXR...SSEXFW, with eight behaviours, idle Stops and more after them.
    assert_eq!(plan(include_str!("../scenarios/plan-figure-2.json")), "AYNEEEWSSX....S");
}
