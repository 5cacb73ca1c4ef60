//! Edits of a presentation: replacing its steps, and showing one of them.

use super::iteration_state::{IterationState, reset};
use super::variants;
use crate::scene::{SceneError, Slide};
use crate::session::state::{Draft, Part};

/// Replaces the steps.
///
/// # Errors
/// If there are too many, or one has an invalid weight or refers to a missing variant.
pub(super) fn set(steps: Vec<Slide>, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    draft.put(Part::Steps(steps));
    draft.document().check_steps()?;
    Ok("Change presentation".to_owned())
}

/// Goes to the shape and the weights of a step.
///
/// # Errors
/// If the step does not exist.
pub(super) fn show(
    index: usize,
    draft: &mut Draft<'_>,
    state: &mut IterationState,
) -> Result<String, SceneError> {
    let steps = &draft.document().steps;
    let step = steps.get(index).ok_or_else(|| SceneError {
        path: format!("steps[{index}]"),
        message: format!("there is no such step: the presentation has {}", steps.len()),
    })?;
    let words = format!("Show {}", step.title);
    let Slide { original, variant, weights, .. } = *step;
    if original {
        reset(draft, state);
    }
    if let Some(variant) = variant {
        variants::go_to(variant, draft)?;
    }
    if let Some(weights) = weights {
        draft.set(|document| {
            document.weights = weights;
            Ok(())
        })?;
    }
    Ok(words)
}

/// After the removal of variants: gives the steps the new index `now` of theirs, or none.
pub(super) fn renumber_variants(draft: &mut Draft<'_>, now: impl Fn(usize) -> Option<usize>) {
    let mut steps = draft.document().steps.clone();
    steps.iter_mut().for_each(|step| step.variant = step.variant.and_then(&now));
    draft.put(Part::Steps(steps));
}
