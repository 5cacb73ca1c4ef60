//! Feature curves, along which vertices may slide when the quality of a mesh is improved (paper
//! section 4.2).

use crate::math::{Vec3, cosine, twice_vector_area};
use crate::mesh::{Mesh, Ragged, Topology};

/// Returns the curves of feature edges: edges where the surface turns by more than `degrees`,
/// boundary edges, and edges of more than two faces. Each feature edge is in exactly one curve.
///
/// A curve continues through vertices where two feature edges meet, and ends at all others, the
/// corners. A closed curve repeats its first vertex at the end. An edge at a face without area is
/// not a crease.
pub fn feature_curves(mesh: &Mesh, topology: &Topology, degrees: f64) -> Ragged {
    let at = |&v: &u32| Vec3::from(mesh.positions[v as usize]);
    let normal = |face: &[u32]| twice_vector_area(face.iter().map(at));
    let normals: Vec<Vec3<f64>> = mesh.faces.iter().map(normal).collect();
    let least = cosine(degrees / 360.0);
    let is_feature: Vec<bool> = (0..)
        .zip(topology.edge_faces().iter())
        .map(|(e, faces)| match *faces {
            [] => false,
            [f, g] => {
                let (a, b) = (normals[f as usize], normals[g as usize] * topology.agreement(e));
                let lengths = a.length() * b.length();
                // The margin keeps rounding from making creases in a plane.
                lengths > 0.0 && a.dot(b) < (least - 1e-12) * lengths
            }
            _ => true,
        })
        .collect();
    let mut creases = Creases { topology, walked: vec![false; is_feature.len()], is_feature };
    let vertices = 0..mesh.positions.len() as u32;
    let mut curves = Ragged::new();
    // Curves from the corners first; closed curves are then left.
    for from_corners in [true, false] {
        for v in vertices.clone() {
            while let Some(edge) =
                creases.fresh(v).filter(|_| !from_corners || creases.is_corner(v))
            {
                curves.push(&creases.walk(edge, v));
            }
        }
    }
    curves
}

/// The feature edges, and which of them are already in a curve.
struct Creases<'a> {
    topology: &'a Topology,
    is_feature: Vec<bool>,
    walked: Vec<bool>,
}

impl Creases<'_> {
    fn at(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let edges = self.topology.vertex_edges().row(v as usize);
        edges.iter().copied().filter(|&e| self.is_feature[e as usize])
    }

    fn is_corner(&self, v: u32) -> bool {
        self.at(v).count() != 2
    }

    /// Returns a feature edge at a vertex that is not yet in a curve.
    fn fresh(&self, v: u32) -> Option<u32> {
        self.at(v).find(|&e| !self.walked[e as usize])
    }

    fn walk(&mut self, first: u32, start: u32) -> Vec<u32> {
        let mut curve = vec![start];
        let (mut next, mut v) = (Some(first), start);
        while let Some(edge) = next {
            self.walked[edge as usize] = true;
            v = self.topology.other_end(edge, v);
            curve.push(v);
            next = if self.is_corner(v) { None } else { self.fresh(v) };
        }
        curve
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::model::Blocks;

    #[test]
    fn a_box_has_twelve_creases_between_eight_corners() {
        let mesh = Blocks::bar([3, 2, 4]).surface();
        let curves = feature_curves(&mesh, &Topology::new(&mesh), 45.0);
        let mut ends: Vec<u32> = curves.iter().flat_map(|c| [c[0], c[c.len() - 1]]).collect();
        ends.sort_unstable();
        assert_eq!(curves.len(), 12);
        assert!(ends.chunks(3).all(|corner| corner[0] == corner[2]), "{ends:?}");
        assert_eq!(curves.iter().map(|c| c.len() - 1).sum::<usize>(), 4 * (3 + 2 + 4));
        // The threshold is exclusive.
        assert_eq!(feature_curves(&mesh, &Topology::new(&mesh), 90.0).len(), 0);
        // Which way a face is turned makes no crease.
        let turned = |(f, face): (usize, &[u32])| match f % 3 {
            0 => face.iter().rev().copied().collect(),
            _ => face.to_vec(),
        };
        let faces = mesh.faces.iter().enumerate().map(turned).collect();
        let mesh = Mesh { faces, ..mesh };
        assert_eq!(feature_curves(&mesh, &Topology::new(&mesh), 45.0), curves);
    }

    #[test]
    fn boundaries_are_closed_curves_and_what_lies_flat_has_no_crease() {
        // Two separate squares, one of them folded along its diagonal.
        let square = |z: f64, fold: f64| {
            [[0.0, 0.0, z], [1.0, 0.0, z + fold], [1.0, 1.0, z], [0.0, 1.0, z + fold]]
        };
        let positions = [square(0.0, 0.0), square(5.0, 0.8)].concat();
        let mut faces = Ragged::new();
        for first in [0, 4] {
            faces.push(&[first, first + 1, first + 2]);
            faces.push(&[first, first + 2, first + 3]);
        }
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        let curves = feature_curves(&mesh, &Topology::new(&mesh), 45.0);
        let rows: Vec<&[u32]> = curves.iter().collect();
        // The fold makes corners of the two ends of its diagonal.
        assert_eq!(rows, [&[4, 5, 6][..], &[4, 6], &[4, 7, 6], &[0, 1, 2, 3, 0]]);
    }
}
