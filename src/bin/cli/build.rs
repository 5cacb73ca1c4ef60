//! `shape-up build`: panels on sheets, the build check, and their files.

use super::output::MadeFolders;
use super::{Failure, arguments, input, output};
use shape_up::fabricate::{
    Build, BuildFile, BuildReport, CheckRow, FrameReport, LengthInMetres, PRESENTATION,
    PaperReport, ReportView,
};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Product};
use shape_up::scene::{Scene, UNITS, Up};
use std::path::{Path, PathBuf};

pub(super) fn build(asked: &arguments::Build) -> Result<(), Failure> {
    let input::Input { mut scene, mesh, mut remarks, .. } = input::read(&asked.input)?;
    scene.units = asked.units.map_or(scene.units, str::to_owned);
    let at = |message: String| Failure::Input(format!("{}: {message}", asked.input.display()));
    scene.validate(&mesh).map_err(|error| at(error.to_string()))?;
    let settings = settings(asked, &scene);
    let mesh = Mesh { positions: scene.start(&mesh).to_vec(), ..mesh };
    let unit = UNITS.iter().find(|unit| unit.symbol == scene.units).unwrap_or_else(|| {
        let what = match &*scene.units {
            "" => "the file has no unit".to_owned(),
            own => format!("the unit {own:?} is not known"),
        };
        remarks.push(format!("{what}: lengths are read as m"));
        &UNITS[0]
    });
    let unit = LengthInMetres { symbol: unit.symbol.to_owned(), metres: unit.metres };
    let build = Build::new(&mesh, &settings, unit).map_err(|fault| at(fault.to_string()))?;
    let report = build.report();
    let _made = asked.out.as_deref().map(MadeFolders::make).transpose()?;
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    if let Some(folder) = &asked.out {
        let drawn = build.files(scene.up == Up::Z).into_iter();
        files.extend(drawn.map(|file| (folder.join(file.name), file.text.into_bytes())));
        files.push((folder.join(PRESENTATION), build.presentation(scene.up == Up::Z)));
    }
    if let Some(path) = &asked.report {
        files.push((path.clone(), output::json(&report).into_bytes()));
    }
    if let Some(path) = &asked.report_page {
        let stem = || asked.input.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let view = ReportView {
            title: Some(scene.title).filter(|title| !title.is_empty()).unwrap_or_else(stem),
            z_up: scene.up == Up::Z,
            camera: None,
            link: asked.link.clone().unwrap_or_default(),
        };
        files.push((path.clone(), build.report_page(&view).into_bytes()));
    }
    output::write(&files)?;
    remarks.extend(asked.out.as_deref().and_then(|folder| left_over(folder, &files)));
    let names = files.iter().map(|(path, _)| format!("{}\n", path.display()));
    output::print(&(words(&report, &remarks) + &names.collect::<String>()))
}

/// Names the files in a folder that an earlier build wrote and this one did not: they are kept, but
/// must not be cut with the new ones.
fn left_over(folder: &Path, written: &[(PathBuf, Vec<u8>)]) -> Option<String> {
    const MOST: usize = 8;
    let found = std::fs::read_dir(folder).ok()?;
    let mut names: Vec<String> = found
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| BuildFile::is_name_of_one(name))
        .filter(|name| !written.iter().any(|(path, _)| *path == folder.join(name)))
        .collect();
    names.sort();
    let some = names[..names.len().min(MOST)].join(", ");
    let more = match names.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    (!names.is_empty()).then(|| {
        format!("{}: not of this build, but of an earlier one: {some}{more}", folder.display())
    })
}

/// Returns the settings of the scene, overridden by the options.
fn settings(asked: &arguments::Build, scene: &Scene) -> BuildSettings {
    let own = scene.build.as_deref().cloned().unwrap_or_default();
    BuildSettings {
        product: asked.product.unwrap_or(own.product),
        pieces: asked.pieces.unwrap_or(own.pieces),
        page: asked.page.unwrap_or(own.page),
        material: asked.material.clone().unwrap_or(own.material),
        thickness: asked.thickness.unwrap_or(own.thickness),
        hole: asked.hole.unwrap_or(own.hole),
        kind: asked.kind.or(own.kind),
        distance: asked.distance.or(own.distance),
        joint: asked.joint.unwrap_or(own.joint),
        scale: asked.scale.unwrap_or(own.scale),
        sheet: asked.sheet.unwrap_or(own.sheet),
        ..own
    }
}

