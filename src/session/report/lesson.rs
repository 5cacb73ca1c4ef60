//! The goals of a lesson on the shape as it is, and the results that a student hands in.

use super::face_measure::{FACE_MEASURES, FaceMeasure, MeasureUnit};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{
    ClosenessTo, ConstraintSpec, Goal, GoalOf, GoalResult, Lesson, MeshSource, Results, Scene,
    SceneError,
};
use crate::session::state::Session;
use serde::Serialize;

/// A goal in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct GoalWords<'a> {
    /// The label of the measure, or the name of the constraint.
    pub label: &'a str,
    /// The measured quantity.
    pub words: &'static str,
    /// The unit of the values.
    pub unit: MeasureUnit,
    /// How large it may be, in that unit.
    pub at_most: f64,
    /// The id of the measure; none where it is about a constraint.
    pub measure: Option<&'static str>,
}

/// Checks that `scene` asks for nothing that cannot be measured on `mesh`.
///
/// # Errors
/// A goal on a measure that there is not, on one of faces where there are none, or on a constraint that
/// there is not, with its JSON path.
pub(crate) fn check_lesson(scene: &Scene, mesh: &Mesh) -> Result<(), SceneError> {
    let goals = scene.lesson.iter().flat_map(|lesson| &lesson.goals);
    for (i, goal) in goals.enumerate() {
        let (key, checked) = match &goal.of {
            GoalOf::Measure(id) => ("measure", check_measure(id, mesh)),
            GoalOf::Constraint(name) => ("constraint", check_constraint(name, scene)),
        };
        let path = || format!("lesson.goals[{i}].{key}");
        checked.map_err(|message| SceneError { path: path(), message })?;
    }
    Ok(())
}

fn check_measure(id: &str, mesh: &Mesh) -> Result<(), String> {
    if declared(id).is_none() {
        let known: Vec<_> = FACE_MEASURES.iter().map(|measure| measure.id).collect();
        return Err(format!("found {id:?}, expected one of {}", known.join(", ")));
    }
    if mesh.faces.is_empty() {
        return Err("this is measured on faces, and the mesh has none".to_owned());
    }
    Ok(())
}

/// One that is switched off is there.
fn check_constraint(name: &str, scene: &Scene) -> Result<(), String> {
    let mut labels: Vec<_> = scene.constraints.iter().map(ConstraintSpec::label).collect();
    if labels.contains(&name) {
        return Ok(());
    }
    labels.sort_unstable();
    labels.dedup();
    let labels: Vec<_> = labels.iter().map(|label| format!("{label:?}")).collect();
    let expected = match &*labels {
        [] => "a constraint, of which there are none".to_owned(),
        [one] => one.clone(),
        _ => format!("one of {}", labels.join(", ")),
    };
    Err(format!("this goal is on the constraint {name:?}, expected {expected}"))
}

fn declared(id: &str) -> Option<&'static FaceMeasure> {
    FACE_MEASURES.iter().find(|measure| measure.id == id)
}

/// The goals of a lesson in words, in their order.
pub fn goals_in_words(lesson: &Lesson) -> Vec<GoalWords<'_>> {
    lesson.goals.iter().map(goal_in_words).collect()
}

fn goal_in_words(goal: &Goal) -> GoalWords<'_> {
    match &goal.of {
        GoalOf::Measure(id) => {
            let measure = declared(id).expect("goals are checked when a scene is taken over");
            GoalWords {
                label: measure.label,
                words: measure.words,
                unit: measure.unit,
                at_most: goal.at_most,
                measure: Some(measure.id),
            }
        }
        GoalOf::Constraint(name) => GoalWords {
            label: name,
            words: "largest distance of a vertex to where this constraint wants it",
            unit: MeasureUnit::Length,
            at_most: goal.at_most,
            measure: None,
        },
    }
}

impl Session {
    /// What each goal of the lesson is on the shape as it is, in their order; empty without a lesson.
    pub fn goals(&mut self) -> Vec<GoalResult> {
        let goals = self.document.lesson.as_ref().map(|lesson| lesson.goals.clone());
        let goals = goals.unwrap_or_default().into_iter();
        goals
            .map(|goal| {
                let value = self.worst_of(&goal.of);
                GoalResult { met: value.is_some_and(|value| value <= goal.at_most), goal, value }
            })
            .collect()
    }

    /// The largest value; none where nothing has one.
    fn worst_of(&mut self, of: &GoalOf) -> Option<f64> {
        match of {
            GoalOf::Measure(id) => {
                let values = self.face_values(id)?.into_iter();
                values.filter(|value| !value.is_nan()).reduce(f64::max)
            }
            GoalOf::Constraint(name) => {
                let specs = self.document.constraints.iter();
                let enabled = specs.filter(|spec| spec.enabled);
                let found = enabled.zip(self.solver.found());
                let called_so = found.filter(|(spec, _)| spec.label() == name);
                called_so.map(|(_, found)| found.worst_squared.sqrt()).reduce(f64::max)
            }
        }
    }

    /// What `student` hands in at `time`; none without a lesson.
    pub fn results(&mut self, student: &str, time: &str) -> Option<Results> {
        self.document.lesson.as_ref()?;
        let goals = self.goals();
        let Scene { title, constraints, handles, .. } = self.scene();
        Some(Results {
            student: student.to_owned(),
            title,
            scene: self.document.fingerprint(&self.mesh),
            time: time.to_owned(),
            iterations: self.run_state.iteration,
            passed: goals.iter().all(|goal| goal.met),
            goals,
            constraints,
            handles,
            positions: self.positions(),
        })
    }
}

/// Measures the shape of `results` with the lesson and the constraints of `scene`, on its `mesh`: what
/// was handed in is not believed, and neither are constraints that a student changed.
///
/// # Errors
/// When the results are of another scene, or the scene has no lesson.
pub fn check_results(
    results: &Results,
    scene: Scene,
    mesh: Mesh,
) -> Result<Vec<GoalResult>, Error> {
    let at = |path: &str, message: String| SceneError { path: path.to_owned(), message };
    if scene.lesson.is_none() {
        return Err(at("", "the scene has no lesson, expected goals to check".to_owned()).into());
    }
    let expected = scene.fingerprint(&mesh);
    if results.scene != expected {
        let found = &results.scene;
        let message = format!(
            "found {found:?}, expected \"{expected}\": the results are of another mesh or lesson"
        );
        return Err(at("scene", message).into());
    }
    // Nothing may move a vertex: neither handles nor a boundary that is held exactly.
    let mut still = Scene::new(MeshSource::Inline(Box::default()));
    still.closeness.to = ClosenessTo::None;
    still.lesson = scene.lesson;
    still.sets = scene.sets;
    still.constraints = scene.constraints;
    still.current = Some(results.positions.clone());
    Ok(Session::open(still, mesh)?.goals())
}
