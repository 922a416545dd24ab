//! Grammars, the mapping and the genetic operators, against oracle cases and values worked by hand.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use rand::RngExt;
use swarm_playground::evolution::{
    Cases, Genome, Grammar, Invalid, Limits, Mapped, Mapper, Mutation, Phenotype, fittest, fixed_one_point, tournament,
    variable_one_point,
};
use swarm_playground::random::{Purpose, Seed, Stream, stream};

fn rng(index: u32) -> Stream {
    stream(Seed::new(5).expect("small"), Purpose::Evolution, index)
}

fn map(text: &str, codons: &[u16], max_wraps: u32, max_depth: u32) -> Result<(String, Mapped), Invalid> {
    let grammar = Grammar::parse(text).expect("a grammar");
    let mut phenotype = Phenotype::new(&grammar);
    let mapped = Mapper::new(&grammar).map(codons, Limits { max_wraps, max_depth }, &mut phenotype)?;
    Ok((phenotype.text, mapped))
}

#[test]
fn every_oracle_case_passes() {
    let cases = Cases::read(include_str!("cases/evolution.json")).expect("the file is valid");
    let verdicts = cases.run();
    assert_eq!(verdicts.len(), 36);
    for verdict in verdicts {
        assert_eq!(verdict.fault, None, "{}", verdict.id);
    }
}

#[test]
fn a_codon_is_used_where_a_rule_has_one_alternative() {
    // <a> takes codon 9 (9 mod 1 = 0), <b> takes 3 (3 mod 2 = 1).
    let (text, mapped) = map("<a> ::= (<b>)\n<b> ::= x | y", &[9, 3], 0, 9).expect("valid");
    assert_eq!((text.as_str(), mapped), ("(y)", Mapped { used: 2, depth: 3 }));
}

#[test]
fn wraps_read_the_codons_again_and_no_more_than_allowed() {
    let grammar = "<a> ::= <b><b><b>\n<b> ::= x | y";
    // Four expansions of two codons: 1 1 | 1 1 needs one wrap.
    assert_eq!(map(grammar, &[1, 1], 0, 9), Err(Invalid::CodonsUsedUp));
    assert_eq!(map(grammar, &[1, 1], 1, 9).expect("valid").0, "yyy");
    assert_eq!(map(grammar, &[], 5, 9), Err(Invalid::CodonsUsedUp));
}

#[test]
fn terminals_count_for_the_depth() {
    let grammar = "<a> ::= <b>\n<b> ::= x";
    assert_eq!(map(grammar, &[0, 0], 0, 3).expect("valid").1.depth, 3);
    assert_eq!(map(grammar, &[0, 0], 0, 2), Err(Invalid::TooDeep));
}

#[test]
fn remainders_are_exact_for_every_codon_and_small_rule() {
    for count in 1..=40_u16 {
        let digits: Vec<String> = (0..count).map(|n| n.to_string()).collect();
        let grammar = Grammar::parse(&format!("<a> ::= {}", digits.join("|"))).expect("a grammar");
        let mut mapper = Mapper::new(&grammar);
        for codon in (0..=u16::MAX).step_by(1 + usize::from(count)) {
            let mut phenotype = Phenotype::new(&grammar);
            let limits = Limits { max_wraps: 0, max_depth: 9 };
            mapper.map([codon].as_slice(), limits, &mut phenotype).expect("valid");
            assert_eq!(phenotype.text, (codon % count).to_string());
        }
    }
}

fn error(text: &str) -> String {
    Grammar::parse(text).expect_err("no grammar").to_string()
}

#[test]
fn grammar_errors_name_the_place() {
    assert_eq!(error(""), "line 1, column 1: expected at least one rule such as <start> ::= text, found none");
    assert_eq!(
        error("# only\n\n"),
        "line 2, column 1: expected at least one rule such as <start> ::= text, found none"
    );
    assert_eq!(error("<a> ::= x\nb ::= y"), "line 2, column 1: expected a rule that begins with <name>, found 'b'");
    assert_eq!(error("<a> := x"), "line 1, column 5: expected ::= after the rule's name, found ':'");
    assert_eq!(error("<a>"), "line 1, column 4: expected ::= after the rule's name, found the end of the line");
    assert_eq!(
        error("<a> ::= x<b"),
        "line 1, column 10: expected > to end the name that begins here, found the end of the line"
    );
    assert_eq!(error("<a> ::= x<>"), "line 1, column 10: expected a name between < and >, found none");
    assert_eq!(error("<a> ::= x |"), "line 1, column 12: expected an alternative, found nothing");
    assert_eq!(error("<a> ::= x | | y"), "line 1, column 13: expected an alternative, found nothing");
    assert_eq!(
        error("<a> ::= x\n <a> ::= y"),
        "line 2, column 2: expected each rule once, found <a> again (first in line 1)"
    );
    assert_eq!(
        error("<start> ::= <actoin>\n<action> ::= x"),
        "line 1, column 13: expected a defined rule, found <actoin>, did you mean <action>?"
    );
    assert_eq!(
        error("<a> ::= é<a>\n<b> ::= x"),
        "line 1, column 1: expected a rule that can end, found <a>, which always needs itself again"
    );
}

#[test]
fn a_line_that_begins_with_a_bar_continues_the_rule() {
    let grammar = Grammar::parse("<a> ::= x\n  | y\n# a comment\n  | z\r\n").expect("a grammar");
    assert_eq!(grammar.alternatives(swarm_playground::evolution::RuleId(0)).count(), 3);
}

