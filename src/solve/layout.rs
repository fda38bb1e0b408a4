//! A model as the two reference methods see it: the positions along the beam with their subsystems and loads, and the
//! positions of the responses.
//!
//! [`fem`](super::fem) and [`transfer_matrix`](super::transfer_matrix) share it. The exact solver does not use it: they
//! must be independent of its `plan`.

use num_complex::Complex64;

use crate::model::{
    At, BeamMotion, MassMotion, Measure, Model, Place, Point, Quantity, Reaction, Response,
    Restraint, Spring, SpringMeasure, SpringName, Subsystem, Support, SupportId, Target,
    UniformPart,
};

/// The positions along a beam and what is attached there.
#[derive(Debug, Clone)]
pub(super) struct Layout<'a> {
    pub(super) model: &'a Model,
    /// Positions closer than this are merged, m.
    merge: f64,
    /// Distances from the left end, m, ascending; the first is 0 and the last the length.
    pub(super) positions: Vec<f64>,
    /// The uniform part of the beam between each position and the next.
    pub(super) parts: Vec<UniformPart>,
    /// Loads along the six motions at each position, N and N m.
    pub(super) loads: Vec<[Complex64; 6]>,
    /// What holds the beam, with the index of its position; the ends first.
    pub(super) supports: Vec<(usize, Support)>,
    /// The springs of each joint, with the index of its position: left of everything else there.
    pub(super) joints: Vec<(usize, [Option<Spring>; 6])>,
    /// The enabled subsystems, by ascending position.
    pub(super) masses: Vec<Mass<'a>>,
    /// Each enabled response.
    pub(super) readings: Vec<Readings<Reading>>,
}

/// A subsystem at a position.
#[derive(Debug, Clone)]
pub(super) struct Mass<'a> {
    pub(super) subsystem: &'a Subsystem,
    /// Index of its position.
    pub(super) place: usize,
    /// Loads along (y, z, theta), N and N m.
    pub(super) load: [Complex64; 3],
}

/// What is read for a response.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reading {
    /// A motion of the beam at a position, plus its twist times an arm, m.
    Beam(usize, BeamMotion, f64, Measure),
    /// An internal force just right of a position; at the right end just left of it.
    Force(usize, BeamMotion),
    /// What the support with this index puts on the ground along a motion of its point.
    Reaction(usize, BeamMotion),
    /// A motion of the mass with this index.
    Mass(usize, MassMotion, Measure),
    /// A spring of the mass with this index.
    Spring(usize, SpringName, SpringMeasure),
    /// `E_V`.
    Energy,
}

/// A response: the sum of some readings, none for what is always 0, over that of others.
#[derive(Debug, Clone)]
pub(super) struct Readings<T> {
    pub(super) sum: Vec<T>,
    pub(super) over: Option<Vec<T>>,
}

impl<T> Readings<T> {
    /// The same with other readings.
    pub(super) fn map<U>(&self, of: impl Fn(&T) -> U) -> Readings<U> {
        let all = |list: &Vec<T>| list.iter().map(&of).collect();
        Readings {
            sum: all(&self.sum),
            over: self.over.as_ref().map(all),
        }
    }

    /// The value, from those of the readings.
    pub(super) fn value(&self, of: impl Fn(&T) -> Complex64) -> Complex64 {
        let sum = |list: &Vec<T>| list.iter().map(&of).sum::<Complex64>();
        match &self.over {
            Some(over) => sum(&self.sum) / sum(over),
            None => sum(&self.sum),
        }
    }
}

