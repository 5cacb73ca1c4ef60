//! Node discs.

use crate::fabricate::beam::Frame;
use crate::fabricate::build::{Build, beam_name, node_name};
use crate::fabricate::file::{Cell, Table};

/// The discs as cut. The seat is the position of their side on the fins along the axis of the node,
/// negative inwards; the neck is the least height of a fin there. x of a disc points away from the node
/// along its first beam in `node-beams.csv`, of which the first slot need not be.
pub(super) fn discs(build: &Build, frame: &Frame) -> String {
    let mut table = Table::new(&[
        "name",
        "diameter_sheet_mm",
        "slots",
        "first_slot",
        "seat_sheet_mm",
        "neck_sheet_mm",
        "lean_deg",
        "area_sheet_mm2",
        "sheet",
        "x_sheet_mm",
        "y_sheet_mm",
        "turn_deg",
        "name_written",
    ]);
    let (places, model) = (build.layout.places(build.parts.len()), build.mm_of_sheet());
    for own in &build.discs {
        let Some(Ok(disc)) = &frame.discs[own.vertex as usize] else { continue };
        let (part, place) = (&build.parts[own.part], places[own.part]);
        let first = disc.slots.first();
        let first = first.map(|slot| beam_name(build.surface.edges[slot.edge as usize].ends));
        table.row([
            Cell::from(&*node_name(own.vertex)),
            Cell::from(2.0 * disc.radius * model),
            Cell::from(disc.slots.len()),
            Cell::from(first.as_deref().unwrap_or_default()),
            Cell::from(disc.seat * model),
            Cell::from(disc.neck * model),
            Cell::from(disc.lean_deg),
            Cell::from(part.area()),
            place.map_or(Cell::None, |(sheet, _)| Cell::from(sheet)),
            Cell::from(place.map(|(_, place)| place.offset[0])),
            Cell::from(place.map(|(_, place)| place.offset[1])),
            Cell::from(place.map(|(_, place)| place.turn_deg())),
            Cell::from(part.named.words()),
        ]);
    }
    table.into_text()
}
