//! The cross field: one cross in each triangle, smooth, along features, and along the lines of
//! curvature as far as the curvature says.
//!
//! A cross at angle theta is `u = e^(4 i theta)` in the frame of its triangle. It minimises
//! `|grad u|^2 + lambda (k1 - k2)^2 |u - q|^2` with the principal crosses q (Knoeppel, Crane, Pinkall
//! and Schroeder 2013), whose two terms are the swirl of the panels and their twist; h, the side of
//! a panel, cancels. Then it is normalised and smoothed in turns (Merriman-Bence-Osher steps; Viertel
//! and Osting 2019), which cancels pairs of singularities that are near to each other.

use super::frames::{Complex, Frames, unit};
use crate::quads::surface::Prepared;
use crate::quads::system::SymmetricSystem;
use crate::quads::{MapFault, Side, Triangulation};

/// Number of smoothing steps.
const STEPS: usize = 15;
/// Number of inverse iterations where nothing directs the field.
const INVERSE_ITERATIONS: usize = 30;

/// What steers a field. The levels of a retry take less and less of the curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Steering {
    /// Weight lambda of alignment with curvature.
    pub follow: f64,
    /// Length over which curvature is smoothed, in panels.
    pub smoothing: f64,
    /// Time of a smoothing step, in squared panels.
    pub step: f64,
}

/// The connection Laplacian of complex numbers in triangles, as a real system of pairs.
struct Connection {
    system: SymmetricSystem,
    /// For each inner side off the features, from the lower triangle: places of the four entries
    /// `[re re, re im, im re, im im]`, row of the neighbour.
    places: Vec<(Side, Side, f64, [usize; 4])>,
    /// Places of the two diagonal entries of each triangle.
    diagonal: Vec<[usize; 2]>,
}

impl Connection {
    fn new(surface: &Triangulation, frames: &Frames) -> Connection {
        let inner = |side: &Side| {
            let back = surface.across(*side)?;
            let own = side.triangle < back.triangle && !surface.is_feature(*side);
            own.then_some((*side, back))
        };
        let sides: Vec<(Side, Side)> = surface.sides().filter_map(|side| inner(&side)).collect();
        let n = surface.triangles.len();
        let couple = |&(side, back): &(Side, Side)| {
            let [f, g] = [side, back].map(|side| 2 * side.triangle as u32);
            [[g, f], [g, f + 1], [g + 1, f], [g + 1, f + 1]]
        };
        let own = (0..n as u32).map(|f| [2 * f, 2 * f + 1]);
        let pairs = sides.iter().flat_map(couple).chain(own).collect();
        let system = SymmetricSystem::new(2 * n, pairs);
        let place = |(side, back): (Side, Side)| {
            let weight = 3.0 * surface.along(side).length_squared()
                / (frames.area[side.triangle] + frames.area[back.triangle]);
            let [f, g] = [2 * side.triangle, 2 * back.triangle];
            let places = [[g, f], [g, f + 1], [g + 1, f], [g + 1, f + 1]];
            (side, back, weight, places.map(|[i, j]| system.place(i, j)))
        };
        let places = sides.into_iter().map(place).collect();
        let diagonal = (0..n).map(|f| [2 * f, 2 * f + 1].map(|i| system.diagonal(i))).collect();
        Connection { system, places, diagonal }
    }

    /// Sets the matrix: the Laplacian of `power`-th powers times `times`, and `extra` on the diagonal
    /// of each triangle.
    fn set(&mut self, frames: &Frames, power: u32, times: f64, extra: impl Fn(usize) -> f64) {
        let Connection { system, places, diagonal } = self;
        let values = system.values();
        values.fill(0.0);
        for (f, both) in diagonal.iter().enumerate() {
            both.iter().for_each(|&place| values[place] = extra(f));
        }
        for &(side, back, weight, entries) in places.iter() {
            let weight = times * weight;
            let Complex { re, im } = frames.transport(side, back, power) * -weight;
            for (place, value) in entries.into_iter().zip([re, -im, im, re]) {
                values[place] += value;
            }
            for triangle in [side.triangle, back.triangle] {
                diagonal[triangle].iter().for_each(|&place| values[place] += weight);
            }
        }
    }

