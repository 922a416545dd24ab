//! Reading a script: one token of lookahead, operators by their level of binding.

use super::{
    Assignment, COMPARISONS, Comparison, Expression, MOST_LEVELS, MOST_TEXT, Operator, Prefix, Script, ScriptError,
    quoted,
};
use std::collections::BTreeMap;

/// Reads a whole script.
pub(super) fn script(text: &str) -> Result<Script, ScriptError> {
    let length = text.chars().count();
    if length > MOST_TEXT {
        return fault(MOST_TEXT, format!("expected at most {MOST_TEXT} characters, found {length}"));
    }
    let token = Token { kind: Kind::End, at: 0, text: "" };
    let script = Script { statements: Vec::new(), names: Vec::new(), assigns_inside: false };
    let mut parser = Parser { rest: text, at: 0, token, slots: BTreeMap::new(), script, levels: 0, inside: 0 };
    parser.advance()?;
    while parser.token.kind != Kind::End {
        if parser.token.kind == Kind::Semicolon {
            parser.advance()?;
        } else {
            let statement = parser.statement()?;
            parser.script.statements.push(statement);
        }
    }
    Ok(parser.script)
}

fn fault<T>(at: usize, message: String) -> Result<T, ScriptError> {
    Err(ScriptError { at, message })
}

#[derive(Clone, Copy, PartialEq)]
enum Kind<'a> {
    Number(f64),
    Text(&'a str),
    Name(&'a str),
    Operator(Operator),
    Compare(Comparison),
    Assign(Assignment),
    /// `~` or `!`; a minus is an operator until it stands where a value is expected.
    Prefix(Prefix),
    Question,
    Colon,
    Open,
    Close,
    Semicolon,
    End,
}

impl Kind<'_> {
    /// How tightly an operator or comparison binds; `None` for all else.
    fn level(self) -> Option<u8> {
        match self {
            Self::Operator(operator) => Some(operator.level()),
            Self::Compare(_) => Some(COMPARISONS),
            _ => None,
        }
    }
}

#[derive(Clone, Copy)]
struct Token<'a> {
    kind: Kind<'a>,
    at: usize,
    text: &'a str,
}

/// A part of a script, or the first fault.
type Parsed = Result<Expression, ScriptError>;

struct Parser<'a> {
    /// The text after the current token, and the place where it begins.
    rest: &'a str,
    at: usize,
    token: Token<'a>,
    slots: BTreeMap<&'a str, usize>,
    script: Script,
    /// Nesting, limited so that neither reading nor running can exhaust the stack.
    levels: usize,
    /// Parentheses and choices that are open.
    inside: usize,
}

impl<'a> Parser<'a> {
    /// An assignment or anything that binds tighter.
    fn statement(&mut self) -> Parsed {
        let start = self.token.at;
        let left = self.choice()?;
        let Kind::Assign(assignment) = self.token.kind else { return Ok(left) };
        let Expression::Name(slot) = left else {
            let hint = if assignment == Assignment::Set { ", did you mean \"==\"?" } else { "" };
            let operator = self.token.text;
            return fault(start, format!("expected a name before \"{operator}\", found something else{hint}"));
        };
        self.script.assigns_inside |= self.inside > 0;
        self.advance()?;
        let value = self.nested(Self::statement)?;
        Ok(Expression::Assign(assignment, slot, Box::new(value)))
    }

    /// A choice `condition ? value : value` or anything that binds tighter.
    fn choice(&mut self) -> Parsed {
        let first = self.operand()?;
        let condition = self.operators(first, 0)?;
        if self.token.kind != Kind::Question {
            return Ok(condition);
        }
        self.advance()?;
        self.inside += 1;
        let first = self.nested(Self::statement)?;
        self.inside -= 1;
        self.expect(Kind::Colon, "\":\" between the two values of \"?\"")?;
        let second = self.nested(Self::choice)?;
        Ok(Expression::Choice(Box::new([condition, first, second])))
    }

    /// `left` with the operators that follow it, as far as they are of level `least` or higher.
    fn operators(&mut self, mut left: Expression, least: u8) -> Parsed {
        while let Some(level) = self.token.kind.level().filter(|&level| level >= least) {
            let first = Box::new(left);
            if level == COMPARISONS {
                let mut rest = Vec::new();
                while let Kind::Compare(comparison) = self.token.kind {
                    rest.push((comparison, self.right_operand(level)?));
                }
                left = Expression::Compare(first, rest);
            } else {
                let mut rest = Vec::new();
                while let Kind::Operator(operator) = self.token.kind
                    && operator.level() == level
                {
                    rest.push((operator, self.right_operand(level)?));
                }
                left = Expression::Chain(first, rest);
            }
        }
        Ok(left)
    }

