//! What the inspector shows: one agent, the agents of one program, or everyone.

use super::controller::{Controller, Planted};
use super::leaf::{Leaf, Name, Object, Tag};
use super::machine::Machine;
use super::mind::Trace;
use super::params::Params;
use super::showmachine::ShownMachine;
use super::world::{State, World};
use crate::bt::{Kind, NodeId, Status, Tree};
use serde::Serialize;
use serde_json::Value;

/// What to show.
#[derive(Clone, Debug, Default)]
pub struct Query {
    /// An agent by number.
    pub agent: Option<u32>,
    /// A program by its id, 16 hex digits; ignored when an agent is given.
    pub program: Option<String>,
    /// A node of the shown tree, or a rule of the machine: the agents that reached it in the last step are listed.
    pub node: Option<u32>,
}

impl Query {
    /// Reads a query from JSON; what is not there, or is no number or text, is not asked for.
    #[must_use]
    pub fn from_value(value: &Value) -> Self {
        let number = |name: &str| value.get(name)?.as_u64().and_then(|number| u32::try_from(number).ok());
        let program = value.get("program").and_then(Value::as_str).map(str::to_owned);
        Self { agent: number("agent"), program, node: number("node") }
    }
}

/// The answer to a query.
#[derive(Clone, Debug, Serialize)]
pub struct Detail {
    tick: u32,
    programs: Programs,
    behaviours: Vec<Behaviour>,
    agent: Option<Agent>,
    tree: Option<ShownTree>,
    reached: Option<Vec<u32>>,
}

#[derive(Clone, Debug, Serialize)]
struct Programs {
    count: usize,
    top: Vec<Group>,
}

/// Agents that ran the same program in the last step.
#[derive(Clone, Debug, Serialize)]
struct Group {
    id: String,
    agents: usize,
    text: String,
    first: u32,
}

/// A leaf name across all programs.
#[derive(Clone, Debug, Serialize)]
struct Behaviour {
    name: &'static str,
    /// Agents whose program has it.
    agents: usize,
    /// Agents that ticked it in the last step.
    ticked: usize,
    /// Agents for which it returned SUCCESS in the last step.
    succeeded: usize,
}

#[derive(Clone, Debug, Serialize)]
struct Agent {
    id: u32,
    x: f64,
    y: f64,
    heading: f64,
    carrying: bool,
    alive: bool,
    knows: Vec<&'static str>,
    inside: Vec<&'static str>,
    fitness: f64,
    diversity: f64,
    exploration: u32,
    feedback: i32,
    prospective: u32,
    /// As the agent's last tick counted it: agents that moved later in the step may have delivered more.
    task: u32,
    /// The blend factor beta.
    memory: f64,
    /// The fitness types that count in this scenario.
    counts: Vec<&'static str>,
    since_swap: u32,
    swaps: u32,
    stored: Vec<Stored>,
    last_action: Option<String>,
    genome: Vec<u16>,
    used: u16,
    program: String,
    /// The program that will run next, when it replaced the shown one in the last step.
    replaced_by: Option<String>,
}

#[derive(Clone, Debug, Serialize)]
struct Stored {
    donor: u32,
    fitness: f64,
    diversity: f64,
}

#[derive(Clone, Debug, Serialize)]
struct ShownTree {
    program: String,
    text: String,
    agents: Vec<u32>,
    /// Of a tree; a machine has none.
    nodes: Vec<ShownNode>,
    machine: Option<ShownMachine>,
}

/// A node as the page draws it.
#[derive(Clone, Debug, Serialize)]
pub struct ShownNode {
    id: u32,
    parent: Option<u32>,
    end: u32,
    kind: &'static str,
    label: String,
    tag: Option<&'static str>,
    negated: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    status: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reached_now: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reached_recently: Option<f64>,
}

/// How many programs the list shows.
const TOP: usize = 12;
/// "Recently" is within so many steps.
const RECENT: u32 = 50;

/// A program's id as the page shows it.
fn hex(id: u64) -> String {
    format!("{id:016x}")
}

