//! Everything that a picture shows, without a GPU: the mesh, the camera, marks, handles, fitted
//! shapes, and what has changed since the last picture.

use super::camera::{Camera, Up};
use super::checks::Checks;
use super::depth_map::DepthMap;
use super::framing::frame;
use super::gizmo::Wanted;
use super::lists::{Lists, ViewError, check_indices};
use super::looks::Looks;
use super::palette::{Colour, DARK, DotKind, LIGHT, Palette};
use super::picking;
use super::projections::Projections;
use super::subject::{Subject, read_points};
use super::surroundings::Surroundings;
use glam::{DVec3, Vec2, Vec3, Vec4};

/// Numbers per fitted shape: kind (0 circle, 1 sphere), centre, normal, radius.
pub const SHAPE_NUMBERS: usize = 8;

/// A vertex that is held, softly or exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// The vertex.
    pub vertex: u32,
    /// [`DotKind::Handle`], [`DotKind::Fixed`] or [`DotKind::Active`].
    pub kind: DotKind,
    /// Where it should be, in file coordinates.
    pub target: DVec3,
}

/// What is switched on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Display {
    /// Edges of the polygons.
    pub edges: bool,
    /// A dot on every vertex.
    pub vertices: bool,
    /// Fitted circles and spheres.
    pub shapes: bool,
    /// Outlines of projected shapes.
    pub outlines: bool,
    /// Arrows from vertices to their projections.
    pub arrows: bool,
}

/// What has changed since the last picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Faces, curves, edges.
    pub mesh: bool,
    /// Where vertices are.
    pub positions: bool,
    /// Where handle targets are.
    pub targets: bool,
    /// Values and marks of faces.
    pub looks: bool,
    /// Which dots and pulling lines there are.
    pub marks: bool,
    /// Fitted shapes.
    pub shapes: bool,
    /// Projections.
    pub projections: bool,
    /// Places on the checkerboard.
    pub checks: bool,
    /// Camera, theme, size, display: all that needs a new picture but no new data.
    pub view: bool,
}

impl Changes {
    /// Everything.
    pub const ALL: Changes = Changes {
        mesh: true,
        positions: true,
        targets: true,
        looks: true,
        marks: true,
        shapes: true,
        projections: true,
        checks: true,
        view: true,
    };

    /// Whether there is anything.
    pub fn any(self) -> bool {
        self != Changes::default()
    }
}

/// The state of the view.
#[derive(Debug)]
pub struct Stage {
    /// The mesh.
    pub subject: Subject,
    /// `#E by 2`: the edges that can be picked and selected.
    pub edges: Vec<[u32; 2]>,
    /// The camera.
    pub camera: Camera,
    /// Values and marks.
    pub looks: Looks,
    /// Colour of the tint.
    pub tint: [f32; 3],
    /// All handles.
    pub handles: Vec<Handle>,
    /// Fitted shapes in view coordinates, `SHAPE_NUMBERS` each.
    pub shapes: Vec<f32>,
    /// Projected points, outlines, arrows.
    pub projections: Projections,
    /// The checkerboard of a flat map.
    pub checks: Checks,
    /// Sides of the faces that a flat map turns over, by their vertices.
    pub flipped: Vec<[u32; 2]>,
    /// The ghost of the model as it was opened, and the ground.
    pub around: Surroundings,
    /// The ends of the measuring tape: none, the first, or both.
    pub tape: Vec<u32>,
    /// What is switched on.
    pub display: Display,
    /// What is wanted of the gizmo.
    pub gizmo: Wanted,
    /// Dark theme.
    pub dark: bool,
    /// White behind everything, for figures, instead of the theme's colour.
    pub white: bool,
    /// Since the last picture.
    pub changes: Changes,
    /// The point that a drag turns the camera about.
    turned_about: Vec3,
    /// Whether the camera stands as `fit` left it, and follows the canvas when that is resized.
    framed: bool,
    map: Option<DepthMap>,
}

