//! `sequence bench`: the variants of the search side by side on generated layouts. `sequence measure`: a scenario's own search
//! on such layouts, for a program to read.

use super::{Failure, in_file, print, read_file};
use clap::Args;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::Instant;
use swarm_playground::random::Seed;
use swarm_playground::scenario::{Scenario, WorldParams};
use swarm_playground::sequencing::{Goal, Kernel, Method, Options, Params, Search, SearchOutcome, Task};

/// Arguments of `sequence bench`.
#[derive(Args)]
pub struct BenchArguments {
    /// A sequencing scenario; its seed and the next ones give the layouts
    scenario: PathBuf,
    /// Layouts
    #[arg(long, default_value_t = 10)]
    layouts: u64,
    /// Integrations after which a variant gives up on a layout
    #[arg(long, default_value_t = 20_000)]
    cap: u64,
    /// Set a parameter, such as robots=10; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Also print each layout
    #[arg(long)]
    each: bool,
}

/// Arguments of `sequence measure`.
#[derive(Args)]
pub struct MeasureArguments {
    /// A sequencing scenario; its seed and the next ones give the layouts
    scenario: PathBuf,
    /// Layouts
    #[arg(long, default_value_t = 10)]
    layouts: u64,
}

/// One layout searched by one variant.
struct Row {
    solved: bool,
    cost: Option<f64>,
    ratio: Option<f64>,
    integrated: f64,
    expanded: u64,
    seconds: f64,
    plan: String,
}

/// Prints a table of the variants and the speed of the kernel.
pub fn bench(arguments: &BenchArguments) -> Result<(), Failure> {
    let mut scenario =
        Scenario::read(&read_file(&arguments.scenario)?).map_err(|error| in_file(&arguments.scenario, &error))?;
    for change in &arguments.set {
        let Some((key, value)) = change.split_once('=') else {
            return Err(Failure::Input(format!("--set: expected KEY=VALUE, found {change:?}")));
        };
        let value = serde_json::from_str(value).unwrap_or_else(|_| serde_json::Value::from(value));
        scenario = scenario.with(key, &value).map_err(|error| Failure::Input(format!("--{error}")))?;
    }
    let (params, tasks) = layouts(&arguments.scenario, &scenario, arguments.layouts)?;
    let base = Options { integrations: arguments.cap, ..params.options() };
    print(&format!("{} layouts, {} robots, w = {}, cap {}", tasks.len(), params.robots, base.weight, arguments.cap))?;
    print(
        "| variant | solved | integrations, median | mean | CPU seconds, median | mean | cost, mean | ratio, mean |",
    )?;
    print("|---|---|---|---|---|---|---|---|")?;
    for (name, options) in variants(base, &tasks) {
        let rows: Vec<Row> = tasks.iter().map(|task| measure(task, options)).collect();
        print(&summary(name, &rows))?;
        if arguments.each {
            for (number, row) in rows.iter().enumerate() {
                let Row { solved, cost, ratio, integrated, expanded, seconds, plan } = row;
                print(&format!(
                    "    layout {number}: solved {solved}, {plan}, cost {cost:.1?}, ratio {ratio:.4?}, {integrated} \
                     integrations, {expanded} expanded, {seconds:.4} s"
                ))?;
            }
        }
    }
    tasks.first().map_or(Ok(()), kernel_speed)
}

/// The parameters of a scenario, and its tasks with margins for its seed and the next ones.
fn layouts<'a>(path: &Path, scenario: &'a Scenario, count: u64) -> Result<(&'a Params, Vec<Task>), Failure> {
    let WorldParams::Sequencing(params) = &scenario.world else {
        return Err(in_file(path, &"world: expected \"sequencing\""));
    };
    let mut tasks = Vec::new();
    for number in 0..count {
        let seed = Seed::new(scenario.seed.value() + number)
            .ok_or_else(|| in_file(path, &"seed: expected room for the layouts"))?;
        let (_, wide) = params.tasks(seed).map_err(|(field, message)| in_file(path, &format!("{field}: {message}")))?;
        tasks.push(wide);
    }
    Ok((params, tasks))
}

/// Searches each layout as the page does and prints seconds by the clock, counts and costs as one line of JSON.
#[expect(clippy::disallowed_methods, reason = "measuring time is what this command is for")]
pub fn measure_layouts(arguments: &MeasureArguments) -> Result<(), Failure> {
    let path = &arguments.scenario;
    let scenario = Scenario::read(&read_file(path)?).map_err(|error| in_file(path, &error))?;
    let (params, tasks) = layouts(path, &scenario, arguments.layouts)?;
    let mut rows = Vec::new();
    for task in &tasks {
        // With a list for drawing, so that native and page do the same.
        let mut search =
            params.search(task, true).map_err(|(field, message)| in_file(path, &format!("{field}: {message}")))?;
        let begun = Instant::now();
        let progress = search.advance(u64::MAX);
        let seconds = begun.elapsed().as_secs_f64();
        rows.push(json!({
            "seconds": seconds,
            "outcome": progress.outcome.map(SearchOutcome::text),
            "plan": search.best().map(|plan| task.letters(&plan.sequence)),
            "cost": progress.cost,
            "lower_bound": search.lower_bound().filter(|bound| bound.is_finite()),
            "integrated": progress.counts.integrated,
            "expanded": progress.counts.expanded,
        }));
    }
    print(&json!({ "layouts": rows }).to_string())
}

