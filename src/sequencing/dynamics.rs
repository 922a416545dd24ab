//! Robots as unicycles, and one step of time: the only place where robots move.
//!
//! A state is a flat slice of 3 M reals, all x, then all y, then all headings; a robot's index is its place in each
//! third. Headings are radians and never wrapped.

use super::behaviours::Law;
use std::f64::consts::PI;

/// Greatest speed in metres per second, forwards and backwards. Source: section V-A.
pub const SPEED_LIMIT: f64 = 2.0;
/// Greatest turning rate in radians per second. Source: section V-A.
pub const TURN_LIMIT: f64 = PI / 8.0;
/// Steps in a second. The paper names no step; ours is that of a 10 Hz controller.
pub const STEPS_PER_SECOND: u32 = 10;
/// Seconds of one step.
pub const STEP: f64 = 0.1;

/// Signed angle from `from` to `to`, counter-clockwise positive.
///
/// Returns radians in `[-pi, pi]`; 0 when either vector is zero.
///
/// - `from`, `to`: finite vectors in the map's frame; only their directions matter.
///
/// Source: eq. (12). The paper writes sgn(cross) acos(dot / norms); this is the same angle, better conditioned near
/// 0, except that exactly opposite vectors give pi or -pi instead of 0.
#[must_use]
pub fn signed_angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    if from == [0.0, 0.0] || to == [0.0, 0.0] {
        return 0.0; // signed zeros: atan2(0, -0) is pi
    }
    libm::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1])
}

/// An angle between -2 pi and 2 pi brought into `[-pi, pi]`.
fn wrap_once(angle: f64) -> f64 {
    if angle > PI {
        angle - 2.0 * PI
    } else if angle < -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
}

/// Any angle brought into `[-pi, pi]`, up to rounding.
fn wrap(angle: f64) -> f64 {
    /// Adding and taking away 1.5 * 2^52 rounds to a whole number; exact, and the same on every target.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    angle - ((angle / (2.0 * PI) + ROUND) - ROUND) * (2.0 * PI)
}

/// What one step needs besides the state: commands and lengths of M robots, allocated once.
#[derive(Clone, Debug)]
pub struct Kernel {
    robots: usize,
    cos: Vec<f64>,
    sin: Vec<f64>,
    /// Headings in `[-pi, pi]`.
    heading: Vec<f64>,
    /// Eq. (13): the sums of v, of gamma and of |N| per robot.
    sums: Vec<Sums>,
    /// Saturated commands: metres per second and radians per second.
    speed: Vec<f64>,
    turn: Vec<f64>,
    /// Metres each robot has gone since [`Kernel::start`].
    length: Vec<f64>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    v: [f64; 2],
    gamma: f64,
    neighbours: f64,
}

impl Kernel {
    /// A kernel for so many robots.
    #[must_use]
    pub fn new(robots: usize) -> Self {
        let zeros = vec![0.0; robots];
        Self {
            robots,
            cos: zeros.clone(),
            sin: zeros.clone(),
            heading: zeros.clone(),
            sums: vec![Sums::default(); robots],
            speed: zeros.clone(),
            turn: zeros.clone(),
            length: zeros,
        }
    }

    /// Sets the lengths gone to 0.
    pub fn start(&mut self) {
        self.length.fill(0.0);
    }

    /// Metres each robot has gone since [`Kernel::start`].
    #[must_use]
    pub fn lengths(&self) -> &[f64] {
        &self.length
    }

    /// Speed and turning rate of a robot as commanded last, after saturation.
    #[must_use]
    pub fn command(&self, robot: usize) -> [f64; 2] {
        [self.speed[robot], self.turn[robot]]
    }

