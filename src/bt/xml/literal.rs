//! Port values: references to entries, and literals that fit a type.

/// What a literal port value has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PortType {
    /// A whole number of 32 bits.
    Int,
    /// A whole number of 32 bits, not negative.
    Unsigned,
    /// A finite number.
    Real,
    /// A truth value.
    Bool,
    /// Any text.
    Text,
    /// A script that parses.
    Script,
    /// A status a node may return.
    Status,
    /// Items separated by `;`.
    Queue(Item),
    /// Anything.
    Any,
}

/// What the items of a queue are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Item {
    /// Whole numbers.
    Int,
    /// Truth values.
    Bool,
    /// Numbers.
    Real,
    /// Texts.
    Text,
}

impl Item {
    /// The type of one item.
    #[must_use]
    pub fn port_type(self) -> PortType {
        match self {
            Self::Int => PortType::Int,
            Self::Bool => PortType::Bool,
            Self::Real => PortType::Real,
            Self::Text => PortType::Text,
        }
    }
}

impl PortType {
    /// The type as a model of the reference writes it.
    #[must_use]
    pub fn model_name(self) -> &'static str {
        match self {
            Self::Int => "int",
            Self::Unsigned => "unsigned int",
            Self::Real => "double",
            Self::Bool => "bool",
            Self::Text | Self::Script => "std::string",
            Self::Status => "BT::NodeStatus",
            Self::Queue(Item::Int) => "std::shared_ptr<std::deque<int>>",
            Self::Queue(Item::Bool) => "std::shared_ptr<std::deque<bool>>",
            Self::Queue(Item::Real) => "std::shared_ptr<std::deque<double>>",
            Self::Queue(Item::Text) => "std::shared_ptr<std::deque<std::string>>",
            Self::Any => "BT::AnyTypeAllowed",
        }
    }

    /// The type a model means; a type we do not know takes anything.
    #[must_use]
    pub fn from_model(name: &str) -> Self {
        match name.trim() {
            "int" | "int32_t" => Self::Int,
            "unsigned int" | "unsigned" | "uint32_t" => Self::Unsigned,
            "double" | "float" => Self::Real,
            "bool" => Self::Bool,
            "std::string" | "string" => Self::Text,
            "NodeStatus" | "BT::NodeStatus" => Self::Status,
            _ => Self::Any,
        }
    }

    /// True when a literal can be read as this type. Scripts are parsed elsewhere, so any text will do for them.
    #[must_use]
    pub fn fits(self, literal: &str) -> bool {
        let digit_first = literal.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.');
        match self {
            Self::Int => digit_first && literal.parse::<i32>().is_ok(),
            Self::Unsigned => digit_first && literal.parse::<u32>().is_ok(),
            Self::Real => digit_first && literal.parse::<f64>().is_ok_and(f64::is_finite),
            Self::Bool => matches!(literal, "true" | "false" | "True" | "False" | "TRUE" | "FALSE" | "1" | "0"),
            Self::Status => matches!(literal, "SUCCESS" | "FAILURE" | "SKIPPED" | "RUNNING"),
            Self::Queue(item) => literal.is_empty() || literal.split(';').all(|one| item.port_type().fits(one)),
            Self::Text | Self::Script | Self::Any => true,
        }
    }

    /// What is allowed, for messages.
    #[must_use]
    pub fn wanted(self) -> &'static str {
        match self {
            Self::Int => "a whole number",
            Self::Unsigned => "a whole number that is not negative",
            Self::Real => "a number",
            Self::Bool => "true or false",
            Self::Text | Self::Any => "a text",
            Self::Script => "a script",
            Self::Status => "SUCCESS, FAILURE, SKIPPED or RUNNING",
            Self::Queue(Item::Int) => "whole numbers separated by ;",
            Self::Queue(Item::Bool) => "true or false, separated by ;",
            Self::Queue(Item::Real) => "numbers separated by ;",
            Self::Queue(Item::Text) => "texts separated by ;",
        }
    }
}

/// The entry that a port value names: `Some("goal")` for `{goal}`, `Some("=")` for `{=}` (the entry with the port's
/// own name), none for a literal. Blanks around the braces do not count.
#[must_use]
pub fn reference(value: &str) -> Option<&str> {
    value.trim().strip_prefix('{')?.strip_suffix('}').filter(|entry| !entry.is_empty())
}
