//! Lists of panels, edges, nodes and types, and a summary. Lengths of panels are those of the parts, at the scale
//! of the model; those of edges and nodes are of the building. Every column says its unit.

use super::build::Build;
use super::file::{Cell, Table};
use super::panel::{area, perimeter, rotated};
use super::sheet::Place;

/// All tables by the names of their files.
pub(super) fn all(build: &Build) -> Vec<(&'static str, String)> {
    vec![
        ("panels.csv", panels(build)),
        ("edges.csv", edges(build)),
        ("nodes.csv", nodes(build)),
        ("types.csv", types(build)),
        ("summary.csv", summary(build)),
    ]
}

/// The name of a type of panels.
fn type_name(number: u32) -> String {
    format!("T{}", number + 1)
}

fn panels(build: &Build) -> String {
    let mut table = Table::new(&[
        "name",
        "type",
        "corners",
        "area_mm2",
        "perimeter_mm",
        "width_mm",
        "height_mm",
        "flatness_mm",
        "flattening_error_mm",
        "sheet",
        "x_mm",
        "y_mm",
        "turn_deg",
    ]);
    let mut places: Vec<Option<(usize, Place)>> = vec![None; build.parts.len()];
    for (sheet, number) in build.layout.sheets.iter().zip(1..) {
        sheet.places.iter().for_each(|place| places[place.part] = Some((number, *place)));
    }
    let model = build.model();
    for (f, name) in build.names.iter().enumerate() {
        let kind = build.types.of_panels[f].map(type_name).unwrap_or_default();
        let corners = build.surface.faces.row(f).len();
        let flat = build.flat[f].as_ref();
        let cut = build.cut[f].as_ref();
        let outline = cut.map(|cut| &build.parts[cut.part].outline[..]);
        let place = cut.and_then(|cut| places[cut.part].map(|place| (cut, place)));
        // The turn from the plane of the panel, which its first edge is along.
        let turn = place.map(|(cut, (_, place))| {
            let [c, s] = rotated(cut.turn, place.turn);
            libm::atan2(s, c).to_degrees()
        });
        table.row([
            Cell::from(&**name),
            Cell::from(&*kind),
            Cell::from(corners),
            Cell::from(outline.map(area)),
            Cell::from(outline.map(perimeter)),
            Cell::from(cut.map(|cut| cut.size[0])),
            Cell::from(cut.map(|cut| cut.size[1])),
            Cell::from(flat.map(|flat| flat.flatness * model)),
            Cell::from(flat.map(|flat| flat.flattening_error * model)),
            place.map_or(Cell::None, |(_, (sheet, _))| Cell::from(sheet)),
            Cell::from(place.map(|(_, (_, place))| place.offset[0])),
            Cell::from(place.map(|(_, (_, place))| place.offset[1])),
            Cell::from(turn),
        ]);
    }
    table.into_text()
}

fn edges(build: &Build) -> String {
    let mut table = Table::new(&[
        "name",
        "node_a",
        "node_b",
        "panel_left",
        "panel_right",
        "length_mm",
        "fold_deg",
        "beam_height_mm",
        "warp_mm",
        "twist_deg",
    ]);
    let building = build.building();
    for (e, edge) in build.surface.edges.iter().enumerate() {
        let [a, b] = edge.ends;
        let name = format!("B{a}-{b}");
        let (a, b) = (format!("N{a}"), format!("N{b}"));
        let panel = |panel: Option<u32>| panel.map_or("", |panel| &*build.names[panel as usize]);
        let beam = build.offset.as_ref().map(|(_, check)| check.beams[e]);
        table.row([
            Cell::from(&*name),
            Cell::from(&*a),
            Cell::from(&*b),
            Cell::from(panel(edge.panels[0])),
            Cell::from(panel(edge.panels[1])),
            Cell::from(build.surface.length(edge) * building),
            Cell::from(build.surface.fold(edge).map(f64::to_degrees)),
            Cell::from(beam.map(|beam| beam.height[1] * building)),
            Cell::from(beam.map(|beam| beam.warp * building)),
            Cell::from(beam.map(|beam| beam.twist_deg)),
        ]);
    }
    table.into_text()
}

fn nodes(build: &Build) -> String {
    let mut table =
        Table::new(&["name", "x_mm", "y_mm", "z_mm", "edges", "axis_x", "axis_y", "axis_z"]);
    let building = build.building();
    let mut degrees = vec![0_usize; build.surface.positions.len()];
    for edge in &build.surface.edges {
        edge.ends.iter().for_each(|&v| degrees[v as usize] += 1);
    }
    for (v, degree) in degrees.into_iter().enumerate().filter(|(_, degree)| *degree > 0) {
        let at = (build.surface.positions[v] + build.surface.centre) * building;
        let axis = build.offset.as_ref().map(|(axes, _)| axes.axes[v]);
        table.row([
            Cell::from(&*format!("N{v}")),
            Cell::from(at.x),
            Cell::from(at.y),
            Cell::from(at.z),
            Cell::from(degree),
            Cell::from(axis.map(|axis| axis.x)),
            Cell::from(axis.map(|axis| axis.y)),
            Cell::from(axis.map(|axis| axis.z)),
        ]);
    }
    table.into_text()
}

fn types(build: &Build) -> String {
    let mut table = Table::new(&["type", "count", "first_panel", "worst_difference_mm"]);
    for (k, &leader) in build.types.leaders.iter().enumerate() {
        table.row([
            Cell::from(&*type_name(k as u32)),
            Cell::from(build.types.counts[k] as usize),
            Cell::from(&*build.names[leader as usize]),
            Cell::from(build.types.worst[k] * build.building()),
        ]);
    }
    table.into_text()
}

fn summary(build: &Build) -> String {
    let report = build.report();
    let mut table = Table::new(&["what", "value", "unit"]);
    let mut row = |what: &str, value: Cell<'_>, unit: &str| {
        table.row([Cell::from(what), value, Cell::from(unit)]);
    };
    row("program", Cell::from(concat!("shape-up ", env!("CARGO_PKG_VERSION"))), "");
    row("scale, 1 to", Cell::from(build.settings.scale), "");
    row("unit of the model", Cell::from(&*build.unit.symbol), "");
    row("panels", Cell::from(report.panels), "");
    row("parts on sheets", Cell::from(report.placed), "");
    row("sheets", Cell::from(report.sheets), "");
    row("sheet width", Cell::from(build.settings.sheet[0]), "mm");
    row("sheet height", Cell::from(build.settings.sheet[1]), "mm");
    row("area of parts", Cell::from(report.cut_area_mm2), "mm2");
    row("length of cuts", Cell::from(report.cut_length_mm), "mm");
    row("joint on the sheet", Cell::from(build.settings.joint * build.model()), "mm");
    row("types of panels", Cell::from(report.types), "");
    row("types alike within, building", Cell::from(build.settings.alike), "mm");
    for check in &report.check {
        row(check.label, Cell::from(check.value), check.unit);
        row(&format!("{}, limit", check.label), Cell::from(check.limit), check.unit);
    }
    table.into_text()
}
