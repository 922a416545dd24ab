//! What a study measures of a swarm: counts and means over robots and programs, at one moment.

use super::controller::Controller;
use super::leaf::{Leaf, Name};
use super::world::World;
use crate::bt::{Kind, NodeId, Tree};

/// The swarm in numbers, as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// Items carried.
    pub carrying: u32,
    /// Robots that have touched no trap.
    pub alive: u32,
    /// Distinct programs that the robots ran last.
    pub programs: u32,
    /// Programs replaced since the start, or since the learning ended, over robots and steps; 0 before the first step.
    pub swaps_per_agent_step: f64,
    /// Action leaves, or reachable states of a machine, mean over the distinct programs.
    pub actions: f64,
    /// Shares of the distinct programs with one, two, three, and four or more of them.
    pub by_actions: [f64; 4],
    /// Share of the robots whose program can never run an action.
    pub inert: f64,
    /// Diversity D, mean over the robots.
    pub diversity: f64,
    /// Run-time fitness A, mean over the robots.
    pub fitness: f64,
    /// Codons of the genome, mean over the robots.
    pub genome_length: f64,
}

impl Measure {
    /// Measures a world.
    #[must_use]
    pub fn of(world: &World) -> Self {
        let state = world.state();
        let agents = f64::from(world.params().agents);
        let mean = |value: &dyn Fn(&super::mind::Offer) -> f64| state.offers.iter().map(value).sum::<f64>() / agents;
        let (mut programs, mut actions, mut by_actions, mut inert) = (0_u32, 0_u32, [0.0; 4], 0);
        for group in state.by_program().chunk_by(|a, b| a.0 == b.0) {
            let controller = &state.ran(group[0].1).controller;
            // A machine does something in every step; it counts with the behaviours that it can come to.
            let (here, idle) = match controller {
                Controller::Tree(planted) => (action_count(&planted.tree), is_inert(&planted.tree)),
                Controller::Machine(machine) => (machine.reachable(), false),
            };
            programs += 1;
            actions += here;
            // A program without actions counts among none of the four.
            if let Some(place) = here.checked_sub(1) {
                by_actions[place.min(3) as usize] += 1.0;
            }
            inert += if idle { group.len() } else { 0 };
        }
        // A fixed population counts from its start.
        let before = if world.awaits_test() { 0 } else { world.params().learning_steps.min(state.tick) };
        let agent_steps = agents * f64::from(state.tick - before);
        let swaps: f64 = state.offers.iter().map(|offer| f64::from(offer.swaps)).sum();
        Self {
            carrying: state.field.carried(),
            alive: state.alive,
            programs,
            swaps_per_agent_step: if agent_steps > 0.0 { swaps / agent_steps } else { 0.0 },
            actions: f64::from(actions) / f64::from(programs),
            by_actions: by_actions.map(|count| count / f64::from(programs)),
            inert: inert as f64 / agents,
            diversity: mean(&|offer| offer.diversity),
            fitness: mean(&|offer| offer.fitness),
            genome_length: mean(&|offer| state.genomes.get(offer.genome).codons.len() as f64),
        }
    }
}

fn action_count(tree: &Tree<Leaf>) -> u32 {
    tree.nodes().iter().filter(|node| matches!(&node.kind, Kind::Leaf(leaf) if leaf.name.is_action())).count() as u32
}

/// Whether no action can ever be ticked, because what stands before it always succeeds or always fails.
///
/// Only `DummyNode` and `CanMove` count as constant (a robot that ticks is alive); conditions that contradict each other
/// are not looked for, so the share of inert programs is a lower bound (our choice).
#[must_use]
pub fn is_inert(tree: &Tree<Leaf>) -> bool {
    !possible(tree, NodeId(0)).acts
}

/// What ticking a node can come to.
#[derive(Clone, Copy, Default)]
struct Possible {
    succeeds: bool,
    fails: bool,
    acts: bool,
}

fn possible(tree: &Tree<Leaf>, node: NodeId) -> Possible {
    let any = Possible { succeeds: true, fails: true, acts: false };
    match &tree.nodes()[node.index()].kind {
        Kind::Leaf(leaf) if leaf.name.is_action() => Possible { acts: true, ..any },
        Kind::Leaf(Leaf { name: Name::DummyNode | Name::CanMove, negated, .. }) => {
            Possible { succeeds: !negated, fails: *negated, acts: false }
        }
        Kind::Leaf(_) => any,
        kind => {
            // A sequence goes on after SUCCESS and ends with FAILURE; a selector the other way round.
            let goes_on_after_success = *kind == Kind::Sequence;
            let (mut goes_on, mut ends, mut acts) = (true, false, false);
            for child in tree.children(node) {
                if !goes_on {
                    break;
                }
                let child = possible(tree, child);
                acts |= child.acts;
                goes_on = if goes_on_after_success { child.succeeds } else { child.fails };
                ends |= if goes_on_after_success { child.fails } else { child.succeeds };
            }
            let (succeeds, fails) = if goes_on_after_success { (goes_on, ends) } else { (ends, goes_on) };
            Possible { succeeds, fails, acts }
        }
    }
}
