//! A sheet as lines with roles: the input of all file formats.

use crate::fabricate::sheet::{CutPart, Hole, Role, Sheet, strokes, text_width};
use crate::math::plane::Point2;

/// A polyline of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLine {
    /// Its purpose, which determines layer and colour.
    pub role: Role,
    /// Its points in mm from the lower left corner of the sheet.
    pub points: Vec<Point2>,
    /// Whether the last point is joined to the first, which is not repeated: true for outlines and
    /// holes only.
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
    /// Its lines.
    pub lines: Vec<DrawnLine>,
}

/// Height of the title in mm; it is left out if it does not fit into the margin.
const TITLE: f64 = 2.5;

impl Drawing {
    /// Draws a sheet. With `outlines_only` it has only outlines and holes.
    pub fn new(
        name: String,
        title: String,
        size: [f64; 2],
        margin: f64,
        sheet: &Sheet,
        parts: &[CutPart],
        outlines_only: bool,
    ) -> Drawing {
        let mut drawing = Drawing { name, title, size, lines: Vec::new() };
        if !outlines_only {
            drawing.frame(margin);
        }
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
                drawing.lines.extend(lines.iter().map(|points| DrawnLine {
                    role,
                    points: put(points),
                    closed,
                    part: part.name.clone(),
                    panels: if role == Role::Cut { part.panels.clone() } else { Vec::new() },
                }));
            }
        }
        drawing
    }

    /// Adds the border of the sheet, and its title in the margin.
    fn frame(&mut self, margin: f64) {
        let [width, height] = self.size;
        let corners = vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height], [0.0, 0.0]];
        self.add(corners);
        let long = text_width(&self.title, TITLE);
        if margin >= TITLE + 1.5 && long <= width - 2.0 * margin {
            let centre = [margin + 0.5 * long, 0.5 * margin];
            for stroke in strokes(&self.title, TITLE, centre, [1.0, 0.0]) {
                self.add(stroke);
            }
        }
    }

    fn add(&mut self, points: Vec<Point2>) {
        self.lines.push(DrawnLine::of_sheet(points));
    }
}
