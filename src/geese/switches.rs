//! The switches between the paper's text and the authors' published code; `profiles.rs` lists them row by row.

use serde::Serialize;

/// The ground that a place takes up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Footprint {
    /// A disc.
    Disc,
    /// The lattice cell of its centre, with the cells around it for radii above 10.
    Cells,
}

/// What an agent senses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sensing {
    /// Places it stands in, items and agents within the sensing radius.
    Disc,
    /// All that is in its lattice cell.
    Cell,
}

/// Where the sites are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SitePlacement {
    /// At random angles, the site distance from the hub.
    Ring,
    /// Up and to the left by the site distance; further ones a quarter turn on each.
    Fixed,
}

/// Where debris belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NestSink {
    /// Anywhere outside the boundary circle.
    Ring,
    /// In five places just outside it; a sixth swallows debris unscored.
    Cells,
}

/// What happens at the edge of the arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EdgeRule {
    /// The agent stays on the edge and turns round.
    Clamp,
    /// It is put back two units, and turns round once for each axis.
    Bounce,
}

/// Whether agents stand on whole coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rounding {
    /// Real coordinates.
    None,
    /// The nearest whole number, of two the even one.
    Nearest,
    /// The whole part.
    Truncate,
}

/// How far one step goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StepRule {
    /// The step length.
    Constant,
    /// Half of it with a load.
    ByLoad,
}

/// How PPA behaviours get past what is ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AvoidRule {
    /// Along the tangent of the disc.
    Tangent,
    /// Along an edge of the bounding box.
    Box,
}

/// Which parts of the boundary agents know at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum InitialMemory {
    /// All.
    All,
    /// The first of the places that take debris.
    FirstBoundary,
}

/// Whose percepts an agent acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Blackboard {
    /// Its own.
    Private,
    /// Those of whoever sensed last.
    Shared,
}

/// When percepts are forgotten.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PerceptWipe {
    /// At the start of each tick.
    Tick,
    /// With each look, and by nothing else.
    Sense,
}

/// When MoveAway is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MoveAwayPostcondition {
    /// When the place is not sensed.
    NotSensed,
    /// When it is, as in MoveTowards.
    Sensed,
}

/// What CompositeDrop returns without a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DropPostcondition {
    /// SUCCESS.
    NotCarrying,
    /// FAILURE, after a look around.
    None,
}

/// Whom an agent meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Neighbours {
    /// The others within the sensing radius.
    Radius,
    /// All in its lattice cell and itself; at least two must remain.
    Cell,
}

/// What a stored genome is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StorageValue {
    /// The fitness its donor had when it was taken.
    Copied,
    /// The fitness its donor has with it now, or had last.
    Live,
}

/// What the elite is compared with children by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EliteRank {
    /// Diversity, as children are.
    Diversity,
    /// Fitness.
    Fitness,
}

/// What happens to children that are too long.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LengthRule {
    /// They lose their end.
    Cut,
    /// The pair is dropped and two parents are drawn again.
    Redraw,
}

/// How genomes are made at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Init {
    /// Random codons, drawn again until they map to a program.
    RandomBits,
    /// The codons of a random derivation, and half as many random ones behind them.
    DerivationTree,
}

/// What run-time fitness remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FitnessRule {
    /// A share of itself in the step before.
    Recurrence,
    /// A share of the last fitness of the program before.
    Delayed,
}

/// How diversity is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DiversityRule {
    /// Names in the program over names in the grammar.
    Names,
    /// Names of a list of nine, with less for programs of many leaves.
    Leaves,
}

/// What exploration counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExplorationRule {
    /// Unit squares.
    Squares,
    /// Lattice cells beyond the first.
    Cells,
}

/// Which statuses feedback counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FeedbackRule {
    /// Of postconditions, constraints and a selector at the root.
    Tags,
    /// Of every selector.
    Selectors,
}

/// What the fittest of a saved population are chosen from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PopulationPool {
    /// The agents.
    Agents,
    /// The different programs.
    Programs,
}
