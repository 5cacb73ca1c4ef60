//! The measuring tape: the vector between two vertices, now and in the mesh as it was opened.

use super::view_state::ViewState;
use crate::view::model::{ViewError, check_indices};
use glam::{DVec3, Vec2};

/// The vector from one vertex to another, in file coordinates and the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// In the current shape.
    pub now: DVec3,
    /// In the shape as it was opened, if that is known.
    pub rest: Option<DVec3>,
}

impl ViewState {
    /// Spans the tape between two vertices, marks its start at one, or removes it.
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

    /// Returns the ends of the tape: none, the first, or both.
    pub fn tape(&self) -> &[u32] {
        &self.content.tape
    }

    /// Returns the canvas position of the middle of the tape, hidden or not, in CSS pixels; none
    /// without a tape, or if it is behind the eye.
    pub fn tape_middle(&self) -> Option<Vec2> {
        let &[from, to] = &self.content.tape[..] else { return None };
        let [from, to] = [from, to].map(|v| self.content.mesh.positions[v as usize]);
        let (at, depth) = self.viewpoint.camera.eye().project(0.5 * (from + to));
        (depth > 0.0).then_some(at)
    }

    /// Returns the vector along the tape; none unless it spans two vertices.
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
