//! An animal of blended round parts.

use super::lattice::Lattice;
use crate::generate::finish::{rounded, slide};
use crate::math::Vec3;
use crate::mesh::{Mesh, Point};

/// Width of the cubes of the lattice: about the size of the triangles.
const SPACING: f64 = 0.25;

/// An animal on four legs, with a long neck and a tail that bends to one side. It faces along x. The
/// surface is closed, connected, of triangles.
pub fn creature() -> Mesh {
    let parts = parts();
    let field = |p: Point| blend(&parts, p);
    let (lowest, highest) = ([-3.6, -1.3, -0.5], [3.0, 1.3, 3.8]);
    let cells = std::array::from_fn(|i| ((highest[i] - lowest[i]) / SPACING).ceil() as u32);
    let mut mesh = Lattice { lowest, cells, spacing: SPACING }.polygonise(field);
    slide(&mut mesh, field, 0.1 * SPACING, 12);
    rounded(mesh)
}

/// A round part: the union of balls whose centres run along a segment and whose radii change
/// linearly.
struct Part {
    ends: [Vec3<f64>; 2],
    radii: [f64; 2],
}

impl Part {
    /// Approximate distance from the part, negative inside.
    fn distance(&self, p: Vec3<f64>) -> f64 {
        let [a, b] = self.ends;
        let axis = b - a;
        let t = ((p - a).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
        (p - (a + axis * t)).length() - (self.radii[0] + t * (self.radii[1] - self.radii[0]))
    }
}

/// The union of the parts with smooth transitions: a polynomial minimum of their distances.
fn blend(parts: &[Part], p: Point) -> f64 {
    const WIDTH: f64 = 0.22;
    let p = Vec3::from(p);
    parts.iter().map(|part| part.distance(p)).fold(f64::MAX, |a, b| {
        let overlap = (WIDTH - (a - b).abs()).max(0.0) / WIDTH;
        a.min(b) - 0.25 * WIDTH * overlap * overlap
    })
}

fn parts() -> Vec<Part> {
    let part = |a: Point, b: Point, radii: [f64; 2]| Part { ends: [a.into(), b.into()], radii };
    let mut parts = vec![
        // Trunk, neck, head and muzzle.
        part([-0.95, 0.0, 1.55], [0.8, 0.0, 1.65], [0.62, 0.6]),
        part([0.95, 0.0, 1.8], [1.65, 0.0, 2.75], [0.42, 0.26]),
        part([1.65, 0.0, 2.85], [2.0, 0.0, 2.9], [0.36, 0.33]),
        part([2.1, 0.0, 2.8], [2.5, 0.0, 2.68], [0.24, 0.2]),
        // The tail.
        part([-1.2, 0.0, 1.6], [-2.1, 0.1, 1.4], [0.45, 0.29]),
        part([-2.1, 0.1, 1.4], [-2.75, 0.35, 1.5], [0.29, 0.2]),
        part([-2.75, 0.35, 1.5], [-3.2, 0.7, 1.8], [0.2, 0.15]),
    ];
    for side in [-1.0, 1.0] {
        parts.extend([
            // Fore leg and hind leg, each with its foot.
            part([0.7, 0.4 * side, 1.4], [0.85, 0.55 * side, 0.7], [0.36, 0.24]),
            part([0.85, 0.55 * side, 0.7], [0.8, 0.55 * side, 0.2], [0.24, 0.21]),
            part([0.8, 0.55 * side, 0.18], [1.08, 0.6 * side, 0.15], [0.21, 0.18]),
            part([-0.95, 0.4 * side, 1.4], [-0.75, 0.6 * side, 0.75], [0.42, 0.27]),
            part([-0.75, 0.6 * side, 0.75], [-0.95, 0.6 * side, 0.2], [0.26, 0.21]),
            part([-0.95, 0.6 * side, 0.18], [-0.65, 0.65 * side, 0.15], [0.21, 0.18]),
            // An ear.
            part([1.65, 0.26 * side, 3.05], [1.45, 0.55 * side, 3.35], [0.16, 0.12]),
        ]);
    }
    parts
}
