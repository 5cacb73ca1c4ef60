//! Hard constraints met. A run iterates with them as soft ones until that has converged, and then meets them: the
//! same call goes on, one iteration or one step at a time, and shows the way now and then.

use super::Session;
use super::run::{Eased, ExactReport, Meeting, MeetingEnd, Met, Step, Unfolding};
use super::state::{Part, RowValues};
use crate::error::Error;
use crate::mesh::Point;
use crate::solve::{
    Constraints, Exact, Handle, Problem, Require, Requirements, SetupCache, exact_tolerance,
};

impl Session {
    /// The exact solver of the hard constraints, from the current shape on, to be stepped by the host and given to
    /// [`Session::accept`]; none where there are no hard constraints.
    ///
    /// # Errors
    /// When a set of the scene is not there.
    pub fn meeting(&self) -> Result<Option<Exact>, Error> {
        self.meeting_with(|require| require)
    }

    /// [`Session::meeting`] with something else required of the rows that are on.
    pub(super) fn meeting_with(
        &self,
        instead: impl Fn(Require) -> Require,
    ) -> Result<Option<Exact>, Error> {
        self.with_requirements(instead, |problem, requirements, handles, start, cache| {
            Exact::new(&problem, &requirements, handles, start, cache)
        })
    }

    /// Poses the problem with something else required of the rows that are on, from the current shape on; none where
    /// nothing is hard then.
    pub(super) fn with_requirements<T>(
        &self,
        instead: impl Fn(Require) -> Require,
        make: impl FnOnce(Problem<'_>, Requirements<'_>, &[Handle], &[Point], SetupCache) -> T,
    ) -> Result<Option<T>, Error> {
        let document = self.document();
        let places: Vec<usize> = self.scene.enabled_rows().collect();
        let requires: Vec<Require> =
            places.iter().map(|&row| instead(document.constraints[row].require)).collect();
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
        Ok(Some(make(problem, requirements, handles, start, cache)))
    }

    /// Whether the mesh is too large for anything to be exact, whatever is asked; within a length it can be met.
    pub fn is_too_large_for_exact(&self) -> bool {
        Exact::is_too_large(self.solver().system().factor_nonzeros())
    }

    /// Said before a run: where exact constraints would not fit in memory, the distance that they are met up to
    /// instead, in the unit of the mesh.
    ///
    /// # Errors
    /// When a set of the scene is not there.
    pub fn nearest_to_exact(&self) -> Result<Option<f64>, Error> {
        let nonzeros = self.solver().system().factor_nonzeros();
        let nearest = self.with_requirements(
            |require| require,
            |problem, requirements, _, _, _| Exact::nearest(&problem, &requirements, nonzeros),
        )?;
        Ok(nearest.flatten())
    }

    /// Takes the shape that was found, as a part of the run that is under way.
    ///
    /// # Errors
    /// When the system would be singular; nothing has changed then.
    pub fn accept(&mut self, exact: &Exact) -> Result<(), Error> {
        self.go_to(&exact.positions(), Vec::new())?;
        self.note_met(exact);
        Ok(())
    }

    /// Meets the hard constraints, if there are any, and improves the shape where that is asked for.
    pub(super) fn meet(&mut self, improves: bool) -> Result<(), Error> {
        if !self.begin_meeting()? {
            return Ok(());
        }
        while let Some(meeting) = &mut self.meeting {
            let ended = meeting.step();
            if ended == Ok(false) || (ended == Ok(true) && self.try_next()?) {
                continue;
            }
            self.end_meeting(improves)?;
            ended?;
        }
        Ok(())
    }

    /// How well the hard constraints are met; none while nobody has met those of the current shape.
    pub fn exact(&self) -> Option<ExactReport> {
        if let Some(met) = self.met_here() {
            return Some(met.report.clone());
        }
        self.hard_distance()
            .filter(|(_, _, met)| *met)
            .map(|(most, tolerance, _)| ExactReport::of_what_is_met(most, tolerance))
    }

    /// The greatest distance to what is hard at the current positions, the greatest that is allowed, and whether all
    /// are as allowed; none where nothing is hard.
    pub(super) fn hard_distance(&self) -> Option<(f64, f64, bool)> {
        let document = self.document();
        let rows = self.scene.enabled_rows().zip(self.solver().found());
        let tolerance = exact_tolerance(self.rest.positions());
        let (mut most, mut allowed, mut met) = (0.0_f64, None, true);
        for (row, found) in rows {
            let within = match document.constraints[row].require {
                Require::Soft => continue,
                Require::Exact => tolerance,
                Require::Within(length) => length,
            };
            let worst = found.worst_squared.sqrt();
            // Written so that NaN is not met.
            met &= worst <= within;
            most = most.max(worst);
            allowed = Some(within.max(allowed.unwrap_or(0.0)));
        }
        allowed.map(|tolerance| (most, tolerance, met))
    }

