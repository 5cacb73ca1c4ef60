//! Results that a student hands in, and their check by a teacher.

use super::Session;
use super::edit::{is_of_solver, settings_of};
use super::state::resolve_row;
use crate::constraint::Selector;
use crate::fabricate::{BUILD_NUMBERS, Build, Stand, unit_of};
use crate::mesh::{Mesh, Topology};
use crate::scene::{
    BoundaryRequire, BuildSettings, ConstraintSpec, Goal, GoalOf, GoalResult, Lock, MeshSource,
    NamedEnum, Results, Scene, SceneError,
};
use crate::session::Error;
use crate::solve::Require;
use serde_json::Value;
use std::rc::Rc;

impl Session {
    /// Returns the results that `student` hands in at `time`; none without a lesson.
    pub fn results(&mut self, student: &str, time: &str) -> Option<Results> {
        self.document().lesson.as_ref()?;
        let goals = self.goals();
        // As it was asked for, before a search chose how to solve it.
        let mut asked = self.scene();
        asked.as_asked();
        let settings = settings_of(&asked);
        let Scene { title, constraints, handles, weights, .. } = asked;
        Some(Results {
            student: student.to_owned(),
            title,
            scene: self.document().fingerprint(self.mesh()),
            mesh: self.document().lesson.as_ref().and_then(|lesson| {
                let is_other = lesson.given.is_some();
                is_other.then(|| MeshSource::Inline(Box::new(self.mesh().clone())))
            }),
            time: time.to_owned(),
            iterations: self.iteration(),
            passed: goals.iter().all(|goal| goal.met),
            goals,
            constraints,
            handles,
            steps: self.history.steps()[0].iter().map(|(name, _)| name.clone()).collect(),
            weights: Some(weights),
            settings,
            moved: Some(self.moved().max),
            distance: Some(self.worst_distance()),
            positions: self.positions(),
        })
    }
}

/// The outcome of measuring the results of a student again.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The goals as measured.
    pub goals: Vec<GoalResult>,
    /// Largest displacement of a vertex, in the unit of the mesh.
    pub moved: f64,
    /// Largest distance of a vertex to its projection by a constraint, in the unit of the mesh.
    pub distance: f64,
    /// The locked parts that differ from the scene.
    pub altered: Vec<Lock>,
    /// Other changes, in words.
    pub changed: Vec<String>,
}

