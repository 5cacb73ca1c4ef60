//! Presets of weights, closeness and smoothness. They are set together, since the weights of a
//! figure of the paper alone can shrink a mesh to a point. The first is that of a mesh file that the
//! user opens, and keeps real meshes intact.
//!
//! With the defaults of a scene file (weights 1, 0, 0), constraints on single faces can shrink or
//! fold the mesh, and constraints on a region can tear it from the rest. Here a weak closeness term
//! keeps each vertex near its position, and the displacement is smoothed. The weight of the shapes
//! is so much larger that they are met all the same.

use super::{
    BoundaryCloseness, BoundaryRequire, ChosenAttempt, ClosenessTo, MeshSource, Scene, Smoothness,
    SmoothnessOf, Weighting, Weights,
};
use crate::mesh::Topology;
use serde::Serialize;

/// A preset of weights, closeness and smoothness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// Identifier.
    pub id: &'static str,
    /// Name shown to the user.
    pub label: &'static str,
    /// Its effect, and its assumptions about the mesh.
    pub assumes: &'static str,
    needs: Needs,
    weights: Weights,
    to: ClosenessTo,
    boundary: BoundaryRequire,
    smoothness: Smoothness,
}

/// Requirement for a preset to keep a mesh intact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Needs {
    Nothing,
    /// A boundary, which keeps smoothing from shrinking the mesh.
    Boundary,
    /// Handles, which keep the mesh in place.
    Handles,
}

/// A preset offered for a scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PresetOffer {
    /// See [`Preset::id`].
    pub id: &'static str,
    /// See [`Preset::label`].
    pub label: &'static str,
    /// See [`Preset::assumes`].
    pub assumes: &'static str,
    /// The unmet assumption of this scene and its consequence, if any.
    pub warning: Option<&'static str>,
}

const OF_DISPLACEMENT: Smoothness =
    Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
const OF_SURFACE: Smoothness = Smoothness { of: SmoothnessOf::Surface, weighting: Weighting::Auto };

/// All presets; the first is the one for opened mesh files.
pub const PRESETS: &[Preset] = &[
    Preset {
        id: "opened",
        label: "Keep the design",
        assumes: "Shapes come first. Each vertex stays near its original position, and neighbours move together.",
        needs: Needs::Nothing,
        weights: Weights { shape: 1000.0, close: 1.0, smooth: 1.0 },
        to: ClosenessTo::Rest,
        boundary: BoundaryRequire::Off,
        smoothness: OF_DISPLACEMENT,
    },
    Preset {
        id: "fig-5",
        label: "Figure 5: smooth surface",
        assumes: "Vertices glide over the original surface, those of the boundary along their own curve; corners of the boundary stay. The surface is smoothed.",
        needs: Needs::Boundary,
        weights: Weights { shape: 5.0, close: 10.0, smooth: 2.0 },
        to: ClosenessTo::Surface,
        boundary: BoundaryRequire::Exact,
        smoothness: OF_SURFACE,
    },
    Preset {
        id: "fig-7",
        label: "Figure 7: near the original",
        assumes: "Vertices glide over the original surface, those of the boundary along their own curve; corners of the boundary stay. Nothing is smoothed.",
        needs: Needs::Nothing,
        weights: Weights { shape: 5.0, close: 1.0, smooth: 0.0 },
        to: ClosenessTo::Surface,
        boundary: BoundaryRequire::Exact,
        smoothness: OF_SURFACE,
    },
    Preset {
        id: "fig-6",
        label: "Figures 6 and 8: only constraints",
        assumes: "Only constraints and handles count: nothing keeps the mesh near the original.",
        needs: Needs::Handles,
        weights: Weights { shape: 1.0, close: 0.0, smooth: 0.0 },
        to: ClosenessTo::None,
        boundary: BoundaryRequire::Off,
        smoothness: OF_SURFACE,
    },
];

impl Preset {
    /// Applies the preset to `scene`. It names every setting that an attempt may have chosen, which are
    /// then the user's.
    pub fn set(&self, scene: &mut Scene) {
        scene.weights = self.weights;
        scene.closeness.to = self.to;
        scene.closeness.boundary = self.boundary();
        scene.smoothness = self.smoothness;
        scene.attempt = ChosenAttempt::default();
    }

    /// Returns the preset whose settings `scene` has, if any.
    pub fn of(scene: &Scene) -> Option<&'static Preset> {
        let closeness = &scene.closeness;
        PRESETS.iter().find(|preset| {
            preset.weights == scene.weights
                && preset.to == closeness.to
                && preset.boundary() == closeness.boundary.in_effect()
                && preset.smoothness == scene.smoothness
        })
    }

    /// How the preset holds the boundary.
    fn boundary(&self) -> BoundaryCloseness {
        BoundaryCloseness { require: self.boundary, ..BoundaryCloseness::default() }
    }

    /// Returns the offer for a mesh with this topology and this number of handles.
    pub fn offer(&self, topology: &Topology, handles: usize) -> PresetOffer {
        let warning = match self.needs {
            Needs::Boundary if topology.boundary_loops().is_empty() => {
                Some("This mesh has no boundary to hold it: smoothing will shrink it.")
            }
            Needs::Handles if handles == 0 => {
                Some("There are no handles: nothing holds this mesh.")
            }
            _ => None,
        };
        PresetOffer { id: self.id, label: self.label, assumes: self.assumes, warning }
    }
}

/// Tolerance at which a run stops. On ten real meshes of 80 to 2400 vertices, with flat and with
/// circular panels, the error of the worst panel and the displacements have then settled to three
/// digits, after 80 to 950 iterations; a hundredth of it takes half as many again and changes
/// nothing.
const TOLERANCE: f64 = 1e-7;
const ITERATIONS: u32 = 1000;

impl Scene {
    /// Returns the scene of the mesh file `name` that the user opens.
    pub fn opened(name: &str) -> Scene {
        let mut scene = Scene::new(MeshSource::File(name.to_owned()));
        scene.set_opened_defaults();
        scene.solver.iterations = ITERATIONS;
        scene.solver.tolerance = TOLERANCE;
        scene
    }

    /// Sets weights, closeness and smoothness to the defaults for opened mesh files.
    pub fn set_opened_defaults(&mut self) {
        PRESETS[0].set(self);
    }
}
