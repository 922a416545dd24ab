//! A task: map, robots, library and goal; and what one behaviour does in one interval.

use super::behaviours::{Behaviour, Law};
use super::dynamics::{Kernel, SPEED_LIMIT, STEPS_PER_SECOND};
use super::map::{Bounds, Obstacle};
use super::parts::{Goal, MOST_CELLS, Parts, TaskError, check_library, fault};

/// Everything a plan depends on, checked.
#[derive(Clone, Debug)]
pub struct Task {
    bounds: Bounds,
    obstacles: Vec<Obstacle>,
    goal: Goal,
    library: Vec<Behaviour>,
    laws: Vec<Law>,
    stop: Option<u8>,
    start: Vec<f64>,
    robots: usize,
    decisions: u16,
    /// Seconds between decision points.
    interval: u32,
}

/// What a robot ran into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touched {
    /// The obstacle of this number.
    Obstacle(u32),
    /// The edge of the map.
    Edge,
}

/// The first touch of an interval, in the order of steps and robots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Collision {
    /// The step of the interval, from 1.
    pub step: u32,
    /// The robot.
    pub robot: u32,
    /// What it touched.
    pub touched: Touched,
}

impl Task {
    /// Checks the parts and makes a task of them.
    ///
    /// # Errors
    /// No robots; a map without inside; an obstacle that is none; an empty library, two behaviours of one letter or two
    /// that stop; a robot that starts off the map or in an obstacle; a number that is not finite.
    pub fn new(parts: &Parts) -> Result<Self, TaskError> {
        let Parts { bounds, obstacles, goal, library, start, decisions, interval } = parts;
        if start.is_empty() {
            return fault("robots", "expected at least one robot, found none".to_owned());
        }
        let sides = [bounds.left, bounds.right, bounds.bottom, bounds.top];
        if !sides.iter().all(|side| side.is_finite()) || bounds.left >= bounds.right || bounds.bottom >= bounds.top {
            return fault("map", format!("expected left below right and bottom below top, found {sides:?}"));
        }
        for (at, form) in obstacles.iter().enumerate() {
            form.check().or_else(|message| fault("obstacles", format!("obstacle {}: {message}", at + 1)))?;
        }
        check_library(library)?;
        let numbers_fit = match goal {
            Goal::Reach { centre, radius } => centre.iter().all(|at| at.is_finite()) && *radius > 0.0,
            Goal::Cover { cells, ratio } => {
                let count = u64::from(cells.columns) * u64::from(cells.rows);
                if !(1..=MOST_CELLS).contains(&count) || cells.side <= 0.0 {
                    return fault("cells", format!("expected 1 to {MOST_CELLS} cells, found {count}"));
                }
                ratio.is_finite() && *ratio >= 0.0
            }
        };
        if !numbers_fit {
            return fault("target", "expected a place and a radius above 0, or a share of the cells".to_owned());
        }
        let obstacles: Vec<Obstacle> = obstacles.iter().cloned().map(Obstacle::new).collect();
        for (robot, &[x, y, heading]) in start.iter().enumerate() {
            let robot = robot + 1;
            if !heading.is_finite() || !bounds.holds([x, y]) {
                return fault("start", format!("robot {robot} at ({x}, {y}): expected a place on the map"));
            }
            if let Some(at) = obstacles.iter().position(|obstacle| obstacle.crosses([x, y], [x, y])) {
                let message = format!("robot {robot} at ({x}, {y}): expected a free place, found obstacle {}", at + 1);
                return fault("start", message);
            }
        }
        let robots = start.len();
        Ok(Self {
            bounds: *bounds,
            obstacles,
            goal: *goal,
            laws: library.iter().map(|behaviour| behaviour.law(robots)).collect(),
            stop: library.iter().position(Behaviour::is_stop).map(|at| at as u8),
            library: library.clone(),
            start: (0..3).flat_map(|part| start.iter().map(move |pose| pose[part])).collect(),
            robots,
            decisions: *decisions,
            interval: *interval,
        })
    }

    /// Where robots may be.
    #[must_use]
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// What stands in the way.
    #[must_use]
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// What is to be done.
    #[must_use]
    pub fn goal(&self) -> &Goal {
        &self.goal
    }

    /// The behaviours.
    #[must_use]
    pub fn library(&self) -> &[Behaviour] {
        &self.library
    }

    /// The behaviour that leaves everything as it is, if the library has one.
    #[must_use]
    pub fn stop(&self) -> Option<u8> {
        self.stop
    }

