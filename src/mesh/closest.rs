//! The closest point `c(v)` on the reference surface (paper section 4, Eq. 11).
//!
//! A bounding-volume tree over triangles, two children to a node, tested side by side in lanes. It
//! is searched for every vertex in every iteration, so a search starts from what the last one of
//! that vertex found: the last closest triangle bounds the distance, and where that bound is short
//! against the triangle, only the part of the tree that holds the triangle's surroundings is
//! searched. Both are exact: nothing is left out that could be nearer.

use super::triangle::{Hit, Triangle};
use super::{Mesh, Point};
use crate::math::{Lane, Lanes, Vec3};

/// Triangles in a leaf, at most.
const LEAF: usize = 4;

/// How far the surroundings of a triangle reach, relative to the diagonal of its box.
const REACH: f64 = 0.5;

/// A surface that answers which of its points is closest.
#[derive(Clone, Debug)]
pub struct Surface {
    /// In the order of the leaves, so that neighbours in space are neighbours in memory.
    triangles: Vec<Triangle>,
    /// For each triangle, where a search near it starts.
    starts: Vec<Start>,
    /// The root first.
    nodes: Vec<Node>,
}

/// A node that holds everything within some distance of a triangle.
#[derive(Clone, Copy, Debug)]
struct Start {
    node: u32,
    /// Square of half that distance: a point nearer to the triangle than this has its closest point
    /// within that distance of the triangle.
    distance_squared: f64,
}

/// The boxes of two children, one in each lane, and where the children are.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Node {
    low: Vec3<Lanes>,
    high: Vec3<Lanes>,
    children: [Child; 2],
}

/// A range of triangles, or a node where `count` is [`Child::NODE`].
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    first: u32,
    count: u32,
}

impl Child {
    const NODE: u32 = u32::MAX;

    fn node(index: u32) -> Child {
        Child { first: index, count: Child::NODE }
    }

    fn is_node(self) -> bool {
        self.count == Child::NODE
    }
}

impl Surface {
    /// No triangle is known yet: the value that `warm` starts from.
    pub const COLD: u32 = u32::MAX;

    /// The surface of `mesh` at `positions` (`#V by 3`): its faces, triangulated as fans
    /// `(f0, fk, fk+1)`; without faces the segments of its curves; without either its vertices.
    pub fn new(positions: &[Point], mesh: &Mesh) -> Surface {
        let at = |v: &u32| positions[*v as usize];
        let mut corners: Vec<[Point; 3]> = Vec::new();
        for face in mesh.faces.iter() {
            for side in face[1..].windows(2) {
                let [a, b, c] = [at(&face[0]), at(&side[0]), at(&side[1])];
                if Triangle::is_sliver([a, b, c]) {
                    corners.extend([[a, b, b], [b, c, c], [c, a, a]]);
                } else {
                    corners.push([a, b, c]);
                }
            }
        }
        if mesh.faces.is_empty() {
            let segments = mesh.curves.iter().flat_map(|curve| curve.windows(2));
            corners.extend(segments.map(|ends| [at(&ends[0]), at(&ends[1]), at(&ends[1])]));
        }
        if corners.is_empty() {
            corners.extend(positions.iter().map(|&p| [p; 3]));
        }
        Surface::of_triangles(&corners)
    }

    fn of_triangles(corners: &[[Point; 3]]) -> Surface {
        let boxes: Vec<Box3> = corners.iter().map(Box3::of).collect();
        let mut order: Vec<u32> = (0..corners.len() as u32).collect();
        let mut nodes = Vec::new();
        if !order.is_empty() {
            build(&mut nodes, &boxes, &mut order, 0);
        }
        let triangles: Vec<Triangle> =
            order.iter().map(|&t| Triangle::new(corners[t as usize])).collect();
        let boxes: Vec<Box3> = order.iter().map(|&t| boxes[t as usize]).collect();
        let starts = boxes.iter().zip(0..).map(|(own, t)| start(&nodes, &boxes, own, t)).collect();
        Surface { triangles, starts, nodes }
    }

    /// The point of the surface that is closest to `p`; `p` itself when the surface is empty.
    /// `warm` is what the last search for this point left, or [`Surface::COLD`]: the better it
    /// fits, the faster the search. It does not matter for the distance that is found.
    pub fn closest(&self, p: Point, warm: &mut u32) -> Point {
        let p = Vec3::from(p);
        let mut best = Hit { point: p, distance_squared: f64::INFINITY };
        let mut from = 0;
        if let Some(triangle) = self.triangles.get(*warm as usize) {
            if let Some(hit) = triangle.closest(p, f64::INFINITY) {
                best = hit;
            }
            let start = self.starts[*warm as usize];
            if best.distance_squared <= start.distance_squared {
                from = start.node;
            }
        }
        if !self.nodes.is_empty() {
            self.search(p, from, &mut best, warm);
        }
        best.point.into()
    }

    fn search(&self, p: Vec3<f64>, from: u32, best: &mut Hit, warm: &mut u32) {
        // Halving a u32 range gives at most 32 levels, and each leaves at most one sibling behind.
        let mut stack = [(0.0, Child::default()); 33];
        let mut waiting = 0;
        let lanes = Vec3::new(Lanes::splat(p.x), Lanes::splat(p.y), Lanes::splat(p.z));
        let mut child = Child::node(from);
        loop {
            if child.is_node() {
                let node = &self.nodes[child.first as usize];
                let [left, right] = node.distances_squared(lanes).0;
                let [near, far] = node.children;
                let (near, near_at, far, far_at) =
                    if left <= right { (near, left, far, right) } else { (far, right, near, left) };
                if far_at < best.distance_squared {
                    stack[waiting] = (far_at, far);
                    waiting += 1;
                }
                if near_at < best.distance_squared {
                    child = near;
                    continue;
                }
            } else {
                let first = child.first as usize;
                for t in first..first + child.count as usize {
                    if let Some(hit) = self.triangles[t].closest(p, best.distance_squared) {
                        *best = hit;
                        *warm = t as u32;
                    }
                }
            }
            loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                if stack[waiting].0 < best.distance_squared {
                    child = stack[waiting].1;
                    break;
                }
            }
        }
    }
}

