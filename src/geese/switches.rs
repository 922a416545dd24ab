//! The switches between the paper's text and the authors' published code; `profiles.rs` lists them row by row.
//!
//! Their words stand in the schema, in the order of the variants: derived writing and reading of so many small types would
//! make the wasm a tenth larger.

use super::params::{Params, put, put_whole};
use super::schema::switches;
use serde_json::{Map, Value};

/// The ground that a place takes up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Footprint {
    /// A disc.
    Disc,
    /// The lattice cell of its centre, with the cells around it for radii above 10.
    Cells,
}

/// What an agent senses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sensing {
    /// Places it stands in, items and agents within the sensing radius.
    Disc,
    /// All that is in its lattice cell.
    Cell,
}

/// Where the sites are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SitePlacement {
    /// At random angles, the site distance from the hub.
    Ring,
    /// Up and to the left by the site distance; further ones a quarter turn on each.
    Fixed,
}

/// Where debris belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NestSink {
    /// Anywhere outside the boundary circle.
    Ring,
    /// In five places just outside it; a sixth swallows debris unscored.
    Cells,
}

/// What happens at the edge of the arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeRule {
    /// The agent stays on the edge and turns round.
    Clamp,
    /// It is put back two units, and turns round once for each axis.
    Bounce,
}

/// Whether agents stand on whole coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Real coordinates.
    None,
    /// The nearest whole number, of two the even one.
    Nearest,
    /// The whole part.
    Truncate,
}

/// How far one step goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepRule {
    /// The step length.
    Constant,
    /// Half of it with a load.
    ByLoad,
}

/// How PPA behaviours get past what is ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AvoidRule {
    /// Along the tangent of the disc.
    Tangent,
    /// Along an edge of the bounding box.
    Box,
}

/// Which parts of the boundary agents know at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InitialMemory {
    /// All.
    All,
    /// The first of the places that take debris.
    FirstBoundary,
}

/// Whose percepts an agent acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blackboard {
    /// Its own.
    Private,
    /// Those of whoever sensed last.
    Shared,
}

/// When percepts are forgotten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PerceptWipe {
    /// At the start of each tick.
    Tick,
    /// With each look, and by nothing else.
    Sense,
}

/// When MoveAway is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveAwayPostcondition {
    /// When the place is not sensed.
    NotSensed,
    /// When it is, as in MoveTowards.
    Sensed,
}

/// What CompositeDrop returns without a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropPostcondition {
    /// SUCCESS.
    NotCarrying,
    /// FAILURE, after a look around.
    None,
}

/// Whom an agent meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Neighbours {
    /// The others within the sensing radius.
    Radius,
    /// All in its lattice cell and itself; at least two must remain.
    Cell,
}

/// What a stored genome is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StorageValue {
    /// The fitness its donor had when it was taken.
    Copied,
    /// The fitness its donor has with it now, or had last.
    Live,
}

/// What the elite is compared with children by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EliteRank {
    /// Diversity, as children are.
    Diversity,
    /// Fitness.
    Fitness,
}

/// What happens to children that are too long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthRule {
    /// They lose their end.
    Cut,
    /// The pair is dropped and two parents are drawn again.
    Redraw,
}

/// How genomes are made at the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Init {
    /// Random codons, drawn again until they map to a program.
    RandomBits,
    /// The codons of a random derivation, and half as many random ones behind them.
    DerivationTree,
}

/// What run-time fitness remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitnessRule {
    /// A share of itself in the step before.
    Recurrence,
    /// A share of the last fitness of the program before.
    Delayed,
}

/// How diversity is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiversityRule {
    /// Names in the program over names in the grammar.
    Names,
    /// Names of a list of nine, with less for programs of many leaves.
    Leaves,
}

/// What exploration counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExplorationRule {
    /// Unit squares.
    Squares,
    /// Lattice cells beyond the first.
    Cells,
}

/// Which statuses feedback counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedbackRule {
    /// Of postconditions, constraints and a selector at the root.
    Tags,
    /// Of every selector.
    Selectors,
}

/// What the fittest of a saved population are chosen from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PopulationPool {
    /// The agents.
    Agents,
    /// The different programs.
    Programs,
}

