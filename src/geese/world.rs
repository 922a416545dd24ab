//! The world: a swarm that forages while every agent evolves its own program.

use super::ahead::reads_ahead;
use super::archive::Archive;
use super::body::{Actor, Body};
use super::breeding::Breeder;
use super::controller::{Controller, Planted};
use super::field::Field;
use super::genomes::{GenomeId, Genomes};
use super::mind::{Feedback, Mind, Offer, Program, Replaced, Storage};
use super::near::Near;
use super::outcome::{Finished, Outcome, Sample};
use super::params::{Activation, Params, PopulationForm, Task};
use super::population::{Deal, Dealt, Known, Population};
use super::program::{Compiler, Sentences};
use super::switches::{ExplorationRule, FitnessRule};
use super::visited::Visited;
use crate::bt::tick_instant;
use crate::evolution::Genome;
use crate::fingerprint::Fingerprint;
use crate::random::{Purpose, Seed, Stream, chance, stream};
use rand::RngExt;
use std::sync::Arc;

/// Steps between two samples of the history.
pub const SAMPLE_EVERY: u32 = 20;

/// A swarm in its arena.
#[derive(Clone, Debug)]
pub struct World {
    params: Params,
    seed: Seed,
    breeder: Breeder,
    near: Near,
    state: State,
}

/// Everything that changes from step to step: what a keyframe stores.
#[derive(Clone, Debug)]
pub struct State {
    pub(super) tick: u32,
    pub(super) field: Field,
    pub(super) bodies: Vec<Body>,
    pub(super) minds: Vec<Mind>,
    /// What each agent offers to those it meets.
    pub(super) offers: Vec<Offer>,
    pub(super) genomes: Genomes,
    pub(super) replaced: Replaced,
    /// Whether programs evolve.
    learning: bool,
    /// The programs of a fixed population that runs them in turns.
    turns: Arc<[Known]>,
    /// What was taken up so far; grows only when it will be asked for.
    pub(super) archive: Archive,
    activation: Stream,
    pub(super) order: Vec<u32>,
    /// Agents that have touched no trap.
    pub(super) alive: u32,
    /// Programs replaced in the last step.
    pub(super) swaps: u32,
    /// Programs replaced since the last sample.
    swaps_since_sample: u32,
    history: Vec<Sample>,
}

impl World {
    /// Places everything and gives every agent a random program.
    ///
    /// # Errors
    /// The field's name and what is wrong with it: parameters that do not fit together, or a grammar of which
    /// random genomes give no program.
    pub fn new(params: &Params, seed: Seed) -> Result<Self, (&'static str, String)> {
        let mut breeder = Breeder::new(params.check()?, params);
        let field = Field::new(params, seed)?;
        if params.learning_steps > 0 {
            // What the end of learning needs is tried now, when it can still be refused.
            Field::new(params, seed.of_restart(Purpose::Settlement))?;
            if params.population_form == PopulationForm::Blended
                && matches!(breeder.compiler.sentences(), Sentences::Machines(_))
            {
                let message = "expected another form: only behaviour trees can be blended, found state machines";
                return Err(("population-form", message.to_owned()));
            }
        }
        let agents = 0..params.agents;
        let (mut dealt, mut turns) = (Vec::new(), Vec::new());
        if !params.population.trim().is_empty() {
            let population = Population::read(&params.population).map_err(|message| ("population", message))?;
            let deal =
                population.deal(params, seed, &mut breeder.compiler).map_err(|message| ("population", message))?;
            (dealt, turns) = (deal.agents, deal.turns);
        }
        let (mut dealt, mut genomes) = (dealt.into_iter(), Genomes::new(params.genome_length));
        let born = agents
            .map(|id| {
                new_mind(&mut breeder, params, seed, id, dealt.next(), &mut genomes).ok_or_else(|| {
                    let message = "expected a grammar of which random genomes give programs, \
                                   found one that gave none in 100,000 draws (try a greater max-depth)";
                    ("grammar", message.to_owned())
                })
            })
            .collect::<Result<Vec<_>, _>>()?;
        let (minds, offers) = born.into_iter().unzip();
        let mut state = State {
            tick: 0,
            bodies: bodies(params, &field, seed),
            field,
            minds,
            offers,
            genomes,
            replaced: Replaced::default(),
            learning: params.evolution,
            turns: turns.into(),
            archive: Archive::new(seed),
            activation: stream(seed, Purpose::Activation, 0),
            order: (0..params.agents).collect(),
            alive: params.agents,
            swaps: 0,
            swaps_since_sample: 0,
            history: Vec::new(),
        };
        state.sample();
        Ok(Self { params: params.clone(), seed, breeder, near: Near::new(params.agents), state })
    }

