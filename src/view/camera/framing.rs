//! Places the camera so that points fill the canvas, and finds the range of their depths.
//!
//! For a given direction of view, the nearest eye that sees all points is found exactly: each point
//! bounds the eye by the four side planes of the field of view.

use super::orbit_camera::Camera;
use glam::{Vec2, Vec3};

/// Margin on each side, as a fraction of the canvas.
const MARGIN: f32 = 0.045;
/// Greatest height of a strip that framing leaves free, as a fraction of half the canvas.
const MOST_COVERED: f32 = 0.95;
/// Minimum ratio of the near depth to the far depth, for the precision of the depth buffer.
const NEAREST: f32 = 1e-3;
/// Maximum ratio of the near depth to the distance of what is looked at.
const NEAREST_SEEN: f32 = 0.3;

/// Moves `camera` along and across its direction of view until balls of `radius` around all
/// `points` are inside the uncovered part of the canvas, with a small margin. The radius should be
/// positive, so that a single point has a size. Without points the camera stays.
pub fn frame(camera: &mut Camera, points: impl Iterator<Item = Vec3> + Clone, radius: f32) {
    let eye = camera.eye();
    // Slopes of the side planes: to the right and upwards, to the left and downwards.
    let aside = eye.middle.x * (1.0 - 2.0 * MARGIN) / eye.focal;
    let margin = 2.0 * MARGIN * eye.middle.y;
    // Something is left between strips that would cover all.
    let strips = camera.covered.map(|height| height.clamp(margin, MOST_COVERED * eye.middle.y));
    let [slope, slope_back] =
        strips.map(|strip| Vec2::new(aside, (eye.middle.y - strip) / eye.focal));
    if eye.parallel.is_some() {
        return frame_parallel(camera, points, radius, [slope, slope_back]);
    }
    // Extent of the ball beyond its centre, measured across the side planes.
    let reach = |slope: Vec2| (slope * slope + 1.0).map(f32::sqrt) * radius;
    let seen = points.map(|p| Vec3::new(p.dot(eye.right), p.dot(eye.up), p.dot(eye.forward)));
    let nowhere = Vec2::splat(f32::NEG_INFINITY);
    let (mut high, mut low) = (nowhere, nowhere);
    let (mut front, mut back) = (f32::INFINITY, f32::NEG_INFINITY);
    for p in seen {
        high = high.max(p.truncate() - slope * p.z);
        low = low.max(-p.truncate() - slope_back * p.z);
        front = front.min(p.z - radius);
        back = back.max(p.z + radius);
    }
    if !back.is_finite() {
        return;
    }
    let (high, low) = (high + reach(slope), low + reach(slope_back));
    let depth = (-(high + low) / (slope + slope_back)).min_element();
    let middle = 0.5 * (front + back);
    // Points on a single ray have no width that bounds the depth.
    let depth = depth.min(front - 0.05 * (back - front));
    let across = (high - low + (slope - slope_back) * depth) * 0.5;
    camera.pivot = eye.right * across.x + eye.up * across.y + eye.forward * middle;
    camera.distance = (middle - depth).max(radius);
}

/// [`frame`] in parallel projection, where the side planes of the field of view are parallel too.
/// The slopes are the free parts of the canvas right and up, and left and down, of its centre.
fn frame_parallel(
    camera: &mut Camera,
    points: impl Iterator<Item = Vec3>,
    radius: f32,
    [slope, slope_back]: [Vec2; 2],
) {
    let eye = camera.eye();
    let seen = points.map(|p| Vec3::new(p.dot(eye.right), p.dot(eye.up), p.dot(eye.forward)));
    let Some((low, high)) =
        seen.map(|p| (p, p)).reduce(|(low, high), (p, _)| (low.min(p), high.max(p)))
    else {
        return;
    };
    let half = 0.5 * (high - low).truncate() + radius;
    camera.distance = (half * 2.0 / (slope + slope_back)).max_element().max(radius);
    let aside = 0.5 * (slope - slope_back) * camera.distance;
    let middle = 0.5 * (low + high) - aside.extend(0.0);
    camera.pivot = eye.right * middle.x + eye.up * middle.y + eye.forward * middle.z;
}

