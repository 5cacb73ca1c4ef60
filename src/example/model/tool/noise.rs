//! Pseudo-random numbers, the same on every machine.

/// Pseudo-random numbers from -1 to 1: the upper half of a linear congruential generator with
/// Knuth's MMIX multiplier.
pub(crate) struct Noise {
    /// State, initially the seed.
    pub(crate) state: u64,
}

impl Noise {
    /// The next number.
    pub(crate) fn next(&mut self) -> f64 {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        const INCREMENT: u64 = 1_442_695_040_888_963_407;
        self.state = self.state.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        (self.state >> 32) as f64 / f64::from(u32::MAX) * 2.0 - 1.0
    }
}
