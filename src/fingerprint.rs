//! The 64-bit fingerprint of a state: equal states give equal fingerprints on every machine.

use crate::random::Stream;
use rand::Rng;

/// A hash fed word by word, in a fixed order.
///
/// Every step is a bijection of the running value, so two states that differ in one word differ in the end.
///
/// ```
/// use swarm_playground::fingerprint::Fingerprint;
/// let of = |values: &[f64]| {
///     let mut hash = Fingerprint::default();
///     values.iter().for_each(|&value| hash.f64(value));
///     hash.finish()
/// };
/// assert_eq!(of(&[1.0, 2.0]), of(&[1.0, 2.0]));
/// assert_ne!(of(&[1.0, 2.0]), of(&[2.0, 1.0]));
/// ```
#[derive(Clone, Debug)]
pub struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Self(0x5357_4152_4D00_0001)
    }
}

impl Fingerprint {
    /// Takes in one word.
    pub fn u64(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0xD6E8_FEB8_6659_FD93);
        self.0 = (mixed ^ (mixed >> 32)).wrapping_add(0x9E37_79B9_7F4A_7C15);
    }

    /// Takes in one 32-bit number.
    pub fn u32(&mut self, value: u32) {
        self.u64(u64::from(value));
    }

    /// Takes in one real by its bits; all NaN count as one, because wasm does not fix their bits.
    pub fn f64(&mut self, value: f64) {
        self.u64(if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() });
    }

    /// Takes in a random stream through its next four words, which its 256 bits of state decide.
    pub fn stream(&mut self, stream: &Stream) {
        let mut ahead = stream.clone();
        for _ in 0..4 {
            self.u64(ahead.next_u64());
        }
    }

    /// The fingerprint of all that was taken in.
    #[must_use]
    pub fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }
}
