//! The soft shadow of a mesh on the ground under a uniform sky, sampled at the corners of a grid.
//! Low parts have a dark and narrow shadow, high parts a pale and wide one.

use crate::view::camera::UpAxis;
use glam::{Vec2, Vec3};

/// Number of cells along the longer side of the grid.
const CELLS: f32 = 80.0;
/// Margin of the grid around the mesh, as a fraction of its longer side and of its height.
const BEYOND: f32 = 0.32;
/// Heights at which the narrow and the wide shadow fade to 1/e, relative to the size of the mesh.
const HEIGHTS: [f32; 2] = [0.06, 0.9];
/// Half widths of the box blurs, relative to the longer side of the grid; each is applied 3 times.
const BLURS: [f32; 2] = [0.009, 0.040];
/// Maximum darkness of the narrow and the wide shadow.
const STRENGTHS: [f32; 2] = [0.50, 0.48];
/// Fraction of the area of upright faces that counts, because they block light too.
const UPRIGHT: f32 = 0.25;
/// Maximum number of samples along the side of a triangle.
const MOST_SAMPLES: f32 = 48.0;
/// Cells up to this darkness are not drawn.
const LEAST: f32 = 0.004;

/// The darkness of the ground at the corners of a grid of squares.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GroundShadow {
    /// Side length of a cell.
    pub side: f32,
    /// The corner of the first cell.
    origin: Vec3,
    /// Vectors to the next cell in a row, and to the next row.
    steps: [Vec3; 2],
    /// Corners per row.
    width: usize,
    /// Row by row, from 0 to 1.
    dark: Vec<f32>,
}

impl GroundShadow {
    /// Computes the shadow of a mesh with `positions` (#V), `triangles` (#T) and the given up axis on
    /// the ground at the height `floor`. It has no cells if the mesh has no horizontal extent.
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]], floor: f32, up: UpAxis) -> GroundShadow {
        let corners = || triangles.iter().flatten().map(|&vertex| positions[vertex as usize]);
        let (Some(low), Some(high)) = (corners().reduce(Vec3::min), corners().reduce(Vec3::max))
        else {
            return GroundShadow::default();
        };
        let [_, _, sky] = up.axes();
        let axes = match up {
            UpAxis::Z => [Vec3::X, Vec3::Y],
            UpAxis::Y => [Vec3::X, Vec3::Z],
        };
        let flat = |point: Vec3| Vec2::new(point.dot(axes[0]), point.dot(axes[1]));
        let (from, to) = (flat(low), flat(high));
        let longer = (to - from).max_element();
        let height = (high - low).dot(sky);
        if !(longer > 0.0 && longer.is_finite() && height.is_finite()) {
            return GroundShadow::default();
        }
        let margin = BEYOND * longer + BEYOND * height.min(longer);
        let from = from - margin;
        let side = (longer + 2.0 * margin) / CELLS;
        let count = ((to + margin - from) / side).ceil() + 1.0;
        let (width, rows) = (count.x as usize, count.y as usize);
        let size = (high - low).length();

        let mut layers = [vec![0.0_f32; width * rows], vec![0.0_f32; width * rows]];
        for triangle in triangles {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            let normal = (b - a).cross(c - a) * 0.5;
            let below = normal.dot(sky).abs();
            let area = below + UPRIGHT * (normal.length() - below);
            let longest = [flat(b - a), flat(c - b), flat(a - c)].map(Vec2::length);
            let longest = longest.into_iter().fold(0.0, f32::max);
            let samples = (longest / side).ceil().clamp(1.0, MOST_SAMPLES);
            let weight = area / (samples * samples * side * side);
            for [s, t] in samples_of_triangle(samples as u32) {
                let at = a + (b - a) * s + (c - a) * t;
                let lifted = (at.dot(sky) - floor) / size;
                let place = (flat(at) - from) / side;
                for (layer, high) in layers.iter_mut().zip(HEIGHTS) {
                    splat(layer, width, place, weight * (-lifted / high).exp());
                }
            }
        }
        for (layer, part) in layers.iter_mut().zip(BLURS) {
            layer.iter_mut().for_each(|dark| *dark = dark.min(1.0));
            let reach = ((part * CELLS).round() as usize).max(1);
            for _ in 0..3 {
                blur(layer, width, 1, reach);
                blur(layer, width, width, reach);
            }
        }
        let [near, far] = STRENGTHS;
        let dark = layers[0].iter().zip(&layers[1]);
        GroundShadow {
            side,
            origin: axes[0] * from.x + axes[1] * from.y + sky * floor,
            steps: axes.map(|axis| axis * side),
            width,
            dark: dark.map(|(a, b)| 1.0 - (1.0 - near * a) * (1.0 - far * b)).collect(),
        }
    }

    /// Returns the visible cells: first corner, and darkness at the four corners, row by row.
    pub fn cells(&self) -> impl Iterator<Item = (Vec3, [f32; 4])> + '_ {
        let rows = self.dark.len().checked_div(self.width).unwrap_or(0);
        let [right, away] = self.steps;
        (1..rows)
            .flat_map(move |row| (1..self.width).map(move |column| (row - 1, column - 1)))
            .filter_map(move |(row, column)| {
                let first = row * self.width + column;
                let dark = [first, first + 1, first + self.width, first + self.width + 1];
                let dark = dark.map(|corner| self.dark[corner]);
                let corner = self.origin + right * column as f32 + away * row as f32;
                dark.iter().any(|&part| part > LEAST).then_some((corner, dark))
            })
    }
}

