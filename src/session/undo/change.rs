//! The difference of two states of a session.

use crate::scene::Scene;
use crate::session::run::Start;
use crate::session::state::{RestMesh, SceneChange};
use std::rc::Rc;

/// The difference from the current state to another one.
pub(crate) struct Change {
    pub(crate) scene: SceneChange,
    /// The mesh of the other state and its whole document, where that is another mesh: then `scene` has no parts.
    pub(crate) other: Option<Box<(RestMesh, Scene)>>,
    /// Iterations up to the other state.
    pub(crate) iteration: u32,
    /// The shape from which iterations led to it, since somebody last changed something.
    pub(crate) start: Option<Rc<Start>>,
}

impl Change {
    /// The bytes that it holds beyond those that `other` holds too.
    pub(crate) fn bytes_beside(&self, other: Option<&Change>) -> usize {
        let known = other.and_then(|other| other.start.as_ref());
        let start =
            self.start.as_ref().filter(|start| !known.is_some_and(|s| Rc::ptr_eq(s, start)));
        let scene = self.scene.bytes_beside(other.map(|other| &other.scene));
        let other = self.other.as_ref().map_or(0, |other| other.0.bytes());
        scene + other + start.map_or(0, |start| start.bytes())
    }
}
