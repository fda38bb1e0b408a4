//! Search for missing roots: the plane is divided until each part contains few of them, which are then computed.
//!
//! Division by the argument principle: Delves & Lyness, Math. Comp. 21 (1967) 543-560; Kravanja & Van Barel, Computing
//! the Zeros of Analytic Functions (Springer, 2000). The contour integrals of responses give the roots of a part.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::argument_principle::{COUNTED_ANGLES, Sector, Unsettled};
use super::damped::Search;
use super::eigenspace::Circle;
use super::types::Gap;
use crate::solve::Cancelled;

/// The division of the half disc of a search.
pub(super) struct Regions<'a> {
    search: &'a Search<'a>,
    /// Radius of the disc, rad/s.
    outer: f64,
}

/// The result for a sector.
enum Outcome {
    /// Nothing is missing in it.
    Settled,
    /// It must be divided.
    Divided([Sector; 2]),
    /// It cannot be settled.
    Open(Option<i64>),
}

impl<'a> Regions<'a> {
    /// For the disc up to `outer`, rad/s.
    pub(super) fn new(search: &'a Search<'a>, outer: f64) -> Self {
        Self { search, outer }
    }

    /// The roots, completed by the missing ones, and the ranges that stay open.
    pub(super) fn completed(
        &self,
        mut roots: Vec<Complex64>,
    ) -> Result<(Vec<Complex64>, Vec<Gap>), Cancelled> {
        let inner = self.inner(&roots)?;
        let mut open = Vec::new();
        if let Err(inner) = inner {
            open.push((0.0, inner, None));
        }
        let mut sectors = vec![Sector {
            radii: [inner.unwrap_or_else(|inner| inner).ln(), self.outer.ln()],
            angles: COUNTED_ANGLES,
        }];
        while let Some(sector) = sectors.pop() {
            match self.settle(&sector, &mut roots)? {
                Outcome::Settled => {}
                Outcome::Divided(parts) => sectors.extend(parts),
                Outcome::Open(missing) => {
                    let [from, to] = sector.radii.map(f64::exp);
                    open.push((from, to, missing));
                }
            }
        }
        match self.search.missing(&roots, self.outer)? {
            // All entries of the list are roots, so none is missing.
            Some(0) => open.clear(),
            Some(_) if open.is_empty() => open.push((0.0, self.outer, None)),
            // The parts are counted separately.
            Some(_) | None => {}
        }
        let gaps = gaps(open, &roots);
        Ok((roots, gaps))
    }

    /// A radius below which no root is missing, or otherwise the radius below which this is unknown.
    fn inner(&self, roots: &[Complex64]) -> Result<Result<f64, f64>, Cancelled> {
        const SMALLER: f64 = 0.03;
        const TRIES: usize = 4;
        let slowest = roots
            .iter()
            .map(|root| root.norm())
            .fold(self.outer, f64::min);
        let mut radius = 0.3 * slowest;
        for _ in 0..TRIES {
            if self.search.missing(roots, radius)? == Some(0) {
                return Ok(Ok(radius));
            }
            radius *= SMALLER;
        }
        Ok(Err(radius / SMALLER))
    }

    fn settle(&self, sector: &Sector, roots: &mut Vec<Complex64>) -> Result<Outcome, Cancelled> {
        const SMALL: f64 = 0.4;
        const SMALLEST: f64 = 2e-3;
        let counted = match self.search.remainder(roots).in_sector(sector) {
            Err(Unsettled::Cancelled(cancelled)) => return Err(cancelled),
            Err(Unsettled::Spent) => return Ok(Outcome::Open(None)),
            Err(Unsettled::Noise) => None,
            Ok(0) => return Ok(Outcome::Settled),
            Ok(missing) => Some(missing),
        };
        let [length, width] = [sector.radii, sector.angles].map(|[from, to]| to - from);
        if let Some(missing) = counted
            && length.max(width) < SMALL
            && self.found(sector, missing, roots)?
            && self.search.remainder(roots).in_sector(sector) == Ok(0)
        {
            return Ok(Outcome::Settled);
        }
        Ok(if length.max(width) < SMALLEST {
            Outcome::Open(counted)
        } else {
            Outcome::Divided(divided(sector, roots))
        })
    }

