//! Two pictures of the same mesh on one canvas, left and right of a divider, with the same camera.
//! Each shows the current shape or the original, with colours of its own (paper Fig. 5).

use super::flat_map::Region;
use crate::view::appearance::ColourScale;
use crate::view::model::ViewError;
use crate::view::state::ViewState;
use glam::Vec2;

/// The divider and its two sides.
#[derive(Debug)]
pub struct Split {
    /// Position of the divider as a fraction of the canvas width, from 0 (left) to 1.
    pub at: f32,
    /// The left and the right side.
    pub sides: [Side; 2],
}

/// One side of a split view.
#[derive(Debug)]
pub struct Side {
    /// The mesh with the colours of this side.
    pub state: ViewState,
    /// Whether it shows the original, which has no handles or projections and stays as it is.
    pub is_original: bool,
}

/// Colours of the faces of a side, by value (#F) on a scale; without values, the plain material.
#[derive(Clone, Debug)]
pub struct Colours {
    /// The value of each face.
    pub values: Option<Vec<f32>>,
    /// #V, of which each face has the largest as its value; none without vertex values.
    pub corners: Option<Vec<f32>>,
    /// The range of the colours, and the tolerance below which there are none.
    pub scale: ColourScale,
}

impl Split {
    /// Creates a split in which both sides show what `model` shows, without colours of values.
    pub fn new(model: &ViewState, at: f32) -> Split {
        let side = || Side { state: model.beside(), is_original: false };
        let mut split = Split { at: 0.0, sides: [side(), side()] };
        split.move_to(at);
        split
    }

    /// Shows the values of both sides in bands, or continuously.
    pub fn set_in_bands(&mut self, in_bands: bool) {
        for side in &mut self.sides {
            side.state.set_in_bands(in_bands);
        }
    }

    /// Moves the divider.
    pub fn move_to(&mut self, at: f32) {
        self.at = if at.is_finite() { at.clamp(0.0, 1.0) } else { 0.5 };
        self.sides[0].state.view_changed();
    }

    /// Returns the parts of the canvas left and right of the divider, which is at a whole pixel.
    pub fn parts(&self, canvas: Vec2) -> [Region; 2] {
        let left = Vec2::new((self.at * canvas.x).round(), canvas.y);
        let at = Vec2::new(left.x, 0.0);
        [Region { at: Vec2::ZERO, size: left }, Region { at, size: canvas - at }]
    }

    /// Updates both sides with what they share with `model`.
    pub fn follow(&mut self, model: &ViewState) {
        for side in &mut self.sides {
            side.follow(model);
        }
    }

    /// Returns whether anything has changed since the last picture.
    pub fn has_changes(&self) -> bool {
        self.sides.iter().any(|side| side.state.changes().any())
    }
}

impl Side {
    /// Shows the shape `coordinates` (#V by 3, in file coordinates), or follows that of `model`.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite; nothing changes then.
    pub fn show(
        &mut self,
        coordinates: Option<&[f64]>,
        model: &ViewState,
    ) -> Result<(), ViewError> {
        match coordinates {
            Some(coordinates) => self.state.set_positions(coordinates)?,
            None => self.state.take_positions(model),
        }
        self.is_original = coordinates.is_some();
        Ok(())
    }

    /// Colours the faces.
    ///
    /// # Errors
    /// A wrong number of values of faces or vertices.
    pub fn colour(&mut self, colours: Colours) -> Result<(), ViewError> {
        let Colours { values, corners, scale } = colours;
        self.state.set_face_values(values, scale)?;
        self.state.set_corner_values(corners)
    }

    fn follow(&mut self, model: &ViewState) {
        if !self.is_original {
            self.state.follow_shape(model);
        }
        self.state.follow_marks(model);
        self.state.follow_view(model);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A view of one quad.
    fn model() -> ViewState {
        let mut state = ViewState::default();
        let faces = (vec![0, 4], vec![0, 1, 2, 3]);
        let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.25];
        state.set_mesh(faces, (vec![0], vec![]), &corners).unwrap();
        state
    }

    fn lifted() -> Vec<f64> {
        vec![0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0]
    }

    #[test]
    fn the_parts_fill_the_canvas_wherever_the_divider_is() {
        let canvas = Vec2::new(1001.0, 700.0);
        for (at, width) in [(0.0, 0.0), (0.25, 250.0), (1.0, 1001.0), (7.0, 1001.0)] {
            let [left, right] = Split::new(&model(), at).parts(canvas);
            assert_eq!((left.at, left.size), (Vec2::ZERO, Vec2::new(width, 700.0)));
            assert_eq!(right.at.x + right.size.x, canvas.x);
            assert_eq!(left.size.x, right.at.x);
        }
        let mut split = Split::new(&model(), 0.2);
        split.move_to(f32::NAN);
        assert_eq!(split.at, 0.5);
    }

