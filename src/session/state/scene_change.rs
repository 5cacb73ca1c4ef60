//! The difference of two states of a solved scene. Exchanging it with the state turns it into its
//! inverse, so that undo and redo store nothing else. An edit makes one by a draft.

use super::part::{Effect, Part, Settings};
use crate::mesh::{Mesh, Point};
use crate::scene::{Scene, SceneError};
use crate::solve::Handle;
use std::mem::size_of_val;
use std::rc::Rc;

/// The parts of the document that differ in the other state, and its handles and positions, which
/// consecutive states share if equal.
#[derive(Clone)]
pub(crate) struct SceneChange {
    /// In the order of their last exchange.
    pub(crate) parts: Vec<Part>,
    pub(crate) handles: Rc<[Handle]>,
    /// `#V by 3`.
    pub(crate) positions: Rc<[Point]>,
}

impl SceneChange {
    /// Exchanges the parts with `document` in reverse order, which undoes the last exchange.
    pub(crate) fn exchange_parts(&mut self, document: &mut Scene) {
        self.parts.iter_mut().rev().for_each(|part| part.exchange(document));
        self.parts.reverse();
    }

    /// Returns the effect of having exchanged the parts with `document`.
    pub(crate) fn effect(&self, document: &Scene) -> Effect {
        let effects = self.parts.iter().map(|part| part.effect(document));
        effects.max().unwrap_or(Effect::Nothing)
    }

    /// Memory in bytes, without data shared with `other`.
    pub(crate) fn bytes_beside(&self, other: Option<&SceneChange>) -> usize {
        let has_handles = other.is_some_and(|other| Rc::ptr_eq(&other.handles, &self.handles));
        let has_positions =
            other.is_some_and(|other| Rc::ptr_eq(&other.positions, &self.positions));
        let handles = if has_handles { 0 } else { size_of_val(&*self.handles) };
        let positions = if has_positions { 0 } else { size_of_val(&*self.positions) };
        let settings = |change: &SceneChange| {
            change.parts.iter().find_map(|part| match part {
                Part::Settings(settings) => Some(settings.clone()),
                _ => None,
            })
        };
        let known = other.and_then(settings);
        let held = settings(self).map_or(0, |settings| settings.bytes_beside(known.as_ref()));
        let parts = self.parts.iter().map(Part::bytes).sum::<usize>() + held;
        size_of::<SceneChange>() + parts + handles + positions
    }
}

/// Whether two lists of handles are equal.
pub(crate) fn same_handles(a: &Rc<[Handle]>, b: &Rc<[Handle]>) -> bool {
    Rc::ptr_eq(a, b) || a == b
}

/// Whether two lists of positions are equal to the last bit.
pub(crate) fn same_positions(a: &Rc<[Point]>, b: &Rc<[Point]>) -> bool {
    let mut pairs = a.as_flattened().iter().zip(b.as_flattened());
    Rc::ptr_eq(a, b) || (a.len() == b.len() && pairs.all(|(a, b)| a.to_bits() == b.to_bits()))
}

/// The document under edit, with its new handles and positions. Every change of the document is
/// recorded, so that it can be undone.
pub(crate) struct Draft<'a> {
    pub(super) document: &'a mut Scene,
    pub(super) mesh: &'a Mesh,
    pub(super) change: SceneChange,
}

impl Draft<'_> {
    pub(crate) fn document(&self) -> &Scene {
        self.document
    }

    /// The rest shape.
    pub(crate) fn mesh(&self) -> &Mesh {
        self.mesh
    }

    pub(crate) fn handles(&self) -> &[Handle] {
        &self.change.handles
    }

    pub(crate) fn shared_handles(&self) -> Rc<[Handle]> {
        Rc::clone(&self.change.handles)
    }

    /// Positions, `#V by 3`.
    pub(crate) fn positions(&self) -> &[Point] {
        &self.change.positions
    }

    pub(crate) fn shared_positions(&self) -> Rc<[Point]> {
        Rc::clone(&self.change.positions)
    }

    /// Replaces a part of the document.
    pub(crate) fn put(&mut self, mut part: Part) {
        part.exchange(self.document);
        self.record(part);
    }

    /// Records a part as it was before; of the settings, as they were before the edit.
    fn record(&mut self, before: Part) {
        let is_settings = |part: &Part| matches!(part, Part::Settings(_));
        if !(is_settings(&before) && self.change.parts.iter().any(is_settings)) {
            self.change.parts.push(before);
        }
    }

    /// The parts that differ from those before the edit, as they were then.
    pub(crate) fn changed(&self) -> impl Iterator<Item = &Part> {
        self.change.parts.iter().filter(|part| !part.is_in(self.document))
    }

    /// Changes settings, and no other part of the document.
    ///
    /// # Errors
    /// Those of `set`, which must then have changed nothing.
    pub(crate) fn set<T>(
        &mut self,
        set: impl FnOnce(&mut Scene) -> Result<T, SceneError>,
    ) -> Result<T, SceneError> {
        let before = Settings::of(self.document);
        let done = set(self.document)?;
        self.document.attempt = before.attempt_beside(&Settings::of(self.document));
        self.record(Part::Settings(before));
        Ok(done)
    }

    /// Changes settings and rows of constraints.
    ///
    /// # Errors
    /// Those of `set`, which must then have changed nothing.
    pub(crate) fn set_rows<T>(
        &mut self,
        set: impl FnOnce(&mut Scene, &Mesh) -> Result<T, SceneError>,
    ) -> Result<T, SceneError> {
        let rows = self.document.constraints.clone();
        let mesh = self.mesh;
        let done = self.set(|document| set(document, mesh))?;
        self.record(Part::Rows(rows));
        Ok(done)
    }

    pub(crate) fn put_handles(&mut self, handles: Vec<Handle>) {
        self.change.handles = handles.into();
    }

    /// Replaces the positions, `#V by 3`.
    pub(crate) fn put_positions(&mut self, positions: Rc<[Point]>) {
        self.change.positions = positions;
    }
}
