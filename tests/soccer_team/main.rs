//! Teams of the soccer: every row of the tables by hand-made views.

mod coaches;
mod conditions;
mod motion;
mod organisation;
mod roles;
mod stage;
mod starts;
mod team;
mod trees;
