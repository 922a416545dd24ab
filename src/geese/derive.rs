//! A derivation step by step: which codon chose what, and which node of the tree, or rule of the machine, came of it.

use super::controller::Controller;
use super::inspect::{ShownNode, shown_nodes};
use super::language::Token;
use super::program::{Compiler, Sentences, needs_root};
use super::showmachine::ShownMachine;
use super::words::{self, Section};
use crate::evolution::{AlternativeId, Derivation, Genome, Invalid, Mapper, RuleId, TerminalId};
use serde::Serialize;

/// What a genome derives, valid or not.
#[derive(Clone, Debug, Serialize)]
pub struct Derived {
    valid: bool,
    reason: Option<String>,
    used: usize,
    depth: u32,
    phenotype: Option<String>,
    diversity: Option<f64>,
    steps: Vec<DerivedStep>,
    /// Of a tree.
    nodes: Option<Vec<ShownNode>>,
    /// Of a machine.
    machine: Option<ShownMachine>,
}

/// One expanded non-terminal.
#[derive(Clone, Debug, Serialize)]
pub struct DerivedStep {
    codon: usize,
    value: u16,
    rule: String,
    alternatives: usize,
    choice: usize,
    text: String,
    depth: u32,
    /// The innermost node, or the rule, that the step's text belongs to; `None` when the genome is invalid.
    node: Option<u32>,
}

impl Derived {
    /// Derives `codons`.
    #[must_use]
    pub fn of(compiler: &mut Compiler, codons: &[u16]) -> Self {
        let grammar = compiler.grammar().clone();
        let limits = compiler.limits();
        let mut steps = Steps { taken: Vec::new(), emitted: Vec::new() };
        let mapped = Mapper::new(&grammar).map(codons, limits, &mut steps);
        let nodes = mapped.is_ok().then(|| nodes_of_terminals(compiler.sentences(), &steps.emitted));
        let depth = steps.taken.iter().map(|step| step.depth + 1).max().unwrap_or(1);
        let shown = steps.taken.iter().enumerate().map(|(index, step)| {
            let alternatives: Vec<AlternativeId> = grammar.alternatives(step.rule).collect();
            DerivedStep {
                codon: index % codons.len().max(1),
                value: step.value,
                rule: grammar.rule_name(step.rule).to_owned(),
                alternatives: alternatives.len(),
                choice: alternatives.iter().position(|&id| id == step.alternative).unwrap_or(0),
                text: grammar.alternative_text(step.alternative),
                depth: step.depth,
                node: nodes.as_ref().and_then(|nodes| nodes.get(step.emitted).copied().flatten()),
            }
        });
        let steps: Vec<DerivedStep> = shown.collect();
        let mut controller = Controller::default();
        let mut genome = Genome { codons: codons.to_vec(), used: 0 };
        let survey = compiler.survey(&mut genome, None).filter(|_| compiler.compile(codons, &mut controller).is_ok());
        Self {
            valid: survey.is_some(),
            reason: mapped.err().map(|reason| match reason {
                Invalid::CodonsUsedUp => "codons used up".to_owned(),
                Invalid::TooDeep => format!("depth limit {} exceeded", limits.max_depth),
            }),
            used: steps.len(),
            depth,
            phenotype: survey.map(|_| controller.text()),
            diversity: survey.map(|survey| survey.diversity),
            steps,
            nodes: survey.and_then(|_| controller.tree().map(shown_nodes)),
            machine: match &controller {
                Controller::Machine(machine) => survey.map(|_| ShownMachine::of(machine)),
                Controller::Tree(_) => None,
            },
        }
    }
}

struct Taken {
    rule: RuleId,
    alternative: AlternativeId,
    value: u16,
    depth: u32,
    /// Terminals emitted before the step.
    emitted: usize,
}

struct Steps {
    taken: Vec<Taken>,
    emitted: Vec<TerminalId>,
}

impl Derivation for Steps {
    const TERMINALS: bool = true;

    fn expand(&mut self, rule: RuleId, alternative: AlternativeId, value: u16, depth: u32) {
        self.taken.push(Taken { rule, alternative, value, depth, emitted: self.emitted.len() });
    }

    fn terminal(&mut self, terminal: TerminalId) {
        self.emitted.push(terminal);
    }
}

/// For each terminal the node, or the rule, that what it begins with belongs to; `None` where only blanks follow.
fn nodes_of_terminals(sentences: &Sentences, terminals: &[TerminalId]) -> Vec<Option<u32>> {
    let (mut before, mut nodes) = (Vec::new(), Vec::new());
    match sentences {
        Sentences::Trees(language, _) => {
            let mut tokens = Vec::new();
            for terminal in terminals {
                before.push(tokens.len());
                tokens.extend_from_slice(&language.tokens[usize::from(terminal.0)]);
            }
            nodes = nodes_of_tokens(&tokens);
        }
        Sentences::Machines(rules) => {
            let mut begun = 0;
            for terminal in terminals {
                before.push(nodes.len());
                for token in &rules.tokens[usize::from(terminal.0)] {
                    begun += u32::from(*token == words::Token::Open(Section::From));
                    nodes.push(begun.saturating_sub(1));
                }
            }
        }
    }
    before.into_iter().map(|before| nodes.get(before).copied()).collect()
}

/// For each token the node it belongs to, numbered in preorder as the builder numbers them.
fn nodes_of_tokens(tokens: &[Token]) -> Vec<u32> {
    let root = needs_root(tokens);
    let (mut next, mut open) = (u32::from(root), if root { vec![0] } else { vec![] });
    let mut pending_leaf = None;
    let mut nodes = Vec::with_capacity(tokens.len());
    for (index, token) in tokens.iter().enumerate() {
        let node = match token {
            Token::Sequence | Token::Selector => {
                open.push(next);
                next += 1;
                next - 1
            }
            Token::CloseNode => open.pop().unwrap_or(0),
            Token::OpenTag(_) | Token::Not => *pending_leaf.get_or_insert(next),
            Token::Name(_) => {
                next += 1;
                pending_leaf = None;
                next - 1
            }
            // A closing tag, an argument or a manner belongs to the leaf just read.
            Token::Object(_) | Token::Manner(_) | Token::CloseTag => next.saturating_sub(1),
        };
        debug_assert_eq!(nodes.len(), index);
        nodes.push(node);
    }
    nodes
}
