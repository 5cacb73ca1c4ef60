//! An outline that may touch itself, and the largest disc that touches it from outside at a place: how far a
//! cut can be from it there.

use crate::fabricate::boxes::Boxes;
use crate::fabricate::panel::{direction_of, sides};
use crate::math::plane::{Point2, bounds, cross, distance, dot, minus};

/// Sides that overlap by less, in mm, touch: panels that count as flat are so far off.
pub(super) const TOUCHING: f64 = 0.02;
/// The cosine between the outward directions of sides that may touch so.
const OPPOSITE: f64 = -0.99;
/// Points closer than this, in mm, are one.
pub(super) const SAME: f64 = 1e-6;
/// Sines and slopes below this, and distances in mm, are rounding.
pub(super) const ROUNDING: f64 = 1e-9;

/// A side of the outline.
pub(super) struct Side {
    pub(super) start: Point2,
    pub(super) along: Point2,
    pub(super) outwards: Point2,
    pub(super) length: f64,
}

impl Side {
    pub(super) fn at(&self, along: f64) -> Point2 {
        [0, 1].map(|x| self.start[x] + along * self.along[x])
    }
}

/// An outline that may touch itself.
pub(super) struct Outline {
    pub(super) sides: Vec<Side>,
    pub(super) boxes: Boxes,
}

/// Where a disc touches the outline: a side, and how far along it.
pub(super) type Contact = (usize, f64);

impl Outline {
    pub(super) fn new(outline: &[Point2]) -> Outline {
        let boxes = Boxes::of(sides(outline).map(bounds));
        let side = |[start, end]: [Point2; 2]| {
            let along = direction_of(start, end);
            Side { start, along, outwards: [along[1], -along[0]], length: distance(start, end) }
        };
        Outline { sides: sides(outline).map(side).collect(), boxes }
    }

    pub(super) fn before(&self, k: usize) -> usize {
        (k + self.sides.len() - 1) % self.sides.len()
    }

    pub(super) fn after(&self, k: usize) -> usize {
        (k + 1) % self.sides.len()
    }

    /// Whether the outline turns inwards at the start of a side: also where a slit has no width, or less.
    pub(super) fn is_concave(&self, k: usize) -> bool {
        /// The sine of the sharpest angle of a piece.
        const SHARPEST: f64 = 0.01;
        let [u, v] = [self.before(k), k].map(|k| self.sides[k].along);
        let turn = cross(u, v);
        turn < -ROUNDING || (dot(u, v) < 0.0 && turn < SHARPEST)
    }

    /// The sides whose discs do not end at a side: itself, and its neighbours where it bulges.
    pub(super) fn own(&self, k: usize) -> [usize; 3] {
        let (before, after) = (self.before(k), self.after(k));
        let before = if self.is_concave(k) { k } else { before };
        [k, before, if self.is_concave(after) { k } else { after }]
    }

    /// Whether no other corner is at the place of the start of a side.
    pub(super) fn is_alone(&self, k: usize) -> bool {
        let corner = self.sides[k].start;
        let around = [-SAME, SAME].map(|by| corner.map(|x| x + by));
        let others = self.boxes.meeting(around).map(|v| v as usize).filter(|&v| v != k);
        others.into_iter().all(|v| distance(self.sides[v].start, corner) > SAME)
    }

    /// The radius of the largest disc that touches the outline at `base` and whose centre lies in the
    /// direction `way` from there, at most `most`, and what else it touches; the sides `own` do not count.
    pub(super) fn disc(
        &self,
        base: Point2,
        way: Point2,
        own: &[usize],
        most: f64,
    ) -> (f64, Option<Contact>) {
        let centre = |by: f64| [0, 1].map(|x| base[x] + by * way[x]);
        let [x, y] = centre(most);
        let by = most + TOUCHING;
        let mut found = (most, None);
        for v in self.boxes.meeting([[x - by, y - by], [x + by, y + by]]) {
            let v = v as usize;
            if own.contains(&v) {
                continue;
            }
            let side = &self.sides[v];
            let mut consider = |radius: f64, along: f64| {
                if radius < found.0 {
                    found = (radius, Some((v, along.clamp(0.0, side.length))));
                }
            };
            let before = dot(minus(base, side.start), side.outwards);
            let facing = dot(way, side.outwards);
            let is_on = |along: f64| (-SAME..=side.length + SAME).contains(&along);
            if before >= -SAME && facing < 1.0 - ROUNDING {
                let radius = before.max(0.0) / (1.0 - facing);
                let along = dot(minus(centre(radius), side.start), side.along);
                if is_on(along) {
                    // A side that begins at the base and leads away from the disc is not in its way.
                    let onwards = if along < 0.5 * side.length { 1.0 } else { -1.0 };
                    let is_end = along.min(side.length - along) < SAME;
                    let leads_away = onwards * dot(side.along, way) < -ROUNDING;
                    if !(before < SAME && is_end && leads_away) {
                        consider(radius, along);
                    }
                    continue;
                }
            } else if before > -TOUCHING && facing < OPPOSITE {
                let along = dot(minus(base, side.start), side.along);
                if is_on(along) {
                    consider(0.0, along);
                    continue;
                }
            }
            for along in [0.0, side.length] {
                let to = minus(side.at(along), base);
                let ahead = dot(to, way);
                if ahead > ROUNDING * most {
                    consider(0.5 * dot(to, to) / ahead, along);
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_beside_a_slit_reaches_the_other_side_and_no_more_than_is_asked() {
        // A slit 2 mm wide, from above.
        let slit = [
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 10.0],
            [6.0, 10.0],
            [6.0, 2.0],
            [4.0, 2.0],
            [4.0, 10.0],
        ];
        let slit = [&slit[..], &[[0.0, 10.0]]].concat();
        let outline = Outline::new(&slit);
        // From the right side of the slit, side 3, the left one is side 5.
        let way = outline.sides[3].outwards;
        let disc = |most: f64| outline.disc([6.0, 6.0], way, &outline.own(3), most);
        assert_eq!(disc(0.5), (0.5, None));
        let (radius, contact) = disc(3.0);
        let (side, along) = contact.expect("it touches the other side");
        assert!((radius - 1.0).abs() < 1e-12 && side == 5 && (along - 4.0).abs() < 1e-12);
        // The ends of the slit are concave, its lips are not.
        let concave: Vec<usize> = (0..slit.len()).filter(|&k| outline.is_concave(k)).collect();
        assert_eq!(concave, [4, 5]);
    }
}
