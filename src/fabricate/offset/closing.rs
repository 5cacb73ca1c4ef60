//! Why corner offsets are exact or not. Transported across an edge, an axis is reflected:
//! `n_j = R_e n_i` with `R_e = I - 2 t_e t_e'`. Around a panel, and around a hole, the product of
//! these reflections must leave the axis unchanged.

use crate::fabricate::surface::PanelSurface;
use crate::math::{Vec3, symmetric_eigen};
use nalgebra::DMatrix;

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
    /// The turn around each rim in degrees; none if it has an odd number of edges.
    pub rims_deg: Vec<Option<f64>>,
    /// The eigenvalues, ascending, of the closing form `H`: the mean of
    /// `(T_j - R_e T_i)' (T_j - R_e T_i)` over all edges outside a spanning tree, with `T_i` the
    /// product of reflections along the tree. Each zero eigenvalue gives one direction of exact
    /// axes. Nonzero eigenvalues depend on the tree.
    pub eigenvalues: [f64; 3],
}

/// Follows the reflections around all panels and rims.
pub fn closing(surface: &PanelSurface) -> Closing {
    let mut found = Closing { eigenvalues: closing_form(surface), ..Closing::default() };
    for (face, f) in surface.faces.iter().zip(0..) {
        match turn(surface, face) {
            Some(angle) if angle > found.panel_deg => (found.panel_deg, found.panel) = (angle, f),
            Some(_) => {}
            None => found.odd_panels += 1,
        }
    }
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

fn closing_form(surface: &PanelSurface) -> [f64; 3] {
    let n = surface.positions.len();
    let mut at: Vec<Vec<(u32, u32)>> = vec![Vec::new(); n];
    for (edge, e) in surface.edges.iter().zip(0..) {
        let [i, j] = edge.ends;
        at[i as usize].push((j, e));
        at[j as usize].push((i, e));
    }
    let mut transported: Vec<Option<Matrix>> = vec![None; n];
    let mut of_tree = vec![false; surface.edges.len()];
    for first in 0..n {
        if transported[first].is_some() {
            continue;
        }
        transported[first] = Some(IDENTITY);
        let (mut queue, mut next) = (vec![first as u32], 0);
        while let Some(&i) = queue.get(next) {
            next += 1;
            let own = transported[i as usize].unwrap_or(IDENTITY);
            for &(j, e) in &at[i as usize] {
                if transported[j as usize].is_none() {
                    let t = surface.direction(&surface.edges[e as usize]);
                    transported[j as usize] = Some(reflected(t, own));
                    of_tree[e as usize] = true;
                    queue.push(j);
                }
            }
        }
    }
    let (mut sum, mut count) = ([[0.0; 3]; 3], 0.0);
    for (edge, of_tree) in surface.edges.iter().zip(of_tree) {
        let [Some(from), Some(to)] = edge.ends.map(|v| transported[v as usize]) else { continue };
        if of_tree {
            continue;
        }
        let over = reflected(surface.direction(edge), from);
        let gap: Matrix = std::array::from_fn(|r| std::array::from_fn(|c| to[r][c] - over[r][c]));
        for r in 0..3 {
            for c in 0..3 {
                sum[r][c] += (0..3).map(|k| gap[k][r] * gap[k][c]).sum::<f64>();
            }
        }
        count += 1.0;
    }
    if count > 0.0 {
        sum = sum.map(|row| row.map(|entry| entry / count));
    }
    let values = symmetric_eigen(&DMatrix::from_fn(3, 3, |r, c| sum[r][c])).0;
    [values[2], values[1], values[0]]
}
