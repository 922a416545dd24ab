//! A tree as a picture: SVG that stands alone and follows the viewer's light or dark theme.

use super::xml::{Document, Element, NodeKind, TreeDefinition, When};
use std::fmt::Write;

/// Pixels, on a grid of 4.
const HEIGHT: f64 = 36.0;
const ROW: f64 = 68.0;
const GAP: f64 = 16.0;
const MARGIN: f64 = 24.0;
const LETTER: f64 = 7.2;

const STYLE: &str = "\
text{font:12px system-ui,sans-serif;fill:#1c2127;text-anchor:middle}\
.type{font-size:10px;fill:#59636e}.title{text-anchor:start;font-weight:600}\
rect{fill:#fafaf7;stroke:#1c2127}.ground{stroke:none}path{fill:none;stroke:#59636e}.subtree{stroke-dasharray:4 3}\
@media(prefers-color-scheme:dark){text{fill:#e8eaed}.type{fill:#9aa4af}rect{fill:#14171c;stroke:#e8eaed}path{stroke:#9aa4af}}";

/// Draws every tree of a document, the main one first; returns the text of an SVG file.
#[must_use]
pub fn draw_svg(document: &Document) -> String {
    let mut body = String::new();
    let (mut width, mut top) = (0.0_f64, MARGIN);
    let others = document.trees.iter().enumerate().filter(|(index, _)| *index != document.main).map(|(_, tree)| tree);
    for tree in document.main_tree().into_iter().chain(others) {
        let (used, height) = draw_tree(tree, top, &mut body);
        width = width.max(used);
        top += height;
    }
    let (width, height) = (width + 2.0 * MARGIN, top);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\
         <style>{STYLE}</style><rect class=\"ground\" width=\"{width}\" height=\"{height}\"/>{body}</svg>\n"
    )
}

/// Draws one tree below `top`; returns its width and height.
fn draw_tree(tree: &TreeDefinition, top: f64, out: &mut String) -> (f64, f64) {
    let title = tree.id.as_deref().unwrap_or("Behaviour tree");
    // Writing to a String cannot fail.
    let _ = write!(out, "<text class=\"title\" x=\"{MARGIN}\" y=\"{}\">{}</text>", top + 12.0, escaped(title));
    let laid = Laid::of(&tree.root);
    laid.draw(MARGIN, top + 28.0, out);
    (laid.width.max(title.chars().count() as f64 * LETTER), 28.0 + f64::from(laid.levels) * ROW)
}

/// A node with the room it takes.
struct Laid<'a> {
    element: &'a Element,
    children: Vec<Laid<'a>>,
    label: String,
    /// Of the node with all below it.
    width: f64,
    own: f64,
    levels: u32,
}

impl<'a> Laid<'a> {
    fn of(element: &'a Element) -> Self {
        let children: Vec<Self> = element.children.iter().map(Self::of).collect();
        let label = label(element);
        let letters = label.chars().count().max(kind_text(element).chars().count());
        let own = (letters as f64 * LETTER + 20.0).ceil().max(56.0);
        let below: f64 =
            children.iter().map(|child| child.width).sum::<f64>() + GAP * children.len().saturating_sub(1) as f64;
        let levels = 1 + children.iter().map(|child| child.levels).max().unwrap_or(0);
        Self { element, children, label, width: own.max(below), own, levels }
    }

    /// Draws the node centred over its children and returns the x of its middle.
    fn draw(&self, left: f64, top: f64, out: &mut String) -> f64 {
        let below: f64 = self.children.iter().map(|child| child.width).sum::<f64>()
            + GAP * self.children.len().saturating_sub(1) as f64;
        let mut x = left + (self.width - below) / 2.0;
        let mut middles = Vec::new();
        for child in &self.children {
            middles.push(child.draw(x, top + ROW, out));
            x += child.width + GAP;
        }
        let middle = match (middles.first(), middles.last()) {
            (Some(first), Some(last)) => f64::midpoint(*first, *last),
            _ => left + self.width / 2.0,
        };
        // Not clamp, which panics where rounding turns the bounds round.
        let middle = middle.max(left + self.own / 2.0).min(left + self.width - self.own / 2.0);
        let (from, to) = (top + HEIGHT, top + ROW);
        let bend = f64::midpoint(from, to);
        for child in middles {
            let _ = write!(out, "<path d=\"M{middle} {from}C{middle} {bend} {child} {bend} {child} {to}\"/>");
        }
        let class = if self.element.kind == NodeKind::SubTree { " class=\"subtree\"" } else { "" };
        let round = if matches!(self.element.kind, NodeKind::Condition) { HEIGHT / 2.0 } else { 3.0 };
        let _ = write!(
            out,
            "<rect{class} x=\"{}\" y=\"{top}\" width=\"{}\" height=\"{HEIGHT}\" rx=\"{round}\"/>\
             <text x=\"{middle}\" y=\"{}\">{}</text><text class=\"type\" x=\"{middle}\" y=\"{}\">{}</text>",
            middle - self.own / 2.0,
            self.own,
            top + 16.0,
            escaped(&self.label),
            top + 29.0,
            escaped(&kind_text(self.element)),
        );
        middle
    }
}

/// The instance name, with the sign of the common control nodes before it.
fn label(element: &Element) -> String {
    let sign = match element.type_name.as_str() {
        "Sequence" | "AsyncSequence" | "SequenceWithMemory" | "ReactiveSequence" => "\u{2192} ",
        "Fallback" | "AsyncFallback" | "ReactiveFallback" => "? ",
        "Parallel" | "ParallelAll" => "\u{21c9} ",
        "Inverter" => "\u{00ac} ",
        _ => "",
    };
    format!("{sign}{}", element.name())
}

/// The registered name with the guards that stand on the node.
fn kind_text(element: &Element) -> String {
    let mut text = element.type_name.clone();
    for guard in When::ALL.into_iter().filter(|when| element.condition(*when).is_some()) {
        text.extend([" ", guard.attribute()]);
    }
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
