//! The teaching trees: each is valid, and its line in the library says what happens when it is run with its script.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::Value as Json;
use std::collections::BTreeMap;
use swarm_playground::bt::xml::{Document, Manifest, Place, Problem, read, write};
use swarm_playground::bt::{
    Host, HostLeaf, Kind, Memory, NodeId, Ports, Recorder, Status, Tree, Value, compile, halt_tree, pass_time,
    tick_exactly_once, tick_once,
};
use swarm_playground::workbench::{Bench, Setup};

const FILES: [(&str, &str); 10] = [
    ("three-sequences.xml", include_str!("../trees/three-sequences.xml")),
    ("two-running.xml", include_str!("../trees/two-running.xml")),
    ("retry.xml", include_str!("../trees/retry.xml")),
    ("parallel.xml", include_str!("../trees/parallel.xml")),
    ("guards.xml", include_str!("../trees/guards.xml")),
    ("branches.xml", include_str!("../trees/branches.xml")),
    ("subtrees.xml", include_str!("../trees/subtrees.xml")),
    ("building-blocks.xml", include_str!("../trees/building-blocks.xml")),
    ("carry-nominal.xml", include_str!("../trees/carry-nominal.xml")),
    ("carry-ppa.xml", include_str!("../trees/carry-ppa.xml")),
];

fn library() -> Vec<Json> {
    serde_json::from_str(include_str!("../trees/library.json")).expect("a list of entries")
}

fn text<'a>(entry: &'a Json, field: &str) -> &'a str {
    entry[field].as_str().unwrap_or_else(|| panic!("{field} is a text in {entry}"))
}

fn number(entry: &Json, field: &str) -> u32 {
    let number = entry[field].as_u64().unwrap_or_else(|| panic!("{field} is a whole number in {entry}"));
    u32::try_from(number).expect("a small number")
}

fn is_note_on_model(problem: &Problem) -> bool {
    problem.warning && problem.code == "unknown-node"
}

/// The document, and a manifest in which the leaves of its models can run.
fn understood(xml: &str) -> (Document, Manifest) {
    let (document, notes) = read(xml, &Manifest::default()).expect("a document without faults");
    assert!(notes.iter().all(is_note_on_model), "{notes:?}");
    let mut manifest = Manifest::default();
    for model in &document.models {
        let node = model.node_type();
        manifest.register(&node.name, node.kind, node.ports).expect("a leaf with a new name");
    }
    let (document, warnings) = read(xml, &manifest).expect("a document without faults");
    assert_eq!(warnings, []);
    (document, manifest)
}

/// What all leaves of one name do: RUNNING so many times after each start, then a status and what they write.
#[derive(Clone)]
struct Answer {
    running: u32,
    then: Status,
    writes: Vec<(String, String)>,
}

#[derive(Default)]
struct Leaves {
    answers: BTreeMap<String, Answer>,
    /// How often a node has returned RUNNING since it started.
    progress: BTreeMap<NodeId, u32>,
    ticked: Vec<String>,
    halted: Vec<String>,
}

impl Host<HostLeaf> for Leaves {
    fn tick(&mut self, node: NodeId, leaf: &HostLeaf, ports: &mut Ports) -> Status {
        self.ticked.push(leaf.name.clone());
        let Some(answer) = self.answers.get(&leaf.name) else { return Status::Success };
        let made = self.progress.get(&node).copied().unwrap_or(0);
        if made < answer.running || answer.then == Status::Running {
            self.progress.insert(node, made + 1);
            return Status::Running;
        }
        self.progress.remove(&node);
        for (port, value) in &answer.writes {
            ports.set(port, Value::literal(value)).expect("an output port with an entry");
        }
        answer.then
    }

    fn halt(&mut self, node: NodeId, leaf: &HostLeaf) {
        self.progress.remove(&node);
        self.halted.push(leaf.name.clone());
    }
}

/// Returns and halts in the order in which they happened.
#[derive(Default)]
struct Log(Vec<(NodeId, char)>);

impl Recorder for Log {
    fn returned(&mut self, node: NodeId, status: Status) {
        self.0.push((node, letter(status)));
    }

    fn halted(&mut self, node: NodeId) {
        self.0.push((node, 'H'));
    }
}

fn letter(status: Status) -> char {
    match status {
        Status::Running => 'R',
        Status::Success => 'S',
        Status::Failure => 'F',
        Status::Skipped => 'K',
        Status::Idle => panic!("no node returns IDLE"),
    }
}

