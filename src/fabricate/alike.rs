//! Sorting of items into types: in order, each item joins the nearest type leader within the
//! tolerance, or becomes a leader itself.

use super::boxes::Boxes;
use std::collections::BTreeMap;

/// An item that can be compared with others.
pub(super) trait Alike {
    /// Number of corners or beams; items with different numbers are never alike.
    fn count(&self) -> usize;

    /// Two numbers that each differ by at most the tolerance between alike items: a quick test that
    /// excludes most candidates.
    fn key(&self) -> [f64; 2];

    /// Difference to another item of the same `count`; anything above `most` if it is larger than
    /// that.
    fn difference(&self, other: &Self, mirror: bool, most: f64) -> f64;
}

/// Relative error of a key.
const ROUNDING: f64 = 1e-9;

/// Items sorted into types.
#[derive(Clone, Debug, Default)]
pub struct Types {
    /// The type of each item; none if it cannot be compared.
    pub of: Vec<Option<u32>>,
    /// The first item of each type, which the others are compared with.
    pub leaders: Vec<u32>,
    /// Number of items of each type.
    pub counts: Vec<u32>,
    /// Largest difference between an item of each type and its leader.
    pub worst: Vec<f64>,
}

impl Types {
    /// Sorts items into types within `tolerance`; with `mirror`, mirror images are alike.
    pub(super) fn new<T: Alike>(
        items: impl Iterator<Item = Option<T>>,
        tolerance: f64,
        mirror: bool,
    ) -> Types {
        let mut types = Types::default();
        let mut leaders: Vec<T> = Vec::new();
        // For each count, a box around the key of each leader, in which are those of its candidates.
        let mut sorted: BTreeMap<usize, Boxes> = BTreeMap::new();
        for (item, number) in items.zip(0..) {
            let Some(item) = item else {
                types.of.push(None);
                continue;
            };
            let key = item.key();
            let near = sorted.entry(item.count()).or_default();
            let mut nearest: Option<(f64, u32)> = None;
            for kind in near.meeting([key; 2]) {
                let difference = item.difference(&leaders[kind as usize], mirror, tolerance);
                if difference <= tolerance && nearest.is_none_or(|best| (difference, kind) < best) {
                    nearest = Some((difference, kind));
                }
            }
            let (difference, kind) = nearest.unwrap_or_else(|| {
                let kind = leaders.len() as u32;
                let around = |by: f64| key.map(|x| x + by * (tolerance + ROUNDING * x.abs()));
                near.insert(kind, [around(-1.0), around(1.0)]);
                leaders.push(item);
                types.leaders.push(number);
                types.counts.push(0);
                types.worst.push(0.0);
                (0.0, kind)
            });
            let k = kind as usize;
            types.counts[k] += 1;
            types.worst[k] = types.worst[k].max(difference);
            types.of.push(Some(kind));
        }
        types
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// An item of two lengths, which counts how often any is compared.
    struct Pair<'a>([f64; 2], &'a Cell<usize>);

    impl Alike for Pair<'_> {
        fn count(&self) -> usize {
            2
        }
        fn key(&self) -> [f64; 2] {
            self.0
        }
        fn difference(&self, other: &Self, _: bool, _: f64) -> f64 {
            self.1.set(self.1.get() + 1);
            (self.0[0] - other.0[0]).abs().max((self.0[1] - other.0[1]).abs())
        }
    }

    fn pairs(n: usize, compared: &Cell<usize>) -> impl Iterator<Item = Option<Pair<'_>>> {
        let at = |k: usize, by: usize| (k * by % 9973) as f64 * 1e-4;
        (0..n).map(move |k| Some(Pair([at(k, 7919), at(k, 104_729)], compared)))
    }

    /// Each was compared with all leaders of about its perimeter, a fixed part of them all.
    #[test]
    fn each_of_many_different_items_is_compared_with_few() {
        let compared = Cell::new(0);
        let types = Types::new(pairs(9000, &compared), 1e-3, false);
        assert!(types.leaders.len() > 4000, "{}", types.leaders.len());
        assert!(compared.get() < 10 * 9000, "{}", compared.get());
    }

    #[test]
    fn an_item_has_the_type_of_the_nearest_leader_of_all() {
        let compared = Cell::new(0);
        for tolerance in [0.0, 1e-3, 0.02, 0.3] {
            let types = Types::new(pairs(600, &compared), tolerance, false);
            let all: Vec<_> = pairs(600, &compared).flatten().collect();
            for (k, own) in all.iter().enumerate() {
                let earlier =
                    types.leaders.iter().zip(0..).take_while(|(leader, _)| **leader <= k as u32);
                let nearest = earlier
                    .map(|(&leader, kind)| {
                        (own.difference(&all[leader as usize], false, 0.0), kind)
                    })
                    .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
                assert_eq!(nearest.map(|(_, kind)| kind), types.of[k], "{tolerance} {k}");
                assert!(nearest.is_some_and(|(difference, _)| difference <= tolerance));
            }
        }
    }
}
