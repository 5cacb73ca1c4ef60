//! One face of a conformal map: its shape in its own plane, and its part of the energy of Eq. 14.

use super::super::assemble::Terms;
use super::super::energy::BIG;
use crate::math::{PrincipalAxes, Vec3, centre};
use crate::mesh::Point;

/// The weights `w_i` of Eq. 14.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum ConformalWeights {
    /// The inverse area of the polygon, so that the map does not depend on the meshing.
    #[default]
    InverseArea,
    /// `w_i = 1`.
    One,
    /// `|z|^2 / area`: on triangles these give least-squares conformal maps.
    Lscm,
}

/// A face that is thinner than this fraction of the size of the mesh has an area only by rounding.
const ROUNDING: f64 = 1e-12;

/// A face in its own plane.
pub(super) struct Face {
    /// Corners, as vertex numbers of the part.
    pub(super) corners: Vec<u32>,
    /// The corners in the least-squares plane, centred, counterclockwise in the order of the face.
    flat: Vec<[f64; 2]>,
    /// Area on the surface, positive.
    pub(super) area: f64,
    /// `|z|^2`.
    squares: f64,
}

impl Face {
    /// Returns the face of these `vertices`, without corners yet, or `None` if it has no area in a
    /// mesh of this `diameter`, and thus no shape to keep.
    pub(super) fn new(vertices: &[u32], positions: &[Point], diameter: f64) -> Option<Face> {
        let mut points: Vec<Vec3<f64>> =
            vertices.iter().map(|&v| positions[v as usize].into()).collect();
        centre(&mut points);
        let mut flat = match points[..] {
            [a, b, c] => flat_triangle(a, b, c),
            _ => flat_polygon(points),
        };
        let n = flat.len();
        let cross = |k: usize| {
            let ([a, b], [c, d]) = (flat[k], flat[(k + 1) % n]);
            a * d - b * c
        };
        let area = 0.5 * (0..n).map(cross).sum::<f64>();
        if area < 0.0 {
            // The axes are of either handedness.
            flat.iter_mut().for_each(|[_, y]| *y = -*y);
        }
        let squares: f64 = flat.iter().map(|[x, y]| x * x + y * y).sum();
        let area = area.abs();
        // Written so that NaN has no area.
        let has_area = area > ROUNDING * diameter * squares.sqrt();
        has_area.then_some(Face { corners: Vec::new(), flat, area, squares })
    }

    /// `w_i` of Eq. 14.
    pub(super) fn weight(&self, weights: ConformalWeights) -> f64 {
        match weights {
            ConformalWeights::InverseArea => 1.0 / self.area,
            ConformalWeights::One => 1.0,
            ConformalWeights::Lscm => self.squares / self.area,
        }
    }

    /// `|N u - P u|^2` of the map `u`.
    pub(super) fn distance(&self, u: &[[f64; 2]]) -> f64 {
        let n = self.corners.len() as f64;
        let mut mean = [0.0; 2];
        for &v in &self.corners {
            mean = [mean[0] + u[v as usize][0] / n, mean[1] + u[v as usize][1] / n];
        }
        let own =
            || self.corners.iter().map(|&v| u[v as usize]).map(|[x, y]| [x - mean[0], y - mean[1]]);
        // z* u / |z|^2, the factor of the closest multiple of z.
        let (mut real, mut imaginary) = (0.0, 0.0);
        for ([x, y], [a, b]) in own().zip(&self.flat) {
            real += (a * x + b * y) / self.squares;
            imaginary += (a * y - b * x) / self.squares;
        }
        own()
            .zip(&self.flat)
            .map(|([x, y], [a, b])| {
                let (dx, dy) = (x - (real * a - imaginary * b), y - (real * b + imaginary * a));
                dx * dx + dy * dy
            })
            .sum()
    }

    /// The signed area in the map.
    pub(super) fn area_in(&self, map: &[[f64; 2]]) -> f64 {
        let n = self.corners.len();
        let at = |k: usize| map[self.corners[k % n] as usize];
        let crosses = (0..n).map(|k| at(k)[0] * at(k + 1)[1] - at(k)[1] * at(k + 1)[0]);
        0.5 * crosses.sum::<f64>()
    }

    /// Number of extra complex unknowns: the mean and the factor of a face with many corners, which
    /// would otherwise be a dense block of the matrix.
    pub(super) fn extra_unknowns(&self) -> usize {
        if self.corners.len() > BIG { 2 } else { 0 }
    }

    /// Adds `w (|N u|^2 - |z* u|^2 / |z|^2)`. The complex unknown `k` has the nodes `2 k` and
    /// `2 k + 1`; the extra unknowns are those from `extra` on.
    pub(super) fn push_terms(&self, terms: &mut Terms, weight: f64, extra: u32) {
        match self.corners.len() {
            3 => self.push_triangle(terms, weight),
            n if n > BIG => self.push_big(terms, weight, extra),
            _ => self.push_polygon(terms, weight),
        }
    }

