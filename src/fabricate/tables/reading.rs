//! What the numbers of the tables and the letters on the sheets mean, for whoever has only the files.

use crate::scene::Product::{self, Fins, Panels, Paper};

const ALL: &[Product] = &Product::ALL;

/// What is explained, for which products, and in which words.
const READING: [(&[Product], &str, &str); 25] = [
    (ALL, "edges.csv panel_left", "seen from outside, on the way from node_a to node_b"),
    (ALL, "edges.csv fold_deg", "0 where panels are coplanar, more for a ridge seen from outside"),
    (
        &[Panels],
        "outlines",
        "each side moved inwards by half the joint, outwards by half the kerf; reliefs for the tool added",
    ),
    (
        &[Panels],
        "panels.csv nodes",
        "counterclockwise seen from outside, from the edge at the arrow",
    ),
    (&[Panels], "panels.csv corners", "of the whole panel, also for a piece; nodes too"),
    (
        &[Panels],
        "panels.csv x_sheet_mm",
        "of the mean of the corners of the whole panel, also for a piece; with y_sheet_mm",
    ),
    (&[Panels], "panels.csv turn_deg", "direction of the edge at the arrow, on the sheet"),
    (&[Fins], "fins.csv x_sheet_mm", "of node_a; with y_sheet_mm"),
    (
        &[Panels],
        "splices.csv pieces",
        "joined by the plate behind their seam, where both have a frame; a piece is in the plane of its panel",
    ),
    (&[Panels], "splices.csv x_sheet_mm", "of the lower left corner of its box; with y_sheet_mm"),
    (
        &[Panels],
        "splices.csv turn_deg",
        "direction of the seam, on the sheet, with piece_a on its left",
    ),
    (&[Fins], "fins.csv turn_deg", "direction from node_a to node_b, on the sheet"),
    (&[Fins], "names of fins", "from their first node to their second, tops of letters outwards"),
    (
        &[Fins],
        "fins.csv end_a_deg",
        "in the fin, between its side at the edge and its end at node_a",
    ),
    (&[Fins], "fins.csv cut_back_a_sheet_mm", "from node_a to the fin, along the edge"),
    (&[Fins], "node-beams.csv azimuth_deg", "about the axis, counterclockwise seen from outside"),
    (
        &[Fins],
        "node-beams.csv elevation_deg",
        "of the edge, outwards from the plane across the axis",
    ),
    (
        &[Fins],
        "discs.csv seat_sheet_mm",
        "from the node along its axis to the side on the fins, negative inwards",
    ),
    (&[Fins], "discs.csv x_sheet_mm", "of the axis of its node; with y_sheet_mm"),
    (&[Fins], "discs.csv turn_deg", "direction of the first beam in node-beams.csv, on the sheet"),
    (&[Paper], "pieces.csv x_sheet_mm", "of the lower left corner of its box; with y_sheet_mm"),
    (&[Paper], "joins.csv fold", "seen from outside; a tab is folded as its edge is"),
    (
        &[Paper],
        "joins.csv cut_back_sheet_mm",
        "from the edge to the inner faces of both panels, as their fold asks: half of the groove or the mitre of a V-cut",
    ),
    (
        &[Paper],
        "joins.csv cut_back_a_sheet_mm",
        "from the edge to the inner face of panel_a as made; scored or separate, it ends there: farther than asked in line with a steeper fold; of panel_b: cut_back_b_sheet_mm",
    ),
    (&[Paper], "tabs", "glued to the inside of the panel that is named on them"),
];

/// The rows for a product: what is explained, and the words.
pub(super) fn reading(product: Product) -> impl Iterator<Item = (&'static str, &'static str)> {
    let own = READING.iter().filter(move |(products, ..)| products.contains(&product));
    own.map(|&(_, what, words)| (what, words))
}
