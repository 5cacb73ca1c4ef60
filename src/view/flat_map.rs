//! The flat map of a surface: the same faces in the plane, in a view of their own from above, and
//! the division of the canvas between the two.

use super::model::undirected_sides;
use crate::math::Ragged;
use crate::view::model::{Checks, RenderMesh, ViewError, check_indices};
use crate::view::state::ViewState;
use glam::{Vec2, Vec3};

/// A part of the canvas, CSS pixels from its upper left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Region {
    /// Its upper left corner.
    pub at: Vec2,
    /// Width and height.
    pub size: Vec2,
}

/// On a canvas narrower than this (CSS pixels) the map lies below the surface.
const NARROW: f32 = 560.0;

impl Region {
    /// Returns the whole of a canvas.
    pub fn whole(canvas: Vec2) -> Region {
        Region { at: Vec2::ZERO, size: canvas }
    }

    /// Returns the parts of the surface and of the map: side by side, or one above the other on a
    /// narrow or high canvas. The surface is at the upper left corner. Both begin at whole pixels.
    pub fn halves(canvas: Vec2) -> [Region; 2] {
        let stacked = canvas.x < NARROW || canvas.x < canvas.y;
        let first = if stacked {
            Vec2::new(canvas.x, (0.5 * canvas.y).round())
        } else {
            Vec2::new((0.5 * canvas.x).round(), canvas.y)
        };
        let at = if stacked { Vec2::new(0.0, first.y) } else { Vec2::new(first.x, 0.0) };
        [Region { at: Vec2::ZERO, size: first }, Region { at, size: canvas - at }]
    }
}

/// Creates the view of a flat map of the mesh of `model`, and the checkerboard of both. `uv` (#V by
/// 2 in a flat array) is in units of the mesh. The `flipped` faces are outlined.
///
/// # Errors
/// A wrong number of points, one that is not finite, or a face that does not exist.
pub fn flat_map(
    model: &ViewState,
    uv: &[f64],
    flipped: &[u32],
) -> Result<(ViewState, Checks), ViewError> {
    let (count, faces) = model.counts();
    check_indices("flipped faces", flipped, faces)?;
    let checks = Checks::new(uv, count)?;
    let flat = checks.uv.iter().flat_map(|uv| [uv.x, uv.y, 0.0].map(f64::from));
    let coordinates: Vec<f64> = flat.collect();
    let mesh = RenderMesh::new(model.mesh().faces.clone(), Ragged::new(), &coordinates)?;
    let flipped = sides(&mesh.faces, flipped);
    Ok((ViewState::of_flat_map(mesh, checks.clone(), flipped), checks))
}

/// Returns the sides of some faces, each once.
fn sides(faces: &Ragged, chosen: &[u32]) -> Vec<[u32; 2]> {
    let corners = chosen.iter().map(|&face| faces.row(face as usize));
    let mut sides: Vec<[u32; 2]> = corners.flat_map(undirected_sides).collect();
    sides.sort_unstable();
    sides.dedup();
    sides
}

/// Zooms to the flipped faces, in proportion to their size; on the model from their front.
pub fn show_flipped(map: &mut ViewState, model: &mut ViewState) {
    let mut vertices = map.flipped().as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    if vertices.is_empty() {
        return;
    }
    let normals = vertices.iter().map(|&v| model.mesh().normals.vertices[v as usize]);
    let front: Vec3 = normals.sum();
    if front.length() > 0.0 {
        model.move_camera(|camera| camera.look_against(front));
    }
    for state in [model, map] {
        let places = vertices.iter().map(|&v| state.mesh().positions[v as usize]);
        let low = places.clone().fold(Vec3::INFINITY, Vec3::min);
        let high = places.fold(Vec3::NEG_INFINITY, Vec3::max);
        let around = 0.25 * (high - low).length();
        state.zoom_to(&vertices, around.max(LEAST_PART * state.size()));
    }
}

/// Minimum margin around the faces, as a fraction of the size of the whole.
const LEAST_PART: f32 = 1e-4;

/// Updates the map with what it shares with the surface.
pub fn follow(map: &mut ViewState, model: &ViewState) {
    map.set_dark(model.is_dark());
    map.set_display(model.display());
    map.follow_marks(model);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_fill_the_canvas_side_by_side_or_stacked() {
        let [model, map] = Region::halves(Vec2::new(1001.0, 700.0));
        assert_eq!((model.at, model.size), (Vec2::ZERO, Vec2::new(501.0, 700.0)));
        assert_eq!((map.at, map.size), (Vec2::new(501.0, 0.0), Vec2::new(500.0, 700.0)));
        for canvas in [Vec2::new(390.0, 700.0), Vec2::new(390.0, 340.0)] {
            let [model, map] = Region::halves(canvas);
            assert_eq!(model.size, map.size);
            assert_eq!(map.at, Vec2::new(0.0, 0.5 * canvas.y));
        }
    }
}
