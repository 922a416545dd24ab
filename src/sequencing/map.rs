//! The map: where robots may be, and what stands in their way.

use super::dynamics::{SPEED_LIMIT, STEP};

/// An axis-parallel rectangle `[left, right) x [bottom, top)`, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least x.
    pub left: f64,
    /// x beyond all of it.
    pub right: f64,
    /// Least y.
    pub bottom: f64,
    /// y beyond all of it.
    pub top: f64,
}

impl Bounds {
    /// Whether a point is inside. Half open: the paper's maps are `[-50, 50)` and `[0, 100)` squared.
    #[must_use]
    pub fn holds(&self, [x, y]: [f64; 2]) -> bool {
        x >= self.left && x < self.right && y >= self.bottom && y < self.top
    }
}

/// What an obstacle looks like. All are closed: touching the edge is a collision.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A disc: centre x, centre y, radius.
    Disc([f64; 3]),
    /// An axis-parallel box: left, bottom, right, top.
    Box([f64; 4]),
    /// A convex polygon by its corners, in either sense of rotation.
    Polygon(Vec<[f64; 2]>),
}

/// An obstacle, ready to be run into.
#[derive(Clone, Debug)]
pub struct Obstacle {
    form: Form,
    /// Left, bottom, right, top of the box around it, a step wider on every side.
    near: [f64; 4],
    /// Boxes and polygons: the half planes `a x + b y <= c` that they are made of.
    sides: Vec<[f64; 3]>,
}

impl Form {
    /// Checks the form.
    ///
    /// # Errors
    /// What is wrong with it, as `expected ..., found ...`.
    pub fn check(&self) -> Result<(), String> {
        match self {
            Self::Disc([.., radius]) if *radius < 0.0 => {
                Err(format!("expected a radius of at least 0 m, found {radius}"))
            }
            Self::Box([x0, y0, x1, y1]) if x0 > x1 || y0 > y1 => {
                Err(format!("expected left, bottom, right, top, found [{x0}, {y0}, {x1}, {y1}]"))
            }
            Self::Polygon(corners) if corners.len() < 3 => {
                Err(format!("expected at least 3 corners, found {}", corners.len()))
            }
            Self::Polygon(corners) if !is_convex(corners) => {
                Err("expected the corners of a convex polygon in order, found others".to_owned())
            }
            Self::Disc(_) | Self::Box(_) | Self::Polygon(_) => Ok(()),
        }
    }

    /// The corners of a box or polygon in counter-clockwise order; none for a disc.
    #[must_use]
    pub fn corners(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Disc(_) => Vec::new(),
            Self::Box([x0, y0, x1, y1]) => vec![[*x0, *y0], [*x1, *y0], [*x1, *y1], [*x0, *y1]],
            Self::Polygon(corners) => {
                let mut corners = corners.clone();
                if area(&corners) < 0.0 {
                    corners.reverse();
                }
                corners
            }
        }
    }

    /// A form that holds every point nearer than `margin` metres to this one; for boxes and polygons a little more,
    /// because their corners stay corners.
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        if margin <= 0.0 {
            return self.clone();
        }
        match self {
            Self::Disc([x, y, radius]) => Self::Disc([*x, *y, radius + margin]),
            Self::Box([x0, y0, x1, y1]) => Self::Box([x0 - margin, y0 - margin, x1 + margin, y1 + margin]),
            Self::Polygon(_) => {
                let corners = self.corners();
                let count = corners.len();
                let outward = |from: usize| {
                    let (a, b) = (corners[from % count], corners[(from + 1) % count]);
                    libm::atan2(a[0] - b[0], b[1] - a[1])
                };
                let mut grown = Vec::with_capacity(2 * count);
                for (at, corner) in corners.iter().enumerate() {
                    let before = outward(at + count - 1);
                    let mut turn = outward(at) - before;
                    if turn < 0.0 {
                        turn += 2.0 * std::f64::consts::PI;
                    }
                    // The corner of a polygon becomes two, where three tangents of the circle around it meet.
                    let far = margin / libm::cos(turn / 4.0);
                    for part in [0.25, 0.75] {
                        let (sin, cos) = libm::sincos(before + part * turn);
                        grown.push([corner[0] + far * cos, corner[1] + far * sin]);
                    }
                }
                Self::Polygon(grown)
            }
        }
    }
}

/// Twice the area; negative when the corners run clockwise.
fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

/// Whether every corner turns the same way and the polygon goes round once.
fn is_convex(corners: &[[f64; 2]]) -> bool {
    let count = corners.len();
    let sense = area(corners);
    let mut turned = 0.0;
    for at in 0..count {
        let [a, b, c] = [at, at + 1, at + 2].map(|at| corners[at % count]);
        let (side, next) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        let angle = super::dynamics::signed_angle(side, next);
        if side == [0.0, 0.0] || angle * sense < 0.0 {
            return false;
        }
        turned += angle.abs();
    }
    sense != 0.0 && turned < 2.0 * std::f64::consts::PI + 1e-6
}