impl Params {
    /// As [`Params::set`], for the switches of this file and the two numbers beside them.
    pub fn set_switch(&mut self, name: &str, value: &Value) -> bool {
        let word = value.as_str().unwrap_or_default();
        let choices = switches().find(|switch| switch.0 == name).map_or(&[][..], |switch| switch.1);
        let at = choices.iter().position(|choice| choice.0 == word);
        match name {
            "stagnation" => put_whole(&mut self.stagnation, value),
            "own-in-pool" => value.as_bool().is_some_and(|on| put(&mut self.own_in_pool, on)),
            "site-placement" => pick(&mut self.site_placement, &[SitePlacement::Ring, SitePlacement::Fixed], at),
            "nest-sink" => pick(&mut self.nest_sink, &[NestSink::Ring, NestSink::Cells], at),
            "footprint" => pick(&mut self.footprint, &[Footprint::Disc, Footprint::Cells], at),
            "edge-rule" => pick(&mut self.edge_rule, &[EdgeRule::Clamp, EdgeRule::Bounce], at),
            "rounding" => pick(&mut self.rounding, &[Rounding::None, Rounding::Nearest, Rounding::Truncate], at),
            "step-rule" => pick(&mut self.step_rule, &[StepRule::Constant, StepRule::ByLoad], at),
            "avoid-rule" => pick(&mut self.avoid_rule, &[AvoidRule::Tangent, AvoidRule::Box], at),
            "sensing" => pick(&mut self.sensing, &[Sensing::Disc, Sensing::Cell], at),
            "initial-memory" => pick(&mut self.initial_memory, &[InitialMemory::All, InitialMemory::FirstBoundary], at),
            "blackboard" => pick(&mut self.blackboard, &[Blackboard::Private, Blackboard::Shared], at),
            "percept-wipe" => pick(&mut self.percept_wipe, &[PerceptWipe::Tick, PerceptWipe::Sense], at),
            "moveaway-postcondition" => pick(
                &mut self.moveaway_postcondition,
                &[MoveAwayPostcondition::NotSensed, MoveAwayPostcondition::Sensed],
                at,
            ),
            "drop-postcondition" => {
                pick(&mut self.drop_postcondition, &[DropPostcondition::NotCarrying, DropPostcondition::None], at)
            }
            "population-pool" => {
                pick(&mut self.population_pool, &[PopulationPool::Agents, PopulationPool::Programs], at)
            }
            "init" => pick(&mut self.init, &[Init::RandomBits, Init::DerivationTree], at),
            "neighbours" => pick(&mut self.neighbours, &[Neighbours::Radius, Neighbours::Cell], at),
            "storage-value" => pick(&mut self.storage_value, &[StorageValue::Copied, StorageValue::Live], at),
            "elite-rank" => pick(&mut self.elite_rank, &[EliteRank::Diversity, EliteRank::Fitness], at),
            "length-rule" => pick(&mut self.length_rule, &[LengthRule::Cut, LengthRule::Redraw], at),
            "fitness" => pick(&mut self.fitness, &[FitnessRule::Recurrence, FitnessRule::Delayed], at),
            "diversity" => pick(&mut self.diversity, &[DiversityRule::Names, DiversityRule::Leaves], at),
            "exploration" => pick(&mut self.exploration, &[ExplorationRule::Squares, ExplorationRule::Cells], at),
            "bt-feedback" => pick(&mut self.bt_feedback, &[FeedbackRule::Tags, FeedbackRule::Selectors], at),
            _ => false,
        }
    }

    /// Every parameter by its name, in the form that [`Params::set`] takes.
    #[must_use]
    pub fn fields(&self) -> Map<String, Value> {
        let Ok(Value::Object(mut fields)) = serde_json::to_value(self) else { return Map::new() };
        // In the order of the schema.
        let chosen = [
            self.footprint as u8,
            self.site_placement as u8,
            self.nest_sink as u8,
            self.edge_rule as u8,
            self.rounding as u8,
            self.step_rule as u8,
            self.sensing as u8,
            self.avoid_rule as u8,
            self.initial_memory as u8,
            self.percept_wipe as u8,
            self.blackboard as u8,
            self.moveaway_postcondition as u8,
            self.drop_postcondition as u8,
            self.neighbours as u8,
            self.storage_value as u8,
            self.elite_rank as u8,
            self.length_rule as u8,
            self.fitness as u8,
            self.diversity as u8,
            self.exploration as u8,
            self.bt_feedback as u8,
            self.population_pool as u8,
            self.init as u8,
        ];
        for ((name, choices), chosen) in switches().zip(chosen) {
            fields.insert(name.to_owned(), Value::from(choices[usize::from(chosen)].0));
        }
        fields
    }
}

/// Sets a field to the one of `all` at a place.
fn pick<T: Copy>(field: &mut T, all: &[T], at: Option<usize>) -> bool {
    at.and_then(|at| all.get(at)).is_some_and(|word| put(field, *word))
}
