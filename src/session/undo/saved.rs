//! Steps of undo and redo, and the progress of a run or a drag since the scene was written, as
//! bytes beside the scene file. With them a reopened session continues in its saved state.
//!
//! A state is written as its difference from the previous state in the file, which is nearer to
//! now: most edits do not change the positions. Of another mesh all is written. Numbers are
//! little-endian with all of their bits; meshes, and document and handles, are scene files.

use super::history::{Change, History, NamedStep};
use crate::mesh::{Mesh, Point, first_out_of_range};
use crate::scene::{ClosenessTo, MeshSource, Scene, SceneError, Variants};
use crate::session::Error;
use crate::session::state::{
    Part, RestMesh, SceneChange, SolvedScene, flat, grouped, same_positions,
};
use crate::solve::Handle;
use std::borrow::Cow;
use std::rc::Rc;

/// The first bytes of a history.
const MAGIC: &[u8] = b"shape-up steps 2";
/// Limits of saved bytes, and of steps per list; the farthest steps are dropped first.
const LIMIT_BYTES: usize = 20_000_000;
const LIMIT_STEPS: usize = 1000;
/// First byte of each part of a state: as in the previous state, or written out.
const SAME: u8 = 0;
const OTHER: u8 = 1;
/// Bits of the first byte of a document that is written out, but with large parts of the previous
/// state: variants, the target of closeness, the pose.
const SAME_VARIANTS: u8 = 2;
const SAME_TARGET: u8 = 4;
const SAME_POSE: u8 = 8;
const KNOWN: u8 = SAME_VARIANTS | SAME_TARGET | SAME_POSE;

/// A state of a session.
#[derive(Clone)]
pub(crate) struct SavedState {
    /// The document without handles and positions.
    document: Scene,
    handles: Rc<[Handle]>,
    /// `#V by 3`.
    positions: Rc<[Point]>,
    /// Number of iterations up to the state.
    iteration: u32,
}

impl SavedState {
    /// The state of `scene` after `iteration`.
    pub(crate) fn of(scene: &SolvedScene, iteration: u32) -> SavedState {
        SavedState {
            document: scene.document().clone(),
            handles: Rc::clone(scene.handles()),
            positions: Rc::clone(scene.positions()),
            iteration,
        }
    }

    /// Applies `change`.
    pub(crate) fn follow(&mut self, change: &Change) {
        let SceneChange { handles, positions, .. } = &change.scene;
        change.scene.clone().exchange_parts(&mut self.document);
        self.handles = Rc::clone(handles);
        self.positions = Rc::clone(positions);
        self.iteration = change.iteration;
    }

    /// Returns the change to this state, of which these parts differ, or the mesh with all of them.
    fn as_change(&self, parts: Vec<Part>, other: Option<RestMesh>) -> Change {
        let SavedState { document, handles, positions, iteration } = self.clone();
        let scene = SceneChange { parts, handles, positions };
        let other = other.map(|rest| Box::new((rest, document)));
        Change { scene, other, iteration, start: None }
    }

    /// Returns the difference to the state `to`.
    pub(crate) fn change_to(&self, to: &SavedState) -> Change {
        to.as_change(Part::between(&self.document, &to.document), None)
    }
}

/// What is under way: the name of the step that it would be, if of its own, and the change back.
pub(crate) type UnderWay<'a> = (Option<String>, &'a Change);

