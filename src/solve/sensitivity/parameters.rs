//! The numbers of a model that responses depend on, in the order of the model file.

use crate::model::field::{BEAM, FORCE, Field, MATERIAL, SECTION, SUBSYSTEM, elastic_fields};
use crate::model::{BeamMotion, Model, Restraint, path};

/// Numbers with their paths.
#[derive(Debug, Default)]
pub(super) struct Parameters {
    pub(super) paths: Vec<String>,
    /// SI.
    pub(super) values: Vec<f64>,
}

impl Parameters {
    /// Those of the beam, of supports that are not fixed, and of the subsystems and forces that are enabled.
    pub(super) fn of(model: &Model) -> Self {
        let mut all = Self::default();
        all.add("beam", BEAM, &model.beam);
        all.add("beam.material", MATERIAL, &model.beam.material);
        all.add("beam.section", SECTION, &model.beam.section);
        let supports = &model.supports;
        for (end, support) in [("left", &supports.left), ("right", &supports.right)] {
            for motion in BeamMotion::ALL {
                if support[motion] != Restraint::Fixed {
                    let owner = format!("supports.{end}.{}", motion.key());
                    all.add(&owner, elastic_fields(motion), &support[motion].elastic());
                }
            }
        }
        // No subsystem, no match; nothing else can fail.
        let keys = path::expand(model, "subsystems.*.name").unwrap_or_default();
        for (subsystem, key) in model.subsystems.iter().zip(&keys) {
            if subsystem.enabled {
                let owner = key.strip_suffix(".name").unwrap_or(key);
                all.add(owner, SUBSYSTEM, subsystem);
            }
        }
        for (index, force) in model.forces.iter().enumerate() {
            if force.enabled {
                all.add(&format!("forces.{}", index + 1), FORCE, force);
            }
        }
        all
    }

    fn add<T>(&mut self, owner: &str, fields: &[Field<T>], of: &T) {
        for field in fields {
            self.paths.push(format!("{owner}.{}", field.key));
            self.values.push((field.get)(of));
        }
    }
}
