//! Cases of the planner: small searches listed completely, and plans of full size.

use super::super::costs::{Costs, Switches};
use super::super::dynamics::Kernel;
use super::super::parts::Goal;
use super::super::replay::{Replay, replay};
use super::super::search::{Method, Options, Outcome, Search};
use super::super::tasks::Task;
use super::{Grid, PLANS, Poses, World, goal, near, near_all, same, task};
use serde::Deserialize;

/// A small search with all its solutions.
#[derive(Clone, Debug, Deserialize)]
pub struct SearchCase {
    pub name: String,
    intervals: usize,
    integrator: String,
    world: World,
    start: Poses,
    target: Option<[f64; 3]>,
    grid: Option<Grid>,
    result: String,
    feasible_count: usize,
    feasible: Vec<(String, f64)>,
    optimal_cost: Option<f64>,
    #[serde(default)]
    optimal_sequences: Vec<String>,
    optimal_stop_last: Option<String>,
    next_best_cost: Option<f64>,
    interval_costs: Option<Vec<f64>>,
    #[serde(rename = "final")]
    end: Option<Poses>,
    visited_at_start: Option<u32>,
    visited_end: Option<u32>,
    #[serde(default)]
    optional_costs: Vec<OptionalCost>,
    integrations_in_full_tree: u64,
    literal_w1: Expanded,
    literal_w2: Expanded,
    stop_last_w1: Expanded,
    stop_last_w2: Expanded,
}

#[derive(Clone, Debug, Deserialize)]
struct OptionalCost {
    switch_rule: String,
    switch_cost: f64,
    time_cost_per_s: f64,
    optimal_total: f64,
    optimal_sequences: Vec<String>,
}

#[derive(Clone, Debug, Deserialize)]
struct Expanded {
    cost: Option<f64>,
    expanded: u64,
}

/// A plan of full size.
#[derive(Clone, Debug, Deserialize)]
pub struct FullCase {
    pub name: String,
    intervals: usize,
    world: World,
    start: Poses,
    target: Option<[f64; 3]>,
    grid: Option<Grid>,
    stop_last_run: StopLastRun,
    plans: Vec<KnownPlan>,
    best_known_cost: f64,
}

#[derive(Clone, Debug, Deserialize)]
struct StopLastRun {
    w: f64,
    cost: f64,
    lower_bound: f64,
}

#[derive(Clone, Debug, Deserialize)]
struct KnownPlan {
    sequence: String,
    cost: f64,
    interval_costs: Option<Vec<f64>>,
    #[serde(rename = "final")]
    end: Option<Poses>,
    visited_end: Option<u32>,
}

/// Costs nearer than this are of plans that differ in where their Stops stand.
const TIE: f64 = 1e-6;
/// No search of a case may take more; the greatest in the shared file takes some ten thousand.
const MOST_INTEGRATIONS: u64 = 2_000_000;

/// Every sequence of a task, in the library's order.
struct Tree<'a> {
    task: &'a Task,
    kernel: Kernel,
    feasible: Vec<(Vec<u8>, f64)>,
    integrations: u64,
}

impl Tree<'_> {
    fn grow(&mut self, sequence: &mut Vec<u8>, state: &[f64], marks: &[u64], visited: u32, cost: f64) {
        if sequence.len() == usize::from(self.task.decisions()) {
            if self.task.is_goal(state, visited) {
                self.feasible.push((sequence.clone(), cost));
            }
            return;
        }
        for next in 0..self.task.library().len() as u8 {
            self.integrations += 1;
            let (mut state, mut marks) = (state.to_vec(), marks.to_vec());
            if let Ok((path, new)) = self.task.act(next, &mut state, &mut marks, &mut self.kernel) {
                sequence.push(next);
                self.grow(sequence, &state, &marks, visited + new, cost + path);
                sequence.pop();
            }
        }
    }
}

