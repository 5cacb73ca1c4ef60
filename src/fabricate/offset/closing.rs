//! Why corner offsets are exact or not. Transported across an edge, an axis is reflected:
//! `n_j = R_e n_i` with `R_e = I - 2 t_e t_e'`. Around a panel, and around a hole, the product of
//! these reflections must leave the axis unchanged.

use crate::fabricate::surface::{PanelSurface, distinct};
use crate::math::Vec3;
use crate::mesh::components;

/// A 3 by 3 matrix.
type Matrix = [[f64; 3]; 3];

const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// How well reflections close around panels and rims.
#[derive(Clone, Debug, Default)]
pub struct Closing {
    /// Largest turn around a panel with an even number of edges, in degrees.
    pub panel_deg: f64,
    /// The panel of `panel_deg`.
    pub panel: u32,
    /// Number of panels with an odd number of edges, around which not every axis can close.
    pub odd_panels: usize,
    /// The largest number of them in one part. Each leaves one of three dimensions of axes less.
    pub most_odd: usize,
    /// The turn around each rim in degrees; none if it has an odd number of edges.
    pub rims_deg: Vec<Option<f64>>,
    /// Whether there are openings through the surface, as in a ring or a tube: its first Betti number
    /// is not 0. Elsewhere axes that close around all panels close everywhere.
    pub has_openings: bool,
}

/// Follows the reflections around all panels and rims.
pub fn closing(surface: &PanelSurface) -> Closing {
    let nodes = distinct(surface.faces.indices().iter().copied()).len();
    // V - E + F = b0 - b1 + b2, where b0 counts parts and b2 those that are closed.
    let closed = surface.shells().iter().filter(|shell| shell.is_closed).count();
    let has_openings = nodes + surface.faces.len() < surface.edges.len() + surface.parts + closed;
    let mut found = Closing { has_openings, ..Closing::default() };
    let parts = components(surface.positions.len(), surface.faces.iter());
    let mut odd = vec![0; parts.len()];
    for (face, f) in surface.faces.iter().zip(0..) {
        match turn(surface, face) {
            Some(angle) if angle > found.panel_deg => (found.panel_deg, found.panel) = (angle, f),
            Some(_) => {}
            None => odd[parts[face[0] as usize] as usize] += 1,
        }
    }
    found.odd_panels = odd.iter().sum();
    found.most_odd = odd.into_iter().max().unwrap_or(0);
    found.rims_deg = surface.rims.iter().map(|rim| turn(surface, rim)).collect();
    found
}

/// The angle in degrees by which an axis is rotated around a loop of vertices; none for an odd
/// number of edges, where it is reflected.
fn turn(surface: &PanelSurface, vertices: &[u32]) -> Option<f64> {
    let n = vertices.len();
    let mut product = IDENTITY;
    let mut edges = 0;
    for k in 0..n {
        let along = surface.at(vertices[(k + 1) % n]) - surface.at(vertices[k]);
        if let Some(t) = along.length_and_direction().1 {
            product = reflected(t, product);
            edges += 1;
        }
    }
    if edges % 2 == 1 {
        return None;
    }
    // The rotation axis, scaled by twice the sine, keeps the digits that the trace loses near zero.
    let [x, y, z] = product;
    let axis = Vec3::new(z[1] - y[2], x[2] - z[0], y[0] - x[1]);
    let cosine = x[0] + y[1] + z[2] - 1.0;
    Some(libm::atan2(axis.length(), cosine).to_degrees())
}

/// `R_e` times a matrix.
fn reflected(t: Vec3<f64>, matrix: Matrix) -> Matrix {
    let t = [t.x, t.y, t.z];
    let along: [f64; 3] = std::array::from_fn(|c| (0..3).map(|k| t[k] * matrix[k][c]).sum());
    std::array::from_fn(|r| std::array::from_fn(|c| matrix[r][c] - 2.0 * t[r] * along[c]))
}
