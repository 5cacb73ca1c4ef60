//! Panels as cut, and their types.

use super::place::{PLACE, place_cells};
use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::fabricate::panel::{perimeter, smallest_box};
use crate::fabricate::sheet::CutPart;
use crate::math::plane::rotated;

/// The name of a type of panels.
fn type_name(number: u32) -> String {
    format!("T{}", number + 1)
}

/// The panels as cut; of one in pieces, each piece.
pub(super) fn panels(build: &Build) -> String {
    let columns = [
        "name",
        "type",
        "corners",
        "area_sheet_mm2",
        "perimeter_sheet_mm",
        "width_sheet_mm",
        "height_sheet_mm",
        "flatness_mm",
        "flattening_error_mm",
    ];
    let mut table = Table::new(&[&columns[..], &PLACE, &["order", "nodes"]].concat());
    let places = build.layout.places(build.parts.len());
    let (building, order) = (build.mm_of_building(), build.order());
    for (f, name) in build.names.iter().enumerate() {
        let kind = build.types.of[f].map(type_name).unwrap_or_default();
        let corners = build.surface.faces.row(f);
        let rings = build.surface.rings(f as u32);
        let around = |ring: &Vec<usize>| {
            ring.iter().map(|&k| build.node_name(corners[k])).collect::<Vec<_>>().join(" ")
        };
        let nodes: Vec<String> = rings.iter().map(around).collect();
        let flat = build.flat[f].as_ref();
        let cut = build.cut[f].as_ref();
        let pieces = cut.map_or(vec![None], |cut| cut.parts().map(Some).collect());
        for number in pieces {
            let part = number.map(|number| &build.parts[number]);
            // The rotation from the plane of the panel, whose x axis is its first edge.
            let on_sheet = cut.zip(number.and_then(|number| places[number]));
            let on_sheet = on_sheet.map(|(cut, (sheet, place))| {
                let [c, s] = rotated(build.on_part(cut.turn), place.turn);
                (sheet, place.offset, libm::atan2(s, c).to_degrees())
            });
            let size = cut.zip(part).map(|(cut, part)| match cut.pieces {
                1 => cut.size,
                _ => smallest_box(&part.outline).1,
            });
            let row = [
                Cell::from(part.map_or(&**name, |part| &*part.name)),
                Cell::from(&*kind),
                Cell::from(rings.iter().map(Vec::len).sum::<usize>()),
                Cell::from(part.map(CutPart::area)),
                Cell::from(part.map(|part| perimeter(&part.outline))),
                Cell::from(size.map(|size| size[0])),
                Cell::from(size.map(|size| size[1])),
                Cell::from(flat.map(|flat| flat.flatness * building)),
                Cell::from(flat.map(|flat| flat.flattening_error * building)),
            ];
            let (order, nodes) = (Cell::from(order[f] as usize), nodes.join(" / "));
            let last = [order, Cell::from(&*nodes)];
            table.row(row.into_iter().chain(place_cells(part, on_sheet)).chain(last));
        }
    }
    table.into_text()
}

pub(super) fn types(build: &Build) -> String {
    let mut table = Table::new(&["type", "count", "first_panel", "worst_difference_mm"]);
    for (k, &leader) in build.types.leaders.iter().enumerate() {
        table.row([
            Cell::from(&*type_name(k as u32)),
            Cell::from(build.types.counts[k] as usize),
            Cell::from(&*build.names[leader as usize]),
            Cell::from(build.types.worst[k] * build.mm_of_building()),
        ]);
    }
    table.into_text()
}