fn costs(rule: &str, switch: f64, per_second: f64) -> Result<Costs, String> {
    let switches = match rule {
        "none" => Switches::Free,
        "stop_transparent" => Switches::Transparent(switch),
        "every_change" => Switches::Charged { between: switch, into_stop: switch, out_of_stop: switch, first: false },
        other => {
            return Err(format!("switch_rule: expected none, every_change or stop_transparent, found {other:?}"));
        }
    };
    Ok(Costs { per_second, switches })
}

/// Searches to the end.
fn solve(task: &Task, options: Options) -> Result<Search, String> {
    let options = Options { integrations: MOST_INTEGRATIONS, nodes: u32::MAX, ..options };
    let mut search = Search::new(task, options, &[]).map_err(|_| "a search without a prefix begins".to_owned())?;
    match search.advance(u64::MAX).outcome {
        Some(Outcome::Solved | Outcome::Infeasible) => Ok(search),
        other => Err(format!("expected an end of the search, found {other:?}")),
    }
}

/// Checks a plan by carrying it out: it is feasible and costs what it is said to cost.
fn check_plan(what: &str, task: &Task, search: &Search) -> Result<Option<f64>, String> {
    let Some(plan) = search.best() else { return Ok(None) };
    let done = carry_out(what, task, &plan.sequence)?;
    let total = done.cost() + search.options().costs.of(&plan.sequence, task.stop(), task.interval());
    near(&format!("{what}, carried out"), plan.cost, total, 1e-9 * total.max(1.0))?;
    Ok(Some(plan.cost))
}

fn carry_out(what: &str, task: &Task, sequence: &[u8]) -> Result<Replay, String> {
    let done = replay(task, sequence, task.start(), &mut Kernel::new(task.robots()));
    match (&done.collision, done.goal) {
        (Some((interval, collision)), _) => {
            Err(format!("{what}: expected no collision, found {collision:?} in interval {}", interval + 1))
        }
        (None, false) => Err(format!("{what}: expected the goal at the end, found another state")),
        (None, true) => Ok(done),
    }
}

impl SearchCase {
    pub fn run(&self) -> Result<(), String> {
        same("integrator", &"zoh_midheading", &self.integrator.as_str())?;
        let goal = goal(self.target, self.grid, &self.world)?;
        let task = task(Some(&self.world), goal, &self.start, self.intervals)?;
        if self.intervals > 6 {
            return Err(format!("intervals: expected at most 6 for a complete list, found {}", self.intervals));
        }
        let feasible = self.check_list(&task)?;
        self.check_optimum(&task, &feasible)?;
        for (name, literal, weight, expected) in [
            ("literal_w1", true, 1.0, &self.literal_w1),
            ("literal_w2", true, 2.0, &self.literal_w2),
            ("stop_last_w1", false, 1.0, &self.stop_last_w1),
            ("stop_last_w2", false, 2.0, &self.stop_last_w2),
        ] {
            let method = if literal { Method::Literal } else { Method::Exact };
            let search = solve(&task, Options { method, weight, eager: true, ..Options::default() })?;
            check_cost(name, &task, &search, expected.cost)?;
            same(&format!("{name}.expanded"), &expected.expanded, &search.progress().counts.expanded)?;
        }
        for options in exact_variants() {
            let search = solve(&task, options)?;
            check_cost(&format!("{options:?}"), &task, &search, self.optimal_cost)?;
        }
        self.optional_costs.iter().try_for_each(|case| case.check(&task, &feasible))
    }

