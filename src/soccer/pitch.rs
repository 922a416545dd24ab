//! The pitch: where things are, in metres, with the origin at the centre, x to the right and y up.
//!
//! Source: the pitch of VSSSLeague/VSSReferee; its corners are the walls of FIRASim and rSim, at 45 degrees. The pitch
//! is the same after a mirror in either axis.

use super::view::{Ball, Pose};
use serde::Serialize;
use std::f64::consts::PI;

/// The lines of the left and the right goal are at -x and x.
pub const HALF_LENGTH: f64 = 0.75;
/// The side walls are at -y and y.
pub const HALF_WIDTH: f64 = 0.65;
/// The posts are at -y and y.
pub const GOAL_HALF: f64 = 0.20;
/// The back walls of the goals are at -x and x.
pub const GOAL_BACK: f64 = 0.85;
/// Goal areas begin at -x and x.
pub const AREA_X: f64 = 0.60;
/// Goal areas end at -y and y.
pub const AREA_HALF: f64 = 0.35;
/// The inner faces of the 45-degree walls in the corners are on `|x| + |y|` of this.
pub const CORNER: f64 = 1.318;
/// The side of a robot, which is a square.
pub const ROBOT: f64 = 0.075;
/// The radius of the ball.
pub const BALL_RADIUS: f64 = 0.0215;
/// The penalty marks are at (-x, 0) and (x, 0).
pub const PENALTY_X: f64 = 0.375;
/// The crosses for free balls are at (±x, ±y) of this.
pub const CROSS: [f64; 2] = [0.375, 0.40];
/// The dots for robots at a free ball are this far left and right of the cross.
pub const DOT: f64 = 0.20;
/// The radius of the centre circle, drawn only.
pub const CIRCLE_RADIUS: f64 = 0.20;
/// The arc at a goal area, drawn only: its centre is at (±x, 0).
pub const ARC_X: f64 = 0.675;
/// The radius of that arc.
pub const ARC_RADIUS: f64 = 0.125;
/// Half of the angle that the arc covers, radians.
pub const ARC_HALF_ANGLE: f64 = 0.9272;
/// The width of lines, drawn only.
pub const LINE_WIDTH: f64 = 0.006;

/// Half of the pitch, and the team that defends the goal there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// x below 0.
    Left,
    /// x above 0.
    Right,
}

impl Side {
    /// Both, in the order in which arrays hold them.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// The place in an array of both sides.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
        }
    }

    /// The other side.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// The sign of x in that half: -1 or 1.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }

    /// The half in which x lies; the halfway line belongs to the left, as in the quadrants.
    #[must_use]
    pub fn of(x: f64) -> Self {
        if x > 0.0 { Self::Right } else { Self::Left }
    }

    /// A place or velocity in the frame of the team that defends this side, or back: for the right one turned by 180
    /// degrees.
    ///
    /// Source: our choice: each team computes as if it defended the left goal.
    #[must_use]
    pub fn turned(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Left => [x, y],
            Self::Right => [-x, -y],
        }
    }

    /// A heading in the frame of the team that defends this side, or back, in `(-pi, pi]` if it was.
    #[must_use]
    pub fn turned_heading(self, heading: f64) -> f64 {
        match self {
            Self::Left => heading,
            Self::Right if heading > 0.0 => heading - PI,
            Self::Right => heading + PI,
        }
    }

    /// A ball in the frame of the team that defends this side, or back.
    #[must_use]
    pub fn turned_ball(self, ball: Ball) -> Ball {
        Ball { at: self.turned(ball.at), velocity: self.turned(ball.velocity) }
    }

    /// A robot in the frame of the team that defends this side, or back.
    #[must_use]
    pub fn turned_pose(self, pose: Pose) -> Pose {
        Pose {
            at: self.turned(pose.at),
            heading: self.turned_heading(pose.heading),
            velocity: self.turned(pose.velocity),
            spin: pose.spin,
        }
    }

    /// Whether a place is in this side's goal area; the goal behind it counts as well, the lines do not.
    #[must_use]
    pub fn has_in_area(self, [x, y]: [f64; 2]) -> bool {
        x * self.sign() > AREA_X && y.abs() < AREA_HALF
    }
}

/// The side in whose goal area a place is.
#[must_use]
pub fn area_of(at: [f64; 2]) -> Option<Side> {
    Side::BOTH.into_iter().find(|side| side.has_in_area(at))
}

/// The side in whose goal the ball is: all of it has crossed the line.
///
/// Source: VSSSLeague/VSSReferee, the checker of goals. The bound on y is wider than the mouth; the walls narrow it.
#[must_use]
pub fn goal_of([x, y]: [f64; 2]) -> Option<Side> {
    (x.abs() > HALF_LENGTH + BALL_RADIUS && y.abs() < AREA_HALF).then_some(Side::of(x))
}

/// A quarter of the pitch, numbered as the league does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(into = "u8")]
pub enum Quadrant {
    /// x > 0, y > 0.
    First = 1,
    /// x <= 0, y > 0.
    Second = 2,
    /// x <= 0, y <= 0.
    Third = 3,
    /// x > 0, y <= 0.
    Fourth = 4,
}

