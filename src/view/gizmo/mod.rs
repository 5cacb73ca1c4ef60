//! The gizmo at the selected handles: an arrow along each axis and a square in each plane, which
//! the pointer can hold. It has the same size on the screen everywhere, and is drawn over the mesh.
//!
//! Arrows that point at the eye and squares seen edge-on fade out and cannot be picked, because a
//! pixel would correspond to any distance.

pub mod drag_constraint;
pub mod outline;

pub use drag_constraint::{DragConstraint, DragDirection};
pub use outline::triangles;

use crate::view::camera::{Camera, Eye};
use drag_constraint::axis_of;
use glam::{Vec2, Vec3};

/// An arrow is invisible up to the first value of the sine of its angle with the ray, and opaque
/// from the second on; likewise a square, by the cosine of the angle of its normal.
const FADING: [f32; 2] = [0.2, 0.38];
/// A part fainter than this cannot be picked.
const LEAST_PICKABLE: f32 = 0.5;

/// Sizes in CSS pixels, seen from the front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Radius around the centre that belongs to the handle itself.
    pub gap: f32,
    /// Distance from the centre to the tip of an arrow.
    pub length: f32,
    /// Range of a square along both of its axes.
    pub square: [f32; 2],
    /// Maximum distance of the pointer from a part: half the size of a target.
    pub reach: f32,
}

/// Sizes for a mouse or a pen.
const FINE: Sizes = Sizes { gap: 15.0, length: 86.0, square: [28.0, 54.0], reach: 12.0 };
/// Sizes for fingers.
const COARSE: Sizes = Sizes { gap: 26.0, length: 120.0, square: [44.0, 84.0], reach: 22.0 };

/// The state of the gizmo, as the page sets it.
#[derive(Clone, Copy, Debug, Default)]
pub struct GizmoState {
    /// Whether it is shown when a handle is selected.
    pub shown: bool,
    /// Whether it is sized for fingers.
    pub touch: bool,
    /// The part that the pointer is over or holds.
    pub highlighted: Option<DragDirection>,
    /// Whether the pointer holds this part or another handle; the other parts are then fainter.
    pub held: bool,
    /// The point that the pointer holds.
    pub drag: Option<DragConstraint>,
}

/// An arrow or a square on the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The direction in which it drags.
    pub direction: DragDirection,
    /// Opacity, from 0 (invisible) to 1.
    pub strength: f32,
    /// Start and tip of an arrow, or the corners of a square, CSS pixels.
    pub corners: Vec<Vec2>,
    /// Depth of its farthest point; nearer parts are drawn later.
    pub depth: f32,
}

/// The gizmo on the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Gizmo {
    /// Position of the handles, CSS pixels.
    pub middle: Vec2,
    /// Its sizes.
    pub sizes: Sizes,
    /// Arrows x, y, z, then squares yz, zx, xy.
    pub parts: Vec<Part>,
}

impl Gizmo {
    /// Creates the gizmo at a point of the scene; `None` if it is behind the eye.
    pub fn new(camera: &Camera, at: Vec3, touch: bool) -> Option<Gizmo> {
        let eye = camera.eye();
        let (middle, depth) = eye.project(at);
        if depth <= 0.0 {
            return None;
        }
        let sizes = if touch { COARSE } else { FINE };
        let pixel = eye.across(Vec2::X, depth).length();
        let sight = eye.ray(middle).1.normalize();
        let place = |offset: Vec3| at + offset * pixel;
        let arrows = (0..3).map(|axis| {
            let along = axis_of(axis);
            let ends = [sizes.gap, sizes.length].map(|far| place(along * far));
            let part = along.dot(sight);
            Part::new(&eye, DragDirection::Axis(axis), (1.0 - part * part).max(0.0).sqrt(), &ends)
        });
        let squares = (0..3).map(|axis| {
            let [a, b] = [axis_of((axis + 1) % 3), axis_of((axis + 2) % 3)];
            let [near, far] = sizes.square;
            let corners = [[near, near], [far, near], [far, far], [near, far]];
            let corners = corners.map(|[u, v]| place(a * u + b * v));
            Part::new(&eye, DragDirection::Plane(axis), axis_of(axis).dot(sight).abs(), &corners)
        });
        Some(Gizmo { middle, sizes, parts: arrows.chain(squares).collect() })
    }

    /// Returns the part at a screen position; none near the centre, where the handle is.
    pub fn pick(&self, at: Vec2) -> Option<DragDirection> {
        if at.distance(self.middle) < self.sizes.gap {
            return None;
        }
        let mut nearest: Option<(f32, DragDirection)> = None;
        for part in self.parts.iter().filter(|part| part.strength >= LEAST_PICKABLE) {
            if let Some(distance) = part.distance(at, self.sizes.reach)
                && nearest.is_none_or(|(least, _)| distance < least)
            {
                nearest = Some((distance, part.direction));
            }
        }
        nearest.map(|(_, direction)| direction)
    }

