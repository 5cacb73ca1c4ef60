//! What the numbers of the tables and the letters on the sheets mean, for whoever has only the files.

/// What is explained, and in which words.
const READING: [(&str, &str); 42] = [
    (
        "nodes.csv name",
        "the vertex of the model, from 0; if fins have names in the order of assembly, its place in it, from 1",
    ),
    ("nodes.csv vertex", "of the model, from 0: the same for panels, fins and paper"),
    ("types.csv type", "of panels whose outlines are cut alike; their holes and bevels can differ"),
    ("edges.csv panel_left", "seen from outside, on the way from node_a to node_b"),
    ("edges.csv fold_deg", "0 where panels are coplanar, more for a ridge seen from outside"),
    (
        "edges.csv bevel_deg",
        "of the sides of both panels from square: half of the fold; more than 0 cuts the inside back, less the outside",
    ),
    (
        "outlines",
        "each side moved inwards by half the joint, at the boundary by the setback, outwards by half the kerf; reliefs for the tool added",
    ),
    (
        "arrows",
        "upwards in the model, in the plane of the part; if it is within 5 degrees of level, to the top of key 1",
    ),
    (
        "panels.csv nodes",
        "counterclockwise seen from outside; after a slash, clockwise around a hole",
    ),
    (
        "panels.csv name",
        "after a dot, the number of a piece: joined by plates, or if edges.csv has its name, a triangle",
    ),
    ("panels.csv order", "of assembly, from the supports upwards"),
    ("panels.csv corners", "of the whole panel, also for a piece; nodes too"),
    (
        "panels.csv x_sheet_mm",
        "of the mean of the corners of the whole panel, also for a piece; with y_sheet_mm",
    ),
    ("panels.csv turn_deg", "direction from its first node to its second, on the sheet"),
    ("fins.csv x_sheet_mm", "of node_a; with y_sheet_mm"),
    (
        "splices.csv pieces",
        "joined by the plate behind their seam, where both have a frame; a piece is in the plane of its panel",
    ),
    ("splices.csv x_sheet_mm", "of the lower left corner of its box; with y_sheet_mm"),
    ("splices.csv turn_deg", "direction of the seam, on the sheet, with piece_a on its left"),
    ("strips.csv length_sheet_mm", "between square ends; strips do not overlap at a node"),
    ("strips.csv cut_back_a_sheet_mm", "from node_a to the strip, along the edge"),
    (
        "fins.csv order",
        "of assembly, from the supports upwards, with the first of the panels beside it",
    ),
    ("fins.csv turn_deg", "direction from node_a to node_b, on the sheet"),
    ("names of fins", "from their first node to their second, tops of letters outwards"),
    ("fins.csv end_a_deg", "in the fin, between its side at the edge and its end at node_a"),
    ("fins.csv cut_back_a_sheet_mm", "from node_a to the fin, along the edge"),
    ("node-beams.csv azimuth_deg", "about the axis, counterclockwise seen from outside"),
    ("node-beams.csv elevation_deg", "of the edge, outwards from the plane across the axis"),
    (
        "discs.csv seat_sheet_mm",
        "from the node along its axis to the side on the fins, negative inwards",
    ),
    ("names at slots of discs", "the node that the fin leads to"),
    ("discs.csv x_sheet_mm", "of the axis of its node; with y_sheet_mm"),
    ("discs.csv order", "of the first fin that is pushed into it: it is there before"),
    ("discs.csv turn_deg", "direction of the first beam in node-beams.csv, on the sheet"),
    ("pieces.csv order", "of assembly, from the supports upwards: of the first of its panels"),
    ("pieces.csv x_sheet_mm", "of the lower left corner of its box; with y_sheet_mm"),
    ("joins.csv fold", "seen from outside; a tab is folded as its edge is"),
    (
        "joins.csv cut_back_sheet_mm",
        "from the edge to the inner faces of both panels, as their fold asks: half of the groove or the mitre of a V-cut",
    ),
    (
        "joins.csv cut_back_a_sheet_mm",
        "from the edge to the inner face of panel_a as made; scored or separate, it ends there: farther than asked in line with a steeper fold; of panel_b: cut_back_b_sheet_mm",
    ),
    ("outlines of pieces", "outwards by half the kerf; in narrower gaps along their middle"),
    ("tabs", "glued to the inside of the panel that is named on them"),
    (
        "tongues",
        "folded as their edge is, as the flanges with the slots; pushed from outside into the slot of their name, behind the panel beside it",
    ),
    ("tongues.csv from_sheet_mm", "from node_a to the tongue, along the edge"),
    (
        "tongues.csv slot_width_sheet_mm",
        "from the fold into the flange: the thickness and the clearance on either side, or what the kerf needs",
    ),
];

/// The table beside whose parts something is explained.
fn table_of(what: &str) -> &str {
    match what {
        "outlines" | "arrows" => "panels.csv",
        "names of fins" => "fins.csv",
        "names at slots of discs" => "discs.csv",
        "tabs" | "outlines of pieces" => "pieces.csv",
        "tongues" => "tongues.csv",
        column => column.split(' ').next().unwrap_or(column),
    }
}

/// The rows for these tables: what is explained, and the words.
pub(super) fn reading(tables: &[&str]) -> impl Iterator<Item = (&'static str, &'static str)> {
    READING.into_iter().filter(|(what, _)| tables.contains(&table_of(what)))
}
