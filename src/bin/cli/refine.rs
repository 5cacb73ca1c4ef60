//! `shape-up refine`: subdivides a scene or a mesh, solving at every level if panels are required.

use crate::cli::arguments::Refine;
use crate::cli::{Failure, input, output};
use serde::Serialize;
use shape_up::mesh::Topology;
use shape_up::session::{Edit, Error, PanelStart, Report, Session, VerdictReport};
use shape_up::solve::Require;
use shape_up::words;
use std::path::Path;
use std::time::Instant;

/// The report written by `--report`.
#[derive(Serialize)]
struct RefineReport {
    /// From the input mesh to the last level.
    levels: Vec<Level>,
    /// A sentence for each item that was not carried over.
    lost: Vec<String>,
    /// The report of the last level.
    report: Report,
}

/// A solved level.
#[derive(Serialize)]
struct Level {
    vertices: usize,
    faces: usize,
    total: f64,
    /// The deviation of the panels from the required shape.
    verdict: Option<VerdictReport>,
    seconds: f64,
}

pub(in crate::cli) fn refine(command: &Refine) -> Result<(), Failure> {
    let input::Input { mut scene, mesh, frame, mut remarks, .. } = input::read(&command.input)?;
    output::check(command.out.iter().chain(&command.report))?;
    let at_input = input::at(&command.input);
    let subdivision = command.subdivision;
    let mut is_asked = false;
    if let Some(kind) = command.panels {
        match scene.request_panels(kind, Require::Soft, &mesh) {
            Ok(_) => is_asked = true,
            Err(error) if subdivision.splits_triangles(&mesh) => {
                return Err(at_input(error.into()));
            }
            // The faces cannot be such panels, but the quads that they are divided into can.
            Err(_) => {}
        }
    }
    let mut session = Session::open(scene, mesh).map_err(at_input)?;
    // Said before anything is solved.
    subdivision
        .counts(session.mesh(), &Topology::new(session.mesh()))
        .map_err(|why| Failure::Input(format!("{}: {why}", command.input.display())))?;
    let (mut levels, mut lost) = (Vec::new(), Vec::new());
    let mut refine = |session: &mut Session, levels| {
        let (scheme, keep) = (subdivision.scheme, subdivision.keep);
        session.edit(Edit::Refine { scheme, levels, keep, adopt: command.adopt })?;
        lost.extend_from_slice(session.lost());
        Ok(())
    };
    if let Some(kind) = command.panels {
        for level in 0..=subdivision.levels {
            let start = Instant::now();
            if level > 0 {
                refine(&mut session, 1).map_err(at_input)?;
            }
            if level == 1 && !is_asked {
                let (kind, from) = (kind.to_owned(), PanelStart::Now);
                session.edit(Edit::MakePanels { kind, within: None, from }).map_err(at_input)?;
            }
            session.solve(false).map_err(at_input)?;
            levels.push(level_of(&mut session, start).map_err(at_input)?);
        }
    } else {
        refine(&mut session, subdivision.levels).map_err(at_input)?;
    }

    let report = session.report();
    let mut text = format!(
        "{}: {}, {}\n",
        command.input.display(),
        words::count(report.vertices, "vertex", "vertices"),
        words::count(report.faces, "face", "faces")
    );
    remarks.extend(lost.iter().cloned());
    let mut files: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &command.out {
        remarks.extend(output::write_changed(path, &session, &frame, &mut files));
    }
    text += &output::notes(&remarks);
    levels.iter().for_each(|level| text += &line(level));
    if let Some(path) = &command.report {
        let report = RefineReport { levels, lost, report };
        files.push((path, output::json(&report).into_bytes()));
    }
    output::write(&files)?;
    output::print(&text)
}

fn level_of(session: &mut Session, start: Instant) -> Result<Level, Error> {
    Ok(Level {
        verdict: session.verdict_report(session.tolerance(), false)?,
        vertices: session.mesh().positions.len(),
        faces: session.mesh().faces.len(),
        total: session.solver().energy().total,
        seconds: start.elapsed().as_secs_f64(),
    })
}

fn line(level: &Level) -> String {
    format!(
        "{}, energy {}, {} s.{}\n",
        words::count(level.faces, "face", "faces"),
        words::number(level.total),
        words::number(level.seconds),
        level.verdict.as_ref().map_or_else(String::new, |verdict| format!(" {}", verdict.words))
    )
}
