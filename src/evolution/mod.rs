//! Grammatical evolution: BNF grammars, the mapping from codons to programs, and the genetic operators.
//!
//! Knows nothing of worlds. The rules are those of `PonyGE2`, checked against oracle cases made with it.

mod cases;
mod genome;
mod grammar;
mod mapping;
mod operators;

pub use cases::{Cases, CaseVerdict};
pub use genome::Genome;
pub use grammar::{AlternativeId, Grammar, GrammarError, Place, RuleId, Symbol, TerminalId};
pub use mapping::{Derivation, Invalid, Limits, Mapped, Mapper, Phenotype};
pub use operators::{Mutation, best_share, one_point_crossover, tournament};
