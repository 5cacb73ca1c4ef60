//! Turns a stage into a picture: brings the GPU's data up to date, then draws the primitives in
//! their order.

use super::device::{Device, DeviceError};
use super::gpu_tables::GpuTables;
use super::viewport::Viewport;
use crate::view::gpu::primitive::{
    Backdrop, Circles, Faces, GizmoMarks, Lines, Points, ProjectionLines, Spheres,
};
use crate::view::overlay::GroundShadow;
use crate::view::side_by_side::{Region, Split};
use crate::view::state::ViewState;
use glam::Vec2;

/// All GPU objects of a view.
#[derive(Debug)]
pub struct Renderer {
    /// Device and canvas.
    pub device: Device,
    /// Of the stage itself.
    whole: Viewport,
    /// Of the stage of the flat map.
    map_store: GpuTables,
    /// Of the two sides of a split picture.
    sides: Option<[Viewport; 2]>,
    backdrop: Backdrop,
    faces: Faces,
    lines: Lines,
    projections: ProjectionLines,
    points: Points,
    circles: Circles,
    spheres: Spheres,
    gizmo: GizmoMarks,
}

impl Renderer {
    /// Builds the pipelines.
    pub fn new(device: Device) -> Renderer {
        let (gpu, format) = (&device.device, device.format());
        let tables = GpuTables::new(gpu, &device.queue);
        Renderer {
            backdrop: Backdrop::new(gpu, &device.queue, &tables, format),
            faces: Faces::new(gpu, &tables, format),
            lines: Lines::new(gpu, &tables, format),
            projections: ProjectionLines::new(gpu, &tables, format),
            points: Points::new(gpu, &tables, format),
            circles: Circles::new(gpu, &tables, format),
            spheres: Spheres::new(gpu, &tables, format),
            gizmo: GizmoMarks::new(gpu, &tables, format),
            whole: Viewport::new(gpu, &device.queue, &tables),
            map_store: tables.beside(gpu, &device.queue),
            sides: None,
            device,
        }
    }

    /// Draws the stage, and beside it its flat map if there is one, or else the two sides of a split
    /// picture in its place, if anything has changed; returns whether it did. `ratio` is pixels per CSS pixel.
    ///
    /// # Errors
    /// The device is lost; a new picture on a new canvas is needed.
    pub fn draw(
        &mut self,
        state: &mut ViewState,
        mut map: Option<&mut ViewState>,
        split: Option<&mut Split>,
        ratio: f32,
    ) -> Result<bool, DeviceError> {
        let split = split.filter(|_| map.is_none());
        let is_new = state.changes().any()
            || map.as_ref().is_some_and(|map| map.changes().any())
            || split.as_ref().is_some_and(|split| split.has_changes());
        if !is_new {
            return Ok(false);
        }
        let Some(frame) = self.device.frame()? else { return Ok(false) };
        let canvas = self.device.size();
        let parts = map.as_ref().map(|_| {
            let css = Vec2::new(canvas.0 as f32, canvas.1 as f32) / ratio;
            Region::halves(css).map(|part| pixels(part, ratio, canvas))
        });
        self.update(state, parts.map_or(canvas, |[[.., width, height], _]| (width, height)));
        state.take_changes();
        if let (Some(map), Some([_, [.., width, height]])) = (&mut map, parts) {
            let (device, queue) = (&self.device.device, &self.device.queue);
            self.map_store.update(device, queue, map, (width, height));
            if map.changes().mesh || map.changes().marks {
                self.lines.update_map(device, queue, map);
            }
            map.take_changes();
        }
        let sides = split.map(|split| self.update_sides(split, canvas, ratio));
        let label = wgpu::CommandEncoderDescriptor { label: Some("picture") };
        let mut encoder = self.device.device.create_command_encoder(&label);
        let mut pass = self.device.pass(&mut encoder, &frame, state.background());
        if let Some([part, _]) = parts {
            confine(&mut pass, part);
        }
        match (sides, &self.sides) {
            (Some(sides), Some(panes)) => {
                for ((part, is_original), viewport) in sides.into_iter().zip(panes) {
                    let [left, top, width, height] = part;
                    pass.set_scissor_rect(left, top, width, height);
                    self.draw_model(&mut pass, viewport, state, Some(is_original));
                }
                pass.set_scissor_rect(0, 0, canvas.0, canvas.1);
            }
            _ => self.draw_model(&mut pass, &self.whole, state, None),
        }
        if let Some([_, part]) = parts {
            confine(&mut pass, part);
            pass.set_bind_group(0, self.map_store.group(), &[]);
            self.faces.draw(&mut pass);
            self.lines.draw(&mut pass, state.display().edges);
            self.lines.draw_flipped(&mut pass);
            // On WebGL2 only what is inside the last rectangle arrives on the canvas.
            confine(&mut pass, [0, 0, canvas.0, canvas.1]);
        }
        drop(pass);
        self.device.show(encoder, frame);
        Ok(true)
    }

