//! A grid of quads over a square.

use crate::mesh::{Mesh, Point, Ragged};

/// A grid of quads over the square from -1 to 1 in x and y, counterclockwise seen from above.
pub(crate) fn grid(panels: [usize; 2], point: impl Fn(f64, f64) -> Point) -> Mesh {
    let [nx, ny] = panels;
    let at = |k: usize, n: usize| (2.0 * k as f64 - n as f64) / n as f64;
    let positions = (0..=ny).flat_map(|j| (0..=nx).map(move |i| (i, j)));
    let positions = positions.map(|(i, j)| point(at(i, nx), at(j, ny))).collect();
    let row = nx + 1;
    let quads = (0..ny).flat_map(|j| (0..nx).map(move |i| j * row + i));
    let faces = quads.map(|v| [v, v + 1, v + row + 1, v + row].map(|v| v as u32));
    Mesh { positions, faces: Ragged::from_iter(faces), ..Mesh::default() }
}
