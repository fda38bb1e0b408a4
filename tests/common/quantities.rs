//! Responses of every quantity that is no motion.

use beamtune::model::{
    Across, BeamMotion, Holder, Model, Place, Point, Quantity, Reaction, Response, SpringMeasure,
    SpringName,
};

/// A response of a quantity.
pub fn response(quantity: Quantity) -> Response {
    Response {
        name: format!("{quantity:?}"),
        enabled: true,
        quantity,
        point: Point::AXIS,
        over: None,
    }
}

/// The reactions of all supports along all motions, and on the ground.
pub fn reactions(model: &Model) -> Vec<Quantity> {
    let inner = model.supports.inner.iter();
    let inner = inner.map(|of| Holder::Inner(of.name.clone()));
    let holders: Vec<Holder> = [Holder::Left, Holder::Right]
        .into_iter()
        .chain(inner)
        .collect();
    let of = |holder: &Holder| {
        BeamMotion::ALL.map(|motion| Quantity::Reaction(Reaction::Support(holder.clone(), motion)))
    };
    let ground = Across::ALL.map(|across| Quantity::Reaction(Reaction::Ground(across)));
    holders.iter().flat_map(of).chain(ground).collect()
}

/// All six internal forces at some places.
pub fn internal_forces(places: &[Place]) -> Vec<Quantity> {
    let of = |place: &Place| BeamMotion::ALL.map(|motion| Quantity::InternalForce(*place, motion));
    places.iter().flat_map(of).collect()
}

/// The force and the stretch of all springs of the attached subsystems.
pub fn springs(model: &Model) -> Vec<Quantity> {
    let mut all = Vec::new();
    for subsystem in model.attached() {
        for measure in SpringMeasure::ALL {
            for spring in SpringName::ALL {
                all.push(Quantity::Spring(subsystem.name.clone(), spring, measure));
            }
        }
    }
    all
}
