//! A polyline parametrised by arc length: points, tangents and closest points.

use crate::math::Vec3;
use crate::mesh::Point;

/// A polyline, open or closed.
#[derive(Clone, Debug)]
pub struct Polyline {
    /// The vertices; a closed polyline repeats its first vertex at the end.
    points: Vec<Vec3<f64>>,
    /// Arc length from the first vertex to each vertex.
    lengths: Vec<f64>,
    closed: bool,
    longest: f64,
}

impl Polyline {
    /// Builds the polyline through these vertices, at least one. If `closed`, the last vertex must
    /// equal the first.
    pub fn new(points: impl IntoIterator<Item = Point>, closed: bool) -> Polyline {
        let points: Vec<Vec3<f64>> = points.into_iter().map(Vec3::from).collect();
        let (mut lengths, mut longest) = (vec![0.0], 0.0f64);
        let mut length = 0.0;
        for ends in points.windows(2) {
            let segment = (ends[1] - ends[0]).length();
            length += segment;
            longest = longest.max(segment);
            lengths.push(length);
        }
        Polyline { points, lengths, closed, longest }
    }

    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Returns the arc length from the first vertex to vertex `k`.
    pub fn length_to(&self, k: usize) -> f64 {
        self.lengths[k]
    }

    /// Clamps an arc length to an open curve. On a closed curve every value is valid, modulo the
    /// total length.
    pub fn bounded(&self, s: f64) -> f64 {
        if self.closed { s } else { s.clamp(0.0, self.length()) }
    }

    /// Returns `s` reduced to the first round, and the segment that it is on or begins.
    fn place(&self, s: f64) -> (f64, usize) {
        let whole = self.length();
        let s = if self.closed && whole > 0.0 { s.rem_euclid(whole) } else { self.bounded(s) };
        // The last segment that begins at or before `s`; it has non-zero length, except at the end.
        let after = self.lengths.partition_point(|&length| length <= s);
        (s, after.max(1) - 1)
    }

    /// Returns the point at arc length `s`; exactly the vertex if `s` is the arc length of a
    /// vertex.
    pub fn point(&self, s: f64) -> Point {
        let (s, k) = self.place(s);
        let beyond = s - self.lengths[k];
        let (a, Some(&b)) = (self.points[k], self.points.get(k + 1)) else {
            return self.points[k].into();
        };
        if beyond == 0.0 {
            return a.into();
        }
        (a + (b - a) * (beyond / (self.lengths[k + 1] - self.lengths[k]))).into()
    }

    /// Returns the unit tangents before and after arc length `s`, both in the direction of the
    /// curve; `None` beyond an end. They differ only at vertices.
    pub fn directions(&self, s: f64) -> [Option<Vec3<f64>>; 2] {
        let (s, k) = self.place(s);
        let n = self.points.len() - 1;
        let direction = |segment: usize| {
            let way = self.points[segment + 1] - self.points[segment];
            way * (1.0 / way.length())
        };
        let has_length = |segment: &usize| self.lengths[segment + 1] > self.lengths[*segment];
        let on = (k..n).find(has_length);
        let back = if s > self.lengths[k] { on } else { (0..k).rev().find(has_length) };
        let around = |found: Option<usize>, first: Option<usize>| match found {
            None if self.closed => first,
            found => found,
        };
        let back = around(back, (0..n).rev().find(has_length));
        let on = around(on, (0..n).find(has_length));
        [back.map(direction), on.map(direction)]
    }

    /// Returns the arc length of the point closest to `p`, by a search that starts at `near`.
    pub fn closest(&self, p: Point, near: f64) -> f64 {
        let p = Vec3::from(p);
        let (_, start) = self.place(near);
        let n = self.points.len() - 1;
        let mut best = (self.lengths[start], (p - self.points[start]).length());
        // Returns the number of following segments that cannot be nearer.
        let mut consider = |k: usize| {
            let (a, way) = (self.points[k], self.points[k + 1] - self.points[k]);
            let squared = way.length_squared();
            let part = if squared > 0.0 { (p - a).dot(way) / squared } else { 0.0 };
            let part = part.clamp(0.0, 1.0);
            let distance = (p - (a + way * part)).length();
            if distance < best.1 {
                let length = self.lengths[k + 1] - self.lengths[k];
                let s = self.lengths[k] + part * length;
                best = (if part == 1.0 { self.lengths[k + 1] } else { s }, distance);
            }
            let spare = distance - best.1;
            if spare > 0.0 { (spare / self.longest) as usize } else { 0 }
        };
        let mut k = start;
        while k < n {
            k = consider(k).saturating_add(k + 1);
        }
        let mut k = start.min(n);
        while k > 0 {
            k = (k - 1).saturating_sub(consider(k - 1));
        }
        best.0
    }
}
