//! Edges of the mesh among the settings of a build, as pairs of vertices, and their checks.

use super::settings::BuildSettings;
use crate::math::polygon_sides;
use crate::mesh::Mesh;
use std::collections::BTreeSet;

/// The ends of an edge, the smaller first: both orders name the same edge.
pub(crate) fn ordered([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl BuildSettings {
    /// Checks that each seam has two ends, and is listed once.
    pub(super) fn check_seams(&self) -> Result<(), (String, String)> {
        let mut known = BTreeSet::new();
        for (edge @ [a, b], k) in self.seams.iter().zip(0..) {
            let fault = if a == b {
                format!("found [{a}, {b}], expected the two ends of an edge")
            } else if !known.insert(ordered(*edge)) {
                format!("the edge [{a}, {b}] is listed twice, expected it once")
            } else {
                continue;
            };
            return Err((format!("seams[{k}]"), fault));
        }
        Ok(())
    }

    /// Checks that its seams are edges of a mesh: sides of its faces.
    ///
    /// # Errors
    /// The path of the first that is none, and a message.
    pub fn check_edges(&self, mesh: &Mesh) -> Result<(), (String, String)> {
        if self.seams.is_empty() {
            return Ok(());
        }
        let sides: BTreeSet<[u32; 2]> =
            mesh.faces.iter().flat_map(polygon_sides).map(ordered).collect();
        match self.seams.iter().position(|edge| !sides.contains(&ordered(*edge))) {
            Some(k) => {
                let [a, b] = self.seams[k];
                let fault = format!(
                    "found [{a}, {b}], expected the ends of an edge: no face has a side between them"
                );
                Err((format!("seams[{k}]"), fault))
            }
            None => Ok(()),
        }
    }
}
