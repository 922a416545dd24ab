//! An agent's controller and all that evolution needs of it: genome, program, fitness and stored genomes.

use super::controller::{Controller, Planted};
use super::leaf::{Leaf, Tag};
use super::program::Compiler;
use super::switches::{ExplorationRule, FeedbackRule};
use super::visited::Visited;
use crate::bt::{Kind, NodeId, Recorder, Status, Tree};
use crate::evolution::Genome;
use crate::fingerprint::Fingerprint;
use crate::random::Stream;

/// What a node of the program last returned, and in which step (0: never).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// The status.
    pub status: Status,
    /// The step.
    pub tick: u32,
}

/// A controller with its name.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The tree or the machine.
    pub controller: Controller,
    /// Equal for equal ones.
    pub id: u64,
}

impl Program {
    /// Makes a controller that was just built ready for its first step.
    pub fn renew(&mut self) {
        self.controller.renew();
        self.id = self.controller.id();
    }
}

/// The controller of one agent.
#[derive(Clone, Debug)]
pub struct Mind {
    /// The genome of the program.
    pub genome: Genome,
    /// The program that will be ticked next.
    pub program: Program,
    /// The program before it; shown when it was replaced in the last step.
    pub replaced: Program,
    /// The step in which the program was taken up; 0 at the start.
    pub since: u32,
    /// How many times the program was replaced.
    pub swaps: u32,
    /// Diversity D of the program.
    pub diversity: f64,
    /// Run-time fitness A.
    pub fitness: f64,
    /// The last fitness of the program before, and of the one before it; 0 unless something asks for them.
    pub last: [f64; 2],
    /// Feedback B of the last step.
    pub feedback: i32,
    /// Items delivered by the whole swarm when the program was ticked last.
    pub task: u32,
    /// Squares visited since the program was taken up; their number is exploration E.
    pub visited: Visited,
    /// Genomes of other agents.
    pub storage: Storage,
    /// The agent's own stream for exchange and breeding.
    pub evolution: Stream,
    /// The agent's own stream for what its machine does with a probability.
    pub luck: Stream,
}

impl Mind {
    /// Makes the genome, which the agent has just been given, its program from the next step on.
    pub fn take_up(&mut self, compiler: &mut Compiler, tick: u32) {
        self.fitness = 0.0;
        self.visited.clear();
        self.since = tick;
        self.swaps += 1;
        std::mem::swap(&mut self.program, &mut self.replaced);
        let valid = compiler.compile(&self.genome.codons, &mut self.program.controller);
        debug_assert!(valid.is_ok(), "the survey found the genome valid");
        self.program.renew();
    }

    /// The program that was ticked in step `tick`.
    #[must_use]
    pub fn ran(&self, tick: u32) -> &Program {
        if self.was_replaced(tick) { &self.replaced } else { &self.program }
    }

    /// Exploration E, by what the scenario counts: all that was visited, or (cells) all but one.
    #[must_use]
    pub fn exploration(&self, rule: ExplorationRule) -> u32 {
        let visited = self.visited.count() as u32;
        match rule {
            ExplorationRule::Squares => visited,
            ExplorationRule::Cells => visited.saturating_sub(1),
        }
    }

    /// Whether the program was replaced in step `tick`, after it was ticked.
    #[must_use]
    pub fn was_replaced(&self, tick: u32) -> bool {
        tick > 0 && self.since == tick
    }

    /// Reads something of each part of the mind, to no end but that it is near when it is needed.
    #[must_use]
    pub fn draw_near(&self) -> u64 {
        let first = self.visited.squares().first().map_or(0, |&square| u64::from(square));
        let lengths = (self.genome.codons.len() ^ self.storage.filled) as u64;
        self.program.id ^ self.diversity.to_bits() ^ self.last[1].to_bits() ^ first ^ lengths
    }

    /// As [`Mind::draw_near`], of what the mind points to.
    #[must_use]
    pub fn draw_nearer(&self) -> u32 {
        let stored = self.storage.entries.get(self.storage.filled).map_or(0, |entry| entry.donor);
        let Controller::Tree(Planted { tree, memory, trace }) = &self.program.controller else { return stored };
        let last = tree.nodes().len() - 1;
        [0, last].iter().fold(stored, |all, &at| {
            all ^ tree.nodes()[at].end ^ memory.status(NodeId(at as u32)) as u32 ^ trace[at].tick
        })
    }

    /// Feeds everything that decides what the agent does next.
    pub fn feed(&self, hash: &mut Fingerprint) {
        self.genome.feed(hash);
        hash.u64(self.program.id);
        hash.u32(self.since);
        hash.u32(self.swaps);
        hash.f64(self.diversity);
        hash.f64(self.fitness);
        if self.last.iter().any(|fitness| fitness.abs() > 0.0) {
            self.last.iter().for_each(|&fitness| hash.f64(fitness));
        }
        self.visited.squares().iter().for_each(|&square| hash.u32(square));
        for entry in self.storage.entries() {
            hash.u64(u64::from(entry.donor) | u64::from(entry.program) << 32);
            hash.f64(entry.fitness);
            hash.f64(entry.diversity);
            entry.genome.feed(hash);
        }
        hash.stream(&self.evolution);
        if let Controller::Machine(machine) = &self.program.controller {
            machine.feed(hash);
            hash.stream(&self.luck);
        }
    }
}

