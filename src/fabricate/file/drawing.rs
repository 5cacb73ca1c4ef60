//! A sheet as lines with roles: the input of all file formats.

use crate::fabricate::sheet::{
    CutPart, Hole, Place, Role, Sheet, height_within, strokes, text_width,
};
use crate::math::plane::{Point2, bounds, is_inside, minus, rotated};
use crate::scene::Page;

/// A polyline of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLine {
    /// Its purpose, which determines layer and colour.
    pub role: Role,
    /// Its points in mm from the lower left corner of the sheet.
    pub points: Vec<Point2>,
    /// Whether the last point is joined to the first, which is not repeated: true for holes, and for
    /// outlines of which no line is cut with another one.
    pub closed: bool,
    /// The name of its part; empty for the sheet's own lines.
    pub part: String,
    /// For an outline, the panels of its part.
    pub panels: Vec<u32>,
}

impl DrawnLine {
    /// A line that belongs to no part.
    pub(in crate::fabricate) fn of_sheet(points: Vec<Point2>) -> DrawnLine {
        let (role, closed) = (Role::Sheet, false);
        DrawnLine { role, points, closed, part: String::new(), panels: Vec::new() }
    }
}

/// A sheet with all its lines, in the order of [`Role::ALL`].
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Name, such as `sheet-01`.
    pub name: String,
    /// The title line: scale, unit, material, number.
    pub title: String,
    /// Width and height in mm.
    pub size: [f64; 2],
    /// Width of the lines in mm.
    pub pen: f64,
    /// Its lines.
    pub lines: Vec<DrawnLine>,
    /// What is free of its margin, where a page may have its ruler.
    pub free: Vec<FreeBand>,
}

/// A free band in a margin, 2 mm high: a line of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeBand {
    /// The middle of its start, in mm.
    pub from: Point2,
    /// The unit vector along it.
    pub along: Point2,
    /// Its length in mm.
    pub length: f64,
}

/// Largest and least height of title and legend in mm; what does not fit into the margin is left out.
const TITLE: f64 = 2.5;
const LEAST: f64 = 1.0;
/// The least margin for them, in mm.
const ROOM: f64 = TITLE + 1.5;
/// Height of a free band in mm.
const BAND: f64 = 2.0;
/// Width of lines in mm: machines take thin ones for cuts.
const PEN: f64 = 0.1;

impl Drawing {
    /// Draws a sheet with its title below and a legend above. With `outlines_only` it has only outlines
    /// and holes.
    pub fn new(
        name: String,
        [title, legend]: [String; 2],
        size: [f64; 2],
        margin: f64,
        sheet: &Sheet,
        parts: &[CutPart],
        outlines_only: bool,
    ) -> Drawing {
        let mut drawing =
            Drawing { name, title, size, pen: PEN, lines: Vec::new(), free: Vec::new() };
        if !outlines_only {
            drawing.frame(margin, &legend);
        }
        drawing.add_parts(sheet, parts, outlines_only);
        drawing
    }

    /// Draws a part alone: the lower left corner of its outline is the origin. A name beside it is left
    /// out, since that of the file says it.
    pub fn of_part(name: String, part: &CutPart, turn: Point2, outlines_only: bool) -> Drawing {
        let [low, high] = bounds(part.outline.iter().map(|&point| rotated(point, turn)));
        let place = Place { part: 0, turn, offset: low.map(|x| -x) };
        let (title, size) = (part.name.clone(), minus(high, low));
        let mut drawing =
            Drawing { name, title, size, pen: PEN, lines: Vec::new(), free: Vec::new() };
        let sheet = Sheet { places: vec![place] };
        let is_on_it = |line: &&Vec<Point2>| line.iter().any(|&at| is_inside(&part.outline, at));
        let engraved = part.engraved.iter().filter(is_on_it).cloned().collect();
        let part = CutPart { engraved, ..part.clone() };
        drawing.add_parts(&sheet, std::slice::from_ref(&part), outlines_only);
        drawing
    }

    /// Adds the lines of the parts on a sheet.
    fn add_parts(&mut self, sheet: &Sheet, parts: &[CutPart], outlines_only: bool) {
        for role in Role::ALL {
            for place in &sheet.places {
                let part = &parts[place.part];
                let put =
                    |points: &Vec<Point2>| points.iter().map(|&p| place.to_sheet(p)).collect();
                let holes: Vec<Vec<Point2>> = part.holes.iter().map(Hole::outline).collect();
                let (lines, closed): (&[Vec<Point2>], bool) = match role {
                    Role::Cut => (std::slice::from_ref(&part.outline), true),
                    Role::Hole => (&holes, true),
                    _ if outlines_only => continue,
                    Role::Engrave => (&part.engraved, false),
                    Role::Fold => (&part.ridges, false),
                    Role::Valley => (&part.valleys, false),
                    Role::Sheet => continue,
                };
                self.lines.extend(lines.iter().map(|points| DrawnLine {
                    role,
                    points: put(points),
                    closed,
                    part: part.name.clone(),
                    panels: if role == Role::Cut { part.panels.clone() } else { Vec::new() },
                }));
            }
        }
    }

    /// Adds the border of the sheet, and its title and legend in the margin.
    fn frame(&mut self, margin: f64, legend: &str) {
        let [width, height] = self.size;
        let corners = vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height], [0.0, 0.0]];
        self.add(corners);
        if margin < ROOM {
            return;
        }
        let middle = 0.5 * margin;
        // In what is printed of a page, as far as the margin reaches there.
        let within = middle.max((Page::FREE + 0.5 * BAND).min(margin - 0.75 * BAND));
        let lines = [
            (legend.to_owned(), height - middle, height - within),
            (self.title.clone(), middle, within),
        ];
        for (text, y, free) in lines {
            let mut left = margin;
            if let Some(height) = Drawing::height_in_margin(&text, width, margin) {
                let long = text_width(&text, height);
                let centre = [left + 0.5 * long, y];
                strokes(&text, height, centre, [1.0, 0.0])
                    .into_iter()
                    .for_each(|line| self.add(line));
                left += long + 2.0 * TITLE;
            }
            let length = width - margin - left;
            self.free.push(FreeBand { from: [left, free], along: [1.0, 0.0], length });
        }
        let (from, length) = ([within, margin], height - 2.0 * margin);
        self.free.push(FreeBand { from, along: [0.0, 1.0], length });
    }

    /// The height of a title or a legend in the margin of a sheet of this width, all in mm; none if it has
    /// no room.
    pub(in crate::fabricate) fn height_in_margin(
        text: &str,
        width: f64,
        margin: f64,
    ) -> Option<f64> {
        let height = height_within(text, TITLE, width - 2.0 * margin);
        (margin >= ROOM && height >= LEAST).then_some(height)
    }

    fn add(&mut self, points: Vec<Point2>) {
        self.lines.push(DrawnLine::of_sheet(points));
    }
}
