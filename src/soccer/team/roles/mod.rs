//! The seven roles as behaviour trees on the shared engine: one tree a role, one leaf a state's condition or a skill.
//!
//! The names and purposes are the paper's (section 4.1), the behaviour is ours. Where its description leaves
//! something open:
//!
//! | question | choice |
//! |---|---|
//! | thresholds given once | the second one is ours: behind the ball 0 / -0.02, Striker waits below -0.50 / -0.45, far corner beyond 0.55 / 0.50 |
//! | "15-degree cone" | 15 degrees to both sides |
//! | which way to spin | so that the side at the ball moves it away from the own goal, or in the other half towards the other one |
//! | "one full spin" | until the robot has turned by 360 degrees, or for 0.5 s when something holds it |
//! | "beside the ball", waiting Striker | towards the middle of the pitch, where there is always room |
//! | getting the ball | the spirals lead to a place 0.04 behind it, where the approach limit is still that of 0.06: contact comes at the rim of the robot, before its centre would arrive |
//! | shooting | the run at the goal ends with the ball at x = 0.37, where the robot brakes and the ball rolls on: pushed on, ball and goalkeeper end up in the goal together |
//! | ball at rest before the goalkeeper | it drives out through it: the referee punishes a team that lets it lie |
//! | ball beside the goal | the goalkeeper gets between it and the goal, then drives it along the end wall into the corner |
//! | ball in the far corner | the Striker drives straight at it, since the spirals need more room than there is |
//! | corner | the Fullback waits at 0.46, not 0.40, from the middle, where nobody pushes it into the area |
//! | area rule, other area | nobody enters while an opponent has the ball there |
//! | area rule, ways | lead round an area that may not be entered |
//! | area rule, own area | while a goalkeeper is in it nobody else enters: the referee counts the keeper too |
//! | area rule, when | already while the ball is within 0.10 of the area, as the referee calls a foul from a single frame |

mod act;
mod area;
mod leaf;
mod player;
mod sense;

pub use leaf::{Leaf, MOST_NUMBERS, What, manifest};
pub use player::{Player, Scene};

use super::duties::Role;
use crate::bt::xml::{Document, Problem, reference};
use crate::bt::{HostLeaf, Tree, compile, xml};
use crate::nearest::nearest;
use crate::place::Place;

/// The built-in roles.
pub const BUILT_IN: &str = include_str!("../../../../trees/soccer/roles.xml");
/// Roles for a team that only chases the ball.
pub const CHASE: &str = include_str!("../../../../trees/soccer/chase.xml");

/// The trees of all roles, ready to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Roles {
    trees: Vec<Tree<Leaf>>,
}

impl Roles {
    /// Reads the trees of the roles.
    ///
    /// - `text`: XML of BehaviorTree.CPP with a tree for each role, named as [`Role::tree`] has it, and any further trees.
    ///
    /// # Errors
    /// What the reader refuses; numbers that are no literals; roles without a tree.
    pub fn read(text: &str) -> Result<Self, Vec<Problem>> {
        let manifest = manifest();
        let (mut document, _) = xml::read(text, &manifest)?;
        let mut problems = Vec::new();
        check_numbers(&document, &mut problems);
        let mut trees = Vec::new();
        for role in Role::ALL {
            let Some(index) = document.tree(role.tree()) else {
                problems.push(missing(&document, role));
                continue;
            };
            document.main = index;
            match compile(&document, &manifest) {
                Ok(tree) => trees.push(tree.map_leaves(|leaf: HostLeaf, extra| Leaf::of(&leaf, extra))),
                Err(faults) => problems.extend(faults),
            }
        }
        if problems.is_empty() { Ok(Self { trees }) } else { Err(problems) }
    }

    /// The tree of a role.
    #[must_use]
    pub fn tree(&self, role: Role) -> &Tree<Leaf> {
        &self.trees[role as usize]
    }
}

fn missing(document: &Document, role: Role) -> Problem {
    let names = document.trees.iter().filter_map(|tree| tree.id.as_deref());
    let near = nearest(role.tree(), names).map_or(String::new(), |near| format!(", found {near:?}"));
    let message = format!("expected a tree named {:?} for the role {}{near}", role.tree(), role.text());
    let place = document.trees.first().map_or(Place { line: 1, column: 1 }, |tree| tree.place);
    Problem { code: "no-role", place, message, warning: false }
}

/// Role trees take their numbers as they stand: looking them up on a board in every frame would cost more than the skill.
fn check_numbers(document: &Document, problems: &mut Vec<Problem>) {
    document.each(&mut |element| {
        let Some(what) = What::ALL.into_iter().find(|what| what.name() == element.type_name) else { return };
        for port in element.ports() {
            if what.numbers().iter().any(|(name, ..)| *name == port.name) && reference(&port.value).is_some() {
                let message = format!("expected a number for port {:?}, found the entry {}", port.name, port.value);
                problems.push(Problem { code: "bad-value", place: port.value_place, message, warning: false });
            }
        }
    });
}
