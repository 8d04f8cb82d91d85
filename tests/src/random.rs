//! Random numbers with a fixed start.

/// A linear congruential generator (Knuth, MMIX), the upper half of its state being used.
#[derive(Debug)]
pub struct Generator(u64);

impl Generator {
    /// The same start gives the same numbers.
    pub fn new(start: u64) -> Self {
        Self(start)
    }

    /// A number from 0 to `bound` - 1; 0 where `bound` is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % bound.max(1)
    }
}
