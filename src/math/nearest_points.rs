//! The nearest of many points, by a k-d tree (Bentley, *Multidimensional binary search trees used for
//! associative searching*, 1975) without stored nodes: the middle of each range divides it.

use super::key_of_number;
use super::vec3::Vec3;

/// Ranges of at most so many points are searched one by one.
const LEAF: usize = 8;

/// Points, to be searched for the nearest to a place.
pub struct NearestPoints<'a> {
    points: &'a [Vec3<f64>],
    /// The points, divided again and again at the middle of ranges.
    order: Vec<usize>,
    /// The coordinate along which the range around each middle is divided.
    axes: Vec<u8>,
}

impl<'a> NearestPoints<'a> {
    /// Sorts the points; the order of time is that of their number times its logarithm.
    pub fn new(points: &'a [Vec3<f64>]) -> NearestPoints<'a> {
        let count = points.len();
        let mut own = NearestPoints { points, order: (0..count).collect(), axes: vec![0; count] };
        own.divide(0, count);
        own
    }

    fn divide(&mut self, from: usize, to: usize) {
        if to - from <= LEAF {
            return;
        }
        let points = self.points;
        let spread = |axis: u8| {
            let all = self.order[from..to].iter().map(|&i| coordinate(points[i], axis));
            let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            high - low
        };
        let axis =
            (1..3).fold(0, |best, axis| if spread(axis) > spread(best) { axis } else { best });
        let middle = usize::midpoint(from, to);
        let key = |&i: &usize| (key_of_number(coordinate(points[i], axis)), i);
        self.order[from..to].select_nth_unstable_by_key(middle - from, key);
        self.axes[middle] = axis;
        self.divide(from, middle);
        self.divide(middle + 1, to);
    }

    /// Returns the point nearest to `place`: `own` if no other is nearer, else the first of equal ones.
    pub fn nearest(&self, place: Vec3<f64>, own: usize) -> usize {
        let mut best = ((self.points[own] - place).length_squared(), own);
        self.search((0, self.order.len()), place, own, &mut best);
        best.1
    }

    fn search(
        &self,
        (from, to): (usize, usize),
        place: Vec3<f64>,
        own: usize,
        best: &mut (f64, usize),
    ) {
        let mut consider = |i: usize| {
            let distance = (self.points[i] - place).length_squared();
            if distance < best.0 || (distance == best.0 && best.1 != own && i < best.1) {
                *best = (distance, i);
            }
        };
        if to - from <= LEAF {
            self.order[from..to].iter().for_each(|&i| consider(i));
            return;
        }
        let middle = usize::midpoint(from, to);
        let at = self.order[middle];
        consider(at);
        let axis = self.axes[middle];
        let away = coordinate(place, axis) - coordinate(self.points[at], axis);
        let (below, above) = ((from, middle), (middle + 1, to));
        let (near, far) = if away < 0.0 { (below, above) } else { (above, below) };
        self.search(near, place, own, best);
        if away * away <= best.0 {
            self.search(far, place, own, best);
        }
    }
}

fn coordinate(point: Vec3<f64>, axis: u8) -> f64 {
    match axis {
        0 => point.x,
        1 => point.y,
        _ => point.z,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_that_of_a_search_through_all() {
        let point = |k: usize| {
            let at = |step: usize| f64::from((k * step % 23) as u32);
            Vec3::new(at(7), at(11), if k.is_multiple_of(2) { 0.0 } else { at(5) })
        };
        for count in [1, 8, 9, 100, 1000] {
            let points: Vec<_> = (0..count).map(point).collect();
            let tree = NearestPoints::new(&points);
            for k in 0..50 {
                let place = point(3 * k + 1) + Vec3::new(0.3, -0.4, 0.1);
                let distance = |i: usize| (points[i] - place).length_squared();
                let found = tree.nearest(place, 0);
                let first = (0..count).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
                assert_eq!(Some(found), first, "{count} {k}");
            }
        }
    }
}
