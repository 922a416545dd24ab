//! From a document to a tree that runs: subtrees expanded, ports and scripts bound to blackboard entries.

use super::blackboard::{EntryId, MAIN};
use super::builtin::{BoundScript, Builtin, Extra, Key, LoopType, Scripts, Source};
use super::script::Script;
use super::xml::{DEEPEST, Document, Element, Manifest, Model, NodeKind, PortType, Problem, When, reference};
use super::{Builder, Kind, Status, Tree, Value};

/// A leaf that the host runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HostLeaf {
    /// The registered name.
    pub type_name: String,
    /// The instance name.
    pub name: String,
    /// Action or condition.
    pub kind: NodeKind,
}

/// Builds the main tree of `document`.
///
/// # Errors
/// What keeps the document from running although it can be shown and edited: nodes that only a model declares, and
/// subtrees that nest too deep once they are expanded.
pub fn compile(document: &Document, manifest: &Manifest) -> Result<Tree<HostLeaf>, Vec<Problem>> {
    let mut compiler = Compiler { document, manifest, builder: Builder::default(), problems: Vec::new(), depth: 0 };
    compiler.builder.boards();
    if let Some(main) = document.main_tree() {
        compiler.element(&main.root, MAIN);
    }
    if !compiler.problems.is_empty() {
        return Err(compiler.problems);
    }
    compiler.builder.finish().map_err(|fault| {
        let place = document.main_tree().map(|tree| tree.place).unwrap_or_default();
        vec![Problem { code: "no-tree", place, message: fault.to_string(), warning: false }]
    })
}

struct Compiler<'a> {
    document: &'a Document,
    manifest: &'a Manifest,
    builder: Builder<HostLeaf>,
    problems: Vec<Problem>,
    depth: usize,
}

