//! Seeded pseudo-random numbers.

use oracle::scalar::Prime;

/// SplitMix64 generator, the same on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Creates a generator from a seed and a stream name; each check has its own stream.
    pub fn new(seed: u64, stream: &str) -> Self {
        let mut random = Self(seed);
        for byte in stream.bytes() {
            random.0 ^= u64::from(byte);
            random.next();
        }
        random
    }

    /// Returns the next 64 pseudo-random bits.
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Draws a uniformly distributed number in [`least`, `greatest`).
    pub fn between(&mut self, least: f64, greatest: f64) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        least + (greatest - least) * unit
    }

    /// Draws a uniformly distributed number in [−`size`, `size`).
    pub fn within(&mut self, size: f64) -> f64 {
        self.between(-size, size)
    }

    /// Returns true with probability 1/`n`.
    pub fn once_in(&mut self, n: u64) -> bool {
        self.next().is_multiple_of(n)
    }

    /// Draws a uniformly distributed element of the prime field.
    pub fn prime(&mut self) -> Prime {
        Prime::new(self.next() >> 3)
    }
}
