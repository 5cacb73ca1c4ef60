//! Points of a lattice of cubes, and the zero level set of a function of space as triangles: marching
//! tetrahedra on a body-centred cubic lattice, whose tetrahedra are congruent and nearly regular.

use crate::math::Vec3;
use crate::mesh::{Mesh, Point, Ragged};
use std::collections::BTreeMap;

/// Cubes of side `spacing`, `cells` of them along x, y and z, from the corner `lowest`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    /// The lowest corner.
    pub(super) lowest: Point,
    /// Number of cubes along x, y and z.
    pub(super) cells: [u32; 3],
    /// The side of a cube.
    pub(super) spacing: f64,
}

impl Lattice {
    /// The surface where `field` is zero, counterclockwise seen from where it is positive. It is a
    /// closed manifold if `field` is positive along the border of the lattice.
    pub(super) fn polygonise(&self, field: impl Fn(Point) -> f64) -> Mesh {
        let corners = self.cells.map(|n| n + 1);
        let half = 0.5 * self.spacing;
        let at = |cell: [u32; 3], shift: f64| -> Point {
            std::array::from_fn(|i| self.lowest[i] + self.spacing * f64::from(cell[i]) + shift)
        };
        let mut nodes: Vec<Point> = grid_points(corners).map(|cell| at(cell, 0.0)).collect();
        let first_centre = nodes.len() as u32;
        nodes.extend(grid_points(self.cells).map(|cell| at(cell, half)));
        let values: Vec<f64> = nodes.iter().map(|&p| field(p)).collect();

        let corner = |c: [u32; 3]| linear_index(c, corners);
        let centre = |c: [u32; 3]| first_centre + linear_index(c, self.cells);
        let mut surface = Triangles { nodes: &nodes, values: &values, ..Triangles::default() };
        for cell in grid_points(self.cells) {
            for axis in 0..3 {
                let mut beside = cell;
                beside[axis] += 1;
                if beside[axis] == self.cells[axis] {
                    continue;
                }
                // One tetrahedron for each side of the square between the two cubes.
                let square = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(a, b)| {
                    let mut c = beside;
                    c[(axis + 1) % 3] += a;
                    c[(axis + 2) % 3] += b;
                    corner(c)
                });
                for k in 0..4 {
                    surface.cut([centre(cell), centre(beside), square[k], square[(k + 1) % 4]]);
                }
            }
        }
        Mesh { positions: surface.positions, faces: surface.faces, ..Mesh::default() }
    }
}

/// The surface so far.
#[derive(Default)]
struct Triangles<'a> {
    nodes: &'a [Point],
    values: &'a [f64],
    /// The vertex on each lattice edge that has one; the smaller node first.
    on_edges: BTreeMap<[u32; 2], u32>,
    positions: Vec<Point>,
    faces: Ragged,
}

impl Triangles<'_> {
    /// Adds the part of the surface in one tetrahedron.
    fn cut(&mut self, tet: [u32; 4]) {
        let (inside, outside): (Vec<u32>, Vec<u32>) =
            tet.iter().partition(|&&node| self.values[node as usize] < 0.0);
        let polygon: Vec<u32> = match (inside.as_slice(), outside.as_slice()) {
            (&[a], others) | (others, &[a]) => others.iter().map(|&b| self.vertex(a, b)).collect(),
            (&[a, b], &[c, d]) => {
                [(a, c), (a, d), (b, d), (b, c)].map(|(a, b)| self.vertex(a, b)).to_vec()
            }
            _ => return,
        };
        let at = |v: u32| Vec3::from(self.positions[v as usize]);
        let node = |v: u32| Vec3::from(self.nodes[v as usize]);
        let triangles = match *polygon {
            [a, b, c, d] if (at(a) - at(c)).length() > (at(b) - at(d)).length() => {
                vec![[a, b, d], [b, c, d]]
            }
            [a, b, c, d] => vec![[a, b, c], [a, c, d]],
            [a, b, c] => vec![[a, b, c]],
            _ => return,
        };
        let outwards = node(outside[0]) - node(inside[0]);
        for [a, b, c] in triangles {
            let normal = (at(b) - at(a)).cross(at(c) - at(a));
            let turned = normal.dot(outwards) < 0.0;
            self.faces.push(&if turned { [a, c, b] } else { [a, b, c] });
        }
    }

    /// The vertex on a lattice edge: the zero of the linear interpolant, kept away from the nodes
    /// to avoid slivers.
    fn vertex(&mut self, a: u32, b: u32) -> u32 {
        const NEAREST: f64 = 0.15;
        let ends = [a.min(b), a.max(b)];
        if let Some(&vertex) = self.on_edges.get(&ends) {
            return vertex;
        }
        let [p, q] = ends.map(|node| Vec3::from(self.nodes[node as usize]));
        let [f, g] = ends.map(|node| self.values[node as usize]);
        let t = (f / (f - g)).clamp(NEAREST, 1.0 - NEAREST);
        let vertex = self.positions.len() as u32;
        self.positions.push((p + (q - p) * t).into());
        self.on_edges.insert(ends, vertex);
        vertex
    }
}

/// The index of a point of a grid of `#x, #y, #z` points, in the order of [`grid_points`].
pub(super) fn linear_index([x, y, z]: [u32; 3], [nx, ny, _]: [u32; 3]) -> u32 {
    (z * ny + y) * nx + x
}

/// All points of a grid, by z, then y, then x.
pub(super) fn grid_points([nx, ny, nz]: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    (0..nx * ny * nz).map(move |k| [k % nx, k / nx % ny, k / (nx * ny)])
}
