//! Why corner offsets are exact or not. Transported across an edge, an axis is reflected:
//! `n_j = R_e n_i` with `R_e = I - 2 t_e t_e'`. Around a panel, and around a hole, the product of
//! these reflections must leave the axis unchanged.

use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use crate::mesh::components;

/// A 3 by 3 matrix.
type Matrix = [[f64; 3]; 3];

const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// How well reflections close around the panels and rims of one connected part.
#[derive(Clone, Debug, Default)]
pub struct Closing {
    /// Largest turn around a panel with an even number of edges, in degrees.
    pub panel_deg: f64,
    /// The panel of `panel_deg`.
    pub panel: u32,
    /// Number of panels with an odd number of edges, around which not every axis can close. Each
    /// removes one of the three degrees of freedom of an axis.
    pub odd_panels: usize,
    /// The turn around each rim in degrees; none if it has an odd number of edges.
    pub rims_deg: Vec<Option<f64>>,
    /// Whether there are openings through the part, as in a ring or a tube: its first Betti number
    /// is not 0. Elsewhere axes that close around all panels close everywhere.
    pub has_openings: bool,
}

/// How well reflections close in all parts of a surface.
#[derive(Clone, Debug)]
pub struct Closings {
    /// Of each part; a vertex of no panel is a part by itself.
    pub parts: Vec<Closing>,
    /// The part of each vertex (`#V`).
    pub part_of: Vec<u32>,
}

/// Follows the reflections around all panels and rims.
pub fn closings(surface: &PanelSurface) -> Closings {
    let part_of = components(surface.positions.len(), surface.faces.iter());
    let part = |v: u32| part_of[v as usize] as usize;
    let count = part_of.iter().max().map_or(0, |last| *last as usize + 1);
    let mut parts = vec![Closing::default(); count];
    // b1 = 1 + b2 - (V - E + F) of each part, where b2 counts the shells that are closed.
    let mut openings = vec![1_i64; count];
    part_of.iter().for_each(|&k| openings[k as usize] -= 1);
    surface.edges.iter().for_each(|edge| openings[part(edge.ends[0])] += 1);
    for shell in surface.shells().iter().filter(|shell| shell.is_closed) {
        openings[part(surface.faces.row(shell.panel as usize)[0])] += 1;
    }
    for (face, f) in surface.faces.iter().zip(0..) {
        let own = part(face[0]);
        openings[own] -= 1;
        let own = &mut parts[own];
        for ring in surface.rings(f) {
            let ring: Vec<u32> = ring.into_iter().map(|k| face[k]).collect();
            match turn(surface, &ring) {
                Some(angle) if angle > own.panel_deg => (own.panel_deg, own.panel) = (angle, f),
                Some(_) => {}
                None => own.odd_panels += 1,
            }
        }
    }
    for rim in surface.rims.iter() {
        parts[part(rim[0])].rims_deg.push(turn(surface, rim));
    }
    parts.iter_mut().zip(openings).for_each(|(own, b1)| own.has_openings = b1 > 0);
    Closings { parts, part_of }
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
