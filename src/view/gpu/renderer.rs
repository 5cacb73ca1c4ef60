//! Draws a view: updates the data on the GPU, then draws the primitives in order.

use super::device::{Device, DeviceError};
use super::gpu_tables::GpuTables;
use super::placement::Placement;
use super::viewport::Viewport;
use crate::view::camera::{Camera, Section};
use crate::view::flat_map::Region;
use crate::view::gpu::primitive::{
    Backdrop, Circles, Faces, GizmoMarks, Lines, Occlusion, Points, ProjectionLines, Spheres,
};
use crate::view::model::RenderMesh;
use crate::view::overlay::GroundShadow;
use crate::view::state::ViewState;
use glam::Vec2;

/// All GPU objects of a view.
#[derive(Debug)]
pub struct Renderer {
    /// Device and canvas.
    pub device: Device,
    /// The picture of the model.
    whole: Viewport,
    /// The tables of the flat map.
    map_store: GpuTables,
    backdrop: Backdrop,
    occlusion: Occlusion,
    /// Camera, depths and size for which the occlusion was last computed.
    occlusion_of: Option<Seen>,
    /// The section with which the shadow on the ground was computed.
    shadow_of: Option<Section>,
    faces: Faces,
    lines: Lines,
    projections: ProjectionLines,
    points: Points,
    circles: Circles,
    spheres: Spheres,
    gizmo: GizmoMarks,
}

/// The inputs of the occlusion beside the shape: camera, near and far depth, size of the picture.
type Seen = (Camera, (f32, f32), (u32, u32));

impl Renderer {
    /// Creates the pipelines.
    pub fn new(device: Device) -> Renderer {
        let (gpu, format) = (&device.device, device.format());
        let tables = GpuTables::new(gpu, &device.queue);
        let occlusion = Occlusion::new(gpu, &tables);
        Renderer {
            backdrop: Backdrop::new(gpu, &device.queue, &tables, format),
            faces: Faces::new(gpu, &tables, occlusion.layout(), format),
            occlusion,
            occlusion_of: None,
            shadow_of: None,
            lines: Lines::new(gpu, &tables, format),
            projections: ProjectionLines::new(gpu, &tables, format),
            points: Points::new(gpu, &tables, format),
            circles: Circles::new(gpu, &tables, format),
            spheres: Spheres::new(gpu, &tables, format),
            gizmo: GizmoMarks::new(gpu, &tables, format),
            whole: Viewport::new(gpu, &device.queue, &tables),
            map_store: tables.beside(gpu, &device.queue),
            device,
        }
    }

    /// Returns whether the last occlusion is still valid for this view and picture size in pixels.
    pub fn occlusion_fits(&self, state: &ViewState, size: (u32, u32)) -> bool {
        let changes = state.changes();
        let is_moved = changes.mesh || changes.positions;
        !is_moved && self.occlusion_of == Some((state.camera(), state.depth_range(), size))
    }

    /// Draws the model, with its flat map beside it if there is one, if anything has changed;
    /// returns whether it did. `ratio` is pixels per CSS pixel; `tile` is the position of the canvas
    /// in a larger picture, if there is one.
    ///
    /// # Errors
    /// The device is lost; a new view on a new canvas is needed.
    pub fn draw(
        &mut self,
        state: &mut ViewState,
        mut map: Option<&mut ViewState>,
        ratio: f32,
        tile: Option<Placement>,
    ) -> Result<bool, DeviceError> {
        let is_new = state.changes().any() || map.as_ref().is_some_and(|map| map.changes().any());
        if !is_new {
            return Ok(false);
        }
        let Some(frame) = self.device.frame()? else { return Ok(false) };
        let picture = tile.unwrap_or_else(|| Placement::whole(self.device.size()));
        let css = Vec2::new(picture.size.0 as f32, picture.size.1 as f32) / ratio;
        let parts = map.as_ref().map(|_| {
            Region::halves(css).map(|part| picture.part(pixels(part, ratio, picture.size)))
        });
        let fits = self.occlusion_fits(state, picture.size);
        self.update(state, parts.map_or(picture, |[part, _]| part));
        state.take_changes();
        if let (Some(map), Some([_, part])) = (&mut map, parts) {
            let (device, queue) = (&self.device.device, &self.device.queue);
            self.map_store.update(device, queue, map, part);
            if map.changes().mesh || map.changes().marks {
                self.lines.update_map(device, queue, map);
            }
            map.take_changes();
        }
        let label = wgpu::CommandEncoderDescriptor { label: Some("picture") };
        let mut encoder = self.device.device.create_command_encoder(&label);
        if state.occlusion() > 0.0 && !fits {
            let size = parts.map_or(picture.size, |[part, _]| part.size);
            let (device, tables) = (&self.device.device, &self.whole.tables);
            self.occlusion.find(device, &mut encoder, tables, &self.faces, size);
            self.occlusion_of = Some((state.camera(), state.depth_range(), picture.size));
        } else if !fits {
            self.occlusion_of = None;
        }
        let mut pass = self.device.pass(&mut encoder, &frame, state.background());
        pass.set_bind_group(1, self.occlusion.group(), &[]);
        if confine(&mut pass, parts.map_or(picture, |[part, _]| part)) {
            self.draw_model(&mut pass, state);
        }
        if let Some([_, part]) = parts
            && confine(&mut pass, part)
        {
            pass.set_bind_group(0, self.map_store.group(), &[]);
            self.faces.draw(&mut pass);
            self.lines.draw_map(&mut pass, state.display().edges);
        }
        // On WebGL2 only the pixels inside the last scissor rectangle reach the canvas.
        let (width, height) = picture.canvas;
        pass.set_scissor_rect(0, 0, width, height);
        drop(pass);
        self.device.show(encoder, frame);
        Ok(true)
    }

