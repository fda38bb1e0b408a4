//! The characteristic determinant of a model, by methods independent of the program's: the state equation of the beam
//! by its Taylor series over short lengths, in numbers of 32 digits, with six solutions kept independent from the left
//! end to the right (Godunov 1961; Conte, SIAM Rev. 8 (1966) 309-321).

use beamtune::model::{
    Beam, BeamMotion, Joint, Link, Model, Point, Restraint, Spring, SpringId, Subsystem, Support,
};
use num_complex::Complex64;

use super::double_double::{Complex2, Double2};

/// w, psi and v.
const FIELDS: usize = 3;

/// At a station: the six motions of the axis and the internal forces conjugate to them, these over a reference stiffness.
/// Within a span: the derivatives of order 0 to 3 of its own (w, psi, v), order by order, each times a length to the power
/// of its order.
type State = [Complex2; 12];

/// Coefficients between the fields; w and psi are not coupled to v.
type Block = [[Complex2; FIELDS]; FIELDS];

/// Terms of the Taylor series by order: 4^53 / 53! is below 1e-37.
const TERMS: usize = 54;

/// The largest growth of the solutions in a step: by e^4.
const GROWTH: f64 = 4.0;

/// A number times a power of two.
#[derive(Debug, Clone, Copy)]
pub struct Scaled {
    value: Complex64,
    exponent: i32,
}

impl Scaled {
    /// The natural logarithm.
    pub fn ln(self) -> Complex64 {
        self.value.ln() + f64::from(self.exponent) * std::f64::consts::LN_2
    }

    /// This over another one.
    pub fn over(self, other: Self) -> Complex64 {
        self.value / other.value * 2.0_f64.powi(self.exponent - other.exponent)
    }
}

/// A model prepared for its determinant.
pub struct Determinant<'a> {
    model: &'a Model,
    /// From left to right.
    spans: Vec<Span>,
    /// 1 over the reference stiffness, E `I_y` of the first span: 1/(N m2).
    reference: Double2,
    /// 1 / n!.
    weights: [Double2; TERMS],
}

/// A span of the beam.
struct Span {
    /// Its ends, m.
    from: f64,
    to: f64,
    /// Its shear centre, from the axis.
    offset: Point,
    /// The reference stiffness over E (1 + i eta) (`I_y`, `Gamma_0`, `I_z`).
    compliance: [Complex2; FIELDS],
    /// G J / (E `Gamma_0`), 1/m2.
    torsion: Double2,
    /// rho [A, A z, 0; A z, `I_0`, 0; 0, 0, A], each row over E (`I_y`, `Gamma_0`, `I_z`), s2/m4.
    inertia: [[Double2; FIELDS]; FIELDS],
    /// 1 / (1 + i eta).
    softness: Complex2,
}

/// Six states at a position, and the power of two that was factored out of them.
struct Basis {
    states: [State; 6],
    exponent: i32,
}

impl<'a> Determinant<'a> {
    /// Of a model with warping stiffness in all of its spans.
    pub fn new(model: &'a Model) -> Self {
        let of = Double2::from;
        let spans = model.spans.iter().map(|span| {
            let beam = Beam {
                length: span.length,
                material: span.material.unwrap_or(model.beam.material),
                section: span.section.unwrap_or(model.beam.section),
                ..model.beam
            };
            (beam, span.offset)
        });
        let mut beams: Vec<(Beam, Point)> = spans.collect();
        if beams.is_empty() {
            beams.push((model.beam, Point::AXIS));
        }
        let first = &beams[0].0;
        let stiffness = of(first.material.young_modulus) * of(first.section.second_moment_y);
        let reference = of(1.0) / stiffness;
        let mut from = 0.0;
        let spans = beams.iter().map(|(beam, offset)| {
            let span = Span::new(from, beam, *offset, reference);
            from = span.to;
            span
        });
        let mut weights = [of(1.0); TERMS];
        for n in 1..TERMS {
            weights[n] = weights[n - 1] / of(n as f64);
        }
        Self {
            model,
            spans: spans.collect(),
            reference,
            weights,
        }
    }

