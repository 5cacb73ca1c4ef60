//! Sheets and lists as files. Everything is in mm of the sheet, with y upwards except in SVG.
//! Numbers have a decimal point and no exponent.

mod csv;
mod cut_once;
mod drawing;
mod dxf;
mod glb;
mod page_marks;
mod pdf;
mod picture;
mod svg;

pub use csv::{Cell, Table, not_a_formula, text_field};
pub(super) use cut_once::shared_length;
pub use drawing::{Drawing, DrawnLine, FreeBand};
pub use dxf::dxf;
pub use glb::{GlbLayer, GlbPart, glb};
pub use pdf::pdf;
pub use picture::{PictureLayer, SheetPicture, picture};
pub(crate) use svg::escaped;
pub use svg::svg;

/// Formats with at most `most` decimal places, without trailing zeros and without `-0`.
pub(in crate::fabricate) fn places(value: f64, most: usize) -> String {
    let text = format!("{value:.most$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Formats with exactly six decimal places.
fn six(value: f64) -> String {
    let text = format!("{value:.6}");
    if text == "-0.000000" { "0.000000".to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_plain() {
        assert_eq!(places(1200.0, 3), "1200");
        assert_eq!(places(-1e-9, 3), "0");
        assert_eq!(places(1.2346, 3), "1.235");
        assert_eq!(places(1e9 + 0.5, 3), "1000000000.5");
        assert_eq!([six(-1e-9), six(2.0)], ["0.000000", "2.000000"]);
    }
}
