//! Draws fitted spheres: `shaders/spheres.wgsl`.

use crate::view::gpu::{GpuTables, Layer, Recipe, SPHERES, VertexBuffer, build};
use crate::view::state::SHAPE_NUMBERS;

const SPHERE: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32];

/// Spheres by centre and radius.
#[derive(Debug)]
pub struct Spheres {
    pipeline: wgpu::RenderPipeline,
    spheres: VertexBuffer,
}

impl Spheres {
    /// Creates the pipeline.
    pub fn new(device: &wgpu::Device, tables: &GpuTables, format: wgpu::TextureFormat) -> Spheres {
        let recipe = Recipe {
            label: "spheres",
            source: &SPHERES.concat(),
            vertex: "corner_of_sphere",
            fragment: "glass",
            attributes: &SPHERE,
            step: wgpu::VertexStepMode::Instance,
            layer: Layer::InFront,
        };
        let pipeline = build(device, tables, format, &recipe);
        Spheres { pipeline, spheres: VertexBuffer::new(device) }
    }

    /// Uploads the spheres among fitted shapes in view coordinates.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, shapes: &[f32]) {
        let spheres: Vec<[f32; 4]> = shapes
            .chunks_exact(SHAPE_NUMBERS)
            .filter(|shape| shape[0] == 1.0)
            .map(|shape| [shape[1], shape[2], shape[3], shape[7]])
            .collect();
        self.spheres.write(device, queue, &spheres);
    }

    /// Draws the spheres.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.spheres.draw_each(pass, &self.pipeline, 6);
    }
}
