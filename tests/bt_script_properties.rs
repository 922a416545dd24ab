//! Laws of scripts: no text makes the reader or a run panic, and faults lie inside the text.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use swarm_playground::bt::Value;
use swarm_playground::bt::script::{Entries, Script};

/// Entries by slot; even slots begin as numbers, texts and queues in turn, odd ones are missing.
struct Board(Vec<Option<Value>>);

impl Board {
    fn new(size: usize) -> Self {
        let value = |slot: usize| match slot % 6 {
            0 => Some(Value::Number(slot as f64)),
            2 => Some(Value::Text("12".to_owned())),
            4 => Some(Value::Queue(vec![])),
            _ => None,
        };
        Self((0..size).map(value).collect())
    }
}

impl Entries for Board {
    fn get(&self, slot: usize, _name: &str) -> Option<&Value> {
        self.0[slot].as_ref()
    }

    fn enum_value(&self, name: &str) -> Option<f64> {
        (name == "RED").then_some(2.0)
    }

    fn assign(&mut self, slot: usize, _name: &str, value: Value, create: bool) -> Result<(), String> {
        if self.0[slot].is_none() && !create {
            return Err("missing".to_owned());
        }
        self.0[slot] = Some(value);
        Ok(())
    }
}

/// Text made of the pieces that scripts are made of, so that much of it is nearly one.
fn soup() -> impl Strategy<Value = String> {
    let pieces = [
        "a", "b", "@c", "RED", "nosuch", "true", "1", "0x1F", "2.5", "1e3", "65.", "'x'", "'12'", "''", "'", ":=", "=",
        "+=", "-=", "*=", "/=", "?", ":", "||", "&&", "==", "!=", "<", "<=", ">", ">=", "|", "^", "&", "+", "-", "..",
        "*", "/", "~", "!", "(", ")", ";", " ", "\n", "é", ".",
    ];
    prop::collection::vec(prop::sample::select(pieces.to_vec()), 0..40).prop_map(|pieces| pieces.concat())
}

/// Operands with operators or semicolons between them: always a script, of values that often do not fit.
fn sentence() -> impl Strategy<Value = String> {
    let operands = [
        "a",
        "-a",
        "!b",
        "~ 3",
        "c",
        "d",
        "e",
        "(a := 2)",
        "(b := 'x')",
        "(a += 1)",
        "(c += c)",
        "(a ? b : 2)",
        "RED",
        "1",
        "0x1F",
        "2.5",
        "1e300",
        "'x'",
        "'12'",
        "'true'",
        "''",
    ];
    let operators = [
        "+", "-", "*", "/", "..", "&", "|", "^", "&&", "||", "==", "!=", "<", "<=", ">", ">=", ";", ";a:=", ";b:=",
        " c ",
    ];
    let pair = (prop::sample::select(operands.to_vec()), prop::sample::select(operators.to_vec()))
        .prop_map(|(operand, operator)| [operand, " ", operator, " "].concat());
    prop::collection::vec(pair, 1..12).prop_map(|pairs| pairs.concat() + "a")
}

/// A number expression that is written with every parenthesis, and its value.
fn sum() -> impl Strategy<Value = (String, f64)> {
    let leaf = (0..100_u32).prop_map(|number| (number.to_string(), f64::from(number)));
    leaf.prop_recursive(6, 60, 2, |inner| {
        (inner.clone(), prop::sample::select(vec!["+", "-", "*", "<", "&&"]), inner).prop_map(
            |(left, operator, right)| {
                let value = match operator {
                    "+" => left.1 + right.1,
                    "-" => left.1 - right.1,
                    "*" => left.1 * right.1,
                    "<" => f64::from(u8::from(left.1 < right.1)),
                    _ => f64::from(u8::from(left.1 != 0.0 && right.1 != 0.0)),
                };
                (format!("({}{operator}{})", left.0, right.0), value)
            },
        )
    })
}

fn try_out(text: &str) {
    match Script::parse(text) {
        Ok(script) => {
            let mut names = script.names().to_vec();
            names.sort();
            names.dedup();
            assert_eq!(names.len(), script.names().len(), "a name twice in {text:?}");
            let mut board = Board::new(names.len());
            if let Err(message) = script.run(&mut board) {
                assert!(!message.is_empty());
            }
        }
        Err(error) => {
            assert!(error.at <= text.chars().count(), "{error} in {text:?}");
            assert!(error.message.contains("expected"), "{error}");
        }
    }
}

proptest! {
    #[test]
    fn random_text_never_panics(text in any::<String>()) {
        try_out(&text);
    }

    #[test]
    fn token_soup_never_panics(text in soup()) {
        try_out(&text);
    }

    #[test]
    fn operands_with_operators_between_always_parse_and_never_panic(text in sentence()) {
        let parsed = Script::parse(&text);
        prop_assert!(parsed.is_ok(), "{parsed:?}");
        try_out(&text);
    }

    #[test]
    fn sums_have_the_value_of_the_same_sum_in_rust((text, value) in sum()) {
        let script = Script::parse(&text).expect("a script");
        prop_assert_eq!(script.run(&mut Board::new(0)), Ok(Value::Number(value)));
    }
}
