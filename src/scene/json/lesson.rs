//! `lesson`: what is to be done, and the goals; and the results that are handed in.
//!
//! ```json
//! { "text": "Make every panel flat.",
//!   "goals": [ { "measure": "planarity", "at_most": 0.001 },
//!              { "constraint": "Eaves", "at_most": 0.01 } ] }
//! ```

use super::file::{RESULTS, VERSION, from_json};
use super::text::{field, lines, number, object, point, rows, text};
use super::{constraint, handle};
use crate::json::{JsonError, found, present};
use crate::scene::{Goal, GoalOf, GoalResult, Lesson, Results, SceneError};
use serde::de::{Deserialize, Deserializer, Error};

impl Lesson {
    /// Reads the `lesson` of a scene.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<Lesson, SceneError> {
        from_json(json)
    }
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct LessonFile {
    text: String,
    #[cfg_attr(target_arch = "wasm32", tsify(type = "GoalFile[]"))]
    goals: Vec<Goal>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct GoalFile {
    #[serde(default, deserialize_with = "present")]
    measure: Option<String>,
    #[serde(default, deserialize_with = "present")]
    constraint: Option<String>,
    #[serde(default, deserialize_with = "present")]
    at_most: Option<f64>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct ResultFile {
    #[serde(default, deserialize_with = "present")]
    measure: Option<String>,
    #[serde(default, deserialize_with = "present")]
    constraint: Option<String>,
    #[serde(default, deserialize_with = "present")]
    at_most: Option<f64>,
    value: Option<f64>,
    met: bool,
}

impl<'de> Deserialize<'de> for Lesson {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Lesson, D::Error> {
        let LessonFile { text, goals } = LessonFile::deserialize(from)?;
        if goals.is_empty() {
            let message = "found an array of 0, expected at least one goal";
            return Err(D::Error::custom(JsonError::new("goals", message)));
        }
        Ok(Lesson { text, goals })
    }
}

impl<'de> Deserialize<'de> for Goal {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Goal, D::Error> {
        goal_of(GoalFile::deserialize(from)?).map_err(D::Error::custom)
    }
}

impl<'de> Deserialize<'de> for GoalResult {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<GoalResult, D::Error> {
        let ResultFile { measure, constraint, at_most, value, met } =
            ResultFile::deserialize(from)?;
        let goal = goal_of(GoalFile { measure, constraint, at_most });
        Ok(GoalResult { goal: goal.map_err(D::Error::custom)?, value, met })
    }
}

fn goal_of(file: GoalFile) -> Result<Goal, JsonError> {
    const WHAT: &str = "{\"measure\": ...} or {\"constraint\": ...}";
    let error = |message: String| Err(JsonError::new("", message));
    let of = match (file.measure, file.constraint) {
        (Some(id), None) => GoalOf::Measure(id),
        (None, Some(name)) => GoalOf::Constraint(name),
        (None, None) => return error(format!("the goal is about nothing, expected {WHAT}")),
        (Some(_), Some(_)) => return error(format!("the goal is about two, expected {WHAT}")),
    };
    let at_most = file.at_most.ok_or_else(|| JsonError::missing_field("at_most"))?;
    if at_most < 0.0 {
        return Err(found(&at_most.into(), "a number from 0").below_key("at_most"));
    }
    Ok(Goal { of, at_most })
}

/// The lesson, each goal on a line.
pub(super) fn write(lesson: &Lesson) -> String {
    let goals = lesson.goals.iter().map(|goal| object(goal_fields(goal))).collect();
    object(vec![field("text", text(&lesson.text)), field("goals", lines('[', goals, ']'))])
}

fn goal_fields(goal: &Goal) -> Vec<String> {
    let of = match &goal.of {
        GoalOf::Measure(id) => field("measure", text(id)),
        GoalOf::Constraint(name) => field("constraint", text(name)),
    };
    vec![of, field("at_most", number(goal.at_most))]
}

impl Results {
    /// Writes the file that [`Results::from_json`] reads.
    pub fn to_json(&self) -> String {
        let goals = self.goals.iter().map(|result| {
            let mut fields = goal_fields(&result.goal);
            fields.push(field("value", result.value.map_or("null".to_owned(), number)));
            fields.push(field("met", result.met.to_string()));
            object(fields)
        });
        let constraints = self.constraints.iter().map(constraint::write).collect();
        let handles = self.handles.iter().map(handle::write).collect();
        let fields = [
            field("format", text(RESULTS)),
            field("version", VERSION.to_string()),
            field("student", text(&self.student)),
            field("title", text(&self.title)),
            field("scene", text(&self.scene)),
            field("time", text(&self.time)),
            field("iterations", self.iterations.to_string()),
            field("passed", self.passed.to_string()),
            field("goals", lines('[', goals.collect(), ']')),
            field("constraints", lines('[', constraints, ']')),
            field("handles", lines('[', handles, ']')),
            field("positions", rows(self.positions.iter().map(point), "")),
        ];
        format!("{{\n  {}\n}}\n", fields.join(",\n  "))
    }
}