    /// What stands right of an operator of `level`: an operand with whatever binds tighter.
    fn right_operand(&mut self, level: u8) -> Parsed {
        self.advance()?;
        let operand = self.operand()?;
        if self.token.kind.level().is_none_or(|next| next <= level) {
            return Ok(operand);
        }
        self.nested(|parser| parser.operators(operand, level + 1))
    }

    fn operand(&mut self) -> Parsed {
        let operand = match self.token.kind {
            Kind::Number(number) => Expression::Number(number),
            Kind::Text(text) => Expression::Text(text.to_owned()),
            Kind::Name(name) => Expression::Name(self.slot(name)),
            Kind::Operator(Operator::Minus) => return self.prefixed(Prefix::Negate),
            Kind::Prefix(prefix) => return self.prefixed(prefix),
            Kind::Open => {
                self.advance()?;
                self.inside += 1;
                let inner = self.nested(Self::statement)?;
                self.inside -= 1;
                self.expect(Kind::Close, "\")\"")?;
                return Ok(inner);
            }
            _ => return fault(self.token.at, format!("expected a number, text or name, found {}", self.found())),
        };
        self.advance()?;
        Ok(operand)
    }

    fn prefixed(&mut self, prefix: Prefix) -> Parsed {
        self.advance()?;
        Ok(Expression::Prefix(prefix, Box::new(self.nested(Self::operand)?)))
    }

    fn nested(&mut self, read: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        if self.levels == MOST_LEVELS {
            return fault(self.token.at, format!("expected at most {MOST_LEVELS} levels of nesting, found more"));
        }
        self.levels += 1;
        let inner = read(self)?;
        self.levels -= 1;
        Ok(inner)
    }

    fn slot(&mut self, name: &'a str) -> usize {
        let names = &mut self.script.names;
        *self.slots.entry(name).or_insert_with(|| {
            names.push(name.to_owned());
            names.len() - 1
        })
    }

    fn expect(&mut self, kind: Kind, what: &str) -> Result<(), ScriptError> {
        if self.token.kind == kind {
            return self.advance();
        }
        fault(self.token.at, format!("expected {what}, found {}", self.found()))
    }

    /// The current token, for a message.
    fn found(&self) -> String {
        match self.token.kind {
            Kind::End => "the end of the script".to_owned(),
            Kind::Text(text) => format!("the text {}", quoted(text)),
            Kind::Name(name) => format!("the name {}", quoted(name)),
            Kind::Number(_) => format!("the number {}", quoted(self.token.text)),
            _ => format!("\"{}\"", self.token.text),
        }
    }

    /// Moves to the next token.
    fn advance(&mut self) -> Result<(), ScriptError> {
        let blank = self.rest.len() - self.rest.trim_start_matches([' ', '\t', '\n', '\r']).len();
        self.skip(blank);
        let (kind, length) = self.next()?;
        self.token = Token { kind, at: self.at, text: &self.rest[..length] };
        self.skip(length);
        Ok(())
    }

    fn skip(&mut self, bytes: usize) {
        let (skipped, rest) = self.rest.split_at(bytes);
        self.at += skipped.chars().count();
        self.rest = rest;
    }

    /// The token at the beginning of the rest, and its length in bytes.
    fn next(&self) -> Result<(Kind<'a>, usize), ScriptError> {
        let rest = self.rest;
        let Some(first) = rest.chars().next() else { return Ok((Kind::End, 0)) };
        if first == '\'' {
            return match rest[1..].find('\'') {
                Some(length) => Ok((Kind::Text(&rest[1..=length]), length + 2)),
                None => {
                    fault(self.at, "expected ' to end the text that begins here, found the end of the script".into())
                }
            };
        }
        if first.is_ascii_digit() {
            return self.number();
        }
        if first.is_ascii_alphabetic() || first == '_' || first == '@' {
            let end =
                rest[1..].find(|c: char| !c.is_ascii_alphanumeric() && c != '_').map_or(rest.len(), |end| end + 1);
            return Ok(match &rest[..end] {
                "true" => (Kind::Number(1.0), end),
                "false" => (Kind::Number(0.0), end),
                name => (Kind::Name(name), end),
            });
        }
        match SYMBOLS.iter().find(|(symbol, _)| rest.starts_with(symbol)) {
            Some((symbol, kind)) => Ok((*kind, symbol.len())),
            None if first == '"' => fault(self.at, "expected a text in single quotes, found a double quote".into()),
            None => fault(self.at, format!("expected a number, text, name or operator, found \"{first}\"")),
        }
    }

