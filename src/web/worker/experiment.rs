//! The face of the experiments in the worker.

use super::solver::Solver;
use crate::error::Error;
use crate::experiment::{COMPARISON, Experiment, Limits, Run};
use crate::mesh::read;
use crate::scene::Scene;
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::thrown;
use js_sys::{Array, Float64Array, Object, Reflect};
use wasm_bindgen::prelude::*;

/// An experiment under way.
#[wasm_bindgen]
pub struct ExperimentRun {
    run: Run,
    /// How many samples of each series the host has been told, and whether that it has ended.
    told: Vec<(usize, bool)>,
}

impl ExperimentRun {
    fn of(run: Run) -> ExperimentRun {
        ExperimentRun { told: vec![(0, false); run.experiment().methods.len()], run }
    }
}

#[wasm_bindgen]
impl ExperimentRun {
    /// The experiment of an example, on its scene and the mesh that this names. Limits that are not
    /// given are the experiment's own.
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

    /// The comparison of methods on what is open, from its original shape. At most so many iterations of
    /// each method, else as the experiment says.
    #[wasm_bindgen(js_name = ofOpen)]
    pub fn of_open(solver: &Solver, iterations: Option<u32>) -> Result<ExperimentRun, JsValue> {
        let session = solver.open()?;
        let scene = Scene { current: None, ..session.document().clone() };
        let limits = COMPARISON.limits;
        let limits = Limits { iterations: iterations.unwrap_or(limits.iterations), ..limits };
        Ok(ExperimentRun::of(Run::new(&COMPARISON, scene, session.mesh().clone(), limits)))
    }

    /// The declaration of the comparison on whatever is open.
    pub fn declared() -> Result<JsValue, JsValue> {
        plain(&COMPARISON)
    }

    /// Iterates for about so many milliseconds; false once all methods have ended.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        let until = clock::now() + milliseconds / 1e3;
        while clock::now() < until {
            if !self.run.step().map_err(|error: Error| thrown(error))? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Samples since the last call, one entry for each method with something new: `method`, its
    /// index; `endedBy`, in words, or null; `samples`, per iteration its number, the seconds, and the
    /// quantities of the experiment.
    pub fn news(&mut self) -> Result<Array, JsValue> {
        let news = Array::new();
        for (method, (series, told)) in self.run.series().iter().zip(&mut self.told).enumerate() {
            let state = (series.samples.len(), series.ended_by.is_some());
            if *told == state {
                continue;
            }
            let fresh = series.samples.iter().enumerate().skip(told.0);
            let numbers: Vec<f64> = fresh
                .flat_map(|(iteration, sample)| {
                    [iteration as f64, sample.seconds].into_iter().chain(sample.values.clone())
                })
                .collect();
            *told = state;
            let ended = series.ended_by.map_or(JsValue::NULL, |ended| ended.words().into());
            let entry = Object::new();
            Reflect::set(&entry, &"method".into(), &(method as f64).into())?;
            Reflect::set(&entry, &"endedBy".into(), &ended)?;
            Reflect::set(&entry, &"samples".into(), &Float64Array::from(&numbers[..]).into())?;
            news.push(&entry);
        }
        Ok(news)
    }

    /// Everything that was measured as comma-separated values.
    pub fn csv(&self) -> String {
        self.run.csv()
    }
}
