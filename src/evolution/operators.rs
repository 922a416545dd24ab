//! Selection, crossover and mutation.

use super::{Genome, GenomeRef};
use crate::random::Stream;
use rand::RngExt;

/// Truncation selection: fills `chosen` with the indices of the `count` best of `fitness`, in rising order.
///
/// Of equal ones at the border the earlier ones are taken.
///
/// - `fitness`: any reals; NaN, the fitness of an invalid individual, is below every number.
/// - `count`: all are taken when there are fewer.
/// - `scratch`: memory for the search; what it holds does not matter.
pub fn fittest(fitness: &[f64], count: usize, scratch: &mut Vec<f64>, chosen: &mut Vec<u32>) {
    let count = count.min(fitness.len());
    let key = |value: f64| if value.is_nan() { f64::NEG_INFINITY } else { value };
    chosen.clear();
    if count == 0 {
        return;
    }
    scratch.clear();
    scratch.extend(fitness.iter().map(|&value| key(value)));
    // The value of the last one is the same whatever way the search takes; its order is not, and is not used.
    let (_, &mut border, _) = scratch.select_nth_unstable_by(count - 1, |a, b| b.total_cmp(a));
    let mut at_border = count - fitness.iter().filter(|&&value| key(value) > border).count();
    for (index, &value) in fitness.iter().enumerate() {
        let value = key(value);
        if value > border {
            chosen.push(index as u32);
        } else if value >= border && at_border > 0 {
            chosen.push(index as u32);
            at_border -= 1;
        }
    }
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
pub fn variable_one_point(rng: &mut Stream, parents: [GenomeRef; 2], longest: u16, children: [&mut Genome; 2]) {
    exchange_tails(parents, variable_cuts(rng, parents), longest, children);
}

/// Fixed one-point crossover: both parents are cut at the same random point within the shorter active part, so that
/// parents of equal length have children of that length. Otherwise as [`variable_one_point`].
pub fn fixed_one_point(rng: &mut Stream, parents: [GenomeRef; 2], longest: u16, children: [&mut Genome; 2]) {
    exchange_tails(parents, fixed_cuts(rng, parents), longest, children);
}

/// How many codons of each parent stay in front in [`variable_one_point`].
pub fn variable_cuts(rng: &mut Stream, parents: [GenomeRef; 2]) -> [usize; 2] {
    parents.map(|parent| rng.random_range(1..=parent.active().max(1) as u32) as usize)
}

/// How many codons of each parent stay in front in [`fixed_one_point`].
pub fn fixed_cuts(rng: &mut Stream, parents: [GenomeRef; 2]) -> [usize; 2] {
    let shorter = parents[0].active().min(parents[1].active()).max(1);
    [rng.random_range(1..=shorter as u32) as usize; 2]
}

/// The children of two parents that exchange what stands behind their cuts; a child longer than `longest` loses its end.
pub fn exchange_tails(parents: [GenomeRef; 2], cuts: [usize; 2], longest: u16, children: [&mut Genome; 2]) {
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
#[derive(Clone, Debug)]
pub struct Mutation {
    unit: Unit,
    codon_max: u16,
    /// Places that can change in one codon: its bits, or 1.
    places: u32,
    probability: f64,
    /// 1 / ln(1 - probability).
    scale: f64,
    /// For each of the shorter distances, the number below 1 from which on the distance is longer.
    ends: [f64; LISTED],
    /// The distance, `LISTED` at most, at the lower end of each part of the unit interval.
    starts: [u8; PARTS],
}

/// So many of the distances are listed, since most draws end there and a logarithm takes longer than all else in one.
const LISTED: usize = 64;

/// So many parts of the unit interval know where to look: in most of them no more than one distance ends.
const PARTS: usize = 256;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Bit,
    Codon,
}

impl Mutation {
    /// Each bit flips with `probability`; `codon_max` must be one less than a power of two.
    #[must_use]
    pub fn of_bits(probability: f64, codon_max: u16) -> Self {
        Self::new(Unit::Bit, u16::BITS - codon_max.leading_zeros(), probability, codon_max)
    }

    /// Each codon is drawn again from 0 to `codon_max` with `probability`.
    #[must_use]
    pub fn of_codons(probability: f64, codon_max: u16) -> Self {
        Self::new(Unit::Codon, 1, probability, codon_max)
    }

    fn new(unit: Unit, places: u32, probability: f64, codon_max: u16) -> Self {
        let scale = 1.0 / libm::log1p(-probability);
        let (ends, starts) = ([1.0; LISTED], [0; PARTS]);
        let mut mutation = Self { unit, codon_max, places, probability, scale, ends, starts };
        if probability > 0.0 && probability < 1.0 {
            mutation.list();
        }
        mutation
    }

    /// Lists the distances. Draws are multiples of 2^-53, so each end is found by halving.
    fn list(&mut self) {
        const DRAWS: u64 = 1 << 53;
        let draw = |number: u64| number as f64 / DRAWS as f64;
        let mut least = 0;
        for distance in 0..LISTED as u32 {
            let (mut low, mut high) = (least, DRAWS);
            while low < high {
                let middle = u64::midpoint(low, high);
                if self.calculated(draw(middle)) > distance {
                    high = middle;
                } else {
                    low = middle + 1;
                }
            }
            self.ends[distance as usize] = draw(low);
            least = low;
        }
        for (part, shortest) in self.starts.iter_mut().enumerate() {
            let start = part as f64 / PARTS as f64;
            *shortest = self.ends.iter().filter(|&&end| end <= start).count() as u8;
        }
    }

    /// Begins to mutate one genome from its first codon on.
    pub fn begin<'a>(&'a self, rng: &'a mut Stream) -> Mutating<'a> {
        let next = self.distance(rng);
        Mutating { mutation: self, rng, next }
    }

    /// Places left out before the next change; saturates where none comes.
    fn distance(&self, rng: &mut Stream) -> u32 {
        if self.probability <= 0.0 {
            return u32::MAX;
        }
        if self.probability >= 1.0 {
            return 0;
        }
        self.looked_up(rng.random())
    }

    /// The distance of a draw from [0, 1).
    fn looked_up(&self, u: f64) -> u32 {
        let start = self.starts[(u * PARTS as f64) as usize % PARTS];
        // Added without a branch, which would be mispredicted now and then.
        let mut distance = u32::from(start) + u32::from(u >= self.ends[usize::from(start) % LISTED]);
        while let Some(end) = self.ends.get(distance as usize) {
            if u < *end {
                return distance;
            }
            distance += 1;
        }
        self.calculated(u)
    }

    fn calculated(&self, u: f64) -> u32 {
        // 1 - u lies in (0, 1], so the logarithm is finite and at most 0; the conversion saturates.
        (libm::log(1.0 - u) * self.scale) as u32
    }
}

/// A mutation on its way through a genome: each codon changes, or not, when it is read for the first time.
#[derive(Debug)]
pub struct Mutating<'a> {
    mutation: &'a Mutation,
    rng: &'a mut Stream,
    /// Places from the next unread codon to the next change.
    next: u32,
}

