//! What lies under the cursor or inside a box. Screen positions are CSS pixels.

use super::camera::Camera;
use super::depth_map::DepthMap;
use super::ray::{Hit, first_hit, hidden};
use super::subject::Subject;
use glam::{Vec2, Vec3};

/// A vertex this much behind the surface, in parts of its distance from the eye, is still seen.
const HIDING_TOLERANCE: f32 = 1e-3;

/// A rectangle on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenBox {
    low: Vec2,
    high: Vec2,
}

impl ScreenBox {
    /// From any two opposite corners.
    pub fn new(a: Vec2, b: Vec2) -> ScreenBox {
        ScreenBox { low: a.min(b), high: a.max(b) }
    }

    fn holds(&self, p: Vec2) -> bool {
        p.cmpge(self.low).all() && p.cmple(self.high).all()
    }

    /// Whether any part of the segment from `a` to `b` is inside (Liang and Barsky 1984).
    fn meets(&self, a: Vec2, b: Vec2) -> bool {
        let (mut enter, mut leave) = (0.0f32, 1.0f32);
        let along = b - a;
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if a[axis] < self.low[axis] || a[axis] > self.high[axis] {
                    return false;
                }
                continue;
            }
            let first = (self.low[axis] - a[axis]) / along[axis];
            let second = (self.high[axis] - a[axis]) / along[axis];
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        enter <= leave
    }
}

/// Whether the vertex is in front of the eye and not behind the surface.
pub fn visible(subject: &Subject, camera: &Camera, vertex: u32) -> bool {
    let eye = camera.eye();
    let point = subject.positions[vertex as usize];
    let (_, depth) = eye.project(point);
    depth > 0.0 && !hidden(subject, eye.at, vertex, (point - eye.at).length() * HIDING_TOLERANCE)
}

/// The visible vertex nearest to a screen position, within a radius.
pub fn pick_vertex(subject: &Subject, camera: &Camera, at: Vec2, radius: f32) -> Option<u32> {
    let all = 0..subject.positions.len() as u32;
    near_cursor(subject, camera, all, at, radius)
        .into_iter()
        .find(|&vertex| visible(subject, camera, vertex))
}

/// The nearest of `candidates` to a screen position, within a radius, hidden or not.
pub fn pick_any(
    subject: &Subject,
    camera: &Camera,
    candidates: impl Iterator<Item = u32>,
    at: Vec2,
    radius: f32,
) -> Option<u32> {
    near_cursor(subject, camera, candidates, at, radius).first().copied()
}

/// Those of `candidates` within `radius` of a screen position, the nearest first; of those in the
/// same place the one nearer to the eye first.
fn near_cursor(
    subject: &Subject,
    camera: &Camera,
    candidates: impl Iterator<Item = u32>,
    at: Vec2,
    radius: f32,
) -> Vec<u32> {
    let eye = camera.eye();
    let mut near: Vec<(f32, f32, u32)> = candidates
        .filter_map(|vertex| {
            let (screen, depth) = eye.project(subject.positions[vertex as usize]);
            let distance = screen.distance(at);
            (depth > 0.0 && distance <= radius).then_some((distance, depth, vertex))
        })
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    near.into_iter().map(|(_, _, vertex)| vertex).collect()
}

/// The face under a screen position, with the depth at which it was met.
pub fn pick_face(subject: &Subject, camera: &Camera, at: Vec2) -> Option<Hit> {
    let eye = camera.eye();
    first_hit(subject, eye.at, eye.direction(at))
}

/// Visible vertices inside a box, in order.
pub fn box_vertices(
    subject: &Subject,
    camera: &Camera,
    map: &DepthMap,
    inside: ScreenBox,
) -> Vec<u32> {
    let eye = camera.eye();
    (0..subject.positions.len() as u32)
        .filter(|&vertex| {
            let (screen, depth) = eye.project(subject.positions[vertex as usize]);
            depth > 0.0 && inside.holds(screen) && map.shows(screen, depth)
        })
        .collect()
}

/// Visible faces inside a box, in order: those wholly inside, or with `crossing` those that it
/// touches.
pub fn box_faces(
    subject: &Subject,
    camera: &Camera,
    map: &DepthMap,
    inside: ScreenBox,
    crossing: bool,
) -> Vec<u32> {
    let eye = camera.eye();
    let mut seen = map.faces_in_front(subject.faces.len());
    // A face too small for the map's pixels is seen where its middle is.
    for (triangle, &face) in subject.triangles.iter().zip(&subject.triangle_face) {
        if !seen[face as usize] {
            let corners = triangle.map(|v| subject.positions[v as usize]);
            let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            let (screen, depth) = eye.project(middle);
            seen[face as usize] = depth > 0.0 && map.shows(screen, depth);
        }
    }
    let mut touched = vec![false; subject.faces.len()];
    if crossing {
        // The box may lie inside a face, and touch none of its sides.
        for corner in [inside.low, inside.high, (inside.low + inside.high) * 0.5] {
            if let Some(hit) = first_hit(subject, eye.at, eye.direction(corner)) {
                touched[hit.face as usize] = true;
            }
        }
    }
    (0..subject.faces.len() as u32)
        .filter(|&f| {
            let corners = subject.faces.row(f as usize);
            let on_screen: Vec<(Vec2, f32)> =
                corners.iter().map(|&v| eye.project(subject.positions[v as usize])).collect();
            let in_front = on_screen.iter().all(|&(_, depth)| depth > 0.0);
            let chosen = if crossing {
                let sides = on_screen.iter().zip(on_screen.iter().cycle().skip(1));
                touched[f as usize]
                    || in_front && sides.take(corners.len()).any(|(a, b)| inside.meets(a.0, b.0))
            } else {
                in_front && on_screen.iter().all(|&(screen, _)| inside.holds(screen))
            };
            chosen && seen[f as usize] && !corners.is_empty()
        })
        .collect()
}

/// How far a vertex must move, parallel to the screen, to lie under a screen position.
pub fn drag_offset(subject: &Subject, camera: &Camera, vertex: u32, to: Vec2) -> Vec3 {
    let eye = camera.eye();
    let (screen, depth) = eye.project(subject.positions[vertex as usize]);
    if depth > 0.0 { eye.across(to - screen, depth) } else { Vec3::ZERO }
}
