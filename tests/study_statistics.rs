//! The statistics of reports, against values worked by hand.

#![expect(clippy::float_cmp, reason = "some results are exact")]

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use swarm_playground::study::statistics::{
    StudentTest, Summary, difference_interval, fisher, kolmogorov_smirnov, mann_whitney, mean_interval, one_sample_t,
    quantile, sign_test, t_quantile, welch_t, wilson,
};

/// Equal to within half of the last digit that the expected value is given with.
fn near(found: f64, expected: f64, half_digit: f64) {
    assert!((found - expected).abs() <= half_digit, "expected {expected}, found {found}");
}

#[test]
fn the_published_t_of_the_coach_study_has_the_published_p() {
    // 250 matches: t = 2.842 with df 249; the paper prints both tails.
    let test = StudentTest::of(2.842, 249.0);
    near(test.p.greater, 0.00243, 5e-6);
    near(test.p.two_sided, 0.00485, 5e-6);
    near(test.p.less, 1.0 - 0.00243, 5e-6);
}

#[test]
fn the_published_summary_of_the_coach_study_gives_its_test_and_what_we_add() {
    // Haug et al., table 2: the mean goal difference of 250 games is 0.2120, its standard deviation 1.1794.
    let none = Summary::of(&[0.0]).expect("not empty");
    let games = Summary { count: 250, mean: 0.212, deviation: 1.1794, ..none };
    let test = one_sample_t(&games, 0.0).expect("they vary");
    near(test.t, 2.842, 5e-4);
    assert_eq!(test.freedom, 249.0);
    near(test.p.greater, 0.00243, 5e-6);
    near(test.p.two_sided, 0.00485, 5e-6);
    let interval = mean_interval(&games).expect("two numbers or more");
    near(interval.low, 0.065, 5e-4);
    near(interval.high, 0.359, 5e-4);
    near(games.mean / games.deviation, 0.18, 5e-3);
    // 87 wins and 57 losses.
    near(sign_test(87, 57).two_sided, 0.015, 5e-4);
}

#[test]
fn signs_are_a_coin() {
    // 8 of 10: 45 + 10 + 1 of 1024 ways are 8 heads or more.
    let test = sign_test(8, 2);
    near(test.greater, 56.0 / 1024.0, 1e-12);
    near(test.two_sided, 112.0 / 1024.0, 1e-12);
    // 2 heads or more: all but 1 + 10.
    near(test.less, 1013.0 / 1024.0, 1e-12);
    assert_eq!((sign_test(0, 0).two_sided, sign_test(3, 3).two_sided), (1.0, 1.0));
}

#[test]
fn kolmogorov_smirnov_counts_ways_to_deal_with_and_without_ties() {
    // Of C(4, 2) = 6 ways one has all of the first below the second, one all above.
    let test = kolmogorov_smirnov(&[2.0, 1.0], &[3.0, 4.0]).expect("neither is empty");
    assert_eq!((test.d, test.p.greater), (1.0, 1.0));
    near(test.p.two_sided, 2.0 / 6.0, 1e-12);
    near(test.p.less, 1.0 / 6.0, 1e-12);
    // With two values alone it is the lady tasting tea: 1 of 4 against 3 of 4.
    let test = kolmogorov_smirnov(&[0.0, 0.0, 0.0, 1.0], &[0.0, 1.0, 1.0, 1.0]).expect("neither is empty");
    assert_eq!(test.d, 0.5);
    near(test.p.two_sided, 34.0 / 70.0, 1e-12);
    near(test.p.less, 17.0 / 70.0, 1e-12);
    near(test.p.greater, 1.0, 1e-12);
    // Counted by dealing {0, 0, 1, 1, 1, 2, 2, 3, 3, 3, 4} out in all C(11, 6) = 462 ways: 122 are as far apart, 81 of
    // them with the first below.
    let test = kolmogorov_smirnov(&[0.0, 1.0, 1.0, 2.0, 3.0, -0.0], &[2.0, 3.0, 3.0, 4.0, 1.0]).expect("filled");
    // Up to 1 there are 4 of 6 and 1 of 5.
    near(test.d, 4.0 / 6.0 - 1.0 / 5.0, 1e-12);
    near(test.p.two_sided, 122.0 / 462.0, 1e-12);
    near(test.p.less, 81.0 / 462.0, 1e-12);
    let same = kolmogorov_smirnov(&[2.0; 5], &[2.0; 9]).expect("neither is empty");
    assert_eq!((same.d, same.p.two_sided), (0.0, 1.0));
    assert!(kolmogorov_smirnov(&[], &[1.0]).is_none());
}

