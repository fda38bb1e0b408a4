//! The arithmetics of x86-64 processors with vectors: the only place with `unsafe`.
//!
//! `cargo bench --bench kernel` measures their gain over [`super::portable`] in the table of instructions. The compiler
//! alone does not make vectors of this length from loops: it gathers and scatters.

#![allow(
    unsafe_code,
    reason = "the only way to instructions that are looked for at run time"
)]

use std::arch::x86_64::{
    __m256d, __m512d, _CMP_LT_OQ, _mm256_add_epi64, _mm256_add_pd, _mm256_and_pd, _mm256_blendv_pd,
    _mm256_castpd_si256, _mm256_castsi256_pd, _mm256_cmp_pd, _mm256_div_pd, _mm256_fmadd_pd,
    _mm256_fnmadd_pd, _mm256_loadu_pd, _mm256_movemask_pd, _mm256_mul_pd, _mm256_or_pd,
    _mm256_set1_epi64x, _mm256_set1_pd, _mm256_sllv_epi64, _mm256_sqrt_pd, _mm256_storeu_pd,
    _mm256_sub_epi64, _mm256_sub_pd, _mm256_xor_pd, _mm512_add_epi64, _mm512_add_pd, _mm512_and_pd,
    _mm512_castpd_si512, _mm512_castsi512_pd, _mm512_cmp_pd_mask, _mm512_div_pd, _mm512_fmadd_pd,
    _mm512_fnmadd_pd, _mm512_loadu_pd, _mm512_mask_blend_pd, _mm512_movepi64_mask, _mm512_mul_pd,
    _mm512_or_pd, _mm512_set1_epi64, _mm512_set1_pd, _mm512_sllv_epi64, _mm512_sqrt_pd,
    _mm512_storeu_pd, _mm512_sub_epi64, _mm512_sub_pd, _mm512_xor_pd,
};

use super::double_double::DoubleDouble;
use super::elementary::{exp, sin_cos};
use super::number::{
    Arithmetic, Bits, EXPONENT, MOST_LANES, Part, Real, SIGN, TWICE_ONE, of_doubles,
};

/// Vectors of 512 bits.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Avx512(__m512d);

/// Vectors of 256 bits, and fused multiply-add.
#[derive(Debug, Clone, Copy)]
pub(in crate::solve) struct Avx2(__m256d);

impl Avx512 {
    /// Whether the processor supports its instructions.
    pub(super) fn is_there() -> bool {
        is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl")
    }
}

impl Avx2 {
    /// Whether the processor supports its instructions.
    pub(super) fn is_there() -> bool {
        is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
    }
}

/// Methods that are one vector instruction each.
macro_rules! instructions {
    ($($method:ident($($argument:ident),*) $instruction:ident,)*) => {
        $(
            #[inline(always)]
            fn $method(self $(, $argument: Self)*) -> Self {
                // SAFETY: only a `Solver` makes these numbers, where the processor has the instructions.
                Self(unsafe { $instruction(self.0 $(, $argument.0)*) })
            }
        )*
    };
}

/// Methods that are one integer vector instruction each.
macro_rules! of_integers {
    ($from:ident, $to:ident, $($method:ident $instruction:ident,)*) => {
        $(
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $from($instruction($to(self.0), $to(other.0))) })
            }
        )*
    };
}

/// Methods with arguments or results other than vectors.
macro_rules! to_and_fro {
    ($lanes:literal, $vector:ident, $features:literal, $splat:ident, $load:ident, $store:ident) => {
        const LANES: usize = $lanes;
        // SAFETY: a vector is its lanes, one after the other.
        const ZERO: Self =
            Self(unsafe { std::mem::transmute::<[f64; $lanes], $vector>([0.0; $lanes]) });
        // SAFETY: as above.
        const ONE: Self =
            Self(unsafe { std::mem::transmute::<[f64; $lanes], $vector>([1.0; $lanes]) });

        #[inline(always)]
        fn splat(value: f64) -> Self {
            // SAFETY: only a `Solver` makes these numbers, where the processor has the instructions.
            Self(unsafe { $splat(value) })
        }

        #[inline(always)]
        fn load(values: &[f64; MOST_LANES]) -> Self {
            // SAFETY: as above, and there are as many values.
            Self(unsafe { $load(values.as_ptr()) })
        }

        #[inline(always)]
        fn store(self) -> [f64; MOST_LANES] {
            let mut out = [0.0; MOST_LANES];
            // SAFETY: as above, and there is as much room.
            unsafe { $store(out.as_mut_ptr(), self.0) };
            out
        }

        #[inline(always)]
        fn outlined<P: Part>(part: P) -> P::Output {
            #[target_feature(enable = $features)]
            #[inline(never)]
            fn with_vectors<P: Part>(part: P) -> P::Output {
                part.run()
            }
            // SAFETY: as above.
            unsafe { with_vectors(part) }
        }
    };
}

