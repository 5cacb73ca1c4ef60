//! `gallery-pictures FOLDER`: solves every example and writes what the gallery shows of it: a picture
//! of the start and of the end, `<id>-start.svg` and `<id>-end.svg`, and what was measured, in
//! `results.json`. A step of the build, not for users.

mod pictures;

use glam::{DVec3, Vec2};
use serde::Serialize;
use shape_up::example::{EXAMPLES, Example};
use shape_up::mesh::{Point, angle_histogram};
use shape_up::session::Session;
use shape_up::solve::{ConformalNorm, ConformalWeights, Parametrization, SolveError};
use shape_up::view::camera::framing;
use shape_up::view::svg::thumbnail;
use std::error::Error;
use std::path::Path;

/// The size of the pictures in CSS pixels, twice that at which the gallery shows them.
const SIZE: Vec2 = Vec2::new(432.0, 312.0);
/// Width of a bin of the histograms of angles: five degrees.
const BINS: usize = 36;

/// The measurements of an example.
#[derive(Serialize)]
struct Result {
    id: &'static str,
    iterations: u32,
    /// The total energy at the start and at the end; none where nothing is asked of the shape.
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<[f64; 2]>,
    /// How many corners of faces have which angle, at rest and at the end, in bins of equal width
    /// from 0 to 180 degrees; where that is what the scene is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    angles: Option<[Vec<u32>; 2]>,
}

fn main() -> std::result::Result<(), Box<dyn Error>> {
    let [_, folder] = <[String; 2]>::try_from(std::env::args().collect::<Vec<_>>())
        .map_err(|_| "usage: gallery-pictures FOLDER")?;
    let folder = Path::new(&folder);
    std::fs::create_dir_all(folder)?;
    let results = EXAMPLES
        .iter()
        .map(|example| picture(example, folder))
        .collect::<std::result::Result<Vec<_>, _>>()?;
    let results = serde_json::to_string(&results)?;
    Ok(std::fs::write(folder.join("results.json"), results + "\n")?)
}

/// Solves an example and draws it at both ends, from one place. One of which nothing is asked is there
/// to be flattened: its end is its flat map, seen from above.
fn picture(example: &Example, folder: &Path) -> std::result::Result<Result, Box<dyn Error>> {
    let (scene, mesh) = example.build();
    let mut session = Session::open(scene, mesh)?;
    let mut state = pictures::state(&session)?;
    let greatest = pictures::greatest(&pictures::values(&session));
    let start = session.positions();
    let is_map = session.rows().is_empty();
    let end = if is_map {
        flat_map(&session)?
    } else {
        session.solve(false)?;
        session.positions()
    };

    state.resize(SIZE);
    let later: &[Point] = if is_map { &[] } else { &end };
    let seen: Vec<_> =
        start.iter().chain(later).map(|&p| state.mesh().relative(DVec3::from(p))).collect();
    let margin = 0.01 * state.size();
    state.move_camera(|camera| framing::frame(camera, seen.into_iter(), margin));
    std::fs::write(folder.join(format!("{}-start.svg", example.id)), thumbnail::svg(&state))?;
    state.set_positions(end.as_flattened())?;
    if is_map {
        state.preset("top")?;
    }
    let scale = pictures::scale(&session, greatest);
    state.set_face_values(pictures::values(&session), scale)?;
    std::fs::write(folder.join(format!("{}-end.svg", example.id)), thumbnail::svg(&state))?;

    let report = session.report();
    let squares = session.rows().iter().any(|row| row.constraints.kind.info().id == "square");
    let histogram = |positions| angle_histogram(positions, &session.mesh().faces, BINS);
    Ok(Result {
        id: example.id,
        iterations: report.iterations,
        energy: (!is_map).then_some([report.energy.initial.total, report.energy.last.total]),
        angles: squares.then(|| [&session.mesh().positions, &end].map(|at| histogram(at))),
    })
}

/// Where the vertices are on the flat map, with the settings that the page begins with.
fn flat_map(session: &Session) -> std::result::Result<Vec<Point>, SolveError> {
    let (weights, norm) = (ConformalWeights::default(), ConformalNorm::default());
    let map = Parametrization::new(session.mesh(), session.topology(), weights, norm)?;
    Ok(map.uv.iter().map(|&[u, v]| [u, v, 0.0]).collect())
}
