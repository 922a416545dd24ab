//! Points in the square arena, sorted into cells, so that a search near a place looks at few of them.

use super::ahead::call_for_place;

/// A set of points with ids 0 to n - 1, each in the set or not.
///
/// Cells are linked lists through the ids: moving a point changes two lists and allocates nothing.
#[derive(Clone, Debug)]
pub struct Grid {
    half: f64,
    /// Cells along one side.
    side: u32,
    /// The first point of each cell.
    heads: Vec<u32>,
    links: Vec<Link>,
}

/// A point with its neighbours in the list of its cell: all that a search asks of it in one place of the memory.
#[derive(Clone, Copy, Debug)]
struct Link {
    point: [f64; 2],
    next: u32,
    previous: u32,
    cell: u32,
}

/// Where to look for points.
#[derive(Clone, Copy, Debug)]
pub enum Area {
    /// Within a radius of the place, the rim included.
    Disc(f64),
    /// In a cell, by its lower left and its upper right corner.
    Cell([[f64; 2]; 2]),
}

/// A search under way.
struct Search {
    place: [f64; 2],
    low: [f64; 2],
    high: [f64; 2],
    /// The greatest squared distance; infinite where only the corners count.
    within: f64,
}

impl Search {
    fn new(place: [f64; 2], area: Area) -> Self {
        match area {
            Area::Disc(radius) => Self {
                place,
                low: place.map(|value| value - radius),
                high: place.map(|value| value + radius),
                within: radius * radius,
            },
            Area::Cell([low, high]) => Self { place, low, high, within: f64::INFINITY },
        }
    }
}

const NONE: u32 = u32::MAX;
/// The side of a cell: the default sensing radius, so that a search looks at nine cells at most.
const CELL: f64 = 5.0;

impl Grid {
    /// An empty set for `count` points in the arena `[-half, half]` squared.
    #[must_use]
    pub fn new(half: f64, count: u32) -> Self {
        let side = ((2.0 * half / CELL).ceil() as u32).max(1);
        let count = count as usize;
        Self {
            half,
            side,
            heads: vec![NONE; (side * side) as usize],
            links: vec![Link { point: [0.0; 2], next: NONE, previous: NONE, cell: NONE }; count],
        }
    }

    /// Where the point is, or last was.
    #[must_use]
    pub fn point(&self, id: u32) -> [f64; 2] {
        self.links[id as usize].point
    }

    /// True when the point is in the set.
    #[cfg(test)]
    fn contains(&self, id: u32) -> bool {
        self.links[id as usize].cell != NONE
    }

    /// Puts the point at a place, into the set if it was not in it.
    pub fn put(&mut self, id: u32, point: [f64; 2]) {
        let [column, row] = self.cell(point);
        let cell = row * self.side + column;
        let link = &mut self.links[id as usize];
        link.point = point;
        if link.cell == cell {
            return;
        }
        self.remove(id);
        let head = self.heads[cell as usize];
        self.links[id as usize] = Link { point, next: head, previous: NONE, cell };
        if head != NONE {
            self.links[head as usize].previous = id;
        }
        self.heads[cell as usize] = id;
    }

    /// Takes the point out of the set; its place is kept.
    pub fn remove(&mut self, id: u32) {
        let Link { next, previous, cell, .. } = self.links[id as usize];
        if cell == NONE {
            return;
        }
        if previous == NONE {
            self.heads[cell as usize] = next;
        } else {
            self.links[previous as usize].next = next;
        }
        if next != NONE {
            self.links[next as usize].previous = previous;
        }
        self.links[id as usize].cell = NONE;
    }

    /// Calls `found` with id and squared distance from `place` of every point of the area around it; in no useful order.
    #[inline]
    pub fn near(&self, place: [f64; 2], area: Area, mut found: impl FnMut(u32, f64)) {
        let search = Search::new(place, area);
        let [[left, bottom], [right, top]] = self.cells(&search);
        for row in bottom..=top {
            for column in left..=right {
                self.look_into([column, row], &search, &mut found);
            }
        }
    }

    /// The nearest point of an area around `place`; of equally near ones that with the smallest number.
    #[must_use]
    pub fn nearest(&self, place: [f64; 2], area: Area) -> Option<u32> {
        let search = Search::new(place, area);
        let [[left, bottom], [right, top]] = self.cells(&search);
        let own = self.cell(place);
        let mut best = (f64::INFINITY, NONE);
        let look_into = |cell: [u32; 2], best: &mut (f64, u32)| {
            self.look_into(cell, &search, &mut |id, distance| {
                if (distance, id) < *best {
                    *best = (distance, id);
                }
            });
        };
        // Items lie on heaps, so where there are any, the own cell mostly has one that is nearer than the other cells are.
        look_into(own, &mut best);
        for row in bottom..=top {
            for column in left..=right {
                if [column, row] != own && self.distance_to_cell([column, row], place) <= best.0 {
                    look_into([column, row], &mut best);
                }
            }
        }
        (best.1 != NONE).then_some(best.1)
    }

