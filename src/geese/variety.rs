//! How many different leaf names one program can have: the greatest diversity that breeding can reach.

use crate::evolution::{Grammar, RuleId, Symbol};

/// The most names of any derivation of `grammar` within `max_depth`.
///
/// - `own`: for each alternative the set of names its own text brings.
///
/// Returns 0 when nothing can be derived. The length of genomes is not looked at, so real programs may have fewer.
#[must_use]
pub fn most_names(grammar: &Grammar, own: &[u16], max_depth: u32) -> u32 {
    let rules = usize::from(grammar.rule_count());
    // The sets that each rule can derive with so many levels below it; none with 0 levels.
    let mut sets: Vec<Vec<u16>> = vec![Vec::new(); rules];
    for _ in 1..max_depth {
        let next: Vec<Vec<u16>> =
            (0..grammar.rule_count()).map(|rule| one_level_more(grammar, own, &sets, RuleId(rule))).collect();
        if next == sets {
            break;
        }
        sets = next;
    }
    sets[0].iter().map(|set| set.count_ones()).max().unwrap_or(0)
}

fn one_level_more(grammar: &Grammar, own: &[u16], sets: &[Vec<u16>], rule: RuleId) -> Vec<u16> {
    let mut derived = Vec::new();
    for alternative in grammar.alternatives(rule) {
        let mut unions = vec![own[usize::from(alternative.0)]];
        for (symbol, _) in grammar.symbols(alternative) {
            if let Symbol::NonTerminal(inner) = symbol {
                let inner = &sets[usize::from(inner.0)];
                unions = largest(unions.iter().flat_map(|a| inner.iter().map(move |b| a | b)).collect());
            }
        }
        derived.extend(unions);
    }
    largest(derived)
}

/// Drops every set that another one contains: it can never lead to more names.
fn largest(sets: Vec<u16>) -> Vec<u16> {
    let mut kept: Vec<u16> = Vec::new();
    for set in sets {
        if kept.iter().all(|other| other & set != set) {
            kept.retain(|other| other & set != *other);
            kept.push(set);
        }
    }
    kept
}
