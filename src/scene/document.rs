//! Data types of the scene.

use super::SceneError;
use super::build::BuildSettings;
use super::closeness::{Closeness, Target};
use super::lesson::Lesson;
use super::presentation::{Slide, Variants};
use crate::constraint::{Kind, Selector, Sets};
use crate::json::{Entries, Object, indices, object, object_or_none, objects, points, present};
use crate::mesh::{Mesh, Point, Read, Topology};
use crate::solve::{Constraints, Hold, Problem, Require, Smoothness, SolverSettings, Weights};
use crate::words;
use serde::ser::{Error, Serializer};
use serde::{Deserialize, Deserializer, Serialize};
use std::rc::Rc;
use std::sync::atomic::{AtomicU32, Ordering};

/// A scene file, checked for form. Its indices and names are checked against the mesh when a
/// session opens it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Name of the model.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// Unit of length, such as `"m"`; empty if unknown.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub units: String,
    /// The axis that points up.
    #[serde(default, skip_serializing_if = "is_default")]
    pub up: Up,
    /// The distance within which panels have their shape, in the unit of the mesh; if absent, that
    /// which their constraint requires, or one that suits the mesh.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// The rest shape.
    pub mesh: MeshSource,
    /// Another pose, which gives the rest shapes of constraints; the mesh itself if absent.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub pose: Option<Pose>,
    /// Start positions, `#V by 3`; if absent, the design of `variants`, else the rest positions.
    #[serde(default, deserialize_with = "points", skip_serializing_if = "Option::is_none")]
    pub current: Option<Vec<Point>>,
    /// Named sets.
    #[serde(default, deserialize_with = "sets", skip_serializing_if = "Sets::is_empty")]
    pub sets: Sets,
    /// Constraints, each a kind on a selector. Written even if empty: they are the main content.
    #[serde(default)]
    pub constraints: Vec<ConstraintSpec>,
    /// Handles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub handles: Vec<HandleSpec>,
    /// The weights of Eq. 13.
    #[serde(
        default,
        deserialize_with = "object",
        skip_serializing_if = "is_default",
        serialize_with = "changed"
    )]
    pub weights: Weights,
    /// The closeness energy, Eq. 11.
    #[serde(default, skip_serializing_if = "is_default")]
    pub closeness: Closeness,
    /// The smoothness energy, Eq. 12.
    #[serde(
        default,
        deserialize_with = "object",
        skip_serializing_if = "is_default",
        serialize_with = "changed"
    )]
    pub smoothness: Smoothness,
    /// Solver settings.
    #[serde(
        default,
        deserialize_with = "object",
        skip_serializing_if = "is_default",
        serialize_with = "changed"
    )]
    pub solver: SolverSettings,
    /// How its hard constraints were met: a run does the same again.
    #[serde(
        default,
        deserialize_with = "object",
        skip_serializing_if = "is_default",
        serialize_with = "changed"
    )]
    pub attempt: ChosenAttempt,
    /// Lesson, if the scene is an exercise.
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    pub lesson: Option<Lesson>,
    /// Settings for building the shape.
    #[serde(
        default,
        deserialize_with = "object_or_none",
        skip_serializing_if = "Option::is_none",
        serialize_with = "changed_build"
    )]
    pub build: Option<Box<BuildSettings>>,
    /// Shapes that the user kept.
    #[serde(default, deserialize_with = "object", skip_serializing_if = "Variants::is_empty")]
    pub variants: Variants,
    /// Steps of the presentation, [`Slide::MOST`] at most.
    #[serde(default, deserialize_with = "objects", skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<Slide>,
}

impl Scene {
    /// Returns a scene without constraints, with the default settings.
    pub fn new(mesh: MeshSource) -> Scene {
        Scene { mesh, ..Scene::default() }
    }

    /// The positions of the other pose, `#V by 3`, which rest shapes are taken from; none without one.
    pub fn pose_positions(&self) -> Option<&[Point]> {
        self.pose.as_ref().and_then(Pose::positions)
    }