impl Obstacle {
    /// An obstacle of a form that was checked.
    #[must_use]
    pub fn new(form: Form) -> Self {
        let sides = match &form {
            Form::Disc(_) => Vec::new(),
            Form::Box([x0, y0, x1, y1]) => {
                vec![[1.0, 0.0, *x1], [-1.0, 0.0, -x0], [0.0, 1.0, *y1], [0.0, -1.0, -y0]]
            }
            Form::Polygon(_) => {
                let corners = form.corners();
                let next = corners.iter().cycle().skip(1);
                let side = |(a, b): (&[f64; 2], &[f64; 2])| {
                    let (nx, ny) = (b[1] - a[1], a[0] - b[0]);
                    [nx, ny, nx * a[0] + ny * a[1]]
                };
                corners.iter().zip(next).map(side).collect()
            }
        };
        let around = match &form {
            Form::Disc([x, y, radius]) => [x - radius, y - radius, x + radius, y + radius],
            Form::Box(sides) => *sides,
            Form::Polygon(corners) => {
                let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
                corners.iter().fold(start, |around, [x, y]| {
                    [around[0].min(*x), around[1].min(*y), around[2].max(*x), around[3].max(*y)]
                })
            }
        };
        // A little more than a step, so that rounding never hides a touch.
        let wide = SPEED_LIMIT * STEP * 1.01;
        Self { form, near: [around[0] - wide, around[1] - wide, around[2] + wide, around[3] + wide], sides }
    }

    /// What it looks like.
    #[must_use]
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// Whether the straight way of one step between two points touches the obstacle.
    ///
    /// - `from`, `to`: at most one step apart.
    #[must_use]
    pub fn touches(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let [left, bottom, right, top] = self.near;
        let near = to[0] >= left && to[0] <= right && to[1] >= bottom && to[1] <= top;
        near && self.crosses(from, to)
    }

    /// Whether the segment between two points, however long, touches the obstacle.
    #[must_use]
    pub fn crosses(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        if let Form::Disc([cx, cy, radius]) = &self.form {
            let (x, y) = (from[0] - cx, from[1] - cy);
            let square = dx * dx + dy * dy;
            let along = if square > 0.0 { (-(x * dx + y * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
            let (x, y) = (x + along * dx, y + along * dy);
            return x * x + y * y <= radius * radius;
        }
        // The part of the segment that is inside all half planes so far.
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for [a, b, c] in &self.sides {
            let beyond = a * from[0] + b * from[1] - c;
            let rate = a * dx + b * dy;
            if rate > 0.0 {
                leaves = leaves.min(-beyond / rate);
            } else if rate < 0.0 {
                enters = enters.max(-beyond / rate);
            } else if beyond > 0.0 {
                return false;
            }
        }
        enters <= leaves
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Obstacle {
        Obstacle::new(Form::Polygon(vec![[0.0, 0.0], [0.0, 3.0], [4.0, 0.0]]))
    }

    #[test]
    fn touching_an_edge_or_a_corner_is_a_collision() {
        let disc = Obstacle::new(Form::Disc([0.0, 0.0, 3.0]));
        assert!(disc.touches([3.1, 0.0], [3.0, 0.0]));
        assert!(!disc.touches([3.1, 0.0], [3.05, 0.0]));
        let square = Obstacle::new(Form::Box([0.0, 0.0, 1.0, 1.0]));
        assert!(square.touches([1.1, 0.5], [1.0, 0.5]));
        // Cutting the corner (1, 1): neither end is inside.
        assert!(square.touches([0.95, 1.04], [1.04, 0.95]));
        assert!(!square.touches([0.95, 1.06], [1.06, 0.96]));
        assert!(triangle().touches([-0.1, 1.0], [0.0, 1.0]));
        assert!(!triangle().touches([2.2, 1.5], [2.1, 1.45]));
    }

    #[test]
    fn only_convex_polygons_are_taken() {
        assert_eq!(triangle().form().check(), Ok(()));
        let dart = Form::Polygon(vec![[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]);
        assert!(dart.check().is_err());
        let star: Vec<[f64; 2]> = (0..5)
            .map(|at| libm::sincos(f64::from(at) * 4.0 * std::f64::consts::PI / 5.0))
            .map(|(s, c)| [c, s])
            .collect();
        assert!(Form::Polygon(star).check().is_err(), "it goes round twice");
    }

    #[test]
    fn a_grown_polygon_holds_everything_within_the_margin() {
        let grown = Obstacle::new(triangle().form().grown(0.5));
        assert_eq!(grown.form().check(), Ok(()));
        for step in 0..360 {
            let (sin, cos) = libm::sincos(f64::from(step).to_radians());
            for corner in [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]] {
                let point = [corner[0] + 0.499 * cos, corner[1] + 0.499 * sin];
                assert!(grown.crosses(point, point), "{point:?}");
            }
        }
        assert!(!grown.crosses([-0.75, 1.0], [-0.75, 1.0]));
    }
}
