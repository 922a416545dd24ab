//! Teams for tests: what is needed to play a match, as plain as can be.

use swarm_playground::soccer::Match;
use swarm_playground::soccer::pitch::Side;
use swarm_playground::soccer::view::{Lineup, Pose, ROBOTS, Slot, View, Wheels};

/// Robot 0 keeps the goal, 1 attacks, 2 supports, all where the table has them.
pub const PLAIN: Lineup = Lineup { slots: [Slot::Goalkeeper, Slot::Attacker, Slot::Supporter], spots: [None; ROBOTS] };

/// Nobody moves.
pub const STILL: [[Wheels; ROBOTS]; 2] = [[Wheels { left: 0.0, right: 0.0 }; ROBOTS]; 2];

/// Wheels that bring a robot to a place, forward or backward.
pub fn go(robot: &Pose, [x, y]: [f64; 2]) -> Wheels {
    let (sin, cos) = libm::sincos(robot.heading);
    let (dx, dy) = (x - robot.at[0], y - robot.at[1]);
    let (ahead, left) = (dx * cos + dy * sin, dy * cos - dx * sin);
    let distance = (dx * dx + dy * dy).sqrt().max(1e-6);
    let direction = if ahead < 0.0 { -1.0 } else { 1.0 };
    let turn = 12.0 * direction * left / distance;
    let speed = direction * (300.0 * distance).min(40.0) * (ahead.abs() / distance);
    Wheels { left: speed - turn, right: speed + turn }
}

/// Robot 0 keeps its goal, 1 goes behind the ball and through it, 2 waits behind it.
pub fn chase(view: &View) -> [Wheels; ROBOTS] {
    let [ball_x, ball_y] = view.ball.at;
    let [keeper, attacker, supporter] = &view.ours;
    let behind = attacker.at[0] < ball_x - 0.03 && (attacker.at[1] - ball_y).abs() < 0.05;
    let target = if behind { [ball_x + 0.2, ball_y * 0.8] } else { [ball_x - 0.10, ball_y] };
    [
        go(keeper, [-0.69, ball_y.clamp(-0.18, 0.18)]),
        go(attacker, target),
        go(supporter, [(ball_x - 0.35).max(-0.5), ball_y * 0.5]),
    ]
}

/// Plays until the match is over or so many frames have passed.
pub fn play(game: &mut Match, frames: u32) {
    for _ in 0..frames {
        if game.pending(Side::Left).is_some() {
            game.place(&[PLAIN; 2]);
        }
        if !game.step(&Side::BOTH.map(|side| chase(&game.view(side)))) {
            return;
        }
    }
}
