//! A change of a scene that an edit is making.

use super::part::{Part, Settings};
use super::scene_change::SceneChange;
use crate::mesh::{Mesh, Point};
use crate::scene::{Scene, SceneError};
use crate::solve::Handle;
use std::rc::Rc;

/// The document under edit, with its new handles and positions. Every change of the document is
/// recorded, so that it can be undone.
pub(crate) struct Draft<'a> {
    pub(super) document: &'a mut Scene,
    pub(super) mesh: &'a Mesh,
    pub(super) change: SceneChange,
}

impl Draft<'_> {
    pub(crate) fn document(&self) -> &Scene {
        self.document
    }

    /// The rest shape.
    pub(crate) fn mesh(&self) -> &Mesh {
        self.mesh
    }

    pub(crate) fn handles(&self) -> &[Handle] {
        &self.change.handles
    }

    /// Positions, `#V by 3`.
    pub(crate) fn positions(&self) -> &[Point] {
        &self.change.positions
    }

    pub(crate) fn shared_positions(&self) -> Rc<[Point]> {
        Rc::clone(&self.change.positions)
    }

    /// Replaces a part of the document.
    pub(crate) fn put(&mut self, mut part: Part) {
        part.exchange(self.document);
        self.change.parts.push(part);
    }

    /// Changes settings, and no other part of the document.
    ///
    /// # Errors
    /// Those of `set`, which must then have changed nothing.
    pub(crate) fn set<T>(
        &mut self,
        set: impl FnOnce(&mut Scene) -> Result<T, SceneError>,
    ) -> Result<T, SceneError> {
        let before = Settings::of(self.document);
        let done = set(self.document)?;
        self.change.parts.push(Part::Settings(before));
        Ok(done)
    }

    /// Changes settings and rows of constraints.
    ///
    /// # Errors
    /// Those of `set`, which must then have changed nothing.
    pub(crate) fn set_rows<T>(
        &mut self,
        set: impl FnOnce(&mut Scene, &Mesh) -> Result<T, SceneError>,
    ) -> Result<T, SceneError> {
        let rows = self.document.constraints.clone();
        let mesh = self.mesh;
        let done = self.set(|document| set(document, mesh))?;
        self.change.parts.push(Part::Rows(rows));
        Ok(done)
    }

    pub(crate) fn put_handles(&mut self, handles: Vec<Handle>) {
        self.change.handles = handles.into();
    }

    /// Replaces the positions, `#V by 3`.
    pub(crate) fn put_positions(&mut self, positions: Rc<[Point]>) {
        self.change.positions = positions;
    }
}
