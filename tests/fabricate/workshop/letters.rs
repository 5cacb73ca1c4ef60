//! Reads single-line letters: the strokes of a sheet, in the order in which they are drawn, as texts.

use shape_up::fabricate::sheet::strokes;
use shape_up::math::plane::{Point2, cross, distance, dot, minus};

/// Largest distance of a point from where its letter has it, in mm: coordinates are rounded.
const EXACT: f64 = 1e-3;
/// The letters, with the space.
const LETTERS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+.,:/%";
/// Height of a letter, and the step to the next one, in units of its grid.
const HEIGHT: f64 = 6.0;
const STEP: f64 = 6.0;

/// A line of text.
#[derive(Clone, Debug)]
pub(super) struct Text {
    pub(super) text: String,
    /// The middle of the line.
    pub(super) centre: Point2,
    /// The unit vector along it.
    pub(super) along: Point2,
    /// The height of its letters.
    pub(super) height: f64,
    /// Whether a line is drawn below it.
    pub(super) is_underlined: bool,
}

/// The frame of a letter: the lower left corner of its grid, and the step to the right by one unit.
#[derive(Clone, Copy)]
struct Frame {
    origin: Point2,
    unit: Point2,
}

impl Frame {
    fn at(&self, [x, y]: Point2) -> Point2 {
        let [u, v] = self.unit;
        [self.origin[0] + x * u - y * v, self.origin[1] + x * v + y * u]
    }

    fn after(&self, letters: f64) -> Frame {
        Frame { origin: self.at([letters * STEP, 0.0]), ..*self }
    }
}

/// The strokes of a letter in units of its grid.
fn glyph(letter: char) -> Vec<Vec<Point2>> {
    strokes(&letter.to_string(), HEIGHT, [2.0, 3.0], [1.0, 0.0])
}

/// The frame in which the first of these lines are the strokes of a letter.
fn frame_of(letter: &[Vec<Point2>], lines: &[Vec<Point2>], exact: f64) -> Option<Frame> {
    let drawn: Vec<Point2> = lines.iter().take(letter.len()).flatten().copied().collect();
    let points: Vec<Point2> = letter.iter().flatten().copied().collect();
    let far = points.iter().position(|&p| distance(p, points[0]) > 3.0)?;
    let (a, b) = (minus(points[far], points[0]), minus(*drawn.get(far)?, drawn[0]));
    let unit = [dot(a, b), cross(a, b)].map(|x| x / dot(a, a));
    let start = Frame { origin: [0.0; 2], unit }.at(points[0]);
    let frame = Frame { origin: minus(drawn[0], start), unit };
    is_drawn(letter, frame, lines, exact).then_some(frame)
}

/// Whether the first of these lines are the strokes of a letter in its frame.
fn is_drawn(letter: &[Vec<Point2>], frame: Frame, lines: &[Vec<Point2>], exact: f64) -> bool {
    lines.len() >= letter.len()
        && letter.iter().zip(lines).all(|(stroke, line)| {
            stroke.len() == line.len()
                && stroke.iter().zip(line).all(|(&p, &q)| distance(frame.at(p), q) < exact)
        })
}

/// Reads all texts among some lines, which begin with a letter from A to Z. Arrows are skipped.
pub(super) fn read(lines: &[Vec<Point2>]) -> Vec<Text> {
    read_within(lines, EXACT)
}

/// Reads all texts whose points may be so far from their places, in mm.
pub(super) fn read_within(lines: &[Vec<Point2>], exact: f64) -> Vec<Text> {
    let known: Vec<(char, Vec<Vec<Point2>>)> = LETTERS.chars().map(|c| (c, glyph(c))).collect();
    let size = |letter: &[Vec<Point2>]| letter.iter().map(Vec::len).sum::<usize>();
    let (mut found, mut at): (Vec<Text>, usize) = (Vec::new(), 0);
    while at < lines.len() {
        let capitals = known.iter().filter(|(c, _)| c.is_ascii_uppercase());
        let first =
            capitals.filter_map(|(c, own)| Some((*c, own, frame_of(own, &lines[at..], exact)?)));
        let Some((c, own, start)) = first.max_by_key(|(_, own, _)| size(own)) else {
            if let Some(text) = found.iter_mut().find(|text| underlines(&lines[at], text)) {
                text.is_underlined = true;
            }
            at += 1;
            continue;
        };
        let (mut text, mut frame) = (c.to_string(), start);
        at += own.len();
        loop {
            // After a space, if the next cell is empty.
            let next = [(1.0, ""), (2.0, " ")].into_iter().find_map(|(step, space)| {
                let there = frame.after(step);
                let fits =
                    known.iter().filter(|(_, own)| is_drawn(own, there, &lines[at..], exact));
                let (c, own) = fits.max_by_key(|(_, own)| size(own))?;
                // Where it is drawn, or errors would add up.
                let there = frame_of(own, &lines[at..], exact).unwrap_or(there);
                Some((format!("{space}{c}"), own.len(), there))
            });
            let Some((letters, count, there)) = next else { break };
            text += &letters;
            (frame, at) = (there, at + count);
        }
        let unit = (start.unit[0] * start.unit[0] + start.unit[1] * start.unit[1]).sqrt();
        let [p, q] = [start.at([0.0, 3.0]), frame.at([4.0, 3.0])];
        found.push(Text {
            text,
            centre: [0, 1].map(|k| 0.5 * (p[k] + q[k])),
            along: start.unit.map(|x| x / unit),
            height: HEIGHT * unit,
            is_underlined: false,
        });
    }
    found
}

/// Whether a line is one below a text. It is drawn last on its part.
fn underlines(line: &[Point2], text: &Text) -> bool {
    let [p, q] = line[..] else { return false };
    let middle = [0, 1].map(|k| 0.5 * (p[k] + q[k]));
    let away = minus(middle, text.centre);
    dot(away, text.along).abs() < EXACT
        && cross(minus(q, p), text.along).abs() < EXACT
        && (0.5..0.9).contains(&(-cross(text.along, away) / text.height))
}

#[test]
fn all_letters_are_read_in_every_direction() {
    for (text, along) in [
        ("SHEET 1/2, SCALE 1:20", [1.0, 0.0]),
        ("QUICK BROWN FOX JUMPS OVER A LAZY DOG 0123456789-+.%", [-0.6, 0.8]),
    ] {
        let [found] = &read(&strokes(text, 2.0, [7.0, 9.0], along))[..] else { panic!("{text}") };
        assert_eq!(found.text, text);
        assert!(distance(found.centre, [7.0, 9.0]) < 1e-9 && distance(found.along, along) < 1e-9);
    }
}
