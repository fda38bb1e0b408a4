//! Groups of close roots, and the distance of the next one.

use num_complex::Complex64;

/// Roots of one group, and the distance of their mean to any other root, rad/s.
#[derive(Debug, Clone)]
pub(super) struct Neighbours {
    /// Their indices in the list of all, ascending.
    pub(super) members: Vec<usize>,
    /// The close ones among them, which have the same neighbours.
    pub(super) close: Vec<usize>,
    pub(super) gap: f64,
}

/// The roots within a chain of relative distances below `close` that includes `all[index]`, and more if these are no
/// closer to each other than to the next one.
pub(super) fn neighbours(all: &[Complex64], index: usize, close: f64) -> Neighbours {
    const MOST: usize = 48;
    const APART: f64 = 0.2;
    let mut members = vec![index];
    let mut next = 0;
    while next < members.len() {
        let here = all[members[next]];
        let larger = |other: Complex64| here.norm().max(other.norm());
        let near = |other: &usize| (all[*other] - here).norm() < close * larger(all[*other]);
        let new: Vec<usize> = (0..all.len())
            .filter(|other| near(other) && !members.contains(other))
            .collect();
        members.extend(new);
        next += 1;
    }
    members.sort_unstable();
    let close = members.clone();
    loop {
        let centre = members.iter().map(|&m| all[m]).sum::<Complex64>() / members.len() as f64;
        let size = members.iter().map(|&m| (all[m] - centre).norm());
        let size = size.fold(0.0, f64::max);
        let others = (0..all.len()).filter(|other| !members.contains(other));
        let distance = |&other: &usize| (all[other] - centre).norm();
        let nearest = others.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        // The rigid-body modes are at 0.
        let far = 0.5 * centre.norm();
        let gap = nearest.map_or(far, |other| distance(&other).min(far));
        match nearest {
            Some(other) if size > APART * gap && members.len() < MOST => members.push(other),
            _ => {
                members.sort_unstable();
                return Neighbours {
                    members,
                    close,
                    gap,
                };
            }
        }
    }
}

/// The roots and, if the model has no loss factor, their mirror images at the imaginary axis: these are also roots.
pub(super) fn with_images(roots: &[Complex64], hysteretic: bool) -> Vec<Complex64> {
    let mut all = roots.to_vec();
    if !hysteretic {
        all.extend(
            roots
                .iter()
                .filter(|root| root.re != 0.0)
                .map(|root| -root.conj()),
        );
    }
    all
}
