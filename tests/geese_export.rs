//! Evolved programs as documents: canonical, and the same programs when they are read back.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::BTreeSet;
use swarm_playground::bt::xml::{Document, Element, Manifest, NodeKind, read, write};
use swarm_playground::bt::{Builder, Tree};
use swarm_playground::evolution::Limits;
use swarm_playground::geese::{
    Compiler, Controller, Detail, Leaf, Manner, Name, Object, Query, Tag, Task, World, export_agent, export_query,
    grammar_text, program_text, write_xml,
};
use swarm_playground::scenario::{Run, Scenario};

/// The built-in PPA grammar for foraging.
fn ppa() -> String {
    grammar_text("ppa", Task::Forage).into_owned()
}

fn compiler(grammar: &str, max_depth: u32) -> Compiler {
    Compiler::new(grammar, Limits { max_wraps: 0, max_depth }).expect("the grammar is valid")
}

/// The tree of a genome; `None` when it maps to none.
fn grown(compiler: &mut Compiler, codons: &[u16]) -> Option<Tree<Leaf>> {
    let mut controller = Controller::default();
    compiler.compile(codons, &mut controller).ok()?;
    controller.tree().cloned()
}

/// What a written document says, after it was found valid and canonical.
fn understood(xml: &str) -> Document {
    let (document, _) = read(xml, &Manifest::default()).unwrap_or_else(|problems| panic!("{problems:#?}\n{xml}"));
    assert_eq!(write(&document, &Manifest::default()), xml);
    let mut manifest = Manifest::default();
    for model in &document.models {
        let node = model.node_type();
        manifest.register(&node.name, node.kind, node.ports).expect("a leaf with a new name");
    }
    let (document, warnings) = read(xml, &manifest).expect("it was valid without the leaves");
    assert_eq!(warnings, [], "{xml}");
    assert!(document.is_runnable());
    let mut used = BTreeSet::new();
    document.each(&mut |element| {
        if matches!(element.kind, NodeKind::Action | NodeKind::Condition) {
            used.insert(element.type_name.as_str());
        }
    });
    let declared: Vec<&str> = document.models.iter().map(|model| model.id.as_str()).collect();
    assert_eq!(declared.len(), used.len(), "a model for each leaf type used: {declared:?}");
    document
}

/// The program that an element stands for, in the form of `program_text`.
fn program_of(element: &Element) -> String {
    let attribute = |name: &str| {
        let found = element.attributes.iter().find(|attribute| attribute.name == name);
        found.map(|attribute| attribute.value.as_str())
    };
    let tagged = |text: String| match attribute("_tag") {
        Some(tag) => format!("{tag}({text})"),
        None => text,
    };
    let children = || element.children.iter().map(program_of).collect::<Vec<_>>().join(" ");
    match element.type_name.as_str() {
        "Sequence" => format!("Seq[{}]", children()),
        "Fallback" => format!("Sel[{}]", children()),
        "Inverter" => tagged(format!("not {}", children())),
        name => {
            // A place or an item, and how to move.
            let arguments: Vec<&str> = element.ports().map(|port| port.value.as_str()).collect();
            let words = [&[name], arguments.as_slice()].concat();
            assert_eq!(element.name(), words.join("_"));
            tagged(words.join(" "))
        }
    }
}

fn assert_same(xml: &str, program: &str) {
    let document = understood(xml);
    assert_eq!(program_of(&document.trees[0].root), program, "{xml}");
}

#[test]
fn a_program_is_written_with_ports_tags_and_inverters() {
    let mut compiler = compiler(&ppa(), 11);
    // Section 4.5 of the mapping's worked examples, with a second postcondition and a negated precondition.
    let codons = [12, 3, 6, 8, 5, 8, 9, 0, 0, 1, 18, 11, 6, 0, 15, 2, 0, 1, 10, 33];
    let tree = grown(&mut compiler, &codons).expect("a program");
    let program = "Sel[Sel[Seq[Post(NeighbourObjects Sites) Post(IsCarrying Food)] \
                   Seq[Seq[Pre(not NeighbourObjects Sites)] Act(MoveTowards Sites)]]]";
    assert_eq!(program_text(&tree), program);
    let expected = r#"<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="Agent_7">
  <BehaviorTree ID="Agent_7">
    <Fallback>
      <Fallback>
        <Sequence>
          <NeighbourObjects name="NeighbourObjects_Sites" object="Sites" _tag="Post"/>
          <IsCarrying name="IsCarrying_Food" item="Food" _tag="Post"/>
        </Sequence>
        <Sequence>
          <Sequence>
            <Inverter _tag="Pre">
              <NeighbourObjects name="NeighbourObjects_Sites" object="Sites"/>
            </Inverter>
          </Sequence>
          <MoveTowards name="MoveTowards_Sites" place="Sites" _tag="Act"/>
        </Sequence>
      </Fallback>
    </Fallback>
  </BehaviorTree>
  <TreeNodesModel>
    <Condition ID="NeighbourObjects">
      <input_port name="object" type="std::string" default=""/>
    </Condition>
    <Condition ID="IsCarrying">
      <input_port name="item" type="std::string"/>
    </Condition>
    <Action ID="MoveTowards">
      <input_port name="place" type="std::string"/>
    </Action>
  </TreeNodesModel>
</root>
"#;
    let xml = write_xml(&tree, "Agent_7");
    assert_eq!(xml, expected);
    assert_same(&xml, program);
}

