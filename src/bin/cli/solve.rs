//! `shape-up solve`: solves a scene or a mesh, optionally with a kind of panels on every face.

use super::arguments::{Required, Solve};
use super::{Failure, input, output};
use serde::Serialize;
use shape_up::constraint::describe;
use shape_up::scene::BoundaryCloseness;
use shape_up::session::{
    EndWords, ExactReport, Report, Session, UnusedCloseness, VerdictReport, tolerance_of,
};
use shape_up::solve::{Improved, Require};
use shape_up::words;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// The most pinned vertices named in the summary; the report has them all.
const NAMED_PINS: usize = 8;

pub(super) fn solve(command: &Solve) -> Result<(), Failure> {
    let start = Instant::now();
    let input::Input { mut scene, mesh, mut remarks, weld, frame } = input::read(&command.input)?;
    let at_input = input::at(&command.input);
    let is_press = command.require == Some(Required::Auto);
    output::check(command.out.iter().chain(&command.report))?;
    if command.require.is_some() {
        // What a search chose was for other requirements.
        scene.as_asked();
    }
    if let Some(kind) = command.panels.filter(|_| !is_press) {
        scene.request_panels(kind, Require::Soft, &mesh).map_err(|error| at_input(error.into()))?;
    }
    let press = is_press.then(|| scene.tolerance.unwrap_or_else(|| tolerance_of(&mesh)));
    let require = match command.require {
        Some(Required::Is(require)) => Some(require),
        _ => press.map(Require::Within).filter(|_| command.panels.is_none()),
    };
    if let Some(require) = require {
        // That of the command takes its place.
        scene.tolerance = None;
        scene.constraints.iter_mut().for_each(|row| row.require = require);
    }
    if let Some((require, weight)) = command.boundary {
        let own = scene.closeness.boundary;
        scene.closeness.boundary = BoundaryCloseness { require, weight, ..own };
    }
    scene.solver.iterations = command.iterations.unwrap_or(scene.solver.iterations);
    scene.solver.tolerance = command.tolerance.unwrap_or(scene.solver.tolerance);
    scene.solver.accelerator = command.accelerator.unwrap_or(scene.solver.accelerator);
    let units = scene.units.clone();
    let load_seconds = start.elapsed().as_secs_f64();

    let mut session = Session::open(scene, mesh).map_err(at_input)?;
    session.set_load_seconds(load_seconds);
    if command.panels.is_some() {
        session.watch_for_collapse();
    }
    if let Some(nearest) = session.nearest_to_exact().map_err(at_input)? {
        let nearest = words::length(nearest, &units);
        eprintln!(
            "note: the mesh, or one constraint, is too large to be exact: met up to about {nearest}; use --within LENGTH"
        );
    }
    if let Some(tolerance) = press {
        session.solve_as_pressed(command.panels, tolerance, command.trace).map_err(at_input)?;
    } else if command.improve {
        session.solve_and_improve(command.trace).map_err(at_input)?;
    } else {
        session.solve(command.trace).map_err(at_input)?;
    }
    let tolerance = session.tolerance();
    let (report, verdict) = (session.report(), verdict(&mut session, tolerance));
    if command.improve && report.exact.as_ref().is_none_or(|exact| exact.improved.is_none()) {
        let why = "--improve did nothing: it needs exact or within constraints, all of them met";
        remarks.push(why.to_owned());
    }
    if command.require.is_some() && report.exact.is_none() {
        let none = match session.document().constraints.is_empty() {
            true => "there are no constraints",
            false => "no constraint is enabled",
        };
        remarks.push(format!("nothing is required: {none}; --panels adds some"));
    }
    let unused = UnusedCloseness::of(session.document(), session.topology());
    if unused.is_some_and(|unused| unused.settings.contains(&"boundary")) {
        remarks.push("the boundary is not held, since the weight of Close is 0".to_owned());
    }
    remarks.extend(misfits(&session));
    remarks.extend(session.unpaired_words());
    remarks.extend(session.collapse().map(|collapse| {
        format!("in this run {collapse}. A larger weight of closeness keeps the mesh closer to its original shape")
    }));

    let mut files: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &command.out {
        let (file, remark) = output::mesh_file(path, &session.shape(weld.as_ref()), &frame);
        files.push((path, file));
        remarks.extend(remark);
    }
    if let Some(path) = &command.report {
        let is_asked = command.panels.is_some() || press.is_some();
        let verdict = match is_asked {
            true => session.verdict_report(tolerance, press.is_some()).map_err(at_input)?,
            false => None,
        };
        files.push((path, output::json(&ReportFile { report: &report, verdict }).into_bytes()));
    }
    output::write(&files)?;
    let told = Told { units, tolerance, verdict, remarks };
    output::print(&summary(&command.input, &report, &told))
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

/// The contents of a report file.
#[derive(Serialize)]
struct ReportFile<'a> {
    #[serde(flatten)]
    report: &'a Report,
    /// What became of panels that were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    verdict: Option<VerdictReport>,
}

