//! Surfaces of triangles whose lines of curvature are known.

use shape_up::math::{cosine, sine};
use shape_up::mesh::{Mesh, Point};

/// Triangles over a grid of parameters from 0 to 1, closed in the directions so asked.
pub(crate) fn parametric(
    [columns, rows]: [u32; 2],
    [closed_u, closed_v]: [bool; 2],
    at: impl Fn(f64, f64) -> Point,
) -> Mesh {
    let mut mesh = Mesh::default();
    let width = if closed_u { columns } else { columns + 1 };
    let height = if closed_v { rows } else { rows + 1 };
    for j in 0..height {
        for i in 0..width {
            mesh.positions
                .push(at(f64::from(i) / f64::from(columns), f64::from(j) / f64::from(rows)));
        }
    }
    let name = |i: u32, j: u32| (j % height) * width + i % width;
    for j in 0..rows {
        for i in 0..columns {
            let [a, b, c, d] = [name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)];
            if (i + j) % 2 == 0 {
                mesh.faces.push(&[a, b, c]);
                mesh.faces.push(&[a, c, d]);
            } else {
                mesh.faces.push(&[a, b, d]);
                mesh.faces.push(&[b, c, d]);
            }
        }
    }
    mesh
}

pub(crate) fn torus() -> Mesh {
    parametric([40, 20], [true, true], |u, v| {
        let radius = 3.0 + cosine(v);
        [radius * cosine(u), radius * sine(u), sine(v)]
    })
}

/// A tube of radius 1 and length 4.
pub(crate) fn tube() -> Mesh {
    parametric([32, 16], [true, false], |u, v| [cosine(u), sine(u), 4.0 * v])
}

/// An ellipsoid with three different axes: an octahedron, divided and rounded.
pub(crate) fn ellipsoid([a, b, c]: Point) -> Mesh {
    let divisions = 12_i32;
    let mut points: Vec<[i32; 3]> = Vec::new();
    let mut mesh = Mesh::default();
    for octant in 0..8 {
        let sign = |bit: i32| if octant >> bit & 1 == 0 { 1 } else { -1 };
        let signs = [sign(0), sign(1), sign(2)];
        let mut index = |i: i32, j: i32| {
            let point = [i * signs[0], j * signs[1], (divisions - i - j) * signs[2]];
            let found = points.iter().position(|other| *other == point);
            found.unwrap_or_else(|| {
                points.push(point);
                points.len() - 1
            }) as u32
        };
        let mut face = |mut corners: [u32; 3]| {
            if signs.iter().product::<i32>() < 0 {
                corners.swap(1, 2);
            }
            mesh.faces.push(&corners);
        };
        for i in 0..divisions {
            for j in 0..divisions - i {
                face([index(i, j), index(i + 1, j), index(i, j + 1)]);
                if i + j + 1 < divisions {
                    face([index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]);
                }
            }
        }
    }
    mesh.positions = points
        .iter()
        .map(|point| {
            let [x, y, z] = point.map(f64::from);
            let length = (x * x + y * y + z * z).sqrt();
            [a * x / length, b * y / length, c * z / length]
        })
        .collect();
    mesh
}

/// A flat ring between a square of side 6 and one of side 2.
pub(crate) fn plate() -> Mesh {
    let count = 18_u32;
    let mut mesh = parametric([count, count], [false, false], |u, v| [6.0 * u, 6.0 * v, 0.0]);
    let hole = |face: &[u32]| {
        let middle =
            |axis: usize| face.iter().map(|&v| mesh.positions[v as usize][axis]).sum::<f64>() / 3.0;
        (0..2).all(|axis| (2.0..4.0).contains(&middle(axis)))
    };
    let faces = mesh.faces.iter().filter(|face| !hole(face)).collect();
    mesh.faces = faces;
    without_stray(mesh)
}

/// A hyperbolic paraboloid over a square whose sides are rulings, at half a right angle to the lines
/// of curvature.
pub(crate) fn hypar() -> Mesh {
    parametric([20, 20], [false, false], |u, v| {
        let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        [2.0 * x, 2.0 * y, 1.2 * x * y]
    })
}

/// A vault without symmetries, over a rectangle.
pub(crate) fn vault() -> Mesh {
    parametric([22, 16], [false, false], |u, v| {
        let (x, y) = (8.0 * u, 6.0 * v);
        let rise = 1.1 * u * (1.0 - u) + 1.9 * v * (1.0 - v) + 0.4 * u * v * v;
        [x, y, 3.0 * rise]
    })
}

/// A groin vault over a square: two barrel vaults that cross, with creases along the diagonals. At its
/// corners a crease meets two sides at less than half a right angle.
pub(crate) fn groin() -> Mesh {
    parametric([24, 24], [false, false], |u, v| {
        let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        [3.0 * x, 3.0 * y, 3.0 * (1.0 - (x * x).min(y * y))]
    })
}

/// A mesh without the vertices that no face uses.
pub(crate) fn without_stray(mut mesh: Mesh) -> Mesh {
    let mut name = vec![u32::MAX; mesh.positions.len()];
    mesh.faces.indices().iter().for_each(|&v| name[v as usize] = 0);
    let mut positions = Vec::new();
    for (name, &position) in name.iter_mut().zip(&mesh.positions) {
        if *name == 0 {
            *name = positions.len() as u32;
            positions.push(position);
        }
    }
    mesh.faces.rename(&name);
    Mesh { positions, ..mesh }
}

/// A roof of 20 m by 20 m in squares of 1 m, each two triangles.
pub(crate) fn roof() -> Mesh {
    parametric([20, 20], [false, false], |u, v| [20.0 * u, 20.0 * v, 3.0 * u * (1.0 - u)])
}