    /// Commands every robot by a law, from one state.
    ///
    /// - `law`: made for as many robots as the kernel has.
    /// - `state`: 3 M reals.
    ///
    /// Source: eqs. (13) to (15), saturation last, per robot (section V-A).
    pub fn control(&mut self, law: &Law, state: &[f64]) {
        let (x, rest) = state.split_at(self.robots);
        let (y, theta) = rest.split_at(self.robots);
        for ((sin, cos), &theta) in self.sin.iter_mut().zip(&mut self.cos).zip(theta) {
            (*sin, *cos) = libm::sincos(theta);
        }
        match law {
            Law::Stand => {
                self.speed.fill(0.0);
                self.turn.fill(0.0);
                return;
            }
            Law::Flock { bias, angle, reach, least } => self.flock(x, y, theta, *bias, *angle, *reach, *least),
            Law::Consensus { gain } => self.gather(x, y, *gain, &[]),
            Law::Formation { offsets } => self.gather(x, y, 1.0, offsets),
        }
        for (speed, turn) in self.speed.iter_mut().zip(&mut self.turn) {
            *speed = speed.clamp(-SPEED_LIMIT, SPEED_LIMIT);
            *turn = turn.clamp(-TURN_LIMIT, TURN_LIMIT);
        }
    }

    /// Eq. (13). Each pair is looked at once: seen from the other robot, the bearing is the same plus pi.
    ///
    /// Radii are inclusive upper bounds. Robots on one point count as neighbours and add nothing. (The paper leaves
    /// both open.)
    #[expect(clippy::too_many_arguments, reason = "the three columns of the state and the four parameters of the law")]
    fn flock(
        &mut self,
        x: &[f64],
        y: &[f64],
        theta: &[f64],
        bias: [f64; 2],
        angle: Option<f64>,
        reach: [f64; 3],
        least: f64,
    ) {
        let robots = self.robots;
        let [repel, align, attract] = reach.map(|radius| radius * radius);
        for (heading, &theta) in self.heading.iter_mut().zip(theta) {
            *heading = wrap(theta);
        }
        self.sums.fill(Sums::default());
        let heading = &self.heading[..robots];
        for i in 0..robots {
            let (xi, yi, hi) = (x[i], y[i], heading[i]);
            let mut own = self.sums[i];
            for j in i + 1..robots {
                let (dx, dy) = (x[j] - xi, y[j] - yi);
                let square = dx * dx + dy * dy;
                if square > attract {
                    continue;
                }
                let other = &mut self.sums[j];
                own.neighbours += 1.0;
                other.neighbours += 1.0;
                if square > align {
                    let bearing = libm::atan2(dy, dx);
                    let back = if bearing > 0.0 { bearing - PI } else { bearing + PI };
                    own.v = [own.v[0] + dx, own.v[1] + dy];
                    other.v = [other.v[0] - dx, other.v[1] - dy];
                    own.gamma += wrap_once(bearing - hi);
                    other.gamma += wrap_once(back - heading[j]);
                } else if square > repel {
                    let towards = wrap_once(heading[j] - hi);
                    own.gamma += towards;
                    other.gamma -= towards;
                } else if square > 0.0 {
                    let bearing = libm::atan2(dy, dx);
                    let back = if bearing > 0.0 { bearing - PI } else { bearing + PI };
                    let weight = 1.0 / (square * square.sqrt());
                    let (px, py) = (dx * weight, dy * weight);
                    own.v = [own.v[0] - px, own.v[1] - py];
                    other.v = [other.v[0] + px, other.v[1] + py];
                    own.gamma += wrap_once(back - hi);
                    other.gamma += wrap_once(bearing - heading[j]);
                }
            }
            self.sums[i] = own;
        }
        for i in 0..robots {
            let Sums { v, gamma, neighbours } = self.sums[i];
            let share = if neighbours > 0.0 { 1.0 / neighbours } else { 0.0 };
            let along = (v[0] * share + bias[0]) * self.cos[i] + (v[1] * share + bias[1]) * self.sin[i];
            self.speed[i] = if along > least { along } else { least };
            // phi(b, q): the bias points to a fixed angle.
            self.turn[i] = gamma * share + angle.map_or(0.0, |angle| wrap_once(angle - self.heading[i]));
        }
    }

