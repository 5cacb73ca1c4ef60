//! On curve (an application of paper section 4.2, where vertices slide along feature curves): the
//! closest point of a fixed polyline, or of a spline through its vertices.

use crate::constraint::kinds::shared::separate_lanes;
use crate::constraint::{Arity, Centring, Element, Form, Info, Param, Projection};
use crate::json::word;
use crate::math::{Cubic, Lane, Vec3, cosine, largest_coordinate};
use serde::{Deserialize, Serialize};

/// The vertices glide along the polyline of their rest positions, in the given order, each on its
/// own piece: from one corner to the next. Corners and ends of open curves stay where they are at
/// rest.
///
/// A corner is a vertex at which the curve turns by more than `corners`; not at a segment without
/// length. A curve of three or more vertices is closed if the gap from its last vertex to its first
/// is at most 1.5 times the longest of its other segments, unless `closed` says yes or no.
///
/// Each vertex is projected to the closest point of its piece; one is chosen if several are.
///
/// Between the rest positions the curve is straight or a `spline`: one cubic per segment, with
/// continuous direction within a piece. The tangent at a vertex is that of the parabola through it
/// and its two neighbours in the centripetal parametrisation, which rules out loops between them
/// (Yuksel, Schaefer, Keyser 2011); at an end of a piece, of the parabola through its last three
/// vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct OnCurve {
    /// The least turning angle of a corner, in degrees.
    corners: f64,
    /// Whether the last vertex is followed by the first.
    #[serde(deserialize_with = "word")]
    closed: Closed,
    /// The curve between rest positions.
    #[serde(deserialize_with = "word")]
    between: Between,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Between {
    Straight,
    Spline,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Closed {
    Auto,
    Yes,
    No,
}

impl Default for OnCurve {
    fn default() -> Self {
        OnCurve { corners: 45.0, closed: Closed::Auto, between: Between::Straight }
    }
}

impl OnCurve {
    /// Whether a curve is taken for closed by the gap between its ends.
    pub(crate) fn tells_closed_by_gap(&self) -> bool {
        self.closed == Closed::Auto
    }
}

/// Greatest length of the gap of a closed curve, relative to the longest segment.
const GAP: f64 = 1.5;

impl Projection for OnCurve {
    const INFO: Info = Info {
        id: "on-curve",
        label: "On curve",
        summary: "The vertices slide along the curve that they form in the original; its corners stay.",
        arity: Arity::AtLeast(2),
        centring: Centring::Placed,
        elements: &[Element::Curve, Element::Polyline, Element::EdgeLine, Element::Boundary],
        colour: [0, 130, 120],
        params: &[
            Param::number("corners", "Corners turn by more than", "degrees", 45.0, [0.0, 180.0]),
            Param::word(
                "closed",
                "Closed",
                "auto",
                &[Form::Word("auto"), Form::Word("yes"), Form::Word("no")],
            ),
            Param::word(
                "between",
                "Between vertices",
                "straight",
                &[Form::Word("straight"), Form::Word("spline")],
            ),
        ],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        // The extent of the search depends on the points, so each lane is projected separately.
        separate_lanes(rest, v, projected, |lane, projected| {
            let curve = Curve::new(self, rest.len(), |i| rest[i].lane(lane));
            let largest = v.iter().map(|v| v.lane(lane).largest_coordinate());
            let largest = largest.fold(curve.size(), f64::max);
            if !(1e-60..=1e60).contains(&largest) {
                return false;
            }
            curve.glide(|i, closest| {
                let p = closest(v[i].lane(lane));
                projected[i].set_lane(lane, p);
            });
            true
        })
    }

    /// The same in units of the largest coordinate, so that squared lengths stay in range.
    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let unit = largest_coordinate(rest).max(largest_coordinate(v));
        if unit == 0.0 {
            return;
        }
        let scaled = |p: Vec3<f64>| Vec3::new(p.x / unit, p.y / unit, p.z / unit);
        let curve = Curve::new(self, rest.len(), |i| scaled(rest[i]));
        curve.glide(|i, closest| v[i] = closest(scaled(v[i])) * unit);
    }
}

/// The polyline of one constraint.
struct Curve<P> {
    /// Returns the position of vertex `i` of `n`.
    at: P,
    n: usize,
    closed: bool,
    is_spline: bool,
    /// Upper bound on the length of a segment.
    longest: f64,
    /// The cosine of the least turn of a corner.
    cosine: f64,
}

impl<P: Fn(usize) -> Vec3<f64>> Curve<P> {
    fn new(operator: &OnCurve, n: usize, at: P) -> Self {
        let lengths = (0..n - 1).map(|i| (at(i + 1) - at(i)).length());
        let longest = lengths.fold(0.0, f64::max);
        let gap = (at(0) - at(n - 1)).length();
        let closed = match operator.closed {
            Closed::Auto => n >= 3 && gap <= GAP * longest,
            Closed::Yes => true,
            Closed::No => false,
        };
        let longest = if closed { longest.max(gap) } else { longest };
        let cosine = cosine(operator.corners / 360.0);
        let is_spline = operator.between == Between::Spline;
        let mut curve = Curve { at, n, closed, is_spline, longest, cosine };
        if is_spline {
            let lengths = (0..curve.segments()).map(|i| curve.cubic(i).length_bound());
            curve.longest = lengths.fold(0.0, f64::max);
        }
        curve
    }

