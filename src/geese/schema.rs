//! Bounds, meaning and source of every parameter, and the checks that concern several of them.

use super::body::MOST_PLACES;
use super::grammars::grammar_text;
use super::params::{MutationMode, Params, Task};
use super::program::Compiler;
use crate::evolution::Limits;
use crate::parameter::{Apply, Kind, Parameter, number};

const WORLD: &str = "World";
const ROBOTS: &str = "Robots";
const EVOLUTION: &str = "Evolution";
const POPULATION: &str = "Population";
const GENOME: &str = "Genome and grammar";
const TABLE_1: &str = "BeTr-GEESE, Table 1";

const fn int(min: i64, max: i64, hard_max: i64) -> Kind {
    Kind::Int { min, max, hard_max, log: false }
}

const fn real(min: f64, max: f64, hard_max: f64, step: f64) -> Kind {
    Kind::Float { min, max, hard_max, step, log: false }
}

/// All parameters, in the order in which the page shows them.
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        name: "task",
        kind: Kind::Choice(&[("forage", "Foraging"), ("nest", "Nest maintenance")]),
        unit: "",
        apply: Apply::Restart,
        group: WORLD,
        label: "Task",
        help: "Bring food from the site to the hub, or carry debris from the hub out of the boundary.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "agents",
        kind: int(1, 400, 10_000),
        unit: "robots",
        apply: Apply::Restart,
        group: WORLD,
        label: "Robots",
        help: "How many robots learn at the same time.",
        source: TABLE_1,
    },
    Parameter {
        name: "items",
        kind: int(0, 400, 10_000),
        unit: "items",
        apply: Apply::Restart,
        group: WORLD,
        label: "Items",
        help: "How many pieces of food or debris there are. 0 means as many as robots.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "steps",
        kind: Kind::Int { min: 1, max: 50_000, hard_max: 10_000_000, log: true },
        unit: "steps",
        apply: Apply::Restart,
        group: WORLD,
        label: "Steps",
        help: "The run ends after so many steps, or earlier when every item is where it belongs.",
        source: TABLE_1,
    },
    Parameter {
        name: "success-threshold",
        kind: real(0.0, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Live,
        group: WORLD,
        label: "Success above",
        help: "A run is a success when more than this share of the items is where it belongs at its end.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "item-placement",
        kind: Kind::Choice(&[("scattered", "Scattered"), ("stacked", "On one spot")]),
        unit: "",
        apply: Apply::Restart,
        group: WORLD,
        label: "Items lie",
        help: "Anywhere in the site (debris: in the hub), or all on its centre.",
        source: "our choice; the paper is silent, the authors' code stacks them",
    },
    Parameter {
        name: "sites",
        kind: int(1, 4, MOST_PLACES),
        unit: "sites",
        apply: Apply::Restart,
        group: WORLD,
        label: "Sites",
        help: "Food is shared out among so many sites, each in a random direction.",
        source: "BeTr-GEESE, section 4.3 (one site)",
    },
    Parameter {
        name: "site-distance",
        kind: real(0.0, 40.0, 1000.0, 1.0),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Distance to the site",
        help: "From the centre of the hub to the centre of the site; the direction is random.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "hub-radius",
        kind: real(1.0, 25.0, 1000.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Hub radius",
        help: "The hub is a disc at the centre of the arena. Robots start there and bring food there.",
        source: "BeTr-GEESE, section 4.2",
    },
    Parameter {
        name: "site-radius",
        kind: real(1.0, 25.0, 1000.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Site radius",
        help: "The food lies scattered in a disc of this radius.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "boundary-radius",
        kind: real(5.0, 45.0, 1000.0, 1.0),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Boundary radius",
        help: "In nest maintenance, debris belongs outside this circle around the origin.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "obstacles",
        kind: int(0, 5, MOST_PLACES),
        unit: "obstacles",
        apply: Apply::Restart,
        group: WORLD,
        label: "Obstacles",
        help: "How many obstacles stand at random places. They bar the way.",
        source: "our choice: none; the paper gives no number",
    },
    Parameter {
        name: "obstacle-radius",
        kind: real(0.5, 10.0, 50.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Obstacle radius",
        help: "Obstacles are discs of this radius.",
        source: "our choice; the authors' code has 5",
    },
    Parameter {
        name: "traps",
        kind: int(0, 5, MOST_PLACES),
        unit: "traps",
        apply: Apply::Restart,
        group: WORLD,
        label: "Traps",
        help: "How many traps lie at random places. A robot that touches one is dead.",
        source: "our choice: none; the paper gives no number",
    },
    Parameter {
        name: "trap-radius",
        kind: real(0.5, 10.0, 50.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Trap radius",
        help: "Traps are discs of this radius.",
        source: "our choice; the authors' code has 5",
    },
    Parameter {
        name: "arena-size",
        kind: int(20, 200, 2000),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Arena side",
        help: "The arena is a square. A robot that reaches the edge stays on it and turns round.",
        source: "BeTr-GEESE, section 4.2; the rule at the edge is our choice, the paper is silent",
    },
    Parameter {
        name: "behaviours",
        kind: Kind::Choice(&[("ppa", "PPA: with postconditions"), ("nominal", "Nominal: plain sequences")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Primitive behaviours",
        help: "PPA behaviours stop when their goal is reached and walk around obstacles; nominal ones do neither.",
        source: "BeTr-GEESE, section 4.4, Figure 1",
    },
    Parameter {
        name: "start-positions",
        kind: Kind::Choice(&[("hub", "At the hub"), ("uniform", "Anywhere")]),
        unit: "",
        apply: Apply::Restart,
        group: ROBOTS,
        label: "Robots start",
        help: "At the centre of the hub, or anywhere in the arena.",
        source: "BeTr-GEESE, appendix B (agents originate in a hub); anywhere in the authors' code",
    },
    Parameter {
        name: "activation",
        kind: Kind::Choice(&[("shuffled", "In an order shuffled each step"), ("index", "Always in the same order")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Order of acting",
        help: "Who acts first in a step.",
        source: "our choice: the paper calls the updates independent; the authors' code keeps one order",
    },
    Parameter {
        name: "step-length",
        kind: real(0.1, 5.0, 20.0, 0.1),
        unit: "units",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Step length",
        help: "How far a robot moves in one step, loaded or not.",
        source: "BeTr-GEESE, section 4.2",
    },
    Parameter {
        name: "moves-per-step",
        kind: Kind::Choice(&[("one", "One"), ("unlimited", "Every action that moves")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Moves per step",
        help: "Whether a tree with several moving actions can move several times in one step.",
        source: "our choice; the paper is silent, the authors' code sets no limit",
    },
    Parameter {
        name: "look-ahead",
        kind: real(0.0, 10.0, 50.0, 0.5),
        unit: "units",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Look ahead",
        help: "How far ahead PPA behaviours see obstacles and traps.",
        source: "our choice, as in the authors' code; the paper is silent on the length",
    },
    Parameter {
        name: "sense-radius",
        kind: real(0.5, 15.0, 200.0, 0.5),
        unit: "units",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Sensing radius",
        help: "How far a robot senses food and other robots. It is also the reach for picking up.",
        source: "our choice: close to the area of a cell in the authors' code; the paper is silent",
    },
    Parameter {
        name: "explore-heading",
        kind: Kind::Choice(&[("uniform", "New direction each step"), ("turning", "Slowly turning walk")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Explore",
        help: "A new random direction on every step goes nowhere fast; a slowly turning walk covers ground.",
        source: "BeTr-GEESE, appendix A (random direction); the turning walk is that of the authors' code",
    },
    Parameter {
        name: "turn-deviation",
        kind: real(0.0, 1.5, 3.2, 0.01),
        unit: "radians",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Turn per step",
        help: "Standard deviation of the turn in a slowly turning walk.",
        source: "the authors' code",
    },
    Parameter {
        name: "drop-rule",
        kind: Kind::Choice(&[("anywhere", "Anywhere"), ("sink", "Only where it belongs")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Dropping",
        help: "Food belongs in the hub, debris outside the boundary; elsewhere it stays on the ground and can be picked up again.",
        source: "BeTr-GEESE, appendix A (at the current location)",
    },
    Parameter {
        name: "is-dropable",
        kind: Kind::Choice(&[
            ("always", "Always"),
            ("kind", "For the right place"),
            ("standing", "At the right place"),
        ]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "IsDropable holds",
        help: "When the condition IsDropable succeeds. At the hub only, it keeps foraging robots from ever leaving it.",
        source: "our choice: the paper lets items be dropped at any place; the authors' code always succeeds",
    },
    Parameter {
        name: "interaction-probability",
        kind: real(0.0, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Interaction probability",
        help: "How likely a robot takes a copy of the genome of each robot it senses, in each step.",
        source: TABLE_1,
    },
    Parameter {
        name: "storage-threshold",
        kind: int(1, 50, 1000),
        unit: "genomes",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Storage threshold",
        help: "A robot breeds when it has stored more than this many genomes of other robots.",
        source: TABLE_1,
    },
    Parameter {
        name: "storage-content",
        kind: Kind::Choice(&[("donors", "Each robot once"), ("meetings", "Every meeting")]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Storage counts",
        help: "Whether meeting the same robot again replaces its stored genome or adds one more.",
        source: "our choice, as in the authors' code; the paper is silent. Each robot once leaves lonely groups stuck",
    },
    Parameter {
        name: "parent-selection",
        kind: Kind::Choice(&[("truncation", "Best share"), ("tournament", "Tournament")]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Parents",
        help: "How the parents are chosen from the stored genomes and the robot's own, by fitness.",
        source: TABLE_1,
    },
    Parameter {
        name: "parent-share",
        kind: real(0.05, 1.0, 1.0, 0.05),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Best share",
        help: "The part of the pool that may become parents; at least two do.",
        source: "our choice: the best half, as in the authors' code; the paper is silent",
    },
    Parameter {
        name: "tournament-size",
        kind: int(1, 10, 100),
        unit: "genomes",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Tournament size",
        help: "How many genomes are drawn for each parent in a tournament.",
        source: "our choice; the paper is silent",
    },
    Parameter {
        name: "elite-size",
        kind: int(0, 10, 1000),
        unit: "genomes",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Elite",
        help: "How many of the fittest genomes of the pool compete unchanged with the children.",
        source: TABLE_1,
    },
    Parameter {
        name: "children",
        kind: int(1, 100, 1000),
        unit: "genomes",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Children",
        help: "How many children a robot breeds at once; the most diverse one may become its program.",
        source: "our choice: 24, as in the authors' code; the paper is silent",
    },
    Parameter {
        name: "genome-selection",
        kind: Kind::Choice(&[
            ("diversity", "The most diverse"),
            ("random", "Any that works"),
            ("fresh", "None: a random program"),
        ]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Choice of child",
        help: "Which child may become the robot's program. Any that works shows what selection adds; a random program in its place shows what changing programs alone does.",
        source: TABLE_1,
    },
    Parameter {
        name: "crossover-mode",
        kind: Kind::Choice(&[
            ("variable-one-point", "Each at its own place"),
            ("fixed-one-point", "Both at the same place"),
        ]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Crossover cuts",
        help: "Cut at different places, genomes change their length; at the same place, they keep it.",
        source: TABLE_1,
    },
    Parameter {
        name: "crossover-probability",
        kind: real(0.0, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Crossover probability",
        help: "How likely two parents exchange the ends of their genomes.",
        source: TABLE_1,
    },
    Parameter {
        name: "mutation-mode",
        kind: Kind::Choice(&[("bit", "Flip a bit"), ("codon", "Redraw a codon")]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Mutation",
        help: "What one mutation changes.",
        source: "BeTr-GEESE, section 3 (bits)",
    },
    Parameter {
        name: "mutation-probability",
        kind: Kind::Float { min: 0.0, max: 0.5, hard_max: 1.0, step: 0.005, log: false },
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Mutation probability",
        help: "How likely each bit, or each codon, of the used part of a genome changes.",
        source: TABLE_1,
    },
    Parameter {
        name: "swap-rule",
        kind: Kind::Choice(&[("d-gt", "If more diverse"), ("d-ge", "If at least as diverse"), ("always", "Always")]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Replace program",
        help: "When the most diverse child replaces the robot's program.",
        source: "BeTr-GEESE, section 3 (if fitter); a child has no fitness but its diversity yet",
    },
    Parameter {
        name: "fitness-diversity",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness I: diversity",
        help: "Distinct behaviours in the tree over those in the grammar count for fitness.",
        source: "BeTr-GEESE, section 4.6",
    },
    Parameter {
        name: "fitness-exploration",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness II: exploration",
        help: "Unit squares visited since the program was taken up count for fitness.",
        source: "BeTr-GEESE, section 4.6; what a location is, is our choice",
    },
    Parameter {
        name: "fitness-prospective",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness III: prospective",
        help: "Items carried count for fitness: an ad hoc reward of GEESE-BT.",
        source: "BeTr-GEESE, section 4.6; the formula is our choice",
    },
    Parameter {
        name: "fitness-task",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness IV: task",
        help: "Items where they belong, of the whole swarm, count for fitness: an ad hoc reward of GEESE-BT.",
        source: "BeTr-GEESE, section 4.6",
    },
    Parameter {
        name: "fitness-feedback",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness V: feedback",
        help: "Statuses of the tree's own nodes count for fitness.",
        source: "BeTr-GEESE, section 4.6",
    },
    Parameter {
        name: "fitness-memory",
        kind: real(0.0, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Fitness memory",
        help: "How much of the fitness so far stays in each step: the blend factor beta.",
        source: "BeTr-GEESE, section 4.6",
    },
    Parameter {
        name: "evolution",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: POPULATION,
        label: "Robots evolve",
        help: "When off, nobody meets anybody: every robot keeps the program it has.",
        source: "BeTr-GEESE, section 5 (fixed programs)",
    },
    Parameter {
        name: "population-form",
        kind: Kind::Choice(&[
            ("as-saved", "As it was saved"),
            ("homogeneous", "Copies of the fittest"),
            ("heterogeneous", "The fittest, each its own"),
            ("blended", "The fittest, all in each robot"),
        ]),
        unit: "",
        apply: Apply::Restart,
        group: POPULATION,
        label: "Saved programs become",
        help: "How the programs of a saved population are dealt out. It needs a population.",
        source: "BeTr-GEESE, section 5",
    },
    Parameter {
        name: "population-share",
        kind: real(0.01, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Restart,
        group: POPULATION,
        label: "The fittest",
        help: "The share of the saved population that takes part.",
        source: "BeTr-GEESE, sections 5.2 and 5.3 (top n %)",
    },
    Parameter {
        name: "population",
        kind: Kind::Text(8_000_000),
        unit: "",
        apply: Apply::Restart,
        group: POPULATION,
        label: "Saved population",
        help: "The programs to start with, as a population file; empty for random ones.",
        source: "BeTr-GEESE, section 5",
    },
    Parameter {
        name: "genome-length",
        kind: int(1, 200, 1000),
        unit: "codons",
        apply: Apply::Restart,
        group: GENOME,
        label: "Genome length",
        help: "How many codons a genome starts with, and the most it can have.",
        source: "BeTr-GEESE, section 4.1",
    },
    Parameter {
        name: "codon-max",
        kind: int(1, 2000, 65_535),
        unit: "",
        apply: Apply::Restart,
        group: GENOME,
        label: "Largest codon",
        help: "Codons are whole numbers from 0 to this. Bit mutation needs one less than a power of two.",
        source: "our choice: codons of 8 bits; the paper speaks of blocks of bits",
    },
    Parameter {
        name: "max-depth",
        kind: int(2, 20, 60),
        unit: "levels",
        apply: Apply::Restart,
        group: GENOME,
        label: "Deepest derivation",
        help: "A genome whose derivation goes deeper maps to no program. At 10, every program has one action.",
        source: TABLE_1,
    },
    Parameter {
        name: "max-wraps",
        kind: int(0, 5, 100),
        unit: "times",
        apply: Apply::Restart,
        group: GENOME,
        label: "Wraps",
        help: "How often a genome may be read again from its start when its codons are used up.",
        source: "our choice; the paper is silent",
    },
    Parameter {
        name: "grammar",
        kind: Kind::Text(100_000),
        unit: "",
        apply: Apply::Restart,
        group: GENOME,
        label: "Grammar",
        help: "The rules that turn codons into behaviour trees. The words ppa and nominal stand for the built-in rules of the task.",
        source: "BeTr-GEESE, appendix B; the parts the paper leaves out are those of the authors' grammar",
    },
];

impl Params {
    /// Compiles the grammar and checks what concerns several parameters; each alone is within its bounds.
    ///
    /// # Errors
    /// The field's name, what was found and what is allowed.
    pub fn check(&self) -> Result<Compiler, (&'static str, String)> {
        let limits = Limits { max_wraps: self.max_wraps, max_depth: self.max_depth };
        let compiler = Compiler::new(&grammar_text(&self.grammar, self.task), limits)
            .map_err(|error| ("grammar", error.to_string()))?;
        let least = compiler.grammar().least_depth();
        if self.max_depth < least {
            let message = format!(
                "expected at least {least}, the depth of the grammar's flattest program, found {}",
                self.max_depth
            );
            return Err(("max-depth", message));
        }
        self.check_fit()?;
        Ok(compiler)
    }

    /// Checks what concerns several parameters but not the grammar: all that a live change can upset, at little cost.
    ///
    /// # Errors
    /// As [`Params::check`].
    pub fn check_fit(&self) -> Result<(), (&'static str, String)> {
        if self.mutation_mode == MutationMode::Bit && !(u32::from(self.codon_max) + 1).is_power_of_two() {
            let message = format!(
                "expected one less than a power of two (1, 3, 7 ... 65535) while mutation flips bits, found {}",
                self.codon_max
            );
            return Err(("codon-max", message));
        }
        let reach = self.site_distance + self.site_radius;
        if self.task == Task::Nest && self.boundary_radius > self.half() {
            let message = format!(
                "expected at most {}, half the arena's side, found {}",
                number(self.half()),
                number(self.boundary_radius)
            );
            return Err(("boundary-radius", message));
        }
        if self.task == Task::Forage && reach > self.half() {
            let message = format!(
                "expected at most {}, so that a site of radius {} lies inside the arena, found {}",
                number(self.half() - self.site_radius),
                number(self.site_radius),
                number(self.site_distance)
            );
            return Err(("site-distance", message));
        }
        if self.hub_radius > self.half() {
            let message = format!(
                "expected at most {}, half the arena's side, found {}",
                number(self.half()),
                number(self.hub_radius)
            );
            return Err(("hub-radius", message));
        }
        Ok(())
    }
}
