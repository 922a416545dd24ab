//! What is still to pay: lower bounds that the proofs rest on, and guesses that only order the search.

use super::behaviours::{Behaviour, Law, Meta};
use super::costs::{Costs, Past};
use super::dynamics::{Kernel, SPEED_LIMIT};
use super::geodesic::Ways;
use super::parts::Goal;
use super::tasks::Task;

/// The bounds and guesses of one task.
#[derive(Clone, Debug)]
pub struct Estimate {
    costs: Costs,
    ways: Option<Ways>,
    /// Per behaviour, metres that all robots together go at least in an interval.
    least: Vec<f64>,
    laws: Vec<Law>,
    /// Long steps of a forecast; 0 to guess by straight lines.
    forecast: u32,
}

/// A state from which something is guessed.
#[derive(Clone, Copy, Debug)]
pub struct Stand<'a> {
    /// 3 M reals.
    pub state: &'a [f64],
    /// Of visited cells.
    pub marks: &'a [u64],
    /// How many are marked.
    pub visited: u32,
    /// What came before.
    pub past: Past,
    /// The bound of the state.
    pub rest: f64,
}

/// Room to guess in.
#[derive(Clone, Debug)]
pub struct Room {
    state: Vec<f64>,
    marks: Vec<u64>,
    kernel: Kernel,
}

impl Room {
    /// Room for the states of a task.
    #[must_use]
    pub fn new(task: &Task) -> Self {
        let robots = task.robots();
        Self { state: vec![0.0; 3 * robots], marks: vec![0; task.words()], kernel: Kernel::new(robots) }
    }
}

/// What is said about one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Never more than what every completion costs: H of eqs. (18), (21), plus time.
    pub bound: f64,
    /// Metres that the farthest robot still has to go at least; 0 without a target.
    pub gap: f64,
}

/// A guess at what a behaviour will do, never simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guess {
    /// Path length, time and switch of the interval.
    pub cost: f64,
    /// The bound of the state after it.
    pub rest: f64,
    /// The second estimate of that state, see [`second`].
    pub second: f64,
}

/// New cells per metre, in sides of a cell: what real flocks see. The bound of eq. (21) allows 2.12.
const CELLS_PER_SIDE: f64 = 0.9;

impl Estimate {
    /// Prepares a task.
    ///
    /// - `geodesic`: whether distances to a target go round the obstacles. `forecast`: long steps in which guesses are
    ///   made; 0 to make them by straight lines.
    #[must_use]
    pub fn new(task: &Task, costs: Costs, geodesic: bool, forecast: u32) -> Self {
        let ways = match (task.goal(), geodesic) {
            (Goal::Reach { centre, radius }, true) => {
                Some(Ways::new(task.bounds(), task.obstacles(), *centre, *radius))
            }
            (Goal::Reach { .. } | Goal::Cover { .. }, _) => None,
        };
        let robots = task.robots() as f64;
        // The factor takes in the rounding of a hundred additions of 0.1 m.
        let least = |behaviour: &Behaviour| behaviour.least_speed() * task.interval() * robots * (1.0 - 1e-12);
        Self {
            costs,
            ways,
            least: task.library().iter().map(least).collect(),
            laws: task.library().iter().map(|behaviour| behaviour.law(task.robots())).collect(),
            forecast,
        }
    }

    /// The lower bound on what every completion of a state costs.
    ///
    /// Source: eqs. (18) and (21); with a charge for time, every interval that is still needed adds its own.
    #[must_use]
    pub fn rest(&self, task: &Task, state: &[f64], visited: u32) -> Rest {
        match task.goal() {
            Goal::Reach { centre, radius } => {
                let robots = task.robots();
                let (mut sum, mut gap) = (0.0, 0.0_f64);
                for robot in 0..robots {
                    let at = [state[robot], state[robots + robot]];
                    let far = match &self.ways {
                        Some(ways) => ways.length(at),
                        None => length([at[0] - centre[0], at[1] - centre[1]]),
                    };
                    // A little less, so that the rounding of sums never lifts a bound above the truth.
                    let left = (far - radius).max(0.0) * (1.0 - 1e-14);
                    sum += left;
                    gap = gap.max(left);
                }
                Rest { bound: sum + self.time(task, gap, task.farthest(state) < *radius), gap }
            }
            Goal::Cover { .. } => {
                let bound = cover_bound(task, f64::from(visited));
                Rest { bound: bound + self.time(task, 0.0, task.is_goal(state, visited)), gap: 0.0 }
            }
        }
    }