/// The nodes of a tree without statuses.
#[must_use]
pub fn shown_nodes(tree: &Tree<Leaf>) -> Vec<ShownNode> {
    let parents = tree.parents();
    let nodes = tree.nodes().iter().zip(parents).enumerate();
    nodes
        .map(|(id, (node, parent))| {
            let kind = tree.kind_name(NodeId(id as u32));
            let (label, tag, negated) = match &node.kind {
                Kind::Leaf(leaf) => (leaf.to_string(), (leaf.tag != Tag::None).then(|| leaf.tag.text()), leaf.negated),
                _ => (kind.to_owned(), None, false),
            };
            ShownNode {
                id: id as u32,
                parent: parent.map(|node| node.0),
                end: node.end,
                kind,
                label,
                tag,
                negated,
                status: None,
                reached_now: None,
                reached_recently: None,
            }
        })
        .collect()
}

impl Detail {
    /// Answers `query` for the present state of `world`.
    ///
    /// An agent or program that does not exist gives `None` in its place; a program that nobody runs any more too.
    #[must_use]
    pub fn of(world: &mut World, query: &Query) -> Self {
        let names: Vec<Name> = world.compiler().vocabulary().collect();
        let state = world.state();
        let (count, groups) = groups(state);
        let agent = query.agent.filter(|&id| (id as usize) < state.minds.len());
        let program = match (agent, &query.program) {
            (Some(id), _) => Some(state.ran(id).id),
            (None, Some(id)) => u64::from_str_radix(id, 16).ok(),
            (None, None) => groups.first().map(|group| group.0),
        };
        let held: Vec<u32> = (0..state.minds.len() as u32).filter(|&id| program == Some(state.ran(id).id)).collect();
        let shown = agent.map_or_else(|| held.clone(), |id| vec![id]);
        let tree = held.first().map(|_| shown_tree(state, &held, &shown, agent.is_some()));
        let reached = query
            .node
            .zip(tree.as_ref())
            .map(|(node, _)| held.iter().copied().filter(|&id| was_reached(state, id, node)).collect());
        Self {
            tick: state.tick,
            programs: Programs { count, top: groups.into_iter().take(TOP).map(|group| group.1).collect() },
            behaviours: behaviours(state, &names),
            agent: agent.map(|id| shown_agent(state, world.params(), id)),
            tree,
            reached,
        }
    }
}

fn was_reached(state: &State, agent: u32, node: u32) -> bool {
    let reached = match &state.ran(agent).controller {
        Controller::Tree(planted) => planted.trace.get(node as usize).map(|trace| trace.tick()),
        Controller::Machine(machine) => machine.fired.get(node as usize).copied(),
    };
    state.tick > 0 && reached == Some(state.tick)
}

/// The number of distinct programs and the largest groups, largest first; of equal ones the one whose first agent
/// has the smallest number.
fn groups(state: &State) -> (usize, Vec<(u64, Group)>) {
    let ran = state.by_program();
    let mut groups: Vec<&[(u64, u32)]> = ran.chunk_by(|a, b| a.0 == b.0).collect();
    let count = groups.len();
    let mut top = Vec::new();
    while top.len() < TOP {
        let largest = (0..groups.len()).max_by_key(|&at| (groups[at].len(), u32::MAX - groups[at][0].1));
        let Some(largest) = largest else { break };
        let group = groups.swap_remove(largest);
        let (program, first) = group[0];
        let text = state.ran(first).controller.text();
        top.push((program, Group { id: hex(program), agents: group.len(), text, first }));
    }
    (count, top)
}

fn behaviours(state: &State, names: &[Name]) -> Vec<Behaviour> {
    let mut counts = vec![[0_usize; 3]; Name::ALL.len()];
    for agent in 0..state.minds.len() as u32 {
        let program = state.ran(agent);
        let mut seen = [[false; 3]; Name::ALL.len()];
        let mut see = |name: Name, now: bool, success: bool| {
            let flags = &mut seen[name as usize];
            flags[0] = true;
            flags[1] |= now;
            flags[2] |= now && success;
        };
        match &program.controller {
            Controller::Tree(Planted { tree, trace, .. }) => {
                for (node, trace) in tree.nodes().iter().zip(trace) {
                    let Kind::Leaf(leaf) = &node.kind else { continue };
                    let status = trace.status_in(state.tick);
                    see(leaf.name, status != Status::Idle, status == Status::Success);
                }
            }
            Controller::Machine(machine) => {
                let now = state.tick > 0 && machine.tick == state.tick;
                for (place, test) in machine.tests.iter().enumerate() {
                    see(test.name, now, machine.holds >> place & 1 == 1);
                }
                for (leaf, place) in machine.states.iter().zip(0..) {
                    see(leaf.name, now && machine.state == place, machine.succeeded);
                }
            }
        }
        for (count, flags) in counts.iter_mut().zip(seen) {
            for (count, flag) in count.iter_mut().zip(flags) {
                *count += usize::from(flag);
            }
        }
    }
    let shown = names.iter().map(|&name| {
        let [agents, ticked, succeeded] = counts[name as usize];
        Behaviour { name: name.text(), agents, ticked, succeeded }
    });
    shown.collect()
}

