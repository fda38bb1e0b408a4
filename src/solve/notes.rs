//! Notes on a possible model: what is unusual and may be a mistake, but no fault.

use super::validity::{CHANGE, euler_bernoulli_up_to};
use crate::model::schema::{ResponseKey, SectionKey, SweepKey};
use crate::model::{
    BeamMotion, BeamNumber, Checked, Group, Model, ParameterId, Part, Quantity, Reaction, Response,
    Restraint, Section, SpringMeasure, SupportId, Target, UniformPart,
};

/// A note on a number of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// The number.
    pub id: ParameterId,
    /// What there is to know about it.
    pub message: String,
}

/// The notes on a model.
pub fn notes(model: &Checked) -> Vec<Note> {
    let sections = sections(model).into_iter();
    let polar_moments = sections.filter_map(|(section, group)| polar_moment(section, group));
    polar_moments
        .chain(sweep(model))
        .chain(always_zero(model))
        .collect()
}

/// Responses that are 0 at every frequency.
fn always_zero(model: &Checked) -> impl Iterator<Item = Note> {
    let enabled = model.responses.iter().enumerate();
    let enabled = enabled.filter(|(_, of)| of.enabled);
    enabled.filter_map(|(index, response)| {
        Some(Note {
            id: Group::Response(index).parameter(ResponseKey::Direction as usize),
            message: format!("is zero at every frequency: {}", why_zero(model, response)?),
        })
    })
}

/// Why a response is 0 at every frequency, if it is.
fn why_zero(model: &Model, response: &Response) -> Option<String> {
    let supports = || SupportId::all(model);
    let warps_at = |x: f64| UniformPart::at(&model.uniform_parts(), x).warps();
    let pulls = |id: SupportId, motion: BeamMotion| match &id.support(model)[motion] {
        Restraint::Fixed => true,
        Restraint::Free => false,
        Restraint::Elastic(elastic) => elastic.spring.acts(),
    };
    match &response.quantity {
        Quantity::Motion(Target::Beam(place, motion), _) => {
            let x = place.position(model.length());
            let fixes = |id: &SupportId| {
                let support = id.support(model);
                id.position(model) == x
                    && support[*motion] == Restraint::Fixed
                    && support.point.arm(*motion) == response.point.arm(*motion)
            };
            let id = supports().find(fixes)?;
            Some(format!(
                "the support {} fixes {}",
                id.name(model),
                motion.key()
            ))
        }
        Quantity::Reaction(Reaction::Support(holder, motion)) => {
            let id = supports().find(|id| id.name(model) == holder.name())?;
            let name = id.name(model);
            if !pulls(id, *motion) {
                let word = motion.key();
                Some(format!(
                    "the support {name} has neither a spring nor a damper along {word}"
                ))
            } else if *motion == BeamMotion::PsiSlope && !warps_at(id.position(model)) {
                Some("without a warping constant no bimoment reaches a support".to_owned())
            } else {
                None
            }
        }
        Quantity::Reaction(Reaction::Ground(across)) => {
            let holds = supports().any(|id| pulls(id, (*across).into()));
            let word = across.key();
            (!holds).then(|| format!("no support has a spring or a damper along {word}"))
        }
        Quantity::InternalForce(place, BeamMotion::PsiSlope) => {
            let carries = warps_at(place.position(model.length()));
            (!carries).then(|| "without a warping constant there is no bimoment".to_owned())
        }
        Quantity::Spring(name, spring, SpringMeasure::Force) => {
            let subsystem = model.subsystems.iter().find(|one| one.name == *name)?;
            let is_none = !spring.of(subsystem).acts();
            is_none.then(|| format!("{name} has no {}", spring.key()))
        }
        Quantity::Motion(Target::Mass(..), _)
        | Quantity::InternalForce(..)
        | Quantity::Spring(_, _, SpringMeasure::Stretch)
        | Quantity::Energy => None,
    }
}

/// The tables of sections that some part of the beam has, each with its group.
fn sections(model: &Model) -> Vec<(&Section, Group)> {
    let is_used = |part: &Part| {
        let number = BeamNumber::Section(*part, SectionKey::PolarMoment);
        number.parts(model).next().is_some()
    };
    let parts = Part::all(model).filter(is_used);
    let sections = parts.filter_map(|part| Some((part.section(model)?, Group::Section(part))));
    sections.collect()
}

