//! What touching does: sequential impulses for the velocities, then moves that take overlaps away.
//!
//! Source: soccer facts, section 4.3. Contacts are gone through in the order in which they were found, always the same.

use super::body::{BALL_MASS, Body};
use super::touch::Touch;
use super::{BALL, WALL};

/// Passes over the velocities, at most; they end earlier when nothing changes any more.
const VELOCITY_PASSES: u32 = 10;
/// Passes over the places, at most.
const PLACE_PASSES: u32 = 6;
/// Changes of speed below this count as none, metres per second.
const STILL: f64 = 1e-6;
/// An overlap that stays, so that what rests keeps touching, metres.
const SLOP: f64 = 0.0005;
/// The share of the ball's speed that a wall gives back.
const BOUNCE: f64 = 0.5;
/// The ball bounces above this speed only, metres per second; that of rSim.
const BOUNCE_FROM: f64 = 0.1;
/// Friction of the ball at walls; that of the peers.
const BALL_WALL: f64 = 1.0;
/// Friction of the ball at robots. No source says; our choice for smooth plastic.
const BALL_ROBOT: f64 = 0.5;
/// Friction of robots at robots and walls. No source says; our choice.
const ROBOT_ALL: f64 = 0.3;
/// What a wall leaves of the spin that rolls into it, if it is pressed hard enough: 1 - 5/7, about a third as measured.
const SPIN_TAKEN: f64 = 5.0 / 7.0;

/// A touch with what the passes need of it.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    touch: Touch,
    friction: f64,
    /// The speed at which the bodies shall part.
    part: f64,
    /// Impulse for a unit of speed, across the surface and along it.
    mass_across: f64,
    mass_along: f64,
    /// Impulses so far.
    across: f64,
    along: f64,
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Velocity of `b` less that of `a` where they touch.
fn apart(bodies: &[Body; WALL + 1], touch: &Touch) -> [f64; 2] {
    let (a, b) = (&bodies[touch.a], &bodies[touch.b]);
    [
        b.velocity[0] - b.spin * touch.from_b[1] - a.velocity[0] + a.spin * touch.from_a[1],
        b.velocity[1] + b.spin * touch.from_b[0] - a.velocity[1] - a.spin * touch.from_a[0],
    ]
}

/// Mass that an impulse along `axis` at the touch feels.
fn felt(bodies: &[Body; WALL + 1], touch: &Touch, axis: [f64; 2]) -> f64 {
    let (a, b) = (&bodies[touch.a], &bodies[touch.b]);
    let (arm_a, arm_b) = (cross(touch.from_a, axis), cross(touch.from_b, axis));
    1.0 / (a.ease + b.ease + arm_a * arm_a * a.turn_ease + arm_b * arm_b * b.turn_ease)
}

/// Gives `impulse` along `axis` to `b`, and the opposite to `a`.
fn push(bodies: &mut [Body; WALL + 1], touch: &Touch, axis: [f64; 2], impulse: f64) {
    for (body, from, impulse) in [(touch.a, touch.from_a, -impulse), (touch.b, touch.from_b, impulse)] {
        let body = &mut bodies[body];
        body.velocity[0] += axis[0] * impulse * body.ease;
        body.velocity[1] += axis[1] * impulse * body.ease;
        body.spin += cross(from, axis) * impulse * body.turn_ease;
    }
}

fn tangent(normal: [f64; 2]) -> [f64; 2] {
    [-normal[1], normal[0]]
}

