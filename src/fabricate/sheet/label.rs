//! Names inside an outline: its own in the middle, optionally an arrow beside it, and the names of
//! neighbours along their edges, or across short ones. Names that do not fit are made smaller down
//! to a readable height, then left out and counted. All names are upright on the sheet, however the
//! part is rotated.

use super::arrow::arrow_beside_name;
use super::beside_edge::{BesideEdge, beside_edge, bevel_words};
use super::lettering::{LEAST, strokes, text_width, upright};
use super::part::Hole;
use super::text_box::TextBox;
use crate::fabricate::panel::{direction_of, roomiest_point_beside, sides};
use crate::math::plane::{Point2, distance, dot};

/// Largest height of neighbours' names, in mm.
pub(super) const TALLEST: f64 = 8.0;
/// Height of neighbours' names relative to the radius of the largest circle in the outline.
const OF_RADIUS: f64 = 0.25;
/// Height of the own name relative to neighbours' names; smaller if that leaves room for more.
const OWN: [f64; 3] = [1.7, 1.3, 1.0];
/// Least cosine of the angle between a name that says how its part lies and the direction that it stands
/// for.
const ORIENTED: f64 = 0.9;
/// Least height of a name with a bevel behind it, relative to that of the name alone.
const WITH_BEVEL: f64 = 0.5;
/// The own name is underlined if a neighbour's is higher than this fraction of it.
pub(super) const ALIKE: f64 = 0.85;
/// Distance of the underline, relative to the height of the name.
const BELOW: f64 = 0.2;

/// The engraved lines of a part.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    /// Polylines.
    pub lines: Vec<Vec<Point2>>,
    /// The texts that are written.
    pub texts: Vec<String>,
    /// Neighbours' names without room.
    pub dropped: usize,
    /// Whether its own name is not written, for lack of room for letters of 2 mm.
    pub small: bool,
}

/// The texts to write inside an outline.
#[derive(Clone, Copy, Debug)]
pub struct Inscription<'a> {
    /// The outline in mm, counterclockwise.
    pub outline: &'a [Point2],
    /// Its name.
    pub name: &'a str,
    /// For each edge, the name of the neighbour there, if any. Edge `k` goes from corner `k` to the
    /// next one.
    pub neighbours: &'a [Option<String>],
    /// For each edge the bevel there in degrees, if any: written behind the neighbour's name if both have
    /// room, positive where the inside is cut back. Edges beyond the last have none.
    pub bevels: &'a [Option<f64>],
    /// Whether its letters say how it lies, as on a fin: its own name runs in one direction only, that
    /// of the sheet. It has names at its ends only, so that a side without a neighbour is not taken for
    /// that of a name near it, as on a panel.
    pub is_oriented: bool,
    /// Where its arrow points, as a unit vector.
    pub arrow: Option<Point2>,
    /// The rotation of the part on its sheet, as cosine and sine.
    pub turn: Point2,
    /// Holes in the part, which names must avoid.
    pub holes: &'a [Hole],
}

/// Writes the labels that have room.
pub fn label(own: Inscription<'_>) -> Labels {
    let openings: Vec<&[Point2]> = own.holes.iter().filter_map(Hole::as_opening).collect();
    let room = roomiest_point_beside(own.outline, &openings);
    let mut best: Option<(usize, Labels)> = None;
    for height in OWN {
        let (labels, has_arrow) = label_of_height(own, room, height);
        let missing = labels.dropped + usize::from(own.arrow.is_some() && !has_arrow);
        if best.as_ref().is_none_or(|(least, _)| missing < *least) {
            best = Some((missing, labels));
        }
        if missing == 0 {
            break;
        }
    }
    best.map_or_else(Labels::default, |(_, labels)| labels)
}

