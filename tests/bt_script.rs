//! Scripts: what each operator does, how they bind, what the messages say and where they point.

use std::collections::BTreeMap;
use swarm_playground::bt::Value;
use swarm_playground::bt::script::{Entries, Script};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Entries by name, and one enum.
#[derive(Default)]
struct Board {
    entries: BTreeMap<String, Value>,
}

impl Entries for Board {
    fn get(&self, _slot: usize, name: &str) -> Option<&Value> {
        self.entries.get(name)
    }

    fn enum_value(&self, name: &str) -> Option<f64> {
        (name == "RED").then_some(2.0)
    }

    fn assign(&mut self, _slot: usize, name: &str, value: Value, create: bool) -> Result<(), String> {
        if !create && !self.entries.contains_key(name) {
            return Err(format!("unknown name \"{name}\", write := to create it"));
        }
        self.entries.insert(name.to_owned(), value);
        Ok(())
    }
}

fn run_on(board: &mut Board, text: &str) -> Result<Value, String> {
    Script::parse(text).map_err(|error| error.to_string())?.run(board)
}

fn run(text: &str) -> Result<Value, String> {
    run_on(&mut Board::default(), text)
}

#[track_caller]
fn gives(text: &str, expected: f64) {
    assert_eq!(run(text), Ok(Value::Number(expected)), "{text}");
}

#[track_caller]
fn gives_text(text: &str, expected: &str) {
    assert_eq!(run(text), Ok(Value::Text(expected.to_owned())), "{text}");
}

#[track_caller]
fn fails(text: &str, message: &str) {
    assert_eq!(run(text), Err(message.to_owned()), "{text}");
}

#[track_caller]
fn refused(text: &str, at: usize, message: &str) {
    let error = Script::parse(text).expect_err(text);
    assert_eq!((error.at, error.message.as_str()), (at, message), "{text}");
}

#[test]
fn literals_are_numbers_and_texts() {
    gives("12", 12.0);
    gives("0x1F", 31.0);
    gives("0XfF", 255.0);
    gives("1.5", 1.5);
    gives("1e3", 1000.0);
    gives("1.5E-1", 0.15);
    gives("2e+2", 200.0);
    gives("007", 7.0);
    gives("true", 1.0);
    gives("false", 0.0);
    gives("9223372036854775807", 9_223_372_036_854_775_807.0);
    gives_text("'a \"b\" \\n é'", "a \"b\" \\n é");
    gives_text("''", "");
}

#[test]
fn arithmetic_is_that_of_reals() {
    gives("7/2", 3.5);
    gives("1/0", f64::INFINITY);
    gives("-1/0", f64::NEG_INFINITY);
    gives("1 + 2 - 5", -2.0);
    gives("8 - 3 - 2", 3.0);
    gives("8 / 4 / 2", 1.0);
    gives("2 * -3", -6.0);
    gives("--3", 3.0);
    gives("!0", 1.0);
    gives("!0.5", 0.0);
    gives("!!7", 1.0);
    gives("~5", -6.0);
    gives("-~!3", 1.0); // !3 = 0, ~0 = -1, -(-1) = 1
}

#[test]
fn bits_need_whole_numbers() {
    gives("6 & 3", 2.0);
    gives("6 | 3", 7.0);
    gives("6 ^ 3", 5.0);
    gives("-1 & 255", 255.0);
    fails("6 & 2.5", "expected whole numbers of 64 bits for \"&\", found 2.5");
    fails("2.5 | 1", "expected whole numbers of 64 bits for \"|\", found 2.5");
    fails("1 ^ 1/0", "expected whole numbers of 64 bits for \"^\", found inf");
    fails("~0.5", "expected whole numbers of 64 bits for \"~\", found 0.5");
    fails("~1e19", "expected whole numbers of 64 bits for \"~\", found 10000000000000000000");
    fails("9223372036854775807 & 1", "expected whole numbers of 64 bits for \"&\", found 9223372036854776000");
}

#[test]
fn each_level_binds_tighter_than_the_one_before() {
    gives("6 & 3 == 2", 1.0); // (6 & 3) == 2, not 6 & (3 == 2) = 0
    gives("n := 1 ? 2 : 3; n", 2.0); // the choice before the assignment
    gives("0 || 1 ? 5 : 6", 5.0); // not 0 || (1 ? 5 : 6) = 1
    gives("1 || 1 && 0", 1.0); // not (1 || 1) && 0 = 0
    gives("1 && 2 == 2", 1.0);
    gives("2 == 1 && 0", 0.0);
    gives("1 | 2 == 3", 1.0);
    gives("4 ^ 6 & 3", 6.0); // 4 ^ 2, not 2 & 3
    gives("4 | 1 ^ 1", 4.0); // from left to right: 5 ^ 1 = 4
    gives("6 & 1 + 1", 2.0); // 6 & 2, not 0 + 1
    gives("1 + 2 * 3", 7.0);
    gives("(1 + 2) * 3", 9.0);
    gives("-2 + 3", 1.0);
    gives("!1 == 0", 1.0); // (!1) == 0
    gives_text("'n' .. 2 * 3", "n6");
    // From left to right: ('n' .. 1) + 1.
    fails("'n' .. 1 + 1", "expected two numbers or two texts around \"+\", found the text 'n1' and the number 1");
}