    /// Lists every sequence; returns the feasible ones with their costs.
    fn check_list(&self, task: &Task) -> Result<Vec<(Vec<u8>, f64)>, String> {
        let mut tree = Tree { task, kernel: Kernel::new(task.robots()), feasible: vec![], integrations: 0 };
        let mut marks = vec![0; task.words()];
        let visited = task.mark_start(task.start(), &mut marks);
        if let Some(expected) = self.visited_at_start {
            same("visited_at_start", &expected, &visited)?;
        }
        tree.grow(&mut Vec::new(), task.start(), &marks, visited, 0.0);
        same("integrations_in_full_tree", &self.integrations_in_full_tree, &tree.integrations)?;
        same("feasible_count", &self.feasible_count, &tree.feasible.len())?;
        same("result", &self.result.as_str(), &if tree.feasible.is_empty() { "infeasible" } else { "solved" })?;
        let mut found: Vec<(String, f64)> =
            tree.feasible.iter().map(|(sequence, cost)| (task.letters(sequence), *cost)).collect();
        let mut expected = self.feasible.clone();
        found.sort_by(|a, b| a.0.cmp(&b.0));
        expected.sort_by(|a, b| a.0.cmp(&b.0));
        same("feasible, sequences", &expected.len(), &found.len())?;
        for (expected, found) in expected.iter().zip(&found) {
            same("feasible", &expected.0, &found.0)?;
            near(&format!("feasible {}", found.0), expected.1, found.1, PLANS)?;
        }
        Ok(tree.feasible)
    }

    fn check_optimum(&self, task: &Task, feasible: &[(Vec<u8>, f64)]) -> Result<(), String> {
        let least = feasible.iter().map(|plan| plan.1).fold(f64::INFINITY, f64::min);
        let Some(expected) = self.optimal_cost else {
            return same("optimal_cost", &f64::INFINITY, &least);
        };
        near("optimal_cost", expected, least, PLANS)?;
        let totals: Vec<f64> = feasible.iter().map(|plan| plan.1).collect();
        check_best("optimal_sequences", task, feasible, &totals, &self.optimal_sequences)?;
        let next = totals.iter().copied().filter(|total| *total > least + TIE).fold(f64::INFINITY, f64::min);
        match self.next_best_cost {
            Some(expected) => near("next_best_cost", expected, next, PLANS)?,
            None => same("next_best_cost", &f64::INFINITY, &next)?,
        }
        let Some(letters) = &self.optimal_stop_last else { return Ok(()) };
        let sequence =
            task.sequence(letters).map_err(|letter| format!("optimal_stop_last: unknown letter {letter:?}"))?;
        let done = carry_out("optimal_stop_last", task, &sequence)?;
        if let Some(expected) = &self.interval_costs {
            near_all("interval_costs", expected, &done.costs, PLANS)?;
        }
        if let Some(expected) = &self.end {
            expected.compare("final", &done.state, PLANS)?;
        }
        match (self.visited_end, done.visited.last()) {
            (Some(expected), Some(found)) => same("visited_end", &expected, found),
            _ => Ok(()),
        }
    }
}

/// The searches that find the optimum because they are exact at w = 1.
fn exact_variants() -> [Options; 5] {
    let options = Options { weight: 1.0, ..Options::default() };
    [
        options,
        Options { geodesic: true, ..options },
        Options { batch: 4, ..options },
        Options { method: Method::Anytime, ..options },
        Options { method: Method::MultiHeuristic { anchor: 1.0, second: 1.0 }, ..options },
    ]
}

fn check_cost(what: &str, task: &Task, search: &Search, expected: Option<f64>) -> Result<(), String> {
    match (expected, check_plan(what, task, search)?) {
        (Some(expected), Some(found)) => near(&format!("{what}.cost"), expected, found, PLANS),
        (None, None) => Ok(()),
        (expected, found) => Err(format!("{what}.cost: expected {expected:?}, found {found:?}")),
    }
}

/// Compares the set of cheapest sequences.
fn check_best(
    what: &str,
    task: &Task,
    feasible: &[(Vec<u8>, f64)],
    totals: &[f64],
    expected: &[String],
) -> Result<(), String> {
    let least = totals.iter().copied().fold(f64::INFINITY, f64::min);
    let best = feasible.iter().zip(totals).filter(|(_, total)| **total <= least + TIE);
    let mut found: Vec<String> = best.map(|((sequence, _), _)| task.letters(sequence)).collect();
    let mut expected = expected.to_vec();
    found.sort();
    expected.sort();
    same(what, &expected, &found)
}

