//! The scene as a value.

use super::SceneError;
use super::closeness::Closeness;
use super::lesson::Lesson;
use super::presentation::Slide;
use crate::constraint::{Kind, Selector, Sets};
use crate::fabricate::BuildSettings;
use crate::json::{indices, present};
use crate::mesh::{Mesh, Point, Read, counted};
use crate::solve::{Hold, Require, Smoothness, SolverSettings, Weights};
use serde::{Deserialize, Deserializer};
use std::rc::Rc;

/// A scene file, checked for form. Whether its indices and names fit the mesh is checked when a
/// session opens it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Shown as the name of the model.
    #[serde(default)]
    pub title: String,
    /// Unit of length, such as `"m"`; empty when not known.
    #[serde(default)]
    pub units: String,
    /// Which axis points up.
    #[serde(default)]
    pub up: Up,
    /// The rest shape.
    pub mesh: MeshSource,
    /// Another pose of the mesh, from which the kinds that keep a rest shape take it; their own when absent.
    #[serde(default, deserialize_with = "present")]
    pub pose: Option<Pose>,
    /// Where the iteration starts, `#V by 3`; at the design, or at rest, when absent.
    #[serde(default, deserialize_with = "present")]
    pub current: Option<Vec<Point>>,
    /// Named sets.
    #[serde(default)]
    pub sets: Sets,
    /// One entry of the list of constraints: a kind on a selector.
    #[serde(default)]
    pub constraints: Vec<ConstraintSpec>,
    /// Handles.
    #[serde(default)]
    pub handles: Vec<HandleSpec>,
    /// The weights of Eq. 13.
    #[serde(default)]
    pub weights: Weights,
    /// The closeness energy, Eq. 11.
    #[serde(default)]
    pub closeness: Closeness,
    /// The smoothness energy, Eq. 12.
    #[serde(default)]
    pub smoothness: Smoothness,
    /// How it is solved.
    #[serde(default)]
    pub solver: SolverSettings,
    /// The exercise that it is.
    #[serde(default, deserialize_with = "present")]
    pub lesson: Option<Lesson>,
    /// How the shape is to be built.
    #[serde(default, deserialize_with = "present")]
    pub build: Option<Box<BuildSettings>>,
    /// Shapes that were kept.
    #[serde(default)]
    pub variants: Variants,
    /// The steps in which it is shown to others, [`Slide::MOST`] at most.
    #[serde(default)]
    pub steps: Vec<Slide>,
}

impl Scene {
    /// A scene without constraints and with the default settings.
    pub fn new(mesh: MeshSource) -> Scene {
        Scene {
            title: String::new(),
            units: String::new(),
            up: Up::Z,
            mesh,
            pose: None,
            current: None,
            sets: Sets::new(),
            constraints: Vec::new(),
            handles: Vec::new(),
            weights: Weights::default(),
            closeness: Closeness::default(),
            smoothness: Smoothness::default(),
            solver: SolverSettings::default(),
            lesson: None,
            build: None,
            variants: Variants::default(),
            steps: Vec::new(),
        }
    }
}

/// Shapes that were kept, to compare them and to go back to them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variants {
    /// In the order in which they were kept, [`Variants::MOST`] at most.
    pub kept: Vec<Variant>,
    /// The one that closeness and smoothness hold the shape to; none for the rest shape.
    #[serde(default, deserialize_with = "present")]
    pub design: Option<usize>,
}

/// A shape that was kept.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variant {
    /// Its name.
    pub name: String,
    /// `#V by 3`.
    #[serde(deserialize_with = "shared")]
    pub positions: Rc<[Point]>,
}

impl Variants {
    /// No more are kept.
    pub const MOST: usize = 12;

    /// The shape that is held to instead of the rest shape, `#V by 3`.
    pub fn design_positions(&self) -> Option<&[Point]> {
        self.design.and_then(|index| self.kept.get(index)).map(|variant| &*variant.positions)
    }
}

