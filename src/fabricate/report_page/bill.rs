//! The bill of materials.

use super::words::{area, count, length, short};
use crate::fabricate::build::Build;
use crate::fabricate::report::BuildReport;
use crate::math::plane::Point2;
use crate::scene::Product;

/// A line of the bill: item and quantity.
pub(super) type Line = (&'static str, String);

/// The bills of the model and of the building.
pub(super) fn bill(build: &Build, report: &BuildReport) -> [Vec<Line>; 2] {
    [model(build, report), building(build, report)]
}

/// The noun for the parts of a product.
pub(super) fn noun(product: Product) -> &'static str {
    match product {
        Product::Panels => "panel",
        Product::Fins => "fin",
        Product::Paper => "piece",
    }
}

fn model(build: &Build, report: &BuildReport) -> Vec<Line> {
    let [width, height] = report.sheet_mm;
    let thickness = build.settings.thickness;
    let material = match thickness > 0.0 {
        true => format!("{} mm {}", short(thickness), build.settings.material),
        false => build.settings.material.clone(),
    };
    let of_sheets = report.sheets as f64 * width * height;
    let mut lines = vec![
        ("Material", material),
        ("Sheets", format!("{} of {} x {} mm", report.sheets, short(width), short(height))),
        ("Area of the sheets", area(of_sheets)),
        (
            "Covered by parts",
            format!("{} ({:.0} %)", area(report.cut_area_mm2), 100.0 * report.used),
        ),
        ("Parts on sheets", count(report.placed, noun(report.product))),
        ("Length of cuts", length(report.cut_length_mm)),
    ];
    let folds = || build.parts.iter().flat_map(|part| part.ridges.iter().chain(&part.valleys));
    match report.product {
        Product::Panels => {
            let [outside, inside] = report.least_joint_mm.map(|mm| length(mm.unwrap_or(0.0)));
            lines.extend([
                ("Joint on the sheet", length(report.joint_mm)),
                ("Least joint for that thickness", format!("{outside} outside, {inside} inside")),
            ]);
        }
        Product::Fins => lines.extend(
            report
                .frame
                .as_ref()
                .map(|frame| ("Cut back at nodes by up to", length(frame.cut_back_mm))),
        ),
        Product::Paper => {
            lines.push(("Length of scores", length(folds().map(|fold| long(fold)).sum())));
            lines.extend(report.paper.as_ref().map(|paper| ("Tabs", paper.tabs.to_string())));
        }
    }
    lines
}

fn building(build: &Build, report: &BuildReport) -> Vec<Line> {
    let building = build.mm_of_building();
    let panels: f64 = build.surface.areas.iter().map(|area| area.length()).sum();
    let edges: f64 = build.surface.edges.iter().map(|edge| build.surface.length(edge)).sum();
    let alike = short(build.settings.alike);
    let mut lines = vec![
        ("Panels", format!("{}, {}", report.panels, area(panels * building * building))),
        ("Types of panels", format!("{} within {alike} mm", report.types)),
        ("Types of edges", format!("{} within {alike} mm", report.edge_types)),
        ("Edges", format!("{}, {}", report.edges, length(edges * building))),
        ("Nodes", report.nodes.to_string()),
    ];
    lines.extend(report.frame.as_ref().map(|frame| {
        let types = format!("{} within {}\u{b0}", frame.node_types, short(frame.alike_deg));
        ("Types of nodes", types)
    }));
    lines.extend(report.fold_deg.map(|[low, high]| {
        ("Folds between panels", format!("{}\u{b0} to {}\u{b0}", short(low), short(high)))
    }));
    lines.push(("Change by laying flat", length(report.flattening_error_mm)));
    lines
}

fn long(line: &[Point2]) -> f64 {
    let parts = line.windows(2).map(|ends| {
        let [x, y] = [0, 1].map(|k| ends[1][k] - ends[0][k]);
        (x * x + y * y).sqrt()
    });
    parts.sum()
}