    /// The determinant at omega, rad/s: analytic, zero at the modes and nowhere else, up to a constant factor.
    pub fn at(&self, omega: Complex64) -> Scaled {
        let omega = Complex2::from(omega);
        let mut basis = self.start(omega);
        let mut product = [Complex2::ONE];
        let mut x = 0.0;
        let inner = &self.model.supports.inner;
        let masses = self.model.attached().map(|mass| mass.position);
        let joints = self.model.joints.iter().map(|joint| joint.position);
        let held = inner.iter().map(|of| of.position);
        let ends = self.spans.iter().map(|span| span.to);
        let mut places: Vec<f64> = masses.chain(held).chain(joints).chain(ends).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        for place in places {
            self.cross(x, place, omega, &mut basis);
            x = place;
            for joint in (self.model.joints.iter()).filter(|joint| joint.position == place) {
                product[0] = product[0] * self.part(joint, omega, &mut basis);
                basis.exponent += normalise(&mut product);
                basis.separate();
            }
            for mass in self.model.attached().filter(|mass| mass.position == place) {
                product[0] = product[0] * self.attach(mass, omega, &mut basis);
                basis.exponent += normalise(&mut product);
                basis.separate();
            }
            for held in inner.iter().filter(|held| held.position == place) {
                product[0] = product[0] * self.hold(&held.support, omega, &mut basis);
                basis.exponent += normalise(&mut product);
                basis.separate();
            }
        }
        // A Maxwell branch gives it a pole.
        let springs = SpringId::all(self.model).filter_map(|id| id.spring(self.model));
        for branch in springs.flat_map(|of| &of.maxwell).filter(|of| of.acts()) {
            let damper = omega.turned() * Double2::from(branch.damping);
            product[0] = product[0] * (damper + Double2::from(branch.stiffness).into());
            basis.exponent += normalise(&mut product);
        }
        let (value, exponent) = determinant(self.right_end(omega, &basis.states));
        let value = (value * product[0]).rounded();
        Scaled {
            value,
            exponent: basis.exponent + exponent,
        }
    }

    /// Six independent states that the left support allows.
    fn start(&self, omega: Complex2) -> Basis {
        let states = std::array::from_fn(|motion| {
            let mut state = [Complex2::ZERO; 12];
            match stiffness(&self.model.supports.left, motion, omega) {
                None => state[6 + motion] = Complex2::ONE,
                Some(stiffness) => {
                    state[motion] = Complex2::ONE;
                    self.load(&mut state, motion, stiffness);
                }
            }
            state
        });
        Basis {
            states,
            exponent: 0,
        }
    }

    /// Adds a force (N, N m or N m2) along a motion of the axis to a state.
    fn load(&self, state: &mut State, motion: usize, force: Complex2) {
        state[6 + motion] += force * self.reference;
    }

    /// The values that must be zero at the right support, of each state.
    fn right_end(&self, omega: Complex2, states: &[State; 6]) -> [[Complex2; 6]; 6] {
        let right = &self.model.supports.right;
        std::array::from_fn(|motion| {
            let stiffness = stiffness(right, motion, omega);
            states.each_ref().map(|state| match stiffness {
                None => state[motion],
                Some(stiffness) => stiffness * self.reference * state[motion] + state[6 + motion],
            })
        })
    }

    /// Passes a joint: its right side moves by the internal force over the stiffness more than its left side. Returns a
    /// factor of the determinant.
    fn part(&self, joint: &Joint, omega: Complex2, basis: &mut Basis) -> Complex2 {
        let mut factor = Complex2::ONE;
        for (motion, link) in joint.links.iter().enumerate() {
            let Link::Elastic(spring) = link else {
                continue;
            };
            let stiffness = dynamic(spring, omega);
            let softness = (stiffness * self.reference).inverse();
            for state in &mut basis.states {
                let force = state[6 + motion];
                state[motion] += force * softness;
            }
            factor = factor * stiffness;
        }
        for (motion, link) in joint.links.iter().enumerate() {
            if *link == Link::Free {
                let forces = basis.states.map(|state| state[6 + motion]);
                let mut parted = [Complex2::ZERO; 12];
                parted[motion] = Complex2::ONE;
                factor = factor * basis.exchange(forces, &parted);
            }
        }
        factor
    }

