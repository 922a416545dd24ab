//! When roles change: the conditions that both coaches ask.
//!
//! Every condition has an enter form, which is our choice since the paper prints none, and a leave form that holds more
//! easily: "more than" halved, "less than" times 1.5 (both adjustable). Numbers count outwards from the middle of the
//! pitch, so that "ball x < -0.60" reads "more than 0.60 deep" and its leave form "more than 0.30 deep".
//!
//! Where the words of a condition leave something open:
//!
//! | question | choice |
//! |---|---|
//! | "nearer to it in x", case (d) | any difference, also in the leave form |
//! | ahead by 0.25 s | at the ball's present speed; rolling takes 4 mm |
//! | nearer to the ball, `lost_ball` and `won_ball` | the nearest robot of each team, goalkeepers too |
//! | "out of the area", `penalty_over` | out of the strip between the mark and the goal, as wide as the goal area: that area itself ends short of the mark, so that the words would always hold |
//! | a condition about a role that nobody plays | does not hold |

use super::duties::{Pair, Role};
use super::geometry::{AREA_Y, FRAMES_PER_SECOND, MARK_X, OWN_GOAL, ROBOT, distance};
use super::margins::Margins;
use crate::soccer::view::{Pose, ROBOTS, View};

/// A condition that both coaches ask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Condition {
    /// Striker and Assistant should swap.
    SwapStrikerAssistant,
    /// Fullback and Wingback should swap.
    SwapFullbackWingback,
    /// Goalkeeper and Wingback should swap.
    SwapGoalkeeperWingback,
    /// The team should defend.
    LostBall,
    /// The team should attack.
    WonBall,
    /// The second Striker is no longer needed.
    TwoStrikersOver,
    /// The own penalty was kicked.
    KickOver,
    /// The opponents' penalty was kicked.
    PenaltyOver,
}

impl Condition {
    /// Every condition.
    pub const ALL: [Self; 8] = [
        Self::SwapStrikerAssistant,
        Self::SwapFullbackWingback,
        Self::SwapGoalkeeperWingback,
        Self::LostBall,
        Self::WonBall,
        Self::TwoStrikersOver,
        Self::KickOver,
        Self::PenaltyOver,
    ];

    /// The id in the table.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::SwapStrikerAssistant => "swap_st_as",
            Self::SwapFullbackWingback => "swap_fb_wb",
            Self::SwapGoalkeeperWingback => "swap_gk_wb",
            Self::LostBall => "lost_ball",
            Self::WonBall => "won_ball",
            Self::TwoStrikersOver => "two_strikers_over",
            Self::KickOver => "kick_over",
            Self::PenaltyOver => "penalty_over",
        }
    }

    /// The condition under which a pair swaps.
    #[must_use]
    pub fn of(pair: Pair) -> Self {
        match pair {
            Pair::StrikerAssistant => Self::SwapStrikerAssistant,
            Pair::FullbackWingback => Self::SwapFullbackWingback,
            Pair::GoalkeeperWingback => Self::SwapGoalkeeperWingback,
        }
    }
}

/// How strictly a condition is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// As the table has it.
    Enter,
    /// Holds more easily.
    Leave,
}

/// Seconds that the conditions look ahead.
const AHEAD: f64 = 0.25;

/// What the conditions are asked about.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// What the team sees.
    pub view: &'a View,
    /// Who plays what.
    pub roles: [Role; ROBOTS],
    /// How strict to be.
    pub margins: &'a Margins,
    /// The control frame of the last change of group since the last call.
    pub group_changed: Option<u32>,
}

/// Numbers of the table in one of the two forms.
struct Strictness {
    enter: f64,
    more: f64,
    less: f64,
}

impl Strictness {
    /// A difference that has to be exceeded.
    fn more(&self, by: f64) -> f64 {
        by * self.enter * self.more
    }

    /// A difference that has to be kept.
    fn less(&self, by: f64) -> f64 {
        by / self.enter * self.less
    }

    /// A place on the pitch beyond which something has to be.
    fn beyond(&self, place: f64) -> f64 {
        place * self.more
    }

    /// A place on the pitch within which something has to be.
    fn within(&self, place: f64) -> f64 {
        place * self.less
    }
}

