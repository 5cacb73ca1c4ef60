//! The contents of one canvas: the model, and beside it its flat map, the same faces in the plane in a
//! view of their own from above.

use super::model::undirected_sides;
use crate::math::Ragged;
use crate::view::appearance::ColourScale;
use crate::view::model::{Checks, RenderMesh, ViewError, check_indices};
use crate::view::state::ViewState;
use glam::{Vec2, Vec3};

/// The view of the model, and that of its flat map.
#[derive(Debug)]
pub struct Pictures {
    model: ViewState,
    map: Option<ViewState>,
    /// Size of the canvas in CSS pixels.
    canvas: Vec2,
}

impl Default for Pictures {
    fn default() -> Self {
        let model = ViewState::default();
        Pictures { canvas: model.camera().canvas, model, map: None }
    }
}

impl Pictures {
    /// Returns the view of the model.
    pub fn model(&self) -> &ViewState {
        &self.model
    }

    /// Returns the view of the model, to be changed.
    pub fn model_mut(&mut self) -> &mut ViewState {
        &mut self.model
    }

    /// Returns the view of the flat map, to be moved.
    pub fn map_mut(&mut self) -> Option<&mut ViewState> {
        self.map.as_mut()
    }

    /// Returns whether anything has changed since the last picture.
    pub fn has_changes(&self) -> bool {
        self.model.changes().any() || self.map.as_ref().is_some_and(|map| map.changes().any())
    }

    /// Returns model and map for the renderer, after updating the map from the model.
    pub fn to_draw(&mut self) -> (&mut ViewState, Option<&mut ViewState>) {
        if let Some(map) = &mut self.map {
            follow(map, &self.model);
        }
        (&mut self.model, self.map.as_mut())
    }

    /// Sets the size of the canvas in CSS pixels, and divides it between the model and its map.
    pub fn resize(&mut self, canvas: Vec2) {
        self.canvas = canvas;
        self.arrange();
    }

    /// Shows a mesh: see [`ViewState::set_mesh`]. If its topology is new, removes the map.
    ///
    /// # Errors
    /// Arrays that do not fit together; the old mesh stays.
    pub fn set_mesh(
        &mut self,
        faces: (Vec<u32>, Vec<u32>),
        curves: (Vec<u32>, Vec<u32>),
        coordinates: &[f64],
    ) -> Result<(), ViewError> {
        self.model.set_mesh(faces, curves, coordinates)?;
        if self.model.checks().uv.is_empty() {
            self.clear_map();
        }
        Ok(())
    }

    /// Shows the flat map `uv` (#V by 2) beside the mesh, replacing an earlier one, and outlines
    /// the faces that it flips.
    ///
    /// # Errors
    /// A wrong number of points, one that is not finite, or an unknown face; nothing changes then.
    pub fn set_map(&mut self, uv: &[f64], flipped: &[u32]) -> Result<(), ViewError> {
        let (map, checks) = flat_map(&self.model, uv, flipped)?;
        self.model.set_checks(checks);
        let is_first = self.map.replace(map).is_none();
        self.arrange();
        if is_first {
            self.model.fit();
        }
        Ok(())
    }

    /// Removes the flat map.
    pub fn clear_map(&mut self) {
        if self.map.take().is_some() {
            self.model.set_checks(Default::default());
            self.arrange();
            self.model.fit();
        }
    }

    /// Draws a checkerboard with `squares` squares along the longer side of the map, on the model,
    /// on the map, or on both, and colours each face of the map by its value (#F) on a scale.
    ///
    /// # Errors
    /// A wrong number of values.
    pub fn set_map_looks(
        &mut self,
        squares: f32,
        [on_model, on_map]: [bool; 2],
        values: Option<Vec<f32>>,
        scale: ColourScale,
    ) -> Result<(), ViewError> {
        let Some(map) = &mut self.map else { return Ok(()) };
        let longest = map.checks().extent().max_element();
        let per_length = if longest > 0.0 { squares / longest } else { 0.0 };
        let drawn = |is_drawn: bool| if is_drawn { per_length } else { 0.0 };
        self.model.scale_checks(drawn(on_model));
        map.scale_checks(drawn(on_map));
        map.appearance_mut().set_values(values, scale)
    }

    /// Returns the region of the map on the canvas; none without a map.
    pub fn map_region(&self) -> Option<Region> {
        self.map.as_ref()?;
        let [_, region] = Region::halves(self.canvas);
        Some(region)
    }

    /// Zooms to the faces that the map flips, on the model and on the map.
    pub fn show_flipped(&mut self) {
        if let Some(map) = &mut self.map {
            show_flipped(map, &mut self.model);
        }
    }

    fn arrange(&mut self) {
        let whole = Region::whole(self.canvas);
        let [model, map] = match &self.map {
            Some(_) => Region::halves(self.canvas),
            None => [whole; 2],
        };
        self.model.resize(model.size);
        if let Some(state) = &mut self.map {
            state.resize(map.size);
        }
    }
}

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

    const QUAD: [f64; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.25];
    const UV: [f64; 8] = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0];

    /// A quad on a wide canvas.
    fn quad() -> Pictures {
        let mut pictures = Pictures::default();
        pictures.resize(Vec2::new(1000.0, 600.0));
        let faces = (vec![0, 4], vec![0, 1, 2, 3]);
        pictures.set_mesh(faces, (vec![0], vec![]), &QUAD).unwrap();
        pictures
    }

    fn drawn(pictures: &mut Pictures) {
        let (model, map) = pictures.to_draw();
        model.take_changes();
        map.map(ViewState::take_changes);
    }

    #[test]
    fn a_map_takes_half_of_the_canvas_and_gives_it_back() {
        let mut pictures = quad();
        pictures.set_map(&UV, &[]).unwrap();
        assert_eq!(pictures.model().camera().canvas, Vec2::new(500.0, 600.0));
        assert_eq!(pictures.map_region().map(|region| region.at.x), Some(500.0));
        pictures.clear_map();
        assert_eq!(pictures.model().camera().canvas, Vec2::new(1000.0, 600.0));
        assert_eq!(pictures.map_region(), None);
        assert!(pictures.set_map(&UV[2..], &[]).is_err());
    }

    #[test]
    fn every_change_asks_for_a_picture_and_nothing_else_does() {
        let mut pictures = quad();
        drawn(&mut pictures);
        assert!(!pictures.has_changes());
        type Change = fn(&mut Pictures);
        let changes: [Change; 9] = [
            |p| p.set_map(&UV, &[0]).unwrap(),
            |p| p.set_map_looks(8.0, [true, true], None, ColourScale::linear(1.0, 2.0)).unwrap(),
            |p| p.show_flipped(),
            |p| p.clear_map(),
            |p| p.model_mut().appearance_mut().set_in_bands(true),
            |p| p.model_mut().set_dark(true),
            |p| p.model_mut().marks_mut().select(vec![1], vec![0]).unwrap(),
            |p| p.model_mut().marks_mut().tint(vec![], vec![0], [1.0, 0.0, 0.0]).unwrap(),
            |p| p.model_mut().set_parallel(true),
        ];
        for (place, change) in changes.into_iter().enumerate() {
            change(&mut pictures);
            assert!(pictures.has_changes(), "change {place}");
            drawn(&mut pictures);
            assert!(!pictures.has_changes(), "change {place}");
        }
        pictures.model_mut().set_dark(true);
        pictures.clear_map();
        assert!(!pictures.has_changes(), "all of it was so before");
    }

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
