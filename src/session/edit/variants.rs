//! Edits of the variants of the shape.

use crate::mesh::Point;
use crate::scene::{Hold, SceneError, Variant, Variants};
use crate::session::state::{Draft, Part};
use std::rc::Rc;

/// Adds the current shape to the variants and makes it the design. Before the first variant, also
/// adds the shape `start` that it was derived from.
///
/// # Errors
/// If there are too many variants.
pub(super) fn keep(start: Rc<[Point]>, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let Variants { mut kept, .. } = draft.document().variants.clone();
    if kept.is_empty() {
        kept.push(Variant { name: "Start".to_owned(), positions: start });
    }
    if kept.len() >= Variants::MOST {
        let message = format!("{} are kept already: remove one first", kept.len());
        return Err(SceneError { path: "variants.kept".to_owned(), message });
    }
    let names = (1..).map(|number| format!("Variant {number}"));
    let name = { names }.find(|name| kept.iter().all(|variant| variant.name != *name));
    let name = name.unwrap_or_default();
    let words = format!("Keep {name}");
    kept.push(Variant { name, positions: draft.shared_positions() });
    let design = Some(kept.len() - 1);
    draft.put(Part::Variants(Variants { kept, design }));
    take_handles_along(draft);
    Ok(words)
}

/// Goes to a variant and makes it the design.
///
/// # Errors
/// If the variant does not exist.
pub(super) fn go_to(index: usize, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let Variant { name, positions } = variant(index, draft)?.clone();
    let kept = draft.document().variants.kept.clone();
    draft.put(Part::Variants(Variants { kept, design: Some(index) }));
    draft.put_positions(positions);
    take_handles_along(draft);
    Ok(format!("Go to {name}"))
}

/// Removes a variant.
///
/// # Errors
/// If the variant does not exist, or is the design.
pub(super) fn remove(index: usize, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let words = format!("Remove {}", variant(index, draft)?.name);
    let mut variants = draft.document().variants.clone();
    if variants.design == Some(index) {
        let message = "this one is the design: go to another one first".to_owned();
        return Err(SceneError { path: format!("variants.kept[{index}]"), message });
    }
    variants.kept.remove(index);
    variants.design = variants.design.map(|design| design - usize::from(design > index));
    draft.put(Part::Variants(variants));
    Ok(words)
}

fn variant<'a>(index: usize, draft: &'a Draft<'_>) -> Result<&'a Variant, SceneError> {
    let kept = &draft.document().variants.kept;
    kept.get(index).ok_or_else(|| SceneError {
        path: format!("variants.kept[{index}]"),
        message: format!("there is no such variant: {} are kept", kept.len()),
    })
}

/// Moves the soft handles to the shape; otherwise they would pull it back.
fn take_handles_along(draft: &mut Draft<'_>) {
    let mut handles = draft.handles().to_vec();
    for handle in handles.iter_mut().filter(|handle| handle.hold != Hold::Fixed) {
        handle.target = draft.positions()[handle.vertex as usize];
    }
    if *handles != *draft.handles() {
        draft.put_handles(handles);
    }
}
