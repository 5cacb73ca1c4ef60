//! A block with creases and corners: a gatehouse.

use super::blocks::Blocks;
use crate::generate::finish::{Noise, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Group, GroupKeyword, Mesh, Ragged, Topology, crease_edges};

/// Panels around the passage (a multiple of four), through the wall, and along the passage.
const PANELS: [u32; 3] = [36, 5, 16];

/// A block with a pitched roof and a round passage through it, of quads. Vertices are displaced
/// along the surface, except at the corners of the block; those on a crease stay on it. The curves are the
/// creases detected in it, each in a group of its own.
pub fn archway() -> Mesh {
    let mut mesh = Blocks::bar(PANELS).surface();
    let mut noise = Noise { state: 1 };
    for p in &mut mesh.positions {
        let at = *p;
        let shifts: [f64; 3] = std::array::from_fn(|_| 0.36 * noise.next());
        for axis in 0..3 {
            if !is_kept(axis, at) {
                p[axis] += shifts[axis];
            }
        }
        *p = point(*p);
    }
    // The map below turns the block inside out.
    let turned = |face: &[u32]| face.iter().rev().copied().collect::<Vec<_>>();
    mesh.faces = mesh.faces.iter().map(turned).collect();
    let mut mesh = rounded(mesh);
    mesh.curves = creases(&mesh);
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
fn is_kept(axis: usize, at: [f64; 3]) -> bool {
    let is_end = |axis: usize| at[axis] == 0.0 || at[axis] == f64::from(PANELS[axis]);
    let is_outside = at[1] == f64::from(PANELS[1]);
    let around = f64::from(PANELS[0]);
    let at_crease = [0.25, 0.5, 0.75].iter().any(|part| at[0] == part * around);
    is_end(axis) || (axis == 0 && is_outside && at_crease)
}

/// Maps grid coordinates to space: around the passage from one foot over the ridge to the
/// other, from the passage outwards, and along the passage.
fn point([around, outwards, along]: [f64; 3]) -> [f64; 3] {
    let [n, thick, long] = PANELS.map(f64::from);
    // Half the width, height of the eaves, height of the ridge, length.
    let [half, eaves, ridge, length] = [5.6, 6.0, 8.8, 11.0];
    // Radius of the passage, and the height at which its arch begins.
    let [radius, spring] = [3.2, 2.6];
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

/// Smallest turn of the surface at a crease, in degrees.
const CREASE: f64 = 40.0;

/// The creases of a closed surface, along which vertices may slide when its quality is improved (paper
/// section 4.2): from corner to corner, where other than two of their edges meet.
fn creases(mesh: &Mesh) -> Ragged {
    let topology = Topology::new(mesh);
    let is_crease = crease_edges(mesh, &topology, CREASE);
    let edges_at = |v: u32| {
        let edges = topology.vertex_edges().row(v as usize).iter().copied();
        edges.filter(|&e| is_crease[e as usize])
    };
    let is_corner = |v: u32| ![0, 2].contains(&edges_at(v).count());
    let mut walked = vec![false; is_crease.len()];
    let mut curves = Ragged::new();
    for corner in (0..mesh.positions.len() as u32).filter(|&v| is_corner(v)) {
        for first in edges_at(corner) {
            let (mut curve, mut next) =
                (vec![corner], Some(first).filter(|&e| !walked[e as usize]));
            while let Some(edge) = next {
                walked[edge as usize] = true;
                let v = topology.other_end(edge, curve[curve.len() - 1]);
                curve.push(v);
                next = edges_at(v).find(|&e| !walked[e as usize] && !is_corner(v));
            }
            if curve.len() > 1 {
                curves.push(&curve);
            }
        }
    }
    curves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_creases_run_from_corner_to_corner() {
        let mesh = archway();
        let mut corners: Vec<u32> =
            mesh.curves.iter().flat_map(|curve| [curve[0], curve[curve.len() - 1]]).collect();
        corners.sort_unstable();
        let meet = corners.chunk_by(|a, b| a == b).map(<[u32]>::len);
        assert!(meet.clone().all(|count| count > 2), "{corners:?}");
        assert_eq!([mesh.curves.len(), mesh.groups.len(), meet.count()], [21, 21, 14]);
    }
}
