//! Elite and children from among which a tournament takes an agent's next program.

use crate::evolution::{Genome, GenomeRef, tournament};
use crate::random::Stream;

/// Genomes with what they are worth. Emptied ones keep their memory for later ones.
#[derive(Clone, Debug, Default)]
pub struct Brood {
    genomes: Vec<Genome>,
    diversity: Vec<f64>,
    /// Its length is the number of genomes in use.
    fitness: Vec<f64>,
}

impl Brood {
    /// Empties the brood.
    pub fn clear(&mut self) {
        self.diversity.clear();
        self.fitness.clear();
    }

    /// Adds a copy of a genome.
    pub fn add(&mut self, genome: GenomeRef, diversity: f64, fitness: f64) {
        let place = self.fitness.len();
        if place == self.genomes.len() {
            self.genomes.push(Genome::default());
        }
        self.genomes[place].copy_from(genome);
        self.diversity.push(diversity);
        self.fitness.push(fitness);
    }

    /// Draws `size` genomes with replacement and puts the fittest, of equal ones the first drawn, into `winner`; returns
    /// its diversity, or `None` when there is nothing to draw from.
    pub fn winner(&self, rng: &mut Stream, size: u32, winner: &mut Genome) -> Option<f64> {
        if self.fitness.is_empty() {
            return None;
        }
        let at = tournament(rng, &self.fitness, size);
        winner.clone_from(&self.genomes[at]);
        Some(self.diversity[at])
    }
}
