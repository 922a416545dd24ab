//! From the answers of both teams to where their robots are placed.

use super::arrangement::Arrangement;
use super::physics::{BALL, ROBOTS, WALL};
use super::pitch::Side;
use super::referee::{CLEARANCE, Decision, Forced, KeeperSide, Referee, ball_place, default_spot};
use super::view::{self, Ball, Lineup, Slot, Spot};

/// Overlaps below this come from rounding, metres.
const ROUNDING: f64 = 1e-9;

/// Where everything shall stand, and what of the teams' wishes was not taken.
#[derive(Clone, Debug)]
pub struct Placing {
    /// The places.
    pub arrangement: Arrangement,
    /// Why places are others than those asked for.
    pub forced: Vec<Forced>,
}

/// Places robots and ball for a decision.
///
/// - `lineups`: of the left and the right team, in the team's frame.
/// - `keeper`: where a goal kick is taken.
///
/// Source: VSSSLeague/VSSReferee, placements. A team whose own places are off the pitch or on the ball stands by the
/// table, the other does not (our choice: nobody shall gain by the other's fault). If two robots would then be closer than
/// [`CLEARANCE`], or overlap, both teams do.
#[must_use]
pub fn place(decision: &Decision, lineups: &[Lineup; 2], keeper: KeeperSide, referee: &Referee) -> Placing {
    let mut forced = Vec::new();
    let ball = Ball { at: ball_place(decision.kick, decision.taker, keeper), velocity: [0.0; 2] };
    let slots = Side::BOTH.map(|side| slots(lineups[side.index()].slots, side, referee, &mut forced));
    let table = Side::BOTH
        .map(|side| slots[side.index()].map(|slot| default_spot(decision.kick, decision.taker, keeper, side, slot)));
    let by_table = Arrangement { ball, robots: table };
    let mut arrangement = by_table;
    for side in Side::BOTH {
        let lineup = &lineups[side.index()];
        let mut own = by_table;
        for (robot, spot) in lineup.spots.iter().enumerate() {
            if let Some(spot) = spot {
                let at = side.turned(spot.at);
                own.robots[side.index()][robot] = Spot { at, heading: side.turned_heading(spot.heading) };
            }
        }
        match fault_of(&own, side) {
            Some(fault) => forced.push(fault),
            None => arrangement.robots[side.index()] = own.robots[side.index()],
        }
    }
    if arrangement != by_table
        && let Some(close) = too_close(&arrangement)
    {
        forced.push(close);
        arrangement = by_table;
    }
    Placing { arrangement, forced }
}

/// The slots of a team, or those that the referee deals: the goalkeeper is who was longest in the own area.
fn slots(wanted: [Slot; 3], side: Side, referee: &Referee, forced: &mut Vec<Forced>) -> [Slot; 3] {
    let has = |slot: Slot| wanted.contains(&slot);
    if has(Slot::Goalkeeper) && has(Slot::Attacker) && has(Slot::Supporter) {
        return wanted;
    }
    forced.push(Forced::Slots { side });
    let goalie = referee.goalie(side);
    let mut rest = [Slot::Attacker, Slot::Supporter].into_iter();
    std::array::from_fn(|robot| if robot == goalie { Slot::Goalkeeper } else { rest.next().unwrap_or(Slot::Supporter) })
}

/// What is wrong with a team's own places by themselves.
fn fault_of(own: &Arrangement, side: Side) -> Option<Forced> {
    let robots = side.index() * view::ROBOTS..(side.index() + 1) * view::ROBOTS;
    for robot in robots {
        let Spot { at, heading } = own.spot(robot);
        if !(at[0].is_finite() && at[1].is_finite() && heading.is_finite()) {
            return Some(Forced::OffPitch { robot });
        }
    }
    let overlaps = own.physics().overlaps().into_iter().filter(|overlap| overlap.depth > ROUNDING);
    for overlap in overlaps {
        let robot = overlap.a;
        match overlap.b {
            WALL if robot < ROBOTS && Arrangement::side(robot) == side => return Some(Forced::OffPitch { robot }),
            BALL if Arrangement::side(robot) == side => return Some(Forced::OnBall { robot }),
            _ => {}
        }
    }
    None
}

/// The first two robots that are closer than allowed or overlap.
fn too_close(arrangement: &Arrangement) -> Option<Forced> {
    let distance = |a: usize, b: usize| {
        let ([ax, ay], [bx, by]) = (arrangement.spot(a).at, arrangement.spot(b).at);
        libm::hypot(bx - ax, by - ay)
    };
    let overlaps = arrangement.physics().overlaps();
    for a in 0..ROBOTS {
        for b in a + 1..ROBOTS {
            let overlap = overlaps.iter().any(|found| found.a == a && found.b == b && found.depth > ROUNDING);
            if overlap || distance(a, b) < CLEARANCE {
                return Some(Forced::Close { robots: [a, b], distance: distance(a, b) });
            }
        }
    }
    None
}
