//! Curvature directions and lines for the page.

use crate::mesh::{CurvatureField, CurvatureLine, Family, Point, Topology};
use crate::web::{log_panics, mesh_of, thrown};
use wasm_bindgen::prelude::*;

const FAMILIES: [Family; 2] = [Family::Larger, Family::Smaller];
/// Maximum number of lines side by side across the surface; smaller distances are refused.
const MOST_LINES: f64 = 200.0;

/// Polylines over the surface, in the form that the view draws.
#[wasm_bindgen(getter_with_clone)]
pub struct CurvatureDrawing {
    /// #points by 3.
    pub points: Vec<f64>,
    /// Polyline `k` has the points from `offsets[k]` to `offsets[k + 1]`.
    pub offsets: Vec<u32>,
    /// The number of polylines along the larger principal curvature, which come first.
    pub count: u32,
}

/// The principal directions of curvature of a shape.
#[wasm_bindgen]
pub struct SurfaceCurvature {
    field: CurvatureField,
}

#[wasm_bindgen]
impl SurfaceCurvature {
    /// Computes the directions on a mesh of `positions`, `#V by 3`, and faces: face `f` has the
    /// corners from `offsets[f]` to `offsets[f + 1]` of `indices`.
    #[wasm_bindgen(constructor)]
    pub fn new(positions: &[f64], offsets: &[u32], indices: &[u32]) -> SurfaceCurvature {
        log_panics();
        let mesh = mesh_of(positions, offsets, indices);
        let field = CurvatureField::new(&mesh.positions, &mesh, &Topology::new(&mesh));
        SurfaceCurvature { field }
    }

    /// Returns a line distance that shows curvature without hiding the surface, in mesh units.
    pub fn distance(&self) -> f64 {
        (0.04 * self.field.diameter()).max(1.5 * self.field.mean_edge())
    }

    /// Returns a short stroke along each direction on every face.
    pub fn strokes(&self) -> CurvatureDrawing {
        drawing(FAMILIES.map(|family| {
            self.field.strokes(family).into_iter().map(|ends| ends.to_vec()).collect()
        }))
    }

    /// Returns lines of curvature at the given distance from each other, in the unit of the mesh.
    ///
    /// # Errors
    /// A distance that is not positive, or so small that there would be too many lines.
    pub fn lines(&self, distance: f64) -> Result<CurvatureDrawing, JsValue> {
        let least = self.field.diameter() / MOST_LINES;
        if distance.is_nan() || distance < least || distance <= 0.0 {
            return Err(thrown(format!("expected a distance from {least:.3e}, found {distance}")));
        }
        Ok(drawing(FAMILIES.map(|family| polylines(&self.field.spaced_lines(family, distance)))))
    }
}

fn polylines(lines: &[CurvatureLine]) -> Vec<Vec<Point>> {
    lines.iter().map(|line| line.positions().collect()).collect()
}

fn drawing(families: [Vec<Vec<Point>>; 2]) -> CurvatureDrawing {
    let count = families[0].len() as u32;
    let mut drawing = CurvatureDrawing { points: Vec::new(), offsets: vec![0], count };
    for line in families.iter().flatten() {
        drawing.points.extend(line.as_flattened());
        drawing.offsets.push((drawing.points.len() / 3) as u32);
    }
    drawing
}
