//! The state that determines a picture, independent of the GPU, so that native tests can check it:
//! the contents, look and camera of a view, and what has changed since the last picture.

pub mod gizmo_drag;
mod layer;
pub mod navigate;
pub mod parts;
pub mod pick;
pub mod select_region;
mod set_look;
pub mod surrounding;

pub use parts::{Changes, Display, FittedShape, HandleMark};
pub use select_region::{Outline, RegionMode};

use crate::view::appearance::{Appearance, DotKind};
use crate::view::gizmo::GizmoState;
use crate::view::model::{
    Checks, ProjectionMarks, RenderMesh, ViewError, check_indices, check_length, read_points, rows,
};
use crate::view::overlay::{ShownLayer, SurfaceLines, Surroundings};
use glam::{DVec3, Vec3, Vec4};
use parts::{Content, Look, Viewpoint};

/// The state of a view. Its setters record changes, which [`ViewState::take_changes`] returns.
#[derive(Debug)]
pub struct ViewState {
    content: Content,
    look: Look,
    viewpoint: Viewpoint,
    /// The ghost of the mesh as it was opened, and the ground.
    around: Surroundings,
    layer: ShownLayer,
    lines: SurfaceLines,
    gizmo: GizmoState,
    changes: Changes,
}

impl Default for ViewState {
    fn default() -> Self {
        ViewState {
            content: Content::default(),
            look: Look::default(),
            viewpoint: Viewpoint::default(),
            around: Surroundings::default(),
            layer: ShownLayer::default(),
            lines: SurfaceLines::default(),
            gizmo: GizmoState::default(),
            changes: Changes::ALL,
        }
    }
}

impl ViewState {
    /// Creates the view of a flat map from above: its mesh in the plane, its checkerboard, and the
    /// sides of the faces that it flips (`#sides by 2`).
    pub fn of_flat_map(mesh: RenderMesh, checks: Checks, flipped: Vec<[u32; 2]>) -> ViewState {
        let mut map = ViewState::default();
        (map.content.mesh, map.content.checks, map.content.flipped) = (mesh, checks, flipped);
        map.look.appearance = Appearance::new(map.counts());
        map.viewpoint.camera.look_from("top").expect("top is a side to look from");
        map
    }

    /// Shows a mesh. One of another topology, or in another place, starts without marks, handles and
    /// shapes, in the three-quarter view; if faces and curves are the same, and the place is about
    /// the same, only the positions change. The rest positions are forgotten in any case, until
    /// [`ViewState::set_rest`].
    ///
    /// # Errors
    /// Arrays that do not fit together; the old mesh stays.
    pub fn set_mesh(
        &mut self,
        faces: (Vec<u32>, Vec<u32>),
        curves: (Vec<u32>, Vec<u32>),
        coordinates: &[f64],
    ) -> Result<(), ViewError> {
        let count = coordinates.len() / 3;
        let faces = rows("faces", faces.0, faces.1, count)?;
        let curves = rows("curves", curves.0, curves.1, count)?;
        let same = faces == self.content.mesh.faces
            && curves == self.content.mesh.curves
            && count == self.content.mesh.exact.len()
            && self.content.mesh.is_near(&read_points(coordinates)?);
        if same {
            self.set_positions(coordinates)?;
            self.leave_surroundings();
            return Ok(());
        }
        let mesh = RenderMesh::new(faces, curves, coordinates)?;
        self.content = Content { mesh, ..Content::default() };
        self.look.appearance = Appearance::new(self.counts());
        self.changes = Changes::ALL;
        self.layer = ShownLayer::default();
        self.viewpoint.camera.section = None;
        self.lines = SurfaceLines::default();
        self.leave_surroundings();
        self.preset("home")
    }

    /// Moves the vertices; #V by 3 in file coordinates.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite.
    pub fn set_positions(&mut self, coordinates: &[f64]) -> Result<(), ViewError> {
        self.changes.mesh |= self.content.mesh.set_positions(coordinates)?;
        self.changes.positions = true;
        self.viewpoint.forget_depth();
        self.keep_ground();
        self.keep_reach();
        Ok(())
    }

    /// Returns the numbers of vertices and faces.
    pub fn counts(&self) -> (usize, usize) {
        (self.content.mesh.positions.len(), self.content.mesh.faces.len())
    }

    /// Sets all handles; states are 0 soft, 1 fixed, 2 active; targets are #H by 3.
    ///
    /// # Errors
    /// Arrays that do not fit together, or an unknown state.
    pub fn set_handles(
        &mut self,
        vertices: &[u32],
        states: &[u8],
        targets: &[f64],
    ) -> Result<(), ViewError> {
        check_indices("handles", vertices, self.counts().0)?;
        let targets = read_points(targets)?;
        for (what, got) in [("handle states", states.len()), ("handle targets", targets.len())] {
            check_length(what, got, vertices.len())?;
        }
        let mut handles = Vec::with_capacity(vertices.len());
        for ((&vertex, &state), &target) in vertices.iter().zip(states).zip(&targets) {
            let kind = match state {
                0 => DotKind::Handle,
                1 => DotKind::Fixed,
                2 => DotKind::Active,
                _ => {
                    let (index, count) = (u32::from(state), 3);
                    return Err(ViewError::Index { what: "handle states", index, count });
                }
            };
            handles.push(HandleMark { vertex, kind, target });
        }
        let same = handles.len() == self.content.handles.len()
            && handles
                .iter()
                .zip(&self.content.handles)
                .all(|(a, b)| a.vertex == b.vertex && a.kind == b.kind);
        self.content.handles = handles;
        self.changes.marks |= !same;
        self.changes.targets = true;
        Ok(())
    }

