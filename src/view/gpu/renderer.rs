//! Draws a view: updates the data on the GPU, then draws the primitives in order.

use super::device::{Device, DeviceError};
use super::gpu_tables::GpuTables;
use super::placement::Placement;
use crate::view::camera::{Camera, Section};
use crate::view::gizmo::triangles;
use crate::view::gpu::primitive::{
    Backdrop, Faces, Instances, Lines, Occlusion, Points, ProjectionLines, SurroundingLines,
    instances,
};
use crate::view::model::RenderMesh;
use crate::view::overlay::GroundShadow;
use crate::view::pictures::Region;
use crate::view::state::ViewState;
use glam::Vec2;

/// All GPU objects of a view.
#[derive(Debug)]
pub struct Renderer {
    /// Device and canvas.
    pub device: Device,
    /// The tables of the model.
    tables: GpuTables,
    /// The tables of the flat map.
    map_tables: GpuTables,
    backdrop: Backdrop,
    occlusion: Occlusion,
    /// Inputs for which the occlusion was last computed.
    occlusion_of: Option<OcclusionInputs>,
    /// The section with which the shadow on the ground was computed.
    shadow_of: Option<Section>,
    faces: Faces,
    lines: Lines,
    around: SurroundingLines,
    layer: SurroundingLines,
    over: SurroundingLines,
    projections: ProjectionLines,
    points: Points,
    circles: Instances,
    spheres: Instances,
    gizmo: Instances,
}

/// The inputs of the occlusion beside the shape: camera, near and far depth, height of the ground, size
/// of the picture.
type OcclusionInputs = (Camera, (f32, f32), f32, (u32, u32));

fn occlusion_inputs(state: &ViewState, size: (u32, u32)) -> OcclusionInputs {
    (state.camera(), state.depth_range(), state.floor(), size)
}

impl Renderer {
    /// Creates the pipelines.
    pub fn new(device: Device) -> Renderer {
        let (gpu, format) = (&device.device, device.format());
        let tables = GpuTables::new(gpu, &device.queue);
        let occlusion = Occlusion::new(gpu, &tables);
        let of = |recipe| Instances::new(gpu, &tables, format, recipe);
        let beside = || SurroundingLines::new(gpu, &device.queue, &tables);
        Renderer {
            backdrop: Backdrop::new(gpu, &device.queue, &tables, format),
            faces: Faces::new(gpu, &tables, occlusion.layout(), format),
            occlusion,
            occlusion_of: None,
            shadow_of: None,
            lines: Lines::new(gpu, &tables, format),
            around: beside(),
            layer: beside(),
            over: beside(),
            projections: ProjectionLines::new(gpu, &tables, format),
            points: Points::new(gpu, &tables, format),
            circles: of(&instances::OF_CIRCLES),
            spheres: of(&instances::OF_SPHERES),
            gizmo: of(&instances::OF_GIZMO),
            map_tables: tables.beside(gpu, &device.queue),
            tables,
            device,
        }
    }

    /// Returns whether the last occlusion is still valid for this view and picture size in pixels.
    pub fn occlusion_fits(&self, state: &ViewState, size: (u32, u32)) -> bool {
        let changes = state.changes();
        let is_moved = changes.mesh || changes.positions;
        !is_moved && self.occlusion_of == Some(occlusion_inputs(state, size))
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
            self.map_tables.update(device, queue, map, part);
            if map.changes().mesh || map.changes().marks {
                self.lines.update_map(device, queue, map);
            }
            map.take_changes();
        }
        let label = wgpu::CommandEncoderDescriptor { label: Some("picture") };
        let mut encoder = self.device.device.create_command_encoder(&label);
        if state.occlusion() > 0.0 && !fits {
            let size = parts.map_or(picture.size, |[part, _]| part.size);
            let (device, tables) = (&self.device.device, &self.tables);
            self.occlusion.find(device, &mut encoder, tables, &self.faces, size);
            self.occlusion_of = Some(occlusion_inputs(state, picture.size));
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
            pass.set_bind_group(0, self.map_tables.group(), &[]);
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
        let (faces, lines, tables) = (&self.faces, &self.lines, &self.tables);
        pass.set_bind_group(0, tables.group(), &[]);
        self.backdrop.draw(pass);
        faces.draw(pass);
        self.around.draw(pass, faces, lines, tables);
        lines.draw(pass, display.edges);
        if display.computed {
            self.over.draw(pass, faces, lines, tables);
            self.layer.draw(pass, faces, lines, tables);
        }
        if display.shapes {
            self.spheres.draw_each(pass, 6);
            self.circles.draw_each(pass, 6 * state.circle_pieces());
        }
        self.projections.draw(pass, display);
        if display.vertices || state.mesh().is_only_points() {
            self.points.draw_vertices(pass);
        }
        self.lines.draw_marks(pass);
        self.points.draw_marks(pass);
        self.gizmo.draw(pass);
    }

    fn update(&mut self, state: &ViewState, placement: Placement) {
        let gpu @ (device, queue) = (&self.device.device, &self.device.queue);
        let changes = state.changes();
        let gizmo = state.gizmo();
        let gizmo = gizmo.map(|own| triangles(&own, state.gizmo_state(), state.palette()));
        self.gizmo.write(device, queue, &gizmo.unwrap_or_default());
        let Camera { section, up, .. } = state.camera();
        let is_moved = changes.mesh || changes.positions || changes.around;
        if is_moved || section != self.shadow_of {
            self.shadow_of = section;
            let RenderMesh { positions, triangles, .. } = state.mesh();
            let floor = state.floor();
            let shadow = match section.map(|section| section.kept(positions, triangles)) {
                Some((points, left)) => GroundShadow::new(&points, &left, floor, up),
                None => GroundShadow::new(positions, triangles, floor, up),
            };
            self.backdrop.update(device, queue, &shadow);
        }
        if changes.mesh {
            self.faces.update(device, queue, state.mesh());
            self.lines.update_mesh(device, queue, state.mesh());
            self.points.update_mesh(device, queue, state);
        }
        self.tables.update(device, queue, state, placement);
        let palette = state.palette();
        let new = (changes.around)
            .then(|| (state.surrounding_lines(), state.surrounding_points().collect()));
        self.around.update(gpu, state, new, palette.ghost, placement);
        // The posts of the layer stand on the surface.
        let new = (changes.layer || changes.positions)
            .then(|| (state.layer_lines(), state.layer_points().collect()));
        self.layer.update(gpu, state, new, palette.layer, placement);
        let new = changes.lines.then(|| state.surface_lines());
        self.over.update(gpu, state, new, palette.layer, placement);
        if changes.mesh || changes.appearance {
            self.lines.update_bands(device, queue, state);
        }
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
            self.circles.write(device, queue, &instances::circles(state.shapes()));
            self.spheres.write(device, queue, &instances::spheres(state.shapes()));
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