    /// Propagates the states from one position to another, within a span.
    fn cross(&self, from: f64, to: f64, omega: Complex2, basis: &mut Basis) {
        let length = Double2::from(to) - Double2::from(from);
        let inside = self.spans.iter().find(|span| to <= span.to);
        let Some(span) = inside.filter(|_| length.rounded() > 0.0) else {
            return;
        };
        let steps = (length.rounded() * span.fastest(omega) / GROWTH)
            .ceil()
            .max(1.0);
        let h = length / Double2::from(steps);
        basis.states = basis.states.map(|state| span.derivatives(&state));
        rescale(&mut basis.states, h);
        let transfer = span.transfer(h, omega, &self.weights);
        for _ in 0..steps as usize {
            for state in &mut basis.states {
                *state = carried(&transfer, state);
            }
            basis.separate();
        }
        rescale(&mut basis.states, Double2::from(1.0) / h);
        basis.states = basis.states.map(|state| span.on_axis(&state));
        basis.separate();
    }

    /// An upper bound on the phase (rad) of the fastest wave of an angular frequency (rad/s) along the beam.
    pub fn waves(&self, omega: f64) -> f64 {
        let omega = Complex2::from(Complex64::from(omega));
        let phase = |span: &Span| span.fastest(omega) * (span.to - span.from);
        self.spans.iter().map(phase).sum()
    }

    /// Adds a support: w and v of its point are `w + z psi` and `v - y psi`, and forces there turn about the axis. Returns a
    /// factor of the determinant.
    fn hold(&self, support: &Support, omega: Complex2, basis: &mut Basis) -> Complex2 {
        let mut factor = Complex2::ONE;
        for motion in 0..6 {
            if let Some(stiffness) = stiffness(support, motion, omega) {
                for state in &mut basis.states {
                    let force = stiffness * self.reference * moved(support, motion, state);
                    react(support, motion, force, state);
                }
            }
        }
        for motion in 0..6 {
            if stiffness(support, motion, omega).is_none() {
                factor = factor * fix(support, motion, basis);
            }
        }
        factor
    }

    /// Adds a mass on its springs; returns the determinant of the mass with the beam blocked.
    fn attach(&self, subsystem: &Subsystem, omega: Complex2, basis: &mut Basis) -> Complex2 {
        let (stiffness, own) = blocked(subsystem, omega);
        for state in &mut basis.states {
            let motion = [state[0], state[1], state[2]];
            for field in 0..FIELDS {
                let mut force = Complex2::ZERO;
                for by in 0..FIELDS {
                    force += stiffness[field][by] * motion[by];
                }
                self.load(state, field, force);
            }
        }
        own
    }
}

/// Fixes a motion: one state makes it zero in all others, and an unknown force takes its place.
fn fix(support: &Support, motion: usize, basis: &mut Basis) -> Complex2 {
    let values = basis.states.map(|state| moved(support, motion, &state));
    let mut held = [Complex2::ZERO; 12];
    react(support, motion, Complex2::ONE, &mut held);
    basis.exchange(values, &held)
}

/// Adds a force, over the reference stiffness, along a motion of the point of a support to a state.
fn react(support: &Support, motion: usize, force: Complex2, state: &mut State) {
    state[6 + motion] += force;
    state[6 + BeamMotion::Psi as usize] += force * arm(support, motion);
}

impl Span {
    /// It begins at `from`, m.
    fn new(from: f64, beam: &Beam, offset: Point, reference: Double2) -> Self {
        let (material, section) = (&beam.material, &beam.section);
        assert!(section.warping_constant > 0.0, "psi is of fourth order");
        let of = Double2::from;
        let softness = Complex2::new(of(1.0), of(material.loss_factor)).inverse();
        let stiffness = [
            section.second_moment_y,
            section.warping_constant,
            section.second_moment_z,
        ]
        .map(|moment| of(material.young_modulus) * of(moment));
        let [area, polar, none] = [section.area, section.polar_moment, 0.0].map(of);
        let lever = area * of(section.centroid_offset);
        let rows = [
            [area, lever, none],
            [lever, polar, none],
            [none, none, area],
        ];
        let density = of(material.density);
        Self {
            from,
            to: from + beam.length,
            offset,
            compliance: stiffness.map(|stiffness| softness * (of(1.0) / (stiffness * reference))),
            torsion: of(material.shear_modulus) * of(section.torsion_constant) / stiffness[1],
            inertia: std::array::from_fn(|row| {
                rows[row].map(|area| density * area / stiffness[row])
            }),
            softness,
        }
    }

