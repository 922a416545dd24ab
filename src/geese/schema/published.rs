//! The switches to the authors' published code, in the order in which the page shows them: each at the end of its group.
//! The first choice of each is the paper's.

use super::evolution::{EVOLUTION, GENOME, POPULATION};
use super::world::{ROBOTS, WORLD};
use crate::parameter::{Apply, Kind, Parameter, text};

const CODE: &str = text("the second choice is that of the authors' code");
const SILENT: &str = text("our choice; the paper is silent, the second choice is that of the authors' code");

/// A choice that needs a restart.
const fn restart(
    group: &'static str,
    [name, label, help]: [&'static str; 3],
    choices: &'static [(&'static str, &'static str)],
    source: &'static str,
) -> Parameter {
    let [label, help, source] = [text(label), text(help), text(source)];
    Parameter { name, kind: Kind::Choice(choices), unit: "", apply: Apply::Restart, group, label, help, source }
}

/// A choice that can change during a run.
const fn live(
    group: &'static str,
    texts: [&'static str; 3],
    choices: &'static [(&'static str, &'static str)],
    source: &'static str,
) -> Parameter {
    Parameter { apply: Apply::Live, ..restart(group, texts, choices, source) }
}

pub const PARAMETERS: &[Parameter] = &[
    restart(
        WORLD,
        ["footprint", "Places are", "The ground of hub, sites, obstacles and traps."],
        &[("disc", text("Discs")), ("cells", text("Cells of a lattice"))],
        "BeTr-GEESE, section 4.2; the second choice is that of the authors' code",
    ),
    restart(
        WORLD,
        ["site-placement", "Sites lie", "At random angles, or up and to the left by the distance."],
        &[("ring", text("Around the hub")), ("fixed", text("At a fixed place"))],
        "BeTr-GEESE, section 4.3; the second choice is that of the authors' code",
    ),
    restart(
        WORLD,
        [
            "nest-sink",
            "Debris belongs",
            "Outside the circle, or in five places on it; a sixth swallows debris unscored.",
        ],
        &[("ring", text("Outside the boundary")), ("cells", text("In places on the boundary"))],
        "BeTr-GEESE, section 4.3; the second choice is that of the authors' code",
    ),
    live(
        WORLD,
        ["edge-rule", "At the edge", "Robots that would leave stay and turn round, or bounce back by two units."],
        &[("clamp", text("Stay")), ("bounce", text("Bounce"))],
        SILENT,
    ),
    restart(
        WORLD,
        ["rounding", "Coordinates", "Whether robots stand on whole coordinates, rounded after each step."],
        &[("none", text("Real")), ("nearest", text("Rounded")), ("truncate", text("Whole part"))],
        SILENT,
    ),
    live(
        ROBOTS,
        ["step-rule", "Steps with a load", "Whether a load makes steps shorter."],
        &[("constant", text("As long as without")), ("by-load", text("Half as long"))],
        "BeTr-GEESE, section 4.2; the second choice is that of the authors' code",
    ),
    live(
        ROBOTS,
        [
            "sensing",
            "Robots sense",
            "Places they stand in and what is within the sensing radius, or all in their cell.",
        ],
        &[("disc", text("By distance")), ("cell", text("By cell"))],
        SILENT,
    ),
    live(
        ROBOTS,
        ["avoid-rule", "Way round obstacles", "Along the tangent, or along an edge of the bounding box."],
        &[("tangent", text("Tangent")), ("box", text("Bounding box"))],
        "BeTr-GEESE, appendix A; the second choice is that of the authors' code",
    ),
    restart(
        ROBOTS,
        ["initial-memory", "Boundary known", "Where debris belongs in places, which of them robots know at the start."],
        &[("all", text("All of it")), ("first-boundary", text("One place"))],
        SILENT,
    ),
    live(
        ROBOTS,
        [
            "percept-wipe",
            "Percepts last",
            "Until the next tick, or until the next look; IsCarryable then looks at nothing else.",
        ],
        &[("tick", text("One tick")), ("sense", text("Until the next look"))],
        SILENT,
    ),
    live(
        ROBOTS,
        ["blackboard", "Percepts are", "Shared percepts make a difference when they last until the next look."],
        &[("private", text("Each robot's own")), ("shared", text("Shared by all"))],
        SILENT,
    ),
    live(
        ROBOTS,
        ["moveaway-postcondition", "MoveAway is done", "When PPA robots stop moving away."],
        &[("not-sensed", text("When out of the place")), ("sensed", text("When in the place"))],
        SILENT,
    ),
    live(
        ROBOTS,
        ["drop-postcondition", "Dropping nothing", "What CompositeDrop of PPA robots returns without a load."],
        &[("not-carrying", text("Succeeds")), ("none", text("Fails"))],
        "BeTr-GEESE, appendix A; the second choice is that of the authors' code",
    ),
    live(
        EVOLUTION,
        [
            "neighbours",
            "Robots meet",
            "The others within the sensing radius, or all in the cell and themselves, two at least.",
        ],
        &[("radius", text("Within the radius")), ("cell", text("In the cell"))],
        SILENT,
    ),
    live(
        EVOLUTION,
        [
            "storage-value",
            "Stored genomes are worth",
            "Whether a stored genome's fitness goes on changing with its donor's.",
        ],
        &[("copied", text("What they were")), ("live", text("What they are now"))],
        SILENT,
    ),
    Parameter {
        name: "stagnation",
        kind: Kind::int(0, 500, 1_000_000),
        unit: "steps",
        apply: Apply::Live,
        group: EVOLUTION,
        label: text("Stagnation"),
        help: text(
            "A robot that explored fewer than two places for so long breeds with ten random genomes; 0 means never.",
        ),
        source: text("our choice: never, as the paper is silent; 200 in the authors' code"),
    },
    Parameter {
        name: "own-in-pool",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Live,
        group: EVOLUTION,
        label: text("Own genome breeds"),
        help: text("Whether a robot's own genome is among those that may become parents."),
        source: text("our choice; the paper is silent, in the authors' code only as one that was met"),
    },
    live(
        EVOLUTION,
        ["elite-rank", "Elite counts by", "What the elite is compared with the children's diversity by."],
        &[("diversity", text("Diversity")), ("fitness", text("Fitness"))],
        SILENT,
    ),
    live(
        EVOLUTION,
        ["length-rule", "Children too long", "What happens to children longer than genomes can be."],
        &[("cut", text("Lose their end")), ("redraw", text("Are drawn again"))],
        SILENT,
    ),
    live(
        EVOLUTION,
        ["fitness", "Fitness remembers", "Its own past, or the last fitness of the program before."],
        &[("recurrence", text("Its own past")), ("delayed", text("The program before"))],
        "BeTr-GEESE, section 4.6; the second choice is that of the authors' code",
    ),
    restart(
        EVOLUTION,
        [
            "diversity",
            "Diversity counts",
            "Names over those of the grammar, or names of a list of nine with less for large programs.",
        ],
        &[("names", text("Names")), ("leaves", text("Names and leaves"))],
        "BeTr-GEESE, section 4.1; the second choice is that of the authors' code",
    ),
    restart(
        EVOLUTION,
        ["exploration", "Exploration counts", "Unit squares visited, or lattice cells beyond the first."],
        &[("squares", text("Squares")), ("cells", text("Cells"))],
        SILENT,
    ),
    live(
        EVOLUTION,
        [
            "bt-feedback",
            "Feedback counts",
            "Postconditions, constraints and the root, or the successes of every selector.",
        ],
        &[("tags", text("Parts of PPA trees")), ("selectors", text("Selectors"))],
        "BeTr-GEESE, section 4.6; the second choice is that of the authors' code",
    ),
    restart(
        POPULATION,
        ["population-pool", "The fittest of", "Whether robots with one program count once."],
        &[("agents", text("The robots")), ("programs", text("The programs"))],
        "BeTr-GEESE, section 5; the second choice is that of the authors' code",
    ),
    restart(
        GENOME,
        ["init", "First genomes", "Random codons, or those of a random derivation and half as many behind them."],
        &[("random-bits", text("Random codons")), ("derivation-tree", text("Random derivation"))],
        CODE,
    ),
];
