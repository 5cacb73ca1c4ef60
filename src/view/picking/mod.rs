//! Picking of elements under the cursor, and visibility. Screen positions are CSS pixels.

pub mod depth_map;
pub mod ray;

pub use depth_map::DepthMap;
pub use ray::hidden;

use crate::view::camera::Camera;
use crate::view::model::RenderMesh;
use glam::Vec2;
use ray::{Hit, first_hit};

/// A vertex behind the surface by up to this fraction of its distance is still visible.
const HIDING_TOLERANCE: f32 = 1e-3;

/// Returns whether a vertex is in front of the eye, not hidden, and kept by the section.
pub fn visible(mesh: &RenderMesh, camera: &Camera, vertex: u32) -> bool {
    let eye = camera.eye();
    let point = mesh.positions[vertex as usize];
    let (_, depth) = eye.project(point);
    let from = eye.seen_from(point);
    let tolerance = eye.scale_depth((point - from).length()) * HIDING_TOLERANCE;
    depth > 0.0
        && camera.keeps(point)
        && !hidden(mesh, from, vertex, tolerance, |point| camera.keeps(point))
}

/// Returns the visible vertex nearest to a screen position, within a radius.
pub fn pick_vertex(mesh: &RenderMesh, camera: &Camera, at: Vec2, radius: f32) -> Option<u32> {
    let all = 0..mesh.positions.len() as u32;
    near_cursor(mesh, camera, all, at, radius)
        .into_iter()
        .find(|&vertex| visible(mesh, camera, vertex))
}

/// Returns the candidate nearest to a screen position, within a radius, hidden or not.
pub fn pick_any(
    mesh: &RenderMesh,
    camera: &Camera,
    candidates: impl Iterator<Item = u32>,
    at: Vec2,
    radius: f32,
) -> Option<u32> {
    near_cursor(mesh, camera, candidates, at, radius).first().copied()
}

/// Returns the candidates within `radius` of a screen position, sorted by distance, then depth.
fn near_cursor(
    mesh: &RenderMesh,
    camera: &Camera,
    candidates: impl Iterator<Item = u32>,
    at: Vec2,
    radius: f32,
) -> Vec<u32> {
    let eye = camera.eye();
    let mut near: Vec<(f32, f32, u32)> = candidates
        .filter_map(|vertex| {
            let (screen, depth) = eye.project(mesh.positions[vertex as usize]);
            let distance = screen.distance(at);
            (depth > 0.0 && distance <= radius).then_some((distance, depth, vertex))
        })
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    near.into_iter().map(|(_, _, vertex)| vertex).collect()
}

/// Returns the face under a screen position, and the distance along its ray.
pub fn pick_face(mesh: &RenderMesh, camera: &Camera, at: Vec2) -> Option<Hit> {
    let (from, direction) = camera.eye().ray(at);
    first_hit(mesh, from, direction, |point| camera.keeps(point))
}
