//! The arithmetic of any processor: loops over arrays, from which a compiler makes vector instructions if the target
//! has them.

use std::fmt::Debug;
use std::marker::PhantomData;

use super::double_double::DoubleDouble;
use super::elementary::{exp, sin_cos};
use super::number::{
    Arithmetic, Bits, EXPONENT, MOST_LANES, Part, Real, SIGN, TWICE_ONE, of_doubles,
};

/// The default arithmetic.
pub(in crate::solve) type Portable = Array<Silent, 4>;

/// The arithmetic of a single frequency.
pub(super) type One = Array<Silent, 1>;

/// Numbers of several lanes.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(in crate::solve) struct Array<N, const LANES: usize>([f64; LANES], PhantomData<N>);

/// A counter of operations.
pub(in crate::solve) trait Notes: Copy + Debug + Send + Sync + 'static {
    /// An operation as cheap as a fused multiply-add.
    fn operation();

    /// A division or a square root.
    fn division();
}

/// Counts nothing.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Silent;

impl Notes for Silent {
    #[inline(always)]
    fn operation() {}

    #[inline(always)]
    fn division() {}
}

/// With one rounding on targets with an instruction for it.
#[inline(always)]
fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_arch = "aarch64") {
        a.mul_add(b, c)
    } else {
        a * b + c
    }
}

impl<N: Notes, const LANES: usize> Array<N, LANES> {
    #[inline(always)]
    const fn new(values: [f64; LANES]) -> Self {
        Self(values, PhantomData)
    }
}

/// A method that computes each lane from the same lanes of its arguments.
macro_rules! by_lane {
    ($name:ident($this:ident $(, $other:ident)*) $lane:expr $(, $note:expr)?) => {
        #[inline(always)]
        fn $name(self $(, $other: Self)*) -> Self {
            $($note;)?
            let mut out = [0.0; LANES];
            for lane in 0..LANES {
                let ($this, $($other,)*) = (self.0[lane], $($other.0[lane],)*);
                out[lane] = $lane;
            }
            Self::new(out)
        }
    };
}

impl<N: Notes, const LANES: usize> Arithmetic for Array<N, LANES> {
    const LANES: usize = LANES;
    const ZERO: Self = Self::new([0.0; LANES]);
    const ONE: Self = Self::new([1.0; LANES]);

    of_doubles!();

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self::new([value; LANES])
    }

    #[inline(always)]
    fn load(values: &[f64; MOST_LANES]) -> Self {
        let mut out = [0.0; LANES];
        out.copy_from_slice(&values[..LANES]);
        Self::new(out)
    }

    #[inline(always)]
    fn store(self) -> [f64; MOST_LANES] {
        let mut out = [0.0; MOST_LANES];
        out[..LANES].copy_from_slice(&self.0);
        out
    }

    by_lane!(plus(a, b) a + b, N::operation());
    by_lane!(minus(a, b) a - b, N::operation());
    by_lane!(times(a, b) a * b, N::operation());
    by_lane!(over(a, b) a / b, N::division());
    by_lane!(square_root(a) a.sqrt(), N::division());
    by_lane!(multiply_add(a, b, c) multiply_add(a, b, c), N::operation());
    by_lane!(subtract_product(a, b, c) multiply_add(-a, b, c), N::operation());
    by_lane!(where_less(a, than, yes, no) if a < than { yes } else { no });

    #[inline(always)]
    fn is_less_somewhere(self, than: Self) -> bool {
        let mut found = false;
        for lane in 0..LANES {
            found |= self.0[lane] < than.0[lane];
        }
        found
    }

    #[inline(never)]
    fn outlined<P: Part>(part: P) -> P::Output {
        part.run()
    }
}

impl<N: Notes, const LANES: usize> Bits for Array<N, LANES> {
    by_lane!(where_signed(a, yes, no) if a.is_sign_negative() { yes } else { no });
    by_lane!(and(a, b) f64::from_bits(a.to_bits() & b.to_bits()));
    by_lane!(or(a, b) f64::from_bits(a.to_bits() | b.to_bits()));
    by_lane!(xor(a, b) f64::from_bits(a.to_bits() ^ b.to_bits()));
    by_lane!(plus_bits(a, b) f64::from_bits(a.to_bits().wrapping_add(b.to_bits())));
    by_lane!(minus_bits(a, b) f64::from_bits(a.to_bits().wrapping_sub(b.to_bits())));

    #[inline(always)]
    fn shifted(self, by: u32) -> Self {
        let mut out = [0.0; LANES];
        for lane in 0..LANES {
            out[lane] = f64::from_bits(self.0[lane].to_bits() << by);
        }
        Self::new(out)
    }
}
