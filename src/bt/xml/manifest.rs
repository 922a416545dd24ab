//! What nodes there are: the 42 built-ins of BehaviorTree.CPP 4.10 and the leaves that the host registers.

use super::check::name_fault;
use super::literal::PortType;
use std::collections::BTreeMap;
use std::fmt;

/// What a node may have below it, and what it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NodeKind {
    /// A leaf that acts.
    Action,
    /// A leaf that looks.
    Condition,
    /// One or more children.
    Control,
    /// Exactly one child.
    Decorator,
    /// No child in the text; stands for another tree.
    SubTree,
}

impl NodeKind {
    /// The name of the explicit form, as in `<Action ID="...">`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Action => "Action",
            Self::Condition => "Condition",
            Self::Control => "Control",
            Self::Decorator => "Decorator",
            Self::SubTree => "SubTree",
        }
    }

    /// The kind of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Action, Self::Condition, Self::Control, Self::Decorator, Self::SubTree]
            .into_iter()
            .find(|kind| kind.name() == name)
    }
}

/// Whether a node reads a port, writes it, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Direction {
    /// Read.
    In,
    /// Written; a literal here is the name of an entry.
    Out,
    /// Both.
    InOut,
}

impl Direction {
    /// The element that declares such a port in a model.
    #[must_use]
    pub fn element(self) -> &'static str {
        match self {
            Self::In => "input_port",
            Self::Out => "output_port",
            Self::InOut => "inout_port",
        }
    }
}

/// A named opening of a node to the blackboard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// The attribute that sets it.
    pub name: String,
    /// Read, written or both.
    pub direction: Direction,
    /// What a literal has to be.
    pub port_type: PortType,
    /// What is taken when the attribute is absent.
    pub default: Option<String>,
    /// True when the node cannot do without.
    pub mandatory: bool,
    /// One phrase for people.
    pub description: String,
}

impl Port {
    /// A mandatory port without default.
    #[must_use]
    pub fn new(name: &str, direction: Direction, port_type: PortType, description: &str) -> Self {
        Self {
            name: name.to_owned(),
            direction,
            port_type,
            default: None,
            mandatory: true,
            description: description.to_owned(),
        }
    }

    /// The same port, not mandatory.
    #[must_use]
    pub fn optional(mut self) -> Self {
        self.mandatory = false;
        self
    }

    /// The same port with a default, hence not mandatory.
    #[must_use]
    pub fn with_default(mut self, default: &str) -> Self {
        self.default = Some(default.to_owned());
        self.optional()
    }
}

/// How many children a node takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arity {
    /// At least so many.
    pub least: u32,
    /// At most so many; none is no limit.
    pub most: Option<u32>,
    /// True when another number is refused; false when it is a warning, because the reference fails only in the tick.
    pub strict: bool,
}

/// A kind of node that can stand in a tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NodeType {
    /// The registered name.
    pub name: String,
    /// What it is.
    pub kind: NodeKind,
    /// Its ports, in the order declared.
    pub ports: Vec<Port>,
    /// How many children it takes.
    pub arity: Arity,
}

impl NodeType {
    /// A node type whose number of children follows from its kind.
    #[must_use]
    pub fn new(name: &str, kind: NodeKind, ports: Vec<Port>) -> Self {
        let (least, most) = match kind {
            NodeKind::Action | NodeKind::Condition | NodeKind::SubTree => (0, Some(0)),
            NodeKind::Decorator => (1, Some(1)),
            NodeKind::Control => (1, None),
        };
        Self { name: name.to_owned(), kind, ports, arity: Arity { least, most, strict: true } }
    }

    /// The port of that name.
    #[must_use]
    pub fn port(&self, name: &str) -> Option<&Port> {
        self.ports.iter().find(|port| port.name == name)
    }
}

