//! Laws of the search on small random tasks, against lists of all sequences.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use swarm_playground::sequencing::{
    Bounds, Cells, Costs, Form, Goal, Kernel, Method, Options, Parts, Search, SearchOutcome, Switches, Task, library,
    replay,
};

fn pose() -> impl Strategy<Value = [f64; 3]> {
    (-16.0..-10.0, -16.0..-10.0, -3.0..3.0).prop_map(|(x, y, heading)| [x, y, heading])
}

fn form() -> impl Strategy<Value = Form> {
    let disc = (-6.0..6.0, -6.0..6.0, 0.5..3.0).prop_map(|(x, y, radius)| Form::Disc([x, y, radius]));
    let square = (-6.0..6.0, -6.0..6.0, 0.5..3.0, 0.5..3.0)
        .prop_map(|(x, y, a, b): (f64, f64, f64, f64)| Form::Box([x - a, y - b, x + a, y + b]));
    let triangle = (-6.0..6.0, -6.0..6.0, 1.0..4.0)
        .prop_map(|(x, y, a): (f64, f64, f64)| Form::Polygon(vec![[x, y], [x + a, y], [x, y + a]]));
    prop_oneof![disc, square, triangle]
}

fn goal() -> impl Strategy<Value = Goal> {
    let reach = (-6.0..6.0, -6.0..6.0, 4.0..8.0).prop_map(|(x, y, radius)| Goal::Reach { centre: [x, y], radius });
    let cover = (0.01..0.06).prop_map(|ratio| {
        let cells = Cells { origin: [-20.0, -20.0], side: 1.0, columns: 40, rows: 40 };
        Goal::Cover { cells, ratio }
    });
    prop_oneof![3 => reach, 1 => cover]
}

/// Tasks of up to three robots and three intervals.
fn tasks() -> impl Strategy<Value = Task> {
    let parts = (prop::collection::vec(pose(), 1..4), prop::collection::vec(form(), 0..3), goal());
    parts.prop_filter_map("a robot starts in an obstacle", |(start, obstacles, goal)| {
        let bounds = Bounds { left: -20.0, right: 20.0, bottom: -20.0, top: 20.0 };
        Task::new(&Parts { bounds, obstacles, goal, library: library(), start, decisions: 3, interval: 10 }).ok()
    })
}

fn costs() -> impl Strategy<Value = Costs> {
    let charge = || prop_oneof![Just(0.0), 1.0..20.0];
    let switches = prop_oneof![
        2 => Just(Switches::Free),
        1 => charge().prop_map(Switches::Transparent),
        2 => (charge(), charge(), charge(), any::<bool>()).prop_map(|(between, into_stop, out_of_stop, first)| {
            Switches::Charged { between, into_stop, out_of_stop, first }
        }),
    ];
    (prop_oneof![Just(0.0), 0.1..2.0], switches).prop_map(|(per_second, switches)| Costs { per_second, switches })
}

/// The least total of all sequences; infinite when none is feasible.
fn least(task: &Task, costs: &Costs) -> f64 {
    let mut kernel = Kernel::new(task.robots());
    let count = task.library().len() as u8;
    let mut least = f64::INFINITY;
    for number in 0..u32::from(count).pow(3) {
        let digit = |place: u32| (number / u32::from(count).pow(place) % u32::from(count)) as u8;
        let sequence = [digit(2), digit(1), digit(0)];
        let done = replay(task, &sequence, task.start(), &mut kernel);
        if done.is_feasible() {
            least = least.min(done.cost() + costs.of(&sequence, task.stop(), task.interval()));
        }
    }
    least
}

fn solve(task: &Task, options: Options) -> Search {
    let mut search = Search::new(task, options, &[]).expect("no prefix");
    search.advance(u64::MAX);
    search
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn every_method_keeps_its_promise(task in tasks(), costs in costs(), weight in 1.0..4.0_f64, batch in 1..9_u32) {
        let least = least(&task, &costs);
        let base = Options { weight, costs, ..Options::default() };
        let (anchor, second) = (weight.sqrt(), weight.sqrt());
        for options in [
            base,
            Options { eager: true, ..base },
            Options { batch, ..base },
            Options { geodesic: true, ..base },
            Options { forecast: 4, ..base },
            Options { method: Method::Literal, ..base },
            Options { method: Method::Anytime, ..base },
            Options { method: Method::BothSides, ..base },
            Options { method: Method::BothSides, geodesic: true, forecast: 3, batch, ..base },
            Options { method: Method::BothSides, weight: 1.0, ..base },
            Options { method: Method::MultiHeuristic { anchor, second }, ..base },
            Options { weight: 1.0, ..base },
        ] {
            let search = solve(&task, options);
            let Some(plan) = search.best() else {
                prop_assert_eq!(search.progress().outcome, Some(SearchOutcome::Infeasible));
                prop_assert!(least.is_infinite(), "{:?}: {}", options, least);
                continue;
            };
            prop_assert_eq!(search.progress().outcome, Some(SearchOutcome::Solved));
            let done = replay(&task, &plan.sequence, task.start(), &mut Kernel::new(task.robots()));
            prop_assert!(done.is_feasible(), "{:?}", options);
            let total = done.cost() + costs.of(&plan.sequence, task.stop(), task.interval());
            prop_assert!((total - plan.cost).abs() < 1e-9, "{:?}: {} said, {} paid", options, plan.cost, total);
            prop_assert!(plan.cost <= options.weight * least + 1e-9, "{:?}: {} of {}", options, plan.cost, least);
            let bound = search.lower_bound().expect("all of these prove something");
            prop_assert!(bound <= least + 1e-9, "{:?}: bound {} of {}", options, bound, least);
            prop_assert!(plan.cost <= options.weight * bound + 1e-6, "{:?}: {} over {}", options, plan.cost, bound);
        }
    }

    #[test]
    fn a_search_that_is_stopped_anywhere_has_a_valid_bound(task in tasks(), costs in costs(), after in 0..60_u64) {
        let least = least(&task, &costs);
        for method in [Method::Exact, Method::Literal, Method::Anytime, Method::BothSides] {
            let mut search = Search::new(&task, Options { method, costs, ..Options::default() }, &[]).expect("no prefix");
            search.advance(after);
            let bound = search.lower_bound().expect("it proves something");
            prop_assert!(bound <= least + 1e-9, "{:?}: bound {} of {}", method, bound, least);
        }
    }
}
