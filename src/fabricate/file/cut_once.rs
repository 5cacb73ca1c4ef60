//! Lines that two outlines on a sheet share, or one that touches itself, are cut once: a second cut
//! along them chars the edge, and takes a knife or a tool off its line. With a kerf, outlines are half of
//! it beside their parts, and the one cut leaves both as large as they should be.

use super::drawing::{Drawing, DrawnLine};
use crate::fabricate::boxes::Boxes;
use crate::fabricate::panel::{direction_of, perimeter, sides};
use crate::fabricate::sheet::Role;
use crate::math::plane::{Point2, bounds, cross, distance, dot, minus};
use crate::math::{key_of_number, sort_by_number};

/// Lines nearer to each other than this, in mm, are one: no machine is more accurate, and rows of parts
/// without a gap are up to 0.01 mm apart.
const SAME: f64 = 0.02;
/// Shorter lines than this, in mm, may be cut twice.
const SHORTEST: f64 = 0.2;

/// What is cut of each outline, as open lines, if something of it is cut already with those before it
/// or with itself; else none.
fn cut_once<'a>(outlines: impl Iterator<Item = &'a [Point2]>) -> Vec<Option<Vec<Vec<Point2>>>> {
    let mut lines = CutLines::default();
    outlines.enumerate().map(|(number, outline)| lines.add(number, outline)).collect()
}

/// The length of what outlines share with others or with themselves, in mm.
pub(in crate::fabricate) fn shared_length(outlines: &[Vec<Point2>]) -> f64 {
    let shared = |(outline, cut): (&Vec<Point2>, Option<Vec<Vec<Point2>>>)| {
        Some(perimeter(outline) - length_of(&cut?))
    };
    let cut = cut_once(outlines.iter().map(|outline| &**outline));
    outlines.iter().zip(cut).filter_map(shared).fold(0.0, |a, b| a + b)
}

fn length_of(lines: &[Vec<Point2>]) -> f64 {
    lines.iter().flat_map(|line| line.windows(2)).map(|ends| distance(ends[0], ends[1])).sum()
}

/// The lines so far.
#[derive(Default)]
struct CutLines {
    lines: Vec<Line>,
    boxes: Boxes,
}

struct Line {
    ends: [Point2; 2],
    /// The number of its outline, and of its side there.
    of: [usize; 2],
}

impl CutLines {
    fn add(&mut self, number: usize, outline: &[Point2]) -> Option<Vec<Vec<Point2>>> {
        let n = outline.len();
        let mut runs: Vec<Vec<Point2>> = Vec::new();
        let mut is_shared = false;
        for (k, side) in sides(outline).enumerate() {
            // A spur of a relief is cut back and forth.
            let is_beside = |of: [usize; 2]| {
                of[0] == number && [k + 1, k + n - 1].iter().any(|other| of[1] == other % n)
            };
            for [p, q] in self.uncut(side, is_beside, &mut is_shared) {
                self.boxes.insert(self.lines.len() as u32, bounds([p, q]));
                self.lines.push(Line { ends: [p, q], of: [number, k] });
                match runs.last_mut().filter(|run| run.last() == Some(&p)) {
                    Some(run) => run.push(q),
                    None => runs.push(vec![p, q]),
                }
            }
        }
        if !is_shared {
            return None;
        }
        // The last run may lead to the first.
        if runs.len() > 1 && runs[0].first() == runs[runs.len() - 1].last() {
            let first = runs.swap_remove(0);
            // The last one is in its place.
            runs[0].extend(first.into_iter().skip(1));
        }
        Some(runs)
    }