impl Arithmetic for Avx512 {
    to_and_fro!(
        8,
        __m512d,
        "avx512f,avx512dq,avx512vl",
        _mm512_set1_pd,
        _mm512_loadu_pd,
        _mm512_storeu_pd
    );
    of_doubles!();
    instructions!(
        plus(other) _mm512_add_pd,
        minus(other) _mm512_sub_pd,
        times(other) _mm512_mul_pd,
        over(other) _mm512_div_pd,
        square_root() _mm512_sqrt_pd,
        multiply_add(b, c) _mm512_fmadd_pd,
        subtract_product(b, c) _mm512_fnmadd_pd,
    );
    #[inline(always)]
    fn where_less(self, than: Self, yes: Self, no: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe {
            let is_less = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, than.0);
            _mm512_mask_blend_pd(is_less, no.0, yes.0)
        })
    }

    #[inline(always)]
    fn is_less_somewhere(self, than: Self) -> bool {
        // SAFETY: as above.
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, than.0) != 0 }
    }
}

impl Bits for Avx512 {
    instructions!(
        and(other) _mm512_and_pd,
        or(other) _mm512_or_pd,
        xor(other) _mm512_xor_pd,
    );
    of_integers!(
        _mm512_castsi512_pd, _mm512_castpd_si512,
        plus_bits _mm512_add_epi64,
        minus_bits _mm512_sub_epi64,
    );

    #[inline(always)]
    fn where_signed(self, yes: Self, no: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe {
            let is_signed = _mm512_movepi64_mask(_mm512_castpd_si512(self.0));
            _mm512_mask_blend_pd(is_signed, no.0, yes.0)
        })
    }

    #[inline(always)]
    fn shifted(self, by: u32) -> Self {
        // SAFETY: as above.
        Self(unsafe {
            let by = _mm512_set1_epi64(i64::from(by));
            _mm512_castsi512_pd(_mm512_sllv_epi64(_mm512_castpd_si512(self.0), by))
        })
    }
}

impl Arithmetic for Avx2 {
    to_and_fro!(
        4,
        __m256d,
        "avx2,fma",
        _mm256_set1_pd,
        _mm256_loadu_pd,
        _mm256_storeu_pd
    );
    of_doubles!();
    instructions!(
        plus(other) _mm256_add_pd,
        minus(other) _mm256_sub_pd,
        times(other) _mm256_mul_pd,
        over(other) _mm256_div_pd,
        square_root() _mm256_sqrt_pd,
        multiply_add(b, c) _mm256_fmadd_pd,
        subtract_product(b, c) _mm256_fnmadd_pd,
    );
    #[inline(always)]
    fn where_less(self, than: Self, yes: Self, no: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe {
            let is_less = _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, than.0);
            _mm256_blendv_pd(no.0, yes.0, is_less)
        })
    }

    #[inline(always)]
    fn is_less_somewhere(self, than: Self) -> bool {
        // SAFETY: as above.
        unsafe { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, than.0)) != 0 }
    }
}

impl Bits for Avx2 {
    instructions!(
        and(other) _mm256_and_pd,
        or(other) _mm256_or_pd,
        xor(other) _mm256_xor_pd,
    );
    of_integers!(
        _mm256_castsi256_pd, _mm256_castpd_si256,
        plus_bits _mm256_add_epi64,
        minus_bits _mm256_sub_epi64,
    );

    #[inline(always)]
    fn where_signed(self, yes: Self, no: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, self.0) })
    }

    #[inline(always)]
    fn shifted(self, by: u32) -> Self {
        // SAFETY: as above.
        Self(unsafe {
            let by = _mm256_set1_epi64x(i64::from(by));
            _mm256_castsi256_pd(_mm256_sllv_epi64(_mm256_castpd_si256(self.0), by))
        })
    }
}
