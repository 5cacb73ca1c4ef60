//! The position of a state in the sequence of iterations, and going back to the rest shape.

use crate::scene::Variants;
use crate::session::run::Start;
use crate::session::state::{Draft, Part};
use std::rc::Rc;

/// The position of a state in the sequence of iterations.
pub(crate) struct IterationState {
    /// Number of iterations up to the state.
    pub(crate) iteration: u32,
    /// The shape at which these iterations began, after the last edit.
    pub(crate) start: Option<Rc<Start>>,
}

/// Goes back to the rest shape; the kept variants stay.
pub(super) fn reset(draft: &mut Draft<'_>, state: &mut IterationState) {
    let kept = draft.document().variants.kept.clone();
    back_to_rest(Variants { kept, design: None }, draft, state);
}

/// Goes back to the rest shape, with these variants.
pub(super) fn back_to_rest(variants: Variants, draft: &mut Draft<'_>, state: &mut IterationState) {
    draft.put_positions(draft.mesh().positions.as_slice().into());
    draft.put(Part::Variants(variants));
    *state = IterationState { iteration: 0, start: None };
}
