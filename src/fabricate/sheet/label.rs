//! Names inside an outline: its own in the middle, an arrow to edge 0 where it is asked for, and along each edge that of the
//! neighbour. What does not fit is made smaller, down to a height that can still be read, and then left out
//! and counted.

use super::lettering::{strokes, text_width};
use crate::fabricate::panel::{
    Point2, direction_of, distance_to_outline, is_inside, roomiest_point,
};

/// The letters of neighbours are at most so high, in mm.
const TALLEST: f64 = 8.0;
/// And at least.
const LEAST: f64 = 2.0;
/// They are a quarter of the radius of the largest circle in the outline high.
const OF_RADIUS: f64 = 0.25;
/// The name in the middle is so many times as high, or less where that leaves room for more.
const OWN: [f64; 3] = [1.7, 1.3, 1.0];
/// The sine of the angle by which a vertical text may lean over backwards: such texts all read upwards.
const LEANING: f64 = 0.2;
/// The name of a neighbour is at most this part of its edge long.
const OF_EDGE: f64 = 0.7;
/// Room around a text, in its heights.
const ROOM: f64 = 0.35;

/// The engraved lines of a part.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    /// Polylines.
    pub lines: Vec<Vec<Point2>>,
    /// The texts that are there.
    pub texts: Vec<String>,
    /// Names of neighbours that have no room.
    pub dropped: usize,
    /// Whether its own name is smaller than can be read well.
    pub small: bool,
}

/// A rectangle in any direction that nothing else may touch.
#[derive(Clone, Copy)]
struct Box2 {
    centre: Point2,
    along: Point2,
    half: [f64; 2],
}

impl Box2 {
    fn of_text(text: &str, height: f64, centre: Point2, along: Point2) -> Box2 {
        let room = ROOM * height;
        let half = [0.5 * text_width(text, height) + room, 0.5 * height + room];
        Box2 { centre, along, half }
    }

    fn corners(&self) -> [Point2; 4] {
        let [c, s] = self.along;
        [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[i, j]| {
            let [x, y] = [i * self.half[0], j * self.half[1]];
            [self.centre[0] + c * x - s * y, self.centre[1] + s * x + c * y]
        })
    }

    /// Whether two are apart, by their separating axes.
    fn is_apart(&self, other: &Box2) -> bool {
        let separates = |axis: Point2| {
            let range = |corners: [Point2; 4]| {
                let at = corners.map(|[x, y]| x * axis[0] + y * axis[1]);
                [
                    at.into_iter().fold(f64::INFINITY, f64::min),
                    at.into_iter().fold(f64::NEG_INFINITY, f64::max),
                ]
            };
            let (a, b) = (range(self.corners()), range(other.corners()));
            a[1] <= b[0] || b[1] <= a[0]
        };
        [self, other].iter().any(|own| {
            let [c, s] = own.along;
            separates([c, s]) || separates([-s, c])
        })
    }

    /// Whether it lies in the polygon: its corners do, and the outline does not come in between.
    fn is_in(&self, outline: &[Point2]) -> bool {
        let inside = self.corners().iter().all(|&corner| is_inside(outline, corner));
        let [c, s] = self.along;
        let enters = |&[x, y]: &Point2| {
            let [x, y] = [x - self.centre[0], y - self.centre[1]];
            (c * x + s * y).abs() < self.half[0] && (c * y - s * x).abs() < self.half[1]
        };
        inside && !outline.iter().any(enters)
    }
}

/// Labels for an outline in mm: its `name`, and for each of its edges the name of the neighbour there, if
/// any. Edge `k` goes from corner `k` to the next one; an arrow to edge 0 is there where it is asked for.
pub fn label(
    outline: &[Point2],
    name: &str,
    neighbours: &[Option<String>],
    with_arrow: bool,
) -> Labels {
    let room = roomiest_point(outline);
    let mut best: Option<(usize, Labels)> = None;
    for own in OWN {
        let (labels, has_arrow) = label_of_height(outline, name, neighbours, with_arrow, room, own);
        let missing = labels.dropped + usize::from(with_arrow && !has_arrow);
        if best.as_ref().is_none_or(|(least, _)| missing < *least) {
            best = Some((missing, labels));
        }
        if missing == 0 {
            break;
        }
    }
    best.map_or_else(Labels::default, |(_, labels)| labels)
}

/// The same with the `own` name so many times as high as those of the neighbours, and whether the arrow is there.
fn label_of_height(
    outline: &[Point2],
    name: &str,
    neighbours: &[Option<String>],
    with_arrow: bool,
    (centre, radius): (Point2, f64),
    own: f64,
) -> (Labels, bool) {
    let mut labels = Labels::default();
    if radius <= 0.0 {
        labels.small = true;
        return (labels, false);
    }
    let n = outline.len();
    let longest = (0..n).max_by(|&a, &b| {
        let length = |k: usize| distance(outline[k], outline[(k + 1) % n]);
        length(a).total_cmp(&length(b)).then(b.cmp(&a))
    });
    let longest = longest.unwrap_or(0);
    let across = direction_of(outline[longest], outline[(longest + 1) % n]);
    let beside = (OF_RADIUS * radius).clamp(LEAST, TALLEST);
    let (mut height, mut own) = (own * beside, None);
    // Along x, else along the longest edge, ever smaller until it is inside.
    while own.is_none() && height > 0.02 * beside {
        for along in [[1.0, 0.0], upright(across)] {
            let found = Box2::of_text(name, height, centre, along);
            if own.is_none() && found.is_in(outline) {
                own = Some(found);
            }
        }
        if own.is_none() {
            height *= 0.85;
        }
    }
    let Some(own) = own else {
        labels.small = true;
        return (labels, false);
    };
    labels.small = height < LEAST;
    labels.lines.extend(strokes(name, height, centre, own.along));
    labels.texts.push(name.to_owned());
    let mut taken = vec![own];
    let has_arrow = with_arrow && arrow(outline, &mut labels, &mut taken, height, radius);
    for (k, neighbour) in neighbours.iter().enumerate() {
        let Some(neighbour) = neighbour else { continue };
        if !beside_edge(outline, k, neighbour, beside.min(height), &mut labels, &mut taken) {
            labels.dropped += 1;
        }
    }
    (labels, has_arrow)
}

