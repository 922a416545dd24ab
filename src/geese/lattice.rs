//! The lattice of cells that the authors' code lays over the arena, and the ground that a place takes up on it.

use super::field::Disc;
use super::params::Params;
use super::switches::{Footprint, Sensing};

/// The side of a cell in arena units.
const CELL: f64 = 10.0;

/// Cells of 10 x 10 units, counted from the lower left corner; what is left of an arena's side belongs to the last.
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    half: f64,
    side: u32,
    footprint: Footprint,
}

impl Lattice {
    /// The lattice of an arena.
    #[must_use]
    pub fn new(params: &Params) -> Self {
        Self { half: params.half(), side: (params.arena_size / CELL as u32).max(1), footprint: params.footprint }
    }

    /// Column and row of the cell of a point. A point on the border of two belongs to the one above or to the right,
    /// one outside the arena to the nearest.
    #[must_use]
    pub fn cell(&self, point: [f64; 2]) -> [u32; 2] {
        // The conversion saturates: anything left of the arena becomes 0.
        point.map(|value| (((value + self.half) / CELL) as u32).min(self.side - 1))
    }

    /// The number of a point's cell: from 0 on, by rows.
    #[must_use]
    pub fn number(&self, point: [f64; 2]) -> u32 {
        let [column, row] = self.cell(point);
        row * self.side + column
    }

    /// Lower left and upper right corner of the cells from `low` to `high`.
    fn corners(&self, low: [u32; 2], high: [u32; 2]) -> [[f64; 2]; 2] {
        let start = |cell: u32| f64::from(cell) * CELL - self.half;
        let end = |cell: u32| if cell + 1 >= self.side { self.half } else { start(cell + 1) };
        [low.map(start), high.map(end)]
    }

    /// Lower left and upper right corner of a point's cell.
    #[must_use]
    pub fn around(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        let cell = self.cell(point);
        self.corners(cell, cell)
    }

    /// The cells of a place, lowest and highest: for radii up to 10 that of its centre, below 20 three by three, and so
    /// on. Cells beyond the arena are left out.
    ///
    /// Source: the authors' code.
    #[must_use]
    pub fn block(&self, disc: &Disc) -> [[u32; 2]; 2] {
        let ring = if disc.radius <= CELL { 0 } else { (disc.radius / CELL) as u32 };
        let centre = self.cell(disc.centre);
        [centre.map(|cell| cell.saturating_sub(ring)), centre.map(|cell| (cell + ring).min(self.side - 1))]
    }

    /// Whether two places share a cell.
    #[must_use]
    pub fn share(&self, a: &Disc, b: &Disc) -> bool {
        let ([a_low, a_high], [b_low, b_high]) = (self.block(a), self.block(b));
        (0..2).all(|axis| a_low[axis] <= b_high[axis] && b_low[axis] <= a_high[axis])
    }

    /// The corners of the cells of a place when places are cells.
    #[must_use]
    pub fn square(&self, disc: &Disc) -> Option<[[f64; 2]; 2]> {
        let [low, high] = self.block(disc);
        (self.footprint == Footprint::Cells).then(|| self.corners(low, high))
    }

    /// The corners of the box around the ground of a place.
    #[must_use]
    pub fn bounds(&self, disc: &Disc) -> [[f64; 2]; 2] {
        let side = |sign: f64| disc.centre.map(|value| value + sign * disc.radius);
        self.square(disc).unwrap_or_else(|| [side(-1.0), side(1.0)])
    }

    /// Whether a point is on the ground of a place.
    #[must_use]
    pub fn covers(&self, disc: &Disc, point: [f64; 2]) -> bool {
        match self.footprint {
            Footprint::Disc => disc.contains(point),
            Footprint::Cells => {
                let ([low, high], cell) = (self.block(disc), self.cell(point));
                (0..2).all(|axis| (low[axis]..=high[axis]).contains(&cell[axis]))
            }
        }
    }

    /// Whether an agent at `point` senses a place: from its ground or closer to it than `margin`, or (`sensing` by
    /// cell) from a cell that the ground touches.
    #[must_use]
    pub fn senses(&self, sensing: Sensing, disc: &Disc, point: [f64; 2], margin: f64) -> bool {
        let near = || Disc { radius: disc.radius + margin, ..*disc }.contains(point);
        match (sensing, self.footprint) {
            (Sensing::Disc, Footprint::Disc) => near(),
            (Sensing::Disc, Footprint::Cells) => self.covers(disc, point) || margin > 0.0 && near(),
            (Sensing::Cell, Footprint::Disc) => {
                let [low, high] = self.around(point);
                disc.contains([0, 1].map(|axis| disc.centre[axis].max(low[axis]).min(high[axis])))
            }
            (Sensing::Cell, Footprint::Cells) => self.covers(disc, point),
        }
    }

