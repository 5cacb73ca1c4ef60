//! Extraction from maps that are known: the grid on rectangles, tori, cones and a disk whose boundary
//! cuts it.

use super::{Extraction, extract};
use crate::math::{Vec3, polygon_sides};
use crate::mesh::{Mesh, Ragged, Topology};
use crate::quads::grid_map::{GridMap, Side, Transition, Triangulation, UNIT};
use std::collections::BTreeMap;

/// A surface of triangles with coordinates at their corners, and transitions that follow from them.
pub(in crate::quads) fn mapped(
    positions: Vec<Vec3<f64>>,
    triangles: Vec<[usize; 3]>,
    corners: Vec<[[i64; 2]; 3]>,
    follows_boundary: bool,
) -> (Triangulation, GridMap) {
    let mut sides: BTreeMap<[usize; 2], Side> = BTreeMap::new();
    for (triangle, ends) in triangles.iter().enumerate() {
        for side in 0..3 {
            sides.insert([ends[side], ends[(side + 1) % 3]], Side { triangle, side });
        }
    }
    let across = |triangle: usize, side: usize| {
        let ends = triangles[triangle];
        sides.get(&[ends[(side + 1) % 3], ends[side]]).copied()
    };
    let of_triangle = |t: usize| [0, 1, 2].map(|side| across(t, side));
    let neighbours: Vec<[Option<Side>; 3]> = (0..triangles.len()).map(of_triangle).collect();
    let transition = |t: usize, side: usize| {
        let Some(other) = neighbours[t][side] else { return Transition::default() };
        let [a, b] = [corners[t][side], corners[t][(side + 1) % 3]];
        let there = corners[other.triangle];
        let [a_there, b_there] = [there[(other.side + 1) % 3], there[other.side]];
        (0..4)
            .map(|quarter_turns| Transition { quarter_turns, shift: [0, 0] })
            .find_map(|turn| {
                let at = turn.apply(a);
                let shift = [a_there[0] - at[0], a_there[1] - at[1]];
                let whole = Transition { shift, ..turn };
                (whole.apply(b) == b_there && shift.iter().all(|s| s % UNIT == 0)).then_some(whole)
            })
            .expect("a seam is exact")
    };
    let transitions =
        (0..triangles.len()).map(|t| [0, 1, 2].map(|side| transition(t, side))).collect();
    let feature = neighbours.iter().map(|n| n.map(|n| n.is_none() && follows_boundary)).collect();
    let surface = Triangulation {
        vertices: vec![None; positions.len()],
        positions,
        triangles,
        neighbours,
        feature,
    };
    (surface, GridMap { corners, transitions })
}

/// The fixed-point number.
fn fixed(x: f64) -> i64 {
    (x * UNIT as f64).round() as i64
}

/// Triangles of a grid of points, split along alternating diagonals; `name` gives the vertex.
fn split(columns: usize, rows: usize, name: impl Fn(usize, usize) -> usize) -> Vec<[usize; 3]> {
    let mut triangles = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let [a, b, c, d] = [name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)];
            if (i + j) % 2 == 0 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    triangles
}

/// A rectangle of `columns` by `rows` cells, inner points moved by `noise` of a cell, whose map is
/// `to_plane`.
fn rectangle(
    columns: usize,
    rows: usize,
    noise: f64,
    to_plane: impl Fn(f64, f64) -> [f64; 2],
    follows_boundary: bool,
) -> (Triangulation, GridMap) {
    let mut positions = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            let inner = i > 0 && j > 0 && i < columns && j < rows;
            let wave = |k: usize| if inner { noise * ((k % 13) as f64 / 6.0 - 1.0) } else { 0.0 };
            let (x, y) = (i as f64 + wave(5 * i + 3 * j), j as f64 + wave(2 * i + 7 * j));
            positions.push(Vec3::new(x, y, 0.0));
        }
    }
    let triangles = split(columns, rows, |i, j| j * (columns + 1) + i);
    let at = |v: usize| to_plane(positions[v].x, positions[v].y).map(fixed);
    let corners = triangles.iter().map(|t| t.map(at)).collect();
    mapped(positions, triangles, corners, follows_boundary)
}