    /// Sets the fitted shapes, eight numbers each: kind (0 circle, else sphere), centre in file
    /// coordinates, normal, radius. Those with a number that is not finite are left out.
    ///
    /// # Errors
    /// A length that is not a multiple of eight.
    pub fn set_shapes(&mut self, shapes: &[f64]) -> Result<(), ViewError> {
        check_length("shapes", shapes.len(), shapes.len().next_multiple_of(8))?;
        let (rows, _) = shapes.as_chunks::<8>();
        let rows = rows.iter().filter(|row| row.iter().all(|&x| (x as f32).is_finite()));
        let mesh = &self.content.mesh;
        let shapes = rows.map(|&[kind, x, y, z, nx, ny, nz, radius]| {
            let (centre, radius) = (mesh.relative(DVec3::new(x, y, z)), radius as f32);
            match kind == 0.0 {
                true => FittedShape::Circle(centre, DVec3::new(nx, ny, nz).as_vec3(), radius),
                false => FittedShape::Sphere(centre, radius),
            }
        });
        self.content.shapes = shapes.collect();
        self.changes.shapes = true;
        self.keep_reach();
        Ok(())
    }

    /// Sets the projections of the constraints.
    pub fn set_projections(&mut self, projections: ProjectionMarks) {
        self.changes.projections |= projections != self.content.projections;
        self.content.projections = projections;
    }

    /// Returns the projected points relative to the view's centre; w: distance from their vertex.
    pub fn projected(&self) -> impl Iterator<Item = Vec4> + '_ {
        self.content.projections.points.iter().map(|point| {
            let at = self.content.mesh.positions[point.vertex as usize] + point.displacement;
            at.extend(point.displacement.length())
        })
    }

    /// Returns the number of segments of a fitted circle: fewer for thousands of small ones.
    pub fn circle_pieces(&self) -> u32 {
        if self.content.shapes.len() > 1000 { 32 } else { 96 }
    }

    /// Requests a redraw without new data.
    pub fn view_changed(&mut self) {
        self.changes.view = true;
        self.viewpoint.forget_depth();
    }

    /// Returns the changes since the last picture.
    pub fn changes(&self) -> Changes {
        self.changes
    }

    /// Returns and clears the changes since the last picture.
    pub fn take_changes(&mut self) -> Changes {
        std::mem::take(&mut self.changes)
    }

    /// Returns the mesh.
    pub fn mesh(&self) -> &RenderMesh {
        &self.content.mesh
    }

    /// Returns all handles.
    pub fn handles(&self) -> &[HandleMark] {
        &self.content.handles
    }

    /// Returns the fitted shapes.
    pub fn shapes(&self) -> &[FittedShape] {
        &self.content.shapes
    }

    /// Returns the projected points, outlines and arrows.
    pub fn projections(&self) -> &ProjectionMarks {
        &self.content.projections
    }

    /// Returns the checkerboard of a flat map.
    pub fn checks(&self) -> &Checks {
        &self.content.checks
    }

    /// Replaces the checkerboard.
    pub fn set_checks(&mut self, checks: Checks) {
        self.content.checks = checks;
        self.changes.checks = true;
        // It replaces the colours of face values.
        self.changes.appearance = true;
    }

    /// Sets the number of checkerboard squares per unit of length on the map; none for 0.
    pub fn scale_checks(&mut self, per_length: f32) {
        self.content.checks.per_length = per_length;
        self.changes.view = true;
    }

    /// Returns the sides of the faces that a flat map flips, as pairs of vertices: `#sides by 2`.
    pub fn flipped(&self) -> &[[u32; 2]] {
        &self.content.flipped
    }

    /// Returns the ghost of the mesh as it was opened, and the ground.
    pub fn around(&self) -> &Surroundings {
        &self.around
    }

    /// Returns half the diagonal of the bounding box; 1 if that is zero.
    pub fn size(&self) -> f32 {
        half_diagonal(self.bounds())
    }

    pub(crate) fn bounds(&self) -> [Vec3; 2] {
        self.content.mesh.bounds
    }

    /// Returns the target of each handle, relative to the view's centre.
    pub fn targets(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.content.handles.iter().map(|handle| self.content.mesh.relative(handle.target))
    }
}

/// Half the diagonal of a box; 1 if that is zero.
fn half_diagonal([low, high]: [Vec3; 2]) -> f32 {
    let size = (high - low).length() * 0.5;
    if size > 0.0 && size.is_finite() { size } else { 1.0 }
}