/// A tick: what the root returned, and what was ticked and halted, as leaves see it and as a recorder does.
struct Tick {
    root: Status,
    log: Vec<String>,
    ticked: Vec<String>,
    halted: Vec<String>,
}

/// Runs a tree with the script of its entry, as many ticks as the entry says.
fn run(xml: &str, entry: &Json, mode: &str) -> Vec<Tick> {
    let (document, manifest) = understood(xml);
    let tree = compile(&document, &manifest).expect("every leaf is registered");
    let names = leaf_names(&tree);
    let ms = u64::from(number(entry, "ms"));
    let mut memory = Memory::for_tree(&tree);
    let mut leaves = Leaves::default();
    let mut ticks = Vec::new();
    for tick in 0..=number(entry, "length") {
        let mut log = Log::default();
        let mut root = None;
        if tick > 0 {
            pass_time(&tree, &mut memory, &mut leaves, &mut log, ms).expect("no script fails");
            let ticked = match mode {
                "once" => tick_once(&tree, &mut memory, &mut leaves, &mut log),
                "exactly_once" => tick_exactly_once(&tree, &mut memory, &mut leaves, &mut log),
                other => panic!("no mode {other}"),
            };
            root = Some(ticked.expect("no tick ends with an error"));
        }
        let script = entry["script"].as_array().expect("a list of events");
        for event in script.iter().filter(|event| number(event, "tick") == tick) {
            if event["halt"] == true {
                halt_tree(&tree, &mut memory, &mut leaves, &mut log).expect("no script fails");
            } else if event["set"].is_string() {
                memory.set(text(event, "set"), Value::literal(text(event, "value"))).expect("a value of its type");
            } else {
                assert!(
                    names.values().any(|name| name.ends_with(text(event, "leaf"))),
                    "no leaf of this name: {event}"
                );
                leaves.answers.insert(text(event, "leaf").to_owned(), answer(event));
            }
        }
        if let Some(root) = root {
            let of_leaves = log.0.iter().filter_map(|(node, letter)| Some(format!("{} {letter}", names.get(node)?)));
            let log = of_leaves.collect();
            let (ticked, halted) = (std::mem::take(&mut leaves.ticked), std::mem::take(&mut leaves.halted));
            ticks.push(Tick { root, log, ticked, halted });
        }
    }
    ticks
}

fn answer(event: &Json) -> Answer {
    let all = [Status::Success, Status::Failure, Status::Running, Status::Skipped];
    let then = all.into_iter().find(|status| status.name() == text(event, "then")).expect("a status");
    let writes = event["writes"].as_object().into_iter().flatten();
    let writes = writes.map(|(port, value)| (port.clone(), value.as_str().expect("a text").to_owned())).collect();
    Answer { running: number(event, "running"), then, writes }
}

/// The names of the leaves; where several share one, with the child of the root below which they stand.
fn leaf_names(tree: &Tree<HostLeaf>) -> BTreeMap<NodeId, String> {
    let leaves = || {
        (0..).map(NodeId).zip(tree.nodes()).filter_map(|(id, node)| match &node.kind {
            Kind::Leaf(leaf) => Some((id, &leaf.name)),
            _ => None,
        })
    };
    let named = leaves().map(|(id, name)| {
        if leaves().filter(|(_, other)| *other == name).count() == 1 {
            return (id, name.clone());
        }
        let below = tree.children(NodeId(0)).take_while(|child| *child <= id).last().expect("the root is no leaf");
        (id, format!("{}/{name}", tree.extra(below).expect("nodes from a document have names").name))
    });
    named.collect()
}

fn entry(file: &str) -> (&'static str, Json) {
    let xml = FILES.iter().find(|(name, _)| *name == file).expect("a file of the list").1;
    let entry = library().into_iter().find(|entry| entry["file"] == file).expect("an entry for each file");
    (xml, entry)
}