    /// The parameters in force.
    #[must_use]
    pub fn params(&self) -> &Params {
        &self.params
    }

    /// Changes live parameters; `params` has passed [`Params::check`] and differs in no other ones.
    pub fn tune(&mut self, params: &Params) {
        self.params.clone_from(params);
        self.breeder.tune(params);
    }

    /// The compiler of this world's grammar.
    pub fn compiler(&mut self) -> &mut Compiler {
        &mut self.breeder.compiler
    }

    /// Everything that changes.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Goes back, or forward, to a state of this world.
    pub fn restore(&mut self, state: &State) {
        self.state.clone_from(state);
    }

    /// Whether the swarm still learns what will be tested later: nothing that it delivers now counts.
    #[must_use]
    pub fn awaits_test(&self) -> bool {
        self.params.learning_steps > 0 && self.state.learning
    }

    /// How the run stands.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        let (delivered, items) = (self.state.field.delivered(), self.params.item_count());
        let share = f64::from(delivered) / f64::from(items);
        let finished = if delivered + self.state.field.lost() == items && !self.awaits_test() {
            Some(match self.params.task {
                Task::Forage => Finished::AllDelivered,
                Task::Nest => Finished::AllRemoved,
            })
        } else if self.state.alive == 0 {
            Some(Finished::AllDead)
        } else {
            (self.state.tick >= self.params.steps).then_some(Finished::TickLimit)
        };
        Outcome { delivered, items, share, success: share > self.params.success_threshold, finished }
    }

    /// One step: every agent, in an order shuffled anew, ticks its program, meets its neighbours and may breed.
    /// Does nothing when the run has ended.
    ///
    /// Source: BeTr-GEESE, section 4.1. The paper calls the updates independent; the shuffle is our choice.
    pub fn step(&mut self) {
        if self.outcome().finished.is_some() {
            return;
        }
        if self.awaits_test() && self.state.tick >= self.params.learning_steps {
            self.settle();
        }
        let Self { params, breeder, near, state, .. } = self;
        state.tick += 1;
        state.swaps = 0;
        state.replaced.clear();
        let in_turns = !state.learning && !state.turns.is_empty();
        match params.activation {
            Activation::Index => state.order.sort_unstable(),
            Activation::Shuffled => {
                for last in (1..state.order.len() as u32).rev() {
                    let other = state.activation.random_range(0..=last);
                    state.order.swap(last as usize, other as usize);
                }
            }
        }
        let reads_ahead = reads_ahead(state.order.len());
        for turn in 0..state.order.len() {
            let agent = state.order[turn];
            if reads_ahead {
                state.read_ahead(turn, params.sense_radius);
            }
            if !state.bodies[agent as usize].alive {
                continue;
            }
            if in_turns {
                state.turn_to_another(params, breeder, agent);
            }
            state.tick_program(params, agent);
            if !state.bodies[agent as usize].alive {
                state.alive -= 1;
            } else if state.learning {
                state.meet(params, breeder, near, agent);
            }
        }
        state.swaps_since_sample += state.swaps;
        if state.tick.is_multiple_of(SAMPLE_EVERY) {
            state.sample();
        }
    }

    /// Ends the learning: the programs become a fixed population, and the task starts afresh, with new places.
    ///
    /// Source: BeTr-GEESE, section 5; the places are new, so that nothing but the programs is kept (our choice).
    fn settle(&mut self) {
        let Self { params, seed, breeder, state, .. } = self;
        state.learning = false;
        let seed = seed.of_restart(Purpose::Settlement);
        let archived =
            if params.population_form == PopulationForm::Archive { state.archive.population() } else { None };
        let population = archived.unwrap_or_else(|| Population::of_state(state));
        let (Ok(field), Ok(Deal { agents: dealt, turns })) =
            (Field::new(params, seed), population.deal(params, seed, &mut breeder.compiler))
        else {
            debug_assert!(false, "both were tried when the world was built, and its own genomes are valid");
            return;
        };
        state.turns = turns.into();
        (state.bodies, state.alive) = (bodies(params, &field, seed), params.agents);
        state.field = field;
        for (id, dealt) in (0..).zip(dealt) {
            let formerly = &mut state.minds[id as usize];
            if let Some((mind, offer)) = new_mind(breeder, params, seed, id, Some(dealt), &mut state.genomes) {
                formerly.storage.clear(&mut state.genomes);
                *formerly = Mind { since: state.tick, ..mind };
                let former = std::mem::replace(&mut state.offers[id as usize], offer);
                state.genomes.release(former.genome);
            }
        }
    }

    /// The fingerprint of the whole state.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fingerprint::default();
        let state = &self.state;
        hash.u32(state.tick);
        hash.stream(&state.activation);
        state.order.iter().for_each(|&agent| hash.u32(agent));
        state.field.feed(&mut hash);
        state.archive.feed(&mut hash);
        for (id, (body, mind)) in state.bodies.iter().zip(&state.minds).enumerate() {
            state.field.agents.point(id as u32).iter().for_each(|&value| hash.f64(value));
            body.feed(&mut hash);
            mind.feed(&state.offers[id], &state.genomes, &mut hash);
        }
        hash.finish()
    }
}

