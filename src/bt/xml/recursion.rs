//! Trees that contain trees: cycles, and sizes after every SubTree is replaced, found without replacing any.

use super::document::Element;
use super::manifest::NodeKind;
use super::problem::Problem;
use super::read::Draft;
use super::scan::DEEPEST;
use crate::place::Place;
use std::collections::BTreeMap;

/// The most nodes of a tree after all its SubTrees are replaced by what they stand for.
pub const MOST_NODES: u64 = 100_000;

/// A tree as seen from outside.
struct Outline<'a> {
    name: &'a str,
    nodes: u64,
    depth: u64,
    /// The trees it contains: index, place of the SubTree, nesting there.
    uses: Vec<(usize, Place, u64)>,
}

#[derive(Clone, Copy, PartialEq)]
enum Mark {
    New,
    Open,
    Done,
}

/// Reports trees that contain themselves; when there is none, the first SubTree that makes a tree too large or too
/// deep.
pub(super) fn check(draft: &Draft, problems: &mut Vec<Problem>) {
    let mut index = BTreeMap::new();
    for (at, tree) in draft.trees.iter().enumerate() {
        if let Some(id) = tree.id() {
            index.entry(id).or_insert(at);
        }
    }
    let outlines: Vec<Outline> = draft
        .trees
        .iter()
        .map(|tree| {
            let mut outline =
                Outline { name: tree.id().unwrap_or("BehaviorTree"), nodes: 0, depth: 0, uses: Vec::new() };
            tree.roots.iter().for_each(|root| outline.add(root, 1, &index));
            outline
        })
        .collect();
    let before = problems.len();
    let order = leaves_first(&outlines, problems);
    if problems.len() == before {
        problems.extend(first_excess(&outlines, &order));
    }
}

impl Outline<'_> {
    fn add(&mut self, element: &Element, depth: u64, index: &BTreeMap<&str, usize>) {
        self.nodes += 1;
        self.depth = self.depth.max(depth);
        if let (NodeKind::SubTree, Some(tree)) = (element.kind, &element.tree)
            && let Some(&at) = index.get(tree.as_str())
        {
            self.uses.push((at, element.place, depth));
        }
        for child in &element.children {
            self.add(child, depth + 1, index);
        }
    }
}

/// The trees in an order in which each stands behind those it contains, without recursion: a chain of trees may be
/// as long as the text. Every SubTree that closes a cycle is reported.
fn leaves_first(outlines: &[Outline], problems: &mut Vec<Problem>) -> Vec<usize> {
    let mut marks = vec![Mark::New; outlines.len()];
    let mut order = Vec::new();
    for start in 0..outlines.len() {
        if marks[start] != Mark::New {
            continue;
        }
        marks[start] = Mark::Open;
        let mut path = vec![(start, 0)];
        while let Some((tree, next)) = path.last_mut() {
            let Some(&(inner, place, _)) = outlines[*tree].uses.get(*next) else {
                marks[*tree] = Mark::Done;
                order.push(*tree);
                path.pop();
                continue;
            };
            *next += 1;
            match marks[inner] {
                Mark::Done => {}
                Mark::New => {
                    marks[inner] = Mark::Open;
                    path.push((inner, 0));
                }
                Mark::Open => {
                    let cycle = path.iter().skip_while(|(tree, _)| *tree != inner).map(|(tree, _)| *tree);
                    problems.push(Problem::fault("recursion", place, cycle_message(outlines, cycle.collect(), inner)));
                }
            }
        }
    }
    order
}

/// The longest cycle that is printed whole.
const MOST_PRINTED: usize = 12;

fn cycle_message(outlines: &[Outline], cycle: Vec<usize>, inner: usize) -> String {
    let name = outlines[inner].name;
    let (count, long) = (cycle.len(), cycle.len() > MOST_PRINTED);
    let mut names: Vec<&str> = cycle.into_iter().take(MOST_PRINTED).map(|tree| outlines[tree].name).collect();
    if long {
        names.push("...");
    }
    names.push(name);
    let long = if long { format!(" ({count} trees)") } else { String::new() };
    format!("expected no tree inside itself, found {}{long}", names.join(" > "))
}

/// The first SubTree that takes its tree over a limit.
fn first_excess(outlines: &[Outline], order: &[usize]) -> Option<Problem> {
    let mut whole = vec![(0_u64, 0_u64); outlines.len()];
    for &tree in order {
        let outline = &outlines[tree];
        let (mut nodes, mut deepest) = (outline.nodes, outline.depth);
        for &(inner, place, depth) in &outline.uses {
            nodes += whole[inner].0;
            deepest = deepest.max(depth + whole[inner].1);
            let (what, most) = if nodes > MOST_NODES {
                ("nodes", MOST_NODES)
            } else if deepest > DEEPEST as u64 {
                ("nodes inside each other", DEEPEST as u64)
            } else {
                continue;
            };
            let message =
                format!("expected at most {most} {what} in {} with all its subtrees, found more", outline.name);
            return Some(Problem::fault("depth", place, message));
        }
        whole[tree] = (nodes, deepest);
    }
    None
}
