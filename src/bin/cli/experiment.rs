//! `shape-up experiment`: runs one of the comparisons of the paper.

use super::arguments::Experiment as Asked;
use super::input::{self, Input};
use super::{Failure, output};
use shape_up::experiment::{COMPARISON, EXPERIMENTS, Experiment, Limits, Run};
use shape_up::generate::example::EXAMPLES;
use shape_up::words;
use std::path::Path;

/// Prints one line per example with its own experiment.
pub(super) fn list() -> Result<(), Failure> {
    let lines = EXPERIMENTS.iter().flat_map(|experiment| {
        let line =
            move |id: &&str| format!("{id:<20} {}. {}\n", experiment.label, experiment.summary);
        experiment.examples.iter().map(line)
    });
    output::print(&lines.collect::<String>())
}

pub(super) fn run(asked: &Asked) -> Result<(), Failure> {
    let (experiment, Input { scene, mesh, remarks, .. }) = problem(&asked.on)?;
    output::check(asked.csv.iter().chain(&asked.svg))?;
    let limits = Limits {
        iterations: asked.iterations.unwrap_or(experiment.limits.iterations),
        seconds: asked.seconds.unwrap_or(experiment.limits.seconds),
    };
    let name = asked.on.display();
    let run = Run::of(experiment, scene, &mesh, limits)
        .map_err(|error| Failure::Input(format!("{name}: {error}")))?;
    let csv = asked.csv.as_ref().map(|file| (file, run.csv()));
    let svg = asked.svg.as_ref().map(|file| (file, run.svg(&name.to_string())));
    output::write(&csv.into_iter().chain(svg).collect::<Vec<_>>())?;
    output::print(&(table(&run) + &output::notes(&remarks)))
}

/// Returns an example with its own or the generic experiment, or a scene file with the generic one.
fn problem(on: &Path) -> Result<(&'static Experiment, Input), Failure> {
    let id = on.to_string_lossy();
    if let Some(example) = EXAMPLES.iter().find(|example| example.id == id) {
        let (scene, mesh) = example.build();
        let (frame, remarks) = Default::default();
        let input = Input { scene, mesh, weld: None, frame, remarks };
        return Ok((Experiment::of(&id).unwrap_or(&COMPARISON), input));
    }
    if !on.exists() {
        let known: Vec<_> = EXAMPLES.iter().map(|example| example.id).collect();
        let expected = format!("a scene file or one of {}", known.join(", "));
        return Err(Failure::Input(format!("{id}: cannot be found, expected {expected}")));
    }
    let input = input::read(on)?;
    if input.scene.constraints.is_empty() {
        let message = "it has no constraints, expected a scene with some";
        return Err(Failure::Input(format!("{id}: {message}")));
    }
    Ok((&COMPARISON, input))
}

/// Formats the last sample of each method.
fn table(run: &Run) -> String {
    let experiment = run.experiment();
    let mut rows =
        vec![vec!["method".to_owned(), "ended by".into(), "iterations".into(), "seconds".into()]];
    rows[0].extend(experiment.quantities.iter().map(|quantity| quantity.label.to_lowercase()));
    for (method, series) in experiment.methods.iter().zip(run.series()) {
        let mut row = vec![method.label.to_owned(), series.ended_by.words().to_owned()];
        if let Some((last, before)) = series.samples.split_last() {
            row.extend([before.len().to_string(), words::number(last.seconds)]);
            row.extend(last.values.iter().map(|&value| words::number(value)));
        }
        row.resize(rows[0].len(), String::new());
        rows.push(row);
    }
    output::table(&rows)
}