impl Mutating<'_> {
    /// Passes over the next codon in order, changing it if its turn has come.
    #[expect(
        clippy::inline_always,
        reason = "once for each codon; a call takes a quarter more instructions of the mapping"
    )]
    #[inline(always)]
    pub fn pass(&mut self, codon: &mut u16) {
        let &Mutation { unit, codon_max, places, .. } = self.mutation;
        while self.next < places {
            match unit {
                Unit::Bit => *codon ^= 1 << self.next,
                Unit::Codon => *codon = self.rng.random_range(0..=codon_max),
            }
            self.next = self.mutation.distance(self.rng).saturating_add(self.next + 1);
        }
        self.next -= places;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Seed, stream};

    #[test]
    fn a_distance_that_is_looked_up_is_the_one_that_is_calculated() {
        let mut rng = stream(Seed::new(7).expect("small"), Purpose::Evolution, 0);
        for probability in [1e-9, 0.001, 0.01, 0.1, 0.3, 0.5, 0.9, 0.999] {
            let mutation = Mutation::of_codons(probability, 255);
            for _ in 0..20_000 {
                let u: f64 = rng.random();
                assert_eq!(mutation.looked_up(u), mutation.calculated(u), "{probability}: {u}");
            }
            // At the ends themselves, and at the last draw before each.
            for end in mutation.ends.into_iter().filter(|end| *end < 1.0) {
                for u in [end, end - 1.0 / (1_u64 << 53) as f64] {
                    assert_eq!(mutation.looked_up(u), mutation.calculated(u), "{probability}: {u}");
                }
            }
        }
    }
}
