//! An agent's controller and all that evolution needs of it: genome, program, fitness and stored genomes.

use super::controller::Controller;
use super::genomes::{GenomeId, Genomes};
use super::leaf::{Leaf, Tag};
use super::switches::{ExplorationRule, FeedbackRule};
use super::visited::Visited;
use crate::bt::{Kind, NodeId, Recorder, Status, Tree};
use crate::fingerprint::Fingerprint;
use crate::random::Stream;

/// What a node of the program last returned, and in which step: twice the step, and one more for SUCCESS. In a swarm there
/// are many of them, so they are small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trace(u32);

impl Trace {
    /// - `status`: SUCCESS or FAILURE, as all that these programs return; `tick`: from 1 on.
    #[must_use]
    pub fn new(status: Status, tick: u32) -> Self {
        Self(tick << 1 | u32::from(status == Status::Success))
    }

    /// The step; 0: never.
    #[must_use]
    pub fn tick(self) -> u32 {
        self.0 >> 1
    }

    /// What was returned in a step; IDLE when it was not in this one.
    #[must_use]
    pub fn status_in(self, tick: u32) -> Status {
        if self.tick() == tick && tick > 0 { Status::completed(self.0 & 1 == 1) } else { Status::Idle }
    }
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

/// The programs that were replaced in the last step, which others may still ask for; those of the steps before leave their
/// memory to the next ones. That is less than a former program for each agent, and it lies in the order of its use.
#[derive(Clone, Debug, Default)]
pub struct Replaced {
    programs: Vec<Program>,
    count: usize,
}

impl Replaced {
    /// Begins a step.
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// The program of that place.
    #[must_use]
    pub fn get(&self, place: u32) -> &Program {
        &self.programs[place as usize]
    }

    /// Takes a place: its number, and the old program that lies there, to be overwritten.
    pub fn take(&mut self) -> (u32, &mut Program) {
        let place = self.count;
        self.count += 1;
        if place == self.programs.len() {
            self.programs.push(Program::default());
        }
        (place as u32, &mut self.programs[place])
    }

    /// The program of the place that will be taken so many times from now, if there is one.
    #[must_use]
    pub fn next(&self, after: usize) -> Option<&Program> {
        self.programs.get(self.count + after)
    }

    /// About how many bytes a copy takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.programs.iter().map(|program| size_of::<Program>() + program.controller.bytes()).sum()
    }
}

/// What others read of an agent that they meet: kept apart from the rest, so that those of a whole crowd lie close together.
#[derive(Clone, Copy, Debug)]
pub struct Offer {
    /// The genome of the program.
    pub genome: GenomeId,
    /// How many times the program was replaced.
    pub swaps: u32,
    /// Diversity D of the program.
    pub diversity: f64,
    /// Run-time fitness A.
    pub fitness: f64,
}

/// The controller of one agent.
///
/// What every step needs stands first and in as few lines of the processor's memory as possible, see [`super::ahead`].
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Mind {
    /// The step in which the program was taken up; 0 at the start.
    pub since: u32,
    /// Feedback B of the last step.
    pub feedback: i32,
    /// Items delivered by the whole swarm when the program was ticked last.
    pub task: u32,
    /// The agent's own stream for exchange and breeding.
    pub evolution: Stream,
    /// Genomes of other agents.
    pub storage: Storage,
    /// The program that will be ticked next.
    pub program: Program,
    /// Squares visited since the program was taken up; their number is exploration E.
    pub visited: Visited,
    /// Where the program before it lies in [`Replaced`], when it was replaced in the last step.
    pub replaced: u32,
    /// The last fitness of the program before, and of the one before it; 0 unless something asks for them.
    pub last: [f64; 2],
    /// The agent's own stream for what its machine does with a probability.
    pub luck: Stream,
}

impl Mind {
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