fn bodies(params: &Params, field: &Field, seed: Seed) -> Vec<Body> {
    (0..params.agents).map(|id| Body::new(params, field, stream(seed, Purpose::Walk, id))).collect()
}

/// A mind with a random program, or with one of a saved population.
fn new_mind(
    breeder: &mut Breeder,
    params: &Params,
    seed: Seed,
    id: u32,
    dealt: Option<Dealt>,
    genomes: &mut Genomes,
) -> Option<(Mind, Offer)> {
    let [mut genesis, evolution, luck] =
        [Purpose::Genesis, Purpose::Evolution, Purpose::Luck].map(|purpose| stream(seed, purpose, id));
    let mut genome = Genome::default();
    let mut program = Program::default();
    let survey = if let Some(dealt) = dealt {
        genome.codons = dealt.codons;
        program.controller = dealt.controller;
        breeder.compiler.survey(&mut genome, None)?
    } else {
        let survey = breeder.genesis(params, &mut genesis, &mut genome)?;
        breeder.compiler.compile(&genome.codons, &mut program.controller).ok()?;
        survey
    };
    program.renew();
    let offer = Offer { genome: genomes.add(genome.view()), swaps: 0, diversity: survey.diversity, fitness: 0.0 };
    let mind = Mind {
        program,
        replaced: 0,
        since: 0,
        last: [0.0; 2],
        feedback: 0,
        task: 0,
        visited: Visited::new(params.arena_size),
        storage: Storage::default(),
        evolution,
        luck,
    };
    Some((mind, offer))
}

impl State {
    /// Steps made so far.
    #[must_use]
    pub fn tick(&self) -> u32 {
        self.tick
    }

    /// The samples so far: the first of tick 0, then one every [`SAMPLE_EVERY`] steps.
    #[must_use]
    pub fn history(&self) -> &[Sample] {
        &self.history
    }

    /// Ticks the agent's program once and updates its fitness: `A = beta A + D + E + B`, or the sum of the fitness types
    /// that the scenario chooses.
    ///
    /// Source: BeTr-GEESE, section 4.6, "Blending Fitness Types". E counts the distinct unit squares visited since the
    /// program was taken up (our reading of "unique world locations"); prospective fitness counts the item carried (the
    /// paper gives no formula); task fitness counts the items that the whole swarm has brought where they belong. The
    /// authors' code adds a tenth of the last fitness of the program before, in place of the sum so far.
    fn tick_program(&mut self, params: &Params, agent: u32) {
        let (mind, offer) = (&mut self.minds[agent as usize], &mut self.offers[agent as usize]);
        let mut actor = Actor::new(params, &mut self.field, &mut self.bodies[agent as usize], agent);
        mind.feedback = match &mut mind.program.controller {
            Controller::Tree(Planted { tree, trace }) => {
                let mut feedback = Feedback::new(tree, trace, self.tick, params.bt_feedback);
                let ticked = tick_instant(tree, |leaf| actor.act(*leaf), &mut feedback);
                debug_assert!(ticked.is_ok(), "evolved trees have no node that needs a memory");
                feedback.sum
            }
            // A machine has no nodes whose statuses could count.
            Controller::Machine(machine) => {
                machine.step(|leaf| actor.act(leaf), &mut mind.luck, self.tick);
                0
            }
        };
        mind.task = self.field.delivered();
        let point = self.field.agents.point(agent);
        match params.exploration {
            ExplorationRule::Squares => mind.visited.mark(point),
            ExplorationRule::Cells => mind.visited.mark_square(self.field.lattice.number(point)),
        }
        let carrying = self.bodies[agent as usize].load.is_some();
        let types = [
            (params.fitness_diversity, offer.diversity),
            (params.fitness_exploration, f64::from(mind.exploration(params.exploration))),
            (params.fitness_feedback, f64::from(mind.feedback)),
            (params.fitness_prospective, f64::from(u8::from(carrying))),
            (params.fitness_task, f64::from(mind.task)),
        ];
        let sum: f64 = types.iter().map(|(counts, value)| if *counts { *value } else { 0.0 }).sum();
        let remembered = match params.fitness {
            FitnessRule::Recurrence => offer.fitness,
            FitnessRule::Delayed => mind.last[0],
        };
        offer.fitness = params.fitness_memory * remembered + sum;
    }

