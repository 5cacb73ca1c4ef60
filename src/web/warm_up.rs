//! Iterates on a small grid while the worker is idle, to warm up the compiled code.
//!
//! V8 first compiles a wasm function quickly, and optimises it after it has run for a while, which
//! makes it up to three times as fast. The warm-up triggers this before the user waits for a
//! result, and estimates the speed of the machine from the time of an iteration.

use crate::mesh::read;
use crate::scene::Scene;
use crate::session::{Session, max_interactive_faces};
use crate::solve::clock;
use std::fmt::Write;
use wasm_bindgen::prelude::*;

/// Common kinds with closed-form projections, every energy, the default accelerator.
const SCENE: &str = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
    "constraints": [ { "kind": "circle", "on": "faces" }, { "kind": "plane", "on": "faces" },
                     { "kind": "rigid", "on": "faces" } ],
    "handles": [ { "vertices": [0], "weight": 100 } ],
    "weights": { "shape": 5, "close": 10, "smooth": 2 }, "solver": { "tolerance": 0 } }"#;

/// Vertices along each side of the grid.
const SIDE: u32 = 20;
/// Number of models, one after another, and iterations of each.
const MODELS: u32 = 4;
const STEPS: u32 = 100;
/// Duration of a slice in seconds.
const SLICE: f64 = 0.006;

/// The state of the warm-up.
#[wasm_bindgen]
#[derive(Default)]
pub struct WarmUp {
    session: Option<Session>,
    models: u32,
    steps: u32,
    /// Seconds per iteration in the fastest slice; other work of the machine slows down the others.
    seconds: Option<f64>,
}

#[wasm_bindgen]
impl WarmUp {
    /// Creates a warm-up that has not begun.
    #[wasm_bindgen(constructor)]
    pub fn new() -> WarmUp {
        WarmUp::default()
    }

    /// Iterates for a few milliseconds; returns false when nothing is left.
    pub fn advance(&mut self) -> bool {
        let Some(session) = &mut self.session else {
            if self.models == MODELS {
                return false;
            }
            self.session = Some(grid());
            (self.models, self.steps) = (self.models + 1, 0);
            return true;
        };
        let (begun, before) = (clock::now(), self.steps);
        while self.steps < STEPS && clock::now() < begun + SLICE {
            session.step().expect("a grid stays finite");
            self.steps += 1;
        }
        let seconds = (clock::now() - begun) / f64::from(self.steps - before);
        self.seconds = Some(self.seconds.map_or(seconds, |fastest| fastest.min(seconds)));
        if self.steps == STEPS {
            self.session = None;
        }
        true
    }

    /// Returns the largest number of faces for interactive work on this machine, once measured.
    #[wasm_bindgen(js_name = mostFaces)]
    pub fn max_interactive_faces(&self) -> Option<u32> {
        let faces = (SIDE - 1) * (SIDE - 1);
        self.seconds.map(|seconds| max_interactive_faces(faces as usize, seconds))
    }
}

/// Opens a bumpy grid of quads, in the same way as a file.
fn grid() -> Session {
    let mut obj = String::new();
    let places = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    for (i, j) in places.clone() {
        let height = f64::from((7 * i + 5 * j) % 11) / 21.0;
        writeln!(obj, "v {i}.25 {j}.5 {height}").expect("strings take everything");
    }
    for (i, j) in places.filter(|&(i, j)| i > 0 && j > 0) {
        let last = j * SIDE + i + 1;
        let [below, left] = [last - SIDE, last - 1];
        writeln!(obj, "f {} {below} {last} {left}", below - 1).expect("strings take everything");
    }
    let mesh = read("grid.obj", obj.as_bytes()).expect("the grid is a mesh").mesh;
    let scene = Scene::from_json(SCENE).expect("the scene is valid");
    Session::open(scene, mesh).expect("it can be solved")
}
