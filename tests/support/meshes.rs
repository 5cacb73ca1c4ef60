//! Meshes for tests: a wavy grid, and random meshes.

pub(crate) use crate::support::grid::grid;
use proptest::prelude::*;
use shape_up::mesh::Mesh;

/// `columns * rows` quads over a wavy surface; the vertices are ordered row by row.
pub(crate) fn wavy(columns: u32, rows: u32) -> Mesh {
    grid(columns, rows, |i, j| {
        let (x, y) = (f64::from(i), f64::from(j));
        [x, y, 0.05 * x * (x - y) + 0.03 * y * y]
    })
}

/// Content of a cell of a random mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Cell {
    Quad,
    Triangles,
    OtherTriangles,
    Hole,
}

/// Random meshes: grids with displaced vertices, whose cells are quads, pairs of triangles or
/// holes.
pub(crate) fn mesh(cells: impl Strategy<Value = Cell> + Clone) -> impl Strategy<Value = Mesh> {
    (1_u32..7, 1_u32..7)
        .prop_flat_map(move |(columns, rows)| {
            let moves = prop::array::uniform3(-0.4..0.4);
            let vertices = ((columns + 1) * (rows + 1)) as usize;
            (
                Just((columns, rows)),
                prop::collection::vec(cells.clone(), (columns * rows) as usize),
                prop::collection::vec(moves, vertices),
            )
        })
        .prop_map(|((columns, rows), cells, moves)| {
            let regular = wavy(columns, rows);
            let mut mesh = Mesh { positions: regular.positions, ..Mesh::default() };
            for (at, by) in mesh.positions.iter_mut().zip(moves) {
                *at = [at[0] + by[0], at[1] + by[1], at[2] + by[2]];
            }
            for (face, cell) in regular.faces.iter().zip(cells) {
                let [a, b, c, d] = [face[0], face[1], face[2], face[3]];
                match cell {
                    Cell::Quad => mesh.faces.push(&[a, b, c, d]),
                    Cell::Triangles => {
                        mesh.faces.push(&[a, b, c]);
                        mesh.faces.push(&[a, c, d]);
                    }
                    Cell::OtherTriangles => {
                        mesh.faces.push(&[b, d, a]);
                        mesh.faces.push(&[b, c, d]);
                    }
                    Cell::Hole => {}
                }
            }
            mesh
        })
}

/// Meshes of quads, triangles and holes.
pub(crate) fn mixed() -> impl Strategy<Value = Mesh> {
    use Cell::*;
    mesh(prop::sample::select(vec![Quad, Triangles, OtherTriangles, Hole]))
}

/// Meshes of triangles and holes.
pub(crate) fn triangles() -> impl Strategy<Value = Mesh> {
    use Cell::*;
    mesh(prop::sample::select(vec![Triangles, OtherTriangles, Triangles, Hole]))
}
