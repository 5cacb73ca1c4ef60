//! Goals of a lesson, in words and as measured.

use super::face_measure::{FACE_MEASURES, FaceMeasure};
use crate::fabricate::{BUILD_NUMBERS, BuildNumber, NumberUnit};
use crate::mesh::Mesh;
use crate::scene::{ConstraintSpec, Goal, GoalOf, GoalResult, Lesson, Scene, SceneError};
use crate::session::Session;
use crate::solve::exact_tolerance;
use crate::words::{MeasureUnit, count, group_digits};
use serde::Serialize;

/// What a goal bounds, and by how much.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
pub struct GoalWords<'a> {
    /// The label of the measure, or the name of the constraint.
    pub label: &'a str,
    /// The measured quantity.
    pub words: &'static str,
    /// The unit of the values.
    pub unit: MeasureUnit,
    /// The largest value that meets the goal, in this unit.
    pub at_most: f64,
    /// The id of the measure; none if the goal is not about a measure.
    pub measure: Option<&'static str>,
    /// The id of the build number; none if the goal is not about built parts.
    pub build: Option<&'static str>,
    /// Only if faces above a value are counted: this value; `at_most` is then a count.
    pub beyond: Option<f64>,
    /// The goal in words.
    pub sentence: String,
}

/// Checks that all goals of `scene` can be measured on `mesh`.
///
/// # Errors
/// If a goal refers to a measure or a constraint that does not exist, or to a measure of faces and
/// there are none; with its JSON path.
pub(crate) fn check_lesson(scene: &Scene, mesh: &Mesh) -> Result<(), SceneError> {
    let goals = scene.lesson.iter().flat_map(|lesson| &lesson.goals);
    for (i, goal) in goals.enumerate() {
        let (key, checked) = match &goal.of {
            GoalOf::Measure(id) | GoalOf::Beyond { measure: id, .. } => {
                ("measure", check_measure(id, mesh))
            }
            GoalOf::Constraint(name) => ("constraint", check_constraint(name, scene)),
            GoalOf::Build(id) => ("build", check_build(id, mesh)),
        };
        let path = || format!("lesson.goals[{i}].{key}");
        checked.map_err(|message| SceneError { path: path(), message })?;
    }
    Ok(())
}

/// Checks that each step of the presentation of `scene` colours faces by an existing measure.
///
/// # Errors
/// As [`check_lesson`].
pub(crate) fn check_presentation(scene: &Scene, mesh: &Mesh) -> Result<(), SceneError> {
    for (i, step) in scene.steps.iter().enumerate() {
        let checked = step.measure.as_ref().map_or(Ok(()), |id| check_measure(id, mesh));
        let path = || format!("steps[{i}].measure");
        checked.map_err(|message| SceneError { path: path(), message })?;
    }
    Ok(())
}

fn check_measure(id: &str, mesh: &Mesh) -> Result<(), String> {
    check_known(id, FACE_MEASURES.iter().map(|measure| measure.id).collect(), mesh)
}

fn check_build(id: &str, mesh: &Mesh) -> Result<(), String> {
    check_known(id, BUILD_NUMBERS.iter().map(|number| number.id).collect(), mesh)
}

fn check_known(id: &str, known: Vec<&str>, mesh: &Mesh) -> Result<(), String> {
    if !known.contains(&id) {
        return Err(format!("found {id:?}, expected one of {}", known.join(", ")));
    }
    if mesh.faces.is_empty() {
        return Err("the mesh has no faces, on which this is measured".to_owned());
    }
    Ok(())
}

/// Checks that there is such a constraint, enabled or disabled.
fn check_constraint(name: &str, scene: &Scene) -> Result<(), String> {
    let mut labels: Vec<&str> = Vec::new();
    for label in scene.constraints.iter().map(ConstraintSpec::label) {
        if let Err(place) = labels.binary_search(&label) {
            labels.insert(place, label);
        }
    }
    if labels.contains(&name) {
        return Ok(());
    }
    let labels: Vec<_> = labels.iter().map(|label| format!("{label:?}")).collect();
    let expected = match &*labels {
        [] => "the name of a constraint, but the scene has none".to_owned(),
        [one] => one.clone(),
        _ => format!("one of {}", labels.join(", ")),
    };
    Err(format!("this goal is on the constraint {name:?}, expected {expected}"))
}