    /// The charge for the intervals that are still needed.
    fn time(&self, task: &Task, gap: f64, is_goal: bool) -> f64 {
        if self.costs.per_second == 0.0 || is_goal {
            return 0.0;
        }
        let intervals = libm::ceil((gap - 1e-9) / task.reach()).max(1.0);
        self.costs.per_second * task.interval() * intervals
    }

    /// The lower bound on what every completion costs that begins with a behaviour, without simulating it.
    ///
    /// - `rest`: the bound of the state it begins in.
    #[must_use]
    pub fn through(&self, task: &Task, rest: f64, past: Past, next: u8) -> f64 {
        let is_stop = task.stop() == Some(next);
        let switch = self.costs.switch(past, next, is_stop);
        let time = self.costs.charge(past, next, is_stop, task.interval()) - switch;
        switch + rest.max(self.least[usize::from(next)] + time)
    }

    /// Guesses what a behaviour would do in the next interval, by a forecast in long steps ([`Task::forecast`]) or by
    /// straight lines: flocks go along their bias, or along their own heading without one; rendezvous, lines and their
    /// like go straight to where they want to be, as far as they can come.
    ///
    /// What a forecast sees colliding is guessed to cost infinitely much: its key is then what its bound allows at most
    /// ([`super::search::queue::Entry::key`]), so that it waits as long as the promise of the weight lets it.
    ///
    /// - `from`: where it begins. `second`: whether the second estimate is wanted.
    #[must_use]
    pub fn guess(&self, task: &Task, from: &Stand, next: u8, second: bool, room: &mut Room) -> Guess {
        let robots = task.robots();
        let is_stop = task.stop() == Some(next);
        let foreseen = if self.forecast == 0 {
            let path = self.guess_places(task, from.state, next, &mut room.state);
            let side = match task.goal() {
                Goal::Reach { .. } => f64::INFINITY,
                Goal::Cover { cells, .. } => cells.side,
            };
            Some((path, CELLS_PER_SIDE * path / side))
        } else {
            room.state.copy_from_slice(from.state);
            room.marks.copy_from_slice(from.marks);
            let seen = task.forecast(next, self.forecast, &mut room.state, &mut room.marks, &mut room.kernel);
            seen.map(|(path, new)| (path, f64::from(new)))
        };
        let Some((path, new)) = foreseen else {
            return Guess { cost: f64::INFINITY, rest: from.rest, second: from.rest };
        };
        let cost = path + self.costs.charge(from.past, next, is_stop, task.interval());
        let at = |robot: usize| [room.state[robot], room.state[robots + robot]];
        let (rest, visited) = match task.goal() {
            Goal::Reach { centre, radius } => {
                let (mut sum, mut gap) = (0.0, 0.0_f64);
                for robot in 0..robots {
                    let at = at(robot);
                    let far = match &self.ways {
                        // A guess may end inside an obstacle, from where nothing is in sight.
                        Some(ways) => Some(ways.length(at)).filter(|far| far.is_finite()),
                        None => None,
                    };
                    let far = far.unwrap_or_else(|| length([at[0] - centre[0], at[1] - centre[1]]));
                    let left = (far - radius).max(0.0);
                    sum += left;
                    gap = gap.max(left);
                }
                (sum + self.time(task, gap, gap <= 0.0), 0.0)
            }
            Goal::Cover { cells, ratio } => {
                let visited = f64::from(from.visited) + new;
                let reached = visited >= ratio * f64::from(cells.columns) * f64::from(cells.rows);
                (cover_bound(task, visited) + self.time(task, 0.0, reached), visited)
            }
        };
        Guess { cost, rest, second: if second { second_of(task, at, visited) } else { 0.0 } }
    }

