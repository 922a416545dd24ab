//! Random streams: every purpose draws from its own, so a new consumer never shifts another.

use rand::distr::Bernoulli;
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};

/// The one generator of the crate; portable, 32 bytes of state.
pub type Stream = Xoshiro256PlusPlus;

/// The seed of a whole run: at most 2^53 - 1, so that JSON and JavaScript hold it exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seed(u64);

impl Seed {
    /// The largest seed, 2^53 - 1.
    pub const MAX: u64 = (1 << 53) - 1;

    /// Returns the seed, or `None` when `value` is above [`Seed::MAX`].
    #[must_use]
    pub fn new(value: u64) -> Option<Self> {
        (value <= Self::MAX).then_some(Self(value))
    }

    /// The seed of a start within a run, unrelated to the run's own.
    #[must_use]
    pub fn of_restart(self, purpose: Purpose) -> Self {
        Self(stream(self, purpose, 0).random::<u64>() >> 11)
    }

    /// The number as the user wrote it.
    #[must_use]
    pub fn value(self) -> u64 {
        self.0
    }
}

/// What a stream is drawn for. The numbers are part of every fingerprint: never reuse or renumber them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Where sites, items and agents start.
    Placement = 1,
    /// The order in which agents act within a step.
    Activation = 2,
    /// The genome an agent starts with; one stream per agent.
    Genesis = 3,
    /// Turns and headings of one agent.
    Walk = 4,
    /// Genome exchange, selection, crossover and mutation of one agent.
    Evolution = 5,
    /// Where obstacles and traps stand.
    Terrain = 6,
    /// The second start of a world, in which fixed programs are tested.
    Settlement = 7,
    /// Which of a swarm's programs are kept.
    Archive = 8,
    /// What an agent's state machine does with a probability.
    Luck = 16,
    /// How starts are moved to see whether a plan survives it; one stream per replay.
    Jitter = 20,
    /// Who has the first kick-off of a match, and on which side a keeper takes a goal kick.
    Coin = 32,
    /// What the camera sees of one robot or the ball, and what it misses.
    Vision = 33,
    /// How strong one robot's motors are, and which of its commands are lost.
    Wheels = 34,
    /// Where one team aims its penalties.
    Penalty = 35,
}

/// The stream of one purpose, and of one agent where agents draw (`index` 0 otherwise).
///
/// Streams of different seeds, purposes or indices are unrelated: the three numbers pass through one
/// bijective mixer each before they meet.
#[must_use]
pub fn stream(seed: Seed, purpose: Purpose, index: u32) -> Stream {
    let key = mix(mix(mix(seed.0) ^ purpose as u64) ^ u64::from(index));
    Stream::seed_from_u64(key)
}

/// The finaliser of `SplitMix64`: a bijection on 64 bits in which each input bit reaches each output bit.
fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// True with that probability; never for what is no number from 0 to 1.
///
/// Draws as `rand`'s `random_bool` does, whose message for a wrong probability would bring all that formats reals into
/// the wasm: ten kilobytes as it is sent.
pub fn chance(rng: &mut Stream, probability: f64) -> bool {
    Bernoulli::new(probability).is_ok_and(|coin| rng.sample(coin))
}

/// One draw from the standard normal distribution, by the polar method (no sine or cosine).
///
/// The second value of each pair is dropped, so a stream's state says all about its future.
pub fn standard_normal(rng: &mut Stream) -> f64 {
    let [first, _] = normal_pair(rng);
    first
}

/// Two independent draws from the standard normal distribution, for little more than the cost of one.
pub fn normal_pair(rng: &mut Stream) -> [f64; 2] {
    loop {
        let u = rng.random::<f64>() * 2.0 - 1.0;
        let v = rng.random::<f64>() * 2.0 - 1.0;
        let s = u * u + v * v;
        if s > 0.0 && s < 1.0 {
            let scale = (-2.0 * libm::log(s) / s).sqrt();
            return [u * scale, v * scale];
        }
    }
}

/// A direction drawn uniformly from the circle, as a unit vector; by rejection from the square.
pub fn direction(rng: &mut Stream) -> [f64; 2] {
    loop {
        let x = rng.random::<f64>() * 2.0 - 1.0;
        let y = rng.random::<f64>() * 2.0 - 1.0;
        let s = x * x + y * y;
        // Very short vectors would lose digits when they are stretched to length 1.
        if s > 1e-6 && s <= 1.0 {
            let scale = 1.0 / s.sqrt();
            return [x * scale, y * scale];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_of_different_purposes_and_agents_differ() {
        let seed = Seed::new(7).expect("7 is below 2^53");
        let mut first: Vec<u64> = Vec::new();
        for purpose in [Purpose::Placement, Purpose::Activation, Purpose::Genesis, Purpose::Walk, Purpose::Evolution] {
            for index in 0..50 {
                first.push(stream(seed, purpose, index).random());
            }
        }
        let drawn = first.len();
        first.sort_unstable();
        first.dedup();
        assert_eq!(first.len(), drawn);
    }

    #[test]
    fn chance_draws_what_random_bool_of_rand_draws() {
        let [mut ours, mut theirs] = [(); 2].map(|()| stream(Seed::new(3).expect("small"), Purpose::Evolution, 1));
        for step in 0..=1000 {
            let probability = f64::from(step) / 1000.0;
            assert_eq!(chance(&mut ours, probability), theirs.random_bool(probability));
        }
        assert_eq!(ours, theirs, "both drew as often");
        let wrong = [1.5, f64::NAN, -0.5];
        assert!(
            !wrong.into_iter().any(|probability| chance(&mut ours, probability)),
            "never for what is no probability"
        );
    }

    #[test]
    fn seeds_above_two_to_the_53_are_refused() {
        assert!(Seed::new((1 << 53) - 1).is_some());
        assert!(Seed::new(1 << 53).is_none());
    }

    #[test]
    fn normal_draws_have_mean_0_and_deviation_1() {
        let mut rng = stream(Seed::new(1).expect("small"), Purpose::Walk, 0);
        let draws: Vec<f64> = (0..40_000).map(|_| standard_normal(&mut rng)).collect();
        let mean = draws.iter().sum::<f64>() / 40_000.0;
        let variance = draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 39_999.0;
        // Five standard errors: 1 / sqrt(40000) = 0.005 for the mean, sqrt(2 / 40000) = 0.007 for the variance.
        assert!(mean.abs() < 0.025, "mean {mean}");
        assert!((variance - 1.0).abs() < 0.036, "variance {variance}");
    }
}
