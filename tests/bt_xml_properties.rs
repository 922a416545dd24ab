//! Laws of the XML of behaviour trees: no text makes the reader panic, and what it accepts survives write and read.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use swarm_playground::bt::xml::{Direction, Manifest, NodeKind, Port, PortType, Problem, read, write};

fn manifest() -> Manifest {
    let mut manifest = Manifest::default();
    let ports = vec![
        Port::new("in", Direction::In, PortType::Text, "a text"),
        Port::new("out", Direction::Out, PortType::Any, "").optional(),
        Port::new("speed", Direction::In, PortType::Real, "metres < miles & \"more\"").with_default("1.5"),
    ];
    manifest.register("Act", NodeKind::Action, ports).expect("a new name");
    manifest.register("Look", NodeKind::Condition, vec![]).expect("a new name");
    manifest
}

/// Text made of the pieces that documents are made of, so that much of it is nearly one.
fn nearly_xml() -> impl Strategy<Value = String> {
    let pieces = [
        "<root BTCPP_format=\"4\">",
        "<root main_tree_to_execute=\"A\">",
        "</root>",
        "<BehaviorTree ID=\"A\">",
        "<BehaviorTree ID='B'>",
        "</BehaviorTree>",
        "<TreeNodesModel>",
        "</TreeNodesModel>",
        "<Sequence>",
        "</Sequence>",
        "<Inverter>",
        "</Inverter>",
        "<SubTree ID=\"A\"/>",
        "<SubTree ID=\"B\" name=\"n\" x=\"{y}\"/>",
        "<Action ID=\"Act\" in=\"1\"/>",
        "<Act",
        " in=\"&lt;&#x20;é\r\n\"",
        " _skipIf='1 &gt; #'",
        " code=\"a :=",
        "<Script",
        "<input_port name=\"1\">",
        "</input_port>",
        "<MetadataFields><Metadata a=\"b\"/></MetadataFields>",
        "<!-- c -->",
        "<!--",
        "-->",
        "<![CDATA[",
        "]]>",
        "<?pi",
        "?>",
        "<!DOCTYPE a>",
        "&a;",
        "xmlns:p=\"u\"",
        "<p:a",
        " ",
        "\n",
        "\t",
        "=",
        "\"",
        "'",
        "/>",
        ">",
        "<",
        "/",
        "é",
        "\u{feff}",
    ];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..40).prop_map(|pieces| pieces.concat())
}

/// Every place lies in the text, and a refusal has a reason.
fn sound(text: &str, outcome: &Result<impl Sized, Vec<Problem>>) {
    let Err(problems) = outcome else { return };
    assert!(problems.iter().any(|problem| !problem.warning));
    let lines: Vec<usize> = text.trim_start_matches('\u{feff}').split('\n').map(|line| line.chars().count()).collect();
    for problem in problems {
        let length = lines.get(problem.place.line as usize - 1).copied();
        assert!(length.is_some_and(|length| (1..=length + 1).contains(&(problem.place.column as usize))), "{problem}");
    }
}

/// A value as it stands in the text: characters that matter to XML, escaped.
fn value() -> impl Strategy<Value = String> {
    let pieces =
        ["a", "{x}", "&lt;", "&gt;", "&amp;", "&quot;", "'", "é", "&#10;", "&#9;", "&#13;", " ", "\n", ";", "-"];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..6).prop_map(|pieces| pieces.concat())
}

fn comment() -> impl Strategy<Value = String> {
    prop::option::of("[ a-zé<>&\n]{0,9}").prop_map(|text| text.map_or(String::new(), |text| format!("<!--{text}-->")))
}

/// A sound node, in either form, with comments.
fn node() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("<AlwaysSuccess/>".to_owned()),
        Just("<Condition ID=\"Look\" name=\"see\"/>".to_owned()),
        Just("<SubTree ID=\"Sub\" goal=\"{g}\" _autoremap=\"true\"/>".to_owned()),
        (value(), value(), comment())
            .prop_map(|(port, note, comment)| format!("<Act in=\"{port}\" _note=\"{note}\">{comment}</Act>")),
        Just("<Fly speed=\"{v}\" _post=\"n := 1\"/>".to_owned()),
    ];
    leaf.prop_recursive(5, 24, 3, |inner| {
        let control =
            ["Sequence", "Control ID=\"Fallback\"", "Parallel success_count=\"1\"", "ReactiveSequence _uid=\"7\""];
        let decorator = ["Inverter", "Decorator ID=\"Repeat\" num_cycles=\"3\"", "LoopInt queue=\"1;2\" value=\"{v}\""];
        let wrap = |tag: &str, inner: String| format!("<{tag}>{inner}</{}>", tag.split(' ').next().unwrap_or(tag));
        prop_oneof![
            (
                prop::sample::select(control.to_vec()),
                prop::collection::vec((comment(), inner.clone()), 1..4),
                comment()
            )
                .prop_map(move |(tag, children, last)| {
                    let children: String = children.into_iter().map(|(comment, child)| comment + &child).collect();
                    wrap(tag, children + &last)
                }),
            (prop::sample::select(decorator.to_vec()), inner).prop_map(move |(tag, inner)| wrap(tag, inner)),
        ]
    })
}

fn document() -> impl Strategy<Value = String> {
    (comment(), node(), comment(), value(), comment()).prop_map(|(head, node, between, text, end)| {
        format!(
            "{head}<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">{between}<BehaviorTree ID=\"Main\">{node}\
             </BehaviorTree>{between}<BehaviorTree ID=\"Sub\"><AlwaysSuccess/>{end}</BehaviorTree>{end}<TreeNodesModel>\
             {between}<Action ID=\"Fly\"><input_port name=\"speed\" type=\"double\" unit=\"{text}\">{text}</input_port>\
             <MetadataFields><Metadata note=\"{text}\"/>{end}</MetadataFields></Action>{end}</TreeNodesModel></root>{end}"
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>()) {
        sound(&text, &read(&text, &manifest()));
    }

    #[test]
    fn no_soup_makes_the_reader_panic(text in nearly_xml()) {
        sound(&text, &read(&text, &manifest()));
    }

    #[test]
    fn no_damage_makes_the_reader_panic(text in document(), from in any::<prop::sample::Index>(), soup in nearly_xml()) {
        let mut characters: Vec<char> = text.chars().collect();
        let from = from.index(characters.len());
        let to = characters.len().min(from + soup.len() / 2);
        characters.splice(from..to, soup.chars());
        let text: String = characters.into_iter().collect();
        sound(&text, &read(&text, &manifest()));
    }

    #[test]
    fn sound_documents_survive_write_and_read(text in document()) {
        let manifest = manifest();
        let (first, _) = read(&text, &manifest).unwrap_or_else(|problems| panic!("{text}\n{problems:#?}"));
        let written = write(&first, &manifest);
        let (second, _) = read(&written, &manifest).unwrap_or_else(|problems| panic!("{written}\n{problems:#?}"));
        prop_assert_eq!(&write(&second, &manifest), &written);
        prop_assert_eq!(first.without_places(), second.without_places());
    }
}