    /// Calls `found` with the points of one cell that the search looks for.
    #[inline]
    fn look_into(&self, [column, row]: [u32; 2], search: &Search, found: &mut impl FnMut(u32, f64)) {
        let mut id = self.heads[(row * self.side + column) as usize];
        while id != NONE {
            let Link { point, next, .. } = self.links[id as usize];
            let distance = squared_distance(point, search.place);
            if distance <= search.within
                && (search.within.is_finite() || self.is_between(point, search.low, search.high))
            {
                found(id, distance);
            }
            id = next;
        }
    }

    /// No point of the cell is nearer than this, squared.
    fn distance_to_cell(&self, cell: [u32; 2], place: [f64; 2]) -> f64 {
        let mut squared = 0.0;
        for axis in 0..2 {
            let low = f64::from(cell[axis]) * CELL - self.half;
            // The outermost cells have no outer side; a little less, since rounding may put a point into the next cell.
            let below = if cell[axis] > 0 { low - place[axis] - 1e-6 } else { 0.0 };
            let above = if cell[axis] + 1 < self.side { place[axis] - (low + CELL) - 1e-6 } else { 0.0 };
            // At most one of the two is above 0. (The larger of two numbers is a call in WebAssembly.)
            if below > 0.0 {
                squared += below * below;
            } else if above > 0.0 {
                squared += above * above;
            }
        }
        squared
    }

    /// Calls for a point, see [`super::ahead`].
    pub fn call_for(&self, id: u32) {
        call_for_place(&self.links, id as usize);
    }

    /// Calls for the cells that a disc touches.
    pub fn call_for_cells(&self, place: [f64; 2], radius: f64) {
        let [[left, bottom], [right, top]] = self.cells(&Search::new(place, Area::Disc(radius)));
        for row in bottom..=top {
            call_for_place(&self.heads, (row * self.side + left) as usize);
            call_for_place(&self.heads, (row * self.side + right) as usize);
        }
    }

    /// The first and the last cell of a search, by column and row.
    fn cells(&self, search: &Search) -> [[u32; 2]; 2] {
        [search.low, search.high].map(|corner| self.cell(corner))
    }

    /// The cell of a place, by column and row.
    fn cell(&self, place: [f64; 2]) -> [u32; 2] {
        place.map(|coordinate| self.axis(coordinate))
    }

    /// Whether a point lies in a cell: on its lower and left side, on the others only where the arena ends.
    fn is_between(&self, point: [f64; 2], low: [f64; 2], high: [f64; 2]) -> bool {
        (0..2).all(|axis| point[axis] >= low[axis] && (point[axis] < high[axis] || high[axis] >= self.half))
    }

    /// The cell of a coordinate along one axis; places outside the arena count to its outermost cells.
    fn axis(&self, coordinate: f64) -> u32 {
        // The conversion saturates: anything left of the arena becomes 0.
        (((coordinate + self.half) * (1.0 / CELL)) as u32).min(self.side - 1)
    }
}

/// The square of the distance of two points.
#[must_use]
pub fn squared_distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
    dx * dx + dy * dy
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_finds_what_a_full_search_finds() {
        let mut grid = Grid::new(50.0, 400);
        let place = |id: u32, salt: u32| {
            let x = f64::from(id.wrapping_mul(2_654_435_761).wrapping_add(salt) % 1001) / 10.0 - 50.0;
            let y = f64::from(id.wrapping_mul(40_503).wrapping_add(salt * 7) % 1001) / 10.0 - 50.0;
            [x, y]
        };
        for salt in 0..3 {
            (0..400).for_each(|id| grid.put(id, place(id, salt)));
        }
        (0..400).filter(|id| id % 7 == 0).for_each(|id| grid.remove(id));
        for id in 0..400 {
            for radius in [0.5, 5.0, 17.0, 200.0] {
                let mut found = Vec::new();
                grid.near(grid.point(id), Area::Disc(radius), |other, _| found.push(other));
                found.sort_unstable();
                let all = (0..400).filter(|&other| grid.contains(other));
                let expected: Vec<u32> =
                    all.filter(|&o| squared_distance(grid.point(o), grid.point(id)) <= radius * radius).collect();
                assert_eq!(found, expected);
                let distance = |&other: &u32| squared_distance(grid.point(other), grid.point(id));
                let nearest = expected.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
                assert_eq!(grid.nearest(grid.point(id), Area::Disc(radius)), nearest);
            }
        }
    }
}
