//! The grid world in which a swarm forages while each agent evolves its own behaviour tree (BeTr-GEESE).
//!
//! The family's first algorithm, GEESE, evolved state machines: a controller is a tree or a machine, by what the grammar
//! writes.
//!
//! Paper: BeTr-GEESE, Cells2Societies workshop, ICLR 2022. Each agent carries a genome; a grammar maps it to a tree;
//! agents that meet exchange genomes; one with enough of them breeds and takes up the most diverse child.
//!
//! Where the paper is silent, the choice stands in the doc comment of the code that makes it and in the `source` of
//! the parameter that changes it. `profiles.rs` sets the paper's text beside the authors' published code, row by row.

mod ahead;
mod archive;
mod body;
mod breeding;
mod brood;
mod choices;
mod controller;
mod derive;
mod export;
mod field;
mod frame;
mod genomes;
mod grammars;
mod grid;
mod inspect;
mod language;
mod lattice;
mod leaf;
mod learning;
mod machine;
mod measure;
mod mind;
mod near;
mod outcome;
mod params;
mod population;
mod profiles;
mod program;
mod rules;
mod schema;
mod showmachine;
mod switches;
mod variety;
mod visited;
mod words;
mod world;

pub use controller::{Controller, Planted};
pub use derive::{Derived, DerivedStep};
pub use export::{export_agent, export_query, write_rules, write_xml};
pub use frame::{Layout, fill_frame};
pub use grammars::grammar_text;
pub use inspect::{Detail, Query};
pub use language::LanguageError;
pub use leaf::{Leaf, Manner, Name, Object, Tag, Takes};
pub use machine::{Machine, Rule, Setting};
pub use measure::{Measure, is_inert};
pub use outcome::{Finished, Outcome, Sample};
pub use params::{
    Activation, Behaviours, CrossoverMode, DropRule, ExploreHeading, GenomeSelection, IsDropable, ItemPlacement,
    MovesPerStep, MutationMode, Params, ParentSelection, PopulationForm, StartPositions, StorageContent, SwapRule,
    Task,
};
pub use population::{Dealt, Member, Population};
pub use program::{Compiler, CompilerError, Survey, program_text};
pub use schema::parameters;
pub use switches::{
    AvoidRule, Blackboard, DiversityRule, DropPostcondition, EdgeRule, EliteRank, ExplorationRule, FeedbackRule,
    FitnessRule, Footprint, Init, InitialMemory, LengthRule, MoveAwayPostcondition, Neighbours, NestSink, PerceptWipe,
    PopulationPool, Rounding, Sensing, SitePlacement, StepRule, StorageValue,
};
pub use world::{SAMPLE_EVERY, State, World};
