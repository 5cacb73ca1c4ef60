//! Seams: boundary vertices that lie on other boundary vertices without being joined to them, as
//! where a program wrote two patches of one surface. Nothing keeps the patches together there.

use super::coincident::{first_within, tolerance};
use super::half_edges::half_edges;
use super::{Mesh, Point};
use crate::math::marked;

/// Returns the pairs of boundary vertices that coincide, up to rounding, without being joined: each
/// later one, ascending, with the first that it lies on. Vertices of one face, which would lose an
/// edge, are left out.
pub fn seams(mesh: &Mesh) -> Vec<[u32; 2]> {
    let Some(tolerance) = tolerance(mesh) else { return Vec::new() };
    let sides = half_edges(mesh);
    let rim = sides.chunk_by(|a, b| a.ends == b.ends).filter(|edge| edge.len() == 1);
    let ends: Vec<u32> = rim.flat_map(|edge| edge[0].ends).collect();
    let on_rim = marked(mesh.positions.len(), &ends);
    let vertices: Vec<u32> =
        (0..mesh.positions.len() as u32).filter(|&v| on_rim[v as usize]).collect();
    let positions: Vec<Point> = vertices.iter().map(|&v| mesh.positions[v as usize]).collect();
    let mut first: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    for (&v, nearest) in
        vertices.iter().zip(first_within(&positions, &vec![0; vertices.len()], tolerance))
    {
        first[v as usize] = vertices[nearest as usize];
    }
    let mut within_face = vec![false; mesh.positions.len()];
    for face in mesh.faces.iter() {
        let mut at: Vec<u32> = face.iter().map(|&v| first[v as usize]).collect();
        at.sort_unstable();
        let twice = at.windows(2).filter(|pair| pair[0] == pair[1]);
        twice.for_each(|pair| within_face[pair[0] as usize] = true);
    }
    (0..)
        .zip(first)
        .filter(|&(v, first)| v != first && !within_face[first as usize])
        .map(|(v, first)| [v, first])
        .collect()
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
    }

    #[test]
    fn a_seam_that_would_fold_a_face_onto_itself_is_none() {
        let mut mesh = strips(0.0);
        // A triangle with two corners on each other.
        mesh.faces.push(&[3, 6, 0]);
        assert!(seams(&mesh).iter().all(|[v, _]| *v != 6));
    }
}
