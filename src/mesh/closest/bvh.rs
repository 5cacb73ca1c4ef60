//! Binary bounding volume hierarchy over boxes; both children of a node are tested at once.

use crate::math::{Lane, Pair, Vec3};
use crate::mesh::Point;
use std::ops::Range;

/// Maximum number of boxes in a leaf.
const LEAF: usize = 4;

/// Size of the traversal stack: halving 2^32 boxes takes 32 levels, and each leaves one child on
/// the stack.
const DEPTH: usize = 33;

/// The hierarchy. Its leaves are ranges of the order that [`Bvh::new`] returns.
#[derive(Clone, Debug)]
pub(crate) struct Bvh {
    /// The root is first; empty without boxes.
    nodes: Vec<Node>,
}

/// The boxes of two children, one per lane, and references to the children.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Node {
    low: Vec3<Pair>,
    high: Vec3<Pair>,
    children: [Child; 2],
}

/// A leaf, as a range of boxes, or, if `count` is [`Child::NODE`], the index of a node.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    first: u32,
    count: u32,
}

impl Child {
    const NODE: u32 = u32::MAX;

    fn node(index: usize) -> Child {
        Child { first: index as u32, count: Child::NODE }
    }

    fn is_node(self) -> bool {
        self.count == Child::NODE
    }

    fn range(self) -> Range<usize> {
        self.first as usize..(self.first + self.count) as usize
    }
}

impl Bvh {
    /// Builds the hierarchy and returns it with the order of the boxes in its leaves, in which
    /// neighbours in space are close to each other.
    pub(crate) fn new(boxes: &[Box3]) -> (Bvh, Vec<u32>) {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        let mut bvh = Bvh { nodes: Vec::new() };
        if !boxes.is_empty() {
            bvh.build(boxes, &mut order, 0);
        }
        (bvh, order)
    }

    /// Builds the node over the boxes of `order`, whose final indices begin at `first`, and halves
    /// them by their centres along the axis in which these spread most.
    fn build(&mut self, boxes: &[Box3], order: &mut [u32], first: u32) -> Child {
        let middles = order.iter().fold(Box3::EMPTY, |all, &b| {
            let middle = std::array::from_fn(|axis| boxes[b as usize].middle(axis));
            all.union(&Box3::around(&[middle]))
        });
        let spread: [f64; 3] = std::array::from_fn(|axis| middles.high[axis] - middles.low[axis]);
        let axis = (1..3).fold(0, |widest, k| if spread[k] > spread[widest] { k } else { widest });
        let half = order.len() / 2;
        order.select_nth_unstable_by(half, |&a, &b| {
            let at = |b: u32| boxes[b as usize].middle(axis);
            at(a).total_cmp(&at(b)).then(a.cmp(&b))
        });
        let place = self.nodes.len();
        let corner = Vec3::new(Pair::zero(), Pair::zero(), Pair::zero());
        self.nodes.push(Node { low: corner, high: corner, children: [Child::default(); 2] });
        let (left, right) = order.split_at_mut(half);
        for (side, (part, first)) in
            [(left, first), (right, first + half as u32)].into_iter().enumerate()
        {
            let around = part.iter().fold(Box3::EMPTY, |all, &b| all.union(&boxes[b as usize]));
            let child = if part.len() <= LEAF {
                Child { first, count: part.len() as u32 }
            } else {
                self.build(boxes, part, first)
            };
            let node = &mut self.nodes[place];
            node.low.set_lane(side, around.low.into());
            node.high.set_lane(side, around.high.into());
            node.children[side] = child;
        }
        Child::node(place)
    }

