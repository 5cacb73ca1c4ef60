//! `gallery-pictures FOLDER`: solves every example and writes its files for the gallery: pictures
//! of the start and the end, `<id>-start.svg` and `<id>-end.svg`, and the measurements in
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

/// The size of the pictures in CSS pixels, twice their size in the gallery.
const SIZE: Vec2 = Vec2::new(432.0, 312.0);
/// The number of bins of the histograms of angles, each five degrees wide.
const BINS: usize = 36;

/// The measurements of an example.
#[derive(Serialize)]
struct Measurements {
    id: &'static str,
    iterations: u32,
    /// The total energy at the start and at the end; none without constraints.
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<[f64; 2]>,
    /// Histograms of the angles at corners of faces, at rest and at the end, in bins of equal width
    /// from 0 to 180 degrees; only for scenes of squares.
    #[serde(skip_serializing_if = "Option::is_none")]
    angles: Option<[Vec<u32>; 2]>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let [_, folder] = <[String; 2]>::try_from(std::env::args().collect::<Vec<_>>())
        .map_err(|_| "usage: gallery-pictures FOLDER")?;
    let folder = Path::new(&folder);
    std::fs::create_dir_all(folder)?;
    let results =
        EXAMPLES.iter().map(|example| picture(example, folder)).collect::<Result<Vec<_>, _>>()?;
    let results = serde_json::to_string(&results)?;
    Ok(std::fs::write(folder.join("results.json"), results + "\n")?)
}

/// Solves an example and draws its start and end with the same camera. For an example without
/// constraints, made to be flattened, the end is its flat map, seen from above.
fn picture(example: &Example, folder: &Path) -> Result<Measurements, Box<dyn Error>> {
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
    let also_framed: &[Point] = if is_map { &[] } else { &end };
    let framed: Vec<_> =
        start.iter().chain(also_framed).map(|&p| state.mesh().relative(DVec3::from(p))).collect();
    let margin = 0.01 * state.size();
    state.move_camera(|camera| framing::frame(camera, framed.into_iter(), margin));
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
    Ok(Measurements {
        id: example.id,
        iterations: report.iterations,
        energy: (!is_map).then_some([report.energy.initial.total, report.energy.last.total]),
        angles: squares.then(|| [&session.mesh().positions, &end].map(|at| histogram(at))),
    })
}

/// Returns the vertices on the flat map, with the default settings of the page.
fn flat_map(session: &Session) -> Result<Vec<Point>, SolveError> {
    let (weights, norm) = (ConformalWeights::default(), ConformalNorm::default());
    let map = Parametrization::new(session.mesh(), session.topology(), weights, norm)?;
    Ok(map.uv.iter().map(|&[u, v]| [u, v, 0.0]).collect())
}
