//! Seams: boundary vertices that lie on other boundary vertices without being joined to them, as
//! where a program wrote two patches of one surface. Nothing keeps the patches together there.

use super::Mesh;
use super::coincident::{first_of_group, tolerance, within_face};
use super::sides::{Side, sides_of_faces};
use crate::math::marked;

/// Returns the pairs of boundary vertices that coincide, up to rounding, without being joined: each
/// later one, ascending, with the first that it lies on. Vertices of one face, which would lose an
/// edge, are left out, and so are those of faces that lie on each other: two layers have no seam. A
/// mesh with tetrahedra has none: they keep its faces together.
pub fn seams(mesh: &Mesh) -> Vec<[u32; 2]> {
    seams_of(mesh, &sides_of_faces(mesh))
}

/// As [`seams`], of a mesh with these sides.
pub(super) fn seams_of(mesh: &Mesh, sides: &[Side]) -> Vec<[u32; 2]> {
    let Some(tolerance) = tolerance(mesh).filter(|_| mesh.tets.is_empty()) else {
        return Vec::new();
    };
    let found = pairs(mesh, sides, tolerance);
    let layered = if found.is_empty() { Vec::new() } else { layered(mesh, tolerance) };
    if layered.is_empty() {
        return found;
    }
    let is_layered = marked(mesh.faces.len(), &layered);
    let others = mesh.faces.iter().zip(is_layered).filter(|(_, is_layered)| !is_layered);
    let faces = others.map(|(corners, _)| corners).collect();
    let mesh = Mesh { faces, ..mesh.clone() };
    pairs(&mesh, &sides_of_faces(&mesh), tolerance)
}

/// Returns the faces that lie on each other: their corners coincide, up to rounding.
fn layered(mesh: &Mesh, tolerance: f64) -> Vec<u32> {
    let first = first_of_group(mesh, |_| Some(0), tolerance);
    let mut places = mesh.faces.clone();
    places.rename(&first);
    places.sort_rows();
    let row = |face: u32| places.row(face as usize);
    let mut faces: Vec<u32> = (0..places.len() as u32).collect();
    faces.sort_unstable_by(|&a, &b| row(a).cmp(row(b)));
    let layers = faces.chunk_by(|&a, &b| row(a) == row(b));
    layers.filter(|layers| layers.len() > 1).flatten().copied().collect()
}