    /// Visits the leaves whose boxes are nearer to `p` (the same point in both lanes) than the
    /// square root of `bound`, at each node the nearer child first. A visit returns the new bound.
    #[inline(always)]
    pub(crate) fn search(
        &self,
        p: Vec3<Pair>,
        mut bound: f64,
        mut visit: impl FnMut(Range<usize>, f64) -> f64,
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let mut stack = [(0.0, Child::default()); DEPTH];
        let mut waiting = 0;
        let mut child = Child::node(0);
        loop {
            if child.is_node() {
                let node = &self.nodes[child.first as usize];
                let distances = node.distances_squared(p);
                let [left, right] = [distances.lane(0), distances.lane(1)];
                let [(near, near_at), (far, far_at)] = if left <= right {
                    [(node.children[0], left), (node.children[1], right)]
                } else {
                    [(node.children[1], right), (node.children[0], left)]
                };
                if far_at < bound {
                    stack[waiting] = (far_at, far);
                    waiting += 1;
                }
                if near_at < bound {
                    child = near;
                    continue;
                }
            } else {
                bound = visit(child.range(), bound);
            }
            loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                if stack[waiting].0 < bound {
                    child = stack[waiting].1;
                    break;
                }
            }
        }
    }

    /// Visits the leaves whose boxes intersect `around`, until a visit returns false.
    pub(crate) fn meeting(&self, around: &Box3, mut visit: impl FnMut(Range<usize>) -> bool) {
        if self.nodes.is_empty() {
            return;
        }
        let mut stack = [Child::default(); DEPTH];
        let mut waiting = 1;
        stack[0] = Child::node(0);
        while waiting > 0 {
            waiting -= 1;
            let child = stack[waiting];
            if child.is_node() {
                let node = &self.nodes[child.first as usize];
                for side in 0..2 {
                    if node.child_box(side).meets(around) {
                        stack[waiting] = node.children[side];
                        waiting += 1;
                    }
                }
            } else if !visit(child.range()) {
                return;
            }
        }
    }
}

impl Node {
    /// Returns the squared distances of a point (the same in both lanes) to the two child boxes.
    #[inline(always)]
    fn distances_squared(&self, p: Vec3<Pair>) -> Pair {
        // At most one of the two differences is positive. `max` is avoided: in wasm it is a branch.
        let positive = |x: Pair| (x + x.abs()) * Pair::splat(0.5);
        let out = |low: Pair, p: Pair, high: Pair| positive(low - p) + positive(p - high);
        let x = out(self.low.x, p.x, self.high.x);
        let y = out(self.low.y, p.y, self.high.y);
        let z = out(self.low.z, p.z, self.high.z);
        x * x + y * y + z * z
    }

    fn child_box(&self, side: usize) -> Box3 {
        Box3 { low: self.low.lane(side).into(), high: self.high.lane(side).into() }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Box3 {
    low: Point,
    high: Point,
}

impl Box3 {
    /// The empty box, at infinite distance from every point.
    const EMPTY: Box3 = Box3 { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    pub(crate) fn around(points: &[Point]) -> Box3 {
        points.iter().fold(Box3::EMPTY, |b, &p| b.union(&Box3 { low: p, high: p }))
    }

    fn union(&self, other: &Box3) -> Box3 {
        Box3 {
            low: std::array::from_fn(|k| Lane::min(self.low[k], other.low[k])),
            high: std::array::from_fn(|k| Lane::max(self.high[k], other.high[k])),
        }
    }

    pub(crate) fn meets(&self, other: &Box3) -> bool {
        (0..3).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    /// Returns the centre; the origin for an empty box.
    pub(crate) fn centre(&self) -> Vec3<f64> {
        let middle = |k: usize| self.low[k] + 0.5 * (self.high[k] - self.low[k]);
        if self.low[0] <= self.high[0] { [0, 1, 2].map(middle).into() } else { Vec3::zero() }
    }

    pub(crate) fn diagonal(&self) -> f64 {
        (Vec3::from(self.high) - Vec3::from(self.low)).length()
    }

    /// Returns the box extended by a margin on all sides.
    pub(crate) fn grown(&self, by: f64) -> Box3 {
        Box3 { low: self.low.map(|x| x - by), high: self.high.map(|x| x + by) }
    }

    /// Returns twice the coordinate of the centre along one axis.
    fn middle(&self, axis: usize) -> f64 {
        self.low[axis] + self.high[axis]
    }
}
