//! Grids of quads for tests.
#![allow(dead_code, reason = "each test uses some of these")]

use shape_up::mesh::{Mesh, Point};

/// A grid of `columns * rows` quads. Vertices and faces are ordered row by row; the vertex of
/// column `i` and row `j` is at `point(i, j)`.
pub(crate) fn grid(columns: u32, rows: u32, point: impl Fn(u32, u32) -> Point) -> Mesh {
    let mut mesh = Mesh::default();
    for j in 0..=rows {
        mesh.positions.extend((0..=columns).map(|i| point(i, j)));
    }
    let width = columns + 1;
    for j in 0..rows {
        for i in 0..columns {
            let corner = j * width + i;
            mesh.faces.push(&[corner, corner + 1, corner + 1 + width, corner + width]);
        }
    }
    mesh
}

/// `n * n` quads over bumps with a period of four.
pub(crate) fn bumpy(n: u32) -> Mesh {
    grid(n, n, |i, j| [f64::from(i), f64::from(j), f64::from((i * 5 + j * 7) % 4) / 8.0])
}

/// A floor of 2 by 2 quads, and a wall of one quad on an edge inside it.
pub(crate) fn wall_on_floor() -> Mesh {
    let mut mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.positions.extend([[1.0, 0.0, 1.0], [1.0, 1.0, 1.0]]);
    mesh.faces.push(&[1, 4, 10, 9]);
    mesh
}
