//! Subdivision of triangles until edges are shorter than a panel, and until features are apart.

use super::edges::Edges;
use crate::math::Vec3;
use crate::mesh::Tensor;
use crate::quads::Side;

/// What a side of a triangle lies on. The order is that of precedence.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Line {
    /// No feature.
    #[default]
    None,
    /// A crease inside the surface.
    Crease,
    /// The boundary.
    Boundary,
}

/// Triangles that are being refined, with what is interpolated in new vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Refined {
    pub positions: Vec<Vec3<f64>>,
    pub tensors: Vec<Tensor>,
    pub vertices: Vec<Option<u32>>,
    pub triangles: Vec<[usize; 3]>,
    /// `#T by 3`: what each side lies on.
    pub lines: Vec<[Line; 3]>,
}

/// A safeguard: each round halves the longest edges.
const MOST_ROUNDS: usize = 40;

impl Refined {
    /// Splits all edges longer than `longest`.
    pub(super) fn split_long(&mut self, longest: f64) {
        for _ in 0..MOST_ROUNDS {
            let edges = Edges::new(&self.triangles);
            let long = |&[a, b]: &[usize; 2]| {
                (self.positions[a] - self.positions[b]).length_squared() > longest * longest
            };
            let split: Vec<bool> = edges.ends.iter().map(long).collect();
            if !split.contains(&true) {
                return;
            }
            let middles = self.middles(&edges, &split);
            self.replace(|refined, t, new| {
                let middle = edges.of_side[t].map(|e| middles[e]);
                refined.split_triangle(t, middle, new);
            });
        }
    }

    /// Separates features: afterwards no triangle has two sides on a feature, and no edge off
    /// the features joins two vertices on them. `on_feature` says which lines are features.
    pub(super) fn separate(&mut self, on_feature: impl Fn(Line) -> bool) {
        let edges = Edges::new(&self.triangles);
        let mut touches = vec![false; self.positions.len()];
        let mut is_feature = vec![false; edges.ends.len()];
        for (e, sides) in edges.sides.iter().enumerate() {
            let Side { triangle, side } = sides[0];
            if on_feature(self.lines[triangle][side]) {
                is_feature[e] = true;
                edges.ends[e].iter().for_each(|&v| touches[v] = true);
            }
        }
        let joins =
            |(&[a, b], &feature): (&[usize; 2], &bool)| !feature && touches[a] && touches[b];
        let split: Vec<bool> = edges.ends.iter().zip(&is_feature).map(joins).collect();
        let middles = self.middles(&edges, &split);
        self.replace(|refined, t, new| {
            let sides = edges.of_side[t];
            let middle = sides.map(|e| middles[e]);
            let features = sides.iter().filter(|&&e| is_feature[e]).count();
            if features >= 2 || middle.iter().any(Option::is_some) {
                refined.split_around_centre(t, middle, new);
            } else {
                new.keep(refined, t);
            }
        });
    }

    /// Adds the middles of the edges to be split.
    fn middles(&mut self, edges: &Edges, split: &[bool]) -> Vec<Option<usize>> {
        let middle = |(ends, &split): (&[usize; 2], &bool)| split.then(|| self.add_mean(ends));
        edges.ends.iter().zip(split).map(middle).collect()
    }

    /// Adds a vertex at the mean of others.
    fn add_mean(&mut self, of: &[usize]) -> usize {
        let share = 1.0 / of.len() as f64;
        let (mut position, mut tensor) = (Vec3::zero(), [0.0; 6]);
        for &v in of {
            position += self.positions[v];
            tensor.iter_mut().zip(self.tensors[v]).for_each(|(sum, part)| *sum += part);
        }
        self.positions.push(position * share);
        self.tensors.push(tensor.map(|sum| sum * share));
        self.vertices.push(None);
        self.positions.len() - 1
    }

    /// Replaces each triangle by those that `split` adds.
    fn replace(&mut self, mut split: impl FnMut(&mut Refined, usize, &mut Pieces)) {
        let mut new = Pieces::default();
        for t in 0..self.triangles.len() {
            split(self, t, &mut new);
        }
        (self.triangles, self.lines) = (new.triangles, new.lines);
    }

    /// Splits a triangle into two, three or four.
    fn split_triangle(&self, t: usize, middle: [Option<usize>; 3], new: &mut Pieces) {
        // Turned so that the pattern begins at side `first`.
        let pattern = middle.map(|middle| middle.is_some());
        let first = match pattern {
            [false, false, false]
            | [true, true, true]
            | [true, false, false]
            | [false, true, true] => 0,
            [false, true, false] | [true, false, true] => 1,
            [false, false, true] | [true, true, false] => 2,
        };
        let turned = |k: usize| (first + k) % 3;
        let [a, b, c] = [0, 1, 2].map(|k| self.triangles[t][turned(k)]);
        let [ab, bc, ca] = [0, 1, 2].map(|k| self.lines[t][turned(k)]);
        let none = Line::None;
        let mut add = |corners, lines| new.add(corners, lines);
        match [0, 1, 2].map(|k| middle[turned(k)]) {
            [Some(mab), Some(mbc), Some(mca)] => {
                add([a, mab, mca], [ab, none, ca]);
                add([mab, b, mbc], [ab, bc, none]);
                add([mca, mbc, c], [none, bc, ca]);
                add([mab, mbc, mca], [none; 3]);
            }
            [Some(mab), None, None] => {
                add([a, mab, c], [ab, none, ca]);
                add([mab, b, c], [ab, bc, none]);
            }
            [None, Some(mbc), Some(mca)] => {
                add([mca, mbc, c], [none, bc, ca]);
                let length =
                    |p: usize, q: usize| (self.positions[p] - self.positions[q]).length_squared();
                if length(a, mbc) < length(b, mca) {
                    add([a, b, mbc], [ab, bc, none]);
                    add([a, mbc, mca], [none, none, ca]);
                } else {
                    add([a, b, mca], [ab, none, ca]);
                    add([b, mbc, mca], [bc, none, none]);
                }
            }
            _ => new.keep(self, t),
        }
    }

    /// Splits a triangle around its centre, and each side in two that has a middle.
    fn split_around_centre(&mut self, t: usize, middle: [Option<usize>; 3], new: &mut Pieces) {
        let corners = self.triangles[t];
        let centre = self.add_mean(&corners);
        for k in 0..3 {
            let (a, b, line) = (corners[k], corners[(k + 1) % 3], self.lines[t][k]);
            let none = Line::None;
            match middle[k] {
                None => new.add([a, b, centre], [line, none, none]),
                Some(m) => {
                    new.add([a, m, centre], [line, none, none]);
                    new.add([m, b, centre], [line, none, none]);
                }
            }
        }
    }
}

/// The triangles after a round.
#[derive(Default)]
struct Pieces {
    triangles: Vec<[usize; 3]>,
    lines: Vec<[Line; 3]>,
}

impl Pieces {
    fn add(&mut self, corners: [usize; 3], lines: [Line; 3]) {
        self.triangles.push(corners);
        self.lines.push(lines);
    }

    fn keep(&mut self, refined: &Refined, t: usize) {
        self.add(refined.triangles[t], refined.lines[t]);
    }
}
