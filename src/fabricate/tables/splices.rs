//! Plates that join the pieces of panels.

use super::place::{PLACE, place_cells};
use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::math::plane::{distance, minus};

/// The plates as cut; their pieces are in `panels.csv`.
pub(super) fn splices(build: &Build) -> String {
    let columns = [
        "name",
        "panel",
        "piece_a",
        "piece_b",
        "seam_sheet_mm",
        "width_sheet_mm",
        "length_sheet_mm",
        "area_sheet_mm2",
    ];
    let mut table = Table::new(&[&columns[..], &PLACE].concat());
    let places = build.layout.places(build.parts.len());
    for own in &build.splices {
        let (part, place) = (&build.parts[own.part], places[own.part]);
        let [one, other] = own.pieces.map(|piece| &*build.parts[piece].name);
        let [low, high] = own.corners;
        let size = [own.axis, 1 - own.axis].map(|axis| high[axis] - low[axis]);
        let on_sheet = place.map(|(sheet, place)| {
            let [from, to] = own.seam.map(|end| place.to_sheet(build.on_part(end)));
            // Turned over, the first piece would be on its right.
            let [c, s] = if build.is_turned_over() { minus(from, to) } else { minus(to, from) };
            (sheet, place.corner(&part.outline), libm::atan2(s, c).to_degrees())
        });
        let row = [
            Cell::from(&*part.name),
            Cell::from(&*build.names[own.panel as usize]),
            Cell::from(one),
            Cell::from(other),
            Cell::from(distance(own.seam[0], own.seam[1])),
            Cell::from(size[0]),
            Cell::from(size[1]),
            Cell::from(part.area()),
        ];
        table.row(row.into_iter().chain(place_cells(Some(part), on_sheet)));
    }
    table.into_text()
}
