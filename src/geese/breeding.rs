//! The act phase: parents from the pool, children by crossover and mutation, the most diverse child.

use super::ahead::reads_ahead;
use super::brood::Brood;
use super::genomes::{GenomeId, Genomes};
use super::mind::{Entry, Offer};
use super::params::{CrossoverMode, GenomeSelection, MutationMode, Params, ParentSelection};
use super::program::{Compiler, Survey};
use super::switches::{EliteRank, Init, LengthRule};
use crate::evolution::{
    Genome, Mutation, RuleId, exchange_tails, fittest, fixed_cuts, grow, tournament, variable_cuts,
};
use crate::random::{Stream, chance};
use rand::RngExt;

/// Where a genome of the pool lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// In the agent's storage, by place.
    Stored(u32),
    /// With its owner, met in this very step.
    Met(u32),
}

/// Breeds children; holds the compiler and all memory that breeding needs.
#[derive(Clone, Debug)]
pub struct Breeder {
    /// Turns genomes into programs.
    pub compiler: Compiler,
    mutation: Mutation,
    /// The genomes to choose from, by source.
    pub pool: Vec<Source>,
    fitness: Vec<f64>,
    sorted: Vec<f64>,
    parents: Vec<u32>,
    children: [Genome; 2],
    best: Genome,
    brood: Brood,
    growing: Vec<(RuleId, u32)>,
}

/// The genome that was chosen.
#[derive(Clone, Copy, Debug)]
pub enum Winner<'a> {
    /// A genome of the pool.
    Elite(GenomeId),
    /// A new one.
    Bred(&'a Genome),
}

/// What breeding chose.
#[derive(Clone, Debug)]
pub struct Best<'a> {
    /// Its genome, mapped.
    pub genome: Winner<'a>,
    /// Its diversity.
    pub diversity: f64,
}

impl Breeder {
    /// Takes a compiler; the operators follow `params`.
    #[must_use]
    pub fn new(compiler: Compiler, params: &Params) -> Self {
        Self {
            compiler,
            mutation: mutation(params),
            pool: Vec::new(),
            fitness: Vec::new(),
            sorted: Vec::new(),
            parents: Vec::new(),
            children: [Genome::default(), Genome::default()],
            best: Genome::default(),
            brood: Brood::default(),
            growing: Vec::new(),
        }
    }

    /// Follows a change of live parameters.
    pub fn tune(&mut self, params: &Params) {
        self.mutation = mutation(params);
    }

    /// Draws genomes until one maps to a program. Of the authors' code, which makes three and takes the first, one.
    ///
    /// Returns `None` when 100,000 draws gave none.
    pub fn genesis(&mut self, params: &Params, rng: &mut Stream, genome: &mut Genome) -> Option<Survey> {
        let Self { compiler, growing, .. } = self;
        (0..100_000).find_map(|_| {
            match params.init {
                Init::RandomBits => genome.randomise(rng, params.genome_length, params.codon_max),
                Init::DerivationTree => {
                    let limits = [compiler.limits().max_depth, u32::from(params.genome_length)];
                    if !grow(compiler.grammar(), rng, limits, params.codon_max, genome, growing) {
                        return None;
                    }
                }
            }
            compiler.survey(genome, None)
        })
    }

    /// Breeds from the pool and the agent's own genome; returns the most diverse of elite and children, the first of
    /// equal ones, or `None` when there is no elite and every child maps to nothing. Children that map to nothing count:
    /// whether one drops them or ranks them last, as the authors' code does, makes no difference. With tournament selection
    /// it returns the winner of a tournament by fitness: a child has not run yet, so it is given the mean of its parents'
    /// (our choice: what is untried is neither favoured nor barred).
    ///
    /// - `own`: what the agent itself has; it stands last in the pool, unless it stays out of it.
    /// - `stored`: the agent's storage, to which the pool's [`Source::Stored`] points.
    /// - `offers`: what all agents have, to which [`Source::Met`] points.
    /// - `genomes`: holds all of their genomes.
    ///
    /// Source: BeTr-GEESE, sections 3 and 4.1, Table 1. The share of parents and the number of children are our choice.
    pub fn breed(
        &mut self,
        params: &Params,
        rng: &mut Stream,
        own: &Offer,
        stored: &[Entry],
        offers: &[Offer],
        genomes: &Genomes,
    ) -> Option<Best<'_>> {
        if params.genome_selection == GenomeSelection::Fresh {
            let mut genome = std::mem::take(&mut self.best);
            let survey = self.genesis(params, rng, &mut genome);
            self.best = genome;
            return survey.map(|survey| Best { genome: Winner::Bred(&self.best), diversity: survey.diversity });
        }
        let Self { compiler, mutation, pool, fitness, sorted, parents, children, best, brood, .. } = self;
        let of = |source: &Source| match *source {
            Source::Stored(at) => stored[at as usize].offer,
            Source::Met(agent) => offers[agent as usize],
        };
        let offer = |index: u32| pool.get(index as usize).map_or(*own, of);
        let genome_of = |index: u32| genomes.get(offer(index).genome);
        let diversity_of = |index: u32| offer(index).diversity;
        fitness.clear();
        fitness.extend(pool.iter().map(|source| of(source).fitness));
        if params.own_in_pool {
            fitness.push(own.fitness);
        }

