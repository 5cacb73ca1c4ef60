//! Locks of a lesson: the edits that they forbid.

use super::edit_list::Edit;
use super::settings::is_of_solver;
use crate::scene::{Lesson, Lock, Scene, SceneError};

/// Refuses `edit` if the lesson of `document` locks a part that it would change.
///
/// # Errors
/// With the path `lesson.lock`.
pub(crate) fn check_locks(edit: &Edit, document: &Scene) -> Result<(), SceneError> {
    let Some(now @ Lesson { lock, .. }) = &document.lesson else { return Ok(()) };
    // Otherwise a student could remove the lesson, change everything, and restore the lesson.
    let changes = matches!(edit, Edit::SetLesson { lesson, .. } if lesson.as_ref() != Some(now));
    if changes && !lock.is_empty() {
        let message =
            "locked by the lesson: only where it was just written, Undo removes it".to_owned();
        return Err(SceneError { path: "lesson.lock".to_owned(), message });
    }
    let changed = changed_by(edit, document);
    changed.iter().find(|part| lock.contains(part)).map_or(Ok(()), |part| Err(locked(*part)))
}

/// Refuses a change of `part` if the lesson of `document` locks it.
///
/// # Errors
/// As [`check_locks`].
pub(crate) fn check_lock(part: Lock, document: &Scene) -> Result<(), SceneError> {
    let is_locked = document.lesson.as_ref().is_some_and(|lesson| lesson.lock.contains(&part));
    if is_locked { Err(locked(part)) } else { Ok(()) }
}

fn locked(part: Lock) -> SceneError {
    let words = match part {
        Lock::Weights => "weights, closeness and smoothness cannot be changed",
        Lock::Constraints => "constraints cannot be changed",
        Lock::Handles => "handles cannot be changed",
        Lock::Mesh => "the mesh cannot be changed",
    };
    let message = format!("locked by the lesson: {words}");
    SceneError { path: "lesson.lock".to_owned(), message }
}

/// Returns the lockable parts that an edit changes.
fn changed_by(edit: &Edit, document: &Scene) -> &'static [Lock] {
    match edit {
        Edit::MakePanels { from, .. } if from.changes_settings() => {
            &[Lock::Weights, Lock::Constraints]
        }
        Edit::AddConstraint(_)
        | Edit::MakePanels { .. }
        | Edit::RemoveConstraint { .. }
        | Edit::DuplicateConstraint { .. }
        | Edit::RenameConstraint { .. }
        | Edit::RemoveSet { .. } => &[Lock::Constraints],
        // A set under a new name is not used by any constraint.
        Edit::NameSet { name, .. } if document.sets.contains_key(name) => &[Lock::Constraints],
        Edit::NameSet { .. } => &[],
        Edit::SetConstraint { weight: Some(_), .. } => &[Lock::Weights, Lock::Constraints],
        Edit::SetConstraint { .. } => &[Lock::Constraints],
        Edit::Set { id, .. } if is_of_solver(id) => &[],
        Edit::Set { .. }
        | Edit::HoldClose { .. }
        | Edit::HoldCloser
        | Edit::SetWeights(_)
        | Edit::Preset { .. } => &[Lock::Weights],
        Edit::ShowStep { .. } => &[Lock::Weights, Lock::Handles],
        // The shape is kept close to the design, and handles move to it.
        Edit::KeepVariant { .. } | Edit::GoToVariant { .. } => &[Lock::Weights, Lock::Handles],
        Edit::FitTo { .. } => &[Lock::Weights, Lock::Mesh],
        Edit::TakePose { .. }
        | Edit::LeavePose
        | Edit::SetUnits { .. }
        | Edit::SetUp { .. }
        | Edit::Refine { .. }
        | Edit::Remesh(_) => &[Lock::Mesh],
        Edit::WeighHandles { .. } | Edit::AddHandles { .. } | Edit::RemoveHandles { .. } => {
            &[Lock::Handles]
        }
        Edit::SetLesson { .. }
        | Edit::SetTolerance { .. }
        | Edit::SetBuild { .. }
        | Edit::SetSteps { .. }
        | Edit::RemoveVariant { .. }
        | Edit::Reset => &[],
    }
}
