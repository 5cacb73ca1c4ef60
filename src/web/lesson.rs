//! Lessons, as the page shows them, and what a student hands in.

use super::solver::Solver;
use super::thrown;
use crate::scene::Lesson;
use crate::session::{GoalWords, Session, goals_in_words};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
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
