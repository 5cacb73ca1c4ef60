//! The result of a run for builders: how many panels have the required shape within a tolerance,
//! and how far the vertices have moved for it.

use super::face_measure::face_values;
use super::inspect::{members, required_measure};
use super::measuring::{Measuring, Shape};
use super::moved::moved;
use crate::mesh::Point;
use crate::session::state::RestMesh;
use crate::solve::Moved;
use serde::Serialize;

/// How many panels have the required shape.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
pub struct Verdict {
    /// The id of the kind that constrains them.
    pub kind: &'static str,
    /// The adjective for panels with the shape: "flat".
    pub adjective: &'static str,
    /// Number of constrained panels.
    pub panels: usize,
    /// Number of panels whose worst vertex is within the tolerance.
    pub within: usize,
    /// The tolerance, in the unit of the mesh.
    pub tolerance: f64,
    /// The panels with a larger tolerance, because they would fold within this one.
    pub eased: Option<EasedPanels>,
    /// The distance of the worst vertex, in the unit of the mesh.
    pub worst: f64,
    /// The face that it belongs to.
    pub worst_face: u32,
    /// Number of faces of the mesh that are folded or dented but were not at rest.
    pub folded: usize,
    /// Distances of the vertices from their rest positions.
    pub moved: Moved,
    /// The angle between neighbouring faces.
    pub bend: Bend,
}

/// The mean angle between neighbouring faces of the whole mesh, in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Bend {
    /// At rest.
    pub rest: f64,
    /// In the current shape.
    pub now: f64,
    /// Whether the difference is a change of the design.
    pub change: Option<BendChange>,
}

/// A change of the surface as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum BendChange {
    /// The faces meet at clearly larger angles.
    Rougher,
    /// They meet at less than half the angle.
    Flatter,
}

impl Bend {
    fn of(now: &[Point], rest: &RestMesh) -> Bend {
        let (fair, before) = (rest.fair_bends(), rest.bend());
        let now = rest.bend_at(now);
        let change = match now {
            _ if now > *fair.end() => Some(BendChange::Rougher),
            _ if now < *fair.start() => Some(BendChange::Flatter),
            _ => None,
        };
        Bend { rest: before, now, change }
    }
}

/// Panels with a larger tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EasedPanels {
    /// Number of panels.
    pub panels: usize,
    /// Their tolerance, in the unit of the mesh.
    pub within: f64,
}

impl Verdict {
    /// Returns how many panels have the shape required by the last enabled row on single faces,
    /// with distances up to `tolerance`. None if no row constrains panels.
    pub(crate) fn of(model: &mut Measuring<'_>, tolerance: f64) -> Option<Verdict> {
        let document = model.scene.document();
        let rows = document.constraints.iter().enumerate().rev();
        let mut asking = rows.filter(|(_, row)| row.enabled);
        let (row, info, adjective) = asking.find_map(|(index, row)| {
            let info = row.kind.info();
            let adjective = info.panels.filter(|_| required_measure(document, index).is_some())?;
            Some((index, info, adjective))
        })?;
        let [faces, _] = members(model.scene.rows().get(row), model.rest);
        let eased = document.constraints[row].eased.as_ref().map(|eased| {
            let panels = eased.faces.iter().filter(|&face| faces.binary_search(face).is_ok());
            EasedPanels { panels: panels.count(), within: eased.within }
        });
        let distances = face_values(model, info.measure?, Shape::Now)?;
        let distance = |face: u32| distances[face as usize];
        let worst_face =
            faces.iter().copied().max_by(|&a, &b| distance(a).total_cmp(&distance(b)))?;
        Some(Verdict {
            kind: info.id,
            adjective,
            panels: faces.len(),
            within: faces.iter().filter(|&&face| distance(face) <= tolerance).count(),
            tolerance,
            eased,
            worst: distance(worst_face),
            worst_face,
            folded: model.rest.folded_by(model.scene.positions()).len(),
            moved: moved(model.scene, model.rest),
            bend: Bend::of(model.scene.positions(), model.rest),
        })
    }
}

/// Returns a tolerance for distances on a mesh: about a thousandth of the mean edge, rounded to 1,
/// 2 or 5 times a power of ten, in the unit of the mesh.
pub(crate) fn tolerance(rest: &RestMesh) -> f64 {
    match rest.mean_edge() {
        edge if edge > 0.0 => round_number(1e-3 * edge),
        _ => round_number(1e-3 * rest.diameter()),
    }
}

/// Rounds to 1, 2 or 5 times a power of ten; returns 1 for anything not positive.
fn round_number(number: f64) -> f64 {
    if number.is_nan() || number <= 0.0 {
        return 1.0;
    }
    // Computed in decimal, so that the result equals its decimal notation.
    let text = format!("{number:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    let step = match mantissa {
        ..1.5 => "1",
        1.5..3.5 => "2",
        3.5..7.5 => "5",
        _ => "10",
    };
    format!("{step}e{exponent}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_is_a_number_that_one_says() {
        for (number, round) in [
            (0.0013, 0.001),
            (0.0017, 0.002),
            (4.9, 5.0),
            (0.08, 0.1),
            (730.0, 500.0),
            (2.2e-7, 2e-7),
            (0.0, 1.0),
        ] {
            assert_eq!(round_number(number), round);
        }
    }
}
