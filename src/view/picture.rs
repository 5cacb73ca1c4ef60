//! Turns a stage into a picture: brings the GPU's data up to date, then draws the primitives in
//! their order.

use super::circles::Circles;
use super::device::{Device, DeviceError};
use super::faces::Faces;
use super::lines::Lines;
use super::points::Points;
use super::projection_lines::ProjectionLines;
use super::spheres::Spheres;
use super::stage::{Changes, Stage};
use super::store::Store;

/// All GPU objects of a view.
#[derive(Debug)]
pub struct Picture {
    /// Device and canvas.
    pub device: Device,
    store: Store,
    faces: Faces,
    lines: Lines,
    projections: ProjectionLines,
    points: Points,
    circles: Circles,
    spheres: Spheres,
}

impl Picture {
    /// Builds the pipelines.
    pub fn new(device: Device) -> Picture {
        let (gpu, format) = (&device.device, device.format());
        let store = Store::new(gpu, &device.queue);
        Picture {
            faces: Faces::new(gpu, &store, format),
            lines: Lines::new(gpu, &store, format),
            projections: ProjectionLines::new(gpu, &store, format),
            points: Points::new(gpu, &store, format),
            circles: Circles::new(gpu, &store, format),
            spheres: Spheres::new(gpu, &store, format),
            store,
            device,
        }
    }

    /// Draws the stage if anything has changed; returns whether it did.
    ///
    /// # Errors
    /// The device is lost; a new picture on a new canvas is needed.
    pub fn draw(&mut self, stage: &mut Stage) -> Result<bool, DeviceError> {
        if !stage.changes.any() {
            return Ok(false);
        }
        let Some(frame) = self.device.frame()? else { return Ok(false) };
        self.update(stage);
        stage.changes = Changes::default();
        let label = wgpu::CommandEncoderDescriptor { label: Some("picture") };
        let mut encoder = self.device.device.create_command_encoder(&label);
        let mut pass = self.device.pass(&mut encoder, &frame, stage.background());
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
        drop(pass);
        self.device.show(encoder, frame);
        Ok(true)
    }

    fn update(&mut self, stage: &Stage) {
        let (device, queue) = (&self.device.device, &self.device.queue);
        let changes = stage.changes;
        self.store.update(device, queue, stage, self.device.size());
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
