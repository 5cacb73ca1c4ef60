//! An example: its texts, and the function that makes its scene and its mesh.

use crate::mesh::Mesh;
use crate::scene::{MeshSource, Scene};

/// A scene to start from.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The name of its files without their endings; that of a figure begins with its number.
    pub id: &'static str,
    /// Shown as the name of the model.
    pub title: &'static str,
    /// A hint of what to look for, in one sentence.
    pub summary: &'static str,
    /// The result when it is solved with its own settings, in one sentence; tests check it.
    pub statement: &'static str,
    /// How the name of its mesh file ends: `obj`, or `mesh` (Medit) where there are tetrahedra.
    pub(super) ending: &'static str,
    pub(super) make: fn(&mut Scene) -> Mesh,
}

impl Example {
    /// The name of its scene file.
    pub fn file(&self) -> String {
        format!("{}.shapeup.json", self.id)
    }

    /// The name of its mesh file, beside the scene.
    pub fn mesh_file(&self) -> String {
        format!("{}.{}", self.id, self.ending)
    }

    /// The scene, which names its mesh as a file beside it, and that mesh.
    pub fn build(&self) -> (Scene, Mesh) {
        let mut scene = Scene::new(MeshSource::File(self.mesh_file()));
        scene.title = self.title.to_owned();
        scene.units = "m".to_owned();
        let mesh = (self.make)(&mut scene);
        (scene, mesh)
    }
}
