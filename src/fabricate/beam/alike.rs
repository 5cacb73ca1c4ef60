//! Types of nodes and edges. Nodes are alike if they have equally many beams, and all elevations
//! and angles between neighbouring beams agree within a tolerance for some choice of the first
//! beam; optionally also mirrored. Edges are alike if their lengths are.

use super::node::Node;
use crate::fabricate::alike::{Alike, Types};
use crate::fabricate::surface::PanelSurface;

/// Sorts nodes into types within `tolerance_deg`.
pub fn node_types(nodes: &[Option<Node>], tolerance_deg: f64, mirror: bool) -> Types {
    Types::new(nodes.iter().map(|node| node.as_ref().map(Angles::of)), tolerance_deg, mirror)
}

/// Sorts edges into types by length, within `tolerance` in the unit of the mesh.
pub fn edge_types(surface: &PanelSurface, tolerance: f64) -> Types {
    let lengths =
        surface.edges.iter().map(|edge| (!edge.is_bridge()).then(|| Length(surface.length(edge))));
    Types::new(lengths, tolerance, false)
}

/// The elevation of every beam, and the angle to the next one.
struct Angles {
    elevations: Vec<f64>,
    gaps: Vec<f64>,
}

impl Angles {
    fn of(node: &Node) -> Angles {
        Angles {
            elevations: node.spokes.iter().map(|spoke| spoke.elevation_deg).collect(),
            gaps: node.gaps_deg().collect(),
        }
    }
}

impl Alike for Angles {
    fn count(&self) -> usize {
        self.gaps.len()
    }

    fn key(&self) -> [f64; 2] {
        [&self.elevations, &self.gaps].map(|own| own.iter().copied().fold(-90.0, f64::max))
    }

    /// The largest difference of an angle, minimised over all first beams.
    fn difference(&self, other: &Angles, mirror: bool, most: f64) -> f64 {
        let n = self.gaps.len();
        let mut least = f64::INFINITY;
        for start in 0..n {
            for mirrored in [false, true].into_iter().take(1 + usize::from(mirror)) {
                let mut worst: f64 = 0.0;
                for k in 0..n {
                    // Mirrored, the order is reversed, and each gap comes before its beam.
                    let (beam, gap) = match mirrored {
                        false => ((start + k) % n, (start + k) % n),
                        true => ((start + n - k) % n, (start + 2 * n - k - 1) % n),
                    };
                    worst = worst.max((self.elevations[k] - other.elevations[beam]).abs());
                    worst = worst.max((self.gaps[k] - other.gaps[gap]).abs());
                    if worst > least.min(most) {
                        break;
                    }
                }
                least = least.min(worst);
            }
        }
        least
    }
}

/// The length of an edge.
struct Length(f64);

impl Alike for Length {
    fn count(&self) -> usize {
        1
    }

    fn key(&self) -> [f64; 2] {
        [self.0; 2]
    }

    fn difference(&self, other: &Length, _: bool, _: f64) -> f64 {
        (self.0 - other.0).abs()
    }
}