/// Measures the shape of `results` with the lesson and the constraints of `scene`, on its `mesh`, or
/// on the one that the student put in its place: then with the constraints of all elements of a kind,
/// since the numbers of others are those of the first mesh, and a goal on another constraint is not
/// met. The measurements and the constraints in the results are not trusted.
///
/// # Errors
/// If the results are of another scene, or the scene has no lesson.
pub fn check_results(results: &Results, scene: Scene, mesh: Mesh) -> Result<Checked, Error> {
    let at = |path: &str, message: String| SceneError { path: path.to_owned(), message };
    let Some(lesson) = &scene.lesson else {
        return Err(at("", "the scene has no lesson, expected goals to check".to_owned()).into());
    };
    let expected = scene.fingerprint(&mesh);
    if results.scene != expected {
        let found = &results.scene;
        let message = format!(
            "found {found:?}, expected \"{expected}\": the results are of another mesh or lesson"
        );
        return Err(at("scene", message).into());
    }
    let (locks, goals) = (lesson.lock.clone(), lesson.goals.clone());
    // The scene as written if it is handed in unchanged.
    let mut given = Session::open(scene.clone(), mesh.clone())?.scene();
    given.as_asked();
    let other = other_mesh(results, &mesh)?.map(|other| {
        let topology = Topology::new(&other);
        (other, topology)
    });
    let is_left =
        |row: &ConstraintSpec| other.as_ref().is_none_or(|other| can_be_carried(row, other));
    let different = differences(results, &given, other.is_some(), is_left);
    let (altered, changed) =
        different.into_iter().partition::<Vec<_>, _>(|(part, _)| locks.contains(part));
    let mut altered: Vec<Lock> = altered.into_iter().map(|(part, _)| part).collect();
    altered.dedup();
    let mut changed: Vec<String> = changed.into_iter().map(|(_, words)| words).collect();
    if other.is_some() {
        match locks.contains(&Lock::Mesh) {
            true => altered.push(Lock::Mesh),
            false => changed.push("mesh".to_owned()),
        }
    }

    // Of several rows of one name, all that are enabled count, or all if none is.
    let is_measured = |goal: &Goal| match &goal.of {
        GoalOf::Constraint(name) => {
            let rows = || scene.constraints.iter().filter(|row| row.label() == name);
            let is_enabled = rows().any(|row| row.enabled);
            rows().filter(|row| row.enabled == is_enabled).all(is_left)
        }
        GoalOf::Measure(_) | GoalOf::Beyond { .. } | GoalOf::Build(_) => true,
    };
    let mut measuring = measuring_scene(&scene);
    measuring.constraints.retain(is_left);
    if let Some(lesson) = &mut measuring.lesson {
        lesson.goals.retain(is_measured);
    }
    let mesh = match &other {
        Some((other, _)) => {
            leave_mesh(&mut measuring, mesh);
            other.clone()
        }
        None => mesh,
    };
    measuring.current = Some(results.positions.clone());
    // The positions are the shape of that scene.
    let of_results = |error: Error| match error {
        Error::Scene(SceneError { path, message }) if path.starts_with("current") => {
            at(&path.replacen("current", "positions", 1), message).into()
        }
        error => error,
    };
    let mut session = Session::open(measuring, mesh).map_err(of_results)?;
    if goals.iter().any(|goal| matches!(goal.of, GoalOf::Build(_))) {
        let stand = Stand::on(&results.handles, scene.up);
        let mut build = scene.build.as_deref().cloned().unwrap_or_default();
        if other.is_some() {
            // They are edges of the mesh of the scene.
            build.seams = Rc::default();
        }
        session.set_build_numbers(numbers(&session, &scene.units, &build, &stand));
    }
    let mut measured = session.goals().into_iter();
    let result = |goal: Goal| {
        let own = is_measured(&goal).then(|| measured.next()).flatten();
        own.unwrap_or(GoalResult { goal, value: None, met: false })
    };
    Ok(Checked {
        goals: goals.into_iter().map(result).collect(),
        moved: session.moved().max,
        distance: session.worst_distance(),
        altered,
        changed,
    })
}

/// Returns the part of a scene by which a shape is measured, in which nothing moves a vertex: neither
/// handles nor a fixed boundary.
fn measuring_scene(scene: &Scene) -> Scene {
    let Scene { sets, constraints, pose, lesson, .. } = scene.clone();
    let mut measuring = Scene { sets, constraints, pose, lesson, ..Scene::default() };
    measuring.closeness.to = scene.closeness.to;
    // What the distance to the original is measured to.
    measuring.closeness.target.clone_from(&scene.closeness.target);
    // To switch a constraint on may be the task.
    for goal in measuring.lesson.iter().flat_map(|lesson| &lesson.goals) {
        let GoalOf::Constraint(name) = &goal.of else { continue };
        let mut own: Vec<_> =
            measuring.constraints.iter_mut().filter(|row| row.label() == name).collect();
        if own.iter().all(|row| !row.enabled) {
            own.iter_mut().for_each(|row| row.enabled = true);
        }
    }
    measuring
}

/// Removes what is on elements of the mesh of a scene, `given`, because another one takes its place.
fn leave_mesh(scene: &mut Scene, given: Mesh) {
    scene.closeness.stay_on(&Rc::new(given));
    (scene.sets, scene.pose) = Default::default();
    scene.constraints.iter_mut().for_each(|row| row.eased = None);
}

/// Whether a row is on all elements of a kind, which `other` has.
fn can_be_carried(row: &ConstraintSpec, (other, topology): &(Mesh, Topology)) -> bool {
    let bare = Scene::default();
    matches!(row.on, Selector::Each { within: None, .. })
        && resolve_row(row, &bare, other, topology).is_ok()
}

