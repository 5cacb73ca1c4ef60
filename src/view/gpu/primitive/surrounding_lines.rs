//! Draws ghost and ground, or the layer beside the surface, or lines over it: lines between points of their own, in
//! the picture of the stage, and the surface of ghost or layer.

use super::faces::Faces;
use super::lines::Lines;
use crate::view::appearance::{Colour, LineKind};
use crate::view::gpu::{GpuTables, Placement, VertexBuffer};
use crate::view::state::ViewState;
use glam::Vec3;

/// Lines that the surface hides.
const HIDDEN: [LineKind; 3] = [LineKind::Ground, LineKind::Larger, LineKind::Smaller];

/// The points and lines on the GPU.
#[derive(Debug)]
pub struct SurroundingLines {
    tables: GpuTables,
    /// First those that are seen through the surface.
    lines: VertexBuffer,
    through: u32,
}

impl SurroundingLines {
    /// Nothing to draw yet; `beside` is the store of the mesh.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, beside: &GpuTables) -> SurroundingLines {
        let lines = VertexBuffer::new(device);
        SurroundingLines { tables: beside.beside(device, queue), lines, through: 0 }
    }

    /// Takes lines, of which those that are seen through the surface are first, and points, where they are new;
    /// for a picture that lies so on the canvas.
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

    /// Draws them; `faces` are those of the mesh, whose group is bound again then. The points of ghost and layer
    /// are numbered as its vertices are.
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
