//! The parts of the state of a view: its contents (mesh, handles, shapes, projections, tape), its
//! look (colours, marks, theme, switches), its viewpoint, and flags of changes since the last
//! picture.

use crate::view::appearance::{Appearance, DotKind};
use crate::view::camera::Camera;
use crate::view::model::{Checks, ProjectionMarks, RenderMesh};
use crate::view::picking::DepthMap;
use glam::{DVec3, Vec3};

/// The mesh and the marks on it.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub(super) mesh: RenderMesh,
    /// `#E by 2`: the edges that can be picked and selected.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) handles: Vec<HandleMark>,
    pub(super) shapes: Vec<FittedShape>,
    pub(super) projections: ProjectionMarks,
    pub(super) checks: Checks,
    /// Sides of the faces that a flat map flips: `#sides by 2`.
    pub(super) flipped: Vec<[u32; 2]>,
    pub(super) tape: Vec<u32>,
}

/// Colours, marks, theme and switches.
#[derive(Debug)]
pub(super) struct Look {
    pub(super) appearance: Appearance,
    pub(super) display: Display,
    pub(super) dark: bool,
    /// A grey background for figures, instead of that of the theme.
    pub(super) background: Option<f32>,
    /// Strength of the ambient occlusion, from 0 to 1.
    pub(super) occlusion: f32,
}

impl Default for Look {
    fn default() -> Self {
        Look {
            appearance: Appearance::default(),
            display: Display { edges: true, computed: true, ..Display::default() },
            dark: false,
            background: None,
            occlusion: 0.0,
        }
    }
}

/// A shape fitted to points, relative to the view's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FittedShape {
    /// A circle: centre, unit normal, radius.
    Circle(Vec3, Vec3, f32),
    /// A sphere: centre, radius.
    Sphere(Vec3, f32),
}

impl FittedShape {
    /// Returns the centre of a circle and two perpendicular radii; none of a sphere.
    pub fn radii(&self) -> Option<(Vec3, [Vec3; 2])> {
        let FittedShape::Circle(centre, normal, radius) = *self else { return None };
        let u = normal.any_orthonormal_vector() * radius;
        Some((centre, [u, normal.cross(u)]))
    }

    /// Returns the corners of a cube around it.
    pub fn corners(&self) -> [Vec3; 8] {
        let (FittedShape::Circle(centre, _, radius) | FittedShape::Sphere(centre, radius)) = *self;
        let side = |k: usize| if k & 1 == 0 { radius } else { -radius };
        std::array::from_fn(|k| centre + Vec3::new(side(k), side(k >> 1), side(k >> 2)))
    }
}

/// A handle: a vertex that is held softly or exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleMark {
    /// The vertex.
    pub vertex: u32,
    /// [`DotKind::Handle`], [`DotKind::Fixed`] or [`DotKind::Active`].
    pub kind: DotKind,
    /// The target position, in file coordinates.
    pub target: DVec3,
}

/// The parts of the view that are switched on.
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
    /// The layer beside the surface and the lines over it: they were computed for the current shape,
    /// and would be false beside the original.
    pub computed: bool,
}

/// Flags of what has changed since the last picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Faces, curves, edges.
    pub mesh: bool,
    /// Vertex positions.
    pub positions: bool,
    /// Handle targets.
    pub targets: bool,
    /// Values and marks of faces.
    pub appearance: bool,
    /// The sets of dots and pull lines.
    pub marks: bool,
    /// Fitted shapes.
    pub shapes: bool,
    /// The projections.
    pub projections: bool,
    /// Texture coordinates of the checkerboard.
    pub checks: bool,
    /// Ghost and ground.
    pub around: bool,
    /// The layer beside the surface.
    pub layer: bool,
    /// The lines over the surface.
    pub lines: bool,
    /// Camera, theme, size, display: all that needs a new picture but no new data.
    pub view: bool,
}

impl Changes {
    /// Everything.
    pub const ALL: Changes = Changes {
        mesh: true,
        positions: true,
        targets: true,
        appearance: true,
        marks: true,
        shapes: true,
        projections: true,
        checks: true,
        around: true,
        layer: true,
        lines: true,
        view: true,
    };

    /// Returns whether anything has changed.
    pub fn any(self) -> bool {
        self != Changes::default()
    }
}

/// The camera, and data that depends on it.
#[derive(Debug)]
pub(super) struct Viewpoint {
    pub(super) camera: Camera,
    /// The point about which a drag turns the camera.
    pub(super) turned_about: Vec3,
    /// Whether the camera is as `fit` left it; then it is fitted again when the canvas is resized.
    pub(super) framed: bool,
    /// The frontmost face per pixel, computed on first use after camera or mesh have moved.
    pub(super) depth_map: Option<DepthMap>,
}

impl Default for Viewpoint {
    fn default() -> Self {
        let camera = Camera::default();
        Viewpoint { camera, turned_about: Vec3::ZERO, framed: true, depth_map: None }
    }
}

impl Viewpoint {
    /// Discards the depth map after camera or mesh have moved.
    pub(super) fn forget_depth(&mut self) {
        self.depth_map = None;
    }
}