impl Default for Stage {
    fn default() -> Self {
        Stage {
            subject: Subject::default(),
            edges: Vec::new(),
            camera: Camera::default(),
            looks: Looks::default(),
            tint: [0.2, 0.7, 0.3],
            handles: Vec::new(),
            shapes: Vec::new(),
            projections: Projections::default(),
            checks: Checks::default(),
            flipped: Vec::new(),
            around: Surroundings::default(),
            tape: Vec::new(),
            display: Display { edges: true, ..Display::default() },
            gizmo: Wanted::default(),
            dark: false,
            white: false,
            changes: Changes::ALL,
            turned_about: Vec3::ZERO,
            framed: true,
            map: None,
        }
    }
}

impl Stage {
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
        let same = faces == self.subject.faces
            && curves == self.subject.curves
            && count == self.subject.exact.len();
        if same {
            return self.set_positions(coordinates);
        }
        self.subject = Subject::new(faces, curves, coordinates)?;
        self.edges.clear();
        self.looks = Looks::default();
        self.handles.clear();
        self.shapes.clear();
        self.projections = Projections::default();
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
        self.subject.set_positions(coordinates)?;
        self.changes.positions = true;
        self.map = None;
        self.keep_reach();
        Ok(())
    }

    /// How many vertices and faces there are.
    pub fn counts(&self) -> (usize, usize) {
        (self.subject.positions.len(), self.subject.faces.len())
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
            handles.push(Handle { vertex, kind, target });
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
            self.shapes.extend(self.subject.relative(centre).to_array());
            self.shapes.extend(&row[4..]);
        }
        self.changes.shapes = true;
        Ok(())
    }

    /// Sets the projections of the constraints.
    pub fn set_projections(&mut self, projections: Projections) {
        self.changes.projections |= projections != self.projections;
        self.projections = projections;
    }

    /// The projected points relative to the view's centre, each with its distance from its vertex.
    pub fn projected(&self) -> impl Iterator<Item = Vec4> + '_ {
        self.projections.points.iter().map(|point| {
            let at = self.subject.positions[point.vertex as usize] + point.way;
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

    /// Sets the size of the canvas in CSS pixels.
    pub fn resize(&mut self, canvas: Vec2) {
        self.camera.canvas = canvas.max(Vec2::ONE);
        self.refit();
        self.view_changed();
    }

    /// Fits again, unless somebody has moved the camera since.
    pub(super) fn refit(&mut self) {
        if self.framed {
            self.fit();
        }
    }

    /// Whether the camera stands as `fit` left it.
    pub(super) fn is_framed(&self) -> bool {
        self.framed
    }

    /// Says whether the camera stands as `fit` would leave it, and lets it.
    pub(super) fn set_framed(&mut self, framed: bool) {
        self.framed = framed;
        self.refit();
        self.view_changed();
    }

    /// Sets the vertical axis.
    pub fn set_up(&mut self, up: Up) {
        if up != self.camera.up {
            self.camera.up = up;
            self.surround();
            self.fit();
        }
    }

    /// Turns the camera about the middle of the canvas by a drag in CSS pixels.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.camera.orbit(dx, dy);
        self.framed = false;
        self.view_changed();
    }

    /// Begins to turn the camera by a drag: about what is under the cursor, or where nothing is about
    /// the middle of the model, or what is in the middle of the canvas when that is out of sight.
    pub fn begin_turn(&mut self, cursor: Vec2) {
        let [low, high] = self.bounds();
        let middle = (low + high) * 0.5;
        let (screen, depth) = self.camera.eye().project(middle);
        let inside = screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.camera.canvas).all();
        let otherwise = if inside && depth > 0.0 { middle } else { self.camera.pivot };
        self.turned_about = self.surface_at(cursor).unwrap_or(otherwise);
    }

    /// Turns the camera about the point of [`Stage::begin_turn`], which keeps its place.
    pub fn turn(&mut self, dx: f32, dy: f32) {
        self.camera.orbit_about(self.turned_about, dx, dy);
        self.framed = false;
        self.view_changed();
    }

    /// Slides the picture by a drag in CSS pixels.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.camera.pan(dx, dy);
        self.framed = false;
        self.view_changed();
    }

    /// Comes `factor` times nearer (farther when less than one) to what is under the cursor.
    pub fn zoom(&mut self, factor: f32, cursor: Vec2) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        let anchor = self.surface_at(cursor).unwrap_or_else(|| self.camera.on_pivot_plane(cursor));
        let size = self.size();
        self.camera.zoom(factor, anchor, size * 1e-3, size * 50.0);
        self.framed = false;
        self.view_changed();
    }

    /// Leaves so much free at the lower edge of the canvas when something is framed, in CSS pixels. What is
    /// framed now moves away from there, and not back.
    pub fn cover(&mut self, pixels: f32) {
        let is_more = pixels > self.camera.covered;
        self.camera.covered = pixels;
        if is_more && self.framed {
            self.fit();
        }
    }

    /// The point of the surface under the cursor.
    fn surface_at(&self, cursor: Vec2) -> Option<Vec3> {
        let hit = picking::pick_face(&self.subject, &self.camera, cursor)?;
        let (from, direction) = self.camera.eye().ray(cursor);
        Some(from + direction * hit.along)
    }

    /// Fills the canvas with the whole model, from where the camera looks now.
    pub fn fit(&mut self) {
        let radius = self.size() * 1e-3;
        frame(&mut self.camera, self.subject.used_positions(), radius);
        self.framed = true;
        self.view_changed();
    }

    /// Fills the canvas with some vertices and a little around them.
    ///
    /// # Errors
    /// A vertex that does not exist.
    pub fn fit_vertices(&mut self, vertices: &[u32]) -> Result<(), ViewError> {
        check_indices("vertices", vertices, self.counts().0)?;
        self.come_near(vertices, self.size() * 0.04);
        Ok(())
    }

    /// Fills the canvas with some vertices and so much around them.
    pub(super) fn come_near(&mut self, vertices: &[u32], around: f32) {
        let points = vertices.iter().map(|&v| self.subject.positions[v as usize]);
        frame(&mut self.camera, points, around);
        self.framed = false;
        self.view_changed();
    }

    /// Looks from a named side and fills the canvas.
    ///
    /// # Errors
    /// An unknown name.
    pub fn preset(&mut self, side: &str) -> Result<(), ViewError> {
        self.camera.look_from(side)?;
        self.fit();
        Ok(())
    }

    /// Half the diagonal of the bounding box; 1 where there is none.
    pub fn size(&self) -> f32 {
        let [low, high] = self.bounds();
        let size = (high - low).length() * 0.5;
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    }

    pub(super) fn bounds(&self) -> [Vec3; 2] {
        let points = self.subject.used_positions();
        let low = points.clone().reduce(Vec3::min).unwrap_or_default();
        [low, points.reduce(Vec3::max).unwrap_or_default()]
    }

    /// Where each handle should be, relative to the view's centre.
    pub fn targets(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.handles.iter().map(|handle| self.subject.relative(handle.target))
    }

    /// The visible vertex nearest to the cursor.
    pub fn pick_vertex(&self, at: Vec2, radius: f32) -> Option<u32> {
        picking::pick_vertex(&self.subject, &self.camera, at, radius)
    }

    /// The handle nearest to the cursor, hidden or not.
    pub fn pick_handle(&self, at: Vec2, radius: f32) -> Option<u32> {
        let handles = self.handles.iter().map(|handle| handle.vertex);
        picking::pick_any(&self.subject, &self.camera, handles, at, radius)
    }

    /// The face under the cursor.
    pub fn pick_face(&self, at: Vec2) -> Option<u32> {
        picking::pick_face(&self.subject, &self.camera, at).map(|hit| hit.face)
    }

    /// Makes sure that it is known what is in front.
    pub(super) fn look(&mut self) {
        self.map.get_or_insert_with(|| DepthMap::new(&self.subject, &self.camera));
    }

    /// What is in front, once [`Stage::look`] has looked.
    pub(super) fn depth_map(&self) -> Option<&DepthMap> {
        self.map.as_ref()
    }

    /// Where a vertex is on the canvas; `None` when hidden or outside.
    pub fn screen(&self, vertex: u32) -> Option<Vec2> {
        let point = *self.subject.positions.get(vertex as usize)?;
        let (screen, _) = self.camera.eye().project(point);
        let inside = screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.camera.canvas).all();
        (inside && picking::visible(&self.subject, &self.camera, vertex)).then_some(screen)
    }
}
