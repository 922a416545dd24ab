//! The XML of behaviour trees: every refusal with its place and text, warnings, and round trips.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use serde_json::Value;
use swarm_playground::bt::xml::{
    Direction, Document, Manifest, ModelPart, NodeKind, Place, Port, PortType, Problem, When, builtin_nodes, read,
    reference, write,
};

fn manifest() -> Manifest {
    let mut manifest = Manifest::default();
    let echo = vec![
        Port::new("in", Direction::In, PortType::Text, "what to copy"),
        Port::new("out", Direction::Out, PortType::Text, "where to"),
    ];
    manifest.register("TestAction", NodeKind::Action, vec![]).expect("a new name");
    manifest.register("TestCondition", NodeKind::Condition, vec![]).expect("a new name");
    manifest.register("EchoPort", NodeKind::Action, echo).expect("a new name");
    manifest
}

fn accepted(text: &str) -> (Document, Vec<Problem>) {
    read(text, &manifest()).unwrap_or_else(|problems| panic!("{text}\n{problems:#?}"))
}

fn refused(text: &str) -> Vec<Problem> {
    match read(text, &manifest()) {
        Ok(_) => panic!("accepted: {text}"),
        Err(problems) => problems,
    }
}

/// The faults of a text as `code: line and column: message`.
fn faults(text: &str) -> Vec<String> {
    refused(text)
        .iter()
        .filter(|problem| !problem.warning)
        .map(|problem| format!("{}: {problem}", problem.code))
        .collect()
}

fn warnings(text: &str) -> Vec<String> {
    accepted(text).1.iter().map(|problem| format!("{}: {problem}", problem.code)).collect()
}

/// A document whose main tree has this content, from line 3, column 1.
fn tree(content: &str) -> String {
    format!(
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"M\">\n<BehaviorTree ID=\"M\">\n{content}\n</BehaviorTree>\n</root>"
    )
}

/// The same with something after the tree, from line 5, column 1.
fn tree_and(content: &str, after: &str) -> String {
    tree(content).replace("\n</root>", &format!("\n{after}\n</root>"))
}