impl Node {
    /// Squared distances of a point (the same in both lanes) to the boxes of the two children.
    #[inline(always)]
    fn distances_squared(&self, p: Vec3<Lanes>) -> Lanes {
        let out = |low: Lanes, p: Lanes, high: Lanes| (low - p).max(p - high).max(Lanes::zero());
        let x = out(self.low.x, p.x, self.high.x);
        let y = out(self.low.y, p.y, self.high.y);
        let z = out(self.low.z, p.z, self.high.z);
        x * x + y * y + z * z
    }

    /// The box of one child.
    fn child_box(&self, side: usize) -> Box3 {
        Box3 { low: self.low.lane(side).into(), high: self.high.lane(side).into() }
    }
}

/// An axis-aligned box.
#[derive(Clone, Copy, Debug)]
struct Box3 {
    low: Point,
    high: Point,
}

impl Box3 {
    /// Holds nothing, and is at an infinite distance from everything.
    const EMPTY: Box3 = Box3 { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    fn of(points: &[Point; 3]) -> Box3 {
        points.iter().fold(Box3::EMPTY, |b, &p| b.union(&Box3 { low: p, high: p }))
    }

    fn union(&self, other: &Box3) -> Box3 {
        Box3 {
            low: std::array::from_fn(|k| Lane::min(self.low[k], other.low[k])),
            high: std::array::from_fn(|k| Lane::max(self.high[k], other.high[k])),
        }
    }

    fn meets(&self, other: &Box3) -> bool {
        (0..3).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    fn diagonal(&self) -> f64 {
        (Vec3::from(self.high) - Vec3::from(self.low)).length()
    }

    fn grown(&self, by: f64) -> Box3 {
        Box3 { low: self.low.map(|x| x - by), high: self.high.map(|x| x + by) }
    }

    /// Twice the centre along one axis.
    fn middle(&self, axis: usize) -> f64 {
        self.low[axis] + self.high[axis]
    }
}

/// Makes the node over the triangles of `order`, which are to become those from `first` on, and
/// returns its index. The triangles are halved by the middles of their boxes along the axis in
/// which these spread most.
fn build(nodes: &mut Vec<Node>, boxes: &[Box3], order: &mut [u32], first: u32) -> u32 {
    let middles = order.iter().fold(Box3::EMPTY, |all, &t| {
        let middle = std::array::from_fn(|k| boxes[t as usize].middle(k));
        all.union(&Box3 { low: middle, high: middle })
    });
    let spread: [f64; 3] = std::array::from_fn(|k| middles.high[k] - middles.low[k]);
    let axis = (1..3).fold(0, |widest, k| if spread[k] > spread[widest] { k } else { widest });
    let half = order.len() / 2;
    if half > 0 {
        order.select_nth_unstable_by(half, |&s, &t| {
            let at = |t: u32| boxes[t as usize].middle(axis);
            at(s).total_cmp(&at(t)).then(s.cmp(&t))
        });
    }
    let place = nodes.len();
    let nothing = Vec3::new(Lanes::zero(), Lanes::zero(), Lanes::zero());
    nodes.push(Node { low: nothing, high: nothing, children: [Child::default(); 2] });
    let (left, right) = order.split_at_mut(half);
    for (side, (part, first)) in
        [(left, first), (right, first + half as u32)].into_iter().enumerate()
    {
        let around = part.iter().fold(Box3::EMPTY, |all, &t| all.union(&boxes[t as usize]));
        let child = if part.len() <= LEAF {
            Child { first, count: part.len() as u32 }
        } else {
            Child::node(build(nodes, boxes, part, first))
        };
        let node = &mut nodes[place];
        node.low.set_lane(side, around.low.into());
        node.high.set_lane(side, around.high.into());
        node.children[side] = child;
    }
    place as u32
}

/// The lowest node that holds every triangle whose box meets the surroundings of triangle `t`.
fn start(nodes: &[Node], boxes: &[Box3], own: &Box3, t: u32) -> Start {
    let reach = REACH * own.diagonal();
    // A little more than the reach, so that rounding in the search cannot matter.
    let around = own.grown(reach * (1.0 + 1e-9));
    let mut node = 0;
    loop {
        let meets = [0, 1].map(|side| child_meets(nodes, boxes, node, side, &around));
        match meets {
            [true, false] if nodes[node].children[0].is_node() => {
                node = nodes[node].children[0].first as usize;
            }
            [false, true] if nodes[node].children[1].is_node() => {
                node = nodes[node].children[1].first as usize;
            }
            _ => break,
        }
    }
    debug_assert!((t as usize) < boxes.len());
    Start { node: node as u32, distance_squared: 0.25 * reach * reach }
}

/// Whether the box of any triangle below a child meets a box.
fn child_meets(nodes: &[Node], boxes: &[Box3], node: usize, side: usize, around: &Box3) -> bool {
    if !nodes[node].child_box(side).meets(around) {
        return false;
    }
    let child @ Child { first, count } = nodes[node].children[side];
    if child.is_node() {
        let below = first as usize;
        child_meets(nodes, boxes, below, 0, around) || child_meets(nodes, boxes, below, 1, around)
    } else {
        boxes[first as usize..(first + count) as usize].iter().any(|b| b.meets(around))
    }
}
