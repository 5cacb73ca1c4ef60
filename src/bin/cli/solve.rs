//! `shape-up solve`: solves a scene or a mesh, optionally with a kind of panels on every face.

use super::arguments::Solve;
use super::{Failure, input, output};
use shape_up::constraint::describe;
use shape_up::mesh::counted;
use shape_up::session::Error;
use shape_up::session::{ExactReport, Report, Session, Unpaired};
use shape_up::solve::{Improved, Require};
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// The most pinned vertices named in the summary; the report has them all.
const NAMED_PINS: usize = 8;

pub(super) fn solve(command: &Solve) -> Result<(), Failure> {
    let start = Instant::now();
    let input::Input { mut scene, mesh, mut remarks, weld } = input::read(&command.input)?;
    let at_input = |error: Error| {
        let message = match error {
            Error::Scene(error) if error.path == "panels" => format!("--panels: {}", error.message),
            error => error.to_string(),
        };
        Failure::Input(format!("{}: {message}", command.input.display()))
    };
    if let Some(kind) = command.panels {
        scene.request_panels(kind, Require::Soft, &mesh).map_err(|error| at_input(error.into()))?;
    }
    if let Some(require) = command.require {
        for row in &mut scene.constraints {
            (row.require, row.eased) = (require, None);
        }
    }
    scene.closeness.boundary = command.boundary.or(scene.closeness.boundary);
    scene.solver.iterations = command.iterations.unwrap_or(scene.solver.iterations);
    scene.solver.tolerance = command.tolerance.unwrap_or(scene.solver.tolerance);
    scene.solver.accelerator = command.accelerator.unwrap_or(scene.solver.accelerator);
    let units = scene.units.clone();
    let load_seconds = start.elapsed().as_secs_f64();

    let mut session = Session::open(scene, mesh).map_err(at_input)?;
    session.set_load_seconds(load_seconds);
    if command.panels.is_some() {
        session.arm_guard();
    }
    if let Some(nearest) = session.nearest_to_exact().map_err(at_input)? {
        let nearest = output::short(nearest);
        eprintln!(
            "note: the mesh, or one constraint, is too large to be exact: met up to about {nearest}; use --within LENGTH"
        );
    }
    if command.improve {
        session.solve_and_improve(command.trace).map_err(at_input)?;
    } else {
        session.solve(command.trace).map_err(at_input)?;
    }
    let report = session.report();
    if command.improve && report.exact.as_ref().is_none_or(|exact| exact.improved.is_none()) {
        let why = "--improve did nothing: it needs exact or within constraints, all of them met";
        remarks.push(why.to_owned());
    }
    if command.require.is_some() && report.exact.is_none() {
        remarks
            .push("nothing is required: there are no constraints; --panels adds some".to_owned());
    }
    remarks.extend(misfits(&session));
    remarks.extend(report.unpaired.iter().map(|row| unpaired(*row, &session)));
    remarks.extend(session.collapse().map(|collapse| {
        format!("stopped: {collapse}. A larger weight of closeness keeps the mesh closer to its original shape")
    }));

    let mut files: Vec<(&Path, String)> = Vec::new();
    if let Some(path) = &command.out {
        files.push((path, output::mesh_text(path, &session, weld.as_ref())));
        remarks.extend(output::left_out(path, session.mesh()));
    }
    if let Some(path) = &command.report {
        files.push((path, output::json(&report)));
    }
    output::write(&files)?;
    output::print(&summary(&command.input, &report, &remarks, &units))
}

/// Describes the elements that each row of constraints skipped.
fn misfits(session: &Session) -> impl Iterator<Item = String> {
    let rows = session.document().constraints.iter().zip(session.rows());
    rows.filter(|(_, row)| row.enabled && row.skipped > 0).map(|(spec, row)| {
        let (info, all) = (spec.kind.info(), row.skipped + row.constraints.members.len());
        format!(
            "{} on {}: {} of {all} skipped; it takes {}",
            info.id,
            describe(&spec.on),
            row.skipped,
            info.arity_in_words()
        )
    })
}