        if fitness.is_empty() {
            return None;
        }
        // The elite is kept by fitness and stands before the children, so it wins where they are no better. The authors'
        // code compares its fitness with the children's diversity.
        let (mut found, mut kept): (Option<f64>, Option<GenomeId>) = (None, None);
        let by_fitness = params.genome_selection == GenomeSelection::Tournament;
        brood.clear();
        let mut diversity = 0.0;
        fittest(fitness, params.elite_size as usize, sorted, parents);
        for &elite in parents.iter() {
            let rank = match params.elite_rank {
                EliteRank::Diversity => diversity_of(elite),
                EliteRank::Fitness => fitness[elite as usize],
            };
            if by_fitness {
                brood.add(genome_of(elite), diversity_of(elite), fitness[elite as usize]);
            } else if found.is_none_or(|best| rank > best) {
                (found, kept, diversity) = (Some(rank), Some(offer(elite).genome), diversity_of(elite));
            }
        }

        fittest(fitness, parent_count(fitness.len(), params.parent_share), sorted, parents);
        if reads_ahead(offers.len()) {
            for &parent in &*parents {
                genomes.call_for(offer(parent).genome);
            }
        }
        let greatest = compiler.greatest_diversity();
        // No later child can be better than the greatest, and the first of equal ones is taken: the rest need no look.
        let is_decided = |found: Option<f64>| match params.genome_selection {
            GenomeSelection::Diversity => found.is_some_and(|best| best >= greatest),
            GenomeSelection::Random | GenomeSelection::Fresh => found.is_some(),
            GenomeSelection::Tournament => false,
        };
        let (mut bred, mut dropped) = (0, 0);
        while bred < params.children && !is_decided(found) {
            let pair = match params.parent_selection {
                ParentSelection::Truncation => {
                    two_different(rng, parents.len() as u32).map(|place| parents[place as usize])
                }
                ParentSelection::Tournament => tournament_pair(rng, fitness, params.tournament_size),
            };
            let [a, b] = pair.map(genome_of);
            let inherited = pair.iter().map(|&parent| fitness[parent as usize]).sum::<f64>() / 2.0;
            let [first, second] = &mut *children;
            if chance(rng, params.crossover_probability) {
                let cuts = match params.crossover_mode {
                    CrossoverMode::VariableOnePoint => variable_cuts(rng, [a, b]),
                    CrossoverMode::FixedOnePoint => fixed_cuts(rng, [a, b]),
                };
                if params.length_rule == LengthRule::Redraw && dropped < MOST_DROPPED {
                    let [head, tail] = [a, b].map(|parent| parent.codons.len());
                    let lengths = [cuts[0] + tail.saturating_sub(cuts[1]), cuts[1] + head.saturating_sub(cuts[0])];
                    if lengths.iter().any(|&length| length > usize::from(params.genome_length)) {
                        dropped += 1;
                        continue;
                    }
                }
                exchange_tails([a, b], cuts, params.genome_length, [&mut *first, &mut *second]);
            } else {
                first.copy_from(a);
                second.copy_from(b);
            }
            for child in [first, second].into_iter().take((params.children - bred) as usize) {
                bred += 1;
                let Some(survey) = compiler.survey(child, Some(mutation.begin(rng))) else { continue };
                if by_fitness {
                    brood.add(child.view(), survey.diversity, inherited);
                } else if found.is_none_or(|best| survey.diversity > best) {
                    (found, kept, diversity) = (Some(survey.diversity), None, survey.diversity);
                    std::mem::swap(best, child);
                }
                if is_decided(found) {
                    break;
                }
            }
        }
        if by_fitness {
            let diversity = brood.winner(rng, params.tournament_size, best)?;
            return Some(Best { genome: Winner::Bred(best), diversity });
        }
        found.map(|_| Best { genome: kept.map_or(Winner::Bred(best), Winner::Elite), diversity })
    }
}

/// So many pairs may be dropped in one brood for their length; the rest is cut. Two genomes of full length have fitting
/// children only when they are cut at the same place, which takes as many draws as they have used codons.
const MOST_DROPPED: u32 = 100_000;

/// How many of a pool become parents: the share, rounded down, but two at least.
fn parent_count(pool: usize, share: f64) -> usize {
    ((pool as f64 * share) as usize).max(2)
}

fn mutation(params: &Params) -> Mutation {
    match params.mutation_mode {
        MutationMode::Bit => Mutation::of_bits(params.mutation_probability, params.codon_max),
        MutationMode::Codon => Mutation::of_codons(params.mutation_probability, params.codon_max),
    }
}

/// Two different numbers below `count`, each pair equally likely; the same number twice when `count` is 1.
fn two_different(rng: &mut Stream, count: u32) -> [u32; 2] {
    let first = rng.random_range(0..count);
    if count == 1 {
        return [first, first];
    }
    let second = rng.random_range(0..count - 1);
    [first, second + u32::from(second >= first)]
}

/// Two tournament winners; drawn again a few times when they are the same, since a genome crossed with itself
/// gives nothing new.
fn tournament_pair(rng: &mut Stream, fitness: &[f64], size: u32) -> [u32; 2] {
    let first = tournament(rng, fitness, size) as u32;
    let mut second = first;
    for _ in 0..8 {
        second = tournament(rng, fitness, size) as u32;
        if second != first {
            break;
        }
    }
    [first, second]
}
