//! Views made by hand, and a toy in which robots follow their wheels exactly.

use swarm_playground::random::{Purpose, Seed, Stream, stream};
use swarm_playground::soccer::team::roles::{Player, Roles, Scene};
use swarm_playground::soccer::team::{Margins, Role, Team, TeamKind};
use swarm_playground::soccer::view::{Ball, Call, Pose, ROBOTS, Restart, View, Wheels, Whose};

/// Seconds of a frame.
pub const FRAME: f64 = 1.0 / 60.0;

pub fn call(restart: Restart, taker: Whose, quadrant: u8, number: u32) -> Call {
    Call { restart, taker, quadrant, number }
}

pub fn at(x: f64, y: f64) -> Pose {
    Pose { at: [x, y], ..Pose::default() }
}

/// Ten seconds into play, the ball in the middle at rest, everybody out of the way.
pub fn view() -> View {
    View {
        frame: 600,
        since: 600,
        call: call(Restart::KickOff, Whose::Ours, 0, 1),
        ball: Ball::default(),
        ours: [at(-0.69, 0.0), at(-0.3, 0.5), at(-0.3, -0.5)],
        theirs: [at(0.69, 0.0), at(0.3, 0.6), at(0.3, -0.6)],
    }
}

pub fn with(ball: [f64; 2], velocity: [f64; 2], ours: [[f64; 2]; ROBOTS]) -> View {
    View { ball: Ball { at: ball, velocity }, ours: ours.map(|[x, y]| at(x, y)), ..view() }
}

pub fn penalties() -> Stream {
    stream(Seed::new(7).expect("below 2^53"), Purpose::Jitter, 0)
}

pub fn team(kind: TeamKind) -> Team {
    Team::new(kind, Margins::default(), None, None, penalties()).expect("a built-in team")
}

/// A team that started with a call at the view's places.
pub fn started(kind: TeamKind, view: &View) -> Team {
    let mut team = team(kind);
    team.called(view);
    team
}

/// One robot in a role, moved by its wheels without mass, slip or collisions.
pub struct Toy {
    pub roles: Roles,
    pub player: Player,
    pub view: View,
    pub told: [Role; ROBOTS],
    pub first_striker: Option<usize>,
}

impl Toy {
    /// Robot 1 plays `role`.
    pub fn new(role: Role, view: &View) -> Self {
        let roles = Roles::read(swarm_playground::soccer::team::roles::BUILT_IN).expect("the built-in roles");
        let told = [Role::Goalkeeper, role, Role::Assistant];
        Self { roles, player: Player::default(), view: *view, told, first_striker: None }
    }

    /// What the wheels are told in the present view; nothing moves.
    pub fn tell(&mut self) -> Wheels {
        let scene = Scene { view: &self.view, roles: self.told, first_striker: self.first_striker, penalty_side: 1.0 };
        self.player
            .play(&self.roles, &scene, 1, 16, &mut swarm_playground::bt::Silent)
            .expect("no tick ends with an error")
    }

    /// One frame: the wheels are told, the robot and the ball move.
    pub fn frame(&mut self) -> Wheels {
        let told = self.tell();
        let speed = (told.left + told.right) * 0.013;
        let turn = (told.right - told.left) * 0.026 / 0.08;
        let pose = &mut self.view.ours[1];
        let heading = pose.heading + turn * FRAME / 2.0;
        pose.velocity = [speed * libm::cos(heading), speed * libm::sin(heading)];
        pose.spin = turn;
        pose.heading += turn * FRAME;
        for axis in 0..2 {
            pose.at[axis] += pose.velocity[axis] * FRAME;
            self.view.ball.at[axis] += self.view.ball.velocity[axis] * FRAME;
        }
        self.view.frame += 1;
        self.view.since += 1;
        told
    }

    /// Frames until `done`, at most so many.
    pub fn run(&mut self, most: u32, mut done: impl FnMut(&Self) -> bool) -> Option<u32> {
        (0..most).find(|_| {
            self.frame();
            done(self)
        })
    }

    pub fn pose(&self) -> &Pose {
        &self.view.ours[1]
    }
}

pub fn gap(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}
