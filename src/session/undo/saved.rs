//! What is saved beside the scene, as bytes, so that a session that is opened again goes on where it
//! stood: the steps of undo and redo, and how far a run or a drag has come since the scene was written.
//!
//! A state to go to is written as what differs from the state that comes before it in the file, which is
//! nearer to now: most edits leave the positions as they are. Numbers are little-endian and keep all of
//! their bits; document and handles are a scene file.

use crate::error::Error;
use crate::mesh::{Point, too_far};
use crate::scene::{MeshSource, Scene, SceneError};
use crate::session::state::{History, Session, Snapshot, flat, grouped};

/// The first bytes of a history.
const MAGIC: &[u8] = b"shape-up steps 1";
/// More bytes are not saved, nor more steps of either list: those that are farthest from now go first.
const LIMIT_BYTES: usize = 20_000_000;
const LIMIT_STEPS: usize = 1000;
/// What each part of a state begins with.
const SAME: u8 = 0;
const OTHER: u8 = 1;

impl Session {
    /// The steps of undo and redo, for [`Session::restore`]; at most 20 MB of them. They belong to the
    /// scene as it stands, or as it stood before the run or the drag that goes on.
    pub fn saved_history(&self) -> Vec<u8> {
        let now = match &self.run_state.transaction {
            Some(transaction) => transaction.before.clone(),
            None => self.snapshot(),
        };
        let mut out = MAGIC.to_vec();
        for steps in self.run_state.history.steps() {
            let mut near = &now;
            let mut written = Vec::new();
            let mut count = 0;
            for (name, state) in steps.iter().rev().take(LIMIT_STEPS) {
                let before = written.len();
                write_bytes(&mut written, name.as_bytes());
                self.write_state(&mut written, state, Some(near));
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

    /// How far the run or the drag that goes on has come, for [`Session::restore`].
    pub fn saved_progress(&self) -> Vec<u8> {
        let mut out = Vec::new();
        self.write_state(&mut out, &self.snapshot(), None);
        out
    }

    /// Goes on where the scene that was just opened stood when it was saved. `history` is of that scene,
    /// `progress` of a run or a drag that began with it, which becomes a step of undo; either may be empty.
    ///
    /// # Errors
    /// When bytes are damaged or belong to another scene; what can be restored is.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), Error> {
        let now = self.snapshot();
        let mut result = Ok(());
        if !history.is_empty() {
            let read = self.read_history(&mut Bytes(history), &now);
            result = read.map(|history| {
                // What was asked when the scene was first opened: edits since then arm the guard.
                if let [[(_, first), ..], _] = history.steps() {
                    self.run_state.guard.opened = first.document.clone();
                }
                self.run_state.history = history;
                self.start_from(None);
            });
        }
        if !progress.is_empty() {
            let read = self.read_state(&mut Bytes(progress), None);
            result = result.and(read.and_then(|state| self.resume(state)));
        }
        result
    }

    /// Makes what has happened since the scene was written one step of undo.
    fn resume(&mut self, state: Snapshot) -> Result<(), Error> {
        if state.handles == self.solver.handles() {
            self.begin_run();
        } else {
            self.begin_drag();
        }
        let resumed = self.go_to(state);
        self.end_run();
        self.end_drag(true);
        resumed
    }

    /// Appends a state: all of it, or what differs from the one that is `near`.
    fn write_state(&self, out: &mut Vec<u8>, state: &Snapshot, near: Option<&Snapshot>) {
        out.extend(state.iteration.to_le_bytes());
        if near.is_some_and(|n| n.document == state.document && n.handles == state.handles) {
            out.push(SAME);
        } else {
            out.push(OTHER);
            let scene = Scene {
                mesh: MeshSource::File("mesh".to_owned()),
                handles: grouped(&state.handles),
                ..state.document.clone()
            };
            write_bytes(out, scene.to_json(&self.mesh).as_bytes());
        }
        if near.is_some_and(|near| same_bits(&near.positions, &state.positions)) {
            out.push(SAME);
        } else {
            out.push(OTHER);
            write_count(out, state.positions.len());
            out.extend(state.positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        }
    }

    fn read_history(&self, bytes: &mut Bytes<'_>, now: &Snapshot) -> Result<History, Error> {
        if bytes.take(MAGIC.len()) != Ok(MAGIC) {
            return Err(bytes.damaged("the mark of such a list").into());
        }
        let mut lists = [Vec::new(), Vec::new()];
        for list in &mut lists {
            for _ in 0..bytes.count()? {
                let name = bytes.text()?.to_owned();
                let near = list.last().map_or(now, |(_, state)| state);
                let state = self.read_state(bytes, Some(near))?;
                list.push((name, state));
            }
            list.reverse();
        }
        Ok(History::of(lists))
    }

    fn read_state(
        &self,
        bytes: &mut Bytes<'_>,
        near: Option<&Snapshot>,
    ) -> Result<Snapshot, Error> {
        let iteration = bytes.count()?;
        let (document, handles) = match (bytes.byte()?, near) {
            (SAME, Some(near)) => (near.document.clone(), near.handles.clone()),
            (OTHER, _) => {
                let mut document = Scene::from_json(bytes.text()?)?;
                document.validate(&self.mesh)?;
                let handles = flat(&std::mem::take(&mut document.handles), &self.mesh.positions);
                (Scene { mesh: self.document.mesh.clone(), ..document }, handles)
            }
            _ => return Err(bytes.damaged("a document").into()),
        };
        let positions = match (bytes.byte()?, near) {
            (SAME, Some(near)) => near.positions.clone(),
            (OTHER, _) => bytes.positions(self.mesh.positions.len())?,
            _ => return Err(bytes.damaged("positions").into()),
        };
        Ok(Snapshot { document, handles, positions, iteration, start: None })
    }
}

fn same_bits(a: &[Point], b: &[Point]) -> bool {
    let mut pairs = a.as_flattened().iter().zip(b.as_flattened());
    a.len() == b.len() && pairs.all(|(a, b)| a.to_bits() == b.to_bits())
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