    /// Adds roots near a sector with missing ones; returns whether there were any.
    fn found(
        &self,
        sector: &Sector,
        missing: i64,
        roots: &mut Vec<Complex64>,
    ) -> Result<bool, Cancelled> {
        // Identical subsystems have equally many roots close together.
        const MOST: i64 = 12;
        const MOST_CLOSE: i64 = 48;
        const CLOSE: f64 = 0.02;
        const POINTS: usize = 32;
        let middle = [sector.radii, sector.angles].map(|[from, to]| 0.5 * (from + to));
        let centre = Complex64::from_polar(middle[0].exp(), middle[1]);
        let corner = Complex64::from_polar(sector.radii[1].exp(), sector.angles[1]);
        let circle = Circle {
            centre,
            radius: 1.1 * (corner - centre).norm(),
            points: POINTS,
        };
        let remainder = self.search.remainder(roots);
        let known = remainder.known.iter();
        let inside = known
            .filter(|root| (*root - centre).norm() < circle.radius)
            .count() as i64;
        let count = match remainder.in_circle(centre, circle.radius) {
            Err(Unsettled::Cancelled(cancelled)) => return Err(cancelled),
            Err(Unsettled::Noise | Unsettled::Spent) => inside + missing,
            Ok(missing) => inside + missing,
        };
        let most = if sector.radii[1] - sector.radii[0] < CLOSE {
            MOST_CLOSE
        } else {
            MOST
        };
        if !(1..=most).contains(&count) {
            return Ok(false);
        }
        let starts = self.search.inside(circle, count as usize);
        let before = roots.len();
        *roots = self.search.proven(std::mem::take(roots), &starts)?;
        if roots.len() == before {
            // They may be too inaccurate for the proof.
            let arrived = self.search.settled(&starts, roots)?;
            *roots = self.search.proven(std::mem::take(roots), &arrived)?;
        }
        Ok(roots.len() > before)
    }
}

/// Two parts of a sector, divided where no known root is near.
fn divided(sector: &Sector, roots: &[Complex64]) -> [Sector; 2] {
    const SHARES: [f64; 5] = [0.5, 0.45, 0.55, 0.4, 0.6];
    let [length, width] = [sector.radii, sector.angles].map(|[from, to]| to - from);
    let by_radius = length >= width;
    let [from, to] = if by_radius {
        sector.radii
    } else {
        sector.angles
    };
    let place = |share: f64| from + share * (to - from);
    let distance = |share: f64| {
        let at = |root: &Complex64| {
            if by_radius {
                root.norm().ln()
            } else {
                root.arg()
            }
        };
        let distances = roots.iter().map(|root| (at(root) - place(share)).abs());
        distances.fold(f64::INFINITY, f64::min)
    };
    let far = |a: &f64, b: &f64| distance(*a).total_cmp(&distance(*b));
    let cut = place(SHARES.into_iter().max_by(far).unwrap_or(0.5));
    let [mut low, mut high] = [*sector; 2];
    let (end, start) = if by_radius {
        (&mut low.radii[1], &mut high.radii[0])
    } else {
        (&mut low.angles[1], &mut high.angles[0])
    };
    (*end, *start) = (cut, cut);
    [low, high]
}

/// Open ranges by ascending frequency, adjacent ones merged.
fn gaps(mut open: Vec<(f64, f64, Option<i64>)>, roots: &[Complex64]) -> Vec<Gap> {
    open.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut joined: Vec<(f64, f64, Option<i64>)> = Vec::new();
    for (from, to, missing) in open {
        match joined.last_mut() {
            Some(last) if from <= last.1 => {
                last.1 = last.1.max(to);
                last.2 = last.2.zip(missing).map(|(a, b)| a + b);
            }
            _ => joined.push((from, to, missing)),
        }
    }
    let gap = |(from, to, missing): (f64, f64, Option<i64>)| {
        let inside = |root: &&Complex64| (from..to).contains(&root.norm());
        let found = roots.iter().filter(inside).count();
        Gap {
            from: from / TAU,
            to: to / TAU,
            found,
            counted: missing.and_then(|missing| usize::try_from(found as i64 + missing).ok()),
        }
    };
    joined.into_iter().map(gap).collect()
}