    /// Feeds everything that decides what the agent does next.
    pub fn feed(&self, offer: &Offer, genomes: &Genomes, hash: &mut Fingerprint) {
        genomes.get(offer.genome).feed(hash);
        hash.u64(self.program.id);
        hash.u32(self.since);
        hash.u32(offer.swaps);
        hash.f64(offer.diversity);
        hash.f64(offer.fitness);
        if self.last.iter().any(|fitness| fitness.abs() > 0.0) {
            self.last.iter().for_each(|&fitness| hash.f64(fitness));
        }
        self.visited.squares().iter().for_each(|&square| hash.u32(square));
        for entry in self.storage.entries() {
            hash.u64(u64::from(entry.donor) | u64::from(entry.program()) << 32);
            hash.f64(entry.offer.fitness);
            hash.f64(entry.offer.diversity);
            genomes.get(entry.offer.genome).feed(hash);
        }
        hash.stream(&self.evolution);
        if let Controller::Machine(machine) = &self.program.controller {
            machine.feed(hash);
            hash.stream(&self.luck);
        }
    }
}

/// What another agent offered when it was met.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Whose genome it is.
    pub donor: u32,
    /// Whether its fitness is to be followed.
    pub live: bool,
    /// The offer; its genome is held as long as the entry stands.
    pub offer: Offer,
}

impl Entry {
    /// Which of the donor's programs it was, from 1 on, when its fitness is followed; otherwise 0.
    fn program(&self) -> u32 {
        if self.live { self.offer.swaps + 1 } else { 0 }
    }
}

/// The genomes an agent has collected: at most one of each donor, in the order of first arrival.
#[derive(Clone, Debug, Default)]
pub struct Storage {
    entries: Vec<Entry>,
}

impl Storage {
    /// What is stored.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Stores an offer in place of the donor's older one, or (`again`) besides it.
    ///
    /// - `live`: whether [`Storage::refresh`] is to follow its fitness.
    pub fn store(&mut self, donor: u32, offer: &Offer, genomes: &mut Genomes, again: bool, live: bool) {
        genomes.hold(offer.genome);
        let entry = Entry { donor, live, offer: *offer };
        match self.entries.iter_mut().find(|entry| !again && entry.donor == donor) {
            Some(older) => genomes.release(std::mem::replace(older, entry).offer.genome),
            None => self.entries.push(entry),
        }
    }

    /// Adds a genome that is nobody's program, worth its diversity.
    ///
    /// - `donor`: who drew it; `genome`: from now on held by the storage alone.
    pub fn add_fresh(&mut self, donor: u32, diversity: f64, genome: GenomeId) {
        let offer = Offer { genome, swaps: 0, diversity, fitness: diversity };
        self.entries.push(Entry { donor, live: false, offer });
    }

    /// Brings the fitness of followed entries up to date: that of the donor while it runs the program, then its last.
    ///
    /// Called once in each turn of the owner; until the next, a donor replaces its program twice at most.
    pub fn refresh(&mut self, offers: &[Offer], minds: &[Mind]) {
        for Entry { donor, offer, .. } in self.entries.iter_mut().filter(|entry| entry.live) {
            let (now, last) = (&offers[*donor as usize], &minds[*donor as usize].last);
            match now.swaps - offer.swaps {
                0 => offer.fitness = now.fitness,
                1 => offer.fitness = last[0],
                2 => offer.fitness = last[1],
                _ => {}
            }
        }
    }

    /// Empties the storage.
    pub fn clear(&mut self, genomes: &mut Genomes) {
        self.entries.drain(..).for_each(|entry| genomes.release(entry.offer.genome));
    }

    /// Bytes on the heap.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.entries.len() * size_of::<Entry>()
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
        self.trace[node.index()] = Trace::new(status, self.tick);
        let by_tags = self.rule == FeedbackRule::Tags;
        self.sum += match (&self.tree.nodes()[node.index()].kind, status) {
            (Kind::Leaf(Leaf { tag: Tag::Post, .. }), Status::Success) if by_tags => 1,
            (Kind::Leaf(Leaf { tag: Tag::Con, .. }), Status::Failure) if by_tags => -2,
            (Kind::Fallback, Status::Success) if node == NodeId(0) || !by_tags => 1,
            _ => 0,
        };
    }
}
