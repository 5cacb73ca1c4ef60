//! `shape-up remesh`: covers a surface with quads along its lines of curvature.

use crate::cli::arguments::unknown;
use crate::cli::tokens::{Token, Tokens};
use crate::cli::{Failure, input, output};
use serde::Serialize;
use shape_up::mesh::Edited;
use shape_up::quads::{
    Boundary, MapOptions, PanelSize, RemeshError, RemeshMeasures, RemeshNote, Remeshed,
    direction_weight, follow_weight,
};
use shape_up::session::PanelLayouts;
use shape_up::solve::clock;
use shape_up::words;
use std::path::{Path, PathBuf};

/// The number of panels if neither number nor size is given.
const QUADS: usize = 500;
/// A crease of half a turn is none.
const NO_CREASE: f64 = 180.0;

/// `shape-up remesh`.
#[derive(Debug, PartialEq)]
pub(in crate::cli) struct Remesh {
    input: PathBuf,
    options: MapOptions,
    /// Without a wish, what moves less.
    boundary: Option<Boundary>,
    out: Option<PathBuf>,
    report: Option<PathBuf>,
}

/// The report written by `--report`.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    measures: RemeshMeasures,
    /// What the panels do at the boundary; none if the surface is closed.
    #[serde(skip_serializing_if = "Option::is_none")]
    boundary: Option<Boundary>,
    /// The level of retry: 0 follows the curvature as asked, 3 not at all.
    level: u32,
    notes: Vec<RemeshNote>,
    seconds: Seconds,
}

#[derive(Serialize)]
struct Seconds {
    load: f64,
    total: f64,
}

/// Parses the arguments.
pub(in crate::cli) fn parse(tokens: &mut Tokens) -> Result<Remesh, String> {
    let mut options = MapOptions::of_size(PanelSize::Count(QUADS));
    let (mut out, mut report, mut input, mut sized) = (None, None, None, None);
    let mut boundary = None;
    while let Some(name) = tokens.option(&mut input)? {
        match name.as_str() {
            "--quads" | "--size" => {
                if let Some(first) = sized.replace(name.clone()) {
                    return Err(format!("remesh takes {first} or {name}, not both"));
                }
                options.size = match name.as_str() {
                    "--quads" => PanelSize::Count(tokens.whole(&name, 1)? as usize),
                    _ => PanelSize::Length(tokens.positive(&name)?),
                };
            }
            "--follow" => options.follow = follow_weight(tokens.share(&name)?),
            "--even" => options.direction = direction_weight(tokens.share(&name)?),
            "--crease" => {
                let degrees = tokens.not_negative(&name)?;
                options.crease = (degrees < NO_CREASE).then_some(degrees);
            }
            "--boundary" => {
                let all = [Boundary::Followed, Boundary::Cut];
                boundary = Some(*tokens.word_of(&name, &all, |boundary| boundary.word())?);
            }
            "--out" => out = Some(tokens.mesh(&name)?),
            "--report" => report = Some(tokens.output(&name)?),
            _ => return Err(unknown(&Token::Option(name), "remesh")),
        }
    }
    let input = input.ok_or("remesh needs a mesh file")?;
    Ok(Remesh { input, options, boundary, out, report })
}

/// Covers the surface, and writes the files.
pub(in crate::cli) fn run(asked: &Remesh) -> Result<(), Failure> {
    let started = clock::now();
    let path = asked.input.display();
    if input::is_scene(&asked.input) {
        return Err(Failure::Usage(format!("remesh takes a mesh file, found `{path}`")));
    }
    let input::Input { scene, mesh, frame, mut remarks, .. } = input::read(&asked.input)?;
    output::check(asked.out.iter().chain(&asked.report))?;
    scene.validate(&mesh).map_err(|error| input::at(&asked.input)(error.into()))?;
    let load = clock::now() - started;
    let mut layouts = PanelLayouts::new(mesh, &scene.units, &[]);
    let found = layouts.remesh(&asked.options, asked.boundary, &mut |_| ());
    let (found, boundary) = found
        .map_err(|error| Failure::Input(format!("{path}: {}", refusal(&error, &scene.units))))?;
    let seconds = Seconds { load, total: clock::now() - started };
    let mut files: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(out) = &asked.out {
        // With the groups, curves and faces with holes of the input, as in the page.
        let Edited { mesh: mut made, origins } = Edited::covering(layouts.shape(), &found.mesh);
        origins.carry(layouts.shape(), &mut made);
        let (file, remark) = output::mesh_file(out, &made, &frame);
        files.push((out, file));
        remarks.extend(remark);
    }
    let mut text = format!("{path}: {}\n", summary(&found, &scene.units));
    found.notes.iter().for_each(|note| text += &format!("note: {}\n", note.words));
    text += &output::notes(&remarks);
    if let Some(to) = &asked.report {
        let Remeshed { measures, level, notes, .. } = found;
        let report = Report { measures, boundary, level, notes, seconds };
        files.push((to, output::json(&report).into_bytes()));
    }
    output::write(&files)?;
    output::print(&text)
}

/// One line on the result: `490 panels, 12 irregular vertices, edges 6.0° off the lines of curvature`.
fn summary(found: &Remeshed, units: &str) -> String {
    let RemeshMeasures { quads, other_faces, irregular, angle, edge, .. } = &found.measures;
    let irregular = irregular.inside + irregular.boundary;
    let mut parts = vec![
        words::count(quads + other_faces, "panel", "panels"),
        words::count(irregular, "irregular vertex", "irregular vertices"),
    ];
    parts.extend(angle.map(|angle| {
        format!("edges {} off the lines of curvature", words::rough_degrees(angle.mean))
    }));
    parts.push(format!("{} on average", words::length(edge.mean, units)));
    parts.join(", ")
}

/// Why nothing came out, with the place; sizes in `units`.
fn refusal(error: &RemeshError, units: &str) -> String {
    match error.place() {
        None => error.words(units),
        Some(place) => {
            let [x, y, z] = [place.x, place.y, place.z].map(words::number);
            format!("{}; at ({x}, {y}, {z})", error.words(units))
        }
    }
}
