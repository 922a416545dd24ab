//! The scripting language of `BehaviorTree.CPP` 4.10: statements that read and write blackboard entries.
//!
//! - Statements stand beside each other, with `;` between them or nothing. The value of a script is that of its last
//!   statement.
//! - Binding, loosest first: `:= = += -= *= /=`; `? :`; `||`; `&&`; `== != < <= > >=`, which may be chained;
//!   `|` `^`; `&`; `+` `-` `..`; `*` `/`; the prefixes `-` `~` `!`. So `6 & 3 == 2` means `(6 & 3) == 2`.
//! - Numbers are reals throughout, `true` and `false` are 1 and 0, texts stand in single quotes without escapes.
//! - `&&` and `||` evaluate both sides, `? :` one, a chain of comparisons goes on until one is false.
//!
//! | Where we differ | Reference | Here |
//! |---|---|---|
//! | assigning to what is no name, `3 = 2` | an error when it runs | an error of the text |
//! | whole number above 2^63 - 1 | silently 0 | an error of the text |
//! | stray `;` before the first statement | refused | ignored |
//! | empty text | refused | a script without statements |
//! | `~2.5` | cuts the fraction off | an error, as for the other bit operators |
//! | a number joined to a text | the form depends on how it was stored | as [`Value`] displays it |
//! | text compared with a number | what follows the numeral is ignored | the whole text is a numeral |
//! | nesting, length of scripts and of joined texts | unlimited | limited, so that no script exhausts the memory |
//!
//! ```
//! use swarm_playground::bt::{Value, script::{Entries, Script}};
//!
//! struct Board(Vec<Option<Value>>);
//! impl Entries for Board {
//!     fn get(&self, slot: usize, _name: &str) -> Option<&Value> {
//!         self.0[slot].as_ref()
//!     }
//!     fn assign(&mut self, slot: usize, name: &str, value: Value, create: bool) -> Result<(), String> {
//!         if self.0[slot].is_none() && !create {
//!             return Err(format!("unknown name \"{name}\""));
//!         }
//!         self.0[slot] = Some(value);
//!         Ok(())
//!     }
//! }
//!
//! let script = Script::parse("n := 7; half := n / 2; n > half > 3")?;
//! assert_eq!(script.names(), ["n", "half"]);
//! assert_eq!(script.run(&mut Board(vec![None; 2])), Ok(Value::Number(1.0)));
//! # Ok::<(), swarm_playground::bt::script::ScriptError>(())
//! ```

mod eval;
mod parse;

use super::Value;
use std::fmt;

/// The most characters of a script, and the most bytes of a text that a script joins.
const MOST_TEXT: usize = 100_000;

/// The most parentheses, prefixes, choices, assignments and tighter-binding right operands inside each other.
const MOST_LEVELS: usize = 200;

/// The level of comparisons; see [`Operator::level`].
const COMPARISONS: u8 = 2;

/// A parsed script.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    statements: Vec<Expression>,
    names: Vec<String>,
    /// Whether an assignment stands inside an expression, so that an entry may change while one is evaluated.
    assigns_inside: bool,
}

impl Script {
    /// Reads a script; an empty or blank text is a script without statements.
    ///
    /// # Errors
    /// The first fault with its place: a character or number that is none, a missing operand, `)` or `:`, an
    /// assignment to something else than a name, more than 200 levels of nesting or 100,000 characters.
    ///
    /// ```
    /// use swarm_playground::bt::script::Script;
    /// let error = Script::parse("n := (1 + 2").unwrap_err();
    /// assert_eq!((error.at, error.to_string().as_str()), (11, "character 12: expected \")\", found the end of the script"));
    /// ```
    pub fn parse(text: &str) -> Result<Self, ScriptError> {
        parse::script(text)
    }

    /// True when there is no statement.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.statements.is_empty()
    }

    /// Every name the script reads or writes, each once, in order of first use, with its `@`; the index is the slot.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Runs all statements and returns the value of the last one; 0 when there is none.
    ///
    /// Scripts that only handle numbers allocate nothing; neither does comparing texts.
    ///
    /// # Errors
    /// The cause of the first fault: an unknown name, an operator that does not take such values, whatever
    /// [`Entries::assign`] refuses. Assignments before the fault stay done.
    pub fn run<E: Entries>(&self, entries: &mut E) -> Result<Value, String> {
        eval::run(self, entries)
    }
}

/// The entries a script reads and writes, by slot in [`Script::names`].
pub trait Entries {
    /// The value of an entry; `None` when there is no such entry or it holds nothing yet.
    fn get(&self, slot: usize, name: &str) -> Option<&Value>;

    /// The number of an enum name; enum names win over entries.
    fn enum_value(&self, _name: &str) -> Option<f64> {
        None
    }

    /// Writes an entry. With `create` (the operator `:=`) it is made when missing, otherwise it must exist.
    ///
    /// # Errors
    /// The cause, when the entry is missing or cannot take the value.
    fn assign(&mut self, slot: usize, name: &str, value: Value, create: bool) -> Result<(), String>;
}

/// Why a text is no script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScriptError {
    /// The place of the fault: a character of the text, counted from 0.
    pub at: usize,
    /// What was expected there and what was found.
    pub message: String,
}

impl fmt::Display for ScriptError {
    /// The place, counted from 1 as columns are, and the message.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "character {}: {}", self.at + 1, self.message)
    }
}

impl std::error::Error for ScriptError {}

/// What a statement or a part of one is made of.
#[derive(Clone, Debug, PartialEq)]
enum Expression {
    Number(f64),
    Text(String),
    /// An entry or enum name, by slot.
    Name(usize),
    Prefix(Prefix, Box<Expression>),
    /// Operators that bind alike, applied from left to right.
    Chain(Box<Expression>, Vec<(Operator, Expression)>),
    /// Each operand compared with the next one.
    Compare(Box<Expression>, Vec<(Comparison, Expression)>),
    /// The condition, and the values when it is true and when it is false.
    Choice(Box<[Expression; 3]>),
    Assign(Assignment, usize, Box<Expression>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Prefix {
    Negate,
    Complement,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operator {
    Or,
    And,
    BitOr,
    BitXor,
    BitAnd,
    Plus,
    Minus,
    Join,
    Times,
    Divide,
}

impl Operator {
    /// How tightly it binds, from 0; comparisons have level 2.
    fn level(self) -> u8 {
        match self {
            Self::Or => 0,
            Self::And => 1,
            Self::BitOr | Self::BitXor => 3,
            Self::BitAnd => 4,
            Self::Plus | Self::Minus | Self::Join => 5,
            Self::Times | Self::Divide => 6,
        }
    }

    /// How it is written.
    fn symbol(self) -> &'static str {
        match self {
            Self::Or => "||",
            Self::And => "&&",
            Self::BitOr => "|",
            Self::BitXor => "^",
            Self::BitAnd => "&",
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Join => "..",
            Self::Times => "*",
            Self::Divide => "/",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Assignment {
    /// `:=`
    Create,
    /// `=`
    Set,
    /// `+=` and its like.
    Update(Operator),
}

/// A text in single quotes for a message, cut after 40 characters.
fn quoted(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("'{}...'", &text[..end]),
        None => format!("'{text}'"),
    }
}
