//! The switches between the paper's text and the authors' published code; `profiles.rs` lists them row by row.

use super::params::{Params, put, put_whole, put_word};
use serde::Serialize;
use serde_json::Value;

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

impl Params {
    /// As [`Params::set`], for the switches of this file.
    pub fn set_switch(&mut self, name: &str, value: &Value) -> bool {
        match name {
            "site-placement" => put_word(&mut self.site_placement, &[SitePlacement::Ring, SitePlacement::Fixed], value),
            "nest-sink" => put_word(&mut self.nest_sink, &[NestSink::Ring, NestSink::Cells], value),
            "footprint" => put_word(&mut self.footprint, &[Footprint::Disc, Footprint::Cells], value),
            "edge-rule" => put_word(&mut self.edge_rule, &[EdgeRule::Clamp, EdgeRule::Bounce], value),
            "rounding" => put_word(&mut self.rounding, &[Rounding::None, Rounding::Nearest, Rounding::Truncate], value),
            "step-rule" => put_word(&mut self.step_rule, &[StepRule::Constant, StepRule::ByLoad], value),
            "avoid-rule" => put_word(&mut self.avoid_rule, &[AvoidRule::Tangent, AvoidRule::Box], value),
            "sensing" => put_word(&mut self.sensing, &[Sensing::Disc, Sensing::Cell], value),
            "initial-memory" => {
                put_word(&mut self.initial_memory, &[InitialMemory::All, InitialMemory::FirstBoundary], value)
            }
            "blackboard" => put_word(&mut self.blackboard, &[Blackboard::Private, Blackboard::Shared], value),
            "percept-wipe" => put_word(&mut self.percept_wipe, &[PerceptWipe::Tick, PerceptWipe::Sense], value),
            "moveaway-postcondition" => put_word(
                &mut self.moveaway_postcondition,
                &[MoveAwayPostcondition::NotSensed, MoveAwayPostcondition::Sensed],
                value,
            ),
            "drop-postcondition" => put_word(
                &mut self.drop_postcondition,
                &[DropPostcondition::NotCarrying, DropPostcondition::None],
                value,
            ),
            "population-pool" => {
                put_word(&mut self.population_pool, &[PopulationPool::Agents, PopulationPool::Programs], value)
            }
            "init" => put_word(&mut self.init, &[Init::RandomBits, Init::DerivationTree], value),
            "neighbours" => put_word(&mut self.neighbours, &[Neighbours::Radius, Neighbours::Cell], value),
            "storage-value" => put_word(&mut self.storage_value, &[StorageValue::Copied, StorageValue::Live], value),
            "stagnation" => put_whole(&mut self.stagnation, value),
            "own-in-pool" => value.as_bool().is_some_and(|on| put(&mut self.own_in_pool, on)),
            "elite-rank" => put_word(&mut self.elite_rank, &[EliteRank::Diversity, EliteRank::Fitness], value),
            "length-rule" => put_word(&mut self.length_rule, &[LengthRule::Cut, LengthRule::Redraw], value),
            "fitness" => put_word(&mut self.fitness, &[FitnessRule::Recurrence, FitnessRule::Delayed], value),
            "diversity" => put_word(&mut self.diversity, &[DiversityRule::Names, DiversityRule::Leaves], value),
            "exploration" => {
                put_word(&mut self.exploration, &[ExplorationRule::Squares, ExplorationRule::Cells], value)
            }
            "bt-feedback" => put_word(&mut self.bt_feedback, &[FeedbackRule::Tags, FeedbackRule::Selectors], value),
            _ => false,
        }
    }
}
