//! Natural frequencies, damped modes and mode shapes: every list is proven to be complete, or states its gaps.
//!
//! Undamped: `wittrick_williams` counts the modes below a frequency (Wittrick & Williams 1971), from
//! `dynamic_stiffness`, `series`, `station`, `rigid` and `matrix_inertia`, and `buckling` the same at frequency 0;
//! `undamped` compares this count with the sign
//! changes, each narrowed by a `bracket`, of the `characteristic` function, which comes from the reflections of the
//! frequency responses and shares nothing with the count. Damped: `damped` moves all roots of that function together by
//! the iteration in `aberth`, accepts those with a `proof`, and counts the missing ones by the `argument_principle`;
//! `regions` finds them. Close and equal modes, and all shapes: `eigenspace` integrates responses around a `group` of
//! them (chosen by `neighbours`), `pencil` separates them into `motion`s, and `orthogonal` makes these bi-orthogonal.
//! `shape` gives the shapes for display, with the integrals along the beam.

mod aberth;
mod argument_principle;
mod blocked;
mod bound;
mod bracket;
mod buckling;
mod characteristic;
mod damped;
mod dynamic_stiffness;
mod eigenspace;
mod group;
mod loads;
mod matrix_inertia;
mod motion;
mod neighbours;
mod orthogonal;
mod pencil;
mod proof;
mod regions;
mod rigid;
mod series;
mod shape;
mod station;
mod types;
mod undamped;
mod wittrick_williams;

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

pub use buckling::{buckling_factor, buckling_factors, buckling_load};
pub(super) use group::Group;
pub(super) use pencil::eigenvalues;
pub use shape::{shape, shapes, shares};
pub use types::{Completeness, Gap, Mode, ModeKind, Modes, Shape, Shares};

use super::Cancelled;
use crate::model::{Checked, Model, SpringId};

/// The number of undamped modes below a frequency (Hz, > 0), rigid-body modes included; `usize::MAX` if there are too
/// many to count.
///
/// Source: Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284.
pub fn count(model: &Checked, frequency: f64) -> usize {
    let omega = TAU * frequency;
    if bound::is_beyond(model, omega) {
        return usize::MAX;
    }
    wittrick_williams::Counter::new(model).below(omega)
}

/// All undamped natural frequencies up to `to` (Hz, > 0), in Hz, ascending, with their multiplicity; rigid-body modes
/// are 0. `None` if there are more than [`MOST_MODES`].
///
/// Dampers and the loss factor are left out. The list is complete by the count of Wittrick & Williams (1971).
///
/// # Errors
/// `cancel` became true before the end.
pub fn undamped(
    model: &Checked,
    to: f64,
    cancel: &AtomicBool,
) -> Result<Option<Vec<f64>>, Cancelled> {
    if bound::is_beyond(model, TAU * to) {
        return Ok(None);
    }
    let roots = undamped::Search::new(model, cancel).up_to(TAU * to)?;
    let in_hertz = |roots: Vec<f64>| roots.into_iter().map(|omega| omega / TAU).collect();
    Ok(roots.map(in_hertz))
}

/// The most modes of a list: no search for more begins.
pub const MOST_MODES: usize = 10_000;

/// Whether more than [`MOST_MODES`] modes are below a frequency (Hz, > 0), checked before the search.
pub fn are_too_many(model: &Checked, to: f64) -> bool {
    count(model, to) > MOST_MODES
}

/// All modes up to `to` (Hz, > 0), with damping; the list is empty if there are more than [`MOST_MODES`].
///
/// Sources: Wittrick & Williams (1971) for the undamped ones, Aberth (Math. Comp. 27 (1973) 339-344) and the argument
/// principle for the damped ones.
///
/// # Errors
/// `cancel` became true before the end.
pub fn modes(model: &Checked, to: f64, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    solved(model, to, Certificate::Wanted, cancel)
}

/// The same without the argument principle, for the many models of an optimisation, or if the count comes later (see
/// [`certify`]): the oscillating modes that continue the undamped ones. A mode may be missing, but never an oscillating
/// one, and the list is [`Completeness::Uncounted`] if there is damping.
///
/// # Errors
/// `cancel` became true before the end.
pub fn uncertified(model: &Checked, to: f64, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    let overdamped = &[];
    solved(model, to, Certificate::Unwanted { overdamped }, cancel)
}

