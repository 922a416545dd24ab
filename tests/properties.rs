//! Laws that hold for any input: random text never makes the readers panic, and what they accept is sound.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use serde_json::Value;
use swarm_playground::evolution::{Grammar, Limits, Mapper, Phenotype, RuleId};
use swarm_playground::geese::{Compiler, Derived};
use swarm_playground::scenario::{Run, Scenario, schema};

/// Text made of the pieces that grammars are made of, so that much of it is nearly one.
fn nearly_grammar() -> impl Strategy<Value = String> {
    let pieces = [
        "<a>",
        "<b>",
        "<a> ::= ",
        "<b> ::= ",
        "::=",
        "|",
        " | ",
        "\n",
        "x",
        "Seq[",
        "Sel[",
        "]",
        "Post(",
        ")",
        "not ",
        "NeighbourObjects ",
        "Explore",
        "Hub",
        "Food",
        "<",
        ">",
        "é",
        "\t",
        "#",
    ];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..40).prop_map(|pieces| pieces.concat())
}

/// A JSON object with fields of the schema and values that may or may not fit.
fn nearly_scenario() -> impl Strategy<Value = Value> {
    let names: Vec<String> = schema()
        .as_array()
        .expect("a list")
        .iter()
        .map(|entry| entry["key"].as_str().expect("a key").trim_start_matches("geese.").to_owned())
        .chain(["events", "title", "agnets", ""].map(str::to_owned))
        .collect();
    let value = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        (-5_i64..300).prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        prop::sample::select(vec!["always", "bit", "codon", "turning", "<a> ::= Explore", "~"]).prop_map(Value::from),
        Just(serde_json::json!([{"tick": 1, "key": "geese.children", "value": 3}])),
        Just(serde_json::json!([{"tick": -1}])),
    ];
    prop::collection::btree_map(prop::sample::select(names), value, 0..5).prop_map(|fields| {
        let mut object: serde_json::Map<String, Value> = fields.into_iter().collect();
        object.insert("world".to_owned(), Value::from("geese"));
        Value::Object(object)
    })
}

proptest! {
    #[test]
    fn any_text_is_a_grammar_or_an_error_within_it(text in any::<String>()) {
        if let Err(error) = Grammar::parse(&text) {
            prop_assert!(error.place().line >= 1 && error.place().column >= 1);
            prop_assert!(error.place().line as usize <= text.lines().count().max(1));
        }
    }

    #[test]
    fn text_like_a_grammar_is_one_or_an_error_within_it(text in nearly_grammar(), codons in prop::collection::vec(any::<u16>(), 0..60)) {
        match Grammar::parse(&text) {
            Err(error) => {
                let line = text.lines().nth(error.place().line as usize - 1).unwrap_or_default();
                prop_assert!(error.place().column as usize <= line.chars().count() + 1, "{error}");
            }
            Ok(grammar) => {
                let limits = Limits { max_wraps: 2, max_depth: 12 };
                let mut phenotype = Phenotype::new(&grammar);
                if let Ok(mapped) = Mapper::new(&grammar).map(codons.as_slice(), limits, &mut phenotype) {
                    prop_assert!(mapped.depth <= 12 && mapped.depth >= grammar.least_depth());
                    prop_assert!(mapped.used as usize <= codons.len() * 3);
                }
                // Where it is a language too, every genome gives a tree or a reason.
                if let Ok(mut compiler) = Compiler::new(&text, limits) {
                    let derived = serde_json::to_value(Derived::of(&mut compiler, &codons)).expect("it is JSON");
                    prop_assert_eq!(derived["valid"].as_bool(), Some(derived["reason"].is_null()));
                    prop_assert_eq!(derived["nodes"].is_null(), derived["phenotype"].is_null());
                }
            }
        }
    }

    #[test]
    fn writing_a_grammar_from_its_tables_and_reading_it_gives_the_same_tables(text in nearly_grammar()) {
        if let Ok(grammar) = Grammar::parse(&text) {
            let write = |rule: u16| {
                let rule = RuleId(rule);
                let alternatives: Vec<String> = grammar.alternatives(rule).map(|id| grammar.alternative_text(id)).collect();
                format!("<{}> ::= {}\n", grammar.rule_name(rule), alternatives.join(" | "))
            };
            let written: String = (0..grammar.rule_count()).map(write).collect();
            let again = Grammar::parse(&written).expect("what was written is a grammar");
            prop_assert_eq!(again.terminals(), grammar.terminals());
            prop_assert_eq!(again.rule_count(), grammar.rule_count());
        }
    }

    #[test]
    fn any_text_is_a_scenario_or_an_error(text in any::<String>()) {
        prop_assert!(Scenario::read(&text).is_err());
    }

    #[test]
    fn a_scenario_that_is_accepted_survives_writing(value in nearly_scenario()) {
        match Scenario::from_value(&value) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(scenario) => prop_assert_eq!(&Scenario::from_value(&scenario.to_value()).expect("valid"), &scenario),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_small_world_of_any_parameters_runs(value in nearly_scenario()) {
        if let Ok(scenario) = Scenario::from_value(&value).and_then(|scenario| scenario.with("agents", &Value::from(8)))
            && let Ok(mut run) = Run::new(scenario)
        {
            run.advance(5);
            prop_assert!(run.tick() <= 5);
        }
    }
}
