//! What the commands of the command line share.

pub mod replay;
pub mod report;
pub mod run;
pub mod sequence;
pub mod study;
pub mod times;
pub mod tournament;

use std::fs;
use std::io::{Write, stdout};
use std::path::Path;

/// What went wrong: input that is refused, or cases that failed.
pub enum Failure {
    /// Input, with what is wrong and where.
    Input(String),
    /// Cases of a cases file.
    Cases,
}

/// Prints a line; a reader that went away (such as `head`) ends the program quietly.
pub fn print(line: &str) -> Result<(), Failure> {
    match writeln!(stdout(), "{line}") {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Input(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

pub fn read_file(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::Input(format!("cannot read {}: {error}", path.display())))
}

/// A failure that concerns a file.
pub fn in_file(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::Input(format!("{}: {error}", path.display()))
}
