//! `shape-up check`: reports on a mesh before it is solved.

use super::{Failure, input, output};
use serde::Serialize;
use shape_up::fabricate::panel::smallest_box;
use shape_up::mesh::{
    Circularity, CurvatureLines, Measures, Mesh, Planarity, Topology, UnrolledStrip, components,
    gauss_curvature, strips,
};
use shape_up::scene::Forecast;
use shape_up::words;
use std::collections::BTreeMap;
use std::path::Path;

/// The number of lines on strips in the text; the report has all strips.
const LINES: usize = 3;

/// The report written by `--report`.
#[derive(Serialize)]
struct Check {
    vertices: usize,
    edges: usize,
    faces: usize,
    curves: usize,
    tets: usize,
    groups: Vec<String>,
    /// The number of faces for each number of corners.
    face_degrees: BTreeMap<usize, usize>,
    /// The number of vertices for each number of neighbours.
    vertex_degrees: BTreeMap<usize, usize>,
    boundary: Boundary,
    /// The number of connected parts; unused vertices do not count.
    components: usize,
    planarity: Planarity,
    circularity: Circularity,
    /// None without an interior vertex.
    #[serde(skip_serializing_if = "Option::is_none")]
    gauss_curvature: Option<GaussCurvature>,
    strips: Vec<StripReport>,
    curvature: Curvature,
    /// The forecast for panels of one shape; none if no such shape is offered.
    #[serde(skip_serializing_if = "Option::is_none")]
    forecast: Option<Forecast>,
    problems: Vec<Problem>,
    notes: Vec<String>,
}

/// The alignment of the edges with the lines of curvature.
#[derive(Serialize)]
struct Curvature {
    /// The mean angle, weighted by length; left out if the surface has no principal directions.
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_degrees: Option<f64>,
    /// The fraction of the edges, by length, for which the angle is defined.
    directed: f64,
}

#[derive(Serialize)]
struct Boundary {
    loops: usize,
    edges: usize,
}

/// The Gauss curvature of greatest magnitude, in one over squared length.
#[derive(Serialize)]
struct GaussCurvature {
    max: f64,
    vertex: usize,
}

/// One unrolled strip, with the size of the smallest rectangle around it.
#[derive(Serialize)]
struct StripReport {
    quads: usize,
    closed: bool,
    width: f64,
    length: f64,
}

#[derive(Serialize)]
struct Problem {
    message: String,
    count: usize,
    line: Option<usize>,
}

pub(super) fn check(path: &Path, report: Option<&Path>) -> Result<(), Failure> {
    if input::is_scene(path) {
        let what = "check takes a mesh file, or results with --scene SCENE";
        return Err(Failure::Usage(format!("{what}, found `{}`", path.display())));
    }
    let (read, ..) = input::read_mesh(path)?;
    let mesh = &read.mesh;
    let topology = Topology::new(mesh);
    let boundary_edges =
        (0..topology.edges().len()).filter(|&e| topology.is_boundary_edge(e as u32)).count();
    let measures = Measures::new(&mesh.positions, &mesh.faces, mesh.size());
    let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &topology);
    let problems = read.problems.iter().map(|problem| Problem {
        message: problem.to_string(),
        count: problem.count,
        line: problem.line,
    });
    let check = Check {
        vertices: mesh.positions.len(),
        edges: topology.edges().len(),
        faces: mesh.faces.len(),
        curves: mesh.curves.len(),
        tets: mesh.tets.len(),
        groups: mesh.groups.iter().map(|group| group.name.clone()).collect(),
        face_degrees: tally(mesh.faces.iter().map(<[u32]>::len)),
        vertex_degrees: tally(topology.neighbours().iter().map(<[u32]>::len)),
        boundary: Boundary { loops: topology.boundary_loops().len(), edges: boundary_edges },
        components: parts(mesh),
        planarity: measures.planarity,
        circularity: measures.circularity,
        gauss_curvature: largest_gauss_curvature(mesh, &topology),
        strips: strip_reports(mesh, &topology),
        curvature: Curvature { mean_degrees: lines.mean, directed: lines.directed },
        forecast: Forecast::of(mesh, &topology),
        problems: problems.collect(),
        notes: read.notes.clone(),
    };
    if let Some(report) = report {
        output::write(&[(report, output::json(&check))])?;
    }
    output::print(&words(path, &check))
}

