//! Requirements of the enabled rows: the problem of the exact solver, and how far the shape is from
//! its solution. A row with eased faces counts as two rows with different requirements.

use super::Session;
use super::report::ConstraintCoverage;
use super::run::ExactReport;
use super::state::RestMesh;
use crate::math::marked;
use crate::mesh::{Point, Ragged};
use crate::scene::{ConstraintSpec, EasedFaces, Scene};
use crate::session::Error;
use crate::solve::{
    Constraints, Exact, ExactAnswer, Handle, Problem, Require, Requirements, SetupCache,
    exact_tolerance, farthest,
};

/// The requirement of a row, and its faces with an eased tolerance.
#[derive(Clone, Debug)]
pub(super) struct Required {
    pub(super) require: Require,
    pub(super) eased: Option<EasedFaces>,
}

impl Required {
    /// Returns the requirement in the scene.
    pub(super) fn of(row: &ConstraintSpec) -> Required {
        Required { require: row.require, eased: row.eased.clone() }
    }

    /// Returns the requirement in the scene, with exactness instead of a tolerance.
    pub(super) fn exactly(row: &ConstraintSpec) -> Required {
        match row.require {
            Require::Within(_) => Required { require: Require::Exact, eased: None },
            _ => Required::of(row),
        }
    }
}

/// Judges an answer by the requirement of the scene on each row of its solver: an attempt with exact
/// panels that leaves some a little off has reached the tolerance that was asked for.
pub(super) fn judged_by(requires: &[Require], mut answer: ExactAnswer) -> ExactAnswer {
    let is_allowed =
        |row: usize, far: f64| matches!(requires[row], Require::Within(length) if far <= length);
    answer.unmet.retain(|miss| !is_allowed(miss.row, miss.distance));
    answer.met = answer.unmet.is_empty();
    answer.contradiction &= !answer.met;
    answer.too_large &= requires.contains(&Require::Exact);
    answer
}

impl Session {
    /// Returns the enabled rows with their requirements: index in the list of constraints, the
    /// constraints, and the requirement.
    fn required_rows(
        &self,
        required: &dyn Fn(&ConstraintSpec) -> Required,
    ) -> Vec<(usize, Constraints, Require)> {
        let mut all = Vec::new();
        for place in self.scene.enabled_rows() {
            let mut row = self.rows()[place].constraints.clone();
            let Required { require, eased } = required(&self.document().constraints[place]);
            if let Some(EasedFaces { within, faces }) = eased {
                let less = take_out(&mut row, &faces, &self.rest);
                all.push((place, less, Require::Within(within)));
            }
            all.push((place, row, require));
        }
        all.retain(|(_, row, _)| !row.members.is_empty());
        all
    }

    /// Returns the index in the list of constraints of each row of the exact solver, with these
    /// requirements; only of hard rows if requested.
    pub(super) fn required_places(
        &self,
        required: &dyn Fn(&ConstraintSpec) -> Required,
        only_hard: bool,
    ) -> Vec<usize> {
        let rows = self.required_rows(required).into_iter();
        rows.filter(|(.., require)| !only_hard || require.is_hard())
            .map(|(place, ..)| place)
            .collect()
    }