    /// Everything that is drawn of the model, as `viewport` has it. A side of a split picture tells whether it
    /// is of the original, of which there is only the mesh and what is about it: handles, projections and
    /// fitted shapes are those of the current shape. Only the whole picture has a shadow.
    fn draw_model(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        viewport: &Viewport,
        state: &ViewState,
        side: Option<bool>,
    ) {
        let display = state.display();
        let is_original = side == Some(true);
        pass.set_bind_group(0, viewport.tables.group(), &[]);
        self.backdrop.draw(pass, side.is_none());
        viewport.draw(pass, &self.faces, &self.lines, display.edges);
        if display.shapes && !is_original {
            self.spheres.draw(pass);
            self.circles.draw(pass, state.circle_pieces());
        }
        if !is_original {
            self.projections.draw(pass, display);
        }
        if display.vertices || state.mesh().is_only_points() {
            self.points.draw_vertices(pass);
        }
        self.lines.draw_marks(pass);
        if !is_original {
            self.lines.draw_pulls(pass);
            self.points.draw_marks(pass);
            self.gizmo.draw(pass);
        }
    }

    /// Brings the tables of both sides up to date; gives of each its part of the canvas, and whether it
    /// shows the original.
    fn update_sides(
        &mut self,
        split: &mut Split,
        canvas: (u32, u32),
        ratio: f32,
    ) -> [([u32; 4], bool); 2] {
        let (device, queue) = (&self.device.device, &self.device.queue);
        let like = &self.map_store;
        let panes =
            self.sides.get_or_insert_with(|| [(); 2].map(|()| Viewport::new(device, queue, like)));
        for (side, viewport) in split.sides.iter_mut().zip(panes) {
            viewport.update((device, queue), &mut side.state, &self.lines, canvas);
            side.state.take_changes();
        }
        let css = Vec2::new(canvas.0 as f32, canvas.1 as f32) / ratio;
        let [left, right] = split.parts(css).map(|part| pixels(part, ratio, canvas));
        [(left, split.sides[0].is_original), (right, split.sides[1].is_original)]
    }

    fn update(&mut self, state: &mut ViewState, size: (u32, u32)) {
        let (device, queue) = (&self.device.device, &self.device.queue);
        let changes = state.changes();
        self.gizmo.update(device, queue, state);
        if changes.mesh || changes.positions {
            let mesh = state.mesh();
            let shadow = GroundShadow::new(&mesh.positions, &mesh.triangles, state.camera().up);
            self.backdrop.update(device, queue, &shadow);
        }
        if changes.mesh {
            self.faces.update(device, queue, state.mesh());
            self.lines.update_mesh(device, queue, state.mesh());
            self.points.update_mesh(device, queue, state);
        }
        self.whole.update((device, queue), state, &self.lines, size);
        if changes.mesh || changes.marks {
            self.lines.update_marks(device, queue, state);
            self.lines.update_handles(device, queue, state);
            self.points.update_marks(device, queue, state);
        }
        // Their points come after the targets of the handles.
        if changes.mesh || changes.marks || changes.projections {
            self.projections.update(device, queue, state);
        }
        if changes.mesh || changes.shapes {
            self.circles.update(device, queue, state.shapes());
            self.spheres.update(device, queue, state.shapes());
        }
    }
}

/// A part of the canvas in pixels: left, top, width, height, all of it on the canvas.
fn pixels(part: Region, ratio: f32, (width, height): (u32, u32)) -> [u32; 4] {
    let low = (part.at * ratio).round();
    let high = ((part.at + part.size) * ratio).round();
    let [left, top] = [(low.x as u32).min(width - 1), (low.y as u32).min(height - 1)];
    let [right, bottom] = [(high.x as u32).min(width), (high.y as u32).min(height)];
    [left, top, right.saturating_sub(left).max(1), bottom.saturating_sub(top).max(1)]
}

/// Restricts drawing to a part of the canvas from here on.
fn confine(pass: &mut wgpu::RenderPass<'_>, [left, top, width, height]: [u32; 4]) {
    let [x, y, w, h] = [left, top, width, height].map(|side| side as f32);
    pass.set_viewport(x, y, w, h, 0.0, 1.0);
    pass.set_scissor_rect(left, top, width, height);
}