#[test]
fn wilson_intervals_of_the_papers_64_runs() {
    // 48 of 64: centre (0.75 + 3.84146/128) / (1 + 3.84146/64) = 0.780011 / 1.060023 = 0.735844,
    // half 1.95996 sqrt(0.75 0.25 / 64 + 3.84146 / 16384) / 1.060023 = 0.104007.
    let well = wilson(48, 64);
    near(well.low, 0.631_837, 2e-6);
    near(well.high, 0.839_851, 2e-6);
    // 6 of 64, in per cent as the paper's reader sees them: 4 to 19.
    let badly = wilson(6, 64);
    assert_eq!([badly.low, badly.high].map(|end| (end * 100.0).round()), [4.0, 19.0]);
    assert_eq!([well.low, well.high].map(|end| (end * 100.0).round()), [63.0, 84.0]);
    // At the ends: 0 of n reaches to z^2 / (n + z^2) = 3.84146 / 13.84146.
    let none = wilson(0, 10);
    assert_eq!((none.value, none.low), (0.0, 0.0));
    near(none.high, 0.277_533, 5e-7);
    near(wilson(10, 10).low, 1.0 - 0.277_533, 5e-7);
    assert_eq!((wilson(0, 0).low, wilson(0, 0).high), (0.0, 1.0));
}

#[test]
fn newcombes_published_examples_of_a_difference() {
    // Newcombe (1998), table II, method 10: 56/70 - 48/80 gives 0.0524 to 0.3339, 10/10 - 0/20 gives 0.6791 to 1.
    let interval = difference_interval((56, 70), (48, 80));
    near(interval.value, 0.2, 1e-12);
    near(interval.low, 0.0524, 5e-5);
    near(interval.high, 0.3339, 5e-5);
    let interval = difference_interval((10, 10), (0, 20));
    near(interval.low, 0.6791, 5e-5);
    near(interval.high, 1.0, 1e-12);
}

#[test]
fn the_lady_tasting_tea() {
    // 3 of 4 against 1 of 4: C(4,3) C(4,1) / C(8,4) = 16/70, C(4,4) C(4,0) / 70 = 1/70.
    let p = fisher((3, 4), (1, 4));
    near(p.greater, 17.0 / 70.0, 1e-12);
    near(p.less, 69.0 / 70.0, 1e-12);
    near(p.two_sided, 34.0 / 70.0, 1e-12);
    let same = fisher((0, 5), (0, 9));
    assert!((same.two_sided - 1.0).abs() < 1e-12, "no success at all says nothing: {same:?}");
}

#[test]
fn mann_whitney_without_ties_counts_orders() {
    // Of C(6,3) = 20 orders one has all of the first below the second.
    let test = mann_whitney(&[1.0, 3.0, 2.0], &[6.0, 4.0, 5.0]).expect("neither is empty");
    assert_eq!((test.u, test.exact, test.a12.value), (0.0, true, 0.0));
    near(test.p.less, 1.0 / 20.0, 1e-12);
    near(test.p.two_sided, 2.0 / 20.0, 1e-12);
    near(test.p.greater, 1.0, 1e-12);
    assert!(test.a12.low == 0.0 && test.a12.high > 0.3, "three against three leave much open: {:?}", test.a12);
    // 1, 2, 5 against 3, 4: U = 2 of 6. Orders with U = 0, 1, 2: 1 + 1 + 2 of C(5,2) = 10.
    let test = mann_whitney(&[1.0, 2.0, 5.0], &[3.0, 4.0]).expect("neither is empty");
    assert_eq!(test.u, 2.0);
    near(test.p.less, 0.4, 1e-12);
    near(test.p.greater, 0.8, 1e-12);
}