fn words(report: &BuildReport, remarks: &[String]) -> String {
    let BuildReport { product, parts, placed, sheets, scale, types, .. } = report;
    let product = match product {
        Product::Paper => "pieces of paper",
        own => own.id(),
    };
    let [width, height] = report.sheet_mm;
    let used = 100.0 * report.used;
    let noun = if *sheets == 1 { "sheet" } else { "sheets" };
    let mut lines = vec![format!(
        "{placed} of {parts} {product} on {sheets} {noun} of {width} x {height} mm, {used:.0} % covered, scale 1:{scale}, unit {}",
        report.unit
    )];
    lines.push(format!("types of panels {types}, of edges {}", report.edge_types));
    lines.extend(report.frame.as_ref().map(frame_line));
    lines.extend(report.paper.as_ref().map(paper_line));
    if let Some(offset) = &report.offset {
        let how = if offset.exact { "exact" } else { "least-squares fit" };
        lines.push(format!(
            "offset of {}s, {how}, {} mm",
            offset.kind.id(),
            output::short(offset.distance_mm)
        ));
        lines.extend((!offset.exact).then(|| format!("not exact: {}", offset.why_not)));
    }
    lines.extend(report.check.iter().map(check_line));
    for (what, names) in
        [("larger than the sheet", &report.too_large), ("not cut", &report.not_cut)]
    {
        if !names.is_empty() {
            lines.push(format!("{what}: {}", names.join(", ")));
        }
    }
    if report.dropped_names + report.small_names > 0 {
        lines.push(format!(
            "names: {} of neighbours have no room, {} smaller than 2 mm",
            report.dropped_names, report.small_names
        ));
    }
    if !report.unnamed.is_empty() {
        let names = &report.unnamed;
        let pieces = if names.len() == 1 { "part has" } else { "parts have" };
        lines.push(format!("{} {pieces} no room for a name: {}", names.len(), names.join(", ")));
    }
    if report.holes + report.dropped_holes > 0 {
        lines.push(format!("holes {}, without room {}", report.holes, report.dropped_holes));
    }
    lines.extend(report.problems.iter().map(|problem| format!("problem: {problem}")));
    lines.extend(remarks.iter().map(|remark| format!("note: {remark}")));
    lines.join("\n") + "\n"
}

fn frame_line(frame: &FrameReport) -> String {
    format!(
        "nodes {}, types of nodes {} within {} degrees; fins cut back by up to {} mm; steps between prisms up to {} mm",
        frame.nodes,
        frame.node_types,
        frame.alike_deg,
        output::short(frame.cut_back_mm),
        output::short(frame.node_step_mm)
    )
}

fn paper_line(paper: &PaperReport) -> String {
    const MOST: usize = 8;
    let bare = &paper.without_tab;
    let bare = match (bare.len(), bare[..bare.len().min(MOST)].join(", ")) {
        (0, _) => String::new(),
        (n, some) if n > MOST => {
            format!("; no tab between {some} and {} more", n - MOST)
        }
        (_, all) => format!("; no tab between {all}"),
    };
    format!(
        "ridges {}, valleys {}, tabs {}, panels creased {}{bare}",
        paper.ridges, paper.valleys, paper.tabs, paper.creased
    )
}

fn check_line(row: &CheckRow) -> String {
    let number = |value: Option<f64>| value.map_or("-".to_owned(), output::short);
    let met = match row.met {
        Some(true) => "met",
        Some(false) => "NOT MET",
        None => "not available",
    };
    format!(
        "{:<15} {} {}, limit {}: {met}",
        row.label,
        number(row.value),
        row.unit,
        number(row.limit)
    )
}