/// As `label`, with the relative height `own` of the own name; also whether the arrow is there.
fn label_of_height(
    Inscription { outline, name, neighbours, bevels, is_oriented, arrow, turn, holes }: Inscription<
        '_,
    >,
    (centre, radius): (Point2, f64),
    own: f64,
) -> (Labels, bool) {
    let mut labels = Labels::default();
    let beyond_outline = sides(outline).zip(neighbours).enumerate();
    let beyond_outline = beyond_outline.filter_map(|(k, (side, name))| {
        Some((side, name.as_deref()?, bevels.get(k).copied().flatten()))
    });
    let in_holes = holes.iter().flat_map(Hole::named_sides).map(|(side, name)| (side, name, None));
    // Each with the name of what lies beyond it, and its bevel.
    let named_sides: Vec<([Point2; 2], &str, Option<f64>)> =
        beyond_outline.chain(in_holes).collect();
    let nothing = || Labels { dropped: named_sides.len(), small: true, ..Labels::default() };
    if radius <= 0.0 {
        return (nothing(), false);
    }
    let n = outline.len();
    let longest = (0..n).max_by(|&a, &b| {
        let length = |k: usize| distance(outline[k], outline[(k + 1) % n]);
        length(a).total_cmp(&length(b)).then(b.cmp(&a))
    });
    let longest = longest.unwrap_or(0);
    let across = direction_of(outline[longest], outline[(longest + 1) % n]);
    let beside = (OF_RADIUS * radius).clamp(LEAST, TALLEST);
    let rings: Vec<&[Point2]> =
        [outline].into_iter().chain(holes.iter().filter_map(Hole::as_opening)).collect();
    let others = holes.iter().filter(|hole| hole.as_opening().is_none());
    let mut taken: Vec<TextBox> = others.map(TextBox::of_hole).collect();
    let mut height = own * beside;
    // Try the roomiest point (it may be beside a hole at one end of a slender part) and the middle;
    // along the sheet and along the longest edge; with decreasing height until the name is inside.
    let middle = middle(outline);
    let sheet = [turn[0], -turn[1]];
    let mut directions = vec![sheet, upright(across, turn)];
    directions.retain(|&along| !is_oriented || dot(along, sheet) > ORIENTED);
    let own = loop {
        let found = [centre, middle]
            .into_iter()
            .flat_map(|centre| directions.iter().map(move |&along| (centre, along)))
            .map(|(centre, along)| TextBox::of_text(name, height, centre, along))
            .find(|own| own.is_on(&rings) && taken.iter().all(|hole| own.is_apart(hole)));
        if found.is_some() || height <= LEAST {
            break found;
        }
        height = (0.85 * height).max(LEAST);
    };
    let Some(own) = own else { return (nothing(), false) };
    labels.lines.extend(strokes(name, height, own.centre, own.along));
    labels.texts.push(name.to_owned());
    taken.insert(0, own);
    let drawn = arrow.and_then(|way| arrow_beside_name(&rings, &taken, height, way));
    let has_arrow = drawn.is_some();
    if let Some((lines, own)) = drawn {
        labels.lines.extend(lines);
        taken.push(own);
    }
    let mut highest: f64 = 0.0;
    let mut beside_edges: Vec<BesideEdge> = Vec::new();
    let is_possible = |i: usize| !is_oriented || matches!(neighbours.get(i), Some(Some(_)));
    let possible_sides = sides(outline).enumerate().filter(|&(i, _)| is_possible(i));
    let of_openings = rings[1..].iter().flat_map(|&opening| sides(opening));
    let possible_sides: Vec<[Point2; 2]> =
        possible_sides.map(|(_, side)| side).chain(of_openings).collect();
    for &(edge, neighbour, bevel) in &named_sides {
        let tallest = beside.min(height);
        let found = beside_edge(
            &rings,
            (edge, &possible_sides),
            (neighbour, tallest),
            turn,
            (&taken, holes),
        );
        match found {
            Some((height, own)) => {
                highest = highest.max(height);
                let words = neighbour.to_owned();
                beside_edges.push(BesideEdge { edge, bevel, at: taken.len(), words, height });
                taken.push(own);
            }
            None => labels.dropped += 1,
        }
    }
    // A bevel takes no room from a name.
    for BesideEdge { edge, bevel, at, words, height } in &mut beside_edges {
        let Some(bevel) = *bevel else { continue };
        let longer = format!("{words} {}", bevel_words(bevel));
        let mut others = taken.clone();
        others.swap_remove(*at);
        let found = beside_edge(
            &rings,
            (*edge, &possible_sides),
            (&longer, *height),
            turn,
            (&others, holes),
        );
        if let Some((lower, own)) = found.filter(|(lower, _)| *lower >= WITH_BEVEL * *height) {
            (taken[*at], *words, *height) = (own, longer, lower);
        }
    }
    for BesideEdge { at, words, height, .. } in beside_edges {
        labels.lines.extend(strokes(&words, height, taken[at].centre, taken[at].along));
        labels.texts.push(words);
    }
    if highest > ALIKE * height {
        labels.lines.push(underline(own, text_width(name, height), height));
    }
    (labels, has_arrow)
}