    /// Writes guessed places into `room`; returns the guessed path length.
    fn guess_places(&self, task: &Task, state: &[f64], next: u8, room: &mut [f64]) -> f64 {
        let robots = task.robots();
        let (x, y) = (&state[..robots], &state[robots..2 * robots]);
        let reach = task.reach();
        let count = robots as f64;
        let middle = [x.iter().sum::<f64>() / count, y.iter().sum::<f64>() / count];
        let behaviour = &task.library()[usize::from(next)];
        let mut path = 0.0;
        for robot in 0..robots {
            let (way, far) = match (&behaviour.meta, &self.laws[usize::from(next)]) {
                (_, Law::Stand) => ([0.0, 0.0], 0.0),
                (Meta::Flock { bias, least, .. }, _) => {
                    let speed = length(*bias).max(*least).clamp(0.0, SPEED_LIMIT);
                    let way = if *bias == [0.0, 0.0] {
                        let (sin, cos) = libm::sincos(state[2 * robots + robot]);
                        [cos, sin]
                    } else {
                        *bias
                    };
                    (way, speed * task.interval())
                }
                (Meta::Consensus(gain), _) if *gain < 0.0 => ([x[robot] - middle[0], y[robot] - middle[1]], reach),
                (Meta::Consensus(_), _) => {
                    let way = [middle[0] - x[robot], middle[1] - y[robot]];
                    (way, length(way).min(reach))
                }
                (Meta::Formation(_), law) => {
                    let offset = match law {
                        Law::Formation { offsets } => offsets.get(robot).copied().unwrap_or_default(),
                        Law::Stand | Law::Flock { .. } | Law::Consensus { .. } => [0.0, 0.0],
                    };
                    let way = [middle[0] - offset[0] / count - x[robot], middle[1] - offset[1] / count - y[robot]];
                    (way, length(way).min(reach))
                }
            };
            let whole = length(way);
            let share = if whole > 0.0 { far / whole } else { 0.0 };
            room[robot] = x[robot] + share * way[0];
            room[robots + robot] = y[robot] + share * way[1];
            path += if whole > 0.0 { far } else { 0.0 };
        }
        path
    }
}

/// An estimate that is no bound, for the second queue: north and east flocks go along two sides of a triangle, and
/// real flocks visit fewer cells than the bound allows.
#[must_use]
pub fn second(task: &Task, state: &[f64], visited: u32) -> f64 {
    let robots = task.robots();
    second_of(task, |robot| [state[robot], state[robots + robot]], f64::from(visited))
}

fn second_of(task: &Task, at: impl Fn(usize) -> [f64; 2], visited: f64) -> f64 {
    match task.goal() {
        Goal::Reach { centre, radius } => {
            let left = |robot: usize| {
                let [x, y] = at(robot);
                ((x - centre[0]).abs() + (y - centre[1]).abs() - radius).max(0.0)
            };
            (0..task.robots()).map(left).sum()
        }
        Goal::Cover { cells, ratio } => {
            let wanted = ratio * f64::from(cells.columns) * f64::from(cells.rows);
            (wanted - visited).max(0.0) * cells.side / CELLS_PER_SIDE
        }
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Eq. (21). With the 4 M of the paper; robots' own cells are counted already, so 3 M would do.
fn cover_bound(task: &Task, visited: f64) -> f64 {
    let Goal::Cover { cells, ratio } = task.goal() else { return 0.0 };
    let wanted = ratio * f64::from(cells.columns) * f64::from(cells.rows);
    let left = (wanted - 4.0 * task.robots() as f64 - visited).max(0.0);
    cells.side * 2.0_f64.sqrt() / 3.0 * left * (1.0 - 1e-14)
}
