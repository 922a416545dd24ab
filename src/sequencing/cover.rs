//! The grid of the coverage task: which cells robots have been in.

/// The cells of a map. Source: section VII.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells {
    /// The corner of the map from which cells are counted.
    pub origin: [f64; 2],
    /// The side of a cell, metres: G_s.
    pub side: f64,
    /// Cells in a row: G_x.
    pub columns: u32,
    /// Cells in a column: G_y.
    pub rows: u32,
}

impl Cells {
    /// Words of 64 bits that hold one bit a cell.
    #[must_use]
    pub fn words(&self) -> usize {
        (self.columns as usize * self.rows as usize).div_ceil(64)
    }

    /// The column and row of a point.
    fn cell(&self, [x, y]: [f64; 2]) -> [i64; 2] {
        let index = |at: f64, from: f64| libm::floor((at - from) / self.side) as i64;
        [index(x, self.origin[0]), index(y, self.origin[1])]
    }

    /// Marks a cell; returns 1 when it is new, 0 when it was marked or is outside the grid.
    fn mark(&self, marks: &mut [u64], [column, row]: [i64; 2]) -> u32 {
        let (columns, rows) = (i64::from(self.columns), i64::from(self.rows));
        if !(0..columns).contains(&column) || !(0..rows).contains(&row) {
            return 0;
        }
        let at = (row * columns + column) as usize;
        let (word, bit) = (at / 64, 1 << (at % 64));
        let new = marks[word] & bit == 0;
        marks[word] |= bit;
        u32::from(new)
    }

    /// Marks the cell of a point; returns how many are new.
    pub fn mark_point(&self, marks: &mut [u64], point: [f64; 2]) -> u32 {
        self.mark(marks, self.cell(point))
    }

    /// Marks every cell on the straight way between two points but the first one's; returns how many are new.
    ///
    /// The paper does not say how visits are counted. Counting only the points at which steps end would miss about 3 %
    /// of the cells. Where the way goes exactly through a corner, the cell beside it counts.
    pub fn mark_way(&self, marks: &mut [u64], from: [f64; 2], to: [f64; 2]) -> u32 {
        let end = self.cell(to);
        let mut cell = self.cell(from);
        let mut new = 0;
        while cell != end {
            // The share of the way at which the next grid line of an axis is crossed.
            let share = |axis: usize| {
                let lines = match end[axis] - cell[axis] {
                    0 => return f64::INFINITY,
                    ahead if ahead > 0 => cell[axis] + 1,
                    _ => cell[axis],
                };
                (self.origin[axis] + lines as f64 * self.side - from[axis]) / (to[axis] - from[axis])
            };
            let axis = usize::from(share(1) < share(0));
            cell[axis] += (end[axis] - cell[axis]).signum();
            new += self.mark(marks, cell);
        }
        new
    }

    /// Whether a cell is marked, in the order of rows.
    #[must_use]
    pub fn is_marked(marks: &[u64], cell: usize) -> bool {
        marks.get(cell / 64).is_some_and(|word| word >> (cell % 64) & 1 == 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CELLS: Cells = Cells { origin: [0.0, 0.0], side: 1.0, columns: 4, rows: 4 };

    fn marked(marks: &[u64]) -> Vec<usize> {
        (0..16).filter(|&cell| Cells::is_marked(marks, cell)).collect()
    }

    #[test]
    fn a_step_over_a_corner_marks_the_cell_between() {
        let mut marks = vec![0; CELLS.words()];
        // From cell (0, 0) to (1, 1): the line x = 1 is crossed at y = 0.99, below the corner.
        assert_eq!(CELLS.mark_way(&mut marks, [0.95, 0.94], [1.05, 1.04]), 2);
        assert_eq!(marked(&marks), [1, 5]);
        // And back over the same cells: nothing new but the first, which it leaves out on the way there.
        assert_eq!(CELLS.mark_way(&mut marks, [1.05, 1.04], [0.95, 0.94]), 1);
        assert_eq!(marked(&marks), [0, 1, 5]);
    }

    #[test]
    fn cells_outside_the_grid_do_not_count() {
        let mut marks = vec![0; CELLS.words()];
        assert_eq!(CELLS.mark_point(&mut marks, [4.5, 1.0]), 0);
        assert_eq!(CELLS.mark_point(&mut marks, [3.5, 1.0]), 1);
    }
}
