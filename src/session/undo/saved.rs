//! Steps of undo and redo, and the progress of a run or a drag since the scene was written, as
//! bytes beside the scene file. With them a reopened session continues in its saved state.
//!
//! A state is written as its difference from the previous state in the file, which is nearer to
//! now: most edits do not change the positions. Of another mesh all is written. Numbers are
//! little-endian with all of their bits; meshes, and document and handles, are scene files.

use super::history::{History, NamedStep, SessionState};
use crate::mesh::{Point, first_out_of_range};
use crate::scene::{ClosenessTo, MeshSource, Scene, SceneError, Variants};
use crate::session::Error;
use crate::session::state::{
    RestMesh, SceneState, flat, grouped, same_document, same_positions, same_problem,
};
use std::rc::Rc;

/// The first bytes of a history.
const MAGIC: &[u8] = b"shape-up steps 2";
/// Limits of saved bytes, and of steps per list; the farthest steps are dropped first.
const LIMIT_BYTES: usize = 20_000_000;
const LIMIT_STEPS: usize = 1000;
/// The byte after the lists if the first state is not that of the document as it was opened.
const CUT: u8 = 1;
/// First byte of each part of a state: as in the previous state, or written out.
const SAME: u8 = 0;
const OTHER: u8 = 1;
/// Bits of the first byte of a document that is written out, but with large parts of the previous
/// state: variants, the target of closeness, the pose.
const SAME_VARIANTS: u8 = 2;
const SAME_TARGET: u8 = 4;
const SAME_POSE: u8 = 8;
const KNOWN: u8 = SAME_VARIANTS | SAME_TARGET | SAME_POSE;

/// Writes the steps of undo and redo of a session in the state `now`. `last` is the step that is under
/// way, unless it is a part of the one before it; `opened` is the document as it was opened, if a run of
/// its problem is as its author intends.
pub(crate) fn write_history(
    [undo, redo]: [&[NamedStep]; 2],
    now: &SessionState,
    last: Option<NamedStep>,
    opened: Option<&Scene>,
) -> Vec<u8> {
    // What was undone cannot be redone after another step.
    let redo = if last.is_some() { &[] } else { redo };
    let mut out = MAGIC.to_vec();
    let mut is_from_opened = false;
    for (steps, last, opened) in [(undo, last, opened), (redo, None, None)] {
        // The states are written beside the last one written.
        let (mut near, mut written, mut count) = (now, Vec::new(), 0);
        for (name, state) in last.iter().chain(steps.iter().rev()).take(LIMIT_STEPS) {
            let before = written.len();
            write_bytes(&mut written, name.as_bytes());
            if Rc::ptr_eq(&state.rest, &near.rest) {
                written.push(SAME);
                write(&mut written, state, Some(near));
            } else {
                written.push(OTHER);
                let mesh = state.rest.mesh();
                let holder = Scene::new(MeshSource::Inline(Box::default()));
                write_bytes(&mut written, holder.to_json(mesh).as_bytes());
                write(&mut written, state, None);
            }
            if out.len() + written.len() > LIMIT_BYTES {
                written.truncate(before);
                break;
            }
            count += 1;
            near = state;
        }
        is_from_opened |= opened.is_some_and(|opened| same_problem(opened, &near.scene.document));
        write_count(&mut out, count);
        out.extend(written);
    }
    out.extend((!is_from_opened).then_some(CUT));
    out
}

pub(crate) fn write_state(state: &SessionState) -> Vec<u8> {
    let mut out = Vec::new();
    write(&mut out, state, None);
    out
}

/// Reads the steps of undo and redo of a session in the state `now`. Also returns the document as it was
/// opened, if the steps begin with it.
///
/// # Errors
/// If the bytes are damaged or belong to another scene.
pub(crate) fn read_history(
    bytes: &[u8],
    now: &SessionState,
) -> Result<(History, Option<Rc<Scene>>), Error> {
    let mut bytes = Bytes(bytes);
    if bytes.take(MAGIC.len()) != Ok(MAGIC) {
        return Err(bytes.damaged("the mark of such a list").into());
    }
    let mut lists = [Vec::new(), Vec::new()];
    for (list, is_undo) in lists.iter_mut().zip([true, false]) {
        let mut near = now.clone();
        let mut generation = 0u32;
        for _ in 0..bytes.count()? {
            let name = bytes.text()?.to_owned();
            near = match bytes.byte()? {
                SAME => read(&mut bytes, &near, true)?,
                OTHER => {
                    let MeshSource::Inline(other) = Scene::from_json(bytes.text()?)?.mesh else {
                        return Err(bytes.damaged("a mesh").into());
                    };
                    // Each mesh has its own number, on both sides of that of the opened one.
                    generation = match is_undo {
                        true => generation.wrapping_sub(1),
                        false => generation + 1,
                    };
                    near.rest = Rc::new(RestMesh::numbered(*other, generation));
                    read(&mut bytes, &near, false)?
                }
                _ => return Err(bytes.damaged("whether the mesh is another one").into()),
            };
            list.push((name, near.clone()));
        }
        list.reverse();
    }
    let first = lists[0].first().map_or(now, |(_, state)| state);
    let opened = bytes.0.is_empty().then(|| Rc::clone(&first.scene.document));
    Ok((History::of(lists, now), opened))
}

