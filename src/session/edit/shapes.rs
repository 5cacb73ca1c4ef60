//! Edits that lead to another shape: the rest shape, a kept variant, a step of the presentation; and
//! those that keep and remove them.

use crate::mesh::Point;
use crate::scene::{Hold, SceneError, Slide, Variant, Variants};
use crate::session::state::Draft;
use std::rc::Rc;

/// Goes back to the rest shape; the kept variants stay.
pub(super) fn reset(draft: &mut Draft<'_>) {
    let kept = draft.document.variants.kept.clone();
    back_to_rest(Variants { kept, design: None }, draft);
}

/// Goes back to the rest shape, with these variants.
pub(super) fn back_to_rest(variants: Variants, draft: &mut Draft<'_>) {
    draft.positions = draft.rest.positions().into();
    draft.document.variants = variants;
    draft.iteration = Some(0);
}

/// Adds the current shape to the variants and makes it the design. Before the first variant, also
/// adds the shape `start` that it was derived from.
///
/// # Errors
/// If there are too many variants.
pub(super) fn keep_variant(
    start: Rc<[Point]>,
    draft: &mut Draft<'_>,
) -> Result<String, SceneError> {
    let positions = Rc::clone(&draft.positions);
    let Variants { kept, design } = &mut draft.document.variants;
    if kept.is_empty() {
        kept.push(Variant { name: "Start".to_owned(), positions: start });
    }
    if kept.len() >= Variants::MOST {
        let message = format!("{} are kept already: remove one first", kept.len());
        return Err(SceneError { path: "variants.kept".to_owned(), message });
    }
    let names = (1..).map(|number| format!("Variation {number}"));
    let name = { names }.find(|name| kept.iter().all(|variant| variant.name != *name));
    let name = name.unwrap_or_default();
    let words = format!("Keep {name}");
    *design = Some(kept.len());
    kept.push(Variant { name, positions });
    take_handles_along(draft);
    Ok(words)
}

/// Goes to a variant and makes it the design.
///
/// # Errors
/// If the variant does not exist.
pub(super) fn go_to_variant(index: usize, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let Variant { name, positions } = variant(index, draft)?.clone();
    draft.document.variants.design = Some(index);
    draft.positions = positions;
    take_handles_along(draft);
    Ok(format!("Go to {name}"))
}

/// Removes a variant.
///
/// # Errors
/// If the variant does not exist, or is the design.
pub(super) fn remove_variant(index: usize, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let words = format!("Remove {}", variant(index, draft)?.name);
    let variants = &mut draft.document.variants;
    if variants.design == Some(index) {
        let message = "this shape is open: open another one first".to_owned();
        return Err(SceneError { path: format!("variants.kept[{index}]"), message });
    }
    variants.kept.remove(index);
    variants.design = variants.design.map(|design| design - usize::from(design > index));
    Ok(words)
}

fn variant<'a>(index: usize, draft: &'a Draft<'_>) -> Result<&'a Variant, SceneError> {
    let kept = &draft.document.variants.kept;
    kept.get(index).ok_or_else(|| SceneError {
        path: format!("variants.kept[{index}]"),
        message: format!("there is no such variation: {} are kept", kept.len()),
    })
}

/// Moves the soft handles to the shape; otherwise they would pull it back.
fn take_handles_along(draft: &mut Draft<'_>) {
    let mut handles = draft.handles.to_vec();
    for handle in handles.iter_mut().filter(|handle| handle.hold != Hold::Fixed) {
        handle.target = draft.positions[handle.vertex as usize];
    }
    draft.handles = handles.into();
}

/// Replaces the steps.
///
/// # Errors
/// If there are too many, or one has an invalid weight or refers to a missing variant.
pub(super) fn set_steps(steps: Vec<Slide>, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    draft.document.steps = steps;
    draft.document.check_steps()?;
    Ok("Change presentation".to_owned())
}

/// Goes to the shape and the weights of a step.
///
/// # Errors
/// If the step does not exist.
pub(super) fn show_step(index: usize, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let steps = &draft.document.steps;
    let step = steps.get(index).ok_or_else(|| SceneError {
        path: format!("steps[{index}]"),
        message: format!("there is no such step: the presentation has {}", steps.len()),
    })?;
    let words = format!("Show {}", step.title);
    let Slide { original, variant, weights, .. } = *step;
    if original {
        reset(draft);
    }
    if let Some(variant) = variant {
        go_to_variant(variant, draft)?;
    }
    if let Some(weights) = weights {
        draft.document.weights = weights;
    }
    Ok(words)
}

/// After the removal of variants: gives the steps the new index `now` of theirs, or none.
pub(super) fn renumber_variants(draft: &mut Draft<'_>, now: impl Fn(usize) -> Option<usize>) {
    let steps = draft.document.steps.iter_mut();
    steps.for_each(|step| step.variant = step.variant.and_then(&now));
}
