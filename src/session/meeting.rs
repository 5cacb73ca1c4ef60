//! Hard constraints met: the shape that has them, and how well.

use super::Session;
use super::run::{ExactReport, Met};
use crate::error::Error;
use crate::solve::{Constraints, Exact, Require, Requirements};
use std::rc::Rc;

impl Session {
    /// What meets the hard constraints from the current shape on, to be stepped by the host and given to
    /// [`Session::accept`]; none where there are no hard constraints.
    ///
    /// # Errors
    /// When a set of the scene is not there.
    pub fn meeting(&self) -> Result<Option<Exact>, Error> {
        let document = self.document();
        let places: Vec<usize> = self.scene.enabled_rows().collect();
        let requires: Vec<Require> =
            places.iter().map(|&row| document.constraints[row].require).collect();
        if !requires.iter().any(|require| require.is_hard()) {
            return Ok(None);
        }
        let (mesh, topology) = (self.mesh(), self.topology());
        let constraints: Vec<Constraints> =
            places.iter().map(|&row| self.rows()[row].constraints.clone()).collect();
        let factors = document.closeness.factors(mesh, topology, &document.sets)?;
        let problem = document.problem(mesh, topology, &constraints, &factors);
        let requirements = Requirements {
            rows: &requires,
            shortest_edge: document.solver.shortest_edge,
            iterations: Requirements::ITERATIONS,
        };
        let (handles, start) = (self.scene.handles(), self.scene.positions());
        let cache = self.solver().setup_cache();
        Ok(Some(Exact::new(&problem, &requirements, handles, start, cache)))
    }

    /// Takes the shape that was found, as a part of the run that is under way.
    ///
    /// # Errors
    /// When the system would be singular; nothing has changed then.
    pub fn accept(&mut self, exact: &Exact) -> Result<(), Error> {
        let mut change = self.way_back();
        change.scene.positions = exact.positions().into();
        self.exchange(&mut change)?;
        self.include(change);
        let places: Vec<usize> = self.scene.enabled_rows().collect();
        let report = ExactReport::new(exact.answer(), &places);
        self.met = Some(Met { positions: Rc::clone(self.scene.positions()), report });
        Ok(())
    }

    /// Meets the hard constraints, if there are any. What cannot be met the report says.
    ///
    /// # Errors
    /// When a set of the scene is not there, or a system is singular.
    pub fn meet(&mut self) -> Result<(), Error> {
        let Some(mut exact) = self.meeting()? else { return Ok(()) };
        let ended = exact.run();
        self.accept(&exact)?;
        Ok(ended?)
    }

    /// How well the hard constraints are met; none while nobody has met those of the current shape.
    pub fn exact(&self) -> Option<&ExactReport> {
        let met = self.met.as_ref()?;
        Rc::ptr_eq(&met.positions, self.scene.positions()).then_some(&met.report)
    }
}
