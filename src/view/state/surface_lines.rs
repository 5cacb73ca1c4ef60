//! The lines over the surface of a view.

use super::view_state::ViewState;
use crate::view::appearance::{Colour, DARK, LineKind};
use crate::view::overlay::SurfaceLines;
use glam::Vec3;

impl ViewState {
    /// Shows lines over the surface instead of those before.
    pub fn set_surface_lines(&mut self, lines: SurfaceLines) {
        self.lines = lines;
        self.view_changed();
    }

    /// The colour of lines over the surface: light ones on the full map of values, most of which are dark.
    pub fn colour_over_surface(&self, kind: LineKind) -> Colour {
        let palette = if self.appearance().has_full_map() { &DARK } else { self.palette() };
        palette.strokes[kind as usize].colour
    }

    /// The lines, with their points relative to the view's centre, where they have changed since this was last asked.
    pub fn take_changed_surface_lines(&mut self) -> Option<(Vec<[u32; 3]>, Vec<Vec3>)> {
        if !std::mem::take(&mut self.lines.changed) {
            return None;
        }
        let points = self.lines.points.iter().map(|&point| self.content.mesh.relative(point));
        Some((self.lines.lines.clone(), points.collect()))
    }
}
