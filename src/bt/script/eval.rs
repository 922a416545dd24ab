//! Running a script.
//!
//! Texts of entries are looked at where they are: an operand remembers the slot, and its text is copied only when it
//! is joined, assigned or returned. In the rare script with an assignment inside an expression, such as
//! `s == (s := 'new')`, texts are copied when they are read.

use super::{Assignment, Comparison, Entries, Expression, MOST_TEXT, Operator, Prefix, Script, quoted};
use crate::bt::Value;
use std::cmp::Ordering;

/// Numbers that differ by no more than this are equal: the machine epsilon of `f32`, as in the reference.
const TOLERANCE: f64 = f32::EPSILON as f64;

/// Runs all statements and returns the value of the last one.
pub(super) fn run<E: Entries>(script: &Script, entries: &mut E) -> Result<Value, String> {
    let mut run = Run { script, entries };
    let mut last = Operand::Number(0.0);
    for statement in &script.statements {
        last = run.evaluate(statement)?;
    }
    run.value(last)
}

/// An evaluated expression.
enum Operand<'a> {
    Number(f64),
    /// A text of the script.
    Text(&'a str),
    /// The text or queue that an entry holds.
    Entry(usize),
    Owned(Value),
}

/// A look at an operand.
#[derive(Clone, Copy)]
enum Seen<'a> {
    Number(f64),
    Text(&'a str),
    Queue,
}

impl<'a> Seen<'a> {
    fn of(value: &'a Value) -> Self {
        match value {
            Value::Number(number) => Self::Number(*number),
            Value::Text(text) => Self::Text(text),
            Value::Queue(_) => Self::Queue,
        }
    }

    fn describe(self) -> String {
        match self {
            Self::Number(number) => format!("the number {number}"),
            Self::Text(text) => format!("the text {}", quoted(text)),
            Self::Queue => "a queue".to_owned(),
        }
    }
}

struct Run<'a, E> {
    script: &'a Script,
    entries: &'a mut E,
}

impl<'a, E: Entries> Run<'a, E> {
    fn evaluate(&mut self, expression: &'a Expression) -> Result<Operand<'a>, String> {
        match expression {
            Expression::Number(number) => Ok(Operand::Number(*number)),
            Expression::Text(text) => Ok(Operand::Text(text)),
            Expression::Name(slot) => self.read(*slot),
            Expression::Prefix(prefix, inner) => {
                let inner = self.evaluate(inner)?;
                prefixed(*prefix, self.see(&inner)?).map(Operand::Number)
            }
            Expression::Chain(first, rest) => {
                let mut left = self.evaluate(first)?;
                for (operator, right) in rest {
                    let right = self.evaluate(right)?;
                    left = self.combine(*operator, left, &right, false)?;
                }
                Ok(left)
            }
            Expression::Compare(first, rest) => {
                let mut left = self.evaluate(first)?;
                for (comparison, right) in rest {
                    let right = self.evaluate(right)?;
                    if !self.compare(*comparison, &left, &right)? {
                        return Ok(Operand::Number(0.0));
                    }
                    left = right;
                }
                Ok(Operand::Number(1.0))
            }
            Expression::Choice(parts) => {
                let [condition, first, second] = &**parts;
                let condition = self.evaluate(condition)?;
                let first_one = chooses_first(self.see(&condition)?)?;
                self.evaluate(if first_one { first } else { second })
            }
            Expression::Assign(assignment, slot, value) => self.assign(*assignment, *slot, value),
        }
    }

    /// The value of a name, where enum names win over entries.
    fn read(&self, slot: usize) -> Result<Operand<'a>, String> {
        match self.entries.enum_value(&self.script.names[slot]) {
            Some(number) => Ok(Operand::Number(number)),
            None => self.read_entry(slot),
        }
    }

