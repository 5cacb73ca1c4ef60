//! Meshes of revolution about the `z` axis: rows of quads, and triangles around an apex.

use super::declaration::{NewMeshError, exactly};
use crate::generate::quads::{Rings, check_face_count};
use crate::math::{angle, cosine, sine};
use crate::mesh::Mesh;
use std::f64::consts::TAU;

/// A cap of a sphere, in equal steps along its meridians.
pub(super) fn dome(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [diameter, rise, opening, around, rows] = exactly(sizes);
    let (eaves, hole) = (0.5 * diameter, 0.5 * opening);
    let radius = (eaves * eaves + rise * rise) / (2.0 * rise);
    if hole >= eaves {
        let expected = "an opening that is smaller than the diameter";
        return Err(NewMeshError::Together { expected });
    }
    // Angles from the axis, in turns.
    let low = angle(radius - rise, eaves).unwrap_or(0.0) / TAU;
    let high = angle((radius * radius - hole * hole).max(0.0).sqrt(), hole).unwrap_or(0.0) / TAU;
    revolved(around, rows, &|up| {
        let turns = low + up * (high - low);
        let at = if up == 1.0 { hole } else { radius * sine(turns) };
        [at, radius * cosine(turns) - (radius - rise)]
    })
}

pub(super) fn cone(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [diameter, top, height, around, rows] = exactly(sizes);
    revolved(around, rows, &|up| [0.5 * (diameter + up * (top - diameter)), up * height])
}

/// A quarter of an ellipse revolved about the axis: vertical at the neck, horizontal at the rim.
pub(super) fn funnel(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [rim, neck, height, around, rows] = exactly(sizes);
    if neck >= rim {
        let expected = "a neck that is narrower than the rim";
        return Err(NewMeshError::Together { expected });
    }
    revolved(around, rows, &|up| {
        let turns = 0.25 * up;
        [0.5 * (neck + (rim - neck) * (1.0 - cosine(turns))), height * sine(turns)]
    })
}

pub(super) fn tube(sizes: &[f64]) -> Result<Mesh, NewMeshError> {
    let [diameter, height, around, rows] = exactly(sizes);
    revolved(around, rows, &|up| [0.5 * diameter, up * height])
}

/// Revolves a `profile`: radius and height of a row, from 0 at the bottom to 1 at the top, where
/// the radius may be zero. `dyn`, to compile this once for all kinds.
fn revolved(
    around: f64,
    rows: f64,
    profile: &dyn Fn(f64) -> [f64; 2],
) -> Result<Mesh, NewMeshError> {
    check_face_count(around * rows).map_err(NewMeshError::TooManyFaces)?;
    let (meridians, rows) = (around as u32, rows as u32);
    let top = profile(1.0);
    let pointed = top[0] == 0.0;
    let rings = Rings { meridians, rows: if pointed { rows - 1 } else { rows } };
    let mut positions = rings.positions(|ring, _, turns| {
        let [radius, height] = profile(f64::from(ring) / f64::from(rows));
        [radius * cosine(turns), radius * sine(turns), height]
    });
    let mut faces = rings.faces();
    if pointed {
        let apex = positions.len() as u32;
        positions.push([0.0, 0.0, top[1]]);
        let last = rings.ring(rings.rows);
        for i in 0..meridians {
            faces.push(&[last.start + i, last.start + (i + 1) % meridians, apex]);
        }
    }
    Ok(Mesh { positions, faces, ..Mesh::default() })
}
