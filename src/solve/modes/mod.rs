//! Natural frequencies, damped modes and mode shapes: every list is proven to be complete, or says where it is not.
//!
//! Undamped: `count` says how many modes lie below a frequency (Wittrick & Williams 1971), from `span`, `series`,
//! `station`, `rigid` and `inertia`; `undamped` compares it with the changes of sign, each narrowed by a `bracket`, of the
//! `characteristic` function, which comes from the reflections of the frequency responses and shares nothing with the
//! count. Damped: `damped` moves all roots of that function together, each a `tracker`, takes those for which `proof`
//! holds, and counts by the argument principle along a `contour` what is missing; `regions` finds it. Close and equal
//! modes, and all shapes: `eigenspace` integrates responses around a `group` of them (`neighbours` says which), `pencil`
//! separates them into `motion`s, and `orthogonal` makes these bi-orthogonal. `shape` is what people see, with the
//! integrals along the beam.

mod aberth;
mod argument_principle;
mod blocked;
mod bound;
mod bracket;
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

pub(super) use group::Group;
pub(super) use pencil::eigenvalues;
pub use shape::{shape, shapes, shares};
pub use types::{Completeness, Gap, Mode, ModeKind, Modes, Shape, Shares};

use super::Cancelled;
use crate::model::{Model, Restraint};

/// How many undamped modes lie below a frequency (Hz, > 0), rigid-body modes included; `usize::MAX` where that is beyond
/// all counting.
///
/// Source: Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284.
pub fn count(model: &Model, frequency: f64) -> usize {
    let omega = TAU * frequency;
    if bound::is_beyond(model, omega) {
        return usize::MAX;
    }
    wittrick_williams::Counter::new(model).below(omega)
}

/// All undamped natural frequencies up to `to` (Hz, > 0), in Hz, rising, as often as they occur; rigid-body modes are
/// 0. None where there are more than [`MOST_MODES`].
///
/// Dampers and the loss factor are left out. The list is complete by the count of Wittrick & Williams (1971).
///
/// # Errors
/// `cancel` became true before the end.
pub fn undamped(
    model: &Model,
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

/// The most modes that are listed: no search for more begins.
pub const MOST_MODES: usize = 10_000;

/// Whether more than [`MOST_MODES`] modes lie below a frequency (Hz, > 0), known before any of them is looked for.
pub fn are_too_many(model: &Model, to: f64) -> bool {
    count(model, to) > MOST_MODES
}

/// All modes up to `to` (Hz, > 0), with damping; none is listed where there are more than [`MOST_MODES`].
///
/// Sources: Wittrick & Williams (1971) for the undamped ones, Aberth (Math. Comp. 27 (1973) 339-344) and the argument
/// principle for the damped ones.
///
/// # Errors
/// `cancel` became true before the end.
pub fn modes(model: &Model, to: f64, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    solved(model, to, Certificate::Wanted, cancel)
}

/// The same without the argument principle, for one of many models of a search, or where the count comes later (see
/// [`certify`]): the oscillating modes that the undamped ones become. What may be missing is never oscillating, and the
/// list is [`Completeness::Uncounted`] where there is damping.
///
/// # Errors
/// `cancel` became true before the end.
pub fn uncertified(model: &Model, to: f64, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
    let overdamped = &[];
    solved(model, to, Certificate::Unwanted { overdamped }, cancel)
}

/// Whether a list of damped modes is to be proved complete.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Certificate<'a> {
    Wanted,
    /// Without a count; these are tried too, as the undamped modes lead to none of them.
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

/// The same as [`uncertified`] up to `before.to`, faster where the model differs little from that of `before`, whose modes
/// are followed one by one. Where one of them is lost on the way, or one enters the range that is not among them, the
/// search starts from the undamped modes. [`certify`] notices what is missing all the same.
///
/// # Errors
/// `cancel` became true before the end.
pub fn follow(model: &Model, before: &Modes, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
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

/// What a list of modes keeps while its model is changed little: how many roots it has in the whole plane (an oscillating
/// mode may become two overdamped ones), and how many more oscillating modes lie in the range than undamped ones.
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

/// A list of [`uncertified`] or [`follow`] for this model, with the count of its modes: what was missing is added, and each
/// mode is proven again. Where none was missing the modes are the same to the last digit. Another list stays as it is.
///
/// # Errors
/// `cancel` became true before the end.
pub fn certify(model: &Model, found: &Modes, cancel: &AtomicBool) -> Result<Modes, Cancelled> {
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
        // From the undamped modes it may come out certain.
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

/// Whether two lists have the same modes, but for rounding.
fn agree(one: &Modes, other: &Modes) -> bool {
    /// Of the frequency: no two modes of a list are taken for one, as their number is the same.
    const ROUNDING: f64 = 1e-9;
    let near = |(a, b): (&Mode, &Mode)| {
        a.kind == b.kind && (a.omega - b.omega).norm() <= ROUNDING * a.omega.norm()
    };
    let same =
        |one: &[Mode], other: &[Mode]| one.len() == other.len() && one.iter().zip(other).all(near);
    same(&one.modes, &other.modes) && same(&one.beyond, &other.beyond)
}

/// The modes of a list that are not at 0, those beyond the range among them.
fn moving(list: &Modes) -> Vec<Mode> {
    let all = list.modes.iter().chain(&list.beyond);
    all.filter(|mode| mode.kind != ModeKind::RigidBody)
        .copied()
        .collect()
}

/// The rigid-body modes and those found, parted at `to`, Hz.
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
        modes: std::iter::repeat_n(still, counter.rigid())
            .chain(inside)
            .collect(),
        beyond,
        completeness: found.completeness.clone(),
    }
}

/// Whether the model has a loss factor: no root is then the mirror image of another.
fn is_hysteretic(model: &Model) -> bool {
    model.beam.material.loss_factor != 0.0
}

/// Whether anything in the model takes energy away.
fn is_damped(model: &Model) -> bool {
    without_damping(model) != *model
}

/// The model with every damper and the loss factor at zero.
pub fn without_damping(model: &Model) -> Model {
    with_damping_times(model, 0.0)
}

/// The model with every damper and the loss factor times a share.
fn with_damping_times(model: &Model, share: f64) -> Model {
    let mut model = model.clone();
    model.beam.material.loss_factor *= share;
    for end in [&mut model.supports.left, &mut model.supports.right] {
        for restraint in &mut end.0 {
            if let Restraint::Elastic(elastic) = restraint {
                elastic.damping *= share;
            }
        }
    }
    for subsystem in &mut model.subsystems {
        for spring in [
            &mut subsystem.y_left,
            &mut subsystem.y_right,
            &mut subsystem.z_left,
            &mut subsystem.z_right,
        ] {
            spring.damping *= share;
        }
    }
    model
}

#[cfg(test)]
mod tests;