    /// Only one direction is orthogonal to the constants and the multiples of z, so the energy of a
    /// triangle is the square of one complex number: the sum of the u, each times the opposite
    /// side.
    fn push_triangle(&self, terms: &mut Terms, weight: f64) {
        let nodes: Vec<u32> = self.corners.iter().flat_map(|&v| [2 * v, 2 * v + 1]).collect();
        let opposite = || {
            (0..3).map(|k| {
                let ([a, b], [c, d]) = (self.flat[(k + 1) % 3], self.flat[(k + 2) % 3]);
                [c - a, d - b]
            })
        };
        let outer = weight / (3.0 * self.squares);
        terms.push(&nodes, opposite().flat_map(|[a, b]| [a, -b]), 0.0, outer);
        terms.push(&nodes, opposite().flat_map(|[a, b]| [b, a]), 0.0, outer);
    }

    fn push_polygon(&self, terms: &mut Terms, weight: f64) {
        let n = self.corners.len();
        let flat = || self.flat.iter();
        for part in 0..2 {
            let nodes: Vec<u32> = self.corners.iter().map(|&v| 2 * v + part).collect();
            terms.push(&nodes, flat().map(|_| 1.0), weight, -weight / n as f64);
        }
        // The real and the imaginary part of z* u.
        let nodes: Vec<u32> = self.corners.iter().flat_map(|&v| [2 * v, 2 * v + 1]).collect();
        let outer = -weight / self.squares;
        terms.push(&nodes, flat().flat_map(|&[a, b]| [a, b]), 0.0, outer);
        terms.push(&nodes, flat().flat_map(|&[a, b]| [-b, a]), 0.0, outer);
    }

    /// The same energy is the minimum of `w |u - m - c z|^2` over the mean `m` and the factor `c`.
    /// With these as unknowns, each corner is coupled only to them. The factor is for z scaled to
    /// length one on average.
    fn push_big(&self, terms: &mut Terms, weight: f64, extra: u32) {
        let (mean, factor) = (2 * extra, 2 * extra + 2);
        let unit = (self.squares / self.corners.len() as f64).sqrt();
        for (&v, [a, b]) in self.corners.iter().zip(&self.flat) {
            let (a, b) = (a / unit, b / unit);
            let real = [2 * v, mean, factor, factor + 1];
            terms.push(&real, [1.0, -1.0, -a, b], 0.0, weight);
            let imaginary = [2 * v + 1, mean + 1, factor, factor + 1];
            terms.push(&imaginary, [1.0, -1.0, -b, -a], 0.0, weight);
        }
    }
}

/// Centred points in their least-squares plane.
fn flat_polygon(mut points: Vec<Vec3<f64>>) -> Vec<[f64; 2]> {
    let scale = PrincipalAxes::rotate(&mut points).scale;
    points.iter().map(|p| [p.x * scale, p.y * scale]).collect()
}

/// A centred triangle in its own plane, with its first side along the first axis.
fn flat_triangle(a: Vec3<f64>, b: Vec3<f64>, c: Vec3<f64>) -> Vec<[f64; 2]> {
    let (along, across) = (b - a, c - a);
    let base = along.length();
    if base == 0.0 {
        return vec![[0.0; 2]; 3];
    }
    let (foot, height) = (along.dot(across) / base, along.cross(across).length() / base);
    let (x, y) = ((base + foot) / 3.0, height / 3.0);
    vec![[-x, -y], [base - x, -y], [foot - x, height - y]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::System;

    /// A polygon with `n` corners that is not flat.
    fn wavy(n: u32) -> Face {
        let corner = |k: u32| {
            let t = f64::from(k) / f64::from(n);
            // Around a square, with a different bump at every corner.
            let side = |t: f64| (4.0 * t).clamp(1.0, 2.0) - 1.0 - ((4.0 * t).clamp(3.0, 4.0) - 3.0);
            let bump = f64::from((k * k * 7) % 11) / 40.0;
            [side(t) + bump, side((t + 0.25) % 1.0) - bump, bump * bump]
        };
        let positions: Vec<Point> = (0..n).map(corner).collect();
        let vertices: Vec<u32> = (0..n).collect();
        let mut face = Face::new(&vertices, &positions, 2.0).expect("it has an area");
        face.corners = vertices;
        face
    }

    #[test]
    fn extra_unknowns_leave_the_energy_of_the_corners_as_it_is() {
        let face = wavy(BIG as u32 + 9);
        let n = face.corners.len();
        assert_eq!(face.extra_unknowns(), 2);
        let solved = |push: &dyn Fn(&mut Terms), unknowns: usize| {
            let mut terms = Terms::default();
            push(&mut terms);
            let mut system = System::new(2 * unknowns, vec![terms]);
            let node_of = system.node_of().to_vec();
            let (mut diagonal, mut right) = (vec![0.0; 2 * unknowns], vec![[0.0; 4]; 2 * unknowns]);
            for k in 0..2 * n {
                let node = node_of[k] as usize;
                diagonal[node] = 0.1;
                right[node] = [((k * 37) % 17) as f64 - 8.0, 1.0, k as f64, 0.0];
            }
            system.factor(&[1.0], &diagonal, vec![false; 2 * unknowns]).expect("it is definite");
            system.solve(&mut right);
            (0..2 * n).map(|k| right[node_of[k] as usize]).collect::<Vec<_>>()
        };
        let dense = solved(&|terms| face.push_polygon(terms, 3.0), n);
        let sparse = solved(&|terms| face.push_terms(terms, 3.0, n as u32), n + 2);
        for (dense, sparse) in dense.as_flattened().iter().zip(sparse.as_flattened()) {
            assert!((dense - sparse).abs() < 1e-9 * dense.abs().max(1.0), "{dense} {sparse}");
        }
    }
}
