//! Intersection of rays with the surface, by the ray-triangle test of Moller and Trumbore (1997).

use crate::view::model::RenderMesh;
use glam::Vec3;

/// Triangles are enlarged by this fraction, so that no ray slips between two of them.
const SEAM: f32 = 1e-5;

/// A point on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The intersected face.
    pub face: u32,
    /// Distance along the ray, in units of the direction's length.
    pub along: f32,
}

/// Returns the first intersection of a ray with the surface for which `is_there` is true.
pub fn first_hit(
    mesh: &RenderMesh,
    from: Vec3,
    direction: Vec3,
    is_there: impl Fn(Vec3) -> bool,
) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (triangle, &face) in mesh.triangles.iter().zip(&mesh.triangle_face) {
        let corners = triangle.map(|v| mesh.positions[v as usize]);
        if let Some(along) = meet(corners, from, direction)
            && nearest.is_none_or(|hit| along < hit.along)
            && is_there(from + direction * along)
        {
            nearest = Some(Hit { face, along });
        }
    }
    nearest
}

/// Returns the place of the first of the `triangles` that hides a vertex from an eye, if any. Triangles
/// at the vertex do not count, nor does anything nearer to it than `tolerance` (units of length), so
/// that corners on the outline and coincident vertices stay visible; nor do points for which
/// `is_there` is false.
pub fn hider(
    mesh: &RenderMesh,
    triangles: &[[u32; 3]],
    eye: Vec3,
    vertex: u32,
    tolerance: f32,
    is_there: impl Fn(Vec3) -> bool,
) -> Option<usize> {
    let to_vertex = mesh.positions[vertex as usize] - eye;
    let limit = 1.0 - tolerance / to_vertex.length().max(f32::MIN_POSITIVE);
    triangles.iter().position(|triangle| {
        !triangle.contains(&vertex)
            && meet(triangle.map(|v| mesh.positions[v as usize]), eye, to_vertex)
                .is_some_and(|along| along < limit && is_there(eye + to_vertex * along))
    })
}

/// Returns the distance to a triangle, from either side, in units of the direction's length.
fn meet([a, b, c]: [Vec3; 3], from: Vec3, direction: Vec3) -> Option<f32> {
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let volume = ab.dot(p);
    if volume == 0.0 {
        return None;
    }
    let to_eye = from - a;
    let u = to_eye.dot(p) / volume;
    if !(-SEAM..=1.0 + SEAM).contains(&u) {
        return None;
    }
    let q = to_eye.cross(ab);
    let v = direction.dot(q) / volume;
    if v < -SEAM || u + v > 1.0 + SEAM {
        return None;
    }
    let along = ac.dot(q) / volume;
    (along > 0.0).then_some(along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Ragged;
    use crate::view::model::rows;

    /// Two unit squares, at z = 0 and z = 1.
    fn two_floors() -> RenderMesh {
        let mut coordinates = Vec::new();
        for z in [0.0, 1.0] {
            for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                coordinates.extend([x, y, z]);
            }
        }
        let faces = rows("faces", vec![0, 4, 8], (0..8).collect(), 8).unwrap();
        RenderMesh::new(faces, Ragged::new(), &coordinates).unwrap()
    }

    #[test]
    fn the_nearer_floor_is_met_from_either_side() {
        let mesh = two_floors();
        let above = Vec3::new(0.1, 0.2, 3.0);
        let hit = first_hit(&mesh, above, Vec3::NEG_Z * 2.0, |_| true).unwrap();
        assert_eq!(hit.face, 1);
        assert!((hit.along - 1.25).abs() < 1e-6);
        // If the upper one is cut away, the lower one is hit.
        let below = |point: Vec3| point.z < 0.0;
        assert_eq!(first_hit(&mesh, above, Vec3::NEG_Z, below).unwrap().face, 0);
        let first = |from: Vec3, way: Vec3| first_hit(&mesh, from, way, |_| true);
        assert_eq!(first(-above, Vec3::Z).unwrap().face, 0);
        assert_eq!(first(above, Vec3::Z), None);
        assert_eq!(first(Vec3::new(2.0, 0.0, 3.0), Vec3::NEG_Z), None);
    }

    #[test]
    fn the_upper_floor_hides_the_lower_one_only() {
        let mesh = two_floors();
        let hidden = |eye: Vec3, vertex: u32, is_there: fn(Vec3) -> bool| {
            hider(&mesh, &mesh.triangles, eye, vertex, 1e-3, is_there).is_some()
        };
        // The origin of the view is the centre of the box: the floors lie at -0.5 and 0.5.
        let eye = Vec3::new(0.0, 0.0, 4.0);
        for vertex in 0..8 {
            assert_eq!(hidden(eye, vertex, |_| true), vertex < 4, "{vertex}");
            assert!(!hidden(eye, vertex, |point| point.z < 0.0));
        }
        let far_aside = Vec3::new(40.0, 0.0, 0.1);
        assert!((0..8).all(|v| !hidden(far_aside, v, |_| true)));
    }
}