    fn read_entry(&self, slot: usize) -> Result<Operand<'a>, String> {
        Ok(match self.entry(slot)? {
            Value::Number(number) => Operand::Number(*number),
            value if self.script.assigns_inside => Operand::Owned(value.clone()),
            Value::Text(_) | Value::Queue(_) => Operand::Entry(slot),
        })
    }

    fn entry(&self, slot: usize) -> Result<&Value, String> {
        let name = &self.script.names[slot];
        self.entries.get(slot, name).ok_or_else(|| format!("unknown name \"{name}\""))
    }

    fn see<'s>(&'s self, operand: &'s Operand) -> Result<Seen<'s>, String> {
        Ok(match operand {
            Operand::Number(number) => Seen::Number(*number),
            Operand::Text(text) => Seen::Text(text),
            Operand::Entry(slot) => Seen::of(self.entry(*slot)?),
            Operand::Owned(value) => Seen::of(value),
        })
    }

    fn value(&self, operand: Operand) -> Result<Value, String> {
        Ok(match operand {
            Operand::Number(number) => Value::Number(number),
            Operand::Text(text) => Value::Text(text.to_owned()),
            Operand::Entry(slot) => self.entry(slot)?.clone(),
            Operand::Owned(value) => value,
        })
    }

    /// Assigns and returns what the entry then holds, which may be a converted value.
    fn assign(&mut self, assignment: Assignment, slot: usize, value: &'a Expression) -> Result<Operand<'a>, String> {
        let right = self.evaluate(value)?;
        let value = match assignment {
            Assignment::Create | Assignment::Set => right,
            Assignment::Update(operator) => {
                let left = self.read_entry(slot)?;
                self.combine(operator, left, &right, true)?
            }
        };
        let value = self.value(value)?;
        self.entries.assign(slot, &self.script.names[slot], value, assignment == Assignment::Create)?;
        self.read_entry(slot)
    }

    /// Applies an operator; `updating` when it is written with `=` behind it.
    fn combine(
        &self,
        operator: Operator,
        left: Operand<'a>,
        right: &Operand,
        updating: bool,
    ) -> Result<Operand<'a>, String> {
        let (seen_left, seen_right) = (self.see(&left)?, self.see(right)?);
        match (operator, seen_left, seen_right) {
            (Operator::Plus, Seen::Text(_), Seen::Text(text))
            | (Operator::Join, Seen::Text(_) | Seen::Number(_), Seen::Text(text)) => joined(self.value(left)?, text),
            (Operator::Join, Seen::Text(_), Seen::Number(number)) => joined(self.value(left)?, &number.to_string()),
            (_, Seen::Number(left), Seen::Number(right)) => calculate(operator, left, right).map(Operand::Number),
            _ => Err(mismatch(operator, updating, seen_left, seen_right)),
        }
    }

    fn compare(&self, comparison: Comparison, left: &Operand, right: &Operand) -> Result<bool, String> {
        match (self.see(left)?, self.see(right)?) {
            (Seen::Number(left), Seen::Number(right)) => Ok(compare_numbers(comparison, left, right)),
            (Seen::Text(left), Seen::Number(right)) => Ok(compare_numbers(comparison, self.number(left)?, right)),
            (Seen::Number(left), Seen::Text(right)) => Ok(compare_numbers(comparison, left, self.number(right)?)),
            (Seen::Text(left), Seen::Text(right)) => Ok(match comparison {
                Comparison::Equal => left == right,
                Comparison::NotEqual => left != right,
                Comparison::Less => left < right,
                Comparison::LessEqual => left <= right,
                Comparison::Greater => left > right,
                Comparison::GreaterEqual => left >= right,
            }),
            (Seen::Queue, _) | (_, Seen::Queue) => {
                Err("expected numbers or texts to compare, found a queue".to_owned())
            }
        }
    }

    /// The number a text stands for when it is compared with one.
    fn number(&self, text: &str) -> Result<f64, String> {
        let number = match text {
            "true" => Some(1.0),
            "false" => Some(0.0),
            _ => self.entries.enum_value(text).or_else(|| text.trim().parse().ok().filter(|n: &f64| n.is_finite())),
        };
        number.ok_or_else(|| format!("expected a text that is a number to compare with one, found {}", quoted(text)))
    }
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}