/// Writes the steps of undo and redo of a session on `mesh` in the state `now`. What is under way is
/// the last step if it has a name, and else a part of the one before it.
pub(crate) fn write_history(
    [undo, redo]: [&[NamedStep]; 2],
    now: &SavedState,
    under_way: Option<UnderWay<'_>>,
    mesh: &Mesh,
) -> Vec<u8> {
    let mut begun = now.clone();
    let name = under_way.and_then(|(name, back)| {
        begun.follow(back);
        name
    });
    // What was undone cannot be redone after another step.
    let redo = if name.is_some() { &[] } else { redo };
    let mut out = MAGIC.to_vec();
    for (steps, first) in [(undo, name), (redo, None)] {
        // The changes are from one state to the next, and written beside the last one written.
        let (mut near, mut at, mut mesh) = (now.clone(), begun.clone(), mesh);
        let (mut written, mut count) = (Vec::new(), 0);
        let steps = steps.iter().rev().map(|(name, change)| (name, Some(change)));
        for (name, change) in first.iter().map(|name| (name, None)).chain(steps).take(LIMIT_STEPS) {
            let before = written.len();
            write_bytes(&mut written, name.as_bytes());
            let other = change.and_then(|change| change.other.as_deref());
            if let Some((rest, document)) = other {
                mesh = rest.mesh();
                at.document.clone_from(document);
            }
            change.into_iter().for_each(|change| at.follow(change));
            if other.is_some() {
                written.push(OTHER);
                let holder = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
                write_bytes(&mut written, holder.to_json(mesh).as_bytes());
                write(&mut written, &at, None, mesh);
            } else {
                written.push(SAME);
                write(&mut written, &at, Some(&near), mesh);
            }
            if out.len() + written.len() > LIMIT_BYTES {
                written.truncate(before);
                break;
            }
            count += 1;
            near = at.clone();
        }
        write_count(&mut out, count);
        out.extend(written);
    }
    out
}

pub(crate) fn write_state(state: &SavedState, mesh: &Mesh) -> Vec<u8> {
    let mut out = Vec::new();
    write(&mut out, state, None, mesh);
    out
}

/// Reads the steps of undo and redo of a session on `mesh` in the state `now`. Also returns the
/// document before the first step of undo.
///
/// # Errors
/// If the bytes are damaged or belong to another scene.
pub(crate) fn read_history(
    bytes: &[u8],
    now: &SavedState,
    mesh: &Mesh,
) -> Result<(History, Option<Scene>), Error> {
    let mut bytes = Bytes(bytes);
    if bytes.take(MAGIC.len()) != Ok(MAGIC) {
        return Err(bytes.damaged("the mark of such a list").into());
    }
    let mut lists = [Vec::new(), Vec::new()];
    let mut farthest = Vec::new();
    let source = &now.document.mesh;
    for (list, is_undo) in lists.iter_mut().zip([true, false]) {
        let (mut near, mut mesh) = (now.clone(), Cow::Borrowed(mesh));
        let mut generation = 0u32;
        for _ in 0..bytes.count()? {
            let name = bytes.text()?.to_owned();
            let (change, state) = match bytes.byte()? {
                SAME => {
                    let state = read(&mut bytes, Some(&near), source, &mesh)?;
                    (near.change_to(&state), state)
                }
                OTHER => {
                    let MeshSource::Inline(other) = Scene::from_json(bytes.text()?)?.mesh else {
                        return Err(bytes.damaged("a mesh").into());
                    };
                    // Each mesh has its own number, on both sides of that of the opened one.
                    generation = match is_undo {
                        true => generation.wrapping_sub(1),
                        false => generation + 1,
                    };
                    mesh = Cow::Owned(*other);
                    let state = read(&mut bytes, None, source, &mesh)?;
                    let rest = RestMesh::numbered(mesh.clone().into_owned(), generation);
                    (state.as_change(Vec::new(), Some(rest)), state)
                }
                _ => return Err(bytes.damaged("whether the mesh is another one").into()),
            };
            list.push((name, change));
            near = state;
        }
        list.reverse();
        farthest.push(near.document);
    }
    let first = farthest.into_iter().next().filter(|_| !lists[0].is_empty());
    Ok((History::of(lists), first))
}

/// Reads a state of a session on `mesh`, which is in the state `now`.
///
/// # Errors
/// If the bytes are damaged or belong to another scene.
pub(crate) fn read_state(bytes: &[u8], now: &SavedState, mesh: &Mesh) -> Result<SavedState, Error> {
    read(&mut Bytes(bytes), None, &now.document.mesh, mesh)
}

