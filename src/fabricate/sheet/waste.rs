//! Names beside parts that have no room for them: on the waste, next to the outline.

use super::lettering::text_width;
use crate::fabricate::boxes::{Boxes, Corners};
use crate::fabricate::panel::{direction_of, sides};
use crate::math::plane::{Point2, bounds, is_inside};

/// Heights of such a name in mm, the best first.
const HEIGHTS: [f64; 3] = [3.5, 2.7, 2.0];
/// Distance from its own part, relative to the height.
const NEAR: f64 = 0.3;
/// Least distance from other parts, relative to the height, to show which part it belongs to.
const FAR: f64 = 1.0;
/// Positions tried along a side.
const SHARES: [f64; 3] = [0.5, 0.2, 0.8];

/// A sheet with parts, and the names written beside them.
pub struct Waste {
    /// The area that may be written on.
    room: Corners,
    /// The outline of each part on the sheet.
    outlines: Vec<Vec<Point2>>,
    /// The boxes of the outlines.
    parts: Boxes,
    /// The names so far.
    names: Boxes,
}

impl Waste {
    /// Makes a sheet of this size with the outlines of its parts, all in mm.
    pub fn new(size: [f64; 2], margin: f64, outlines: Vec<Vec<Point2>>) -> Waste {
        let room = [[margin; 2], size.map(|size| size - margin)];
        let parts = Boxes::of(outlines.iter().map(|outline| bounds(outline.iter().copied())));
        Waste { room, outlines, parts, names: Boxes::default() }
    }

    /// The height and the centre of a name beside the outline `own`, along an axis of the sheet, as
    /// high as there is room; none without room. Its area is then reserved.
    pub fn write(&mut self, own: usize, name: &str, along: Point2) -> Option<(f64, Point2)> {
        let outline = self.outlines.get(own)?;
        for height in HEIGHTS {
            let mut half = [0.5 * text_width(name, height), 0.5 * height];
            if along[0] == 0.0 {
                half.swap(0, 1);
            }
            let grown = |centre: Point2, by: f64| {
                [-1.0, 1.0].map(|sign| [0, 1].map(|x| centre[x] + sign * (half[x] + by)))
            };
            for [p, q] in sides(outline) {
                let [c, s] = direction_of(p, q);
                // Outwards, until the text is clear of the side.
                let away = s.abs() * half[0] + c.abs() * half[1] + NEAR * height;
                for share in SHARES {
                    let centre = [
                        p[0] + share * (q[0] - p[0]) + away * s,
                        p[1] + share * (q[1] - p[1]) - away * c,
                    ];
                    if self.is_free(
                        own,
                        grown(centre, 0.5 * NEAR * height),
                        grown(centre, FAR * height),
                    ) {
                        self.names.insert(own as u32, grown(centre, FAR * height));
                        return Some((height, centre));
                    }
                }
            }
        }
        None
    }

    /// Whether `near` is free of part `own` and of names, and the larger `far` of all other parts.
    fn is_free(&self, own: usize, near: Corners, far: Corners) -> bool {
        let [low, high] = self.room;
        let is_on_sheet = (0..2).all(|x| near[0][x] >= low[x] && near[1][x] <= high[x]);
        let meets = |k: u32| {
            let k = k as usize;
            covers(&self.outlines[k], if k == own { near } else { far })
        };
        is_on_sheet
            && self.names.meeting(near).next().is_none()
            && !self.parts.meeting(far).any(meets)
    }
}

/// Whether a part covers some of a rectangle.
fn covers(outline: &[Point2], [low, high]: Corners) -> bool {
    let crosses = |[p, q]: [Point2; 2]| {
        let within = [0, 1].map(|x| [p[x].min(q[x]), p[x].max(q[x])]);
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
        let to_the_left =
            corners.map(|[x, y]| (q[0] - p[0]) * (y - p[1]) > (q[1] - p[1]) * (x - p[0]));
        (0..2).all(|x| within[x][0] < high[x] && within[x][1] > low[x])
            && to_the_left.iter().any(|left| *left != to_the_left[0])
    };
    is_inside(outline, [0, 1].map(|x| 0.5 * (low[x] + high[x]))) || sides(outline).any(crosses)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::boxes::meet;

    #[test]
    fn a_name_is_on_the_sheet_beside_its_own_part_and_away_from_others_and_their_names() {
        // Two narrow strips with a lane between them, and a third that leaves none.
        let strip = |y: f64| vec![[20.0, y], [80.0, y], [80.0, y + 1.5], [20.0, y + 1.5]];
        let mut waste = Waste::new([100.0, 40.0], 5.0, vec![strip(10.0), strip(22.0), strip(25.0)]);
        let mut names = Vec::new();
        for own in [0, 1, 2] {
            let (height, [x, y]) = waste.write(own, "S12", [1.0, 0.0]).expect("there is room");
            let half = [0.5 * text_width("S12", height), 0.5 * height];
            let text = [[x - half[0], y - half[1]], [x + half[0], y + half[1]]];
            assert!(height >= 2.0 && text[0].iter().all(|at| *at >= 5.0) && text[1][1] <= 35.0);
            for (k, y) in [10.0, 22.0, 25.0].into_iter().enumerate() {
                let by = if k == own { 0.0 } else { 0.9 * height };
                let near = [[20.0 - by, y - by], [80.0 + by, y + 1.5 + by]];
                assert!(!meet(near, text), "{own} {k}");
            }
            assert!(!names.iter().any(|other| meet(*other, text)));
            names.push(text);
        }
    }
}
