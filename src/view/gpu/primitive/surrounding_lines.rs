//! Draws the ghost and the ground: lines between points of their own, in the picture of the stage, and
//! the surface of the ghost.

use super::faces::Faces;
use super::lines::Lines;
use crate::view::appearance::LineKind;
use crate::view::gpu::{GpuTables, VertexBuffer};
use crate::view::state::ViewState;

/// The points and lines on the GPU.
#[derive(Debug)]
pub struct SurroundingLines {
    tables: GpuTables,
    /// First those of the ghost.
    lines: VertexBuffer,
    ghosts: u32,
}

impl SurroundingLines {
    /// Nothing to draw yet; `beside` is the store of the mesh.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, beside: &GpuTables) -> SurroundingLines {
        let lines = VertexBuffer::new(device);
        SurroundingLines { tables: beside.beside(device, queue), lines, ghosts: 0 }
    }

    /// Takes what is new, for a canvas of `size` pixels.
    pub fn update(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        state: &mut ViewState,
        size: (u32, u32),
    ) {
        let changed = state.take_changed_surroundings();
        if changed {
            let lines = state.surrounding_lines();
            let is_ghost = |line: &&[u32; 3]| line[2] == LineKind::Ghost as u32;
            self.ghosts = lines.iter().filter(is_ghost).count() as u32;
            self.lines.write(device, queue, &lines);
        }
        if self.lines.count() > 0 {
            let points = changed.then(|| state.surrounding_points());
            self.tables.update_points(device, queue, state, points, size);
        }
    }

    /// Draws them; `faces` are those of the mesh, whose group is bound again then. The points of the
    /// ghost are numbered as its vertices are.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        faces: &Faces,
        lines: &Lines,
        mesh: &GpuTables,
    ) {
        if self.lines.count() > 0 {
            pass.set_bind_group(0, self.tables.group(), &[]);
            if self.ghosts > 0 {
                faces.draw_veil(pass);
            }
            lines.draw_others(pass, &self.lines, self.ghosts);
            pass.set_bind_group(0, mesh.group(), &[]);
        }
    }
}
