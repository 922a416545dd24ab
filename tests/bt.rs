//! Behaviour trees: each node kind tick by tick, as BehaviorTree.CPP 4.10 has it.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::bt::Status::{Failure, Running, Skipped, Success};
use swarm_playground::bt::{
    BuildError, Builder, Builtin, Host, Kind, Memory, NodeId, Ports, Silent, Status, Tree, halt_tree,
    tick_exactly_once, tick_instant, tick_once,
};

/// Leaves that return the statuses of a script, the last one again and again.
struct Script {
    statuses: Vec<Vec<Status>>,
    ticked: Vec<usize>,
    trace: Vec<usize>,
    halts: Vec<usize>,
}

impl Host<usize> for Script {
    fn tick(&mut self, _node: NodeId, leaf: &usize, _ports: &mut Ports) -> Status {
        let script = &self.statuses[*leaf];
        let status = script[self.ticked[*leaf].min(script.len() - 1)];
        self.ticked[*leaf] += 1;
        self.trace.push(*leaf);
        status
    }

    fn halt(&mut self, _node: NodeId, leaf: &usize) {
        self.halts.push(*leaf);
    }
}

struct Bench {
    tree: Tree<usize>,
    memory: Memory,
    script: Script,
}

/// A node to be built.
enum Made {
    Kind(Kind<usize>),
    Builtin(Builtin),
}

impl From<Kind<usize>> for Made {
    fn from(kind: Kind<usize>) -> Self {
        Self::Kind(kind)
    }
}

impl Made {
    fn open(self, builder: &mut Builder<usize>) {
        let kind = match self {
            Self::Kind(kind) => kind,
            Self::Builtin(builtin) => builder.builtin(builtin),
        };
        builder.open(kind);
    }
}

fn parallel(success_count: i32, failure_count: i32) -> Made {
    Made::Builtin(Builtin::Parallel { success_count: success_count.into(), failure_count: failure_count.into() })
}

/// A tree of `node` over one leaf for each script.
fn bench(node: impl Into<Made>, statuses: &[&[Status]]) -> Bench {
    let mut builder = Builder::default();
    node.into().open(&mut builder);
    (0..statuses.len()).for_each(|leaf| builder.leaf(leaf));
    builder.close();
    let tree = builder.finish().expect("a tree");
    let statuses: Vec<Vec<Status>> = statuses.iter().map(|script| script.to_vec()).collect();
    let script = Script { ticked: vec![0; statuses.len()], statuses, trace: vec![], halts: vec![] };
    Bench { memory: Memory::for_tree(&tree), tree, script }
}

impl Bench {
    /// One pass: the root's status, the leaves ticked, the leaves halted.
    fn pass(&mut self) -> (Status, Vec<usize>, Vec<usize>) {
        let status = tick_exactly_once(&self.tree, &mut self.memory, &mut self.script, &mut Silent).expect("no error");
        (status, std::mem::take(&mut self.script.trace), std::mem::take(&mut self.script.halts))
    }
}

#[test]
fn sequence_resumes_and_does_not_look_back() {
    let mut bench = bench(Kind::Sequence, &[&[Success], &[Running, Success], &[Failure, Success]]);
    assert_eq!(bench.pass(), (Running, vec![0, 1], vec![]));
    assert_eq!(bench.pass(), (Failure, vec![1, 2], vec![]));
    assert_eq!(bench.pass(), (Success, vec![0, 1, 2], vec![]));
}

#[test]
fn fallback_is_the_mirror_image() {
    let mut bench = bench(Kind::Fallback, &[&[Failure], &[Running, Failure], &[Success, Failure]]);
    assert_eq!(bench.pass(), (Running, vec![0, 1], vec![]));
    assert_eq!(bench.pass(), (Success, vec![1, 2], vec![]));
    assert_eq!(bench.pass(), (Failure, vec![0, 1, 2], vec![]));
}

#[test]
fn reactive_sequence_looks_at_its_conditions_again_and_halts() {
    let mut bench = bench(Kind::ReactiveSequence, &[&[Success, Success, Failure], &[Running]]);
    assert_eq!(bench.pass(), (Running, vec![0, 1], vec![]));
    assert_eq!(bench.pass(), (Running, vec![0, 1], vec![]));
    assert_eq!(bench.pass(), (Failure, vec![0], vec![1]));
}

