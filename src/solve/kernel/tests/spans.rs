//! Beams of several spans against uniform ones, and random spans.

use super::{assert_near, characteristic, complex_frequencies, lanes, random_model, some};
use crate::model::{
    BeamMotion, Bedding, Foundation, Link, Material, Model, Place, Point, Quantity, Restraint,
    Section, Span, SupportId, Target, UniformPart,
};
use crate::solve::kernel::Instructions;
use crate::solve::plan::Plan;

/// Frequencies, Hz.
const ALL: [f64; 4] = [7.0, 31.0, 140.0, 900.0];

/// The slopes, and the rate of twist.
const SLOPES: [BeamMotion; 3] = [BeamMotion::WSlope, BeamMotion::PsiSlope, BeamMotion::VSlope];

/// The same beam in spans that end at some positions, m.
fn cut(model: &mut Model, ends: &mut Vec<f64>) {
    ends.push(model.beam.length);
    ends.sort_by(f64::total_cmp);
    let mut start = 0.0;
    for end in ends {
        model.spans.push(Span {
            length: *end - start,
            ..Span::default()
        });
        start = *end;
    }
    model.beam.length = 0.0;
}

fn assert_same(model: &Model, expected: &Model, within: f64) {
    for instructions in Instructions::available() {
        let [found, expected] = [model, expected].map(|model| {
            let plan = Plan::new(model);
            (lanes(instructions, &plan, &ALL), plan.outputs.len())
        });
        assert_near(&found.0, &expected.0, found.1, [within, within, 1e-12]);
    }
}

/// Closed form: a beam that is cut into equal spans is the same beam.
#[test]
fn a_beam_in_equal_spans_is_the_same_beam() {
    let mut random = fastrand::Rng::with_seed(21);
    for _ in 0..60 {
        let expected = random_model(&mut random);
        let mut model = expected.clone();
        let length = expected.beam.length;
        let mut ends: Vec<f64> = (0..random.usize(1..4))
            .map(|_| length * random.f64())
            .collect();
        ends.extend(model.subsystems.first().map(|of| of.position));
        cut(&mut model, &mut ends);
        // Each span has its own numbers, although they are equal.
        let whole = expected.beam;
        for span in &mut model.spans {
            span.section = Some(whole.section);
            span.material = random.bool().then_some(whole.material);
        }
        assert_same(&model, &expected, 1e-9);
    }
}

/// Closed form: the same beam about another axis. Its points, and the mounts along z, move with it; rotations about y and z
/// would not be the same motions of the section, so that nothing drives or reads them and springs act on none.
#[test]
fn another_axis_changes_no_response() {
    let mut random = fastrand::Rng::with_seed(22);
    let mut compared = 0;
    while compared < 60 {
        let mut expected = random_model(&mut random);
        let is_slope = |target: &Target| {
            matches!(
                target,
                Target::Beam(_, BeamMotion::WSlope | BeamMotion::VSlope)
            )
        };
        expected.forces.retain(|force| !is_slope(&force.target));
        expected
            .responses
            .retain(|response| !response.quantity.target().is_some_and(is_slope));
        expected.beam.foundation.w = Bedding::default();
        expected.beam.foundation.v = Bedding::default();
        for id in SupportId::all(&expected) {
            let support = id.support_mut(&mut expected);
            let slopes = if random.bool() {
                Restraint::Free
            } else {
                Restraint::Fixed
            };
            for motion in SLOPES {
                support[motion] = slopes.clone();
            }
        }
        for joint in &mut expected.joints {
            for motion in [
                BeamMotion::W,
                BeamMotion::Psi,
                BeamMotion::V,
                BeamMotion::PsiSlope,
            ] {
                joint[motion] = Link::Rigid;
            }
        }
        if expected.beam.section.warping_constant == 0.0 {
            continue;
        }
        compared += 1;
        let y = if expected.subsystems.is_empty() {
            some(&mut random, -0.3, 0.3)
        } else {
            0.0
        };
        let offset = Point {
            y,
            z: some(&mut random, -0.3, 0.3),
        };
        let moved = |point: &mut Point| {
            point.y += offset.y;
            point.z += offset.z;
        };
        let mut model = expected.clone();
        for id in SupportId::all(&model) {
            moved(&mut id.support_mut(&mut model).point);
        }
        for (target, point) in model
            .forces
            .iter_mut()
            .map(|of| (&of.target, &mut of.point))
        {
            if target.has_point() {
                moved(point);
            }
        }
        for response in &mut model.responses {
            if matches!(&response.quantity, Quantity::Motion(target, _) if target.has_point()) {
                moved(&mut response.point);
            }
        }
        for subsystem in &mut model.subsystems {
            subsystem.mount_z += offset.z;
        }
        let half = 0.4 * model.beam.length;
        cut(&mut model, &mut vec![half]);
        for span in &mut model.spans {
            span.offset = offset;
        }
        assert_same(&model, &expected, 1e-9);
    }
}

/// Expected: a warping constant so small that its boundary layers are short; the difference is in proportion to their
/// thickness.
#[test]
fn spans_without_warping_stiffness_are_the_limit_of_those_with_little() {
    let mut random = fastrand::Rng::with_seed(23);
    for _ in 0..60 {
        let mut expected = random_model(&mut random);
        expected.supports.inner.clear();
        expected.joints.clear();
        // The rate of twist in the layers is another one than outside.
        let is_rate = |target: &Target| matches!(target, Target::Beam(_, BeamMotion::PsiSlope));
        expected.forces.retain(|force| !is_rate(&force.target));
        expected.responses.retain(
            |response| !matches!(&response.quantity, Quantity::Motion(target, _) if is_rate(target)),
        );
        let length = expected.beam.length;
        let mut ends = vec![0.3 * length, 0.55 * length];
        cut(&mut expected, &mut ends);
        let mut model = expected.clone();
        for index in 0..model.spans.len() {
            let mut section = expected.beam.section;
            section.torsion_constant *= some(&mut random, 0.5, 2.0);
            section.warping_constant = 1e-8;
            if random.bool() {
                section.warping_constant = 0.0;
            }
            model.spans[index].section = Some(section);
            if section.warping_constant == 0.0 {
                section.warping_constant = 1e-24;
            }
            expected.spans[index].section = Some(section);
        }
        assert_same(&model, &expected, 1e-5);
    }
}