fn words(path: &Path, check: &Check) -> String {
    let degrees = |degrees: &BTreeMap<usize, usize>| {
        let each = degrees.iter().map(|(degree, count)| format!("{count} of {degree}"));
        each.collect::<Vec<_>>().join(", ")
    };
    let mut lines = vec![
        path.display().to_string(),
        format!(
            "vertices    {}, by neighbours: {}",
            check.vertices,
            degrees(&check.vertex_degrees)
        ),
        format!("faces       {}, by corners: {}", check.faces, degrees(&check.face_degrees)),
        format!("edges       {}", check.edges),
        format!("boundary    loops: {}, edges: {}", check.boundary.loops, check.boundary.edges),
        format!("components  {}", check.components),
        format!("curves      {}", check.curves),
        format!("tetrahedra  {}", check.tets),
        format!("groups      {}", check.groups.len()),
        output::planarity(&check.planarity, "", 0.0),
        output::circularity(&check.circularity, "", 0.0),
    ];
    if let Some(GaussCurvature { max, vertex }) = check.gauss_curvature {
        lines.push(format!("Gauss curv. greatest {}, at vertex {vertex}", words::number(max)));
    }
    lines.extend(words_of(&check.strips));
    lines.extend(curvature(&check.curvature));
    lines.extend(
        check.forecast.as_ref().map(|forecast| format!("panels      {}", forecast.words(""))),
    );
    lines.extend(check.problems.iter().map(|problem| format!("problem: {}", problem.message)));
    lines.extend(check.notes.iter().map(|note| format!("note: {note}")));
    lines.join("\n") + "\n"
}

fn largest_gauss_curvature(mesh: &Mesh, topology: &Topology) -> Option<GaussCurvature> {
    let at_vertices = gauss_curvature(&mesh.positions, mesh, topology);
    let known = at_vertices.into_iter().enumerate().filter(|(_, value)| value.is_finite());
    let (vertex, max) = known.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))?;
    Some(GaussCurvature { max, vertex })
}

/// Returns all strips; each quad is in two, one for each of its directions.
fn strip_reports(mesh: &Mesh, topology: &Topology) -> Vec<StripReport> {
    let strips = strips(mesh, topology);
    let flat = strips.iter().filter_map(|s| UnrolledStrip::new(&mesh.positions, s, topology));
    let report = |UnrolledStrip { quads, closed, outline }| {
        let (_, [length, width]) = smallest_box(&outline);
        StripReport { quads, closed, width, length }
    };
    flat.map(report).collect()
}

/// Returns a line for each number of quads, the longest strips first.
fn words_of(strips: &[StripReport]) -> Vec<String> {
    let mut by_quads: Vec<&StripReport> = strips.iter().collect();
    by_quads.sort_by_key(|strip| std::cmp::Reverse(strip.quads));
    let alike = by_quads.chunk_by(|a, b| a.quads == b.quads).take(LINES);
    let line = |alike: &[&StripReport]| {
        let widths = alike.iter().map(|strip| strip.width);
        let [least, most] =
            [widths.clone().fold(f64::INFINITY, f64::min), widths.fold(0.0, f64::max)];
        let longest = alike.iter().map(|strip| strip.length).fold(0.0, f64::max);
        format!(
            "strips      {} of {}: laid flat {} to {} wide, up to {} long",
            alike.len(),
            words::count(alike[0].quads, "quad", "quads"),
            words::number(least),
            words::number(most),
            words::number(longest)
        )
    };
    alike.map(line).collect()
}

/// Describes the angle of the edges to the lines of curvature, if it is defined.
fn curvature(edges: &Curvature) -> Option<String> {
    let angle = words::rough_degrees(edges.mean_degrees?);
    Some(format!("curvature   edges are {angle} off the lines of curvature on average"))
}

fn tally(degrees: impl Iterator<Item = usize>) -> BTreeMap<usize, usize> {
    let mut counts = BTreeMap::new();
    for degree in degrees {
        *counts.entry(degree).or_insert(0) += 1;
    }
    counts
}

/// Counts the connected parts, without unused vertices.
fn parts(mesh: &Mesh) -> usize {
    let tets = mesh.tets.iter().map(|tet| tet.as_slice());
    let elements = || mesh.faces.iter().chain(mesh.curves.iter()).chain(tets.clone());
    let labels = components(mesh.positions.len(), elements());
    let mut used: Vec<u32> = elements().map(|element| labels[element[0] as usize]).collect();
    used.sort_unstable();
    used.dedup();
    used.len()
}
