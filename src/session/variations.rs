//! Variations: ways to change the shape while its hard constraints stay met. They are searched on a
//! copy; their shapes are shown, kept or discarded by the session.

use super::Session;
use super::edit::Edit;
use super::run::{ExactReport, Met};
use super::undo::{ShownVariation, Transaction, TransactionKind};
use crate::mesh::Point;
use crate::session::Error;
use crate::solve::{Handle, Problem, Requirements, ShapeSpace, Variation};
use std::rc::Rc;

/// The variations of a shape of a session.
pub struct Variations {
    space: ShapeSpace,
    /// The index in the scene's list of constraints of each row of the space.
    places: Vec<usize>,
    generation: u32,
}

/// A varied shape that was brought back onto the hard constraints.
pub struct Varied {
    /// `#V by 3`.
    pub positions: Vec<Point>,
    /// The fraction of the coefficients that was reached; the rest is not possible.
    pub part: f64,
    /// How well it meets the constraints.
    pub report: ExactReport,
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

    /// The [`Session::generation`] of the shape that they change.
    pub fn generation(&self) -> u32 {
        self.generation
    }

    /// Returns the shape plus the variations times these coefficients, `#V by 3`, which meets the
    /// constraints only to first order.
    pub fn towards(&self, coefficients: &[f64]) -> Vec<Point> {
        self.space.towards(coefficients)
    }

    /// Applies the coefficients as far as the constraints can be met again.
    ///
    /// # Errors
    /// As [`ShapeSpace::move_along`].
    pub fn go(&mut self, coefficients: &[f64]) -> Result<Varied, Error> {
        let reached = self.space.move_along(coefficients)?;
        let report = ExactReport::new(reached.answer, &self.places);
        Ok(Varied { positions: reached.positions, part: reached.part, report })
    }
}

impl Session {
    /// Starts the search for variations of the current shape; none if no constraint is hard, or
    /// some are not met.
    ///
    /// # Errors
    /// If a set of the scene does not exist, or the system is singular.
    pub fn variations(&self) -> Result<Option<Variations>, Error> {
        let Some(required) = self.met_requirements() else { return Ok(None) };
        let make =
            |problem: Problem<'_>,
             requirements: Requirements<'_>,
             handles: &[Handle],
             start: &[Point],
             cache| { ShapeSpace::new(&problem, &requirements, handles, start, cache) };
        let Some(space) = self.with_requirements(self.document(), &required, make)? else {
            return Ok(None);
        };
        let places = self.required_places(&required, true);
        Ok(Some(Variations { space: space?, places, generation: self.generation() }))
    }

    /// Shows the positions `#V by 3` of a variation of the shape with the number `of`, with the
    /// report if they were brought back onto the constraints. Returns false if the current shape is
    /// another one, or dragged.
    pub fn show_variation(
        &mut self,
        of: u32,
        positions: &[Point],
        report: Option<ExactReport>,
    ) -> bool {
        if let Some(shown) = self.transaction.as_mut().and_then(Transaction::variation_shown) {
            if shown.of != of {
                return false;
            }
        } else {
            if self.is_dragging() || self.generation() != of {
                return false;
            }
            self.end_transaction();
            let met_before = self.met.take();
            let shown = ShownVariation { of, met_before };
            self.begin(TransactionKind::Variation(Box::new(shown)));
        }
        self.scene.show(positions);
        self.met = report.map(|report| Met::new(&self.scene, self.in_the_scene(report)));
        true
    }

    /// Keeps the shape shown as a variant and makes it the design, as one step of undo. Returns
    /// false if none is shown that was brought back onto the constraints.
    ///
    /// # Errors
    /// If there are too many variants; the shape is then still shown.
    pub fn keep_variation(&mut self) -> Result<bool, Error> {
        let Some(report) = self.met_here().map(|met| met.report.clone()) else { return Ok(false) };
        let Some(transaction) = self.transaction.take_if(|now| now.is_variation()) else {
            return Ok(false);
        };
        let start = Rc::clone(&transaction.before().scene.positions);
        match self.make(Edit::KeepVariant { start }) {
            Ok(Some((name, _))) => {
                self.add_step(name, transaction.into_before());
                self.met = Some(Met::new(&self.scene, self.in_the_scene(report)));
                Ok(true)
            }
            Ok(None) => unreachable!("a variant more is a change"),
            Err(error) => {
                self.transaction = Some(transaction);
                Err(error)
            }
        }
    }

    /// Discards a variation that is shown and not kept, and restores the shape before it. Returns
    /// whether there was one.
    pub fn leave_variation(&mut self) -> bool {
        let shown = self.transaction.as_mut().and_then(Transaction::variation_shown);
        let Some((of, met)) = shown.map(|shown| (shown.of, shown.met_before.take())) else {
            return false;
        };
        let Some(transaction) = self.transaction.take() else { return false };
        self.go_to_state(transaction.into_before()).expect("the state was solvable before");
        self.met = met;
        self.scene.restored(of);
        true
    }
}
