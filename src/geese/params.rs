//! The switches of the world: the paper's text taken literally is the default of each.

pub use super::choices::{
    Activation, Behaviours, CrossoverMode, DropRule, ExploreHeading, GenomeSelection, IsDropable, ItemPlacement,
    MovesPerStep, MutationMode, ParentSelection, PopulationForm, StartPositions, StorageContent, SwapRule, Task,
};
use super::switches::{
    AvoidRule, Blackboard, DiversityRule, DropPostcondition, EdgeRule, EliteRank, ExplorationRule, FeedbackRule,
    FitnessRule, Footprint, Init, InitialMemory, LengthRule, MoveAwayPostcondition, Neighbours, NestSink, PerceptWipe,
    PopulationPool, Rounding, Sensing, SitePlacement, StepRule, StorageValue,
};
use serde::Serialize;
use serde_json::Value;

/// Every parameter of the foraging world and its evolution; see `schema.rs` for bounds, meaning and source. What is written
/// of it is [`Params::fields`]: the derived form lacks the switches.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[expect(missing_docs, reason = "each field is described once, in the schema")]
#[expect(clippy::struct_excessive_bools, reason = "the fitness types are switches of the paper, each on its own")]
pub struct Params {
    pub task: Task,
    pub agents: u32,
    pub steps: u32,
    pub arena_size: u32,
    pub hub_radius: f64,
    pub sites: u32,
    pub site_radius: f64,
    pub site_distance: f64,
    #[serde(skip)]
    pub site_placement: SitePlacement,
    pub boundary_radius: f64,
    #[serde(skip)]
    pub nest_sink: NestSink,
    pub items: u32,
    pub item_placement: ItemPlacement,
    pub obstacles: u32,
    pub obstacle_radius: f64,
    pub traps: u32,
    pub trap_radius: f64,
    #[serde(skip)]
    pub footprint: Footprint,
    #[serde(skip)]
    pub edge_rule: EdgeRule,
    #[serde(skip)]
    pub rounding: Rounding,
    pub success_threshold: f64,
    pub start_positions: StartPositions,
    pub activation: Activation,
    pub behaviours: Behaviours,
    pub step_length: f64,
    #[serde(skip)]
    pub step_rule: StepRule,
    pub moves_per_step: MovesPerStep,
    pub look_ahead: f64,
    #[serde(skip)]
    pub avoid_rule: AvoidRule,
    #[serde(skip)]
    pub sensing: Sensing,
    pub sense_radius: f64,
    pub explore_heading: ExploreHeading,
    pub turn_deviation: f64,
    pub drop_rule: DropRule,
    pub is_dropable: IsDropable,
    #[serde(skip)]
    pub initial_memory: InitialMemory,
    #[serde(skip)]
    pub blackboard: Blackboard,
    #[serde(skip)]
    pub percept_wipe: PerceptWipe,
    #[serde(skip)]
    pub moveaway_postcondition: MoveAwayPostcondition,
    #[serde(skip)]
    pub drop_postcondition: DropPostcondition,
    pub evolution: bool,
    pub learning_steps: u32,
    pub population_form: PopulationForm,
    pub population_share: f64,
    pub dwell: f64,
    #[serde(skip)]
    pub population_pool: PopulationPool,
    pub population: String,
    pub genome_length: u16,
    #[serde(skip)]
    pub init: Init,
    pub codon_max: u16,
    pub max_depth: u32,
    pub max_wraps: u32,
    pub grammar: String,
    pub interaction_probability: f64,
    #[serde(skip)]
    pub neighbours: Neighbours,
    pub storage_threshold: u32,
    pub storage_content: StorageContent,
    #[serde(skip)]
    pub storage_value: StorageValue,
    pub stagnation: u32,
    pub own_in_pool: bool,
    pub parent_selection: ParentSelection,
    pub parent_share: f64,
    pub tournament_size: u32,
    pub elite_size: u32,
    #[serde(skip)]
    pub elite_rank: EliteRank,
    pub children: u32,
    pub genome_selection: GenomeSelection,
    pub crossover_mode: CrossoverMode,
    pub crossover_probability: f64,
    #[serde(skip)]
    pub length_rule: LengthRule,
    pub mutation_mode: MutationMode,
    pub mutation_probability: f64,
    pub swap_rule: SwapRule,
    pub fitness_diversity: bool,
    pub fitness_exploration: bool,
    pub fitness_prospective: bool,
    pub fitness_task: bool,
    pub fitness_feedback: bool,
    pub fitness_memory: f64,
    #[serde(skip)]
    pub fitness: FitnessRule,
    #[serde(skip)]
    pub diversity: DiversityRule,
    #[serde(skip)]
    pub exploration: ExplorationRule,
    #[serde(skip)]
    pub bt_feedback: FeedbackRule,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            task: Task::Forage,
            agents: 100,
            steps: 12_000,
            arena_size: 100,
            hub_radius: 10.0,
            sites: 1,
            site_radius: 10.0,
            site_distance: 30.0,
            site_placement: SitePlacement::Ring,
            boundary_radius: 30.0,
            nest_sink: NestSink::Ring,
            items: 0,
            item_placement: ItemPlacement::Scattered,
            obstacles: 0,
            obstacle_radius: 5.0,
            traps: 0,
            trap_radius: 5.0,
            footprint: Footprint::Disc,
            edge_rule: EdgeRule::Clamp,
            rounding: Rounding::None,
            success_threshold: 0.8,
            start_positions: StartPositions::Hub,
            activation: Activation::Shuffled,
            behaviours: Behaviours::Ppa,
            step_length: 2.0,
            step_rule: StepRule::Constant,
            moves_per_step: MovesPerStep::One,
            look_ahead: 3.0,
            avoid_rule: AvoidRule::Tangent,
            sensing: Sensing::Disc,
            sense_radius: 5.0,
            explore_heading: ExploreHeading::Uniform,
            turn_deviation: 0.1,
            drop_rule: DropRule::Anywhere,
            is_dropable: IsDropable::Always,
            initial_memory: InitialMemory::All,
            blackboard: Blackboard::Private,
            percept_wipe: PerceptWipe::Tick,
            moveaway_postcondition: MoveAwayPostcondition::NotSensed,
            drop_postcondition: DropPostcondition::NotCarrying,
            evolution: true,
            learning_steps: 0,
            population_form: PopulationForm::AsSaved,
            population_share: 0.5,
            dwell: 3.0,
            population_pool: PopulationPool::Agents,
            population: String::new(),
            genome_length: 100,
            init: Init::RandomBits,
            codon_max: 255,
            max_depth: 10,
            max_wraps: 0,
            grammar: "ppa".to_owned(),
            interaction_probability: 0.85,
            neighbours: Neighbours::Radius,
            storage_threshold: 7,
            storage_content: StorageContent::Meetings,
            storage_value: StorageValue::Copied,
            stagnation: 0,
            own_in_pool: true,
            parent_selection: ParentSelection::Truncation,
            parent_share: 0.5,
            tournament_size: 2,
            elite_size: 0,
            elite_rank: EliteRank::Diversity,
            children: 24,
            genome_selection: GenomeSelection::Diversity,
            crossover_mode: CrossoverMode::VariableOnePoint,
            crossover_probability: 0.9,
            length_rule: LengthRule::Cut,
            mutation_mode: MutationMode::Bit,
            mutation_probability: 0.01,
            swap_rule: SwapRule::Greater,
            fitness_diversity: true,
            fitness_exploration: true,
            fitness_prospective: false,
            fitness_task: false,
            fitness_feedback: true,
            fitness_memory: 0.9,
            fitness: FitnessRule::Recurrence,
            diversity: DiversityRule::Names,
            exploration: ExplorationRule::Squares,
            bt_feedback: FeedbackRule::Tags,
        }
    }
}