/// A copy of another agent's genome, with what it was worth when it was taken.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Whose genome it is.
    pub donor: u32,
    /// Which of the donor's programs it was, from 1 on, when its fitness is to be followed; otherwise 0.
    pub program: u32,
    /// Run-time fitness A of the donor.
    pub fitness: f64,
    /// Diversity D of the donor.
    pub diversity: f64,
    /// The genome.
    pub genome: Genome,
}

/// The genomes an agent has collected: at most one of each donor, in the order of first arrival.
///
/// Emptied entries keep their memory for later ones.
#[derive(Clone, Debug, Default)]
pub struct Storage {
    entries: Vec<Entry>,
    filled: usize,
}

impl Storage {
    /// What is stored.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries[..self.filled]
    }

    /// Stores a copy in place of the donor's older one, or (`again`) besides it.
    ///
    /// - `live`: whether [`Storage::refresh`] is to follow its fitness.
    pub fn store(&mut self, donor: u32, mind: &Mind, again: bool, live: bool) {
        let older = self.entries().iter().position(|entry| !again && entry.donor == donor);
        let program = if live { mind.swaps + 1 } else { 0 };
        self.put(older.unwrap_or(self.filled), [donor, program], [mind.fitness, mind.diversity], &mind.genome);
    }

    /// Adds a genome that is nobody's program, worth its diversity.
    ///
    /// - `donor`: who drew it.
    pub fn add_fresh(&mut self, donor: u32, diversity: f64, genome: &Genome) {
        self.put(self.filled, [donor, 0], [diversity; 2], genome);
    }

    fn put(&mut self, at: usize, [donor, program]: [u32; 2], [fitness, diversity]: [f64; 2], genome: &Genome) {
        self.filled = self.filled.max(at + 1);
        if let Some(entry) = self.entries.get_mut(at) {
            (entry.donor, entry.program, entry.fitness, entry.diversity) = (donor, program, fitness, diversity);
            entry.genome.clone_from(genome);
        } else {
            self.entries.push(Entry { donor, program, fitness, diversity, genome: genome.clone() });
        }
    }

    /// Brings the fitness of followed entries up to date: that of the donor while it runs the program, then its last.
    ///
    /// Called once in each turn of the owner; until the next, a donor replaces its program twice at most.
    pub fn refresh(&mut self, minds: &[Mind]) {
        for entry in self.entries[..self.filled].iter_mut().filter(|entry| entry.program > 0) {
            let donor = &minds[entry.donor as usize];
            match donor.swaps + 1 - entry.program {
                0 => entry.fitness = donor.fitness,
                1 => entry.fitness = donor.last[0],
                2 => entry.fitness = donor.last[1],
                _ => {}
            }
        }
    }

    /// Empties the storage.
    pub fn clear(&mut self) {
        self.filled = 0;
    }

    /// Bytes on the heap.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.entries.iter().map(|entry| size_of::<Entry>() + entry.genome.codons.capacity() * 2).sum()
    }
}

/// Sums the feedback fitness of one tick and notes each node's status for display.
///
/// B: +1 for each postcondition that returns SUCCESS, -2 for each constraint that returns FAILURE, +1 when the root
/// is a selector and returns SUCCESS. Nodes that are not ticked count 0. In the authors' code the first two look for nodes
/// of other names and find none, and every selector counts.
///
/// Source: BeTr-GEESE, section 4.6.
pub struct Feedback<'a> {
    tree: &'a Tree<Leaf>,
    trace: &'a mut [Trace],
    tick: u32,
    rule: FeedbackRule,
    /// The sum.
    pub sum: i32,
}

impl<'a> Feedback<'a> {
    /// Begins step `tick`; `trace` has one place for each node of `tree`.
    pub fn new(tree: &'a Tree<Leaf>, trace: &'a mut [Trace], tick: u32, rule: FeedbackRule) -> Self {
        Self { tree, trace, tick, rule, sum: 0 }
    }
}

impl Recorder for Feedback<'_> {
    fn returned(&mut self, node: NodeId, status: Status) {
        self.trace[node.index()] = Trace { status, tick: self.tick };
        let by_tags = self.rule == FeedbackRule::Tags;
        self.sum += match (&self.tree.nodes()[node.index()].kind, status) {
            (Kind::Leaf(Leaf { tag: Tag::Post, .. }), Status::Success) if by_tags => 1,
            (Kind::Leaf(Leaf { tag: Tag::Con, .. }), Status::Failure) if by_tags => -2,
            (Kind::Fallback, Status::Success) if node == NodeId(0) || !by_tags => 1,
            _ => 0,
        };
    }
}