/// Returns near and far depths that tightly enclose all `points`.
pub fn depth_range(camera: &Camera, points: impl Iterator<Item = Vec3>) -> (f32, f32) {
    let eye = camera.eye();
    let (mut front, mut back) = (f32::INFINITY, f32::NEG_INFINITY);
    for p in points {
        let depth = (p - eye.at).dot(eye.forward);
        front = front.min(depth);
        back = back.max(depth);
    }
    if back <= 0.0 || !back.is_finite() {
        (front, back) = (camera.distance, camera.distance);
    }
    let far = back * 1.02;
    // What one looks at from nearby is not cut off, although less far things fight for the same depth.
    let nearest = (far * NEAREST).min(camera.distance * NEAREST_SEEN);
    ((front * 0.98).clamp(nearest, far * 0.96), far)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::camera::{CameraProjection, UpAxis};

    fn corners() -> Vec<Vec3> {
        (0..8)
            .map(|i| {
                Vec3::new((i & 1) as f32 * 20.0, (i >> 1 & 1) as f32 * 8.0, (i >> 2) as f32 * 3.0)
            })
            .collect()
    }

    #[test]
    fn a_framed_box_touches_the_margin_and_nothing_leaves_the_canvas() {
        let parallel = CameraProjection::Parallel { reach: 30.0 };
        for (canvas, projection) in [
            (Vec2::new(1440.0, 900.0), CameraProjection::Perspective),
            (Vec2::new(390.0, 844.0), CameraProjection::Perspective),
            (Vec2::new(390.0, 844.0), parallel),
            (Vec2::new(1440.0, 900.0), parallel),
        ] {
            for (side, up) in [("home", UpAxis::Z), ("top", UpAxis::Z), ("left", UpAxis::Y)] {
                let mut camera = Camera { canvas, up, projection, ..Camera::default() };
                camera.look_from(side).unwrap();
                frame(&mut camera, corners().into_iter(), 0.0);
                let eye = camera.eye();
                let mut spare = f32::INFINITY;
                for p in corners() {
                    let (screen, depth) = eye.project(p);
                    assert!(depth > 0.0);
                    let edge = screen.min(canvas - screen) / canvas;
                    spare = spare.min(edge.min_element());
                }
                assert!((spare - MARGIN).abs() < 1e-3, "{side} {canvas}: {spare}");
            }
        }
    }

    #[test]
    fn nothing_of_a_framed_box_is_where_the_canvas_is_covered() {
        let canvas = Vec2::new(390.0, 600.0);
        for projection in
            [CameraProjection::Perspective, CameraProjection::Parallel { reach: 30.0 }]
        {
            for side in ["home", "front"] {
                let covered = [80.0, 120.0];
                let mut camera = Camera { canvas, projection, covered, ..Camera::default() };
                camera.look_from(side).unwrap();
                // As high as the canvas.
                frame(
                    &mut camera,
                    corners().into_iter().map(|p| p * Vec3::new(1.0, 1.0, 20.0)),
                    0.0,
                );
                let eye = camera.eye();
                let heights = corners()
                    .into_iter()
                    .map(|p| eye.project(p * Vec3::new(1.0, 1.0, 20.0)).0.y)
                    .collect::<Vec<_>>();
                let low = heights.iter().copied().fold(0.0, f32::max);
                let high = heights.iter().copied().fold(f32::INFINITY, f32::min);
                assert!((low - 480.0).abs() < 0.5, "{side} {projection:?}: {low}");
                assert!((high - 80.0).abs() < 0.5, "{side} {projection:?}: {high}");
            }
        }
    }

    #[test]
    fn one_point_and_points_on_a_line_of_sight_give_a_finite_view() {
        let mut camera = Camera::default();
        let point = Vec3::new(3.0, 1.0, 2.0);
        frame(&mut camera, std::iter::once(point), 0.5);
        let (screen, depth) = camera.eye().project(point);
        assert!((screen - camera.canvas * 0.5).length() < 0.1 && depth > 0.5);
        camera.look_from("front").unwrap();
        frame(&mut camera, [Vec3::ZERO, Vec3::Y].into_iter(), 1e-3);
        assert!(camera.eye().project(Vec3::ZERO).1 > 0.0);
    }

    #[test]
    fn depths_hold_the_scene_from_outside_and_inside() {
        let mut camera = Camera::default();
        frame(&mut camera, corners().into_iter(), 0.0);
        let (near, far) = depth_range(&camera, corners().into_iter());
        for p in corners() {
            let depth = camera.eye().project(p).1;
            assert!(near < depth && depth < far);
        }
        assert!(far / near < 10.0);
        camera.distance = 0.1;
        let (near, far) = depth_range(&camera, corners().into_iter());
        assert!(near > 0.0 && near < far && far.is_finite());
        assert!(depth_range(&camera, std::iter::empty()).1.is_finite());
    }
}
