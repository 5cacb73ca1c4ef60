//! A run of an experiment: its methods, one after another.

use super::declaration::{Experiment, Limits, Method, MethodInfo, Step};
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::session::Error;
use crate::solve::clock;

/// The measurements of one method.
#[derive(Clone, Debug)]
pub struct Series {
    /// One sample at the start and after each iteration; empty if the mesh is too large.
    pub samples: Vec<Sample>,
    /// Why the method ended.
    pub ended_by: EndedBy,
}

/// The state of a method after an iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Seconds taken by the method, with its set-up but without measuring.
    pub seconds: f64,
    /// The quantities of the experiment.
    pub values: Vec<f64>,
}

/// Why a method ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndedBy {
    /// It has reached the goal of the experiment.
    Reached,
    /// It cannot find a better point.
    Stalled,
    /// The limit of iterations.
    Iterations,
    /// The limit of time.
    Seconds,
    /// It was not run: the mesh has more vertices than it accepts.
    TooLarge,
}

impl EndedBy {
    /// Returns the reason in words.
    pub fn words(self) -> &'static str {
        match self {
            EndedBy::Reached => "reached",
            EndedBy::Stalled => "stalled",
            EndedBy::Iterations => "limit of iterations",
            EndedBy::Seconds => "limit of time",
            EndedBy::TooLarge => "not run: mesh too large",
        }
    }
}

/// An experiment on a scene, and its measurements.
pub struct Run {
    experiment: &'static Experiment,
    pub(super) scene: Scene,
    /// One entry for each method.
    series: Vec<Series>,
}

impl Run {
    /// Runs each method until it ends or reaches a limit.
    ///
    /// # Errors
    /// If the scene does not fit the experiment, or a position is not finite.
    pub fn of(
        experiment: &'static Experiment,
        scene: Scene,
        mesh: &Mesh,
        limits: Limits,
    ) -> Result<Run, Error> {
        let run = |info: &MethodInfo| {
            if info.most_vertices.is_some_and(|most| mesh.positions.len() > most) {
                return Ok(Series { samples: Vec::new(), ended_by: EndedBy::TooLarge });
            }
            series((info.start)(&scene, mesh)?, limits)
        };
        let series = experiment.methods.iter().map(run).collect::<Result<_, Error>>()?;
        Ok(Run { experiment, scene, series })
    }

    /// The experiment.
    pub fn experiment(&self) -> &'static Experiment {
        self.experiment
    }

    /// The measurements of each method.
    pub fn series(&self) -> &[Series] {
        &self.series
    }

    /// Returns all measurements as CSV: a header, then one line for each iteration of each method.
    pub fn csv(&self) -> String {
        let quantities: Vec<_> = self.experiment.quantities.iter().map(|q| q.id).collect();
        let mut text = format!("method,iteration,seconds,{}\n", quantities.join(","));
        for (method, series) in self.experiment.methods.iter().zip(&self.series) {
            for (iteration, sample) in series.samples.iter().enumerate() {
                let values: Vec<_> =
                    sample.values.iter().map(|value| format!("{value:e}")).collect();
                let start = format!("{},{iteration},{:.6}", method.id, sample.seconds);
                text.push_str(&format!("{start},{}\n", values.join(",")));
            }
        }
        text
    }
}

/// Runs a method until it ends or reaches a limit.
fn series(mut method: Box<dyn Method>, limits: Limits) -> Result<Series, Error> {
    let mut seconds = method.set_up_seconds();
    let mut samples = vec![Sample { seconds, values: method.values() }];
    let ended_by = loop {
        if samples.len() > limits.iterations as usize {
            break EndedBy::Iterations;
        }
        if samples.len() > 1 && seconds > limits.seconds {
            break EndedBy::Seconds;
        }
        let started = clock::now();
        let step = method.step()?;
        seconds += clock::now() - started;
        if step == Step::Stalled {
            break EndedBy::Stalled;
        }
        samples.push(Sample { seconds, values: method.values() });
        if step == Step::Reached {
            break EndedBy::Reached;
        }
    };
    Ok(Series { samples, ended_by })
}
