//! The bill of materials.

use crate::fabricate::build::Build;
use crate::fabricate::report::BuildReport;
use crate::math::plane::distance;
use crate::scene::Product;
use crate::words::{area, brief, millimetres, millimetres_limit, part, rough_degrees};

/// A line of the bill: item and quantity.
pub(super) type Line = (&'static str, String);

/// The bills of the model and of the building.
pub(super) fn bill(build: &Build, report: &BuildReport) -> [Vec<Line>; 2] {
    [model(build, report), building(build, report)]
}

fn model(build: &Build, report: &BuildReport) -> Vec<Line> {
    let [width, height] = report.sheet_mm;
    let thickness = build.settings.thickness;
    let material = match thickness > 0.0 {
        true => format!("{} {}", millimetres_limit(thickness), build.settings.material),
        false => build.settings.material.clone(),
    };
    let of_sheets = report.sheets as f64 * width * height;
    let mut lines = vec![
        ("Material", material),
        ("Sheets", format!("{} of {} x {} mm", report.sheets, brief(width), brief(height))),
        ("Area of the sheets", area(of_sheets)),
        ("Covered by parts", format!("{} ({})", area(report.cut_area_mm2), part(report.used))),
        ("Parts on sheets", report.parts_in_words(true)),
        ("Length of cuts", millimetres(report.cut_length_mm)),
    ];
    lines.extend(report.smallest_part_mm.map(|_| ("Smallest part", report.smallest_in_words())));
    match report.product {
        Product::Panels => {
            let least = [0, 1].map(|k| match report.no_least_joint[k] {
                "" => millimetres(report.least_joint_mm[k].unwrap_or(0.0)),
                why => format!("not known ({why})"),
            });
            let least = format!("{} outside, {} inside", least[0], least[1]);
            lines.extend([
                ("Joint on the sheet", millimetres(report.joint_mm)),
                ("Least joint for that thickness", least),
            ]);
        }
        Product::Fins => lines.extend(
            report
                .frame
                .as_ref()
                .filter(|_| !build.fins.is_empty())
                .map(|frame| ("Cut back at nodes by up to", millimetres(frame.cut_back_mm))),
        ),
        Product::Paper => {
            // Where valleys are dashed, the gaps are folded too.
            let scores = build.paper.iter().flat_map(|model| {
                let places = build.layout.sheets.iter().flat_map(|sheet| &sheet.places);
                places.flat_map(|place| model.scores(model.pieces[place.part]))
            });
            let scores = scores.map(|([p, q], _)| distance(p, q)).fold(0.0, |a, b| a + b);
            lines.push(("Length of scores", millimetres(scores)));
            let [tabs, tongues] =
                report.paper.as_ref().map_or([0; 2], |paper| [paper.tabs, paper.tongues]);
            let joins = [("Tabs", tabs), ("Tongues and slots", tongues)].into_iter();
            lines.extend(joins.filter(|(_, n)| *n > 0).map(|(what, n)| (what, n.to_string())));
        }
    }
    lines
}

fn building(build: &Build, report: &BuildReport) -> Vec<Line> {
    let building = build.mm_of_building();
    let panels: f64 = build.surface.areas.iter().map(|area| area.length()).sum();
    let edges: f64 = build.surface.real_edges().map(|edge| build.surface.length(edge)).sum();
    let alike = millimetres_limit(build.settings.alike);
    let mut lines = vec![
        ("Panels", format!("{}, {}", report.panels, area(panels * building * building))),
        ("Types of panels", format!("{} within {alike}", report.types)),
        ("Types of edges", format!("{} within {alike}", report.edge_types)),
        ("Edges", format!("{}, {}", report.edges, millimetres(edges * building))),
        ("Nodes", report.nodes.to_string()),
    ];
    lines.extend(report.frame.as_ref().map(|frame| {
        let types = format!("{} within {}°", frame.node_types, brief(frame.alike_deg));
        ("Types of nodes", types)
    }));
    lines.extend(report.fold_deg.map(|[low, high]| {
        ("Folds between panels", format!("{} to {}", rough_degrees(low), rough_degrees(high)))
    }));
    lines.push(("Change by laying flat", millimetres(report.flattening_error_mm)));
    lines
}
