//! Secondary views: the two pictures of a split view, and a flat map.

use super::view_state::ViewState;
use crate::view::model::{Checks, RenderMesh};

impl ViewState {
    /// Creates a view of the same mesh, without marks, handles and values.
    pub fn beside(&self) -> ViewState {
        let mut other = ViewState::default();
        other.content.mesh = self.content.mesh.clone();
        other.around = self.around.clone();
        other.around.changed = true;
        other.look.appearance.set_in_bands(self.look.appearance.is_in_bands());
        other
    }

    /// Creates the view of a flat map from above: its mesh in the plane, its checkerboard, and the
    /// sides of the faces that it flips (`#sides by 2`).
    pub fn of_flat_map(mesh: RenderMesh, checks: Checks, flipped: Vec<[u32; 2]>) -> ViewState {
        let mut map = ViewState::default();
        (map.content.mesh, map.content.checks, map.content.flipped) = (mesh, checks, flipped);
        map.viewpoint.camera.look_from("top").expect("top is a side to look from");
        map
    }

    /// Copies positions and targets of `model`, which has the same faces.
    pub fn take_positions(&mut self, model: &ViewState) {
        let (own, other) = (&mut self.content.mesh, &model.content.mesh);
        own.exact.clone_from(&other.exact);
        own.positions.clone_from(&other.positions);
        own.normals.clone_from(&other.normals);
        self.changes.positions = true;
        self.viewpoint.forget_depth();
        self.take_targets(model);
    }

    /// Copies positions, targets and projections of `model` that have changed.
    pub fn follow_shape(&mut self, model: &ViewState) {
        if model.changes.positions {
            self.take_positions(model);
        } else if model.changes.targets {
            self.take_targets(model);
        }
        if model.changes.projections || self.content.projections != model.content.projections {
            self.content.projections.clone_from(&model.content.projections);
            self.changes.projections = true;
        }
    }

    /// Copies marks and tint of `model`, if they have changed.
    pub fn follow_marks(&mut self, model: &ViewState) {
        if model.changes.appearance {
            self.look.appearance.mark_as(&model.look.appearance);
            self.look.tint = model.look.tint;
            self.changes.appearance = true;
        }
    }

    /// Copies the camera, surroundings, theme and switches of `model`.
    pub fn follow_view(&mut self, model: &ViewState) {
        if model.around.changed {
            self.around.clone_from(&model.around);
        }
        self.viewpoint.camera.clone_from(&model.viewpoint.camera);
        let (own, other) = (&mut self.look, &model.look);
        (own.display, own.dark, own.ground) = (other.display, other.dark, other.ground);
        self.keep_reach();
        self.changes.view |= model.changes.view;
    }

    /// Requests a redraw with the marks and positions of `model`.
    pub fn redraw(&mut self) {
        self.changes.appearance = true;
        self.changes.positions = true;
    }

    fn take_targets(&mut self, model: &ViewState) {
        self.content.handles.clone_from(&model.content.handles);
        self.changes.targets = true;
    }
}