    fn factor(&mut self, given: &[bool]) -> Result<(), MapFault> {
        let pairs: Vec<bool> = given.iter().flat_map(|&given| [given; 2]).collect();
        self.system.factor(&pairs)
    }

    /// Solves in place; where values are given, `right` has them.
    fn solve(&mut self, right: &mut [Complex]) {
        let mut x: Vec<[f64; 1]> = right.iter().flat_map(|z| [[z.re], [z.im]]).collect();
        self.system.solve(&mut x);
        let pairs = x.chunks_exact(2).map(|pair| Complex::new(pair[0][0], pair[1][0]));
        right.iter_mut().zip(pairs).for_each(|(to, z)| *to = z);
    }
}

/// A field: the cross of each triangle, and the curvature that steered it.
pub(crate) struct Cross {
    /// `e^(4 i theta)`, `#T`.
    pub crosses: Vec<Complex>,
    /// The smoothed `(k1 - k2)/2 e^(2 i theta)`, `#T`.
    pub anisotropy: Vec<Complex>,
}

/// Computes the field.
///
/// # Errors
/// If a matrix is singular.
pub(crate) fn cross_field(
    prepared: &Prepared,
    frames: &Frames,
    steering: Steering,
) -> Result<Cross, MapFault> {
    let surface = &prepared.surface;
    let h = prepared.size;
    let n = surface.triangles.len();
    let mut connection = Connection::new(surface, frames);
    // Details below a panel do not steer: one implicit step of diffusion.
    let time = steering.smoothing * steering.smoothing * h * h;
    let mut anisotropy = frames.anisotropy(prepared);
    connection.set(frames, 2, time, |f| frames.area[f]);
    connection.factor(&vec![false; n])?;
    for (z, area) in anisotropy.iter_mut().zip(&frames.area) {
        *z *= *area;
    }
    connection.solve(&mut anisotropy);
    let given = given(prepared, frames);
    let is_given: Vec<bool> = given.iter().map(Option::is_some).collect();
    let weight: Vec<f64> = anisotropy
        .iter()
        .zip(&frames.area)
        .map(|(&z, area)| {
            let difference = (2.0 * z.norm_sqr().sqrt()).min(1.0 / h);
            steering.follow * area * difference * difference
        })
        .collect();
    let pull: Vec<Complex> = anisotropy
        .iter()
        .zip(&weight)
        .map(|(&z, &weight)| unit(z).map_or(Complex::default(), |z| z * z * weight))
        .collect();
    let right = |f: usize| given[f].unwrap_or(pull[f]);
    let directs =
        |f: usize| is_given[f] || pull[f].norm_sqr().sqrt() > 1e-9 * frames.area[f] / (h * h);
    let mut crosses: Vec<Complex>;
    // A trace of mass keeps the matrix regular where neither feature nor curvature holds the field.
    let trace = |f: usize| 1e-7 * frames.area[f] / (h * h);
    connection.set(frames, 4, 1.0, |f| weight[f] + trace(f));
    connection.factor(&is_given)?;
    if (0..n).any(directs) {
        crosses = (0..n).map(right).collect();
        connection.solve(&mut crosses);
    } else {
        crosses = vec![Complex::new(1.0, 0.0); n];
        for _ in 0..INVERSE_ITERATIONS {
            let norm = crosses.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
            for (z, area) in crosses.iter_mut().zip(&frames.area) {
                *z = *z * *area / norm;
            }
            connection.solve(&mut crosses);
        }
    }
    let mut before = vec![Complex::new(1.0, 0.0); n];
    normalise(&mut crosses, &before);
    let rate = 1.0 / (steering.step * h * h);
    connection.set(frames, 4, 1.0, |f| weight[f] + trace(f) + rate * frames.area[f]);
    connection.factor(&is_given)?;
    for _ in 0..STEPS {
        before.copy_from_slice(&crosses);
        for f in 0..n {
            let mass = rate * frames.area[f];
            crosses[f] = given[f].unwrap_or(pull[f] + before[f] * mass);
        }
        connection.solve(&mut crosses);
        normalise(&mut crosses, &before);
    }
    Ok(Cross { crosses, anisotropy })
}

