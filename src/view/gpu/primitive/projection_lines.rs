//! Draws projected shapes as outlines with a faint inside, and arrows: `shaders/projections.wgsl`.

use crate::view::appearance::LineKind;
use crate::view::gpu::{GpuTables, Layer, PROJECTIONS, Recipe, VertexBuffer, build};
use crate::view::model::ProjectedFaces;
use crate::view::state::{Display, ViewState};
use glam::Vec3;

const LINE: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Uint32x2, 1 => Uint32x2];
const CORNER: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Uint32x2, 1 => Float32];

/// A corner of the inside of a projected shape.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct Corner {
    point: u32,
    /// Index of its colour.
    colour: u32,
    /// Upper bound on its distance from the surface.
    beside: f32,
}

/// Lines between vertices and projected points, which are entries of the table of positions.
#[derive(Debug)]
pub struct ProjectionLines {
    lines: wgpu::RenderPipeline,
    insides: wgpu::RenderPipeline,
    /// Three corners per triangle.
    corners: VertexBuffer,
    /// The two ends of each line, its [`LineKind`], and the index of its colour.
    outlines: VertexBuffer,
    arrows: VertexBuffer,
}

impl ProjectionLines {
    /// Creates the pipelines.
    pub fn new(
        device: &wgpu::Device,
        tables: &GpuTables,
        format: wgpu::TextureFormat,
    ) -> ProjectionLines {
        let lines = Recipe {
            label: "projections",
            source: &PROJECTIONS,
            vertex: "corner_of_projection",
            fragment: "drawn",
            attributes: &LINE,
            step: wgpu::VertexStepMode::Instance,
            layer: Layer::InFront,
        };
        let insides = Recipe {
            vertex: "corner_of_inside",
            fragment: "inside",
            attributes: &CORNER,
            step: wgpu::VertexStepMode::Vertex,
            ..lines
        };
        ProjectionLines {
            lines: build(device, tables, format, &lines),
            insides: build(device, tables, format, &insides),
            corners: VertexBuffer::new(device),
            outlines: VertexBuffer::new(device),
            arrows: VertexBuffer::new(device),
        }
    }

    /// Uploads the projections; their points follow vertices and targets in the table of positions.
    pub fn update(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, state: &ViewState) {
        let first = (state.counts().0 + state.handles().len()) as u32;
        let points = &state.projections().points;
        let outlines: Vec<[u32; 4]> = state
            .projections()
            .outlines
            .iter()
            .map(|&[a, b]| {
                line([first + a, first + b], LineKind::Outline, points[a as usize].colour)
            })
            .collect();
        self.outlines.write(device, queue, &outlines);
        let places: Vec<Vec3> = state.projected().map(|point| point.truncate()).collect();
        let faces = ProjectedFaces::new(state.projections(), &places);
        let corners: Vec<Corner> = faces
            .triangles
            .iter()
            .zip(faces.beside)
            .flat_map(|(triangle, beside)| {
                triangle.map(|point| {
                    let colour = u32::from(points[point as usize].colour);
                    Corner { point: first + point, colour, beside }
                })
            })
            .collect();
        self.corners.write(device, queue, &corners);
        let arrows: Vec<[u32; 4]> = points
            .iter()
            .zip(first..)
            .map(|(point, end)| line([point.vertex, end], LineKind::Arrow, point.colour))
            .collect();
        self.arrows.write(device, queue, &arrows);
    }

    /// Draws the parts that are switched on.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, display: Display) {
        if display.outlines {
            self.corners.draw(pass, &self.insides);
            self.outlines.draw_each(pass, &self.lines, 6);
        }
        if display.arrows {
            self.arrows.draw_each(pass, &self.lines, 6);
        }
    }
}

fn line([from, to]: [u32; 2], kind: LineKind, colour: u8) -> [u32; 4] {
    [from, to, kind as u32, u32::from(colour)]
}
