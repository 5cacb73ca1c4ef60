//! Picking under the cursor, canvas positions of vertices, and the measuring tape: the vector
//! between two vertices, now and in the mesh as it was opened.

use super::ViewState;
use crate::view::model::{ViewError, check_indices};
use crate::view::picking;
use crate::view::picking::depth_map::{COARSE, DepthMap};
use glam::{DVec3, Vec2};

impl ViewState {
    /// Returns the visible vertex nearest to the cursor.
    pub fn pick_vertex(&self, at: Vec2, radius: f32) -> Option<u32> {
        let drawn = self.drawn_vertices().into_iter();
        picking::pick_vertex(&self.content.mesh, &self.viewpoint.camera, drawn, at, radius)
    }

    /// Returns the vertices that are drawn, in ascending order: those of faces, curves and edges that
    /// can be picked, and all others only as dots. Nobody selects what is not drawn.
    pub(super) fn drawn_vertices(&self) -> Vec<u32> {
        let mesh = &self.content.mesh;
        let mut is_drawn = vec![self.look.display.vertices; mesh.exact.len()];
        for &vertex in mesh.used.iter().chain(self.content.edges.iter().flatten()) {
            is_drawn[vertex as usize] = true;
        }
        (0..).zip(is_drawn).filter_map(|(vertex, is)| is.then_some(vertex)).collect()
    }

    /// Returns the handle nearest to the cursor, hidden or not.
    pub fn pick_handle(&self, at: Vec2, radius: f32) -> Option<u32> {
        let handles = self.content.handles.iter().map(|handle| handle.vertex);
        picking::pick_any(&self.content.mesh, &self.viewpoint.camera, handles, at, radius)
    }

    /// Returns the face under the cursor.
    pub fn pick_face(&self, at: Vec2) -> Option<u32> {
        picking::pick_face(&self.content.mesh, &self.viewpoint.camera, at).map(|hit| hit.face)
    }

    /// Computes the depth map, unless it is up to date.
    pub(crate) fn ensure_depth_map(&mut self) {
        self.viewpoint.depth_map.get_or_insert_with(|| {
            DepthMap::new(&self.content.mesh, &self.viewpoint.camera, COARSE)
        });
    }

    /// Returns the depth map, if [`ViewState::ensure_depth_map`] has made it.
    pub(crate) fn depth_map(&self) -> Option<&DepthMap> {
        self.viewpoint.depth_map.as_ref()
    }

    /// Returns the canvas position of a vertex; `None` if it is hidden or outside.
    pub fn screen(&self, vertex: u32) -> Option<Vec2> {
        let point = *self.content.mesh.positions.get(vertex as usize)?;
        let (screen, _) = self.viewpoint.camera.eye().project(point);
        let inside =
            screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.viewpoint.camera.canvas).all();
        (inside && picking::visible(&self.content.mesh, &self.viewpoint.camera, vertex))
            .then_some(screen)
    }
}

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
