//! Grammatical evolution: BNF grammars, the mapping from codons to programs, and the genetic operators.
//!
//! Knows nothing of worlds. The rules are those of `PonyGE2`, checked against oracle cases made with it.

mod cases;
mod genome;
mod grammar;
mod mapping;
mod operators;

pub use cases::Cases;
pub use genome::Genome;
pub use grammar::{AlternativeId, Grammar, GrammarError, RuleId, Symbol, TerminalId};
pub use mapping::{Codons, Derivation, Invalid, Limits, Mapped, Mapper, Phenotype};
pub use operators::{Mutating, Mutation, fittest, fixed_one_point, tournament, variable_one_point};