/// Runs a tree in a mode and compares each tick: the root's letter, then leaves with what they returned (S, F, R, K
/// for SKIPPED) and H where they were halted, in order.
fn expect_ticks(xml: &str, entry: &Json, mode: &str, expected: &[&str]) {
    let ticks = run(xml, entry, mode);
    let found: Vec<String> =
        ticks.iter().map(|tick| format!("{}: {}", letter(tick.root), tick.log.join(", "))).collect();
    assert_eq!(found, expected, "{} with {mode}", text(entry, "file"));
    // The leaves were told what the recorder saw; only guards answer for them.
    let ending_in = |tick: &Tick, letters: &[char]| tick.log.iter().filter(|event| event.ends_with(letters)).count();
    for tick in &ticks {
        assert_eq!(
            (tick.ticked.len(), tick.halted.len()),
            (ending_in(tick, &['S', 'F', 'R']), ending_in(tick, &['H']))
        );
    }
}

/// As [`expect_ticks`], in the mode of the library.
fn expect(file: &str, expected: &[&str]) {
    let (xml, entry) = entry(file);
    expect_ticks(xml, &entry, text(&entry, "mode"), expected);
}

#[test]
fn the_library_lists_exactly_these_files() {
    let listed: Vec<String> = library().iter().map(|entry| text(entry, "file").to_owned()).collect();
    assert_eq!(listed, FILES.map(|(name, _)| name));
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn every_file_of_the_folder_is_listed() {
    let folder = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/trees")).expect("the folder is there");
    let files = folder.flatten().filter(|entry| entry.path().is_file());
    let mut found: Vec<String> = files.map(|file| file.file_name().to_string_lossy().into_owned()).collect();
    let mut wanted: Vec<String> = FILES.iter().map(|(name, _)| (*name).to_owned()).collect();
    wanted.push("library.json".to_owned());
    found.sort();
    wanted.sort();
    assert_eq!(found, wanted);
}

#[test]
fn entries_are_complete_and_their_texts_short() {
    for entry in library() {
        let fields: Vec<&str> = entry.as_object().expect("an object").keys().map(String::as_str).collect();
        let known = ["at", "compare", "file", "length", "mode", "ms", "script", "title", "watch"];
        assert!(fields.iter().all(|field| known.contains(field)), "{fields:?}");
        assert!(text(&entry, "title").chars().count() <= 40, "{}", entry["title"]);
        assert!(text(&entry, "watch").chars().count() <= 140, "{}", entry["watch"]);
        assert!(!text(&entry, "watch").contains('\n'));
        assert!(number(&entry, "at") <= number(&entry, "length"));
    }
}

#[test]
fn every_tree_is_valid_and_canonical() {
    for (name, xml) in FILES {
        let (document, manifest) = understood(xml);
        assert!(document.is_runnable(), "{name}");
        assert_eq!(write(&document, &Manifest::default()), xml, "{name}");
        // Nothing declares a leaf that no tree uses.
        let mut used = Vec::new();
        document.each(&mut |element| used.push(element.type_name.as_str()));
        let idle: Vec<&str> =
            document.models.iter().map(|model| model.id.as_str()).filter(|id| !used.contains(id)).collect();
        assert!(idle.is_empty() && document.missing_models(&manifest).is_empty(), "{name}: {idle:?}");
    }
}

/// The forms of the tree that are compared: the element at `compare` exchanged for each kind of sequence.
fn compared() -> Vec<(&'static str, String)> {
    let (xml, entry) = entry("three-sequences.xml");
    let place = Place { line: number(&entry["compare"], "line"), column: number(&entry["compare"], "column") };
    let (document, _) = understood(xml);
    let mut found = None;
    document.each(&mut |element| found = found.take().or((element.place == place).then_some(&element.type_name)));
    assert_eq!(found.map(String::as_str), Some("Sequence"));
    let exchange = |kind: &'static str| {
        (kind, xml.replace("<Sequence", &format!("<{kind}")).replace("</Sequence", &format!("</{kind}")))
    };
    ["Sequence", "ReactiveSequence", "SequenceWithMemory"].map(exchange).to_vec()
}

#[test]
fn three_sequences_differ_at_ticks_2_4_and_6() {
    let (_, entry) = entry("three-sequences.xml");
    let expected = [
        [
            "R: BallSeen S, Approach R",
            "R: Approach R",
            "F: Approach S, Grasp F",
            "R: BallSeen S, Approach R",
            "R: Approach R, Approach H",
            "R: BallSeen S, Approach R",
            "R: Approach R",
            "S: Approach S, Grasp S",
        ],
        [
            "R: BallSeen S, Approach R",
            "F: BallSeen F, Approach H",
            "R: BallSeen S, Approach R",
            "R: BallSeen S, Approach R",
            "S: BallSeen S, Approach S, Grasp S",
            "R: BallSeen S, Approach R",
            "R: BallSeen S, Approach R",
            "S: BallSeen S, Approach S, Grasp S",
        ],
        [
            "R: BallSeen S, Approach R",
            "R: Approach R",
            "F: Approach S, Grasp F",
            "S: Grasp S",
            "R: BallSeen S, Approach R, Approach H",
            "R: Approach R",
            "R: Approach R",
            "S: Approach S, Grasp S",
        ],
    ];
    for ((_, xml), expected) in compared().iter().zip(expected) {
        expect_ticks(xml, &entry, "once", &expected);
    }
}

