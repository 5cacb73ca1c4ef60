//! Picking of elements under the cursor, and visibility. Screen positions are CSS pixels.

pub mod depth_map;
pub mod ray;

pub use depth_map::DepthMap;

use crate::view::camera::Camera;
use crate::view::model::RenderMesh;
use glam::Vec2;
use ray::{Hit, first_hit, hider};

/// A vertex behind the surface by up to this fraction of its distance is still visible.
const HIDING_TOLERANCE: f32 = 1e-3;

/// Pixels by which a triangle may reach beyond its rounded corners on the screen.
const MARGIN: f32 = 1.0;

/// Returns whether a vertex is in front of the eye, not hidden, and kept by the section.
pub fn visible(mesh: &RenderMesh, camera: &Camera, vertex: u32) -> bool {
    let point = mesh.positions[vertex as usize];
    let (_, depth) = camera.eye().project(point);
    depth > 0.0 && camera.keeps(point) && hider_of(mesh, &mesh.triangles, camera, vertex).is_none()
}

/// The place of the first of the `triangles` that hides a vertex, if any.
fn hider_of(
    mesh: &RenderMesh,
    triangles: &[[u32; 3]],
    camera: &Camera,
    vertex: u32,
) -> Option<usize> {
    let eye = camera.eye();
    let point = mesh.positions[vertex as usize];
    let from = eye.seen_from(point);
    let tolerance = eye.scale_depth((point - from).length()) * HIDING_TOLERANCE;
    hider(mesh, triangles, from, vertex, tolerance, |point| camera.keeps(point))
}

/// Returns the visible one of the candidates that is nearest to a screen position, within a radius.
pub fn pick_vertex(
    mesh: &RenderMesh,
    camera: &Camera,
    candidates: impl Iterator<Item = u32>,
    at: Vec2,
    radius: f32,
) -> Option<u32> {
    let mut near = near_cursor(mesh, camera, candidates, at, radius);
    near.retain(|&vertex| camera.keeps(mesh.positions[vertex as usize]));
    if near.is_empty() {
        return None;
    }
    // Very many may be near, and none of them visible: few triangles can hide them, and what hides
    // one often hides the next.
    let mut triangles = triangles_near(mesh, camera, at, radius + MARGIN);
    near.into_iter().find(|&vertex| match hider_of(mesh, &triangles, camera, vertex) {
        None => true,
        Some(place) => {
            triangles[..=place].rotate_right(1);
            false
        }
    })
}

/// Returns the triangles of which a part may be seen within `radius` of a screen position.
fn triangles_near(mesh: &RenderMesh, camera: &Camera, at: Vec2, radius: f32) -> Vec<[u32; 3]> {
    let eye = camera.eye();
    let is_near = |triangle: &&[u32; 3]| {
        let seen = triangle.map(|v| eye.project(mesh.positions[v as usize]));
        let corners = seen.map(|(screen, _)| screen);
        let low = corners[0].min(corners[1]).min(corners[2]);
        let high = corners[0].max(corners[1]).max(corners[2]);
        // One that reaches behind the eye has no outline on the screen.
        seen.iter().any(|(_, depth)| *depth <= 0.0)
            || (low.cmple(at + radius).all() && high.cmpge(at - radius).all())
    };
    mesh.triangles.iter().filter(is_near).copied().collect()
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
