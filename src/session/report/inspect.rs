//! Queries about rows of constraints and vertices: members and measure of a row, vertices with another
//! closeness weight than the rest, vertices that no energy acts on.

use super::constraint_map::ConstraintCoverage;
use crate::constraint::{Element, Selector};
use crate::scene::{BoundaryRequire, ClosenessTo, Scene};
use crate::session::state::{ResolvedRow, RestMesh, SolvedScene};

/// The id of the measure that row `index` brings to zero on single faces: that of its kind, if each of its
/// constraints is on one face.
pub(crate) fn asked_measure(document: &Scene, index: usize) -> Option<&'static str> {
    let row = document.constraints.get(index)?;
    let of_faces = matches!(row.on, Selector::Each { element: Element::Face, radius: 0, .. });
    row.kind.info().measure.filter(|_| of_faces)
}

/// How many vertices are kept close more or less than the others.
pub(crate) fn held_otherwise(document: &Scene, rest: &RestMesh) -> usize {
    let closeness = &document.closeness;
    if closeness.weights.is_empty() {
        return 0;
    }
    let factors = closeness.factors(rest.mesh(), rest.topology(), &document.sets);
    let factors = factors.expect("the document was resolved when it was taken over");
    factors.iter().filter(|&&factor| factor != 1.0).count()
}

/// The faces and the vertices that a row acts on, ascending; a face counts when one of the row's
/// constraints has all its corners. Empty where there is no row.
pub(crate) fn members(row: Option<&ResolvedRow>, rest: &RestMesh) -> [Vec<u32>; 2] {
    let mut cover = ConstraintCoverage::new(rest.mesh(), rest.topology());
    let [mut faces, mut vertices] = [Vec::new(), Vec::new()];
    if let Some(row) = row {
        let members = &row.constraints.members;
        members.iter().for_each(|set| faces.extend(cover.faces(set)));
        vertices.extend(members.indices());
    }
    for indices in [&mut faces, &mut vertices] {
        indices.sort_unstable();
        indices.dedup();
    }
    [faces, vertices]
}

/// The vertices on which neither a constraint nor closeness, smoothness, or a handle acts, ascending.
pub(crate) fn free(scene: &SolvedScene, rest: &RestMesh) -> Vec<u32> {
    let (document, count) = (scene.document(), rest.positions().len());
    let mut acted_on = vec![false; count];
    let mut act_on = |vertices: &[u32]| {
        vertices.iter().for_each(|&vertex| acted_on[vertex as usize] = true);
    };
    let weights = document.weights;
    let acting = |row: &&ResolvedRow| row.enabled && row.constraints.weight > 0.0;
    for row in scene.rows().iter().filter(acting).filter(|_| weights.shape > 0.0) {
        act_on(row.constraints.members.indices());
    }
    scene.handles().iter().for_each(|handle| act_on(&[handle.vertex]));
    if weights.smooth > 0.0 {
        act_on(rest.topology().edges().as_flattened());
    }
    let closeness = &document.closeness;
    let exact = closeness.boundary.is_some_and(|it| it.require == BoundaryRequire::Exact);
    if weights.close > 0.0 || exact {
        let factors = closeness.factors(rest.mesh(), rest.topology(), &document.sets);
        let factors = factors.expect("the document was resolved when it was taken over");
        let mut hold = |vertex: u32| {
            acted_on[vertex as usize] |= factors[vertex as usize] > 0.0;
        };
        if closeness.to != ClosenessTo::None && weights.close > 0.0 {
            (0..count as u32).for_each(&mut hold);
        } else if closeness.boundary.is_some() {
            let loops = rest.topology().boundary_loops();
            loops.indices().iter().copied().for_each(&mut hold);
        }
    }
    (0..).zip(acted_on).filter(|(_, acted_on)| !acted_on).map(|(vertex, _)| vertex).collect()
}
