//! Points without faces, as from a survey of a building.

use crate::generate::finish::{Noise, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};
use std::f64::consts::TAU;

/// Half the sides of the floor, and the height of the wall.
const FLOOR: [f64; 2] = [5.6, 4.0];
const WALL: f64 = 4.2;
/// Position of the columns along x and y.
const COLUMN: f64 = 2.8;
/// Height of the centre of the dome, and its radius.
const DOME: [f64; 2] = [1.4, 4.9];

/// Points on a pavilion, with random errors: a floor, a wall at its back, and a dome on four columns; and
/// these by name. The foot of the wall is also in the floor; the ends of a column are also in the floor
/// and in the dome.
pub fn pavilion() -> (Mesh, Vec<(String, Vec<u32>)>) {
    let mut points: Vec<Point> = Vec::new();
    let mut add = |point: Point| {
        points.push(point);
        points.len() as u32 - 1
    };
    let (mut floor, mut wall, mut dome) = (Vec::new(), Vec::new(), Vec::new());
    let between = |k: u32, n: u32, half: f64| half * (2.0 * f64::from(k) / f64::from(n) - 1.0);
    for j in 0..=10 {
        for i in 0..=14 {
            let vertex = add([between(i, 14, FLOOR[0]), between(j, 10, FLOOR[1]), 0.0]);
            floor.push(vertex);
            if j == 10 {
                wall.push(vertex);
            }
        }
    }
    for k in 1..=6 {
        for i in 0..=14 {
            wall.push(add([between(i, 14, FLOOR[0]), FLOOR[1], WALL * f64::from(k) / 6.0]));
        }
    }
    let [middle, radius] = DOME;
    let base = (radius * radius - 2.0 * COLUMN * COLUMN).sqrt() + middle;
    // Rings from the top down to the heads of the columns, spaced as widely as their points.
    for ring in 0..=7u32 {
        let around = if ring == 0 { 1 } else { 6 * ring };
        let lowest = (base - middle) / radius;
        // Equal steps of the angle from the top: `ring / 7` of the angle at the base.
        let tilt = f64::from(ring) / 7.0 * libm::acos(lowest) / TAU;
        for i in 0..around {
            let turn = (f64::from(i) + 0.5) / f64::from(around);
            let across = radius * sine(tilt);
            dome.push(add([
                across * cosine(turn),
                across * sine(turn),
                middle + radius * cosine(tilt),
            ]));
        }
    }
    let mut groups = Vec::new();
    for (k, [x, y]) in (1..).zip([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]) {
        let at = |z: f64| [x * COLUMN, y * COLUMN, z];
        let column: Vec<u32> = (0..=11).map(|i| add(at(base * f64::from(i) / 11.0))).collect();
        floor.push(column[0]);
        dome.push(column[11]);
        groups.push((format!("column {k}"), column));
    }
    let named = [("floor", floor), ("wall", wall), ("dome", dome)];
    groups.extend(named.map(|(name, members)| (name.to_owned(), members)));
    let mut noise = Noise { state: 1 };
    for x in points.as_flattened_mut() {
        *x += 0.22 * noise.next();
    }
    (rounded(Mesh { positions: points, ..Mesh::default() }), groups)
}
