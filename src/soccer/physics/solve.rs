//! What touching does: sequential impulses for the velocities, then moves that take overlaps away.
//!
//! Source: our choice. Contacts are gone through in the order in which they were found, always the same.

use super::body::{BALL_MASS, Body};
use super::touch::Touch;
use super::{BALL, WALL};
use crate::fingerprint::Fingerprint;

/// Passes over the velocities, at most; they end earlier only when nothing changes any more.
const VELOCITY_PASSES: u32 = 8;
/// Passes over the places, at most.
const PLACE_PASSES: u32 = 6;
/// Changes of speed below this count as none, metres per second.
const STILL: f64 = 1e-3;
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

/// What the passes need of a touch along one axis.
#[derive(Clone, Copy, Debug)]
struct Axis {
    /// The unit vector, from `a` to `b`.
    along: [f64; 2],
    /// Change of each body's turn rate for a unit of impulse.
    turn_a: f64,
    turn_b: f64,
    /// How far off the axis the bodies' centres are.
    arm_a: f64,
    arm_b: f64,
    /// Change of the relative speed for a unit of impulse, and the inverse.
    change: f64,
    mass: f64,
    /// The impulse so far.
    impulse: f64,
}

/// A touch with what the passes need of it.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    key: u32,
    a: usize,
    b: usize,
    ease_a: f64,
    ease_b: f64,
    friction: f64,
    /// The speed at which the bodies shall part.
    part: f64,
    across: Axis,
    side: Axis,
}

/// Velocities and turn rates of all bodies; eight of them, so that an index with its upper bits cut is never beyond.
type Motions = [[f64; 3]; WALL + 1];

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl Axis {
    fn new(a: &Body, b: &Body, touch: &Touch, along: [f64; 2]) -> Self {
        let (arm_a, arm_b) = (cross(touch.from_a, along), cross(touch.from_b, along));
        let (turn_a, turn_b) = (arm_a * a.turn_ease, arm_b * b.turn_ease);
        let change = a.ease + b.ease + arm_a * turn_a + arm_b * turn_b;
        Self { along, turn_a, turn_b, arm_a, arm_b, change, mass: 1.0 / change, impulse: 0.0 }
    }

    /// The speed at which the bodies part along this axis.
    fn speed(&self, a: &[f64; 3], b: &[f64; 3]) -> f64 {
        self.along[0] * (b[0] - a[0]) + self.along[1] * (b[1] - a[1]) + self.arm_b * b[2] - self.arm_a * a[2]
    }
}

impl Contact {
    fn new(bodies: &[Body; WALL + 1], touch: &Touch) -> Self {
        let (a, b) = (&bodies[touch.a], &bodies[touch.b]);
        let normal = touch.normal;
        let of_ball = touch.a == BALL || touch.b == BALL;
        let friction = match (of_ball, touch.b == WALL) {
            (true, true) => BALL_WALL,
            (true, false) => BALL_ROBOT,
            (false, _) => ROBOT_ALL,
        };
        let mut contact = Self {
            key: touch.key,
            a: touch.a,
            b: touch.b,
            ease_a: a.ease,
            ease_b: b.ease,
            friction,
            part: 0.0,
            across: Axis::new(a, b, touch, normal),
            side: Axis::new(a, b, touch, [-normal[1], normal[0]]),
        };
        if of_ball && touch.b == WALL {
            let approach = -contact.across.speed(&motion(a), &motion(b));
            contact.part = if approach > BOUNCE_FROM { BOUNCE * approach } else { 0.0 };
        }
        contact
    }

    /// Begins with the impulses of the same contact in the substep before.
    fn begin(&mut self, old: &Self, motions: &mut Motions) {
        let (mut a, mut b) = (motions[self.a & WALL], motions[self.b & WALL]);
        self.across.impulse = old.across.impulse;
        self.side.impulse = old.side.impulse;
        push(&mut a, &mut b, &self.across, self.ease_a, self.ease_b, old.across.impulse);
        push(&mut a, &mut b, &self.side, self.ease_a, self.ease_b, old.side.impulse);
        motions[self.a & WALL] = a;
        motions[self.b & WALL] = b;
    }

    /// Takes in what the next substep needs of it.
    pub fn absorb(&self, hash: &mut Fingerprint) {
        hash.u32(self.key);
        hash.f64(self.across.impulse);
        hash.f64(self.side.impulse);
    }