/// What the summary says besides the numbers of the report.
struct Told {
    /// The symbol of the unit of the mesh.
    units: String,
    /// The tolerance of the verdict.
    tolerance: f64,
    verdict: Vec<String>,
    remarks: Vec<String>,
}

/// Returns the verdict in the words of the page: on the panels, on hard constraints, or on all
/// constraints.
fn verdict(session: &mut Session, tolerance: f64) -> Vec<String> {
    let exact = session.exact_words();
    if let Some(panels) = session.verdict(tolerance) {
        let panels = session.verdict_words(&panels).full();
        // What is within a tolerance is said of the panels.
        let exact = exact.filter(|words| !words.numbers.is_empty());
        let exact = exact.map(|words| format!("{} {}", words.brief, words.numbers));
        return [Some(panels), exact].into_iter().flatten().collect();
    }
    let Some((brief, numbers)) = exact
        .map(|words| (words.brief, words.numbers))
        .or_else(|| session.run_verdict(tolerance).map(|words| (words.brief, words.numbers)))
    else {
        return Vec::new();
    };
    let sentences = [brief, numbers, session.moved_words()];
    vec![sentences.into_iter().filter(|said| !said.is_empty()).collect::<Vec<_>>().join(" ")]
}

fn summary(input: &Path, report: &Report, told: &Told) -> String {
    let Told { units, tolerance, verdict, remarks } = told;
    let mut text = String::new();
    let mut line = |words: std::fmt::Arguments<'_>| {
        writeln!(text, "{words}").expect("writing to a string does not fail");
    };
    let kinds: Vec<_> =
        report.constraints.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    line(format_args!(
        "{}: {}, {}, constraints: {}",
        input.display(),
        words::count(report.vertices, "vertex", "vertices"),
        words::count(report.faces, "face", "faces"),
        if kinds.is_empty() { "none".to_owned() } else { kinds.join(", ") }
    ));
    for remark in remarks {
        line(format_args!("note: {remark}"));
    }
    if !report.pinned.is_empty() {
        let pinned: Vec<_> = report.pinned.iter().map(ToString::to_string).collect();
        line(format_args!(
            "note: {} {}",
            if report.pinned.len() == 1 {
                "one part of the mesh has no handle or closeness; fixed at vertex"
            } else {
                "some parts of the mesh have no handle or closeness; fixed at vertices"
            },
            words::and_more(&pinned, NAMED_PINS)
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
            words::number(before),
            words::number(after)
        ));
    }
    line(format_args!(
        "{}, stopped by {}, {} s",
        ended(report),
        report.stopped_by,
        words::number(report.seconds.iterate)
    ));
    line(format_args!("{}", output::planarity(&report.planarity, units, *tolerance)));
    line(format_args!("{}", output::circularity(&report.circularity, units, *tolerance)));
    if let Some(folded) = report.folded {
        let panels = words::count(folded.get(), "panel is", "panels are");
        line(format_args!("folds       {panels} folded or dented"));
    }
    verdict.iter().for_each(|words| line(format_args!("{words}")));
    if let Some(exact) = &report.exact {
        line(format_args!("{}", exact_line(exact, units)));
        if let Some(Improved { before, after, steps }) = exact.improved {
            line(format_args!(
                "improved by {}: energy without hard constraints {} -> {}",
                words::count(steps as usize, "step", "steps"),
                words::number(before),
                words::number(after)
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

/// Says how the iterations ended.
fn ended(report: &Report) -> String {
    let EndWords { converged, paused } = EndWords::after(report.iterations);
    if report.stopped_by == "tolerance" { converged } else { paused }
}

/// Formats how well hard constraints are met.
fn exact_line(exact: &ExactReport, units: &str) -> String {
    let met = if exact.met {
        "met".to_owned()
    } else {
        let misses = words::count(exact.misses, "constraint", "constraints");
        let why = if exact.contradiction { ", which contradict each other" } else { "" };
        let mut why = why.to_owned();
        if let Some(ratio) = exact.shortest_edge.filter(|_| exact.on_guard > 0) {
            let edges = words::count(exact.on_guard, "edge is", "edges are");
            let ratio = words::number(ratio);
            why += &format!("; {edges} as short as allowed, down to {ratio} of the length at rest");
        }
        format!("not met by {misses}{why}")
    };
    format!(
        "hard constraints {met}: moved {} on the way, {} s",
        words::length(exact.moved.max, units),
        words::number(exact.seconds)
    )
}
