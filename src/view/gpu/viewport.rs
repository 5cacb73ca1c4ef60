//! The GPU resources of the picture of the model: its tables, ghost, ground, layer and surface lines,
//! and the lines between its bands of values.

use super::gpu_tables::GpuTables;
use super::pipeline::VertexBuffer;
use super::placement::Placement;
use crate::view::gpu::primitive::{Faces, Lines, SurroundingLines};
use crate::view::state::ViewState;

/// The picture of the model.
#[derive(Debug)]
pub struct Viewport {
    /// The tables of the view state.
    pub tables: GpuTables,
    around: SurroundingLines,
    layer: SurroundingLines,
    over: SurroundingLines,
    bands: VertexBuffer,
}

impl Viewport {
    /// Creates an empty viewport; `like` are tables that the same pipelines read.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, like: &GpuTables) -> Viewport {
        Viewport {
            tables: like.beside(device, queue),
            around: SurroundingLines::new(device, queue, like),
            layer: SurroundingLines::new(device, queue, like),
            over: SurroundingLines::new(device, queue, like),
            bands: VertexBuffer::new(device),
        }
    }

    /// Uploads changes of the state, for a picture at `placement`; `lines` already has its mesh.
    pub fn update(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        state: &mut ViewState,
        lines: &Lines,
        placement: Placement,
    ) {
        self.tables.update(device, queue, state, placement);
        let changed = state.take_changed_surroundings();
        let new =
            changed.then(|| (state.surrounding_lines(), state.surrounding_points().collect()));
        self.around.update((device, queue), state, new, state.palette().ghost, placement);
        let changed = state.take_changed_layer();
        let new = changed.then(|| (state.layer_lines(), state.layer_points().collect()));
        self.layer.update((device, queue), state, new, state.palette().layer, placement);
        let new = state.take_changed_surface_lines();
        self.over.update((device, queue), state, new, state.palette().layer, placement);
        if state.changes().mesh || state.changes().appearance {
            self.bands.write(device, queue, &lines.between_bands(state));
        }
    }

    /// Draws the surface, its surroundings, its edges, the lines over it, and the layer beside it.
    /// Leaves the group of the tables bound.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        faces: &Faces,
        lines: &Lines,
        show_edges: bool,
    ) {
        pass.set_bind_group(0, self.tables.group(), &[]);
        faces.draw(pass);
        self.around.draw(pass, faces, lines, &self.tables);
        lines.draw(pass, show_edges);
        lines.draw_others(pass, &self.bands, 0);
        self.over.draw(pass, faces, lines, &self.tables);
        self.layer.draw(pass, faces, lines, &self.tables);
    }
}