fn shown_agent(state: &State, params: &Params, id: u32) -> Agent {
    let (body, mind, offer) = (&state.bodies[id as usize], &state.minds[id as usize], &state.offers[id as usize]);
    let position = state.field.agents.point(id);
    let field = &state.field;
    let stands_in = |place: Object| match place {
        Object::Hub => field.covers(&field.hub, position),
        Object::Sites => field.sites.iter().any(|disc| field.covers(disc, position)),
        Object::Boundary => field.sink() == Object::Boundary && field.accepts(position),
        _ => false,
    };
    let places = |is: &dyn Fn(Object) -> bool| -> Vec<&'static str> {
        Object::PLACES.into_iter().filter(|place| is(*place)).map(Object::text).collect()
    };
    let ran = state.ran(id);
    Agent {
        id,
        x: position[0],
        y: position[1],
        heading: libm::atan2(body.heading[1], body.heading[0]),
        carrying: body.load.is_some(),
        alive: body.alive,
        knows: places(&|place| body.knows(place, field)),
        inside: places(&stands_in),
        fitness: offer.fitness,
        diversity: offer.diversity,
        exploration: mind.exploration(params.exploration),
        feedback: mind.feedback,
        prospective: u32::from(body.load.is_some()),
        task: mind.task,
        memory: params.fitness_memory,
        counts: counted(params),
        since_swap: state.tick - mind.since,
        swaps: offer.swaps,
        stored: mind
            .storage
            .entries()
            .iter()
            .map(|entry| Stored { donor: entry.donor, fitness: entry.offer.fitness, diversity: entry.offer.diversity })
            .collect(),
        last_action: body.last_action.map(|leaf| leaf.to_string()),
        genome: state.genomes.get(offer.genome).codons.to_vec(),
        used: state.genomes.get(offer.genome).used,
        program: hex(ran.id),
        replaced_by: mind.was_replaced(state.tick).then(|| mind.program.controller.text()),
    }
}

fn counted(params: &Params) -> Vec<&'static str> {
    let types = [
        (params.fitness_diversity, "diversity"),
        (params.fitness_exploration, "exploration"),
        (params.fitness_prospective, "prospective"),
        (params.fitness_task, "task"),
        (params.fitness_feedback, "feedback"),
    ];
    types.into_iter().filter(|(counts, _)| *counts).map(|(_, name)| name).collect()
}

/// The tree of the agents `held`, with the trace of the agents `shown` (one of them, or all).
fn shown_tree(state: &State, held: &[u32], shown: &[u32], with_status: bool) -> ShownTree {
    let program = state.ran(held[0]);
    let mut nodes = program.controller.tree().map(shown_nodes).unwrap_or_default();
    let (mut traces, mut machines): (Vec<&[Trace]>, Vec<&Machine>) = (Vec::new(), Vec::new());
    for &id in shown {
        match &state.ran(id).controller {
            Controller::Tree(planted) => traces.push(&planted.trace),
            Controller::Machine(machine) => machines.push(machine),
        }
    }
    let machine = machines.first().map(|machine| ShownMachine::running(machine, &machines, state.tick, RECENT));
    for (index, node) in nodes.iter_mut().enumerate() {
        let within = |steps: u32| {
            let reached =
                traces.iter().filter(|trace| trace[index].tick() > 0 && trace[index].tick() + steps > state.tick);
            reached.count() as f64 / traces.len() as f64
        };
        node.reached_now = Some(within(1));
        node.reached_recently = Some(within(RECENT));
        node.status = with_status.then(|| traces[0][index].status_in(state.tick).name());
    }
    ShownTree { program: hex(program.id), text: program.controller.text(), agents: held.to_vec(), nodes, machine }
}
