//! Transfer matrices over a short length by power series: one solution for each unit state at the start.
//!
//! Forces follow from the inertia forces along the length (`S' = -(m w + d psi)`, `T' = -(d w + b psi)`) and not from
//! third derivatives: so nothing cancels if the span moves as a rigid body.

use super::dynamic_stiffness::{Field, Transfer};

/// Terms of the power series: 1.5^26 / 26! is below 1e-22.
const TERMS: usize = 26;

/// Sums over the terms c x^n of a series at x = 1.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    value: f64,
    slope: f64,
    curvature: f64,
    integral: f64,
}

impl Sums {
    fn add(&mut self, n: f64, term: f64) {
        self.value += term;
        self.slope += n * term;
        self.curvature += n * (n - 1.0) * term;
        self.integral += term / (n + 1.0);
    }
}

/// (n + 1)(n + 2)(n + 3)(n + 4).
fn steps(n: f64) -> f64 {
    (n + 1.0) * (n + 2.0) * (n + 3.0) * (n + 4.0)
}

/// The columns of a transfer matrix from the state (q, p) at the end for each unit at the start.
fn by_columns<const N: usize>(end: impl Fn(&[[f64; N]; 2]) -> [[f64; N]; 2]) -> Transfer<N> {
    let mut transfer = Transfer::zeros();
    for column in 0..N {
        for side in 0..2 {
            let mut start = [[0.0; N]; 2];
            start[side][column] = 1.0;
            let [q, p] = end(&start);
            let (to_q, to_p) = match side {
                0 => (&mut transfer.a, &mut transfer.c),
                _ => (&mut transfer.b, &mut transfer.d),
            };
            for row in 0..N {
                to_q[(row, column)] = q[row];
                to_p[(row, column)] = p[row];
            }
        }
    }
    transfer
}

/// Bending over h, `stiffness w'''' = mass w`; degrees of freedom (w, w').
pub(super) fn bending(stiffness: f64, mass: f64, h: f64) -> Transfer<2> {
    let square = h * h;
    by_columns(|&[[w, slope], [force, moment]]| {
        let curvature = moment / stiffness;
        let third = -force / stiffness;
        let mut c = [
            w,
            slope * h,
            0.5 * curvature * square,
            third * square * h / 6.0,
        ];
        let mut sum = Sums::default();
        for n in 0..TERMS {
            let n = n as f64;
            sum.add(n, c[0]);
            let next = square * square * mass * c[0] / (stiffness * steps(n));
            c = [c[1], c[2], c[3], next];
        }
        [
            [sum.value, sum.slope / h],
            [
                force - h * mass * sum.integral,
                stiffness * sum.curvature / square,
            ],
        ]
    })
}

/// Twist over h, `Gamma psi'''' - J psi'' = b psi`; degrees of freedom (psi, psi').
pub(super) fn twist(field: &Field, h: f64) -> Transfer<2> {
    let alone = Field {
        coupling: 0.0,
        mass: 0.0,
        ..*field
    };
    by_columns(|&[[psi, rate], [torque, bimoment]]| {
        let start = [[0.0, psi, 0.0, rate], [0.0, torque, 0.0, bimoment]];
        let [q, p] = end(&alone, h, &start);
        [[q[1], q[3]], [p[1], p[3]]]
    })
}

/// w and psi together; degrees of freedom (w, psi, w', psi').
pub(super) fn coupled(field: &Field, h: f64) -> Transfer<4> {
    by_columns(|start| end(field, h, start))
}

/// The state of w and psi at the end from that at the start.
fn end(field: &Field, h: f64, start: &[[f64; 4]; 2]) -> [[f64; 4]; 2] {
    if field.warping == 0.0 {
        bend_and_twist_without_warping(field, h, start)
    } else {
        bend_and_twist(field, h, start)
    }
}

/// The first terms of w: all others follow from the equation of motion.
fn first_of_w(h: f64, start: &[[f64; 4]; 2]) -> [f64; 4] {
    let [[w, _, slope, _], [force, _, moment, _]] = *start;
    let square = h * h;
    [
        w,
        slope * h,
        0.5 * moment * square,
        -force * square * h / 6.0,
    ]
}

/// `w'''' = m w + d psi`, `Gamma psi'''' - J psi'' = d w + b psi`.
fn bend_and_twist(field: &Field, h: f64, start: &[[f64; 4]; 2]) -> [[f64; 4]; 2] {
    let square = h * h;
    let [[_, psi, _, rate], [_, torque, _, bimoment]] = *start;
    let third = (field.torsion * rate - torque) / field.warping;
    let mut c = first_of_w(h, start);
    let mut e = [
        psi,
        rate * h,
        0.5 * bimoment / field.warping * square,
        third * square * h / 6.0,
    ];
    let mut sums = [Sums::default(); 2];
    for n in 0..TERMS {
        let n = n as f64;
        sums[0].add(n, c[0]);
        sums[1].add(n, e[0]);
        let next_c = square * square * (field.mass * c[0] + field.coupling * e[0]) / steps(n);
        let inertia = square * square * (field.coupling * c[0] + field.polar * e[0]);
        let stiffness = field.torsion * square * (n + 2.0) * (n + 1.0) * e[2];
        let next_e = (stiffness + inertia) / (field.warping * steps(n));
        c = [c[1], c[2], c[3], next_c];
        e = [e[1], e[2], e[3], next_e];
    }
    let mut end = end_state(field, h, start, &sums);
    end[1][3] = field.warping * sums[1].curvature / square;
    end
}

/// The same without warping stiffness: `-J psi'' = d w + b psi`. The rate of twist is not a degree of freedom; an
/// independent foundation replaces it and adds no mode.
fn bend_and_twist_without_warping(field: &Field, h: f64, start: &[[f64; 4]; 2]) -> [[f64; 4]; 2] {
    let square = h * h;
    let [[_, psi, _, rate], [_, torque, _, bimoment]] = *start;
    let mut c = first_of_w(h, start);
    let mut e = [psi, torque / field.torsion * h];
    let mut sums = [Sums::default(); 2];
    for n in 0..TERMS {
        let n = n as f64;
        sums[0].add(n, c[0]);
        sums[1].add(n, e[0]);
        let next_c = square * square * (field.mass * c[0] + field.coupling * e[0]) / steps(n);
        let inertia = square * (field.coupling * c[0] + field.polar * e[0]);
        let next_e = -inertia / (field.torsion * (n + 2.0) * (n + 1.0));
        c = [c[1], c[2], c[3], next_c];
        e = [e[1], next_e];
    }
    let mut end = end_state(field, h, start, &sums);
    end[0][3] = h.cosh() * rate + h.sinh() * bimoment;
    end[1][3] = h.sinh() * rate + h.cosh() * bimoment;
    end
}

/// The state at the end except the bimoment.
fn end_state(field: &Field, h: f64, start: &[[f64; 4]; 2], sums: &[Sums; 2]) -> [[f64; 4]; 2] {
    let [w, psi] = sums;
    let [force, torque] = [start[1][0], start[1][1]];
    [
        [w.value, psi.value, w.slope / h, psi.slope / h],
        [
            force - h * (field.mass * w.integral + field.coupling * psi.integral),
            torque - h * (field.coupling * w.integral + field.polar * psi.integral),
            w.curvature / (h * h),
            0.0,
        ],
    ]
}
