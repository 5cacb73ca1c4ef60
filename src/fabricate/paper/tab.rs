//! Tabs: trapezia on one of the two edges of a cut joint, shortened until they lie behind the
//! neighbour, where they are hidden, and overlap nothing else on the piece.

use super::facet::FacetSide;
use super::net::PaperNet;
use super::plane::{Motion, overlaps, reach};
use crate::fabricate::boxes::Corners;
use crate::fabricate::panel::{direction_of, distance_to_outline};
use crate::math::cosine_and_sine_of_degrees;
use crate::math::plane::{Point2, bounds, distance, is_inside};

/// Smallest useful height of a tab, in mm.
pub const LEAST_TAB: f64 = 2.0;
/// Largest angle at its base, in degrees.
const STEEPEST: f64 = 45.0;
/// Shortest side away from the piece, as a fraction of the edge.
const TOP: f64 = 0.25;
/// Least distance from the tab to the outline of the neighbour, in mm.
const HIDDEN: f64 = 0.3;

/// A tab.
#[derive(Clone, Copy, Debug)]
pub struct Tab {
    /// The side that it is on.
    pub side: FacetSide,
    /// Its corners, counterclockwise: the start of the side, the two outer corners, the end of the
    /// side.
    pub corners: [Point2; 4],
    /// Its height in mm.
    pub height: f64,
}

/// The highest tab of at most `most` mm on a side of an outline that keeps clear of the convex
/// counterclockwise polygons `taken`, and of all of its piece. None at the rim, or if it would be lower
/// than [`LEAST_TAB`].
pub(super) fn tab(
    net: &PaperNet,
    side: FacetSide,
    taken: &[[Point2; 4]],
    most: f64,
) -> Option<Tab> {
    let (joint, there) = net.across(side)?;
    let [p, q] = net.ends(side);
    let length = distance(p, q);
    // The neighbour, unfolded over the edge: the tab is hidden behind it.
    let of_neighbour = &net.facets[there.0 as usize].corners;
    let m = of_neighbour.len();
    let [i, j] = [there.1 as usize, (there.1 as usize + 1) % m];
    let unfolded = Motion::between([of_neighbour[i], of_neighbour[j]], [q, p]);
    let neighbour: Vec<Point2> = of_neighbour.iter().map(|&corner| unfolded.put(corner)).collect();
    // In the neighbour the side runs from q to p.
    let inside_q = angle(q, p, neighbour[(i + m - 1) % m]);
    let inside_p = angle(p, neighbour[(j + 1) % m], q);
    // The free angle beside the piece is shared with the tab of the adjacent side.
    let share = |other: FacetSide| {
        let same = net.across(other).is_some_and(|(own, _)| own == joint);
        if same { 0.9 } else { 0.48 }
    };
    let [after, before] = net.beside(side);
    let free_p = share(before) * (360.0 - angle(p, q, net.ends(before)[0]));
    let free_q = share(after) * (360.0 - angle(q, net.ends(after)[1], p));
    let base = [inside_p.min(2.0 * free_p), inside_q.min(2.0 * free_q)]
        .map(|most| (0.5 * most).min(STEEPEST));
    if base.iter().any(|angle| *angle < 1.0) {
        return None;
    }
    let along = direction_of(p, q);
    let outwards = [along[1], -along[0]];
    let slopes = base.map(|angle| {
        let [cosine, sine] = cosine_and_sine_of_degrees(angle);
        cosine / sine
    });
    let of_piece = net.near(net.piece_of[side.0 as usize], around(net, side, most));
    let mut height = most.min((1.0 - TOP) * length / (slopes[0] + slopes[1]));
    while height >= LEAST_TAB {
        let top = |from: Point2, shift: f64| {
            [0, 1].map(|x| from[x] + shift * along[x] + height * outwards[x])
        };
        let corners = [p, top(p, height * slopes[0]), top(q, -height * slopes[1]), q];
        let is_hidden = corners[1..3].iter().all(|&corner| {
            is_inside(&neighbour, corner) && distance_to_outline(&neighbour, corner) >= HIDDEN
        });
        let is_whole = !(0..m).any(|c| c != i && c != j && is_inside(&corners, neighbour[c]));
        let is_free = || {
            let mut all =
                taken.iter().map(|own| &own[..]).chain(of_piece.iter().map(|own| &own[..]));
            !all.any(|other| overlaps(&corners, other, true))
        };
        if is_hidden && is_whole && is_free() {
            return Some(Tab { side, corners, height });
        }
        height *= 0.85;
    }
    None
}

/// The box of what may be in the way of a tab of at most `most` mm on a side.
pub(super) fn around(net: &PaperNet, side: FacetSide, most: f64) -> Corners {
    reach(bounds(net.ends(side)), most)
}

/// The angle at a point, counterclockwise from one other point to a second, in degrees from 0 to
/// 360.
fn angle(at: Point2, from: Point2, to: Point2) -> f64 {
    let ([a, b], [c, d]) = (direction_of(at, from), direction_of(at, to));
    let degrees = libm::atan2(a * d - b * c, a * c + b * d).to_degrees();
    if degrees < 0.0 { degrees + 360.0 } else { degrees }
}
