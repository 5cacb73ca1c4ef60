//! The nodes: points of the surface at integer coordinates and, where the boundary is cut, the
//! points at which grid lines cross it, and its corners.

use super::fan::Fans;
use super::line::{
    GridPoint, across, directions_between, directions_left_of, is_grid_point, is_integral,
    orientation,
};
use crate::math::{Vec3, key_of_number, sort_by_number};
use crate::quads::grid_map::{GridMap, Side, Triangulation, UNIT};

/// Where a point lies on the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::quads) enum Place {
    /// At a vertex.
    Vertex(usize),
    /// Inside a side, which stands for its neighbour as well.
    Side(Side),
    /// Inside a triangle.
    Inside(usize),
}

/// A point where grid lines meet, or meet the boundary.
#[derive(Clone, Copy, Debug)]
pub(in crate::quads) struct Node {
    pub(in crate::quads) place: Place,
    /// In the unit of the surface, on its triangles.
    pub(in crate::quads) position: Vec3<f64>,
    /// Coordinates in the triangle of `place`, or in the first of the fan. A coordinate that is not
    /// integral, where a grid line crosses the boundary, is rounded.
    pub(in crate::quads) point: GridPoint,
    /// Whether it lies on the boundary of the surface.
    pub(in crate::quads) boundary: bool,
    /// Whether the boundary turns sharply here.
    pub(in crate::quads) corner: bool,
}

/// Cosine of the turn from which a vertex of a cut boundary is a corner of panels: 30 degrees.
const CORNER: f64 = 0.866;
/// The least number of nodes of a boundary loop.
const LEAST: usize = 3;

/// Finds all nodes: those at vertices, then inside sides, then inside triangles.
pub(super) fn nodes(surface: &Triangulation, map: &GridMap, fans: &Fans) -> Vec<Node> {
    let mut nodes = Vec::new();
    at_vertices(surface, map, fans, &mut nodes);
    for side in surface.sides() {
        if surface.across(side).is_none_or(|other| side < other) {
            inside_side(surface, map, side, &mut nodes);
        }
    }
    for triangle in 0..surface.triangles.len() {
        inside_triangle(surface, map, triangle, &mut nodes);
    }
    nodes
}

/// Whether a side lies on a boundary that cuts the grid.
pub(super) fn is_cut(surface: &Triangulation, side: Side) -> bool {
    surface.across(side).is_none() && !surface.is_feature(side)
}

fn at_vertices(surface: &Triangulation, map: &GridMap, fans: &Fans, nodes: &mut Vec<Node>) {
    let mut is_node: Vec<bool> = vec![false; surface.positions.len()];
    let mut corner = is_node.clone();
    for v in 0..surface.positions.len() {
        let fan = fans.of_vertex(v);
        let Some(first) = fan.first() else { continue };
        is_node[v] = is_grid_point(map.corners[first.triangle][first.side]);
        if !fans.is_closed(v) && is_cut(surface, *first) {
            corner[v] = turns(surface, fan);
            is_node[v] |= corner[v] || fan.iter().any(|&at| leaves_at(map, at));
        }
    }
    for chain in cut_loops(surface, fans) {
        let count = chain.iter().filter(|&&v| is_node[v]).count();
        if count < LEAST {
            (0..LEAST).for_each(|k| is_node[chain[k * chain.len() / LEAST]] = true);
        }
    }
    for v in (0..surface.positions.len()).filter(|&v| is_node[v]) {
        let first = fans.of_vertex(v)[0];
        nodes.push(Node {
            place: Place::Vertex(v),
            position: surface.positions[v],
            point: map.corners[first.triangle][first.side],
            boundary: !fans.is_closed(v),
            corner: corner[v],
        });
    }
}

/// Whether a grid line ends at this corner from within its triangle.
fn leaves_at(map: &GridMap, Side { triangle, side }: Side) -> bool {
    let corners = map.corners[triangle];
    let at = corners[side];
    let [a, b] = [1, 2].map(|k| minus(corners[(side + k) % 3], at));
    let mut inside = directions_between(a, b, [true, false]);
    map.doubled_area(triangle) > 0 && inside.any(|d| is_integral(at[across(d)]))
}

/// Whether the boundary turns by more than [`CORNER`] at the vertex of an open fan.
fn turns(surface: &Triangulation, fan: &[Side]) -> bool {
    let [first, last] = [fan[0], fan[fan.len() - 1]];
    let after = surface.along(first);
    let before = surface.along(Side { triangle: last.triangle, side: (last.side + 2) % 3 });
    before.dot(after) < CORNER * before.length() * after.length()
}

/// The vertices of each boundary loop that cuts the grid, with the surface on the left.
fn cut_loops(surface: &Triangulation, fans: &Fans) -> Vec<Vec<usize>> {
    let mut seen = vec![false; surface.positions.len()];
    let mut loops = Vec::new();
    for side in surface.sides().filter(|&side| is_cut(surface, side)) {
        let mut at = surface.corner(side.triangle, side.side);
        let mut chain = Vec::new();
        while !seen[at] {
            seen[at] = true;
            chain.push(at);
            let first = fans.of_vertex(at)[0];
            at = surface.corner(first.triangle, first.side + 1);
        }
        if !chain.is_empty() {
            loops.push(chain);
        }
    }
    loops
}

