//! Turns a stage into a picture: brings the GPU's data up to date, then draws the primitives in
//! their order.

use super::circles::Circles;
use super::device::{Device, DeviceError};
use super::faces::Faces;
use super::flat_map::Region;
use super::gizmo_marks::GizmoMarks;
use super::lines::Lines;
use super::points::Points;
use super::projection_lines::ProjectionLines;
use super::spheres::Spheres;
use super::stage::{Changes, Stage};
use super::store::Store;
use glam::Vec2;

/// All GPU objects of a view.
#[derive(Debug)]
pub struct Picture {
    /// Device and canvas.
    pub device: Device,
    store: Store,
    /// Of the stage of the flat map.
    map_store: Store,
    faces: Faces,
    lines: Lines,
    projections: ProjectionLines,
    points: Points,
    circles: Circles,
    spheres: Spheres,
    gizmo: GizmoMarks,
}

impl Picture {
    /// Builds the pipelines.
    pub fn new(device: Device) -> Picture {
        let (gpu, format) = (&device.device, device.format());
        let store = Store::new(gpu, &device.queue);
        let map_store = store.beside(gpu, &device.queue);
        Picture {
            faces: Faces::new(gpu, &store, format),
            lines: Lines::new(gpu, &store, format),
            projections: ProjectionLines::new(gpu, &store, format),
            points: Points::new(gpu, &store, format),
            circles: Circles::new(gpu, &store, format),
            spheres: Spheres::new(gpu, &store, format),
            gizmo: GizmoMarks::new(gpu, &store, format),
            store,
            map_store,
            device,
        }
    }

    /// Draws the stage, and beside it its flat map if there is one, if anything has changed; returns
    /// whether it did. `ratio` is pixels per CSS pixel.
    ///
    /// # Errors
    /// The device is lost; a new picture on a new canvas is needed.
    pub fn draw(
        &mut self,
        stage: &mut Stage,
        mut map: Option<&mut Stage>,
        ratio: f32,
    ) -> Result<bool, DeviceError> {
        if !stage.changes.any() && !map.as_ref().is_some_and(|map| map.changes.any()) {
            return Ok(false);
        }
        let Some(frame) = self.device.frame()? else { return Ok(false) };
        let canvas = self.device.size();
        let parts = map.as_ref().map(|_| {
            let css = Vec2::new(canvas.0 as f32, canvas.1 as f32) / ratio;
            Region::halves(css).map(|part| pixels(part, ratio, canvas))
        });
        self.update(stage, parts.map_or(canvas, |[[.., width, height], _]| (width, height)));
        stage.changes = Changes::default();
        if let (Some(map), Some([_, [.., width, height]])) = (&mut map, parts) {
            let (device, queue) = (&self.device.device, &self.device.queue);
            self.map_store.update(device, queue, map, (width, height));
            map.changes = Changes::default();
        }
        let label = wgpu::CommandEncoderDescriptor { label: Some("picture") };
        let mut encoder = self.device.device.create_command_encoder(&label);
        let mut pass = self.device.pass(&mut encoder, &frame, stage.background());
        if let Some([part, _]) = parts {
            confine(&mut pass, part);
        }
        pass.set_bind_group(0, self.store.group(), &[]);
        let display = stage.display;
        self.faces.draw(&mut pass);
        self.lines.draw(&mut pass, display.edges);
        if display.shapes {
            self.spheres.draw(&mut pass);
            self.circles.draw(&mut pass, stage.circle_pieces());
        }
        self.projections.draw(&mut pass, display);
        if display.vertices || stage.subject.is_only_points() {
            self.points.draw_vertices(&mut pass);
        }
        self.lines.draw_marks(&mut pass);
        self.lines.draw_pulls(&mut pass);
        self.points.draw_marks(&mut pass);
        self.gizmo.draw(&mut pass);
        if let Some([_, part]) = parts {
            confine(&mut pass, part);
            pass.set_bind_group(0, self.map_store.group(), &[]);
            self.faces.draw(&mut pass);
            self.lines.draw(&mut pass, display.edges);
            // On WebGL2 only what is inside the last rectangle arrives on the canvas.
            confine(&mut pass, [0, 0, canvas.0, canvas.1]);
        }
        drop(pass);
        self.device.show(encoder, frame);
        Ok(true)
    }

    fn update(&mut self, stage: &Stage, size: (u32, u32)) {
        let (device, queue) = (&self.device.device, &self.device.queue);
        let changes = stage.changes;
        self.store.update(device, queue, stage, size);
        self.gizmo.update(device, queue, stage);
        if changes.mesh {
            self.faces.update(device, queue, &stage.subject);
            self.lines.update_mesh(device, queue, &stage.subject);
            self.points.update_mesh(device, queue, stage);
        }
        if changes.mesh || changes.marks {
            self.lines.update_marks(device, queue, stage);
            self.lines.update_handles(device, queue, stage);
            self.points.update_marks(device, queue, stage);
        }
        // Their points come after the targets of the handles.
        if changes.mesh || changes.marks || changes.projections {
            self.projections.update(device, queue, stage);
        }
        if changes.mesh || changes.shapes {
            self.circles.update(device, queue, &stage.shapes);
            self.spheres.update(device, queue, &stage.shapes);
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

/// What is drawn from now on is drawn in a part of the canvas.
fn confine(pass: &mut wgpu::RenderPass<'_>, [left, top, width, height]: [u32; 4]) {
    let [x, y, w, h] = [left, top, width, height].map(|side| side as f32);
    pass.set_viewport(x, y, w, h, 0.0, 1.0);
    pass.set_scissor_rect(left, top, width, height);
}