#[test]
fn of_two_running_children_of_a_reactive_fallback_the_later_started_is_halted() {
    let mut bench = bench(Kind::ReactiveFallback, &[&[Failure, Running], &[Running]]);
    assert_eq!(bench.pass(), (Running, vec![0, 1], vec![]));
    assert_eq!(bench.pass(), (Running, vec![0], vec![1]));
}

#[test]
fn sequence_with_memory_keeps_its_place_after_a_failure_and_yields_between_children() {
    let mut bench = bench(Kind::SequenceWithMemory, &[&[Success], &[Failure, Success], &[Success]]);
    assert_eq!(
        bench.pass(),
        (Running, vec![0], vec![]),
        "it gives the control back after a child that was done at once"
    );
    assert_eq!(bench.pass(), (Failure, vec![1], vec![]));
    assert_eq!(bench.pass(), (Running, vec![1], vec![]));
    assert_eq!(bench.pass(), (Success, vec![2], vec![]));
}

#[test]
fn tick_once_runs_on_where_a_node_yields() {
    let mut bench = bench(Kind::SequenceWithMemory, &[&[Success], &[Success]]);
    let status = tick_once(&bench.tree, &mut bench.memory, &mut bench.script, &mut Silent);
    assert_eq!((status, bench.script.trace), (Ok(Success), vec![0, 1]));
}

#[test]
fn skipped_children_are_absent_and_all_skipped_is_skipped() {
    for kind in
        [Kind::Sequence, Kind::ReactiveSequence, Kind::Fallback, Kind::ReactiveFallback, Kind::SequenceWithMemory]
    {
        let mut all = bench(kind, &[&[Skipped], &[Skipped]]);
        assert_eq!(all.pass().0, Skipped);
        assert_eq!(all.memory.status(NodeId(0)), Status::Idle);
    }
    assert_eq!(bench(Kind::Sequence, &[&[Skipped], &[Success]]).pass().0, Success);
    assert_eq!(bench(Kind::Fallback, &[&[Skipped], &[Failure]]).pass().0, Failure);
}

#[test]
fn parallel_ends_with_its_thresholds_and_halts_the_rest() {
    let two_of_three = || parallel(-2, 1);
    let mut first = bench(two_of_three(), &[&[Running], &[Success], &[Running, Success]]);
    assert_eq!(first.pass(), (Running, vec![0, 1, 2], vec![]));
    assert_eq!(first.pass(), (Success, vec![0, 2], vec![0]), "the completed child is not ticked again");
    let mut second = bench(two_of_three(), &[&[Running], &[Failure], &[Success]]);
    assert_eq!(second.pass(), (Failure, vec![0, 1], vec![0]), "children after the deciding one are not ticked");
    // Three of three needed: one failure makes them out of reach, though two failures would be allowed.
    let all = parallel(3, 3);
    assert_eq!(bench(all, &[&[Failure], &[Running], &[Running]]).pass(), (Failure, vec![0], vec![]));
}

#[test]
fn a_parallel_threshold_above_the_children_is_an_error_of_the_tick() {
    let mut bench = bench(parallel(3, 1), &[&[Success], &[Success]]);
    let result = tick_once(&bench.tree, &mut bench.memory, &mut bench.script, &mut Silent);
    assert_eq!(
        result.expect_err("there are two children").to_string(),
        "node 0 (Parallel): port success_count: expected at most 2, the number of children, found 3"
    );
    assert_eq!(bench.memory.status(NodeId(0)), Status::Idle);
}

#[test]
fn decorators_change_completions_only() {
    for (kind, success, failure) in [
        (Kind::Inverter, Failure, Success),
        (Kind::ForceSuccess, Success, Success),
        (Kind::ForceFailure, Failure, Failure),
    ] {
        let mut bench = bench(kind, &[&[Success, Failure, Running, Skipped]]);
        assert_eq!(
            [bench.pass().0, bench.pass().0, bench.pass().0, bench.pass().0],
            [success, failure, Running, Skipped]
        );
    }
}

#[test]
fn halting_the_tree_tells_running_leaves_once() {
    let mut bench = bench(Kind::Sequence, &[&[Success], &[Running]]);
    bench.pass();
    for expected in [vec![1], vec![]] {
        halt_tree(&bench.tree, &mut bench.memory, &mut bench.script, &mut Silent).expect("no script");
        assert_eq!(std::mem::take(&mut bench.script.halts), expected);
    }
    assert_eq!(bench.pass().1, [0, 1], "it starts afresh");
}

