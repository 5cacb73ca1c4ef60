//! The name of what lies beyond an edge of a part, beside that edge.

use super::lettering::{LEAST, text_width, upright};
use super::part::Hole;
use super::text_box::{ROOM, TextBox};
use crate::fabricate::panel::{direction_of, distance_to_outline};
use crate::math::plane::{Point2, distance};

/// Largest length of a neighbour's name relative to its edge.
const OF_EDGE: f64 = 0.7;
/// Names are shrunk to this fraction of their largest height before they are written across their
/// edge.
const SMALL: f64 = 0.7;
/// Positions along an edge at which a neighbour's name is tried.
const SHARES: [f64; 9] = [0.5, 0.38, 0.62, 0.28, 0.72, 0.24, 0.76, 0.14, 0.86];

/// The name beside an edge.
pub(super) struct BesideEdge {
    pub edge: [Point2; 2],
    /// In degrees.
    pub bevel: Option<f64>,
    /// The place of its box among those that are taken.
    pub at: usize,
    pub words: String,
    pub height: f64,
}

/// The height of a neighbour's name beside its edge, and its box: along the edge or else across it,
/// as high as there is room up to `tallest`, if necessary beyond the hole nearest to the edge. None
/// if it would be unreadable, or nearer to one of the `possible_sides`, with whose name it could be
/// confused, than to its edge.
pub(super) fn beside_edge(
    rings: &[&[Point2]],
    ([p, q], possible_sides): ([Point2; 2], &[[Point2; 2]]),
    (name, tallest): (&str, f64),
    turn: Point2,
    (taken, holes): (&[TextBox], &[Hole]),
) -> Option<(f64, TextBox)> {
    if tallest < LEAST {
        return None;
    }
    let length = distance(p, q);
    let along = direction_of(p, q);
    let inwards = [-along[1], along[0]];
    let others = holes.iter().filter(|hole| hole.as_opening().is_none());
    let beyond = others.map(|hole| hole.reach(p, inwards)).reduce(f64::min);
    let mut height = tallest;
    loop {
        let width = text_width(name, height);
        // Across the edge only if letters along it would become small.
        let directions = [(along, true), (inwards, false)];
        let is_tall = height > LEAST.max(SMALL * tallest);
        let tried = if is_tall { &directions[..1] } else { &directions };
        for &(direction, is_along) in tried {
            let [size, depth] = if is_along { [width, height] } else { [height, width] };
            if size > OF_EDGE * length {
                continue;
            }
            let away = 0.5 * depth + ROOM * height + 0.4;
            for away in [Some(away), beyond.map(|beyond| beyond + away)].into_iter().flatten() {
                // In the middle of the edge, else to either side; near its ends only with small
                // letters.
                for share in if is_tall { &SHARES[..5] } else { &SHARES[..] } {
                    let centre = [0, 1].map(|x| p[x] + share * (q[x] - p[x]) + away * inwards[x]);
                    let own = TextBox::of_text(name, height, centre, upright(direction, turn));
                    if own.is_on(rings)
                        && taken.iter().all(|other| own.is_apart(other))
                        && is_nearest([p, q], possible_sides, centre)
                    {
                        return Some((height, own));
                    }
                }
            }
        }
        if height <= LEAST {
            return None;
        }
        height = (0.8 * height).max(LEAST);
    }
}

/// Whether none of the `possible_sides`, which may have its own side, is nearer to a point than that.
pub(super) fn is_nearest(own: [Point2; 2], possible_sides: &[[Point2; 2]], point: Point2) -> bool {
    let far = |side: &[Point2; 2]| distance_to_outline(side, point);
    let least = far(&own) * (1.0 - 1e-9);
    possible_sides.iter().all(|other| far(other) >= least)
}

/// A bevel with its sign, to a tenth of a degree.
pub(super) fn bevel_words(degrees: f64) -> String {
    let text = format!("{degrees:+.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}
