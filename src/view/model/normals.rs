//! One normal per polygon, and a smoothed one per vertex. Panels must look like panels, so shading
//! uses mainly the polygon's normal; the vertex normal only bends it slightly across the panel.

use super::lists::Lists;
use super::triangulate::newell_normal;
use glam::Vec3;

/// Unit normals: `faces` is #F, `vertices` is #V. Zero without area, or where normals cancel.
#[derive(Clone, Debug, Default)]
pub struct Normals {
    /// One per polygon.
    pub faces: Vec<Vec3>,
    /// One per vertex, the area-weighted mean of its polygons.
    pub vertices: Vec<Vec3>,
}

impl Normals {
    /// Computes both for the given positions.
    pub fn update(&mut self, positions: &[Vec3], faces: &Lists) {
        self.faces.clear();
        self.vertices.clear();
        self.vertices.resize(positions.len(), Vec3::ZERO);
        for face in faces.iter() {
            let normal = newell_normal(positions, face);
            for &corner in face {
                self.vertices[corner as usize] += normal;
            }
            self.faces.push(normal.normalize_or_zero());
        }
        for normal in &mut self.vertices {
            *normal = normal.normalize_or_zero();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folded_pair_has_two_face_normals_and_their_mean_on_the_fold() {
        let positions =
            [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let faces = Lists::new("faces", vec![0, 3, 6], vec![0, 2, 1, 0, 1, 3], 4).unwrap();
        let mut normals = Normals::default();
        normals.update(&positions, &faces);
        assert_eq!(normals.faces, [Vec3::Z, Vec3::X]);
        assert!((normals.vertices[0] - Vec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-6);
        assert_eq!(normals.vertices[3], Vec3::X);
    }
}
