//! Lessons in the form that the page shows.

use crate::scene::{Lesson, Lock};
use crate::session::{GoalWords, Session, goals_in_words};
use serde::Serialize;

/// The exercise of the scene.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub(crate) struct LessonWords<'a> {
    text: &'a str,
    goals: Vec<GoalWords<'a>>,
    /// The locked parts.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "(\"weights\" | \"constraints\" | \"handles\" | \"mesh\")[]")
    )]
    lock: &'a [Lock],
}

impl<'a> LessonWords<'a> {
    pub(crate) fn new(lesson: &'a Lesson) -> Self {
        LessonWords { text: &lesson.text, goals: goals_in_words(lesson), lock: &lesson.lock }
    }
}

/// The value of a goal on the current shape.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub(crate) struct GoalNumbers {
    value: Option<f64>,
    met: bool,
}

impl GoalNumbers {
    pub(crate) fn of(session: &mut Session) -> Vec<GoalNumbers> {
        let goals = session.goals().into_iter();
        goals.map(|goal| GoalNumbers { value: goal.value, met: goal.met }).collect()
    }
}
