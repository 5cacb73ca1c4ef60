//! Plates that join the pieces of panels.

use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::math::plane::{distance, minus};

/// The plates as cut; their pieces are in `panels.csv`.
pub(super) fn splices(build: &Build) -> String {
    let mut table = Table::new(&[
        "name",
        "panel",
        "piece_a",
        "piece_b",
        "seam_sheet_mm",
        "width_sheet_mm",
        "length_sheet_mm",
        "area_sheet_mm2",
        "sheet",
        "x_sheet_mm",
        "y_sheet_mm",
        "turn_deg",
        "name_written",
    ]);
    let places = build.layout.places(build.parts.len());
    for own in &build.splices {
        let (part, place) = (&build.parts[own.part], places[own.part]);
        let [one, other] = own.pieces.map(|piece| &*build.parts[piece].name);
        let [low, high] = own.corners;
        let size = [own.axis, 1 - own.axis].map(|axis| high[axis] - low[axis]);
        let corner = place.map(|(_, place)| place.corner(&part.outline));
        let turn = place.map(|(_, place)| {
            let [from, to] = own.seam.map(|end| place.to_sheet(end));
            minus(to, from)
        });
        table.row([
            Cell::from(&*part.name),
            Cell::from(&*build.names[own.panel as usize]),
            Cell::from(one),
            Cell::from(other),
            Cell::from(distance(own.seam[0], own.seam[1])),
            Cell::from(size[0]),
            Cell::from(size[1]),
            Cell::from(part.area()),
            place.map_or(Cell::None, |(sheet, _)| Cell::from(sheet)),
            Cell::from(corner.map(|corner| corner[0])),
            Cell::from(corner.map(|corner| corner[1])),
            Cell::from(turn.map(|[c, s]| libm::atan2(s, c).to_degrees())),
            Cell::from(part.named.words()),
        ]);
    }
    table.into_text()
}
