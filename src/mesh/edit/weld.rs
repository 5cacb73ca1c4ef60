//! Welding of coincident vertices. In a mesh whose faces do not share vertices, faces have no
//! common edges, and constraints on them would tear it apart.

use crate::math::marked;
use crate::mesh::coincident::{first_of_group, tolerance, within_face};
use crate::mesh::{
    GroupKeyword, Mesh, Point, ProblemKind, Read, Topology, diagnose, elements_with_problem,
};
use crate::words;
use std::collections::BTreeSet;

/// A mesh is unwelded if at least this fraction of the vertices of faces belongs to one face only.
const OWN: f64 = 0.9;
/// It is welded only if at least this fraction of the vertices of faces merges into others.
const SHARED: f64 = 0.25;

/// A welded mesh: its original, and the map to the merged vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Weld {
    /// The mesh before welding.
    pub original: Mesh,
    /// The vertex of the welded mesh for each vertex of the original.
    pub to: Vec<u32>,
    /// Largest distance at which vertices are welded, in the unit of the mesh.
    pub tolerance: f64,
}

impl Read {
    /// Welds the mesh if its faces do not share vertices, and updates its problems and notes.
    pub fn weld(&mut self) -> Option<Weld> {
        let weld = Weld::apply(&mut self.mesh)?;
        self.problems.retain(|problem| !problem.kind.is_of_mesh());
        self.problems.extend(diagnose(&self.mesh));
        if let Some(outdated) = self.on_coincident.take() {
            self.notes.remove(outdated);
        }
        let left = self.mesh.positions.len();
        let [welded, left] = [weld.original.positions.len() - left, left].map(words::group_digits);
        self.notes.push(format!(
            "faces do not share vertices: {welded} coincident vertices were welded, and the mesh has {left}, \
             which are numbered anew"
        ));
        Some(weld)
    }
}

impl Weld {
    /// Welds `mesh` if its faces do not share vertices. Returns `None` and leaves it unchanged if
    /// they do, or if too few vertices coincide. Faces, curves and groups keep their order; merged
    /// vertices are in the order of the first of each.
    pub fn apply(mesh: &mut Mesh) -> Option<Weld> {
        let uses = uses(mesh);
        let used = uses.iter().filter(|&&uses| uses > 0).count();
        let own = uses.iter().filter(|&&uses| uses == 1).count();
        if !mesh.tets.is_empty() || mesh.faces.len() < 2 || (own as f64) < OWN * used as f64 {
            return None;
        }
        let tolerance = tolerance(mesh)?;
        let within = |parts: &[u32]| {
            let mut first = first_of_group(mesh, |v| Some(parts[v as usize]), tolerance);
            let stays = within_face(mesh, &first);
            (0..)
                .zip(&mut first)
                .zip(stays)
                .filter(|(_, stays)| *stays)
                .for_each(|((v, own), _)| *own = v);
            // Loose points and ends of curves at one place say nothing of faces.
            let of_faces = first.iter().zip(&uses).filter(|(_, uses)| **uses > 0);
            let remain = of_faces.map(|(first, _)| first).collect::<BTreeSet<_>>().len();
            let merge = (used - remain) as f64;
            (merge >= SHARED * used as f64).then(|| merged(mesh, &first))?
        };
        // Solids that touch have two coincident faces: weld such solids within their groups only. Copies
        // of faces are welded by themselves.
        let (welded, to) = within(&vec![0; mesh.positions.len()])
            .or_else(|| within(&groups(mesh)))
            .or_else(|| within(&copies(mesh, tolerance)?))?;
        Some(Weld { original: std::mem::replace(mesh, welded), to, tolerance })
    }

    /// Returns the positions of the original, `#V by 3`, after the welded mesh moved from `rest` to
    /// `now`: each vertex is where its welded one is, so that what was measured on the welded mesh is
    /// true of the original. If nothing moved, all are where they were.
    pub fn original_positions(&self, rest: &[Point], now: &[Point]) -> Vec<Point> {
        if now == rest {
            return self.original.positions.clone();
        }
        self.to.iter().map(|&to| now[to as usize]).collect()
    }
}

