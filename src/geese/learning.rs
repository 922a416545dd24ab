//! Learning together: an agent collects the genomes of those it meets, and breeds when it has enough of them.

use super::breeding::{Best, Breeder, Source, Winner};
use super::grid::Area;
use super::near::Near;
use super::params::{Params, PopulationForm, StorageContent, SwapRule};
use super::switches::{FitnessRule, Neighbours, Sensing, StorageValue};
use super::world::State;
use crate::evolution::Genome;
use crate::random::chance;

impl State {
    /// Sense, act and update: takes copies of the neighbours' genomes, and breeds when it has enough of them.
    ///
    /// Source: BeTr-GEESE, section 3. Our choices: neighbours are the agents within the sensing radius, and a stored
    /// genome keeps the fitness it had when it was taken. In the authors' code an agent meets its cell mates and itself,
    /// two at least, stored fitness is live, and one that gets nowhere breeds with ten random genomes.
    pub(super) fn meet(&mut self, params: &Params, breeder: &mut Breeder, near: &mut Near, agent: u32) {
        // In every turn, also alone: what donors had two programs ago is nowhere to be found.
        if params.storage_value == StorageValue::Live {
            let mut storage = std::mem::take(&mut self.minds[agent as usize].storage);
            storage.refresh(&self.offers, &self.minds);
            self.minds[agent as usize].storage = storage;
        }
        let place = self.field.agents.point(agent);
        near.clear();
        let area = match params.neighbours {
            Neighbours::Radius => Area::Disc(params.sense_radius),
            Neighbours::Cell => self.field.area(Sensing::Cell, place, 0.0),
        };
        self.field.agents.near(place, area, |other, _| near.add(other));
        if params.neighbours == Neighbours::Radius {
            near.remove(agent);
        }
        if near.is_empty() && params.stagnation == 0 {
            return;
        }
        let mind = &mut self.minds[agent as usize];
        near.retain(|_| chance(&mut mind.evolution, params.interaction_probability));
        if params.neighbours == Neighbours::Cell && near.ids().len() < 2 {
            near.clear();
        }
        let again = params.storage_content == StorageContent::Meetings;
        let entries = mind.storage.entries();
        let replaced = entries.iter().filter(|entry| !again && near.contains(entry.donor)).count();
        let stored = entries.len() + near.ids().len() - replaced;
        let is_full = stored > params.storage_threshold as usize;
        let is_stuck = params.stagnation > 0
            && self.tick - mind.since > params.stagnation
            && mind.exploration(params.exploration) < 2;
        if is_full || is_stuck {
            self.evolve(params, breeder, near, agent, !is_full);
            return;
        }
        let live = params.storage_value == StorageValue::Live;
        for &donor in near.ids() {
            mind.storage.store(donor, &self.offers[donor as usize], &mut self.genomes, again, live);
        }
    }

    /// Breeds from the storage and those just met, and takes up the best child if the swap rule lets it.
    ///
    /// - `stuck`: whether it breeds with random genomes too.
    fn evolve(&mut self, params: &Params, breeder: &mut Breeder, met: &Near, agent: u32, stuck: bool) {
        let mut storage = std::mem::take(&mut self.minds[agent as usize].storage);
        let mut rng = self.minds[agent as usize].evolution.clone();
        let again = params.storage_content == StorageContent::Meetings;
        let entries = storage.entries();
        breeder.pool.clear();
        breeder.pool.extend(entries.iter().enumerate().map(|(at, entry)| {
            if !again && met.contains(entry.donor) { Source::Met(entry.donor) } else { Source::Stored(at as u32) }
        }));
        let is_stored = |donor: u32| !again && entries.iter().any(|entry| entry.donor == donor);
        breeder.pool.extend(met.ids().iter().filter(|&&donor| !is_stored(donor)).map(|&donor| Source::Met(donor)));
        if stuck {
            let mut genome = Genome::default();
            for _ in 0..10 {
                if let Some(survey) = breeder.genesis(params, &mut rng, &mut genome) {
                    breeder.pool.push(Source::Stored(storage.entries().len() as u32));
                    storage.add_fresh(agent, survey.diversity, self.genomes.add(genome.view()));
                }
            }
        }
        let own = self.offers[agent as usize];
        let best = breeder.breed(params, &mut rng, &own, storage.entries(), &self.offers, &self.genomes);
        let winner = best.filter(|best| match params.swap_rule {
            SwapRule::Greater => best.diversity > own.diversity,
            SwapRule::NotSmaller => best.diversity >= own.diversity,
            SwapRule::Always => true,
        });
        if let Some(Best { genome: Winner::Elite(id), .. }) = winner {
            self.genomes.hold(id);
        }
        storage.clear(&mut self.genomes);
        if let Some(Best { genome, diversity }) = winner {
            let genome = match genome {
                Winner::Elite(id) => id,
                Winner::Bred(genome) => self.genomes.add(genome.view()),
            };
            if params.learning_steps > 0 && params.population_form == PopulationForm::Archive {
                self.archive.add(self.genomes.get(genome));
            }
            if params.fitness == FitnessRule::Delayed || params.storage_value == StorageValue::Live {
                let mind = &mut self.minds[agent as usize];
                mind.last = [own.fitness, mind.last[0]];
            }
            self.take_up(&mut breeder.compiler, agent, genome, diversity, self.tick);
        }
        let mind = &mut self.minds[agent as usize];
        mind.storage = storage;
        mind.evolution = rng;
    }
}