/// The number of boundary loops, and vertices of faces minus edges plus faces.
fn shape(extraction: &Extraction) -> (usize, i64) {
    let face = |face: &Vec<usize>| face.iter().map(|&node| node as u32).collect::<Vec<u32>>();
    let faces: Ragged = extraction.faces.iter().map(face).collect();
    let positions = vec![[0.0; 3]; extraction.nodes.len()];
    let topology = Topology::new(&Mesh { positions, faces, ..Mesh::default() });
    let vertices = topology.neighbours().iter().filter(|near| !near.is_empty()).count();
    let euler = (vertices + extraction.faces.len()) as i64 - topology.edges().len() as i64;
    (topology.boundary_loops().len(), euler)
}

/// The sides of the faces, and how many of them are on the boundary.
fn sides(extraction: &Extraction) -> (Vec<[usize; 2]>, usize) {
    let sides: Vec<[usize; 2]> =
        extraction.faces.iter().flat_map(|face| polygon_sides(face)).collect();
    let outer = sides.iter().filter(|&&[a, b]| !sides.contains(&[b, a])).count();
    (sides, outer)
}

fn all_quads(extraction: &Extraction) -> bool {
    extraction.faces.iter().all(|face| face.len() == 4)
}

#[test]
fn the_grid_of_a_rectangle_is_found_whatever_its_triangles() {
    for noise in [0.0, 0.1, 0.3] {
        for (columns, rows, scale) in [(4, 3, 1.0), (6, 4, 0.5), (5, 2, 3.0), (3, 3, 7.0)] {
            let (surface, map) =
                rectangle(columns, rows, noise, |x, y| [scale * x, scale * y], true);
            let found = extract(&surface, &map, false);
            let expected = columns * rows * (scale * scale * 4.0) as usize / 4;
            assert_eq!(found.faces.len(), expected, "{columns} {rows} {scale} {noise}");
            assert!(all_quads(&found));
            assert_eq!(shape(&found), (1, 1));
            let boundary = (2.0 * scale * (columns + rows) as f64) as usize;
            assert_eq!(sides(&found).1, boundary);
        }
    }
}

#[test]
fn a_torus_has_quads_only() {
    // 5 by 4 points; the map has 7 by 3 panels, so that seams carry shifts.
    let (columns, rows, u, v) = (5, 4, 7, 3);
    let name = |i: usize, j: usize| (j % rows) * columns + i % columns;
    let positions: Vec<_> = (0..columns * rows)
        .map(|k| Vec3::new((k % columns) as f64, (k / columns) as f64, 0.1))
        .collect();
    let triangles = split(columns, rows, name);
    let at = |i: usize, j: usize| {
        let shear = (3 * (j % rows) + 2 * (i % columns)) as i64 * UNIT / 50;
        [u * i as i64 * UNIT / columns as i64 + shear, v * j as i64 * UNIT / rows as i64 - shear]
    };
    let corners = split(columns, rows, |i, j| j * (columns + 1) + i)
        .iter()
        .map(|t| t.map(|k| at(k % (columns + 1), k / (columns + 1))))
        .collect();
    let (surface, map) = mapped(positions, triangles, corners, true);
    let found = extract(&surface, &map, false);
    assert_eq!(found.faces.len(), (u * v) as usize);
    assert!(all_quads(&found));
    assert_eq!(shape(&found), (0, 0));
}

