//! The Coach, twice: a state machine and a behaviour tree over the same roles, conditions and hands.
//!
//! | | machine | tree |
//! |---|---|---|
//! | after a swap | waits in a swap state, where nothing else can happen | decides anew in each frame; a latch keeps only this pair from swapping back |
//! | priority | the order of the guards | the order of the children |
//! | calls of the referee | outside: they choose the start state | inside: the first branch |
//! | a new role | touches the edges of its states | adds a node |

mod check;
mod leaf;
pub mod machine;
mod tree;

pub use leaf::{Leaf, manifest};
pub use tree::{BUILT_IN, Latch, Program, TreeCoach, WITHOUT_SWAPS};