    /// Builds the problem with the settings of `document` and the `required` requirements of the enabled
    /// rows, starting at the current shape; none if no row is then hard.
    pub(super) fn with_requirements<T>(
        &self,
        document: &Scene,
        required: &dyn Fn(&ConstraintSpec) -> Required,
        make: impl FnOnce(Problem<'_>, Requirements<'_>, &[Handle], &[Point], SetupCache) -> T,
    ) -> Result<Option<T>, Error> {
        let (mut constraints, mut requires) = (Vec::new(), Vec::new());
        for (_, row, require) in self.required_rows(required) {
            constraints.push(row);
            requires.push(require);
        }
        if !requires.iter().any(|require| require.is_hard()) {
            return Ok(None);
        }
        let (mesh, topology) = (self.mesh(), self.topology());
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

    /// Returns the largest distance to a hard constraint at the current positions, the largest
    /// allowed one, and whether all are within theirs; none if no constraint is hard.
    pub(super) fn hard_distance(&self) -> Option<(f64, f64, bool)> {
        let document = self.document();
        let exact = exact_tolerance(self.rest.mesh());
        let allowed = |require| match require {
            Require::Soft => None,
            Require::Exact => Some(exact),
            Require::Within(length) => Some(length),
        };
        let mut distances: Vec<(f64, f64)> = Vec::new();
        for (place, found) in self.scene.enabled_rows().zip(self.solver().found()) {
            let row = &document.constraints[place];
            let worst = found.worst_squared.sqrt();
            distances
                .extend(allowed(row.require).filter(|_| row.eased.is_none()).map(|it| (worst, it)));
        }
        let has_eased = |place: usize| document.constraints[place].eased.is_some();
        if self.scene.enabled_rows().any(has_eased) {
            let rows = self.required_rows(&Required::of);
            let pose = document.pose_positions();
            for (_, row, require) in rows.iter().filter(|(place, ..)| has_eased(*place)) {
                let worst = farthest(self.mesh(), pose, self.scene.positions(), row);
                distances.extend(allowed(*require).map(|it| (worst, it)));
            }
        }
        let most = distances.iter().map(|(worst, _)| *worst).reduce(f64::max)?;
        let tolerance = distances.iter().map(|(_, allowed)| *allowed).fold(0.0, f64::max);
        // Written so that NaN counts as not met.
        Some((most, tolerance, distances.iter().all(|(worst, allowed)| worst <= allowed)))
    }

    /// Returns the largest distance to a hard constraint at `positions`, `#V by 3`; none if no constraint
    /// is hard.
    pub(super) fn hard_distance_at(&self, positions: &[Point]) -> Option<f64> {
        let pose = self.document().pose_positions();
        let rows = self.required_rows(&Required::of).into_iter();
        let hard = rows.filter(|(.., require)| require.is_hard());
        hard.map(|(_, row, _)| farthest(self.mesh(), pose, positions, &row)).reduce(f64::max)
    }

    /// Whether the current shape meets its hard constraints exactly, whatever the scene requires.
    pub(super) fn is_exact(&self) -> bool {
        let tolerance = exact_tolerance(self.rest.mesh());
        self.exact().is_some_and(|report| report.met && report.max_distance <= tolerance)
    }

    /// The requirements that other shapes are to meet as the current one does: exactly, if it is exact;
    /// none if it does not meet those of the scene.
    pub(super) fn met_requirements(&self) -> Option<fn(&ConstraintSpec) -> Required> {
        let is_met = self.exact().is_some_and(|report| report.met);
        is_met.then_some(if self.is_exact() { Required::exactly } else { Required::of })
    }

    /// Returns the report on a shape that was found with other requirements, with the tolerance of the
    /// scene.
    pub(super) fn in_the_scene(&self, report: ExactReport) -> ExactReport {
        let required = self.hard_distance();
        let tolerance = required.map_or(report.tolerance, |(_, tolerance, _)| tolerance);
        ExactReport { tolerance, ..report }
    }

    /// Whether some enabled constraints are hard.
    pub fn has_hard_rows(&self) -> bool {
        let rows = &self.document().constraints;
        self.scene.enabled_rows().any(|row| rows[row].require.is_hard())
    }

    /// Whether the mesh is too large for exact constraints; those within a length can be met.
    pub fn is_too_large_for_exact(&self) -> bool {
        let is_smooth = self.document().weights.smooth > 0.0;
        Exact::is_too_large(self.solver().system().factor_nonzeros(), is_smooth)
    }

    /// Returns the distance, in the unit of the mesh, up to which exact constraints will be met if
    /// they do not fit in memory. Used to inform the user before a run.
    ///
    /// # Errors
    /// If a set of the scene does not exist.
    pub fn nearest_to_exact(&self) -> Result<Option<f64>, Error> {
        let nonzeros = self.solver().system().factor_nonzeros();
        let nearest = self.with_requirements(
            self.document(),
            &Required::of,
            |problem, requirements, _, _, _| Exact::nearest(&problem, &requirements, nonzeros),
        )?;
        Ok(nearest.flatten())
    }
}

/// Removes the constraints on any of the faces from a row, and returns them.
fn take_out(row: &mut Constraints, faces: &[u32], rest: &RestMesh) -> Constraints {
    let is_eased = marked(rest.mesh().faces.len(), faces);
    let mut coverage = ConstraintCoverage::new(rest.mesh(), rest.topology());
    let (mut taken, mut kept) = (Ragged::new(), Ragged::new());
    for members in row.members.iter() {
        let is_taken = coverage.faces(members).iter().any(|&face| is_eased[face as usize]);
        if is_taken { taken.push(members) } else { kept.push(members) }
    }
    row.members = kept;
    Constraints { members: taken, ..row.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::Unmet;

    #[test]
    fn an_answer_is_judged_by_what_the_scene_requires() {
        // Panels 1e-7 off in an attempt to make them exact were not satisfied within 1 mm.
        let unmet = |row| Unmet { row, vertices: Vec::new(), distance: 1e-7 };
        let answer =
            ExactAnswer { unmet: vec![unmet(0), unmet(1)], too_large: true, ..Default::default() };
        let within = Require::Within(1e-3);
        let judged = judged_by(&[within, Require::Exact], answer.clone());
        assert!(!judged.met && judged.too_large && judged.unmet.len() == 1);
        assert!(judged_by(&[within, Require::Within(1e-8)], answer.clone()).unmet.len() == 1);
        let judged = judged_by(&[within, within], answer);
        assert!(judged.met && !judged.too_large && judged.unmet.is_empty());
    }
}
