//! What generators of any kind do with a mesh: even it out, edit it, open it, and round its coordinates; and
//! random numbers, the same on every machine.

use crate::math::{Vec3, mean};
use crate::mesh::{Mesh, MeshOperation, Point, Task, Topology};

/// Smooths a surface: in each step every vertex moves halfway to the mean of its neighbours.
pub(super) fn soften(mesh: &mut Mesh, steps: usize) {
    let topology = Topology::new(mesh);
    for _ in 0..steps {
        mesh.positions = halfway(mesh, &topology).into_iter().map(Into::into).collect();
    }
}

/// Evens out the triangles of the surface where `field` is zero: in each step every vertex moves
/// along the surface, halfway to the centre of the triangles around it, and is then projected back.
/// `spacing` is the step of the finite differences for the gradient.
pub(super) fn slide(mesh: &mut Mesh, field: impl Fn(Point) -> f64, spacing: f64, steps: usize) {
    for _ in 0..steps {
        let towards = centres(mesh);
        for (p, to) in mesh.positions.iter_mut().zip(towards) {
            let from = Vec3::from(*p);
            let normal = gradient(&field, *p, spacing);
            let length = normal.length_squared();
            let step = to - from;
            let along = step - normal * (step.dot(normal) / length);
            let moved = from + along;
            *p = (moved - normal * (field(moved.into()) / length)).into();
        }
    }
}

fn halfway(mesh: &Mesh, topology: &Topology) -> Vec<Vec3<f64>> {
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let rows = (0..).zip(topology.neighbours().iter());
    rows.map(|(v, neighbours)| {
        let sum = neighbours.iter().fold(Vec3::zero(), |sum, &n| sum + at(n));
        (at(v) + sum * (1.0 / neighbours.len() as f64)) * 0.5
    })
    .collect()
}

/// For each vertex the midpoint between it and the area-weighted centre of the triangles around it.
fn centres(mesh: &Mesh) -> Vec<Vec3<f64>> {
    let mut sums = vec![(Vec3::zero(), 0.0); mesh.positions.len()];
    for face in mesh.faces.iter() {
        let [a, b, c] = [0, 1, 2].map(|k| Vec3::from(mesh.positions[face[k] as usize]));
        let area = (b - a).cross(c - a).length();
        for &v in face {
            sums[v as usize].0 += (a + b + c) * (area / 3.0);
            sums[v as usize].1 += area;
        }
    }
    let pairs = mesh.positions.iter().zip(sums);
    pairs.map(|(&p, (sum, area))| (Vec3::from(p) + sum * (1.0 / area)) * 0.5).collect()
}

/// Gradient by central differences.
fn gradient(field: impl Fn(Point) -> f64, p: Point, step: f64) -> Vec3<f64> {
    let along = |axis: usize| {
        let (mut low, mut high) = (p, p);
        low[axis] -= 0.5 * step;
        high[axis] += 0.5 * step;
        (field(high) - field(low)) / step
    };
    Vec3::new(along(0), along(1), along(2))
}

/// The mesh after an operation on `faces`, which the generator knows to be possible. Some operations act
/// on all faces if there are none, others are refused.
pub(super) fn edited(mesh: &Mesh, operation: &str, sizes: &[f64], faces: &[u32]) -> Mesh {
    let (rest, topology) = (&mesh.positions, &Topology::new(mesh));
    let task = Task { mesh, rest, topology, up: [0.0, 0.0, 1.0], sizes, vertices: &[], faces };
    let edited = MeshOperation::of(operation).and_then(|operation| operation.apply(&task));
    edited.expect("the operation fits the mesh").mesh
}

/// The mesh without the faces for whose centroid `is_open` is true, and without the vertices then
/// unused; the rest keeps its order.
pub(super) fn opened(mesh: &Mesh, is_open: impl Fn(Point) -> bool) -> Mesh {
    let middle = |face: &[u32]| mean(face.iter().map(|&v| mesh.positions[v as usize].into()));
    let is_open = |(_, face): &(u32, &[u32])| is_open(middle(face).into());
    let open: Vec<u32> = (0..).zip(mesh.faces.iter()).filter(is_open).map(|(f, _)| f).collect();
    if open.is_empty() { mesh.clone() } else { edited(mesh, "delete", &[], &open) }
}

/// Rounds coordinates to tenths of a millimetre, so that the file is short.
pub(super) fn rounded(mut mesh: Mesh) -> Mesh {
    for x in mesh.positions.as_flattened_mut() {
        *x = (*x * 1e4).round() / 1e4;
    }
    mesh
}

/// Pseudo-random numbers from -1 to 1: the upper half of a linear congruential generator with
/// Knuth's MMIX multiplier.
pub(crate) struct Noise {
    /// State, initially the seed.
    pub(crate) state: u64,
}

impl Noise {
    /// The next number.
    pub(crate) fn next(&mut self) -> f64 {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        const INCREMENT: u64 = 1_442_695_040_888_963_407;
        self.state = self.state.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        (self.state >> 32) as f64 / f64::from(u32::MAX) * 2.0 - 1.0
    }
}