impl Params {
    /// Sets the field of that name, in kebab case; returns false when there is none or the value is of another type.
    ///
    /// By hand, because derived reading of this many fields makes the wasm a tenth larger.
    pub fn set(&mut self, name: &str, value: &Value) -> bool {
        match name {
            "agents" => put_whole(&mut self.agents, value),
            "steps" => put_whole(&mut self.steps, value),
            "arena-size" => put_whole(&mut self.arena_size, value),
            "hub-radius" => value.as_f64().is_some_and(|real| put(&mut self.hub_radius, real)),
            "site-radius" => value.as_f64().is_some_and(|real| put(&mut self.site_radius, real)),
            "site-distance" => value.as_f64().is_some_and(|real| put(&mut self.site_distance, real)),
            "items" => put_whole(&mut self.items, value),
            "success-threshold" => value.as_f64().is_some_and(|real| put(&mut self.success_threshold, real)),
            "step-length" => value.as_f64().is_some_and(|real| put(&mut self.step_length, real)),
            "moves-per-step" => {
                put_word(&mut self.moves_per_step, &[MovesPerStep::One, MovesPerStep::Unlimited], value)
            }
            "sense-radius" => value.as_f64().is_some_and(|real| put(&mut self.sense_radius, real)),
            "explore-heading" => {
                put_word(&mut self.explore_heading, &[ExploreHeading::Uniform, ExploreHeading::Turning], value)
            }
            "turn-deviation" => value.as_f64().is_some_and(|real| put(&mut self.turn_deviation, real)),
            "drop-rule" => {
                put_word(&mut self.drop_rule, &[DropRule::Anywhere, DropRule::Sink, DropRule::OutsideHub], value)
            }
            "task" => put_word(&mut self.task, &[Task::Forage, Task::Nest], value),
            "sites" => put_whole(&mut self.sites, value),
            "boundary-radius" => value.as_f64().is_some_and(|real| put(&mut self.boundary_radius, real)),
            "item-placement" => {
                put_word(&mut self.item_placement, &[ItemPlacement::Scattered, ItemPlacement::Stacked], value)
            }
            "obstacles" => put_whole(&mut self.obstacles, value),
            "obstacle-radius" => value.as_f64().is_some_and(|real| put(&mut self.obstacle_radius, real)),
            "traps" => put_whole(&mut self.traps, value),
            "trap-radius" => value.as_f64().is_some_and(|real| put(&mut self.trap_radius, real)),
            "start-positions" => {
                put_word(&mut self.start_positions, &[StartPositions::Hub, StartPositions::Uniform], value)
            }
            "activation" => put_word(&mut self.activation, &[Activation::Shuffled, Activation::Index], value),
            "behaviours" => put_word(&mut self.behaviours, &[Behaviours::Ppa, Behaviours::Nominal], value),
            "look-ahead" => value.as_f64().is_some_and(|real| put(&mut self.look_ahead, real)),
            "fitness-diversity" => value.as_bool().is_some_and(|on| put(&mut self.fitness_diversity, on)),
            "fitness-exploration" => value.as_bool().is_some_and(|on| put(&mut self.fitness_exploration, on)),
            "fitness-prospective" => value.as_bool().is_some_and(|on| put(&mut self.fitness_prospective, on)),
            "fitness-task" => value.as_bool().is_some_and(|on| put(&mut self.fitness_task, on)),
            "fitness-feedback" => value.as_bool().is_some_and(|on| put(&mut self.fitness_feedback, on)),
            "is-dropable" => {
                put_word(&mut self.is_dropable, &[IsDropable::Always, IsDropable::Kind, IsDropable::Standing], value)
            }
            "genome-length" => put_whole(&mut self.genome_length, value),
            "codon-max" => put_whole(&mut self.codon_max, value),
            "max-depth" => put_whole(&mut self.max_depth, value),
            "max-wraps" => put_whole(&mut self.max_wraps, value),
            "grammar" => value.as_str().is_some_and(|text| put(&mut self.grammar, text.to_owned())),
            "interaction-probability" => {
                value.as_f64().is_some_and(|real| put(&mut self.interaction_probability, real))
            }
            "storage-threshold" => put_whole(&mut self.storage_threshold, value),
            "storage-content" => {
                put_word(&mut self.storage_content, &[StorageContent::Donors, StorageContent::Meetings], value)
            }
            "parent-selection" => {
                put_word(&mut self.parent_selection, &[ParentSelection::Truncation, ParentSelection::Tournament], value)
            }
            "parent-share" => value.as_f64().is_some_and(|real| put(&mut self.parent_share, real)),
            "tournament-size" => put_whole(&mut self.tournament_size, value),
            "elite-size" => put_whole(&mut self.elite_size, value),
            "children" => put_whole(&mut self.children, value),
            "genome-selection" => put_word(
                &mut self.genome_selection,
                &[
                    GenomeSelection::Diversity,
                    GenomeSelection::Tournament,
                    GenomeSelection::Random,
                    GenomeSelection::Fresh,
                ],
                value,
            ),
            "crossover-mode" => put_word(
                &mut self.crossover_mode,
                &[CrossoverMode::VariableOnePoint, CrossoverMode::FixedOnePoint],
                value,
            ),
            "crossover-probability" => value.as_f64().is_some_and(|real| put(&mut self.crossover_probability, real)),
            "mutation-mode" => put_word(&mut self.mutation_mode, &[MutationMode::Bit, MutationMode::Codon], value),
            "mutation-probability" => value.as_f64().is_some_and(|real| put(&mut self.mutation_probability, real)),
            "swap-rule" => {
                put_word(&mut self.swap_rule, &[SwapRule::Greater, SwapRule::NotSmaller, SwapRule::Always], value)
            }
            "fitness-memory" => value.as_f64().is_some_and(|real| put(&mut self.fitness_memory, real)),
            _ => self.set_population(name, value) || self.set_switch(name, value),
        }
    }

