//! What differs between two documents on one mesh.

use crate::constraint::{Kind, Selector, Set};
use crate::scene::{ConstraintSpec, Scene, Variants};
use crate::solve::Require;

/// How much of the solver depends on what differs between two documents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    /// The solver does not depend on it.
    Nothing,
    /// Only the weights of Eq. 13.
    Weights,
    /// The whole problem.
    Problem,
}

impl Effect {
    /// Returns the effect of what differs between these documents.
    pub(crate) fn between(a: &Scene, b: &Scene) -> Effect {
        match (same_beside_weights(a, b), a.weights == b.weights) {
            (true, true) => Effect::Nothing,
            (true, false) => Effect::Weights,
            (false, _) => Effect::Problem,
        }
    }
}

/// Whether two documents pose the same problem to the solver, which was met in the same way.
pub(crate) fn same_problem(a: &Scene, b: &Scene) -> bool {
    a.attempt == b.attempt && Effect::between(a, b) == Effect::Nothing
}

/// Whether two documents pose the same problem, apart from the weights of Eq. 13.
fn same_beside_weights(a: &Scene, b: &Scene) -> bool {
    let alike = |(a, b): (&ConstraintSpec, &ConstraintSpec)| {
        let values = |row: &ConstraintSpec| (row.weight, row.enabled, row.require);
        (&a.kind, &a.on, &a.eased, values(a)) == (&b.kind, &b.on, &b.eased, values(b))
    };
    let [from, to] = [a, b].map(|scene| &scene.closeness);
    from.to == to.to
        && from.target == to.target
        && from.boundary.in_effect() == to.boundary.in_effect()
        && from.weights == to.weights
        && a.pose == b.pose
        && a.smoothness == b.smoothness
        && a.solver == b.solver
        && same_design(&a.variants, &b.variants)
        && a.constraints.len() == b.constraints.len()
        && a.constraints.iter().zip(&b.constraints).all(alike)
        && other_sets(a, b)
            .all(|name| [a, b].iter().all(|scene| !uses(name, scene).contains(&true)))
}

/// The names of the sets that differ.
pub(crate) fn other_sets<'a>(a: &'a Scene, b: &'a Scene) -> impl Iterator<Item = &'a str> {
    let names = a.sets.keys().chain(b.sets.keys().filter(move |name| !a.sets.contains_key(*name)));
    names.filter(move |name| a.sets.get(*name) != b.sets.get(*name)).map(String::as_str)
}

/// Whether constraints, and whether closeness weights of a scene are on the set of this name.
pub(crate) fn uses(name: &str, scene: &Scene) -> [bool; 2] {
    let is_it = |on: &Selector| on.named() == Some(name);
    [
        scene.constraints.iter().any(|row| is_it(&row.on)),
        scene.closeness.weights.iter().any(|entry| is_it(&entry.on)),
    ]
}

fn same_design(a: &Variants, b: &Variants) -> bool {
    a.design_positions() == b.design_positions()
}

/// Whether other hard constraints are asked for: how much they weigh is no question of what is asked
/// for, and what is eased is what a search has found.
pub(crate) fn asks_otherwise(a: &Scene, b: &Scene) -> bool {
    type Asked<'a> = (&'a Kind, &'a Selector, Require, Option<&'a Set>);
    fn asked(scene: &Scene) -> impl Iterator<Item = Asked<'_>> {
        let rows = scene.constraints.iter().filter(|row| row.enabled && row.require.is_hard());
        rows.map(move |row| {
            let set = row.on.named().and_then(|name| scene.sets.get(name));
            (&row.kind, &row.on, row.require, set)
        })
    }
    !asked(a).eq(asked(b))
}
