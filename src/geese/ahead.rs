//! Reading ahead in the memory, so that what agents need is near the processor when their turn comes.
//!
//! In a crowd nothing of an agent is near when its turn comes, and one piece after the other would be waited for. The order
//! of the turns is known, so the pieces of later agents are called for while the present one acts: first what lies in the
//! arrays, and when that has come, what it points to. Nothing but the time depends on it.

use super::body::Body;
use super::controller::{Controller, Planted};
use super::mind::Mind;
use super::world::State;
use std::mem::offset_of;

/// From so many agents on, their states are more than the near memories of usual processors hold.
const CROWD: usize = 500;

/// Bytes of a line, the piece in which processors read memory.
const LINE: usize = 64;

/// How many turns ahead each piece is called for.
const ARRAYS: usize = 8;
const POINTED: usize = 4;

/// How many programs ahead the memory of those to be taken up is called for.
const TAKEN_UP: usize = 3;

/// Whether so many agents are worth it. WebAssembly has no instruction to call for memory.
pub fn reads_ahead(agents: usize) -> bool {
    cfg!(not(target_arch = "wasm32")) && agents >= CROWD
}

/// Calls for a value; it is not read.
#[inline]
pub fn call_for<T>(value: &T) {
    call_for_place(std::slice::from_ref(value), 0);
}

/// Calls for a place of a list, which may be beyond its end.
#[inline]
pub fn call_for_place<T>(list: &[T], place: usize) {
    #[cfg(not(target_arch = "wasm32"))]
    prefetch_index::prefetch_index(list, place);
    #[cfg(target_arch = "wasm32")]
    let _ = (list, place);
}

/// Calls for a whole list.
pub fn call_for_all<T>(list: &[T]) {
    (0..list.len()).step_by((LINE / size_of::<T>()).max(1)).for_each(|place| call_for_place(list, place));
}

fn call_for_tree(Planted { tree, trace }: &Planted) {
    call_for_all(tree.nodes());
    call_for_all(trace);
}

impl State {
    /// Calls for the memory of the programs that will be taken up next.
    pub(super) fn call_for_replaced(&self) {
        if !reads_ahead(self.order.len()) {
            return;
        }
        if let Some(Controller::Tree(planted)) = self.replaced.next(TAKEN_UP).map(|program| &program.controller) {
            call_for_tree(planted);
        }
    }

    /// Calls for what the agents after that turn will need.
    ///
    /// - `radius`: within which they sense.
    #[inline(never)]
    pub(super) fn read_ahead(&self, turn: usize, radius: f64) {
        if let Some(&agent) = self.order.get(turn + ARRAYS) {
            let Body { heading, last_action, .. } = &self.bodies[agent as usize];
            call_for(heading);
            call_for(last_action);
            call_for_place(&self.offers, agent as usize);
            self.field.agents.call_for(agent);
            // Its first field stands at the start of a line.
            let since = std::slice::from_ref(&self.minds[agent as usize].since);
            (0..offset_of!(Mind, last)).step_by(LINE).for_each(|at| call_for_place(since, at / size_of::<u32>()));
        }
        if let Some(&agent) = self.order.get(turn + POINTED) {
            let mind = &self.minds[agent as usize];
            if let Controller::Tree(planted) = &mind.program.controller {
                call_for_tree(planted);
            }
            call_for_all(mind.storage.entries());
            let place = self.field.agents.point(agent);
            self.field.agents.call_for_cells(place, radius);
        }
    }
}
