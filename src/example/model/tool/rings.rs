//! Vertices in rings one above another, and the quads between them.

use crate::mesh::{Point, Ragged};
use std::ops::Range;

/// Rings around the z axis with equally many vertices.
#[derive(Clone, Copy)]
pub(crate) struct Rings {
    /// Vertices of each ring.
    pub meridians: u32,
    /// Rows of quads between the rings.
    pub rows: u32,
}

impl Rings {
    /// The positions; vertex `i` of ring `k` has index `k * meridians + i`. `point` gets the index
    /// of the ring, its relative height from 0 to 1, and the angle in turns.
    pub(crate) fn positions(self, point: impl Fn(u32, f64, f64) -> Point) -> Vec<Point> {
        let part = |n: u32, of: u32| f64::from(n) / f64::from(of);
        let places = (0..=self.rows).flat_map(|k| (0..self.meridians).map(move |i| (k, i)));
        places.map(|(k, i)| point(k, part(k, self.rows), part(i, self.meridians))).collect()
    }

    /// The corners of each quad from its lower left one, counterclockwise from outside.
    pub(crate) fn quads(self) -> impl Iterator<Item = [u32; 4]> {
        let below = move |k: u32, i: u32| k * self.meridians + i % self.meridians;
        let places = (0..self.rows).flat_map(move |k| (0..self.meridians).map(move |i| (k, i)));
        places
            .map(move |(k, i)| [below(k, i), below(k, i + 1), below(k + 1, i + 1), below(k + 1, i)])
    }

    /// The quads as faces.
    pub(crate) fn faces(self) -> Ragged {
        Ragged::from_iter(self.quads())
    }

    /// The vertices of ring `k`.
    pub(crate) fn ring(self, k: u32) -> Range<u32> {
        k * self.meridians..(k + 1) * self.meridians
    }
}
