//! The neighbours of one agent: found in any order, listed by number.

/// A set of agents that lists its members in rising order.
///
/// Found agents set bits; reading the bits in order sorts them, so nothing depends on how the search went. A second layer
/// says which words of the first have bits, so that a few neighbours in a crowd cost no walk over the crowd.
#[derive(Clone, Debug)]
pub struct Near {
    bits: Vec<u64>,
    /// A bit for each word of `bits` that an agent was put into.
    used: Vec<u64>,
    ids: Vec<u32>,
}

impl Near {
    /// An empty set for agents 0 to `agents` - 1.
    #[must_use]
    pub fn new(agents: u32) -> Self {
        let words = agents.div_ceil(64);
        Self { bits: vec![0; words as usize], used: vec![0; words.div_ceil(64) as usize], ids: Vec::new() }
    }

    /// Empties the set.
    pub fn clear(&mut self) {
        for (at, used) in self.used.iter_mut().enumerate() {
            for bit in bits_of(std::mem::take(used)) {
                self.bits[at * 64 + bit as usize] = 0;
            }
        }
        self.ids.clear();
    }

    /// Adds an agent; [`Near::ids`] shows it after the next [`Near::retain`].
    #[inline]
    pub fn add(&mut self, id: u32) {
        self.bits[(id / 64) as usize] |= 1 << (id % 64);
        self.used[(id / 4096) as usize] |= 1 << (id / 64 % 64);
    }

    /// Removes an agent.
    pub fn remove(&mut self, id: u32) {
        self.bits[(id / 64) as usize] &= !(1 << (id % 64));
    }

    /// True when nobody is in the set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let words = self.used.iter().enumerate().flat_map(|(at, &used)| bits_of(used).map(move |bit| (at, bit)));
        words.map(|(at, bit)| self.bits[at * 64 + bit as usize]).all(|word| word == 0)
    }

    /// True when the agent is in the set.
    #[must_use]
    pub fn contains(&self, id: u32) -> bool {
        self.bits[(id / 64) as usize] & 1 << (id % 64) != 0
    }

    /// Keeps the agents for which `keep` says so, asked in rising order.
    pub fn retain(&mut self, mut keep: impl FnMut(u32) -> bool) {
        self.ids.clear();
        for (at, &used) in self.used.iter().enumerate() {
            for word in bits_of(used).map(|bit| at as u32 * 64 + bit) {
                for bit in bits_of(self.bits[word as usize]) {
                    let id = word * 64 + bit;
                    if keep(id) {
                        self.ids.push(id);
                    } else {
                        self.bits[word as usize] &= !(1 << bit);
                    }
                }
            }
        }
    }

    /// The agents that the last [`Near::retain`] kept, in rising order.
    #[must_use]
    pub fn ids(&self) -> &[u32] {
        &self.ids
    }
}

/// The numbers of the bits that are set, rising.
fn bits_of(mut word: u64) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let bit = word.trailing_zeros();
        word &= word.wrapping_sub(1);
        (bit < 64).then_some(bit)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_are_listed_in_rising_order_and_those_not_kept_are_gone() {
        let mut near = Near::new(10_000);
        assert!(near.is_empty());
        for id in [9_999, 0, 4_096, 63, 64, 4_095, 128] {
            near.add(id);
        }
        near.remove(128);
        let mut asked = Vec::new();
        near.retain(|id| {
            asked.push(id);
            id % 2 == 1
        });
        assert_eq!(asked, [0, 63, 64, 4_095, 4_096, 9_999]);
        assert_eq!(near.ids(), [63, 4_095, 9_999]);
        assert!(near.contains(63) && !near.contains(64) && !near.contains(128));
        near.clear();
        assert!(near.is_empty() && near.ids().is_empty() && !near.contains(63));
        near.add(200);
        near.remove(200);
        assert!(near.is_empty(), "an agent that was removed leaves nothing");
    }
}
