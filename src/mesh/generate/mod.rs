//! Meshes of the examples, computed. Lengths are in metres, z points up. Only `+ - * / sqrt` are
//! used, so every machine makes the same bits.
//!
//! | file | makes |
//! |---|---|
//! | `canopy`, `dome`, `hypar` | the models that the page shows first |
//! | `hall` | a flowing roof with a swelling and a waist |
//! | `honeycomb`, `dual` | polygons over a surface: the dual of rows of triangles |
//! | `mask` | a face in relief, of uneven triangles |
//! | `mounds` | a roof of polygons with two mounds |
//! | `lantern` | a surface of revolution, whose panels have circles |
//! | `net` | a piece of a torus, whose lines are circles |
//! | `strip` | a strip between two rails |
//! | `noise` | numbers without a pattern |
//! | `rings` | vertices in rings one above another |
//! | `patch` | a sheet of skew, uneven panels |
//! | `archway` | a block with a pitched roof and a round passage: creases and corners |
//! | `vase` | a surface of revolution of triangles, out of the round |
//! | `tower` | a tower whose floors are wavy |
//! | `pavilion` | points without faces: a floor, a wall, columns and a dome |
//! | `opening` | takes faces out |
//! | `blocks` | blocks of cubes: their surface, and tetrahedra |
//! | `creature`, `implicit`, `relax` | an animal of blended round parts, polygonised |

mod archway;
mod blocks;
mod canopy;
mod creature;
mod dome;
mod dual;
mod hall;
mod honeycomb;
mod hypar;
mod implicit;
mod lantern;
mod mask;
mod mounds;
mod net;
mod noise;
mod opening;
mod patch;
mod pavilion;
mod relax;
mod rings;
mod strip;
mod tower;
mod vase;

pub use archway::Archway;
pub use blocks::Blocks;
pub use canopy::Canopy;
pub use creature::Creature;
pub use dome::Dome;
pub use hall::Hall;
pub use honeycomb::honeycomb;
pub use hypar::Hypar;
pub use lantern::Lantern;
pub use mask::Mask;
pub use mounds::Mounds;
pub use net::Net;
pub use opening::opened;
pub use patch::Patch;
pub use pavilion::Pavilion;
pub use relax::soften;
pub use strip::Strip;
pub use tower::Tower;
pub use vase::Vase;

pub(crate) use noise::Noise;

use super::{Mesh, Point, Ragged};

/// A grid of quads over the square from -1 to 1 in x and y, seen from above counter-clockwise.
fn grid(panels: [usize; 2], point: impl Fn(f64, f64) -> Point) -> Mesh {
    let [nx, ny] = panels;
    let at = |k: usize, n: usize| (2.0 * k as f64 - n as f64) / n as f64;
    let positions = (0..=ny).flat_map(|j| (0..=nx).map(move |i| (i, j)));
    let positions = positions.map(|(i, j)| point(at(i, nx), at(j, ny))).collect();
    let row = nx + 1;
    let quads = (0..ny).flat_map(|j| (0..nx).map(move |i| j * row + i));
    let faces = quads.map(|v| [v, v + 1, v + row + 1, v + row].map(|v| v as u32));
    Mesh { positions, faces: Ragged::from_iter(faces), ..Mesh::default() }
}

/// The mesh with coordinates in whole tenths of a millimetre, so that its file is short.
fn rounded(mut mesh: Mesh) -> Mesh {
    for x in mesh.positions.as_flattened_mut() {
        *x = (*x * 1e4).round() / 1e4;
    }
    mesh
}
