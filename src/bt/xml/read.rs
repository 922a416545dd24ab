//! From text to a draft of the document: elements, attributes and comments, with everything that the shape decides.

use super::check;
use super::document::{Attribute, Document, Element, Role, TreeDefinition, When};
use super::literal::reference;
use super::manifest::{Manifest, NodeKind, NodeType};
use super::model;
use super::problem::{Problem, Source};
use super::scan::{MOST_BYTES, element_name, scan};
use crate::nearest::nearest;
use crate::place::Place;
use roxmltree::{Node, TextPos};
use std::collections::BTreeMap;

/// Reads a document; the second part of the answer are warnings.
///
/// - `text`: XML of format 4, at most [`MOST_BYTES`] long; a byte order mark at its start is skipped.
/// - `manifest`: the nodes that can run. Nodes that only the document's models declare are accepted, with a warning.
///
/// # Errors
/// All problems of the text in the order in which they stand, warnings included; at least one is not a warning.
pub fn read(text: &str, manifest: &Manifest) -> Result<(Document, Vec<Problem>), Vec<Problem>> {
    let source = Source::new(text.trim_start_matches('\u{feff}'));
    if text.len() > MOST_BYTES {
        let message = format!("expected at most {MOST_BYTES} bytes, found {}", text.len());
        return Err(vec![Problem::fault("xml", source.place(0), message)]);
    }
    let open = scan(&source).map_err(|problem| vec![problem])?;
    let xml = roxmltree::Document::parse(source.text).map_err(|error| vec![not_well_formed(&error, open, &source)])?;
    let mut reader = Reader { source, known: Known { manifest, models: BTreeMap::new() }, problems: Vec::new() };
    let draft = reader.document(&xml);
    let Reader { source, known, mut problems } = reader;
    if let Some(draft) = &draft {
        check::check(draft, &known, &source, &mut problems);
    }
    problems.sort_by_key(|problem| problem.place);
    match draft.and_then(|draft| draft.finish(manifest)) {
        Some(document) if problems.iter().all(|problem| problem.warning) => Ok((document, problems)),
        _ => Err(problems),
    }
}

/// The document before it is known to be sound: a tree may have any number of top nodes.
pub(super) struct Draft {
    pub root: Place,
    /// The attribute `main_tree_to_execute`.
    pub main: Option<Attribute>,
    pub trees: Vec<DraftTree>,
    /// All but the trees and the main tree.
    pub document: Document,
}

pub(super) struct DraftTree {
    pub id: Option<Attribute>,
    pub place: Place,
    pub roots: Vec<Element>,
    attributes: Vec<Attribute>,
    comments: Vec<String>,
    trailing: Vec<String>,
}

impl Draft {
    /// The index of the tree to run: the one that is named, else the only one.
    pub fn main_index(&self) -> Option<usize> {
        match &self.main {
            Some(main) => self.trees.iter().position(|tree| tree.id() == Some(&main.value)),
            None => (self.trees.len() == 1).then_some(0),
        }
    }

    /// The document; none when a tree has not exactly one top node or there is no main tree, which is reported.
    fn finish(self, manifest: &Manifest) -> Option<Document> {
        let main = self.main_index()?;
        let mut document = Document { main, ..self.document };
        for tree in self.trees {
            let mut roots = tree.roots.into_iter();
            let (Some(root), None) = (roots.next(), roots.next()) else { return None };
            document.trees.push(TreeDefinition {
                id: tree.id.map(|id| id.value),
                root,
                attributes: tree.attributes,
                comments: tree.comments,
                trailing: tree.trailing,
                place: tree.place,
            });
        }
        let missing = document.missing_models(manifest);
        document.models.extend(missing);
        Some(document)
    }
}

impl DraftTree {
    pub fn id(&self) -> Option<&str> {
        self.id.as_ref().map(|id| id.value.as_str())
    }
}

/// The node types of the manifest and of the document's models.
pub(super) struct Known<'a> {
    pub manifest: &'a Manifest,
    /// By name; a subtree's model is named after its tree.
    pub models: BTreeMap<String, NodeType>,
}

impl Known<'_> {
    /// The type of that name, the registered one first.
    pub fn find(&self, name: &str) -> Option<&NodeType> {
        let model = || self.models.get(name).filter(|model| model.kind != NodeKind::SubTree);
        self.manifest.find(name).or_else(model)
    }
}

pub(super) struct Reader<'a> {
    pub source: Source<'a>,
    pub known: Known<'a>,
    pub problems: Vec<Problem>,
}

/// The elements below a node, each with the comments before it, and the comments after the last one.
type Contents<'d, 'i> = (Vec<(Vec<String>, Node<'d, 'i>)>, Vec<String>);

impl<'a> Reader<'a> {
    pub fn fault(&mut self, code: &'static str, place: Place, message: impl Into<String>) {
        self.problems.push(Problem::fault(code, place, message));
    }

    pub fn place(&self, node: Node) -> Place {
        self.source.place(node.range().start)
    }