/// Appends a state: all of it, or its difference from the state `near`.
fn write(out: &mut Vec<u8>, state: &SavedState, near: Option<&SavedState>, mesh: &Mesh) {
    out.extend(state.iteration.to_le_bytes());
    if near.is_some_and(|n| n.document == state.document && n.handles == state.handles) {
        out.push(SAME);
    } else {
        let mut scene = Scene {
            mesh: MeshSource::File("mesh".to_owned()),
            handles: grouped(&state.handles),
            ..state.document.clone()
        };
        let mut known = 0;
        if let Some(SavedState { document: near, .. }) = near {
            if scene.variants == near.variants {
                scene.variants = Variants::default();
                known |= SAME_VARIANTS;
            }
            let own = &mut scene.closeness;
            let there = &near.closeness;
            if own.target.is_some() && (own.to, &own.target) == (there.to, &there.target) {
                (own.to, own.target) = (ClosenessTo::None, None);
                known |= SAME_TARGET;
            }
            if scene.pose.is_some() && scene.pose == near.pose {
                scene.pose = None;
                known |= SAME_POSE;
            }
        }
        out.push(if known == 0 { OTHER } else { known });
        write_bytes(out, scene.to_json(mesh).as_bytes());
    }
    if near.is_some_and(|near| same_positions(&near.positions, &state.positions)) {
        out.push(SAME);
    } else {
        out.push(OTHER);
        write_count(out, state.positions.len());
        out.extend(state.positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    }
}

/// Reads the output of [`write`]; `source` becomes the mesh of the document.
fn read(
    bytes: &mut Bytes<'_>,
    near: Option<&SavedState>,
    source: &MeshSource,
    mesh: &Mesh,
) -> Result<SavedState, Error> {
    let iteration = bytes.count()?;
    let (document, handles) = match (bytes.byte()?, near) {
        (SAME, Some(near)) => (near.document.clone(), Rc::clone(&near.handles)),
        (known, _) if known == OTHER || (near.is_some() && known & !KNOWN == 0) => {
            let mut document = Scene::from_json(bytes.text()?)?;
            if let Some(SavedState { document: near, .. }) = near {
                if known & SAME_VARIANTS != 0 {
                    document.variants = near.variants.clone();
                }
                if known & SAME_TARGET != 0 {
                    document.closeness.to = near.closeness.to;
                    document.closeness.target.clone_from(&near.closeness.target);
                }
                if known & SAME_POSE != 0 {
                    document.pose.clone_from(&near.pose);
                }
            }
            document.validate(mesh)?;
            let handles = flat(&std::mem::take(&mut document.handles), &mesh.positions);
            (Scene { mesh: source.clone(), ..document }, handles.into())
        }
        _ => return Err(bytes.damaged("a document").into()),
    };
    let positions = match (bytes.byte()?, near) {
        (SAME, Some(near)) => Rc::clone(&near.positions),
        (OTHER, _) => bytes.positions(mesh.positions.len())?.into(),
        _ => return Err(bytes.damaged("positions").into()),
    };
    Ok(SavedState { document, handles, positions, iteration })
}

fn write_count(out: &mut Vec<u8>, count: usize) {
    let count = u32::try_from(count).expect("counts fit in 32 bits");
    out.extend(count.to_le_bytes());
}

fn write_bytes(out: &mut Vec<u8>, bytes: &[u8]) {
    write_count(out, bytes.len());
    out.extend(bytes);
}

/// The bytes not yet read.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn damaged(&self, expected: &str) -> SceneError {
        let message =
            format!("damaged {} bytes before their end, expected {expected}", self.0.len());
        SceneError { path: "saved steps".to_owned(), message }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], SceneError> {
        let (taken, rest) =
            self.0.split_at_checked(count).ok_or_else(|| self.damaged("more bytes"))?;
        self.0 = rest;
        Ok(taken)
    }

    fn byte(&mut self) -> Result<u8, SceneError> {
        Ok(self.take(1)?[0])
    }

    fn count(&mut self) -> Result<u32, SceneError> {
        let bytes = self.take(4)?.try_into().map_err(|_| self.damaged("a number"))?;
        Ok(u32::from_le_bytes(bytes))
    }

    fn text(&mut self) -> Result<&'a str, SceneError> {
        let count = self.count()?;
        let bytes = self.take(count as usize)?;
        std::str::from_utf8(bytes).map_err(|_| self.damaged("text"))
    }

    /// Reads one position for each vertex of the mesh.
    fn positions(&mut self, vertices: usize) -> Result<Vec<Point>, SceneError> {
        if self.count()? as usize != vertices {
            return Err(self.damaged("one position for each vertex"));
        }
        let (numbers, _) = self.take(24 * vertices)?.as_chunks::<8>();
        let numbers: Vec<f64> = numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
        let positions = numbers.as_chunks::<3>().0.to_vec();
        match first_out_of_range(&positions) {
            None => Ok(positions),
            Some(_) => Err(self.damaged("positions that are not too far out")),
        }
    }
}