    /// Returns the best position for picking a part; `None` if it cannot be picked.
    pub fn best(&self, direction: DragDirection) -> Option<Vec2> {
        let part = self.parts.iter().find(|part| part.direction == direction)?;
        let at = match part.corners[..] {
            [start, tip] => start.lerp(tip, 0.75),
            _ => part.middle(),
        };
        (part.strength >= LEAST_PICKABLE).then_some(at)
    }
}

impl Part {
    fn new(eye: &Eye, direction: DragDirection, slant: f32, points: &[Vec3]) -> Part {
        let [gone, whole] = FADING;
        let (corners, depths): (Vec<_>, Vec<_>) = points.iter().map(|&p| eye.project(p)).unzip();
        Part {
            direction,
            strength: ((slant - gone) / (whole - gone)).clamp(0.0, 1.0),
            corners,
            depth: depths.into_iter().fold(0.0, f32::max),
        }
    }

    fn middle(&self) -> Vec2 {
        self.corners.iter().sum::<Vec2>() / self.corners.len() as f32
    }

    /// Returns the distance of the part from a screen position, if it is at most `reach`.
    fn distance(&self, at: Vec2, reach: f32) -> Option<f32> {
        if let [start, tip] = self.corners[..] {
            let distance = distance_to_segment(at, start, tip);
            return (distance <= reach).then_some(distance);
        }
        let sides = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let turns = sides.clone().map(|(&a, &b)| (b - a).perp_dot(at - a));
        let inside = turns.clone().all(|turn| turn >= 0.0) || turns.clone().all(|turn| turn <= 0.0);
        if inside {
            return Some(0.0);
        }
        let distance = sides.map(|(&a, &b)| distance_to_segment(at, a, b)).fold(f32::MAX, f32::min);
        (at.distance(self.middle()) <= reach).then_some(distance)
    }
}

fn distance_to_segment(at: Vec2, start: Vec2, end: Vec2) -> f32 {
    let span = end - start;
    let part =
        ((at - start).dot(span) / span.length_squared().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    at.distance(start + span * part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::FRAC_PI_2;

    fn gizmo(turn: f32, tilt: f32, distance: f32, touch: bool) -> Gizmo {
        let canvas = Vec2::new(1000.0, 800.0);
        let camera = Camera { turn, tilt, distance, canvas, ..Camera::default() };
        Gizmo::new(&camera, Vec3::new(0.2, 0.1, -0.1), touch).unwrap()
    }

    fn length(part: &Part) -> f32 {
        part.corners[0].distance(part.corners[1])
    }

    #[test]
    fn it_is_as_large_from_far_as_from_near() {
        let [near, far] = [3.0, 300.0].map(|distance| gizmo(0.55, 0.65, distance, false));
        for (a, b) in near.parts.iter().zip(&far.parts) {
            assert_eq!(a.direction, b.direction);
            assert!((length(a) - length(b)).abs() < 4.0, "{:?}", a.direction);
        }
        let behind = Camera { distance: -3.0, ..Camera::default() };
        assert!(Gizmo::new(&behind, Vec3::ZERO, false).is_none());
    }

    #[test]
    fn every_part_can_be_taken_where_it_is_said_to_be() {
        for touch in [false, true] {
            let gizmo = gizmo(0.55, 0.65, 5.0, touch);
            for part in &gizmo.parts {
                let at = gizmo.best(part.direction).unwrap();
                assert_eq!(gizmo.pick(at), Some(part.direction), "{touch}");
            }
            assert_eq!(gizmo.pick(gizmo.middle + 3.0), None, "the handle is there");
            assert_eq!(gizmo.pick(gizmo.middle + 300.0), None);
        }
    }

    #[test]
    fn a_target_is_24_pixels_wide_and_44_for_fingers() {
        for (touch, half) in [(false, 12.0), (true, 22.0)] {
            let gizmo = gizmo(0.55, 0.65, 5.0, touch);
            for part in &gizmo.parts[..3] {
                let [start, tip] = part.corners[..] else { panic!("an arrow has two ends") };
                let aside = (tip - start).perp().normalize() * (half - 0.1);
                for side in [aside, -aside] {
                    let found = part.distance(tip + side, gizmo.sizes.reach);
                    assert!(found.is_some(), "{:?}", part.direction);
                }
            }
            for part in &gizmo.parts[3..] {
                for way in [Vec2::X, Vec2::Y, -Vec2::X, -Vec2::Y] {
                    let at = part.middle() + way * (half - 0.1);
                    assert!(part.distance(at, gizmo.sizes.reach).is_some(), "{:?}", part.direction);
                }
            }
        }
    }

    #[test]
    fn from_above_only_what_moves_on_the_ground_can_be_taken() {
        let gizmo = gizmo(0.0, FRAC_PI_2, 50.0, false);
        let taken: Vec<_> =
            gizmo.parts.iter().map(|part| gizmo.best(part.direction).is_some()).collect();
        assert_eq!(taken, [true, true, false, false, false, true]);
        let upwards = &gizmo.parts[2];
        assert_eq!(upwards.strength, 0.0);
        assert_ne!(gizmo.pick(upwards.corners[1] + Vec2::splat(9.0)), Some(upwards.direction));
    }
}