/// Whether a list of damped modes must be proved complete.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Certificate<'a> {
    Wanted,
    /// Without a count; these are also tried, because the undamped modes lead to none of them.
    Unwanted {
        overdamped: &'a [Mode],
    },
}

fn solved(
    model: &Model,
    to: f64,
    certificate: Certificate<'_>,
    cancel: &AtomicBool,
) -> Result<Modes, Cancelled> {
    // Damping slows a mode: some from beyond the range may come into it.
    const BEYOND: f64 = 1.1;
    if bound::is_beyond(model, TAU * to * BEYOND) {
        return Ok(Modes::too_many(to));
    }
    let search = undamped::Search::new(model, cancel);
    let Some(undamped) = search.up_to(TAU * to * BEYOND)? else {
        return Ok(Modes::too_many(to));
    };
    let counter = search.counter;
    let oscillating = &undamped[counter.rigid().min(undamped.len())..];
    let found = if is_damped(model) {
        let search = damped::Search::new(model, counter.rigid(), TAU * to, cancel);
        match certificate {
            Certificate::Wanted => search.continue_undamped(oscillating, TAU * to)?,
            Certificate::Unwanted { overdamped } => search.uncertified(oscillating, overdamped)?,
        }
    } else {
        damped::Found::without_damping(oscillating)
    };
    Ok(collected(&counter, to, &found))
}

/// The same as [`uncertified`] up to `before.to`, faster if the model differs little from that of `before`, whose modes
/// it follows one by one. If one of them is lost, or another one enters the range, the search starts from the undamped
/// modes. [`certify`] detects missing modes in both cases.
///
/// # Errors
/// `cancel` became true before the end.
pub fn follow(model: &Checked, before: &Modes, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    if are_too_many(model, before.to) {
        return Ok(Modes::too_many(before.to));
    }
    let moving = moving(before);
    if is_damped(model) && !moving.is_empty() {
        let counter = wittrick_williams::Counter::new(model);
        let search = damped::Search::new(model, counter.rigid(), TAU * before.to, cancel);
        let followed = collected(&counter, before.to, &search.follow(&moving)?);
        if balance(&followed) == balance(before) {
            return Ok(followed);
        }
    }
    let mut overdamped = moving;
    overdamped.retain(|mode| mode.kind == ModeKind::Overdamped);
    let overdamped = &overdamped;
    solved(
        model,
        before.to,
        Certificate::Unwanted { overdamped },
        cancel,
    )
}

/// An invariant of a list of modes under small changes of its model: the number of roots in the whole plane (an
/// oscillating mode may become two overdamped ones), and the number of oscillating modes in the range minus that of
/// undamped ones.
fn balance(list: &Modes) -> (usize, i64) {
    let is_overdamped = |mode: &&Mode| mode.kind == ModeKind::Overdamped;
    let all = list.modes.iter().chain(&list.beyond);
    let roots = all.map(|mode| match mode.kind {
        ModeKind::RigidBody | ModeKind::Oscillating => 2,
        ModeKind::Overdamped => 1,
    });
    let overdamped = list.modes.iter().filter(is_overdamped).count();
    let oscillating = list.modes.len() - overdamped;
    (roots.sum(), oscillating as i64 - list.undamped as i64)
}

/// A list of [`uncertified`] or [`follow`] for this model, after counting its modes: missing ones are added, and each
/// mode is proven again. If none was missing, the modes are the same to the last digit. Another list stays unchanged.
///
/// # Errors
/// `cancel` became true before the end.
pub fn certify(model: &Checked, found: &Modes, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    match found.completeness {
        Completeness::Uncounted => {}
        Completeness::Certain | Completeness::Open(_) | Completeness::TooMany => {
            return Ok(found.clone());
        }
    }
    let counter = wittrick_williams::Counter::new(model);
    let search = damped::Search::new(model, counter.rigid(), TAU * found.to, cancel);
    let counted = search.certify(&moving(found), TAU * found.to)?;
    let counted = match counted.completeness {
        Completeness::Certain => collected(&counter, found.to, &counted),
        // From the undamped modes the result may be certain.
        Completeness::Open(_) | Completeness::Uncounted | Completeness::TooMany => {
            modes(model, found.to, cancel)?
        }
    };
    if !agree(found, &counted) {
        return Ok(counted);
    }
    Ok(Modes {
        completeness: counted.completeness,
        ..found.clone()
    })
}

