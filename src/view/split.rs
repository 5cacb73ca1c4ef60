//! Two pictures of the same mesh on one canvas, seen by the same camera: one left and one right of a
//! divider. Each shows the shape as it is or the original, with colours of its own (paper Fig. 5).

use super::flat_map::Region;
use super::lists::ViewError;
use super::stage::Stage;
use glam::Vec2;

/// The divider and what is on its two sides.
#[derive(Debug)]
pub struct Split {
    /// Where the divider is, as a part of the width of the canvas: 0 is the left end, 1 the right.
    pub at: f32,
    /// Left and right.
    pub sides: [Side; 2],
}

/// What is drawn on one side.
#[derive(Debug)]
pub struct Side {
    /// The mesh with the colours of this side.
    pub stage: Stage,
    /// Whether it stays as it is when the mesh moves: handles and projections are not of its shape.
    pub is_original: bool,
}

/// The colours of the faces of a side: a value each (#F), from `low` to `high`; none for the plain
/// material.
#[derive(Clone, Debug, Default)]
pub struct Colours {
    /// A value per face.
    pub values: Option<Vec<f32>>,
    /// What the first colour stands for.
    pub low: f32,
    /// What the last colour stands for.
    pub high: f32,
}

impl Split {
    /// Both sides show what `model` shows, without colours of values.
    pub fn new(model: &Stage, at: f32) -> Split {
        let side = || {
            let mut stage = Stage::default();
            stage.subject = model.subject.clone();
            Side { stage, is_original: false }
        };
        let mut split = Split { at: 0.0, sides: [side(), side()] };
        split.move_to(at);
        split
    }

    /// Moves the divider.
    pub fn move_to(&mut self, at: f32) {
        self.at = if at.is_finite() { at.clamp(0.0, 1.0) } else { 0.5 };
        self.sides[0].stage.changes.view = true;
    }

    /// The parts of the canvas left and right of the divider, which is at a whole pixel.
    pub fn parts(&self, canvas: Vec2) -> [Region; 2] {
        let left = Vec2::new((self.at * canvas.x).round(), canvas.y);
        let at = Vec2::new(left.x, 0.0);
        [Region { at: Vec2::ZERO, size: left }, Region { at, size: canvas - at }]
    }

    /// Brings both sides up to date with what they have in common with `model`.
    pub fn follow(&mut self, model: &Stage) {
        for side in &mut self.sides {
            side.follow(model);
        }
    }

    /// Whether there is anything new to see.
    pub fn has_changes(&self) -> bool {
        self.sides.iter().any(|side| side.stage.changes.any())
    }
}

impl Side {
    /// Shows the shape `coordinates` (#V by 3, in file coordinates), whatever becomes of `model`; or
    /// what `model` shows.
    ///
    /// # Errors
    /// Another number of vertices or a coordinate that is not finite; all stays as it was.
    pub fn show(&mut self, coordinates: Option<&[f64]>, model: &Stage) -> Result<(), ViewError> {
        match coordinates {
            Some(coordinates) => self.stage.set_positions(coordinates)?,
            None => self.take_positions(model),
        }
        self.is_original = coordinates.is_some();
        Ok(())
    }

    /// Colours the faces.
    ///
    /// # Errors
    /// Another number of values than faces.
    pub fn colour(&mut self, colours: Colours) -> Result<(), ViewError> {
        let (_, faces) = self.stage.counts();
        let Colours { values, low, high } = colours;
        self.stage.looks.set_values(values, low, high, faces)?;
        self.stage.changes.looks = true;
        Ok(())
    }

    fn take_positions(&mut self, model: &Stage) {
        let (own, other) = (&mut self.stage.subject, &model.subject);
        own.exact.clone_from(&other.exact);
        own.positions.clone_from(&other.positions);
        own.normals.clone_from(&other.normals);
        self.stage.changes.positions = true;
        self.take_targets(model);
    }

    fn take_targets(&mut self, model: &Stage) {
        self.stage.handles.clone_from(&model.handles);
        self.stage.changes.targets = true;
    }

    fn follow(&mut self, model: &Stage) {
        let changes = model.changes;
        if !self.is_original {
            if changes.positions {
                self.take_positions(model);
            } else if changes.targets {
                self.take_targets(model);
            }
            if changes.projections || self.stage.projections != model.projections {
                self.stage.projections.clone_from(&model.projections);
                self.stage.changes.projections = true;
            }
        }
        if changes.looks {
            self.stage.looks.mark_as(&model.looks);
            self.stage.tint = model.tint;
            self.stage.changes.looks = true;
        }
        let stage = &mut self.stage;
        stage.camera.clone_from(&model.camera);
        (stage.display, stage.dark, stage.white) = (model.display, model.dark, model.white);
        stage.keep_reach();
        stage.changes.view |= changes.view;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quad in a stage.
    fn model() -> Stage {
        let mut stage = Stage::default();
        let faces = (vec![0, 4], vec![0, 1, 2, 3]);
        let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.25];
        stage.set_mesh(faces, (vec![0], vec![]), &corners).unwrap();
        stage
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
            model.subject.exact.iter().flat_map(|point| point.to_array()).collect();
        let before = model.subject.positions.clone();
        split.sides[0].show(Some(&original), &model).unwrap();
        model.set_positions(&lifted()).unwrap();
        model.orbit(30.0, 10.0);
        split.follow(&model);
        let [left, right] = &split.sides;
        assert_eq!(left.stage.subject.positions, before);
        assert_eq!(right.stage.subject.positions, model.subject.positions);
        for side in [left, right] {
            assert_eq!(side.stage.camera.eye().at, model.camera.eye().at);
        }
        // Back to the shape as it is.
        split.sides[0].show(None, &model).unwrap();
        assert_eq!(split.sides[0].stage.subject.positions, model.subject.positions);
    }

    #[test]
    fn each_side_has_colours_of_its_own() {
        let model = model();
        let mut split = Split::new(&model, 0.5);
        split.sides.iter_mut().for_each(|side| side.stage.changes = Default::default());
        assert!(!split.has_changes());
        let colours = |value| Colours { values: Some(vec![value]), low: 0.0, high: 1.0 };
        split.sides[0].colour(colours(0.0)).unwrap();
        split.sides[1].colour(colours(1.0)).unwrap();
        assert!(split.has_changes());
        let [left, right] = split.sides.each_ref().map(|side| side.stage.looks.bytes(1));
        assert_ne!(left, right);
        assert!(split.sides[0].colour(Colours { values: Some(vec![]), ..colours(0.0) }).is_err());
        assert!(split.sides[1].show(Some(&[0.0]), &model).is_err());
        assert!(!split.sides[1].is_original);
    }
}
