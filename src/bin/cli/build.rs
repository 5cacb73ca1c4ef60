//! `shape-up build`: panels on sheets, the build check, and their files.

use super::{Failure, arguments, input, output};
use shape_up::fabricate::{
    Advice, AdvisedValue, Build, BuildFile, BuildReport, BuildWords, CardWords, CheckRow,
    CheckWords, FrameReport, PARTS, PaperReport, ReportView, Stand, unit_of,
};
use shape_up::mesh::Mesh;
use shape_up::scene::{BUILD_SETTINGS, BuildSetting, BuildSettings, Scene, Up};
use shape_up::words;
use shape_up::words::UNITS;
use std::path::{Path, PathBuf};

pub(super) fn build(asked: &arguments::Build) -> Result<(), Failure> {
    let input::Input { scene, mesh, mut remarks, .. } = input::read_in(asked.units, &asked.input)?;
    let at = |message: String| Failure::Input(format!("{}: {message}", asked.input.display()));
    scene.validate(&mesh).map_err(|error| at(error.to_string()))?;
    let settings = settings(asked, &scene).map_err(at)?;
    remarks.extend(without_effect(asked, &settings));
    let mesh = Mesh { positions: scene.start(&mesh).to_vec(), ..mesh };
    let unit = unit_of(&scene.units)
        .map_err(|fault| at(format!("{fault}, such as --units {}", UNITS[0].symbol)))?;
    if scene.units.is_empty() {
        remarks.push(format!("the file has no unit: lengths are read as {}", unit.symbol));
    }
    let build = Build::new(&mesh, &settings, unit, &Stand::of_scene(&scene))
        .map_err(|fault| at(fault.to_string()))?;
    let report = build.report();
    let said = build.words(&report);
    if asked.out.is_some() && report.placed == 0 {
        let why = report.card.problems.iter().chain(&said.warnings).cloned().collect::<Vec<_>>();
        return Err(at(format!("nothing can be cut: {}", why.join(" "))));
    }
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    if let Some(folder) = &asked.out {
        let drawn = build.files(scene.up == Up::Z).into_iter();
        files.extend(drawn.map(|file| (folder.join(file.name), file.bytes)));
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
    match &asked.out {
        Some(out) if settings.one_file_each => {
            output::write_with_folder(&out.join(PARTS), &files)?;
        }
        Some(out) => output::write_with_folder(out, &files)?,
        None => output::write(&files)?,
    }
    let left_over =
        |folder: &Path, is_of_build: fn(&str) -> bool| left_over(folder, &files, is_of_build);
    let is_drawing = |name: &str| name.ends_with(".svg") || name.ends_with(".dxf");
    remarks.extend(asked.out.as_ref().and_then(|out| left_over(out, BuildFile::is_name_of_one)));
    remarks.extend(asked.out.as_ref().and_then(|out| left_over(&out.join(PARTS), is_drawing)));
    let names = files.iter().map(|(path, _)| format!("{}\n", path.display()));
    output::print(&(words(&report, &said, &remarks) + &names.collect::<String>()))
}

/// Names the files in a folder that an earlier build wrote, as their names say, and this one did not:
/// they are kept, but must not be cut with the new ones.
fn left_over(
    folder: &Path,
    written: &[(PathBuf, Vec<u8>)],
    is_of_build: fn(&str) -> bool,
) -> Option<String> {
    const MOST: usize = 8;
    let found = std::fs::read_dir(folder).ok()?;
    let mut names: Vec<String> = found
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| is_of_build(name))
        .filter(|name| !written.iter().any(|(path, _)| *path == folder.join(name)))
        .collect();
    names.sort();
    (!names.is_empty()).then(|| {
        let some = words::and_more(&names, MOST);
        format!("{}: not of this build, but of an earlier one: {some}", folder.display())
    })
}

/// Names the options that the product does not use.
fn without_effect(asked: &arguments::Build, settings: &BuildSettings) -> Option<String> {
    let product = settings.product;
    let given = asked.settings.iter().filter_map(|(id, _)| declared(id));
    let unused = given.filter(|setting| !setting.products.contains(&product));
    let names: Vec<String> = unused.filter_map(BuildSetting::option).collect();
    (!names.is_empty()).then(|| format!("of no effect on {}: {}", product.id(), names.join(", ")))
}

fn declared(id: &str) -> Option<&'static BuildSetting> {
    BUILD_SETTINGS.iter().find(|setting| setting.id == id)
}

/// Returns the settings of the scene, overridden by presets, and these by what is asked for by itself,
/// wherever it stands.
fn settings(asked: &arguments::Build, scene: &Scene) -> Result<BuildSettings, String> {
    let own = scene.build.as_deref().cloned().unwrap_or_default();
    let given =
        asked.presets.iter().chain(&asked.settings).filter(|(id, _)| declared(id).is_some());
    let given = given.map(|(id, value)| ((*id).to_owned(), value.clone())).collect();
    own.with_all(given).map_err(|fault| fault.to_string())
}

fn words(report: &BuildReport, said: &BuildWords, remarks: &[String]) -> String {
    let [width, height] = report.sheet_mm;
    let mut lines = vec![
        said.sheets.clone(),
        format!("sheets of {width} x {height} mm, scale 1:{}, unit {}", report.scale, report.unit),
        format!("types of edges {}", report.edge_types),
    ];
    lines.extend(report.frame.as_ref().map(|frame| frame_line(frame, report)));
    lines.extend(report.paper.as_ref().map(paper_line));
    let CardWords { check, offset, .. } = &said.card;
    let sentences = [offset, &said.joint].into_iter().filter(|words| !words.is_empty());
    lines.extend(sentences.cloned());
    lines.extend(report.card.check.iter().zip(check).map(check_line));
    lines.extend(said.advice.iter().map(advice_line));
    lines.extend(said.warnings.iter().cloned());
    lines.extend(report.card.problems.iter().map(|problem| format!("problem: {problem}")));
    lines.join("\n") + "\n" + &output::notes(remarks)
}

fn frame_line(frame: &FrameReport, report: &BuildReport) -> String {
    // Those that are cut away altogether have no length that is.
    let cut_back = match report.placed + report.too_large.len() > 0 {
        true => format!("fins cut back by up to {}; ", words::millimetres(frame.cut_back_mm)),
        false => String::new(),
    };
    let step = words::millimetres(frame.node_step_mm);
    format!("nodes {}; {cut_back}steps between prisms up to {step}", frame.nodes)
}

fn paper_line(paper: &PaperReport) -> String {
    let folds = format!("ridges {}, valleys {}", paper.ridges, paper.valleys);
    match paper.seams {
        0 => folds,
        seams => format!("{folds}, seams {seams}"),
    }
}

/// An advice, with the options that follow it.
fn advice_line(Advice { words, choices }: &Advice) -> String {
    let option = |choice: &AdvisedValue| {
        let value = choice.value.map_or("auto".to_owned(), |value| value.to_string());
        Some(format!("{} {value}", declared(choice.setting)?.option()?))
    };
    let options: Vec<String> = choices.iter().filter_map(option).collect();
    if options.is_empty() {
        return words.clone();
    }
    format!("{words} Try {}.", options.join(" or "))
}

fn check_line(
    (row, CheckWords { value, limit, state, remedy, .. }): (&CheckRow, &CheckWords),
) -> String {
    let limit = if limit.is_empty() { String::new() } else { format!(" ({limit})") };
    let state = if state.is_empty() { String::new() } else { format!(": {state}") };
    let remedy = if remedy.is_empty() { String::new() } else { format!(". {remedy}") };
    format!("{:<15} {value}{limit}{state}{remedy}", row.label)
}
