//! A tree ticked as fast as it goes, with nobody looking: for measuring.

use super::leaves::{LeafNames, Leaves};
use super::setup::{Answer, EventKind, Mode, Setup};
use super::variants::understand;
use crate::bt::xml::Problem;
use crate::bt::{Memory, Silent, Status, TickError, compile, pass_time, tick_exactly_once, tick_once};
use crate::fingerprint::Fingerprint;

/// What came of ticking a tree without a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Headless {
    /// Ticks in which the root completed.
    pub completed: u32,
    /// Of the tree's state behind the last tick, and of what the root returned.
    pub fingerprint: u64,
}

/// Ticks a setup's tree and keeps nothing; of its script only what happens before the first tick counts.
///
/// # Errors
/// The faults of the document.
pub fn tick_headless(setup: &Setup, ticks: u32) -> Result<Headless, Vec<Problem>> {
    let (document, manifest, _) = understand(&setup.xml)?;
    let tree = compile(&document, &manifest)?;
    let names = LeafNames::of(&tree);
    let mut memory = Memory::for_tree(&tree);
    let mut answers = vec![Answer::default(); names.names.len()];
    for event in setup.script.iter().filter(|event| event.tick == 0) {
        if let EventKind::Answer(leaf, answer) = &event.kind
            && let Some(index) = names.find(leaf)
        {
            answers[index] = answer.clone();
        }
    }
    let mut progress = vec![None; tree.nodes().len()];
    let mut leaves = Leaves { names: &names, answers: &answers, progress: &mut progress, fault: None };
    let (mut completed, mut errors) = (0, 0);
    for _ in 0..ticks {
        let waited = pass_time(&tree, &mut memory, &mut leaves, &mut Silent, setup.ms);
        let status: Result<Status, TickError> = match setup.mode {
            Mode::Once => tick_once(&tree, &mut memory, &mut leaves, &mut Silent),
            Mode::ExactlyOnce => tick_exactly_once(&tree, &mut memory, &mut leaves, &mut Silent),
        };
        match waited.and(status) {
            Ok(status) => completed += u32::from(status.is_completed()),
            Err(_) => errors += 1,
        }
    }
    let mut hash = Fingerprint::default();
    memory.hash_into(&mut hash);
    hash.u32(completed);
    hash.u32(errors);
    Ok(Headless { completed, fingerprint: hash.finish() })
}
