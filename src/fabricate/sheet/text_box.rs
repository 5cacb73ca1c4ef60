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

    /// Whether it lies on a part with this outline, its first ring, and beside the openings in it.
    pub(super) fn is_on(&self, rings: &[&[Point2]]) -> bool {
        let is_beside = |opening: &&[Point2]| {
            // An opening inside it has sides that enter it.
            !self.corners().iter().any(|&corner| is_inside(opening, corner))
                && !sides(opening).any(|side| self.is_entered_by(side))
        };
        rings.split_first().is_some_and(|(outline, openings)| {
            self.is_in(outline) && openings.iter().all(is_beside)
        })
    }

    /// Whether it lies in a polygon: its corners do, and no side of the polygon enters it, as one of
    /// a narrow notch may do although no corner is in it.
    fn is_in(&self, outline: &[Point2]) -> bool {
        self.corners().iter().all(|&corner| is_inside(outline, corner))
            && !sides(outline).any(|side| self.is_entered_by(side))
    }

    fn is_entered_by(&self, side: [Point2; 2]) -> bool {
        let [c, s] = self.along;
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

    #[test]
    fn a_text_on_a_part_is_beside_its_openings_wherever_they_are() {
        let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
        let (outline, opening) = (square(0.0, 60.0), square(45.0, 55.0));
        let text = |at: f64, half: [f64; 2]| TextBox { centre: [at, at], along: [1.0, 0.0], half };
        for (at, half, is_on) in [
            // On the way from the outline to the opening there is nothing.
            (26.0, [12.0, 4.0], true),
            (50.0, [1.0, 1.0], false),
            (46.0, [4.0, 2.0], false),
            (50.0, [8.0, 8.0], false),
        ] {
            assert_eq!(text(at, half).is_on(&[&outline, &opening]), is_on, "{at} {half:?}");
        }
    }
}
