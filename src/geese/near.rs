//! The neighbours of one agent: found in any order, listed by number.

/// A set of agents that lists its members in rising order.
///
/// Found agents set bits; reading the bits in order sorts them, so nothing depends on how the search went.
#[derive(Clone, Debug)]
pub struct Near {
    bits: Vec<u64>,
    ids: Vec<u32>,
}

impl Near {
    /// An empty set for agents 0 to `agents` - 1.
    #[must_use]
    pub fn new(agents: u32) -> Self {
        Self { bits: vec![0; agents.div_ceil(64) as usize], ids: Vec::new() }
    }

    /// Empties the set.
    pub fn clear(&mut self) {
        self.bits.fill(0);
        self.ids.clear();
    }

    /// Adds an agent; [`Near::ids`] shows it after the next [`Near::retain`].
    #[inline]
    pub fn add(&mut self, id: u32) {
        self.bits[(id / 64) as usize] |= 1 << (id % 64);
    }

    /// Removes an agent.
    pub fn remove(&mut self, id: u32) {
        self.bits[(id / 64) as usize] &= !(1 << (id % 64));
    }

    /// True when nobody is in the set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bits.iter().all(|&word| word == 0)
    }

    /// True when the agent is in the set.
    #[must_use]
    pub fn contains(&self, id: u32) -> bool {
        self.bits[(id / 64) as usize] & 1 << (id % 64) != 0
    }

    /// Keeps the agents for which `keep` says so, asked in rising order.
    pub fn retain(&mut self, mut keep: impl FnMut(u32) -> bool) {
        self.ids.clear();
        for (at, word) in self.bits.iter_mut().enumerate() {
            let mut left = *word;
            while left != 0 {
                let bit = left.trailing_zeros();
                left &= left - 1;
                let id = at as u32 * 64 + bit;
                if keep(id) {
                    self.ids.push(id);
                } else {
                    *word &= !(1 << bit);
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