/// The variants of interest, with the scenario's weight and charges.
fn variants(base: Options, tasks: &[Task]) -> Vec<(&'static str, Options)> {
    let lazy = Options { method: Method::Exact, eager: false, geodesic: false, batch: 1, ..base };
    let eager = Options { eager: true, ..lazy };
    let two = Method::MultiHeuristic { anchor: 1.25, second: 1.6 };
    let mut all = vec![
        ("Algorithm 1, literal", Options { method: Method::Literal, ..lazy }),
        ("A: Stops last, eager", eager),
        ("A, two queues 1.25 x 1.6", Options { method: two, ..eager }),
        ("B: A, simulated late", lazy),
        ("B, two queues 1.25 x 1.6", Options { method: two, ..lazy }),
        ("B, batches of 2", Options { batch: 2, ..lazy }),
        ("B, batches of 16", Options { batch: 16, ..lazy }),
        ("B, rounded to 1 m (no proof)", Options { method: Method::Approximate(1.0), ..lazy }),
        ("B, rounded to 4 m (no proof)", Options { method: Method::Approximate(4.0), ..lazy }),
        ("B, anytime to w = 1", Options { method: Method::Anytime, weight: 1.0, ..lazy }),
    ];
    if tasks.iter().all(|task| matches!(task.goal(), Goal::Reach { .. })) {
        all.push(("B, round obstacles", Options { geodesic: true, ..lazy }));
        let anytime = Options { method: Method::Anytime, weight: 1.0, geodesic: true, ..lazy };
        all.push(("B, anytime, round obstacles", anytime));
        all.push(("B, from both sides to 1.25", Options { method: Method::BothSides, weight: 1.25, ..lazy }));
    }
    all
}

fn measure(task: &Task, options: Options) -> Row {
    let begun = cpu();
    let Ok(mut search) = Search::new(task, options, &[]) else {
        unreachable!("without a fixed beginning nothing can collide")
    };
    let progress = search.advance(u64::MAX);
    let seconds = cpu() - begun;
    Row {
        solved: progress.outcome == Some(SearchOutcome::Solved),
        cost: progress.cost,
        ratio: search.proven_ratio(),
        integrated: progress.counts.integrated as f64,
        expanded: progress.counts.expanded,
        seconds,
        plan: search.best().map_or_else(|| "no plan".to_owned(), |plan| task.letters(&plan.sequence)),
    }
}

/// Seconds on the processor, where the system tells, so that a busy machine does not show; otherwise by the clock.
#[expect(clippy::disallowed_methods, reason = "measuring time is what this command is for")]
pub(super) fn cpu() -> f64 {
    static BEGUN: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|told| told.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGUN.get_or_init(Instant::now).elapsed().as_secs_f64(), |told| told * 1e-9)
}

/// The middle of some values; 0 without any.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.len() {
        0 => 0.0,
        odd if odd % 2 == 1 => values[middle],
        _ => f64::midpoint(values[middle - 1], values[middle]),
    }
}

fn summary(name: &str, rows: &[Row]) -> String {
    let all = |value: &dyn Fn(&Row) -> f64| rows.iter().map(value).collect::<Vec<f64>>();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let (integrated, seconds) = (all(&|row| row.integrated), all(&|row| row.seconds));
    let costs: Vec<f64> = rows.iter().filter_map(|row| row.cost).collect();
    let ratios: Vec<f64> = rows.iter().filter_map(|row| row.ratio).collect();
    let ratio = if ratios.is_empty() { "-".to_owned() } else { format!("{:.3}", mean(&ratios)) };
    format!(
        "| {name} | {}/{} | {} | {:.0} | {:.4} | {:.4} | {:.0} | {ratio} |",
        rows.iter().filter(|row| row.solved).count(),
        rows.len(),
        median(integrated.clone()),
        mean(&integrated),
        median(seconds.clone()),
        mean(&seconds),
        mean(&costs),
    )
}

/// Prints how many robots are moved by one step in a second of the processor, per kind of behaviour.
fn kernel_speed(task: &Task) -> Result<(), Failure> {
    let mut kernel = Kernel::new(task.robots());
    for letter in ['F', 'N', 'R', 'X'] {
        let Some(at) = task.library().iter().position(|behaviour| behaviour.letter == letter) else { continue };
        let law = task.library()[at].law(task.robots());
        let rounds = 20_000_u32;
        let begun = cpu();
        let mut state = task.start().to_vec();
        for step in 0..rounds {
            if step % task.steps() == 0 {
                state.copy_from_slice(task.start());
            }
            kernel.advance(&law, &mut state);
        }
        let rate = f64::from(rounds) * task.robots() as f64 / (cpu() - begun);
        print(&format!("{}: {rate:.2e} robot-steps a second", task.library()[at].name))?;
    }
    Ok(())
}
