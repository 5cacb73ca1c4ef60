//! The current state as a mesh file and as a scene.

use super::Session;
use super::state::grouped;
use crate::mesh::{Mesh, Weld, write_medit, write_obj, write_obj_with_uv, write_ply, write_stl};
use crate::scene::{MeshSource, Scene, UnitsAndUp};

impl Session {
    /// Returns the current shape as the text of an OBJ file, with its unit and axis if known.
    pub fn obj(&self) -> String {
        self.obj_comments() + &write_obj(self.mesh(), self.scene.positions())
    }

    /// Returns the current shape as a mesh file with this ending: `ply`, `stl`, `mesh`, else OBJ; with
    /// the vertices and faces of the file before it was welded, if it was.
    pub fn mesh_file(&self, ending: &str, weld: Option<&Weld>) -> Vec<u8> {
        let moved =
            |weld: &Weld| weld.original_positions(self.rest.positions(), self.scene.positions());
        let positions = weld.map_or_else(|| self.scene.positions().to_vec(), moved);
        let mesh = weld.map_or(self.mesh(), |weld| &weld.original);
        match ending.to_ascii_lowercase().as_str() {
            "ply" => write_ply(mesh, &positions, &self.comments_of_header()),
            "stl" => write_stl(mesh, &positions),
            "mesh" => write_medit(&Mesh { positions, ..mesh.clone() }).into_bytes(),
            _ => (self.obj_comments() + &write_obj(mesh, &positions)).into_bytes(),
        }
    }

    /// The same as [`UnitsAndUp::comments`], without the signs of OBJ.
    fn comments_of_header(&self) -> Vec<String> {
        let comments = self.obj_comments();
        comments.lines().map(|line| line.trim_start_matches("# ").to_owned()).collect()
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