impl GoalWords<'_> {
    /// Whether the goal bounds a number of parts.
    fn is_count(&self) -> bool {
        self.build.is_some() && self.unit == MeasureUnit::Number
    }

    /// Returns the goal in words, on a mesh whose unit has the symbol `units`.
    fn in_words(&self, units: &str) -> String {
        let GoalWords { label, at_most, measure, build, .. } = *self;
        let written = |value: f64| self.unit.limit(value, units);
        if let Some(beyond) = self.beyond.map(written) {
            return match at_most {
                0.0 => format!("{label}: no panel beyond {beyond}"),
                _ => format!("{label} beyond {beyond}: at most {}", panels(at_most)),
            };
        }
        if measure.is_none() && build.is_none() && at_most == 0.0 {
            return format!("{label}: exact");
        }
        if self.is_count() {
            return format!("{label}: at most {at_most}");
        }
        // The name of a constraint does not say what of it is measured; a label of a measure does.
        let what = if measure.is_none() && build.is_none() { "largest distance " } else { "" };
        format!("{label}: {what}at most {}", written(at_most))
    }

    /// Returns the value of the goal on the current shape in words, in the unit of its limit, so that
    /// the two can be compared; `size` is that of the mesh.
    fn now_in_words(&self, value: f64, units: &str, size: f64) -> String {
        if self.beyond.is_some() {
            return panels(value);
        }
        if self.is_count() {
            return value.to_string();
        }
        let shown = self.unit.or_zero(value, size);
        self.unit.in_words(shown, units, if self.at_most > 0.0 { self.at_most } else { shown })
    }
}

/// Formats a number of panels; a limit may be any number from 0.
fn panels(number: f64) -> String {
    match number.fract() {
        0.0 => count(number as usize, "panel", "panels"),
        _ => format!("{number} panels"),
    }
}

/// Returns the goals of a lesson in words, in their order, on a mesh whose unit has the symbol
/// `units`.
pub fn goals_in_words<'a>(lesson: &'a Lesson, units: &str) -> Vec<GoalWords<'a>> {
    let worded = |goal| {
        let words = described(goal);
        GoalWords { sentence: words.in_words(units), ..words }
    };
    lesson.goals.iter().map(worded).collect()
}

/// The goals of a lesson on the current shape, in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LessonProgress {
    /// Each goal, in their order.
    pub goals: Vec<GoalProgress>,
    /// Whether all goals are met.
    pub passed: bool,
    /// How many goals are met: `1 of 2 goals satisfied`.
    pub words: String,
}

/// A goal on the current shape.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GoalProgress {
    /// Whether it is met.
    pub met: bool,
    /// The same in words.
    pub words: &'static str,
    /// Its value.
    pub value: String,
}

/// The words of a goal without what it bounds.
const PLAIN: GoalWords<'static> = GoalWords {
    label: "",
    words: "",
    unit: MeasureUnit::Length,
    at_most: 0.0,
    measure: None,
    build: None,
    beyond: None,
    sentence: String::new(),
};

/// Returns what a goal bounds, without the sentence.
fn described(goal: &Goal) -> GoalWords<'_> {
    let plain = GoalWords { at_most: goal.at_most, ..PLAIN };
    match &goal.of {
        GoalOf::Measure(id) | GoalOf::Beyond { measure: id, .. } => {
            let &FaceMeasure { id, label, words, unit, .. } =
                FaceMeasure::of(id).expect("goals are checked when a scene is taken over");
            let beyond = match goal.of {
                GoalOf::Beyond { tolerance, .. } => Some(tolerance),
                _ => None,
            };
            GoalWords { label, words, unit, measure: Some(id), beyond, ..plain }
        }
        GoalOf::Constraint(name) => GoalWords {
            label: name,
            words: "largest distance of a vertex to the shape of this constraint",
            ..plain
        },
        GoalOf::Build(id) => {
            let declared = BUILD_NUMBERS.iter().find(|number| number.id == id);
            let &BuildNumber { id, label, description, unit } =
                declared.expect("goals are checked when a scene is taken over");
            let unit = match unit {
                NumberUnit::Length => MeasureUnit::Length,
                NumberUnit::Degrees => MeasureUnit::Degrees,
                NumberUnit::Count => MeasureUnit::Number,
            };
            GoalWords { label, words: description, unit, build: Some(id), ..plain }
        }
    }
}