    /// Gives the agent another program of the fixed population, once in a while.
    fn turn_to_another(&mut self, params: &Params, breeder: &mut Breeder, agent: u32) {
        let mind = &mut self.minds[agent as usize];
        if chance(&mut mind.evolution, 1.0 / params.dwell) {
            let Known { genome, diversity } =
                &self.turns[mind.evolution.random_range(0..self.turns.len() as u32) as usize];
            let (genome, diversity) = (self.genomes.add(genome.view()), *diversity);
            // As if at the end of the step before: it is ticked in this one.
            self.take_up(&mut breeder.compiler, agent, genome, diversity, self.tick - 1);
        }
    }

    /// Makes a genome the agent's, and from the next step on its program.
    ///
    /// - `genome`: from now on held by the agent.
    pub(super) fn take_up(&mut self, compiler: &mut Compiler, agent: u32, genome: GenomeId, diversity: f64, tick: u32) {
        self.swaps += 1;
        let (mind, offer) = (&mut self.minds[agent as usize], &mut self.offers[agent as usize]);
        self.genomes.release(offer.genome);
        *offer = Offer { genome, swaps: offer.swaps + 1, diversity, fitness: 0.0 };
        mind.visited.clear();
        mind.since = tick;
        let (place, program) = self.replaced.take();
        mind.replaced = place;
        std::mem::swap(&mut mind.program, program);
        let valid = compiler.compile(self.genomes.get(genome).codons, &mut mind.program.controller);
        debug_assert!(valid.is_ok(), "the survey found the genome valid");
        mind.program.renew();
        self.call_for_replaced();
    }

    /// The program that the agent ran in the last step.
    #[must_use]
    pub fn ran(&self, agent: u32) -> &Program {
        let mind = &self.minds[agent as usize];
        if mind.was_replaced(self.tick) { self.replaced.get(mind.replaced) } else { &mind.program }
    }

    /// Each agent with the id of the program it ran in the last step, agents of one program side by side.
    #[must_use]
    pub fn by_program(&self) -> Vec<(u64, u32)> {
        let ran = (0..self.minds.len() as u32).map(|agent| (self.ran(agent).id, agent));
        let mut ran: Vec<(u64, u32)> = ran.collect();
        ran.sort_unstable();
        ran
    }

    /// How many distinct programs were ticked in the last step.
    #[must_use]
    pub fn program_count(&self) -> u32 {
        self.by_program().chunk_by(|a, b| a.0 == b.0).count() as u32
    }

    fn sample(&mut self) {
        let sample = Sample {
            delivered: self.field.delivered(),
            carrying: self.field.carried(),
            programs: self.program_count(),
            swaps: std::mem::take(&mut self.swaps_since_sample),
        };
        self.history.push(sample);
    }

    /// About how many bytes a copy takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let mind = |mind: &Mind| {
            let program = mind.program.controller.bytes();
            size_of::<Mind>() + size_of::<Body>() + mind.visited.bytes() + mind.storage.bytes() + program + 256
        };
        self.minds.iter().map(mind).sum::<usize>()
            + self.offers.len() * size_of::<Offer>()
            + self.genomes.bytes()
            + self.replaced.bytes()
            + self.archive.bytes()
            + self.history.len() * size_of::<Sample>()
            + 8192
    }
}
