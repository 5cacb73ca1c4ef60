//! Draws fitted circles: `shaders/circles.wgsl`.

use crate::view::gpu::{CIRCLES, GpuTables, Layer, Recipe, VertexBuffer, build};
use crate::view::state::SHAPE_NUMBERS;

const CIRCLE: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32];

/// Circles by centre, normal and radius.
#[derive(Debug)]
pub struct Circles {
    pipeline: wgpu::RenderPipeline,
    circles: VertexBuffer,
}

impl Circles {
    /// Creates the pipeline.
    pub fn new(device: &wgpu::Device, tables: &GpuTables, format: wgpu::TextureFormat) -> Circles {
        let recipe = Recipe {
            label: "circles",
            source: &CIRCLES.concat(),
            vertex: "corner_of_circle",
            fragment: "drawn",
            attributes: &CIRCLE,
            step: wgpu::VertexStepMode::Instance,
            layer: Layer::InFront,
        };
        let pipeline = build(device, tables, format, &recipe);
        Circles { pipeline, circles: VertexBuffer::new(device) }
    }

    /// Uploads the circles among fitted shapes in view coordinates.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, shapes: &[f32]) {
        let circles: Vec<[f32; 7]> = shapes
            .chunks_exact(SHAPE_NUMBERS)
            .filter(|shape| shape[0] == 0.0)
            .map(|shape| std::array::from_fn(|i| shape[i + 1]))
            .collect();
        self.circles.write(device, queue, &circles);
    }

    /// Draws the circles, each with `pieces` segments.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pieces: u32) {
        self.circles.draw_each(pass, &self.pipeline, 6 * pieces);
    }
}