    #[test]
    fn one_side_stays_as_it_was_and_the_other_follows() {
        let mut model = model();
        let mut split = Split::new(&model, 0.5);
        let original: Vec<f64> =
            model.mesh().exact.iter().flat_map(|point| point.to_array()).collect();
        let before = model.mesh().positions.clone();
        split.sides[0].show(Some(&original), &model).unwrap();
        model.set_positions(&lifted()).unwrap();
        model.orbit(30.0, 10.0);
        split.follow(&model);
        let [left, right] = &split.sides;
        assert_eq!(left.state.mesh().positions, before);
        assert_eq!(right.state.mesh().positions, model.mesh().positions);
        for side in [left, right] {
            assert_eq!(side.state.camera().eye().at, model.camera().eye().at);
        }
        // Back to the current shape.
        split.sides[0].show(None, &model).unwrap();
        assert_eq!(split.sides[0].state.mesh().positions, model.mesh().positions);
    }

    #[test]
    fn both_sides_are_in_bands_and_each_has_its_own() {
        let mut model = model();
        model.set_in_bands(true);
        let mut split = Split::new(&model, 0.5);
        for (side, high) in split.sides.iter_mut().zip([1.0, 30.0]) {
            let corners = Some(vec![0.0, 0.0, 0.0, high]);
            let scale = ColourScale::linear(0.0, high);
            let colours = Colours { values: Some(vec![high]), corners, scale };
            side.colour(colours).unwrap();
        }
        let steps = |split: &Split| {
            split
                .sides
                .each_ref()
                .map(|side| side.state.appearance().bands().map(|bands| bands.step))
        };
        assert_eq!(steps(&split), [Some(0.2), Some(5.0)]);
        // Isolines go through the faces, from the values of the vertices.
        for side in &split.sides {
            assert!(side.state.appearance().corner_steps().is_some());
            assert!(
                side.state.appearance().corner_in_steps(3)
                    > side.state.appearance().corner_in_steps(0)
            );
        }
        split.set_in_bands(false);
        assert_eq!(steps(&split), [None, None]);
        let scale = ColourScale::linear(0.0, 1.0);
        let wrong = Colours { values: None, corners: Some(vec![0.0]), scale };
        assert!(split.sides[0].colour(wrong).is_err());
    }

    #[test]
    fn ghost_and_ground_are_about_both_sides_and_nothing_of_them_is_cut_off() {
        let mut model = model();
        let low: Vec<f64> = lifted().chunks(3).flat_map(|at| [at[0], at[1], -40.0]).collect();
        model.set_surroundings(false, true);
        let mut split = Split::new(&model, 0.5);
        model.set_rest(&low).unwrap();
        model.set_surroundings(true, true);
        split.follow(&model);
        let eye = model.camera().eye();
        for side in &split.sides {
            assert!(side.state.around().changed);
            assert!(side.state.surrounding_points().eq(model.surrounding_points()));
            assert_eq!(side.state.surrounding_lines(), model.surrounding_lines());
            let (near, far) = side.state.depth_range();
            for point in side.state.surrounding_points() {
                let (_, depth) = eye.project(point);
                assert!(depth < far && (depth > near || depth < 0.0), "{near} {depth} {far}");
            }
        }
        // A split that begins later has them at once.
        let later = Split::new(&model, 0.5);
        assert_eq!(later.sides[1].state.around().grid_step(), model.around().grid_step());
        assert!(later.sides[1].state.around().changed);
    }

    #[test]
    fn each_side_has_colours_of_its_own() {
        let model = model();
        let mut split = Split::new(&model, 0.5);
        split.sides.iter_mut().for_each(|side| {
            side.state.take_changes();
        });
        assert!(!split.has_changes());
        let colours = |value| Colours {
            values: Some(vec![value]),
            corners: None,
            scale: ColourScale::linear(0.0, 1.0),
        };
        split.sides[0].colour(colours(0.0)).unwrap();
        split.sides[1].colour(colours(1.0)).unwrap();
        assert!(split.has_changes());
        let [left, right] = split.sides.each_ref().map(|side| side.state.appearance().bytes(1));
        assert_ne!(left, right);
        // A face within the tolerance keeps the material, as in one picture.
        let scale = ColourScale { tolerance: Some(0.5), ..ColourScale::linear(0.5, 1.0) };
        split.sides[0].colour(Colours { scale, ..colours(0.25) }).unwrap();
        assert!(!split.sides[0].state.appearance().has_full_map());
        assert!(split.sides[0].colour(Colours { values: Some(vec![]), ..colours(0.0) }).is_err());
        assert!(split.sides[1].show(Some(&[0.0]), &model).is_err());
        assert!(!split.sides[1].is_original);
    }
}
