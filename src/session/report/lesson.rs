//! Goals of a lesson, in words and as measured.

use super::face_measure::{FACE_MEASURES, FaceMeasure, MeasureUnit, face_values};
use super::measuring::{Measuring, Shape};
use crate::fabricate::{BUILD_NUMBERS, BuildNumber, NumberUnit};
use crate::mesh::Mesh;
use crate::scene::{ConstraintSpec, Goal, GoalOf, GoalResult, Lesson, Scene, SceneError};
use crate::solve::exact_tolerance;
use serde::Serialize;

/// A goal in words.
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

/// Returns the goals of a lesson in words, in their order.
pub fn goals_in_words(lesson: &Lesson) -> Vec<GoalWords<'_>> {
    lesson.goals.iter().map(goal_in_words).collect()
}

fn goal_in_words(goal: &Goal) -> GoalWords<'_> {
    match &goal.of {
        GoalOf::Measure(id) | GoalOf::Beyond { measure: id, .. } => {
            let measure =
                FaceMeasure::of(id).expect("goals are checked when a scene is taken over");
            GoalWords {
                label: measure.label,
                words: measure.words,
                unit: measure.unit,
                at_most: goal.at_most,
                measure: Some(measure.id),
                build: None,
                beyond: match goal.of {
                    GoalOf::Beyond { tolerance, .. } => Some(tolerance),
                    _ => None,
                },
            }
        }
        GoalOf::Constraint(name) => GoalWords {
            label: name,
            words: "largest distance of a vertex to the shape of this constraint",
            unit: MeasureUnit::Length,
            at_most: goal.at_most,
            measure: None,
            build: None,
            beyond: None,
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
            let (measure, beyond) = (None, None);
            GoalWords {
                label,
                words: description,
                unit,
                at_most: goal.at_most,
                measure,
                build: Some(id),
                beyond,
            }
        }
    }
}

/// Returns the value of each goal of the lesson on the current shape, in their order.
pub(crate) fn goals(model: &mut Measuring<'_>) -> Vec<GoalResult> {
    let lesson = model.scene.document().lesson.as_ref();
    let goals = lesson.map(|lesson| lesson.goals.clone()).unwrap_or_default();
    let exact = exact_tolerance(model.rest.mesh());
    let result = |goal: Goal| {
        let value = worst_of(model, &goal.of);
        // A limit of zero means exact, and rounding errors keep the value above zero.
        let at_most = match goal.of {
            GoalOf::Constraint(_) => goal.at_most.max(exact),
            GoalOf::Measure(_) | GoalOf::Beyond { .. } | GoalOf::Build(_) => goal.at_most,
        };
        GoalResult { met: value.is_some_and(|value| value <= at_most), goal, value }
    };
    goals.into_iter().map(result).collect()
}

/// Returns the largest value, or the number of faces above the limit; none if nothing has a value.
fn worst_of(model: &mut Measuring<'_>, of: &GoalOf) -> Option<f64> {
    match of {
        GoalOf::Measure(id) => {
            let values = face_values(model, id, Shape::Now)?.into_iter();
            values.filter(|value| !value.is_nan()).reduce(f64::max)
        }
        GoalOf::Beyond { measure, tolerance } => {
            let values = face_values(model, measure, Shape::Now)?;
            let has_one = values.iter().any(|value| !value.is_nan());
            let beyond = values.iter().filter(|value| *value > tolerance).count();
            has_one.then_some(beyond as f64)
        }
        GoalOf::Build(id) => model.cache.external_number(model.scene, id),
        GoalOf::Constraint(name) => {
            let specs = model.scene.document().constraints.iter();
            let enabled = specs.filter(|spec| spec.enabled);
            let found = enabled.zip(model.scene.solver().found());
            let called_so = found.filter(|(spec, _)| spec.label() == name);
            called_so.map(|(_, found)| found.worst_squared.sqrt()).reduce(f64::max)
        }
    }
}
