//! The response of a plan at one frequency: a sweep of reflections from left to right, and of amplitudes back.
//!
//! At every point the right-going amplitudes are carried as `a = R b + s`, seen looking left; only decaying
//! exponentials occur, so nothing is lost however long the beam or high the frequency, where a product of transfer
//! matrices loses digits like `exp(2 kappa L)` (Chen & Liu 2022, Eq. 48). Cost and memory are linear in the stations.

use num_complex::Complex64;

use super::attachment::{Attachment, Channels, UNKNOWNS};
use super::energy::SpanEnergy;
use super::linear::{Matrix, ZERO, size, solve, solve_with_margin, zeros};
use super::plan::{End, Event, Output, Plan};
use super::waves::Waves;
use crate::model::{BeamMotion, Elastic, Measure, Restraint};

/// Six wave amplitudes.
pub(super) type Amplitudes = [Complex64; 6];

/// A margin of the last system below which its answer is rounding alone: the model has no damping and is at a
/// resonance to the last digits of the frequency.
const RESONANT: f64 = 1e-14;

/// a = R b + s at a point, looking left.
#[derive(Debug, Clone)]
struct Reflection {
    r: Matrix<6, 6>,
    s: Amplitudes,
}

/// What the sweep to the right leaves at a station for the way back.
#[derive(Debug, Clone)]
struct Record {
    /// The reflection just left of the station.
    left: Reflection,
    /// The unknowns of an attachment.
    channels: Option<Channels>,
}

/// The solution at a station.
#[derive(Debug, Clone)]
struct State {
    /// Amplitudes just left of it.
    a: Amplitudes,
    b: Amplitudes,
    /// The unknowns of an attachment.
    unknowns: [Complex64; UNKNOWNS],
}

/// Room for one frequency at a time; reused, so that a sweep does not allocate.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    /// exp(-kappa l) of each distinct span.
    decays: Vec<Amplitudes>,
    records: Vec<Record>,
    states: Vec<State>,
}

impl Workspace {
    /// Writes the response of every output at `frequency` (Hz, > 0) to `out`. Where the model has no finite answer
    /// (no damping, exactly at a resonance) the values are not finite.
    pub(super) fn solve(&mut self, plan: &Plan, frequency: f64, out: &mut [Complex64]) {
        let omega = std::f64::consts::TAU * frequency;
        let waves = Waves::new(&plan.beam, omega);
        self.decays.clear();
        self.decays
            .extend(plan.lengths.iter().map(|&length| decay(&waves, length)));
        let start = left_end(plan, &waves, omega);
        let at_end = self.sweep_right(plan, &waves, omega, start.clone());
        let b = right_end(plan, &waves, omega, &at_end);
        let energy = self.sweep_left(plan, &waves, b, &start);
        for (value, output) in out.iter_mut().zip(&plan.outputs) {
            *value = self.read(plan, &waves, omega, *output, energy);
        }
    }

    /// Carries the reflection over all stations; what returns is that of the right end.
    fn sweep_right(
        &mut self,
        plan: &Plan,
        waves: &Waves,
        omega: f64,
        mut at: Reflection,
    ) -> Reflection {
        self.records.clear();
        for (station, &span) in plan.stations.iter().zip(&plan.spans) {
            at.propagate(&self.decays[span]);
            let left = at.clone();
            let channels = match &station.event {
                Event::Attachment(attachment) => Some(at.attach(waves, omega, attachment)),
                Event::Load(load) => {
                    at.load(waves, load);
                    None
                }
                Event::Probe => None,
            };
            self.records.push(Record { left, channels });
        }
        at.propagate(&self.decays[plan.last_span()]);
        at
    }