#[test]
fn comparisons_may_be_chained() {
    gives("1 < 3 < 5", 1.0);
    gives("1 < 5 < 3", 0.0);
    gives("3 > 2 >= 2 == 2 != 1", 1.0);
    gives("5 > 4 > 3 > 2", 1.0);
    gives("(5 > 4) > 3", 0.0); // 1 > 3
    gives("3 == 3 == 1", 0.0); // not (3 == 3) == 1
    gives("2 < 1 < nosuch", 0.0); // ends with the first that is false
    fails("1 < 2 < nosuch", "unknown name \"nosuch\"");
}

#[test]
fn equality_has_the_tolerance_of_f32_and_order_has_none() {
    gives("1 == 1.0000001", 1.0);
    gives("1 == 1.0000002", 0.0);
    gives("1 != 1.0000001", 0.0);
    gives("1 < 1.0000001", 1.0);
    gives("1 <= 1", 1.0);
    gives("2 <= 1", 0.0);
    gives("1 >= 2", 0.0);
    // As in the reference: the difference of infinities is no number, and no number is above or below it.
    gives("1/0 == 1/0", 0.0);
    gives("1/0 != 1/0", 1.0);
    gives("0/0 < 1", 1.0);
    gives("0/0 > 1", 1.0);
}

#[test]
fn and_and_or_evaluate_both_sides() {
    gives("2 && 3", 1.0);
    gives("2 && 0", 0.0);
    gives("0 || 0.5", 1.0);
    gives("0 || 0", 0.0);
    fails("0 && nosuch", "unknown name \"nosuch\"");
    fails("1 || nosuch", "unknown name \"nosuch\"");
    gives("n := 0; 1 || (n := 5); n", 5.0);
    fails("'a' && 1", "expected two numbers around \"&&\", found the text 'a' and the number 1");
}

#[test]
fn choices_evaluate_one_side() {
    gives("1 ? 2 : nosuch", 2.0);
    gives("0 ? nosuch : 3", 3.0);
    gives("0 ? 1 : 0 ? 2 : 3", 3.0);
    gives("1 ? 0 ? 1 : 2 : 3", 2.0);
    gives("n := 0; 1 ? n := 4 : 5; n", 4.0);
    gives_text("'a' ? 'yes' : 'no'", "yes");
    fails("'' ? 1 : 2", "expected a number or a text before \"?\", found an empty text");
}

#[test]
fn texts_are_joined() {
    gives_text("'a' + 'b' + 'c'", "abc");
    gives_text("'a' .. 'b'", "ab");
    gives_text("'n' .. 1", "n1");
    gives_text("2.5 .. 'm'", "2.5m");
    gives_text("1 + 1 .. 'x'", "2x");
    gives_text("1..'x'", "1x");
    gives_text("'n' .. 7 / 2", "n3.5");
    fails("'a' + 1", "expected two numbers or two texts around \"+\", found the text 'a' and the number 1");
    fails("1 .. 2", "expected a text and a text or number around \"..\", found the number 1 and the number 2");
    fails("'a' * 2", "expected two numbers around \"*\", found the text 'a' and the number 2");
    fails("-'a'", "expected a number after \"-\", found the text 'a'");
    fails("!'a'", "expected a number after \"!\", found the text 'a'");
    fails("~'a'", "expected a number after \"~\", found the text 'a'");
}

#[test]
fn texts_are_compared_and_converted() {
    gives("'a' == 'a'", 1.0);
    gives("'a' != 'b'", 1.0);
    gives("'a' < 'b' <= 'b'", 1.0);
    gives("'b' > 'a' >= 'a'", 1.0);
    gives("'1' == '1.0'", 0.0); // two texts
    gives("'1' == 1.0", 1.0);
    gives("2.5 == '2.5'", 1.0);
    gives("' 3 ' > 2", 1.0);
    gives("'true' == 1", 1.0);
    gives("0 == 'false'", 1.0);
    gives("'RED' == RED", 1.0);
    fails("'blue' == 1", "expected a text that is a number to compare with one, found 'blue'");
    fails("1 < '3x'", "expected a text that is a number to compare with one, found '3x'");
    fails("1 < 'inf'", "expected a text that is a number to compare with one, found 'inf'");
}

