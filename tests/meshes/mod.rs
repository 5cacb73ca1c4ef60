//! Meshes for tests: made here, random ones, and those of `../shared/meshes`.
#![allow(dead_code, reason = "each test file uses some of these")]

use proptest::prelude::*;
use shape_up::mesh::{Mesh, Point};
use std::path::PathBuf;

/// `columns * rows` quads over a wavy ground; the vertices come row by row.
pub(crate) fn grid(columns: usize, rows: usize) -> Mesh {
    let mut mesh = Mesh::default();
    for j in 0..=rows {
        for i in 0..=columns {
            let (x, y) = (i as f64, j as f64);
            mesh.positions.push([x, y, 0.05 * x * (x - y) + 0.03 * y * y]);
        }
    }
    let width = columns as u32 + 1;
    for j in 0..rows as u32 {
        for i in 0..columns as u32 {
            let corner = j * width + i;
            mesh.faces.push(&[corner, corner + 1, corner + 1 + width, corner + width]);
        }
    }
    mesh
}

/// What stands in a cell of a random mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Cell {
    Quad,
    Triangles,
    OtherTriangles,
    Hole,
}

/// Random meshes: grids whose cells are quads, two triangles or holes, with moved vertices.
pub(crate) fn mesh(cells: impl Strategy<Value = Cell> + Clone) -> impl Strategy<Value = Mesh> {
    (1_usize..7, 1_usize..7)
        .prop_flat_map(move |(columns, rows)| {
            let moves = prop::array::uniform3(-0.4..0.4);
            let vertices = (columns + 1) * (rows + 1);
            (
                Just((columns, rows)),
                prop::collection::vec(cells.clone(), columns * rows),
                prop::collection::vec(moves, vertices),
            )
        })
        .prop_map(|((columns, rows), cells, moves)| {
            let regular = grid(columns, rows);
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

/// Quads, triangles and holes.
pub(crate) fn mixed() -> impl Strategy<Value = Mesh> {
    use Cell::*;
    mesh(prop::sample::select(vec![Quad, Triangles, OtherTriangles, Hole]))
}

/// Triangles and holes.
pub(crate) fn triangles() -> impl Strategy<Value = Mesh> {
    use Cell::*;
    mesh(prop::sample::select(vec![Triangles, OtherTriangles, Triangles, Hole]))
}

/// A mesh of `../shared/meshes`; none, and a line that says so, where that is absent. Reads only
/// the plain files of that folder: positions and faces.
pub(crate) fn shared(name: &str) -> Option<Mesh> {
    let path = shared_folder().join("meshes").join(name);
    let Ok(text) = std::fs::read_to_string(&path) else {
        println!("skipped: {} is not there", path.display());
        return None;
    };
    let mut mesh = Mesh::default();
    let number = |word: &str| word.parse::<f64>().expect("a number");
    let point =
        |words: &[&str]| -> Point { [number(words[0]), number(words[1]), number(words[2])] };
    let index = |word: &str| word.parse::<u32>().expect("an index");
    let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    if name.ends_with(".off") {
        let mut lines =
            lines.filter(|words| words.first().is_some_and(|w| !w.starts_with('#'))).skip(1);
        let counts = lines.next().expect("counts");
        let (n_vertices, n_faces) = (index(counts[0]) as usize, index(counts[1]) as usize);
        mesh.positions.extend(lines.by_ref().take(n_vertices).map(|words| point(&words)));
        for words in lines.take(n_faces) {
            let face: Vec<u32> = words[1..].iter().map(|word| index(word)).collect();
            mesh.faces.push(&face[..index(words[0]) as usize]);
        }
    } else {
        for words in lines {
            match words.first() {
                Some(&"v") => mesh.positions.push(point(&words[1..])),
                Some(&"f") => {
                    let corner = |word: &&str| index(word.split('/').next().expect("a corner")) - 1;
                    mesh.faces.push(&words[1..].iter().map(corner).collect::<Vec<_>>());
                }
                _ => {}
            }
        }
    }
    Some(mesh)
}

/// Where the shared material is.
pub(crate) fn shared_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared")
}
