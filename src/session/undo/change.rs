//! The difference of two states of a session.

use crate::session::run::Start;
use crate::session::state::SceneChange;
use std::rc::Rc;

/// The difference from the current state to another one.
#[derive(Clone)]
pub(crate) struct Change {
    pub(crate) scene: SceneChange,
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
        scene + start.map_or(0, |start| start.bytes())
    }
}
