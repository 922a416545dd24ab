//! Bounds, meaning and source of every parameter of a match, in the order in which the page shows them.

use super::noise::MOST_DELAY;
use crate::parameter::{Apply, Kind, Parameter};

const TEAMS: &str = "Teams";
const MARGINS: &str = "When roles change";
const MATCH: &str = "Match";
const NOISE: &str = "Noise and losses";
const PHYSICS: &str = "Physics";
const LEAGUE: &str = "VSSSLeague/VSSReferee";
const OURS: &str = "our choice; zero gives matches without it";
const FIRASIM: &str = "our choice: none; FIRASim has it as an option";

/// All parameters.
#[must_use]
pub fn parameters() -> &'static [&'static [Parameter]] {
    &[TEAM_PARAMETERS, MARGIN_PARAMETERS, PARAMETERS]
}

/// A parameter that both teams have.
const fn kind(name: &'static str, label: &'static str) -> Parameter {
    Parameter {
        name,
        kind: Kind::Choice(&[
            ("tree", "Behaviour tree"),
            ("machine", "State machine"),
            ("tree-without-swaps", "Tree without swaps"),
            ("machine-without-swaps", "Machine without swaps"),
            ("tree-double-margins", "Tree, margins doubled"),
            ("chase", "Two chase the ball"),
            ("formation", "Formation, no coach"),
        ]),
        unit: "",
        apply: Apply::Restart,
        group: TEAMS,
        label,
        help: "Who gives out the roles. All but the two without a coach have the same roles, motion and conditions.",
        source: "Haug et al. 2024, sections 4 and 5: state machine and behaviour tree; the others are our choice",
    }
}

const fn trees(name: &'static str, label: &'static str, help: &'static str) -> Parameter {
    Parameter {
        name,
        kind: Kind::Text(100_000),
        unit: "",
        apply: Apply::Restart,
        group: TEAMS,
        label,
        help,
        source: "our choice",
    }
}

const COACH: &str = "BehaviorTree.CPP XML of a coach to play with in place of the built-in tree; empty for that one.";
const ROLES: &str = "BehaviorTree.CPP XML of the roles to play with in place of the built-in trees; empty for those.";

const TEAM_PARAMETERS: &[Parameter] = &[
    kind("blue", "Blue team"),
    kind("yellow", "Yellow team"),
    trees("blue-coach", "Blue coach tree", COACH),
    trees("yellow-coach", "Yellow coach tree", COACH),
    trees("blue-roles", "Blue role trees", ROLES),
    trees("yellow-roles", "Yellow role trees", ROLES),
];

const fn margin(
    name: &'static str,
    kind: Kind,
    unit: &'static str,
    label: &'static str,
    help: &'static str,
) -> Parameter {
    Parameter {
        name,
        kind,
        unit,
        apply: Apply::Restart,
        group: MARGINS,
        label,
        help,
        source: "our choice; the paper prints no conditions",
    }
}

const MARGIN_PARAMETERS: &[Parameter] = &[
    margin(
        "enter",
        Kind::real(0.1, 4.0, 10.0, 0.1),
        "",
        "Clearness",
        "How much clearer than in the table a difference must be before roles change; 1 is the table.",
    ),
    margin(
        "leave-more",
        Kind::real(0.0, 1.0, 1.0, 0.05),
        "",
        "Leaving, lower bounds",
        "Lower bounds of a condition times this must still hold for it to go on holding; 1 is no hysteresis.",
    ),
    margin(
        "leave-less",
        Kind::real(1.0, 3.0, 10.0, 0.05),
        "",
        "Leaving, upper bounds",
        "Upper bounds of a condition times this must still hold for it to go on holding; 1 is no hysteresis.",
    ),
    margin(
        "swap-dwell",
        Kind::real(0.0, 3.0, 60.0, 0.05),
        "s",
        "Rest after a swap",
        "Seconds before the same two robots may swap again, or a swap state be left.",
    ),
    margin(
        "group-dwell",
        Kind::real(0.0, 3.0, 60.0, 0.05),
        "s",
        "Rest after a change of group",
        "Seconds before attack and defence may change again.",
    ),
    margin(
        "lock-out",
        Kind::real(0.0, 3.0, 60.0, 0.05),
        "s",
        "Rest after a placement",
        "Seconds after the referee has placed the robots without any swap.",
    ),
];