impl OptionalCost {
    fn check(&self, task: &Task, feasible: &[(Vec<u8>, f64)]) -> Result<(), String> {
        let Self { switch_rule, switch_cost, time_cost_per_s, .. } = self;
        let what = format!("optional_costs {switch_rule} {switch_cost} {time_cost_per_s}");
        let costs = costs(switch_rule, *switch_cost, *time_cost_per_s)?;
        let total = |plan: &(Vec<u8>, f64)| plan.1 + costs.of(&plan.0, task.stop(), task.interval());
        let totals: Vec<f64> = feasible.iter().map(total).collect();
        let least = totals.iter().copied().fold(f64::INFINITY, f64::min);
        near(&format!("{what}, optimal_total"), self.optimal_total, least, PLANS)?;
        check_best(&format!("{what}, optimal_sequences"), task, feasible, &totals, &self.optimal_sequences)?;
        let exact = Options { weight: 1.0, ..Options::default() };
        for options in [exact, Options { method: Method::Literal, ..exact }] {
            let search = solve(task, Options { costs, ..options })?;
            check_cost(&format!("{what}, {options:?}"), task, &search, Some(self.optimal_total))?;
        }
        Ok(())
    }
}

impl FullCase {
    pub fn run(&self) -> Result<(), String> {
        let goal = goal(self.target, self.grid, &self.world)?;
        let task = task(Some(&self.world), goal, &self.start, self.intervals)?;
        for plan in &self.plans {
            plan.check(&task)?;
        }
        let StopLastRun { w, cost, lower_bound } = self.stop_last_run;
        near("stop_last_run.cost, at most w times the best known", cost.min(w * self.best_known_cost), cost, PLANS)?;
        let geodesic = matches!(task.goal(), Goal::Reach { .. });
        let anytime = Options { method: Method::Anytime, ..Options::default() };
        for options in [
            Options { eager: true, ..Options::default() },
            Options::default(),
            Options { geodesic, batch: 4, ..Options::default() },
            anytime,
        ] {
            let search = solve(&task, Options { weight: w, ..options })?;
            let what = format!("{options:?}");
            let found =
                check_plan(&what, &task, &search)?.ok_or_else(|| format!("{what}: expected a plan, found none"))?;
            let own = search.lower_bound().unwrap_or(0.0);
            if found < lower_bound - PLANS || found > w * self.best_known_cost + PLANS {
                let most = w * self.best_known_cost;
                return Err(format!("{what}: expected a cost from {lower_bound} to {most}, found {found}"));
            }
            if own > self.best_known_cost + PLANS || own > found {
                let best = self.best_known_cost;
                return Err(format!("{what}: expected a lower bound of at most {best}, found {own}"));
            }
        }
        Ok(())
    }
}

impl KnownPlan {
    fn check(&self, task: &Task) -> Result<(), String> {
        let what = format!("plan {}", self.sequence);
        let sequence = task.sequence(&self.sequence).map_err(|letter| format!("{what}: unknown letter {letter:?}"))?;
        same(&format!("{what}, intervals"), &usize::from(task.decisions()), &sequence.len())?;
        let done = carry_out(&what, task, &sequence)?;
        if let Some(expected) = &self.interval_costs {
            near_all(&format!("{what}, interval_costs"), expected, &done.costs, PLANS)?;
        }
        near(&format!("{what}, cost"), self.cost, done.cost(), PLANS)?;
        if let Some(expected) = &self.end {
            expected.compare(&format!("{what}, final"), &done.state, PLANS)?;
        }
        match (self.visited_end, done.visited.last()) {
            (Some(expected), Some(found)) => same(&format!("{what}, visited_end"), &expected, found),
            _ => Ok(()),
        }
    }
}