#[test]
fn mann_whitney_with_ties_is_normal_with_both_corrections() {
    // Ranks of 1, 2, 2 among {1, 2, 2, 2, 3}: 1 + 3 + 3 = 7, U = 7 - 6 = 1, expected 3. Ties of three: 27 - 3 = 24.
    // Variance 6/12 (6 - 24/20) = 2.4, z = (2 - 0.5) / 1.549193 = 0.968246; twice its tail is 0.33292.
    let test = mann_whitney(&[1.0, 2.0, 2.0], &[2.0, 3.0]).expect("neither is empty");
    assert_eq!((test.u, test.exact), (1.0, false));
    near(test.p.two_sided, 0.332_92, 5e-6);
    let same = mann_whitney(&[1.0; 8], &[1.0; 5]).expect("neither is empty");
    assert_eq!((same.a12.value, same.p.two_sided), (0.5, 1.0));
    assert!(mann_whitney(&[], &[1.0]).is_none());
}

#[test]
fn t_tests_of_samples_small_enough_for_a_pencil() {
    let summary = Summary::of(&[5.0, 1.0, 3.0, 2.0, 4.0]).expect("not empty");
    // Mean 3, variance 10/4; t = (3 - 2) / sqrt(2.5 / 5) = sqrt 2.
    assert_eq!((summary.mean, summary.median, summary.lower, summary.upper), (3.0, 3.0, 2.0, 4.0));
    let test = one_sample_t(&summary, 2.0).expect("five numbers");
    near(test.t, std::f64::consts::SQRT_2, 1e-12);
    assert_eq!(test.freedom, 4.0);
    // Of two degrees of freedom P(T > t) = 1/2 - t / (2 sqrt(2 + t^2)): at sqrt 2, 1/2 - sqrt 2 / 4. Of one: 1/4 at 1.
    near(StudentTest::of(std::f64::consts::SQRT_2, 2.0).p.greater, 0.5 - std::f64::consts::SQRT_2 / 4.0, 1e-14);
    near(StudentTest::of(1.0, 1.0).p.two_sided, 0.5, 1e-14);
    // {1, 3} and {2, 6, 10}: variances 2 and 16, parts 1 and 16/3, t = (2 - 6) / sqrt(19/3),
    // df = (19/3)^2 / (1/1 + (16/3)^2 / 2) = 40.1111 / 15.2222 = 2.635036.
    let pair = [Summary::of(&[1.0, 3.0]), Summary::of(&[2.0, 6.0, 10.0])].map(|summary| summary.expect("not empty"));
    let test = welch_t(&pair[0], &pair[1]).expect("they vary");
    near(test.t, -4.0 / (19.0_f64 / 3.0).sqrt(), 1e-12);
    near(test.freedom, 2.635_036, 5e-7);
    // The tabled point t(0.975; 4) = 2.776.
    near(t_quantile(0.025, 4.0), 2.776, 5e-4);
    let interval = mean_interval(&summary).expect("five numbers");
    near(interval.high, 3.0 + 2.776_445 * 0.5_f64.sqrt(), 1e-5);
    let equal = Summary::of(&[2.0, 2.0]).expect("not empty");
    assert!(one_sample_t(&equal, 1.0).is_none() && welch_t(&equal, &equal).is_none());
}

#[test]
fn quantiles_are_those_of_definition_seven() {
    // 1 2 3 4: place 3 x 0.25 = 0.75, so 1.75; the median lies half way.
    let sorted = [1.0, 2.0, 3.0, 4.0];
    assert_eq!([0.0, 0.25, 0.5, 1.0].map(|share| quantile(&sorted, share)), [1.0, 1.75, 2.5, 4.0]);
    assert!(quantile(&[], 0.5).is_nan());
    assert!(Summary::of(&[]).is_none());
    let one = Summary::of(&[7.0]).expect("not empty");
    assert_eq!((one.deviation, one.lower, one.greatest), (0.0, 7.0, 7.0));
    assert!(mean_interval(&one).is_none());
}
