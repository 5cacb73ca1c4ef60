//! Draws the faces, and the ghost's faces as a veil: `shaders/faces.wgsl`.

use crate::view::gpu::{FACES, GpuTables, Layer, Onto, Recipe, VertexBuffer, build_onto};
use crate::view::model::RenderMesh;

/// A corner of a triangle: its vertex and its face.
pub const CORNER_OF_FACE: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![0 => Uint32x2];

/// The faces' triangles.
#[derive(Debug)]
pub struct Faces {
    surface: wgpu::RenderPipeline,
    veil: wgpu::RenderPipeline,
    /// The vertex and the face of each corner.
    corners: VertexBuffer,
}

impl Faces {
    /// Creates the pipelines; `occlusion` is the layout of the second group.
    pub fn new(
        device: &wgpu::Device,
        tables: &GpuTables,
        occlusion: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
    ) -> Faces {
        let groups = [Some(tables.layout()), Some(occlusion)];
        let pipeline = |vertex: &str, fragment: &str, layer: Layer| {
            let recipe = Recipe {
                label: "faces",
                source: &FACES,
                vertex,
                fragment,
                attributes: &CORNER_OF_FACE,
                step: wgpu::VertexStepMode::Vertex,
                layer,
            };
            build_onto(device, &groups, Onto::Picture(format), &recipe)
        };
        Faces {
            surface: pipeline("corner_of_face", "lit", Layer::Surface),
            veil: pipeline("corner_of_veil", "veil", Layer::Veil),
            corners: VertexBuffer::new(device),
        }
    }

    /// Uploads the triangles of a mesh.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, mesh: &RenderMesh) {
        let corners: Vec<[u32; 2]> = mesh
            .triangles
            .iter()
            .zip(&mesh.triangle_face)
            .flat_map(|(triangle, &face)| triangle.map(|vertex| [vertex, face]))
            .collect();
        self.corners.write(device, queue, &corners);
    }

    /// Draws the faces; the second bind group must be that of the occlusion.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.surface);
    }

    /// Draws the faces as a veil at the points whose tables are bound.
    pub fn draw_veil(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_with(pass, &self.veil);
    }

    /// Draws the faces with a pipeline that takes [`CORNER_OF_FACE`].
    pub fn draw_with(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        self.corners.draw(pass, pipeline);
    }
}
