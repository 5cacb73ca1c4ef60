//! Elements inside a box, a lasso, or a brush stroke. Screen positions are CSS pixels.

use super::ViewState;
use crate::math::polygon_sides;
use crate::view::camera::{Camera, CameraProjection, Eye};
use crate::view::model::{RenderMesh, ViewError, check_indices, check_length};
use crate::view::picking::DepthMap;
use glam::{Vec2, Vec3};

/// A closed polygon on the screen. If it intersects itself, the even-odd rule applies.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    corners: Vec<Vec2>,
    low: Vec2,
    high: Vec2,
}

impl Outline {
    /// Creates an outline from its corners in order, closed implicitly; empty without corners.
    pub fn new(corners: Vec<Vec2>) -> Outline {
        let low = corners.iter().copied().reduce(Vec2::min).unwrap_or(Vec2::INFINITY);
        let high = corners.iter().copied().reduce(Vec2::max).unwrap_or(Vec2::NEG_INFINITY);
        Outline { corners, low, high }
    }

    fn contains(&self, p: Vec2) -> bool {
        p.cmpge(self.low).all() && p.cmple(self.high).all() && contains(&self.corners, p)
    }

    /// Returns whether a segment crosses the outline.
    fn crosses(&self, a: Vec2, b: Vec2) -> bool {
        let beside = a.max(b).cmplt(self.low).any() || a.min(b).cmpgt(self.high).any();
        !beside && polygon_sides(&self.corners).any(|[c, d]| cross(a, b, c, d))
    }

    /// Returns whether any part of a segment is inside.
    fn intersects(&self, a: Vec2, b: Vec2) -> bool {
        self.contains(a) || self.crosses(a, b)
    }

    /// Returns whether a segment is entirely inside.
    fn contains_segment(&self, a: Vec2, b: Vec2) -> bool {
        self.contains(a) && self.contains(b) && !self.crosses(a, b)
    }
}

