//! A block with creases and corners: a gatehouse.

use super::blocks::Blocks;
use super::finish::{Noise, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Group, GroupKeyword, Mesh, Topology, feature_curves};

/// A block with a pitched roof and a round passage through it, of quads. Vertices are displaced
/// along the surface, except at the corners of the block; those on a crease stay on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Archway {
    /// Panels around the passage (a multiple of four), through the wall, and along the passage.
    pub panels: [u32; 3],
    /// Half the width, height of the eaves, height of the ridge, length.
    pub size: [f64; 4],
    /// Radius of the passage, and the height at which its arch begins.
    pub passage: [f64; 2],
    /// Largest displacement of a vertex, as a fraction of a panel.
    pub jitter: f64,
}

impl Default for Archway {
    fn default() -> Self {
        Archway {
            panels: [36, 5, 16],
            size: [5.6, 6.0, 8.8, 11.0],
            passage: [3.2, 2.6],
            jitter: 0.36,
        }
    }
}

/// Smallest turn of the surface at a crease, in degrees.
const CREASE: f64 = 40.0;

impl Archway {
    /// The mesh. Its curves are the creases detected in it, each in a group of its own.
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Blocks::bar(self.panels).surface();
        let mut noise = Noise { state: 1 };
        for p in &mut mesh.positions {
            let at = *p;
            let shifts: [f64; 3] = std::array::from_fn(|_| self.jitter * noise.next());
            for axis in 0..3 {
                if !self.is_kept(axis, at) {
                    p[axis] += shifts[axis];
                }
            }
            *p = self.point(*p);
        }
        // The map below turns the block inside out.
        let turned = |face: &[u32]| face.iter().rev().copied().collect::<Vec<_>>();
        mesh.faces = mesh.faces.iter().map(turned).collect();
        let mut mesh = rounded(mesh);
        mesh.curves = feature_curves(&mesh, &Topology::new(&mesh), CREASE);
        mesh.groups = (0..mesh.curves.len() as u32)
            .map(|curve| Group {
                name: format!("crease-{}", curve + 1),
                keyword: GroupKeyword::Group,
                faces: Vec::new(),
                curves: vec![curve],
            })
            .collect();
        mesh
    }

    /// Whether a vertex keeps its coordinate `axis`, so that it does not leave a side of the block
    /// or a crease.
    fn is_kept(&self, axis: usize, at: [f64; 3]) -> bool {
        let is_end = |axis: usize| at[axis] == 0.0 || at[axis] == f64::from(self.panels[axis]);
        let is_outside = at[1] == f64::from(self.panels[1]);
        let around = f64::from(self.panels[0]);
        let at_crease = [0.25, 0.5, 0.75].iter().any(|part| at[0] == part * around);
        is_end(axis) || (axis == 0 && is_outside && at_crease)
    }

    /// Maps grid coordinates to space: around the passage from one foot over the ridge to the
    /// other, from the passage outwards, and along the passage.
    fn point(&self, [around, outwards, along]: [f64; 3]) -> [f64; 3] {
        let [n, thick, long] = self.panels.map(f64::from);
        let [half, eaves, ridge, length] = self.size;
        let [radius, spring] = self.passage;
        // Both sides are symmetric: `t` runs from 0 at a foot to 1 at the ridge.
        let side = if 2.0 * around > n { 1.0 } else { -1.0 };
        let t = 1.0 - (2.0 * around / n - 1.0).abs();
        let outer = match t {
            t if t <= 0.5 => [half, 2.0 * t * eaves],
            t => [half * (2.0 - 2.0 * t), eaves + (2.0 * t - 1.0) * (ridge - eaves)],
        };
        let quarter = 0.25 * std::f64::consts::TAU * radius;
        let inner = match t * (spring + quarter) {
            up if up <= spring => [radius, up],
            up => {
                let turns = 0.25 * (up - spring) / quarter;
                [radius * cosine(turns), spring + radius * sine(turns)]
            }
        };
        let s = outwards / thick;
        let [x, z] = std::array::from_fn(|i| inner[i] + s * (outer[i] - inner[i]));
        [side * x, (along / long - 0.5) * length, z]
    }
}
