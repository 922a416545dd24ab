//! What a world says of its parameters: one list, from which controls, links, checks and help are derived.

use serde::Serialize;
use serde_json::Value;

/// One parameter of a world. Its default is not here: it is that of the world's own `Default`.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The field's name in the scenario, in kebab case.
    pub name: &'static str,
    /// Type and bounds.
    pub kind: Kind,
    /// What is counted or measured; empty for pure numbers.
    pub unit: &'static str,
    /// When a change takes effect.
    pub apply: Apply,
    /// The heading it stands under.
    pub group: &'static str,
    /// A short name for people.
    pub label: &'static str,
    /// One or two plain sentences.
    pub help: &'static str,
    /// Paper and section, or "our choice" with the reason.
    pub source: &'static str,
}

/// The text; nothing in a build without the feature `texts`.
///
/// The engine of the page's first load is such a build: the page gets what is said of parameters from a file that the
/// build writes, and the wasm stays within its budget.
#[must_use]
pub const fn text(text: &'static str) -> &'static str {
    if cfg!(feature = "texts") { text } else { "" }
}

/// When a change of a parameter takes effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Apply {
    /// At once; the change becomes an event of the scenario.
    Live,
    /// With the next start from tick 0.
    Restart,
}

/// Type and bounds of a parameter. Sliders span `min` to `max`; values up to `hard_max` are accepted.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A whole number.
    Int {
        /// Least value.
        min: i64,
        /// Most value of a slider.
        max: i64,
        /// Most value accepted.
        hard_max: i64,
        /// Whether a slider should be logarithmic.
        log: bool,
    },
    /// A real number; NaN and infinities are never accepted.
    Float {
        /// Least value.
        min: f64,
        /// Most value of a slider.
        max: f64,
        /// Most value accepted.
        hard_max: f64,
        /// Distance between slider positions.
        step: f64,
        /// Whether a slider should be logarithmic.
        log: bool,
    },
    /// On or off.
    Bool,
    /// One of several words: value and label.
    Choice(&'static [(&'static str, &'static str)]),
    /// Text of at most so many bytes.
    Text(usize),
    /// A list of at most so many items, which the world reads.
    List(usize),
}

impl Kind {
    /// A whole number on a linear slider.
    #[must_use]
    pub const fn int(min: i64, max: i64, hard_max: i64) -> Self {
        Self::Int { min, max, hard_max, log: false }
    }

    /// A real number on a linear slider.
    #[must_use]
    pub const fn real(min: f64, max: f64, hard_max: f64, step: f64) -> Self {
        Self::Float { min, max, hard_max, step, log: false }
    }

    /// Returns the value in the form its field takes (whole numbers without a fraction).
    ///
    /// # Errors
    /// What was found and what is allowed, as `expected ..., found ...`; the caller puts the path in front.
    pub fn check(&self, value: &Value, unit: &str) -> Result<Value, String> {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let fault = |expected: String| Err(format!("expected {expected}, found {}", shown(value)));
        match self {
            Self::Int { min, hard_max, .. } => {
                let expected = format!("a whole number from {min} to {hard_max}{unit}");
                let whole = value.as_i64().or_else(|| {
                    let real = value.as_f64()?;
                    (real % 1.0 == 0.0 && real.abs() < 9e15).then_some(real as i64)
                });
                match whole {
                    Some(whole) if (*min..=*hard_max).contains(&whole) => Ok(Value::from(whole)),
                    _ => fault(expected),
                }
            }
            Self::Float { min, hard_max, .. } => match value.as_f64() {
                Some(real) if (*min..=*hard_max).contains(&real) => Ok(Value::from(real)),
                _ => fault(format!("a number from {} to {}{unit}", number(*min), number(*hard_max))),
            },
            Self::Bool => match value {
                Value::Bool(_) => Ok(value.clone()),
                _ => fault("true or false".to_owned()),
            },
            Self::Choice(choices) => match value.as_str() {
                Some(word) if choices.iter().any(|choice| choice.0 == word) => Ok(value.clone()),
                _ => {
                    let words: Vec<String> = choices.iter().map(|choice| format!("\"{}\"", choice.0)).collect();
                    fault(format!("one of {}", words.join(", ")))
                }
            },
            Self::Text(most) => match value.as_str() {
                Some(text) if text.len() <= *most => Ok(value.clone()),
                Some(text) => Err(format!("expected at most {most} bytes of text, found {}", text.len())),
                None => fault("text".to_owned()),
            },
            Self::List(most) => match value.as_array() {
                Some(items) if items.len() <= *most => Ok(value.clone()),
                Some(items) => Err(format!("expected at most {most} items, found {}", items.len())),
                None => fault("a list".to_owned()),
            },
        }
    }
}

/// A real number as messages show it, without a needless fraction.
#[must_use]
pub fn number(value: f64) -> String {
    let text = Value::from(value).to_string();
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// A value as messages show it: JSON, cut to a readable length.
#[must_use]
pub fn shown(value: &Value) -> String {
    match value {
        Value::Array(_) => "a list".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        other => {
            let text = other.to_string();
            if text.chars().count() <= 60 { text } else { text.chars().take(57).chain("...".chars()).collect() }
        }
    }
}

impl Parameter {
    /// The entry of the schema that the page reads.
    ///
    /// - `prefix`: put before the name, such as `geese.`; empty for parameters of every world.
    /// - `default`: the value of the field in the world's `Default`.
    #[must_use]
    pub fn schema(&self, prefix: &str, default: &Value) -> Value {
        let mut entry = serde_json::json!({
            "key": format!("{prefix}{}", self.name),
            "default": default,
            "unit": self.unit,
            "apply": self.apply,
            "group": self.group,
            "label": self.label,
            "help": self.help,
            "source": self.source,
        });
        let scale = |log: bool| if log { "log" } else { "linear" };
        let (kind, more) = match &self.kind {
            Kind::Int { min, max, hard_max, log } => (
                "int",
                serde_json::json!({"min": min, "max": max, "hard_max": hard_max, "step": 1, "scale": scale(*log)}),
            ),
            Kind::Float { min, max, hard_max, step, log } => (
                "float",
                serde_json::json!({"min": min, "max": max, "hard_max": hard_max, "step": step, "scale": scale(*log)}),
            ),
            Kind::Bool => ("bool", serde_json::json!({})),
            Kind::Choice(choices) => {
                let choices: Vec<Value> =
                    choices.iter().map(|(value, label)| serde_json::json!({"value": value, "label": label})).collect();
                ("choice", serde_json::json!({ "choices": choices }))
            }
            Kind::Text(most) => ("text", serde_json::json!({ "max_length": most })),
            Kind::List(most) => ("list", serde_json::json!({ "max_length": most })),
        };
        if let (Value::Object(entry), Value::Object(more)) = (&mut entry, more) {
            entry.insert("type".to_owned(), Value::from(kind));
            entry.extend(more);
        }
        entry
    }
}
