//! The interface of the experiments in the worker.

use super::solver::Solver;
use crate::experiment::{COMPARISON, Experiment, Limits, Run};
use crate::mesh::read;
use crate::scene::Scene;
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::thrown;
use js_sys::{Array, Float64Array, Object, Reflect};
use wasm_bindgen::prelude::*;

/// An experiment in progress.
#[wasm_bindgen]
pub struct ExperimentRun {
    run: Run,
    /// For each series: the number of samples sent to the page, and whether its end was sent.
    sent: Vec<(usize, bool)>,
}

impl ExperimentRun {
    fn of(run: Run) -> ExperimentRun {
        ExperimentRun { sent: vec![(0, false); run.experiment().methods.len()], run }
    }
}

#[wasm_bindgen]
impl ExperimentRun {
    /// Creates the experiment of an example, on its scene and the mesh that the scene names. Limits
    /// default to those of the experiment.
    #[wasm_bindgen(constructor)]
    pub fn new(
        example: &str,
        scene: &str,
        mesh_name: &str,
        mesh: &[u8],
        iterations: Option<u32>,
        seconds: Option<f64>,
    ) -> Result<ExperimentRun, JsValue> {
        let experiment = Experiment::of(example)
            .ok_or_else(|| thrown(format!("there is no experiment on {example}")))?;
        let limits = Limits {
            iterations: iterations.unwrap_or(experiment.limits.iterations),
            seconds: seconds.unwrap_or(experiment.limits.seconds),
        };
        let scene = Scene::from_json(scene).map_err(thrown)?;
        let mesh = read(mesh_name, mesh).map_err(thrown)?.mesh;
        Ok(ExperimentRun::of(Run::new(experiment, scene, mesh, limits)))
    }

    /// Creates the comparison of methods on the open model, from its original shape, with at most
    /// `iterations` of each method (default: as the experiment declares).
    #[wasm_bindgen(js_name = ofOpen)]
    pub fn of_open(solver: &Solver, iterations: Option<u32>) -> Result<ExperimentRun, JsValue> {
        let session = solver.open()?;
        let scene = Scene { current: None, ..session.document().clone() };
        let limits = COMPARISON.limits;
        let limits = Limits { iterations: iterations.unwrap_or(limits.iterations), ..limits };
        Ok(ExperimentRun::of(Run::new(&COMPARISON, scene, session.mesh().clone(), limits)))
    }

    /// Returns the declaration of the comparison on the open model.
    pub fn declared() -> Result<JsValue, JsValue> {
        plain(&COMPARISON)
    }

    /// Iterates for about the given time; returns false once all methods have ended.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        clock::repeat(1e-3 * milliseconds, || self.run.step()).map_err(thrown)
    }

    /// Returns the samples since the last call, one entry for each method with news: `method`, its
    /// index; `endedBy`, in words, or null; `samples`, for each iteration its number, the seconds,
    /// and the quantities of the experiment.
    pub fn news(&mut self) -> Result<Array, JsValue> {
        let news = Array::new();
        for (method, (series, sent)) in self.run.series().iter().zip(&mut self.sent).enumerate() {
            let state = (series.samples.len(), series.ended_by.is_some());
            if *sent == state {
                continue;
            }
            let fresh = series.samples.iter().enumerate().skip(sent.0);
            let numbers: Vec<f64> = fresh
                .flat_map(|(iteration, sample)| {
                    [iteration as f64, sample.seconds].into_iter().chain(sample.values.clone())
                })
                .collect();
            *sent = state;
            let ended = series.ended_by.map_or(JsValue::NULL, |ended| ended.words().into());
            let entry = Object::new();
            Reflect::set(&entry, &"method".into(), &(method as f64).into())?;
            Reflect::set(&entry, &"endedBy".into(), &ended)?;
            Reflect::set(&entry, &"samples".into(), &Float64Array::from(&numbers[..]).into())?;
            news.push(&entry);
        }
        Ok(news)
    }

    /// Returns all measurements as comma-separated values.
    pub fn csv(&self) -> String {
        self.run.csv()
    }
}
