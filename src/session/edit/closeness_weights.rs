//! How much some vertices are kept close, more or less than the others: the entries of
//! `closeness.weights` that an edit of single vertices leaves.

use crate::constraint::Selector;
use crate::scene::{ClosenessTo, ClosenessWeight, Scene};

/// Gives `vertices` the factor `weight`, whatever other entries say; an entry for each factor lists
/// its vertices.
pub(crate) fn set_closeness_weight(
    weights: &mut Vec<ClosenessWeight>,
    vertices: &[u32],
    weight: f64,
) {
    let mut moved = vertices.to_vec();
    moved.sort_unstable();
    moved.dedup();
    for entry in weights.iter_mut() {
        if let Selector::Vertices(listed) = &mut entry.on {
            listed.retain(|vertex| moved.binary_search(vertex).is_err());
        }
    }
    let lists = |entry: &ClosenessWeight| matches!(entry.on, Selector::Vertices(_));
    weights.retain(|entry| entry.on != Selector::Vertices(Vec::new()));
    if weight == 1.0 && weights.iter().all(lists) {
        return;
    }
    let same = weights.iter_mut().rev().take_while(|entry| lists(entry));
    match same.into_iter().find(|entry| entry.weight == weight) {
        Some(ClosenessWeight { on: Selector::Vertices(listed), .. }) => {
            listed.extend(moved);
            listed.sort_unstable();
        }
        _ => weights.push(ClosenessWeight { on: Selector::Vertices(moved), weight }),
    }
}

/// Holds every vertex closer to where it was at rest: at first as a mesh that is opened, and from then on
/// ten times as much. On the surface alone it may still shrink to a dot.
pub(crate) fn strengthen_closeness(document: &mut Scene) {
    let close = document.weights.close;
    if close > 0.0 && document.closeness.to == ClosenessTo::Rest {
        document.weights.close = 10.0 * close;
    } else {
        document.keep_whole();
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
        let list = |vertices: &[u32]| Selector::Vertices(vertices.to_vec());
        let mut weights = Vec::new();
        set_closeness_weight(&mut weights, &[5, 3, 4], 10.0);
        set_closeness_weight(&mut weights, &[4, 9], 0.0);
        set_closeness_weight(&mut weights, &[1], 10.0);
        assert_eq!(weights, [entry(list(&[1, 3, 5]), 10.0), entry(list(&[4, 9]), 0.0)]);
        set_closeness_weight(&mut weights, &[1, 3, 4, 5, 9], 1.0);
        assert_eq!(weights, []);
        // Of a set that the scene names, single vertices are taken out by an entry of their own.
        weights.push(entry(Selector::Set("eaves".to_owned()), 3.0));
        set_closeness_weight(&mut weights, &[2], 1.0);
        assert_eq!(weights[1], entry(list(&[2]), 1.0));
    }
}
