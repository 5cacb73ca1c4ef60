//! The attempts to meet hard constraints without folding faces, and without a rough surface.

use super::Session;
use super::requirements::Required;
use super::run::{Attempt, Attempts, Eased, Outcome, Tolerances, Unfolding};
use super::state::{Part, RowValues, Settings};
use crate::mesh::Point;
use crate::scene::{ConstraintSpec, EasedFaces, SmoothnessOf, all_faces};
use crate::session::Error;
use crate::solve::{Exact, ExactAnswer, Require, Requirements};
use crate::words;

impl Session {
    /// Plans the attempts to meet the hard constraints.
    pub(super) fn attempts(&self) -> Attempts {
        let document = self.document();
        // Only displacements: a smoother surface would be another design.
        let is_smooth =
            document.weights.smooth > 0.0 && document.smoothness.of == SmoothnessOf::Displacement;
        let (faces, edge) = (self.mesh().faces.len(), self.rest.mean_edge());
        Attempts::new(self.unfolding, is_smooth, faces, edge, self.rest.fair_bends())
    }

    /// Begins the next attempt after one has ended; returns false if there is none.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub(super) fn try_next(&mut self) -> Result<bool, Error> {
        let Some(meeting) = &mut self.meeting else { return Ok(false) };
        let positions = meeting.exact().positions();
        let ExactAnswer { met, iterations, .. } = meeting.exact().answer();
        let outcome = Outcome {
            met,
            folded: self.rest.folded_by(&positions),
            bend: self.rest.bend_at(&positions),
            energy: meeting.energy(),
            moved: self.rest.moved_by(&positions).max,
            work: u64::from(iterations) * positions.len() as u64,
        };
        let rest = &self.rest;
        let next = meeting.next(&outcome, &|faces| rest.faces_around(faces));
        let Some((attempt, start)) = next else { return Ok(false) };
        let start = match start {
            Some(whole) => self.eased_start(&attempt, whole, &positions),
            None => self.rest.positions().to_vec(),
        };
        let next = self.attempt(&attempt, &start)?;
        Ok(self.meeting.as_mut().zip(next).is_some_and(|(meeting, next)| {
            meeting.turn_to(next, attempt);
            true
        }))
    }

    /// Returns the exact solver of an attempt that starts at `start` (`#V by 3`).
    fn attempt(&self, attempt: &Attempt, start: &[Point]) -> Result<Option<Exact>, Error> {
        let required = |row: &ConstraintSpec| match attempt {
            Attempt::Exact if self.may_ease(row) => {
                Required { require: Require::Exact, eased: None }
            }
            Attempt::Eased(Tolerances { within, eased }) if self.may_ease(row) => {
                Required { require: Require::Within(*within), eased: eased.clone() }
            }
            _ => Required::of(row),
        };
        self.with_requirements(&required, |mut problem, mut requirements, handles, _, cache| {
            problem.weights.smooth *= attempt.smoother();
            requirements.iterations = attempt.iterations().unwrap_or(Requirements::ITERATIONS);
            Exact::new(&problem, &requirements, handles, start, cache)
        })
    }

    /// Returns the change that multiplies the smoothness weight.
    pub(super) fn smoother(&self, times: f64) -> Part {
        Part::Settings(Settings::of(self.document()).smoother(times))
    }

    /// Returns the start of an eased attempt, `#V by 3`: the end of the last one, but with the
    /// eased faces of the last shape without folds. From that shape alone it would take longer.
    fn eased_start(&self, attempt: &Attempt, whole: Vec<Point>, last: &[Point]) -> Vec<Point> {
        let Attempt::Eased(Tolerances { eased: Some(eased), .. }) = attempt else { return whole };
        let mut start = last.to_vec();
        for &face in &eased.faces {
            for &vertex in self.rest.mesh().faces.row(face as usize) {
                start[vertex as usize] = whole[vertex as usize];
            }
        }
        start
    }

    /// Whether the tolerance of a row may be eased: it is that of all panels.
    pub(super) fn may_ease(&self, row: &ConstraintSpec) -> bool {
        let Unfolding::Eased(asked) = self.unfolding else { return false };
        row.enabled && row.require == Require::Within(asked) && row.on == all_faces()
    }

    /// Returns the changes that ease the rows to `tolerances`, and a report. `folded` faces would
    /// fold otherwise, and the `farthest` vertex has this distance to its projection. If the panels
    /// did not reach the required tolerance, all of them are eased.
    pub(super) fn eased(
        &self,
        tolerances: &Tolerances,
        folded: usize,
        farthest: f64,
    ) -> Option<(Vec<Part>, Eased)> {
        let Unfolding::Eased(asked) = self.unfolding else { return None };
        let Tolerances { within, eased } = tolerances;
        let mut eased =
            eased.clone().unwrap_or_else(|| EasedFaces { within: *within, faces: Vec::new() });
        if *within > asked {
            eased.faces = (0..self.mesh().faces.len() as u32).collect();
        }
        if eased.faces.is_empty() {
            return None;
        }
        // Use no larger tolerance than needed.
        eased.within = two_digits_above(farthest).clamp(asked, eased.within);
        let report = Eased { asked, within: eased.within, panels: eased.faces.len(), folded };
        Some((self.ease_rows(Some(&eased)), report))
    }

    /// Returns the changes that give these eased faces to the rows that may have them.
    pub(super) fn ease_rows(&self, eased: Option<&EasedFaces>) -> Vec<Part> {
        let rows = self.document().constraints.iter().enumerate();
        let rows = rows.filter(|(_, row)| self.may_ease(row) && row.eased.as_ref() != eased);
        let ease = |(index, row)| {
            Part::RowValues(index, RowValues { eased: eased.cloned(), ..RowValues::of(row) })
        };
        rows.map(ease).collect()
    }
}

/// Rounds up to a number of two digits, at most a ninth larger.
fn two_digits_above(number: f64) -> f64 {
    words::rounded(1.06 * number, 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_number_is_above_and_near() {
        for k in 0..2000 {
            let number = 1e-3 * 1.01_f64.powi(k);
            let above = two_digits_above(number);
            assert!((1.0..1.112).contains(&(above / number)), "{number}: {above}");
        }
    }
}