/// Returns the centroids of the `count`² subtriangles of a triangle, in coordinates of two sides.
fn samples_of_triangle(count: u32) -> impl Iterator<Item = [f32; 2]> {
    let part = 1.0 / (3.0 * count as f32);
    (0..count).flat_map(move |i| (0..count - i).map(move |j| (i, j))).flat_map(move |(i, j)| {
        let [s, t] = [i, j].map(|at| (3 * at + 1) as f32 * part);
        let turned = (i + j + 1 < count).then_some([s + part, t + part]);
        [Some([s, t]), turned].into_iter().flatten()
    })
}

/// Adds a weight to the four corners around a point, by bilinear interpolation.
fn splat(layer: &mut [f32], width: usize, place: Vec2, weight: f32) {
    let cell = place.floor();
    let part = place - cell;
    let first = cell.y as usize * width + cell.x as usize;
    for (corner, share) in [
        (first, (1.0 - part.x) * (1.0 - part.y)),
        (first + 1, part.x * (1.0 - part.y)),
        (first + width, (1.0 - part.x) * part.y),
        (first + width + 1, part.x * part.y),
    ] {
        if let Some(dark) = layer.get_mut(corner) {
            *dark += weight * share;
        }
    }
}

/// Replaces each value by the mean over `reach` neighbours on both sides along rows (`step` 1) or
/// columns (`step` the width); values outside the grid are 0.
fn blur(layer: &mut [f32], width: usize, step: usize, reach: usize) {
    let (lines, length, between) = if step == 1 {
        (layer.len() / width, width, width)
    } else {
        (width, layer.len() / width, 1)
    };
    let share = 1.0 / (2 * reach + 1) as f32;
    let mut line = vec![0.0; length];
    for start in (0..lines).map(|i| i * between) {
        for (i, value) in line.iter_mut().enumerate() {
            *value = layer[start + i * step];
        }
        let mut sum: f32 = line.iter().take(reach).sum();
        for i in 0..length {
            sum += line.get(i + reach).copied().unwrap_or(0.0);
            layer[start + i * step] = (sum * share).max(0.0);
            sum -= if i >= reach { line[i - reach] } else { 0.0 };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square plate of the given side and height, above a tiny triangle that marks the ground.
    fn plate(side: f32, height: f32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let corner = |x: f32, y: f32| Vec3::new(x * side, y * side, height);
        let mut points = vec![corner(0., 0.), corner(1., 0.), corner(1., 1.), corner(0., 1.)];
        points.extend([Vec3::ZERO, Vec3::X * 1e-4, Vec3::Y * 1e-4]);
        (points, vec![[0, 1, 2], [0, 2, 3], [4, 5, 6]])
    }

    fn darkest(shadow: &GroundShadow) -> f32 {
        shadow.cells().flat_map(|(_, dark)| dark).fold(0.0, f32::max)
    }

    #[test]
    fn it_is_below_the_mesh_pale_around_it_and_gone_at_the_end_of_the_grid() {
        let (points, triangles) = plate(4.0, 0.02);
        let shadow = GroundShadow::new(&points, &triangles, 0.0, UpAxis::Z);
        let middle = Vec3::new(2.0, 2.0, 0.0);
        let dark_at = |place: Vec3| {
            let near = |(at, _): &(Vec3, [f32; 4])| {
                let away = place - *at;
                (0.0..shadow.side).contains(&away.x) && (0.0..shadow.side).contains(&away.y)
            };
            shadow.cells().find(near).map_or(0.0, |(_, dark)| dark[0])
        };
        assert!(dark_at(middle) > 0.65);
        let beside = dark_at(Vec3::new(2.0, -0.25, 0.0));
        assert!(beside > 0.02 && beside < 0.5 * dark_at(middle), "{beside}");
        assert!(dark_at(Vec3::new(2.0, -1.2, 0.0)) < 0.02);
        assert!(shadow.cells().all(|(at, _)| at.z == 0.0));
    }

    #[test]
    fn what_is_higher_has_a_paler_shadow() {
        let darkness = [0.02, 0.5, 2.0, 6.0].map(|height| {
            let (points, triangles) = plate(4.0, height);
            darkest(&GroundShadow::new(&points, &triangles, 0.0, UpAxis::Z))
        });
        assert!(darkness.windows(2).all(|pair| pair[1] < pair[0]), "{darkness:?}");
        assert!(darkness[3] > 0.02);
    }

    #[test]
    fn it_does_not_depend_on_how_finely_a_plate_is_divided() {
        let (points, triangles) = plate(4.0, 0.3);
        let whole = GroundShadow::new(&points, &triangles, 0.0, UpAxis::Z);
        let mut fine = points.clone();
        let mut pieces = vec![[4, 5, 6]];
        for (x, y) in (0..20).flat_map(|x| (0..20).map(move |y| (x, y))) {
            let first = fine.len() as u32;
            for (u, v) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
                fine.push(Vec3::new(0.2 * (x + u) as f32, 0.2 * (y + v) as f32, 0.3));
            }
            pieces.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
        let divided = GroundShadow::new(&fine, &pieces, 0.0, UpAxis::Z);
        assert_eq!(whole.dark.len(), divided.dark.len());
        for (a, b) in whole.dark.iter().zip(&divided.dark) {
            assert!((a - b).abs() < 0.05, "{a} {b}");
        }
    }

    #[test]
    fn with_y_up_it_is_the_same_on_the_other_ground() {
        let (points, triangles) = plate(4.0, 0.5);
        let turned: Vec<Vec3> = points.iter().map(|p| Vec3::new(p.x, p.z, p.y)).collect();
        let [z, y] = [(&points, UpAxis::Z), (&turned, UpAxis::Y)]
            .map(|(points, up)| GroundShadow::new(points, &triangles, 0.0, up));
        assert_eq!(z.dark, y.dark);
        assert!(y.cells().all(|(at, _)| at.y == 0.0));
    }

    #[test]
    fn without_faces_or_extent_there_is_none() {
        assert_eq!(GroundShadow::new(&[], &[], 0.0, UpAxis::Z), GroundShadow::default());
        let point = [Vec3::ONE; 3];
        assert_eq!(GroundShadow::new(&point, &[[0, 1, 2]], 0.0, UpAxis::Z).cells().count(), 0);
    }
}