fn shared<'de, D: Deserializer<'de>>(from: D) -> Result<Rc<[Point]>, D::Error> {
    Vec::deserialize(from).map(Rc::from)
}

/// Which axis points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// y, as in most viewers.
    Y,
    /// z, as in Rhino.
    #[default]
    Z,
}

impl Up {
    /// The unit vector that points up.
    pub fn direction(self) -> Point {
        match self {
            Up::Y => [0.0, 1.0, 0.0],
            Up::Z => [0.0, 0.0, 1.0],
        }
    }
}

/// Where the mesh of a scene comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshSource {
    /// A file beside the scene: path relative to it.
    File(String),
    /// In the scene itself.
    Inline(Box<Mesh>),
}

/// Another pose of the mesh of a scene: other positions of its vertices (deformation transfer, paper section 6).
#[derive(Clone, Debug, PartialEq)]
pub enum Pose {
    /// A mesh file beside the scene, with the same faces. It has to be read before the scene is opened.
    File(String),
    /// `#V by 3`.
    Positions(Rc<[Point]>),
}

impl Pose {
    /// That of the mesh in another file, whose faces have to be those of `mesh`.
    ///
    /// # Errors
    /// When they are not; `name` is that of the file.
    pub fn of(name: &str, mut posed: Read, mesh: &Mesh) -> Result<Pose, SceneError> {
        if posed.mesh.positions.len() != mesh.positions.len() {
            posed.weld();
        }
        let Mesh { positions, faces, .. } = posed.mesh;
        if positions.len() == mesh.positions.len() && faces == mesh.faces {
            return Ok(Pose::Positions(positions.into()));
        }
        let counts = |vertices: usize, faces: usize| {
            let [vertices, faces] =
                [counted(vertices, "vertex", "vertices"), counted(faces, "face", "faces")];
            format!("{vertices} and {faces}")
        };
        let message = format!(
            "{name} is no pose of the model: it has {}, expected the {} of the model, in their order",
            counts(positions.len(), faces.len()),
            counts(mesh.positions.len(), mesh.faces.len())
        );
        Err(SceneError { path: "pose".to_owned(), message })
    }

    /// `#V by 3`, if it was read.
    pub fn positions(&self) -> Option<&[Point]> {
        match self {
            Pose::File(_) => None,
            Pose::Positions(positions) => Some(positions),
        }
    }
}

/// A kind of constraint on a selector.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintSpec {
    /// The operator with its parameters.
    pub kind: Kind,
    /// Which vertices.
    pub on: Selector,
    /// `w_i` of Eq. 4, not negative.
    pub weight: f64,
    /// Whether it counts; a disabled one stays in the list.
    pub enabled: bool,
    /// Its name; empty for the label of its kind.
    pub name: String,
    /// Whether it is weighed, or met.
    pub require: Require,
    /// The faces of which less is required.
    pub eased: Option<EasedFaces>,
}

/// Faces that are met within a larger length than the other ones of a row, as they would fold nearer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EasedFaces {
    /// The length, above zero, in the unit of the mesh.
    pub within: f64,
    /// Indices of faces.
    #[serde(deserialize_with = "indices::deserialize")]
    pub faces: Vec<u32>,
}

impl ConstraintSpec {
    /// Its name, or the label of its kind where it has none.
    pub fn label(&self) -> &str {
        if self.name.is_empty() { self.kind.info().label } else { &self.name }
    }
}

/// Vertices held at targets.
#[derive(Clone, Debug, PartialEq)]
pub struct HandleSpec {
    /// Indices of vertices.
    pub vertices: Vec<u32>,
    /// `#vertices by 3`; the rest positions when absent.
    pub targets: Option<Vec<Point>>,
    /// How the targets are met.
    pub hold: Hold,
}

/// The weight of a soft handle that does not say its own.
pub const HANDLE_WEIGHT: f64 = 100.0;
