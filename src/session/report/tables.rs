//! Tables for export as CSV: the errors of the faces, the energies of the iterations, and the angles
//! at the corners of the faces (paper Fig. 7). They are comma-separated with a decimal point and one
//! header line. Numbers have the fewest digits that read back to the same bits. Units are in the header,
//! in brackets, if known.

use super::face_measure::FACE_MEASURES;
use super::measuring::Shape;
use crate::fabricate::file::text_field;
use crate::mesh::{Decimal, angle_histogram};
use crate::session::{Session, TraceEntry};
use crate::words::MeasureUnit;

/// Number of bins of equal width from 0 to 180 degrees.
const ANGLE_BINS: usize = 36;

impl Session {
    /// One line per face, from 0: its corners, its groups, and every measure of [`FACE_MEASURES`],
    /// empty if the face has no value.
    pub fn errors_csv(&mut self) -> String {
        let mesh = self.mesh();
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
            let length = self.document().units.as_str();
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
            let values = self.face_values(measure.id);
            columns.push(values.expect("the measure is one of the list"));
        }
        text.push('\n');
        for (face, corners) in self.faces().iter().enumerate() {
            let words = [face.to_string(), corners.len().to_string(), text_field(&groups[face])];
            let values: Vec<f64> = columns.iter().map(|column| column[face]).collect();
            row(&mut text, &words, &values);
        }
        text
    }

    /// One line per recorded iteration since the scene was opened: the energies, of which the total has
    /// the weights.
    pub fn convergence_csv(&self) -> String {
        let units = &self.document().units;
        let square = if units.is_empty() { String::new() } else { format!("{units}²") };
        let unit = bracketed(&square);
        let names =
            ["shape", "close", "smooth", "handles", "total"].map(|name| format!("{name}{unit}"));
        let mut text = format!("iteration,{}\n", names.join(","));
        for TraceEntry { iteration, energy: e } in self.trace() {
            let numbers = [e.shape, e.close, e.smooth, e.handles, e.total];
            row(&mut text, &[iteration.to_string()], &numbers);
        }
        text
    }

    /// Histogram of the face angles, in bins of five degrees from 0 to 180.
    pub fn angles(&self, shape: &Shape) -> Vec<u32> {
        angle_histogram(&self.positions_of(shape), self.faces(), ANGLE_BINS)
    }

    /// One line per bin: its lower and upper angle, and the number of corners of the original and of
    /// the current shape in it.
    pub fn angles_csv(&self) -> String {
        let [original, now] = [Shape::Original, Shape::Now].map(|shape| self.angles(&shape));
        let mut text = "from (°),to (°),original,now\n".to_owned();
        let width = 180 / ANGLE_BINS;
        for (bin, (original, now)) in original.iter().zip(&now).enumerate() {
            let from = bin * width;
            text.push_str(&format!("{from},{},{original},{now}\n", from + width));
        }
        text
    }
}

/// Appends a line: words, then numbers, with empty fields for numbers that are not finite.
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

/// Replaces the characters that would end a field, for text inside one.
fn quoted_part(text: &str) -> String {
    text.replace(['"', ',', '\n', '\r'], " ")
}