/// Merges the vertices that have the same `first`; returns the mesh and the new index of each vertex.
/// `None` if faces coincide.
fn merged(mesh: &Mesh, first: &[u32]) -> Option<(Mesh, Vec<u32>)> {
    let mut to = vec![0; first.len()];
    let mut positions = Vec::new();
    for (vertex, &first) in first.iter().enumerate() {
        to[vertex] = if first as usize == vertex {
            positions.push(mesh.positions[vertex]);
            positions.len() as u32 - 1
        } else {
            to[first as usize]
        };
    }
    let mut welded = Mesh { positions, ..mesh.clone() };
    welded.faces.rename(&to);
    welded.curves.rename(&to);
    welded.untouched.rename(&to);
    for v in &mut welded.unplaced {
        *v = to[*v as usize];
    }
    welded.unplaced.sort_unstable();
    welded.unplaced.dedup();
    let on_each_other =
        |mesh: &Mesh| elements_with_problem(mesh, ProblemKind::DuplicateFace).faces.len();
    (on_each_other(&welded) == on_each_other(mesh)).then_some((welded, to))
}

/// Returns for each vertex 1 if only copies of faces have it, else 0: faces that lie on an earlier one
/// without sharing its vertices. None where more than two other faces meet at a side of one, as where
/// solids touch.
fn copies(mesh: &Mesh, tolerance: f64) -> Option<Vec<u32>> {
    let mut joined = mesh.clone();
    joined.faces.rename(&first_of_group(mesh, |_| Some(0), tolerance));
    let on_earlier = |mesh: &Mesh| elements_with_problem(mesh, ProblemKind::DuplicateFace).faces;
    let mut is_copy = marked(mesh.faces.len(), on_earlier(&joined));
    on_earlier(mesh).into_iter().for_each(|face| is_copy[face as usize] = false);
    let is_crowded = |faces: &[u32]| {
        let others = faces.iter().filter(|face| !is_copy[**face as usize]).count();
        others > 2 && others < faces.len()
    };
    if !is_copy.contains(&true) || Topology::new(&joined).edge_faces().iter().any(is_crowded) {
        return None;
    }
    let mut of_copies = vec![1; mesh.positions.len()];
    let rows = mesh.faces.iter().zip(&is_copy).filter(|(_, is_copy)| !**is_copy);
    rows.flat_map(|(row, _)| row).for_each(|&v| of_copies[v as usize] = 0);
    Some(of_copies)
}

/// Returns for each vertex the number, from 1, of an object or group of its faces; 0 without one.
fn groups(mesh: &Mesh) -> Vec<u32> {
    let mut of_vertex = vec![0; mesh.positions.len()];
    let named = mesh.groups.iter().filter(|group| group.keyword != GroupKeyword::Material);
    for (number, group) in (1..).zip(named) {
        for corner in group.faces.iter().flat_map(|&face| mesh.faces.row(face as usize)) {
            of_vertex[*corner as usize] = number;
        }
    }
    of_vertex
}

