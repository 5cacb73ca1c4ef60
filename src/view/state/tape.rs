//! The measuring tape: how far apart two vertices are, now and in the model that was opened.

use super::view_state::ViewState;
use crate::view::model::{ViewError, check_indices};
use glam::{DVec3, Vec2};

/// From one vertex to another, in file coordinates and the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// As the mesh is.
    pub now: DVec3,
    /// As it was opened, when that is known.
    pub rest: Option<DVec3>,
}

impl ViewState {
    /// Spans the tape between two vertices, marks the one that it begins at, or takes it away.
    ///
    /// # Errors
    /// A vertex that does not exist, or more than two.
    pub fn set_tape(&mut self, vertices: &[u32]) -> Result<(), ViewError> {
        check_indices("tape", vertices, self.counts().0)?;
        if vertices.len() > 2 {
            let got = vertices.len();
            return Err(ViewError::Length { what: "tape", got, expected: 2 });
        }
        self.changes.marks |= self.content.tape != vertices;
        self.content.tape = vertices.to_vec();
        Ok(())
    }

    /// The ends of the tape: none, the first, or both.
    pub fn tape(&self) -> &[u32] {
        &self.content.tape
    }

    /// Where the middle of the tape is on the canvas, hidden or not, in CSS pixels; nothing without a tape,
    /// and where it is behind the eye.
    pub fn tape_middle(&self) -> Option<Vec2> {
        let &[from, to] = &self.content.tape[..] else { return None };
        let [from, to] = [from, to].map(|v| self.content.mesh.positions[v as usize]);
        let (at, depth) = self.viewpoint.camera.eye().project(0.5 * (from + to));
        (depth > 0.0).then_some(at)
    }

    /// The vector along the tape; none unless it spans two vertices.
    pub fn measured(&self) -> Option<Measured> {
        let &[from, to] = &self.content.tape[..] else { return None };
        let between = |points: &[DVec3]| points[to as usize] - points[from as usize];
        let rest = self.around.rest();
        Some(Measured {
            now: between(&self.content.mesh.exact),
            rest: (!rest.is_empty()).then(|| between(rest)),
        })
    }
}
