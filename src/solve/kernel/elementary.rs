//! Exponential, sine and cosine of several frequencies at once, and decay and phase of waves.
//!
//! Reduction and polynomials as in FDLIBM (Sun Microsystems, 1993: `__ieee754_rem_pio2`, `__kernel_sin`,
//! `__kernel_cos`) and the Taylor series of the exponential; within 2 units of the last place.

use super::complex::Complex;
use super::number::{Arithmetic, Bits, MOST_LANES, Real, part};

/// Adding it rounds a number below 2^51 to an integer in the low bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Beyond it the reduction of an angle loses digits.
const LARGEST: f64 = 1e6;

/// exp(-re) (cos im - i sin im): decay and phase of a wave for `re + i im`.
#[inline(always)]
pub(super) fn decay<A: Arithmetic>(re: Real<A>, im: Real<A>) -> Complex<A> {
    // Without damping a wave either decays or propagates.
    if !Real::ZERO.is_less_somewhere(im.abs()) {
        return Complex::from_real((-re).exp());
    }
    let (sin, cos) = im.sin_cos();
    if !Real::ZERO.is_less_somewhere(re.abs()) {
        return Complex { re: cos, im: -sin };
    }
    let size = (-re).exp();
    Complex {
        re: size * cos,
        im: -(size * sin),
    }
}

/// A product rounded to an integer: in the low bits, and as a number.
#[inline(always)]
pub(super) fn rounded_product<A: Bits>(x: Real<A>, by: f64) -> (Real<A>, Real<A>) {
    let rounded = x.multiply_add(Real::splat(by), Real::splat(ROUNDER));
    (rounded, rounded - Real::splat(ROUNDER))
}

/// The exponential of a number at or below 700; 0 below -700.
#[inline(always)]
pub(super) fn exp<A: Bits>(x: Real<A>) -> Real<A> {
    const SMALLEST: f64 = -700.0;
    const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
    const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
    /// 1/k! from k = 13 to 0.
    const SERIES: [f64; 14] = [
        1.605_904_383_682_161_5e-10,
        2.087_675_698_786_81e-9,
        2.505_210_838_544_172e-8,
        2.755_731_922_398_589e-7,
        2.755_731_922_398_589_3e-6,
        2.480_158_730_158_73e-5,
        1.984_126_984_126_984e-4,
        1.388_888_888_888_889e-3,
        8.333_333_333_333_333e-3,
        4.166_666_666_666_666_4e-2,
        1.666_666_666_666_666_6e-1,
        0.5,
        1.0,
        1.0,
    ];
    let clamped = x.max(Real::splat(SMALLEST));
    let (rounded, n) = rounded_product(clamped, std::f64::consts::LOG2_E);
    let r = n.subtract_product(
        Real::splat(LN_2_LOW),
        n.subtract_product(Real::splat(LN_2_HIGH), clamped),
    );
    let mut sum = Real::splat(SERIES[0]);
    for coefficient in &SERIES[1..] {
        sum = sum.multiply_add(r, Real::splat(*coefficient));
    }
    x.where_less(
        Real::splat(SMALLEST),
        Real::ZERO,
        sum * rounded.power_of_two(),
    )
}

/// Sine and cosine.
#[inline(always)]
pub(super) fn sin_cos<A: Bits>(x: Real<A>) -> (Real<A>, Real<A>) {
    if Real::splat(LARGEST).is_less_somewhere(x.abs()) {
        return A::outlined(Far((x,)));
    }
    reduced_sin_cos(x)
}

/// For numbers of any size.
#[inline(always)]
fn far_sin_cos<A: Bits>((x,): (Real<A>,)) -> (Real<A>, Real<A>) {
    let (sin, cos) = reduced_sin_cos(x);
    let (x, mut sin, mut cos) = (x.lanes(), sin.lanes(), cos.lanes());
    for lane in 0..MOST_LANES {
        if x[lane].abs() > LARGEST {
            (sin[lane], cos[lane]) = x[lane].sin_cos();
        }
    }
    (Real::new(&sin), Real::new(&cos))
}

#[inline(always)]
fn reduced_sin_cos<A: Bits>(x: Real<A>) -> (Real<A>, Real<A>) {
    /// pi/2 in three parts of 33 bits, whose products with small integers are exact.
    const QUARTERS: [f64; 3] = [
        1.570_796_326_734_125_6,
        6.077_100_506_303_966e-11,
        2.022_266_248_711_166_5e-21,
    ];
    let (rounded, n) = rounded_product(x, std::f64::consts::FRAC_2_PI);
    let mut r = x;
    for part in QUARTERS {
        r = n.subtract_product(Real::splat(part), r);
    }
    let (sin, cos) = (sine(r), cosine(r));
    let turned_sin = rounded.where_bit(0, cos, sin);
    let turned_cos = rounded.where_bit(0, sin, cos);
    (
        turned_sin.turned_by_bit(rounded, 1),
        turned_cos.turned_by_bit(rounded.next_bits(), 1),
    )
}

/// The sine of a number within pi/4 of 0.
#[inline(always)]
fn sine<A: Arithmetic>(r: Real<A>) -> Real<A> {
    const SERIES: [f64; 6] = [
        1.589_690_995_211_55e-10,
        -2.505_076_025_340_686_3e-8,
        2.755_731_370_707_006_8e-6,
        -1.984_126_982_985_795e-4,
        8.333_333_333_322_49e-3,
        -1.666_666_666_666_663_2e-1,
    ];
    let square = r * r;
    let mut sum = Real::splat(SERIES[0]);
    for coefficient in &SERIES[1..] {
        sum = sum.multiply_add(square, Real::splat(*coefficient));
    }
    (square * r).multiply_add(sum, r)
}

/// The cosine of a number within pi/4 of 0.
#[inline(always)]
fn cosine<A: Arithmetic>(r: Real<A>) -> Real<A> {
    const SERIES: [f64; 6] = [
        -1.135_964_755_778_819_5e-11,
        2.087_572_321_298_175e-9,
        -2.755_731_435_139_066_3e-7,
        2.480_158_728_947_673e-5,
        -1.388_888_888_887_411e-3,
        4.166_666_666_666_66e-2,
    ];
    let square = r * r;
    let mut sum = Real::splat(SERIES[0]);
    for coefficient in &SERIES[1..] {
        sum = sum.multiply_add(square, Real::splat(*coefficient));
    }
    // 1 - square/2, corrected by the rounding error of the difference.
    let half = square * Real::splat(0.5);
    let near_one = Real::ONE - half;
    let lost = (Real::ONE - near_one) - half;
    near_one + (square * square).multiply_add(sum, lost)
}

part!(
    Far [A: Bits] [A]
    (Real<A>,) -> (Real<A>, Real<A>),
    far_sin_cos
);
