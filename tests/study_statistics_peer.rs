//! The statistics of reports, against the crate `statrs`.
#![cfg(not(target_arch = "wasm32"))]

use proptest::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use statrs::function::beta::beta_reg;
use statrs::stats_tests::fisher::fishers_exact;
use statrs::stats_tests::ks_test::{KSTwoSampleAlternativeMethod, ks_twosample};
use statrs::stats_tests::mannwhitneyu::{MannWhitneyUMethod, mannwhitneyu};
use statrs::stats_tests::ttest_onesample::ttest_onesample;
use statrs::stats_tests::{Alternative, NaNPolicy};
use swarm_playground::study::statistics::{
    Summary, Tails, beta_inc, fisher, kolmogorov_smirnov, mann_whitney, normal_upper, one_sample_t, t_upper,
};

/// Both programs lose digits in the logarithm of the gamma function; p values are read to three.
const DIGITS: f64 = 1e-9;

fn agree(ours: f64, theirs: f64) -> Result<(), TestCaseError> {
    prop_assert!((ours - theirs).abs() <= DIGITS * theirs.abs().max(1.0), "{ours} and {theirs}");
    Ok(())
}

fn tails(p: Tails) -> [(f64, Alternative); 3] {
    [(p.two_sided, Alternative::TwoSided), (p.greater, Alternative::Greater), (p.less, Alternative::Less)]
}

proptest! {
    #[test]
    fn incomplete_beta(a in 0.3..80.0_f64, b in 0.3..80.0_f64, x in 0.0..=1.0_f64) {
        agree(beta_inc(a, b, x), beta_reg(a, b, x))?;
    }

    #[test]
    fn tails_of_student_and_normal(t in -9.0..9.0_f64, freedom in 1.0..400.0_f64) {
        agree(t_upper(t, freedom), StudentsT::new(0.0, 1.0, freedom).expect("valid").sf(t))?;
        agree(normal_upper(t), Normal::new(0.0, 1.0).expect("valid").sf(t))?;
    }

    #[test]
    fn fishers_test(a in 0..40_u32, b in 0..40_u32, c in 0..40_u32, d in 0..40_u32) {
        prop_assume!(a + b > 0 && c + d > 0 && a + c > 0 && b + d > 0);
        let table = [a, c, b, d].map(u64::from);
        for (ours, alternative) in tails(fisher((a, a + b), (c, c + d))) {
            agree(ours, fishers_exact(&table, alternative).expect("valid"))?;
        }
    }

    // Only with the first sample the longer: otherwise statrs 0.19 gives the complement of the exact tail (for 0 against
    // 1 to 18 it says p = 1 where one order of 19 is as extreme). The next law carries the agreement over.
    #[test]
    fn mann_whitney_exact(order in Just((0..19).map(f64::from).collect::<Vec<_>>()).prop_shuffle(), cut in 10..19_usize) {
        let (first, second) = order.split_at(cut);
        let test = mann_whitney(first, second).expect("neither is empty");
        prop_assert!(test.exact);
        for (ours, alternative) in tails(test.p) {
            let (_, theirs) = mannwhitneyu(first, second, MannWhitneyUMethod::Exact, alternative).expect("valid");
            agree(ours, theirs)?;
        }
    }

    #[test]
    fn exchanging_the_samples_exchanges_the_tails(
        order in Just((0..19).map(f64::from).collect::<Vec<_>>()).prop_shuffle(), cut in 1..19_usize,
    ) {
        let (first, second) = order.split_at(cut);
        let [ours, turned] = [mann_whitney(first, second), mann_whitney(second, first)].map(|test| test.expect("filled").p);
        agree(ours.greater, turned.less)?;
        agree(ours.less, turned.greater)?;
        agree(ours.two_sided, turned.two_sided)?;
    }

    #[test]
    fn mann_whitney_with_ties(first in prop::collection::vec(0..6_u8, 2..30), second in prop::collection::vec(0..6_u8, 2..30)) {
        let [first, second] = [first, second].map(|sample| sample.into_iter().map(f64::from).collect::<Vec<_>>());
        let test = mann_whitney(&first, &second).expect("neither is empty");
        prop_assume!(!test.exact && first.iter().chain(&second).any(|value| value.to_bits() != first[0].to_bits()));
        for (ours, alternative) in tails(test.p) {
            let method = MannWhitneyUMethod::AsymptoticInclContinuityCorrection;
            let (_, theirs) = mannwhitneyu(&first, &second, method, alternative).expect("valid");
            agree(ours, theirs.min(1.0))?;
        }
    }

    // Without ties: with them statrs looks also within a tie, where no sample can be compared.
    #[test]
    fn kolmogorov_smirnov_exact(
        order in Just((0..24).map(f64::from).collect::<Vec<_>>()).prop_shuffle(), cut in 1..24_usize,
    ) {
        let (first, second) = order.split_at(cut);
        let test = kolmogorov_smirnov(first, second).expect("neither is empty");
        let method = KSTwoSampleAlternativeMethod::TwoSidedExact;
        let (d, theirs) = ks_twosample(first.to_vec(), second.to_vec(), method, NaNPolicy::Error).expect("valid");
        agree(test.d, d)?;
        agree(test.p.two_sided, theirs)?;
        let turned = kolmogorov_smirnov(second, first).expect("neither is empty");
        agree(test.p.greater, turned.p.less)?;
    }

    #[test]
    fn one_sample(values in prop::collection::vec(-50.0..50.0_f64, 3..40), against in -20.0..20.0_f64) {
        let test = one_sample_t(&Summary::of(&values).expect("not empty"), against).expect("they vary");
        for (ours, alternative) in tails(test.p) {
            let (t, theirs) = ttest_onesample(values.clone(), against, alternative, NaNPolicy::Error).expect("valid");
            prop_assert!((t - test.t).abs() <= 1e-9 * t.abs().max(1.0));
            agree(ours, theirs)?;
        }
    }

    #[test]
    fn an_interval_of_a12_holds_it_and_turns_round_with_the_samples(
        first in prop::collection::vec(-9.0..9.0_f64, 1..20), second in prop::collection::vec(-9.0..9.0_f64, 1..20),
    ) {
        let [ours, turned] = [mann_whitney(&first, &second), mann_whitney(&second, &first)].map(|test| test.expect("filled").a12);
        prop_assert!(0.0 <= ours.low && ours.holds(ours.value) && ours.high <= 1.0);
        prop_assert!((ours.low + turned.high - 1.0).abs() < 1e-9 && (ours.high + turned.low - 1.0).abs() < 1e-9);
    }
}
