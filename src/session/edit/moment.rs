//! The place of a state among the iterations, and the way back to the first.

use crate::scene::Variants;
use crate::session::run::Start;
use crate::session::state::{Draft, Part};
use std::rc::Rc;

/// The place of a state among the iterations.
pub(crate) struct Moment {
    /// Iterations up to it.
    pub(crate) iteration: u32,
    /// The shape from which they led to it, since somebody last changed something.
    pub(crate) start: Option<Rc<Start>>,
}

/// Goes back to the rest shape; the variants that were kept stay.
pub(super) fn reset(draft: &mut Draft<'_>, moment: &mut Moment) {
    let kept = draft.document().variants.kept.clone();
    back_to_rest(Variants { kept, design: None }, draft, moment);
}

/// Goes back to the rest shape, with these variants.
pub(super) fn back_to_rest(variants: Variants, draft: &mut Draft<'_>, moment: &mut Moment) {
    draft.put_positions(draft.mesh().positions.as_slice().into());
    draft.put(Part::Variants(variants));
    *moment = Moment { iteration: 0, start: None };
}
