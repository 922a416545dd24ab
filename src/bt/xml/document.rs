//! A document in memory: trees, models, comments and metadata, enough to write the same document again.

use super::literal::PortType;
use super::manifest::{Direction, Manifest, NodeKind, NodeType, Port};
use crate::place::Place;
use std::collections::BTreeSet;

/// The one format that is read and written.
pub const FORMAT: &str = "4";

/// A whole document. The format is always [`FORMAT`]: another one is a warning when the text is read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// The tree to run, as index into `trees`.
    pub main: usize,
    /// The trees in the order written.
    pub trees: Vec<TreeDefinition>,
    /// The models in the order written; those of registered leaves that are used without one follow at the end.
    pub models: Vec<Model>,
    /// Attributes of `root` beyond format and main tree.
    pub attributes: Vec<Attribute>,
    /// Comments before `root`.
    pub comments: Vec<String>,
    /// Comments before `TreeNodesModel`.
    pub models_comments: Vec<String>,
    /// Comments in `TreeNodesModel` after the last model.
    pub models_trailing: Vec<String>,
    /// Comments in `root` after the last element.
    pub trailing: Vec<String>,
    /// Comments after `root`.
    pub epilogue: Vec<String>,
}

/// One `BehaviorTree`.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeDefinition {
    /// The name; only the tree of a document with a single tree may have none.
    pub id: Option<String>,
    /// The top node.
    pub root: Element,
    /// Attributes beyond `ID`.
    pub attributes: Vec<Attribute>,
    /// Comments before the tree.
    pub comments: Vec<String>,
    /// Comments after the top node.
    pub trailing: Vec<String>,
    /// Where `<BehaviorTree` stands.
    pub place: Place,
}

/// One node of a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// The registered name, also in the explicit form; `SubTree` for subtrees.
    pub type_name: String,
    /// What the registered node is.
    pub kind: NodeKind,
    /// True when written as `<Action ID="Name">`.
    pub explicit: bool,
    /// False when the node is declared in a model only: it can be shown and edited, not run.
    pub is_runnable: bool,
    /// The tree that a SubTree stands for.
    pub tree: Option<String>,
    /// All attributes but `ID`, in the order written.
    pub attributes: Vec<Attribute>,
    /// The children in order.
    pub children: Vec<Element>,
    /// Comments before the element.
    pub comments: Vec<String>,
    /// Comments after the last child.
    pub trailing: Vec<String>,
    /// Where the `<` stands.
    pub place: Place,
    /// Where the attribute `ID` stands, if there is one.
    pub id_place: Place,
}

/// One attribute.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// The name as written.
    pub name: String,
    /// The value, entities replaced.
    pub value: String,
    /// What it is for.
    pub role: Role,
    /// Where the name begins.
    pub place: Place,
    /// Where the value begins, behind the quote.
    pub value_place: Place,
    /// The same as a byte of the text.
    pub(super) value_start: usize,
}

/// What an attribute of a node is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The instance name.
    Name,
    /// A port.
    Port,
    /// A pre- or post-condition.
    Condition(When),
    /// `_autoremap` of a SubTree.
    AutoRemap,
    /// Anything else; kept, without effect.
    Metadata,
}

/// When the script of a pre- or post-condition runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum When {
    /// Idle: true is FAILURE.
    FailureIf,
    /// Idle: true is SUCCESS.
    SuccessIf,
    /// Idle: true is SKIPPED.
    SkipIf,
    /// Idle and running: false is SKIPPED.
    While,
    /// After SUCCESS.
    OnSuccess,
    /// After FAILURE.
    OnFailure,
    /// After either.
    Post,
    /// After a halt.
    OnHalted,
}

impl When {
    /// All eight, in the order in which they are looked at.
    pub const ALL: [Self; 8] = [
        Self::FailureIf,
        Self::SuccessIf,
        Self::SkipIf,
        Self::While,
        Self::OnSuccess,
        Self::OnFailure,
        Self::Post,
        Self::OnHalted,
    ];

