//! A genome: codons, and how many of them the last mapping used.

use crate::fingerprint::Fingerprint;
use crate::random::Stream;
use rand::RngExt;

/// Codons of variable number. Cloning into a genome of at least that capacity allocates nothing.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Genome {
    /// The codons; each chooses an alternative of one rule.
    pub codons: Vec<u16>,
    /// Codons that the mapping used; 0 when the genome maps to no program.
    pub used: u16,
}

impl Clone for Genome {
    fn clone(&self) -> Self {
        Self { codons: self.codons.clone(), used: self.used }
    }

    fn clone_from(&mut self, source: &Self) {
        self.copy_from(source.view());
    }
}

impl Genome {
    /// Draws `length` codons uniformly from 0 to `codon_max`; not mapped yet, so `used` is 0.
    pub fn randomise(&mut self, rng: &mut Stream, length: u16, codon_max: u16) {
        self.codons.clear();
        self.codons.extend((0..length).map(|_| rng.random_range(0..=codon_max)));
        self.used = 0;
    }

    /// The same genome, borrowed.
    #[must_use]
    pub fn view(&self) -> GenomeRef<'_> {
        GenomeRef { codons: &self.codons, used: self.used }
    }

    /// Becomes a copy; allocates nothing when there is capacity.
    pub fn copy_from(&mut self, source: GenomeRef) {
        self.codons.clear();
        self.codons.extend_from_slice(source.codons);
        self.used = source.used;
    }
}

/// A genome that lies elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GenomeRef<'a> {
    /// As [`Genome::codons`].
    pub codons: &'a [u16],
    /// As [`Genome::used`].
    pub used: u16,
}

impl GenomeRef<'_> {
    /// How many codons, from the first, crossover and mutation may touch: the used ones, or all of a genome that
    /// maps to nothing. Wraps can use more codons than there are; then it is all of them.
    #[must_use]
    pub fn active(&self) -> usize {
        if self.used == 0 { self.codons.len() } else { self.codons.len().min(usize::from(self.used)) }
    }

    /// Feeds the codons and the used count.
    pub fn feed(&self, hash: &mut Fingerprint) {
        hash.u32(self.codons.len() as u32);
        for four in self.codons.chunks(4) {
            hash.u64(four.iter().fold(0, |word, &codon| word << 16 | u64::from(codon)));
        }
        hash.u32(u32::from(self.used));
    }
}