/// A polar moment that no homogeneous section with these areas has.
fn polar_moment(section: &Section, group: Group) -> Option<Note> {
    /// Tables round, and thin-walled formulas leave out the corners.
    const USUAL: f64 = 0.05;
    let (of_centroid, _) = section.least_polar_moment();
    let own = section.second_moment_y + section.second_moment_z + of_centroid;
    let excess = section.polar_moment / own - 1.0;
    (excess.abs() > USUAL).then(|| Note {
        id: group.parameter(SectionKey::PolarMoment as usize),
        message: format!(
            "I_y + I_z + A (y_c^2 + z_c^2) is {own:.4e} m4, as I_0 of a homogeneous section; this one is {:+.0} % off",
            100.0 * excess
        ),
    })
}

/// A sweep beyond the theory of bending.
fn sweep(model: &Checked) -> Option<Note> {
    let limit = euler_bernoulli_up_to(model)?;
    if model.sweep.to <= limit {
        return None;
    }
    Some(Note {
        id: Group::Sweep.parameter(SweepKey::To as usize),
        message: format!(
            "above {limit:.0} Hz shear and rotary inertia change the bending wave number by more than {:.0} %; the theory \"timoshenko\" has both",
            100.0 * CHANGE
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{self, Model, checked, path};

    fn preset(name: &str) -> Model {
        model::read(crate::presets::find(name).unwrap().text)
            .unwrap()
            .into_inner()
    }

    #[test]
    fn the_papers_polar_moment_is_noted() {
        // Closed form: 1.6625e-4 + 1.3745e-4 + 0.0116 * 0.0619^2 = 3.4815e-4 m4, and 5.9992e-4 is 72 % more.
        let notes = notes(&checked(&preset("fig05a")));
        assert_eq!(notes.len(), 1, "{notes:?}");
        assert!(notes[0].message.contains("3.4815e-4 m4") && notes[0].message.contains("+72 %"));
    }

    #[test]
    fn a_section_that_no_span_has_is_not_noted() {
        let mut model = preset("fig05a");
        let own = model.beam.section;
        let section = Some(model::Section {
            polar_moment: 3.4815e-4,
            ..own
        });
        let span = |section| model::Span {
            length: 1.6,
            section,
            ..model::Span::default()
        };
        model.spans = vec![span(section), span(None)];
        assert_eq!(notes(&checked(&model)).len(), 1);
        model.spans[1].section = section;
        assert_eq!(notes(&checked(&model)), []);
    }

    #[test]
    fn a_response_that_is_always_zero_is_noted_with_the_reason() {
        let mut model = preset("cantilever");
        let quantities = [
            Quantity::Reaction(Reaction::Support(crate::model::Holder::Left, BeamMotion::W)),
            Quantity::Reaction(Reaction::Support(
                crate::model::Holder::Right,
                BeamMotion::W,
            )),
            Quantity::Motion(
                Target::Beam(crate::model::Place::Left, BeamMotion::W),
                crate::model::Measure::Velocity,
            ),
        ];
        let pattern = model.responses[0].clone();
        let responses = quantities.into_iter().enumerate();
        let responses = responses.map(|(index, quantity)| Response {
            name: index.to_string(),
            quantity,
            ..pattern.clone()
        });
        model.responses = responses.collect();
        let mut found = notes(&checked(&model));
        found.retain(|note| matches!(note.id.group, Group::Response(_)));
        let texts: Vec<_> = found
            .iter()
            .map(|note| path::text(&model, note.id))
            .collect();
        assert_eq!(
            texts,
            ["responses.\"1\".direction", "responses.\"2\".direction"]
        );
        assert!(
            found[0]
                .message
                .contains("right has neither a spring nor a damper along w")
        );
        assert!(found[1].message.contains("the support left fixes w"));
    }

    #[test]
    fn a_sweep_beyond_the_theory_is_noted_and_another_theory_is_not() {
        let mut model = preset("purlin");
        assert_eq!(notes(&checked(&model)), []);
        model.sweep.to = 2e4;
        let found = notes(&checked(&model));
        assert_eq!(path::text(&model, found[0].id), "sweep.to");
        model.beam.theory = crate::model::Theory::Rayleigh;
        assert_eq!(notes(&checked(&model)), []);
    }
}
