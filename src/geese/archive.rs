//! What a swarm took up while it learned: a fair sample of it, for a fixed population of more than the last programs.

use super::population::{Member, Population};
use crate::evolution::GenomeRef;
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, Stream, stream};
use rand::RngExt;
use std::sync::Arc;

/// A random sample of genomes that came one by one, each with the same chance to be in it.
///
/// Source: our answer to the open question of BeTr-GEESE, section 5. Programs drift: after a long learning the swarm's last
/// ones have lost kinds of actions that the task needs, but each kind was there at some time. The sample is drawn as in
/// J. Vitter, Random sampling with a reservoir (1985), algorithm R.
#[derive(Clone, Debug)]
pub struct Archive {
    /// Shared by the keyframes between which it does not change.
    sample: Arc<Vec<Vec<u16>>>,
    seen: u32,
    luck: Stream,
}

/// Genomes in the sample: ten for each robot of the paper's swarm.
const SIZE: u32 = 1_000;

impl Archive {
    /// Nothing seen yet.
    #[must_use]
    pub fn new(seed: Seed) -> Self {
        Self { sample: Arc::default(), seen: 0, luck: stream(seed, Purpose::Archive, 0) }
    }

    /// A genome that an agent has taken up.
    pub fn add(&mut self, genome: GenomeRef) {
        self.seen = self.seen.saturating_add(1);
        let sample = Arc::make_mut(&mut self.sample);
        if sample.len() < SIZE as usize {
            sample.push(genome.codons.to_vec());
            return;
        }
        let place = self.luck.random_range(0..self.seen);
        if let Some(former) = sample.get_mut(place as usize) {
            former.clear();
            former.extend_from_slice(genome.codons);
        }
    }

    /// The sample as a population; nobody knows what its members are worth. `None` while there is nothing in it.
    #[must_use]
    pub fn population(&self) -> Option<Population> {
        let members = self.sample.iter().map(|genome| Member { fitness: 0.0, genome: genome.clone() });
        (!self.sample.is_empty()).then(|| Population { members: members.collect() })
    }

    /// Feeds the sample, if there is one.
    pub fn feed(&self, hash: &mut Fingerprint) {
        if self.seen > 0 {
            hash.u32(self.seen);
            self.sample.iter().flatten().for_each(|&codon| hash.u32(u32::from(codon)));
            hash.stream(&self.luck);
        }
    }

    /// Bytes on the heap, as if nothing were shared.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.sample.iter().map(|genome| size_of::<Vec<u16>>() + genome.capacity() * 2).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_genome_has_the_same_chance_to_stay() {
        let mut kept = [0_u32; 4];
        for seed in 0..40 {
            let mut archive = Archive::new(Seed::new(seed).expect("small"));
            for codon in 0..4 * SIZE as u16 {
                archive.add(GenomeRef { codons: &[codon], used: 1 });
            }
            let members = archive.population().expect("genomes").members;
            assert_eq!(members.len(), SIZE as usize);
            for member in members {
                kept[usize::from(member.genome[0]) / SIZE as usize] += 1;
            }
        }
        // Of 40 samples of 1,000, a quarter from each quarter: 10,000, with a standard deviation of 75 or so.
        assert!(kept.iter().all(|&quarter| quarter.abs_diff(10_000) < 400), "{kept:?}");
    }
}