#[test]
fn truncation_takes_the_best_and_of_equal_ones_the_first() {
    let (mut scratch, mut parents) = (vec![], vec![]);
    fittest(&[1.0, f64::NAN, 3.0, 2.0, 3.0, 2.0, 2.0], 4, &mut scratch, &mut parents);
    // Both 3.0 and the first two 2.0.
    assert_eq!(parents, [2, 3, 4, 5]);
    fittest(&[1.0, f64::NAN, 0.5], 2, &mut scratch, &mut parents);
    assert_eq!(parents, [0, 2]);
    fittest(&[f64::NAN], 2, &mut scratch, &mut parents);
    assert_eq!(parents, [0]);
    fittest(&[1.0, 2.0], 0, &mut scratch, &mut parents);
    assert!(parents.is_empty());
}

#[test]
fn fixed_crossover_keeps_the_length() {
    let mut rng = rng(6);
    let mother = Genome { codons: (0..10).collect(), used: 9 };
    let father = Genome { codons: (100..110).collect(), used: 5 };
    let (mut a, mut b) = (Genome::default(), Genome::default());
    for _ in 0..100 {
        fixed_one_point(&mut rng, [mother.view(), father.view()], 25, [&mut a, &mut b]);
        let cut = a.codons.iter().take_while(|&&codon| codon < 100).count();
        assert!((1..=5).contains(&cut));
        let expected: Vec<u16> = (0..cut as u16).chain(100 + cut as u16..110).collect();
        assert_eq!((a.codons.as_slice(), b.codons.len()), (expected.as_slice(), 10));
    }
}

#[test]
fn a_tournament_of_two_takes_the_best_of_three_with_probability_five_ninths() {
    let mut rng = rng(0);
    let won = (0..30_000).filter(|_| tournament(&mut rng, &[0.0, 2.0, 1.0], 2) == 1).count();
    // 1 - (2/3)^2 = 5/9; five standard errors of 30,000 draws are 0.0143.
    assert!((won as f64 / 30_000.0 - 5.0 / 9.0).abs() < 0.0143, "{won}");
}

#[test]
fn crossover_exchanges_the_tails_behind_cuts_in_the_used_part() {
    let mut rng = rng(1);
    let mother = Genome { codons: (0..10).collect(), used: 4 };
    let father = Genome { codons: (100..130).collect(), used: 2 };
    let (mut a, mut b) = (Genome::default(), Genome::default());
    let mut seen = [[false; 5]; 3];
    for _ in 0..200 {
        variable_one_point(&mut rng, [mother.view(), father.view()], 25, [&mut a, &mut b]);
        let cut = a.codons.iter().take_while(|&&codon| codon < 100).count();
        let other = b.codons.iter().take_while(|&&codon| codon >= 100).count();
        assert!((1..=4).contains(&cut) && (1..=2).contains(&other));
        seen[other][cut] = true;
        let expected: Vec<u16> = (0..cut as u16).chain(100 + other as u16..130).take(25).collect();
        assert_eq!(a.codons, expected);
        let expected: Vec<u16> = (100..100 + other as u16).chain(cut as u16..10).collect();
        assert_eq!(b.codons, expected);
    }
    assert_eq!(seen.iter().flatten().filter(|seen| **seen).count(), 8, "every pair of cuts comes up");
}

fn changed_share(mutation: &Mutation, before: u16, rng: &mut Stream) -> f64 {
    let mut changed = 0;
    for _ in 0..2000 {
        let mut codons = [before; 50];
        let mut mutating = mutation.begin(rng);
        for codon in &mut codons {
            mutating.pass(codon);
        }
        changed += codons.iter().map(|codon| (codon ^ before).count_ones()).sum::<u32>();
    }
    f64::from(changed) / (2000.0 * 50.0)
}

#[test]
fn bits_flip_at_their_rate() {
    let mut rng = rng(2);
    let share = changed_share(&Mutation::of_bits(0.01, 255), 0b1010_0110, &mut rng);
    // 8 bits x 0.01 a codon; five standard errors of 800,000 bits are 8 x 0.00056.
    assert!((share - 0.08).abs() < 0.0045, "{share}");
    assert!(changed_share(&Mutation::of_bits(0.0, 255), 7, &mut rng).abs() < 1e-12);
    assert!((changed_share(&Mutation::of_bits(1.0, 255), 7, &mut rng) - 8.0).abs() < 1e-12);
}

#[test]
fn codons_are_redrawn_at_their_rate() {
    let mut rng = rng(3);
    // A codon drawn again from 0 and 1 differs half of the time: one bit in 0.1 x 0.5 of the codons.
    let share = changed_share(&Mutation::of_codons(0.1, 1), 0, &mut rng);
    assert!((share - 0.05).abs() < 0.0035, "{share}");
}

#[test]
fn mutation_touches_only_what_the_mapping_reads() {
    let grammar = Grammar::parse("<a> ::= <b><b>\n<b> ::= x | y").expect("a grammar");
    let mut mapper = Mapper::new(&grammar);
    let mutation = Mutation::of_bits(1.0, 255);
    let mut rng = rng(4);
    let mut codons = vec![0_u16; 6];
    let mut phenotype = Phenotype::new(&grammar);
    let limits = Limits { max_wraps: 0, max_depth: 9 };
    let result = mapper.map((codons.as_mut_slice(), mutation.begin(&mut rng)), limits, &mut phenotype).expect("valid");
    assert_eq!(result.used, 3);
    assert_eq!(codons, [255, 255, 255, 0, 0, 0]);
    assert_eq!(phenotype.text, "yy");
    assert!(rng.random_bool(1.0));
}