/// The built-in node types: 17 controls, 16 decorators, SubTree and 8 leaves.
///
/// Source: the registrations and port lists of BehaviorTree.CPP 4.10.0; descriptions are ours.
#[must_use]
pub fn builtin_nodes() -> Vec<NodeType> {
    use super::literal::Item;
    use Direction::{In, InOut, Out};
    use NodeKind::{Action, Condition, Control, Decorator, SubTree};
    use PortType::{Any, Bool, Int, Queue, Script, Status, Text, Unsigned};

    let plain = |kind: NodeKind, names: &[&str]| -> Vec<NodeType> {
        names.iter().map(|name| NodeType::new(name, kind, Vec::new())).collect()
    };
    let with_children = |mut node: NodeType, least, most, strict| {
        node.arity = Arity { least, most, strict };
        node
    };
    let mut nodes = plain(Control, &["Sequence", "AsyncSequence", "SequenceWithMemory", "ReactiveSequence"]);
    nodes.extend(plain(Control, &["Fallback", "AsyncFallback", "ReactiveFallback"]));
    nodes.push(NodeType::new(
        "Parallel",
        Control,
        vec![
            Port::new("success_count", In, Int, "successes that end it; -1 is all children").with_default("-1"),
            Port::new("failure_count", In, Int, "failures that end it; -1 is all children").with_default("1"),
        ],
    ));
    nodes.push(NodeType::new(
        "ParallelAll",
        Control,
        vec![Port::new("max_failures", In, Int, "so many failures make it fail").with_default("1")],
    ));
    nodes.extend(
        plain(Control, &["IfThenElse", "WhileDoElse"]).into_iter().map(|node| with_children(node, 2, Some(3), false)),
    );
    for cases in 2..=6 {
        let mut ports = vec![Port::new("variable", In, Text, "the value that selects a child")];
        ports.extend((1..=cases).map(|case| Port::new(&format!("case_{case}"), In, Text, "selects this child")));
        let switch = NodeType::new(&format!("Switch{cases}"), Control, ports);
        nodes.push(with_children(switch, cases + 1, Some(cases + 1), false));
    }
    let halted = Port::new("catch_on_halt", In, Bool, "a halt inside the block ticks the clean-up once");
    nodes.push(with_children(NodeType::new("TryCatch", Control, vec![halted.with_default("false")]), 2, None, true));

    nodes.extend(plain(Decorator, &["Inverter", "ForceSuccess", "ForceFailure"]));
    let cycles = Port::new("num_cycles", In, Int, "successes wanted; -1 is endless");
    let attempts = Port::new("num_attempts", In, Int, "failures allowed; -1 is endless");
    nodes.push(NodeType::new("Repeat", Decorator, vec![cycles]));
    nodes.push(NodeType::new("RetryUntilSuccessful", Decorator, vec![attempts]));
    nodes.extend(plain(Decorator, &["KeepRunningUntilFailure"]));
    let delay = Port::new("delay_msec", In, Unsigned, "milliseconds before the child is ticked");
    let due = Port::new("msec", In, Unsigned, "milliseconds until the child is halted; 0 is never");
    nodes.push(NodeType::new("Delay", Decorator, vec![delay]));
    nodes.push(NodeType::new("Timeout", Decorator, vec![due]));
    let skip = Port::new("then_skip", In, Bool, "afterwards skipped, otherwise the same status again");
    nodes.push(NodeType::new("RunOnce", Decorator, vec![skip.with_default("true")]));
    nodes.push(NodeType::new(
        "Precondition",
        Decorator,
        vec![
            Port::new("if", In, Script, "the child is ticked when this is true"),
            Port::new("else", In, Status, "the status otherwise").with_default("FAILURE"),
        ],
    ));
    let loops =
        [("LoopInt", Item::Int), ("LoopBool", Item::Bool), ("LoopDouble", Item::Real), ("LoopString", Item::Text)];
    for (name, item) in loops {
        let ports = vec![
            Port::new("queue", InOut, Queue(item), "the values that are left"),
            Port::new("value", Out, item.port_type(), "the value of this turn").optional(),
            Port::new("if_empty", In, Status, "the status of an empty queue").with_default("SUCCESS"),
        ];
        nodes.push(NodeType::new(name, Decorator, ports));
    }
    for name in ["SkipUnlessUpdated", "WaitValueUpdate"] {
        nodes.push(NodeType::new(name, Decorator, vec![Port::new("entry", In, Any, "the entry to look at")]));
    }
    let remap = Port::new("_autoremap", In, Bool, "entries of the same name are shared with the parent");
    nodes.push(NodeType::new("SubTree", SubTree, vec![remap.with_default("false")]));

    nodes.extend(plain(Action, &["AlwaysSuccess", "AlwaysFailure"]));
    nodes.push(NodeType::new("Script", Action, vec![Port::new("code", In, Script, "the script to run")]));
    nodes.push(NodeType::new("ScriptCondition", Condition, vec![Port::new("code", In, Script, "true is SUCCESS")]));
    nodes.push(NodeType::new(
        "SetBlackboard",
        Action,
        vec![
            Port::new("output_key", InOut, Any, "the entry to write"),
            Port::new("value", In, Any, "a literal, or the entry to copy"),
        ],
    ));
    nodes.push(NodeType::new("UnsetBlackboard", Action, vec![Port::new("key", In, Text, "the entry to remove")]));
    nodes.push(NodeType::new("Sleep", Action, vec![Port::new("msec", In, Unsigned, "milliseconds to wait")]));
    nodes.push(NodeType::new("WasEntryUpdated", Action, vec![Port::new("entry", In, Any, "the entry to look at")]));
    nodes
}

/// Why a leaf cannot be registered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RegisterError(String);

impl fmt::Display for RegisterError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

impl std::error::Error for RegisterError {}

/// The nodes that can run: the built-ins and the host's leaves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Manifest {
    /// Each node type, and whether it is built in.
    nodes: BTreeMap<String, (NodeType, bool)>,
}

impl Default for Manifest {
    fn default() -> Self {
        Self { nodes: builtin_nodes().into_iter().map(|node| (node.name.clone(), (node, true))).collect() }
    }
}

impl Manifest {
    /// Adds a leaf of the host.
    ///
    /// # Errors
    /// When the kind is no leaf, the name is no allowed name or is taken already, or a port's name is not allowed.
    pub fn register(&mut self, name: &str, kind: NodeKind, ports: Vec<Port>) -> Result<(), RegisterError> {
        if !matches!(kind, NodeKind::Action | NodeKind::Condition) {
            let found = kind.name();
            return Err(RegisterError(format!("expected Action or Condition for {name:?}, found {found}")));
        }
        if let Some(fault) = name_fault("node", name) {
            return Err(RegisterError(fault));
        }
        if self.nodes.contains_key(name) || NodeKind::from_name(name).is_some() {
            return Err(RegisterError(format!("expected a new name, found {name:?} again")));
        }
        if let Some(fault) = ports.iter().find_map(|port| name_fault("port", &port.name)) {
            return Err(RegisterError(fault));
        }
        self.nodes.insert(name.to_owned(), (NodeType::new(name, kind, ports), false));
        Ok(())
    }

    /// The node type of that name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&NodeType> {
        self.nodes.get(name).map(|(node, _)| node)
    }

    /// True for the 42 built-ins.
    #[must_use]
    pub fn is_builtin(&self, name: &str) -> bool {
        self.nodes.get(name).is_some_and(|(_, builtin)| *builtin)
    }

    /// All node types by name.
    pub fn nodes(&self) -> impl Iterator<Item = &NodeType> {
        self.nodes.values().map(|(node, _)| node)
    }
}
