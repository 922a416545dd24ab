//! The tree workbench: what follows from a setup, and every way of looking at it.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::{Value, json};
use swarm_playground::place::Place;
use swarm_playground::workbench::{Bench, Moment, Opened, Setup, format, models, variants};

const MODELS: &str = "<TreeNodesModel><Condition ID=\"Near\"/><Condition ID=\"Free\"/>\
    <Action ID=\"Grasp\"><output_port name=\"held\"/></Action><Action ID=\"Wave\"/></TreeNodesModel>";

/// A document of one tree named Main.
fn document(tree: &str) -> String {
    format!("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">{tree}</BehaviorTree>{MODELS}</root>")
}

fn open(bench: &mut Bench, setup: &Value) -> Opened {
    bench.open(&Setup::from_value(setup).expect("a valid setup"))
}

/// A bench with a tree that runs, and the moment it shows.
fn opened(setup: &Value) -> (Bench, Moment) {
    let mut bench = Bench::default();
    let opened = open(&mut bench, setup);
    assert_eq!(opened.problems, [], "no problem");
    (bench, opened.moment.expect("it runs"))
}

fn columns(bench: &Bench, to: u32) -> Vec<String> {
    bench.timeline(1, to).columns
}

#[test]
fn leaves_answer_as_the_script_says_and_the_later_answer_counts() {
    let script = json!([
        {"tick": 4, "leaf": "Near", "then": "FAILURE"},
        {"tick": 0, "leaf": "Grasp", "running": 2, "then": "FAILURE"},
        {"tick": 3, "leaf": "Grasp", "then": "SUCCESS"},
    ]);
    let xml = document("<Sequence><Near/><Grasp/></Sequence>");
    let (bench, moment) = opened(&json!({"xml": xml, "script": script, "length": 5}));
    // Two ticks RUNNING, then FAILURE; from tick 4 Grasp succeeds at once; after tick 4 Near fails.
    assert_eq!(columns(&bench, 9), ["RSR", "R.R", "F.F", "SSS", "FF."]);
    assert_eq!(bench.timeline(1, 9).roots, ["R", "R", "F", "S", "F"]);
    assert_eq!((moment.tick, moment.length, moment.root), (5, 5, Some("FAILURE")));
    assert_eq!(moment.last, [Some(5), Some(5), Some(4)]);
    assert_eq!(moment.last_status, "FFS");
    assert_eq!(moment.ticked, "FF.");
    assert_eq!(moment.trace, [(1, "FAILURE"), (0, "FAILURE")]);
}

#[test]
fn a_halted_leaf_starts_its_answer_anew() {
    let script = json!([
        {"tick": 0, "leaf": "Wave", "running": 3},
        {"tick": 2, "leaf": "Near", "then": "FAILURE"},
        {"tick": 3, "leaf": "Near", "then": "SUCCESS"},
    ]);
    let xml = document("<ReactiveSequence><Near/><Wave/></ReactiveSequence>");
    let (mut bench, _) = opened(&json!({"xml": xml, "script": script, "length": 8}));
    assert_eq!(columns(&bench, 8), ["RSR", "RSR", "FFH", "RSR", "RSR", "RSR", "SSS", "RSR"]);
    let third = bench.seek(3).expect("it runs");
    assert_eq!((third.halted, third.kept.as_str()), (vec![2], "III"));
    let fifth = bench.seek(5).expect("it runs");
    assert_eq!((fifth.progress, fifth.kept.as_str()), (vec![(2, 2)], "RIR"));
}

#[test]
fn halting_by_hand_shows_in_the_tick_it_follows() {
    let script = json!([{"tick": 0, "leaf": "Wave", "then": "RUNNING"}, {"tick": 2, "halt": true}]);
    let (mut bench, moment) =
        opened(&json!({"xml": document("<Sequence><Wave/></Sequence>"), "script": script, "length": 3, "at": 2}));
    assert_eq!((moment.halted.as_slice(), moment.kept.as_str()), ([1, 0].as_slice(), "II"));
    assert_eq!(columns(&bench, 3), ["RR", "HH", "RR"]);
    assert_eq!(bench.seek(3).expect("it runs").progress, [(1, 1)], "it was started anew");
}

#[test]
fn the_blackboard_says_who_wrote_what_and_when() {
    let script = json!([
        {"tick": 0, "set": "goal", "value": "3"},
        {"tick": 0, "leaf": "Grasp", "running": 1, "writes": {"held": "cup"}},
        {"tick": 2, "set": "@mode", "value": "fast"},
    ]);
    let tree = "<Sequence><Script code=\"n:=goal+1\"/><SubTree ID=\"Take\" thing=\"{thing}\"/></Sequence>";
    let xml = document(tree).replace(
        "<TreeNodesModel>",
        "<BehaviorTree ID=\"Take\"><Grasp held=\"{thing}\"/></BehaviorTree><TreeNodesModel>",
    );
    let xml = xml.replace("BTCPP_format=\"4\"", "BTCPP_format=\"4\" main_tree_to_execute=\"Main\"");
    let (_, moment) = opened(&json!({"xml": xml, "script": script, "length": 2}));
    let shown: Vec<String> = moment
        .entries
        .iter()
        .map(|entry| {
            let value = entry.value.as_deref().unwrap_or("none");
            format!(
                "{}:{}={value} {} by {:?} in {:?}",
                entry.board, entry.name, entry.kind, entry.writer, entry.written
            )
        })
        .collect();
    assert_eq!(
        shown,
        [
            "Main:n=4 number by Some(1) in Some(1)",
            "Main:goal=3 number by None in Some(0)",
            "Main:thing=cup text by Some(3) in Some(2)",
            "@:mode=fast text by None in Some(2)",
        ]
    );
}

#[test]
fn an_output_that_cannot_be_written_ends_the_tick_at_its_leaf() {
    let script = json!([{"tick": 0, "leaf": "Grasp", "writes": {"held": "cup"}}]);
    let xml = document("<Sequence><Grasp held=\"here\"/></Sequence>");
    let (mut bench, moment) = opened(&json!({"xml": xml, "script": script, "length": 1}));
    let error = moment.error.expect("it failed");
    assert_eq!(
        (error.node, error.message.as_str()),
        (1, "expected the output port \"held\" to name an entry such as {held}")
    );
    assert_eq!((moment.root, bench.timeline(1, 1).roots), (Some("ERROR"), vec!["E".to_owned()]));
    assert_eq!(bench.advance(5).expect("it runs").tick, 2, "an error ends an advance");
}

#[test]
fn going_back_and_on_again_gives_the_same_moments() {
    let script = json!([
        {"tick": 0, "leaf": "Wave", "running": 4},
        {"tick": 70, "leaf": "Near", "then": "FAILURE"},
        {"tick": 75, "leaf": "Near", "then": "SUCCESS"},
    ]);
    let tree = "<Sequence><Repeat num_cycles=\"3\"><Sequence><Near/><Wave/></Sequence></Repeat>\
        <Sleep msec=\"250\"/><Script code=\"n:=1\"/></Sequence>";
    let (mut bench, _) = opened(&json!({"xml": document(tree), "script": script, "length": 0}));
    let mut straight = Vec::new();
    for tick in 1..=200 {
        let moment = bench.advance(1).expect("it runs");
        assert_eq!(moment.tick, tick);
        straight.push(serde_json::to_value(&moment).expect("serialises"));
    }
    for tick in [199, 3, 64, 65, 128, 63, 71, 200, 1, 150] {
        let mut moment = serde_json::to_value(bench.seek(tick).expect("it runs")).expect("serialises");
        assert_eq!(moment["length"], json!(200));
        moment["length"] = json!(tick);
        assert_eq!(moment, straight[tick as usize - 1], "tick {tick}");
    }
    let again = opened(&json!({"xml": document(tree), "script": script, "length": 200, "at": 150})).1;
    assert_eq!(json!(again.fingerprint), straight[149]["fingerprint"]);
}

#[test]
fn an_advance_stops_behind_the_tick_of_a_breakpoint() {
    let script = json!([{"tick": 0, "leaf": "Wave", "running": 3}, {"tick": 5, "leaf": "Near", "then": "FAILURE"}]);
    let xml = document("<ReactiveSequence><Near/><Wave/></ReactiveSequence>");
    let (mut bench, _) = opened(&json!({"xml": xml, "script": script}));
    bench.breakpoints(vec![(0, "S".to_owned()), (2, "H".to_owned())]);
    let first = bench.advance(100).expect("it runs");
    assert_eq!((first.tick, first.stopped.map(|stopped| (stopped.node, stopped.status))), (4, Some((0, "SUCCESS"))));
    let second = bench.advance(100).expect("it runs");
    assert_eq!((second.tick, second.stopped.map(|stopped| (stopped.node, stopped.status))), (6, Some((2, "HALTED"))));
    bench.seek(0);
    assert_eq!(bench.advance(100).expect("it runs").tick, 4, "known ticks stop too");
}

#[test]
fn tick_once_makes_several_passes_where_exactly_once_makes_one() {
    let xml = document("<RetryUntilSuccessful num_attempts=\"3\"><Wave/></RetryUntilSuccessful>");
    let script = json!([{"tick": 0, "leaf": "Wave", "then": "FAILURE"}]);
    let (_, once) = opened(&json!({"xml": xml, "script": script, "length": 1}));
    assert_eq!((once.passes, once.root), (3, Some("FAILURE")));
    let (bench, _) = opened(&json!({"xml": xml, "script": script, "mode": "exactly_once", "length": 3}));
    assert_eq!(columns(&bench, 3), ["RF", "RF", "FF"]);
}

#[test]
fn a_fault_in_the_text_leaves_the_last_tree_on_the_bench() {
    let (mut bench, _) = opened(&json!({"xml": document("<Sequence><Wave/></Sequence>"), "length": 2}));
    let faulty = open(&mut bench, &json!({"xml": document("<Sequnce><Wave/></Sequnce>")}));
    assert!(faulty.tree.is_none() && faulty.moment.is_none());
    let [problem] = faulty.problems.as_slice() else { panic!("one problem, found {:?}", faulty.problems) };
    assert_eq!((problem.code, problem.line, problem.column), ("unknown-node", 1, 48));
    assert_eq!(problem.message, "unknown node \"Sequnce\", did you mean \"Sequence\"?");
    assert_eq!(bench.advance(1).expect("it goes on").tick, 3);
}

#[test]
fn a_control_node_that_only_a_model_declares_is_shown_and_not_run() {
    let xml =
        document("<Dance><Wave/></Dance>").replace("</TreeNodesModel>", "<Control ID=\"Dance\"/></TreeNodesModel>");
    let mut bench = Bench::default();
    let opened = open(&mut bench, &json!({"xml": xml, "length": 3}));
    let tree = opened.tree.expect("it is shown");
    assert_eq!((tree.nodes.len(), tree.runnable), (2, false));
    assert!(opened.moment.is_none());
    let [problem] = opened.problems.as_slice() else { panic!("one problem, found {:?}", opened.problems) };
    assert!(problem.warning && problem.message.contains("only declared in a model"), "{}", problem.message);
}

#[test]
fn subtrees_are_expanded_with_places_in_the_text() {
    let xml = "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n<BehaviorTree ID=\"Main\">\n<Sequence>\n\
        <SubTree ID=\"Greet\" name=\"first\"/>\n<SubTree ID=\"Greet\" who=\"{x}\"/>\n</Sequence>\n</BehaviorTree>\n\
        <BehaviorTree ID=\"Greet\">\n<Wave _skipIf=\"tired==1\"/>\n</BehaviorTree>\n\
        <TreeNodesModel><Action ID=\"Wave\"/></TreeNodesModel></root>";
    let mut bench = Bench::default();
    let tree = open(&mut bench, &json!({"xml": xml})).tree.expect("it is shown");
    let nodes = serde_json::to_value(&tree.nodes).expect("serialises");
    let lines: Vec<String> = nodes
        .as_array()
        .expect("a list")
        .iter()
        .map(|node| {
            format!("{} {} {} {} {}", node["parent"], node["type"], node["name"], node["definition"], node["line"])
        })
        .collect();
    assert_eq!(
        lines,
        [
            "null \"Sequence\" \"Sequence\" \"Main\" 3",
            "0 \"SubTree\" \"first\" \"Main\" 4",
            "1 \"Wave\" \"Wave\" \"Greet\" 9",
            "0 \"SubTree\" \"Greet\" \"Main\" 5",
            "3 \"Wave\" \"Wave\" \"Greet\" 9",
        ]
    );
    assert_eq!(nodes[2]["conditions"], json!([["_skipIf", "tired==1"]]));
    assert_eq!(nodes[3]["ports"], json!([["who", "{x}"]]));
    assert_eq!((&nodes[2]["scripted"], &nodes[2]["category"]), (&json!(true), &json!("action")));
}

#[test]
fn a_sequence_is_exchanged_for_its_family_and_nothing_else() {
    let xml = document("<Sequence><Near/><Fallback><Free/><Wave/></Fallback></Sequence>");
    let at = |text: &str| Place { line: 1, column: xml.find(text).expect("it is there") as u32 + 1 };
    let forms = variants(&xml, at("<Sequence>"));
    let kinds: Vec<&str> = forms.iter().map(|form| form.type_name).collect();
    assert_eq!(kinds, ["Sequence", "ReactiveSequence", "SequenceWithMemory"]);
    assert!(forms[1].xml.contains("<ReactiveSequence>") && forms[1].xml.contains("<Fallback>"), "{}", forms[1].xml);
    let kinds: Vec<&str> = variants(&xml, at("<Fallback>")).iter().map(|form| form.type_name).collect();
    assert_eq!(kinds, ["Fallback", "ReactiveFallback", "AsyncFallback"]);
    assert_eq!(variants(&xml, at("<Wave/>")), []);
    assert_eq!(variants("<root", Place { line: 1, column: 1 }), []);
}

#[test]
fn the_canonical_text_opens_to_the_same_run() {
    let script = json!([{"tick": 0, "leaf": "Wave", "running": 1}]);
    let xml = document("<ReactiveSequence><Near/><Action ID=\"Wave\" name=\"Wave\"/></ReactiveSequence>");
    let canonical = format(&xml).expect("it is valid");
    let (first, _) = opened(&json!({"xml": xml, "script": script, "length": 4}));
    let (second, _) = opened(&json!({"xml": canonical, "script": script, "length": 4}));
    assert_eq!(columns(&first, 4), columns(&second, 4));
    assert_eq!(format("<tree/>").expect_err("no document")[0].code, "xml");
}

#[test]
fn every_built_in_node_is_listed_for_the_editor() {
    let list = models();
    let list = list.as_array().expect("a list");
    assert_eq!(list.len(), 42);
    let retry = list.iter().find(|node| node["name"] == "RetryUntilSuccessful").expect("listed");
    assert_eq!(
        (&retry["category"], &retry["ports"][0]["name"], &retry["ports"][0]["direction"]),
        (&json!("decorator"), &json!("num_attempts"), &json!("in"))
    );
}

#[test]
fn a_setup_that_is_none_is_refused_with_the_path() {
    let cases = [
        (json!([]), "setup: expected an object, found []"),
        (json!({}), "xml: expected a text, found no such field"),
        (
            json!({"xml": "", "speed": 1}),
            "speed: expected one of \"xml\", \"script\", \"mode\", \"ms\", \"length\", \"at\"",
        ),
        (json!({"xml": "", "mode": "twice"}), "mode: expected \"once\" or \"exactly_once\", found \"twice\""),
        (json!({"xml": "", "ms": -1}), "ms: expected a whole number from 0 to 3600000, found -1"),
        (json!({"xml": "", "length": 2, "at": 3}), "at: expected a whole number from 0 to 2, found 3"),
        (json!({"xml": "", "length": 1e9}), "length: expected a whole number from 0 to 100000, found 1000000000.0"),
        (json!({"xml": "", "script": 7}), "script: expected a list of at most 10000 events, found 7"),
        (
            json!({"xml": "", "script": [{"tick": 0}]}),
            "script[0]: expected exactly one of \"leaf\", \"set\" and \"halt\": true, found {\"tick\":0}",
        ),
        (
            json!({"xml": "", "script": [{"tick": 0, "halt": true}, {"leaf": "A"}]}),
            "script[1].tick: expected a whole number, found no such field",
        ),
        (
            json!({"xml": "", "script": [{"tick": 0, "leaf": "A", "then": "MAYBE"}]}),
            "script[0].then: expected one of \"SUCCESS\", \"FAILURE\", \"RUNNING\", \"SKIPPED\", found \"MAYBE\"",
        ),
        (
            json!({"xml": "", "script": [{"tick": 0, "leaf": "A", "writes": {"out": 1}}]}),
            "script[0].writes.out: expected a text, found 1",
        ),
        (
            json!({"xml": "", "script": [{"tick": 0, "set": "a"}]}),
            "script[0].value: expected a text, found no such field",
        ),
    ];
    for (setup, expected) in cases {
        let error = Setup::from_value(&setup).expect_err("it is refused").to_string();
        assert_eq!(error, expected, "{setup}");
    }
}

#[test]
fn a_timeline_says_that_it_is_full_after_its_last_tick() {
    let xml = document("<Near/>");
    let (mut bench, moment) = opened(&json!({"xml": xml, "length": 99_999}));
    assert!(!moment.full);
    let last = bench.advance(5).expect("it runs");
    assert_eq!((last.tick, last.full), (100_000, true));
    assert_eq!(bench.advance(1).expect("it stands").tick, 100_000);
}