#[test]
fn xml_names_the_faulty_markup() {
    assert_eq!(faults("<root>\n <a>\n</root>"), [r"xml: line 3, column 1: expected </a>, found </root>"]);
    assert_eq!(
        faults("<root>\n <a>"),
        ["xml: line 2, column 2: expected </a> for this element, found the end of the text"]
    );
    assert_eq!(faults("\n <tree/>"), ["xml: line 2, column 2: expected <root> as the outer element, found <tree>"]);
    assert_eq!(faults(""), ["xml: line 1, column 1: expected <root>, found no element"]);
    assert_eq!(
        faults("<root>\n<a b=\"1\" b=\"2\"/></root>"),
        [r#"xml: line 2, column 10: expected each attribute once, found "b" again"#]
    );
    assert_eq!(
        faults(&tree_and("<AlwaysSuccess/>", "<TreeNodeModel/>")),
        ["xml: line 5, column 1: expected <BehaviorTree> or <TreeNodesModel> in <root>, found <TreeNodeModel>, \
          did you mean <TreeNodesModel>?"]
    );
}

#[test]
fn xml_refuses_document_types_hence_entities_and_their_bombs() {
    let bomb = "<!DOCTYPE r [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n<root>&b;</root>";
    assert_eq!(
        faults(bomb),
        [
            "xml: line 1, column 1: expected an element, found a document type or other <! markup, which is not supported"
        ]
    );
    assert_eq!(refused("<root>&b;</root>")[0].code, "xml");
}

#[test]
fn xml_refuses_texts_that_are_too_large() {
    let text = tree(&format!("<!--{}--><AlwaysSuccess/>", " ".repeat(2_000_000)));
    assert_eq!(faults(&text), [format!("xml: line 1, column 1: expected at most 2000000 bytes, found {}", text.len())]);
    let attributes: Vec<String> = (0..1001).map(|n| format!(" _a{n}='='")).collect();
    assert_eq!(
        faults(&tree(&format!("<AlwaysSuccess{}/>", attributes.concat()))),
        ["xml: line 3, column 1: expected at most 1000 attributes, found 1001"]
    );
    assert_eq!(
        faults(&tree(&"<Inverter xmlns:a='b'>\n".repeat(101))),
        ["xml: line 103, column 11: expected at most 100 namespaces, found more"]
    );
}

#[test]
fn no_tree_and_main_tree() {
    assert_eq!(
        faults("<root BTCPP_format=\"4\"/>"),
        ["no-tree: line 1, column 1: expected at least one BehaviorTree, found none"]
    );
    let two = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Attack\"><AlwaysSuccess/></BehaviorTree>\
               <BehaviorTree ID=\"B\"><AlwaysSuccess/></BehaviorTree></root>";
    assert_eq!(
        faults(two),
        ["main-tree: line 1, column 1: expected main_tree_to_execute to name one of 2 trees, found none"]
    );
    assert_eq!(
        faults(&two.replace("4\"", "4\" main_tree_to_execute=\"Atack\"")),
        [r#"main-tree: line 1, column 24: unknown main tree "Atack", did you mean "Attack"?"#]
    );
}

#[test]
fn tree_id() {
    let more = |id: &str| tree_and("<AlwaysSuccess/>", &format!("<BehaviorTree{id}><AlwaysSuccess/></BehaviorTree>"));
    assert_eq!(
        faults(&more("")),
        ["tree-id: line 5, column 1: expected the attribute ID in a BehaviorTree beside others, found none"]
    );
    assert_eq!(
        faults(&more(" ID=\"M\"")),
        [r#"tree-id: line 5, column 15: expected each tree once, found "M" again (first: line 2, column 15)"#]
    );
    assert_eq!(
        faults(&more(" ID=\"Sequence\"")),
        [r#"tree-id: line 5, column 15: expected a tree name of its own, found "Sequence", which is a node"#]
    );
}

#[test]
fn one_child() {
    assert_eq!(
        faults(&tree("<AlwaysSuccess/><AlwaysFailure/>")),
        ["one-child: line 2, column 1: expected exactly 1 child of BehaviorTree \"M\", found 2: \
          AlwaysFailure in line 3, column 17 is one too many"]
    );
    assert_eq!(
        faults(&tree("")),
        [r#"one-child: line 2, column 1: expected exactly 1 child of BehaviorTree "M", found none"#]
    );
    assert_eq!(
        faults(&tree(" <Inverter/>")),
        ["one-child: line 3, column 2: expected exactly 1 child of Inverter, found none"]
    );
    assert_eq!(
        faults(&tree("<Inverter>\n<AlwaysSuccess/>\n <Sleep msec=\"1\"/></Inverter>")),
        ["one-child: line 3, column 1: expected exactly 1 child of Inverter, found 2: \
          Sleep in line 5, column 2 is one too many"]
    );
}

#[test]
fn no_child() {
    assert_eq!(
        faults(&tree("<Sequence/>")),
        ["no-child: line 3, column 1: expected at least 1 child of Sequence, found none"]
    );
    assert_eq!(
        faults(&tree("<TryCatch><AlwaysSuccess/></TryCatch>")),
        ["no-child: line 3, column 1: expected at least 2 children of TryCatch, found 1"]
    );
}

#[test]
fn leaf_child() {
    assert_eq!(
        faults(&tree("<TestAction>\n  <AlwaysSuccess/></TestAction>")),
        ["leaf-child: line 4, column 3: expected no child of TestAction, found AlwaysSuccess"]
    );
    assert_eq!(
        faults(&tree_and(
            "<SubTree ID=\"S\"><AlwaysSuccess/></SubTree>",
            "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>"
        )),
        ["leaf-child: line 3, column 17: expected no child of SubTree, found AlwaysSuccess"]
    );
}

#[test]
fn unknown_node() {
    assert_eq!(
        faults(&tree("     <Sequnce><Nothing/></Sequnce>")),
        [
            r#"unknown-node: line 3, column 6: unknown node "Sequnce", did you mean "Sequence"?"#,
            r#"unknown-node: line 3, column 15: unknown node "Nothing""#
        ]
    );
    assert_eq!(
        faults(&tree("<Action ID=\"TestActoin\"/>")),
        [r#"unknown-node: line 3, column 1: unknown node "TestActoin", did you mean "TestAction"?"#]
    );
    let text = tree_and("<S/>", "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>");
    assert_eq!(faults(&text), [r#"unknown-node: line 3, column 1: unknown node "S", did you mean <SubTree ID="S"/>?"#]);
    assert_eq!(
        faults(&tree("<x:Sequence xmlns:x=\"y\"/>")),
        [r#"unknown-node: line 3, column 1: unknown node "x:Sequence", did you mean "Sequence"?"#]
    );
}

#[test]
fn a_node_that_only_a_model_declares_is_shown_and_not_run() {
    let text = tree_and("<Fly/>", "<TreeNodesModel><Action ID=\"Fly\"/></TreeNodesModel>");
    let (document, warnings) = accepted(&text);
    assert!(!document.is_runnable());
    assert_eq!(
        warnings[0].to_string(),
        "line 3, column 1: Fly is only declared in a model: it can be shown and edited, not run"
    );
    assert!(accepted(&tree("<TestAction/>")).0.is_runnable());
}

#[test]
fn id_misuse() {
    assert_eq!(
        faults(&tree("<Sequence><Action name=\"a\"/><SubTree/></Sequence>")),
        [
            "id-misuse: line 3, column 11: expected the attribute ID in <Action>, which names the node, found none",
            "id-misuse: line 3, column 29: expected the attribute ID in <SubTree>, which names a tree, found none"
        ]
    );
    assert_eq!(
        faults(&tree("<TestAction  ID=\"x\"/>")),
        [r#"id-misuse: line 3, column 14: expected no attribute ID in <TestAction>, found ID="x""#]
    );
}

#[test]
fn unknown_subtree() {
    assert_eq!(
        faults(&tree_and(" <SubTree ID=\"Atack\"/>", "<BehaviorTree ID=\"Attack\"><AlwaysSuccess/></BehaviorTree>")),
        [r#"unknown-subtree: line 3, column 2: unknown tree "Atack" in SubTree, did you mean "Attack"?"#]
    );
}

#[test]
fn recursion() {
    assert_eq!(
        faults(&tree("<Inverter><SubTree ID=\"M\"/></Inverter>")),
        ["recursion: line 3, column 11: expected no tree inside itself, found M > M"]
    );
    let text = tree_and(
        "<SubTree ID=\"A\"/>",
        "<BehaviorTree ID=\"A\"><SubTree ID=\"B\"/></BehaviorTree>\n\
         <BehaviorTree ID=\"B\"><SubTree ID=\"A\"/></BehaviorTree>",
    );
    assert_eq!(faults(&text), ["recursion: line 6, column 22: expected no tree inside itself, found A > B > A"]);
}

#[test]
fn unknown_port() {
    assert_eq!(
        faults(&tree("<Parallel succes_count=\"1\"><TestAction speed=\"1\"/></Parallel>")),
        [
            "unknown-port: line 3, column 11: unknown port \"succes_count\", Parallel has ports success_count, \
             failure_count, did you mean \"success_count\"?",
            "unknown-port: line 3, column 40: unknown port \"speed\", TestAction has no ports"
        ]
    );
}

#[test]
fn bad_value() {
    assert_eq!(
        faults(&tree("<Repeat num_cycles = 'x'><Sleep msec=\"-1\"/></Repeat>")),
        [
            r#"bad-value: line 3, column 23: expected a whole number for port "num_cycles", found "x""#,
            r#"bad-value: line 3, column 39: expected a whole number that is not negative for port "msec", found "-1""#
        ]
    );
    assert_eq!(
        faults(&tree("<LoopInt queue=\"1;2;x\" if_empty=\"IDLE\"><AlwaysSuccess/></LoopInt>")),
        [
            r#"bad-value: line 3, column 17: expected whole numbers separated by ; for port "queue", found "1;2;x""#,
            "bad-value: line 3, column 34: expected SUCCESS, FAILURE, SKIPPED or RUNNING for port \"if_empty\", \
             found \"IDLE\""
        ]
    );
    assert_eq!(
        faults(&tree_and(
            "<SubTree ID=\"S\" _autoremap=\"yes\"/>",
            "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>"
        )),
        [r#"bad-value: line 3, column 29: expected true or false for _autoremap, found "yes""#]
    );
    for good in ["<Repeat num_cycles=\"{n}\"><AlwaysSuccess/></Repeat>", "<Sleep msec=\"{=}\"/>"] {
        assert!(warnings(&tree(good)).is_empty());
    }
    assert_eq!(
        (reference(" {goal} "), reference("{=}"), reference("goal"), reference("{}")),
        (Some("goal"), Some("="), None, None)
    );
}

#[test]
fn missing_port() {
    let text = |subtree: &str| {
        tree_and(
            subtree,
            "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>\n<TreeNodesModel><SubTree ID=\"S\">\
             <input_port name=\"goal\"/><input_port name=\"speed\" default=\"1\"/></SubTree></TreeNodesModel>",
        )
    };
    assert_eq!(
        faults(&text("  <SubTree ID=\"S\"/>")),
        [r#"missing-port: line 3, column 3: expected the port "goal" of SubTree S, found none"#]
    );
    assert!(warnings(&text("<SubTree ID=\"S\" goal=\"{g}\"/>")).is_empty());
    assert!(warnings(&text("<SubTree ID=\"S\" _autoremap=\"true\"/>")).is_empty());
}

#[test]
fn bad_script_points_to_the_character_as_typed() {
    let place = |text: &str| {
        let problems = refused(&tree(text));
        let [problem] = &problems[..] else { panic!("one problem: {problems:?}") };
        assert_eq!(problem.code, "bad-script");
        (problem.place.line, problem.place.column)
    };
    assert_eq!(
        faults(&tree("<Precondition if=\"a &lt;= \"><Script code='b := := 1'/></Precondition>")),
        [
            "bad-script: line 3, column 27: expected a number, text or name, found the end of the script",
            "bad-script: line 3, column 48: expected a number, text or name, found \":=\""
        ]
    );
    assert_eq!(place("<Script code=\"a := := 1\"/>"), (3, 20));
    assert_eq!(place("<AlwaysSuccess _skipIf=\"a &gt; 1 &#38;&amp; #\"/>"), (3, 45));
    assert_eq!(place("<AlwaysSuccess _while=\"a &gt;\r\n 1 # b\"/>"), (4, 4));
    assert_eq!(place("<AlwaysSuccess _post=\"x := '€' #\"/>"), (3, 32));
}

#[test]
fn bad_name() {
    assert_eq!(
        faults(&tree("<TestAction name=\"go home\"/>")),
        [r#"bad-name: line 3, column 13: expected an instance name without ' ', found "go home""#]
    );
    assert_eq!(
        faults(&tree("<Action ID=\"\"/>")),
        ["bad-name: line 3, column 9: expected a node name, found an empty one"]
    );
    assert_eq!(
        faults(&tree("<AlwaysSuccess/>").replace("\"M\"", "\"Root\"")),
        [r#"bad-name: line 2, column 15: expected a tree name other than "Root", which is reserved"#]
    );
    assert_eq!(
        faults(&tree_and("<SubTree ID=\"S\" a.b=\"1\"/>", "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>")),
        [r#"bad-name: line 3, column 17: expected a port name without '.', found "a.b""#]
    );
    assert_eq!(
        faults(&tree_and(
            "<AlwaysSuccess/>",
            "<TreeNodesModel><Action ID=\"A\"><input_port name=\"1st\"/><input_port name=\"_post\"/></Action></TreeNodesModel>"
        )),
        [
            r#"bad-name: line 5, column 44: expected a port name that does not start with a digit, found "1st""#,
            r#"bad-name: line 5, column 68: expected a port name that is not reserved, found "_post""#
        ]
    );
}

#[test]
fn model() {
    assert_eq!(
        faults(&tree_and("<AlwaysSuccess/>", "<TreeNodesModel/>\n<TreeNodesModel/>")),
        ["model: line 6, column 1: expected one TreeNodesModel, found another one (first: line 5, column 1)"]
    );
    assert_eq!(
        faults(&tree_and(
            "<AlwaysSuccess/>",
            "<TreeNodesModel><Action/><Node ID=\"x\"/><Action ID=\"A\"><input_port type=\"int\"/></Action></TreeNodesModel>"
        )),
        [
            "model: line 5, column 17: expected the attribute ID in the model <Action>, found none",
            "model: line 5, column 26: expected a model <Action>, <Condition>, <Control>, <Decorator> or <SubTree>, \
             found <Node>",
            "model: line 5, column 55: expected the attribute name in <input_port>, found none"
        ]
    );
}

#[test]
fn depth() {
    let nested = |levels: usize| {
        tree(&format!("{}<AlwaysSuccess/>{}", "<Inverter>".repeat(levels), "</Inverter>".repeat(levels)))
    };
    assert!(warnings(&nested(253)).is_empty(), "root, BehaviorTree, 253 decorators and the leaf are 256");
    assert_eq!(
        faults(&nested(254)),
        ["depth: line 3, column 2541: expected at most 256 elements inside each other, found more"]
    );
    assert_eq!(refused(&"<a>".repeat(600_000))[0].code, "depth");
}

#[test]
fn depth_counts_what_subtrees_stand_for_without_building_it() {
    // Nodes: T0 11, T1 1 + 10 (1 + 11) = 121, T2 1221, T3 12 221, T4 122 221. In T4 the ninth SubTree is one too many:
    // 11 + 9 * 12 221 = 110 000.
    let define = |n: usize| {
        let leaf = if n == 0 { "<AlwaysSuccess/>".to_owned() } else { format!("<SubTree ID=\"T{}\"/>", n - 1) };
        format!("<BehaviorTree ID=\"T{n}\"><Sequence>{}</Sequence></BehaviorTree>", leaf.repeat(10))
    };
    let trees = (0..30).map(define).collect::<Vec<_>>().join("\n");
    let found = faults(&tree_and("<SubTree ID=\"T29\"/>", &trees));
    assert_eq!(
        found,
        ["depth: line 9, column 177: expected at most 100000 nodes in T4 with all its subtrees, found more"]
    );

    let link = |n| format!("<BehaviorTree ID=\"T{n}\"><SubTree ID=\"T{}\"/></BehaviorTree>", n + 1);
    let links = (0..20_000).map(link).collect::<Vec<_>>().concat();
    let chain = links + "<BehaviorTree ID=\"T20000\"><AlwaysSuccess/></BehaviorTree>";
    let found = faults(&tree_and("<AlwaysSuccess/>", &chain));
    assert_eq!(found.len(), 1);
    assert!(
        found[0].ends_with("expected at most 256 nodes inside each other in T19744 with all its subtrees, found more"),
        "{found:?}"
    );
}

#[test]
fn subtree_name() {
    let subtrees = "<Sequence><SubTree ID=\"S\" name=\"a\"/>\n<SubTree ID=\"S\" name=\"a\"/><SubTree ID=\"S\"/><SubTree ID=\"S\"/></Sequence>";
    assert_eq!(
        faults(&tree_and(subtrees, "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>")),
        [
            r#"subtree-name: line 4, column 1: expected another name for this SubTree, found "a" again (first: line 3, column 11)"#
        ]
    );
}

#[test]
fn include_is_not_supported() {
    assert_eq!(
        faults(&tree_and("<AlwaysSuccess/>", " <include path=\"x.xml\"/>")),
        ["include: line 5, column 2: include is not supported: put the trees of the other file into this one"]
    );
}

#[test]
fn what_the_reference_refuses_only_in_the_tick_is_a_warning() {
    let children = "<AlwaysSuccess/>".repeat(4);
    assert_eq!(
        warnings(&tree(&format!("<Parallel success_count=\"5\">{children}</Parallel>"))),
        [
            "threshold: line 3, column 26: expected at most 4 for port \"success_count\", the number of children, found 5"
        ]
    );
    assert_eq!(
        warnings(&tree(&format!("<IfThenElse>{children}</IfThenElse>"))),
        ["children: line 3, column 1: expected 2 to 3 children of IfThenElse, found 4"]
    );
    assert_eq!(
        warnings(&tree(&format!("<Switch2 variable=\"{{v}}\" case_1=\"a\" case_2=\"b\">{children}</Switch2>"))),
        ["children: line 3, column 1: expected 3 children of Switch2, found 4"]
    );
    assert_eq!(
        warnings(&tree("<Repeat><AlwaysSuccess/></Repeat>")),
        [r#"missing-port: line 3, column 1: expected the port "num_cycles" of Repeat, found none"#]
    );
    assert_eq!(
        warnings(&tree("<Script code=\" \"/>")),
        ["bad-script: line 3, column 15: the script of code is empty and does nothing"]
    );
    assert_eq!(
        warnings(&tree("<Condition ID=\"TestAction\"/>")),
        [r#"kind: line 3, column 1: expected <Action ID="TestAction">, found <Condition>"#]
    );
    assert_eq!(
        warnings("<root><BehaviorTree><AlwaysSuccess/></BehaviorTree></root>"),
        ["format: line 1, column 1: expected BTCPP_format=\"4\", found none; it is read as format 4"]
    );
    assert_eq!(
        warnings("<root BTCPP_format=\"3\"><BehaviorTree><AlwaysSuccess/></BehaviorTree></root>"),
        ["format: line 1, column 7: expected BTCPP_format=\"4\", found \"3\"; it is read as format 4"]
    );
    assert_eq!(
        warnings(&tree("<AlwaysSuccess/> stray")),
        ["xml: line 3, column 18: text between elements has no meaning here and is dropped"]
    );
}

#[test]
fn all_problems_are_reported_in_the_order_of_the_text() {
    let text = tree("<Sequence>\n<Nope/>\n<Inverter/>\n<Sleep msec=\"x\"/>\n<Script code=\"\"/></Sequence>");
    let codes: Vec<&str> = refused(&text).iter().map(|problem| problem.code).collect();
    assert_eq!(codes, ["unknown-node", "one-child", "bad-value", "bad-script"]);
    assert_eq!(refused(&text)[2].place, Place { line: 6, column: 14 });
}

#[test]
fn a_byte_order_mark_is_skipped() {
    assert!(warnings(&format!("\u{feff}{}", tree("<AlwaysSuccess/>"))).is_empty());
    assert_eq!(refused("\u{feff}<rot/>")[0].place, Place { line: 1, column: 1 });
}

/// Import, export, import: the same document, and the second export is the first one.
fn survives(text: &str) -> String {
    let (first, _) = accepted(text);
    let written = write(&first, &manifest());
    let (second, _) = accepted(&written);
    assert_eq!(first.without_places(), second.clone().without_places(), "{written}");
    assert_eq!(write(&second, &manifest()), written);
    written
}

#[test]
fn the_canonical_form() {
    let text = "<!-- head --><root BTCPP_format='4' project_name=\"P&quot;Q\"><!--t--><BehaviorTree ID='M' _fullpath='x'><!--s-->\
        <Sequence _uid='3' name='top'><Action ID='EchoPort' in=' {x}&#10;&lt;b' out='{=}' _skipIf='a &gt; 1'/><!--last--></Sequence>\
        <!--after--></BehaviorTree><!--m--><TreeNodesModel><!--a--><Action ID='Fly' editable='true'><!--p-->\
        <inout_port name='h' type='double' default='1' unit='m'> how &amp; high </inout_port><MetadataFields><Metadata colour='red'/>\
        <Metadata a='1' b='2'/></MetadataFields><!--z--></Action><!--e--></TreeNodesModel><!--r--></root><!--end-->";
    let expected = r#"<?xml version="1.0" encoding="UTF-8"?>
<!-- head -->
<root BTCPP_format="4" main_tree_to_execute="M" project_name="P&quot;Q">
  <!--t-->
  <BehaviorTree ID="M" _fullpath="x">
    <!--s-->
    <Sequence _uid="3" name="top">
      <Action ID="EchoPort" in=" {x}&#10;&lt;b" out="{=}" _skipIf="a &gt; 1"/>
      <!--last-->
    </Sequence>
    <!--after-->
  </BehaviorTree>
  <!--m-->
  <TreeNodesModel>
    <!--a-->
    <Action ID="Fly" editable="true">
      <!--p-->
      <inout_port name="h" type="double" default="1" unit="m">how &amp; high</inout_port>
      <MetadataFields>
        <Metadata colour="red"/>
        <Metadata a="1" b="2"/>
      </MetadataFields>
      <!--z-->
    </Action>
    <Action ID="EchoPort">
      <input_port name="in" type="std::string">what to copy</input_port>
      <output_port name="out" type="std::string">where to</output_port>
    </Action>
    <!--e-->
  </TreeNodesModel>
  <!--r-->
</root>
<!--end-->
"#;
    assert_eq!(survives(text), expected);
}

#[test]
fn round_trips() {
    survives("<root BTCPP_format=\"4\"><BehaviorTree><AlwaysSuccess/></BehaviorTree></root>");
    survives(
        "<root><BehaviorTree ID=\"x\"><Control ID=\"Sequence\"><Decorator ID=\"Inverter\"><TestCondition/></Decorator></Control></BehaviorTree></root>",
    );
    let written = survives(&tree_and(
        "<Sequence><SubTree ID=\"S\" name=\"first\" in=\"{goal}\" lit=\"3\" _post=\"x := 1\"/><SubTree _autoremap=\"true\" ID=\"S\"/></Sequence>",
        "<BehaviorTree ID=\"S\"><EchoPort in=\"{in}\" out=\"{out}\"/></BehaviorTree>",
    ));
    assert!(
        written.contains("<SubTree ID=\"S\" name=\"first\" in=\"{goal}\" lit=\"3\" _post=\"x := 1\"/>"),
        "{written}"
    );
    // The second tree may be the main one.
    let text = tree_and("<AlwaysSuccess/>", "<BehaviorTree ID=\"N\"><AlwaysFailure/></BehaviorTree>");
    let text = text.replace("execute=\"M\"", "execute=\"N\"");
    assert_eq!(accepted(&text).0.main, 1);
    survives(&text);
    survives(&tree("<AlwaysSuccess _description=\"tab&#9;line&#10;return&#13;end\"><!-- alone --></AlwaysSuccess>"));
}

#[test]
fn what_a_document_says_about_its_nodes() {
    let (document, _) = accepted(&tree_and(
        "<Parallel success_count=\"2\" _while=\"x &lt; 1\"><SubTree ID=\"S\" _autoremap=\"1\" p=\"{q}\"/><TestAction name=\"a\"/></Parallel>",
        "<BehaviorTree ID=\"S\"><AlwaysSuccess/></BehaviorTree>",
    ));
    let root = &document.main_tree().expect("a main tree").root;
    assert_eq!((root.name(), root.kind, root.explicit), ("Parallel", NodeKind::Control, false));
    assert_eq!(root.port("success_count").map(|port| port.value.as_str()), Some("2"));
    assert_eq!(root.condition(When::While).map(|script| script.value.as_str()), Some("x < 1"));
    let [subtree, action] = &root.children[..] else { panic!("two children") };
    assert_eq!((subtree.name(), subtree.tree.as_deref(), subtree.autoremap()), ("S", Some("S"), true));
    assert_eq!(subtree.ports().map(|port| port.name.as_str()).collect::<Vec<_>>(), ["p"]);
    assert_eq!((action.name(), action.place), ("a", Place { line: 3, column: 87 }));
    let mut names = Vec::new();
    document.each(&mut |element| names.push(element.name().to_owned()));
    assert_eq!(names, ["Parallel", "S", "a", "AlwaysSuccess"]);
    assert!(document.models.iter().all(|model| model.parts.iter().all(|part| matches!(part, ModelPart::Port(_)))));
}

#[test]
fn there_are_42_built_in_nodes() {
    let count = |kind: NodeKind| builtin_nodes().iter().filter(|node| node.kind == kind).count();
    assert_eq!(builtin_nodes().len(), 42);
    assert_eq!((count(NodeKind::Control), count(NodeKind::Decorator), count(NodeKind::SubTree)), (17, 16, 1));
    assert_eq!(count(NodeKind::Action) + count(NodeKind::Condition), 8);
    let defaults = builtin_nodes().into_iter().flat_map(|node| node.ports);
    for port in defaults.filter(|port| port.default.is_some()) {
        assert!(port.port_type.fits(port.default.as_deref().unwrap_or_default()), "{}", port.name);
    }
}

#[test]
fn a_leaf_is_registered_once_and_under_an_allowed_name() {
    let mut manifest = manifest();
    let mut error = |name: &str, kind| manifest.register(name, kind, vec![]).map_err(|error| error.to_string());
    assert_eq!(
        error("TestAction", NodeKind::Action),
        Err("expected a new name, found \"TestAction\" again".to_owned())
    );
    assert_eq!(error("a b", NodeKind::Action), Err("expected a node name without ' ', found \"a b\"".to_owned()));
    assert_eq!(
        error("Both", NodeKind::Control),
        Err("expected Action or Condition for \"Both\", found Control".to_owned())
    );
}

#[test]
fn the_cases_file_is_accepted_or_refused_as_the_reference_does() {
    let cases: Value = serde_json::from_str(include_str!("cases/behaviour_trees.json")).expect("JSON");
    let cases = cases["cases"].as_array().expect("a list");
    assert_eq!(cases.len(), 44);
    for case in cases {
        let (id, text) = (case["id"].as_str().expect("an id"), case["xml"].as_str().expect("a text"));
        if case["expect"]["error"] == "parse" {
            let problems = refused(text);
            assert!(problems.iter().any(|problem| !problem.warning && problem.place.line == 1), "{id}");
        } else {
            let (document, _) = accepted(text);
            assert!(document.is_runnable(), "{id}");
            survives(text);
        }
    }
}

#[test]
fn a_drawing_shows_every_node_and_escapes_names() {
    let text = "<root BTCPP_format=\"4\" main_tree_to_execute=\"M\"><BehaviorTree ID=\"M\"><Fallback _while=\"n &lt; 3\">\
                <Sequence><AlwaysSuccess/><Inverter><AlwaysFailure/></Inverter></Sequence><SubTree ID=\"S\"/></Fallback>\
                </BehaviorTree><BehaviorTree ID=\"S\"><AlwaysSuccess name=\"a_very_long_name_for_a_node\"/></BehaviorTree></root>";
    let (document, _) = read(text, &Manifest::default()).expect("valid XML");
    let svg = swarm_playground::bt::draw_svg(&document);
    let drawing = roxmltree::Document::parse(&svg).expect("a drawing is XML");
    let texts: Vec<&str> = drawing.descendants().filter_map(|node| node.text()).collect();
    for expected in ["M", "S", "? Fallback", "Fallback _while", "a_very_long_name_for_a_node"] {
        assert!(texts.contains(&expected), "{expected} in {texts:?}");
    }
    // One rectangle a node, and the ground.
    assert_eq!(drawing.descendants().filter(|node| node.has_tag_name("rect")).count(), 8);
}
