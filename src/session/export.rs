//! The current state as files: OBJ, scene.

use super::state::{Session, grouped};
use crate::mesh::{Weld, write_obj};
use crate::scene::{Scene, UnitsAndUp};

impl Session {
    /// The current shape as the text of an OBJ file, with the unit and the axis that are known.
    pub fn obj(&self) -> String {
        let comments = UnitsAndUp::comments(&self.document.units, self.document.up);
        comments + &write_obj(&self.mesh, &self.positions())
    }

    /// The same of the mesh as it came, which was welded to the mesh of this session.
    pub fn obj_as_it_came(&self, weld: &Weld) -> String {
        let comments = UnitsAndUp::comments(&self.document.units, self.document.up);
        let positions = weld.as_it_came(&self.mesh.positions, &self.positions());
        comments + &write_obj(&weld.original, &positions)
    }

    /// The scene as it stands, with current positions when they are not at rest.
    pub fn scene(&self) -> Scene {
        let mut scene = self.document.clone();
        let positions = self.positions();
        scene.current = (positions != self.mesh.positions).then_some(positions);
        scene.handles = grouped(self.solver.handles());
        scene
    }
}
