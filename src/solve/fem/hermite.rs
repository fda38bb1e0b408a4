//! The cubic Hermite shape functions, and the energy of an element with them.

/// Coefficients of a cubic of s = x / h in [0, 1], by ascending power.
pub(super) type Cubic = [f64; 4];

/// The four cubics with 1 for one and 0 for the other three of: value and slope (d/ds) at the left end, value and slope
/// at the right end.
pub(super) const SHAPES: [Cubic; 4] = [
    [1.0, 0.0, -3.0, 2.0],
    [0.0, 1.0, -2.0, 1.0],
    [0.0, 0.0, 3.0, -2.0],
    [0.0, 0.0, -1.0, 1.0],
];

/// A part of an element's strain energy, `stiffness/2 (of . u)^2`, over its unknowns u = (value, slope d/dx) at the left
/// and at the right end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strain {
    pub(super) stiffness: f64,
    pub(super) of: [f64; 4],
}

/// The strain energy `1/2 int (bending u''^2 + torsion u'^2) dx` of a cubic u over an element of length `h`, as squares.
///
/// With t in [-1/2, 1/2] along the element, turn = u'(h) - u'(0), rise = u(h) - u(0) and lag = h (u'(0) + u'(h))/2 -
/// rise, the cubic has `h u' = rise + turn h t + lag (6 t^2 - 1/2)`. The three functions of t are orthogonal with the
/// squares 1, 1/12 and 1/5, their derivatives with 0, 1 and 12. The entries of the stiffness matrix cancel for a smooth
/// shape; turn, rise and lag are small when the strain is.
pub(super) fn strains(h: f64, bending: f64, torsion: f64) -> [Strain; 3] {
    [
        Strain {
            stiffness: bending / h + torsion * h / 12.0,
            of: [0.0, -1.0, 0.0, 1.0],
        },
        Strain {
            stiffness: 12.0 * bending / (h * h * h) + torsion / (5.0 * h),
            of: [1.0, 0.5 * h, -1.0, 0.5 * h],
        },
        Strain {
            stiffness: torsion / h,
            of: [-1.0, 0.0, 1.0, 0.0],
        },
    ]
}

/// d/ds.
pub(super) fn derivative(cubic: Cubic) -> Cubic {
    [cubic[1], 2.0 * cubic[2], 3.0 * cubic[3], 0.0]
}

/// int a b ds over [0, 1].
pub(super) fn integral(a: &Cubic, b: &Cubic) -> f64 {
    let mut sum = 0.0;
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            sum += a * b / (i + j + 1) as f64;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH: f64 = 0.3;

    /// The integrals over s of all products, times `scale` for dx, and times h for each slope: a slope d/dx of 1 is h in
    /// terms of s.
    fn products(functions: &[Cubic; 4], h: f64, scale: f64) -> [[f64; 4]; 4] {
        let unit = [1.0, h, 1.0, h];
        let mut out = [[0.0; 4]; 4];
        for i in 0..4 {
            for j in 0..4 {
                out[i][j] = scale * (unit[i] * unit[j]) * integral(&functions[i], &functions[j]);
            }
        }
        out
    }

    fn assert_near(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-14 * b.abs().max(1.0), "{a} {b}");
    }

    /// Expected: the integrals of the products of the shape functions' own derivatives.
    #[test]
    fn the_squares_are_the_strain_energy_of_the_shape_functions() {
        let once = SHAPES.map(derivative);
        let (bending, torsion) = (7.0, 5.0);
        let curvature = products(&once.map(derivative), LENGTH, LENGTH.powi(-3));
        let slope = products(&once, LENGTH, 1.0 / LENGTH);
        for i in 0..4 {
            for j in 0..4 {
                let by_strains: f64 = strains(LENGTH, bending, torsion)
                    .iter()
                    .map(|strain| strain.stiffness * strain.of[i] * strain.of[j])
                    .sum();
                let expected = bending * curvature[i][j] + torsion * slope[i][j];
                assert_near(by_strains / 1e3, expected / 1e3);
            }
        }
    }
}