/// The name of a neighbour inside its edge, read from inside; false where there is no room.
fn beside_edge(
    outline: &[Point2],
    k: usize,
    name: &str,
    tallest: f64,
    labels: &mut Labels,
    taken: &mut Vec<Box2>,
) -> bool {
    let (p, q) = (outline[k], outline[(k + 1) % outline.len()]);
    let along = direction_of(p, q);
    let inwards = [-along[1], along[0]];
    let mut height = tallest;
    loop {
        let fits = text_width(name, height) <= OF_EDGE * distance(p, q);
        // In the middle of the edge, else a little to either side.
        for share in [0.5, 0.38, 0.62] {
            let away = height * (0.5 + ROOM) + 0.4;
            let centre = [0, 1].map(|x| p[x] + share * (q[x] - p[x]) + away * inwards[x]);
            let own = Box2::of_text(name, height, centre, upright(along));
            if fits && own.is_in(outline) && taken.iter().all(|other| own.is_apart(other)) {
                labels.lines.extend(strokes(name, height, centre, own.along));
                labels.texts.push(name.to_owned());
                taken.push(own);
                return true;
            }
        }
        if height <= LEAST {
            return false;
        }
        height = (0.8 * height).max(LEAST);
    }
}

/// An arrow from the middle towards edge 0, as long as a letter is high; false where there is no room.
fn arrow(
    outline: &[Point2],
    labels: &mut Labels,
    taken: &mut Vec<Box2>,
    height: f64,
    radius: f64,
) -> bool {
    let Some(own) = taken.first().copied() else { return false };
    let n = outline.len();
    let aim = [0, 1].map(|x| 0.5 * (outline[0][x] + outline[1 % n][x]));
    let along = direction_of(own.centre, aim);
    let half = [0.5 * height, 0.25 * height];
    // Just outside of the box of the name.
    let mut away = 0.0;
    let room = |away: f64| {
        let centre = [0, 1].map(|x| own.centre[x] + away * along[x]);
        Box2 { centre, along, half }
    };
    while !room(away).is_apart(&own) && away < 4.0 * radius {
        away += 0.1 * height;
    }
    let found = room(away);
    let tip = [0, 1].map(|x| found.centre[x] + half[0] * along[x]);
    if !found.is_in(outline) || distance_to_outline(outline, tip) < 0.2 * height {
        return false;
    }
    let at = |x: f64, y: f64| {
        let [c, s] = along;
        [found.centre[0] + c * x - s * y, found.centre[1] + s * x + c * y]
    };
    let [x, y] = [half[0], 0.8 * half[1]];
    labels.lines.push(vec![at(-x, 0.0), at(x, 0.0)]);
    labels.lines.push(vec![at(0.1 * x, y), at(x, 0.0), at(0.1 * x, -y)]);
    taken.push(found);
    true
}

/// The direction or its opposite, whichever does not put letters on their heads: what is nearly vertical reads
/// upwards.
pub(in crate::fabricate) fn upright([c, s]: Point2) -> Point2 {
    if c < -LEANING || (c <= LEANING && s < 0.0) { [-c, -s] } else { [c, s] }
}

fn distance([a, b]: Point2, [c, d]: Point2) -> f64 {
    let [x, y] = [a - c, b - d];
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Height and width of polylines.
    fn extent(lines: &[Vec<Point2>]) -> [f64; 2] {
        [0, 1].map(|x| {
            let at = || lines.iter().flatten().map(|point| point[x]);
            at().fold(f64::NEG_INFINITY, f64::max) - at().fold(f64::INFINITY, f64::min)
        })
    }

    #[test]
    fn the_own_name_is_larger_than_those_of_the_neighbours() {
        let outline = [[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]];
        let own = label(&outline, "H", &[], false);
        let both = label(&outline, "H", &[Some("H".to_owned())], false);
        let beside = &both.lines[own.lines.len()..];
        assert!(extent(&own.lines)[1] > 1.5 * extent(beside)[1]);
        assert_eq!((both.dropped, both.texts.len()), (0, 2));
    }

    #[test]
    fn what_is_nearly_vertical_reads_upwards() {
        for degrees in (-180..180).step_by(5) {
            let (s, c) = libm::sincos(f64::from(degrees).to_radians());
            let [x, y] = upright([c, s]);
            assert!(x > 0.25 || (y > 0.0 && x > -0.25), "{degrees}");
        }
    }
}
