//! Lists of elements, and lessons, as the page asks for them.

use super::solver::{Solver, object, plain};
use super::thrown;
use crate::scene::Lesson;
use crate::session::{GoalWords, Session, goals_in_words};
use js_sys::Uint32Array;
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The `count` worst faces by a measure.
    #[wasm_bindgen(js_name = worstFaces)]
    pub fn worst_faces(&mut self, measure: &str, count: usize) -> Result<JsValue, JsValue> {
        let worst = self.open_mut()?.worst_faces(measure, count);
        plain(&worst.ok_or_else(|| thrown(format!("unknown measure {measure:?}")))?)
    }

    /// The `count` worst constraints of a row.
    #[wasm_bindgen(js_name = worstConstraints)]
    pub fn worst_constraints(&mut self, row: usize, count: usize) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.worst_constraints(row, count))
    }

    /// The vertices, edges and faces that have a flaw, as the page selects them.
    pub fn flawed(&self, name: &str) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let found = session.flawed(name);
        let found = found.ok_or_else(|| thrown(format!("unknown flaw {name:?}")))?;
        let indices = |indices: &[u32]| JsValue::from(Uint32Array::from(indices));
        object([
            ("vertices", indices(&found.vertices)),
            ("edges", indices(&session.edges_between(&found.edges))),
            ("faces", indices(&found.faces)),
        ])
    }

    /// The file that `student` hands in.
    pub fn results(&mut self, student: &str, time: &str) -> Result<String, JsValue> {
        let results = self.open_mut()?.results(student, time);
        let results = results.ok_or_else(|| thrown("the scene has no lesson"))?;
        Ok(results.to_json())
    }
}

/// The exercise that the scene is.
#[derive(Serialize)]
pub(super) struct LessonWords<'a> {
    text: &'a str,
    goals: Vec<GoalWords<'a>>,
}

impl<'a> LessonWords<'a> {
    pub(super) fn new(lesson: &'a Lesson) -> Self {
        LessonWords { text: &lesson.text, goals: goals_in_words(lesson) }
    }
}

/// What a goal is on the shape as it is.
#[derive(Serialize)]
pub(super) struct GoalNumbers {
    value: Option<f64>,
    met: bool,
}

impl GoalNumbers {
    pub(super) fn of(session: &mut Session) -> Vec<GoalNumbers> {
        let goals = session.goals().into_iter();
        goals.map(|goal| GoalNumbers { value: goal.value, met: goal.met }).collect()
    }
}