    /// Carries b back to the left end, keeping the state of every station; returns `E_V` where it is wanted.
    fn sweep_left(
        &mut self,
        plan: &Plan,
        waves: &Waves,
        mut b: Amplitudes,
        start: &Reflection,
    ) -> f64 {
        let energy = plan
            .wants_energy
            .then(|| SpanEnergy::new(plan, waves, &self.decays));
        let mut sum = 0.0;
        self.states.clear();
        for (index, station) in plan.stations.iter().enumerate().rev() {
            let span = plan.spans[index + 1];
            let at_span_end = b;
            decay_in_place(&mut b, &self.decays[span]);
            let record = &self.records[index];
            let mut unknowns = [ZERO; UNKNOWNS];
            let (to_right, to_left) = match (&station.event, &record.channels) {
                (Event::Attachment(attachment), Some(channels)) => {
                    unknowns = channels.at(&b);
                    radiated(waves, &attachment.jump(&unknowns), &[ZERO; 3])
                }
                (Event::Load(load), _) => {
                    let (force, moment) = jumps_of_load(load);
                    radiated(waves, &force, &moment)
                }
                _ => ([ZERO; 6], [ZERO; 6]),
            };
            add_to(&mut b, &to_left);
            let a = record.left.at(&b);
            if let Some(energy) = &energy {
                let mut at_span_start = a;
                add_to(&mut at_span_start, &to_right);
                sum += energy.of(span, &at_span_start, &at_span_end);
            }
            self.states.push(State { a, b, unknowns });
        }
        self.states.reverse();
        if let Some(energy) = &energy {
            let at_span_end = b;
            decay_in_place(&mut b, &self.decays[plan.spans[0]]);
            sum += energy.of(plan.spans[0], &start.at(&b), &at_span_end);
        }
        sum
    }

    fn read(
        &self,
        plan: &Plan,
        waves: &Waves,
        omega: f64,
        output: Output,
        energy: f64,
    ) -> Complex64 {
        match output {
            Output::Held => ZERO,
            Output::Energy => energy.into(),
            Output::Beam {
                station,
                motion,
                measure,
            } => derivative(omega, measure) * beam_motion(waves, motion, &self.states[station]),
            Output::Mass {
                station,
                motion,
                measure,
            } => {
                let state = &self.states[station];
                let q = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V]
                    .map(|m| beam_motion(waves, m, state));
                match &plan.stations[station].event {
                    Event::Attachment(attachment) => {
                        let moved = attachment.motion(omega, &state.unknowns, &q);
                        derivative(omega, measure) * moved[motion as usize]
                    }
                    Event::Load(_) | Event::Probe => ZERO,
                }
            }
        }
    }
}

impl Channels {
    /// The unknowns for waves `b` just right of the station.
    fn at(&self, b: &Amplitudes) -> [Complex64; UNKNOWNS] {
        std::array::from_fn(|row| self.forced[row] + dot(&self.from_waves[row], b))
    }
}

impl Reflection {
    /// a for given b.
    fn at(&self, b: &Amplitudes) -> Amplitudes {
        std::array::from_fn(|row| self.s[row] + dot(&self.r[row], b))
    }

    /// Over a span: R <- e R e, s <- e s.
    fn propagate(&mut self, decay: &Amplitudes) {
        for row in 0..6 {
            for column in 0..6 {
                self.r[row][column] *= decay[row] * decay[column];
            }
            self.s[row] *= decay[row];
        }
    }

    /// Past a subsystem: its jump f of the internal forces radiates X f both ways.
    fn attach(&mut self, waves: &Waves, omega: f64, attachment: &Attachment) -> Channels {
        let arriving = self.plus_identity();
        let moved = product3(&waves.displacement, &arriving);
        let still = std::array::from_fn(|row| dot(&waves.displacement[row], &self.s));
        let outgoing = radiating(&arriving, &waves.from_force);
        let receptance = receptance(&waves.displacement, &outgoing);
        let channels = attachment.channels(omega, &receptance, &moved, &still);
        for column in 0..6 {
            let unknowns = std::array::from_fn(|row| channels.from_waves[row][column]);
            let jump = attachment.jump(&unknowns);
            for row in 0..6 {
                self.r[row][column] += dot3(&outgoing[row], &jump);
            }
        }
        let jump = attachment.jump(&channels.forced);
        for row in 0..6 {
            self.s[row] += dot3(&outgoing[row], &jump);
        }
        channels
    }

    /// Past loads: s <- s + (I + R) X f + (I - R) Y m.
    fn load(&mut self, waves: &Waves, load: &[Complex64; 6]) {
        let (force, moment) = jumps_of_load(load);
        let (to_right, to_left) = radiated(waves, &force, &moment);
        // What goes left comes back reflected.
        let returned: Amplitudes = std::array::from_fn(|row| dot(&self.r[row], &to_left));
        add_to(&mut self.s, &to_right);
        add_to(&mut self.s, &returned);
    }

