//! Queries about rows of constraints and vertices: members and measure of a row, measure of all, vertices
//! with a closeness factor of their own, vertices that no energy acts on.

use super::constraint_map::ConstraintCoverage;
use crate::constraint::{Element, Kind, Selector};
use crate::scene::{Scene, all_faces};
use crate::session::state::acts;
use crate::session::{ResolvedRow, Session};

/// Returns the id of the measure that row `index` makes zero on single faces, which is that of its
/// kind; none if its constraints are not on single faces.
pub(super) fn required_measure(document: &Scene, index: usize) -> Option<&'static str> {
    let row = document.constraints.get(index)?;
    let of_faces = matches!(row.on, Selector::Each { element: Element::Face, radius: 0, .. });
    row.kind.info().measure.filter(|_| of_faces)
}

/// Whether a kind has no parameters of its own: with them the shape is another one than that which
/// its measure is about.
pub(super) fn is_usual(kind: &Kind) -> bool {
    Kind::new(kind.info().id, serde_json::json!({})).is_ok_and(|usual| usual == *kind)
}

/// Returns the index of the row that asks panels for a shape: an enabled one on single faces whose kind
/// has an adjective for them. Of several it is one on all faces, as [`Scene::request_panels`] makes it,
/// and of the kind of the last one that asks for nothing else. None if no row does.
pub(crate) fn panel_row(document: &Scene) -> Option<usize> {
    let row = |index: usize| &document.constraints[index];
    let asks = |&index: &usize| {
        row(index).enabled
            && row(index).kind.info().panels.is_some()
            && required_measure(document, index).is_some()
    };
    let is_on_all = |index: &usize| row(*index).on == all_faces();
    let rows = || (0..document.constraints.len()).rev().filter(asks);
    let last = rows().find(is_on_all).or_else(|| rows().next())?;
    let is_plain = |index: &usize| {
        let kind = &row(*index).kind;
        is_on_all(index) == is_on_all(&last)
            && kind.info().id == row(last).kind.info().id
            && is_usual(kind)
    };
    rows().find(is_plain).or(Some(last))
}

impl Session {
    /// Returns the id of the measure whose largest value over all faces is the largest distance of
    /// constraint row `index`; none if there is no such measure.
    pub fn row_measure(&self, index: usize) -> Option<&'static str> {
        let document = self.document();
        let kind = &document.constraints.get(index)?.kind;
        let ResolvedRow { constraints, skipped, .. } = self.rows().get(index)?;
        let is_on_all = *skipped == 0 && constraints.members.len() == self.faces().len();
        required_measure(document, index).filter(|_| is_on_all && is_usual(kind))
    }

    /// Returns the id of the measure that fits the scene: that of the first enabled row that has one, else
    /// the distance to the constraints; none without constraints or faces.
    pub fn scene_measure(&self) -> Option<&'static str> {
        let document = self.document();
        if document.constraints.is_empty() || self.faces().is_empty() {
            return None;
        }
        let rows = document.constraints.iter().enumerate();
        let mut measured = rows
            .filter(|(_, row)| row.enabled && is_usual(&row.kind))
            .filter_map(|(row, _)| required_measure(document, row));
        Some(measured.next().unwrap_or("residual"))
    }

    /// Counts the vertices with a closeness factor other than 1.
    pub fn reweighted_vertices(&self) -> usize {
        if self.document().closeness.weights.is_empty() {
            return 0;
        }
        self.closeness_factors().iter().filter(|&&factor| factor != 1.0).count()
    }

    /// Returns the faces and the vertices that row `index` acts on, ascending; empty without a row. A face
    /// is included if one constraint of the row contains all its corners.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        let mut cover = ConstraintCoverage::new(self.mesh(), self.topology());
        let [mut faces, mut vertices] = [Vec::new(), Vec::new()];
        if let Some(row) = self.rows().get(index) {
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

    /// Returns the vertices without constraint, closeness, smoothness and handle, ascending.
    pub fn free(&self) -> Vec<u32> {
        let (document, count) = (self.document(), self.rest.positions().len());
        let mut acted_on = vec![false; count];
        let mut act_on = |vertices: &[u32]| {
            vertices.iter().for_each(|&vertex| acted_on[vertex as usize] = true);
        };
        let weights = document.weights;
        for (spec, row) in document.constraints.iter().zip(self.rows()) {
            if acts(spec, document) {
                act_on(row.constraints.members.indices());
            }
        }
        self.scene.handles().iter().for_each(|handle| act_on(&[handle.vertex]));
        if weights.smooth > 0.0 {
            act_on(self.topology().edges().as_flattened());
        }
        for (acted_on, is_kept) in acted_on.iter_mut().zip(self.solver().is_kept_close()) {
            *acted_on |= is_kept;
        }
        (0..).zip(acted_on).filter(|(_, acted_on)| !acted_on).map(|(vertex, _)| vertex).collect()
    }

    fn closeness_factors(&self) -> Vec<f64> {
        let document = self.document();
        let factors = document.closeness.factors(self.mesh(), self.topology(), &document.sets);
        factors.expect("the document was resolved when it was taken over")
    }
}
