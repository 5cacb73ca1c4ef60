//! A sheet as the page shows it: one path per layer regardless of the number of parts, rounded to
//! hundredths of a millimetre to be short and quick to parse. Saved files are exact: see `svg`.

use super::drawing::{Drawing, DrawnLine};
use crate::fabricate::sheet::Role;
use crate::math::plane::Point2;
use serde::Serialize;

/// Steps per millimetre.
const STEPS: f64 = 100.0;

/// A sheet as the page shows it; lengths are in hundredths of a millimetre, y points down.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SheetPicture {
    /// Its name.
    pub name: String,
    /// Width and height.
    pub size: [i32; 2],
    /// Layers below the outlines, from the lowest up.
    pub layers: Vec<PictureLayer>,
    /// Colour of the outlines.
    pub colour: String,
    /// The outline of each part, as a separate path.
    pub outlines: Vec<String>,
    /// The name of each part.
    pub parts: Vec<String>,
    /// The panels of each part.
    pub panels: Vec<Vec<u32>>,
    /// A path along the sides of panels whose beams exceed a limit, and to the corners whose nodes
    /// do.
    pub failed: String,
}

/// The lines of one role.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PictureLayer {
    /// The name of the layer in files.
    pub name: &'static str,
    /// Colour in CSS.
    pub colour: String,
    /// All lines as one path.
    pub path: String,
}

/// Draws a sheet, with lines that mark elements exceeding a limit.
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

/// Points are relative to the rounded previous one, so that rounding errors do not add up. A single
/// point becomes a line of zero length.
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
