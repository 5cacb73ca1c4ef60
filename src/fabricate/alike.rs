//! Sorting of items into types: in order, each item joins the nearest type leader within the
//! tolerance, or becomes a leader itself.

/// An item that can be compared with others.
pub(super) trait Alike {
    /// Number of corners or beams; items with different numbers are never alike.
    fn count(&self) -> usize;

    /// A number that differs by at most `count` times the tolerance between alike items: a quick
    /// test that excludes most candidates.
    fn sum(&self) -> f64;

    /// Difference to another item of the same `count`; anything above `most` if it is larger than
    /// that.
    fn difference(&self, other: &Self, mirror: bool, most: f64) -> f64;
}

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
        things: impl Iterator<Item = Option<T>>,
        tolerance: f64,
        mirror: bool,
    ) -> Types {
        let mut types = Types::default();
        let mut leaders: Vec<T> = Vec::new();
        // Leaders sorted by count and sum, so that candidates are neighbours.
        let mut sorted: Vec<(usize, f64, u32)> = Vec::new();
        for (thing, number) in things.zip(0..) {
            let Some(thing) = thing else {
                types.of.push(None);
                continue;
            };
            let (count, sum) = (thing.count(), thing.sum());
            let reach = count as f64 * tolerance;
            let from =
                sorted.partition_point(|&(n, s, _)| n < count || (n == count && s < sum - reach));
            let near =
                sorted[from..].iter().take_while(|&&(n, s, _)| n == count && s <= sum + reach);
            let mut nearest: Option<(f64, u32)> = None;
            for &(.., kind) in near {
                let difference = thing.difference(&leaders[kind as usize], mirror, tolerance);
                if difference <= tolerance && nearest.is_none_or(|best| (difference, kind) < best) {
                    nearest = Some((difference, kind));
                }
            }
            let (difference, kind) = nearest.unwrap_or_else(|| {
                let kind = leaders.len() as u32;
                let at = sorted.partition_point(|&(n, s, _)| (n, s) < (count, sum));
                sorted.insert(at, (count, sum, kind));
                leaders.push(thing);
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
