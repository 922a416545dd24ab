//! The genomes of a swarm, each stored once, however many agents hold it.
//!
//! A meeting then notes a number. Copied at every meeting, the codons were most of what a crowd moved through memory, and
//! most copies were thrown away unread.

use crate::evolution::Genome;

/// The number of a genome among the [`Genomes`] of a swarm; good as long as it is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GenomeId(u32);

/// Genomes with the number of their holders. One that nobody holds keeps its memory for a later one.
#[derive(Clone, Debug, Default)]
pub struct Genomes {
    places: Vec<Genome>,
    holders: Vec<u32>,
    /// Places that nobody holds; the last one was in use most recently and is taken first, since it is near.
    free: Vec<u32>,
}

impl Genomes {
    /// The genome of that number.
    #[must_use]
    pub fn get(&self, id: GenomeId) -> &Genome {
        &self.places[id.0 as usize]
    }

    /// Adds a copy of a genome, with one holder.
    pub fn add(&mut self, genome: &Genome) -> GenomeId {
        if let Some(place) = self.free.pop() {
            self.places[place as usize].clone_from(genome);
            self.holders[place as usize] = 1;
            return GenomeId(place);
        }
        self.places.push(genome.clone());
        self.holders.push(1);
        GenomeId(self.places.len() as u32 - 1)
    }

    /// One holder more.
    pub fn hold(&mut self, id: GenomeId) {
        self.holders[id.0 as usize] += 1;
    }

    /// One holder less.
    pub fn release(&mut self, id: GenomeId) {
        let holders = &mut self.holders[id.0 as usize];
        *holders -= 1;
        if *holders == 0 {
            self.free.push(id.0);
        }
    }

    /// About how many bytes a copy takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let codons: usize = self.places.iter().map(|genome| genome.codons.len() * size_of::<u16>()).sum();
        codons + self.places.len() * (size_of::<Genome>() + 2 * size_of::<u32>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_genome_stays_until_its_last_holder_lets_go() {
        let [first, second] = [[1, 2].to_vec(), [3].to_vec()].map(|codons| Genome { codons, used: 1 });
        let mut genomes = Genomes::default();
        let kept = genomes.add(&first);
        genomes.hold(kept);
        genomes.release(kept);
        let other = genomes.add(&second);
        assert_eq!((genomes.get(kept), genomes.get(other)), (&first, &second));
        genomes.release(kept);
        let again = genomes.add(&second);
        assert_eq!((again, genomes.get(again)), (kept, &second), "its place is used again");
    }
}
