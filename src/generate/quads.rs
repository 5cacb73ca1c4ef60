//! Rows of quads: over a square, around an axis, between curves; and the limit of the number of
//! faces of a new mesh.

use crate::mesh::{Mesh, Point, Ragged};
use crate::words;
use std::fmt;
use std::ops::Range;

/// Largest number of faces of a new mesh: it starts coarse and is refined later.
const MOST_FACES: f64 = 100_000.0;

/// A mesh would have too many faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyFaces;

impl fmt::Display for TooManyFaces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "that would be more than {} faces", words::group_digits(MOST_FACES as usize))
    }
}

impl std::error::Error for TooManyFaces {}

/// Fails if there would be too many faces.
pub(super) fn check_face_count(faces: f64) -> Result<(), TooManyFaces> {
    if faces > MOST_FACES { Err(TooManyFaces) } else { Ok(()) }
}

/// The corners of the quads between `rows + 1` rows of vertices, which have `along` quads each:
/// from the lower left one, counterclockwise if rows follow each other upwards. A closed row has as
/// many vertices as quads, an open one has one more.
pub(super) fn quads([along, rows]: [usize; 2], closed: bool) -> impl Iterator<Item = [u32; 4]> {
    let columns = along + usize::from(!closed);
    let at = move |i: usize, j: usize| (j * columns + i % columns) as u32;
    (0..rows).flat_map(move |j| {
        (0..along).map(move |i| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    })
}

/// A grid of quads over the square from -1 to 1 in x and y, counterclockwise seen from above.
pub(super) fn grid(panels: [usize; 2], point: impl Fn(f64, f64) -> Point) -> Mesh {
    let [nx, ny] = panels;
    let at = |k: usize, n: usize| (2.0 * k as f64 - n as f64) / n as f64;
    let positions = (0..=ny).flat_map(|j| (0..=nx).map(move |i| (i, j)));
    let positions = positions.map(|(i, j)| point(at(i, nx), at(j, ny))).collect();
    Mesh { positions, faces: quads(panels, false).collect(), ..Mesh::default() }
}

/// Rings around the z axis, one above another, with equally many vertices.
#[derive(Clone, Copy)]
pub(super) struct Rings {
    /// Vertices of each ring.
    pub(super) meridians: u32,
    /// Rows of quads between the rings.
    pub(super) rows: u32,
}

impl Rings {
    /// The positions; vertex `i` of ring `k` has index `k * meridians + i`. `point` gets the index
    /// of the ring, its relative height from 0 to 1, and the angle in turns.
    pub(super) fn positions(self, point: impl Fn(u32, f64, f64) -> Point) -> Vec<Point> {
        let part = |n: u32, of: u32| f64::from(n) / f64::from(of);
        let places = (0..=self.rows).flat_map(|k| (0..self.meridians).map(move |i| (k, i)));
        places.map(|(k, i)| point(k, part(k, self.rows), part(i, self.meridians))).collect()
    }

    /// The corners of each quad from its lower left one, counterclockwise from outside.
    pub(super) fn quads(self) -> impl Iterator<Item = [u32; 4]> {
        quads([self.meridians as usize, self.rows as usize], true)
    }

    /// The quads as faces.
    pub(super) fn faces(self) -> Ragged {
        self.quads().collect()
    }

    /// The vertices of ring `k`.
    pub(super) fn ring(self, k: u32) -> Range<u32> {
        k * self.meridians..(k + 1) * self.meridians
    }
}
