//! Times of parts and sheets: the measurements of `.scripts/bench/parts.mjs` in WebAssembly, with
//! the same names.

use super::{black_box, timed};
use serde::Serialize;
use shape_up::fabricate::file::picture;
use shape_up::fabricate::{Build, BuildSettings, LengthInMetres, Product};
use shape_up::mesh::read;

/// Milliseconds of each round.
#[derive(Serialize, Default)]
pub(super) struct Parts {
    /// Flattening, naming and layout of panels; the offset with the smaller errors.
    build: Vec<f64>,
    /// The same with fins along the edges instead of panels.
    fins: Vec<f64>,
    /// The same with a paper model.
    paper: Vec<f64>,
    /// The axes of all three kinds, and their checks.
    axes: Vec<f64>,
    /// The same axes at another distance.
    distance: Vec<f64>,
    /// Drawings of all sheets.
    sheets: Vec<f64>,
    /// All files.
    files: Vec<f64>,
}

/// Builds the mesh of a file `rounds` times.
pub(super) fn parts(path: &str, rounds: usize) -> Parts {
    let mesh = read(path, &std::fs::read(path).expect("the mesh was written"));
    let mesh = mesh.expect("the mesh can be read").mesh;
    let mut found = Parts::default();
    for _ in 0..rounds {
        let of = |product| {
            let unit = LengthInMetres { symbol: "m".to_owned(), metres: 1.0 };
            let settings = BuildSettings { product, ..BuildSettings::default() };
            let (build, ms) = timed(|| Build::new(&mesh, &settings, unit));
            (build.expect("it can be built"), ms)
        };
        found.fins.push(of(Product::Fins).1);
        found.paper.push(of(Product::Paper).1);
        let (mut build, ms) = of(Product::Panels);
        found.build.push(ms);
        found.axes.push(timed(|| build.choices()).1);
        let moved = timed(|| {
            build.move_layer(0.1);
            black_box((build.report(), build.layer()))
        });
        found.distance.push(moved.1);
        let sheets = || build.drawings().iter().map(|own| picture(own, &[])).collect::<Vec<_>>();
        found.sheets.push(timed(sheets).1);
        found.files.push(timed(|| build.files(true)).1);
    }
    found
}
