//! The switches of the world: the paper's text taken literally is the default of each.

use super::schema::GRAMMAR;
use serde::{Deserialize, Serialize};

/// Every parameter of the foraging world and its evolution; see `schema.rs` for bounds, meaning and source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[expect(missing_docs, reason = "each field is described once, in the schema")]
pub struct Params {
    pub agents: u32,
    pub steps: u32,
    pub arena_size: u32,
    pub hub_radius: f64,
    pub site_radius: f64,
    pub site_distance: f64,
    pub items: u32,
    pub success_threshold: f64,
    pub step_length: f64,
    pub moves_per_step: MovesPerStep,
    pub sense_radius: f64,
    pub explore_heading: ExploreHeading,
    pub turn_deviation: f64,
    pub drop_rule: DropRule,
    pub is_dropable: IsDropable,
    pub genome_length: u16,
    pub codon_max: u16,
    pub max_depth: u32,
    pub max_wraps: u32,
    pub grammar: String,
    pub interaction_probability: f64,
    pub storage_threshold: u32,
    pub storage_content: StorageContent,
    pub parent_selection: ParentSelection,
    pub parent_share: f64,
    pub tournament_size: u32,
    pub elite_size: u32,
    pub children: u32,
    pub genome_selection: GenomeSelection,
    pub crossover_mode: CrossoverMode,
    pub crossover_probability: f64,
    pub mutation_mode: MutationMode,
    pub mutation_probability: f64,
    pub swap_rule: SwapRule,
    pub fitness_memory: f64,
}

/// How many moves an agent makes in one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MovesPerStep {
    /// A second move in the same step fails.
    One,
    /// Every action of the tree that moves, moves.
    Unlimited,
}

/// How Explore chooses its heading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExploreHeading {
    /// A new direction on every call.
    Uniform,
    /// The heading so far plus a small normal angle.
    Turning,
}

/// Where CompositeDrop puts an item down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DropRule {
    /// Anywhere; outside the hub the item stays on the ground.
    Anywhere,
    /// Only in the hub; elsewhere the drop fails.
    Hub,
}

/// When the condition IsDropable holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum IsDropable {
    /// Everywhere, as dropping is allowed everywhere.
    Always,
    /// For the hub, wherever the agent is: it is the kind of place that takes food.
    Kind,
    /// For the hub, while the agent stands in it.
    Standing,
}

/// What counts as one stored genome.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StorageContent {
    /// The newest genome of each donor.
    Donors,
    /// One genome of each meeting, the same donor's again and again.
    Meetings,
}

/// How parents are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ParentSelection {
    /// The best share of the pool; each pair is drawn from it.
    Truncation,
    /// Each parent is the best of a few drawn from the pool.
    Tournament,
}

/// Which child may become the agent's program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GenomeSelection {
    /// The most diverse one.
    Diversity,
    /// The first that maps to a program: no selection.
    Random,
}

/// Where two parents are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CrossoverMode {
    /// Each at its own place.
    VariableOnePoint,
    /// Both at the same place.
    FixedOnePoint,
}

/// What one mutation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MutationMode {
    /// A bit is flipped.
    Bit,
    /// A codon is drawn again.
    Codon,
}

/// When the best child replaces its parent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

impl Default for Params {
    fn default() -> Self {
        Self {
            agents: 100,
            steps: 12_000,
            arena_size: 100,
            hub_radius: 10.0,
            site_radius: 10.0,
            site_distance: 30.0,
            items: 0,
            success_threshold: 0.8,
            step_length: 2.0,
            moves_per_step: MovesPerStep::One,
            sense_radius: 5.0,
            explore_heading: ExploreHeading::Uniform,
            turn_deviation: 0.1,
            drop_rule: DropRule::Anywhere,
            is_dropable: IsDropable::Always,
            genome_length: 100,
            codon_max: 255,
            max_depth: 10,
            max_wraps: 0,
            grammar: GRAMMAR.to_owned(),
            interaction_probability: 0.85,
            storage_threshold: 7,
            storage_content: StorageContent::Meetings,
            parent_selection: ParentSelection::Truncation,
            parent_share: 0.5,
            tournament_size: 2,
            elite_size: 0,
            children: 24,
            genome_selection: GenomeSelection::Diversity,
            crossover_mode: CrossoverMode::VariableOnePoint,
            crossover_probability: 0.9,
            mutation_mode: MutationMode::Bit,
            mutation_probability: 0.01,
            swap_rule: SwapRule::Greater,
            fitness_memory: 0.9,
        }
    }
}

impl Params {
    /// Half the side of the arena: coordinates lie in `[-half, half]`.
    #[must_use]
    pub fn half(&self) -> f64 {
        f64::from(self.arena_size) / 2.0
    }

    /// How many items there are: as many as agents unless a number is given.
    #[must_use]
    pub fn item_count(&self) -> u32 {
        if self.items == 0 { self.agents } else { self.items }
    }
}