    /// What of a side is not yet cut.
    fn uncut(
        &self,
        [p, q]: [Point2; 2],
        is_beside: impl Fn([usize; 2]) -> bool,
        is_shared: &mut bool,
    ) -> Vec<[Point2; 2]> {
        let (length, along) = (distance(p, q), direction_of(p, q));
        let [low, high] = bounds([p, q]);
        let around = [low.map(|x| x - SAME), high.map(|x| x + SAME)];
        let mut cut: Vec<[f64; 2]> = Vec::new();
        for line in self.boxes.meeting(around).map(|k| &self.lines[k as usize]) {
            if is_beside(line.of) {
                continue;
            }
            let at = line.ends.map(|end| {
                let away = minus(end, p);
                [dot(along, away), cross(along, away)]
            });
            let [from, to] = if at[0][0] < at[1][0] { at } else { [at[1], at[0]] };
            let common = [from[0].max(0.0), to[0].min(length)];
            let aside = |x: f64| from[1] + (x - from[0]) / (to[0] - from[0]) * (to[1] - from[1]);
            if common[1] - common[0] > SHORTEST && common.iter().all(|&x| aside(x).abs() < SAME) {
                cut.push(common);
            }
        }
        if cut.is_empty() {
            return vec![[p, q]];
        }
        *is_shared = true;
        sort_by_number(&mut cut, |piece| key_of_number(piece[0]));
        let (mut rest, mut done) = (Vec::new(), 0.0_f64);
        for [from, to] in cut.into_iter().chain([[length, length]]) {
            if from - done > SAME {
                rest.push([done, from]);
            }
            done = done.max(to);
        }
        let point = |x: f64| match x {
            0.0 => p,
            x if x == length => q,
            x => [p[0] + x * along[0], p[1] + x * along[1]],
        };
        rest.into_iter().map(|ends| ends.map(point)).collect()
    }
}

impl Drawing {
    /// The drawing as it is cut: each line once.
    pub(in crate::fabricate) fn cut_once(mut self) -> Drawing {
        let is_outline = |line: &&DrawnLine| line.role == Role::Cut;
        let outlines = self.lines.iter().filter(is_outline).map(|line| &*line.points);
        let mut once = cut_once(outlines).into_iter();
        let lines = std::mem::take(&mut self.lines);
        for line in lines {
            let runs = if line.role == Role::Cut { once.next().flatten() } else { None };
            match runs {
                None => self.lines.push(line),
                Some(runs) => self.lines.extend(runs.into_iter().map(|points| DrawnLine {
                    points,
                    closed: false,
                    ..line.clone()
                })),
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle([x, y]: Point2, [width, height]: [f64; 2]) -> Vec<Point2> {
        vec![[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
    }

    #[test]
    fn a_line_that_outlines_share_in_part_is_cut_once() {
        let all = [
            rectangle([0.0, 0.0], [30.0, 20.0]),
            // Beside it, and higher; half of its side is cut already.
            rectangle([30.0 + 1e-7, 10.0], [30.0, 20.0]),
            // Above the first, and as high as the second.
            rectangle([0.0, 20.0], [30.0, 10.0]),
            // Apart from all.
            rectangle([70.0, 0.0], [5.0, 5.0]),
        ];
        let found = cut_once(all.iter().map(|own| &**own));
        assert!(found[0].is_none() && found[3].is_none());
        let [second, third] = [1, 2].map(|k| found[k].as_ref().expect("it shares a line"));
        assert_eq!((second.len(), third.len()), (1, 1), "{second:?} {third:?}");
        assert!((length_of(second) - 90.0).abs() < 1e-6);
        // Its lower side, and the side at the second.
        assert!((length_of(third) - 40.0).abs() < 1e-6);
    }

    #[test]
    fn an_outline_that_touches_itself_is_cut_once_there_and_a_spur_is_kept() {
        // Around a ring, with a slit without width.
        let ring = [
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 10.0],
            [0.0, 10.0],
            [0.0, 0.0],
            [3.0, 3.0],
            [3.0, 6.0],
            [6.0, 6.0],
            [6.0, 3.0],
            [3.0, 3.0],
        ];
        let found = cut_once([&ring[..]].into_iter());
        let lines = found[0].as_ref().expect("it touches itself");
        let slit = distance(ring[4], ring[5]);
        assert!((length_of(lines) - (40.0 + 12.0 + slit)).abs() < 1e-9, "{lines:?}");
        let spur = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [5.0, 10.0], [6.0, 7.0], [5.0, 10.0]];
        assert_eq!(cut_once([&spur[..]].into_iter()), [None]);
    }
}
