//! Random numbers that are the same everywhere.

/// A small random number generator (Knuth's MMIX constants).
pub struct Dice(pub u64);

impl Dice {
    /// The next 31 bits. The generator's low bits hardly change.
    fn bits(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    /// A number from 0 to below `sides`, which is at least 1 and below 2^31.
    pub fn roll(&mut self, sides: usize) -> usize {
        self.bits() as usize % sides
    }

    /// One of the items.
    pub fn pick<'a, T: ?Sized>(&mut self, things: &[&'a T]) -> &'a T {
        things[self.roll(things.len())]
    }

    /// Random bits as a float.
    pub fn float(&mut self) -> f64 {
        f64::from_bits(self.bits() << 40 ^ self.bits() << 20 ^ self.bits())
    }
}
