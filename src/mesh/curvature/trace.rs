//! Lines of curvature, traced by the midpoint method: each step is straight on the surface, in the
//! direction found halfway.

use super::field::{CurvatureField, Family, SurfacePlace};
use super::walk::Heading;
use crate::mesh::Point;

/// Step length, as a fraction of the mean edge.
const STEP: f64 = 0.25;
/// A line is closed if it returns to its beginning within this fraction of the mean edge.
const CLOSED: f64 = 0.5;
/// A line ends if the curvatures differ by at most this fraction of the sum of their sizes. The
/// threshold for beginning one is larger.
const UMBILIC: f64 = 0.04;
/// Maximum number of steps in each direction.
const MOST_STEPS: usize = 20_000;

/// A line of curvature.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvatureLine {
    /// The family of the line.
    pub family: Family,
    /// The places along the line; a closed line repeats its first place at the end.
    pub places: Vec<SurfacePlace>,
    /// Whether the line is closed.
    pub closed: bool,
}

impl CurvatureLine {
    /// Returns the positions of the places, `#places by 3`.
    pub fn points(&self) -> impl ExactSizeIterator<Item = Point> + '_ {
        self.places.iter().map(|place| Point::from(place.at))
    }
}

impl CurvatureField {
    /// Traces the line through a place to both sides until it closes, reaches the boundary or a
    /// point without a direction, or is within an edge of an earlier part of itself. `None` without
    /// a direction at the place.
    pub fn line_through(&self, place: SurfacePlace, family: Family) -> Option<CurvatureLine> {
        self.line_until(place, family, |places| comes_back(places, self.mean_edge()))
    }

    /// Traces the line through a place until `is_end` of the places so far, the newest last.
    pub(super) fn line_until(
        &self,
        place: SurfacePlace,
        family: Family,
        mut is_end: impl FnMut(&[SurfacePlace]) -> bool,
    ) -> Option<CurvatureLine> {
        let way = self.direction(place, family, super::edges::UMBILIC)?;
        let (ahead, closed) = self.half(Heading { place, way }, family, &mut is_end);
        if closed {
            return Some(CurvatureLine { family, places: ahead, closed });
        }
        let (mut places, _) = self.half(Heading { place, way: -way }, family, &mut is_end);
        places.reverse();
        places.extend(&ahead[1..]);
        Some(CurvatureLine { family, places, closed })
    }

    /// Traces one side of a line; returns its places and whether it is closed.
    fn half(
        &self,
        begin: Heading,
        family: Family,
        is_end: &mut impl FnMut(&[SurfacePlace]) -> bool,
    ) -> (Vec<SurfacePlace>, bool) {
        let step = STEP * self.mean_edge();
        let near = CLOSED * self.mean_edge();
        let mut places = vec![begin.place];
        let mut heading = begin;
        let mut was_away = false;
        for _ in 0..MOST_STEPS {
            let Some(next) = self.step(heading, family, step) else { break };
            heading = next;
            let away = (heading.place.at - begin.place.at).length();
            was_away |= away > 2.0 * near;
            let is_back = was_away && away < near && heading.way.dot(begin.way) > 0.5;
            // The beginning is at most one step ahead, or behind.
            if is_back && (begin.place.at - heading.place.at).dot(heading.way) <= step {
                places.extend([heading.place, begin.place]);
                return (places, true);
            }
            places.push(heading.place);
            if is_end(&places) {
                break;
            }
        }
        (places, false)
    }

    /// Takes one step. The direction of `from` only selects the sign of the principal direction.
    fn step(&self, from: Heading, family: Family, length: f64) -> Option<Heading> {
        let along = |heading: Heading| {
            let way = self.direction(heading.place, family, UMBILIC)?;
            Some(if way.dot(heading.way) < 0.0 { -way } else { way })
        };
        let way = along(from)?;
        let half = self.walk(Heading { way, ..from }, 0.5 * length)?;
        let there = along(half)?;
        // Apply the turn of the direction halfway to the direction at the beginning.
        let (cosine, sine) =
            (half.way.dot(there), half.way.cross(there).dot(self.normal(half.place)));
        let turned = way * cosine + self.normal(from.place).cross(way) * sine;
        self.walk(Heading { way: turned, ..from }, length)
    }
}

/// Whether the newest place is nearer than `distance` to an earlier part of the line, other than
/// its beginning.
pub(super) fn comes_back(places: &[SurfacePlace], distance: f64) -> bool {
    let [first, .., last] = places else { return false };
    if (first.at - last.at).length() < 2.0 * distance {
        return false;
    }
    let near = |place: &SurfacePlace| (place.at - last.at).length() < distance;
    // Skip the most recent places, which are near in any case.
    let before = places.iter().rposition(|place| !near(place)).unwrap_or(0);
    places[..before].iter().any(near)
}
