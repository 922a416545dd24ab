//! The models of `TreeNodesModel`.

use super::check::name_fault;
use super::document::{Attribute, Document, Model, ModelPart, ModelPort};
use super::manifest::{Direction, NodeKind};
use super::problem::Problem;
use super::read::Reader;
use roxmltree::Node;
use std::collections::BTreeSet;

/// Reads all models into the document and makes their node types known.
pub(super) fn read_models(reader: &mut Reader, section: Node, document: &mut Document) {
    for attribute in reader.attributes(section) {
        dropped(reader, &attribute);
    }
    let (elements, trailing) = reader.contents(section);
    document.models_trailing.extend(trailing);
    for (comments, element) in elements {
        if let Some(mut model) = read_model(reader, element) {
            model.comments = comments;
            if reader.known.models.insert(model.id.clone(), model.node_type()).is_some() {
                let message = format!("expected one model for {:?}, found another one", model.id);
                reader.problems.push(Problem::warning("model", model.place, message));
            }
            document.models.push(model);
        }
    }
}

fn dropped(reader: &mut Reader, attribute: &Attribute) {
    let message = format!("the attribute {:?} has no meaning here and is dropped", attribute.name);
    reader.problems.push(Problem::warning("model", attribute.place, message));
}

/// Takes the attribute of that name out of the list.
fn take(attributes: &mut Vec<Attribute>, name: &str) -> Option<Attribute> {
    let at = attributes.iter().position(|attribute| attribute.name == name)?;
    Some(attributes.remove(at))
}

fn read_model(reader: &mut Reader, node: Node) -> Option<Model> {
    let place = reader.place(node);
    let name = reader.name(node);
    let Some(kind) = NodeKind::from_name(name) else {
        let message =
            format!("expected a model <Action>, <Condition>, <Control>, <Decorator> or <SubTree>, found <{name}>");
        reader.fault("model", place, message);
        return None;
    };
    let mut attributes = reader.attributes(node);
    let id = take(&mut attributes, "ID");
    let mut parts = Vec::new();
    let mut names = BTreeSet::new();
    let (elements, trailing) = reader.contents(node);
    for (comments, element) in elements {
        parts.extend(comments.into_iter().map(ModelPart::Comment));
        let tag = reader.name(element);
        let directions = [Direction::In, Direction::Out, Direction::InOut];
        if let Some(direction) = directions.into_iter().find(|direction| direction.element() == tag) {
            let Some(declared) = read_port(reader, element, direction, &mut parts) else { continue };
            if !names.insert(declared.name.clone()) {
                let message = format!("expected each port once, found {:?} again", declared.name);
                reader.problems.push(Problem::warning("model", declared.place, message));
            }
            parts.push(ModelPart::Port(declared));
        } else if tag == "MetadataFields" {
            read_fields(reader, element, &mut parts);
        } else {
            let message = format!("expected a port or <MetadataFields> in a model, found <{tag}>, which is dropped");
            reader.problems.push(Problem::warning("model", reader.place(element), message));
        }
    }
    parts.extend(trailing.into_iter().map(ModelPart::Comment));
    let Some(id) = id else {
        reader.fault("model", place, format!("expected the attribute ID in the model <{name}>, found none"));
        return None;
    };
    if let Some(fault) = name_fault(if kind == NodeKind::SubTree { "tree" } else { "node" }, &id.value) {
        reader.fault("bad-name", id.place, fault);
    }
    if let Some(registered) = reader.known.manifest.find(&id.value).map(|node| node.kind).filter(|found| *found != kind)
    {
        let message = format!("expected a model <{}> for {:?}, found <{name}>", registered.name(), id.value);
        reader.problems.push(Problem::warning("model", place, message));
    }
    Some(Model { kind, id: id.value, attributes, parts, comments: Vec::new(), place })
}

/// Reads a port; comments inside it move in front of it.
fn read_port(reader: &mut Reader, node: Node, direction: Direction, before: &mut Vec<ModelPart>) -> Option<ModelPort> {
    let place = reader.place(node);
    let mut attributes = reader.attributes(node);
    let name = take(&mut attributes, "name");
    let type_name = take(&mut attributes, "type").map(|attribute| attribute.value);
    let default = take(&mut attributes, "default").map(|attribute| attribute.value);
    let mut description = String::new();
    for child in node.children() {
        if child.is_comment() {
            before.push(ModelPart::Comment(child.text().unwrap_or_default().to_owned()));
        } else if child.is_text() {
            description.push_str(child.text().unwrap_or_default());
        } else {
            let message = "expected text in a port, found other markup, which is dropped";
            reader.problems.push(Problem::warning("model", reader.place(child), message));
        }
    }
    let Some(name) = name else {
        reader.fault("model", place, format!("expected the attribute name in <{}>, found none", direction.element()));
        return None;
    };
    if let Some(fault) = name_fault("port", &name.value) {
        reader.fault("bad-name", name.place, fault);
    }
    let description = description.trim().to_owned();
    Some(ModelPort { name: name.value, direction, type_name, default, description, attributes, place })
}

fn read_fields(reader: &mut Reader, node: Node, parts: &mut Vec<ModelPart>) {
    for attribute in reader.attributes(node) {
        dropped(reader, &attribute);
    }
    let (elements, trailing) = reader.contents(node);
    for (comments, element) in elements {
        parts.extend(comments.into_iter().map(ModelPart::Comment));
        if reader.name(element) == "Metadata" && !element.has_children() {
            let fields = reader.attributes(element);
            parts.push(ModelPart::Metadata(fields));
        } else {
            let message =
                "expected <Metadata> without content in <MetadataFields>, found something else, which is dropped";
            reader.problems.push(Problem::warning("model", reader.place(element), message));
        }
    }
    parts.extend(trailing.into_iter().map(ModelPart::Comment));
}
