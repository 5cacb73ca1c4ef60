//! Types of panels. The difference `delta(P, Q)` is the largest difference of corresponding
//! distances between corners, and of how far corresponding sides are moved before they are cut, minimised
//! over cyclic shifts and (if the sheet may be turned over) mirror images. It is zero exactly for panels
//! that are congruent and cut alike, and needs no fitting.

use super::FlatPanel;
use super::polygon::perimeter;
use crate::fabricate::alike::{Alike, Types};
use crate::math::plane::{length, minus};

/// The most distances between corners of a panel: of one with more, every so many offsets are taken.
const MOST_DISTANCES: usize = 1_000_000;
/// Setbacks that differ by less than this fraction of the largest distance are equal.
const ROUNDING: f64 = 1e-9;

/// Distances between the corners of a panel.
struct Shape {
    corners: usize,
    /// `distances[i * corners + k]`: from corner `k` to corner `k + s + 1`, with `s` the i-th offset.
    distances: Vec<f64>,
    /// How far side `k`, from corner `k` to corner `k + 1`, is moved.
    setbacks: Vec<f64>,
    /// The mean length of its sides.
    mean: f64,
    /// The largest of the distances.
    longest: f64,
}

impl Shape {
    fn of(panel: &FlatPanel, setbacks: Vec<f64>) -> Shape {
        let n = panel.corners.len();
        let distance =
            |s: usize, k: usize| length(minus(panel.corners[(k + s + 1) % n], panel.corners[k]));
        let distances: Vec<f64> =
            offsets(n).flat_map(|s| (0..n).map(move |k| distance(s, k))).collect();
        let longest = distances.iter().copied().fold(0.0, f64::max);
        let mean = perimeter(&panel.corners) / n as f64;
        Shape { corners: n, distances, setbacks, mean, longest }
    }
}

/// The offsets between corners whose distances are compared.
fn offsets(corners: usize) -> impl Iterator<Item = usize> {
    // A `usize` has 32 bits in a browser.
    let distances = (corners / 2) as u64 * corners as u64;
    let every = distances.div_ceil(MOST_DISTANCES as u64).max(1) as usize;
    (0..corners / 2).step_by(every)
}

impl Alike for Shape {
    fn count(&self) -> usize {
        self.corners
    }

    fn key(&self) -> [f64; 2] {
        [self.mean, self.longest]
    }

    /// The difference `delta`.
    fn difference(&self, other: &Shape, mirror: bool, most: f64) -> f64 {
        let n = self.corners;
        let mut least = f64::INFINITY;
        for shift in 0..n {
            for mirrored in [false, true].into_iter().take(1 + usize::from(mirror)) {
                let bound = least.min(most);
                let there = |s: usize, k: usize| match mirrored {
                    true => (2 * n + shift - k - s - 1) % n,
                    false => (k + shift) % n,
                };
                // A side that is moved by more changes its ends by still more where corners are sharp.
                let moved = |k: usize| (self.setbacks[k] - other.setbacks[there(0, k)]).abs();
                if (0..n).any(|k| moved(k) > ROUNDING * self.longest) {
                    continue;
                }
                let mut worst = 0.0_f64;
                'all: for (i, s) in offsets(n).enumerate() {
                    for k in 0..n {
                        let there = there(s, k);
                        let difference = self.distances[i * n + k] - other.distances[i * n + there];
                        worst = worst.max(difference.abs());
                        if worst > bound {
                            break 'all;
                        }
                    }
                }
                least = least.min(worst);
            }
        }
        least
    }
}

/// Sorts panels into types within `tolerance`. The sides of panel `f` are moved by `setbacks(f)` before it
/// is cut, in the unit of the mesh.
pub fn panel_types(
    panels: &[Option<FlatPanel>],
    setbacks: impl Fn(usize) -> Vec<f64>,
    tolerance: f64,
    mirror: bool,
) -> Types {
    let shape = |(panel, f): (&Option<FlatPanel>, usize)| {
        panel.as_ref().map(|panel| Shape::of(panel, setbacks(f)))
    };
    Types::new(panels.iter().zip(0..).map(shape), tolerance, mirror)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_of_many_corners_takes_no_gigabytes() {
        for n in [3, 4, 1001, 30_000, 131_072] {
            let count = n * offsets(n).count();
            assert!(count > 0 && count <= MOST_DISTANCES + n, "{n}: {count}");
        }
        assert_eq!(offsets(1000).count(), 500);
    }
}
