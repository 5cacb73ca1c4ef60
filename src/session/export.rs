//! The current state as a mesh file and as a scene.

use super::Session;
use super::state::grouped;
use crate::mesh::{Mesh, Weld, write_obj_with, write_with_ending};
use crate::scene::{MeshSource, Scene, UnitsAndUp};

impl Session {
    /// Returns the current shape as the text of an OBJ file, with its unit and axis if known.
    pub fn obj(&self) -> String {
        String::from_utf8_lossy(&self.mesh_file("obj", None)).into_owned()
    }

    /// Returns the current shape as a mesh file with this ending: `ply`, `stl`, `mesh`, else OBJ; with
    /// the vertices and faces of the file before it was welded, if it was, and with its unit and axis,
    /// if known and if the format has comments.
    pub fn mesh_file(&self, ending: &str, weld: Option<&Weld>) -> Vec<u8> {
        let shape = self.shape(weld);
        write_with_ending(ending, &shape, &shape.positions, &self.comments(&shape))
    }

    /// Returns the mesh in its current shape, with the vertices and faces of the file before it was
    /// welded, if it was.
    pub fn shape(&self, weld: Option<&Weld>) -> Mesh {
        match weld {
            None => self.current_shape(),
            Some(weld) => {
                let moved = weld.original_positions(self.rest.positions(), self.scene.positions());
                weld.original.at(&moved)
            }
        }
    }

    /// The comments of a file with this shape, of which its reader guesses what they do not say.
    fn comments(&self, shape: &Mesh) -> Vec<String> {
        let document = self.document();
        UnitsAndUp::comments(&document.units, Some(document.up), shape)
    }

    /// The current shape as OBJ with the texture coordinates `uv` of each vertex, `#V by 2`, and with
    /// its unit and axis if known.
    ///
    /// # Errors
    /// If the number of coordinates differs from that of the vertices, in words.
    pub fn obj_with_uv(&self, uv: &[[f64; 2]]) -> Result<String, String> {
        let vertices = self.rest.positions().len();
        if uv.len() != vertices {
            let found = 2 * uv.len();
            return Err(format!("{found} texture coordinates, expected {}", 2 * vertices));
        }
        let shape = self.current_shape();
        Ok(write_obj_with(&shape, &shape.positions, uv, &self.comments(&shape)))
    }

    /// Returns the scene file with the mesh inline, as text.
    pub fn scene_with_mesh(&self) -> String {
        let mut scene = self.scene();
        scene.mesh = MeshSource::default();
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