const PARAMETERS: &[Parameter] = &[
    Parameter {
        name: "half-seconds",
        kind: Kind::int(1, 300, 3600),
        unit: "s",
        apply: Apply::Restart,
        group: MATCH,
        label: "Length of a half",
        help: "Seconds of play in each of the two halves. Waiting for the referee does not count.",
        source: LEAGUE,
    },
    Parameter {
        name: "knockout",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Restart,
        group: MATCH,
        label: "Knock-out game",
        help: "A tie leads to overtime and then to a shoot-out.",
        source: LEAGUE,
    },
    Parameter {
        name: "extra-seconds",
        kind: Kind::int(0, 180, 3600),
        unit: "s",
        apply: Apply::Restart,
        group: MATCH,
        label: "Length of a half of overtime",
        help: "Of knock-out games only. With 0 the shoot-out follows at once.",
        source: LEAGUE,
    },
    Parameter {
        name: "sides-exchanged",
        kind: Kind::Bool,
        unit: "",
        apply: Apply::Restart,
        group: MATCH,
        label: "Sides exchanged",
        help: "Blue defends the right goal instead of the left one. Coin, noise and motors stay with the sides, so the two \
               matches of a seed, one of them exchanged, give both teams the same luck.",
        source: "our choice: in the league blue defends the left goal",
    },
    Parameter {
        name: "vision-noise",
        kind: Kind::real(0.0, 10.0, 100.0, 0.1),
        unit: "mm",
        apply: Apply::Restart,
        group: NOISE,
        label: "Noise of places",
        help: "The standard deviation with which the camera sees where robots and ball are, in x and in y.",
        source: OURS,
    },
    Parameter {
        name: "heading-noise",
        kind: Kind::real(0.0, 5.0, 45.0, 0.1),
        unit: "degrees",
        apply: Apply::Restart,
        group: NOISE,
        label: "Noise of headings",
        help: "The standard deviation with which the camera sees where robots look.",
        source: OURS,
    },
    Parameter {
        name: "lost-detections",
        kind: Kind::real(0.0, 0.5, 1.0, 0.01),
        unit: "",
        apply: Apply::Restart,
        group: NOISE,
        label: "Lost detections",
        help: "The share of frames in which the camera misses a robot or the ball, and tells what it saw before.",
        source: FIRASIM,
    },
    Parameter {
        name: "wheel-noise",
        kind: Kind::real(0.0, 5.0, 20.0, 0.1),
        unit: "%",
        apply: Apply::Restart,
        group: NOISE,
        label: "Difference of motors",
        help: "The standard deviation of how fast a robot's motors turn when asked for the same; drawn once for each robot.",
        source: OURS,
    },
    Parameter {
        name: "placement-noise",
        kind: Kind::real(0.0, 10.0, 20.0, 0.1),
        unit: "mm",
        apply: Apply::Restart,
        group: NOISE,
        label: "Noise of placements",
        help: "The standard deviation with which robots and ball are placed, in x and in y, cut at three of them.",
        source: OURS,
    },
    Parameter {
        name: "lost-commands",
        kind: Kind::real(0.0, 0.5, 1.0, 0.01),
        unit: "",
        apply: Apply::Restart,
        group: NOISE,
        label: "Lost commands",
        help: "The share of frames in which a robot does not get its command, and goes on with the one before.",
        source: FIRASIM,
    },
    Parameter {
        name: "command-delay",
        kind: Kind::int(0, 10, MOST_DELAY as i64),
        unit: "frames",
        apply: Apply::Restart,
        group: NOISE,
        label: "Delay of commands",
        help: "Control frames of 1/60 s between what the camera sees and what the wheels do.",
        source: "our choice: one frame",
    },
    Parameter {
        name: "substeps",
        kind: Kind::int(1, 8, 32),
        unit: "substeps",
        apply: Apply::Restart,
        group: PHYSICS,
        label: "Substeps",
        help: "Steps of the physics in a control frame of 1/60 s. From 2 on, how often goals fall should not depend on them.",
        source: "our choice: in 4 substeps the ball moves by less than half of its radius each",
    },
];
