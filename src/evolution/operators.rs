//! Selection, crossover and mutation.

use super::Genome;
use crate::random::Stream;
use rand::RngExt;

/// Orders `order` best first and returns how many of them are parents: `share` of all, at least 2 (truncation
/// selection). Equal fitness keeps the order of `order`.
///
/// - `order`: indices into `fitness`; at least 2.
/// - `fitness`: any reals; NaN, the fitness of an invalid individual, is below every number.
/// - `share`: in (0, 1]; the number of parents is rounded down.
pub fn best_share(order: &mut [u32], fitness: &[f64], share: f64) -> usize {
    let key = |index: u32| {
        let value = fitness[index as usize];
        if value.is_nan() { f64::NEG_INFINITY } else { value }
    };
    order.sort_by(|&a, &b| key(b).total_cmp(&key(a)));
    ((order.len() as f64 * share) as usize).clamp(2.min(order.len()), order.len())
}

/// Draws `size` of `fitness` with replacement and returns the index of the best; a tie goes to the one drawn first.
///
/// - `fitness`: at least one; NaN loses against every number.
/// - `size`: at least 1.
pub fn tournament(rng: &mut Stream, fitness: &[f64], size: u32) -> usize {
    let mut draw = || rng.random_range(0..fitness.len() as u32) as usize;
    let mut best = draw();
    for _ in 1..size {
        let challenger = draw();
        if fitness[challenger] > fitness[best] || fitness[best].is_nan() {
            best = challenger;
        }
    }
    best
}

/// Variable one-point crossover: each parent is cut at its own random point, and the tails are exchanged.
///
/// The children get `used` 0: they are not mapped yet. The cuts lie behind codon 1 to the last active codon of
/// each parent, so that both heads have at least one codon. A child longer than `longest` loses its end.
///
/// Source: BeTr-GEESE, Table 1 ("variable onepoint"); cuts within the used part as in `PonyGE2`.
pub fn one_point_crossover(rng: &mut Stream, parents: [&Genome; 2], longest: u16, children: [&mut Genome; 2]) {
    let cuts = parents.map(|parent| rng.random_range(1..=parent.active().max(1) as u32) as usize);
    for (child, (head, tail)) in children.into_iter().zip([(0, 1), (1, 0)]) {
        child.used = 0;
        child.codons.clear();
        child.codons.extend_from_slice(&parents[head].codons[..cuts[head].min(parents[head].codons.len())]);
        child.codons.extend_from_slice(&parents[tail].codons[cuts[tail].min(parents[tail].codons.len())..]);
        child.codons.truncate(usize::from(longest));
    }
}

/// Random changes of single codons or bits, each with the same probability.
///
/// The distance to the next change is drawn (a geometric number), not a coin for each place: the result has the
/// same distribution at a tenth of the draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mutation {
    unit: Unit,
    codon_max: u16,
    probability: f64,
    /// 1 / ln(1 - probability).
    scale: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Bit,
    Codon,
}

impl Mutation {
    /// Each bit flips with `probability`; `codon_max` must be one less than a power of two.
    #[must_use]
    pub fn of_bits(probability: f64, codon_max: u16) -> Self {
        Self::new(Unit::Bit, probability, codon_max)
    }

    /// Each codon is drawn again from 0 to `codon_max` with `probability`.
    #[must_use]
    pub fn of_codons(probability: f64, codon_max: u16) -> Self {
        Self::new(Unit::Codon, probability, codon_max)
    }

    fn new(unit: Unit, probability: f64, codon_max: u16) -> Self {
        Self { unit, codon_max, probability, scale: 1.0 / libm::log1p(-probability) }
    }

    /// Mutates the first `active` codons of `genome`; returns the index of the first codon touched, or `None`.
    ///
    /// `active` is [`Genome::active`] of the genome as it was mapped before.
    pub fn apply(&self, rng: &mut Stream, genome: &mut Genome, active: usize) -> Option<usize> {
        let bits = (u16::BITS - self.codon_max.leading_zeros()) as usize;
        let places = match self.unit {
            Unit::Bit => active * bits,
            Unit::Codon => active,
        };
        let mut first = None;
        let mut place = self.distance(rng, places);
        while place < places {
            let codon = match self.unit {
                Unit::Bit => {
                    genome.codons[place / bits] ^= 1 << (place % bits);
                    place / bits
                }
                Unit::Codon => {
                    genome.codons[place] = rng.random_range(0..=self.codon_max);
                    place
                }
            };
            first.get_or_insert(codon);
            place += 1 + self.distance(rng, places);
        }
        first
    }

    /// Places left out before the next change; at least `places` when none of them changes.
    fn distance(&self, rng: &mut Stream, places: usize) -> usize {
        if self.probability <= 0.0 {
            return places;
        }
        if self.probability >= 1.0 {
            return 0;
        }
        // 1 - u lies in (0, 1], so the logarithm is finite and at most 0; the quotient saturates as an integer.
        let u: f64 = rng.random();
        ((libm::log(1.0 - u) * self.scale) as usize).min(places)
    }
}
