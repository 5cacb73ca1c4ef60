//! The scene of a mesh file that the user opens, with settings that keep a real mesh intact.
//!
//! With the defaults of a scene file (weights 1, 0, 0), constraints on single faces can shrink or
//! fold the mesh, and constraints on a region can tear it from the rest. Here a weak closeness term
//! keeps each vertex near its position, and the displacement is smoothed. The weight of the shapes
//! is so much larger that they are met all the same.

use super::{MeshSource, PRESETS, Scene};

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
