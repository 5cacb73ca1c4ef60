//! Factors of closeness for single vertices: edits of the entries of `closeness.weights`.

use crate::constraint::Selector;
use crate::scene::{ClosenessTo, ClosenessWeight, Scene};

/// Sets the factor of `vertices` to `weight`, whatever other entries contain. Each factor has one
/// entry, which lists its vertices.
pub(crate) fn set_closeness_weight(
    weights: &mut Vec<ClosenessWeight>,
    vertices: &[u32],
    weight: f64,
) {
    let mut moved = vertices.to_vec();
    moved.sort_unstable();
    moved.dedup();
    let is_moved = |vertex: &u32| moved.binary_search(vertex).is_ok();
    weights.retain_mut(|entry| match &mut entry.on {
        Selector::Vertices(listed) => {
            if listed.iter().any(is_moved) {
                *listed = listed.iter().copied().filter(|vertex| !is_moved(vertex)).collect();
            }
            !listed.is_empty()
        }
        _ => true,
    });
    let lists = |entry: &ClosenessWeight| matches!(entry.on, Selector::Vertices(_));
    if weight == 1.0 && weights.iter().all(lists) {
        return;
    }
    let same = weights.iter_mut().rev().take_while(|entry| lists(entry));
    match same.into_iter().find(|entry| entry.weight == weight) {
        Some(ClosenessWeight { on: Selector::Vertices(listed), .. }) => {
            let mut all = [&**listed, &moved].concat();
            all.sort_unstable();
            *listed = all.into();
        }
        _ => weights.push(ClosenessWeight { on: Selector::Vertices(moved.into()), weight }),
    }
}

/// Holds every vertex closer to its rest position: first as in a newly opened mesh, then ten times
/// as strongly on each call. Closeness to the surface alone may let the shape shrink to a point.
pub(crate) fn strengthen_closeness(document: &mut Scene) {
    let close = document.weights.close;
    if close > 0.0 && document.closeness.to == ClosenessTo::Rest {
        document.weights.close = 10.0 * close;
    } else {
        document.set_opened_defaults();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(on: Selector, weight: f64) -> ClosenessWeight {
        ClosenessWeight { on, weight }
    }

    #[test]
    fn a_vertex_is_in_one_list_and_the_usual_factor_needs_none() {
        let list = |vertices: &[u32]| Selector::Vertices(vertices.into());
        let mut weights = Vec::new();
        set_closeness_weight(&mut weights, &[5, 3, 4], 10.0);
        set_closeness_weight(&mut weights, &[4, 9], 0.0);
        set_closeness_weight(&mut weights, &[1], 10.0);
        assert_eq!(weights, [entry(list(&[1, 3, 5]), 10.0), entry(list(&[4, 9]), 0.0)]);
        set_closeness_weight(&mut weights, &[1, 3, 4, 5, 9], 1.0);
        assert_eq!(weights, []);
        // An entry of its own excludes single vertices from a set of the scene.
        weights.push(entry(Selector::Set("eaves".to_owned()), 3.0));
        set_closeness_weight(&mut weights, &[2], 1.0);
        assert_eq!(weights[1], entry(list(&[2]), 1.0));
    }
}