/// Closed form: a beam that is cut into equal spans has the same characteristic function, up to a constant factor.
#[test]
fn equal_spans_have_the_same_characteristic_function() {
    let mut random = fastrand::Rng::with_seed(24);
    let omegas = complex_frequencies();
    for _ in 0..40 {
        let mut expected = random_model(&mut random);
        expected.forces.clear();
        expected.responses.clear();
        let mut model = expected.clone();
        let length = expected.beam.length;
        cut(&mut model, &mut vec![0.2 * length, 0.6 * length]);
        for instructions in Instructions::available() {
            let [found, expected] =
                [&model, &expected].map(|model| characteristic(instructions, model, &omegas));
            for (found_here, expected_here) in found.iter().zip(&expected) {
                let relative = found_here.over(&found[0]);
                let error = (relative.ratio(&expected_here.over(&expected[0])) - 1.0).norm();
                assert!(error < 1e-9, "{error:e}");
            }
        }
    }
}

/// Divides a beam into two or three spans with numbers of their own, and moves some of what it has to where they meet.
pub(super) fn divide(model: &mut Model, random: &mut fastrand::Rng) {
    let length = model.beam.length;
    let mut ends: Vec<f64> = (0..random.usize(1..3))
        .map(|_| length * some(random, 0.1, 0.9))
        .collect();
    cut(model, &mut ends);
    let beam = model.beam;
    for span in &mut model.spans {
        let section = random.bool().then(|| random_section(&beam.section, random));
        span.section = section;
        if section.unwrap_or(beam.section).warping_constant != 0.0 {
            span.offset = random_offset(random);
        }
        span.material = random.bool().then(|| Material {
            young_modulus: beam.material.young_modulus * some(random, 0.3, 2.0),
            density: beam.material.density * some(random, 0.5, 2.0),
            loss_factor: [0.0, 0.02, 0.3][random.usize(0..3)],
            ..beam.material
        });
        span.axial_force = [None, Some(0.0), Some(1e6), Some(-1e5)][random.usize(0..4)];
        span.foundation = random.bool().then(|| {
            let mut foundation = Foundation::default();
            foundation.w.stiffness = [0.0, 1e6][random.usize(0..2)];
            foundation.psi.stiffness = [0.0, 1e4][random.usize(0..2)];
            foundation.v.damping = [0.0, 1e3][random.usize(0..2)];
            foundation
        });
    }
    let parts = model.uniform_parts();
    let meet = parts[0].end;
    let is_moved = |random: &mut fastrand::Rng| random.usize(0..3) == 0;
    // Each position has one joint at most.
    for position in [
        model.subsystems.first_mut().map(|of| &mut of.position),
        model.supports.inner.first_mut().map(|of| &mut of.position),
        model.joints.first_mut().map(|of| &mut of.position),
    ] {
        if let Some(position) = position.filter(|_| is_moved(random)) {
            *position = meet;
        }
    }
    let forces = model.forces.iter_mut().map(|force| &mut force.target);
    let responses = model.responses.iter_mut();
    let read = responses.filter_map(|response| match &mut response.quantity {
        Quantity::Motion(target, _) => Some(target),
        _ => None,
    });
    for target in forces.chain(read) {
        match target {
            Target::Beam(place, _) if is_moved(random) => *place = Place::Position(meet),
            Target::Beam(..) | Target::Mass(..) => {}
        }
    }
    // A section without warping stiffness carries no bimoment.
    let length = model.length();
    let carries = |place: Place| {
        let x = place.position(length);
        let here = |part: &&UniformPart| (part.start..=part.end).contains(&x);
        parts.iter().filter(here).any(UniformPart::warps)
    };
    model.forces.retain(|force| match force.target {
        Target::Beam(place, BeamMotion::PsiSlope) => carries(place),
        Target::Beam(..) | Target::Mass(..) => true,
    });
}

fn random_offset(random: &mut fastrand::Rng) -> Point {
    Point {
        y: [0.0, some(random, -0.15, 0.15)][random.usize(0..2)],
        z: [0.0, some(random, -0.15, 0.15)][random.usize(0..2)],
    }
}

/// A section like another one; some have no warping stiffness.
fn random_section(like: &Section, random: &mut fastrand::Rng) -> Section {
    let mut section = *like;
    section.area *= some(random, 0.5, 2.0);
    section.second_moment_y *= some(random, 0.3, 3.0);
    section.second_moment_z *= some(random, 0.3, 3.0);
    section.product_moment = some(random, -0.5, 0.5) * section.most_product_moment();
    section.product_moment *= [0.0, 1.0][random.usize(0..2)];
    section.torsion_constant *= some(random, 0.3, 3.0);
    section.warping_constant *= [0.0, 1.0, 3.0][random.usize(0..3)];
    section.centroid_offset = [0.0, some(random, -0.1, 0.1)][random.usize(0..2)];
    section.centroid_offset_y = [0.0, some(random, -0.1, 0.1)][random.usize(0..2)];
    let bending = section.second_moment_y + section.second_moment_z;
    section.polar_moment = section.least_polar_moment().0 + bending * some(random, 0.7, 1.5);
    section
}
