//! The shape with its offset and beams in space, as one file for presentations.

use crate::fabricate::build::Build;
use crate::fabricate::file::{GlbPart, glb};
use crate::math::Vec3;

/// The name of the file.
pub const PRESENTATION: &str = "model.glb";

impl Build {
    /// Writes panels, offset panels and flat beams between them as binary glTF, in metres about the
    /// centre of the bounding box. `z_up` is whether z is up in the mesh; else y is.
    pub fn presentation(&self, z_up: bool) -> Vec<u8> {
        let [mut panels, mut offset, mut beams] = [
            ("panels", [0.80, 0.81, 0.83, 1.0]),
            ("offset", [0.35, 0.20, 0.65, 0.35]),
            ("beams", [0.45, 0.30, 0.18, 1.0]),
        ]
        .map(|(name, colour)| GlbPart { name, colour, ..GlbPart::default() });
        let metres = self.unit.metres;
        let surface = &self.surface;
        let below = |v: u32| surface.at(v) * metres;
        for face in surface.faces.iter() {
            panels.add_polygon(&face.iter().map(|&v| below(v)).collect::<Vec<_>>());
        }
        if let Some((axes, _)) = &self.offset {
            let by = self.distance() * metres;
            let above = |v: u32| -> Vec3<f64> { below(v) + axes.axes[v as usize] * by };
            for face in surface.faces.iter() {
                offset.add_polygon(&face.iter().map(|&v| above(v)).collect::<Vec<_>>());
            }
            for [i, j] in surface.edges.iter().map(|edge| edge.ends) {
                beams.add_polygon(&[below(i), below(j), above(j), above(i)]);
            }
        }
        glb(&[panels, offset, beams], z_up)
    }
}