    /// Whether some constraints that are on are hard.
    pub fn has_hard_rows(&self) -> bool {
        let rows = &self.document().constraints;
        self.scene.enabled_rows().any(|row| rows[row].require.is_hard())
    }

    /// Whether the run that goes on is meeting hard constraints.
    pub fn is_meeting(&self) -> bool {
        self.meeting.is_some()
    }

    /// The result of the exact solver, if it is the current shape.
    pub(super) fn met_here(&self) -> Option<&Met> {
        self.met.as_ref().filter(|met| met.is_of(&self.scene))
    }

    /// Whether hard constraints were met here as well as they can be, and nothing has changed since.
    pub(super) fn is_met(&self) -> bool {
        self.met_here().is_some_and(|met| met.is_all(&self.scene))
    }

    /// Begins to meet the hard constraints, where there are some.
    pub(super) fn begin_meeting(&mut self) -> Result<bool, Error> {
        self.scene.settle();
        let Some(exact) = self.meeting()? else { return Ok(false) };
        self.meeting = Some(Meeting::new(exact, self.attempts()));
        Ok(true)
    }

    /// One iteration or step of what a run is meeting; none where it is not.
    pub(super) fn meeting_step(&mut self) -> Result<Option<Step>, Error> {
        let Some(meeting) = &mut self.meeting else { return Ok(None) };
        let ended = meeting.step();
        let shown = meeting.due_positions();
        let goes = ended == Ok(false) || (ended == Ok(true) && self.try_next()?);
        if !goes {
            self.progress.count();
            self.end_meeting(false)?;
            ended?;
            return Ok(Some(Step { converged: self.converged(), ended: true }));
        }
        match shown {
            Some(positions) => {
                self.scene.show(&positions);
                self.progress.advance(self.scene.solver().energy());
            }
            None => self.progress.count(),
        }
        Ok(Some(Step { converged: false, ended: false }))
    }

    /// Ends what a run is meeting, with the best shape so far, improved where that is asked for; whether there was
    /// anything.
    pub(super) fn end_meeting(&mut self, improves: bool) -> Result<bool, Error> {
        let Some(end) = self.meeting.take().map(Meeting::end) else { return Ok(false) };
        let MeetingEnd { mut exact, within, is_whole, folded_at_first, attempts } = end;
        let mut improved = Ok(());
        if improves {
            exact.improve();
            improved = exact.run();
        }
        let eased = match (self.unfolding, within) {
            (Unfolding::Eased(asked), Some(within)) => {
                Some(Eased { asked, within, folded: folded_at_first })
            }
            _ => None,
        };
        self.go_to(&exact.positions(), self.rows_eased(eased))?;
        self.note_met(&exact);
        if let Some(met) = &mut self.met {
            (met.report.attempts, met.report.eased) = (attempts, eased);
            if !is_whole {
                met.interrupt();
            }
        }
        Ok(improved.map(|()| true)?)
    }

    /// What makes rows within the tolerance that was asked such within the one that was taken.
    fn rows_eased(&self, eased: Option<Eased>) -> Vec<Part> {
        let Some(Eased { asked, within, .. }) = eased else { return Vec::new() };
        let rows = self.document().constraints.iter().enumerate();
        let asked = rows.filter(|(_, row)| row.require == Require::Within(asked));
        let eased = |(index, row)| {
            let require = Require::Within(within);
            Part::RowValues(index, RowValues { require, ..RowValues::of(row) })
        };
        asked.map(eased).collect()
    }

    /// Goes to other positions, `#V by 3`, and puts parts of the document, as a part of the run that is under way.
    fn go_to(&mut self, positions: &[Point], parts: Vec<Part>) -> Result<(), Error> {
        let mut change = self.way_back();
        change.scene.positions = positions.into();
        change.scene.parts = parts;
        self.exchange(&mut change)?;
        self.include(change);
        Ok(())
    }

    /// Notes that the current shape is that of `exact`.
    pub(super) fn note_met(&mut self, exact: &Exact) {
        let places: Vec<usize> = self.scene.enabled_rows().collect();
        let report = ExactReport::new(exact.answer(), &places);
        self.met = Some(Met::new(&self.scene, report));
    }
}
