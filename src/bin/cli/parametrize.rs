//! `shape-up parametrize`: a conformal map of a mesh to the plane.

use super::arguments::Parametrize;
use super::{Failure, input, output};
use serde::Serialize;
use shape_up::mesh::{QuasiConformal, Topology, Weld, write_obj_with};
use shape_up::scene::{NamedEnum, UnitsAndUp};
use shape_up::solve::{ConformalNorm, ConformalSeconds, FewerFlips, Parametrization, clock};
use shape_up::words;
use std::path::Path;

/// The report written by `--report`.
#[derive(Serialize)]
struct Report {
    vertices: usize,
    faces: usize,
    parts: usize,
    /// Faces without area, or on the same vertices as another.
    left_out: usize,
    eigenvalue: f64,
    quasi_conformal: QuasiConformal,
    flipped: usize,
    seconds: Seconds,
}

#[derive(Serialize)]
struct Seconds {
    load: f64,
    #[serde(flatten)]
    parts: ConformalSeconds,
    total: f64,
}

pub(super) fn parametrize(asked: &Parametrize) -> Result<(), Failure> {
    let started = clock::now();
    let path = asked.mesh.display();
    let (read, weld, stated) = input::read_mesh(&asked.mesh)?;
    output::check(asked.out.iter().chain(&asked.report))?;
    let mesh = &read.mesh;
    if mesh.faces.is_empty() {
        return Err(Failure::Input(format!("{path}: the mesh has no faces, expected a surface")));
    }
    let loaded = clock::now();
    let topology = Topology::new(mesh);
    let map = Parametrization::new(mesh, &topology, asked.weights, asked.norm);
    let map =
        map.map_err(|error| Failure::Input(format!("{path}: cannot be flattened: {error}")))?;
    let report = Report {
        vertices: mesh.positions.len(),
        faces: mesh.faces.len(),
        parts: map.parts,
        left_out: map.left_out.len(),
        eigenvalue: map.eigenvalue,
        quasi_conformal: map.errors.quasi_conformal,
        flipped: map.errors.flipped,
        seconds: Seconds {
            load: loaded - started,
            parts: map.seconds,
            total: clock::now() - started,
        },
    };
    let mut files: Vec<(&Path, String)> = Vec::new();
    let mut remark = None;
    if let Some(out) = &asked.out {
        let (original, uv) = match &weld {
            None => (mesh, map.uv),
            Some(Weld { original, to, .. }) => {
                (original, to.iter().map(|&vertex| map.uv[vertex as usize]).collect())
            }
        };
        let units = stated.units.as_deref().unwrap_or_default();
        let comments = UnitsAndUp::comments(units, stated.up, original);
        files.push((out, write_obj_with(original, &original.positions, &uv, &comments)));
        remark = output::left_out(out, original, &stated);
    }
    if let Some(to) = &asked.report {
        files.push((to, output::json(&report)));
    }
    output::write(&files)?;
    let mut lines = vec![
        path.to_string(),
        format!("parts            {}", report.parts),
        format!("eigenvalue       {}", words::number(report.eigenvalue)),
        format!(
            "quasi-conformal  mean {}, worst {}",
            words::number(report.quasi_conformal.mean),
            words::number(report.quasi_conformal.max)
        ),
        format!("flipped          {}", report.flipped),
        format!("seconds          {}", words::number(report.seconds.total)),
    ];
    if report.flipped > 0 {
        let faces = words::count(report.flipped, "face", "faces");
        let better = FewerFlips::of(mesh, &topology, report.flipped).map_or(
            "and no other weights or norm turn fewer: cut the mesh open or into parts".to_owned(),
            |better| {
                let FewerFlips { weights, norm, flipped, .. } = better;
                format!("--weights {} --norm {} turns {flipped}", weights.word(), norm.word())
            },
        );
        lines.push(format!("warning: {faces} turned over; {better}"));
    }
    if report.left_out > 0 {
        let faces = words::count(report.left_out, "face", "faces");
        lines.push(format!(
            "left out         {faces} without area or on the same vertices as another"
        ));
    }
    lines.extend(read.problems.iter().map(|problem| format!("problem: {problem}")));
    lines.extend(read.notes.iter().chain(&remark).map(|note| format!("note: {note}")));
    if map.closed_parts > 0 && asked.norm == ConformalNorm::Boundary {
        let closed = match (map.closed_parts, map.parts) {
            (1, 1) => "the mesh has no boundary: the norm uses all its vertices".to_owned(),
            (closed, all) => {
                format!(
                    "parts without a boundary: {closed} of {all}; there the norm uses all vertices"
                )
            }
        };
        lines.push(format!("warning: {closed}"));
    }
    output::print(&(lines.join("\n") + "\n"))
}
