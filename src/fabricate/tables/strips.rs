//! Strips that cover the joints between panels.

use crate::fabricate::CoverStrip;
use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};

/// The strips, each with the name of its edge: a list for the saw.
pub(super) fn strips(build: &Build, strips: &[CoverStrip]) -> String {
    let mut table = Table::new(&[
        "name",
        "node_a",
        "node_b",
        "panel_left",
        "panel_right",
        "length_sheet_mm",
        "width_sheet_mm",
        "cut_back_a_sheet_mm",
        "cut_back_b_sheet_mm",
        "fold_deg",
    ]);
    for own in strips.iter().filter(|own| own.length > 0.0) {
        let edge = &build.surface.edges[own.edge as usize];
        let [a, b] = edge.ends.map(|v| build.node_name(v));
        let panels = edge.panels.map(|panel| panel.map(|f| &*build.names[f as usize]));
        let [left, right] = panels.map(Option::unwrap_or_default);
        table.row([
            Cell::from(&*build.beam_name(edge.ends)),
            Cell::from(&*a),
            Cell::from(&*b),
            Cell::from(left),
            Cell::from(right),
            Cell::from(own.length),
            Cell::from(build.settings.strip),
            Cell::from(own.cut_back[0]),
            Cell::from(own.cut_back[1]),
            Cell::from(build.surface.fold(edge).map(f64::to_degrees)),
        ]);
    }
    table.into_text()
}
