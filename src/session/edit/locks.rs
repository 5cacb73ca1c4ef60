//! Locks of a lesson: what an edit has changed is refused if it is locked, whichever edit it is.

use super::edit_list::Edit;
use crate::scene::{Lesson, Lock, Scene, SceneError, Variant, Variants};
use crate::session::state::{Draft, Part, Settings, uses};
use crate::solve::Handle;

/// Refuses `edit` before it is tried, if the lesson of `document` locks what it is sure to change.
///
/// # Errors
/// With the path `lesson.lock`.
pub(crate) fn check_locks(edit: &Edit, document: &Scene) -> Result<(), SceneError> {
    let Some(now @ Lesson { lock, .. }) = &document.lesson else { return Ok(()) };
    // Otherwise a student could remove the lesson, change everything, and restore the lesson.
    let is_same = |lesson: &Option<Lesson>| lesson.as_ref().is_some_and(|it| it.asks_the_same(now));
    let changes = matches!(edit, Edit::SetLesson { lesson, .. } if !is_same(lesson));
    if changes && !lock.is_empty() {
        let message = "locked by the lesson: it cannot be changed while it locks parts of the scene. If you have just written it, press Undo".to_owned();
        return Err(SceneError { path: "lesson.lock".to_owned(), message });
    }
    // To try these takes as long as they do.
    let changed: &[Lock] = match edit {
        Edit::FitTo { .. } => &[Lock::Weights, Lock::Mesh],
        Edit::Refine { .. } | Edit::Remesh(_) | Edit::TakePose { .. } => &[Lock::Mesh],
        _ => &[],
    };
    changed.iter().try_for_each(|part| check_lock(*part, document))
}

/// Refuses the changes of an edit that the lesson locks; the `handles` are those before it.
///
/// # Errors
/// As [`check_locks`].
pub(super) fn check_changes(draft: &Draft<'_>, handles: &[Handle]) -> Result<(), SceneError> {
    let document = draft.document();
    if document.lesson.is_none() {
        return Ok(());
    }
    let mut changed: Vec<Lock> = draft.changed().flat_map(|it| locks_of(it, document)).collect();
    if draft.handles() != handles {
        changed.push(Lock::Handles);
    }
    changed.into_iter().try_for_each(|part| check_lock(part, document))
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

/// Returns what a lesson may lock, of a part that was so `before` and is another one `now`.
fn locks_of(before: &Part, now: &Scene) -> Vec<Lock> {
    match before {
        Part::Units(_) | Part::Up(_) => vec![Lock::Mesh],
        Part::Settings(before) => before.locks_beside(&Settings::of(now)),
        Part::ClosenessWeights(_) => vec![Lock::Weights],
        Part::RowName(..) | Part::Row(..) | Part::Rows(_) => vec![Lock::Constraints],
        Part::RowValues(index, before) if before.weight != now.constraints[*index].weight => {
            vec![Lock::Weights, Lock::Constraints]
        }
        // Not what a search has eased.
        Part::RowValues(index, before) if before.asks_as(&now.constraints[*index]) => Vec::new(),
        Part::RowValues(..) => vec![Lock::Constraints],
        Part::Set(name, before) => {
            let [by_rows, by_weights] = uses(name, now);
            let is_of_rows = (by_rows || before.is_some()).then_some(Lock::Constraints);
            let is_of_weights = by_weights.then_some(Lock::Weights);
            is_of_rows.into_iter().chain(is_of_weights).collect()
        }
        // The shape is kept close to the design; to leave it is a reset.
        Part::Variants(before)
            if design(&now.variants).is_some_and(|it| Some(it) != design(before)) =>
        {
            vec![Lock::Weights]
        }
        Part::Variants(_)
        | Part::Tolerance(_)
        | Part::Lesson(_)
        | Part::Build(_)
        | Part::Steps(_) => Vec::new(),
    }
}

fn design(variants: &Variants) -> Option<&Variant> {
    variants.kept.get(variants.design?)
}