    fn draw_model(&self, pass: &mut wgpu::RenderPass<'_>, state: &ViewState) {
        let display = state.display();
        pass.set_bind_group(0, self.whole.tables.group(), &[]);
        self.backdrop.draw(pass);
        self.whole.draw(pass, &self.faces, &self.lines, display.edges);
        if display.shapes {
            self.spheres.draw(pass);
            self.circles.draw(pass, state.circle_pieces());
        }
        self.projections.draw(pass, display);
        if display.vertices || state.mesh().is_only_points() {
            self.points.draw_vertices(pass);
        }
        self.lines.draw_marks(pass);
        self.lines.draw_pulls(pass);
        self.points.draw_marks(pass);
        self.gizmo.draw(pass);
    }

    fn update(&mut self, state: &mut ViewState, placement: Placement) {
        let (device, queue) = (&self.device.device, &self.device.queue);
        let changes = state.changes();
        self.gizmo.update(device, queue, state);
        let Camera { section, up, .. } = state.camera();
        if changes.mesh || changes.positions || section != self.shadow_of {
            self.shadow_of = section;
            let RenderMesh { positions, triangles, .. } = state.mesh();
            let shadow = match section.map(|section| section.kept(positions, triangles)) {
                Some((points, left)) => GroundShadow::new(&points, &left, up),
                None => GroundShadow::new(positions, triangles, up),
            };
            self.backdrop.update(device, queue, &shadow);
        }
        if changes.mesh {
            self.faces.update(device, queue, state.mesh());
            self.lines.update_mesh(device, queue, state.mesh());
            self.points.update_mesh(device, queue, state);
        }
        self.whole.update((device, queue), state, &self.lines, placement);
        if changes.mesh || changes.marks {
            self.lines.update_marks(device, queue, state);
            self.lines.update_handles(device, queue, state);
            self.points.update_marks(device, queue, state);
        }
        // Projected points come after the targets of the handles in the table.
        if changes.mesh || changes.marks || changes.projections {
            self.projections.update(device, queue, state);
        }
        if changes.mesh || changes.shapes {
            self.circles.update(device, queue, state.shapes());
            self.spheres.update(device, queue, state.shapes());
        }
    }
}

/// Returns a part of the picture in pixels: left, top, width, height, clamped to the picture.
fn pixels(part: Region, ratio: f32, (width, height): (u32, u32)) -> [u32; 4] {
    let low = (part.at * ratio).round();
    let high = ((part.at + part.size) * ratio).round();
    let [left, top] = [(low.x as u32).min(width - 1), (low.y as u32).min(height - 1)];
    let [right, bottom] = [(high.x as u32).min(width), (high.y as u32).min(height)];
    [left, top, right.saturating_sub(left).max(1), bottom.saturating_sub(top).max(1)]
}

/// Restricts drawing to the part of a picture that the canvas shows; returns whether there is one.
fn confine(pass: &mut wgpu::RenderPass<'_>, part: Placement) -> bool {
    let shown = part.shown();
    if let Some([left, top, width, height]) = shown {
        pass.set_scissor_rect(left, top, width, height);
    }
    shown.is_some()
}