/// Adds the grid points strictly inside a side; where it cuts the grid, all crossings of grid lines,
/// in their order along it.
fn inside_side(surface: &Triangulation, map: &GridMap, side: Side, nodes: &mut Vec<Node>) {
    let corners = map.corners[side.triangle];
    let (a, b) = (corners[side.side], corners[(side.side + 1) % 3]);
    let along = minus(b, a);
    let is_boundary = surface.across(side).is_none();
    let start = surface.at(side.triangle, side.side);
    let mut add = |point: GridPoint, share: f64| {
        nodes.push(Node {
            place: Place::Side(side),
            position: start + surface.along(side) * share,
            point,
            boundary: is_boundary,
            corner: false,
        });
    };
    if is_cut(surface, side) {
        let mut found: Vec<(f64, GridPoint)> = Vec::new();
        for axis in [0, 1] {
            for value in multiples_between(a[axis], b[axis]) {
                let (point, share) = on_side(a, along, axis, value);
                let is_new = !is_grid_point(point) || axis == 0 || along[0] == 0;
                if point[axis] == value && is_new && has_line(along, axis) {
                    found.push((share, point));
                }
            }
        }
        sort_by_number(&mut found, |(share, _)| key_of_number(*share));
        found.into_iter().for_each(|(share, point)| add(point, share));
        return;
    }
    // Over the longer extent: no two points have the same coordinate there.
    let axis = usize::from(along[1].abs() > along[0].abs());
    let mut found: Vec<(f64, GridPoint)> = multiples_between(a[axis], b[axis])
        .filter_map(|value| {
            let other = 1 - axis;
            let product = i128::from(value - a[axis]) * i128::from(along[other]);
            let exact = product % i128::from(along[axis]) == 0;
            let (point, share) = on_side(a, along, axis, value);
            (exact && is_grid_point(point)).then_some((share, point))
        })
        .collect();
    sort_by_number(&mut found, |(share, _)| key_of_number(*share));
    found.into_iter().for_each(|(share, point)| add(point, share));
}

/// Whether the grid line on which coordinate `axis` is constant crosses a side of this direction to
/// its left, so that a line begins there.
fn has_line(along: GridPoint, axis: usize) -> bool {
    directions_left_of(along, [false, false]).any(|d| across(d) == axis)
}

/// The point of a side at which coordinate `axis` has a value, the other coordinate rounded down,
/// and its share of the side.
fn on_side(a: GridPoint, along: GridPoint, axis: usize, value: i64) -> (GridPoint, f64) {
    let other = 1 - axis;
    // Euclidean division rounds down by a positive divisor only.
    let sign = i128::from(along[axis].signum());
    let product = sign * i128::from(value - a[axis]) * i128::from(along[other]);
    let divisor = sign * i128::from(along[axis]);
    let quotient = product.div_euclid(divisor);
    let mut point = [value; 2];
    point[other] = a[other] + i64::try_from(quotient).expect("it lies between the ends");
    // A rounded coordinate must not look integral.
    if product % divisor != 0 && is_integral(point[other]) {
        point[other] += 1;
    }
    (point, (value - a[axis]) as f64 / along[axis] as f64)
}

/// The multiples of [`UNIT`] strictly between two numbers, ascending.
fn multiples_between(a: i64, b: i64) -> impl Iterator<Item = i64> {
    let (low, high) = (a.min(b), a.max(b));
    let first = low.div_euclid(UNIT) + 1;
    let last = (high - 1).div_euclid(UNIT);
    (first..=last).map(|k| k * UNIT)
}

/// Adds the grid points strictly inside a triangle that is not flipped.
fn inside_triangle(surface: &Triangulation, map: &GridMap, triangle: usize, nodes: &mut Vec<Node>) {
    let area = map.doubled_area(triangle);
    if area <= 0 {
        return;
    }
    let corners = map.corners[triangle];
    let [u, v] = [0, 1].map(|axis| {
        let values = corners.map(|corner| corner[axis]);
        let least = values.iter().copied().fold(i64::MAX, i64::min);
        let most = values.iter().copied().fold(i64::MIN, i64::max);
        (least, most)
    });
    for x in multiples_between(u.0, u.1) {
        for y in multiples_between(v.0, v.1) {
            let opposite =
                |k: usize| orientation(corners[(k + 1) % 3], corners[(k + 2) % 3], [x, y]);
            let weights = [0, 1, 2].map(opposite);
            if weights.iter().all(|&weight| weight > 0) {
                let share = |k: usize| surface.at(triangle, k) * (weights[k] as f64 / area as f64);
                nodes.push(Node {
                    place: Place::Inside(triangle),
                    position: share(0) + share(1) + share(2),
                    point: [x, y],
                    boundary: false,
                    corner: false,
                });
            }
        }
    }
}

/// The vector from `b` to `a`.
pub(super) fn minus(a: GridPoint, b: GridPoint) -> GridPoint {
    [a[0] - b[0], a[1] - b[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crossing_is_the_same_point_from_both_ends_of_its_side() {
        // Where a side ran backwards it was rounded up.
        let (a, b) = ([3, -5], [7 * UNIT + 1, 3 * UNIT + 2]);
        let along = |from: GridPoint, to: GridPoint| [to[0] - from[0], to[1] - from[1]];
        for axis in [0, 1] {
            for value in multiples_between(a[axis], b[axis]) {
                let (forth, share) = on_side(a, along(a, b), axis, value);
                let (back, rest) = on_side(b, along(b, a), axis, value);
                assert_eq!(forth, back);
                assert!((share + rest - 1.0).abs() < 1e-12);
            }
        }
    }
}
