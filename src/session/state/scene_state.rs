//! A state of a solved scene, and the draft by which an edit makes the next one.

use super::rest_mesh::RestMesh;
use crate::mesh::{Mesh, Point};
use crate::scene::{Pose, Scene, Target};
use crate::solve::Handle;
use std::iter;
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
    /// Memory in bytes of what is not shared with `other`, of positions, meshes, handles and the list of
    /// constraints.
    pub(crate) fn unshared_bytes(&self, other: &SceneState) -> usize {
        let known = other.large();
        self.large().iter().filter(|data| !known.contains(data)).map(|(_, bytes)| bytes).sum()
    }

    /// The positions, meshes, handles and constraints: the address of each list, and its bytes.
    fn large(&self) -> Vec<(usize, usize)> {
        let Scene { variants, pose, closeness, constraints, .. } = &*self.document;
        let pose = match pose {
            Some(Pose::Positions(positions)) => Some(positions),
            Some(Pose::File(_)) | None => None,
        };
        let of_mesh = |mesh: &Rc<Mesh>| {
            let bytes = size_of_val(&*mesh.positions) + size_of_val(mesh.faces.indices());
            (Rc::as_ptr(mesh).addr(), bytes)
        };
        let kept = variants.kept.iter().map(|variant| &variant.positions);
        let positions = iter::once(&self.positions).chain(kept).chain(pose);
        // A document that was changed has a list of constraints of its own.
        let others = [
            (self.handles.as_ptr().addr(), size_of_val(&*self.handles)),
            (constraints.as_ptr().addr(), size_of_val(&**constraints)),
        ];
        positions
            .map(|list| (list.as_ptr().addr(), size_of_val(&**list)))
            .chain(others)
            .chain(closeness.target.as_ref().and_then(Target::mesh).map(of_mesh))
            .collect()
    }
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
    pub(crate) rest: &'a RestMesh,
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
    use crate::solve::Hold;

    #[test]
    fn data_of_several_states_counts_towards_the_limit_of_undo_once() {
        // The meshes of all surfaces that were tried stayed in memory.
        let mesh = || Mesh { positions: vec![[0.0; 3]; 1000], ..Mesh::default() };
        let with = |document: &Scene| SceneState {
            document: Rc::new(document.clone()),
            handles: Rc::default(),
            positions: Rc::default(),
        };
        let mut document = Scene::default();
        let plain = with(&document);
        document.closeness.target = Some(Target::Mesh(Rc::new(mesh())));
        let before = with(&document);
        assert_eq!(before.unshared_bytes(&plain), 24_000);
        document.pose = Some(Pose::Positions(mesh().positions.into()));
        assert_eq!(with(&document).unshared_bytes(&before), 24_000);
        document.closeness.target = Some(Target::Mesh(Rc::new(mesh())));
        assert_eq!(with(&document).unshared_bytes(&before), 48_000);
        // So did handles and rows, which have no limit either.
        let handle = Handle { vertex: 0, target: [0.0; 3], hold: Hold::Fixed };
        let held = SceneState { handles: vec![handle; 1000].into(), ..plain.clone() };
        assert_eq!(held.unshared_bytes(&plain), 1000 * size_of::<Handle>());
        assert_eq!(held.clone().unshared_bytes(&held), 0);
        // A copy of the document shares its meshes.
        assert_eq!(with(&document).unshared_bytes(&with(&document)), 0);
    }
}