    /// Returns the positions that the scene starts at, `#V by 3`: the current ones, otherwise those
    /// of the design, which may be the rest shape `mesh`.
    pub fn start<'a>(&'a self, mesh: &'a Mesh) -> &'a [Point] {
        let design = || self.variants.design_positions().unwrap_or(&mesh.positions);
        self.current.as_deref().unwrap_or_else(design)
    }

    /// Returns the problem on `mesh`, the mesh that [`Scene::mesh`] refers to. `constraints` are
    /// the enabled constraints with resolved selectors, and `closeness_factors`, `#V`, the result
    /// of [`Closeness::factors`].
    pub fn problem<'a>(
        &'a self,
        mesh: &'a Mesh,
        topology: &'a Topology,
        constraints: &'a [Constraints],
        closeness_factors: &'a [f64],
    ) -> Problem<'a> {
        Problem {
            mesh,
            design: self.variants.design_positions(),
            pose: self.pose_positions(),
            topology,
            constraints,
            weights: self.weights,
            closeness_to: self.closeness.to,
            closeness_target: self.closeness.target.as_ref().and_then(Target::mesh),
            boundary_closeness: self.closeness.boundary,
            closeness_factors,
            smoothness: self.smoothness,
            settings: self.solver,
        }
    }
}

fn sets<'de, D: Deserializer<'de>>(from: D) -> Result<Sets, D::Error> {
    let Entries(sets) = Entries::deserialize(from)?;
    Ok(sets.into_iter().map(|(name, Object(set))| (name, set)).collect())
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Writes the entries that are not at their defaults.
fn changed<T: Serialize + Default, S: Serializer>(value: &T, to: S) -> Result<S::Ok, S::Error> {
    let values = |value: &T| serde_json::to_value(value).map_err(S::Error::custom);
    let (own, defaults) = (values(value)?, values(&T::default())?);
    let own = own.as_object().into_iter().flatten();
    to.collect_map(own.filter(|(key, value)| defaults.get(key) != Some(value)))
}

fn changed_build<S: Serializer>(
    build: &Option<Box<BuildSettings>>,
    to: S,
) -> Result<S::Ok, S::Error> {
    match build {
        Some(build) => changed(&**build, to),
        None => to.serialize_none(),
    }
}

/// The axis that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum Up {
    /// y, as in most viewers.
    Y,
    /// z, as in Rhino.
    #[default]
    Z,
}

impl Up {
    /// Returns the unit vector that points up.
    pub fn direction(self) -> Point {
        match self {
            Up::Y => [0.0, 1.0, 0.0],
            Up::Z => [0.0, 0.0, 1.0],
        }
    }
}

/// Source of the mesh of a scene.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshSource {
    /// Path of a mesh file relative to the scene.
    File(String),
    /// A mesh in the scene itself.
    Inline(Box<Mesh>),
}

impl Default for MeshSource {
    fn default() -> MeshSource {
        MeshSource::Inline(Box::default())
    }
}

/// Another pose of the mesh of a scene (deformation transfer, paper section 6).
#[derive(Clone, Debug, PartialEq)]
pub enum Pose {
    /// Path of a mesh file with the same faces, relative to the scene; to be read before opening.
    File(String),
    /// Positions, `#V by 3`.
    Positions(Rc<[Point]>),
}

impl Pose {
    /// Takes the pose from the mesh of another file, called `name`.
    ///
    /// # Errors
    /// If its faces differ from those of `mesh`.
    pub fn of(name: &str, mut posed: Read, mesh: &Mesh) -> Result<Pose, SceneError> {
        if posed.mesh.positions.len() != mesh.positions.len() {
            posed.weld();
        }
        let Mesh { positions, faces, .. } = posed.mesh;
        if positions.len() == mesh.positions.len() && faces == mesh.faces {
            return Ok(Pose::Positions(positions.into()));
        }
        let counts = |vertices: usize, faces: usize| {
            let [vertices, faces] = [
                words::count(vertices, "vertex", "vertices"),
                words::count(faces, "face", "faces"),
            ];
            format!("{vertices} and {faces}")
        };
        let message = format!(
            "{name} is not a pose of the model: it has {}, expected the {} of the model, in their order",
            counts(positions.len(), faces.len()),
            counts(mesh.positions.len(), mesh.faces.len())
        );
        Err(SceneError { path: "pose".to_owned(), message })
    }