    /// The derivatives of its own motions, with 1 m as length, from a state of the axis. Internal forces are `E I` times
    /// minus the third derivative, for twist `G J psi'` more, and `E I` times the second one.
    fn derivatives(&self, axis: &State) -> State {
        let [y, z] = [self.offset.y, self.offset.z].map(Double2::from);
        let mut own = *axis;
        for first in [0, FIELDS] {
            let (psi, force) = (own[first + 1], [own[6 + first], own[8 + first]]);
            own[first] += psi * z;
            own[first + 2] -= psi * y;
            own[7 + first] -= force[0] * z - force[1] * y;
        }
        let mut state = own;
        for field in 0..FIELDS {
            state[6 + field] = own[9 + field] * self.compliance[field];
            state[9 + field] = -(own[6 + field] * self.compliance[field]);
        }
        state[10] += own[4] * self.torsion;
        state
    }

    /// The opposite of [`Self::derivatives`].
    fn on_axis(&self, derivatives: &State) -> State {
        let [y, z] = [self.offset.y, self.offset.z].map(Double2::from);
        let mut bent = *derivatives;
        bent[10] -= bent[4] * self.torsion;
        let mut state = bent;
        for field in 0..FIELDS {
            let stiffness = self.compliance[field].inverse();
            state[9 + field] = bent[6 + field] * stiffness;
            state[6 + field] = -(bent[9 + field] * stiffness);
        }
        for first in [0, FIELDS] {
            let (psi, force) = (state[first + 1], [state[6 + first], state[8 + first]]);
            state[first] -= psi * z;
            state[first + 2] += psi * y;
            state[7 + first] += force[0] * z - force[1] * y;
        }
        state
    }

    /// A bound on the wave numbers, 1/m.
    fn fastest(&self, omega: Complex2) -> f64 {
        let square = (omega * omega * self.softness).rounded().norm();
        let [w, psi, v] = [0, 1, 2].map(|field| square * self.inertia[field][field].rounded());
        let half = 0.5 * self.torsion.rounded();
        (half + (half * half + w + psi).sqrt())
            .sqrt()
            .max(v.powf(0.25))
    }

    /// The states of unit h after h, a column for each entry of the state before.
    ///
    /// In units of h the fields u obey `u'''' = P u'' + Q u`. Let `d(0) = 0`, `d(2) = 1`, `d(n+4) = P d(n+2) + Q d(n)`: the
    /// solution that starts with `u'' = 1` alone has d(n) as its n-th derivative at 0, that with `u''' = 1` has d(n-1),
    /// with `u = 1` d(n+2) - d(n) P, with `u' = 1` d(n+1) - d(n-1) P.
    fn transfer(&self, h: Double2, omega: Complex2, weights: &[Double2; TERMS]) -> [State; 12] {
        let square = h * h;
        let pull = self.torsion * square;
        let inertia = omega * omega * self.softness * (square * square);
        // The sums over n of d(n+i) / n!, from i = -1 on.
        let mut sums = [[[Complex2::ZERO; FIELDS]; FIELDS]; 7];
        let mut before: Block = Default::default();
        let mut here = before;
        for field in 0..FIELDS {
            here[field][field] = Complex2::ONE;
        }
        for order in (2..TERMS - 1).step_by(2) {
            let mut next: Block = Default::default();
            for row in 0..FIELDS {
                for &column in coupled(row) {
                    for (index, sum) in sums.iter_mut().enumerate() {
                        if let Some(n) = (order + 1).checked_sub(index) {
                            sum[row][column] += here[row][column] * weights[n];
                        }
                    }
                    let mut forced = Complex2::ZERO;
                    for &by in coupled(row) {
                        forced += before[by][column] * self.inertia[row][by];
                    }
                    next[row][column] = forced * inertia;
                    if row == 1 {
                        next[row][column] += here[row][column] * pull;
                    }
                }
            }
            (before, here) = (here, next);
        }
        let mut columns = [[Complex2::ZERO; 12]; 12];
        for order in 0..4 {
            for row in 0..FIELDS {
                for &field in coupled(row) {
                    let sum = |index: usize| sums[order + index][row][field];
                    let pull = if field == 1 { pull } else { Double2::from(0.0) };
                    let starts = [
                        sum(3) - sum(1) * pull,
                        sum(2) - sum(0) * pull,
                        sum(1),
                        sum(0),
                    ];
                    for (start, entry) in starts.into_iter().enumerate() {
                        columns[FIELDS * start + field][FIELDS * order + row] = entry;
                    }
                }
            }
        }
        columns
    }
}

