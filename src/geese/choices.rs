//! The words among which parameters choose, but for the switches to the published code.

use serde::Serialize;

/// What the swarm is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Task {
    /// Bring food from the sites to the hub.
    Forage,
    /// Carry debris from the hub out of the boundary.
    Nest,
}

/// How items lie at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ItemPlacement {
    /// Anywhere in the site, or in the hub for debris.
    Scattered,
    /// All on its centre.
    Stacked,
}

/// Where agents start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StartPositions {
    /// At the centre of the hub.
    Hub,
    /// Anywhere in the arena.
    Uniform,
}

/// The order in which agents act within a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Activation {
    /// Shuffled anew for each step.
    Shuffled,
    /// By number.
    Index,
}

/// How the primitive behaviours are built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Behaviours {
    /// With postconditions and obstacle avoidance.
    Ppa,
    /// Plain sequences, as in GEESE-BT.
    Nominal,
}

/// How many moves an agent makes in one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MovesPerStep {
    /// A second move in the same step fails.
    One,
    /// Every action of the tree that moves, moves.
    Unlimited,
}

/// How Explore chooses its heading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExploreHeading {
    /// A new direction on every call.
    Uniform,
    /// The heading so far plus a small normal angle.
    Turning,
}

/// Where CompositeDrop puts an item down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DropRule {
    /// Anywhere; where it does not belong the item stays on the ground.
    Anywhere,
    /// Only where the item belongs; elsewhere the drop fails.
    Sink,
    /// Anywhere but in the hub when the items are debris: there the drop fails.
    OutsideHub,
}

/// When the condition IsDropable holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum IsDropable {
    /// Everywhere, as dropping is allowed everywhere.
    Always,
    /// For the place that takes the task's items, wherever the agent is: the hub or the boundary.
    Kind,
    /// For that place, while the agent stands there.
    Standing,
}

/// What counts as one stored genome.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StorageContent {
    /// The newest genome of each donor.
    Donors,
    /// One genome of each meeting, the same donor's again and again.
    Meetings,
}

/// How parents are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ParentSelection {
    /// The best share of the pool; each pair is drawn from it.
    Truncation,
    /// Each parent is the best of a few drawn from the pool.
    Tournament,
}

/// Which child may become the agent's program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum GenomeSelection {
    /// The most diverse one.
    Diversity,
    /// The winner of a tournament by fitness.
    Tournament,
    /// The first that maps to a program: no selection.
    Random,
    /// No child: a random genome, as at the start.
    Fresh,
}

/// How the programs of a saved population are dealt out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PopulationForm {
    /// Each agent gets one, in the order saved.
    AsSaved,
    /// All get the fittest.
    Homogeneous,
    /// The fittest are dealt out in turns.
    Heterogeneous,
    /// Each agent gets all of the fittest under one root.
    Blended,
    /// Each agent runs one of the fittest for a while, then another.
    Multiplexed,
    /// The same with programs of the whole learning: a sample of those that agents took up at any time.
    Archive,
}

/// Where two parents are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CrossoverMode {
    /// Each at its own place.
    VariableOnePoint,
    /// Both at the same place.
    FixedOnePoint,
}

/// What one mutation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MutationMode {
    /// A bit is flipped.
    Bit,
    /// A codon is drawn again.
    Codon,
}

/// When the best child replaces its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum SwapRule {
    /// When its diversity is greater.
    #[serde(rename = "d-gt")]
    Greater,
    /// When its diversity is not smaller.
    #[serde(rename = "d-ge")]
    NotSmaller,
    /// Always.
    #[serde(rename = "always")]
    Always,
}
