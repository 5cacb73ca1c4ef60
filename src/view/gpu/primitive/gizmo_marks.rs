//! Draws the gizmo: `shaders/gizmo.wgsl`.

use crate::view::gizmo::triangles;
use crate::view::gpu::{GIZMO, GpuTables, Layer, Recipe, VertexBuffer, build};
use crate::view::state::ViewState;

const CORNER: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x4];

/// The triangles of the gizmo.
#[derive(Debug)]
pub struct GizmoMarks {
    pipeline: wgpu::RenderPipeline,
    corners: VertexBuffer,
}

impl GizmoMarks {
    /// Creates the pipeline.
    pub fn new(
        device: &wgpu::Device,
        tables: &GpuTables,
        format: wgpu::TextureFormat,
    ) -> GizmoMarks {
        let recipe = Recipe {
            label: "gizmo",
            source: &GIZMO.concat(),
            vertex: "corner_of_gizmo",
            fragment: "drawn",
            attributes: &CORNER,
            step: wgpu::VertexStepMode::Vertex,
            layer: Layer::Over,
        };
        GizmoMarks {
            pipeline: build(device, tables, format, &recipe),
            corners: VertexBuffer::new(device),
        }
    }

    /// Uploads the gizmo at its current screen position.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let gizmo = state.gizmo();
        let corners = gizmo.map(|gizmo| triangles(&gizmo, state.gizmo_state(), state.palette()));
        self.corners.write(device, queue, &corners.unwrap_or_default());
    }

    /// Draws the gizmo.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.corners.draw(pass, &self.pipeline);
    }
}