/// The fields that a field is coupled with in the beam.
fn coupled(field: usize) -> &'static [usize] {
    if field < 2 { &[0, 1] } else { &[2] }
}

/// The stiffness of a mass on its springs against (w, psi, v), the mass eliminated, and the determinant of the mass.
fn blocked(subsystem: &Subsystem, omega: Complex2) -> (Block, Complex2) {
    let square = omega * omega;
    let [y_left, y_right, z_left, z_right] = subsystem.springs().map(|of| dynamic(of, omega));
    let (y_u, z_b) = (subsystem.mount_y, subsystem.mount_z);
    // Over (y, z, theta | w, psi, v).
    let springs = [
        (y_left + y_right, [1.0, 0.0, 0.0, -1.0, -z_b, 0.0]),
        (z_left, [0.0, 1.0, -subsystem.arm_left, 0.0, y_u, -1.0]),
        (z_right, [0.0, 1.0, subsystem.arm_right, 0.0, -y_u, -1.0]),
    ];
    let mut full = [[Complex2::ZERO; 6]; 6];
    for (stiffness, stretch) in springs {
        for i in 0..6 {
            for j in 0..6 {
                full[i][j] += stiffness * (Double2::from(stretch[i]) * Double2::from(stretch[j]));
            }
        }
    }
    let inertias = [subsystem.mass, subsystem.mass, subsystem.inertia];
    for (index, inertia) in inertias.into_iter().enumerate() {
        full[index][index] -= square * Double2::from(inertia);
    }
    let mut own = Complex2::ONE;
    for pivot in 0..3 {
        // Neither inertia nor springs.
        if full[pivot][pivot] == Complex2::ZERO {
            continue;
        }
        own = own * full[pivot][pivot];
        let inverse = full[pivot][pivot].inverse();
        let row = full[pivot];
        for other in &mut full[pivot + 1..] {
            let factor = other[pivot] * inverse;
            for column in pivot + 1..6 {
                other[column] -= factor * row[column];
            }
        }
    }
    let rest = std::array::from_fn(|i| std::array::from_fn(|j| full[3 + i][3 + j]));
    (rest, own)
}

/// The arm by which twist moves the point of a support along a motion, m.
fn arm(support: &Support, motion: usize) -> Double2 {
    let arm = support.point.arm(BeamMotion::ALL[motion]);
    Double2::from(arm.unwrap_or_default())
}

/// A motion of the point of a support: m, rad or rad/m.
fn moved(support: &Support, motion: usize, state: &State) -> Complex2 {
    state[motion] + state[BeamMotion::Psi as usize] * arm(support, motion)
}

/// k (1 + i eta) + i omega c, and the series of spring and damper of each Maxwell branch.
fn dynamic(spring: &Spring, omega: Complex2) -> Complex2 {
    let stiffness = Double2::from(spring.stiffness);
    let mut sum = Complex2::new(stiffness, stiffness * Double2::from(spring.loss_factor))
        + omega.turned() * Double2::from(spring.damping);
    for branch in spring.maxwell.iter().filter(|of| of.acts()) {
        let (k, c) = (
            Double2::from(branch.stiffness),
            Double2::from(branch.damping),
        );
        let damper = omega.turned() * c;
        sum += damper * k * (damper + Complex2::from(k)).inverse();
    }
    sum
}