/// `sectors` squares of `size` panels around a vertex.
fn cone(sectors: usize, size: i64, cells: usize) -> (Triangulation, GridMap) {
    // The vertex (i, j) of a sector; its left edge is the lower edge of the next.
    let name = |sector: usize, i: usize, j: usize| match (i, j) {
        (0, 0) => 0,
        (i, 0) => 1 + sector * cells * (cells + 1) + (i - 1),
        (0, j) => 1 + (sector + 1) % sectors * cells * (cells + 1) + (j - 1),
        (i, j) => 1 + sector * cells * (cells + 1) + j * cells + (i - 1),
    };
    let (mut triangles, mut corners) = (Vec::new(), Vec::new());
    let mut positions = vec![Vec3::zero(); 1 + sectors * cells * (cells + 1)];
    for sector in 0..sectors {
        triangles.extend(split(cells, cells, |i, j| name(sector, i, j)));
        for j in 0..=cells {
            for i in 0..=cells {
                let turn = (sector as f64 + j as f64 / (i + j).max(1) as f64) / sectors as f64;
                let radius = (i + j) as f64;
                let (x, y) = (crate::math::cosine(turn), crate::math::sine(turn));
                positions[name(sector, i, j)] = Vec3::new(radius * x, radius * y, -radius);
            }
        }
        let at = |k: usize| {
            [k % (cells + 1), k / (cells + 1)].map(|k| k as i64 * size * UNIT / cells as i64)
        };
        let plain = split(cells, cells, |i, j| j * (cells + 1) + i);
        corners.extend(plain.iter().map(|t| t.map(at)));
    }
    mapped(positions, triangles, corners, true)
}

#[test]
fn a_cone_has_one_irregular_vertex() {
    for sectors in [3, 5, 6] {
        for (size, cells) in [(1, 4), (4, 4), (6, 4), (5, 2)] {
            let (surface, map) = cone(sectors, size, cells);
            let found = extract(&surface, &map, false);
            assert_eq!(found.faces.len(), sectors * (size * size) as usize);
            assert!(all_quads(&found));
            assert_eq!(shape(&found), (1, 1));
            let at_apex = found.faces.iter().filter(|face| face.contains(&0)).count();
            assert_eq!(at_apex, sectors);
        }
    }
}

#[test]
fn a_boundary_that_cuts_the_grid_closes_its_panels() {
    for turns in [0.03, 0.08, 0.125, 0.2] {
        let (c, s) = (crate::math::cosine(turns), crate::math::sine(turns));
        let to_plane = |x: f64, y: f64| [1.7 * (c * x - s * y), 1.7 * (s * x + c * y)];
        let (surface, map) = rectangle(6, 4, 0.2, to_plane, false);
        let found = extract(&surface, &map, false);
        assert_eq!(shape(&found), (1, 1), "{turns}");
        let area = |face: &Vec<usize>| {
            let at = |k: usize| found.nodes[face[k % face.len()]].position;
            (0..face.len()).map(|k| 0.5 * at(k).cross(at(k + 1)).z).sum::<f64>()
        };
        let areas: Vec<f64> = found.faces.iter().map(area).collect();
        assert!(areas.iter().all(|&area| area > 0.0));
        assert!((areas.iter().sum::<f64>() - 24.0).abs() < 1e-5);
        let whole = areas.iter().fold(0.0f64, |most, &area| most.max(area));
        assert!((whole - 1.0 / (1.7 * 1.7)).abs() < 1e-5, "no panel is larger than a whole one");
        let corners = found.nodes.iter().filter(|node| node.corner).count();
        assert_eq!(corners, 4);
    }
}

#[test]
fn a_flipped_triangle_leaves_no_edge_without_a_face() {
    let (surface, mut map) = rectangle(8, 8, 0.2, |x, y| [2.0 * x, 2.0 * y], true);
    // A vertex beyond the opposite side of one of its triangles.
    let moved = 4 * 9 + 4;
    for (triangle, corners) in surface.triangles.iter().zip(&mut map.corners) {
        for (&v, point) in triangle.iter().zip(corners) {
            if v == moved {
                point[0] += 2 * UNIT + UNIT / 3;
            }
        }
    }
    assert!((0..surface.triangles.len()).any(|t| map.doubled_area(t) < 0));
    for careful in [false, true] {
        let found = extract(&surface, &map, careful);
        let quads = found.faces.iter().filter(|face| face.len() == 4).count();
        assert!(quads > 200, "{quads}");
        let (_, outer) = sides(&found);
        assert_eq!((shape(&found).0, outer), (1, 64));
    }
}