/// Reads a state of a session on its mesh, which is in the state `now`.
///
/// # Errors
/// If the bytes are damaged or belong to another scene.
pub(crate) fn read_state(bytes: &[u8], now: &SessionState) -> Result<SessionState, Error> {
    read(&mut Bytes(bytes), now, false)
}

/// Appends a state without its mesh: all of it, or its difference from the state `near`.
fn write(out: &mut Vec<u8>, state: &SessionState, near: Option<&SessionState>) {
    let near = near.map(|near| &near.scene);
    let SceneState { document, handles, positions } = &state.scene;
    out.extend(state.iteration.to_le_bytes());
    if near.is_some_and(|n| same_document(&n.document, document) && n.handles == *handles) {
        out.push(SAME);
    } else {
        let mut scene = Scene {
            mesh: MeshSource::File("mesh".to_owned()),
            handles: grouped(handles),
            ..(**document).clone()
        };
        let mut known = 0;
        if let Some(SceneState { document: near, .. }) = near {
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
        write_bytes(out, scene.to_json(state.rest.mesh()).as_bytes());
    }
    if near.is_some_and(|near| same_positions(&near.positions, positions)) {
        out.push(SAME);
    } else {
        out.push(OTHER);
        write_count(out, positions.len());
        out.extend(positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    }
}

/// Reads the output of [`write`] on the mesh of the state `near`: the difference from it, or all.
fn read(
    bytes: &mut Bytes<'_>,
    near: &SessionState,
    is_difference: bool,
) -> Result<SessionState, Error> {
    let mesh = near.rest.mesh();
    let SceneState { document: there, handles, positions } = &near.scene;
    let iteration = bytes.count()?;
    let (document, handles) = match bytes.byte()? {
        SAME if is_difference => (Rc::clone(there), Rc::clone(handles)),
        known if known == OTHER || (is_difference && known & !KNOWN == 0) => {
            let mut document = Scene::from_json(bytes.text()?)?;
            if known & SAME_VARIANTS != 0 {
                document.variants = there.variants.clone();
            }
            if known & SAME_TARGET != 0 {
                document.closeness.to = there.closeness.to;
                document.closeness.target.clone_from(&there.closeness.target);
            }
            if known & SAME_POSE != 0 {
                document.pose.clone_from(&there.pose);
            }
            document.validate(mesh)?;
            share_lists(&mut document, there);
            let handles = flat(&std::mem::take(&mut document.handles), &mesh.positions);
            (document.title, document.mesh) = (there.title.clone(), there.mesh.clone());
            (Rc::new(document), handles.into())
        }
        _ => return Err(bytes.damaged("a document").into()),
    };
    let positions = match bytes.byte()? {
        SAME if is_difference => Rc::clone(positions),
        OTHER => bytes.positions(mesh.positions.len())?.into(),
        _ => return Err(bytes.damaged("positions").into()),
    };
    let scene = SceneState { document, handles, positions };
    Ok(SessionState { rest: Rc::clone(&near.rest), scene, iteration, last_run: None })
}

/// Shares sets and rows with the document `near`, where they are equal: each has been read anew. Rows
/// behind one that has been added or removed are found from the end. Rows that have been changed keep
/// their numbers.
fn share_lists(document: &mut Scene, near: &Scene) {
    for (name, set) in &mut document.sets {
        if let Some(near) = near.sets.get(name).filter(|near| **near == *set) {
            *set = near.clone();
        }
    }
    let (rows, there) = (&mut document.constraints, &near.constraints);
    let count = rows.len();
    let are_as_many = count == there.len();
    let first = rows.iter().zip(there).take_while(|(row, near)| row == near).count();
    for (index, row) in rows.iter_mut().enumerate() {
        let from_end = || (index + there.len()).checked_sub(count).filter(|&at| at >= first);
        let at = if index < first { Some(index) } else { from_end() };
        let Some(near) = at.map(|at| &there[at]) else { continue };
        if *row == *near {
            *row = near.clone();
        } else if are_as_many {
            row.number = near.number;
        }
    }
    if document.closeness.weights == near.closeness.weights {
        document.closeness.weights.clone_from(&near.closeness.weights);
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::session::Session;

    #[test]
    fn what_was_opened_is_known_where_the_steps_begin_with_it() {
        // Where the first ones were left out the problem of now was taken for it: no collapse was told.
        let mesh = Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            faces: [[0, 1, 2]].into_iter().collect(),
            ..Mesh::default()
        };
        let session = Session::open(Scene::opened("a.obj"), mesh).expect("it fits");
        let now = session.state();
        let is_known = |opened: Option<&Scene>| {
            let bytes = write_history([&[], &[]], &now, None, opened);
            read_history(&bytes, &now).expect("it was written so").1.is_some()
        };
        let other = Scene { weights: Default::default(), ..session.document().clone() };
        assert!(is_known(Some(session.document())) && !is_known(Some(&other)) && !is_known(None));
    }
}
