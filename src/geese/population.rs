//! Evolved populations: saved with their fitness, and dealt out again to agents that evolve on or stay as they are.

use super::controller::Controller;
use super::leaf::Leaf;
use super::mind::Offer;
use super::params::{Params, PopulationForm};
use super::program::{Compiler, placeholder};
use super::switches::PopulationPool;
use super::world::{State, World};
use crate::bt::{Builder, Kind, NodeId, Tree};
use crate::evolution::Genome;
use crate::random::{Purpose, Seed, stream};
use rand::RngExt;
use serde_json::{Value, json};

/// What a population file says it is.
const FORMAT: &str = "geese-population/1";
const MOST_MEMBERS: usize = 10_000;
/// The longest genome that a scenario can have.
const MOST_CODONS: usize = 1_000;

/// The controllers of a swarm at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Population {
    /// In the order of the agents they come from.
    pub members: Vec<Member>,
}

/// One controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// Run-time fitness A, in whole millionths.
    pub fitness: f64,
    /// The codons.
    pub genome: Vec<u16>,
}

impl Population {
    /// The population of a world as it stands.
    #[must_use]
    pub fn of(world: &World) -> Self {
        Self::of_state(world.state())
    }

    pub(super) fn of_state(state: &State) -> Self {
        let member = |offer: &Offer| Member {
            fitness: millionths(offer.fitness),
            genome: state.genomes.get(offer.genome).codons.to_vec(),
        };
        Self { members: state.offers.iter().map(member).collect() }
    }

    /// The text of a population file.
    #[must_use]
    pub fn write(&self) -> String {
        self.text("")
    }

    /// As [`Population::write`], with the run and the tick the population comes from: for people, and not read again.
    ///
    /// - `title`: of the scenario; empty for a nameless one.
    #[must_use]
    pub fn write_with(&self, title: &str, seed: Seed, tick: u32) -> String {
        let title = Value::from(title);
        self.text(&format!("  \"title\": {title},\n  \"seed\": {},\n  \"tick\": {tick},\n", seed.value()))
    }

    fn text(&self, origin: &str) -> String {
        let members: Vec<String> = self
            .members
            .iter()
            .map(|member| json!({"fitness": member.fitness, "genome": member.genome}).to_string())
            .collect();
        let version = env!("CARGO_PKG_VERSION");
        let list = members.join(",\n    ");
        format!(
            "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": \"{version}\",\n{origin}  \"members\": [\n    {list}\n  ]\n}}\n"
        )
    }

