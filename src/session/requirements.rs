//! What is required of the rows that are on: the problem of the exact solver, and how near the shape is to it. A row
//! with eased faces counts as two, which differ in what is required.

use super::Session;
use super::report::ConstraintCoverage;
use super::state::RestMesh;
use crate::error::Error;
use crate::mesh::{Point, Ragged};
use crate::scene::{ConstraintSpec, EasedFaces};
use crate::solve::{
    Constraints, Exact, Handle, Problem, Require, Requirements, SetupCache, exact_tolerance,
    farthest,
};

/// What is required of a row, and of which faces less.
#[derive(Clone, Debug)]
pub(super) struct Required {
    pub(super) require: Require,
    pub(super) eased: Option<EasedFaces>,
}

impl Required {
    /// As the scene says it.
    pub(super) fn of(row: &ConstraintSpec) -> Required {
        Required { require: row.require, eased: row.eased.clone() }
    }
}

impl Session {
    /// The rows that are on, with what is required of them: the place in the list of constraints, the constraints, and
    /// the requirement.
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

    /// The entries of the list of constraints that the rows of the exact solver belong to, where all is required as the
    /// scene says it, or those of the hard ones alone.
    pub(super) fn required_places(&self, only_hard: bool) -> Vec<usize> {
        let rows = self.required_rows(&Required::of).into_iter();
        rows.filter(|(.., require)| !only_hard || require.is_hard())
            .map(|(place, ..)| place)
            .collect()
    }

    /// Poses the problem with what is `required` of the rows that are on, from the current shape on; none where nothing
    /// is hard then.
    pub(super) fn with_requirements<T>(
        &self,
        required: &dyn Fn(&ConstraintSpec) -> Required,
        make: impl FnOnce(Problem<'_>, Requirements<'_>, &[Handle], &[Point], SetupCache) -> T,
    ) -> Result<Option<T>, Error> {
        let document = self.document();
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

    /// The greatest distance to what is hard at the current positions, the greatest that is allowed, and whether all
    /// are as allowed; none where nothing is hard.
    pub(super) fn hard_distance(&self) -> Option<(f64, f64, bool)> {
        let document = self.document();
        let exact = exact_tolerance(self.rest.positions());
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
            for (_, row, require) in rows.iter().filter(|(place, ..)| has_eased(*place)) {
                let worst = farthest(self.mesh(), self.scene.positions(), row);
                distances.extend(allowed(*require).map(|it| (worst, it)));
            }
        }
        let most = distances.iter().map(|(worst, _)| *worst).reduce(f64::max)?;
        let tolerance = distances.iter().map(|(_, allowed)| *allowed).fold(0.0, f64::max);
        // Written so that NaN is not met.
        Some((most, tolerance, distances.iter().all(|(worst, allowed)| worst <= allowed)))
    }

    /// Whether some constraints that are on are hard.
    pub fn has_hard_rows(&self) -> bool {
        let rows = &self.document().constraints;
        self.scene.enabled_rows().any(|row| rows[row].require.is_hard())
    }

    /// Whether the mesh is too large for anything to be exact, whatever is asked; within a length it can be met.
    pub fn is_too_large_for_exact(&self) -> bool {
        let is_smooth = self.document().weights.smooth > 0.0;
        Exact::is_too_large(self.solver().system().factor_nonzeros(), is_smooth)
    }

    /// Said before a run: where exact constraints would not fit in memory, the distance that they are met up to
    /// instead, in the unit of the mesh.
    ///
    /// # Errors
    /// When a set of the scene is not there.
    pub fn nearest_to_exact(&self) -> Result<Option<f64>, Error> {
        let nonzeros = self.solver().system().factor_nonzeros();
        let nearest = self.with_requirements(&Required::of, |problem, requirements, _, _, _| {
            Exact::nearest(&problem, &requirements, nonzeros)
        })?;
        Ok(nearest.flatten())
    }
}

/// Takes the constraints that are on one of the faces out of a row.
fn take_out(row: &mut Constraints, faces: &[u32], rest: &RestMesh) -> Constraints {
    let mut is_eased = vec![false; rest.mesh().faces.len()];
    faces.iter().for_each(|&face| is_eased[face as usize] = true);
    let mut coverage = ConstraintCoverage::new(rest.mesh(), rest.topology());
    let (mut less, mut left) = (Ragged::new(), Ragged::new());
    for members in row.members.iter() {
        let is_less = coverage.faces(members).iter().any(|&face| is_eased[face as usize]);
        if is_less { less.push(members) } else { left.push(members) }
    }
    row.members = left;
    Constraints { members: less, ..row.clone() }
}
