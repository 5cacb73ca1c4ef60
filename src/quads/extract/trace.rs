//! The walk along a grid line from a node to the next one.

use super::line::{
    Direction, GridPoint, across, cross, left_of, opposite, orientation, step, turned,
};
use super::nodes::minus;
use crate::quads::grid_map::{GridMap, Side, Triangulation, UNIT};

/// The side to which the line is thought to be shifted by less than any distance, so that it meets
/// no vertex. Lines along a boundary need the side on which the surface is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shift {
    Left,
    Right,
}

/// How a walk ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival {
    /// The last triangle, which contains the grid point, or which the line leaves.
    pub(super) triangle: usize,
    /// The direction in its coordinates.
    pub(super) direction: Direction,
    /// The grid point in its coordinates; where the line leaves the surface, beyond it.
    pub(super) point: GridPoint,
    /// The side over which the line leaves the surface.
    pub(super) leaves: Option<usize>,
    /// Whether it went through a triangle that is flipped or degenerate.
    pub(super) flipped: bool,
}

/// A beginning of a walk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    pub(super) triangle: usize,
    pub(super) point: GridPoint,
    pub(super) direction: Direction,
}

/// Walks to the next grid point. `None` if the walk cannot go on, which happens only beside flipped
/// triangles or if the line is shifted out of the surface.
pub(super) fn trace(
    surface: &Triangulation,
    map: &GridMap,
    start: Start,
    shift: Shift,
) -> Option<Arrival> {
    let Start { mut triangle, mut direction, point } = first(surface, map, start, shift);
    let mut target = target(point, direction);
    let (mut entered, mut flipped) = (None, false);
    for _ in 0..3 * surface.triangles.len() + 3 {
        let corners = map.corners[triangle];
        let proper = map.doubled_area(triangle) > 0;
        flipped |= !proper;
        let holds = |k: usize| orientation(corners[k], corners[(k + 1) % 3], target) >= 0;
        if proper && (0..3).all(holds) {
            return Some(Arrival { triangle, direction, point: target, leaves: None, flipped });
        }
        let is_left = corners.map(|corner| match left_of(target, direction, corner) {
            0 => shift == Shift::Right,
            distance => distance > 0,
        });
        let exit = (0..3).find(|&k| {
            let (from, to) = (is_left[k], is_left[(k + 1) % 3]);
            // The line leaves a triangle of positive area over the side that runs from its right to
            // its left.
            if proper { !from && to } else { from != to && entered != Some(k) }
        })?;
        let side = Side { triangle, side: exit };
        let Some(next) = surface.across(side) else {
            let leaves = Some(exit);
            return Some(Arrival { triangle, direction, point: target, leaves, flipped });
        };
        let transition = map.transitions[triangle][exit];
        target = transition.apply(target);
        direction = turned(direction, transition);
        (triangle, entered) = (next.triangle, Some(next.side));
    }
    None
}

/// The first grid point after a point along its line.
fn target(point: GridPoint, direction: Direction) -> GridPoint {
    let axis = 1 - across(direction);
    let mut start = point;
    if direction < 2 {
        start[axis] = point[axis].div_euclid(UNIT) * UNIT;
    } else {
        start[axis] = -(-point[axis]).div_euclid(UNIT) * UNIT;
    }
    step(start, direction)
}

/// Where the line begins after the shift: to the right of the side along which it runs, that is in
/// the neighbour.
fn first(surface: &Triangulation, map: &GridMap, start: Start, shift: Shift) -> Start {
    let Start { triangle, point, direction } = start;
    if shift == Shift::Left {
        return start;
    }
    let corners = map.corners[triangle];
    let ahead = step([0, 0], direction);
    for side in 0..3 {
        let along = minus(corners[(side + 1) % 3], corners[side]);
        let to_point = minus(point, corners[side]);
        let runs_along = cross(along, ahead) == 0
            && cross(along, to_point) == 0
            && i128::from(along[0]) * i128::from(ahead[0])
                + i128::from(along[1]) * i128::from(ahead[1])
                > 0;
        let Some(next) = surface.across(Side { triangle, side }).filter(|_| runs_along) else {
            continue;
        };
        let transition = map.transitions[triangle][side];
        return Start {
            triangle: next.triangle,
            point: transition.apply(point),
            direction: turned(direction, transition),
        };
    }
    start
}

/// The direction from which a line arrives.
pub(super) fn back(arrival: &Arrival) -> Direction {
    opposite(arrival.direction)
}
