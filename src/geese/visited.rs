//! The unit squares of the arena that an agent has visited.

/// A set of squares that remembers the order of the first visits.
///
/// Programs live for a few steps, so the set is small whatever the arena. The first squares lie in the set itself, where a
/// crowd's agents find them without another access to memory.
#[derive(Clone, Debug)]
pub struct Visited {
    side: u32,
    count: u32,
    /// The squares while they are few.
    few: [u32; FEW],
    /// All squares, once they are more; its memory is kept for the next time.
    many: Option<Box<Many>>,
}

const FEW: usize = 16;

impl Visited {
    /// None visited yet; the arena has `side` squares along each side.
    #[must_use]
    pub fn new(side: u32) -> Self {
        Self { side, count: 0, few: [0; FEW], many: None }
    }

    /// Marks the square of a point of the arena `[-side / 2, side / 2]` squared.
    pub fn mark(&mut self, point: [f64; 2]) {
        let [column, row] = point.map(|value| ((value + f64::from(self.side) / 2.0) as u32).min(self.side - 1));
        self.mark_square(row * self.side + column);
    }

    /// Marks a square by its number.
    pub fn mark_square(&mut self, square: u32) {
        let count = self.count as usize;
        if count > FEW {
            self.mark_among_many(square);
        } else if !self.few[..count].contains(&square) {
            if count < FEW {
                self.few[count] = square;
                self.count += 1;
            } else {
                self.many.get_or_insert_default().begin(&self.few);
                self.mark_among_many(square);
            }
        }
    }

    fn mark_among_many(&mut self, square: u32) {
        if let Some(many) = &mut self.many {
            many.mark(square);
            self.count = many.squares.len() as u32;
        }
    }

    /// The squares in the order of the first visit.
    #[must_use]
    pub fn squares(&self) -> &[u32] {
        match &self.many {
            Some(many) if self.count as usize > FEW => &many.squares,
            _ => &self.few[..self.count as usize],
        }
    }

    /// How many squares were visited.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// Bytes on the heap.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let many = self.many.as_ref();
        many.map_or(0, |many| size_of::<Many>() + (many.table.capacity() + many.squares.capacity()) * 4)
    }
}

/// A table of at least twice as many places as squares, searched from a square's own place onwards. It is never walked
/// through, so its layout shows nowhere.
#[derive(Clone, Debug, Default)]
struct Many {
    /// Square plus one, or 0; a power of two long.
    table: Vec<u32>,
    /// In the order of the first visit.
    squares: Vec<u32>,
}

impl Many {
    /// Starts with these squares, which all differ.
    fn begin(&mut self, squares: &[u32]) {
        self.squares.clear();
        self.squares.extend_from_slice(squares);
        self.rebuild();
    }

    fn mark(&mut self, square: u32) {
        if !self.insert(square) {
            return;
        }
        self.squares.push(square);
        if 2 * self.squares.len() > self.table.len() {
            self.rebuild();
        }
    }

    fn rebuild(&mut self) {
        self.table.clear();
        self.table.resize(4 * self.squares.len().next_power_of_two(), 0);
        for index in 0..self.squares.len() {
            self.insert(self.squares[index]);
        }
    }

    /// Puts a square into the table; false when it is there already. At least half of the table is free.
    fn insert(&mut self, square: u32) -> bool {
        let mask = self.table.len() - 1;
        // Neighbouring squares are far apart in the table: multiplied by 2^32 over the golden ratio.
        let mut place = (square.wrapping_mul(0x9E37_79B9) >> 16) as usize & mask;
        loop {
            match self.table[place] {
                0 => {
                    self.table[place] = square + 1;
                    return true;
                }
                found if found == square + 1 => return false,
                _ => place = (place + 1) & mask,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn it_counts_what_a_plain_set_counts() {
        let mut visited = Visited::new(100);
        for round in 1..4_u32 {
            let mut plain = BTreeSet::new();
            for step in 0..900_u32 {
                let x = f64::from(step.wrapping_mul(37 * round) % 997) / 10.0 - 50.0;
                let y = f64::from(step.wrapping_mul(101) % 89) - 44.5;
                visited.mark([x, y]);
                plain.insert(((x + 50.0) as u32, (y + 50.0) as u32));
                assert_eq!(visited.count(), plain.len());
            }
            visited.clear();
            assert_eq!(visited.count(), 0);
        }
    }

    #[test]
    fn the_far_edge_belongs_to_the_last_square() {
        let mut visited = Visited::new(10);
        visited.mark([5.0, 5.0]);
        visited.mark([4.5, 4.5]);
        visited.mark([-5.0, -5.0]);
        assert_eq!(visited.squares(), [99, 0]);
    }
}