    /// The name as written, with its prefix: we know no namespaces.
    pub fn name(&self, node: Node) -> &'a str {
        element_name(&self.source.text[node.range()])
    }

    /// The attributes as written, all as metadata.
    pub fn attributes(&mut self, node: Node) -> Vec<Attribute> {
        let inherited = node.parent().map_or(1, |parent| parent.namespaces().len().max(1));
        if node.namespaces().len() > inherited {
            let message = "a namespace has no meaning here and is dropped";
            self.problems.push(Problem::warning("xml", self.place(node), message));
        }
        let read = |attribute: roxmltree::Attribute| {
            let range = attribute.range();
            let (name, _) = self.source.text[range.clone()].split_once('=').unwrap_or_default();
            let value_start = range.start + name.len() + 1;
            let quote = self.source.text[value_start..range.end].find(['"', '\'']).unwrap_or(0);
            let value_start = value_start + quote + 1;
            Attribute {
                name: name.trim_end().to_owned(),
                value: attribute.value().to_owned(),
                role: Role::Metadata,
                place: self.source.place(range.start),
                value_place: self.source.place(value_start),
                value_start,
            }
        };
        node.attributes().map(read).collect()
    }

    /// The elements and comments directly below a node; other markup and text is dropped with a warning.
    pub fn contents<'d, 'i>(&mut self, parent: Node<'d, 'i>) -> Contents<'d, 'i> {
        let (mut elements, mut comments) = (Vec::new(), Vec::new());
        for node in parent.children() {
            if node.is_element() {
                elements.push((std::mem::take(&mut comments), node));
            } else if node.is_comment() {
                comments.push(node.text().unwrap_or_default().to_owned());
            } else {
                let text = node.text().unwrap_or_default();
                if node.is_pi() || !text.trim().is_empty() {
                    let what = if node.is_pi() { "an instruction" } else { "text" };
                    let blanks = if node.is_pi() { 0 } else { self.leading_blanks(node) };
                    let place = self.source.place(node.range().start + blanks);
                    let message = format!("{what} between elements has no meaning here and is dropped");
                    self.problems.push(Problem::warning("xml", place, message));
                }
            }
        }
        (elements, comments)
    }

    fn leading_blanks(&self, node: Node) -> usize {
        let typed = &self.source.text[node.range()];
        typed.len() - typed.trim_start().len()
    }

    fn document(&mut self, xml: &roxmltree::Document) -> Option<Draft> {
        let (mut elements, epilogue) = self.contents(xml.root());
        let (comments, root) = elements.pop()?;
        let place = self.place(root);
        if self.name(root) != "root" {
            let message = format!("expected <root> as the outer element, found <{}>", self.name(root));
            self.fault("xml", place, message);
            return None;
        }
        let mut document = Document { comments, epilogue, ..Document::default() };
        let mut attributes = self.attributes(root);
        let mut take = |name: &str| {
            let at = attributes.iter().position(|attribute| attribute.name == name)?;
            Some(attributes.remove(at))
        };
        let (main, format) = (take("main_tree_to_execute"), take("BTCPP_format"));
        document.attributes = attributes;
        self.format(place, format.as_ref());

        let (elements, trailing) = self.contents(root);
        document.trailing = trailing;
        let mut models_at: Option<Place> = None;
        for (comments, element) in &elements {
            if self.name(*element) == "TreeNodesModel" {
                let at = self.place(*element);
                if let Some(first) = models_at {
                    self.fault("model", at, format!("expected one TreeNodesModel, found another one (first: {first})"));
                }
                models_at = Some(models_at.unwrap_or(at));
                document.models_comments.extend_from_slice(comments);
                model::read_models(self, *element, &mut document);
            }
        }
        let mut trees = Vec::new();
        for (comments, element) in elements {
            match self.name(element) {
                "BehaviorTree" => trees.push(self.tree(comments, element)),
                "TreeNodesModel" => {}
                "include" => {
                    let message = "include is not supported: put the trees of the other file into this one";
                    self.fault("include", self.place(element), message);
                }
                other => {
                    let near = if other.len() > 64 {
                        None
                    } else {
                        nearest(other, ["BehaviorTree", "TreeNodesModel", "include"].into_iter())
                    };
                    let near = near.map_or(String::new(), |near| format!(", did you mean <{near}>?"));
                    let message =
                        format!("expected <BehaviorTree> or <TreeNodesModel> in <root>, found <{other}>{near}");
                    self.fault("xml", self.place(element), message);
                }
            }
        }
        Some(Draft { root: place, main, trees, document })
    }

    fn format(&mut self, root: Place, format: Option<&Attribute>) {
        let (place, found) = match format {
            None => (root, "none".to_owned()),
            Some(format) if format.value == super::FORMAT => return,
            Some(format) => (format.place, format!("{:?}", format.value)),
        };
        let message = format!("expected BTCPP_format=\"{}\", found {found}; it is read as format 4", super::FORMAT);
        self.problems.push(Problem::warning("format", place, message));
    }

    fn tree(&mut self, comments: Vec<String>, node: Node) -> DraftTree {
        let place = self.place(node);
        let mut attributes = self.attributes(node);
        let id = attributes.iter().position(|attribute| attribute.name == "ID").map(|at| attributes.remove(at));
        let (elements, trailing) = self.contents(node);
        let roots: Vec<Element> =
            elements.into_iter().map(|(comments, element)| self.element(comments, element)).collect();
        let called = id.as_ref().map_or("BehaviorTree".to_owned(), |id| format!("BehaviorTree {:?}", id.value));
        check::one_child(&called, place, &roots, &mut self.problems);
        DraftTree { id, place, roots, attributes, comments, trailing }
    }

    /// Reads a node and what is below it; the nesting is limited before.
    fn element(&mut self, comments: Vec<String>, node: Node) -> Element {
        let place = self.place(node);
        let tag = self.name(node);
        let mut attributes = self.attributes(node);
        let form = NodeKind::from_name(tag);
        let id = attributes.iter().position(|attribute| attribute.name == "ID");
        let id = match (form, id) {
            (Some(_), Some(at)) => Some(attributes.remove(at)),
            (Some(NodeKind::SubTree), None) => {
                self.fault(
                    "id-misuse",
                    place,
                    "expected the attribute ID in <SubTree>, which names a tree, found none",
                );
                None
            }
            (Some(form), None) => {
                let form = form.name();
                let message = format!("expected the attribute ID in <{form}>, which names the node, found none");
                self.fault("id-misuse", place, message);
                None
            }
            (None, Some(at)) => {
                let id = attributes.remove(at);
                let message = format!("expected no attribute ID in <{tag}>, found ID={:?}", id.value);
                self.fault("id-misuse", id.place, message);
                None
            }
            (None, None) => None,
        };
        let is_subtree = form == Some(NodeKind::SubTree);
        for attribute in &mut attributes {
            attribute.role = role(&attribute.name, is_subtree);
        }
        let id_place = id.as_ref().map_or(Place::default(), |id| id.place);
        let id = id.map(|id| id.value);
        let type_name = match (form, &id) {
            (None | Some(NodeKind::SubTree), _) => tag.to_owned(),
            (Some(_), id) => id.clone().unwrap_or_default(),
        };
        let (elements, trailing) = self.contents(node);
        let children: Vec<Element> =
            elements.into_iter().map(|(comments, child)| self.element(comments, child)).collect();
        let found = self.known.find(&type_name).map(|found| found.kind);
        if let (Some(form), Some(kind)) = (form, found)
            && form != kind
        {
            let message = format!("expected <{} ID={type_name:?}>, found <{}>", kind.name(), form.name());
            self.problems.push(Problem::warning("kind", place, message));
        }
        let kind = found.or(form).unwrap_or(NodeKind::Action);
        let is_runnable = self.known.manifest.find(&type_name).is_some();
        let tree = if is_subtree { id } else { None };
        let explicit = form.is_some() && !is_subtree;
        Element {
            type_name,
            kind,
            explicit,
            is_runnable,
            tree,
            attributes,
            children,
            comments,
            trailing,
            place,
            id_place,
        }
    }
}