/// A line below the text of a box.
pub(super) fn underline(
    TextBox { centre, along: [c, s], .. }: TextBox,
    width: f64,
    height: f64,
) -> Vec<Point2> {
    let down = (0.5 + BELOW) * height;
    let at = |x: f64| [centre[0] + c * x + s * down, centre[1] + s * x - c * down];
    vec![at(-0.5 * width), at(0.5 * width)]
}

/// The centroid of the outline as a curve.
fn middle(outline: &[Point2]) -> Point2 {
    let (mut sum, mut whole) = ([0.0; 2], 0.0);
    for [p, q] in sides(outline) {
        let length = distance(p, q);
        (0..2).for_each(|x| sum[x] += 0.5 * length * (p[x] + q[x]));
        whole += length;
    }
    sum.map(|sum| sum / whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::sheet::beside_edge::is_nearest;
    use crate::math::plane::rotated;

    /// Width and height of polylines.
    fn extent(lines: &[Vec<Point2>]) -> [f64; 2] {
        [0, 1].map(|x| {
            let at = || lines.iter().flatten().map(|point| point[x]);
            at().fold(f64::NEG_INFINITY, f64::max) - at().fold(f64::INFINITY, f64::min)
        })
    }

    const AS_IT_IS: Point2 = [1.0, 0.0];

    #[test]
    fn the_own_name_is_larger_than_those_of_the_neighbours() {
        let outline = [[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]];
        let one = [Some("H".to_owned())];
        let [own, both] = [&[][..], &one[..]].map(|neighbours| {
            let (name, arrow, turn) = ("H", None, AS_IT_IS);
            let holes = &[][..];
            label(Inscription {
                outline: &outline,
                name,
                neighbours,
                bevels: &[],
                is_oriented: false,
                arrow,
                turn,
                holes,
            })
        });
        let beside = &both.lines[own.lines.len()..];
        assert!(extent(&own.lines)[1] > 1.5 * extent(beside)[1]);
        assert_eq!((both.dropped, both.texts.len()), (0, 2));
    }

    #[test]
    fn the_own_name_is_underlined_where_those_of_neighbours_are_as_high() {
        let neighbour = Some("P7".to_owned());
        let neighbours = &[neighbour.clone(), None, neighbour, None][..];
        let (name, arrow, turn, holes) = ("P5", None, AS_IT_IS, &[][..]);
        // Equally wide, with or without room for a larger name in the middle.
        for (high, is_underlined) in [(14.0, false), (11.5, true)] {
            let outline = &[[0.0, 0.0], [8.0, 0.0], [8.0, high], [0.0, high]][..];
            let own = Inscription {
                outline,
                name,
                neighbours,
                bevels: &[],
                is_oriented: false,
                arrow,
                turn,
                holes,
            };
            let found = label(own);
            assert_eq!((found.dropped, found.small, found.texts.len()), (0, false, 3));
            let below = |line: &&Vec<Point2>| {
                let [p, q] = line[..] else { return false };
                p[1] == q[1] && q[0] - p[0] > 0.9 * text_width(name, 2.0) && p[1] < 0.5 * high
            };
            assert_eq!(found.lines.iter().filter(below).count(), usize::from(is_underlined));
        }
    }

    #[test]
    fn a_name_is_nearer_to_its_own_edge_than_to_another() {
        // At its short edges there is room for a name only beside a longer one.
        let outline = [[0.0, 0.0], [30.0, 0.0], [32.0, 4.0], [30.0, 20.0], [0.0, 20.0]];
        let (arrow, turn, holes) = (None, AS_IT_IS, &[][..]);
        for k in 0..outline.len() {
            let mut neighbours = vec![None; outline.len()];
            let own = |neighbours: &[Option<String>]| {
                let outline = &outline[..];
                label(Inscription {
                    outline,
                    name: "P1",
                    neighbours,
                    bevels: &[],
                    is_oriented: false,
                    arrow,
                    turn,
                    holes,
                })
            };
            let before = own(&neighbours).lines.len();
            neighbours[k] = Some("P120".to_owned());
            let found = own(&neighbours);
            if found.dropped > 0 {
                continue;
            }
            let text = &found.lines[before..];
            let middle = [0, 1].map(|x| {
                let at = || text.iter().flatten().map(|point| point[x]);
                let [low, high] =
                    [at().fold(f64::INFINITY, f64::min), at().fold(f64::NEG_INFINITY, f64::max)];
                0.5 * (low + high)
            });
            let side = |k: usize| [outline[k], outline[(k + 1) % 5]];
            let possible_sides: Vec<_> = (0..5).filter(|i| *i != k).map(side).collect();
            assert!(is_nearest(side(k), &possible_sides, middle), "edge {k}: {middle:?}");
        }
    }

    #[test]
    fn names_at_the_ends_of_a_slender_part_lie_along_it() {
        let outline = [[0.0, 0.0], [60.0, 0.0], [60.0, 5.0], [0.0, 5.0]];
        let neighbours = [None, Some("N12".to_owned()), None, Some("N7".to_owned())];
        let (name, arrow, turn) = ("B7-12", Some([0.0, -1.0]), AS_IT_IS);
        let (outline, neighbours, holes) = (&outline[..], &neighbours[..], &[][..]);
        let found = label(Inscription {
            outline,
            name,
            neighbours,
            bevels: &[],
            is_oriented: true,
            arrow,
            turn,
            holes,
        });
        assert_eq!((found.dropped, found.small), (0, false));
        assert_eq!(found.texts, ["B7-12", "N12", "N7"]);
    }

    #[test]
    fn the_name_of_a_slender_part_keeps_away_from_the_holes_at_its_ends() {
        // A little wider at its end, as a fin is: without the hole there is most room.
        let outline = [[0.0, 0.0], [80.0, 0.0], [80.0, 10.2], [0.0, 10.0]];
        let holes = [4.0, 76.0].map(|x| Hole::round([x, 5.0], 1.0));
        let (outline, name, neighbours, turn) = (&outline[..], "B10-11", &[][..], AS_IT_IS);
        let height = |holes: &[Hole]| {
            let own = Inscription {
                outline,
                name,
                neighbours,
                bevels: &[],
                is_oriented: false,
                arrow: None,
                turn,
                holes,
            };
            let found = label(own);
            assert!(!found.small);
            extent(&found.lines)[1]
        };
        assert!((height(&holes) - height(&[])).abs() < 1e-9);
    }

    #[test]
    fn an_arrow_has_its_direction_wherever_there_is_room_for_it() {
        // Ahead of the name there is room in the square only; beside it in the bar too.
        for high in [60.0, 9.0] {
            let outline = [[0.0, 0.0], [60.0, 0.0], [60.0, high], [0.0, high]];
            for degrees in (0..360).step_by(15) {
                let way = crate::math::cosine_and_sine_of_degrees(f64::from(degrees));
                let own = |arrow: Option<Point2>| {
                    let (neighbours, holes, turn) = (&[][..], &[][..], AS_IT_IS);
                    let (outline, name) = (&outline[..], "P1");
                    let is_oriented = false;
                    let own = Inscription {
                        outline,
                        name,
                        neighbours,
                        bevels: &[],
                        is_oriented,
                        arrow,
                        turn,
                        holes,
                    };
                    label(own).lines
                };
                let (without, with) = (own(None), own(Some(way)));
                assert_eq!(with.len(), without.len() + 2, "{high} {degrees}");
                let [from, to] = with[without.len()][..] else { panic!("a line") };
                let found = direction_of(from, to);
                assert!(distance(found, way) < 1e-9, "{high} {degrees}: {found:?}");
            }
        }
    }

    #[test]
    fn a_bevel_is_written_behind_a_name_where_that_leaves_all_names_as_they_are() {
        let neighbours = ["P12", "P3", "P4", "P5"].map(|name| Some(name.to_owned()));
        let bevels = [Some(12.34), Some(-0.46), None, Some(45.0)];
        for (size, expected) in [
            (60.0, ["P1", "P12 +12.3", "P3 -0.5", "P4", "P5 +45"]),
            (13.0, ["P1", "P12", "P3", "P4", "P5"]),
        ] {
            let outline = &[[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]][..];
            let found = |bevels: &[Option<f64>]| {
                label(Inscription {
                    outline,
                    name: "P1",
                    neighbours: &neighbours,
                    bevels,
                    is_oriented: false,
                    arrow: None,
                    turn: AS_IT_IS,
                    holes: &[],
                })
            };
            let (with, without) = (found(&bevels), found(&[]));
            assert_eq!((with.dropped, with.small), (without.dropped, without.small));
            assert_eq!(with.texts, expected);
        }
    }

    #[test]
    fn what_is_nearly_vertical_reads_upwards_whatever_the_turn() {
        for degrees in (-180..180).step_by(5) {
            let (s, c) = libm::sincos(f64::from(degrees).to_radians());
            for turn in [AS_IT_IS, [0.0, 1.0], [-1.0, 0.0]] {
                let [x, y] = rotated(upright([c, s], turn), turn);
                assert!(x > 0.25 || (y > 0.0 && x > -0.25), "{degrees}");
            }
        }
    }
}
