//! Bounds, meaning and source of every parameter, and the checks that concern several of them.

mod evolution;
mod published;
mod world;

use super::grammars::grammar_text;
use super::params::{MutationMode, Params, Task};
use super::program::Compiler;
use crate::evolution::Limits;
use crate::parameter::{Kind, Parameter, number, text};

const TABLE_1: &str = text("BeTr-GEESE, Table 1");

/// All parameters, in the order in which the page shows them.
#[must_use]
pub fn parameters() -> &'static [&'static [Parameter]] {
    &[world::PARAMETERS, evolution::PARAMETERS, published::PARAMETERS]
}

/// The switches to the authors' published code: name and choices of each.
pub fn switches() -> impl Iterator<Item = (&'static str, &'static [(&'static str, &'static str)])> {
    published::PARAMETERS.iter().filter_map(|parameter| match parameter.kind {
        Kind::Choice(choices) => Some((parameter.name, choices)),
        _ => None,
    })
}

impl Params {
    /// Compiles the grammar and checks what concerns several parameters; each alone is within its bounds.
    ///
    /// # Errors
    /// The field's name, what was found and what is allowed.
    pub fn check(&self) -> Result<Compiler, (&'static str, String)> {
        let limits = Limits { max_wraps: self.max_wraps, max_depth: self.max_depth };
        let mut compiler = Compiler::new(&grammar_text(&self.grammar, self.task), limits)
            .map_err(|error| ("grammar", error.to_string()))?;
        let least = compiler.grammar().least_depth();
        if self.max_depth < least {
            let message = format!(
                "expected at least {least}, the depth of the grammar's flattest program, found {}",
                self.max_depth
            );
            return Err(("max-depth", message));
        }
        self.check_fit()?;
        compiler.count_by(self.diversity);
        Ok(compiler)
    }

    /// Checks what concerns several parameters but not the grammar: all that a live change can upset, at little cost.
    ///
    /// # Errors
    /// As [`Params::check`].
    pub fn check_fit(&self) -> Result<(), (&'static str, String)> {
        if self.mutation_mode == MutationMode::Bit && !(u32::from(self.codon_max) + 1).is_power_of_two() {
            let message = format!(
                "expected one less than a power of two (1, 3, 7 ... 65535) while mutation flips bits, found {}",
                self.codon_max
            );
            return Err(("codon-max", message));
        }
        let reach = self.site_distance + self.site_radius;
        if self.task == Task::Nest && self.boundary_radius > self.half() {
            let message = format!(
                "expected at most {}, half the arena's side, found {}",
                number(self.half()),
                number(self.boundary_radius)
            );
            return Err(("boundary-radius", message));
        }
        if self.task == Task::Forage && reach > self.half() {
            let message = format!(
                "expected at most {}, so that a site of radius {} lies inside the arena, found {}",
                number(self.half() - self.site_radius),
                number(self.site_radius),
                number(self.site_distance)
            );
            return Err(("site-distance", message));
        }
        if self.hub_radius > self.half() {
            let message = format!(
                "expected at most {}, half the arena's side, found {}",
                number(self.half()),
                number(self.hub_radius)
            );
            return Err(("hub-radius", message));
        }
        Ok(())
    }
}
