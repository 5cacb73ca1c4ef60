//! The paper for a view, or for the shape unrolled: the smallest on which its names can be read, and the drawing.

use super::view::{Mark, Spot};
use crate::fabricate::file::{Drawing, DrawnLine};
use crate::fabricate::sheet::{Role, height_within, strokes, text_width};
use crate::math::plane::Point2;

/// A4 to A0: shorter and longer side, in mm.
const PAPERS: [[f64; 2]; 5] =
    [[210.0, 297.0], [297.0, 420.0], [420.0, 594.0], [594.0, 841.0], [841.0, 1189.0]];
/// Free margin, in mm, and the height of the title in it, unless that is too long for the page.
const MARGIN: f64 = 12.0;
const TITLE: [f64; 2] = [3.0, 8.0];
/// Height of the title relative to the longer side.
const OF_PAGE: f64 = 0.008;
/// Width of lines, in mm: to be seen from afar.
const PEN: f64 = 0.25;
/// Heights of names in mm: the least that is written, the least that is read well, the largest.
const LEAST: f64 = 1.0;
const READABLE: f64 = 1.8;
const LARGEST: f64 = 5.0;
/// A paper is large enough if this fraction of the names is read well.
const MOST: f64 = 0.95;

/// A page, and the scale of a view on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Page {
    /// Width and height in mm.
    size: [f64; 2],
    /// Millimetres per unit of the mesh.
    scale: f64,
}

impl Page {
    /// The smallest page for a shape of this size on which nearly all its names are read well, and none of the `missing`
    /// marks is without a name that a larger page has; else the largest.
    pub(super) fn of(shape: [f64; 2], spots: &[Option<Spot>], missing: &[usize]) -> Page {
        let is_wide = shape[0] > shape[1];
        let pages = PAPERS.map(|[short, long]| {
            let size = if is_wide { [long, short] } else { [short, long] };
            let scales = [0, 1].map(|k| (size[k] - 2.0 * MARGIN) / shape[k]);
            let scale = scales[0].min(scales[1]);
            Page { size, scale: if scale.is_finite() { scale } else { 1.0 } }
        });
        let seen = spots.iter().flatten().count() as f64;
        let named = |page: &Page| missing.iter().filter(|mark| page.names(spots, **mark)).count();
        let most = named(&pages[PAPERS.len() - 1]);
        let is_enough = |page: &&Page| {
            let read = spots.iter().flatten().filter(|spot| page.height(spot) >= READABLE);
            read.count() as f64 >= MOST * seen && named(page) == most
        };
        *pages.iter().find(is_enough).unwrap_or(&pages[PAPERS.len() - 1])
    }

    /// The height of a name, in mm.
    fn height(&self, spot: &Spot) -> f64 {
        (self.scale * spot.height).min(LARGEST)
    }

    /// Whether the name of a mark is written.
    pub(super) fn names(&self, spots: &[Option<Spot>], mark: usize) -> bool {
        spots[mark].is_some_and(|spot| self.height(&spot) >= LEAST)
    }

    /// Draws lines, and the names of marks, of what is in a box with this lower left corner and size.
    pub(super) fn drawing(
        &self,
        (name, title): (String, String),
        (low, shape): (Point2, [f64; 2]),
        lines: Vec<Vec<Point2>>,
        (spots, marks): (&[Option<Spot>], &[Mark]),
    ) -> Drawing {
        let put = |point: Point2| -> Point2 {
            std::array::from_fn(|k| {
                let middle = low[k] + 0.5 * shape[k];
                rounded(0.5 * self.size[k] + self.scale * (point[k] - middle))
            })
        };
        let lines = lines.into_iter().map(|line| line.into_iter().map(put).collect());
        let mut lines: Vec<DrawnLine> = lines.map(DrawnLine::of_sheet).collect();
        let tall = (OF_PAGE * self.size[0].max(self.size[1])).clamp(TITLE[0], TITLE[1]);
        let tall = height_within(&title, tall, self.size[0] - 2.0 * MARGIN);
        let left = [MARGIN + 0.5 * text_width(&title, tall), 0.5 * MARGIN];
        lines.extend(strokes(&title, tall, left, [1.0, 0.0]).into_iter().map(DrawnLine::of_sheet));
        for (mark, spot) in marks.iter().zip(spots) {
            let Some(spot) = spot.filter(|spot| self.height(spot) >= LEAST) else { continue };
            let written = strokes(&mark.name, self.height(&spot), put(spot.at), spot.along);
            lines.extend(written.into_iter().map(|points| DrawnLine {
                role: Role::Engrave,
                points: points.into_iter().map(|point| point.map(rounded)).collect(),
                closed: false,
                part: mark.name.clone(),
                panels: Vec::new(),
            }));
        }
        Drawing { name, title, size: self.size, pen: PEN, lines, free: Vec::new() }
    }
}

/// Rounds to a hundredth of a millimetre: nobody sees more, and files are shorter.
fn rounded(length: f64) -> f64 {
    (100.0 * length).round() / 100.0
}
