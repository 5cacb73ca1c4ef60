//! The gizmo of a view, and dragging with or without it.

use super::ViewState;
use crate::view::gizmo::{DragConstraint, DragDirection, Gizmo, GizmoState};
use crate::view::model::{ViewError, check_indices};
use glam::{DVec3, Vec2, Vec3};

impl ViewState {
    /// Returns the gizmo, at the mean target of the selected handles; none if it is switched off or
    /// no handle is selected.
    pub fn gizmo(&self) -> Option<Gizmo> {
        let middle = self.gizmo.shown.then(|| self.middle_of_chosen())??;
        Gizmo::new(&self.viewpoint.camera, middle, self.gizmo.touch)
    }

    /// Returns the switches of the gizmo, and what the pointer holds.
    pub fn gizmo_state(&self) -> &GizmoState {
        &self.gizmo
    }

    /// Returns the canvas position of what is held after a displacement `by`, in CSS pixels; none
    /// if nothing is held.
    pub fn held_place(&self, by: Vec3) -> Option<Vec2> {
        Some(self.gizmo.drag?.place(by))
    }

    /// Changes the state of the gizmo, and requests a redraw if the change is visible.
    pub fn want_gizmo(&mut self, change: impl FnOnce(&mut GizmoState)) {
        let look =
            |wanted: &GizmoState| (wanted.shown, wanted.touch, wanted.highlighted, wanted.held);
        let before = look(&self.gizmo);
        change(&mut self.gizmo);
        self.changes.view |= look(&self.gizmo) != before;
    }

    /// Begins to hold a vertex, with the pointer at a screen position or, if `None`, exactly on it.
    ///
    /// # Errors
    /// A vertex that does not exist.
    pub fn hold_vertex(&mut self, vertex: u32, from: Option<Vec2>) -> Result<(), ViewError> {
        check_indices("held vertex", &[vertex], self.counts().0)?;
        let held = self.content.mesh.positions[vertex as usize];
        let from = from.unwrap_or_else(|| self.viewpoint.camera.eye().project(held).0);
        self.gizmo.drag = Some(DragConstraint::new(&self.viewpoint.camera, held, from));
        Ok(())
    }

    /// Begins to hold the gizmo, if there is one, with the pointer at a screen position.
    pub fn hold_gizmo(&mut self, from: Vec2) {
        self.gizmo.drag = self
            .middle_of_chosen()
            .map(|held| DragConstraint::new(&self.viewpoint.camera, held, from));
    }

    /// Returns the displacement of what is held if the pointer moves by `by` CSS pixels; see
    /// [`DragConstraint::displacement`].
    pub fn constrain_move(&self, direction: DragDirection, by: Vec2) -> Option<Vec3> {
        self.gizmo.drag?.displacement(direction, by)
    }

    /// Returns the mean target of the selected handles, relative to the view's centre.
    fn middle_of_chosen(&self) -> Option<Vec3> {
        let appearance = &self.look.appearance;
        if appearance.selected_vertices.is_empty() {
            return None;
        }
        let handles = self.content.handles.iter();
        let chosen = handles.filter(|handle| appearance.is_selected(handle.vertex));
        let targets: Vec<DVec3> = chosen.map(|handle| handle.target).collect();
        let sum: DVec3 = targets.iter().sum();
        (!targets.is_empty()).then(|| self.content.mesh.relative(sum / targets.len() as f64))
    }
}
