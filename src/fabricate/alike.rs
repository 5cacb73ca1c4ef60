//! Things that are the same within a tolerance, sorted into types: in their order each joins the nearest leader within
//! the tolerance, else becomes one.

/// Something that can be the same as others.
pub(super) trait Alike {
    /// How many corners or beams it has: things of different numbers are never the same.
    fn count(&self) -> usize;

    /// A number that differs by no more than `count` times the tolerance between things that are the same: it
    /// tells most of the others apart at once.
    fn sum(&self) -> f64;

    /// How far it is from another of the same `count`, or something above `most` where it is farther than that.
    fn difference(&self, other: &Self, mirror: bool, most: f64) -> f64;
}

/// Things sorted into types.
#[derive(Clone, Debug, Default)]
pub struct Types {
    /// The type of each thing; none of those that cannot be compared.
    pub of: Vec<Option<u32>>,
    /// The first thing of each type, which the others are compared with.
    pub leaders: Vec<u32>,
    /// How many things each type has.
    pub counts: Vec<u32>,
    /// The largest difference of a thing to the leader of its type.
    pub worst: Vec<f64>,
}

impl Types {
    /// Sorts things within `tolerance`; `mirror` images are the same where that is asked for.
    pub(super) fn new<T: Alike>(
        things: impl Iterator<Item = Option<T>>,
        tolerance: f64,
        mirror: bool,
    ) -> Types {
        let mut types = Types::default();
        let mut leaders: Vec<T> = Vec::new();
        // Leaders by their counts and sums: those of the same type differ by little.
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
