//! The contents of one canvas: the model, and its flat map beside it.

use super::flat_map::{Region, flat_map, follow, show_flipped};
use crate::view::appearance::ColourScale;
use crate::view::model::ViewError;
use crate::view::state::ViewState;
use glam::Vec2;

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
}