    /// Sets a field that concerns fixed programs.
    fn set_population(&mut self, name: &str, value: &Value) -> bool {
        match name {
            "evolution" => value.as_bool().is_some_and(|on| put(&mut self.evolution, on)),
            "learning-steps" => put_whole(&mut self.learning_steps, value),
            "dwell" => value.as_f64().is_some_and(|real| put(&mut self.dwell, real)),
            "population-form" => put_word(
                &mut self.population_form,
                &[
                    PopulationForm::AsSaved,
                    PopulationForm::Homogeneous,
                    PopulationForm::Heterogeneous,
                    PopulationForm::Blended,
                    PopulationForm::Multiplexed,
                    PopulationForm::Archive,
                ],
                value,
            ),
            "population-share" => value.as_f64().is_some_and(|real| put(&mut self.population_share, real)),
            "population" => value.as_str().is_some_and(|text| put(&mut self.population, text.to_owned())),
            _ => false,
        }
    }

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

pub fn put<T>(field: &mut T, value: T) -> bool {
    *field = value;
    true
}

pub fn put_whole<T: TryFrom<u64>>(field: &mut T, value: &Value) -> bool {
    value.as_u64().and_then(|whole| T::try_from(whole).ok()).is_some_and(|whole| put(field, whole))
}

/// Sets a field to the one of `all` that is written as `value`.
fn put_word<T: Copy + Serialize>(field: &mut T, all: &[T], value: &Value) -> bool {
    let found = all.iter().find(|word| serde_json::to_value(word).is_ok_and(|written| written == *value));
    found.is_some_and(|word| put(field, *word))
}
