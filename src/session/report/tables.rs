//! Tables to be taken away, as CSV: the errors of the faces, and the energies of the iterations.
//! Comma-separated with a decimal point, one head line; numbers have the fewest digits that read
//! back to the same bits. Units stand in the head, in brackets, where they are known.

use super::face_measure::{FACE_MEASURES, MeasureUnit, face_values};
use super::measuring::{Measuring, Shape};
use crate::mesh::Decimal;
use crate::session::run::TraceEntry;

/// One line per face, from 0: its corners, the groups that it is in, and every measure of
/// [`FACE_MEASURES`]; empty where a face has no such value.
pub(crate) fn errors_csv(model: &mut Measuring<'_>) -> String {
    let mesh = model.rest.mesh();
    let mut groups = vec![String::new(); mesh.faces.len()];
    for group in &mesh.groups {
        for &face in &group.faces {
            let names = &mut groups[face as usize];
            if !names.is_empty() {
                names.push(' ');
            }
            names.push_str(&group.name);
        }
    }
    let mut text = "face,corners,groups".to_owned();
    let mut columns = Vec::new();
    for measure in FACE_MEASURES {
        let length = model.scene.document().units.as_str();
        let per = |power: &str| match length {
            "" => String::new(),
            length => ["1/", length, power].concat(),
        };
        let unit = match measure.unit {
            MeasureUnit::Length => length.to_owned(),
            MeasureUnit::Percent => "%".to_owned(),
            MeasureUnit::Degrees => "°".to_owned(),
            MeasureUnit::Number => String::new(),
            MeasureUnit::PerLength => per(""),
            MeasureUnit::PerArea => per("²"),
        };
        text.push_str(&format!(",{}{}", measure.label, bracketed(&unit)));
        let values = face_values(model, measure.id, Shape::Now);
        columns.push(values.expect("the measure is one of the list"));
    }
    text.push('\n');
    for (face, corners) in mesh.faces.iter().enumerate() {
        let words = [face.to_string(), corners.len().to_string(), quoted(&groups[face])];
        let values: Vec<f64> = columns.iter().map(|column| column[face]).collect();
        row(&mut text, &words, &values);
    }
    text
}

/// One line per recorded iteration: its energies, weights included, in the square of the unit `units`.
pub(crate) fn convergence_csv(trace: &[TraceEntry], units: &str) -> String {
    let square = if units.is_empty() { String::new() } else { format!("{units}²") };
    let unit = bracketed(&square);
    let names =
        ["shape", "close", "smooth", "handles", "total"].map(|name| format!("{name}{unit}"));
    let mut text = format!("iteration,{}\n", names.join(","));
    for TraceEntry { iteration, energy: e } in trace {
        let numbers = [e.shape, e.close, e.smooth, e.handles, e.total];
        row(&mut text, &[iteration.to_string()], &numbers);
    }
    text
}

/// Appends a line: words, then numbers, nothing for what is not one.
fn row(text: &mut String, words: &[String], numbers: &[f64]) {
    text.push_str(&words.join(","));
    for &number in numbers {
        text.push(',');
        if number.is_finite() {
            text.push_str(&Decimal(number).to_string());
        }
    }
    text.push('\n');
}

fn bracketed(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { quoted_part(&format!(" ({unit})")) }
}

/// Without what would end the field: it stands in the middle of one.
fn quoted_part(text: &str) -> String {
    text.replace(['"', ',', '\n', '\r'], " ")
}

/// A field that holds anything.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