impl<'a> Layout<'a> {
    /// Lays out a checked model; merges a position closer than `merge` (m) to its left neighbour with it.
    pub(super) fn new(model: &'a Model, merge: f64) -> Self {
        let parts = model.uniform_parts();
        let positions = positions(model, &parts, merge);
        let between = positions.windows(2).map(|ends| {
            let middle = 0.5 * (ends[0] + ends[1]);
            let here = parts.iter().find(|part| middle < part.end);
            *here.unwrap_or(&parts[parts.len() - 1])
        });
        let mut layout = Self {
            model,
            merge,
            parts: between.collect(),
            positions,
            loads: Vec::new(),
            supports: Vec::new(),
            joints: Vec::new(),
            masses: Vec::new(),
            readings: Vec::new(),
        };
        layout.loads = vec![[Complex64::ZERO; 6]; layout.positions.len()];
        let last = layout.positions.len() - 1;
        let ends = [(0, &model.supports.left), (last, &model.supports.right)];
        let inner = model.supports.inner.iter();
        let inner = inner.map(|inner| (layout.place(inner.position), &inner.support));
        let supports = ends.into_iter().chain(inner);
        layout.supports = supports
            .map(|(place, support)| (place, layout.holding(place, support)))
            .collect();
        let joints = model.joints.iter().map(|joint| {
            let place = layout.place(joint.position);
            // No bimoment passes where a part without warping stiffness begins or ends.
            let without_warping = layout.warping_around(place) != [true; 2];
            (place, joint.springs(without_warping))
        });
        layout.joints = joints.collect();
        layout.masses = model
            .attached()
            .map(|subsystem| Mass {
                subsystem,
                place: layout.place(subsystem.position),
                load: [Complex64::ZERO; 3],
            })
            .collect();
        layout.masses.sort_by_key(|mass| mass.place);
        layout.put_loads();
        layout.readings = model
            .responses
            .iter()
            .filter(|response| response.enabled)
            .map(|response| Readings {
                sum: layout.sum(response),
                over: response.divisor(model).map(|over| layout.sum(over)),
            })
            .collect();
        layout
    }

    fn put_loads(&mut self) {
        for force in self.model.forces.iter().filter(|force| force.enabled) {
            let value = Complex64::from_polar(force.amplitude, force.phase.to_radians());
            match &force.target {
                Target::Beam(place, motion) => {
                    let place = self.place(distance(self.model, *place));
                    self.loads[place][*motion as usize] += value;
                    let arm = force.point.arm(*motion).unwrap_or_default();
                    self.loads[place][BeamMotion::Psi as usize] += arm * value;
                }
                Target::Mass(name, motion) => {
                    if let Some(mass) = self.mass(name) {
                        self.masses[mass].load[*motion as usize] += value;
                    }
                }
            }
        }
    }

    fn sum(&self, response: &Response) -> Vec<Reading> {
        let reading = match &response.quantity {
            Quantity::Energy => Some(Reading::Energy),
            // A checked model has no enabled response on a disabled subsystem.
            Quantity::Motion(Target::Mass(name, motion), measure) => {
                let mass = self.mass(name);
                mass.map(|mass| Reading::Mass(mass, *motion, *measure))
            }
            Quantity::Motion(Target::Beam(place, motion), measure) => {
                self.moved(*place, *motion, response.point, *measure)
            }
            Quantity::InternalForce(place, motion) => {
                let place = self.place(distance(self.model, *place));
                Some(Reading::Force(place, *motion))
            }
            Quantity::Reaction(Reaction::Support(holder, motion)) => {
                let mut all = SupportId::all(self.model);
                let index = all.position(|id| id.name(self.model) == holder.name());
                index.map(|index| Reading::Reaction(index, *motion))
            }
            Quantity::Reaction(Reaction::Ground(across)) => {
                let all = 0..self.supports.len();
                return all
                    .map(|index| Reading::Reaction(index, (*across).into()))
                    .collect();
            }
            Quantity::Spring(name, spring, measure) => {
                let mass = self.mass(name);
                mass.map(|mass| Reading::Spring(mass, *spring, *measure))
            }
        };
        reading.into_iter().collect()
    }

    /// A motion of the beam; none that a support fixes.
    fn moved(
        &self,
        place: Place,
        motion: BeamMotion,
        point: Point,
        measure: Measure,
    ) -> Option<Reading> {
        let place = self.place(distance(self.model, place));
        let arm = point.arm(motion).unwrap_or_default();
        let is_held = self.supports_at(place).any(|support| {
            let own_arm = support.point.arm(motion).unwrap_or_default();
            support[motion] == Restraint::Fixed
                && (own_arm == arm || support[BeamMotion::Psi] == Restraint::Fixed)
        });
        (!is_held).then_some(Reading::Beam(place, motion, arm, measure))
    }

    /// The supports at a position.
    pub(super) fn supports_at(&self, place: usize) -> impl Iterator<Item = &Support> {
        let here = self.supports.iter().filter(move |(own, _)| *own == place);
        here.map(|(_, support)| support)
    }