/// The crosses that features and wedges give, `#T`; those of wedges where both do.
fn given(prepared: &Prepared, frames: &Frames) -> Vec<Option<Complex>> {
    let surface = &prepared.surface;
    let cross = |direction: Complex| (direction * direction) * (direction * direction);
    let of_triangle = |triangle: usize| {
        let wedge = prepared.wedges[triangle].and_then(|d| unit(frames.of(triangle, d)));
        let mut sides = (0..3).map(|side| Side { triangle, side });
        let feature = sides.find(|&side| surface.is_feature(side));
        wedge.or(feature.map(|side| frames.tangent(prepared, side))).map(cross)
    };
    (0..surface.triangles.len()).map(of_triangle).collect()
}

/// Scales to absolute value one; a zero keeps the value before.
fn normalise(crosses: &mut [Complex], before: &[Complex]) {
    for (cross, &before) in crosses.iter_mut().zip(before) {
        *cross = unit(*cross).unwrap_or(before);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Vec3, cosine, sine};
    use crate::mesh::Mesh;
    use crate::quads::{Boundary, InputSurface, MapOptions, PanelSize};

    /// A square sheet of triangles in space, prepared for panels of a fifth of its side.
    fn sheet(boundary: Boundary, at: impl Fn(f64, f64) -> [f64; 3]) -> Prepared {
        let n = 20;
        let mut mesh = Mesh::default();
        for (j, i) in (0..=n).flat_map(|j| (0..=n).map(move |i| (j, i))) {
            mesh.positions.push(at(f64::from(i) / f64::from(n), f64::from(j) / f64::from(n)));
        }
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            let [a, b] = [j * (n + 1) + i, (j + 1) * (n + 1) + i];
            mesh.faces.push(&[a, a + 1, b + 1]);
            mesh.faces.push(&[a, b + 1, b]);
        }
        let parts = InputSurface::parts(&mesh, &[]).unwrap().surfaces;
        let options = MapOptions { boundary, ..MapOptions::of_size(PanelSize::Length(0.2)) };
        parts[0].prepare(2.0, 0.2, &options).unwrap()
    }

    /// The largest difference of a cross from those along `direction`.
    fn largest_difference(prepared: &Prepared, follow: f64, direction: Vec3<f64>) -> f64 {
        let frames = Frames::new(&prepared.surface);
        let steering = Steering { follow, smoothing: 0.5, step: 1.0 };
        let found = cross_field(prepared, &frames, steering).unwrap();
        let difference = |(t, &cross): (usize, &Complex)| {
            let along = unit(frames.of(t, direction)).unwrap();
            (cross - along * along * along * along).norm_sqr().sqrt()
        };
        found.crosses.iter().enumerate().map(difference).fold(0.0, f64::max)
    }

    #[test]
    fn crosses_follow_the_rulings_of_a_cylinder_across_a_cut_boundary() {
        // A sheet at 20 degrees to the rulings, which are along z.
        let [c, s] = [cosine(20.0 / 360.0), sine(20.0 / 360.0)];
        let cylinder = |u: f64, v: f64| {
            let (x, z) = (c * u - s * v, s * u + c * v);
            [cosine(x / 6.0), sine(x / 6.0), z]
        };
        let axis = Vec3::new(0.0, 0.0, 1.0);
        assert!(largest_difference(&sheet(Boundary::Cut, cylinder), 20.0, axis) < 0.02);
        // Followed, the boundary gives the direction.
        assert!(largest_difference(&sheet(Boundary::Followed, cylinder), 20.0, axis) > 1.0);
    }

    #[test]
    fn crosses_of_a_flat_square_are_parallel_to_its_sides() {
        let flat = |u: f64, v: f64| [0.6 * u - 0.8 * v, 0.8 * u + 0.6 * v, 0.0];
        let side = Vec3::new(0.6, 0.8, 0.0);
        for follow in [0.0, 20.0] {
            assert!(largest_difference(&sheet(Boundary::Followed, flat), follow, side) < 1e-9);
        }
    }
}
