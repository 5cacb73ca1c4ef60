//! Blocks of cubes: their surfaces as quads, and tetrahedra.

use super::lattice::{grid_points, linear_index};
use crate::mesh::{Mesh, Point, Ragged};

/// Unit cubes of a grid, each filled or empty. No two may touch only along an edge or in a corner,
/// so that their surface is a manifold.
pub struct Blocks {
    size: [u32; 3],
    /// By z, then y, then x.
    filled: Vec<bool>,
}

impl Blocks {
    /// Fills the cubes of a grid of `size` for which `is_there` is true.
    pub fn new(size: [u32; 3], is_there: impl Fn([u32; 3]) -> bool) -> Blocks {
        Blocks { size, filled: grid_points(size).map(is_there).collect() }
    }

    /// Fills all cubes of a grid of `size`.
    pub fn bar(size: [u32; 3]) -> Blocks {
        Blocks::new(size, |_| true)
    }

    /// The surface: a quad for each side of a cube without a neighbour, counterclockwise from
    /// outside. Vertices are ordered by z, then y, then x.
    pub fn surface(&self) -> Mesh {
        let mut quads: Vec<[[u32; 3]; 4]> = Vec::new();
        for cube in self.cubes() {
            for axis in 0..3 {
                let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                for (above, neighbour) in
                    [(1, cube[axis].checked_add(1)), (0, cube[axis].checked_sub(1))]
                {
                    let covered = neighbour.is_some_and(|n| {
                        let mut beside = cube;
                        beside[axis] = n;
                        self.has(beside)
                    });
                    if covered {
                        continue;
                    }
                    // Counterclockwise seen from the positive end of the axis.
                    let mut quad = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(a, b)| {
                        let mut corner = cube;
                        corner[axis] += above;
                        corner[u] += a;
                        corner[v] += b;
                        corner
                    });
                    if above == 0 {
                        quad.reverse();
                    }
                    quads.push(quad);
                }
            }
        }
        let numbers = self.numbers(quads.iter().flatten());
        let faces = quads.iter().map(|quad| quad.map(|corner| numbers.of(corner))).collect();
        Mesh { positions: numbers.positions, faces, ..Mesh::default() }
    }

    /// Six tetrahedra per cube around its diagonal (Kuhn's subdivision, which matches across
    /// cubes), and their surface as triangles, counterclockwise from outside. Vertices are ordered
    /// by z, then y, then x.
    pub fn tetrahedra(&self) -> Mesh {
        // The axes along which each path goes from the lowest to the highest corner.
        const PATHS: [[usize; 3]; 6] =
            [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];
        let mut corners: Vec<[[u32; 3]; 4]> = Vec::new();
        for cube in self.cubes() {
            for (k, path) in PATHS.iter().enumerate() {
                let mut at = cube;
                let mut tet = [at; 4];
                for (corner, &axis) in tet[1..].iter_mut().zip(path) {
                    at[axis] += 1;
                    *corner = at;
                }
                if k >= 3 {
                    // Odd permutations give mirrored tetrahedra.
                    tet.swap(2, 3);
                }
                corners.push(tet);
            }
        }
        let numbers = self.numbers(corners.iter().flatten());
        let tets: Vec<[u32; 4]> =
            corners.iter().map(|tet| tet.map(|corner| numbers.of(corner))).collect();
        Mesh { positions: numbers.positions, faces: boundary(&tets), tets, ..Mesh::default() }
    }

    fn cubes(&self) -> impl Iterator<Item = [u32; 3]> {
        grid_points(self.size)
            .zip(&self.filled)
            .filter(|(_, filled)| **filled)
            .map(|(cube, _)| cube)
    }

    fn has(&self, cube: [u32; 3]) -> bool {
        let [nx, ny, nz] = self.size;
        let [x, y, z] = cube;
        x < nx && y < ny && z < nz && self.filled[((z * ny + y) * nx + x) as usize]
    }

    /// Numbers the corners that are used.
    fn numbers<'a>(&self, used: impl Iterator<Item = &'a [u32; 3]>) -> Numbers {
        let corners = self.size.map(|n| n + 1);
        let mut numbers = vec![0; corners.iter().product::<u32>() as usize];
        used.for_each(|&corner| numbers[linear_index(corner, corners) as usize] = 1);
        let mut positions: Vec<Point> = Vec::new();
        for (number, at) in numbers.iter_mut().zip(grid_points(corners)) {
            if *number == 1 {
                *number = positions.len() as u32;
                positions.push(at.map(f64::from));
            }
        }
        Numbers { corners, numbers, positions }
    }
}

/// Vertex numbers of cube corners.
struct Numbers {
    corners: [u32; 3],
    numbers: Vec<u32>,
    positions: Vec<Point>,
}

impl Numbers {
    fn of(&self, corner: [u32; 3]) -> u32 {
        self.numbers[linear_index(corner, self.corners) as usize]
    }
}

/// The triangles that belong to only one tetrahedron, counterclockwise from outside, in the order
/// of the tetrahedra.
fn boundary(tets: &[[u32; 4]]) -> Ragged {
    let sides = |t: [u32; 4]| {
        [[t[1], t[2], t[3]], [t[0], t[3], t[2]], [t[0], t[1], t[3]], [t[0], t[2], t[1]]]
    };
    let sorted = |mut side: [u32; 3]| {
        side.sort_unstable();
        side
    };
    let mut all: Vec<[u32; 3]> = tets.iter().flat_map(|&tet| sides(tet).map(sorted)).collect();
    all.sort_unstable();
    let single = |side: &[u32; 3]| {
        let side = sorted(*side);
        let first = all.partition_point(|other| *other < side);
        all.get(first + 1) != Some(&side)
    };
    tets.iter().flat_map(|&tet| sides(tet)).filter(single).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    /// Six times the volume inside a closed surface.
    fn volume(mesh: &Mesh) -> f64 {
        let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
        let fans = mesh
            .faces
            .iter()
            .flat_map(|face| (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]));
        fans.map(|[a, b, c]| at(a).dot(at(b).cross(at(c)))).sum()
    }

    #[test]
    fn the_surface_and_the_tetrahedra_fill_the_cubes() {
        // An L of three cubes on a bar of two.
        let blocks = Blocks::new([2, 2, 2], |[x, y, z]| z == 0 || x + y == 0);
        let surface = blocks.surface();
        assert_eq!(volume(&surface), 6.0 * 5.0);
        let tets = blocks.tetrahedra();
        assert_eq!(volume(&tets), 6.0 * 5.0);
        assert_eq!(tets.tets.len(), 6 * 5);
        for tet in &tets.tets {
            let [a, b, c, d] = tet.map(|v| Vec3::from(tets.positions[v as usize]));
            assert_eq!((b - a).dot((c - a).cross(d - a)), 1.0);
        }
        assert_eq!(2 * surface.faces.len(), tets.faces.len());
    }
}
