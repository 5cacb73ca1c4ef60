//! Pieces of a paper model, how each edge is joined, and tongues with their slots.

use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::fabricate::paper::{JointKind, PaperModel};
use crate::math::plane::distance;

/// Both tables, with the names of their files.
pub(super) fn all(build: &Build) -> Vec<(&'static str, String)> {
    let Some(model) = &build.paper else { return Vec::new() };
    let mut tables = vec![("pieces.csv", pieces(build, model)), ("joins.csv", joins(build, model))];
    if model.has_tongues() {
        tables.push(("tongues.csv", tongues(build, model)));
    }
    tables
}

fn pieces(build: &Build, model: &PaperModel) -> String {
    let columns = [
        "name",
        "panels",
        "tabs",
        "area_sheet_mm2",
        "sheet",
        "x_sheet_mm",
        "y_sheet_mm",
        "names",
        "name_written",
        "order",
    ];
    let mut table = Table::new(&columns);
    let places = build.layout.places(build.parts.len());
    let order = build.order();
    for (k, part) in build.parts.iter().enumerate() {
        let place = places[k];
        let corner = place.map(|(_, place)| place.corner(&part.outline));
        let first = part.panels.iter().map(|&panel| order[panel as usize]).min();
        let names: Vec<&str> =
            part.panels.iter().map(|&panel| &*build.names[panel as usize]).collect();
        table.row([
            Cell::from(&*part.name),
            Cell::from(part.panels.len()),
            Cell::from(model.tabs(model.pieces[k]).count()),
            Cell::from(part.area()),
            place.map_or(Cell::None, |(sheet, _)| Cell::from(sheet)),
            Cell::from(corner.map(|corner| corner[0])),
            Cell::from(corner.map(|corner| corner[1])),
            Cell::from(&*names.join(" ")),
            Cell::from(part.named.words()),
            first.map_or(Cell::None, |first| Cell::from(first as usize)),
        ]);
    }
    table.into_text()
}

/// Folds are as seen from outside, whichever side is printed.
fn joins(build: &Build, model: &PaperModel) -> String {
    let columns = [
        "edge",
        "panel_a",
        "panel_b",
        "piece_a",
        "piece_b",
        "join",
        "fold",
        "fold_deg",
        "tab_on",
        "tab_sheet_mm",
        "length_a_sheet_mm",
        "length_b_sheet_mm",
        "cut_back_sheet_mm",
        "cut_back_a_sheet_mm",
        "cut_back_b_sheet_mm",
    ];
    let mut table = Table::new(&columns);
    let net = &model.net;
    let number = numbers(model);
    for (joint, kind) in net.joints.iter().zip(&model.joint_kinds) {
        let name = joint.edge.map_or("crease".to_owned(), |edge| {
            build.beam_name(build.surface.edges[edge as usize].ends)
        });
        let panel = |k: usize| net.facets[joint.sides[k].0 as usize].panel as usize;
        let piece =
            |k: usize| format!("S{}", number[net.piece_of[joint.sides[k].0 as usize] as usize]);
        let (pieces, panels) = ([piece(0), piece(1)], [0, 1].map(|k| &*build.names[panel(k)]));
        let (join, tab) = match kind {
            JointKind::Folded => ("folded", None),
            JointKind::Tab(tab) => ("tab", Some(tab)),
            JointKind::Tongue(_) => ("slot", None),
            JointKind::Bare => ("no tab", None),
        };
        let tab_on = tab.map(|tab| panels[usize::from(tab.side != joint.sides[0])]);
        let length = |k: usize| {
            let [p, q] = net.ends(joint.sides[k]);
            distance(p, q)
        };
        let back = |k: usize| {
            let (f, side) = joint.sides[k];
            net.facets[f as usize].backs[side as usize]
        };
        table.row([
            Cell::from(&*name),
            Cell::from(panels[0]),
            Cell::from(panels[1]),
            Cell::from(&*pieces[0]),
            Cell::from(&*pieces[1]),
            Cell::from(join),
            Cell::from(joint.kind().word()),
            Cell::from(joint.fold.to_degrees()),
            Cell::from(tab_on.unwrap_or_default()),
            Cell::from(tab.map(|tab| tab.height)),
            Cell::from(length(0)),
            Cell::from(length(1)),
            Cell::from(joint.back),
            Cell::from(back(0)),
            Cell::from(back(1)),
        ]);
    }
    table.into_text()
}

/// The number of each piece of the net, from 1.
fn numbers(model: &PaperModel) -> Vec<usize> {
    let mut found = vec![0; model.net.pieces.len()];
    model.pieces.iter().zip(1..).for_each(|(&piece, k)| found[piece as usize] = k);
    found
}

/// Tongues and their slots, as they are after cutting.
fn tongues(build: &Build, model: &PaperModel) -> String {
    let columns = [
        "name",
        "node_a",
        "node_b",
        "from_sheet_mm",
        "tongue_piece",
        "tongue_panel",
        "tongue_width_sheet_mm",
        "tongue_length_sheet_mm",
        "slot_piece",
        "slot_panel",
        "slot_length_sheet_mm",
        "slot_width_sheet_mm",
        "flange_sheet_mm",
    ];
    let mut table = Table::new(&columns);
    let (net, number) = (&model.net, numbers(model));
    for kind in &model.joint_kinds {
        let JointKind::Tongue(own) = kind else { continue };
        let piece = |f: u32| format!("S{}", number[net.piece_of[f as usize] as usize]);
        let panel = |f: u32| &*build.names[net.facets[f as usize].panel as usize];
        let (f, k) = own.side;
        let vertices = &net.facets[f as usize].vertices;
        let node = |k: u32| build.node_name(vertices[k as usize % vertices.len()]);
        let there = own.flange.side.0;
        table.row([
            Cell::from(&*own.name()),
            Cell::from(&*node(k)),
            Cell::from(&*node(k + 1)),
            Cell::from(own.root[0]),
            Cell::from(&*piece(f)),
            Cell::from(panel(f)),
            Cell::from(own.root[1] - own.root[0]),
            Cell::from(own.length),
            Cell::from(&*piece(there)),
            Cell::from(panel(there)),
            Cell::from(own.slot[1] - own.slot[0]),
            Cell::from(own.width),
            Cell::from(own.flange.height),
        ]);
    }
    table.into_text()
}