#[test]
fn enum_names_win_over_entries() {
    let mut board = Board::default();
    board.entries.insert("RED".to_owned(), Value::Number(9.0));
    assert_eq!(run_on(&mut board, "RED"), Ok(Value::Number(2.0)));
}

#[test]
fn assignments_create_or_need_an_entry() {
    let mut board = Board::default();
    assert_eq!(run_on(&mut board, "n := 3"), Ok(Value::Number(3.0)));
    assert_eq!(run_on(&mut board, "n = 4"), Ok(Value::Number(4.0)));
    assert_eq!(run_on(&mut board, "n += 1"), Ok(Value::Number(5.0)));
    assert_eq!(run_on(&mut board, "n -= 3"), Ok(Value::Number(2.0)));
    assert_eq!(run_on(&mut board, "n *= 5"), Ok(Value::Number(10.0)));
    assert_eq!(run_on(&mut board, "n /= 4"), Ok(Value::Number(2.5)));
    assert_eq!(run_on(&mut board, "a := b := n"), Ok(Value::Number(2.5)));
    assert_eq!(run_on(&mut board, "s := 'x'; s += 'y'"), Ok(Value::Text("xy".to_owned())));
    assert_eq!(run_on(&mut board, "t := s; s = 'z'; t .. s"), Ok(Value::Text("xyz".to_owned())));
    let names: Vec<_> = board.entries.keys().map(String::as_str).collect();
    assert_eq!(names, ["a", "b", "n", "s", "t"]);
    fails("m = 1", "unknown name \"m\", write := to create it");
    fails("m += 1", "unknown name \"m\"");
    fails("m := m", "unknown name \"m\"");
    fails("s := 'a'; s -= 'b'", "expected two numbers around \"-=\", found the text 'a' and the text 'b'");
    fails("s := 'a'; s += 1", "expected two numbers or two texts around \"+=\", found the text 'a' and the number 1");
}

#[test]
fn assignments_inside_expressions_leave_what_was_read_before() {
    gives_text("s := 'a'; s .. (s := 'b') .. s", "abb");
    gives("s := 'a'; s == (s := 'b')", 0.0);
    gives("n := 1; n + (n := 5) + n", 11.0);
    gives("n := 1; n += (n := 5)", 10.0); // the entry is read after the right side, as in the reference
}

#[test]
fn queues_can_be_copied_and_nothing_else() {
    let mut board = Board::default();
    let queue = Value::Queue(vec![Value::Number(1.0)]);
    board.entries.insert("q".to_owned(), queue.clone());
    assert_eq!(run_on(&mut board, "p := q"), Ok(queue));
    assert_eq!(run_on(&mut board, "q == 1"), Err("expected numbers or texts to compare, found a queue".to_owned()));
    assert_eq!(
        run_on(&mut board, "q + 1"),
        Err("expected two numbers or two texts around \"+\", found a queue and the number 1".to_owned())
    );
    assert_eq!(
        run_on(&mut board, "q ? 1 : 2"),
        Err("expected a number or a text before \"?\", found a queue".to_owned())
    );
}

#[test]
fn statements_stand_beside_each_other() {
    gives("a := 1; b := 2; a + b", 3.0);
    gives("a := 1 b := 2 a + b", 3.0);
    gives(";; a := 1 ;; a ;", 1.0);
    gives("a := 1\n\t; a\r\n+ 1", 2.0);
    gives("1 2 3", 3.0);
    gives("3 -1", 2.0); // one statement
    gives("", 0.0);
    for blank in ["", "  \n\t", ";;"] {
        assert_eq!(Script::parse(blank).map(|script| script.is_empty()), Ok(true));
    }
    assert_eq!(Script::parse("0").map(|script| script.is_empty()), Ok(false));
}

#[test]
fn names_are_listed_once_in_order_of_first_use() {
    let script = Script::parse("b := @a + _c1 * b; trueish ? @a : true").expect("a script");
    assert_eq!(script.names(), ["b", "@a", "_c1", "trueish"]);
}