#[test]
fn a_recorder_sees_children_before_their_parents() {
    let mut bench = bench(Kind::Fallback, &[&[Failure], &[Success], &[Success]]);
    let mut seen: Vec<(NodeId, Status)> = Vec::new();
    tick_once(&bench.tree, &mut bench.memory, &mut bench.script, &mut seen).expect("no error");
    assert_eq!(seen, [(NodeId(1), Failure), (NodeId(2), Success), (NodeId(0), Success)]);
}

#[test]
fn malformed_trees_are_refused() {
    let mut builder: Builder<usize> = Builder::default();
    assert_eq!(builder.finish(), Err(BuildError::Empty));
    builder.open(Kind::Sequence);
    builder.close();
    let error = builder.finish().expect_err("a Sequence without children");
    assert_eq!(error.to_string(), "node 0: expected at least 1 child for Sequence, found 0");
    builder.open(Kind::Inverter);
    builder.leaf(0);
    builder.leaf(1);
    builder.close();
    let error = builder.finish().expect_err("an Inverter with two children");
    assert_eq!(error.to_string(), "node 0: expected exactly 1 child for Inverter, found 2");
    builder.leaf(0);
    builder.leaf(1);
    assert_eq!(builder.finish(), Err(BuildError::SecondRoot(NodeId(1))));
    builder.open(Kind::Sequence);
    builder.leaf(0);
    assert_eq!(builder.finish(), Err(BuildError::Unbalanced));
    builder.leaf(0);
    assert!(builder.finish().is_ok(), "a fault leaves no trace");
}

/// Leaves that are done at once: the bits of a number, one after the other.
struct Bits {
    bits: u64,
    taken: u32,
}

impl Bits {
    fn next(&mut self) -> bool {
        self.taken += 1;
        self.bits.rotate_right(self.taken) & 1 == 1
    }
}

impl Host<()> for Bits {
    fn tick(&mut self, _node: NodeId, _leaf: &(), _ports: &mut Ports) -> Status {
        Status::completed(self.next())
    }
}

/// Some tree of the kinds that remember nothing when all leaves are done at once.
fn some_tree(choices: &mut impl FnMut(u32) -> u32, depth: u32, builder: &mut Builder<()>) {
    let kinds = [Kind::Sequence, Kind::Fallback, Kind::ReactiveSequence, Kind::ReactiveFallback];
    let decorators = [Kind::Inverter, Kind::ForceSuccess, Kind::ForceFailure];
    match choices(if depth == 0 { 1 } else { 9 }) {
        0..3 => builder.leaf(()),
        kind @ 3..7 => {
            builder.open(kinds[kind as usize - 3].clone());
            (0..=choices(4)).for_each(|_| some_tree(choices, depth - 1, builder));
            builder.close();
        }
        _ => {
            builder.open(decorators[choices(3) as usize].clone());
            some_tree(choices, depth - 1, builder);
            builder.close();
        }
    }
}

#[test]
fn ticks_without_a_memory_are_the_ticks_with_one() {
    let mut number = 1_u64;
    let mut draw = || {
        number = number.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        number >> 33
    };
    let mut most = 0;
    for _ in 0..500 {
        let mut builder = Builder::default();
        some_tree(&mut |below| (draw() % u64::from(below)) as u32, 5, &mut builder);
        let tree = builder.finish().expect("a tree");
        most = most.max(tree.nodes().len());
        let mut memory = Memory::for_tree(&tree);
        for _ in 0..8 {
            let bits = draw() << 31 ^ draw();
            let (mut with, mut without) = (Vec::new(), Vec::new());
            let mut host = Bits { bits, taken: 0 };
            let expected = tick_once(&tree, &mut memory, &mut host, &mut with).expect("no error");
            let mut leaves = Bits { bits, taken: 0 };
            let found = tick_instant(&tree, |()| leaves.next(), &mut without);
            assert_eq!((found, leaves.taken), (Ok(expected), host.taken));
            assert_eq!(with, without);
        }
    }
    assert!(most > 50, "some of the trees are large");
}

#[test]
fn nodes_that_need_a_memory_are_refused_without_one() {
    for node in [Kind::SequenceWithMemory.into(), parallel(1, 1)] {
        let mut builder = Builder::default();
        builder.open(Kind::Sequence);
        node.open(&mut builder);
        builder.leaf(0);
        builder.close();
        builder.close();
        let tree = builder.finish().expect("a tree");
        assert_eq!(tick_instant(&tree, |_| true, &mut Silent), Err(NodeId(1)));
    }
}
