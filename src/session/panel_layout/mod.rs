//! New panels along the lines of curvature of the surface: laid out on a copy, shown, and taken in
//! place of the mesh.
//!
//! | file | holds |
//! |---|---|
//! | `settings` | what is wished of them |
//! | `layouts` | panels laid out, with all that another wish can use again |
//! | `layout` | one layout: its forecast, its words, its lines |

mod layout;
mod layouts;
mod settings;

pub use layout::{LayoutWords, PanelLayout};
pub use layouts::PanelLayouts;
pub use settings::LayoutSettings;

use super::Session;
use super::edit::check_lock;
use crate::mesh::{Edited, Mesh};
use crate::quads::RemeshObserver;
use crate::scene::{Lock, SceneError};
use crate::session::Error;
use crate::words;

impl Session {
    /// Begins to lay out panels along the lines of curvature of the current shape.
    ///
    /// # Errors
    /// If the mesh is no surface.
    pub fn panel_layouts(&self) -> Result<PanelLayouts, Error> {
        if !self.mesh().tets.is_empty() {
            let message = "the mesh has tetrahedra, expected a surface".to_owned();
            return Err(SceneError { path: String::new(), message }.into());
        }
        Ok(PanelLayouts::new(self.current_mesh(), &self.document().units)?)
    }

    /// Lays out panels once; see [`PanelLayouts::lay_out`].
    ///
    /// # Errors
    /// If panels of this size cannot cover the surface, or if `observer` cancels.
    pub fn lay_out_panels(
        &self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<PanelLayout, Error> {
        Ok(self.panel_layouts()?.lay_out(settings, observer)?)
    }

    /// Puts panels in place of the mesh, as one step of undo, if the session still has this
    /// generation; returns whether it has. The scene is carried over.
    ///
    /// # Errors
    /// If the lesson locks the mesh, or the system would be singular; nothing has changed then.
    pub fn take_panels(&mut self, generation: u32, panels: &Mesh) -> Result<bool, Error> {
        if self.is_dragging() || generation != self.generation() {
            return Ok(false);
        }
        check_lock(Lock::Mesh, self.document())?;
        self.end_transaction();
        let edited = Edited::covering(&self.current_mesh(), panels);
        let change = self.replace_mesh(&edited)?;
        let count = words::count(panels.faces.len(), "panel", "panels");
        self.history.push(format!("Lay out {count}"), change);
        Ok(true)
    }

    /// The mesh at its current positions.
    fn current_mesh(&self) -> Mesh {
        Mesh { positions: self.positions(), ..self.mesh().clone() }
    }
}