    /// I + R.
    fn plus_identity(&self) -> Matrix<6, 6> {
        let mut out = self.r;
        for (index, row) in out.iter_mut().enumerate() {
            row[index] += 1.0;
        }
        out
    }
}

fn dot(row: &Amplitudes, b: &Amplitudes) -> Complex64 {
    let mut sum = ZERO;
    for k in 0..6 {
        sum += row[k] * b[k];
    }
    sum
}

fn dot3(row: &[Complex64; 3], f: &[Complex64; 3]) -> Complex64 {
    row[0] * f[0] + row[1] * f[1] + row[2] * f[2]
}

/// Columns of the waves that a row (w, psi, v) of Q, S, P or M, or a column of X, can reach.
const fn reach(row: usize) -> std::ops::Range<usize> {
    if row < 2 { 0..4 } else { 4..6 }
}

/// Q A for the sparse Q of the waves.
fn product3(q: &Matrix<3, 6>, a: &Matrix<6, 6>) -> Matrix<3, 6> {
    let mut out = zeros::<3, 6>();
    for row in 0..3 {
        for wave in reach(row) {
            for column in 0..6 {
                out[row][column] += q[row][wave] * a[wave][column];
            }
        }
    }
    out
}

/// (I + R) X.
fn radiating(arriving: &Matrix<6, 6>, x: &Matrix<6, 3>) -> Matrix<6, 3> {
    let mut out = zeros::<6, 3>();
    for row in 0..6 {
        for column in 0..3 {
            for wave in reach(column) {
                out[row][column] += arriving[row][wave] * x[wave][column];
            }
        }
    }
    out
}

/// Q (I + R) X: the displacement per jump of the internal forces, with nothing arriving from the right.
fn receptance(q: &Matrix<3, 6>, outgoing: &Matrix<6, 3>) -> Matrix<3, 3> {
    let mut out = zeros::<3, 3>();
    for row in 0..3 {
        for wave in reach(row) {
            for column in 0..3 {
                out[row][column] += q[row][wave] * outgoing[wave][column];
            }
        }
    }
    out
}

/// What jumps of force and moment send (right, left): X f + Y m and X f - Y m.
fn radiated(
    waves: &Waves,
    force: &[Complex64; 3],
    moment: &[Complex64; 3],
) -> (Amplitudes, Amplitudes) {
    let (mut to_right, mut to_left) = ([ZERO; 6], [ZERO; 6]);
    for wave in 0..6 {
        let even = dot3(&waves.from_force[wave], force);
        let odd = dot3(&waves.from_moment[wave], moment);
        to_right[wave] = even + odd;
        to_left[wave] = even - odd;
    }
    (to_right, to_left)
}

/// The jumps (forces, moments) that a load makes: p(x+) = p(x-) - F.
fn jumps_of_load(load: &[Complex64; 6]) -> ([Complex64; 3], [Complex64; 3]) {
    (
        [-load[0], -load[1], -load[2]],
        [-load[3], -load[4], -load[5]],
    )
}

fn add_to(to: &mut Amplitudes, what: &Amplitudes) {
    to.iter_mut().zip(what).for_each(|(to, what)| *to += what);
}

fn decay_in_place(b: &mut Amplitudes, decay: &Amplitudes) {
    b.iter_mut().zip(decay).for_each(|(b, decay)| *b *= decay);
}

/// exp(-kappa l); 1 over no length, also for the wave that decays at once.
fn decay(waves: &Waves, length: f64) -> Amplitudes {
    waves.kappa.map(|kappa| {
        if length == 0.0 {
            Complex64::ONE
        } else if kappa.re.is_infinite() {
            ZERO
        } else {
            (-kappa * length).exp()
        }
    })
}

fn derivative(omega: f64, measure: Measure) -> Complex64 {
    match measure {
        Measure::Displacement => Complex64::ONE,
        Measure::Velocity => Complex64::new(0.0, omega),
        Measure::Acceleration => Complex64::new(-omega * omega, 0.0),
    }
}