/// The stiffness of a support against a motion; none where it is fixed.
fn stiffness(support: &Support, motion: usize, omega: Complex2) -> Option<Complex2> {
    match &support[BeamMotion::ALL[motion]] {
        Restraint::Fixed => None,
        Restraint::Free => Some(Complex2::ZERO),
        Restraint::Elastic(elastic) => {
            Some(dynamic(&elastic.spring, omega) - omega * omega * Double2::from(elastic.inertia))
        }
    }
}

/// Multiplies the states' unit of length by `ratio`.
fn rescale(states: &mut [State; 6], ratio: Double2) {
    for state in states {
        let mut power = ratio;
        for order in 1..4 {
            for field in 0..FIELDS {
                state[FIELDS * order + field] = state[FIELDS * order + field] * power;
            }
            power = power * ratio;
        }
    }
}

fn carried(columns: &[State; 12], state: &State) -> State {
    let mut after = [Complex2::ZERO; 12];
    for (from, column) in columns.iter().enumerate() {
        for order in 0..4 {
            for &field in coupled(from % FIELDS) {
                let to = FIELDS * order + field;
                after[to] += column[to] * state[from];
            }
        }
    }
    after
}

impl Basis {
    /// Makes a value zero: one state makes it zero in all others, and a new state takes its place. Returns its value.
    fn exchange(&mut self, values: [Complex2; 6], new: &State) -> Complex2 {
        let size = |index: &usize| values[*index].rounded().norm();
        let pivot = (0..6).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap();
        let (own, inverse) = (self.states[pivot], values[pivot].inverse());
        for (state, value) in self.states.iter_mut().zip(values) {
            for (entry, own) in state.iter_mut().zip(&own) {
                *entry -= value * inverse * *own;
            }
        }
        self.states[pivot] = *new;
        values[pivot]
    }

    /// Makes the states nearly orthogonal and of size 1. It subtracts multiples of other states, which does not change
    /// the determinant, so the multiples need not be exact.
    fn separate(&mut self) {
        for index in 0..self.states.len() {
            let (done, rest) = self.states.split_at_mut(index);
            let own = &mut rest[0];
            for other in done.iter() {
                let pairs = || other.iter().zip(own.iter());
                let (mut share, mut size) = (Complex64::ZERO, 0.0);
                for (a, b) in pairs() {
                    share += a.rounded().conj() * b.rounded();
                    size += a.rounded().norm_sqr();
                }
                let factor = -share / size;
                for (own, other) in own.iter_mut().zip(other) {
                    *own += other.times_short(factor);
                }
            }
            self.exponent += normalise(own);
        }
    }
}

/// Factors a power of two out of numbers so that the largest is about 1; returns its exponent.
fn normalise(values: &mut [Complex2]) -> i32 {
    let parts = values.iter().map(|value| value.rounded());
    let largest = parts.fold(0.0, |largest, z| z.re.abs().max(z.im.abs()).max(largest));
    if largest == 0.0 {
        return 0;
    }
    let exponent = largest.log2().floor() as i32;
    let power = 2.0_f64.powi(-exponent);
    for value in values {
        *value = value.times_exactly(power);
    }
    exponent
}

/// By elimination with partial pivoting; a number times a power of two.
fn determinant(mut a: [[Complex2; 6]; 6]) -> (Complex2, i32) {
    let mut exponent: i32 = a.iter_mut().map(|row| normalise(row)).sum();
    let mut product = [Complex2::ONE];
    for column in 0..6 {
        let size = |row: &usize| a[*row][column].rounded().norm();
        let pivot = (column..6)
            .max_by(|i, j| size(i).total_cmp(&size(j)))
            .unwrap_or(column);
        if pivot != column {
            a.swap(pivot, column);
            product[0] = -product[0];
        }
        let top = a[column];
        product[0] = product[0] * top[column];
        if product[0] == Complex2::ZERO {
            return (Complex2::ZERO, 0);
        }
        exponent += normalise(&mut product);
        let inverse = top[column].inverse();
        for row in &mut a[column + 1..] {
            let factor = row[column] * inverse;
            for k in column..6 {
                row[k] -= factor * top[k];
            }
        }
    }
    (product[0], exponent)
}