    /// Reads a population file.
    ///
    /// # Errors
    /// Line and column where the text is no JSON; otherwise the path of the field, what was found and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(text).map_err(|fault| format!("expected JSON, found {fault}"))?;
        if value["format"] != FORMAT {
            return Err(format!("format: expected \"{FORMAT}\", found {}", value["format"]));
        }
        let Some(list) = value["members"].as_array().filter(|list| (1..=MOST_MEMBERS).contains(&list.len())) else {
            return Err(format!("members: expected a list of 1 to {MOST_MEMBERS} members"));
        };
        let members = list.iter().enumerate().map(|(index, member)| {
            let fitness = member["fitness"].as_f64();
            let fitness = fitness.ok_or_else(|| format!("members[{index}].fitness: expected a number"))?;
            let codons =
                member["genome"].as_array().map(|codons| codons.iter().map(codon).collect::<Option<Vec<u16>>>());
            let genome = codons
                .flatten()
                .ok_or_else(|| format!("members[{index}].genome: expected a list of whole numbers from 0 to 65535"))?;
            if genome.len() > MOST_CODONS {
                let found = genome.len();
                return Err(format!("members[{index}].genome: expected {MOST_CODONS} codons at most, found {found}"));
            }
            Ok(Member { fitness, genome })
        });
        Ok(Self { members: members.collect::<Result<_, String>>()? })
    }

    /// The members that take part, by number, fittest first; of equally fit ones the earlier first.
    ///
    /// Source: BeTr-GEESE, sections 5.1 to 5.3. The authors' code takes a share of the different programs, of which it
    /// keeps as many as there are agents, and rounds it to the nearest whole number.
    fn chosen(&self, params: &Params, controllers: &[Controller]) -> Vec<usize> {
        // An archive is a sample already, and nobody knows what its members are worth.
        if matches!(params.population_form, PopulationForm::AsSaved | PopulationForm::Archive) {
            return (0..controllers.len()).collect();
        }
        // The order of `total_cmp` turned round; equal ones stay in their order by their numbers.
        let rank = |fitness: f64| {
            let bits = fitness.to_bits().cast_signed();
            !((bits ^ (bits >> 63 & i64::MAX)).cast_unsigned() ^ 1 << 63)
        };
        let mut ranked: Vec<(u64, u32)> =
            (0..).zip(&self.members).map(|(at, member)| (rank(member.fitness), at)).collect();
        ranked.sort_unstable();
        let mut members: Vec<usize> = ranked.iter().map(|&(_, member)| member as usize).collect();
        let share = params.population_share;
        let part = match params.population_pool {
            PopulationPool::Agents => members.len() as f64 * share,
            PopulationPool::Programs => {
                let (mut seen, mut kept) = (Vec::new(), Vec::new());
                for member in members {
                    let id = controllers[member].id();
                    if !seen.contains(&id) {
                        seen.push(id);
                        kept.push(member);
                    }
                }
                members = kept;
                (members.len().min(params.agents as usize) as f64 * share).round_ties_even()
            }
        };
        members.truncate(if params.population_form == PopulationForm::Homogeneous {
            1
        } else {
            (part as usize).max(1)
        });
        members
    }

    /// The controller of each agent, with its codons. Members are dealt out in turns; a blended agent has them all
    /// under one root, each agent in an order of its own.
    ///
    /// The paper's root is a Parallel that "loosely acts as a logical or". No leaf here returns RUNNING, so it ticks every
    /// child once in each step and its status has no effect: a Sequence of children that are forced to succeed.
    ///
    /// # Errors
    /// The member whose genome maps to no program of the compiler's grammar, or is no tree where trees are to be blended.
    pub fn deal(&self, params: &Params, seed: Seed, compiler: &mut Compiler) -> Result<Deal, String> {
        let mut controllers = Vec::with_capacity(self.members.len());
        for (index, member) in self.members.iter().enumerate() {
            let mut controller = Controller::default();
            compiler.compile(&member.genome, &mut controller).map_err(|_| {
                format!("members[{index}].genome: expected codons of a program of the grammar, found none")
            })?;
            controllers.push(controller);
        }
        let chosen = self.chosen(params, &controllers);
        let turns = if matches!(params.population_form, PopulationForm::Multiplexed | PopulationForm::Archive) {
            chosen.iter().filter_map(|&member| self.known(member, compiler)).collect()
        } else {
            Vec::new()
        };
        let agents = 0..params.agents;
        let agents = match params.population_form {
            PopulationForm::Blended => {
                let trees: Option<Vec<&Tree<Leaf>>> = controllers.iter().map(Controller::tree).collect();
                let trees = trees.ok_or("expected behaviour trees to blend, found state machines")?;
                let blended = agents.map(|agent| {
                    let mut order = chosen.clone();
                    let mut rng = stream(seed, Purpose::Genesis, agent);
                    for last in (1..order.len() as u32).rev() {
                        order.swap(last as usize, rng.random_range(0..=last) as usize);
                    }
                    Dealt {
                        codons: self.members[order[0]].genome.clone(),
                        controller: blend(order.iter().map(|&index| trees[index])).into(),
                    }
                });
                blended.collect()
            }
            _ => agents
                .map(|agent| {
                    let index = chosen[agent as usize % chosen.len()];
                    Dealt { codons: self.members[index].genome.clone(), controller: controllers[index].clone() }
                })
                .collect(),
        };
        Ok(Deal { agents, turns })
    }

    /// One of the programs that take turns.
    fn known(&self, member: usize, compiler: &mut Compiler) -> Option<Known> {
        let mut genome = Genome { codons: self.members[member].genome.clone(), ..Genome::default() };
        let survey = compiler.survey(&mut genome, None)?;
        Some(Known { genome, diversity: survey.diversity })
    }
}

/// A population that was dealt out.
#[derive(Clone, Debug)]
pub struct Deal {
    /// The controller of each agent.
    pub agents: Vec<Dealt>,
    /// The programs among which multiplexed agents choose; none in the other forms.
    ///
    /// An answer to the question with which the paper's section 5 ends: fixed programs fail because none solves the whole
    /// task, and what evolution adds while it runs is that every robot changes its program all the time. Here nothing
    /// evolves any more, but the changing stays.
    pub turns: Vec<Known>,
}

/// A program of a fixed population.
#[derive(Clone, Debug)]
pub struct Known {
    /// Its genome, mapped.
    pub genome: Genome,
    /// Its diversity.
    pub diversity: f64,
}

/// The controller of one agent.
#[derive(Clone, Debug)]
pub struct Dealt {
    /// The codons; of a blended agent those of its first tree.
    pub codons: Vec<u16>,
    /// The program.
    pub controller: Controller,
}

fn blend<'a>(trees: impl Iterator<Item = &'a Tree<Leaf>>) -> Tree<Leaf> {
    let mut builder = Builder::default();
    builder.open(Kind::Sequence);
    for tree in trees {
        builder.open(Kind::ForceSuccess);
        graft(tree, NodeId(0), &mut builder);
        builder.close();
    }
    builder.close();
    builder.finish().unwrap_or_else(|_| placeholder())
}

fn graft(tree: &Tree<Leaf>, node: NodeId, builder: &mut Builder<Leaf>) {
    builder.open(tree.nodes()[node.index()].kind.clone());
    for child in tree.children(node) {
        graft(tree, child, builder);
    }
    builder.close();
}

/// Rounded, so that the text that is written is read as the same number.
fn millionths(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn codon(value: &Value) -> Option<u16> {
    value.as_u64().and_then(|codon| u16::try_from(codon).ok())
}