/// Whether two lists have the same modes up to rounding.
fn agree(one: &Modes, other: &Modes) -> bool {
    /// Relative to the frequency: the lists have the same length, so two modes cannot be confused.
    const ROUNDING: f64 = 1e-9;
    let near = |(a, b): (&Mode, &Mode)| {
        a.kind == b.kind && (a.omega - b.omega).norm() <= ROUNDING * a.omega.norm()
    };
    let same =
        |one: &[Mode], other: &[Mode]| one.len() == other.len() && one.iter().zip(other).all(near);
    same(&one.modes, &other.modes) && same(&one.beyond, &other.beyond)
}

/// The modes of a list that are not at 0, including those beyond the range.
fn moving(list: &Modes) -> Vec<Mode> {
    let all = list.modes.iter().chain(&list.beyond);
    all.filter(|mode| mode.kind != ModeKind::RigidBody)
        .copied()
        .collect()
}

/// The rigid-body modes and the found ones, split at `to`, Hz.
fn collected(counter: &wittrick_williams::Counter, to: f64, found: &damped::Found) -> Modes {
    let still = Mode {
        omega: num_complex::Complex64::ZERO,
        kind: ModeKind::RigidBody,
    };
    let (inside, beyond): (Vec<Mode>, Vec<Mode>) =
        found.modes.iter().partition(|mode| mode.frequency() <= to);
    Modes {
        to,
        undamped: counter.below(TAU * to),
        unstable: counter.unstable(),
        modes: std::iter::repeat_n(still, counter.rigid())
            .chain(inside)
            .collect(),
        beyond,
        completeness: found.completeness.clone(),
    }
}

/// Whether the model has a loss factor: then no root is the mirror image of another.
fn is_hysteretic(model: &Model) -> bool {
    let parts = model.uniform_parts();
    let materials = parts.iter().map(|part| part.beam.material.loss_factor);
    let beddings = parts
        .iter()
        .flat_map(|part| part.beam.foundation.beddings());
    let springs = SpringId::acting(model);
    let mut losses = materials
        .chain(beddings.map(|of| of.stiffness * of.loss_factor))
        .chain(springs.map(|of| of.complex_stiffness().im));
    losses.any(|loss| loss != 0.0)
}

/// Whether anything in the model dissipates energy.
fn is_damped(model: &Model) -> bool {
    with_damping_times(model, 0.0) != *model
}

/// The model with every damper and loss factor at zero.
pub fn without_damping(model: &Checked) -> Checked {
    model.derived(|model| *model = with_damping_times(model, 0.0))
}

/// The model with every damper and loss factor times a fraction.
fn with_damping_times(model: &Model, share: f64) -> Model {
    let mut model = model.clone();
    let materials = model
        .spans
        .iter_mut()
        .filter_map(|span| span.material.as_mut());
    for material in materials.chain([&mut model.beam.material]) {
        material.loss_factor *= share;
    }
    let foundations = model
        .spans
        .iter_mut()
        .filter_map(|span| span.foundation.as_mut());
    for foundation in foundations.chain([&mut model.beam.foundation]) {
        for bedding in [&mut foundation.w, &mut foundation.psi, &mut foundation.v] {
            bedding.damping *= share;
            bedding.loss_factor *= share;
        }
    }
    for id in SpringId::all(&model) {
        if let Some(spring) = id.spring_mut(&mut model) {
            spring.damping *= share;
            spring.loss_factor *= share;
            for branch in &mut spring.maxwell {
                branch.damping *= share;
            }
        }
    }
    model
}

#[cfg(test)]
mod tests;
