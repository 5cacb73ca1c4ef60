//! An example: its texts, and the function that makes its scene and its mesh.

use crate::mesh::Mesh;
use crate::scene::{MeshSource, Scene};

/// A scene to start from.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The name of its files without their extensions; begins with the number of the figure, if
    /// any.
    pub id: &'static str,
    /// The name of the model, as shown.
    pub title: &'static str,
    /// A hint of what to look for, in one sentence.
    pub summary: &'static str,
    /// The result of solving it with its own settings, in one sentence; tests check it.
    pub statement: &'static str,
    pub(super) make: fn(&mut Scene) -> Mesh,
}

impl Example {
    /// The name of its scene file.
    pub fn file(&self) -> String {
        format!("{}.shapeup.json", self.id)
    }

    /// The name of its mesh file, in the same folder: OBJ, or Medit for tetrahedra, which its own name says.
    pub fn mesh_file(&self) -> String {
        format!("{}.{}", self.id, if self.id.ends_with("-tets") { "mesh" } else { "obj" })
    }

    /// The scene, which refers to its mesh file by name, and the mesh.
    pub fn build(&self) -> (Scene, Mesh) {
        let mut scene = Scene::new(MeshSource::File(self.mesh_file()));
        scene.title = self.title.to_owned();
        scene.units = "m".to_owned();
        let mesh = (self.make)(&mut scene);
        (scene, mesh)
    }
}
