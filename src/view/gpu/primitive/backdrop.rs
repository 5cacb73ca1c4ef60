//! Draws the background: `shaders/backdrop.wgsl`.

use crate::view::gpu::{BACKDROP, GpuTables, Layer, Recipe, VertexBuffer, build};
use crate::view::overlay::GroundShadow;

const CORNER: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![0 => Float32x2];
const CELL: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x4, 1 => Unorm8x4];
/// One triangle that covers the picture.
const PICTURE: [[f32; 2]; 3] = [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]];

/// The gradient and the shadow.
#[derive(Debug)]
pub struct Backdrop {
    gradient: wgpu::RenderPipeline,
    shadow: wgpu::RenderPipeline,
    picture: VertexBuffer,
    cells: VertexBuffer,
}

/// A cell as the shader reads it.
#[derive(Clone, Copy, bytemuck::NoUninit)]
#[repr(C)]
struct Cell {
    /// Its corner, and its side length.
    place: [f32; 4],
    dark: [u8; 4],
}

impl Backdrop {
    /// Creates the pipelines, without a shadow.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        tables: &GpuTables,
        format: wgpu::TextureFormat,
    ) -> Backdrop {
        let recipe = Recipe {
            label: "backdrop",
            source: &BACKDROP,
            vertex: "corner_of_picture",
            fragment: "gradient",
            attributes: &CORNER,
            step: wgpu::VertexStepMode::Vertex,
            layer: Layer::Over,
        };
        let gradient = build(device, tables, format, &recipe);
        let recipe = Recipe {
            label: "shadow",
            vertex: "corner_of_cell",
            fragment: "shadow",
            attributes: &CELL,
            step: wgpu::VertexStepMode::Instance,
            ..recipe
        };
        let shadow = build(device, tables, format, &recipe);
        let mut picture = VertexBuffer::new(device);
        picture.write(device, queue, &PICTURE);
        Backdrop { gradient, shadow, picture, cells: VertexBuffer::new(device) }
    }

    /// Uploads the shadow of the mesh.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, shadow: &GroundShadow) {
        let cells: Vec<Cell> = shadow
            .cells()
            .map(|(corner, dark)| Cell {
                place: corner.extend(shadow.side).to_array(),
                dark: dark.map(|part| (255.0 * part).round() as u8),
            })
            .collect();
        self.cells.write(device, queue, &cells);
    }

    /// Draws the gradient and the shadow.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.picture.draw(pass, &self.gradient);
        self.cells.draw_each(pass, &self.shadow, 6);
    }
}
