//! The worst elements: a list in words and numbers of what the colours show.

use super::constraint_map::ConstraintCoverage;
use super::face_measure::FaceMeasure;
use crate::constraint::{Element, Selector};
use crate::math::{argsort, key_of_number};
use crate::session::Session;
use crate::words::{MeasureUnit, count};
use serde::Serialize;

/// An element that is far from its constraint or has a large value of a measure.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct WorstElement {
    /// Its name: "face 37", "edge 3–4".
    pub element: String,
    /// The label of its row of constraints, and the groups of the mesh that contain one of its faces.
    pub about: String,
    /// The row of constraints: that of the list, or the one that pulls most at the face.
    pub row: Option<usize>,
    /// The distance or value, in the unit of the measure.
    pub value: f64,
    /// The same in words; rounding errors are 0.
    pub words: String,
    /// The faces whose corners are all in it.
    pub faces: Vec<u32>,
    /// Its vertices.
    pub vertices: Vec<u32>,
}

impl Session {
    /// Returns the `count` faces with the largest absolute values of the measure `id`, largest first,
    /// ties in mesh order, without faces that have no value. None if there is no such measure. Lengths are
    /// written in the unit in which their `tolerance` is written.
    pub fn worst_faces(
        &mut self,
        id: &str,
        count: usize,
        tolerance: Option<f64>,
    ) -> Option<Vec<WorstElement>> {
        let unit = FaceMeasure::of(id)?.unit;
        let values = self.face_values(id)?;
        let value = |face: u32| values[face as usize];
        let descending = argsort(values.iter().map(|&value| !key_of_number(value.abs())));
        let with_value = descending.into_iter().filter(|&face| !value(face).is_nan());
        let faces: Vec<u32> = with_value.take(count).collect();
        let pulling = self.pulling_rows(&faces);
        let worst = faces.iter().zip(pulling).map(|(&face, row)| {
            let elements = [vec![face], self.faces().row(face as usize).to_vec()];
            let element = format!("face {face}");
            self.worst_element(element, elements, row, value(face), unit, tolerance)
        });
        Some(worst.collect())
    }

    /// Returns the `count` constraints of row `index` that are farthest from being met, farthest first,
    /// by the largest distance of a vertex to its projection, in the unit of the mesh; it is written in the
    /// unit in which `tolerance` is. Empty if the row is disabled or does not exist.
    pub fn worst_constraints(
        &mut self,
        index: usize,
        count: usize,
        tolerance: Option<f64>,
    ) -> Vec<WorstElement> {
        let Some(asked) = self.scene.enabled_rows().position(|row| row == index) else {
            return Vec::new();
        };
        let mut worst: Vec<(f64, Vec<u32>)> = Vec::new();
        self.scene.projected(|row, points| {
            if row != asked || count == 0 {
                return;
            }
            let distance = points.iter().fold(0.0, |far: f64, (_, way)| far.max(way.length()));
            if worst.len() == count && worst[count - 1].0 >= distance {
                return;
            }
            worst.truncate(count - 1);
            let place = worst.partition_point(|(other, _)| *other >= distance);
            worst.insert(place, (distance, points.iter().map(|(vertex, _)| *vertex).collect()));
        });
        let mut cover = ConstraintCoverage::new(self.rest.mesh(), self.rest.topology());
        let spec = &self.scene.document().constraints[index];
        let element = |(value, vertices): (f64, Vec<u32>)| {
            let mut faces = cover.faces(&vertices).to_vec();
            faces.sort_unstable();
            // Some kinds name a vertex twice, such as those on the edges of a face.
            faces.dedup();
            let (element, unit) = (name_of(&spec.on, &faces, &vertices), MeasureUnit::Length);
            self.worst_element(element, [faces, vertices], Some(index), value, unit, tolerance)
        };
        worst.into_iter().map(element).collect()
    }

    /// Returns for each face the row with a corner farthest from its projection.
    fn pulling_rows(&mut self, faces: &[u32]) -> Vec<Option<usize>> {
        let enabled: Vec<usize> = self.scene.enabled_rows().collect();
        // The faces that each vertex is a corner of.
        let mut corners: Vec<(u32, usize)> = Vec::new();
        for (place, &face) in faces.iter().enumerate() {
            corners.extend(self.faces().row(face as usize).iter().map(|&v| (v, place)));
        }
        corners.sort_unstable();
        let mut most: Vec<(f64, Option<usize>)> = vec![(0.0, None); faces.len()];
        self.scene.projected(|row, points| {
            // A constraint on many vertices may contain corners of any face, so search by vertex.
            for (vertex, way) in points {
                let first = corners.partition_point(|(corner, _)| corner < vertex);
                for (_, place) in corners[first..].iter().take_while(|(corner, _)| corner == vertex)
                {
                    let far = way.length_squared();
                    if far > most[*place].0 {
                        most[*place] = (far, Some(enabled[row]));
                    }
                }
            }
        });
        most.into_iter().map(|(_, row)| row).collect()
    }

    fn worst_element(
        &self,
        element: String,
        [faces, vertices]: [Vec<u32>; 2],
        row: Option<usize>,
        value: f64,
        unit: MeasureUnit,
        tolerance: Option<f64>,
    ) -> WorstElement {
        let document = self.document();
        let shown = unit.or_zero(value, self.rest.diameter());
        let words = unit.in_words(shown, &document.units, tolerance.unwrap_or(value));
        let label = row.map(|row| document.constraints[row].label().to_owned());
        let names = label.into_iter().chain(self.rest.groups_of(&faces));
        let names: Vec<String> = names.filter(|name| !name.is_empty()).collect();
        let about = if names.is_empty() { "–".to_owned() } else { names.join(" · ") };
        WorstElement { element, about, row, value, words, faces, vertices }
    }
}

/// Returns the name of the element that one constraint of a selector acts on.
fn name_of(on: &Selector, faces: &[u32], vertices: &[u32]) -> String {
    let Selector::Each { element, radius, .. } = on else {
        return match on {
            Selector::Set(name) => name.clone(),
            _ => count(vertices.len(), "vertex", "vertices"),
        };
    };
    match (element, radius, vertices) {
        (Element::Face, 0, _) if faces.len() == 1 => format!("face {}", faces[0]),
        (Element::Edge | Element::Hinge, 0, [a, b, ..]) => format!("edge {a}–{b}"),
        (Element::Ring | Element::Star, _, [middle, ..]) => format!("vertex {middle}"),
        (Element::Corner, 0, [_, middle, _]) => format!("corner at vertex {middle}"),
        (element, _, [first, ..]) => format!("{} with vertex {first}", element.label()),
        (element, _, []) => element.label().to_owned(),
    }
}
