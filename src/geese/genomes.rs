//! The genomes of a swarm, each stored once, however many agents hold it.
//!
//! A meeting then notes a number. Copied at every meeting, the codons were most of what a crowd moved through memory, and
//! most copies were thrown away unread.

use super::ahead::call_for_all;
use crate::evolution::GenomeRef;

/// The number of a genome among the [`Genomes`] of a swarm; good as long as it is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GenomeId(u32);

/// Genomes with the number of their holders. One that nobody holds leaves its place to a later one.
#[derive(Clone, Debug)]
pub struct Genomes {
    /// Places of equal size one after the other, so that a genome's number says where its codons lie. In each the used
    /// count, the number of codons, and the codons.
    places: Vec<u16>,
    /// Size of a place.
    size: usize,
    holders: Vec<u32>,
    /// Places that nobody holds; the last one was in use most recently and is taken first, since it is near.
    free: Vec<u32>,
}

/// What stands in a place before the codons.
const HEAD: usize = 2;

impl Genomes {
    /// None yet.
    ///
    /// - `longest`: codons that most genomes will have at most; longer ones make every place larger.
    #[must_use]
    pub fn new(longest: u16) -> Self {
        Self { places: Vec::new(), size: HEAD + usize::from(longest), holders: Vec::new(), free: Vec::new() }
    }

    /// The genome of that number.
    #[must_use]
    pub fn get(&self, id: GenomeId) -> GenomeRef<'_> {
        let place = &self.places[id.0 as usize * self.size..][..self.size];
        GenomeRef { used: place[0], codons: &place[HEAD..][..usize::from(place[1])] }
    }

    /// Adds a copy of a genome, with one holder.
    ///
    /// - `genome`: of at most 65,535 codons; further ones are left out.
    pub fn add(&mut self, genome: GenomeRef) -> GenomeId {
        let count = u16::try_from(genome.codons.len()).unwrap_or(u16::MAX);
        let length = usize::from(count);
        if HEAD + length > self.size {
            self.widen(HEAD + length);
        }
        let number = self.free.pop().unwrap_or(self.holders.len() as u32);
        if number as usize == self.holders.len() {
            self.holders.push(0);
            self.places.resize(self.holders.len() * self.size, 0);
        }
        self.holders[number as usize] = 1;
        let place = &mut self.places[number as usize * self.size..][..HEAD + length];
        (place[0], place[1]) = (genome.used, count);
        place[HEAD..].copy_from_slice(&genome.codons[..length]);
        GenomeId(number)
    }

    fn widen(&mut self, size: usize) {
        let mut places = vec![0; self.holders.len() * size];
        for (new, old) in places.chunks_mut(size).zip(self.places.chunks(self.size)) {
            new[..old.len()].copy_from_slice(old);
        }
        (self.places, self.size) = (places, size);
    }

    /// Calls for a genome, see [`super::ahead`].
    pub fn call_for(&self, id: GenomeId) {
        call_for_all(&self.places[id.0 as usize * self.size..][..self.size]);
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
        self.places.len() * size_of::<u16>() + (self.holders.len() + self.free.len()) * size_of::<u32>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_genome_stays_until_its_last_holder_lets_go() {
        let first = GenomeRef { codons: &[1, 2], used: 1 };
        // Longer than was said: the places grow.
        let second = GenomeRef { codons: &[3, 4, 5, 6], used: 2 };
        let mut genomes = Genomes::new(2);
        let kept = genomes.add(first);
        genomes.hold(kept);
        genomes.release(kept);
        let other = genomes.add(second);
        assert_eq!((genomes.get(kept), genomes.get(other)), (first, second));
        genomes.release(kept);
        let again = genomes.add(second);
        assert_eq!((again, genomes.get(again), genomes.get(other)), (kept, second, second), "its place is used again");
    }

    #[test]
    fn a_genome_without_codons_is_one_too() {
        let mut genomes = Genomes::new(0);
        let none = genomes.add(GenomeRef { codons: &[], used: 0 });
        let longer = GenomeRef { codons: &[7; 300], used: 9 };
        let some = genomes.add(longer);
        assert_eq!((genomes.get(none).codons.len(), genomes.get(some)), (0, longer));
    }
}
