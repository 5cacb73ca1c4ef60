//! Variations: ways to change the shape while its hard constraints stay met. They are shown,
//! projected back onto the constraints, and kept or discarded.

use super::Session;
use super::edit::Edit;
use super::requirements::Required;
use super::run::{ExactReport, Met};
use super::undo::{Change, Transaction};
use crate::mesh::Point;
use crate::session::Error;
use crate::solve::{ExactAnswer, Handle, Problem, Requirements, ShapeSpace, Variation};
use std::rc::Rc;

/// The variations of a shape of a session.
pub struct Variations {
    space: ShapeSpace,
    /// The shape that they change, `#V by 3`.
    from: Rc<[Point]>,
    /// The last answer, if its shape is shown.
    reached: Option<ExactAnswer>,
}

impl Variations {
    /// Continues the search for variations and their ranges; returns whether there is more to do.
    ///
    /// # Errors
    /// As [`ShapeSpace::step`].
    pub fn step(&mut self) -> Result<bool, Error> {
        Ok(self.space.step()?)
    }

    /// Whether the variations are found; their ranges may not be.
    pub fn are_found(&self) -> bool {
        self.space.has_modes()
    }

    /// The variations found, the softest first.
    pub fn modes(&self) -> &[Variation] {
        self.space.modes()
    }
}

impl Session {
    /// Starts the search for variations of the current shape; none if no constraint is hard, or
    /// some are not met.
    ///
    /// # Errors
    /// If a set of the scene does not exist, or the system is singular.
    pub fn variations(&self) -> Result<Option<Variations>, Error> {
        if !self.exact().is_some_and(|exact| exact.met) {
            return Ok(None);
        }
        let make =
            |problem: Problem<'_>,
             requirements: Requirements<'_>,
             handles: &[Handle],
             start: &[Point],
             cache| { ShapeSpace::new(&problem, &requirements, handles, start, cache) };
        let Some(space) = self.with_requirements(&Required::of, make)? else { return Ok(None) };
        let from = Rc::clone(self.scene.positions());
        Ok(Some(Variations { space: space?, from, reached: None }))
    }

    /// Shows the shape plus the variations times these coefficients, without projecting it back
    /// onto the constraints. Returns false if the variations are of another shape.
    pub fn show_variation(&mut self, variations: &mut Variations, coefficients: &[f64]) -> bool {
        if !self.begin_variation(variations) {
            return false;
        }
        self.scene.show(&variations.space.towards(coefficients));
        variations.reached = None;
        true
    }

    /// Applies the coefficients as far as the constraints can be met again, and shows that shape.
    /// Returns the fraction reached, or none if the variations are of another shape.
    ///
    /// # Errors
    /// As [`ShapeSpace::go`].
    pub fn project_variation(
        &mut self,
        variations: &mut Variations,
        coefficients: &[f64],
    ) -> Result<Option<f64>, Error> {
        if !self.begin_variation(variations) {
            return Ok(None);
        }
        let reached = variations.space.go(coefficients)?;
        self.scene.show(&reached.positions);
        self.note_reached(&reached.answer);
        variations.reached = Some(reached.answer);
        Ok(Some(reached.part))
    }

    /// Keeps the shape reached last as a variant and makes it the design, as one step of undo.
    /// Returns false if there is nothing to keep.
    ///
    /// # Errors
    /// If there are too many variants; the shape is then still shown.
    pub fn keep_variation(&mut self, variations: &mut Variations) -> Result<bool, Error> {
        let Some(answer) = variations.reached.take() else { return Ok(false) };
        let Some(transaction) = self.transaction.take_if(|it| it.is_variation()) else {
            return Ok(false);
        };
        let start = Rc::clone(&variations.from);
        match self.make(Edit::KeepVariant { start }) {
            Ok(Some((name, mut change))) => {
                change.scene.positions = transaction.into_back().scene.positions;
                self.history.push(name, change);
                self.note_reached(&answer);
                Ok(true)
            }
            Ok(None) => unreachable!("a variant more is a change"),
            Err(error) => {
                (self.transaction, variations.reached) = (Some(transaction), Some(answer));
                Err(error)
            }
        }
    }

    /// Discards a variation that is shown and not kept, and restores the shape before it.
    pub fn leave_variation(&mut self) {
        let Some(transaction) = self.transaction.take_if(|it| it.is_variation()) else { return };
        let mut back: Change = transaction.into_back();
        self.exchange(&mut back).expect("the state was solvable before");
        self.met = self.met_before.take();
    }

    fn begin_variation(&mut self, variations: &Variations) -> bool {
        let shown = self.transaction.as_ref().filter(|it| it.is_variation());
        if let Some(transaction) = shown {
            return Rc::ptr_eq(&transaction.back().scene.positions, &variations.from);
        }
        if !Rc::ptr_eq(self.scene.positions(), &variations.from) {
            return false;
        }
        self.begin(Transaction::variation);
        self.met_before = self.met.take();
        true
    }

    fn note_reached(&mut self, answer: &ExactAnswer) {
        let report = ExactReport::new(answer.clone(), &self.required_places(true));
        self.met = Some(Met::new(&self.scene, report));
    }
}
