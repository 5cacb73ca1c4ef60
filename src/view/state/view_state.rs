//! Everything that a picture shows, and what has changed since the last one.

use super::parts::{Changes, Display, HandleMark, SHAPE_NUMBERS};
use crate::view::appearance::{Appearance, Colour, DARK, DotKind, LIGHT, Palette};
use crate::view::camera::Camera;
use crate::view::gizmo::GizmoState;
use crate::view::model::{
    Checks, Lists, ProjectionMarks, RenderMesh, ViewError, check_indices, read_points,
};
use crate::view::overlay::Surroundings;
use crate::view::picking::DepthMap;
use glam::{DVec3, Vec3, Vec4};

/// The state of the view.
#[derive(Debug)]
pub struct ViewState {
    /// The mesh.
    pub mesh: RenderMesh,
    /// `#E by 2`: the edges that can be picked and selected.
    pub edges: Vec<[u32; 2]>,
    /// The camera.
    pub camera: Camera,
    /// Values and marks.
    pub appearance: Appearance,
    /// Colour of the tint.
    pub tint: [f32; 3],
    /// All handles.
    pub handles: Vec<HandleMark>,
    /// Fitted shapes in view coordinates, `SHAPE_NUMBERS` each.
    pub shapes: Vec<f32>,
    /// Projected points, outlines, arrows.
    pub projections: ProjectionMarks,
    /// The checkerboard of a flat map.
    pub checks: Checks,
    /// Sides of the faces that a flat map turns over, by their vertices.
    pub flipped: Vec<[u32; 2]>,
    /// The ghost of the model as it was opened, and the ground.
    pub around: Surroundings,
    /// The ends of the measuring tape: none, the first, or both.
    pub tape: Vec<u32>,
    /// The parts of the view that are switched on.
    pub display: Display,
    /// The state of the gizmo.
    pub gizmo: GizmoState,
    /// Dark theme.
    pub dark: bool,
    /// White behind everything, for figures, instead of the theme's colour.
    pub white: bool,
    /// Since the last picture.
    pub changes: Changes,
    /// The point that a drag turns the camera about.
    pub(super) turned_about: Vec3,
    /// Whether the camera stands as `fit` left it, and follows the canvas when that is resized.
    pub(super) framed: bool,
    pub(super) map: Option<DepthMap>,
}

impl Default for ViewState {
    fn default() -> Self {
        ViewState {
            mesh: RenderMesh::default(),
            edges: Vec::new(),
            camera: Camera::default(),
            appearance: Appearance::default(),
            tint: [0.2, 0.7, 0.3],
            handles: Vec::new(),
            shapes: Vec::new(),
            projections: ProjectionMarks::default(),
            checks: Checks::default(),
            flipped: Vec::new(),
            around: Surroundings::default(),
            tape: Vec::new(),
            display: Display { edges: true, ..Display::default() },
            gizmo: GizmoState::default(),
            dark: false,
            white: false,
            changes: Changes::ALL,
            turned_about: Vec3::ZERO,
            framed: true,
            map: None,
        }
    }
}

