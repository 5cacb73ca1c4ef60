//! A state of a solved scene, and the draft by which an edit makes the next one.

use crate::constraint::Selector;
use crate::mesh::{Mesh, Point};
use crate::scene::{Pose, Scene, Slide, Target};
use crate::solve::Handle;
use std::mem::size_of_val;
use std::rc::Rc;

/// A state of a solved scene. States share what is the same in them: a copy of one takes no time, and
/// of a document that was changed neither its meshes nor its lists of elements are copied.
#[derive(Clone)]
pub(crate) struct SceneState {
    /// Without handles and positions.
    pub(crate) document: Rc<Scene>,
    pub(crate) handles: Rc<[Handle]>,
    /// `#V by 3`.
    pub(crate) positions: Rc<[Point]>,
}

impl SceneState {
    /// Memory in bytes, without what is shared with `other`.
    pub(crate) fn unshared_bytes(&self, other: &SceneState) -> usize {
        let [own, known] = [self, other].map(SceneState::shared);
        let own = own.iter().filter(|data| known.binary_search(data).is_err());
        let has_document = Rc::ptr_eq(&self.document, &other.document);
        let document = if has_document { 0 } else { bytes_of(&self.document) };
        document + own.map(|(_, bytes)| bytes).sum::<usize>()
    }

    /// The data that states may share, each once: its address and its bytes, ascending.
    fn shared(&self) -> Vec<(usize, usize)> {
        fn data<T>(list: &Rc<[T]>) -> (usize, usize) {
            (Rc::as_ptr(list).cast::<()>().addr(), size_of_val(&**list))
        }
        let of_mesh = |mesh: &Rc<Mesh>| {
            let bytes = size_of_val(&*mesh.positions) + size_of_val(mesh.faces.indices());
            (Rc::as_ptr(mesh).addr(), bytes)
        };
        let document = &*self.document;
        let mut all = vec![data(&self.handles), data(&self.positions)];
        all.extend(document.closeness.target.as_ref().and_then(Target::mesh).map(of_mesh));
        if let Some(Pose::Positions(pose)) = &document.pose {
            all.push(data(pose));
        }
        all.extend(document.variants.kept.iter().map(|variant| data(&variant.positions)));
        all.extend(document.sets.values().flat_map(|set| [data(&set.vertices), data(&set.faces)]));
        let rows = document.constraints.iter();
        all.extend(rows.clone().filter_map(|row| row.eased.as_ref()).map(|it| data(&it.faces)));
        let weights = document.closeness.weights.iter();
        let selectors = rows.map(|row| &row.on).chain(weights.map(|entry| &entry.on));
        all.extend(selectors.filter_map(|on| match on {
            Selector::Vertices(vertices) => Some(data(vertices)),
            Selector::Set(_) | Selector::Each { .. } => None,
        }));
        all.sort_unstable();
        all.dedup();
        all
    }
}

/// Memory in bytes of a document, without what documents share.
fn bytes_of(document: &Scene) -> usize {
    let Scene { constraints, closeness, sets, variants, lesson, build, steps, .. } = document;
    let of_step = |step: &Slide| step.title.len() + step.text.len() + step.notes.len();
    let names = constraints.iter().map(|row| &row.name).chain(sets.keys());
    let lesson = lesson.as_ref().map_or(0, |it| it.text.len() + size_of_val(&*it.goals));
    size_of::<Scene>()
        + size_of_val(&**constraints)
        + size_of_val(&*closeness.weights)
        + size_of_val(&*variants.kept)
        + size_of_val(&**steps)
        + names.map(String::len).sum::<usize>()
        + steps.iter().map(of_step).sum::<usize>()
        + lesson
        + build.as_deref().map_or(0, size_of_val)
}

/// Whether two documents are equal.
pub(crate) fn same_document(a: &Rc<Scene>, b: &Rc<Scene>) -> bool {
    Rc::ptr_eq(a, b) || a == b
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

/// The document under edit, with its new handles and positions.
pub(crate) struct Draft<'a> {
    /// The document before the edit.
    pub(crate) before: &'a Scene,
    /// The document as edited.
    pub(crate) document: Scene,
    /// The rest shape.
    pub(crate) mesh: &'a Mesh,
    pub(crate) handles: Rc<[Handle]>,
    /// `#V by 3`.
    pub(crate) positions: Rc<[Point]>,
    /// The number of iterations to go on from, if the edit went back to the rest shape; it stays
    /// otherwise, also where the edit has replaced the positions.
    pub(crate) iteration: Option<u32>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constraint::Set;

    #[test]
    fn data_of_several_states_counts_towards_the_limit_of_undo_once() {
        // The meshes of all surfaces that were tried stayed in memory.
        let mesh = || Mesh { positions: vec![[0.0; 3]; 1000], ..Mesh::default() };
        let with = |document: Scene| SceneState {
            document: Rc::new(document),
            handles: Rc::default(),
            positions: Rc::default(),
        };
        let plain = with(Scene::default());
        let mut document = Scene::default();
        let more = |document: &Scene, before: &SceneState| {
            with(document.clone()).unshared_bytes(before) - bytes_of(document)
        };
        document.closeness.target = Some(Target::Mesh(Rc::new(mesh())));
        assert_eq!(more(&document, &plain), 24_000);
        let before = with(document.clone());
        document.pose = Some(Pose::Positions(mesh().positions.into()));
        assert_eq!(more(&document, &before), 24_000);
        document.closeness.target = Some(Target::Mesh(Rc::new(mesh())));
        assert_eq!(more(&document, &before), 48_000);
        let before = with(document.clone());
        let set = Set { vertices: (0..1000).collect(), ..Set::default() };
        document.sets.insert(String::new(), set);
        assert_eq!(more(&document, &before), 4000);
        // A copy of the document shares all but itself.
        assert_eq!(more(&document, &with(document.clone())), 0);
        assert_eq!(before.unshared_bytes(&before.clone()), 0);
    }
}
