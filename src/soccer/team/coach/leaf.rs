//! The leaves of coach trees.

use crate::bt::xml::{Direction, Manifest, NodeKind, Port, PortType};
use crate::soccer::team::conditions::Condition;
use crate::soccer::team::duties::{Pair, Role};
use crate::soccer::view::ROBOTS;

/// A leaf of a coach tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaf {
    /// A call of the referee has not been dealt with.
    RefereeEventPending,
    /// Gives out the roles of a start: the call's, or those named.
    AssignStartRoles(Option<[Role; ROBOTS]>),
    /// The call has been dealt with.
    ConsumeEvent,
    /// A condition of the coaches holds.
    Holds(Condition),
    /// The two robots should exchange their roles, and the latch of the pair is open.
    ShouldSwap(Pair),
    /// The two robots exchange their roles.
    Swap(Pair),
    /// Every robot takes the role that belongs to its own in the other group.
    ChangeGroup,
    /// The robot with the first role, of several the one farthest from the ball, takes the second.
    Become(Role, Role),
}

/// The nodes that coach trees can be made of: the built-ins and the leaves.
///
/// # Panics
/// Never: the names are allowed and differ, which a test checks.
#[must_use]
pub fn manifest() -> Manifest {
    let role = |name: &str, description: &str| Port::new(name, Direction::In, PortType::Text, description);
    let pair = || vec![role("first", "a role"), role("second", "the role it is exchanged with")];
    let leaves = [
        ("RefereeEventPending", NodeKind::Condition, vec![]),
        (
            "AssignStartRoles",
            NodeKind::Action,
            vec![role("roles", "goalkeeper;ball player;supporter, instead of the call's").optional()],
        ),
        ("ConsumeEvent", NodeKind::Action, vec![]),
        ("LostBall", NodeKind::Condition, vec![]),
        ("WonBall", NodeKind::Condition, vec![]),
        ("TwoStrikersOver", NodeKind::Condition, vec![]),
        ("KickOver", NodeKind::Condition, vec![]),
        ("PenaltyOver", NodeKind::Condition, vec![]),
        ("ShouldSwap", NodeKind::Condition, pair()),
        ("Swap", NodeKind::Action, pair()),
        ("ChangeGroup", NodeKind::Action, vec![]),
        (
            "Become",
            NodeKind::Action,
            vec![
                role("role", "the role before; of several robots the farthest from the ball"),
                role("into", "the role after"),
            ],
        ),
    ];
    let mut manifest = Manifest::default();
    for (name, kind, ports) in leaves {
        manifest.register(name, kind, ports).expect("the names are allowed and differ");
    }
    manifest
}