    fn segments(&self) -> usize {
        if self.closed { self.n } else { self.n - 1 }
    }

    fn size(&self) -> f64 {
        (0..self.n).fold(0.0, |size, i| (self.at)(i).largest_coordinate().max(size))
    }

    fn is_kept(&self, i: usize) -> bool {
        let n = self.n;
        if !self.closed && (i == 0 || i == n - 1) {
            return true;
        }
        let here = (self.at)(i);
        let (before, after) = (here - (self.at)((i + n - 1) % n), (self.at)((i + 1) % n) - here);
        let lengths = before.length() * after.length();
        // The tolerance keeps rounding from making a corner of a straight line.
        lengths > 0.0 && before.dot(after) < (self.cosine - 1e-12) * lengths
    }

    /// Calls `place` for each vertex, with a function that returns the closest point of its piece.
    fn glide(&self, mut place: impl FnMut(usize, &dyn Fn(Vec3<f64>) -> Vec3<f64>)) {
        let (n, segments) = (self.n, self.segments());
        let Some(first) = (0..n).find(|&i| self.is_kept(i)) else {
            (0..n).for_each(|i| place(i, &|v| self.closest(0, segments, i, v)));
            return;
        };
        // Pieces extend from one kept vertex to the next, around the whole curve if it is closed.
        let mut start = first;
        while start < first + segments {
            let after = (start + 1..first + segments).find(|&i| self.is_kept(i % n));
            let end = after.unwrap_or(first + segments);
            for i in start + 1..end {
                place(i % n, &|v| self.closest(start, end, i, v));
            }
            start = end;
        }
        (0..n).filter(|&i| self.is_kept(i)).for_each(|i| place(i, &|_| (self.at)(i)));
    }

    /// Returns the point closest to `v` on the segments `start..end`, numbered by their first
    /// vertices. The search begins at vertex `near` and skips segments too far along the curve to
    /// be nearer than the best point so far.
    fn closest(&self, start: usize, end: usize, near: usize, v: Vec3<f64>) -> Vec3<f64> {
        let mut best = ((self.at)(near % self.n), f64::INFINITY);
        let mut consider = |segment: usize| {
            let point = if self.is_spline {
                self.cubic(segment).closest(v)
            } else {
                closest_of_segment(self.ends(segment), v)
            };
            let distance = (v - point).length();
            if distance < best.1 {
                best = (point, distance);
            }
            // Neighbouring segments begin at least this much farther away than the best point.
            let spare = distance - best.1;
            if spare > 0.0 { (spare / self.longest) as usize } else { 0 }
        };
        let mut segment = near;
        while segment < end {
            segment = consider(segment).saturating_add(segment + 1);
        }
        let mut segment = near;
        while segment > start {
            let skipped = consider(segment - 1);
            segment = (segment - 1).saturating_sub(skipped).max(start);
        }
        best.0
    }

    fn ends(&self, segment: usize) -> [Vec3<f64>; 2] {
        [(self.at)(segment % self.n), (self.at)((segment + 1) % self.n)]
    }

    /// Returns a segment of the spline.
    fn cubic(&self, segment: usize) -> Cubic {
        let (n, ends) = (self.n, self.ends(segment));
        let (first, second) = (segment % n, (segment + 1) % n);
        let chord = ends[1] - ends[0];
        let step = chord.length().sqrt();
        // The chord beyond an end, and its parameter step; none at the end of a piece.
        let beyond = |end: usize, other: usize| {
            let chord =
                if end == first { ends[0] - (self.at)(other) } else { (self.at)(other) - ends[1] };
            let other_step = chord.length().sqrt();
            (!self.is_kept(end) && other_step > 0.0).then_some((chord, other_step))
        };
        let derivative = |(other, other_step): (Vec3<f64>, f64)| {
            let (own, all) = (chord * (1.0 / step), step + other_step);
            (own * (other_step / all) + other * (step / (other_step * all))) * step
        };
        if step == 0.0 {
            return Cubic::hermite(ends, [Vec3::zero(); 2]);
        }
        let before = beyond(first, (first + n - 1) % n).map(derivative);
        let after = beyond(second, (second + 1) % n).map(derivative);
        let of_parabola =
            |other: Option<Vec3<f64>>| other.map_or(chord, |other| chord * 2.0 - other);
        let [start, end] = [
            before.unwrap_or_else(|| of_parabola(after)),
            after.unwrap_or_else(|| of_parabola(before)),
        ];
        Cubic::hermite(ends, [start, end])
    }
}

fn closest_of_segment([a, b]: [Vec3<f64>; 2], v: Vec3<f64>) -> Vec3<f64> {
    let side = b - a;
    let squared = side.length_squared();
    let along = if squared > 0.0 { (v - a).dot(side) / squared } else { 0.0 };
    match along {
        along if along <= 0.0 => a,
        along if along >= 1.0 => b,
        along => a + side * along,
    }
}
