//! Panels that are the same. `delta(P, Q)` is the least, over cyclic shifts and (where the sheet may be turned
//! over) mirror images, of the largest difference of corresponding corner-to-corner distances. It is zero
//! exactly for congruent panels, and nothing is fitted.

use super::flat::FlatPanel;
use super::polygon::{length, minus, perimeter};

/// Panels sorted into types.
#[derive(Clone, Debug, Default)]
pub struct Types {
    /// The type of each panel, by panels; none of those that could not be laid flat.
    pub of_panels: Vec<Option<u32>>,
    /// The first panel of each type, which the others are compared with.
    pub leaders: Vec<u32>,
    /// How many panels each type has.
    pub counts: Vec<u32>,
    /// The largest `delta` of a panel to the leader of its type.
    pub worst: Vec<f64>,
}

/// Distances from each corner to those behind it, and the perimeter.
struct Shape {
    corners: usize,
    /// `distances[s * corners + k]`: from corner `k` to the one `s + 1` behind it.
    distances: Vec<f64>,
    perimeter: f64,
}

impl Shape {
    fn of(panel: &FlatPanel) -> Shape {
        let n = panel.corners.len();
        let distance =
            |s: usize, k: usize| length(minus(panel.corners[(k + s + 1) % n], panel.corners[k]));
        let distances = (0..n / 2).flat_map(|s| (0..n).map(move |k| distance(s, k))).collect();
        Shape { corners: n, distances, perimeter: perimeter(&panel.corners) }
    }

    /// `delta`, or something above `most` where it is above that.
    fn delta(&self, other: &Shape, mirror: bool, most: f64) -> f64 {
        let n = self.corners;
        let mut least = f64::INFINITY;
        for shift in 0..n {
            for mirrored in [false, true].into_iter().take(1 + usize::from(mirror)) {
                let bound = least.min(most);
                let mut worst: f64 = 0.0;
                'all: for s in 0..n / 2 {
                    for k in 0..n {
                        let there = if mirrored {
                            (2 * n + shift - k - s - 1) % n
                        } else {
                            (k + shift) % n
                        };
                        let difference = self.distances[s * n + k] - other.distances[s * n + there];
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

/// Sorts panels: in their order each joins the nearest leader within `tolerance`, else becomes one.
pub fn panel_types(panels: &[Option<FlatPanel>], tolerance: f64, mirror: bool) -> Types {
    let mut types = Types::default();
    let mut shapes: Vec<Shape> = Vec::new();
    // Leaders by their corners and perimeters: those of the same shape differ by little.
    let mut sorted: Vec<(usize, f64, u32)> = Vec::new();
    for (panel, f) in panels.iter().zip(0..) {
        let Some(panel) = panel else {
            types.of_panels.push(None);
            continue;
        };
        let shape = Shape::of(panel);
        let reach = shape.corners as f64 * tolerance;
        let from = sorted.partition_point(|&(corners, perimeter, _)| {
            corners < shape.corners
                || (corners == shape.corners && perimeter < shape.perimeter - reach)
        });
        let mut nearest: Option<(f64, u32)> = None;
        for &(corners, perimeter, own) in &sorted[from..] {
            if corners != shape.corners || perimeter > shape.perimeter + reach {
                break;
            }
            let delta = shape.delta(&shapes[own as usize], mirror, tolerance);
            let is_nearer = nearest.is_none_or(|best| (delta, own) < best);
            if delta <= tolerance && is_nearer {
                nearest = Some((delta, own));
            }
        }
        let own = match nearest {
            Some((delta, own)) => {
                types.counts[own as usize] += 1;
                types.worst[own as usize] = types.worst[own as usize].max(delta);
                own
            }
            None => {
                let own = shapes.len() as u32;
                let at = sorted.partition_point(|&(corners, perimeter, _)| {
                    (corners, perimeter) < (shape.corners, shape.perimeter)
                });
                sorted.insert(at, (shape.corners, shape.perimeter, own));
                shapes.push(shape);
                types.leaders.push(f);
                types.counts.push(1);
                types.worst.push(0.0);
                own
            }
        };
        types.of_panels.push(Some(own));
    }
    types
}