/// The mesh of the results, if it is not `given`.
///
/// # Errors
/// If the results only name its file.
fn other_mesh(results: &Results, given: &Mesh) -> Result<Option<Mesh>, SceneError> {
    match &results.mesh {
        None => Ok(None),
        Some(MeshSource::Inline(mesh)) => {
            let is_given = mesh.positions == given.positions
                && mesh.faces == given.faces
                && mesh.tets == given.tets;
            Ok((!is_given).then(|| (**mesh).clone()))
        }
        Some(MeshSource::File(path)) => {
            let message = format!("found the file {path:?}, expected the mesh itself");
            Err(SceneError { path: "mesh".to_owned(), message })
        }
    }
}

/// The build numbers of the current shape, in a unit and with settings, as it stands; empty if not
/// buildable.
fn numbers(
    shape: &Session,
    units: &str,
    settings: &BuildSettings,
    stand: &Stand,
) -> Vec<(String, f64)> {
    let Ok(unit) = unit_of(units) else { return Vec::new() };
    let mesh = shape.current_shape();
    let Ok(build) = Build::new(&mesh, settings, unit, stand) else { return Vec::new() };
    let known = BUILD_NUMBERS.iter().zip(build.numbers());
    known.filter_map(|(number, value)| Some((number.id.to_owned(), value?))).collect()
}

/// Returns the differences from the given scene in words, with the part they concern.
/// On another mesh only what has no numbers of elements, and not what is carried over to it by itself;
/// rows that `is_left` on it.
fn differences(
    results: &Results,
    given: &Scene,
    is_other_mesh: bool,
    is_left: impl Fn(&ConstraintSpec) -> bool,
) -> Vec<(Lock, String)> {
    let is_carried = |id: &str| is_other_mesh && ["closeness", "boundary"].contains(&id);
    let mut found = Vec::new();
    match results.weights {
        Some(weights) => {
            let [from, to] = [given.weights, weights];
            let pairs = [
                ("shape", from.shape, to.shape),
                ("close", from.close, to.close),
                ("smooth", from.smooth, to.smooth),
            ];
            for (name, from, to) in pairs.into_iter().filter(|(_, from, to)| from != to) {
                found.push((Lock::Weights, format!("{name} weight {from} to {to}")));
            }
        }
        None => found.push((Lock::Weights, "weights missing".to_owned())),
    }
    for (id, from) in &settings_of(given) {
        let to = results.settings.get(id);
        if !is_of_solver(id) && !is_carried(id) && to.is_none_or(|to| !same_value(to, from)) {
            found.push((Lock::Weights, format!("setting {id}")));
        }
    }
    // Which panels have a relaxed tolerance is found by the search, and not set by anybody; and in
    // results of earlier versions what is met within a distance has become exact by itself.
    let own = |specs: &[ConstraintSpec]| -> Vec<ConstraintSpec> {
        let left = specs.iter().filter(|spec| is_left(spec));
        left.map(|spec| ConstraintSpec { eased: None, ..spec.clone() }).collect()
    };
    let (mut now, before) = (own(&results.constraints), own(&given.constraints));
    for (now, before) in now.iter_mut().zip(&before) {
        if now.require == Require::Exact && matches!(before.require, Require::Within(_)) {
            now.require = before.require;
        }
    }
    if now != before {
        // The weight of an added row does not count as a changed weight.
        let unweighed = |specs: &[ConstraintSpec]| -> Vec<ConstraintSpec> {
            specs.iter().map(|spec| ConstraintSpec { weight: 1.0, ..spec.clone() }).collect()
        };
        if unweighed(&now) == unweighed(&before) {
            found.push((Lock::Weights, "weights of constraints".to_owned()));
        }
        found.push((Lock::Constraints, "constraints".to_owned()));
    }
    if !is_other_mesh && results.handles != given.handles {
        found.push((Lock::Handles, "handles".to_owned()));
    }
    found
}

/// Compares a value `handed_in` with that of a setting. A whole number may be written with or without a
/// decimal point, and results of earlier versions have other words for how the boundary is held.
fn same_value(handed_in: &Value, given: &Value) -> bool {
    let word = match handed_in.as_str() {
        Some("exactly") => Some(BoundaryRequire::Exact.word()),
        Some("nearly") => Some(BoundaryRequire::Soft.word()),
        word => word,
    };
    match word {
        Some(word) => given.as_str() == Some(word),
        None => handed_in.as_f64().is_some_and(|number| given.as_f64() == Some(number)),
    }
}
