//! A depth buffer made on the CPU, with the nearest depth and its face per pixel. It decides
//! visibility for box selections and line drawings, for which a ray per point would be too slow.

use crate::view::camera::section::clipped;
use crate::view::camera::{Camera, Eye};
use crate::view::model::RenderMesh;
use glam::{Vec2, Vec3};

/// Pixels along the longer side of the canvas, for selection.
pub const COARSE: f32 = 512.0;
/// A point farther away than the surface by up to this fraction of its depth still counts as on it.
const TOLERANCE: f32 = 4e-3;
/// The same for sides of faces, whose own faces need no tolerance.
const TOLERANCE_OF_SIDES: f32 = 5e-4;
/// A surface behind a line by more than this fraction of its depth does not continue the line's.
const BEHIND: f32 = 2e-2;
const NONE: u32 = u32::MAX;

/// The nearest depth and its face per pixel.
#[derive(Clone, Debug)]
pub struct DepthMap {
    width: usize,
    height: usize,
    /// Pixels per CSS pixel.
    scale: f32,
    /// Nearness, which grows towards the eye and is linear on the screen: 1 / depth in perspective,
    /// minus the depth in parallel projection. Minus infinity on empty pixels.
    nearness: Vec<f32>,
    faces: Vec<u32>,
    /// [`Eye::parallel`].
    parallel: Option<f32>,
}

impl DepthMap {
    /// Draws all triangles as the camera sees them, with this many pixels on the longer side.
    pub fn new(mesh: &RenderMesh, camera: &Camera, longer_side: f32) -> DepthMap {
        let scale = longer_side / camera.canvas.max_element().max(1.0);
        let size = (camera.canvas * scale).ceil().max(Vec2::ONE);
        let (width, height) = (size.x as usize, size.y as usize);
        let mut map = DepthMap {
            width,
            height,
            scale,
            nearness: vec![f32::NEG_INFINITY; width * height],
            faces: vec![NONE; width * height],
            parallel: camera.eye().parallel,
        };
        let eye = camera.eye();
        for (triangle, &face) in mesh.triangles.iter().zip(&mesh.triangle_face) {
            let corners = triangle.map(|v| mesh.positions[v as usize]);
            map.draw_clipped(camera, &eye, corners, face);
        }
        map
    }

    /// Clips a triangle at the near depth and at the section, and draws the rest.
    fn draw_clipped(&mut self, camera: &Camera, eye: &Eye, corners: [Vec3; 3], face: u32) {
        let near = camera.distance * 1e-3;
        let beyond_near = |point: Vec3| (point - eye.at).dot(eye.forward) - near;
        if corners.iter().all(|&p| beyond_near(p) >= 0.0 && camera.keeps(p)) {
            self.draw(corners.map(|p| self.pixel(eye, p)), face);
            return;
        }
        let mut kept = clipped(&corners, beyond_near);
        if let Some(section) = camera.section {
            kept = clipped(&kept, |point| section.within(point));
        }
        for i in 2..kept.len() {
            self.draw([kept[0], kept[i - 1], kept[i]].map(|p| self.pixel(eye, p)), face);
        }
    }

    /// Returns the pixel position, with the nearness as third coordinate.
    fn pixel(&self, eye: &Eye, point: Vec3) -> Vec3 {
        let (screen, depth) = eye.project(point);
        let nearness = if self.parallel.is_some() { -depth } else { 1.0 / depth };
        (screen * self.scale).extend(nearness)
    }

    fn draw(&mut self, [a, b, c]: [Vec3; 3], face: u32) {
        let low = a.min(b).min(c);
        let high = a.max(b).max(c);
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        if area == 0.0 || !area.is_finite() {
            return;
        }
        // Pixel centres are at half-integers. The casts saturate, which clamps to the border.
        let range = |low: f32, high: f32, count: usize| {
            ((low - 0.5).ceil().max(0.0) as usize)
                ..((high + 0.5).floor().max(0.0) as usize).min(count)
        };
        for y in range(low.y, high.y, self.height) {
            for x in range(low.x, high.x, self.width) {
                let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let weight = |from: Vec3, to: Vec3| {
                    (to - from).truncate().perp_dot(p - from.truncate()) / area
                };
                let (at_c, at_a, at_b) = (weight(a, b), weight(b, c), weight(c, a));
                if at_a < 0.0 || at_b < 0.0 || at_c < 0.0 {
                    continue;
                }
                let nearness = at_a * a.z + at_b * b.z + at_c * c.z;
                let pixel = y * self.width + x;
                if nearness > self.nearness[pixel] {
                    self.nearness[pixel] = nearness;
                    self.faces[pixel] = face;
                }
            }
        }
    }

    /// Returns whether a point of the surface is in front at its pixel or a neighbour. Neighbours
    /// count so that points on the outline are visible.
    pub fn shows(&self, screen: Vec2, depth: f32) -> bool {
        let nearness = self.nearness_of(depth, TOLERANCE);
        self.around(screen, |pixel| self.nearness[pixel] <= nearness)
    }

    /// Returns whether a point of a line is in front at its pixel, or one of the `faces` with the
    /// line as a side is in front at its pixel or a neighbour.
    pub fn shows_line(&self, screen: Vec2, depth: f32, faces: &[u32]) -> bool {
        let tolerance = if faces.is_empty() { TOLERANCE } else { TOLERANCE_OF_SIDES };
        self.nearness[self.pixel_at(screen, 0, 0)] <= self.nearness_of(depth, tolerance)
            || self.around(screen, |pixel| faces.contains(&self.faces[pixel]))
    }

    /// Returns whether, at the pixel of a point or a neighbour, there is nothing or a surface much
    /// farther away that is none of `faces`.
    pub fn ends_at(&self, screen: Vec2, depth: f32, faces: &[u32]) -> bool {
        let behind = self.nearness_of(depth, -BEHIND);
        self.around(screen, |pixel| {
            self.nearness[pixel] < behind && !faces.contains(&self.faces[pixel])
        })
    }

    /// Returns the nearness above which a sample hides a point at this depth.
    fn nearness_of(&self, depth: f32, tolerance: f32) -> f32 {
        match self.parallel {
            None => (1.0 + tolerance) / depth,
            Some(scale) => tolerance * scale - depth,
        }
    }

    /// Returns whether `is_so` holds for the pixel at a position or one of its neighbours.
    fn around(&self, screen: Vec2, is_so: impl Fn(usize) -> bool) -> bool {
        (-1..=1).any(|dy| (-1..=1).any(|dx| is_so(self.pixel_at(screen, dx, dy))))
    }

    /// Returns the pixel at a position, offset by `dx` and `dy` and clamped to the border.
    fn pixel_at(&self, screen: Vec2, dx: i64, dy: i64) -> usize {
        let at = (screen * self.scale).floor();
        let x = (at.x as i64 + dx).clamp(0, self.width as i64 - 1) as usize;
        let y = (at.y as i64 + dy).clamp(0, self.height as i64 - 1) as usize;
        y * self.width + x
    }

    /// Returns for each face whether it is in front at some pixel.
    pub fn faces_in_front(&self, count: usize) -> Vec<bool> {
        let mut seen = vec![false; count];
        for &face in self.faces.iter().filter(|&&f| f != NONE) {
            seen[face as usize] = true;
        }
        seen
    }
}
