//! Lines of curvature, traced by the midpoint method: each step goes straight on over the surface in the direction
//! that is found halfway.

use super::field::{CurvatureField, Family, SurfacePlace};
use super::walk::Heading;
use crate::mesh::Point;

/// Steps, as parts of the mean edge.
const STEP: f64 = 0.25;
/// A line is closed where it comes back to where it began, up to this part of the mean edge.
const CLOSED: f64 = 0.5;
/// It goes on until the curvatures differ by less than this part of the sum of their sizes; where it begins they
/// differ by more.
const UMBILIC: f64 = 0.04;
/// So many steps at most, in each direction.
const MOST_STEPS: usize = 20_000;

/// A line of curvature.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvatureLine {
    /// Its family.
    pub family: Family,
    /// Its places, one after another; the last is the first one again where it is closed.
    pub places: Vec<SurfacePlace>,
    /// Whether it comes back to where it began.
    pub closed: bool,
}

impl CurvatureLine {
    /// Its points, `#points by 3`.
    pub fn points(&self) -> impl ExactSizeIterator<Item = Point> + '_ {
        self.places.iter().map(|place| Point::from(place.at))
    }
}

impl CurvatureField {
    /// The line of curvature through a place, to both sides until it is closed, at the boundary, within an edge of an
    /// earlier part of itself, or where the surface has no direction. None where it has none at the place.
    pub fn line_through(&self, place: SurfacePlace, family: Family) -> Option<CurvatureLine> {
        self.line_until(place, family, |places| comes_back(places, self.mean_edge()))
    }

    /// The same, until `is_end` of the places so far, the newest last.
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

    /// One side of a line, from its first place on; and whether it is closed.
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
            // Past the nearest point: what is left of the way there lies behind.
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

    /// One step; the direction of the heading only says to which side it goes.
    fn step(&self, from: Heading, family: Family, length: f64) -> Option<Heading> {
        let along = |heading: Heading| {
            let way = self.direction(heading.place, family, UMBILIC)?;
            Some(if way.dot(heading.way) < 0.0 { -way } else { way })
        };
        let way = along(from)?;
        let half = self.walk(Heading { way, ..from }, 0.5 * length)?;
        let there = along(half)?;
        // How far the direction turns until there, and so from here.
        let (cosine, sine) =
            (half.way.dot(there), half.way.cross(there).dot(self.normal(half.place)));
        let turned = way * cosine + self.normal(from.place).cross(way) * sine;
        self.walk(Heading { way: turned, ..from }, length)
    }
}

/// Whether the newest place is nearer than `distance` to one that came long before, and not where the line began.
pub(super) fn comes_back(places: &[SurfacePlace], distance: f64) -> bool {
    let [first, .., last] = places else { return false };
    if (first.at - last.at).length() < 2.0 * distance {
        return false;
    }
    let near = |place: &SurfacePlace| (place.at - last.at).length() < distance;
    // Those just before are near anyhow.
    let before = places.iter().rposition(|place| !near(place)).unwrap_or(0);
    places[..before].iter().any(near)
}
