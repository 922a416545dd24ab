//! Running a file of mapping cases (schema `ge-oracle/1`) against the mapper.

use super::{Grammar, Limits, Mapped, Mapper, Phenotype};
use crate::verdict::CaseVerdict;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A cases file: grammars by name, and cases with what the mapping must give.
#[derive(Clone, Debug, Deserialize)]
pub struct Cases {
    schema: String,
    grammars: BTreeMap<String, String>,
    #[serde(rename = "cases")]
    list: Vec<Case>,
}

#[derive(Clone, Debug, Deserialize)]
struct Case {
    id: String,
    grammar: String,
    codons: Vec<u64>,
    max_wraps: u32,
    max_depth: Option<u32>,
    expect: Expect,
}

#[derive(Clone, Debug, Deserialize)]
struct Expect {
    phenotype: Option<String>,
    used_codons: Option<u32>,
    depth: Option<u32>,
}

/// The most wraps a case may ask for: a runaway derivation ends within this many readings of its codons.
const MOST_WRAPS: u32 = 1000;

impl Cases {
    /// Reads a cases file.
    ///
    /// # Errors
    /// A sentence with line and column where the text is no JSON of this schema.
    pub fn read(json: &str) -> Result<Self, String> {
        let cases: Self = serde_json::from_str(json).map_err(|error| error.to_string())?;
        if cases.schema == "ge-oracle/1" {
            Ok(cases)
        } else {
            Err(format!("schema: expected \"ge-oracle/1\", found {:?}", cases.schema))
        }
    }

    /// Runs every case, in the file's order.
    #[must_use]
    pub fn run(&self) -> Vec<CaseVerdict> {
        let grammars: BTreeMap<&str, Result<Grammar, String>> = self
            .grammars
            .iter()
            .map(|(name, text)| (name.as_str(), Grammar::parse(text).map_err(|error| error.to_string())))
            .collect();
        let verdict = |case: &Case| CaseVerdict { id: case.id.clone(), fault: case.run(&grammars).err() };
        self.list.iter().map(verdict).collect()
    }
}

impl Case {
    fn run(&self, grammars: &BTreeMap<&str, Result<Grammar, String>>) -> Result<(), String> {
        let grammar = match grammars.get(self.grammar.as_str()) {
            None => return Err(format!("grammar: expected one of the file's grammars, found {:?}", self.grammar)),
            Some(Err(error)) => return Err(format!("grammar {}: {error}", self.grammar)),
            Some(Ok(grammar)) => grammar,
        };
        let codons: Vec<u16> = self
            .codons
            .iter()
            .enumerate()
            .map(|(at, &codon)| {
                u16::try_from(codon).map_err(|_| format!("codons[{at}]: expected 0 to 65535, found {codon}"))
            })
            .collect::<Result<_, _>>()?;
        if self.max_wraps > MOST_WRAPS {
            return Err(format!("max_wraps: expected at most {MOST_WRAPS}, found {}", self.max_wraps));
        }
        let limits = Limits { max_wraps: self.max_wraps, max_depth: self.max_depth.unwrap_or(Limits::ANY_DEPTH) };
        let mut phenotype = Phenotype::new(grammar);
        let found = Mapper::new(grammar).map(codons.as_slice(), limits, &mut phenotype);
        let found = match found {
            Ok(Mapped { used, depth }) => (Some(phenotype.text), Some(used), Some(depth)),
            Err(_) => (None, None, None),
        };
        let expected = (self.expect.phenotype.clone(), self.expect.used_codons, self.expect.depth);
        if found == expected {
            return Ok(());
        }
        let show = |(text, used, depth): (Option<String>, Option<u32>, Option<u32>)| match text {
            Some(text) => format!("{text:?}, {} codons used, depth {}", used.unwrap_or(0), depth.unwrap_or(0)),
            None => "invalid".to_owned(),
        };
        Err(format!("expected {}, found {}", show(expected), show(found)))
    }
}
