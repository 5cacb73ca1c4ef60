//! Fins, prisms with their end cuts, the beams around each node, types of nodes, node discs.

use super::place::{PLACE, place_cells};
use crate::fabricate::beam::Frame;
use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::fabricate::surface::Edge;

/// All tables, with the names of their files.
pub(super) fn all(build: &Build, frame: &Frame) -> Vec<(&'static str, String)> {
    let mut tables = vec![
        ("fins.csv", fins(build, frame)),
        ("beams.csv", prisms(build, frame)),
        ("node-beams.csv", around_nodes(build, frame)),
        ("node-types.csv", types(build, frame)),
    ];
    if !build.discs.is_empty() {
        tables.push(("discs.csv", discs(build, frame)));
    }
    tables
}

/// The number of each fin in the order of assembly, from 1: with the first of the panels beside it.
fn order(build: &Build) -> Vec<usize> {
    let panels = build.order();
    let first = |k: &usize| {
        let beside = build.parts[*k].panels.iter().map(|&f| panels[f as usize]);
        (beside.min().unwrap_or(u32::MAX), *k)
    };
    let mut sorted: Vec<usize> = (0..build.fins.len()).collect();
    sorted.sort_unstable_by_key(first);
    let mut order = vec![0; sorted.len()];
    sorted.into_iter().zip(1..).for_each(|(k, number)| order[k] = number);
    order
}

fn fins(build: &Build, frame: &Frame) -> String {
    let columns = [
        "name",
        "node_a",
        "node_b",
        "cut_back_a_sheet_mm",
        "cut_back_b_sheet_mm",
        "end_a_deg",
        "end_b_deg",
        "area_sheet_mm2",
        "flattening_error_mm",
    ];
    let mut table = Table::new(&[&columns[..], &PLACE, &["order"]].concat());
    let (places, model) = (build.layout.places(build.parts.len()), build.mm_of_sheet());
    let fins = build.fins.iter().zip(&build.parts).zip(places);
    for (((&edge, part), place), number) in fins.zip(order(build)) {
        let Ok(fin) = &frame.fins[edge as usize] else { continue };
        let [a, b] = build.surface.edges[edge as usize].ends.map(|v| build.node_name(v));
        let row = [
            Cell::from(&*part.name),
            Cell::from(&*a),
            Cell::from(&*b),
            Cell::from(fin.cut_back[0] * model),
            Cell::from(fin.cut_back[1] * model),
            Cell::from(fin.end_deg[0]),
            Cell::from(fin.end_deg[1]),
            Cell::from(part.area()),
            Cell::from(fin.flattening_error * build.mm_of_building()),
        ];
        let on_sheet = place.map(|(sheet, place)| (sheet, place.offset, place.turn_deg()));
        let cells = row.into_iter().chain(place_cells(Some(part), on_sheet));
        table.row(cells.chain([Cell::from(number)]));
    }
    table.into_text()
}

/// The saw list: for each beam its lengths, and at both ends the cuts and the step to the next
/// beam.
fn prisms(build: &Build, frame: &Frame) -> String {
    let ends = ["a", "b"].map(|end| {
        ["mitre_left", "mitre_right", "tilt"]
            .map(|what| format!("{what}_{end}_deg"))
            .into_iter()
            .chain([format!("step_{end}_mm")])
    });
    let ends: Vec<String> = ends.into_iter().flatten().collect();
    let lengths = ["node_to_node_mm", "left_mm", "right_mm", "height_mm", "width_mm"];
    let columns = ["name", "node_a", "node_b"].into_iter().chain(lengths);
    let columns: Vec<&str> = columns.chain(ends.iter().map(|name| &**name)).collect();
    let mut table = Table::new(&columns);
    let building = build.mm_of_building();
    let all = build.surface.edges.iter().zip(&frame.prisms).enumerate();
    let is_beam = |edge: &Edge| build.surface.length(edge) > 0.0 && !edge.is_bridge();
    for (e, (edge, prism)) in all.filter(|(_, (edge, _))| is_beam(edge)) {
        let name = build.beam_name(edge.ends);
        let [a, b] = edge.ends.map(|v| build.node_name(v));
        let length = build.surface.length(edge) * building;
        let of_prism = |k: usize| prism.as_ref().map(|prism| prism.lengths[k] * building);
        let height = build.offset.as_ref().map(|(_, check)| check.beams[e].height[1] * building);
        let mut row = vec![
            Cell::from(&*name),
            Cell::from(&*a),
            Cell::from(&*b),
            Cell::from(length),
            Cell::from(of_prism(0)),
            Cell::from(of_prism(1)),
            Cell::from(height),
            Cell::from(build.beam_width() * building),
        ];
        for (v, side) in edge.ends.into_iter().zip([[0, 1], [1, 0]]) {
            let node = frame.nodes[v as usize].as_ref();
            let cut = node
                .and_then(|node| node.spoke_index(e as u32))
                .map(|k| &frame.cuts[v as usize][k]);
            // Left and right as seen from the first node.
            row.extend(side.map(|side: usize| Cell::from(cut.map(|cut| cut.mitre_deg[side]))));
            row.push(Cell::from(cut.map(|cut| cut.tilt_deg)));
            row.push(Cell::from(cut.map(|cut| cut.step * building)));
        }
        table.row(row);
    }
    table.into_text()
}

