//! Draws the faces: `shaders/faces.wgsl`.

use super::pipeline::{Layer, Recipe, VertexBuffer, build};
use super::shaders::FACES;
use super::store::Store;
use super::subject::Subject;

const CORNER: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![0 => Uint32x2];

/// The faces' triangles.
#[derive(Debug)]
pub struct Faces {
    pipeline: wgpu::RenderPipeline,
    /// Per corner its vertex and its face.
    corners: VertexBuffer,
}

impl Faces {
    /// Nothing to draw yet.
    pub fn new(device: &wgpu::Device, store: &Store, format: wgpu::TextureFormat) -> Faces {
        let recipe = Recipe {
            label: "faces",
            source: &FACES.concat(),
            vertex: "corner_of_face",
            fragment: "lit",
            attributes: &CORNER,
            stride: 8,
            step: wgpu::VertexStepMode::Vertex,
            layer: Layer::Surface,
        };
        let pipeline = build(device, store, format, &recipe);
        Faces { pipeline, corners: VertexBuffer::new(device) }
    }

    /// Takes the triangles of a mesh.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, subject: &Subject) {
        let corners: Vec<[u32; 2]> = subject
            .triangles
            .iter()
            .zip(&subject.triangle_face)
            .flat_map(|(triangle, &face)| triangle.map(|vertex| [vertex, face]))
            .collect();
        self.corners.write(device, queue, &corners);
    }

    /// Draws them.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if self.corners.count() > 0 {
            pass.set_pipeline(&self.pipeline);
            pass.set_vertex_buffer(0, self.corners.slice());
            pass.draw(0..self.corners.count(), 0..1);
        }
    }
}