    /// The numeral at the beginning of the rest, and its length.
    fn number(&self) -> Result<(Kind<'a>, usize), ScriptError> {
        let bytes = self.rest.as_bytes();
        let is = |index: usize, set: &[u8]| bytes.get(index).is_some_and(|byte| set.contains(byte));
        let expected = |index: usize, what: &str| {
            let found = self.rest[index..].chars().next().map(|found| format!("\"{found}\""));
            let found = found.as_deref().unwrap_or("the end of the script");
            fault(self.at + index, format!("expected {what}, found {found}"))
        };
        // The end of the digits from an index; the same index when there are none.
        let digits = |from: usize, radix: u32| {
            from + bytes[from..].iter().take_while(|&&byte| char::from(byte).is_digit(radix)).count()
        };

        let hexadecimal = bytes[0] == b'0' && is(1, b"xX");
        let mut end = if hexadecimal { digits(2, 16) } else { digits(0, 10) };
        let mut whole = true;
        if hexadecimal && end == 2 {
            return expected(end, "a hexadecimal digit");
        }
        if !hexadecimal && is(end, b".") && !is(end + 1, b".") {
            (whole, end) = (false, end + 1);
            if digits(end, 10) == end {
                return expected(end, "a digit after the point");
            }
            end = digits(end, 10);
        }
        if !hexadecimal && is(end, b"eE") {
            (whole, end) = (false, end + 1);
            end += usize::from(is(end, b"+-"));
            if digits(end, 10) == end {
                return expected(end, "a digit of the exponent");
            }
            end = digits(end, 10);
        }
        let continues = bytes.get(end).is_some_and(|byte| byte.is_ascii_alphanumeric() || b"_@".contains(byte));
        if continues || is(end, b".") && (hexadecimal || !is(end + 1, b".")) {
            return expected(end, "a blank or an operator after the number");
        }

        let text = &self.rest[..end];
        let (number, most) = if whole {
            let (digits, radix) = if hexadecimal { (&text[2..], 16) } else { (text, 10) };
            (i64::from_str_radix(digits, radix).ok().map(|number| number as f64), "a whole number of at most 2^63 - 1")
        } else {
            (text.parse().ok().filter(|number: &f64| number.is_finite()), "a number below 1.8e308")
        };
        match number {
            Some(number) => Ok((Kind::Number(number), end)),
            None => fault(self.at, format!("expected {most}, found {}", quoted(text))),
        }
    }
}

/// The operators and marks; those of two characters first.
const SYMBOLS: [(&str, Kind); 29] = [
    (":=", Kind::Assign(Assignment::Create)),
    ("+=", Kind::Assign(Assignment::Update(Operator::Plus))),
    ("-=", Kind::Assign(Assignment::Update(Operator::Minus))),
    ("*=", Kind::Assign(Assignment::Update(Operator::Times))),
    ("/=", Kind::Assign(Assignment::Update(Operator::Divide))),
    ("||", Kind::Operator(Operator::Or)),
    ("&&", Kind::Operator(Operator::And)),
    ("..", Kind::Operator(Operator::Join)),
    ("==", Kind::Compare(Comparison::Equal)),
    ("!=", Kind::Compare(Comparison::NotEqual)),
    ("<=", Kind::Compare(Comparison::LessEqual)),
    (">=", Kind::Compare(Comparison::GreaterEqual)),
    ("<", Kind::Compare(Comparison::Less)),
    (">", Kind::Compare(Comparison::Greater)),
    ("=", Kind::Assign(Assignment::Set)),
    ("|", Kind::Operator(Operator::BitOr)),
    ("^", Kind::Operator(Operator::BitXor)),
    ("&", Kind::Operator(Operator::BitAnd)),
    ("+", Kind::Operator(Operator::Plus)),
    ("-", Kind::Operator(Operator::Minus)),
    ("*", Kind::Operator(Operator::Times)),
    ("/", Kind::Operator(Operator::Divide)),
    ("~", Kind::Prefix(Prefix::Complement)),
    ("!", Kind::Prefix(Prefix::Not)),
    ("?", Kind::Question),
    (":", Kind::Colon),
    ("(", Kind::Open),
    (")", Kind::Close),
    (";", Kind::Semicolon),
];