    /// The state at the start, 3 M reals.
    #[must_use]
    pub fn start(&self) -> &[f64] {
        &self.start
    }

    /// How many robots there are, M.
    #[must_use]
    pub fn robots(&self) -> usize {
        self.robots
    }

    /// How many decision points there are, n.
    #[must_use]
    pub fn decisions(&self) -> u16 {
        self.decisions
    }

    /// Seconds between two decision points.
    #[must_use]
    pub fn interval(&self) -> f64 {
        f64::from(self.interval)
    }

    /// Steps between two decision points.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.interval * STEPS_PER_SECOND
    }

    /// How far a robot can come in one interval, metres.
    #[must_use]
    pub fn reach(&self) -> f64 {
        SPEED_LIMIT * self.interval()
    }

    /// The letters of a sequence.
    #[must_use]
    pub fn letters(&self, sequence: &[u8]) -> String {
        sequence.iter().filter_map(|&at| self.library.get(usize::from(at))).map(|behaviour| behaviour.letter).collect()
    }

    /// The sequence that letters stand for, or the first one that stands for nothing.
    ///
    /// # Errors
    /// The letter that no behaviour has.
    pub fn sequence(&self, letters: &str) -> Result<Vec<u8>, char> {
        let find = |letter| self.library.iter().position(|behaviour| behaviour.letter == letter).ok_or(letter);
        letters.chars().map(|letter| find(letter).map(|at| at as u8)).collect()
    }

    /// Words that the marks of visited cells take; 0 without a grid.
    #[must_use]
    pub fn words(&self) -> usize {
        match &self.goal {
            Goal::Reach { .. } => 0,
            Goal::Cover { cells, .. } => cells.words(),
        }
    }

    /// Marks the cells in which robots start; returns how many they are.
    ///
    /// - `state`: 3 M reals. `marks`: [`Task::words`] zeros.
    pub fn mark_start(&self, state: &[f64], marks: &mut [u64]) -> u32 {
        match &self.goal {
            Goal::Reach { .. } => 0,
            Goal::Cover { cells, .. } => {
                (0..self.robots).map(|robot| cells.mark_point(marks, [state[robot], state[self.robots + robot]])).sum()
            }
        }
    }

    /// Whether a state is in the goal set.
    ///
    /// - `visited`: marked cells; of no matter without a grid.
    #[must_use]
    pub fn is_goal(&self, state: &[f64], visited: u32) -> bool {
        match &self.goal {
            Goal::Reach { radius, .. } => self.farthest(state) < *radius,
            Goal::Cover { cells, ratio } => {
                f64::from(visited) >= ratio * f64::from(cells.columns) * f64::from(cells.rows)
            }
        }
    }

    /// Whether every robot stands on the map and outside all obstacles.
    #[must_use]
    pub fn is_free(&self, state: &[f64]) -> bool {
        (0..self.robots).all(|robot| {
            let at = [state[robot], state[self.robots + robot]];
            self.bounds.holds(at) && !self.obstacles.iter().any(|obstacle| obstacle.crosses(at, at))
        })
    }

    /// The distance of the farthest robot from the target's centre; 0 without a target.
    #[must_use]
    pub fn farthest(&self, state: &[f64]) -> f64 {
        let Goal::Reach { centre, .. } = &self.goal else { return 0.0 };
        let square = |robot: usize| {
            let (x, y) = (state[robot] - centre[0], state[self.robots + robot] - centre[1]);
            x * x + y * y
        };
        (0..self.robots).map(square).fold(0.0, f64::max).sqrt()
    }

    /// Makes one step of a behaviour, all robots at once.
    ///
    /// Returns how many cells are new, or what was touched first; the state is then that of the robots moved so far.
    ///
    /// - `behaviour`: an index of the library. `state`: 3 M reals. `marks`: [`Task::words`] words.
    ///
    /// # Errors
    /// The robot, and what it touched. Segments between the ends of steps are tested against obstacles, the ends
    /// themselves against the map; robots do not collide with each other.
    pub fn step(
        &self,
        behaviour: u8,
        state: &mut [f64],
        marks: &mut [u64],
        kernel: &mut Kernel,
    ) -> Result<u32, (u32, Touched)> {
        kernel.control(&self.laws[usize::from(behaviour)], state);
        let robots = self.robots;
        let mut new = 0;
        for robot in 0..robots {
            let from = [state[robot], state[robots + robot], state[2 * robots + robot]];
            let [x, y, theta] = kernel.moved(robot, from);
            state[robot] = x;
            state[robots + robot] = y;
            state[2 * robots + robot] = theta;
            let (from, to) = ([from[0], from[1]], [x, y]);
            if !self.bounds.holds(to) {
                return Err((robot as u32, Touched::Edge));
            }
            if let Some(at) = self.obstacles.iter().position(|obstacle| obstacle.touches(from, to)) {
                return Err((robot as u32, Touched::Obstacle(at as u32)));
            }
            if let Goal::Cover { cells, .. } = &self.goal {
                new += cells.mark_way(marks, from, to);
            }
        }
        Ok(new)
    }

    /// Lets a behaviour act for one interval.
    ///
    /// Returns the metres gone by all robots together (eqs. (17), (20)) and how many cells are new.
    ///
    /// - `state`, `marks`, `kernel`: as for [`Task::step`]; after a collision they are those of its moment.
    ///
    /// # Errors
    /// The first collision; the rest of the interval is not simulated.
    pub fn act(
        &self,
        behaviour: u8,
        state: &mut [f64],
        marks: &mut [u64],
        kernel: &mut Kernel,
    ) -> Result<(f64, u32), Collision> {
        kernel.start();
        if self.stop == Some(behaviour) {
            return Ok((0.0, 0)); // the state stays as it is, bit for bit
        }
        let mut new = 0;
        for step in 1..=self.steps() {
            let made = self.step(behaviour, state, marks, kernel);
            new += made.map_err(|(robot, touched)| Collision { step, robot, touched })?;
        }
        Ok((kernel.lengths().iter().sum(), new))
    }

    /// Foresees what a behaviour does in one interval, in a few long steps: a guess, never a fact of the model.
    ///
    /// Returns metres and new cells as [`Task::act`], or `None` when somebody touches something.
    ///
    /// - `steps`: how many, at least 1. `state`, `marks`, `kernel`: as for [`Task::step`].
    pub fn forecast(
        &self,
        behaviour: u8,
        steps: u32,
        state: &mut [f64],
        marks: &mut [u64],
        kernel: &mut Kernel,
    ) -> Option<(f64, u32)> {
        kernel.start();
        if self.stop == Some(behaviour) {
            return Some((0.0, 0));
        }
        let robots = self.robots;
        let seconds = self.interval() / f64::from(steps);
        let mut new = 0;
        for _ in 0..steps {
            kernel.control(&self.laws[usize::from(behaviour)], state);
            for robot in 0..robots {
                let from = [state[robot], state[robots + robot], state[2 * robots + robot]];
                let [x, y, theta] = kernel.moved_for(seconds, robot, from);
                state[robot] = x;
                state[robots + robot] = y;
                state[2 * robots + robot] = theta;
                let (from, to) = ([from[0], from[1]], [x, y]);
                if !self.bounds.holds(to) || self.obstacles.iter().any(|obstacle| obstacle.crosses(from, to)) {
                    return None;
                }
                if let Goal::Cover { cells, .. } = &self.goal {
                    new += cells.mark_way(marks, from, to);
                }
            }
        }
        Some((kernel.lengths().iter().sum(), new))
    }

    /// The same task with every obstacle grown, the target shrunk and more cells to be visited: what is feasible here
    /// is feasible there with something to spare.
    ///
    /// - `obstacle`, `target`: metres. `cover`: the share by which the number of cells to visit grows.
    ///
    /// # Errors
    /// A robot starts within the margin of an obstacle, or the target vanishes.
    pub fn with_margins(&self, obstacle: f64, target: f64, cover: f64) -> Result<Self, TaskError> {
        let mut parts = self.parts();
        parts.obstacles = parts.obstacles.iter().map(|form| form.grown(obstacle)).collect();
        match &mut parts.goal {
            Goal::Reach { radius, .. } => {
                if target >= *radius {
                    return fault("target", format!("expected a margin below the radius {radius} m, found {target} m"));
                }
                *radius -= target;
            }
            Goal::Cover { ratio, .. } => *ratio *= 1.0 + cover,
        }
        Self::new(&parts)
    }

    /// The parts it was made of.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let robots = self.robots;
        Parts {
            bounds: self.bounds,
            obstacles: self.obstacles.iter().map(|obstacle| obstacle.form().clone()).collect(),
            goal: self.goal,
            library: self.library.clone(),
            start: (0..robots).map(|at| [0, 1, 2].map(|part| self.start[part * robots + at])).collect(),
            decisions: self.decisions,
            interval: self.interval,
        }
    }
}
