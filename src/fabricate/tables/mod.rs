//! Lists of the parts, and a summary. Every column name includes its unit: `_sheet_mm` of the parts, at
//! the scale of the model, and `_mm` of the building. Settings in the summary are as they are set; its last
//! rows say how to read the other tables.

mod beams;
mod panels;
mod paper;
mod place;
mod reading;
mod shape;
mod splices;
mod strips;

use super::build::Build;
use super::file::{Cell, Table};
use crate::scene::{
    BUILD_SETTINGS, BuildForm, BuildSetting, BuildSettings, BuildUnit, Product, ordered,
};
use serde_json::Value;

/// The names of the files of all tables of all products.
pub(super) const NAMES: [&str; 15] = [
    "panels.csv",
    "types.csv",
    "splices.csv",
    "strips.csv",
    "fins.csv",
    "beams.csv",
    "node-beams.csv",
    "node-types.csv",
    "discs.csv",
    "pieces.csv",
    "joins.csv",
    "tongues.csv",
    "edges.csv",
    "nodes.csv",
    "summary.csv",
];

/// All tables, with the names of their files.
pub(super) fn all(build: &Build) -> Vec<(&'static str, String)> {
    let mut tables = match (build.settings.product, &build.frame) {
        (Product::Panels, _) => {
            let mut tables =
                vec![("panels.csv", panels::panels(build)), ("types.csv", panels::types(build))];
            if !build.splices.is_empty() {
                tables.push(("splices.csv", splices::splices(build)));
            }
            let strips = build.strips();
            if !strips.is_empty() {
                tables.push(("strips.csv", strips::strips(build, &strips)));
            }
            tables
        }
        (Product::Fins, Some(frame)) => beams::all(build, frame),
        (Product::Paper, _) => paper::all(build),
        (Product::Fins, None) => Vec::new(),
    };
    tables.extend([("edges.csv", shape::edges(build)), ("nodes.csv", shape::nodes(build))]);
    let names: Vec<&str> = tables.iter().map(|(name, _)| *name).collect();
    tables.push(("summary.csv", summary(build, &names)));
    tables
}

/// The summary, which explains the tables of these names.
fn summary(build: &Build, names: &[&str]) -> String {
    let report = build.report_without_curves();
    let mut table = Table::new(&["what", "value", "unit"]);
    let mut row = |what: &str, value: Cell<'_>, unit: &str| {
        table.row([Cell::from(what), value, Cell::from(unit)]);
    };
    row("program", Cell::from(concat!("shape-up ", env!("CARGO_PKG_VERSION"))), "");
    row("unit of the model", Cell::from(build.unit.symbol), "");
    row("panels", Cell::from(report.panels), "");
    row("product", Cell::from(report.product.id()), "");
    row("parts on sheets", Cell::from(report.placed), "");
    if let Some(frame) = report.frame.as_ref().filter(|_| !build.discs.is_empty()) {
        row("node discs", Cell::from(frame.placed_discs), "");
    }
    if report.spliced > 0 {
        row("panels in pieces", Cell::from(report.spliced), "");
        row("splice plates", Cell::from(report.plates), "");
    }
    if report.strips > 0 {
        row("cover strips", Cell::from(report.strips), "");
        row("length of cover strips", Cell::from(report.strip_length_mm), "sheet mm");
    }
    if report.halved > 0 {
        row("panels cut as two triangles", Cell::from(report.halved), "");
    }
    if let Some(paper) = report.paper.as_ref().filter(|paper| paper.tongues > 0) {
        row("tongues and slots", Cell::from(paper.tongues), "");
    }
    row("parts without room for their name", Cell::from(report.unnamed.len()), "");
    row("sheets", Cell::from(report.sheets), "");
    row("area of parts", Cell::from(report.cut_area_mm2), "sheet mm2");
    row("length of cuts", Cell::from(report.cut_length_mm), "sheet mm");
    row("smallest part", Cell::from(&*report.smallest_part), "");
    row(
        "smallest part, width",
        Cell::from(report.smallest_part_mm.map(|size| size[1])),
        "sheet mm",
    );
    if report.product == Product::Panels {
        row("joint on the sheet", Cell::from(report.joint_mm), "sheet mm");
        // A joint below it lets panels of this thickness meet.
        for (side, k) in ["outside", "inside"].into_iter().zip(0..) {
            let is_known = report.no_least_joint[k].is_empty();
            let known = is_known.then(|| report.least_joint_mm[k].unwrap_or(0.0));
            row(&format!("least joint, panels {side}"), Cell::from(known), "sheet mm");
        }
    }
    row("legend of the sheets", Cell::from(&*build.legend()), "");
    row("types of panels", Cell::from(report.types), "");
    for check in &report.card.check {
        row(check.label, Cell::from(check.value), check.unit);
        row(&format!("{}, limit", check.label), Cell::from(check.limit), check.unit);
    }
    let settings = used_settings(build);
    let seams = build.settings.seams.iter().copied().map(|ends| build.beam_name(ordered(ends)));
    let seams = seams.collect::<Vec<_>>().join(" ");
    let is_used = |setting: &&BuildSetting| {
        // Without edges there is nothing to say of them.
        let is_empty = matches!(setting.form, BuildForm::Edges) && seams.is_empty();
        setting.products.contains(&report.product) && !is_empty
    };
    for setting in BUILD_SETTINGS.iter().filter(is_used) {
        let unit = match setting.form {
            BuildForm::Number { unit: BuildUnit::Mesh, .. } => build.unit.symbol,
            BuildForm::Number { unit: BuildUnit::Mm, .. } => "mm",
            BuildForm::Number { unit: BuildUnit::Degrees, .. } => "deg",
            _ => "",
        };
        let value = settings.value(setting);
        let cell = match &value {
            Value::Number(number) => Cell::from(number.as_f64()),
            Value::String(text) => Cell::from(&**text),
            Value::Bool(is_on) => Cell::from(if *is_on { "on" } else { "off" }),
            Value::Array(_) => Cell::from(&*seams),
            _ => Cell::None,
        };
        row(&format!("{} ({})", setting.label, setting.id), cell, unit);
    }
    let has_tabs = report.paper.as_ref().is_some_and(|paper| paper.tabs > 0);
    let explained = reading::reading(names).filter(|(what, _)| has_tabs || *what != "tabs");
    for (what, words) in explained {
        row(&format!("how to read {what}"), Cell::from(words), "");
    }
    table.into_text()
}

/// The settings of a build, with the values that were computed for those that are absent.
fn used_settings(build: &Build) -> BuildSettings {
    BuildSettings {
        kind: build.offset.as_ref().map(|(axes, _)| axes.kind),
        distance: Some(build.distance()),
        beam_width: Some(build.beam_width()),
        ..build.settings.clone()
    }
}