    /// The attribute.
    #[must_use]
    pub fn attribute(self) -> &'static str {
        match self {
            Self::FailureIf => "_failureIf",
            Self::SuccessIf => "_successIf",
            Self::SkipIf => "_skipIf",
            Self::While => "_while",
            Self::OnSuccess => "_onSuccess",
            Self::OnFailure => "_onFailure",
            Self::Post => "_post",
            Self::OnHalted => "_onHalted",
        }
    }
}

/// The model of a node in `TreeNodesModel`: what an editor needs to know.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// What the node is.
    pub kind: NodeKind,
    /// Its registered name; of a SubTree, the tree.
    pub id: String,
    /// Attributes beyond `ID`.
    pub attributes: Vec<Attribute>,
    /// Ports, metadata and comments in the order written.
    pub parts: Vec<ModelPart>,
    /// Comments before the model.
    pub comments: Vec<String>,
    /// Where the `<` stands.
    pub place: Place,
}

/// A piece of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelPart {
    /// A declared port.
    Port(ModelPort),
    /// The attributes of one `Metadata` in `MetadataFields`.
    Metadata(Vec<Attribute>),
    /// A comment.
    Comment(String),
}

/// A port as a model declares it.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelPort {
    /// Its name.
    pub name: String,
    /// Read, written or both.
    pub direction: Direction,
    /// The type as written, such as `std::string`.
    pub type_name: Option<String>,
    /// The default as written.
    pub default: Option<String>,
    /// The text for people.
    pub description: String,
    /// Attributes beyond name, type and default.
    pub attributes: Vec<Attribute>,
    /// Where the `<` stands.
    pub place: Place,
}

impl Attribute {
    /// An attribute that was never in a text.
    #[must_use]
    pub fn new(name: &str, value: &str, role: Role) -> Self {
        let (place, value_place) = (Place::default(), Place::default());
        Self { name: name.to_owned(), value: value.to_owned(), role, place, value_place, value_start: 0 }
    }

    fn forget_place(&mut self) {
        (self.place, self.value_place, self.value_start) = (Place::default(), Place::default(), 0);
    }
}

impl Element {
    /// The instance name; the registered name, or a SubTree's tree, when none is given.
    #[must_use]
    pub fn name(&self) -> &str {
        let given = self.attributes.iter().find(|attribute| attribute.role == Role::Name);
        given.map_or_else(|| self.tree.as_deref().unwrap_or(&self.type_name), |attribute| &attribute.value)
    }

    /// The ports that are set, in the order written.
    pub fn ports(&self) -> impl Iterator<Item = &Attribute> {
        self.attributes.iter().filter(|attribute| attribute.role == Role::Port)
    }

    /// The value of a port, if it is set.
    #[must_use]
    pub fn port(&self, name: &str) -> Option<&Attribute> {
        self.ports().find(|attribute| attribute.name == name)
    }

    /// The script of a pre- or post-condition.
    #[must_use]
    pub fn condition(&self, when: When) -> Option<&Attribute> {
        self.attributes.iter().find(|attribute| attribute.role == Role::Condition(when))
    }

    /// True when a SubTree shares entries of the same name with its parent.
    #[must_use]
    pub fn autoremap(&self) -> bool {
        let given = self.attributes.iter().find(|attribute| attribute.role == Role::AutoRemap);
        given.is_some_and(|attribute| matches!(attribute.value.as_str(), "true" | "True" | "TRUE" | "1"))
    }

    /// Calls `visit` for this element and all below, parents first.
    pub fn each<'a>(&'a self, visit: &mut impl FnMut(&'a Self)) {
        visit(self);
        for child in &self.children {
            child.each(visit);
        }
    }

    fn forget_places(&mut self) {
        (self.place, self.id_place) = (Place::default(), Place::default());
        self.attributes.iter_mut().for_each(Attribute::forget_place);
        self.children.iter_mut().for_each(Self::forget_places);
    }
}

