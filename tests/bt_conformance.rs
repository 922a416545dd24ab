//! Behaviour trees from XML against the cases confirmed on BehaviorTree.CPP, and what those cases leave out.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::bt::xml::{Manifest, NodeKind, read};
use swarm_playground::bt::{
    Cases, Host, HostLeaf, Memory, NodeId, Ports, Silent, Status, Tree, Value, compile, halt_tree, pass_time,
    tick_exactly_once, tick_once,
};

#[test]
fn every_oracle_case_passes() {
    let cases = Cases::read(include_str!("cases/behaviour_trees.json")).expect("the file is valid");
    let verdicts = cases.run();
    assert_eq!(verdicts.len(), 44);
    for verdict in verdicts {
        assert_eq!(verdict.fault, None, "{}", verdict.id);
    }
}

/// A leaf `Work` that is RUNNING for one tick and then succeeds, and keeps a log.
#[derive(Default)]
struct Work {
    running: bool,
    log: Vec<&'static str>,
}

impl Host<HostLeaf> for Work {
    fn tick(&mut self, _node: NodeId, _leaf: &HostLeaf, _ports: &mut Ports) -> Status {
        self.running = !self.running;
        self.log.push(if self.running { "starts" } else { "ends" });
        if self.running { Status::Running } else { Status::Success }
    }

    fn halt(&mut self, _node: NodeId, _leaf: &HostLeaf) {
        self.running = false;
        self.log.push("halted");
    }
}

struct Bench {
    tree: Tree<HostLeaf>,
    memory: Memory,
    work: Work,
}

impl Bench {
    fn new(nodes: &str) -> Self {
        let mut manifest = Manifest::default();
        manifest.register("Work", NodeKind::Action, vec![]).expect("a new name");
        let text = format!("<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">{nodes}</BehaviorTree></root>");
        let (document, _) = read(&text, &manifest).expect("valid XML");
        let tree = compile(&document, &manifest).expect("it runs");
        Self { memory: Memory::for_tree(&tree), tree, work: Work::default() }
    }

    fn pass(&mut self) -> Result<Status, String> {
        tick_exactly_once(&self.tree, &mut self.memory, &mut self.work, &mut Silent).map_err(|error| error.to_string())
    }

    fn wait(&mut self, milliseconds: u64) {
        pass_time(&self.tree, &mut self.memory, &mut self.work, &mut Silent, milliseconds).expect("no script fails");
    }

    fn number(&self, name: &str) -> Option<f64> {
        match self.memory.get(name) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        }
    }
}

#[test]
fn an_endless_repeat_is_stopped_within_one_tick_once() {
    let mut bench = Bench::new("<Repeat num_cycles=\"-1\"><AlwaysSuccess/></Repeat>");
    let error = tick_once(&bench.tree, &mut bench.memory, &mut bench.work, &mut Silent).expect_err("it has no end");
    assert_eq!(error.to_string(), "node 0 (Repeat): expected an end within 10000 passes of one tick, found none");
    assert_eq!(bench.pass(), Ok(Status::Running), "one pass is fine");
}

#[test]
fn run_once_survives_a_halt_of_the_tree() {
    let mut bench = Bench::new("<RunOnce then_skip=\"false\"><Script code=\"n := 1\"/></RunOnce>");
    assert_eq!(bench.pass(), Ok(Status::Success));
    halt_tree(&bench.tree, &mut bench.memory, &mut bench.work, &mut Silent).expect("no script");
    bench.memory.set("n", Value::Number(7.0)).expect("a number");
    assert_eq!(bench.pass(), Ok(Status::Success));
    assert_eq!(bench.number("n"), Some(7.0), "the child was not ticked again");
}

#[test]
fn sleep_waits_on_simulated_time_only() {
    let mut bench = Bench::new("<Sleep msec=\"50\"/>");
    assert_eq!(bench.pass(), Ok(Status::Running));
    bench.wait(49);
    assert_eq!(bench.pass(), Ok(Status::Running));
    bench.wait(1);
    assert_eq!(bench.pass(), Ok(Status::Success));
    assert_eq!(bench.pass(), Ok(Status::Running), "it starts afresh");
}

