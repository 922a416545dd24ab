//! Bounds, meaning and source of every parameter, and the checks that concern several of them.

use super::params::{MutationMode, Params};
use super::program::Compiler;
use crate::evolution::Limits;
use crate::parameter::{Apply, Kind, Parameter, number};

/// The PPA grammar of BeTr-GEESE for foraging (BNF-II), after the paper's appendix B. The paper elides the
/// alternatives of pc, p, k and action; they are those of the authors' grammar for foraging. The order matters:
/// a codon chooses by number.
pub const GRAMMAR: &str = "\
<S> ::= <root>
<root> ::= <sequence> | <selector>
<sequence> ::= Seq[<ppa>] | Seq[<root> <root>] | Seq[<sequence> <root>]
<selector> ::= Sel[<ppa>] | Sel[<root> <root>] | Sel[<selector> <root>]
<ppa> ::= Sel[<postconditions> <ppasequence>]
<postconditions> ::= <successnode> | <ppa> | Seq[<postcondition>]
<postcondition> ::= <postcondition> Post(<pc>) | Post(<pc>)
<pc> ::= NeighbourObjects <o> | NeighbourObjects <s> | NeighbourObjects <d> | IsCarrying <d> | IsVisitedBefore <s>
<ppasequence> ::= Seq[<preconditions> Act(<action>)] | Seq[<constraints> Act(<action>)]
  | Seq[<preconditions> <constraints> Act(<action>)]
<preconditions> ::= Seq[<precondition>]
<precondition> ::= <precondition> Pre(<p>) | Pre(<p>)
<p> ::= IsDropable <s> | NeighbourObjects <o> | not NeighbourObjects <o> | IsVisitedBefore <s>
  | not IsVisitedBefore <s> | IsCarrying <d> | not IsCarrying <d>
<constraints> ::= Seq[<constraint>]
<constraint> ::= <constraint> Con(<k>) | Con(<k>)
<k> ::= CanMove | IsCarryable <d> | IsDropable <s>
<action> ::= MoveTowards <s> | Explore | CompositeSingleCarry <d> | CompositeDrop <d> | MoveAway <s>
<o> ::= <s> | <d>
<s> ::= Hub | Sites
<d> ::= Food
<successnode> ::= Post(DummyNode)
";

const WORLD: &str = "World";
const ROBOTS: &str = "Robots";
const EVOLUTION: &str = "Evolution";
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
        label: "Food",
        help: "How much food lies at the site. 0 means as much as there are robots.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "steps",
        kind: Kind::Int { min: 1, max: 50_000, hard_max: 10_000_000, log: true },
        unit: "steps",
        apply: Apply::Restart,
        group: WORLD,
        label: "Steps",
        help: "The run ends after so many steps, or earlier when all food is delivered.",
        source: TABLE_1,
    },
    Parameter {
        name: "success-threshold",
        kind: real(0.0, 1.0, 1.0, 0.01),
        unit: "",
        apply: Apply::Live,
        group: WORLD,
        label: "Success above",
        help: "A run is a success when more than this share of the food is delivered at its end.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "site-distance",
        kind: real(0.0, 40.0, 200.0, 1.0),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Distance to the site",
        help: "From the centre of the hub to the centre of the site; the direction is random.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "hub-radius",
        kind: real(1.0, 25.0, 200.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Hub radius",
        help: "The hub is a disc at the centre of the arena. Robots start there and bring food there.",
        source: "BeTr-GEESE, section 4.2",
    },
    Parameter {
        name: "site-radius",
        kind: real(1.0, 25.0, 200.0, 0.5),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Site radius",
        help: "The food lies scattered in a disc of this radius.",
        source: "BeTr-GEESE, section 4.3",
    },
    Parameter {
        name: "arena-size",
        kind: int(20, 200, 400),
        unit: "units",
        apply: Apply::Restart,
        group: WORLD,
        label: "Arena side",
        help: "The arena is a square. A robot that reaches the edge stays on it and turns round.",
        source: "BeTr-GEESE, section 4.2; the rule at the edge is our choice, the paper is silent",
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
        kind: Kind::Choice(&[("anywhere", "Anywhere"), ("hub", "Only at the hub")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "Dropping",
        help: "Food dropped outside the hub stays on the ground and can be picked up again.",
        source: "BeTr-GEESE, appendix A (at the current location)",
    },
    Parameter {
        name: "is-dropable",
        kind: Kind::Choice(&[("always", "Always"), ("kind", "For the hub"), ("standing", "Inside the hub")]),
        unit: "",
        apply: Apply::Live,
        group: ROBOTS,
        label: "IsDropable holds",
        help: "When the condition IsDropable succeeds. Inside the hub only, it keeps robots from ever leaving it.",
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
        kind: Kind::Choice(&[("diversity", "The most diverse"), ("random", "Any that works")]),
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: "Choice of child",
        help: "Which child may become the robot's program. Any that works shows what selection adds.",
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
        help: "The rules that turn codons into behaviour trees.",
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
        let compiler = Compiler::new(&self.grammar, limits).map_err(|error| ("grammar", error.to_string()))?;
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
        if reach > self.half() {
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
