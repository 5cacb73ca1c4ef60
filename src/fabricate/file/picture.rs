//! A sheet as a page shows it: a path for each layer, however many parts there are, in whole hundredths of a
//! millimetre, which are short to write and quick to read. The files that are saved are exact: see `svg`.

use super::drawing::{Drawing, DrawnLine};
use crate::fabricate::panel::Point2;
use crate::fabricate::sheet::Role;
use serde::Serialize;

/// So many steps are a millimetre.
const STEPS: f64 = 100.0;

/// A sheet as a page shows it; lengths are in hundredths of a millimetre, y downwards.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SheetPicture {
    /// Its name.
    pub name: String,
    /// Width and height.
    pub size: [i32; 2],
    /// What lies under the outlines, from below.
    pub layers: Vec<PictureLayer>,
    /// The colour of outlines.
    pub colour: String,
    /// The outline of each part, as a path of its own.
    pub outlines: Vec<String>,
    /// The name of each part.
    pub parts: Vec<String>,
    /// The panels of each part.
    pub panels: Vec<Vec<u32>>,
    /// A path along the sides, and to the corners, of panels where beams and nodes are not within a limit.
    pub failed: String,
}

/// The lines of one purpose.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PictureLayer {
    /// The name of the layer in files.
    pub name: &'static str,
    /// As CSS writes it.
    pub colour: String,
    /// All lines as one path.
    pub path: String,
}

/// Draws a sheet, with these lines where something fails.
pub fn picture(drawing: &Drawing, failed: &[Vec<Point2>]) -> SheetPicture {
    let height = drawing.size[1];
    let of = |role: Role| drawing.lines.iter().filter(move |line| line.role == role);
    let layer = |role: Role| {
        let mut path = String::new();
        of(role).for_each(|line| add(&mut path, line, height));
        (!path.is_empty()).then(|| PictureLayer { name: role.layer(), colour: colour(role), path })
    };
    let outline = |line: &DrawnLine| {
        let mut path = String::new();
        add(&mut path, line, height);
        path
    };
    let mut sides = String::new();
    failed.iter().for_each(|points| add_points(&mut sides, points, height));
    SheetPicture {
        name: drawing.name.clone(),
        size: drawing.size.map(steps),
        layers: Role::ALL.into_iter().filter(|role| *role != Role::Cut).filter_map(layer).collect(),
        colour: colour(Role::Cut),
        outlines: of(Role::Cut).map(outline).collect(),
        parts: of(Role::Cut).map(|line| line.part.clone()).collect(),
        panels: of(Role::Cut).map(|line| line.panels.clone()).collect(),
        failed: sides,
    }
}

fn colour(role: Role) -> String {
    let [r, g, b] = role.rgb();
    format!("#{r:02X}{g:02X}{b:02X}")
}

fn steps(length: f64) -> i32 {
    (STEPS * length).round() as i32
}

fn add(path: &mut String, line: &DrawnLine, height: f64) {
    add_points(path, &line.points, height);
    if line.closed {
        path.push('Z');
    }
}

/// Each point but the first by its way from the last one, as it was rounded: nothing adds up. One point alone is a line
/// without length.
fn add_points(path: &mut String, points: &[Point2], height: f64) {
    let mut last = [0, 0];
    for (k, &[x, y]) in points.iter().enumerate() {
        let at = [steps(x), steps(height - y)];
        let [right, down] = [0, 1].map(|x| at[x] - last[x]);
        let letter = if k == 0 { 'M' } else { 'l' };
        *path += &format!("{letter}{right},{down}");
        last = at;
    }
    if points.len() == 1 {
        path.push_str("h0");
    }
}
