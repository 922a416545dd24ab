//! The open list: entries in the order of their insertion, and one or two heaps of their keys.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A sequence that may still be extended: a simulated node, or one with a behaviour that was not simulated yet.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Cost and rest, true ones for a node, guessed ones for a behaviour not yet simulated.
    pub cost: f64,
    /// See `cost`.
    pub rest: f64,
    /// Never more than what a completion costs in all.
    pub bound: f64,
    /// The second queue's estimate of the rest.
    pub second: f64,
    /// The node.
    pub node: u32,
    /// The behaviour to simulate from there, or [`NONE`].
    pub behaviour: u8,
    /// Behaviours in the sequence, the one to simulate included.
    pub depth: u16,
    /// Whether it was taken.
    gone: bool,
}

/// No behaviour.
pub const NONE: u8 = u8::MAX;

impl Entry {
    /// An entry that was not taken yet.
    #[must_use]
    pub fn new(node: u32, behaviour: u8, depth: u16, [cost, rest, bound, second]: [f64; 4]) -> Self {
        Self { cost, rest, bound, second, node, behaviour, depth, gone: false }
    }

    /// Its place in the queue at weight w: c + w H of eq. (10), and never above w times its bound.
    ///
    /// A node's true cost and rest are below that anyway. A guess may be arbitrarily wrong; clamped, it keeps the
    /// promise: on the cheapest sequence there is always an open entry whose key is at most w times its cost.
    #[must_use]
    pub fn key(&self, weight: f64) -> f64 {
        (self.cost + weight * self.rest).min(weight * self.bound)
    }
}

/// A key and whose it is. The greatest is taken first: smaller key, then deeper, then inserted earlier.
#[derive(Clone, Copy, Debug)]
struct Item {
    key: f64,
    depth: u16,
    id: u32,
}

impl Ord for Item {
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key).then(self.depth.cmp(&other.depth)).then(other.id.cmp(&self.id))
    }
}

impl PartialOrd for Item {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Item {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Item {}

/// One of the heaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heap {
    /// By the key of the weight.
    Anchor,
    /// By the cost and the second estimate.
    Second,
    /// By the bound.
    Bound,
}

/// Which heaps there are besides the anchor.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sides {
    /// [`Heap::Second`].
    pub second: bool,
    /// [`Heap::Bound`].
    pub bound: bool,
}

/// The open list.
#[derive(Clone, Debug)]
pub struct Queue {
    entries: Vec<Entry>,
    anchor: BinaryHeap<Item>,
    /// Ordered by c plus the second estimate; stays empty where nobody takes from it.
    second: BinaryHeap<Item>,
    /// Ordered by the bound; likewise.
    by_bound: BinaryHeap<Item>,
    sides: Sides,
    /// Ties by insertion alone, as in the literal algorithm.
    first_in_first_out: bool,
    weight: f64,
    open: usize,
    peak: usize,
}

impl Queue {
    /// An empty list.
    #[must_use]
    pub fn new(weight: f64, sides: Sides, first_in_first_out: bool) -> Self {
        let [anchor, second, by_bound] = [const { BinaryHeap::new() }; 3];
        Self { entries: Vec::new(), anchor, second, by_bound, sides, first_in_first_out, weight, open: 0, peak: 0 }
    }

    /// How many entries are open.
    #[must_use]
    pub fn open(&self) -> usize {
        self.open
    }

    /// How many were open when they were most.
    #[must_use]
    pub fn peak(&self) -> usize {
        self.peak
    }

    /// Bytes taken, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let items = self.anchor.len() + self.second.len() + self.by_bound.len();
        self.entries.len() * size_of::<Entry>() + items * size_of::<Item>()
    }

    /// Adds an entry.
    pub fn push(&mut self, entry: Entry) {
        let id = self.entries.len() as u32;
        let item = self.item(id, &entry, entry.key(self.weight));
        self.anchor.push(item);
        if self.sides.second {
            self.second.push(self.item(id, &entry, entry.cost + entry.second));
        }
        if self.sides.bound {
            self.by_bound.push(self.item(id, &entry, entry.bound));
        }
        self.entries.push(entry);
        self.open += 1;
        self.peak = self.peak.max(self.open);
    }

    fn item(&self, id: u32, entry: &Entry, key: f64) -> Item {
        Item { key, depth: if self.first_in_first_out { 0 } else { entry.depth }, id }
    }

    fn heap(&mut self, heap: Heap) -> &mut BinaryHeap<Item> {
        match heap {
            Heap::Anchor => &mut self.anchor,
            Heap::Second => &mut self.second,
            Heap::Bound => &mut self.by_bound,
        }
    }

    /// The smallest key of a heap; `None` when nothing is open, or there is no such heap.
    pub fn least(&mut self, heap: Heap) -> Option<f64> {
        loop {
            let item = *self.heap(heap).peek()?;
            if !self.entries[item.id as usize].gone {
                return Some(item.key);
            }
            self.heap(heap).pop();
        }
    }

    /// Takes the first entry of a heap out of all.
    pub fn pop(&mut self, heap: Heap) -> Option<Entry> {
        loop {
            let item = self.heap(heap).pop()?;
            let entry = &mut self.entries[item.id as usize];
            if !entry.gone {
                entry.gone = true;
                self.open -= 1;
                return Some(*entry);
            }
        }
    }

    /// Orders the anchor anew for another weight.
    pub fn set_weight(&mut self, weight: f64) {
        self.weight = weight;
        let entries = self.entries.iter().enumerate().filter(|entry| !entry.1.gone);
        self.anchor = entries.map(|(id, entry)| self.item(id as u32, entry, entry.key(weight))).collect();
    }

    /// The least bound of all open entries; infinite without any.
    #[must_use]
    pub fn bound(&self) -> f64 {
        let open = self.anchor.iter().map(|item| &self.entries[item.id as usize]).filter(|entry| !entry.gone);
        open.map(|entry| entry.bound).fold(f64::INFINITY, f64::min)
    }

    /// Every open entry, in no particular but a fixed order.
    pub fn each(&self) -> impl Iterator<Item = &Entry> {
        self.anchor.iter().map(|item| &self.entries[item.id as usize]).filter(|entry| !entry.gone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_go_to_the_deeper_and_then_to_the_earlier() {
        let mut queue = Queue::new(1.0, Sides::default(), false);
        for (node, depth, cost) in [(0, 1, 5.0), (1, 2, 5.0), (2, 2, 5.0), (3, 0, 4.0)] {
            queue.push(Entry::new(node, NONE, depth, [cost, 0.0, cost, 0.0]));
        }
        let order: Vec<u32> = std::iter::from_fn(|| queue.pop(Heap::Anchor)).map(|entry| entry.node).collect();
        assert_eq!(order, [3, 1, 2, 0]);
    }

    #[test]
    fn what_one_heap_gave_the_other_does_not_give_again() {
        let mut queue = Queue::new(1.0, Sides { second: true, bound: true }, false);
        queue.push(Entry::new(0, NONE, 1, [1.0, 9.0, 10.0, 0.0]));
        queue.push(Entry::new(1, NONE, 1, [1.0, 2.0, 3.0, 50.0]));
        assert_eq!(queue.least(Heap::Bound), Some(3.0));
        assert_eq!(queue.pop(Heap::Second).map(|entry| entry.node), Some(0));
        assert_eq!(queue.pop(Heap::Anchor).map(|entry| entry.node), Some(1));
        assert_eq!((queue.least(Heap::Second), queue.least(Heap::Bound)), (None, None));
        assert_eq!(queue.open(), 0);
    }
}
