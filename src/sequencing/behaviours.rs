//! The three meta-behaviours with all their parameters, and the library of ten made from them.

use super::dynamics::SPEED_LIMIT;

/// A concrete behaviour: a meta-behaviour with its parameters, a letter and a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Behaviour {
    /// One character that stands for it in sequences.
    pub letter: char,
    /// Its name for people.
    pub name: String,
    /// What it makes robots do.
    pub meta: Meta,
}

/// A meta-behaviour with its parameters. Source: section V-B.
#[derive(Clone, Debug, PartialEq)]
pub enum Meta {
    /// Biased flocking, eq. (13).
    Flock {
        /// The bias q, metres per second.
        bias: [f64; 2],
        /// The radii of repulsion, alignment and attraction in metres; each at least the one before it.
        radii: [f64; 3],
        /// The least forward speed before saturation, metres per second.
        least: f64,
    },
    /// Rendezvous and anti-rendezvous, eq. (14), with the gain Kp per second; 0 stops the robots.
    Consensus(f64),
    /// Formation control, eq. (15).
    Formation(Shape),
}

/// Where robots stand in a formation, up to a translation. Source: z of eq. (15).
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Robot i stands at i times this vector, metres.
    Row([f64; 2]),
    /// Robot i stands at the i-th of these points, metres; with more robots than points they are used in turn.
    Points(Vec<[f64; 2]>),
}

/// The letters of the ten behaviours of section V-C in the library's order.
pub const LETTERS: &str = "FENWS.RAXY";

/// The radii of section V-B.1.
pub const RADII: [f64; 3] = [5.0, 10.0, 20.0];

/// The behaviour of section V-C with this letter of [`LETTERS`], or `None`.
#[must_use]
pub fn standard(letter: char) -> Option<Behaviour> {
    let flock = |x: f64, y: f64| Meta::Flock { bias: [x, y], radii: RADII, least: 1.0 };
    let (name, meta) = match letter {
        'F' => ("Flock", flock(0.0, 0.0)),
        'E' => ("Flock East", flock(1.0, 0.0)),
        'N' => ("Flock North", flock(0.0, 1.0)),
        'W' => ("Flock West", flock(-1.0, 0.0)),
        'S' => ("Flock South", flock(0.0, -1.0)),
        '.' => ("Stop Moving", Meta::Consensus(0.0)),
        'R' => ("Rendezvous", Meta::Consensus(1.0)),
        'A' => ("Anti-Rendezvous", Meta::Consensus(-1.0)),
        'X' => ("Line X", Meta::Formation(Shape::Row([2.0, 0.0]))),
        'Y' => ("Line Y", Meta::Formation(Shape::Row([0.0, 2.0]))),
        _ => return None,
    };
    Some(Behaviour { letter, name: name.to_owned(), meta })
}

/// The library of section V-C.
#[must_use]
pub fn library() -> Vec<Behaviour> {
    LETTERS.chars().filter_map(standard).collect()
}

/// A behaviour prepared for a number of robots, as the kernel takes it.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Nobody moves: the state stays as it is, bit for bit.
    Stand,
    /// Eq. (13).
    Flock {
        /// The bias q.
        bias: [f64; 2],
        /// The direction of the bias; `None` without one.
        angle: Option<f64>,
        /// The three radii.
        reach: [f64; 3],
        /// The least forward speed.
        least: f64,
    },
    /// Eq. (14).
    Consensus {
        /// The gain Kp.
        gain: f64,
    },
    /// Eq. (15).
    Formation {
        /// The sum over the others of (z_j - z_i), per robot.
        offsets: Vec<[f64; 2]>,
    },
}

impl Behaviour {
    /// Whether it leaves every state as it is.
    #[must_use]
    pub fn is_stop(&self) -> bool {
        self.meta == Meta::Consensus(0.0)
    }

    /// The speed, metres per second, below which no robot moves while this behaviour is active.
    #[must_use]
    pub fn least_speed(&self) -> f64 {
        match &self.meta {
            Meta::Flock { least, .. } => least.clamp(0.0, SPEED_LIMIT),
            Meta::Consensus(_) | Meta::Formation(_) => 0.0,
        }
    }

    /// The behaviour as a law for so many robots.
    #[must_use]
    pub fn law(&self, robots: usize) -> Law {
        match &self.meta {
            Meta::Flock { bias, radii, least } => {
                let angle = (*bias != [0.0, 0.0]).then(|| libm::atan2(bias[1], bias[0]));
                Law::Flock { bias: *bias, angle, reach: *radii, least: *least }
            }
            // Exactly 0, as users write it: every other gain moves somebody.
            Meta::Consensus(gain) => {
                if *gain == 0.0 {
                    Law::Stand
                } else {
                    Law::Consensus { gain: *gain }
                }
            }
            Meta::Formation(shape) => {
                let places: Vec<[f64; 2]> = (0..robots).map(|robot| shape.place(robot)).collect();
                let sum = places.iter().fold([0.0, 0.0], |sum, place| [sum[0] + place[0], sum[1] + place[1]]);
                let count = robots as f64;
                let offset = |place: &[f64; 2]| [sum[0] - count * place[0], sum[1] - count * place[1]];
                Law::Formation { offsets: places.iter().map(offset).collect() }
            }
        }
    }
}

impl Shape {
    /// Where a robot stands in the formation.
    #[must_use]
    pub fn place(&self, robot: usize) -> [f64; 2] {
        match self {
            Self::Row(step) => [robot as f64 * step[0], robot as f64 * step[1]],
            Self::Points(points) if points.is_empty() => [0.0, 0.0],
            Self::Points(points) => points[robot % points.len()],
        }
    }
}
