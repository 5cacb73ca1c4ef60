//! Sheets over a piece of the ground: quads, triangles and hexagons, counterclockwise from above.

use super::declaration::{NewMeshError, exactly};
use crate::generate::hexagons::{self, triangle_rows};
use crate::generate::quads::{check_face_count, grid};
use crate::math::{angle, cosine, sine};
use crate::mesh::{Mesh, Point};
use std::f64::consts::TAU;

pub(super) fn flat(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [length, width, along, across] = exactly(sizes);
    quads(along, across, &|x, y| [0.5 * length * x, 0.5 * width * y, 0.0])
}

/// A piece of a cylinder, in equal steps along its arcs.
pub(super) fn barrel(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [length, span, rise, along, across] = exactly(sizes);
    let half = 0.5 * span;
    let radius = (half * half + rise * rise) / (2.0 * rise);
    let turns = angle(radius - rise, half).unwrap_or(0.0) / TAU;
    quads(along, across, &|x, y| {
        let (across, up) = (radius * sine(turns * y), radius * cosine(turns * y));
        [0.5 * length * x, across, up - (radius - rise)]
    })
}

/// The upper half of a torus around the `z` axis.
pub(super) fn torus(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [radius, section, turn, along, across] = exactly(sizes);
    if section >= radius {
        let expected = "a section whose radius is smaller than that of the arc";
        return Err(NewMeshError::Together { expected });
    }
    quads(along, across, &|x, y| {
        let (turns, around) = (0.5 * turn / 360.0 * x, 0.25 * (1.0 + y));
        let out = radius + section * cosine(around);
        [out * cosine(turns), out * sine(turns), section * sine(around)]
    })
}

pub(super) fn hypar(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [span, height, panels] = exactly(sizes);
    quads(panels, panels, &|x, y| [0.5 * span * x, 0.5 * span * y, 0.5 * height * (1.0 + x * y)])
}

/// Hexagons, regular if the length is a whole number of rows, with half hexagons along the
/// boundary.
pub(super) fn hexagons(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let (rows, across, point) = cap(sizes, 1.0)?;
    Ok(hexagons::hexagons(rows, |_| across, point))
}

/// Triangles, equilateral if the length is a whole number of rows, with half triangles at the
/// sides.
pub(super) fn triangles(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let (rows, across, point) = cap(sizes, 2.0)?;
    let mut mesh = triangle_rows(rows, &|_| across);
    mesh.positions.iter_mut().for_each(|p| *p = point(p[0], p[1]));
    Ok(mesh)
}

/// The number of rows of triangle corners along the length, their number per row, and a paraboloid
/// over the rectangle, level at its corners. There are `faces` for each corner.
fn cap(
    sizes: &[f64],
    faces: f64,
) -> Result<(usize, usize, impl Fn(f64, f64) -> Point), NewMeshError> {
    let [length, width, rise, size] = exactly(sizes);
    if size > length || size > width {
        let expected = "panels that are smaller than length and width";
        return Err(NewMeshError::Together { expected });
    }
    let (rows, across) = ((length / (0.75_f64.sqrt() * size)).round(), (width / size).round());
    check_face_count(faces * rows * across).map_err(NewMeshError::TooManyFaces)?;
    let point = move |x: f64, y: f64| {
        [0.5 * length * x, 0.5 * width * y, rise * (1.0 - 0.5 * (x * x + y * y))]
    };
    Ok((rows as usize, across as usize + 1, point))
}

/// A grid of quads mapped from the square from -1 to 1; `dyn`, to compile this once for all kinds.
fn quads(along: f64, across: f64, point: &dyn Fn(f64, f64) -> Point) -> Result<Mesh, NewMeshError> {
    check_face_count(along * across).map_err(NewMeshError::TooManyFaces)?;
    Ok(grid([along as usize, across as usize], point))
}
