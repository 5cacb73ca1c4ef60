//! `lesson`: task and goals; and the results that students hand in.
//!
//! ```json
//! { "text": "Make every panel flat.",
//!   "goals": [ { "measure": "planarity", "at_most": 0.001 },
//!              { "measure": "planarity", "beyond": 0.001, "at_most": 3 },
//!              { "constraint": "Eaves", "at_most": 0.01 },
//!              { "build": "beam_warp", "at_most": 0.001 } ],
//!   "lock": ["mesh", "constraints"] }
//! ```

use super::file::{RESULTS, VERSION, from_json};
use super::text::{field, lines, number, object, point, rows, text};
use super::{constraint, handle};
use crate::json::{JsonError, found, present};
use crate::scene::{Goal, GoalOf, GoalResult, Lesson, Lock, NamedEnum, Results, SceneError};
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
    #[serde(default)]
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(optional, type = "(\"weights\" | \"constraints\" | \"handles\" | \"mesh\")[]")
    )]
    lock: Vec<Lock>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct GoalFile {
    #[serde(default, deserialize_with = "present")]
    measure: Option<String>,
    #[serde(default, deserialize_with = "present")]
    build: Option<String>,
    #[serde(default, deserialize_with = "present")]
    constraint: Option<String>,
    #[serde(default, deserialize_with = "present")]
    beyond: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    at_most: Option<f64>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct ResultFile {
    #[serde(default, deserialize_with = "present")]
    measure: Option<String>,
    #[serde(default, deserialize_with = "present")]
    build: Option<String>,
    #[serde(default, deserialize_with = "present")]
    constraint: Option<String>,
    #[serde(default, deserialize_with = "present")]
    beyond: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    at_most: Option<f64>,
    value: Option<f64>,
    met: bool,
}

impl<'de> Deserialize<'de> for Lesson {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Lesson, D::Error> {
        let LessonFile { text, goals, lock } = LessonFile::deserialize(from)?;
        if goals.is_empty() {
            let message = "found an array of 0, expected at least one goal";
            return Err(D::Error::custom(JsonError::new("goals", message)));
        }
        Ok(Lesson { text, goals, lock })
    }
}

impl<'de> Deserialize<'de> for Goal {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Goal, D::Error> {
        goal_of(GoalFile::deserialize(from)?).map_err(D::Error::custom)
    }
}

impl<'de> Deserialize<'de> for GoalResult {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<GoalResult, D::Error> {
        let ResultFile { measure, build, constraint, beyond, at_most, value, met } =
            ResultFile::deserialize(from)?;
        let goal = goal_of(GoalFile { measure, build, constraint, beyond, at_most });
        Ok(GoalResult { goal: goal.map_err(D::Error::custom)?, value, met })
    }
}

fn goal_of(file: GoalFile) -> Result<Goal, JsonError> {
    const WHAT: &str = "{\"measure\": ...}, {\"constraint\": ...} or {\"build\": ...}";
    let error = |message: String| Err(JsonError::new("", message));
    let from_zero = |key: &str, value: f64| match value >= 0.0 {
        true => Ok(value),
        false => Err(found(&value.into(), "a number from 0").below_key(key)),
    };
    let beyond = file.beyond.map(|beyond| from_zero("beyond", beyond)).transpose()?;
    let of = match (file.measure, file.constraint, file.build) {
        (Some(measure), None, None) => match beyond {
            Some(tolerance) => GoalOf::Beyond { measure, tolerance },
            None => GoalOf::Measure(measure),
        },
        (None, ..) if beyond.is_some() => {
            return error("`beyond` is only for measures, expected a \"measure\"".to_owned());
        }
        (None, Some(name), None) => GoalOf::Constraint(name),
        (None, None, Some(id)) => GoalOf::Build(id),
        (None, None, None) => return error(format!("the goal has no quantity, expected {WHAT}")),
        _ => return error(format!("the goal has two quantities, expected {WHAT}")),
    };
    let at_most = file.at_most.ok_or_else(|| JsonError::missing_field("at_most"))?;
    Ok(Goal { of, at_most: from_zero("at_most", at_most)? })
}

pub(super) fn write(lesson: &Lesson) -> String {
    let goals = lesson.goals.iter().map(|goal| object(goal_fields(goal))).collect();
    let mut fields =
        vec![field("text", text(&lesson.text)), field("goals", lines('[', goals, ']'))];
    if !lesson.lock.is_empty() {
        let words: Vec<_> = lesson.lock.iter().map(|lock| text(lock.word())).collect();
        fields.push(field("lock", format!("[{}]", words.join(", "))));
    }
    object(fields)
}

fn goal_fields(goal: &Goal) -> Vec<String> {
    let mut fields = match &goal.of {
        GoalOf::Measure(id) => vec![field("measure", text(id))],
        GoalOf::Beyond { measure, tolerance } => {
            vec![field("measure", text(measure)), field("beyond", number(*tolerance))]
        }
        GoalOf::Constraint(name) => vec![field("constraint", text(name))],
        GoalOf::Build(id) => vec![field("build", text(id))],
    };
    fields.push(field("at_most", number(goal.at_most)));
    fields
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
        let steps: Vec<_> = self.steps.iter().map(|step| text(step)).collect();
        let mut fields = vec![
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
            field("steps", format!("[{}]", steps.join(", "))),
        ];
        fields.extend(self.weights.map(|w| {
            let values = [("shape", w.shape), ("close", w.close), ("smooth", w.smooth)];
            field("weights", object(values.map(|(key, value)| field(key, number(value))).into()))
        }));
        let settings = self.settings.iter().map(|(id, value)| field(id, value.to_string()));
        fields.push(field("settings", object(settings.collect())));
        fields.extend(self.moved.map(|moved| field("moved", number(moved))));
        fields.extend(self.distance.map(|distance| field("distance", number(distance))));
        fields.push(field("positions", rows(self.positions.iter().map(point), "")));
        format!("{{\n  {}\n}}\n", fields.join(",\n  "))
    }
}