#[test]
fn faulty_numbers_are_refused_at_their_place() {
    refused("65.", 3, "expected a digit after the point, found the end of the script");
    refused("n := 65.x", 8, "expected a digit after the point, found \"x\"");
    refused("3x", 1, "expected a blank or an operator after the number, found \"x\"");
    refused("1.5.2", 3, "expected a blank or an operator after the number, found \".\"");
    refused("0x1G", 3, "expected a blank or an operator after the number, found \"G\"");
    refused("0x1.", 3, "expected a blank or an operator after the number, found \".\"");
    refused("0x", 2, "expected a hexadecimal digit, found the end of the script");
    refused("1e", 2, "expected a digit of the exponent, found the end of the script");
    refused("1e+;", 3, "expected a digit of the exponent, found \";\"");
    refused("1e3f", 3, "expected a blank or an operator after the number, found \"f\"");
    refused("2 * 1e999", 4, "expected a number below 1.8e308, found '1e999'");
    refused("9223372036854775808", 0, "expected a whole number of at most 2^63 - 1, found '9223372036854775808'");
    refused("'é'; 0x8000000000000000", 5, "expected a whole number of at most 2^63 - 1, found '0x8000000000000000'");
}

#[test]
fn other_faults_are_refused_at_their_place() {
    refused("1 +", 3, "expected a number, text or name, found the end of the script");
    refused("1 + * 2", 4, "expected a number, text or name, found \"*\"");
    refused("(1 + 2", 6, "expected \")\", found the end of the script");
    refused("(1 'a'", 3, "expected \")\", found the text 'a'");
    refused("1)", 1, "expected a number, text or name, found \")\"");
    refused("()", 1, "expected a number, text or name, found \")\"");
    refused("1 ? 2", 5, "expected \":\" between the two values of \"?\", found the end of the script");
    refused("1 ? 2 n", 6, "expected \":\" between the two values of \"?\", found the name 'n'");
    refused("a + 'b", 4, "expected ' to end the text that begins here, found the end of the script");
    refused("a % b", 2, "expected a number, text, name or operator, found \"%\"");
    refused("'é' .. é", 7, "expected a number, text, name or operator, found \"é\"");
    refused("a == \"b\"", 5, "expected a text in single quotes, found a double quote");
    refused("; 3 = 2", 2, "expected a name before \"=\", found something else, did you mean \"==\"?");
    refused("a == 1 && b = 2", 0, "expected a name before \"=\", found something else, did you mean \"==\"?");
    refused("'a' += 'b'", 0, "expected a name before \"+=\", found something else");
    refused("a.b", 1, "expected a number, text, name or operator, found \".\"");
    let error = Script::parse("1 +").expect_err("no script");
    assert_eq!(error.to_string(), "character 4: expected a number, text or name, found the end of the script");
}

#[test]
fn nesting_and_length_are_limited() {
    let nested = |levels: usize| format!("{}1{}", "(".repeat(levels), ")".repeat(levels));
    gives(&nested(200), 1.0);
    refused(&nested(201), 201, "expected at most 200 levels of nesting, found more");
    for text in ["-", "!", "(", "1 ? ", "1 ? 1 : ", "n := ", "1 || 1 && 1 < 1 | 1 & 1 + 1 * ("] {
        let error = Script::parse(&text.repeat(3000)).expect_err("too deep");
        assert_eq!(error.message, "expected at most 200 levels of nesting, found more", "{text}");
    }
    // What stands beside each other is not nested.
    gives(&format!("1{}", "+1".repeat(49_999)), 50_000.0);
    gives(&"1 ".repeat(50_000), 1.0);
    gives(&format!("0{}", "<=0".repeat(33_333)), 1.0);
    refused(&" ".repeat(100_001), 100_000, "expected at most 100000 characters, found 100001");
}

/// Natively the main thread has eight times as much, in the browser twice as much.
#[test]
#[cfg(not(target_arch = "wasm32"))]
fn the_deepest_scripts_need_half_a_megabyte_of_stack() {
    let deep = || {
        gives(&format!("{}1{}", "1 + (".repeat(200), ")".repeat(200)), 201.0);
        gives(&format!("{}1{}", "1 ? ".repeat(200), " : 0".repeat(200)), 1.0);
        gives(&format!("{}1{}", "0 || 1 && 1 <= 1 | 1 & 1 + 1 * (".repeat(28), ")".repeat(28)), 1.0);
        gives(&format!("{}1", "-".repeat(200)), 1.0);
        gives(&format!("{}1", "n := ".repeat(200)), 1.0);
        gives(&format!("{}1", "0 ? 0 : ".repeat(200)), 1.0);
    };
    let thread = std::thread::Builder::new().stack_size(512 * 1024).spawn(deep).expect("a thread");
    assert!(thread.join().is_ok());
}

#[test]
fn joined_texts_are_limited() {
    let text = format!("s := 'ab' {}", "s += s ".repeat(1000));
    fails(&text, "expected a joined text of at most 100000 bytes, found 131072");
}

#[test]
fn messages_quote_long_texts_in_part() {
    let text = format!("-'{}'", "é".repeat(50));
    fails(&text, &format!("expected a number after \"-\", found the text '{}...'", "é".repeat(40)));
}
