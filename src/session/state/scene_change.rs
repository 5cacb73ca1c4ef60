//! The difference of two states of a scene that is solved. Exchanged with the state, it is the way back:
//! undo and redo hold nothing else.

use super::part::{Effect, Part};
use crate::mesh::Point;
use crate::scene::Scene;
use crate::solve::Handle;
use std::mem::size_of_val;
use std::rc::Rc;

/// The parts of the document that are others in the other state, and its handles and positions, which
/// states that follow each other share where they are the same.
#[derive(Clone)]
pub(crate) struct SceneChange {
    /// In the order in which they were exchanged last.
    pub(crate) parts: Vec<Part>,
    pub(crate) handles: Rc<[Handle]>,
    /// `#V by 3`.
    pub(crate) positions: Rc<[Point]>,
}

impl SceneChange {
    /// Exchanges the parts with those of `document`: the last first, which takes them back.
    pub(crate) fn exchange_parts(&mut self, document: &mut Scene) {
        self.parts.iter_mut().rev().for_each(|part| part.exchange(document));
        self.parts.reverse();
    }

    /// The effect of having exchanged the parts with `document`.
    pub(crate) fn effect(&self, document: &Scene) -> Effect {
        let effects = self.parts.iter().map(|part| part.effect(document));
        effects.max().unwrap_or(Effect::Nothing)
    }

    /// The bytes that it holds beyond those that `other` holds too.
    pub(crate) fn bytes_beside(&self, other: Option<&SceneChange>) -> usize {
        let has_handles = other.is_some_and(|other| Rc::ptr_eq(&other.handles, &self.handles));
        let has_positions =
            other.is_some_and(|other| Rc::ptr_eq(&other.positions, &self.positions));
        let handles = if has_handles { 0 } else { size_of_val(&*self.handles) };
        let positions = if has_positions { 0 } else { size_of_val(&*self.positions) };
        let parts: usize = self.parts.iter().map(Part::bytes).sum();
        size_of::<SceneChange>() + parts + handles + positions
    }
}

/// Whether two lists of handles are the same.
pub(crate) fn same_handles(a: &Rc<[Handle]>, b: &Rc<[Handle]>) -> bool {
    Rc::ptr_eq(a, b) || a == b
}

/// Whether two lists of positions are the same to the last bit.
pub(crate) fn same_positions(a: &Rc<[Point]>, b: &Rc<[Point]>) -> bool {
    let mut pairs = a.as_flattened().iter().zip(b.as_flattened());
    Rc::ptr_eq(a, b) || (a.len() == b.len() && pairs.all(|(a, b)| a.to_bits() == b.to_bits()))
}
