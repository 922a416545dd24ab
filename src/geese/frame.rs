//! One frame as a flat buffer of reals: what the page draws, and nothing else.

use super::field::{Disc, ItemState};
use super::leaf::{Leaf, Name, Object, Takes};
use super::params::Task;
use super::world::World;
use serde::Serialize;

/// What stands where in a frame; made once for a world.
#[derive(Clone, Debug, Serialize)]
pub struct Layout {
    /// Reals in a frame.
    pub length: usize,
    counts: Block,
    agents: Block,
    items: Block,
    actions: Vec<String>,
    arena: Arena,
    /// What is carried: food or debris.
    item: &'static str,
    places: Vec<Place>,
}

#[derive(Clone, Debug, Serialize)]
struct Block {
    offset: usize,
    stride: usize,
    count: usize,
    fields: &'static [&'static str],
}

#[derive(Clone, Debug, Serialize)]
struct Arena {
    half: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Place {
    kind: &'static str,
    x: f64,
    y: f64,
    radius: f64,
    /// Lower left and upper right corner where places are cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    square: Option<[[f64; 2]; 2]>,
}

const COUNTS: &[&str] = &["tick", "delivered", "carried", "free", "items", "programs", "swaps", "alive"];
const AGENT: &[&str] = &["x", "y", "heading", "carrying", "action", "alive"];
const ITEM: &[&str] = &["x", "y", "state"];

/// Every action with each argument it takes; the frame's `action` is an index into "none" and these.
fn actions() -> impl Iterator<Item = (Name, Object)> {
    Name::ALL.into_iter().filter(|name| name.is_action()).flat_map(|name| {
        let objects: &[Object] = match name.takes() {
            Takes::Nothing => &[Object::Nothing],
            Takes::Place => &Object::PLACES,
            Takes::Item => &Object::ITEMS,
            Takes::Object => &Object::ALL,
        };
        objects.iter().map(move |&object| (name, object))
    })
}

impl Layout {
    /// The layout of the frames of `world`.
    #[must_use]
    pub fn of(world: &World) -> Self {
        let block =
            |offset, count, fields: &'static [&'static str]| Block { offset, stride: fields.len(), count, fields };
        let counts = block(0, 1, COUNTS);
        let agents = block(COUNTS.len(), world.params().agents as usize, AGENT);
        let items = block(agents.offset + agents.count * agents.stride, world.params().item_count() as usize, ITEM);
        let field = &world.state().field;
        let ring = [field.inside];
        let is_ring = field.task == Task::Nest && field.sinks.is_empty();
        let groups: [(_, &[Disc]); 6] = [
            ("hub", &[field.hub]),
            ("boundary", if is_ring { &ring } else { &[] }),
            ("boundary", &field.sinks),
            ("site", &field.sites),
            ("obstacle", &field.obstacles),
            ("trap", &field.traps),
        ];
        let mut places = Vec::new();
        for (kind, discs) in groups {
            for disc in discs {
                let ([x, y], is_circle) = (disc.centre, is_ring && kind == "boundary");
                let square = if is_circle { None } else { field.lattice.square(disc) };
                places.push(Place { kind, x, y, radius: disc.radius, square });
            }
        }
        let names = actions().map(|(name, object)| {
            let gap = if object == Object::Nothing { "" } else { " " };
            format!("{}{gap}{}", name.text(), object.text())
        });
        Self {
            length: items.offset + items.count * items.stride,
            counts,
            agents,
            items,
            actions: std::iter::once("none".to_owned()).chain(names).collect(),
            arena: Arena { half: field.half },
            item: match field.task {
                Task::Forage => "food",
                Task::Nest => "debris",
            },
            places,
        }
    }
}

/// Fills `frame` with the present state, as [`Layout::of`] says; its length becomes the layout's.
///
/// Values are `f32`: good for drawing, not for continuing the run.
pub fn fill_frame(world: &World, frame: &mut Vec<f32>) {
    let state = world.state();
    let field = &state.field;
    let items = world.params().item_count();
    let (delivered, carried) = (field.delivered(), field.carried());
    frame.clear();
    frame.extend(
        [
            state.tick,
            delivered,
            carried,
            items - delivered - carried - field.lost(),
            items,
            state.program_count(),
            state.swaps,
            state.alive,
        ]
        .map(|count| count as f32),
    );
    for (id, body) in state.bodies.iter().enumerate() {
        let [x, y] = field.agents.point(id as u32);
        let heading = libm::atan2(body.heading[1], body.heading[0]);
        let carrying = if body.load.is_some() { 1.0 } else { 0.0 };
        let alive = if body.alive { 1.0 } else { 0.0 };
        frame.extend([x as f32, y as f32, heading as f32, carrying, action_number(body.last_action), alive]);
    }
    let from = frame.len();
    for (id, item) in field.item_states().iter().enumerate() {
        let [x, y] = field.items.point(id as u32);
        frame.extend([x as f32, y as f32, f32::from(*item as u8)]);
    }
    // A carried item is where its carrier is.
    for (id, body) in state.bodies.iter().enumerate() {
        if let Some(item) = body.load {
            let at = from + item as usize * ITEM.len();
            let [x, y] = field.agents.point(id as u32);
            (frame[at], frame[at + 1]) = (x as f32, y as f32);
        }
    }
    debug_assert!(field.item_states().iter().filter(|&&state| state == ItemState::Carried).count() == carried as usize);
}

fn action_number(action: Option<Leaf>) -> f32 {
    let found = action.and_then(|leaf| actions().position(|action| action == (leaf.name, leaf.object)));
    found.map_or(0.0, |index| index as f32 + 1.0)
}