impl Scene<'_> {
    /// True when both coaches may act on the condition: its enter form holds, and no lock is on.
    ///
    /// Swaps wait for the end of the lock-out after a placement, changes of group for the dwell after the last one.
    #[must_use]
    pub fn enters(&self, condition: Condition) -> bool {
        let unlocked = match condition {
            Condition::SwapStrikerAssistant | Condition::SwapFullbackWingback | Condition::SwapGoalkeeperWingback => {
                self.since() >= self.margins.lock_out
            }
            Condition::LostBall | Condition::WonBall => {
                self.group_changed.is_none_or(|frame| self.seconds_since(frame) >= self.margins.group_dwell)
            }
            Condition::TwoStrikersOver | Condition::KickOver | Condition::PenaltyOver => true,
        };
        unlocked && self.holds(condition, Form::Enter)
    }

    /// Whether a condition holds in one of its forms, whatever locks are on.
    #[must_use]
    pub fn holds(&self, condition: Condition, form: Form) -> bool {
        let Margins { enter, leave_more, leave_less, .. } = *self.margins;
        let strict = match form {
            Form::Enter => Strictness { enter, more: 1.0, less: 1.0 },
            Form::Leave => Strictness { enter, more: leave_more, less: leave_less },
        };
        match condition {
            Condition::SwapStrikerAssistant => self.swap_striker_assistant(&strict),
            Condition::SwapFullbackWingback => self.swap_fullback_wingback(&strict),
            Condition::SwapGoalkeeperWingback => self.swap_goalkeeper_wingback(&strict),
            Condition::LostBall => {
                let depth = -self.ball_ahead();
                depth > strict.more(0.12) || (depth > -strict.less(0.10) && self.advantage(false) > strict.more(0.08))
            }
            Condition::WonBall => {
                let depth = self.ball_ahead();
                depth > strict.more(0.12) || (depth > -strict.less(0.10) && self.advantage(true) > strict.more(0.08))
            }
            Condition::TwoStrikersOver => {
                self.view.ball.at[0] < strict.within(0.25) || self.since() >= strict.beyond(3.0)
            }
            Condition::KickOver => {
                distance(self.view.ball.at, [MARK_X, 0.0]) > strict.beyond(0.15) || self.since() >= strict.beyond(1.5)
            }
            Condition::PenaltyOver => {
                let ball = &self.view.ball;
                let leaves = ball.velocity[0] > 0.0 || ball.at[0] > -MARK_X || ball.at[1].abs() > AREA_Y;
                let moved = distance(ball.at, [-MARK_X, 0.0]) > strict.beyond(0.10);
                (moved && leaves) || self.since() >= strict.beyond(1.5)
            }
        }
    }

    /// Seconds of play since the last placement.
    #[must_use]
    pub fn since(&self) -> f64 {
        f64::from(self.view.since) / FRAMES_PER_SECOND
    }

    /// Seconds of play since an earlier control frame.
    #[must_use]
    pub fn seconds_since(&self, frame: u32) -> f64 {
        f64::from(self.view.frame.saturating_sub(frame)) / FRAMES_PER_SECOND
    }

    fn robot(&self, role: Role) -> Option<&Pose> {
        let robot = self.roles.iter().position(|other| *other == role)?;
        self.view.ours.get(robot)
    }

    /// Where the ball will be, along the pitch.
    fn ball_ahead(&self) -> f64 {
        self.view.ball.at[0] + AHEAD * self.view.ball.velocity[0]
    }

    /// By how much our nearest robot, or theirs, is nearer to the ball than the other team's.
    fn advantage(&self, ours: bool) -> f64 {
        let nearest = |robots: &[Pose; ROBOTS]| {
            robots.iter().map(|robot| distance(robot.at, self.view.ball.at)).fold(f64::INFINITY, f64::min)
        };
        let lead = nearest(&self.view.theirs) - nearest(&self.view.ours);
        if ours { lead } else { -lead }
    }

    fn swap_striker_assistant(&self, strict: &Strictness) -> bool {
        let (Some(striker), Some(assistant)) = (self.robot(Role::Striker), self.robot(Role::Assistant)) else {
            return false;
        };
        // Cases (a) to (d) of the table, in this order.
        let ([x, y], [sx, sy], [ax, ay]) = (self.view.ball.at, striker.at, assistant.at);
        let half = strict.more(ROBOT / 2.0);
        let level = (ay - y).abs() < strict.less(ROBOT);
        let behind = x - ax > half;
        let passed = sx - x > half;
        let assistant_leads = behind && ax - sx > half && level;
        let striker_passed = x > 0.0 && x < strict.within(0.56) && passed && behind && level;
        let striker_wide = x > strict.beyond(0.19)
            && sy.abs() > strict.beyond(0.35)
            && ay.abs() < strict.within(0.20)
            && y.abs() < strict.within(0.20)
            && level
            && ax < x;
        let both_passed = passed && ax - x > half && ax < sx;
        assistant_leads || striker_passed || striker_wide || both_passed
    }

    fn swap_fullback_wingback(&self, strict: &Strictness) -> bool {
        let (Some(fullback), Some(wingback)) = (self.robot(Role::Fullback), self.robot(Role::Wingback)) else {
            return false;
        };
        let ball = self.view.ball.at;
        ball[0] - fullback.at[0] > strict.more(ROBOT / 2.0)
            && distance(wingback.at, ball) - distance(fullback.at, ball) > strict.more(0.15)
    }

    fn swap_goalkeeper_wingback(&self, strict: &Strictness) -> bool {
        let (Some(keeper), Some(wingback)) = (self.robot(Role::Goalkeeper), self.robot(Role::Wingback)) else {
            return false;
        };
        let [x, y] = self.view.ball.at;
        let pulled_out = keeper.at[1].abs() > strict.beyond(0.20) || -keeper.at[0] < strict.within(0.60);
        -x > strict.beyond(0.60)
            && y.abs() > strict.beyond(0.25)
            && pulled_out
            && distance(keeper.at, OWN_GOAL) - distance(wingback.at, OWN_GOAL) > strict.more(ROBOT)
    }
}
