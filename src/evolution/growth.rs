//! Genomes made from a derivation, so that they are valid from the start.

use super::Genome;
use super::grammar::{Grammar, RuleId, Symbol};
use crate::random::Stream;
use rand::RngExt;

/// Fills `genome` with the codons of a random derivation and, behind them, half as many random ones; not mapped yet, so
/// `used` is 0. Returns false, with a genome of no use, when the derivation needs more than `longest` codons.
///
/// Each rule takes one of those alternatives that can end within the depth limit, all equally likely; its codon is drawn
/// from those that choose it.
///
/// - `max_depth`: at least the grammar's least depth.
/// - `longest`: the tail is cut where it would make the genome longer.
/// - `codon_max`: where it is too small to choose an alternative, the codon exceeds it.
/// - `pending`: memory for the search; what it holds does not matter.
///
/// Source: initialisation of `PonyGE2` as the authors of BeTr-GEESE use it.
pub fn grow(
    grammar: &Grammar,
    rng: &mut Stream,
    [max_depth, longest]: [u32; 2],
    codon_max: u16,
    genome: &mut Genome,
    pending: &mut Vec<(RuleId, u32)>,
) -> bool {
    genome.used = 0;
    genome.codons.clear();
    pending.clear();
    pending.push((RuleId(0), 1));
    while let Some((rule, depth)) = pending.pop() {
        if genome.codons.len() >= longest as usize {
            return false;
        }
        let fits = |alternative| {
            grammar.symbols(alternative).iter().all(|(symbol, _)| match symbol {
                Symbol::Terminal(_) => depth < max_depth,
                Symbol::NonTerminal(inner) => {
                    let least = grammar.least_depth_of(*inner);
                    least > 0 && depth + least <= max_depth
                }
            })
        };
        let alternatives = grammar.alternatives(rule);
        let count = alternatives.len() as u16;
        let fitting = alternatives.clone().filter(|id| fits(*id)).count() as u32;
        if fitting == 0 {
            return false;
        }
        let nth = rng.random_range(0..fitting) as usize;
        let Some((choice, chosen)) = alternatives.enumerate().filter(|(_, id)| fits(*id)).nth(nth) else {
            return false;
        };
        let multiples = codon_max.saturating_sub(choice as u16) / count;
        genome.codons.push(choice as u16 + count * rng.random_range(0..=multiples));
        for (symbol, _) in grammar.symbols(chosen).iter().rev() {
            if let Symbol::NonTerminal(inner) = symbol {
                pending.push((*inner, depth + 1));
            }
        }
    }
    let tail = (genome.codons.len() / 2).min(longest as usize - genome.codons.len());
    genome.codons.extend((0..tail).map(|_| rng.random_range(0..=codon_max)));
    true
}
