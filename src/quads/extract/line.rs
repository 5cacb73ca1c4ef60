//! Directions of the grid, and the side of a grid line on which a point lies.

use crate::quads::grid_map::{Transition, UNIT};

/// A direction of the grid, as quarter turns from +u.
pub(super) type Direction = u8;

/// A point of the map in fixed point.
pub(super) type GridPoint = [i64; 2];

/// The four directions: +u, +v, -u, -v.
pub(super) const STEPS: [GridPoint; 4] = [[UNIT, 0], [0, UNIT], [-UNIT, 0], [0, -UNIT]];

/// The direction after a transition.
pub(super) fn turned(direction: Direction, transition: Transition) -> Direction {
    (direction + transition.quarter_turns) % 4
}

/// The opposite direction.
pub(super) fn opposite(direction: Direction) -> Direction {
    (direction + 2) % 4
}

/// The coordinate that is constant along a line in a direction: 0 for u, 1 for v.
pub(super) fn across(direction: Direction) -> usize {
    usize::from(direction.is_multiple_of(2))
}

/// The neighbouring grid point in a direction.
pub(super) fn step(point: GridPoint, direction: Direction) -> GridPoint {
    let [x, y] = STEPS[direction as usize];
    [point[0] + x, point[1] + y]
}

/// Whether both coordinates are integral.
pub(super) fn is_grid_point(point: GridPoint) -> bool {
    is_integral(point[0]) && is_integral(point[1])
}

/// Whether a coordinate is integral.
pub(super) fn is_integral(coordinate: i64) -> bool {
    coordinate % UNIT == 0
}

/// Positive if `c` lies to the left of the line from `a` to `b`, negative to its right: twice the
/// area of the triangle.
pub(super) fn orientation(a: GridPoint, b: GridPoint, c: GridPoint) -> i128 {
    cross([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]])
}

/// The determinant of two vectors.
pub(super) fn cross(a: GridPoint, b: GridPoint) -> i128 {
    i128::from(a[0]) * i128::from(b[1]) - i128::from(a[1]) * i128::from(b[0])
}

/// Distance of `point` to the left of the grid line through `on` in a direction.
pub(super) fn left_of(on: GridPoint, direction: Direction, point: GridPoint) -> i64 {
    match direction {
        0 => point[1] - on[1],
        1 => on[0] - point[0],
        2 => on[1] - point[1],
        _ => point[0] - on[0],
    }
}

/// The directions, counterclockwise, that lie in the wedge from `a` counterclockwise to `b`, of less
/// than half a turn: with those along `a` and along `b` if so asked.
pub(super) fn directions_between(
    a: GridPoint,
    b: GridPoint,
    [with_a, with_b]: [bool; 2],
) -> impl Iterator<Item = Direction> {
    let inside = move |direction: &Direction| {
        let step = STEPS[*direction as usize];
        let (after_a, before_b) = (cross(a, step), cross(step, b));
        let along = |v: GridPoint| {
            i128::from(v[0]) * i128::from(step[0]) + i128::from(v[1]) * i128::from(step[1]) > 0
        };
        let on_a = after_a == 0 && along(a);
        let on_b = before_b == 0 && along(b);
        if on_a {
            with_a
        } else if on_b {
            with_b
        } else {
            after_a > 0 && before_b > 0
        }
    };
    in_order(inside)
}

/// The directions, counterclockwise, that point to the left of a vector; with those along it and
/// against it if so asked.
pub(super) fn directions_left_of(
    a: GridPoint,
    [with_along, with_against]: [bool; 2],
) -> impl Iterator<Item = Direction> {
    let inside = move |direction: &Direction| {
        let step = STEPS[*direction as usize];
        let along = i128::from(a[0]) * i128::from(step[0]) + i128::from(a[1]) * i128::from(step[1]);
        match cross(a, step) {
            0 if along > 0 => with_along,
            0 => with_against,
            left => left > 0,
        }
    };
    in_order(inside)
}

/// The directions that fulfil a condition, counterclockwise from the one whose predecessor does not.
fn in_order(inside: impl Fn(&Direction) -> bool) -> impl Iterator<Item = Direction> {
    let first = (0..4).find(|d| inside(d) && !inside(&((d + 3) % 4))).unwrap_or(0);
    (first..first + 4).map(|d| d % 4).filter(inside)
}