impl From<Quadrant> for u8 {
    fn from(quadrant: Quadrant) -> Self {
        quadrant.number()
    }
}

impl Quadrant {
    /// All four, by number.
    pub const ALL: [Self; 4] = [Self::First, Self::Second, Self::Third, Self::Fourth];

    /// The quadrant of a place.
    #[must_use]
    pub fn of([x, y]: [f64; 2]) -> Self {
        match (x > 0.0, y > 0.0) {
            (true, true) => Self::First,
            (false, true) => Self::Second,
            (false, false) => Self::Third,
            (true, false) => Self::Fourth,
        }
    }

    /// 1 to 4.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8
    }

    /// The half it lies in.
    #[must_use]
    pub const fn side(self) -> Side {
        match self {
            Self::First | Self::Fourth => Side::Right,
            Self::Second | Self::Third => Side::Left,
        }
    }

    /// The sign of y in it.
    #[must_use]
    pub const fn sign_y(self) -> f64 {
        match self {
            Self::First | Self::Second => 1.0,
            Self::Third | Self::Fourth => -1.0,
        }
    }

    /// The cross for free balls in it.
    #[must_use]
    pub fn cross(self) -> [f64; 2] {
        [CROSS[0] * self.side().sign(), CROSS[1] * self.sign_y()]
    }

    /// The quadrant as the team that defends `side` numbers it.
    #[must_use]
    pub const fn seen_from(self, side: Side) -> Self {
        match (side, self) {
            (Side::Left, same) => same,
            (Side::Right, Self::First) => Self::Third,
            (Side::Right, Self::Second) => Self::Fourth,
            (Side::Right, Self::Third) => Self::First,
            (Side::Right, Self::Fourth) => Self::Second,
        }
    }
}

/// The walls, from end to end each: the side walls, then for either half the back of the goal, its two sides, the two
/// parts of the end wall and the two 45-degree walls.
#[must_use]
pub fn walls() -> [[[f64; 2]; 2]; 16] {
    let (along, up) = (CORNER - HALF_WIDTH, CORNER - HALF_LENGTH);
    let mut walls = [[[0.0; 2]; 2]; 16];
    let mut at = 0;
    let mut put = |wall| {
        walls[at] = wall;
        at += 1;
    };
    for y in [-HALF_WIDTH, HALF_WIDTH] {
        put([[-along, y], [along, y]]);
    }
    for x in Side::BOTH.map(Side::sign) {
        put([[x * GOAL_BACK, -GOAL_HALF], [x * GOAL_BACK, GOAL_HALF]]);
        for y in [-1.0, 1.0] {
            put([[x * HALF_LENGTH, y * GOAL_HALF], [x * GOAL_BACK, y * GOAL_HALF]]);
            put([[x * HALF_LENGTH, y * GOAL_HALF], [x * HALF_LENGTH, y * up]]);
            put([[x * HALF_LENGTH, y * up], [x * along, y * HALF_WIDTH]]);
        }
    }
    walls
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrants_hold_their_borders_as_the_league_says() {
        for (at, quadrant) in [
            ([0.1, 0.1], Quadrant::First),
            ([0.0, 0.1], Quadrant::Second),
            ([-0.1, 0.0], Quadrant::Third),
            ([0.0, 0.0], Quadrant::Third),
            ([0.1, 0.0], Quadrant::Fourth),
        ] {
            assert_eq!(Quadrant::of(at), quadrant, "{at:?}");
        }
    }

    #[test]
    fn a_quadrant_seen_from_the_right_is_that_of_the_turned_place() {
        for quadrant in Quadrant::ALL {
            let turned = Side::Right.turned(quadrant.cross());
            assert_eq!(quadrant.seen_from(Side::Right), Quadrant::of(turned));
            assert_eq!(quadrant.seen_from(Side::Left), quadrant);
        }
    }

    #[test]
    fn goal_areas_hold_the_goal_but_not_their_lines() {
        assert_eq!(area_of([0.61, 0.34]), Some(Side::Right));
        assert_eq!(area_of([-0.80, 0.0]), Some(Side::Left));
        assert_eq!(area_of([0.60, 0.0]), None);
        assert_eq!(area_of([0.61, 0.35]), None);
        assert_eq!(goal_of([0.7715, 0.0]), None);
        assert_eq!(goal_of([0.7716, 0.0]), Some(Side::Right));
        assert_eq!(goal_of([-0.7716, 0.34]), Some(Side::Left));
    }

    #[test]
    fn every_end_of_a_wall_is_shared_by_two_walls() {
        let ends: Vec<[f64; 2]> = walls().into_iter().flatten().collect();
        for end in &ends {
            let near = |other: &&[f64; 2]| (other[0] - end[0]).abs() < 1e-12 && (other[1] - end[1]).abs() < 1e-12;
            assert_eq!(ends.iter().filter(near).count(), 2, "{end:?}");
        }
    }

    #[test]
    fn turned_headings_stay_within_one_turn() {
        for heading in [-3.0, -0.1, 0.0, 0.1, 3.0, PI] {
            let turned = Side::Right.turned_heading(heading);
            assert!(turned > -PI && turned <= PI, "{heading}: {turned}");
        }
    }
}