/// What an attribute of a node is for.
fn role(name: &str, is_subtree: bool) -> Role {
    let condition = When::ALL.into_iter().find(|when| when.attribute() == name);
    match name {
        "name" => Role::Name,
        "_autoremap" if is_subtree => Role::AutoRemap,
        _ if condition.is_some() => condition.map_or(Role::Metadata, Role::Condition),
        _ if name.starts_with('_') => Role::Metadata,
        _ => Role::Port,
    }
}

/// The reader's error with its place in front and our words where its own would puzzle.
fn not_well_formed(error: &roxmltree::Error, open: Option<(usize, &str)>, source: &Source) -> Problem {
    let TextPos { row, col } = error.pos();
    let place = Place { line: row, column: col };
    let (place, message) = match (error, open) {
        (roxmltree::Error::UnclosedRootNode, Some((at, name))) => {
            (source.place(at), format!("expected </{name}> for this element, found the end of the text"))
        }
        (roxmltree::Error::UnexpectedCloseTag(expected, found, _), _) => {
            (place, format!("expected </{expected}>, found </{found}>"))
        }
        (roxmltree::Error::NoRootNode, _) => (source.place(0), "expected <root>, found no element".to_owned()),
        (roxmltree::Error::DuplicatedAttribute(name, _), _) => {
            (place, format!("expected each attribute once, found {name:?} again"))
        }
        _ => {
            let text = error.to_string();
            let text = text.strip_suffix(&format!(" at {row}:{col}")).unwrap_or(&text);
            (place, text.replace(&format!(" at {row}:{col}"), ""))
        }
    };
    Problem::fault("xml", place, message)
}

/// True when a port is given a literal, which can be checked before anything runs.
pub(super) fn is_literal(value: &str) -> bool {
    reference(value).is_none()
}