    /// Eqs. (14) and (15) with all other robots as neighbours: the sum of (p_j - p_i) over them is that of all
    /// positions less M p_i. Positions are taken from the first robot's, so robots on one point stay there exactly.
    fn gather(&mut self, x: &[f64], y: &[f64], gain: f64, offsets: &[[f64; 2]]) {
        let robots = self.robots;
        if robots < 2 {
            self.speed.fill(0.0);
            self.turn.fill(0.0);
            return;
        }
        let count = robots as f64;
        let share = gain / (count - 1.0);
        let (x0, y0) = (x[0], y[0]);
        let (mut sum_x, mut sum_y) = (0.0, 0.0);
        for (x, y) in x.iter().zip(y) {
            sum_x += x - x0;
            sum_y += y - y0;
        }
        for i in 0..robots {
            let [zx, zy] = offsets.get(i).copied().unwrap_or_default();
            let to = [share * (sum_x - count * (x[i] - x0) - zx), share * (sum_y - count * (y[i] - y0) - zy)];
            let (cos, sin) = (self.cos[i], self.sin[i]);
            self.speed[i] = cos * to[0] + sin * to[1];
            self.turn[i] = signed_angle([cos, sin], to);
        }
    }

    /// Commands all robots by a law and moves them by one step in the open.
    pub fn advance(&mut self, law: &Law, state: &mut [f64]) {
        self.control(law, state);
        let robots = self.robots;
        for robot in 0..robots {
            let moved = self.moved(robot, [0, 1, 2].map(|part| state[part * robots + robot]));
            for (part, real) in moved.into_iter().enumerate() {
                state[part * robots + robot] = real;
            }
        }
    }

    /// Where a robot is after the step just commanded, and its heading then; its length grows by |u_v| dt.
    ///
    /// The command is held for the step and the heading taken in its middle: eq. (11) integrated with dt = 0.1 s,
    /// the model's definition of time. The turn by half a step is at most pi/160, so a short series is exact to
    /// the last bit or two.
    pub fn moved(&mut self, robot: usize, pose: [f64; 3]) -> [f64; 3] {
        self.moved_for(STEP, robot, pose)
    }

    /// As [`Kernel::moved`] with the command held for so many seconds: only for forecasts, which are no part of the model.
    pub fn moved_for(&mut self, seconds: f64, robot: usize, [x, y, theta]: [f64; 3]) -> [f64; 3] {
        let (speed, turn) = (self.speed[robot], self.turn[robot]);
        let half = turn * (seconds / 2.0);
        let square = half * half;
        let cos_half = 1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)));
        let sin_half = half * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0))));
        let (cos, sin) = (self.cos[robot], self.sin[robot]);
        let way = speed * seconds;
        self.length[robot] += way.abs();
        [
            x + way * (cos * cos_half - sin * sin_half),
            y + way * (sin * cos_half + cos * sin_half),
            theta + turn * seconds,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_the_half_turn_is_the_cosine_and_sine() {
        let mut kernel = Kernel::new(1);
        kernel.speed[0] = SPEED_LIMIT;
        kernel.turn[0] = TURN_LIMIT;
        (kernel.cos[0], kernel.sin[0]) = (1.0, 0.0);
        let [x, y, theta] = kernel.moved(0, [0.0, 0.0, 0.0]);
        assert!((x - 0.2 * libm::cos(PI / 160.0)).abs() < 1e-16);
        assert!((y - 0.2 * libm::sin(PI / 160.0)).abs() < 1e-16);
        assert!((theta - PI / 80.0).abs() < 1e-16);
    }

    #[test]
    fn angles_are_wrapped_into_one_turn() {
        for turns in -12..=12 {
            let angle = 0.7 + f64::from(turns) * 2.0 * PI;
            assert!((wrap(angle) - 0.7).abs() < 1e-13, "{turns}");
        }
    }

    #[test]
    fn an_angle_with_a_zero_vector_is_zero() {
        assert_eq!(signed_angle([0.0, 0.0], [-1.0, 0.0]).to_bits(), 0.0_f64.to_bits());
        assert_eq!(signed_angle([-1.0, -0.0], [0.0, -0.0]).to_bits(), 0.0_f64.to_bits());
    }
}
