//! `shape-up check`: what there is to say of a mesh before it is solved.

use super::{Failure, input, output};
use serde::Serialize;
use shape_up::mesh::{
    BoundingSphere, Circularity, Measures, Mesh, Planarity, Topology, components,
};
use std::collections::BTreeMap;
use std::path::Path;

/// The report that `--report` writes.
#[derive(Serialize)]
struct Check {
    vertices: usize,
    edges: usize,
    faces: usize,
    curves: usize,
    tets: usize,
    groups: Vec<String>,
    /// How many faces have how many corners.
    face_degrees: BTreeMap<usize, usize>,
    /// How many vertices have how many neighbours.
    vertex_degrees: BTreeMap<usize, usize>,
    boundary: Boundary,
    /// Connected parts; a vertex that nothing uses is none.
    components: usize,
    planarity: Planarity,
    circularity: Circularity,
    problems: Vec<Problem>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct Boundary {
    loops: usize,
    edges: usize,
}

#[derive(Serialize)]
struct Problem {
    message: String,
    count: usize,
    line: Option<usize>,
}

pub(super) fn check(path: &Path, report: Option<&Path>) -> Result<(), Failure> {
    let read = input::read_mesh(path)?;
    let mesh = &read.mesh;
    let topology = Topology::new(mesh);
    let boundary_edges =
        (0..topology.edges().len()).filter(|&e| topology.is_boundary_edge(e as u32)).count();
    let diameter = BoundingSphere::of(&mesh.positions).diameter();
    let measures = Measures::new(&mesh.positions, &mesh.faces, diameter);
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
        problems: problems.collect(),
        notes: read.notes.clone(),
    };
    if let Some(report) = report {
        let text = serde_json::to_string_pretty(&check);
        let text = text.expect("a check is plain data with finite numbers") + "\n";
        output::write(&[(report, text)])?;
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
        output::planarity(&check.planarity, ""),
        output::circularity(&check.circularity, ""),
    ];
    lines.extend(check.problems.iter().map(|problem| format!("problem: {}", problem.message)));
    lines.extend(check.notes.iter().map(|note| format!("note: {note}")));
    lines.join("\n") + "\n"
}

fn tally(degrees: impl Iterator<Item = usize>) -> BTreeMap<usize, usize> {
    let mut counts = BTreeMap::new();
    for degree in degrees {
        *counts.entry(degree).or_insert(0) += 1;
    }
    counts
}

/// Connected parts of the vertices that something uses.
fn parts(mesh: &Mesh) -> usize {
    let tets = mesh.tets.iter().map(|tet| tet.as_slice());
    let elements = || mesh.faces.iter().chain(mesh.curves.iter()).chain(tets.clone());
    let labels = components(mesh.positions.len(), elements());
    let mut used: Vec<u32> = elements().map(|element| labels[element[0] as usize]).collect();
    used.sort_unstable();
    used.dedup();
    used.len()
}
