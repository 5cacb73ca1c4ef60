//! Panels of four corners that are not flat, and the radius to which they are bent in place. A sheet that
//! is forced from flat to such corners becomes a saddle with its lines of curvature along the diagonals: if
//! one corner of a parallelogram lies `w` from the plane of the others, a diagonal of length `d` is an arc of
//! the sagitta `w/4`, hence of the radius `d^2 / (2 w)`. The shorter diagonal is bent most.

use super::{FlatPanel, is_simple, triangles};
use crate::fabricate::fault::Fault;
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;
use crate::mesh::Mesh;

/// A panel as two triangles of its vertices. The first begins with the first side of the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fabricate) struct Halves {
    /// The panel.
    pub panel: u32,
    /// The corners, in the direction of the panel.
    pub corners: [[u32; 3]; 2],
}

/// The radius to which a panel with these corners is bent; infinite if it is flat.
fn bending_radius(corners: [Vec3<f64>; 4]) -> f64 {
    // The distance of the diagonals, of which each corner of a parallelogram is twice as far away. Three
    // corners that are nearly in line have no plane.
    let [a, b, c, d] = corners;
    let away = 2.0 * (b - a).dot(unit((c - a).cross(d - b))).abs();
    let diagonal = |k: usize| (corners[k + 2] - corners[k]).length_squared();
    let shorter = diagonal(0).min(diagonal(1));
    if away > 0.0 { 0.5 * shorter / away } else { f64::INFINITY }
}

/// The panels of four corners that are bent to a radius below `least`, in the unit of the mesh, as
/// triangles on both sides of the shorter diagonal that lies within the panel.
pub(in crate::fabricate) fn bent_panels(
    surface: &PanelSurface,
    flat: &[Option<FlatPanel>],
    least: f64,
) -> Vec<Halves> {
    let halves = |(panel, own): (u32, &Option<FlatPanel>)| {
        let flat = own.as_ref()?;
        let &[a, b, c, d] = surface.faces.row(panel as usize) else { return None };
        let radius = bending_radius([a, b, c, d].map(|v| surface.at(v)));
        if radius >= least || !is_simple(&flat.corners) {
            return None;
        }
        let both = triangles(&flat.corners);
        let has = |corner: usize| both.iter().all(|own| own.contains(&corner));
        let corners = match (both.len(), has(0)) {
            (2, true) => [[a, b, c], [c, d, a]],
            (2, false) => [[a, b, d], [b, c, d]],
            _ => return None,
        };
        Some(Halves { panel, corners })
    };
    (0..).zip(flat).filter_map(halves).collect()
}

/// The surface and the names of its panels, some of which are two triangles, as which they stand in the
/// order of assembly, too.
///
/// # Errors
/// As of [`PanelSurface::new`].
pub(in crate::fabricate) fn halved(
    mesh: &Mesh,
    whole: &PanelSurface,
    (mut names, rows): (Vec<String>, &mut [Vec<u32>]),
    bent: &[Halves],
) -> Result<(PanelSurface, Vec<String>), Fault> {
    let count = mesh.faces.len();
    let mut faces: Vec<&[u32]> = whole.faces.iter().take(count).collect();
    let mut second: Vec<Option<u32>> = vec![None; names.len()];
    for (Halves { panel, corners: [first, other] }, number) in bent.iter().zip(count as u32..) {
        faces[*panel as usize] = first;
        faces.push(other);
        second[*panel as usize] = Some(number);
    }
    let halves = bent.iter().map(|own| format!("{}.2", names[own.panel as usize]));
    let halves: Vec<String> = halves.collect();
    bent.iter().for_each(|own| names[own.panel as usize].push_str(".1"));
    names.splice(count..count, halves);
    let with_second = |f: u32| {
        // Panels with holes come after all halves.
        let is_face = (f as usize) < count;
        let first = if is_face { f } else { f + bent.len() as u32 };
        std::iter::once(first).chain(second[f as usize])
    };
    for row in rows {
        *row = row.iter().copied().flat_map(with_second).collect();
    }
    let faces = faces.into_iter().collect();
    let mut surface = PanelSurface::new(&Mesh { faces, ..mesh.clone() })?;
    surface.turned = whole.turned;
    Ok((surface, names))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_radius_is_that_of_the_saddle_over_the_corners() {
        // z = x y / 100 has the curvature 1/100 along both diagonals.
        let saddle = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.01 * x * y);
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(saddle);
        assert!((bending_radius(square) - 100.0).abs() < 1e-1, "{}", bending_radius(square));
        // However large, and wherever it begins.
        let larger = square.map(|point| point * 3.0);
        assert!((bending_radius(larger) - 3.0 * bending_radius(square)).abs() < 1e-9);
        let [a, b, c, d] = square;
        assert!((bending_radius([b, c, d, a]) - bending_radius(square)).abs() < 1e-9);
        let flat = square.map(|point| Vec3::new(point.x, point.y, 0.0));
        assert_eq!(bending_radius(flat), f64::INFINITY);
    }

    #[test]
    fn three_corners_that_are_nearly_in_line_bend_nothing() {
        // Their plane stands upright, and the fourth corner was 2 m away from it.
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 1e-6], [2.0, 0.0, 0.0], [1.0, 2.0, 0.0]];
        let radius = bending_radius(corners.map(|[x, y, z]| Vec3::new(x, y, z)));
        assert!(radius > 1e5, "{radius}");
    }
}
