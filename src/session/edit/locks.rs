//! Locks of a lesson: what an edit has changed is refused if it is locked, whichever edit it is.

use super::edit_list::{Edit, PanelStart};
use crate::scene::{ConstraintSpec, Lesson, Lock, Scene, SceneError, Variant, Variants};
use crate::session::state::{Draft, other_sets, uses};
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
    // Edits that read or make a mesh are refused before they are tried, which takes long. Settings that
    // a press asks for look like a search's to `locks_between`.
    let changed: &[Lock] = match edit {
        Edit::MakePanels {
            from: PanelStart::Smoother | PanelStart::Surface | PanelStart::Boundary,
            ..
        } => &[Lock::Weights],
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
    let document = &draft.document;
    if document.lesson.is_none() {
        return Ok(());
    }
    let mut changed = locks_between(draft.before, document);
    if *draft.handles != *handles {
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

/// Returns what a lesson may lock, of what differs between the document `before` an edit and that `now`.
fn locks_between(before: &Scene, now: &Scene) -> Vec<Lock> {
    let mut changed = Vec::new();
    let mut add_if = |differs: bool, lock| changed.extend(differs.then_some(lock));
    // That a search has chosen settings is no change of the user, nor that they are left again; but it
    // is one that they are the user's from now on.
    let [from, to] = [before, now].map(|scene| {
        let mut asked = scene.clone();
        asked.as_asked();
        (asked.weights, asked.closeness.to, asked.closeness.boundary, asked.smoothness)
    });
    add_if(from != to, Lock::Weights);
    let [from, to] = [before, now].map(|it| (&it.closeness.target, &it.pose));
    add_if(from != to, Lock::Mesh);
    add_if((&before.units, before.up) != (&now.units, now.up), Lock::Mesh);
    add_if(before.closeness.weights != now.closeness.weights, Lock::Weights);
    // The shape is kept close to the design; to leave it is a reset.
    let of_now = design(&now.variants);
    add_if(of_now.is_some() && of_now != design(&before.variants), Lock::Weights);
    let [from, to] = [before, now].map(|scene| &scene.constraints);
    let reweighed = from.iter().zip(to).any(|(from, to)| from.weight != to.weight);
    add_if(reweighed && from.len() == to.len(), Lock::Weights);
    // Not what a search has eased.
    let bare = |row: &ConstraintSpec| ConstraintSpec { eased: None, ..row.clone() };
    add_if(!from.iter().map(bare).eq(to.iter().map(bare)), Lock::Constraints);
    for name in other_sets(before, now) {
        let [by_rows, by_weights] = uses(name, now);
        add_if(by_rows || before.sets.contains_key(name), Lock::Constraints);
        add_if(by_weights, Lock::Weights);
    }
    changed
}

fn design(variants: &Variants) -> Option<&Variant> {
    variants.kept.get(variants.design?)
}
