//! Edges and nodes of the shape.

use crate::fabricate::build::Build;
use crate::fabricate::file::{Cell, Table};
use crate::math::{polygon_sides, sort_by_number};

pub(super) fn edges(build: &Build) -> String {
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
        "bevel_deg",
    ]);
    let building = build.mm_of_building();
    // The panels that traverse each edge from its first to its second end.
    let mut ascending = vec![Vec::new(); build.surface.edges.len()];
    for (face, f) in build.surface.faces.iter().zip(0..) {
        let sides = build.surface.sides.row(f as usize).iter().zip(polygon_sides(face));
        sides.filter(|(_, [a, b])| a < b).for_each(|(&e, _)| ascending[e as usize].push(f));
    }
    for (e, edge) in build.surface.edges.iter().enumerate().filter(|(_, edge)| !edge.is_bridge()) {
        let [a, b] = edge.ends;
        let name = build.beam_name(edge.ends);
        let (a, b) = (build.node_name(a), build.node_name(b));
        // Several on a side only where more than two panels meet, or the surface has one side, or beyond
        // a panel without area.
        let panels = |is_left: bool| {
            let own = build.surface.panels.row(e).iter();
            let own = own.filter(|f| ascending[e].contains(f) == is_left);
            let made = own.flat_map(|&f| build.surface.panels_beyond_degenerate(e as u32, f));
            made.map(|f| &*build.names[f as usize]).collect::<Vec<_>>().join("/")
        };
        let [left, right] = [panels(true), panels(false)];
        let beam = build.offset.as_ref().map(|(_, check)| check.beams[e]);
        table.row([
            Cell::from(&*name),
            Cell::from(&*a),
            Cell::from(&*b),
            Cell::from(&*left),
            Cell::from(&*right),
            Cell::from(build.surface.length(edge) * building),
            Cell::from(build.surface.fold(edge).map(f64::to_degrees)),
            Cell::from(beam.map(|beam| beam.height[1] * building)),
            Cell::from(beam.map(|beam| beam.warp * building)),
            Cell::from(beam.map(|beam| beam.twist_deg)),
            Cell::from(build.surface.bevel(e as u32).map(f64::to_degrees)),
        ]);
    }
    table.into_text()
}

pub(super) fn nodes(build: &Build) -> String {
    let mut table = Table::new(&[
        "name", "x_mm", "y_mm", "z_mm", "edges", "axis_x", "axis_y", "axis_z", "vertex",
    ]);
    let building = build.mm_of_building();
    let mut degrees = vec![0_usize; build.surface.positions.len()];
    for edge in build.surface.real_edges() {
        edge.ends.iter().for_each(|&v| degrees[v as usize] += 1);
    }
    let mut used: Vec<(usize, usize)> = degrees.into_iter().enumerate().collect();
    used.retain(|(_, degree)| *degree > 0);
    sort_by_number(&mut used, |&(v, _)| build.nodes[v].into());
    for (v, degree) in used {
        let at = (build.surface.positions[v] + build.surface.centre) * building;
        let axis = build.offset.as_ref().map(|(axes, _)| axes.axes[v]);
        table.row([
            Cell::from(&*build.node_name(v as u32)),
            Cell::from(at.x),
            Cell::from(at.y),
            Cell::from(at.z),
            Cell::from(degree),
            Cell::from(axis.map(|axis| axis.x)),
            Cell::from(axis.map(|axis| axis.y)),
            Cell::from(axis.map(|axis| axis.z)),
            Cell::from(v),
        ]);
    }
    table.into_text()
}
