//! What is measured of the foraging swarm.

use super::Form;
use crate::geese::Measure;
use crate::scenario::{Outcome, Run};

/// A number that a run of the foraging swarm gives; each is described once, by its help text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Foraging {
    Share,
    Delivered,
    Success,
    Steps,
    StepsTo50,
    StepsTo80,
    Carrying,
    Alive,
    DistinctPrograms,
    SwapsPerAgentStep,
    ActionsPerProgram,
    ProgramsWith1Action,
    ProgramsWith2Actions,
    ProgramsWith3Actions,
    ProgramsWith4OrMore,
    InertShare,
    MeanDiversity,
    MeanFitness,
    MeanGenomeLength,
}

impl Foraging {
    /// Every metric, in the order of the documentation, with the name it has in studies and results.
    pub const ALL: [(&'static str, Self); 19] = [
        ("share", Self::Share),
        ("delivered", Self::Delivered),
        ("success", Self::Success),
        ("steps", Self::Steps),
        ("steps_to_50", Self::StepsTo50),
        ("steps_to_80", Self::StepsTo80),
        ("carrying", Self::Carrying),
        ("alive", Self::Alive),
        ("distinct_programs", Self::DistinctPrograms),
        ("swaps_per_agent_step", Self::SwapsPerAgentStep),
        ("actions_per_program", Self::ActionsPerProgram),
        ("programs_with_1_action", Self::ProgramsWith1Action),
        ("programs_with_2_actions", Self::ProgramsWith2Actions),
        ("programs_with_3_actions", Self::ProgramsWith3Actions),
        ("programs_with_4_or_more_actions", Self::ProgramsWith4OrMore),
        ("inert_share", Self::InertShare),
        ("mean_diversity", Self::MeanDiversity),
        ("mean_fitness", Self::MeanFitness),
        ("mean_genome_length", Self::MeanGenomeLength),
    ];

    /// The name in studies and results.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }

    /// The name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Share => "Items delivered",
            Self::Delivered => "Items delivered, count",
            Self::Success => "Success",
            Self::Steps => "Steps made",
            Self::StepsTo50 => "Steps to 50 %",
            Self::StepsTo80 => "Steps to 80 %",
            Self::Carrying => "Items carried",
            Self::Alive => "Robots alive",
            Self::DistinctPrograms => "Distinct programs",
            Self::SwapsPerAgentStep => "Swaps per robot and step",
            Self::ActionsPerProgram => "Actions per program",
            Self::ProgramsWith1Action => "Programs with one action",
            Self::ProgramsWith2Actions => "Programs with two actions",
            Self::ProgramsWith3Actions => "Programs with three actions",
            Self::ProgramsWith4OrMore => "Programs with four or more actions",
            Self::InertShare => "Inert robots",
            Self::MeanDiversity => "Diversity",
            Self::MeanFitness => "Fitness",
            Self::MeanGenomeLength => "Genome length",
        }
    }

    /// What is measured, in one sentence.
    pub fn help(self) -> &'static str {
        match self {
            Self::Share => "Share of the items delivered when the run ended.",
            Self::Delivered => "Number of items delivered when the run ended.",
            Self::Success => "1 when the share of items delivered is above the success threshold, else 0.",
            Self::Steps => "Steps made until the run ended.",
            Self::StepsTo50 => "The first step after which half of the items were delivered; empty when never.",
            Self::StepsTo80 => "The first step after which 80 % of the items were delivered; empty when never.",
            Self::Carrying => "Items carried when the run ended.",
            Self::Alive => "Robots that had touched no trap when the run ended.",
            Self::DistinctPrograms => "Distinct programs that the robots ran in the last step.",
            Self::SwapsPerAgentStep => "Programs replaced during the run, over robots and steps.",
            Self::ActionsPerProgram => "Action leaves, mean over the distinct programs of the last step.",
            Self::ProgramsWith1Action => "Share of the distinct programs of the last step with one action leaf.",
            Self::ProgramsWith2Actions => "Share of the distinct programs of the last step with two action leaves.",
            Self::ProgramsWith3Actions => "Share of the distinct programs of the last step with three action leaves.",
            Self::ProgramsWith4OrMore => {
                "Share of the distinct programs of the last step with four or more action leaves."
            }
            Self::InertShare => "Share of the robots whose program could never run an action, whatever they sensed.",
            Self::MeanDiversity => "Diversity D, mean over the robots.",
            Self::MeanFitness => "Run-time fitness A, mean over the robots.",
            Self::MeanGenomeLength => "Codons of the genome, mean over the robots.",
        }
    }

    /// What numbers it can be.
    pub fn form(self) -> Form {
        match self {
            Self::Success => Form::Flag,
            Self::Share
            | Self::ProgramsWith1Action
            | Self::ProgramsWith2Actions
            | Self::ProgramsWith3Actions
            | Self::ProgramsWith4OrMore
            | Self::InertShare
            | Self::MeanDiversity => Form::Share,
            Self::Delivered
            | Self::Steps
            | Self::StepsTo50
            | Self::StepsTo80
            | Self::Carrying
            | Self::Alive
            | Self::DistinctPrograms
            | Self::SwapsPerAgentStep
            | Self::ActionsPerProgram
            | Self::MeanFitness
            | Self::MeanGenomeLength => Form::Number,
        }
    }

    /// Whether nothing that can still happen in the run changes it.
    pub fn is_settled(self, run: &Run, reached: &Reached) -> bool {
        match self {
            // Items that were delivered stay delivered; only an event could move the threshold.
            Self::Success => run.scenario().events.is_empty() && outcome(run).is_some_and(|outcome| outcome.success),
            Self::StepsTo50 => reached.half.is_some(),
            Self::StepsTo80 => reached.most.is_some(),
            Self::Share
            | Self::Delivered
            | Self::Steps
            | Self::Carrying
            | Self::Alive
            | Self::DistinctPrograms
            | Self::SwapsPerAgentStep
            | Self::ActionsPerProgram
            | Self::ProgramsWith1Action
            | Self::ProgramsWith2Actions
            | Self::ProgramsWith3Actions
            | Self::ProgramsWith4OrMore
            | Self::InertShare
            | Self::MeanDiversity
            | Self::MeanFitness
            | Self::MeanGenomeLength => false,
        }
    }

    /// Its value in a run as it stands.
    pub fn of(self, run: &Run, measure: &Measure, reached: &Reached) -> Option<f64> {
        let outcome = outcome(run)?;
        Some(match self {
            Self::Share => outcome.share,
            Self::Delivered => f64::from(outcome.delivered),
            Self::Success => f64::from(u8::from(outcome.success)),
            Self::Steps => f64::from(run.tick()),
            Self::StepsTo50 => f64::from(reached.half?),
            Self::StepsTo80 => f64::from(reached.most?),
            Self::Carrying => f64::from(measure.carrying),
            Self::Alive => f64::from(measure.alive),
            Self::DistinctPrograms => f64::from(measure.programs),
            Self::SwapsPerAgentStep => measure.swaps_per_agent_step,
            Self::ActionsPerProgram => measure.actions,
            Self::ProgramsWith1Action => measure.by_actions[0],
            Self::ProgramsWith2Actions => measure.by_actions[1],
            Self::ProgramsWith3Actions => measure.by_actions[2],
            Self::ProgramsWith4OrMore => measure.by_actions[3],
            Self::InertShare => measure.inert,
            Self::MeanDiversity => measure.diversity,
            Self::MeanFitness => measure.fitness,
            Self::MeanGenomeLength => measure.genome_length,
        })
    }
}

/// The steps after which half, and 80 %, of the items were delivered.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reached {
    half: Option<u32>,
    most: Option<u32>,
}

impl Reached {
    /// Takes note of a run as it stands.
    pub fn note(&mut self, run: &Run) {
        let (share, tick) = (outcome(run).map_or(0.0, |outcome| outcome.share), run.tick());
        self.half = self.half.or((share >= 0.5).then_some(tick));
        self.most = self.most.or((share >= 0.8).then_some(tick));
    }
}

/// The outcome of the foraging swarm, if that is what runs.
fn outcome(run: &Run) -> Option<crate::geese::Outcome> {
    match run.outcome() {
        Outcome::Geese(outcome) => Some(outcome),
        #[cfg(feature = "sequencing")]
        Outcome::Sequencing(_) => None,
        #[cfg(feature = "soccer")]
        Outcome::Soccer(_) => None,
    }
}
