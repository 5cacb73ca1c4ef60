//! The layer beside the surface of a view, and the lines over the surface.

use super::ViewState;
use crate::view::appearance::{Colour, DARK, LineKind};
use crate::view::model::{ViewError, check_indices, check_length, read_points};
use crate::view::overlay::{ShownLayer, SurfaceLines};
use glam::Vec3;

impl ViewState {
    /// Shows a layer: #V by 3 points in file coordinates, or none to hide it; with the edges (two
    /// vertices each) that fail, and the vertices whose posts fail.
    ///
    /// # Errors
    /// A wrong number of vertices, a coordinate that is not finite, or an unknown vertex; the old
    /// layer stays.
    pub fn set_layer(
        &mut self,
        coordinates: &[f64],
        failed_edges: &[u32],
        failed_vertices: Vec<u32>,
    ) -> Result<(), ViewError> {
        let count = self.content.mesh.exact.len();
        if !coordinates.is_empty() {
            check_length("points of the layer", coordinates.len(), 3 * count)?;
        }
        let pairs = failed_edges.len().next_multiple_of(2);
        check_length("edges of the layer", failed_edges.len(), pairs)?;
        let (ends, _) = failed_edges.as_chunks::<2>();
        check_indices("edges of the layer", failed_edges, count)?;
        check_indices("vertices of the layer", &failed_vertices, count)?;
        let points = read_points(coordinates)?;
        self.layer = ShownLayer { points, failed_edges: ends.to_vec(), failed_vertices };
        self.changes.layer = true;
        self.keep_reach();
        self.view_changed();
        Ok(())
    }

    /// Returns the points of the layer relative to the view's centre, then those of the surface.
    pub fn layer_points(&self) -> impl Iterator<Item = Vec3> + '_ {
        let points = &self.layer.points;
        let below = self.content.mesh.positions.iter().take(points.len());
        points.iter().map(|&point| self.content.mesh.relative(point)).chain(below.copied())
    }

    /// Returns the lines of the layer: their ends among [`ViewState::layer_points`], and their
    /// [`LineKind`]. Failing lines come last, to be drawn over the others.
    pub fn layer_lines(&self) -> Vec<[u32; 3]> {
        let count = self.layer.points.len() as u32;
        if count == 0 {
            return Vec::new();
        }
        let post = |v: u32, kind: LineKind| [v, count + v, kind as u32];
        let mut is_used = vec![false; count as usize];
        let mut lines = Vec::new();
        for edge in &self.content.mesh.edges {
            let [a, b] = edge.ends;
            lines.push([a, b, LineKind::Layer as u32]);
            is_used[a as usize] = true;
            is_used[b as usize] = true;
        }
        let used = (0..count).filter(|&v| is_used[v as usize]);
        lines.extend(used.map(|v| post(v, LineKind::Layer)));
        for &[a, b] in &self.layer.failed_edges {
            let kind = LineKind::Failed as u32;
            lines.extend([[a, b, kind], [count + a, count + b, kind]]);
            lines.extend([a, b].map(|v| post(v, LineKind::Failed)));
        }
        let failed = self.layer.failed_vertices.iter();
        lines.extend(failed.map(|&v| post(v, LineKind::Failed)));
        lines
    }

    /// Replaces the lines over the surface.
    pub fn set_surface_lines(&mut self, lines: SurfaceLines) {
        self.lines = lines;
        self.changes.lines = true;
        self.view_changed();
    }

    /// Returns the colour of lines over the surface: light on a full map, which is mostly dark.
    pub fn colour_over_surface(&self, kind: LineKind) -> Colour {
        let palette = if self.appearance().has_full_map() { &DARK } else { self.palette() };
        palette.strokes[kind as usize].colour
    }

    /// Returns the lines over the surface, and their points relative to the view's centre.
    pub fn surface_lines(&self) -> (Vec<[u32; 3]>, Vec<Vec3>) {
        let points = self.lines.points.iter().map(|&point| self.content.mesh.relative(point));
        (self.lines.lines.clone(), points.collect())
    }
}