/// Describes a row of constraints that pairs vertices, some of which have no partner.
fn unpaired(row: Unpaired, session: &Session) -> String {
    let spec = &session.document().constraints[row.constraint];
    let (of, on) = (row.paired.of, describe(&spec.on));
    let free = if row.paired.vertices == 0 {
        "it does nothing; see its parameters"
    } else {
        "the others are free"
    };
    format!(
        "{} on {on}: {} of {of} vertices have an image at rest, {free}",
        spec.kind.info().id,
        row.paired.vertices
    )
}

fn summary(input: &Path, report: &Report, remarks: &[String], units: &str) -> String {
    let mut text = String::new();
    let mut line = |words: std::fmt::Arguments<'_>| {
        writeln!(text, "{words}").expect("writing to a string does not fail");
    };
    let kinds: Vec<_> =
        report.constraints.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    line(format_args!(
        "{}: {}, {}, constraints: {}",
        input.display(),
        counted(report.vertices, "vertex", "vertices"),
        counted(report.faces, "face", "faces"),
        if kinds.is_empty() { "none".to_owned() } else { kinds.join(", ") }
    ));
    for remark in remarks {
        line(format_args!("note: {remark}"));
    }
    if !report.pinned.is_empty() {
        let named: Vec<_> =
            report.pinned.iter().take(NAMED_PINS).map(ToString::to_string).collect();
        let more = report.pinned.len() - named.len();
        line(format_args!(
            "note: {} {}{}",
            if report.pinned.len() == 1 {
                "one part of the mesh has no handle or closeness; fixed at vertex"
            } else {
                "some parts of the mesh have no handle or closeness; fixed at vertices"
            },
            named.join(", "),
            if more == 0 { String::new() } else { format!(" and {more} more") }
        ));
    }
    let (initial, last) = (report.energy.initial, report.energy.last);
    for (name, before, after) in [
        ("total", initial.total, last.total),
        ("shape", initial.shape, last.shape),
        ("close", initial.close, last.close),
        ("smooth", initial.smooth, last.smooth),
        ("handles", initial.handles, last.handles),
    ] {
        line(format_args!(
            "energy {name:<8} {} -> {}",
            output::short(before),
            output::short(after)
        ));
    }
    line(format_args!(
        "iterations {}, stopped by {}, {} s",
        report.iterations,
        report.stopped_by,
        output::short(report.seconds.iterate)
    ));
    line(format_args!("{}", output::planarity(&report.planarity, units)));
    line(format_args!("{}", output::circularity(&report.circularity, units)));
    if let Some(folded) = report.folded {
        line(format_args!("folds       {folded} faces are folded or dented"));
    }
    if let Some(exact) = &report.exact {
        line(format_args!("{}", exact_line(exact, units)));
        if let Some(Improved { before, after, steps }) = exact.improved {
            line(format_args!(
                "improved by {}: energy without hard constraints {} -> {}",
                counted(steps as usize, "step", "steps"),
                output::short(before),
                output::short(after)
            ));
        }
    }
    for entry in report.trace.iter().flatten() {
        line(format_args!(
            "iteration {:>4}  total {:e}  shape {:e}  close {:e}  smooth {:e}  handles {:e}",
            entry.iteration,
            entry.energy.total,
            entry.energy.shape,
            entry.energy.close,
            entry.energy.smooth,
            entry.energy.handles
        ));
    }
    text
}

/// Formats how well hard constraints are met.
fn exact_line(exact: &ExactReport, units: &str) -> String {
    let length = |length: f64| output::length(length, units);
    let met = if exact.met {
        "met".to_owned()
    } else {
        let misses = counted(exact.misses, "constraint", "constraints");
        let why = if exact.contradiction { ", which contradict each other" } else { "" };
        let mut why = why.to_owned();
        if let Some(ratio) = exact.shortest_edge.filter(|_| exact.on_guard > 0) {
            let edges = counted(exact.on_guard, "edge is", "edges are");
            let ratio = output::short(ratio);
            why += &format!("; {edges} as short as allowed, down to {ratio} of the length at rest");
        }
        format!("not met by {misses}{why}")
    };
    format!(
        "hard constraints {met}: farthest {}, tolerance {}, moved {} on the way, {} s",
        length(exact.max_distance),
        length(exact.tolerance),
        length(exact.moved.max),
        output::short(exact.seconds)
    )
}
