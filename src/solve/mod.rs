//! Exact frequency responses of a checked model: pure numerics, without input or output.
//!
//! [`sweep()`] is the entry point. Inside, `beam_matrices` has every theory, section and foundation as symmetric
//! matrices, `plan` lays a model out along x, `attachment` is a subsystem as the beam sees it, `output` says what is read
//! for a response, `kernel` solves a plan, low frequencies with the error-free sums and products of `error_free`;
//! `solution` is its result for a whole model, `limit` finds the value at a resonance that no load excites,
//! `sweep_cache` reuses what one edit leaves unchanged. `validity` says where a theory ends, `notes` what is unusual in
//! a model.
//!
//! Method: the waves of Chen & Liu, Mathematics 2022, 10(16), 2849, in a recursion of reflections instead of the
//! paper's product of 12x12 transfer matrices, which loses all digits above a few hundred hertz. No matrix is larger
//! than 6x6.
//!
//! [`modes`] finds the natural frequencies and damped modes; [`peaks`] refines the frequency grid at peaks and
//! anti-resonances and lists the peaks; [`band`] computes levels in a band. [`operating()`](operating::operating) gives
//! the state of the whole beam at one frequency: motions, internal forces, power. [`sensitivity`] has the exact
//! derivatives of the responses, modes and peaks by every parameter.
//!
//! Two reference methods share none of its formulas: [`fem`], finite elements, and [`transfer_matrix`], the product of
//! matrices of the paper. `layout` lays a model out for both, [`compare`] computes their differences from the exact
//! responses.
//!
//! # Example
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//! use beamtune::{model, presets, solve};
//!
//! let cancel = AtomicBool::new(false);
//! let text = presets::find("cantilever").expect("an embedded preset").text;
//! let beam = model::read(text).expect("a possible model");
//! let frf = solve::sweep(&beam, &[25.0, 35.0], &cancel).expect("nothing cancels it");
//! let tip = &frf.columns[0];
//! assert_eq!(tip.name, "tip w");
//! // Complex values, zero to peak, one per frequency; a mode lies at 36.8 Hz.
//! assert!(tip.values[1].norm() > tip.values[0].norm());
//!
//! let found = solve::modes::modes(&beam, 60.0, &cancel).expect("nothing cancels it");
//! for mode in &found.modes {
//!     println!("{:8.3} Hz  {:.2e}", mode.frequency(), mode.damping_ratio());
//! }
//! assert_eq!(found.completeness, solve::modes::Completeness::Certain);
//! ```

mod attachment;
pub mod band;
mod beam_matrices;
mod beam_state;
mod cancelled;
pub mod compare;
mod error_free;
pub(crate) mod extrema;
pub mod fem;
mod kernel;
mod layout;
mod limit;
mod linear;
pub mod modes;
mod notes;
pub mod operating;
mod output;
pub mod peaks;
mod plan;
mod quadrature;
mod reference;
pub mod sensitivity;
mod solution;
mod springs;
mod sweep;
mod sweep_cache;
pub mod transfer_matrix;
mod validity;
mod waves;

pub use cancelled::Cancelled;
pub use notes::{Note, notes};
pub use reference::Reference;
pub use sweep::{Column, ColumnKind, Frf, frequencies, sweep, sweep_alone};
pub use sweep_cache::SweepCache;
pub use validity::euler_bernoulli_up_to;

/// The kernel with a given instruction set, and its operations: only for the benchmark of the kernel, which measures
/// them.
#[doc(hidden)]
pub mod instruction_sets {
    pub use super::kernel::{Instructions, Work, work};
    pub use super::sweep::sweep_with;
}