fn uses(mesh: &Mesh) -> Vec<u32> {
    let mut uses = vec![0; mesh.positions.len()];
    mesh.faces.indices().iter().for_each(|&v| uses[v as usize] += 1);
    uses
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::read;

    /// A grid of `n * n` quads that do not share vertices; coincident corners differ by up to
    /// `apart`.
    fn soup(n: u32, apart: f64, scale: f64) -> Mesh {
        let mut mesh = Mesh::default();
        for (i, j) in (0..n * n).map(|k| (k % n, k / n)) {
            let first = mesh.positions.len() as u32;
            for (x, y) in [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)] {
                let lift = apart * f64::from((i + 2 * j) % 3) * 0.5;
                let at = [f64::from(x), f64::from(y), 0.1 * f64::from(x * y) + lift];
                mesh.positions.push(at.map(|x| scale * x));
            }
            mesh.faces.push(&[first, first + 1, first + 2, first + 3]);
        }
        mesh
    }

    #[test]
    fn faces_with_vertices_of_their_own_are_welded_and_come_out_as_they_came() {
        for (apart, scale) in [(0.0, 1.0), (1e-7, 1.0), (1e-7, 1e-3), (0.0, 1e6)] {
            let came = soup(5, apart, scale);
            let mut mesh = came.clone();
            let weld = Weld::apply(&mut mesh).expect("its faces have their own vertices");
            assert_eq!((mesh.positions.len(), mesh.faces.len()), (36, 25));
            assert_eq!(Topology::new(&mesh).boundary_loops().len(), 1);
            assert_eq!(weld.original, came);
            assert!(weld.tolerance > 0.0 && weld.tolerance < 1e-4 * scale);
            assert_eq!(weld.original_positions(&mesh.positions, &mesh.positions), came.positions);
            // Welded vertices are at one place, so that what holds for the mesh holds for them.
            let mut now = mesh.positions.clone();
            now[weld.to[2] as usize][2] += scale;
            let out = weld.original_positions(&mesh.positions, &now);
            let is_there = |(at, &to): (&Point, &u32)| *at == now[to as usize];
            assert!(out.iter().zip(&weld.to).all(is_there));
        }
    }

    #[test]
    fn a_face_with_two_corners_at_one_place_leaves_the_others_welded() {
        let mut mesh = soup(5, 0.0, 1.0);
        let first = mesh.positions.len() as u32;
        mesh.positions.extend([[5.0, 5.0, 2.5], [5.0, 5.0, 2.5], [6.0, 5.0, 2.5]]);
        mesh.faces.push(&[first, first + 1, first + 2]);
        Weld::apply(&mut mesh).expect("most of its faces can be welded");
        // Only the place of the two corners, where another face has one, is left as it is.
        assert_eq!((mesh.positions.len(), mesh.faces.len()), (39, 26));
        assert_eq!(Topology::new(&mesh).boundary_loops().len(), 2);
    }

    #[test]
    fn faces_that_only_touch_themselves_stay_as_they_are() {
        // Separate quads, each with two corners at one place.
        let mut mesh = soup(2, 0.0, 1.0);
        for face in 0..4_u32 {
            let first = 4 * face as usize;
            for v in first..first + 4 {
                mesh.positions[v][0] += 10.0 * f64::from(face);
            }
            mesh.positions[first + 1] = mesh.positions[first];
        }
        assert_eq!(Weld::apply(&mut mesh), None);
    }

    #[test]
    fn what_is_whole_or_in_separate_pieces_stays_as_it_is() {
        let mut apart = soup(5, 0.0, 1.0);
        // Panels with joints between them.
        for face in 0..apart.faces.len() {
            for &v in &apart.faces.row(face).to_vec() {
                apart.positions[v as usize][0] += 0.02 * (face % 5) as f64;
                apart.positions[v as usize][1] += 0.02 * (face / 5) as f64;
            }
        }
        let mut whole = soup(5, 0.0, 1.0);
        Weld::apply(&mut whole).expect("it is in pieces");
        for mesh in [apart, whole, soup(1, 0.0, 1.0), Mesh::default()] {
            let mut after = mesh.clone();
            assert_eq!(Weld::apply(&mut after), None);
            assert_eq!(after, mesh);
        }
    }

    #[test]
    fn stray_vertices_far_away_do_not_weld_what_has_joints() {
        // Panels with joints of 20 mm at site coordinates, and unused vertices at the origin.
        let mut mesh = soup(5, 0.0, 1.0);
        for face in 0..mesh.faces.len() {
            for &v in &mesh.faces.row(face).to_vec() {
                let at = &mut mesh.positions[v as usize];
                at[0] += 2.7e6 + 0.02 * (face % 5) as f64;
                at[1] += 0.02 * (face / 5) as f64;
            }
        }
        mesh.positions.extend([[0.0; 3]; 30]);
        assert_eq!(Weld::apply(&mut mesh), None);
    }

    #[test]
    fn a_copy_of_a_face_is_left_out_and_the_others_are_welded() {
        for copied in [0, 12] {
            let mut mesh = soup(5, 0.0, 1.0);
            let first = mesh.positions.len() as u32;
            let row = mesh.faces.row(copied).to_vec();
            row.iter().for_each(|&v| mesh.positions.push(mesh.positions[v as usize]));
            mesh.faces.push(&[first, first + 1, first + 2, first + 3]);
            Weld::apply(&mut mesh).expect("its faces have their own vertices");
            assert_eq!((mesh.positions.len(), mesh.faces.len()), (40, 26));
            assert_eq!(Topology::new(&mesh).boundary_loops().len(), 2);
        }
        // Of two boxes side by side with such faces no one knows which is to be left out.
        let mut boxes = Mesh::default();
        for x in [0.0, 1.0] {
            let corner = |i: usize| [x + (i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64];
            for face in
                [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
            {
                let first = boxes.positions.len() as u32;
                boxes.positions.extend(face.map(corner));
                boxes.faces.push(&[first, first + 1, first + 2, first + 3]);
            }
        }
        assert_eq!(Weld::apply(&mut boxes), None);
    }

    #[test]
    fn two_boxes_that_touch_stay_two() {
        let corners =
            |x: u32| (0..8).map(move |i| format!("v {} {} {}\n", x + (i & 1), i >> 1 & 1, i >> 2));
        let faces = |k: u32| {
            [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]
                .map(|face| format!("f {}\n", face.map(|v: u32| (v + k).to_string()).join(" ")))
        };
        let text: String = corners(0).chain(corners(1)).chain(faces(0)).chain(faces(8)).collect();
        let mut boxes = read("boxes.obj", text.as_bytes()).expect("it is a mesh").mesh;
        assert_eq!(Weld::apply(&mut boxes), None);
    }
}