/// Applies the even-odd rule to a horizontal ray from `p` to the right.
fn contains(corners: &[Vec2], p: Vec2) -> bool {
    let crossed = polygon_sides(corners).filter(|&[a, b]| {
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

/// Returns whether two segments cross: the ends of each lie on different sides of the other.
fn cross(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> bool {
    let side = |from: Vec2, to: Vec2, p: Vec2| (to - from).perp_dot(p - from) > 0.0;
    side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)
}

/// Which elements a region selects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RegionMode {
    /// Whether elements that are partly inside count.
    pub touching: bool,
    /// Whether elements that the surface hides count.
    pub through: bool,
}

impl ViewState {
    /// Sets the edges that can be picked: two vertices each, numbered in this order.
    ///
    /// # Errors
    /// A vertex that does not exist, or an odd number of vertices.
    pub fn set_edges(&mut self, ends: &[u32]) -> Result<(), ViewError> {
        self.content.edges = self.edges_of("edges", ends)?;
        Ok(())
    }

    /// Sets the selected edges.
    ///
    /// # Errors
    /// An index out of range of [`ViewState::set_edges`].
    pub fn select_edges(&mut self, edges: &[u32]) -> Result<(), ViewError> {
        check_indices("selected edges", edges, self.content.edges.len())?;
        self.look.appearance.selected_edges =
            edges.iter().map(|&e| self.content.edges[e as usize]).collect();
        self.changes.marks = true;
        Ok(())
    }

    /// Sets the edges along which a paper model is cut: two vertices each.
    ///
    /// # Errors
    /// A vertex that does not exist, or an odd number of vertices; the old ones stay.
    pub fn set_seams(&mut self, ends: &[u32]) -> Result<(), ViewError> {
        self.look.appearance.seams = self.edges_of("seams", ends)?;
        self.changes.marks = true;
        Ok(())
    }

    /// Returns the edges whose ends these are, two each; `what` names them in an error.
    fn edges_of(&self, what: &'static str, ends: &[u32]) -> Result<Vec<[u32; 2]>, ViewError> {
        check_indices(what, ends, self.counts().0)?;
        check_length(what, ends.len(), ends.len().next_multiple_of(2))?;
        Ok(ends.as_chunks::<2>().0.to_vec())
    }

    /// Returns the visible edge nearest to a screen position, within a radius.
    pub fn pick_edge(&mut self, at: Vec2, radius: f32) -> Option<u32> {
        let seen = SeenMesh::new(self, false);
        let is_parallel = seen.camera.projection != CameraProjection::Perspective;
        let mut near: Vec<(f32, f32, u32, f32)> = Vec::new();
        for (&ends, edge) in seen.edges.iter().zip(0..) {
            let Some([a, b]) = seen.on_screen(ends) else { continue };
            let along = (b.0 - a.0).length_squared();
            let part = if along > 0.0 { (at - a.0).dot(b.0 - a.0) / along } else { 0.0 };
            let part = part.clamp(0.0, 1.0);
            let distance = a.0.lerp(b.0, part).distance(at);
            if distance <= radius {
                // The same point in space: in perspective the nearer part of the edge is longer.
                let behind = if is_parallel { 1.0 } else { b.1 / a.1 };
                let share = part / (part + (1.0 - part) * behind);
                near.push((distance, a.1.min(b.1), edge, share));
            }
        }
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let is_seen = |&(_, _, edge, share): &(f32, f32, u32, f32)| {
            let [a, b] = seen.edges[edge as usize].map(|v| seen.mesh.positions[v as usize]);
            seen.shows(a.lerp(b, share))
        };
        near.into_iter().find(is_seen).map(|(_, _, edge, _)| edge)
    }

    /// Returns the vertices inside that are drawn, in ascending order.
    pub fn vertices_in(&mut self, outline: &Outline, through: bool) -> Vec<u32> {
        let drawn = self.drawn_vertices();
        let seen = SeenMesh::new(self, through);
        let inside = |&vertex: &u32| {
            let point = seen.mesh.positions[vertex as usize];
            let (at, depth) = seen.project(point);
            depth > 0.0 && outline.contains(at) && seen.shows(point)
        };
        drawn.into_iter().filter(inside).collect()
    }

    /// Returns the edges inside, in the order of [`ViewState::set_edges`]. An edge is visible if
    /// its midpoint is.
    pub fn edges_in(&mut self, outline: &Outline, mode: RegionMode) -> Vec<u32> {
        let seen = SeenMesh::new(self, mode.through);
        let inside = |&edge: &u32| {
            let Some([a, b]) = seen.on_screen(seen.edges[edge as usize]) else { return false };
            let within = if mode.touching {
                outline.intersects(a.0, b.0)
            } else {
                outline.contains_segment(a.0, b.0)
            };
            within && seen.shows_edge(edge)
        };
        (0..seen.edges.len() as u32).filter(inside).collect()
    }

    /// Returns the faces inside, in ascending order.
    pub fn faces_in(&mut self, outline: &Outline, mode: RegionMode) -> Vec<u32> {
        let seen = SeenMesh::new(self, mode.through);
        let shown = seen.faces();
        let inside = |&face: &u32| {
            let corners = seen.mesh.faces.row(face as usize);
            let places: Vec<(Vec2, f32)> =
                corners.iter().map(|&v| seen.project(seen.mesh.positions[v as usize])).collect();
            if places.is_empty() || places.iter().any(|&(_, depth)| depth <= 0.0) {
                return false;
            }
            let corners: Vec<Vec2> = places.iter().map(|&(at, _)| at).collect();
            let within = if mode.touching {
                // The outline may lie inside the face without touching its sides.
                polygon_sides(&corners).any(|[a, b]| outline.intersects(a, b))
                    || outline.corners.first().is_some_and(|&corner| contains(&corners, corner))
            } else {
                polygon_sides(&corners).all(|[a, b]| outline.contains_segment(a, b))
            };
            let is_left = || {
                let mut row = seen.mesh.faces.row(face as usize).iter();
                row.any(|&v| seen.camera.keeps(seen.mesh.positions[v as usize]))
            };
            within && shown.as_ref().is_none_or(|shown| shown[face as usize]) && is_left()
        };
        (0..seen.mesh.faces.len() as u32).filter(inside).collect()
    }
}

/// The mesh as the camera sees it, with the depths to test visibility.
struct SeenMesh<'a> {
    mesh: &'a RenderMesh,
    edges: &'a [[u32; 2]],
    camera: Camera,
    eye: Eye,
    /// None if hidden elements count too.
    map: Option<&'a DepthMap>,
}

impl<'a> SeenMesh<'a> {
    fn new(state: &'a mut ViewState, through: bool) -> SeenMesh<'a> {
        if !through {
            state.ensure_depth_map();
        }
        let state = &*state;
        let camera = state.camera();
        let eye = camera.eye();
        let map = if through { None } else { state.depth_map() };
        SeenMesh { mesh: &state.content.mesh, edges: &state.content.edges, camera, eye, map }
    }

    fn project(&self, point: Vec3) -> (Vec2, f32) {
        self.eye.project(point)
    }

    /// Returns whether the section keeps a point and, if that counts, the surface does not hide it.
    fn shows(&self, point: Vec3) -> bool {
        let (at, depth) = self.project(point);
        self.camera.keeps(point) && self.map.is_none_or(|map| map.shows(at, depth))
    }

    /// Returns the screen positions and depths of the ends of an edge, if both are before the eye.
    fn on_screen(&self, ends: [u32; 2]) -> Option<[(Vec2, f32); 2]> {
        let ends = ends.map(|v| self.project(self.mesh.positions[v as usize]));
        ends.iter().all(|&(_, depth)| depth > 0.0).then_some(ends)
    }

    fn shows_edge(&self, edge: u32) -> bool {
        let [a, b] = self.edges[edge as usize].map(|v| self.mesh.positions[v as usize]);
        self.shows((a + b) * 0.5)
    }

    /// Returns whether each face is visible; none if hidden faces count too.
    fn faces(&self) -> Option<Vec<bool>> {
        let map = self.map?;
        let mut shown = map.faces_in_front(self.mesh.faces.len());
        // A face too small for the map's pixels is visible if its centre is.
        for (triangle, &face) in self.mesh.triangles.iter().zip(&self.mesh.triangle_face) {
            if !shown[face as usize] {
                let corners = triangle.map(|v| self.mesh.positions[v as usize]);
                let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
                shown[face as usize] = self.project(middle).1 > 0.0 && self.shows(middle);
            }
        }
        Some(shown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_notch_of_a_lasso_is_outside() {
        let at = |x: f32, y: f32| Vec2::new(x, y);
        // A U: the notch comes down from above to the height of 2.
        let corners =
            [(0., 0.), (9., 0.), (9., 9.), (6., 9.), (6., 2.), (3., 2.), (3., 9.), (0., 9.)];
        let u = Outline::new(corners.map(|(x, y)| at(x, y)).to_vec());
        assert!(u.contains(at(1.0, 5.0)) && u.contains(at(8.0, 5.0)) && u.contains(at(4.5, 1.0)));
        assert!(!u.contains(at(4.5, 5.0)) && !u.contains(at(-1.0, 5.0)));
        // From arm to arm: both ends are inside, the middle is not.
        assert!(
            u.intersects(at(1.0, 5.0), at(8.0, 5.0))
                && !u.contains_segment(at(1.0, 5.0), at(8.0, 5.0))
        );
        assert!(u.contains_segment(at(1.0, 5.0), at(1.5, 8.0)));
        assert!(u.intersects(at(-5.0, 1.0), at(20.0, 1.0)));
        assert!(!u.intersects(at(4.0, 5.0), at(5.0, 8.0)));
        assert!(!Outline::new(vec![]).intersects(at(0.0, 0.0), at(1.0, 1.0)));
    }
}
