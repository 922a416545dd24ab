//! Grammatical evolution: BNF grammars, the mapping from codons to programs, and the genetic operators.
//!
//! Knows nothing of worlds. The rules are those of `PonyGE2`, checked against oracle cases made with it.

mod cases;
mod genome;
mod grammar;
mod growth;
mod mapping;
mod operators;

pub use cases::Cases;
pub use genome::{Genome, GenomeRef};
pub use grammar::{AlternativeId, Grammar, GrammarError, RuleId, Symbol, TerminalId};
pub use growth::grow;
pub use mapping::{Codons, Derivation, Invalid, Limits, Mapped, Mapper, Phenotype};
pub use operators::{
    Mutating, Mutation, exchange_tails, fittest, fixed_cuts, fixed_one_point, tournament, variable_cuts,
    variable_one_point,
};
