//! Draws elements of one kind, each as some corners of triangles: fitted circles
//! (`shaders/circles.wgsl`) and spheres (`shaders/spheres.wgsl`), and the gizmo (`shaders/gizmo.wgsl`).

use crate::view::gpu::{CIRCLES, GIZMO, GpuTables, Layer, Recipe, SPHERES, VertexBuffer, build};
use crate::view::state::FittedShape;

const CIRCLE: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32];
const SPHERE: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32];
const CORNER: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x4];

/// Fitted circles, by centre, normal and radius.
pub const OF_CIRCLES: Recipe<'_> = Recipe {
    label: "circles",
    source: &CIRCLES,
    vertex: "corner_of_circle",
    fragment: "drawn",
    attributes: &CIRCLE,
    step: wgpu::VertexStepMode::Instance,
    layer: Layer::InFront,
};
/// Fitted spheres, by centre and radius.
pub const OF_SPHERES: Recipe<'_> = Recipe {
    label: "spheres",
    source: &SPHERES,
    vertex: "corner_of_sphere",
    fragment: "glass",
    attributes: &SPHERE,
    ..OF_CIRCLES
};
/// The corners of the gizmo's triangles, by place and colour.
pub const OF_GIZMO: Recipe<'_> = Recipe {
    label: "gizmo",
    source: &GIZMO,
    vertex: "corner_of_gizmo",
    attributes: &CORNER,
    step: wgpu::VertexStepMode::Vertex,
    layer: Layer::Over,
    ..OF_CIRCLES
};

/// Elements of one kind, and their pipeline.
#[derive(Debug)]
pub struct Instances {
    pipeline: wgpu::RenderPipeline,
    elements: VertexBuffer,
}

impl Instances {
    /// Creates the pipeline of a recipe, without elements.
    pub fn new(
        device: &wgpu::Device,
        tables: &GpuTables,
        format: wgpu::TextureFormat,
        recipe: &Recipe<'_>,
    ) -> Instances {
        let pipeline = build(device, tables, format, recipe);
        Instances { pipeline, elements: VertexBuffer::new(device) }
    }

    /// Uploads all elements.
    pub fn write<T: bytemuck::NoUninit>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        elements: &[T],
    ) {
        self.elements.write(device, queue, elements);
    }

    /// Draws triangles whose corners are the elements.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.elements.draw(pass, &self.pipeline);
    }

    /// Draws each element as an instance of `corners` corners of triangles.
    pub fn draw_each(&self, pass: &mut wgpu::RenderPass<'_>, corners: u32) {
        self.elements.draw_each(pass, &self.pipeline, corners);
    }
}

/// Returns the circles among fitted shapes: centre, normal, radius.
pub fn circles(shapes: &[FittedShape]) -> Vec<[f32; 7]> {
    let circle = |shape: &FittedShape| match *shape {
        FittedShape::Circle(c, n, radius) => Some([c.x, c.y, c.z, n.x, n.y, n.z, radius]),
        FittedShape::Sphere(..) => None,
    };
    shapes.iter().filter_map(circle).collect()
}

/// Returns the spheres among fitted shapes: centre, radius.
pub fn spheres(shapes: &[FittedShape]) -> Vec<[f32; 4]> {
    let sphere = |shape: &FittedShape| match *shape {
        FittedShape::Sphere(centre, radius) => Some(centre.extend(radius).to_array()),
        FittedShape::Circle(..) => None,
    };
    shapes.iter().filter_map(sphere).collect()
}