    /// Returns the positions, `#V by 3`, if they were read.
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
    /// Selector of the vertices.
    pub on: Selector,
    /// Weight `w_i` of Eq. 4, not negative.
    pub weight: f64,
    /// Whether it is active; a disabled constraint stays in the list.
    pub enabled: bool,
    /// Name; empty for the label of its kind.
    pub name: String,
    /// Whether it is weighted (soft), or has to be met (hard).
    pub require: Require,
    /// Faces with a larger tolerance.
    pub eased: Option<EasedFaces>,
    /// Its number in a session.
    pub number: RowNumber,
}

/// The number of a row of constraints, which tells it from all others of its session: its index changes
/// with the rows before it. It is not written to files, and rows that differ in it alone are equal.
#[derive(Clone, Copy, Debug)]
pub struct RowNumber(u32);

/// The smallest number that no row has had.
static NEXT_ROW: AtomicU32 = AtomicU32::new(0);

impl RowNumber {
    /// Returns the number `number`, which no new row will have.
    pub fn of(number: u32) -> RowNumber {
        NEXT_ROW.fetch_max(number.saturating_add(1), Ordering::Relaxed);
        RowNumber(number)
    }

    /// Returns it as a number.
    pub fn get(self) -> u32 {
        self.0
    }
}

impl Default for RowNumber {
    /// Returns a number that no row has had.
    fn default() -> RowNumber {
        RowNumber(NEXT_ROW.fetch_add(1, Ordering::Relaxed))
    }
}

impl PartialEq for RowNumber {
    fn eq(&self, _: &RowNumber) -> bool {
        true
    }
}

/// Faces with a larger tolerance than the others of a constraint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EasedFaces {
    /// The tolerance, above zero, in the unit of the mesh.
    pub within: f64,
    /// Indices of faces.
    #[serde(with = "indices")]
    pub faces: Rc<[u32]>,
}

/// The attempt by which a search met the hard constraints. The settings of the scene are those of the
/// attempt; it also says which of them the search has changed, so that the next one can begin with
/// those before.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ChosenAttempt {
    /// Where it began.
    pub from: AttemptStart,
    /// The factor by which the weight of smoothness was multiplied, above zero.
    pub smoother: f64,
    /// Whether closeness was to the rest positions before, and to the surface then.
    pub on_surface: bool,
    /// Whether vertices of the boundary were free to leave it before, and are held on it then.
    pub holds_boundary: bool,
    /// Whether they were held softly before, and exactly then.
    pub hardens_boundary: bool,
}

impl Default for ChosenAttempt {
    fn default() -> ChosenAttempt {
        let from = AttemptStart::Soft;
        let [on_surface, holds_boundary, hardens_boundary] = [false; 3];
        ChosenAttempt { from, smoother: 1.0, on_surface, holds_boundary, hardens_boundary }
    }
}

/// Where an attempt to meet hard constraints began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AttemptStart {
    /// At the soft solution.
    #[default]
    Soft,
    /// At the rest shape, or at the soft solution where a handle or a variation pulls.
    Rest,
    /// At the rest shape, as for `Rest`, with exact panels.
    Exact,
    /// At the soft solution, and on through larger tolerances.
    Eased,
}

impl ConstraintSpec {
    /// Returns its name, or the label of its kind if the name is empty.
    pub fn label(&self) -> &str {
        if self.name.is_empty() { self.kind.info().label } else { &self.name }
    }
}

/// A handle: vertices held at targets.
#[derive(Clone, Debug, PartialEq)]
pub struct HandleSpec {
    /// Indices of vertices.
    pub vertices: Vec<u32>,
    /// Targets, `#vertices by 3`; the rest positions if absent.
    pub targets: Option<Vec<Point>>,
    /// Whether the targets are soft, with a weight, or fixed.
    pub hold: Hold,
}

/// Default weight of a soft handle.
pub const HANDLE_WEIGHT: f64 = 100.0;