#[test]
fn the_running_child_ticked_last_wins_and_the_other_is_halted_after_it_started() {
    expect(
        "two-running.xml",
        &[
            "R: Charge F, Patrol R",
            "R: Charge F, Patrol R",
            "R: Charge R, Patrol H",
            "R: Charge R",
            "R: Charge F, Patrol R",
            "R: Charge F, Patrol R",
            "R: Charge F, Patrol R",
            "S: Charge F, Patrol S",
        ],
    );
}

#[test]
fn three_attempts_are_one_step_of_tick_once_and_three_of_tick_exactly_once() {
    expect(
        "retry.xml",
        &[
            "R: PushDoor F, PushDoor F, PushDoor F, WaitForHelp R",
            "R: WaitForHelp R",
            "R: WaitForHelp R",
            "F: WaitForHelp H",
            "R: PushDoor F, PushDoor F, PushDoor F, WaitForHelp R",
            "R: WaitForHelp R",
            "R: WaitForHelp R",
            "F: WaitForHelp H",
        ],
    );
    let (xml, entry) = entry("retry.xml");
    let expected = [
        "R: PushDoor F",
        "R: PushDoor F",
        "R: PushDoor F, WaitForHelp R",
        "R: WaitForHelp R",
        "R: WaitForHelp R",
        "F: WaitForHelp H",
        "R: PushDoor F",
        "R: PushDoor F",
    ];
    expect_ticks(xml, &entry, "exactly_once", &expected);
}

#[test]
fn parallel_does_not_tick_what_stands_behind_the_deciding_child() {
    expect(
        "parallel.xml",
        &[
            "R: Left R, Middle R, Right R",
            "R: Left S, Middle R, Right R",
            "S: Middle S, Right H",
            "F: Left F, Middle F",
        ],
    );
}

#[test]
fn skip_if_is_looked_at_only_at_the_start_and_while_during_the_run() {
    expect(
        "guards.xml",
        &[
            "R: Walk R, Dance R",
            "R: Walk R, Dance R",
            "R: Walk R, Dance H, Dance K",
            "R: Walk R, Dance K",
            "S: Walk S, Dance K",
            "K: Walk K, Dance K",
            "R: Walk R, Dance R",
        ],
    );
}

#[test]
fn if_then_else_keeps_its_branch_and_while_do_else_changes_it() {
    let both = |condition: char, branch: &str| {
        format!(
            "IfThenElse/DoorOpen {condition}, IfThenElse/{branch} R, \
             WhileDoElse/DoorOpen {condition}, WhileDoElse/{branch} R"
        )
    };
    expect(
        "branches.xml",
        &[
            &format!("R: {}", both('S', "GoThrough")),
            "R: IfThenElse/GoThrough R, WhileDoElse/DoorOpen S, WhileDoElse/GoThrough R",
            "R: IfThenElse/GoThrough R, WhileDoElse/DoorOpen F, WhileDoElse/GoThrough H, WhileDoElse/Knock R",
            "S: IfThenElse/GoThrough S, WhileDoElse/DoorOpen F, WhileDoElse/Knock S",
            &format!("R: {}", both('F', "Knock")),
            "S: IfThenElse/Knock S, WhileDoElse/DoorOpen F, WhileDoElse/Knock S",
        ],
    );
}

#[test]
fn a_subtree_sees_what_is_given_to_it_and_the_global_board() {
    expect(
        "subtrees.xml",
        &[
            "R: ChooseGoal S, Alone/StandStill R",
            "R: Alone/StandStill S, Remapped/ToShelf R",
            "R: Remapped/ToShelf S, Literal/ToDoor R",
            "R: Literal/ToDoor S, Auto/ToShelf R",
            "R: Auto/ToShelf S, Global/ToDoor R",
            "S: Global/ToDoor S",
        ],
    );
}