fn prefixed(prefix: Prefix, operand: Seen) -> Result<f64, String> {
    let symbol = match prefix {
        Prefix::Negate => "-",
        Prefix::Complement => "~",
        Prefix::Not => "!",
    };
    let Seen::Number(number) = operand else {
        return Err(format!("expected a number after \"{symbol}\", found {}", operand.describe()));
    };
    match prefix {
        Prefix::Negate => Ok(-number),
        Prefix::Complement => Ok(!whole(number, symbol)? as f64),
        Prefix::Not => Ok(truth(number == 0.0)),
    }
}

fn joined<'a>(left: Value, right: &str) -> Result<Operand<'a>, String> {
    let mut text = match left {
        Value::Text(text) => text,
        other => other.to_string(),
    };
    text.push_str(right);
    if text.len() > MOST_TEXT {
        return Err(format!("expected a joined text of at most {MOST_TEXT} bytes, found {}", text.len()));
    }
    Ok(Operand::Owned(Value::Text(text)))
}

fn mismatch(operator: Operator, updating: bool, left: Seen, right: Seen) -> String {
    let expected = match operator {
        Operator::Plus => "two numbers or two texts",
        Operator::Join => "a text and a text or number",
        _ => "two numbers",
    };
    let (symbol, equals) = (operator.symbol(), if updating { "=" } else { "" });
    format!("expected {expected} around \"{symbol}{equals}\", found {} and {}", left.describe(), right.describe())
}

fn calculate(operator: Operator, left: f64, right: f64) -> Result<f64, String> {
    let whole = |number| whole(number, operator.symbol());
    Ok(match operator {
        Operator::Or => truth(left != 0.0 || right != 0.0),
        Operator::And => truth(left != 0.0 && right != 0.0),
        Operator::BitOr => (whole(left)? | whole(right)?) as f64,
        Operator::BitXor => (whole(left)? ^ whole(right)?) as f64,
        Operator::BitAnd => (whole(left)? & whole(right)?) as f64,
        Operator::Join => return Err(mismatch(operator, false, Seen::Number(left), Seen::Number(right))),
        Operator::Plus => left + right,
        Operator::Minus => left - right,
        Operator::Times => left * right,
        Operator::Divide => left / right,
    })
}

/// The number as 64-bit integer, for the bit operators.
fn whole(number: f64, symbol: &str) -> Result<i64, String> {
    const LIMIT: f64 = 9_223_372_036_854_775_808.0; // 2^63
    if number.fract() == 0.0 && (-LIMIT..LIMIT).contains(&number) {
        return Ok(number as i64);
    }
    Err(format!("expected whole numbers of 64 bits for \"{symbol}\", found {number}"))
}

/// Equality within the tolerance, order exact. As in the reference, an infinity does not equal itself (their
/// difference is no number), and what is no number is unequal to any other, yet in every order with it.
fn compare_numbers(comparison: Comparison, left: f64, right: f64) -> bool {
    let equal = (left - right).abs() <= TOLERANCE;
    let order = left.partial_cmp(&right);
    match comparison {
        Comparison::Equal => equal,
        Comparison::NotEqual => !equal,
        Comparison::Less => order.is_none_or(Ordering::is_lt),
        Comparison::LessEqual => order.is_none_or(Ordering::is_le),
        Comparison::Greater => order.is_none_or(Ordering::is_gt),
        Comparison::GreaterEqual => order.is_none_or(Ordering::is_ge),
    }
}

/// Whether a condition takes the first value of a choice: a number that is not 0, or a text that is not empty.
fn chooses_first(condition: Seen) -> Result<bool, String> {
    match condition {
        Seen::Number(number) => Ok(number != 0.0),
        Seen::Text(text) if !text.is_empty() => Ok(true),
        // The reference tries to read the empty text as a number, and fails.
        Seen::Text(_) => Err("expected a number or a text before \"?\", found an empty text".to_owned()),
        Seen::Queue => Err("expected a number or a text before \"?\", found a queue".to_owned()),
    }
}
