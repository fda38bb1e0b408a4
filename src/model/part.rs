//! The parts of the beam that have numbers of their own: the whole beam and its spans.

use super::beam::{Foundation, Material, Section, Span};
use super::schema;
use super::types::Model;

/// A part of the beam that may have a material, a section and a foundation of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The whole beam, for what its spans have in common.
    Whole,
    /// A span, by its index.
    Span(usize),
}

impl Part {
    /// All parts of a model: the whole beam, then its spans.
    pub fn all(model: &Model) -> impl Iterator<Item = Self> + use<> {
        let spans = (0..model.spans.len()).map(Self::Span);
        std::iter::once(Self::Whole).chain(spans)
    }

    /// Its own material; none of a span that has the beam's, nor of a beam without one whose spans all have their own.
    pub fn material(self, model: &Model) -> Option<&Material> {
        self.table(model, &model.beam.material, |span| span.material.as_ref())
    }

    /// Its own section; none as for [`Self::material`].
    pub fn section(self, model: &Model) -> Option<&Section> {
        self.table(model, &model.beam.section, |span| span.section.as_ref())
    }

    /// Its own foundation; none as for [`Self::material`].
    pub fn foundation(self, model: &Model) -> Option<&Foundation> {
        self.table(model, &model.beam.foundation, |span| {
            span.foundation.as_ref()
        })
    }

    fn table<'a, T: Default + PartialEq>(
        self,
        model: &'a Model,
        of_beam: &'a T,
        own: fn(&Span) -> Option<&T>,
    ) -> Option<&'a T> {
        match self {
            Self::Whole => {
                let all_own = model.spans.iter().all(|span| own(span).is_some());
                let left_out = !model.spans.is_empty() && all_own && *of_beam == T::default();
                (!left_out).then_some(of_beam)
            }
            Self::Span(index) => model.spans.get(index).and_then(own),
        }
    }

    /// Its own material, mutable; a span that has the beam's gets a copy.
    pub fn material_mut(self, model: &mut Model) -> &mut Material {
        let of_beam = &mut model.beam.material;
        match self {
            Self::Whole => of_beam,
            Self::Span(index) => model.spans[index].material.get_or_insert(*of_beam),
        }
    }

    /// Its own section, mutable; a span that has the beam's gets a copy.
    pub fn section_mut(self, model: &mut Model) -> &mut Section {
        let of_beam = &mut model.beam.section;
        match self {
            Self::Whole => of_beam,
            Self::Span(index) => model.spans[index].section.get_or_insert(*of_beam),
        }
    }

    /// Its own foundation, mutable; a span that has the beam's gets a copy.
    pub fn foundation_mut(self, model: &mut Model) -> &mut Foundation {
        let of_beam = &mut model.beam.foundation;
        match self {
            Self::Whole => of_beam,
            Self::Span(index) => model.spans[index].foundation.get_or_insert(*of_beam),
        }
    }

    /// The same part with another index; the whole beam stays.
    pub(super) const fn at(self, place: usize) -> Self {
        match self {
            Self::Whole => Self::Whole,
            Self::Span(_) => Self::Span(place),
        }
    }
}

/// A number of the beam, of one of its spans or of a table of either, by its key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BeamNumber {
    Beam(schema::BeamKey),
    Span(usize, schema::SpanKey),
    Material(Part, schema::MaterialKey),
    Section(Part, schema::SectionKey),
    Foundation(Part, schema::FoundationKey),
}

impl BeamNumber {
    /// The indices of the uniform parts of a model that it describes.
    pub(crate) fn parts(self, model: &Model) -> impl Iterator<Item = usize> + Clone {
        let (of, has_own): (Part, fn(&Span) -> bool) = match self {
            Self::Beam(schema::BeamKey::AxialForce) => {
                (Part::Whole, |span| span.axial_force.is_some())
            }
            Self::Beam(_) => (Part::Whole, |_| false),
            Self::Span(index, _) => (Part::Span(index), |_| false),
            Self::Material(of, _) => (of, |span| span.material.is_some()),
            Self::Section(of, _) => (of, |span| span.section.is_some()),
            Self::Foundation(of, _) => (of, |span| span.foundation.is_some()),
        };
        let describes = move |part: &usize| match of {
            Part::Whole => model.spans.get(*part).is_none_or(|span| !has_own(span)),
            Part::Span(index) => *part == index,
        };
        (0..model.spans.len().max(1)).filter(describes)
    }
}
