//! New panels along the lines of curvature of the surface: laid out on a copy, shown, and taken in
//! place of the mesh.
//!
//! | file | holds |
//! |---|---|
//! | `settings` | what is wished of them |
//! | `layouts` | panels laid out, with all that another wish can use again |
//! | `layout` | one layout: its forecast, its words, its lines |
//! | `places` | places that are named, to be shown |

mod layout;
mod layouts;
mod places;
mod settings;

pub use layout::{BoundaryForecast, LayoutNote, PanelLayout};
pub use layouts::PanelLayouts;
pub use places::MarkedPlace;
pub use settings::LayoutSettings;

use super::Session;
use super::edit::check_lock;
use crate::mesh::{Edited, Mesh};
use crate::scene::{Lock, SceneError};
use crate::session::Error;
use crate::words;
use std::rc::Rc;

impl Session {
    /// Begins to lay out panels along the lines of curvature of the current shape, beside the faces
    /// `kept`, which stay as they are.
    ///
    /// # Errors
    /// If there is no face of this number.
    pub fn panel_layouts(&self, kept: &[u32]) -> Result<PanelLayouts, Error> {
        let faces = self.mesh().faces.len();
        if let Some(face) = kept.iter().find(|face| **face as usize >= faces) {
            let message = format!("there is no face {face}, expected less than {faces}");
            return Err(SceneError { path: String::new(), message }.into());
        }
        Ok(PanelLayouts::new(self.current_shape(), &self.document().units, kept))
    }

    /// Puts panels in place of the mesh, as one step of undo, if the session still has this
    /// generation; returns whether it has. The scene is carried over, with closeness to the surface
    /// to which the mesh was kept close before; faces that are left out are no part of that.
    ///
    /// # Errors
    /// If the lesson locks the mesh, or the system would be singular; nothing has changed then.
    pub fn take_panels(&mut self, generation: u32, panels: &Mesh) -> Result<bool, Error> {
        if !self.is_at(generation) {
            return Ok(false);
        }
        check_lock(Lock::Mesh, self.document())?;
        self.end_transaction();
        let shape = self.current_shape();
        // Faces that stay as they are have not been laid out.
        let staying: Vec<u32> = panels.same_faces(&shape).into_iter().flatten().collect();
        let new = panels.faces.len() - staying.len();
        let edited = Edited::covering(&shape, panels);
        let mut original = self.mesh().without_faces(&shape.faces_left_out(&staying));
        if let Some(design) = self.document().variants.design_positions() {
            original.positions = design.to_vec();
        }
        let original = Rc::new(original);
        let before = self.replace_mesh(&edited, |scene| scene.closeness.stay_on(&original))?;
        self.add_step(format!("Lay out {}", words::count(new, "panel", "panels")), before);
        Ok(true)
    }
}