fn around_nodes(build: &Build, frame: &Frame) -> String {
    let mut table = Table::new(&[
        "node",
        "type",
        "beams",
        "number",
        "beam",
        "azimuth_deg",
        "elevation_deg",
        "cut_back_sheet_mm",
    ]);
    for node in frame.nodes.iter().flatten() {
        let v = node.vertex;
        let kind = frame.types.of[v as usize].map(type_name).unwrap_or_default();
        for (spoke, number) in node.spokes.iter().zip(1..) {
            let edge = &build.surface.edges[spoke.edge as usize];
            let fin = frame.fins[spoke.edge as usize].as_ref().ok();
            let end = usize::from(edge.ends[1] == v);
            table.row([
                Cell::from(&*build.node_name(v)),
                Cell::from(&*kind),
                Cell::from(node.spokes.len()),
                Cell::Count(number),
                Cell::from(&*build.beam_name(edge.ends)),
                Cell::from(spoke.azimuth_deg),
                Cell::from(spoke.elevation_deg),
                Cell::from(fin.map(|fin| fin.cut_back[end] * build.mm_of_sheet())),
            ]);
        }
    }
    table.into_text()
}

fn types(build: &Build, frame: &Frame) -> String {
    let mut table = Table::new(&["type", "count", "beams", "first_node", "worst_difference_deg"]);
    for (k, &leader) in frame.types.leaders.iter().enumerate() {
        let beams = frame.nodes[leader as usize].as_ref().map_or(0, |node| node.spokes.len());
        table.row([
            Cell::from(&*type_name(k as u32)),
            Cell::from(frame.types.counts[k] as usize),
            Cell::from(beams),
            Cell::from(&*build.node_name(leader)),
            Cell::from(frame.types.worst[k]),
        ]);
    }
    table.into_text()
}

/// The name of a type of nodes.
fn type_name(number: u32) -> String {
    format!("NT{}", number + 1)
}

/// The discs as cut. The seat is the position of their side on the fins along the axis of the node,
/// negative inwards; the neck is the least height of a fin there. x of a disc points away from the node
/// along its first beam in `node-beams.csv`, of which the first slot need not be.
fn discs(build: &Build, frame: &Frame) -> String {
    let columns = [
        "name",
        "diameter_sheet_mm",
        "slots",
        "first_slot",
        "seat_sheet_mm",
        "neck_sheet_mm",
        "lean_deg",
        "area_sheet_mm2",
    ];
    let mut table = Table::new(&[&columns[..], &PLACE, &["order"]].concat());
    let (places, model) = (build.layout.places(build.parts.len()), build.mm_of_sheet());
    // The first fin at each node.
    let mut first_fin = vec![usize::MAX; build.surface.positions.len()];
    for (&edge, number) in build.fins.iter().zip(order(build)) {
        for v in build.surface.edges[edge as usize].ends.map(|v| v as usize) {
            first_fin[v] = first_fin[v].min(number);
        }
    }
    for own in &build.discs {
        let Some(Ok(disc)) = &frame.discs[own.vertex as usize] else { continue };
        let (part, place) = (&build.parts[own.part], places[own.part]);
        let first = disc.slots.first();
        let first = first.map(|slot| build.beam_name(build.surface.edges[slot.edge as usize].ends));
        let name = build.node_name(own.vertex);
        let row = [
            Cell::from(&*name),
            Cell::from(2.0 * disc.radius * model),
            Cell::from(disc.slots.len()),
            Cell::from(first.as_deref().unwrap_or_default()),
            Cell::from(disc.seat * model),
            Cell::from(disc.neck * model),
            Cell::from(disc.lean_deg),
            Cell::from(part.area()),
        ];
        let on_sheet = place.map(|(sheet, place)| (sheet, place.offset, place.turn_deg()));
        let cells = row.into_iter().chain(place_cells(Some(part), on_sheet));
        table.row(cells.chain([Cell::from(first_fin[own.vertex as usize])]));
    }
    table.into_text()
}