fn evolved(ticks: u32) -> Run {
    let scenario = Scenario::read(include_str!("../scenarios/foraging.json")).expect("the preset is valid");
    let mut run = Run::new(scenario).expect("the preset builds");
    assert_eq!(run.advance(ticks), ticks);
    run
}

/// The program an agent ran in the last step, as the inspector shows it.
fn shown(world: &mut World, agent: u32) -> String {
    let detail = Detail::of(world, &Query { agent: Some(agent), ..Query::default() });
    let detail = serde_json::to_value(detail).expect("it is JSON");
    detail["tree"]["text"].as_str().expect("the agent has a tree").to_owned()
}

#[test]
fn every_evolved_program_is_the_one_shown() {
    let mut run = evolved(0);
    let mut programs = BTreeSet::new();
    for _ in 0..3 {
        run.advance(100);
        let world = run.geese_mut().expect("the world of the preset");
        for agent in 0..world.params().agents {
            let xml = export_agent(world, agent).expect("the agent exists");
            let program = shown(world, agent);
            assert!(xml.contains(&format!("<BehaviorTree ID=\"Agent_{agent}\">")), "{xml}");
            assert_same(&xml, &program);
            programs.insert(program);
        }
        assert_eq!(export_agent(world, world.params().agents), None);
        let program = Detail::of(world, &Query { agent: Some(3), ..Query::default() });
        let program = serde_json::to_value(program).expect("it is JSON")["agent"]["program"].clone();
        let asked = |query: serde_json::Value| export_query(world, &Query::from_value(&query));
        assert_eq!(asked(serde_json::json!({"agent": 3})), export_agent(world, 3));
        let first = asked(serde_json::json!({"program": program})).expect("somebody runs it");
        let bodies = |xml: &str| {
            xml.split("<BehaviorTree").nth(1).and_then(|rest| rest.split_once('>')).map(|split| split.1.to_owned())
        };
        assert_eq!(bodies(&first), bodies(&export_agent(world, 3).expect("the agent exists")));
        assert_eq!(asked(serde_json::json!({"program": "none"})), None);
    }
    assert!(programs.len() > 30, "many distinct programs were written: {}", programs.len());
}

#[test]
fn every_leaf_that_can_be_written_is_read_back() {
    for name in Name::ALL {
        for object in Object::ALL.into_iter().chain([Object::Nothing]) {
            for (tag, negated) in [(Tag::None, false), (Tag::None, true), (Tag::Post, false), (Tag::Con, true)] {
                let takes = name.takes() != swarm_playground::geese::Takes::Nothing;
                if takes == (object == Object::Nothing) {
                    continue;
                }
                for manner in Manner::ALL.into_iter().filter(|&manner| manner == Manner::Avoid || name.moves()) {
                    let mut builder = Builder::default();
                    builder.leaf(Leaf { name, object, tag, negated, manner });
                    let tree = builder.finish().expect("a leaf is a tree");
                    assert_same(&write_xml(&tree, "One"), &program_text(&tree));
                }
            }
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
mod laws {
    use super::{assert_same, compiler, grown, ppa, program_text, write_xml};
    use proptest::prelude::*;

    /// A grammar with everything that the default one leaves out: no tags, no argument, several nodes at the top.
    const PLAIN: &str = "\
<S> ::= <node> | <node> <S>
<node> ::= Seq[<S>] | Sel[<S>] | <call> | Cond(<call>) | Act(<call>)
<call> ::= NeighbourObjects | not NeighbourObjects | NeighbourObjects <o> | not NeighbourObjects <o>
  | IsVisitedBefore <s> | not IsVisitedBefore <s> | IsCarrying Food | not IsCarryable Food | IsDropable <s>
  | CanMove | not DummyNode | MoveTowards <s> | MoveAway <s> <t> | Explore <t> | CompositeSingleCarry Food
  | not CompositeDrop Food
<o> ::= <s> | Food
<s> ::= Hub | Sites
<t> ::= Normal | Avoid
";

    proptest! {
        #[test]
        fn any_program_is_read_back_as_it_was(
            codons in prop::collection::vec(any::<u16>(), 1..200),
            plain in any::<bool>(),
            max_depth in 8_u32..40,
        ) {
            let ppa = ppa();
            let mut compiler = compiler(if plain { PLAIN } else { &ppa }, max_depth);
            if let Some(tree) = grown(&mut compiler, &codons) {
                assert_same(&write_xml(&tree, "Any_1"), &program_text(&tree));
            }
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
#[ignore = "writes what scripts/peer.py opens in another implementation, into the folder PEER_FOLDER"]
fn documents_for_the_peer_are_written() {
    let folder = std::env::var("PEER_FOLDER").expect("a folder");
    let mut documents = Vec::new();
    for ticks in [0, 200] {
        let run = evolved(ticks);
        let world = run.geese().expect("the world of the preset");
        documents.extend((0..20).filter_map(|agent| export_agent(world, agent)));
    }
    let path = std::path::Path::new(&folder).join("evolved.json");
    std::fs::write(path, serde_json::to_string(&documents).expect("texts")).expect("a folder that can be written");
}
