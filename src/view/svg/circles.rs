//! Fitted circles of a still picture, as ellipses on the screen. They are drawn over all faces,
//! which suits meshes whose faces are all visible.

use crate::view::appearance::LIGHT;
use crate::view::camera::Eye;
use crate::view::state::{SHAPE_NUMBERS, ViewState};
use glam::{Vec2, Vec3};
use std::fmt::Write;

/// Circles of a smaller radius on the screen are fainter, as in `shaders/circles.wgsl`; CSS pixels.
const FULL_OPACITY: f32 = 20.0;
/// Radius on the screen at which circles disappear, CSS pixels.
const NO_OPACITY: f32 = 2.0;

/// Ellipse axes are rounded to multiples of this angle in degrees.
const TURN: f32 = 6.0;

/// A circle of the scene: centre, and two perpendicular radii.
pub(super) struct Circle {
    pub centre: Vec3,
    pub radii: [Vec3; 2],
}

/// An ellipse on the screen, CSS pixels.
struct Ellipse {
    centre: Vec2,
    /// The longer semi-axis.
    axis: Vec2,
    /// The length of the shorter semi-axis.
    minor: f32,
}

/// Returns all circles as one path, which a script redraws from the fitted shapes, or nothing.
pub(super) fn circles(state: &ViewState, eye: &Eye) -> String {
    let mut path = String::new();
    let mut sizes = Vec::new();
    for circle in fitted(state) {
        sizes.push(size_on_screen(&circle, eye));
        // Rounded first, so that equal ellipses have equal text, which compresses well.
        let Ellipse { centre, axis, minor } = on_screen(&circle, eye);
        let (major, minor) = (half(axis.length()), half(minor));
        let turn = (axis.y.atan2(axis.x).to_degrees() / TURN).round() * TURN;
        let axis = (Vec2::from_angle(turn.to_radians()) * major).round();
        let from = (centre - axis).round();
        let arc = format!("{major} {minor} {turn} 1 0");
        let Vec2 { x, y } = 2.0 * axis;
        // Writing to a string cannot fail.
        let _ = write!(path, "M{} {}a{arc} {x} {y} {arc} {} {}", from.x, from.y, -x, -y);
    }
    if path.is_empty() {
        return path;
    }
    // A path has a single opacity: the mean, weighted by the radii on the screen.
    let part = |size: f32| ((size - NO_OPACITY) / (FULL_OPACITY - NO_OPACITY)).clamp(0.0, 1.0);
    let drawn: f32 = sizes.iter().map(|&size| size * part(size)).sum();
    let mean = drawn / sizes.iter().sum::<f32>().max(f32::MIN_POSITIVE);
    let [.., alpha] = LIGHT.circle.colour;
    let opacity = (100.0 * alpha * mean).round() / 100.0;
    format!(r#"<g opacity="{opacity}"><path class="circles" d="{path}"/></g>"#)
}

/// Returns the radius in CSS pixels, reduced if the circle is seen edge-on.
fn size_on_screen(circle: &Circle, eye: &Eye) -> f32 {
    let [u, v] = circle.radii;
    let away = eye.seen_from(circle.centre) - circle.centre;
    let facing = u.cross(v).normalize_or_zero().dot(away.normalize_or_zero()).abs();
    let (_, depth) = eye.project(circle.centre);
    let pixel = eye.across(Vec2::X, depth).length();
    u.length() * (0.15 + 0.85 * facing) / pixel
}

/// Returns the fitted circles of the scene.
pub(super) fn fitted(state: &ViewState) -> impl Iterator<Item = Circle> + '_ {
    let shapes = state.shapes().chunks_exact(SHAPE_NUMBERS);
    shapes.filter(|shape| shape[0] == 0.0).map(|shape| {
        let normal = Vec3::from_slice(&shape[4..7]);
        let u = normal.any_orthonormal_vector() * shape[7];
        Circle { centre: Vec3::from_slice(&shape[1..4]), radii: [u, normal.cross(u)] }
    })
}

/// Returns the ellipse whose conjugate semi-diameters are the images of the two radii. In
/// perspective this is the image of the circle up to terms of second order in radius / distance.
fn on_screen(circle: &Circle, eye: &Eye) -> Ellipse {
    let [u, v] = circle.radii.map(|radius| {
        let [a, b] = [radius, -radius].map(|way| eye.project(circle.centre + way).0);
        0.5 * (a - b)
    });
    // The angle at which the distance from the centre is greatest.
    let turn = 0.5 * (2.0 * u.dot(v)).atan2(u.length_squared() - v.length_squared());
    let (sin, cos) = turn.sin_cos();
    let [axis, other] = [u * cos + v * sin, v * cos - u * sin];
    Ellipse { centre: eye.project(circle.centre).0, axis, minor: other.length() }
}

fn half(value: f32) -> f32 {
    (2.0 * value).round() / 2.0
}
