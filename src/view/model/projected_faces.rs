//! Triangles that fill projected shapes whose outlines form closed rings.

use super::projections::ProjectionMarks;
use super::triangulate::triangulate;
use glam::Vec3;

/// Triangles between projected points, which fill closed shapes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectedFaces {
    /// Three projected points each.
    pub triangles: Vec<[u32; 3]>,
    /// Largest displacement in the ring of each triangle: its maximum distance from the surface.
    pub beside: Vec<f32>,
}

impl ProjectedFaces {
    /// Fills the closed shapes of `projections`, whose points are at `places`.
    pub fn new(projections: &ProjectionMarks, places: &[Vec3]) -> ProjectedFaces {
        let mut found = ProjectedFaces::default();
        for ring in rings(&projections.outlines, places.len()) {
            let lengths =
                ring.iter().map(|&point| projections.points[point as usize].displacement.length());
            let farthest = lengths.fold(0.0, f32::max);
            triangulate(places, &ring, &mut found.triangles);
            found.beside.resize(found.triangles.len(), farthest);
        }
        found
    }
}

/// Returns the closed rings among pairs of `count` points, each once, sorted by first point.
fn rings(pairs: &[[u32; 2]], count: usize) -> Vec<Vec<u32>> {
    let mut degree = vec![0u8; count];
    let mut beside = vec![[0u32; 2]; count];
    for &[a, b] in pairs {
        for (point, other) in [(a as usize, b), (b as usize, a)] {
            if let Some(place) = beside[point].get_mut(usize::from(degree[point])) {
                *place = other;
            }
            degree[point] = degree[point].saturating_add(1);
        }
    }
    let mut seen = vec![false; count];
    let mut found = Vec::new();
    for first in 0..count as u32 {
        let mut ring = Vec::new();
        let (mut before, mut at) = (first, first);
        while !seen[at as usize] && degree[at as usize] == 2 {
            seen[at as usize] = true;
            ring.push(at);
            let [a, b] = beside[at as usize];
            (before, at) = (at, if a == before { b } else { a });
        }
        if at == first && ring.len() > 2 {
            found.push(ring);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_closed_and_does_not_branch_is_a_ring() {
        let square = [[0, 1], [0, 3], [1, 2], [2, 3]];
        assert_eq!(rings(&square, 4), [[0, 1, 2, 3]]);
        // The sides of a quad as they come, sorted by vertices rather than around the quad.
        let crossed = [[0, 2], [0, 3], [1, 2], [1, 3]];
        assert_eq!(rings(&crossed, 4), [[0, 2, 1, 3]]);
        let open = [[0, 1], [1, 2], [2, 3]];
        assert!(rings(&open, 4).is_empty());
        let star = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [1, 3]];
        assert!(rings(&star, 4).is_empty());
        let lollipop = [[0, 1], [1, 2], [2, 3], [1, 3]];
        assert!(rings(&lollipop, 4).is_empty());
        let two = [[0, 1], [1, 2], [0, 2], [3, 4], [4, 5], [3, 5]];
        assert_eq!(rings(&two, 6), [[0, 1, 2], [3, 4, 5]]);
        assert!(rings(&[[0, 1], [0, 1]], 2).is_empty());
    }

    #[test]
    fn a_square_is_filled_and_knows_how_far_it_may_lie_from_the_surface() {
        let displacements = [0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0];
        let outlines = [0, 1, 1, 2, 2, 3, 0, 3];
        let projections =
            ProjectionMarks::new(&[0, 1, 2, 3], &displacements, &[1; 4], &outlines, &[0.5; 3], 4)
                .unwrap();
        let places = [Vec3::ZERO, Vec3::X, Vec3::ONE.with_z(0.0), Vec3::Y];
        let faces = ProjectedFaces::new(&projections, &places);
        assert_eq!(faces.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(faces.beside, [2.0, 2.0]);
    }
}