impl Compiler<'_> {
    fn element(&mut self, element: &Element, board: u32) {
        if self.depth >= DEEPEST {
            let message = format!("expected at most {DEEPEST} levels with all subtrees expanded, found more");
            self.problem("depth", element, message);
            return;
        }
        let Some(kind) = self.kind(element, board) else {
            let message =
                format!("expected a node that can run, found {:?}, which only a model declares", element.type_name);
            self.problem("unknown-node", element, message);
            return;
        };
        let extra = self.extra(element, board);
        self.builder.open(kind);
        self.builder.extra(extra);
        self.depth += 1;
        if element.kind == NodeKind::SubTree {
            let tree = element.tree.as_deref().and_then(|id| self.document.tree(id));
            if let Some(tree) = tree.and_then(|index| self.document.trees.get(index)) {
                let inner = self.scope(element, board);
                self.element(&tree.root, inner);
            }
        } else {
            for child in &element.children {
                self.element(child, board);
            }
        }
        self.depth -= 1;
        self.builder.close();
    }

    fn problem(&mut self, code: &'static str, element: &Element, message: String) {
        // One such fault stops the expansion of many subtrees, so one is enough.
        if self.problems.is_empty() {
            self.problems.push(Problem { code, place: element.place, message, warning: false });
        }
    }

    /// The board of a subtree: what is remapped to its parent's, and literals that are its own.
    fn scope(&mut self, element: &Element, parent: u32) -> u32 {
        let inner = self.builder.boards().add(parent, element.autoremap());
        let given = element.ports().map(|port| (port.name.as_str(), port.value.as_str()));
        let model = element
            .tree
            .as_deref()
            .and_then(|id| self.document.models.iter().find(|model| model.kind == NodeKind::SubTree && model.id == id));
        let defaults = model.into_iter().flat_map(Model::ports).filter_map(|port| {
            let default = port.default.as_deref()?;
            element.port(&port.name).is_none().then_some((port.name.as_str(), default))
        });
        for (name, value) in given.chain(defaults) {
            let boards = self.builder.boards();
            if let Some(entry) = reference(value) {
                let outer = boards.resolve(parent, if entry == "=" { name } else { entry });
                boards.remap(inner, name, outer);
            } else {
                let own = boards.keep(inner, name);
                boards.begin_with(own, Value::literal(value));
            }
        }
        inner
    }

    fn extra(&mut self, element: &Element, board: u32) -> Extra {
        let mut scripts = When::ALL.map(|when| {
            let attribute = element.condition(when)?;
            self.script(&attribute.value, board).filter(|bound| !bound.script.is_empty())
        });
        let ports = match self.manifest.find(&element.type_name) {
            Some(node) if !self.manifest.is_builtin(&element.type_name) => {
                let sources = node.ports.iter().map(|port| {
                    let given = element.port(&port.name).map(|attribute| attribute.value.as_str());
                    let value = given.or(port.default.as_deref());
                    (port.name.clone(), self.source(&port.name, value, port.port_type, board))
                });
                sources.collect()
            }
            _ => Vec::new(),
        };
        let scripts = scripts.iter().any(Option::is_some).then(|| {
            Box::new(Scripts {
                before: std::array::from_fn(|index| scripts[index].take()),
                after: std::array::from_fn(|index| scripts[index + 4].take()),
            })
        });
        Extra { name: element.name().to_owned(), scripts, ports }
    }

    /// A script with its names bound; the document was checked, so one that does not parse is none.
    fn script(&mut self, text: &str, board: u32) -> Option<BoundScript> {
        let script = Script::parse(text).ok()?;
        let entries = script.names().iter().map(|name| self.builder.boards().resolve(board, name)).collect();
        Some(BoundScript { script, entries })
    }

    fn source(&mut self, port: &str, value: Option<&str>, of: PortType, board: u32) -> Source {
        let Some(value) = value else { return Source::Missing };
        if let Some(entry) = reference(value) {
            return Source::Entry(self.builder.boards().resolve(board, if entry == "=" { port } else { entry }));
        }
        Source::Literal(match of {
            PortType::Int | PortType::Unsigned | PortType::Real => Value::literal(value),
            PortType::Bool => Value::Number(f64::from(u8::from(matches!(value, "true" | "True" | "TRUE" | "1")))),
            PortType::Text | PortType::Script | PortType::Status | PortType::Queue(_) | PortType::Any => {
                Value::Text(value.to_owned())
            }
        })
    }

    /// The source of a built-in node's port, its default included.
    fn port(&mut self, element: &Element, port: &str, board: u32) -> Source {
        let declared = self.manifest.find(&element.type_name).and_then(|node| node.port(port));
        let of = declared.map_or(PortType::Any, |declared| declared.port_type);
        let given = element.port(port).map(|attribute| attribute.value.clone());
        let value = given.or_else(|| declared.and_then(|declared| declared.default.clone()));
        self.source(port, value.as_deref(), of, board)
    }

    /// The entry that a port names, with or without braces.
    fn entry(&mut self, element: &Element, port: &str, board: u32) -> EntryId {
        let value = element.port(port).map_or("", |attribute| attribute.value.as_str());
        let name = reference(value).unwrap_or(value);
        self.builder.boards().resolve(board, if name == "=" { port } else { name })
    }

    /// A port whose text is the name of an entry: given as it is, or as what another entry holds.
    fn key(&mut self, element: &Element, port: &str, board: u32) -> Key {
        let value = element.port(port).map_or("", |attribute| attribute.value.as_str());
        match reference(value) {
            Some(by) => {
                Key::Named { board, by: self.builder.boards().resolve(board, if by == "=" { port } else { by }) }
            }
            None => Key::Entry(self.builder.boards().resolve(board, value)),
        }
    }

    /// The script of a port; nothing to run when it is not given.
    fn code(&mut self, element: &Element, port: &str, board: u32) -> Option<BoundScript> {
        self.script(&element.port(port)?.value, board)
    }

    /// What the node does; `None` for one that only a model declares.
    fn kind(&mut self, element: &Element, board: u32) -> Option<Kind<HostLeaf>> {
        let mut port = |name: &str| self.port(element, name, board);
        let builtin = match element.type_name.as_str() {
            "Sequence" => return Some(Kind::Sequence),
            "SequenceWithMemory" => return Some(Kind::SequenceWithMemory),
            "ReactiveSequence" => return Some(Kind::ReactiveSequence),
            "Fallback" => return Some(Kind::Fallback),
            "ReactiveFallback" => return Some(Kind::ReactiveFallback),
            "Inverter" => return Some(Kind::Inverter),
            "ForceSuccess" => return Some(Kind::ForceSuccess),
            "ForceFailure" => return Some(Kind::ForceFailure),
            "AsyncSequence" => Builtin::AsyncSequence,
            "AsyncFallback" => Builtin::AsyncFallback,
            "Parallel" => {
                Builtin::Parallel { success_count: port("success_count"), failure_count: port("failure_count") }
            }
            "ParallelAll" => Builtin::ParallelAll { max_failures: port("max_failures") },
            "IfThenElse" => Builtin::IfThenElse,
            "WhileDoElse" => Builtin::WhileDoElse,
            "TryCatch" => Builtin::TryCatch { catch_on_halt: port("catch_on_halt") },
            "Repeat" => Builtin::Repeat { num_cycles: port("num_cycles") },
            "RetryUntilSuccessful" => Builtin::RetryUntilSuccessful { num_attempts: port("num_attempts") },
            "KeepRunningUntilFailure" => Builtin::KeepRunningUntilFailure,
            "Delay" => Builtin::Delay { delay_msec: port("delay_msec") },
            "Timeout" => Builtin::Timeout { msec: port("msec") },
            "RunOnce" => Builtin::RunOnce { then_skip: port("then_skip") },
            "SubTree" => Builtin::SubTree,
            "AlwaysSuccess" => Builtin::AlwaysSuccess,
            "AlwaysFailure" => Builtin::AlwaysFailure,
            "Sleep" => Builtin::Sleep { msec: port("msec") },
            "Precondition" => Builtin::Precondition {
                condition: self.code(element, "if", board),
                otherwise: status_of(element, "else", Status::Failure),
            },
            "SkipUnlessUpdated" => Builtin::SkipUnlessUpdated { entry: self.entry(element, "entry", board) },
            "WaitValueUpdate" => Builtin::WaitValueUpdate { entry: self.entry(element, "entry", board) },
            "WasEntryUpdated" => Builtin::WasEntryUpdated { entry: self.entry(element, "entry", board) },
            "Script" => Builtin::Script { code: self.code(element, "code", board) },
            "ScriptCondition" => Builtin::ScriptCondition { code: self.code(element, "code", board) },
            "UnsetBlackboard" => Builtin::UnsetBlackboard { key: self.key(element, "key", board) },
            "SetBlackboard" => Builtin::SetBlackboard {
                output_key: self.key(element, "output_key", board),
                value: self.port(element, "value", board),
            },
            name if name.starts_with("Switch") && self.manifest.is_builtin(name) => {
                let cases = name.trim_start_matches("Switch").parse().unwrap_or(2);
                let cases = (1..=cases).map(|case: u32| self.port(element, &format!("case_{case}"), board)).collect();
                Builtin::Switch { variable: self.port(element, "variable", board), cases }
            }
            name if name.starts_with("Loop") && self.manifest.is_builtin(name) => Builtin::Loop {
                of: match name {
                    "LoopInt" => LoopType::Int,
                    "LoopBool" => LoopType::Bool,
                    "LoopDouble" => LoopType::Double,
                    _ => LoopType::String,
                },
                queue: self.port(element, "queue", board),
                value: self.port(element, "value", board),
                if_empty: status_of(element, "if_empty", Status::Success),
            },
            name => {
                self.manifest.find(name)?;
                return Some(Kind::Leaf(HostLeaf {
                    type_name: name.to_owned(),
                    name: element.name().to_owned(),
                    kind: element.kind,
                }));
            }
        };
        Some(self.builder.builtin(builtin))
    }
}

/// The status that a port gives.
fn status_of(element: &Element, port: &str, otherwise: Status) -> Status {
    match element.port(port).map(|attribute| attribute.value.as_str()) {
        Some("SUCCESS") => Status::Success,
        Some("FAILURE") => Status::Failure,
        Some("SKIPPED") => Status::Skipped,
        Some("RUNNING") => Status::Running,
        _ => otherwise,
    }
}
