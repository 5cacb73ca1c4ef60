//! Tables to be taken away, as CSV: the errors of the faces, and the energies of the iterations.
//! Comma-separated with a decimal point, one head line; numbers have the fewest digits that read
//! back to the same bits. Units stand in the head, in brackets, where they are known.

use super::Session;
use std::fmt::Write;

impl Session {
    /// One line per face, from 0: its corners, the groups that it is in, and its errors in the unit of
    /// the mesh, whose largest and mean are those of the report.
    pub fn errors_csv(&mut self) -> String {
        let measures = self.measures();
        let residuals = self.residuals();
        let mut groups = vec![String::new(); self.mesh.faces.len()];
        for group in &self.mesh.groups {
            for &face in &group.faces {
                let names = &mut groups[face as usize];
                if !names.is_empty() {
                    names.push(' ');
                }
                names.push_str(&group.name);
            }
        }
        let unit = bracketed(&self.document.units);
        let mut text = format!(
            "face,corners,groups,planarity distance{unit},circularity distance{unit},\
             distance to projection{unit}\n"
        );
        for (face, corners) in self.mesh.faces.iter().enumerate() {
            let errors = [
                measures.planarity_distances[face],
                measures.circularity_distances[face],
                residuals[face],
            ];
            row(
                &mut text,
                &[face.to_string(), corners.len().to_string(), quoted(&groups[face])],
                &errors,
            );
        }
        text
    }

    /// One line per iteration since the scene was opened: the energies, weights included.
    pub fn convergence_csv(&self) -> String {
        let units = &self.document.units;
        let square = if units.is_empty() { String::new() } else { format!("{units}²") };
        let unit = bracketed(&square);
        let names =
            ["shape", "close", "smooth", "handles", "total"].map(|name| format!("{name}{unit}"));
        let mut text = format!("iteration,{}\n", names.join(","));
        for entry in self.trace.iter().flat_map(|trace| trace.entries()) {
            let e = entry.energy;
            row(
                &mut text,
                &[entry.iteration.to_string()],
                &[e.shape, e.close, e.smooth, e.handles, e.total],
            );
        }
        text
    }
}

/// Appends a line: words, then numbers.
fn row(text: &mut String, words: &[String], numbers: &[f64]) {
    text.push_str(&words.join(","));
    for &number in numbers {
        let digits = serde_json::Value::from(number).to_string();
        write!(text, ",{}", digits.strip_suffix(".0").unwrap_or(&digits))
            .expect("a string takes all that is written to it");
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
