//! The rectangle around a text or a hole: what it overlaps.

use super::lettering::text_width;
use super::part::Hole;
use crate::fabricate::panel::{direction_of, sides};
use crate::math::plane::{Point2, bounds, is_inside, length, minus, rotated};

/// Room around a text, relative to its height.
pub(super) const ROOM: f64 = 0.35;

/// A rotated rectangle that nothing else may overlap.
#[derive(Clone, Copy)]
pub(super) struct TextBox {
    pub(super) centre: Point2,
    pub(super) along: Point2,
    pub(super) half: [f64; 2],
}

impl TextBox {
    pub(super) fn of_text(text: &str, height: f64, centre: Point2, along: Point2) -> TextBox {
        let room = ROOM * height;
        let half = [0.5 * text_width(text, height) + room, 0.5 * height + room];
        TextBox { centre, along, half }
    }

    pub(super) fn of_hole(hole: &Hole) -> TextBox {
        match &hole.slot {
            None => TextBox { centre: hole.centre, along: [1.0, 0.0], half: [hole.radius; 2] },
            Some(outline) => TextBox::of_slot(outline),
        }
    }

    /// Along the first side of an outline.
    fn of_slot(outline: &[Point2]) -> TextBox {
        let along = match outline {
            [p, q, ..] => direction_of(*p, *q),
            _ => [1.0, 0.0],
        };
        let [c, s] = along;
        let [low, high] = bounds(outline.iter().map(|&point| rotated(point, [c, -s])));
        let centre = rotated([0, 1].map(|k| 0.5 * (low[k] + high[k])), along);
        TextBox { centre, along, half: [0, 1].map(|k| 0.5 * (high[k] - low[k])) }
    }

    fn corners(&self) -> [Point2; 4] {
        let [c, s] = self.along;
        [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[i, j]| {
            let [x, y] = [i * self.half[0], j * self.half[1]];
            [self.centre[0] + c * x - s * y, self.centre[1] + s * x + c * y]
        })
    }

    /// The distance of its farthest corner from the origin.
    pub(super) fn reach(&self) -> f64 {
        self.corners().into_iter().map(length).fold(0.0, f64::max)
    }

    /// Whether two are disjoint, by their separating axes.
    pub(super) fn is_apart(&self, other: &TextBox) -> bool {
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

    /// Whether it lies in a polygon: its corners do, and no side of the polygon enters it, as one of
    /// a narrow notch may do although no corner is in it.
    pub(super) fn is_in(&self, outline: &[Point2]) -> bool {
        let inside = self.corners().iter().all(|&corner| is_inside(outline, corner));
        let [c, s] = self.along;
        let enters = |side: [Point2; 2]| {
            let [p, q] = side.map(|point| {
                let [x, y] = minus(point, self.centre);
                [c * x + s * y, c * y - s * x]
            });
            // The shares of the side between which it is within the bounds of each axis.
            let (mut from, mut to) = (0.0_f64, 1.0_f64);
            for k in 0..2 {
                let (step, half) = (q[k] - p[k], self.half[k]);
                if step != 0.0 {
                    let [a, b] = [(-half - p[k]) / step, (half - p[k]) / step];
                    (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
                } else if p[k].abs() >= half {
                    return false;
                }
            }
            from < to
        };
        inside && !sides(outline).any(enters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_across_a_notch_is_not_in_the_outline() {
        // The notch is narrower than the text, and its tip and its mouth are beyond.
        let outline = [
            [0.0, 0.0],
            [20.0, 0.0],
            [20.0, 20.0],
            [10.2, 20.0],
            [10.0, 2.0],
            [9.8, 20.0],
            [0.0, 20.0],
        ];
        let text = |centre: Point2, along: Point2| TextBox { centre, along, half: [4.0, 1.0] };
        for along in [[1.0, 0.0], [0.8, 0.6], [0.0, 1.0]] {
            assert!(!text([10.0, 10.0], along).is_in(&outline), "{along:?}");
            assert!(text([5.0, 10.0], along).is_in(&outline), "{along:?}");
        }
    }
}
