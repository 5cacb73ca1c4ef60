//! Where parts are on the sheets, as the tables of all kinds of parts say it.

use crate::fabricate::file::Cell;
use crate::fabricate::sheet::CutPart;
use crate::math::plane::Point2;

/// The columns of where a part is on the sheets.
pub(super) const PLACE: [&str; 5] =
    ["sheet", "x_sheet_mm", "y_sheet_mm", "turn_deg", "name_written"];

/// Their cells for a part, if it is made: the sheet, if it is on one, the coordinates there of a point
/// of the part in mm, its turn in degrees, and where its name is written.
pub(super) fn place_cells(
    part: Option<&CutPart>,
    on_sheet: Option<(usize, Point2, f64)>,
) -> [Cell<'static>; 5] {
    [
        on_sheet.map_or(Cell::None, |(sheet, ..)| Cell::from(sheet)),
        Cell::from(on_sheet.map(|(_, [x, _], _)| x)),
        Cell::from(on_sheet.map(|(_, [_, y], _)| y)),
        Cell::from(on_sheet.map(|(.., turn)| turn)),
        Cell::from(part.map_or("", |part| part.named.words())),
    ]
}