impl Model {
    /// The declared ports, in the order written.
    pub fn ports(&self) -> impl Iterator<Item = &ModelPort> {
        self.parts.iter().filter_map(|part| match part {
            ModelPart::Port(port) => Some(port),
            ModelPart::Metadata(_) | ModelPart::Comment(_) => None,
        })
    }

    /// The node type that the model describes; a port without default counts as mandatory.
    #[must_use]
    pub fn node_type(&self) -> NodeType {
        let ports = self.ports().map(|port| Port {
            name: port.name.clone(),
            direction: port.direction,
            port_type: port.type_name.as_deref().map_or(PortType::Any, PortType::from_model),
            default: port.default.clone(),
            mandatory: port.default.is_none(),
            description: port.description.clone(),
        });
        NodeType::new(&self.id, self.kind, ports.collect())
    }

    /// The model that describes a registered node.
    #[must_use]
    pub fn of(node: &NodeType) -> Self {
        let ports = node.ports.iter().map(|port| {
            ModelPart::Port(ModelPort {
                name: port.name.clone(),
                direction: port.direction,
                type_name: Some(port.port_type.model_name().to_owned()),
                default: port.default.clone(),
                description: port.description.trim().to_owned(),
                attributes: Vec::new(),
                place: Place::default(),
            })
        });
        Self {
            kind: node.kind,
            id: node.name.clone(),
            attributes: Vec::new(),
            parts: ports.collect(),
            comments: Vec::new(),
            place: Place::default(),
        }
    }

    fn forget_places(&mut self) {
        self.place = Place::default();
        self.attributes.iter_mut().for_each(Attribute::forget_place);
        for part in &mut self.parts {
            match part {
                ModelPart::Port(port) => {
                    port.place = Place::default();
                    port.attributes.iter_mut().for_each(Attribute::forget_place);
                }
                ModelPart::Metadata(fields) => fields.iter_mut().for_each(Attribute::forget_place),
                ModelPart::Comment(_) => {}
            }
        }
    }
}

impl Document {
    /// The tree to run, if there is any tree.
    #[must_use]
    pub fn main_tree(&self) -> Option<&TreeDefinition> {
        self.trees.get(self.main)
    }

    /// The index of the tree of that name.
    #[must_use]
    pub fn tree(&self, id: &str) -> Option<usize> {
        self.trees.iter().position(|tree| tree.id.as_deref() == Some(id))
    }

    /// True when every node of every tree can run.
    #[must_use]
    pub fn is_runnable(&self) -> bool {
        let mut runnable = true;
        self.each(&mut |element| runnable &= element.is_runnable);
        runnable
    }

    /// Calls `visit` for every node of every tree, in the order written.
    pub fn each<'a>(&'a self, visit: &mut impl FnMut(&'a Element)) {
        for tree in &self.trees {
            tree.root.each(visit);
        }
    }

    /// The same document with all places zero, to compare documents from different texts.
    #[must_use]
    pub fn without_places(mut self) -> Self {
        self.attributes.iter_mut().for_each(Attribute::forget_place);
        for tree in &mut self.trees {
            tree.place = Place::default();
            tree.attributes.iter_mut().for_each(Attribute::forget_place);
            tree.root.forget_places();
        }
        self.models.iter_mut().for_each(Model::forget_places);
        self
    }

    /// Models of the nodes that are used, are not built in and have none, in the order of their first use.
    #[must_use]
    pub fn missing_models(&self, manifest: &Manifest) -> Vec<Model> {
        let mut known: BTreeSet<&str> = self.models.iter().map(|model| model.id.as_str()).collect();
        let mut missing = Vec::new();
        self.each(&mut |element| {
            if element.kind == NodeKind::SubTree
                || manifest.is_builtin(&element.type_name)
                || !known.insert(&element.type_name)
            {
                return;
            }
            missing.push(manifest.find(&element.type_name).map_or_else(
                || {
                    let ports = element.ports().map(|port| Port::new(&port.name, Direction::InOut, PortType::Any, ""));
                    Model::of(&NodeType::new(&element.type_name, element.kind, ports.collect()))
                },
                Model::of,
            ));
        });
        missing
    }
}