/// A motion of the beam: Q (a + b), or -S (a - b) for a slope.
fn beam_motion(waves: &Waves, motion: BeamMotion, state: &State) -> Complex64 {
    let row = motion as usize;
    let mut sum = ZERO;
    for wave in reach(row % 3) {
        sum += if row < 3 {
            waves.displacement[row][wave] * (state.a[wave] + state.b[wave])
        } else {
            waves.slope[row - 3][wave] * (state.b[wave] - state.a[wave])
        };
    }
    sum
}

/// The equation of one motion of an end as coefficients of (a, b), with what stands on its right.
///
/// `outward` is the sign with which internal forces enter: -1 at the left end (-p + K q = F), +1 at the right.
fn end_row(
    plan: &Plan,
    waves: &Waves,
    omega: f64,
    end: &End,
    motion: BeamMotion,
    outward: f64,
) -> [Amplitudes; 3] {
    let row = motion as usize;
    let slope = row >= 3;
    let (moved, acted) = if slope {
        (&waves.slope[row - 3], &waves.moment[row - 3])
    } else {
        (&waves.displacement[row], &waves.force[row])
    };
    let right = [end.load[row]; 6];
    // Displacements go with a + b and forces with a - b; slopes with b - a and moments with a + b.
    let (of_a, of_b) = if slope { (-1.0, 1.0) } else { (1.0, 1.0) };
    let (force_a, force_b) = if slope { (1.0, 1.0) } else { (1.0, -1.0) };
    match end.support[motion] {
        Restraint::Fixed => [moved.map(|x| of_a * x), moved.map(|x| of_b * x), [ZERO; 6]],
        // Without warping stiffness the least restraint holds the rate of twist.
        Restraint::Elastic(elastic)
            if motion == BeamMotion::PsiSlope
                && plan.beam.without_warping()
                && elastic != Elastic::default() =>
        {
            [moved.map(|x| of_a * x), moved.map(|x| of_b * x), [ZERO; 6]]
        }
        restraint => {
            let k = stiffness(restraint, omega);
            let combine = |sign: f64, force: f64| {
                std::array::from_fn(|wave| k * sign * moved[wave] + outward * force * acted[wave])
            };
            [combine(of_a, force_a), combine(of_b, force_b), right]
        }
    }
}

fn stiffness(restraint: Restraint, omega: f64) -> Complex64 {
    match restraint {
        Restraint::Elastic(Elastic {
            stiffness,
            damping,
            inertia,
        }) => Complex64::new(stiffness - omega * omega * inertia, omega * damping),
        Restraint::Free | Restraint::Fixed => ZERO,
    }
}

/// a = R b + s at the left end.
fn left_end(plan: &Plan, waves: &Waves, omega: f64) -> Reflection {
    let mut of_a = zeros::<6, 6>();
    let mut right = zeros::<6, 7>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let [a, b, load] = end_row(plan, waves, omega, &plan.left, motion, -1.0);
        of_a[row] = a;
        for column in 0..6 {
            right[row][column] = -b[column];
        }
        right[row][6] = load[0];
    }
    let solved = solve(of_a, right);
    let mut reflection = Reflection {
        r: zeros(),
        s: [ZERO; 6],
    };
    for row in 0..6 {
        reflection.r[row].copy_from_slice(&solved[row][..6]);
        reflection.s[row] = solved[row][6];
    }
    reflection
}

/// b at the right end, from its six equations with a = R b + s; not finite at an undamped resonance.
fn right_end(plan: &Plan, waves: &Waves, omega: f64, at: &Reflection) -> Amplitudes {
    let mut of_b = zeros::<6, 6>();
    let mut terms = [[0.0; 6]; 6];
    let mut right = zeros::<6, 1>();
    for (row, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let [a, b, load] = end_row(plan, waves, omega, &plan.right, motion, 1.0);
        for column in 0..6 {
            let mut sum = b[column];
            let mut sizes = size(sum);
            for wave in 0..6 {
                let term = a[wave] * at.r[wave][column];
                sum += term;
                sizes += size(term);
            }
            of_b[row][column] = sum;
            terms[row][column] = sizes;
        }
        right[row][0] = load[0] - dot(&a, &at.s);
    }
    let (b, margin) = solve_with_margin(of_b, right, terms);
    if margin < RESONANT {
        return [Complex64::new(f64::INFINITY, 0.0); 6];
    }
    b.map(|row| row[0])
}