impl Session {
    /// Returns the goals of the lesson on the current shape in words; none without a lesson.
    pub fn lesson_progress(&mut self) -> Option<LessonProgress> {
        self.scene.document().lesson.as_ref()?;
        let results = self.goals();
        let (units, size) = (&self.scene.document().units, self.rest.diameter());
        let progress = |GoalResult { goal, value, met }: &GoalResult| {
            let words = if *met { "satisfied" } else { "not satisfied" };
            let value = match (value, &goal.of) {
                (Some(value), _) => described(goal).now_in_words(*value, units, size),
                (None, GoalOf::Build(id)) => match self.measured.build_number(&self.scene, id) {
                    Some(_) => "cannot be measured: see Build".to_owned(),
                    None => "measured when the shape no longer moves".to_owned(),
                },
                (None, _) => "no such constraint or value".to_owned(),
            };
            GoalProgress { met: *met, words, value }
        };
        let goals: Vec<GoalProgress> = results.iter().map(progress).collect();
        let met = goals.iter().filter(|goal| goal.met).count();
        let passed = met == goals.len();
        let words = match passed {
            true => format!("Passed: {} satisfied", count(met, "goal", "goals")),
            false => {
                format!(
                    "{} of {} satisfied",
                    group_digits(met),
                    count(goals.len(), "goal", "goals")
                )
            }
        };
        Some(LessonProgress { goals, passed, words })
    }

    /// Returns the value of each goal of the lesson on the current shape, in their order; empty
    /// without a lesson. A goal on the built parts has no value before [`Session::set_build_numbers`].
    pub fn goals(&mut self) -> Vec<GoalResult> {
        let lesson = self.scene.document().lesson.as_ref();
        let goals = lesson.map(|lesson| lesson.goals.clone()).unwrap_or_default();
        let exact = exact_tolerance(self.rest.mesh());
        let size = self.rest.diameter();
        let result = |goal: Goal| {
            let value = self.worst_of(&goal.of);
            // A limit of zero means exact, and rounding errors keep the value above zero.
            let is_within = |value: f64| match goal.of {
                GoalOf::Constraint(_) => value <= goal.at_most.max(exact),
                GoalOf::Beyond { .. } => value <= goal.at_most,
                GoalOf::Measure(_) | GoalOf::Build(_) => {
                    described(&goal).unit.or_zero(value, size) <= goal.at_most
                }
            };
            GoalResult { met: value.is_some_and(is_within), goal, value }
        };
        goals.into_iter().map(result).collect()
    }

    /// Returns the largest absolute value, or the number of faces above the limit; none if nothing has a
    /// value.
    fn worst_of(&mut self, of: &GoalOf) -> Option<f64> {
        match of {
            GoalOf::Measure(id) => {
                let values = self.face_errors(id)?.into_iter();
                values.filter(|value| !value.is_nan()).reduce(f64::max)
            }
            GoalOf::Beyond { measure, tolerance } => {
                let values = self.face_errors(measure)?;
                let has_one = values.iter().any(|value| !value.is_nan());
                let beyond = values.iter().filter(|value| **value > *tolerance).count();
                has_one.then_some(beyond as f64)
            }
            GoalOf::Build(id) => self.measured.build_number(&self.scene, id).flatten(),
            GoalOf::Constraint(name) => {
                let specs = self.scene.document().constraints.iter();
                let enabled = specs.filter(|spec| spec.enabled);
                let found = enabled.zip(self.scene.solver().found());
                let called_so = found.filter(|(spec, _)| spec.label() == name);
                called_so.map(|(_, found)| found.worst_squared.sqrt()).reduce(f64::max)
            }
        }
    }

    /// Stores numbers of the parts built from the current shape, by the ids of
    /// [`crate::fabricate::BUILD_NUMBERS`], until the shape, the settings of the build or the unit change.
    /// What has no value is left out: of what cannot be built, all.
    pub fn set_build_numbers(&mut self, numbers: Vec<(String, f64)>) {
        self.measured.set_build_numbers(&self.scene, numbers);
    }
}
