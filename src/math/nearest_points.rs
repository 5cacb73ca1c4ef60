//! The nearest of many points, by a k-d tree (Bentley, *Multidimensional binary search trees used for
//! associative searching*, 1975) without stored nodes: the middle of each range divides it. And the points
//! within a length, by cubic cells, while points come and go.

use super::key_of_number;
use super::vec3::Vec3;
use std::collections::HashMap;

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

/// Points with an item each, in cubic cells, to be searched for those within a length of a place.
pub struct Cells<T> {
    reach: f64,
    /// By the bits of the coordinates of the cells, which are whole numbers.
    cells: HashMap<[u64; 3], Vec<(Vec3<f64>, T)>>,
}

/// Side of a cell, in reaches: above two by more than rounding takes, so that what is within the reach is in
/// at most two cells along each axis.
const SIDE: f64 = 2.5;

impl<T: Copy> Cells<T> {
    /// No points yet, to be searched within `reach`, a positive length.
    pub fn new(reach: f64) -> Cells<T> {
        Cells { reach, cells: HashMap::new() }
    }

    /// Adds a point.
    pub fn add(&mut self, point: Vec3<f64>, item: T) {
        self.cells.entry(self.cell(point)).or_default().push((point, item));
    }

    /// Returns the items of at least all points within the reach of a place, and their distances.
    pub fn near(&self, place: Vec3<f64>) -> impl Iterator<Item = (T, f64)> {
        let points = self.around(place).filter_map(|cell| self.cells.get(&cell)).flatten();
        points.map(move |&(point, item)| (item, (point - place).length()))
    }

    /// Takes out the points that are nearer to a place than the reach, and returns their items.
    pub fn take(&mut self, place: Vec3<f64>) -> Vec<T> {
        let mut taken = Vec::new();
        for cell in self.around(place) {
            let Some(points) = self.cells.get_mut(&cell) else { continue };
            let near = |point: &mut (Vec3<f64>, T)| (point.0 - place).length() < self.reach;
            taken.extend(points.extract_if(.., near).map(|(_, item)| item));
        }
        taken
    }

    fn cell(&self, point: Vec3<f64>) -> [u64; 3] {
        // Adding zero turns -0 into +0.
        let cell = |x: f64| ((x / (SIDE * self.reach)).floor() + 0.0).to_bits();
        <[f64; 3]>::from(point).map(cell)
    }

    /// The cells within the reach of a place.
    fn around(&self, place: Vec3<f64>) -> impl Iterator<Item = [u64; 3]> + use<T> {
        let reach = Vec3::new(self.reach, self.reach, self.reach);
        let [low, high] = [place - reach, place + reach].map(|corner| self.cell(corner));
        let is_new = move |k: &usize| (0..3).all(|i| k >> i & 1 == 0 || low[i] != high[i]);
        let cell =
            move |k: usize| [0, 1, 2].map(|i| if k >> i & 1 == 0 { low[i] } else { high[i] });
        (0..8).filter(is_new).map(cell)
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
    fn cells_hold_all_points_within_their_reach() {
        // Multiples of it, whose neighbours on both sides are at the sides of cells.
        for reach in [0.1, 1.0 / 3.0, 1e-12] {
            let point = |k: i32| Vec3::new(reach * f64::from(k), -reach * f64::from(k), 0.0);
            let mut cells = Cells::new(reach);
            (-20..20).for_each(|k| cells.add(point(k), k));
            for k in -20..20 {
                let place = point(k) + Vec3::new(0.0, 0.0, 0.9 * reach);
                let near = cells.near(place).filter(|(_, distance)| *distance < reach);
                assert_eq!(near.map(|(item, _)| item).collect::<Vec<_>>(), [k], "{reach}");
            }
            assert_eq!((cells.take(point(3)), cells.take(point(3))), (vec![3], vec![]));
        }
    }

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
