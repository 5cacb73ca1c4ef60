//! What one solver leaves to the next one on the same mesh, because no edit of the document changes it.

use super::ordered::Ordered;
use crate::mesh::Surface;
use std::cell::OnceCell;
use std::rc::Rc;

/// The rest surface, and the order of elimination of the last pattern.
#[derive(Clone, Default)]
pub struct Kept {
    /// Relative to the centre of the model; made when it is first asked for.
    pub(super) surface: OnceCell<Rc<Surface>>,
    pub(super) ordered: Option<Rc<Ordered>>,
}
