//! A running experiment: one method after another, one iteration at a time, so that a host can show
//! the progress and stop at any time.

use super::declaration::{Experiment, Limits, Method, Step};
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::session::Error;
use crate::solve::clock;

/// The measurements of one method.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// One sample at the start and after each iteration; empty if the mesh is too large.
    pub samples: Vec<Sample>,
    /// Why the method ended, once it has.
    pub ended_by: Option<EndedBy>,
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

/// An experiment on a scene.
pub struct Run {
    experiment: &'static Experiment,
    pub(super) scene: Scene,
    mesh: Mesh,
    limits: Limits,
    under_way: Option<Box<dyn Method>>,
    /// One entry for each method that has started.
    series: Vec<Series>,
}

impl Run {
    /// Creates a run; no method has started yet.
    pub fn new(experiment: &'static Experiment, scene: Scene, mesh: Mesh, limits: Limits) -> Run {
        Run { experiment, scene, mesh, limits, under_way: None, series: Vec::new() }
    }

    /// The experiment.
    pub fn experiment(&self) -> &'static Experiment {
        self.experiment
    }

    /// The measurements so far, of each method that has started.
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

    /// Starts the next method, or runs one iteration of the current one. Returns false once all
    /// have ended.
    ///
    /// # Errors
    /// If the scene does not fit the experiment, or a position is not finite.
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some(method) = &mut self.under_way else {
            let Some(info) = self.experiment.methods.get(self.series.len()) else {
                return Ok(false);
            };
            let vertices = self.mesh.positions.len();
            if info.most_vertices.is_some_and(|most| vertices > most) {
                let ended_by = Some(EndedBy::TooLarge);
                self.series.push(Series { samples: Vec::new(), ended_by });
                return Ok(true);
            }
            let method = (info.start)(&self.scene, &self.mesh)?;
            let first = Sample { seconds: method.set_up_seconds(), values: method.values() };
            let ended_by = (self.limits.iterations == 0).then_some(EndedBy::Iterations);
            self.series.push(Series { samples: vec![first], ended_by });
            self.under_way = ended_by.is_none().then_some(method);
            return Ok(true);
        };
        let started = clock::now();
        let step = method.step()?;
        let took = clock::now() - started;
        let series = self.series.last_mut().expect("the method that is under way has one");
        let seconds = took + series.samples.last().map_or(0.0, |sample| sample.seconds);
        if step != Step::Stalled {
            series.samples.push(Sample { seconds, values: method.values() });
        }
        series.ended_by = match step {
            Step::Reached => Some(EndedBy::Reached),
            Step::Stalled => Some(EndedBy::Stalled),
            Step::Going if series.samples.len() > self.limits.iterations as usize => {
                Some(EndedBy::Iterations)
            }
            Step::Going => (seconds > self.limits.seconds).then_some(EndedBy::Seconds),
        };
        if series.ended_by.is_some() {
            self.under_way = None;
        }
        Ok(true)
    }
}
