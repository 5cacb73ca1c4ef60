//! A copy of the open model, and trials on it: the forecast of what a press would move, the cost of
//! exactness, improvements, edits that may help if constraints are not met, and presses for panels that
//! end better.

use super::SLICE;
use crate::scene::{Forecast, MeshSuggestion, UnitsAndUp};
use crate::session::{
    BetterPress, BetterPresses, Error, ExactOffer, ExactShape, ExactTrial, FileReader, OpenedFile,
    PanelLayouts, Session, Suggestion, Suggestions, Variations,
};
use crate::solve::clock;
use crate::web::values::{Js, flat, plain, plains};
use crate::web::{log_panics, thrown};
use js_sys::{Float64Array, Function};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// A copy of the open model, and what is tried on it.
#[wasm_bindgen]
pub struct ModelCopy {
    pub(super) session: Session,
    trial: Option<Trial>,
    pub(super) variations: Option<Variations>,
    /// New panels on the copied shape, from the first question for them on.
    pub(super) layouts: Option<PanelLayouts>,
    /// Called with what is being done, in words.
    pub(super) told: Function,
}

/// What is being tried.
enum Trial {
    Exact(Box<ExactTrial>),
    Suggestions(Box<Suggestions>),
    Presses(Box<BetterPresses>),
}

/// How far making panels of one shape will move the mesh.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct ForecastWords {
    words: String,
    /// The id of the kind to recommend.
    recommended: &'static str,
    /// Whether new panels along the lines of curvature are the better choice.
    new_panels: bool,
    /// A change of the mesh that would reduce the move.
    suggestion: Option<MeshSuggestion>,
}

impl ForecastWords {
    fn of(forecast: &Forecast, session: &Session) -> ForecastWords {
        ForecastWords {
            words: forecast.words(&session.document().units),
            recommended: forecast.recommended(),
            new_panels: forecast.recommends_new_panels(),
            suggestion: forecast.suggestion(),
        }
    }
}

#[wasm_bindgen]
impl ModelCopy {
    /// Opens the text of a scene with its mesh, which the solver has at this generation.
    /// What takes long calls `told` with what is being done, in words.
    ///
    /// # Errors
    /// As opening the scene; not expected, since it is open in the solver.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &str, generation: u32, told: Function) -> Result<ModelCopy, JsValue> {
        log_panics();
        let frame = UnitsAndUp::default();
        let file = FileReader::default().read("copy.json", scene.as_bytes(), frame, false);
        let OpenedFile { scene, mesh, .. } = file.map_err(thrown)?;
        let session = Session::open_copy(scene, mesh, generation).map_err(thrown)?;
        Ok(ModelCopy { session, trial: None, variations: None, layouts: None, told })
    }

    /// Returns in words how far making panels of one shape will move the mesh, and a change of the
    /// mesh that would reduce it; undefined if no shape is offered.
    pub fn forecast(&self) -> Result<Option<Js<ForecastWords>>, JsValue> {
        self.session
            .forecast()
            .map(|forecast| plain(&ForecastWords::of(&forecast, &self.session)))
            .transpose()
    }

    /// Begins a trial, from the current shape, to meet exactly what is met within a distance.
    #[wasm_bindgen(js_name = tryExact)]
    pub fn try_exact(&mut self) -> Result<(), JsValue> {
        let trial = self.session.exact_trial().map_err(thrown)?;
        self.trial = trial.map(|trial| Trial::Exact(Box::new(trial)));
        Ok(())
    }

    /// Begins to search the shapes that meet the requirements for one of lower energy.
    #[wasm_bindgen(js_name = tryImprovement)]
    pub fn try_improvement(&mut self) -> Result<(), JsValue> {
        let trial = self.session.improvement().map_err(thrown)?;
        self.trial = trial.map(|trial| Trial::Exact(Box::new(trial)));
        Ok(())
    }

    /// Begins to try edits that may help if constraints are not met.
    #[wasm_bindgen(js_name = trySuggestions)]
    pub fn try_suggestions(&mut self) -> Result<(), JsValue> {
        let suggestions = Suggestions::new(&self.session).map_err(thrown)?;
        self.trial = Some(Trial::Suggestions(Box::new(suggestions)));
        Ok(())
    }

    /// Begins to try presses for panels that end better than the last one.
    #[wasm_bindgen(js_name = tryPresses)]
    pub fn try_presses(&mut self) {
        let tolerance = self.session.tolerance();
        let presses = BetterPresses::new(&mut self.session, tolerance);
        self.trial = presses.map(|presses| Trial::Presses(Box::new(presses)));
    }

    /// Continues the trial for a slice; returns whether there is more to do.
    pub fn advance(&mut self) -> Result<bool, JsValue> {
        let ModelCopy { session, trial, .. } = self;
        let step = || -> Result<bool, Error> {
            match trial {
                Some(Trial::Exact(trial)) => trial.step(session),
                Some(Trial::Suggestions(suggestions)) => suggestions.step(),
                Some(Trial::Presses(presses)) => presses.step(),
                None => Ok(false),
            }
        };
        clock::repeat(SLICE, step).map_err(thrown)
    }

    /// Returns the cost of the exact shape found so far; undefined if there is nothing to make exact.
    pub fn offer(&mut self) -> Result<Option<Js<ExactOffer>>, JsValue> {
        let ModelCopy { session, trial, .. } = self;
        let offer = match trial {
            Some(Trial::Exact(trial)) => trial.offer(session),
            _ => None,
        };
        offer.as_ref().map(plain).transpose()
    }

    /// Returns that shape for [`crate::web::worker::Solver::make_exact`], without its positions.
    pub fn shape(&self) -> Result<Option<Js<ExactShape>>, JsValue> {
        self.exact().map(|trial| plain(&trial.shape())).transpose()
    }

    /// Returns the positions of that shape, `#V by 3`; empty without one.
    pub fn positions(&self) -> Float64Array {
        flat(&self.exact().map(ExactTrial::positions).unwrap_or_default())
    }

    /// Returns the presses that end better.
    #[wasm_bindgen(js_name = betterPresses)]
    pub fn better_presses(&self) -> Result<Vec<Js<BetterPress>>, JsValue> {
        match &self.trial {
            Some(Trial::Presses(presses)) => plains(presses.found()),
            _ => Ok(Vec::new()),
        }
    }

    /// Returns the edits that help, the most effective first.
    pub fn suggestions(&self) -> Result<Vec<Js<Suggestion>>, JsValue> {
        match &self.trial {
            Some(Trial::Suggestions(suggestions)) => plains(suggestions.found()),
            _ => Ok(Vec::new()),
        }
    }
}

impl ModelCopy {
    fn exact(&self) -> Option<&ExactTrial> {
        match &self.trial {
            Some(Trial::Exact(trial)) => Some(trial),
            _ => None,
        }
    }
}
