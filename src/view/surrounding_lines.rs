//! Draws the ghost and the ground: lines between points of their own, in the picture of the stage.

use super::lines::Lines;
use super::pipeline::VertexBuffer;
use super::stage::Stage;
use super::store::Store;

/// The points and lines on the GPU.
#[derive(Debug)]
pub struct SurroundingLines {
    store: Store,
    lines: VertexBuffer,
}

impl SurroundingLines {
    /// Nothing to draw yet; `beside` is the store of the mesh.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, beside: &Store) -> SurroundingLines {
        SurroundingLines { store: beside.beside(device, queue), lines: VertexBuffer::new(device) }
    }

    /// Takes what is new, for a canvas of `size` pixels.
    pub fn update(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        stage: &mut Stage,
        size: (u32, u32),
    ) {
        let changed = std::mem::take(&mut stage.around.changed);
        if changed {
            self.lines.write(device, queue, &stage.surrounding_lines());
        }
        if self.lines.count() > 0 {
            let points = changed.then(|| stage.surrounding_points());
            self.store.update_points(device, queue, stage, points, size);
        }
    }

    /// Draws them; the group of the mesh is bound again then.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, lines: &Lines, mesh: &Store) {
        if self.lines.count() > 0 {
            pass.set_bind_group(0, self.store.group(), &[]);
            lines.draw_others(pass, &self.lines);
            pass.set_bind_group(0, mesh.group(), &[]);
        }
    }
}