#[test]
fn a_timer_that_comes_due_wakes_tick_once_up() {
    let mut bench = Bench::new("<Sequence><Sleep msec=\"5\"/><Work/></Sequence>");
    assert_eq!(bench.pass(), Ok(Status::Running));
    bench.wait(5);
    // One pass ends the Sleep and starts the work; the wake-up that is pending makes another.
    let status = tick_once(&bench.tree, &mut bench.memory, &mut bench.work, &mut Silent);
    assert_eq!(status, Ok(Status::Success));
    assert_eq!(bench.work.log, ["starts", "ends"]);
}

#[test]
fn halting_runs_the_script_of_running_nodes_only() {
    let mut bench = Bench::new("<Sequence><Script code=\"n := 0\"/><Work _onHalted=\"n := n + 1\"/></Sequence>");
    assert_eq!(bench.pass(), Ok(Status::Running));
    for _ in 0..2 {
        halt_tree(&bench.tree, &mut bench.memory, &mut bench.work, &mut Silent).expect("the script runs");
        assert_eq!(bench.number("n"), Some(1.0));
    }
    assert_eq!(bench.work.log, ["starts", "halted"]);
}

#[test]
fn try_catch_cleans_up_once_when_it_is_halted_in_its_block() {
    let mut bench = Bench::new("<TryCatch catch_on_halt=\"true\"><Work/><Script code=\"n := 1\"/></TryCatch>");
    assert_eq!(bench.pass(), Ok(Status::Running));
    halt_tree(&bench.tree, &mut bench.memory, &mut bench.work, &mut Silent).expect("the script runs");
    assert_eq!(bench.number("n"), Some(1.0));
}

#[test]
fn an_error_of_a_tick_names_the_node_and_the_cause() {
    let mut bench = Bench::new("<Sequence><Script name=\"sum_up\" code=\"n := m + 1\"/></Sequence>");
    assert_eq!(bench.pass(), Err("node 1 (Script \"sum_up\"): unknown name \"m\"".to_owned()));
    bench.memory.set("m", Value::Number(2.0)).expect("a number");
    assert_eq!(bench.pass(), Ok(Status::Success), "the next tick starts afresh");
    assert_eq!(bench.number("n"), Some(3.0));
}

#[test]
fn wait_value_update_runs_its_child_once_for_each_write() {
    let mut bench = Bench::new("<WaitValueUpdate entry=\"{n}\"><Script code=\"seen := n\"/></WaitValueUpdate>");
    assert_eq!(bench.pass(), Ok(Status::Running), "no such entry yet");
    bench.memory.set("n", Value::Number(4.0)).expect("a number");
    assert_eq!(bench.pass(), Ok(Status::Success));
    assert_eq!(bench.number("seen"), Some(4.0));
    assert_eq!(bench.pass(), Ok(Status::Running), "nothing new");
}

#[test]
fn a_loop_over_an_entry_takes_values_from_its_queue() {
    let mut bench = Bench::new("<LoopInt queue=\"{q}\" value=\"{v}\"><Script code=\"sum := sum + v\"/></LoopInt>");
    bench.memory.set("q", Value::Text("4;5".to_owned())).expect("a text");
    bench.memory.set("sum", Value::Number(0.0)).expect("a number");
    assert_eq!(
        [bench.pass(), bench.pass(), bench.pass()],
        [Ok(Status::Running), Ok(Status::Running), Ok(Status::Success)]
    );
    assert_eq!(bench.number("sum"), Some(9.0));
    assert_eq!(bench.memory.get("q"), Some(&Value::Queue(vec![])));
}

#[test]
fn autoremap_shares_names_but_those_with_an_underscore() {
    let text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"M\"><BehaviorTree ID=\"M\"><Sequence>\
                <Script code=\"a := 1\"/><SubTree ID=\"S\" _autoremap=\"true\"/></Sequence></BehaviorTree>\
                <BehaviorTree ID=\"S\"><Script code=\"b := a + 1; _c := 5\"/></BehaviorTree></root>";
    let manifest = Manifest::default();
    let (document, _) = read(text, &manifest).expect("valid XML");
    let tree = compile(&document, &manifest).expect("it runs");
    let mut memory = Memory::for_tree(&tree);
    let status = tick_once(&tree, &mut memory, &mut Work::default(), &mut Silent);
    assert_eq!(status, Ok(Status::Success));
    assert_eq!(memory.get("b"), Some(&Value::Number(2.0)));
    assert_eq!(memory.get("_c"), None);
}
