//! Draws ghost and ground, or the layer beside the surface, or the lines over it: lines between
//! points of their own, and the surface of ghost or layer.

use super::faces::Faces;
use super::lines::Lines;
use crate::view::appearance::{Colour, LineKind};
use crate::view::gpu::{GpuTables, Placement, VertexBuffer};
use crate::view::state::ViewState;
use glam::Vec3;

/// Kinds of lines that the surface hides.
const HIDDEN: [LineKind; 3] = [LineKind::Ground, LineKind::Larger, LineKind::Smaller];

/// The points and lines on the GPU.
#[derive(Debug)]
pub struct SurroundingLines {
    tables: GpuTables,
    /// Lines that show through the surface come first.
    lines: VertexBuffer,
    through: u32,
}

impl SurroundingLines {
    /// Creates empty buffers; `beside` are the tables of the mesh.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, beside: &GpuTables) -> SurroundingLines {
        let lines = VertexBuffer::new(device);
        SurroundingLines { tables: beside.beside(device, queue), lines, through: 0 }
    }

    /// Uploads lines, those that show through the surface first, and points, if they are new.
    pub fn update(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        state: &ViewState,
        new: Option<(Vec<[u32; 3]>, Vec<Vec3>)>,
        veil: Colour,
        placement: Placement,
    ) {
        let points = new.map(|(lines, points)| {
            let is_through = |line: &&[u32; 3]| !HIDDEN.iter().any(|&kind| kind as u32 == line[2]);
            self.through = lines.iter().filter(is_through).count() as u32;
            self.lines.write(device, queue, &lines);
            points
        });
        if self.lines.count() > 0 {
            self.tables.update_points(device, queue, state, points, veil, placement);
        }
    }

    /// Draws them. `faces` are those of the mesh, because the points of ghost and layer have the
    /// indices of its vertices. The group of `mesh` is bound again afterwards.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        faces: &Faces,
        lines: &Lines,
        mesh: &GpuTables,
    ) {
        if self.lines.count() > 0 {
            pass.set_bind_group(0, self.tables.group(), &[]);
            if self.through > 0 {
                faces.draw_veil(pass);
            }
            lines.draw_others(pass, &self.lines, self.through);
            pass.set_bind_group(0, mesh.group(), &[]);
        }
    }
}
