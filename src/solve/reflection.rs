//! The reflection a = R b + s, seen looking left from a point, and how spans, subsystems and loads change it.

use num_complex::Complex64;

use super::attachment::{Attachment, Channels, UNKNOWNS};
use super::linear::{Matrix, ZERO, zeros};
use super::waves::Waves;

/// Six wave amplitudes.
pub(super) type Amplitudes = [Complex64; 6];

/// a = R b + s at a point, looking left.
#[derive(Debug, Clone)]
pub(super) struct Reflection {
    /// R.
    pub(super) r: Matrix<6, 6>,
    /// The forced part.
    pub(super) s: Amplitudes,
}

/// The beam at a place where something is to be attached.
#[derive(Debug)]
pub(super) struct Contact {
    /// Displacement (w, psi, v) per wave from the right.
    pub(super) moved: Matrix<3, 6>,
    /// Displacement with nothing arriving from the right.
    pub(super) still: [Complex64; 3],
    /// Displacement per jump of the internal forces.
    pub(super) receptance: Matrix<3, 3>,
    /// (I + R) X: waves per jump of the internal forces.
    outgoing: Matrix<6, 3>,
}

impl Channels {
    /// The unknowns for waves `b` just right of the station.
    pub(super) fn at(&self, b: &Amplitudes) -> [Complex64; UNKNOWNS] {
        std::array::from_fn(|row| self.forced[row] + dot(&self.from_waves[row], b))
    }
}

impl Reflection {
    /// a for given b.
    pub(super) fn at(&self, b: &Amplitudes) -> Amplitudes {
        std::array::from_fn(|row| self.s[row] + dot(&self.r[row], b))
    }

    /// Over a span: R <- e R e, s <- e s.
    pub(super) fn propagate(&mut self, decay: &Amplitudes) {
        for row in 0..6 {
            for column in 0..6 {
                self.r[row][column] *= decay[row] * decay[column];
            }
            self.s[row] *= decay[row];
        }
    }

    /// What a subsystem meets here.
    pub(super) fn contact(&self, waves: &Waves) -> Contact {
        let arriving = self.plus_identity();
        let outgoing = radiating(&arriving, &waves.from_force);
        Contact {
            moved: product3(&waves.displacement, &arriving),
            still: std::array::from_fn(|row| dot(&waves.displacement[row], &self.s)),
            receptance: receptance(&waves.displacement, &outgoing),
            outgoing,
        }
    }

    /// Past a subsystem: its jump f of the internal forces radiates X f both ways.
    pub(super) fn attach(
        &mut self,
        contact: &Contact,
        omega: Complex64,
        attachment: &Attachment,
    ) -> Channels {
        let outgoing = &contact.outgoing;
        let channels = attachment.channels(omega, contact);
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
    pub(super) fn load(&mut self, waves: &Waves, load: &[Complex64; 6]) {
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

pub(super) fn dot(row: &Amplitudes, b: &Amplitudes) -> Complex64 {
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
pub(super) const fn reach(row: usize) -> std::ops::Range<usize> {
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
pub(super) fn radiated(
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
pub(super) fn jumps_of_load(load: &[Complex64; 6]) -> ([Complex64; 3], [Complex64; 3]) {
    (
        [-load[0], -load[1], -load[2]],
        [-load[3], -load[4], -load[5]],
    )
}

pub(super) fn add_to(to: &mut Amplitudes, what: &Amplitudes) {
    to.iter_mut().zip(what).for_each(|(to, what)| *to += what);
}

pub(super) fn decay_in_place(b: &mut Amplitudes, decay: &Amplitudes) {
    b.iter_mut().zip(decay).for_each(|(b, decay)| *b *= decay);
}

/// exp(-kappa l); 1 over no length, also for the wave that decays at once.
pub(super) fn decay(waves: &Waves, length: f64) -> Amplitudes {
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
