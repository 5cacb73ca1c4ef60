//! Steps of undo and redo, and the progress of a run or a drag since the scene was written, as bytes beside
//! the scene file, so that a session that is opened again goes on where it stood.
//!
//! A state to go to is written as what differs from the state that comes before it in the file, which is
//! nearer to now: most edits leave the positions as they are. Numbers are little-endian and keep all of
//! their bits; document and handles are a scene file.

use super::change::Change;
use super::history::{History, NamedStep};
use crate::error::Error;
use crate::mesh::{Mesh, Point, too_far};
use crate::scene::{MeshSource, Scene, SceneError, Variants};
use crate::session::state::{Part, SceneChange, SolvedScene, flat, grouped, same_positions};
use crate::solve::Handle;
use std::rc::Rc;

/// The first bytes of a history.
const MAGIC: &[u8] = b"shape-up steps 1";
/// More bytes are not saved, nor more steps of either list: those that are farthest from now go first.
const LIMIT_BYTES: usize = 20_000_000;
const LIMIT_STEPS: usize = 1000;
/// The first byte of each part of a state: as in the state before it, or written out.
const SAME: u8 = 0;
const OTHER: u8 = 1;
/// Of a document: written out, but with the variants of the state before it.
const SAME_VARIANTS: u8 = 2;

/// A state of a session.
#[derive(Clone)]
pub(crate) struct SavedState {
    /// Without handles and positions.
    document: Scene,
    handles: Rc<[Handle]>,
    /// `#V by 3`.
    positions: Rc<[Point]>,
    /// Iterations up to it.
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

    /// Goes where `change` leads.
    pub(crate) fn follow(&mut self, change: &Change) {
        let SceneChange { handles, positions, .. } = &change.scene;
        change.scene.clone().exchange_parts(&mut self.document);
        self.handles = Rc::clone(handles);
        self.positions = Rc::clone(positions);
        self.iteration = change.iteration;
    }

    /// The difference to the state `to`.
    pub(crate) fn change_to(&self, to: &SavedState) -> Change {
        let SavedState { document, handles, positions, iteration } = to;
        Change {
            scene: SceneChange {
                parts: Part::between(&self.document, document),
                handles: Rc::clone(handles),
                positions: Rc::clone(positions),
            },
            other: None,
            iteration: *iteration,
            start: None,
        }
    }
}

/// The steps of undo and redo of a session on `mesh` that is in the state `now`.
pub(crate) fn write_history(steps: [&[NamedStep]; 2], now: &SavedState, mesh: &Mesh) -> Vec<u8> {
    let mut out = MAGIC.to_vec();
    for steps in steps {
        let mut near = now.clone();
        let mut written = Vec::new();
        let mut count = 0;
        // What was before the mesh is of no use to a session that is opened on this one.
        let on_this_mesh = steps.iter().rev().take_while(|(_, change)| change.other.is_none());
        for (name, change) in on_this_mesh.take(LIMIT_STEPS) {
            let before = written.len();
            let mut state = near.clone();
            state.follow(change);
            write_bytes(&mut written, name.as_bytes());
            write(&mut written, &state, Some(&near), mesh);
            if out.len() + written.len() > LIMIT_BYTES {
                written.truncate(before);
                break;
            }
            count += 1;
            near = state;
        }
        write_count(&mut out, count);
        out.extend(written);
    }
    out
}

/// A state of a session on `mesh`.
pub(crate) fn write_state(state: &SavedState, mesh: &Mesh) -> Vec<u8> {
    let mut out = Vec::new();
    write(&mut out, state, None, mesh);
    out
}

/// The steps of undo and redo of a session on `mesh` that is in the state `now`, and the document before
/// the first of them.
///
/// # Errors
/// When the bytes are damaged or belong to another scene.
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
    for list in &mut lists {
        let mut near = now.clone();
        for _ in 0..bytes.count()? {
            let name = bytes.text()?.to_owned();
            let state = read(&mut bytes, Some(&near), &now.document.mesh, mesh)?;
            list.push((name, near.change_to(&state)));
            near = state;
        }
        list.reverse();
        farthest.push(near.document);
    }
    let first = farthest.into_iter().next().filter(|_| !lists[0].is_empty());
    Ok((History::of(lists), first))
}

/// A state of a session on `mesh` that is in the state `now`.
///
/// # Errors
/// When the bytes are damaged or belong to another scene.
pub(crate) fn read_state(bytes: &[u8], now: &SavedState, mesh: &Mesh) -> Result<SavedState, Error> {
    read(&mut Bytes(bytes), None, &now.document.mesh, mesh)
}

/// Appends a state: all of it, or what differs from the one that is `near`.
fn write(out: &mut Vec<u8>, state: &SavedState, near: Option<&SavedState>, mesh: &Mesh) {
    out.extend(state.iteration.to_le_bytes());
    if near.is_some_and(|n| n.document == state.document && n.handles == state.handles) {
        out.push(SAME);
    } else {
        let variants = &state.document.variants;
        let known = near.is_some_and(|n| n.document.variants == *variants);
        out.push(if known { SAME_VARIANTS } else { OTHER });
        let variants = if known { Variants::default() } else { variants.clone() };
        let scene = Scene {
            variants,
            mesh: MeshSource::File("mesh".to_owned()),
            handles: grouped(&state.handles),
            ..state.document.clone()
        };
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

/// Reads what [`write`] appends; the document has its mesh from `source`.
fn read(
    bytes: &mut Bytes<'_>,
    near: Option<&SavedState>,
    source: &MeshSource,
    mesh: &Mesh,
) -> Result<SavedState, Error> {
    let iteration = bytes.count()?;
    let (document, handles) = match (bytes.byte()?, near) {
        (SAME, Some(near)) => (near.document.clone(), Rc::clone(&near.handles)),
        (written @ (OTHER | SAME_VARIANTS), _) => {
            let mut document = Scene::from_json(bytes.text()?)?;
            if let Some(near) = near.filter(|_| written == SAME_VARIANTS) {
                document.variants = near.document.variants.clone();
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
    let count = u32::try_from(count).expect("fewer than four thousand million of anything fit");
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

    /// As many positions as the mesh has vertices.
    fn positions(&mut self, vertices: usize) -> Result<Vec<Point>, SceneError> {
        if self.count()? as usize != vertices {
            return Err(self.damaged("one position for each vertex"));
        }
        let (numbers, _) = self.take(24 * vertices)?.as_chunks::<8>();
        let numbers: Vec<f64> = numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
        let positions = numbers.as_chunks::<3>().0.to_vec();
        match too_far(&positions) {
            None => Ok(positions),
            Some(_) => Err(self.damaged("positions that are not too far out")),
        }
    }
}
