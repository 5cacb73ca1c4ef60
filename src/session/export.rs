//! The current state as an OBJ file and as a scene.

use super::Session;
use super::state::grouped;
use crate::mesh::{Weld, write_obj, write_obj_with_uv};
use crate::scene::{MeshSource, Scene, UnitsAndUp};

impl Session {
    /// Returns the current shape as the text of an OBJ file, with its unit and axis if known.
    pub fn obj(&self) -> String {
        self.obj_comments() + &write_obj(self.mesh(), self.scene.positions())
    }

    /// As [`Session::obj`], with the vertices and faces of the file before it was welded.
    pub fn obj_unwelded(&self, weld: &Weld) -> String {
        let positions = weld.original_positions(self.rest.positions(), self.scene.positions());
        self.obj_comments() + &write_obj(&weld.original, &positions)
    }

    fn obj_comments(&self) -> String {
        let document = self.document();
        UnitsAndUp::comments(&document.units, document.up)
    }

    /// The current shape as OBJ with the texture coordinates `uv` of each vertex, `#V by 2`.
    ///
    /// # Errors
    /// If the number of coordinates differs from that of the vertices, in words.
    pub fn obj_with_uv(&self, uv: &[[f64; 2]]) -> Result<String, String> {
        let vertices = self.rest.positions().len();
        if uv.len() != vertices {
            let found = 2 * uv.len();
            return Err(format!("{found} texture coordinates, expected {}", 2 * vertices));
        }
        Ok(write_obj_with_uv(self.mesh(), self.scene.positions(), uv))
    }

    /// Returns the scene file with the mesh inline, as text.
    pub fn scene_with_mesh(&self) -> String {
        let mut scene = self.scene();
        scene.mesh = MeshSource::Inline(Box::new(self.mesh().clone()));
        scene.to_json(self.mesh())
    }

    /// Returns the scene in its current state, with current positions if they differ from the
    /// design, or without a design from the rest positions.
    pub fn scene(&self) -> Scene {
        let mut whole = self.document().clone();
        let positions = self.scene.positions();
        let design = whole.variants.design_positions().unwrap_or(self.rest.positions());
        whole.current = (**positions != *design).then(|| positions.to_vec());
        whole.handles = grouped(self.scene.handles());
        whole
    }
}
