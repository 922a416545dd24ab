//! The leaves of an agent's tree: conditions and primitive behaviours, with their arguments.

use std::fmt;

/// What a leaf does; its number is its bit in a set of names, part of no fingerprint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// Something of the argument's kind is sensed now.
    NeighbourObjects,
    /// The agent has sensed the place before.
    IsVisitedBefore,
    /// The agent carries the item.
    IsCarrying,
    /// A free item is within reach.
    IsCarryable,
    /// The agent stands where the place accepts drops.
    IsDropable,
    /// The agent is alive.
    CanMove,
    /// Always SUCCESS.
    DummyNode,
    /// One move towards a known place.
    MoveTowards,
    /// One move away from a sensed place.
    MoveAway,
    /// One move in a direction of its own.
    Explore,
    /// Picks up an item.
    CompositeSingleCarry,
    /// Puts down what is carried.
    CompositeDrop,
}

/// What a name takes after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// Nothing.
    Nothing,
    /// A place.
    Place,
    /// A kind of item.
    Item,
    /// Either, or nothing for any object.
    Object,
}

impl Name {
    /// Every name, in the order of their numbers.
    pub const ALL: [Self; 12] = [
        Self::NeighbourObjects,
        Self::IsVisitedBefore,
        Self::IsCarrying,
        Self::IsCarryable,
        Self::IsDropable,
        Self::CanMove,
        Self::DummyNode,
        Self::MoveTowards,
        Self::MoveAway,
        Self::Explore,
        Self::CompositeSingleCarry,
        Self::CompositeDrop,
    ];

    /// The name as the paper writes it.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::NeighbourObjects => "NeighbourObjects",
            Self::IsVisitedBefore => "IsVisitedBefore",
            Self::IsCarrying => "IsCarrying",
            Self::IsCarryable => "IsCarryable",
            Self::IsDropable => "IsDropable",
            Self::CanMove => "CanMove",
            Self::DummyNode => "DummyNode",
            Self::MoveTowards => "MoveTowards",
            Self::MoveAway => "MoveAway",
            Self::Explore => "Explore",
            Self::CompositeSingleCarry => "CompositeSingleCarry",
            Self::CompositeDrop => "CompositeDrop",
        }
    }

    /// What the name takes.
    #[must_use]
    pub fn takes(self) -> Takes {
        match self {
            Self::NeighbourObjects => Takes::Object,
            Self::IsVisitedBefore | Self::IsDropable | Self::MoveTowards | Self::MoveAway => Takes::Place,
            Self::IsCarrying | Self::IsCarryable | Self::CompositeSingleCarry | Self::CompositeDrop => Takes::Item,
            Self::CanMove | Self::DummyNode | Self::Explore => Takes::Nothing,
        }
    }

    /// True for the primitive behaviours, false for conditions.
    #[must_use]
    pub fn is_action(self) -> bool {
        self >= Self::MoveTowards
    }

    /// True for the behaviours that move, which take a [`Manner`] as their last word.
    #[must_use]
    pub fn moves(self) -> bool {
        matches!(self, Self::MoveTowards | Self::MoveAway | Self::Explore)
    }

    /// The name's bit in a set of names. `DummyNode` has none: it does not count for diversity.
    #[must_use]
    pub fn bit(self) -> u16 {
        if self == Self::DummyNode { 0 } else { 1 << self as u16 }
    }
}

/// What a leaf is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Object {
    /// For names that take nothing.
    Nothing,
    /// The nest at the origin.
    Hub,
    /// Where food lies at the start.
    Sites,
    /// The item of the foraging task.
    Food,
    /// The circle around the nest beyond which debris belongs.
    Boundary,
    /// The item of the nest-maintenance task.
    Debris,
    /// What bars the way.
    Obstacles,
    /// What kills on contact.
    Trap,
}

impl Object {
    /// Every argument a grammar may name.
    pub const ALL: [Self; 7] =
        [Self::Hub, Self::Sites, Self::Food, Self::Boundary, Self::Debris, Self::Obstacles, Self::Trap];

    /// The arguments that are places.
    pub const PLACES: [Self; 5] = [Self::Hub, Self::Sites, Self::Boundary, Self::Obstacles, Self::Trap];

    /// The arguments that are items.
    pub const ITEMS: [Self; 2] = [Self::Food, Self::Debris];

    /// The argument as the paper writes it; empty for [`Object::Nothing`].
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Nothing => "",
            Self::Hub => "Hub",
            Self::Sites => "Sites",
            Self::Food => "Food",
            Self::Boundary => "Boundary",
            Self::Debris => "Debris",
            Self::Obstacles => "Obstacles",
            Self::Trap => "Trap",
        }
    }
}

/// The part of a PPA structure that a leaf plays; only the feedback fitness reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tag {
    /// No part.
    None,
    /// A condition of a nominal tree.
    Cond,
    /// A precondition.
    Pre,
    /// A constraint.
    Con,
    /// A postcondition.
    Post,
    /// An action.
    Act,
}

impl Tag {
    /// Every tag a grammar may write.
    pub const ALL: [Self; 5] = [Self::Cond, Self::Pre, Self::Con, Self::Post, Self::Act];

    /// The tag as grammars write it; empty for [`Tag::None`].
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Cond => "Cond",
            Self::Pre => "Pre",
            Self::Con => "Con",
            Self::Post => "Post",
            Self::Act => "Act",
        }
    }
}

/// How a moving behaviour deals with what is ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Manner {
    /// It keeps clear of obstacles and traps, in PPA form.
    Avoid,
    /// It does not look.
    Normal,
}

impl Manner {
    /// Every manner a grammar may write.
    pub const ALL: [Self; 2] = [Self::Avoid, Self::Normal];

    /// The manner as grammars write it, after the place.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Avoid => "Avoid",
            Self::Normal => "Normal",
        }
    }
}

/// A leaf of an agent's tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Leaf {
    /// What it does.
    pub name: Name,
    /// What it is about.
    pub object: Object,
    /// Its part in the PPA structure.
    pub tag: Tag,
    /// Whether the status is turned round ("not").
    pub negated: bool,
    /// For what moves: [`Manner::Avoid`] unless the grammar says otherwise.
    pub manner: Manner,
}

impl Leaf {
    /// A number that tells the leaf from every other, for hashes.
    #[must_use]
    pub fn number(self) -> u64 {
        self.name as u64
            | (self.object as u64) << 8
            | (self.tag as u64) << 16
            | u64::from(self.negated) << 24
            | (self.manner as u64) << 25
    }
}

impl fmt::Display for Leaf {
    /// The leaf without its tag, such as `not IsCarrying Food`; of the manners only `Normal` shows.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let not = if self.negated { "not " } else { "" };
        let gap = if self.object == Object::Nothing { "" } else { " " };
        let manner = if self.manner == Manner::Normal { " Normal" } else { "" };
        write!(out, "{not}{}{gap}{}{manner}", self.name.text(), self.object.text())
    }
}
