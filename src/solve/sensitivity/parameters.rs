//! The numbers of a model that responses depend on, in the order of the model file.

use crate::model::schema::Kind;
use crate::model::{Group, Model, ParameterId, edit};

/// Numbers with the parameters that they are of.
#[derive(Debug, Default)]
pub(super) struct Parameters {
    pub(super) ids: Vec<ParameterId>,
    /// SI.
    pub(super) values: Vec<f64>,
}

impl Parameters {
    /// Those of the beam, of supports that are not fixed, and of the subsystems and forces that are enabled.
    pub(super) fn of(model: &Model) -> Self {
        let ids = ParameterId::all(model).into_iter();
        let numbers = ids
            .filter(|id| id.key().kind == Kind::Number && acts(model, id.group))
            .filter_map(|id| Some((id, edit::number(model, id).ok()?)));
        let (ids, values) = numbers.unzip();
        Self { ids, values }
    }
}

/// Whether responses depend on the numbers of a table.
fn acts(model: &Model, group: Group) -> bool {
    match group {
        Group::Beam | Group::Material | Group::Section | Group::Motion(..) => true,
        Group::Subsystem(index) => model.subsystems[index].enabled,
        Group::Force(index) => model.forces[index].enabled,
        _ => false,
    }
}