    /// The support at a position, if it is an end.
    pub(super) fn end(&self, place: usize) -> Option<&'a Support> {
        match place {
            0 => Some(&self.model.supports.left),
            last if last + 1 == self.positions.len() => Some(&self.model.supports.right),
            _ => None,
        }
    }

    /// A support at a position. Without warping stiffness any spring or inertia fixes the rate of twist: over a length
    /// that vanishes with the warping constant, without energy.
    fn holding(&self, place: usize, support: &Support) -> Support {
        let mut support = support.clone();
        let rate = &mut support[BeamMotion::PsiSlope];
        if !self.warps(place) && rate.acts() {
            *rate = Restraint::Fixed;
        }
        support
    }

    /// Whether the part to which everything at a position belongs has warping stiffness: of the two next to it the one that
    /// has it.
    pub(super) fn warps(&self, place: usize) -> bool {
        let [left, right] = self.warping_around(place);
        left || right
    }

    /// Whether the parts left and right of a position have warping stiffness; outside of the beam none.
    pub(super) fn warping_around(&self, place: usize) -> [bool; 2] {
        let left = place.checked_sub(1).and_then(|left| self.parts.get(left));
        let around = [left, self.parts.get(place)];
        around.map(|part| part.is_some_and(UniformPart::warps))
    }

    /// Index of the position at a distance from the left end: the last one not beyond it, or the right end.
    fn place(&self, x: f64) -> usize {
        if self.model.length() - x <= self.merge {
            return self.positions.len() - 1;
        }
        self.positions
            .partition_point(|&position| position <= x)
            .saturating_sub(1)
    }

    fn mass(&self, name: &str) -> Option<usize> {
        self.masses
            .iter()
            .position(|mass| mass.subsystem.name == name)
    }
}

/// (i omega)^n for a displacement, velocity or acceleration.
pub(super) fn derivative(omega: f64, measure: Measure) -> Complex64 {
    let rate = Complex64::new(0.0, omega);
    match measure {
        Measure::Displacement => Complex64::ONE,
        Measure::Velocity => rate,
        Measure::Acceleration => rate * rate,
    }
}

fn distance(model: &Model, place: Place) -> f64 {
    place.position(model.length())
}

/// The distinct positions, ascending, ends included.
fn positions(model: &Model, parts: &[UniformPart], merge: f64) -> Vec<f64> {
    let beam_place = |at: At<'_>| match at {
        At::Beam(place) => Some(distance(model, place)),
        At::Subsystem(_) | At::Support(_) | At::Ground => None,
    };
    let forces = model.forces.iter().filter(|force| force.enabled);
    let mut all: Vec<f64> = model.attached().map(|s| s.position).collect();
    all.extend(model.supports.inner.iter().map(|inner| inner.position));
    all.extend(model.joints.iter().map(|joint| joint.position));
    all.extend(parts.iter().map(|part| part.end));
    all.extend(forces.filter_map(|force| beam_place(force.target.at())));
    all.extend(
        model
            .computed()
            .filter_map(|response| beam_place(response.quantity.at()?)),
    );
    all.sort_by(f64::total_cmp);
    let length = model.length();
    let mut places = vec![0.0];
    for x in all {
        // The last position is the right end itself.
        let last = places.last().copied().unwrap_or(0.0);
        if x - last > merge && length - x > merge {
            places.push(x);
        }
    }
    places.push(length);
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(name: &str) -> Model {
        crate::model::read(crate::presets::find(name).unwrap().text)
            .unwrap()
            .into_inner()
    }

    #[test]
    fn places_are_distinct_and_what_is_there_is_found() {
        // fig05b: subsystems at 0.8, 1.6, 2.4 m, the force at 1.2 m, responses at the ends, 1.2 and 2.0 m.
        let model = model("fig05b");
        let layout = Layout::new(&model, 0.0);
        assert_eq!(layout.positions, [0.0, 0.8, 1.2, 1.6, 2.0, 2.4, 3.2]);
        assert_eq!(layout.masses[1].place, 3);
        let loaded: Vec<usize> = (0..7)
            .filter(|&place| layout.loads[place] != [Complex64::ZERO; 6])
            .collect();
        assert_eq!(loaded, [2]);
    }

    #[test]
    fn places_nearer_than_asked_are_one() {
        let mut model = model("fig05b");
        model.subsystems[0].position = 1.2 - 1e-7;
        model.subsystems[2].position = 3.2 - 1e-7;
        assert_eq!(Layout::new(&model, 0.0).positions.len(), 7);
        let layout = Layout::new(&model, 1e-6);
        assert_eq!(layout.positions.len(), 5);
        assert_eq!(layout.masses[2].place, 4);
    }
}