    /// Whether a move leads onto or over the ground of a place; in cells only when it enters another cell.
    #[must_use]
    pub fn crosses(&self, disc: &Disc, from: [f64; 2], to: [f64; 2]) -> bool {
        match self.footprint {
            Footprint::Disc => disc.meets(from, to),
            Footprint::Cells => self.cell(from) != self.cell(to) && self.covers(disc, to),
        }
    }

    /// Whether a look along `heading` meets a place: anywhere on the way, or (in cells) at whole parts of the points 0,
    /// 1, 2 ... units ahead.
    ///
    /// - `length`: how far the look goes; the end is not looked at in cells.
    #[must_use]
    pub fn in_sight(&self, disc: &Disc, from: [f64; 2], heading: [f64; 2], length: f64) -> bool {
        let ahead = |far: f64| [0, 1].map(|axis| from[axis] + heading[axis] * far);
        match self.footprint {
            Footprint::Disc => disc.meets(from, ahead(length)),
            Footprint::Cells => {
                (0..length.ceil() as u32).any(|far| self.covers(disc, ahead(f64::from(far)).map(f64::trunc)))
            }
        }
    }
}

/// The direction of the first edge of a box (bottom, right, top, left, each counter-clockwise) that the way from `from`
/// to `to` cuts, as a unit vector; `None` when it cuts none.
#[must_use]
pub fn edge_along([low, high]: [[f64; 2]; 2], from: [f64; 2], to: [f64; 2]) -> Option<[f64; 2]> {
    // Each edge lies at one value of `across` and spans the box along the other axis.
    let edges =
        [(1, low[1], [1.0, 0.0]), (0, high[0], [0.0, 1.0]), (1, high[1], [-1.0, 0.0]), (0, low[0], [0.0, -1.0])];
    let cut = edges.into_iter().find(|&(across, at, _)| {
        let (before, after, along) = (from[across] - at, to[across] - at, 1 - across);
        let way = before - after;
        if before * after > 0.0 || way.abs() <= 0.0 {
            return false;
        }
        let place = from[along] + (to[along] - from[along]) * before / way;
        (low[along]..=high[along]).contains(&place)
    });
    cut.map(|(_, _, direction)| direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(footprint: Footprint) -> Lattice {
        Lattice::new(&Params { footprint, ..Params::default() })
    }

    #[test]
    fn cells_have_the_numbers_of_the_authors_code() {
        let lattice = lattice(Footprint::Cells);
        // They count from 1.
        let number = |x: f64, y: f64| lattice.number([x, y]) + 1;
        assert_eq!([number(0.0, 0.0), number(-1.0, -1.0), number(50.0, 50.0)], [56, 45, 100]);
        assert_eq!([number(-50.0, -50.0), number(10.0, 0.0), number(9.0, 9.0)], [1, 57, 56]);
    }

    #[test]
    fn a_place_is_one_cell_nine_or_twenty_five() {
        let lattice = lattice(Footprint::Cells);
        for (radius, cells) in [(0.5, 1), (10.0, 1), (11.0, 9), (19.0, 9), (20.0, 25), (29.0, 25)] {
            let disc = Disc { centre: [0.0, 0.0], radius };
            let points = (-50..50).flat_map(|x| (-50..50).map(move |y| [f64::from(x), f64::from(y)]));
            assert_eq!(points.filter(|point| lattice.covers(&disc, *point)).count(), cells * 100, "radius {radius}");
        }
        let hub = Disc { centre: [0.0, 0.0], radius: 10.0 };
        assert_eq!(lattice.square(&hub), Some([[0.0, 0.0], [10.0, 10.0]]));
    }

    #[test]
    fn a_disc_is_sensed_by_cell_from_every_cell_that_it_touches() {
        let lattice = lattice(Footprint::Disc);
        let disc = Disc { centre: [5.0, 5.0], radius: 6.0 };
        let senses = |x: f64, y: f64| lattice.senses(Sensing::Cell, &disc, [x, y], 0.0);
        assert!(senses(9.0, 9.0) && senses(19.0, 9.0) && senses(-9.0, 1.0));
        assert!(!senses(19.0, 19.0) && !senses(20.0, 5.0), "the corner is 7.07 from the centre");
    }

    #[test]
    fn the_box_is_rounded_counter_clockwise() {
        let unit = [[0.0, 0.0], [10.0, 10.0]];
        assert_eq!(edge_along(unit, [5.0, -2.0], [5.0, 1.0]), Some([1.0, 0.0]));
        assert_eq!(edge_along(unit, [12.0, 5.0], [9.0, 5.0]), Some([0.0, 1.0]));
        assert_eq!(edge_along(unit, [5.0, 12.0], [5.0, 9.0]), Some([-1.0, 0.0]));
        assert_eq!(edge_along(unit, [-2.0, 5.0], [1.0, 5.0]), Some([0.0, -1.0]));
        assert_eq!(edge_along(unit, [5.0, 5.0], [6.0, 6.0]), None);
    }
}