    /// Brings this touch in order; returns whether that changed anything.
    fn pass(&mut self, motions: &mut Motions) -> bool {
        let (mut a, mut b) = (motions[self.a & WALL], motions[self.b & WALL]);
        let across = &mut self.across;
        let wanted = (across.impulse + (self.part - across.speed(&a, &b)) * across.mass).max(0.0);
        let pushed = wanted - across.impulse;
        across.impulse = wanted;
        push(&mut a, &mut b, across, self.ease_a, self.ease_b, pushed);
        let most = self.friction * wanted;
        let side = &mut self.side;
        let wanted = (side.impulse - side.speed(&a, &b) * side.mass).clamp(-most, most);
        let rubbed = wanted - side.impulse;
        side.impulse = wanted;
        push(&mut a, &mut b, side, self.ease_a, self.ease_b, rubbed);
        motions[self.a & WALL] = a;
        motions[self.b & WALL] = b;
        (pushed * self.across.change).abs() > STILL || (rubbed * self.side.change).abs() > STILL
    }
}

fn motion(body: &Body) -> [f64; 3] {
    [body.velocity[0], body.velocity[1], body.spin]
}

/// Gives `impulse` along the axis to `b`, and the opposite to `a`.
fn push(a: &mut [f64; 3], b: &mut [f64; 3], axis: &Axis, ease_a: f64, ease_b: f64, impulse: f64) {
    let (by_a, by_b) = (impulse * ease_a, impulse * ease_b);
    a[0] -= axis.along[0] * by_a;
    a[1] -= axis.along[1] * by_a;
    a[2] -= axis.turn_a * impulse;
    b[0] += axis.along[0] * by_b;
    b[1] += axis.along[1] * by_b;
    b[2] += axis.turn_b * impulse;
}

/// Changes velocities so that no two bodies move into each other, and rubs the ball's spin.
///
/// - `touches`: what [`super::touch::find`] found for `bodies`.
/// - `contacts`: those of the substep before, which become those of this one. What touched then begins with the impulses
///   of then, which for bodies that rest or push are nearly right.
/// - `before`: room to work in.
/// - `roll`: the ball's, see [`Body::brake`].
pub fn velocities(
    bodies: &mut [Body; WALL + 1],
    touches: &[Touch],
    contacts: &mut Vec<Contact>,
    before: &mut Vec<Contact>,
    roll: &mut [f64; 2],
) {
    std::mem::swap(contacts, before);
    contacts.clear();
    contacts.extend(touches.iter().map(|touch| Contact::new(bodies, touch)));
    let mut motions = [[0.0; 3]; WALL + 1];
    for (motion_of, body) in motions.iter_mut().zip(&*bodies) {
        *motion_of = motion(body);
    }
    // Both lists rise by key.
    let mut old = before.iter().peekable();
    for contact in contacts.iter_mut() {
        while old.next_if(|old| old.key < contact.key).is_some() {}
        if let Some(old) = old.next_if(|old| old.key == contact.key) {
            contact.begin(old, &mut motions);
        }
    }
    for _ in 0..VELOCITY_PASSES {
        let mut changed = false;
        for contact in contacts.iter_mut() {
            changed |= contact.pass(&mut motions);
        }
        if !changed {
            break;
        }
    }
    for (body, [x, y, spin]) in bodies.iter_mut().zip(motions) {
        body.velocity = [x, y];
        body.spin = spin;
    }
    for contact in contacts.iter().filter(|contact| contact.a == BALL || contact.b == BALL) {
        rub(roll, contact);
    }
}

/// Friction at an upright surface takes away spin that rolls into it or out of it, up to what it was pressed.
///
/// Source: our choice, held against rSim 1.2 in `tests/soccer_physics.rs`. A sphere that meets a surface with spin alone
/// keeps 2/7 of it, if the impulse suffices.
fn rub(roll: &mut [f64; 2], contact: &Contact) {
    let normal = contact.across.along;
    let into = dot(*roll, normal);
    let most = 2.5 * contact.friction * contact.across.impulse / BALL_MASS;
    let taken = (into * SPIN_TAKEN).clamp(-most, most);
    roll[0] -= normal[0] * taken;
    roll[1] -= normal[1] * taken;
}

/// Impulse for a unit of speed, across the surface.
fn felt(bodies: &[Body; WALL + 1], touch: &Touch) -> f64 {
    Axis::new(&bodies[touch.a], &bodies[touch.b], touch, touch.normal).mass
}

/// Moves bodies apart until no overlap is deeper than the slop; velocities stay as they are. Returns whether anything moved.
pub fn places(bodies: &mut [Body; WALL + 1], touches: &[Touch]) -> bool {
    if !touches.iter().any(|touch| touch.depth > SLOP) {
        return false;
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
            let excess = touch.depth - dot(gained, touch.normal) - SLOP;
            if excess <= 0.0 {
                continue;
            }
            deepest = deepest.max(excess);
            let push = excess * felt(bodies, touch);
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
    true
}