/// Changes velocities so that no two bodies move into each other, and rubs the ball's spin.
///
/// - `touches`: what [`super::touch::find`] found for `bodies`.
/// - `contacts`: room to work in.
/// - `roll`: the ball's, see [`Body::brake`].
pub fn velocities(bodies: &mut [Body; WALL + 1], touches: &[Touch], contacts: &mut Vec<Contact>, roll: &mut [f64; 2]) {
    contacts.clear();
    for touch in touches {
        let approach = -along(apart(bodies, touch), touch.normal);
        let of_ball = touch.a == BALL || touch.b == BALL;
        let friction = match (of_ball, touch.b == WALL) {
            (true, true) => BALL_WALL,
            (true, false) => BALL_ROBOT,
            (false, _) => ROBOT_ALL,
        };
        let bounces = of_ball && touch.b == WALL && approach > BOUNCE_FROM;
        contacts.push(Contact {
            touch: *touch,
            friction,
            part: if bounces { BOUNCE * approach } else { 0.0 },
            mass_across: felt(bodies, touch, touch.normal),
            mass_along: felt(bodies, touch, tangent(touch.normal)),
            across: 0.0,
            along: 0.0,
        });
    }
    for _ in 0..VELOCITY_PASSES {
        let mut most: f64 = 0.0;
        for contact in contacts.iter_mut() {
            let normal = contact.touch.normal;
            let speed = along(apart(bodies, &contact.touch), normal);
            let wanted = (contact.across + (contact.part - speed) * contact.mass_across).max(0.0);
            let change = wanted - contact.across;
            contact.across = wanted;
            push(bodies, &contact.touch, normal, change);
            most = most.max((change / contact.mass_across).abs());

            let side = tangent(normal);
            let speed = along(apart(bodies, &contact.touch), side);
            let most_friction = contact.friction * contact.across;
            let wanted = (contact.along - speed * contact.mass_along).clamp(-most_friction, most_friction);
            let change = wanted - contact.along;
            contact.along = wanted;
            push(bodies, &contact.touch, side, change);
            most = most.max((change / contact.mass_along).abs());
        }
        if most < STILL {
            break;
        }
    }
    for contact in contacts.iter() {
        if contact.touch.a == BALL || contact.touch.b == BALL {
            rub(roll, contact);
        }
    }
}

fn along(vector: [f64; 2], axis: [f64; 2]) -> f64 {
    vector[0] * axis[0] + vector[1] * axis[1]
}

/// Friction at an upright surface takes away spin that rolls into it or out of it, up to what it was pressed.
///
/// Source: section 4.2, rows 9 to 11 and the note. A sphere that meets a surface with spin alone keeps 2/7 of it, if the
/// impulse suffices: that is the third which the note asks for.
fn rub(roll: &mut [f64; 2], contact: &Contact) {
    let normal = contact.touch.normal;
    let into = along(*roll, normal);
    let most = 2.5 * contact.friction * contact.across / BALL_MASS;
    let taken = (into * SPIN_TAKEN).clamp(-most, most);
    roll[0] -= normal[0] * taken;
    roll[1] -= normal[1] * taken;
}

/// Moves bodies apart until no overlap is deeper than the slop; velocities stay as they are.
pub fn places(bodies: &mut [Body; WALL + 1], touches: &[Touch]) {
    if !touches.iter().any(|touch| touch.depth > SLOP) {
        return;
    }
    let mut moved = [[0.0; 3]; WALL + 1];
    for _ in 0..PLACE_PASSES {
        let mut deepest: f64 = 0.0;
        for touch in touches {
            let ([ax, ay, turn_a], [bx, by, turn_b]) = (moved[touch.a], moved[touch.b]);
            let gained = [
                bx - turn_b * touch.from_b[1] - ax + turn_a * touch.from_a[1],
                by + turn_b * touch.from_b[0] - ay - turn_a * touch.from_a[0],
            ];
            let excess = touch.depth - along(gained, touch.normal) - SLOP;
            if excess <= 0.0 {
                continue;
            }
            deepest = deepest.max(excess);
            let push = excess * felt(bodies, touch, touch.normal);
            for (body, from, push) in [(touch.a, touch.from_a, -push), (touch.b, touch.from_b, push)] {
                let (ease, turn_ease) = (bodies[body].ease, bodies[body].turn_ease);
                moved[body][0] += touch.normal[0] * push * ease;
                moved[body][1] += touch.normal[1] * push * ease;
                moved[body][2] += cross(from, touch.normal) * push * turn_ease;
            }
        }
        if deepest < SLOP / 10.0 {
            break;
        }
    }
    for (body, [x, y, turn]) in bodies.iter_mut().zip(moved) {
        body.at = [body.at[0] + x, body.at[1] + y];
        if turn != 0.0 {
            body.turn(turn.clamp(-0.2, 0.2));
        }
    }
}
