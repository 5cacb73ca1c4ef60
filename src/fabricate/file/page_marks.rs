//! What a page of a PDF has besides the lines of its sheet, and never over them: a ruler; if the sheet is
//! on several pages, also the frame along which they are cut, and the number of the page.

use super::drawing::FreeBand;
use super::places;
use crate::fabricate::sheet::{strokes, text_width};
use crate::math::plane::Point2;
use crate::scene::Page;

/// Height of text, in mm.
const TEXT: f64 = 2.0;
/// Distance of a ruler from its words, in mm, and from what is before it.
const BESIDE: f64 = 3.0;
/// Height of the ticks of a ruler, in mm.
const TICK: f64 = 1.5;
/// The least and the largest length of a ruler, in cm.
const LENGTHS: [f64; 2] = [2.0, 10.0];

/// The longest ruler that one of these bands has room for, in the first of several; no lines if none
/// has.
pub(super) fn longest_ruler(bands: &[FreeBand]) -> Vec<Vec<Point2>> {
    let rulers = bands.iter().filter_map(|band| Some((ruler_length(band)?, band)));
    let longest = rulers.reduce(|best, own| if own.0 > best.0 { own } else { best });
    longest.map(|(length, band)| ruler(band, length)).unwrap_or_default()
}

/// The words beside a ruler of this length in cm.
fn words_of(length: f64) -> String {
    format!("{} MM. PRINT AT 100 %", places(10.0 * length, 0))
}

/// The length in cm of the longest ruler that a band has room for, with its words; none if it is too
/// short to be measured well.
fn ruler_length(band: &FreeBand) -> Option<f64> {
    let [least, most] = LENGTHS;
    let room = band.length - BESIDE - text_width(&words_of(most), TEXT);
    Some((room / 10.0).floor().min(most)).filter(|length| *length >= least)
}

/// A ruler of this length in cm, and what it is for.
fn ruler(band: &FreeBand, length: f64) -> Vec<Vec<Point2>> {
    let ([x, y], [c, s]) = (band.from, band.along);
    let at = |along: f64, up: f64| [x + c * along - s * up, y + s * along + c * up];
    let up = 0.5 * TICK;
    let mut lines = vec![vec![at(0.0, up), at(10.0 * length, up)]];
    for k in 0..=length as u32 {
        let along = 10.0 * f64::from(k);
        lines.push(vec![at(along, up), at(along, -up)]);
    }
    let words = words_of(length);
    let middle = 10.0 * length + BESIDE + 0.5 * text_width(&words, TEXT);
    lines.extend(strokes(&words, TEXT, at(middle, 0.0), band.along));
    lines
}

/// The frame along which a page is cut, ticks where the next page begins, and below it the number of
/// the page and a ruler.
pub(super) fn marks(
    sheet: &str,
    page: [f64; 2],
    [column, row]: [u32; 2],
    [columns, rows]: [u32; 2],
) -> Vec<Vec<Point2>> {
    let [[left, bottom], [right, top]] = Page::frame(page);
    let mut lines =
        vec![vec![[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]]];
    let tick = 4.0;
    if column + 1 < columns {
        let x = right - Page::OVERLAP;
        lines.extend([vec![[x, bottom], [x, bottom + tick]], vec![[x, top - tick], [x, top]]]);
    }
    if row + 1 < rows {
        let y = top - Page::OVERLAP;
        lines.extend([vec![[left, y], [left + tick, y]], vec![[right - tick, y], [right, y]]]);
    }
    let words = format!(
        "{}, COLUMN {} OF {columns}, ROW {} OF {rows} FROM BELOW",
        sheet,
        column + 1,
        row + 1
    );
    let (long, y) = (text_width(&words, TEXT), bottom - 0.5 * Page::LINE);
    lines.extend(strokes(&words, TEXT, [left + 0.5 * long, y], [1.0, 0.0]));
    let from = left + long + 2.0 * BESIDE;
    let band = FreeBand { from: [from, y], along: [1.0, 0.0], length: right - from };
    lines.extend(longest_ruler(&[band]));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::file::Drawing;
    use crate::fabricate::sheet::Sheet;

    /// The lower and the upper corner of lines.
    fn extent(lines: &[Vec<Point2>]) -> [Point2; 2] {
        let all = || lines.iter().flatten();
        [
            [0, 1].map(|k| all().map(|point| point[k]).fold(f64::INFINITY, f64::min)),
            [0, 1].map(|k| all().map(|point| point[k]).fold(f64::NEG_INFINITY, f64::max)),
        ]
    }

    fn sheet(size: [f64; 2], margin: f64, outlines_only: bool) -> Drawing {
        let words = ["SHEET 1/1, SCALE 1:50", "SEEN FROM OUTSIDE, ARROW: TO ITS FIRST EDGE"];
        let words = words.map(str::to_owned);
        let name = "sheet-01".to_owned();
        Drawing::new(name, words, size, margin, &Sheet::default(), &[], outlines_only)
    }

    #[test]
    fn a_ruler_is_in_the_margin_where_nothing_else_is() {
        for size in [[420.0, 297.0], [297.0, 210.0], [150.0, 150.0], [1220.0, 610.0]] {
            for margin in [5.0, 12.0] {
                let drawing = sheet(size, margin, false);
                let ruler = longest_ruler(&drawing.free);
                let [low, high] = extent(&ruler);
                assert!(high[0] - low[0] > 60.0 || high[1] - low[1] > 60.0, "{size:?}");
                let is_within = (0..2).all(|k| low[k] > 0.0 && high[k] < size[k]);
                let is_in_margin =
                    high[0] < margin || high[1] < margin || low[1] > size[1] - margin;
                assert!(is_within && is_in_margin, "{size:?} {low:?} {high:?}");
                // The first line is the border.
                for line in &drawing.lines[1..] {
                    let [under, over] = extent(std::slice::from_ref(&line.points));
                    let is_apart = (0..2).any(|k| over[k] < low[k] || under[k] > high[k]);
                    assert!(is_apart, "{size:?} {margin}");
                }
            }
        }
    }

    #[test]
    fn a_sheet_without_room_or_with_outlines_only_has_no_ruler() {
        for (margin, outlines_only) in [(0.0, false), (3.0, false), (5.0, true)] {
            let drawing = sheet([420.0, 297.0], margin, outlines_only);
            assert!(longest_ruler(&drawing.free).is_empty(), "{margin}");
        }
    }

    #[test]
    fn the_ruler_and_the_number_of_a_part_of_a_sheet_are_printed() {
        for page in [[210.0, 297.0], [297.0, 210.0]] {
            let lines = marks("sheet-01", page, [0, 0], [3, 2]);
            let [[_, bottom], [right, _]] = Page::frame(page);
            let [low, high] = extent(&lines);
            assert!((0..2).all(|k| low[k] >= 5.0 && high[k] <= page[k] - 5.0), "{low:?} {high:?}");
            let below = lines.iter().filter(|line| line.iter().all(|point| point[1] < bottom));
            let long = |line: &&Vec<Point2>| (line[1][0] - line[0][0]).abs() > 49.9;
            let rulers: Vec<_> = below.filter(long).collect();
            assert!(rulers.len() == 1 && rulers[0][1][0] < right, "{rulers:?}");
        }
    }
}