/// Returns the pairs as [`seams`], but also between the layers of a mesh.
fn pairs(mesh: &Mesh, sides: &[Side], tolerance: f64) -> Vec<[u32; 2]> {
    let rim = sides.chunk_by(|a, b| a.ends == b.ends).filter(|edge| edge.len() == 1);
    let ends: Vec<u32> = rim.flat_map(|edge| edge[0].ends).collect();
    let on_rim = marked(mesh.positions.len(), &ends);
    let first = first_of_group(mesh, |v| on_rim[v as usize].then_some(0), tolerance);
    if (0..).zip(&first).all(|(v, first)| v == *first) {
        return Vec::new();
    }
    let pairs = (0..).zip(&first).zip(within_face(mesh, &first));
    let pairs = pairs.filter(|((v, first), within_face)| v != *first && !within_face);
    pairs.map(|((v, &first), _)| [v, first]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Mesh, read};

    /// Two strips of two quads side by side; the second has its own vertices, `apart` from those of
    /// the first.
    fn strips(apart: f64) -> Mesh {
        let mut text = String::new();
        for x in [0.0, 1.0, 1.0 + apart, 2.0 + apart] {
            (0..3).for_each(|y| text.push_str(&format!("v {x} {y} {}\n", x * f64::from(y))));
        }
        text.push_str("f 1 4 5 2\nf 2 5 6 3\nf 7 10 11 8\nf 8 11 12 9\n");
        read("strips.obj", text.as_bytes()).expect("it is a mesh").mesh
    }

    #[test]
    fn vertices_along_a_seam_are_found_up_to_rounding_and_not_across_a_joint() {
        assert_eq!(seams(&strips(0.0)), [[6, 3], [7, 4], [8, 5]]);
        assert_eq!(seams(&strips(1e-7)), [[6, 3], [7, 4], [8, 5]]);
        assert_eq!(seams(&strips(0.01)), [[0; 2]; 0]);
    }

    #[test]
    fn a_seam_is_said_with_its_place_and_once() {
        let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n\
            f 1 2 3 4\nf 5 6 7 8\nf 1 4 3\n";
        let read = read("a.obj", text.as_bytes()).expect("it is a mesh");
        let said: Vec<String> = read.problems.iter().map(ToString::to_string).collect();
        let seam = "2 boundary vertices that lie on others without being joined to them: the seam can \
             open, first at line 5: `v 1 0 0`";
        assert!(said.iter().any(|line| line == seam), "{said:?}");
        assert_eq!(read.notes, [""; 0]);
        // One more, at no seam.
        let loose = format!("{text}v 2 1 0\n");
        let read = crate::mesh::read("a.obj", loose.as_bytes()).expect("it is a mesh");
        assert_eq!(read.notes, ["1 vertex lies exactly on an earlier one, first at line 12"]);
    }

    /// Appends copies of these faces, on copies of their vertices.
    fn double(mesh: &mut Mesh, faces: std::ops::Range<usize>) {
        let mut copies = vec![None; mesh.positions.len()];
        for face in faces {
            let mut row = mesh.faces.row(face).to_vec();
            for v in &mut row {
                let at = mesh.positions[*v as usize];
                *v = *copies[*v as usize].get_or_insert_with(|| {
                    mesh.positions.push(at);
                    mesh.positions.len() as u32 - 1
                });
            }
            mesh.faces.push(&row);
        }
    }

    #[test]
    fn layers_have_no_seam_and_do_not_hide_another_one() {
        let mut grid = String::new();
        for k in 0..25 {
            grid.push_str(&format!("v {} {} {}\n", k / 5, k % 5, 0.1 * f64::from(k)));
        }
        for k in (0..19).filter(|k| k % 5 < 4) {
            grid.push_str(&format!("f {} {} {} {}\n", k + 1, k + 6, k + 7, k + 2));
        }
        let grid = read("grid.obj", grid.as_bytes()).expect("it is a mesh").mesh;
        for faces in [0..16, 0..1, 0..4, 12..16] {
            let mut twice = grid.clone();
            double(&mut twice, faces);
            assert_eq!(seams(&twice), [[0; 2]; 0]);
        }
        // Only the face at one end of the seam is there twice.
        let mut mesh = strips(0.0);
        double(&mut mesh, 0..1);
        assert_eq!(seams(&mesh), [[7, 4], [8, 5]]);
    }

    #[test]
    fn faces_of_tetrahedra_have_no_seam() {
        // Nor could it be joined: see `MESH_OPERATIONS`.
        let mut mesh = strips(0.0);
        mesh.tets.push([0, 3, 4, 10]);
        assert_eq!(seams(&mesh), [[0; 2]; 0]);
    }

    #[test]
    fn a_guessed_place_is_on_no_seam() {
        let text = "v 0 0 0\nv 1 0 0\nv nan 1 0\nv 3 0 0\nv 4 0 0\nv nan 1 0\nf 1 2 3\nf 4 5 6\n";
        let mesh = read("a.obj", text.as_bytes()).expect("it is a mesh").mesh;
        assert_eq!(mesh.positions[2], mesh.positions[5]);
        assert_eq!(seams(&mesh), [[0; 2]; 0]);
    }

    #[test]
    fn a_seam_that_would_fold_a_face_onto_itself_is_none() {
        let mut mesh = strips(0.0);
        // A triangle with two corners on each other.
        mesh.faces.push(&[3, 6, 0]);
        assert!(seams(&mesh).iter().all(|[v, _]| *v != 6));
    }
}
