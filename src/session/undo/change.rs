//! The difference of two states of a session.

use crate::scene::Scene;
use crate::session::run::Start;
use crate::session::state::{RestMesh, SceneChange};
use std::rc::Rc;

/// The difference from the current state to another one.
pub(crate) struct Change {
    pub(crate) scene: SceneChange,
    /// The other mesh and its whole document, if they differ; `scene` then has no parts.
    pub(crate) other: Option<Box<(RestMesh, Scene)>>,
    /// Iteration count of the other state.
    pub(crate) iteration: u32,
    /// The shape at which its iterations began, after the last edit.
    pub(crate) start: Option<Rc<Start>>,
}

impl Change {
    /// Memory in bytes, without data shared with `other`.
    pub(crate) fn bytes_beside(&self, other: Option<&Change>) -> usize {
        let known = other.and_then(|other| other.start.as_ref());
        let start =
            self.start.as_ref().filter(|start| !known.is_some_and(|s| Rc::ptr_eq(s, start)));
        let scene = self.scene.bytes_beside(other.map(|other| &other.scene));
        let other = self.other.as_ref().map_or(0, |other| other.0.bytes());
        scene + other + start.map_or(0, |start| start.bytes())
    }
}
