//! The results that a student hands in, and what a teacher finds when they are checked.

use super::Session;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, GoalResult, MeshSource, Results, Scene, SceneError};

impl Session {
    /// The results that `student` hands in at `time`; none without a lesson.
    pub fn results(&mut self, student: &str, time: &str) -> Option<Results> {
        self.document().lesson.as_ref()?;
        let goals = self.goals();
        let Scene { title, constraints, handles, .. } = self.scene();
        Some(Results {
            student: student.to_owned(),
            title,
            scene: self.document().fingerprint(self.mesh()),
            time: time.to_owned(),
            iterations: self.iteration(),
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
