//! Canonical XML: one element a line, two blanks of indent, attributes in the order of the document.

use super::document::{Attribute, Document, Element, FORMAT, Model, ModelPart, TreeDefinition};
use super::manifest::{Manifest, NodeKind};

/// The document as XML format 4, with a model for every node that is not built in.
///
/// - `document`: nested at most as deep as [`super::DEEPEST`], as every document that was read is.
#[must_use]
pub fn write(document: &Document, manifest: &Manifest) -> String {
    let mut out = Writer { text: String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"), depth: 0 };
    out.comments(&document.comments);
    out.text.push_str("<root BTCPP_format=\"");
    out.text.push_str(FORMAT);
    out.text.push('"');
    if let Some(id) = document.main_tree().and_then(|tree| tree.id.as_ref()) {
        out.attribute("main_tree_to_execute", id);
    }
    out.attributes(&document.attributes);
    out.text.push_str(">\n");
    out.depth = 1;
    for tree in &document.trees {
        out.tree(tree);
    }
    let missing = document.missing_models(manifest);
    let models = || document.models.iter().chain(&missing);
    out.comments(&document.models_comments);
    if models().next().is_some() || !document.models_trailing.is_empty() || !document.models_comments.is_empty() {
        out.line("<TreeNodesModel>");
        out.depth = 2;
        models().for_each(|model| out.model(model));
        out.comments(&document.models_trailing);
        out.depth = 1;
        out.line("</TreeNodesModel>");
    }
    out.comments(&document.trailing);
    out.depth = 0;
    out.line("</root>");
    out.comments(&document.epilogue);
    out.text
}

struct Writer {
    text: String,
    depth: usize,
}

impl Writer {
    fn indent(&mut self) {
        self.text.extend(std::iter::repeat_n("  ", self.depth));
    }

    fn line(&mut self, line: &str) {
        self.indent();
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn comments(&mut self, comments: &[String]) {
        for comment in comments {
            self.indent();
            self.text.push_str("<!--");
            self.text.push_str(&comment_text(comment));
            self.text.push_str("-->\n");
        }
    }

    fn attribute(&mut self, name: &str, value: &str) {
        self.text.extend([" ", name, "=\""]);
        escape(value, true, &mut self.text);
        self.text.push('"');
    }

    fn attributes(&mut self, attributes: &[Attribute]) {
        for attribute in attributes {
            self.attribute(&attribute.name, &attribute.value);
        }
    }

    fn tree(&mut self, tree: &TreeDefinition) {
        self.comments(&tree.comments);
        self.indent();
        self.text.push_str("<BehaviorTree");
        if let Some(id) = &tree.id {
            self.attribute("ID", id);
        }
        self.attributes(&tree.attributes);
        self.text.push_str(">\n");
        self.depth += 1;
        self.element(&tree.root);
        self.comments(&tree.trailing);
        self.depth -= 1;
        self.line("</BehaviorTree>");
    }

    fn element(&mut self, element: &Element) {
        self.comments(&element.comments);
        self.indent();
        let explicit = element.explicit && element.kind != NodeKind::SubTree;
        let tag = if explicit { element.kind.name() } else { &element.type_name };
        self.text.extend(["<", tag]);
        if let Some(tree) = &element.tree {
            self.attribute("ID", tree);
        } else if explicit {
            self.attribute("ID", &element.type_name);
        }
        self.attributes(&element.attributes);
        if element.children.is_empty() && element.trailing.is_empty() {
            self.text.push_str("/>\n");
            return;
        }
        self.text.push_str(">\n");
        self.depth += 1;
        for child in &element.children {
            self.element(child);
        }
        self.comments(&element.trailing);
        self.depth -= 1;
        self.line(&format!("</{tag}>"));
    }

    fn model(&mut self, model: &Model) {
        self.comments(&model.comments);
        self.indent();
        self.text.extend(["<", model.kind.name()]);
        self.attribute("ID", &model.id);
        self.attributes(&model.attributes);
        if model.parts.is_empty() {
            self.text.push_str("/>\n");
            return;
        }
        self.text.push_str(">\n");
        self.depth += 1;
        let mut in_fields = false;
        for part in &model.parts {
            let is_field = matches!(part, ModelPart::Metadata(_));
            if is_field && !in_fields {
                self.line("<MetadataFields>");
            } else if in_fields && !is_field {
                self.line("</MetadataFields>");
            }
            in_fields = is_field;
            self.part(part);
        }
        if in_fields {
            self.line("</MetadataFields>");
        }
        self.depth -= 1;
        self.line(&format!("</{}>", model.kind.name()));
    }

    fn part(&mut self, piece: &ModelPart) {
        match piece {
            ModelPart::Comment(comment) => self.comments(std::slice::from_ref(comment)),
            ModelPart::Metadata(fields) => {
                self.indent();
                self.text.push_str("  <Metadata");
                self.attributes(fields);
                self.text.push_str("/>\n");
            }
            ModelPart::Port(port) => {
                self.indent();
                let tag = port.direction.element();
                self.text.extend(["<", tag]);
                self.attribute("name", &port.name);
                if let Some(type_name) = &port.type_name {
                    self.attribute("type", type_name);
                }
                if let Some(default) = &port.default {
                    self.attribute("default", default);
                }
                self.attributes(&port.attributes);
                if port.description.is_empty() {
                    self.text.push_str("/>\n");
                } else {
                    self.text.push('>');
                    escape(&port.description, false, &mut self.text);
                    self.text.extend(["</", tag, ">\n"]);
                }
            }
        }
    }
}

/// Replaces what XML would read as markup; in attributes also what it would turn into blanks.
fn escape(text: &str, attribute: bool, out: &mut String) {
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\r' => out.push_str("&#13;"),
            '"' if attribute => out.push_str("&quot;"),
            '\n' if attribute => out.push_str("&#10;"),
            '\t' if attribute => out.push_str("&#9;"),
            _ => out.push(character),
        }
    }
}

/// A comment's text without what would end it; texts that were read have none of that.
fn comment_text(comment: &str) -> String {
    let mut text = String::with_capacity(comment.len());
    for character in comment.chars() {
        if character == '-' && text.ends_with('-') {
            text.push(' ');
        }
        text.push(character);
    }
    if text.ends_with('-') {
        text.push(' ');
    }
    text
}