#[test]
fn the_building_blocks_differ_where_they_have_memory() {
    expect(
        "building-blocks.xml",
        &[
            "R: FallbackBlock/HasBall F, FallbackBlock/FetchBall R, FallbackMemory/HasBall F, \
             FallbackMemory/FetchBall R, SequenceBlock/GoalOpen S, SequenceBlock/Shoot R, SequenceMemory/GoalOpen S, \
             SequenceMemory/Shoot R, MarkOpponent R, Defend R, DecoratorBlock/HasBall F",
            "R: FallbackBlock/HasBall F, FallbackBlock/FetchBall R, FallbackMemory/FetchBall R, \
             SequenceBlock/GoalOpen S, SequenceBlock/Shoot R, SequenceMemory/Shoot R, MarkOpponent R, Defend R",
            "R: FallbackBlock/HasBall S, FallbackBlock/FetchBall H, FallbackMemory/FetchBall R, \
             SequenceBlock/GoalOpen F, SequenceBlock/Shoot H, SequenceMemory/Shoot R, MarkOpponent S, Defend H",
            "R: FallbackMemory/FetchBall R, SequenceMemory/Shoot R",
            "F: FallbackMemory/FetchBall S, SequenceMemory/Shoot S",
        ],
    );
}

#[test]
fn a_postcondition_spares_what_is_done_already() {
    expect(
        "carry-nominal.xml",
        &[
            "S: IsCarryable S, Carry S",
            "F: IsCarryable F",
            "F: IsCarryable F",
            "F: IsCarryable F",
            "S: IsCarryable S, Carry S",
        ],
    );
    expect(
        "carry-ppa.xml",
        &[
            "S: AlreadyCarrying F, IsCarryable S, Carry S",
            "S: AlreadyCarrying S",
            "S: AlreadyCarrying S",
            "F: AlreadyCarrying F, IsCarryable F",
            "S: AlreadyCarrying F, IsCarryable S, Carry S",
        ],
    );
}

#[test]
fn the_workbench_opens_every_entry_and_does_the_same() {
    for (name, xml) in FILES {
        let (_, entry) = entry(name);
        let mut setup = entry.clone();
        let fields = setup.as_object_mut().expect("an object");
        for field in ["file", "title", "watch", "compare"] {
            fields.remove(field);
        }
        fields.insert("xml".to_owned(), Json::from(xml));
        let mut bench = Bench::default();
        let opened = bench.open(&Setup::from_value(&setup).expect("an entry is a setup"));
        assert!(opened.problems.is_empty(), "{name}");
        let roots: Vec<String> =
            run(xml, &entry, text(&entry, "mode")).iter().map(|tick| letter(tick.root).to_string()).collect();
        assert_eq!(bench.timeline(1, number(&entry, "length")).roots, roots, "{name}");
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
#[ignore = "writes what scripts/peer.py compares with another implementation, into the folder PEER_FOLDER"]
fn runs_for_the_peer_are_written() {
    let folder = std::env::var("PEER_FOLDER").expect("a folder");
    let mut runs = Vec::new();
    for entry in library() {
        let xml = FILES.iter().find(|(name, _)| entry["file"] == *name).expect("a file for each entry").1;
        let mut forms = vec![(text(&entry, "file").to_owned(), xml.to_owned())];
        if entry.get("compare").is_some() {
            let others = compared().into_iter().skip(1);
            forms.extend(others.map(|(kind, xml)| (format!("{} as {kind}", text(&entry, "file")), xml)));
        }
        for (id, xml) in forms {
            for mode in ["once", "exactly_once"] {
                let ticks = run(&xml, &entry, mode);
                runs.push(serde_json::json!({
                    "id": format!("{id}, {mode}"),
                    "xml": &xml,
                    "mode": mode,
                    "ms": &entry["ms"],
                    "script": &entry["script"],
                    "root": ticks.iter().map(|tick| tick.root.name()).collect::<Vec<_>>(),
                    "trace": ticks.iter().map(|tick| &tick.ticked).collect::<Vec<_>>(),
                    "halts": ticks.iter().map(|tick| &tick.halted).collect::<Vec<_>>(),
                }));
            }
        }
    }
    let path = std::path::Path::new(&folder).join("teaching.json");
    std::fs::write(path, Json::from(runs).to_string()).expect("a folder that can be written");
}