impl ViewState {
    /// Shows a mesh. Another mesh than before comes without marks, handles and shapes, and is
    /// framed from the three-quarter view; the same faces and curves only move.
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
        let faces = Lists::new("faces", faces.0, faces.1, count)?;
        let curves = Lists::new("curves", curves.0, curves.1, count)?;
        let same = faces == self.mesh.faces
            && curves == self.mesh.curves
            && count == self.mesh.exact.len();
        if same {
            return self.set_positions(coordinates);
        }
        self.mesh = RenderMesh::new(faces, curves, coordinates)?;
        self.edges.clear();
        self.appearance = Appearance::default();
        self.handles.clear();
        self.shapes.clear();
        self.projections = ProjectionMarks::default();
        self.checks = Checks::default();
        self.tape.clear();
        self.changes = Changes::ALL;
        self.leave_surroundings();
        self.preset("home")
    }

    /// Moves the vertices; #V by 3 in file coordinates.
    ///
    /// # Errors
    /// Another number of vertices or a coordinate that is not finite.
    pub fn set_positions(&mut self, coordinates: &[f64]) -> Result<(), ViewError> {
        self.mesh.set_positions(coordinates)?;
        self.changes.positions = true;
        self.map = None;
        self.keep_reach();
        Ok(())
    }

    /// How many vertices and faces there are.
    pub fn counts(&self) -> (usize, usize) {
        (self.mesh.positions.len(), self.mesh.faces.len())
    }

    /// Sets all handles; states are 0 soft, 1 fixed, 2 active; targets are #H by 3.
    ///
    /// # Errors
    /// Arrays that do not fit together, or a state that is not known.
    pub fn set_handles(
        &mut self,
        vertices: &[u32],
        states: &[u8],
        targets: &[f64],
    ) -> Result<(), ViewError> {
        check_indices("handles", vertices, self.counts().0)?;
        let targets = read_points(targets)?;
        for (what, got) in [("handle states", states.len()), ("handle targets", targets.len())] {
            if got != vertices.len() {
                return Err(ViewError::Length { what, got, expected: vertices.len() });
            }
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
        let same = handles.len() == self.handles.len()
            && handles
                .iter()
                .zip(&self.handles)
                .all(|(a, b)| a.vertex == b.vertex && a.kind == b.kind);
        self.handles = handles;
        self.changes.marks |= !same;
        self.changes.targets = true;
        Ok(())
    }

    /// Sets the fitted shapes: eight numbers each, centres in file coordinates.
    ///
    /// # Errors
    /// A length that is no multiple of eight.
    pub fn set_shapes(&mut self, shapes: &[f32]) -> Result<(), ViewError> {
        let (rows, rest) = shapes.as_chunks::<SHAPE_NUMBERS>();
        if !rest.is_empty() {
            let expected = (rows.len() + 1) * SHAPE_NUMBERS;
            return Err(ViewError::Length { what: "shapes", got: shapes.len(), expected });
        }
        self.shapes.clear();
        for row in rows.iter().filter(|row| row.iter().all(|x| x.is_finite())) {
            let centre = DVec3::new(f64::from(row[1]), f64::from(row[2]), f64::from(row[3]));
            self.shapes.push(row[0]);
            self.shapes.extend(self.mesh.relative(centre).to_array());
            self.shapes.extend(&row[4..]);
        }
        self.changes.shapes = true;
        Ok(())
    }

    /// Sets the projections of the constraints.
    pub fn set_projections(&mut self, projections: ProjectionMarks) {
        self.changes.projections |= projections != self.projections;
        self.projections = projections;
    }

    /// The projected points relative to the view's centre, each with its distance from its vertex.
    pub fn projected(&self) -> impl Iterator<Item = Vec4> + '_ {
        self.projections.points.iter().map(|point| {
            let at = self.mesh.positions[point.vertex as usize] + point.way;
            at.extend(point.way.length())
        })
    }

    /// Pieces that a fitted circle is drawn with: fewer when there are thousands, which are small.
    pub fn circle_pieces(&self) -> u32 {
        if self.shapes.len() > 1000 * SHAPE_NUMBERS { 32 } else { 96 }
    }

    /// The colours of the theme.
    pub fn palette(&self) -> &'static Palette {
        if self.dark { &DARK } else { &LIGHT }
    }

    /// The colour behind everything.
    pub fn background(&self) -> Colour {
        if self.white { [1.0; 4] } else { self.palette().background }
    }

    /// Says that the next picture differs without new data.
    pub fn view_changed(&mut self) {
        self.changes.view = true;
        self.map = None;
    }

    /// Half the diagonal of the bounding box; 1 where there is none.
    pub fn size(&self) -> f32 {
        let [low, high] = self.bounds();
        let size = (high - low).length() * 0.5;
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    }

    pub(crate) fn bounds(&self) -> [Vec3; 2] {
        let points = self.mesh.used_positions();
        let low = points.clone().reduce(Vec3::min).unwrap_or_default();
        [low, points.reduce(Vec3::max).unwrap_or_default()]
    }

    /// Where each handle should be, relative to the view's centre.
    pub fn targets(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.handles.iter().map(|handle| self.mesh.relative(handle.target))
    }
}
