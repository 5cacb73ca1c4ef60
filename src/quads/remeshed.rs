//! All parts in one mesh: measured, and put into words.

use super::RemeshError;
use super::options::MOST_PANELS;
use super::part::Part;
use super::result::{Distances, NEAR, RemeshMeasures, Tally, places, places_near};
use super::surface::{Opening, StayingPart};
use crate::math::{Vec3, mean};
use crate::mesh::{Mesh, Point};
use crate::words;
use serde::Serialize;

/// A mesh of quads along the lines of curvature of another mesh.
#[derive(Clone, Debug)]
pub struct Remeshed {
    /// Its parts are in the order of those of the input, those that stay as they are at the end.
    /// Without curves and groups.
    pub mesh: Mesh,
    /// Number of faces of the input that stay as they are: the last ones of the mesh.
    pub staying: usize,
    /// Measures of all covered parts together.
    pub measures: RemeshMeasures,
    /// The irregular vertices that [`RemeshMeasures::irregular`] counts, ascending.
    pub irregular: Vec<u32>,
    /// The greatest level of retry of a part: 0 follows the curvature as asked, 3 not at all.
    pub level: u32,
    /// What the reader should know.
    pub notes: Vec<RemeshNote>,
}

/// A sentence about a result, with the places that it names.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RemeshNote {
    /// The sentence.
    pub words: String,
    /// In the unit of the mesh; empty if it concerns the whole.
    pub places: Vec<Point>,
}

impl RemeshNote {
    fn new(words: String, places: impl IntoIterator<Item = Vec3<f64>>) -> RemeshNote {
        RemeshNote { words, places: places.into_iter().map(Point::from).collect() }
    }
}

/// Vertices of the input or of the result that are farther than this many panels from the other one are
/// where the surface is not followed.
const FAR: f64 = 1.0;
/// A panel follows a surface that turns by no more than this along it, in radians.
const TURN: f64 = 1.0;
/// The side of panels that leave an opening open, as a fraction of the length around it: less than a
/// quarter by more than rounding takes.
const SHORT: f64 = 0.2;

/// One mesh of all parts, measured against the faces of the input that they cover, and described. No size
/// of panels below `least` is suggested.
pub(super) fn together(
    covered_faces: &Mesh,
    parts: Vec<Part>,
    cuts: bool,
    least: f64,
    units: &str,
) -> Remeshed {
    let mut mesh = Mesh::default();
    let mut tally = Tally::default();
    for part in &parts {
        let first = mesh.positions.len();
        mesh.positions.extend(part.positions.iter().map(|&p| Point::from(p)));
        for face in &part.faces {
            let face: Vec<u32> = face.iter().map(|&v| (first + v) as u32).collect();
            mesh.faces.push(&face);
        }
        tally.add(&part.positions, &part.faces, &part.samples, part.size, cuts);
    }
    let distances = Distances::between(&mesh, covered_faces);
    let mut notes = Vec::new();
    notes.extend(not_followed(&parts, covered_faces, &distances, least, units));
    notes.extend(dropped(&parts));
    notes.extend(covered(&parts, least, units));
    let irregular = std::mem::take(&mut tally.irregular_vertices);
    let measures = tally.measures(
        distances.largest,
        parts.iter().map(|part| part.shape.loops).sum(),
        parts.iter().map(|part| part.shape.euler).sum(),
    );
    let level = parts.iter().map(|part| part.level).max().unwrap_or(0);
    Remeshed { mesh, staying: 0, measures, irregular, level, notes }
}

impl Remeshed {
    /// Appends faces of the input that stay as they are.
    pub(super) fn append(&mut self, input: &Mesh, faces: &[u32]) {
        let mut name = vec![u32::MAX; input.positions.len()];
        for &face in faces {
            let corner = |&v: &u32| {
                let own = &mut name[v as usize];
                if *own == u32::MAX {
                    *own = self.mesh.positions.len() as u32;
                    self.mesh.positions.push(input.positions[v as usize]);
                }
                *own
            };
            let corners: Vec<u32> = input.faces.row(face as usize).iter().map(corner).collect();
            self.mesh.faces.push(&corners);
        }
        self.staying += faces.len();
    }
}

/// Says which parts stay as they are, and why; `units` is the symbol of the unit.
pub(super) fn notes_on(staying: &[StayingPart], units: &str) -> Vec<RemeshNote> {
    let mut notes: Vec<(String, usize, Vec<Vec3<f64>>)> = Vec::new();
    for part in staying {
        // Of a small part the whole is the place.
        let (why, at) = match part.error {
            RemeshError::TooFewTriangles { .. } => (String::new(), part.at),
            ref error => (format!(": {}", error.words(units)), error.place().unwrap_or(part.at)),
        };
        match notes.iter_mut().find(|(known, ..)| *known == why) {
            Some((_, count, places)) => {
                *count += 1;
                places.push(at);
            }
            None => notes.push((why, 1, vec![at])),
        }
    }
    let note = |(why, count, places): (String, usize, Vec<Vec3<f64>>)| {
        let small = if why.is_empty() { "small " } else { "" };
        let parts = words::count(count, &format!("{small}part"), &format!("{small}parts"));
        let stay = if count == 1 { "stays as it is" } else { "stay as they are" };
        RemeshNote::new(format!("{parts} {stay}{why}"), places)
    };
    notes.into_iter().map(note).collect()
}

/// Says how many faces are left out because a corner has no position, and where: at the means of their
/// other corners.
pub(super) fn note_on_left_out(input: &Mesh, faces: &[u32], size: f64) -> Option<RemeshNote> {
    let is_placed = |v: &&u32| !input.is_unplaced(**v);
    let at = |v: &u32| Vec3::from(input.positions[*v as usize]);
    let corners = faces.iter().map(|&face| input.faces.row(face as usize).iter().filter(is_placed));
    let placed = corners.filter(|corners| corners.clone().count() > 0);
    let middles: Vec<Vec3<f64>> = placed.map(|corners| mean(corners.map(at))).collect();
    let has = match faces.len() {
        0 => return None,
        1 => "1 face is left out, since it has".to_owned(),
        count => format!("{} faces are left out, since they have", words::group_digits(count)),
    };
    let words = format!("{has} a vertex with a coordinate in the file that is not a number");
    Some(RemeshNote::new(words, places(&middles, NEAR * size)))
}

/// Names the places that the panels cannot follow, and the size of panels along which the surface turns
/// there as far as panels can, unless it is below `least`.
fn not_followed(
    parts: &[Part],
    covered_faces: &Mesh,
    distances: &Distances,
    least: f64,
    units: &str,
) -> Option<RemeshNote> {
    let size = parts.first()?.size;
    let of_part = |part: &Part| [part.lost.clone(), part.folds.clone()].concat();
    let mut lost: Vec<Vec3<f64>> = parts.iter().flat_map(of_part).collect();
    let used = covered_faces.used_positions();
    let of_input = used.iter().map(|&point| Vec3::from(point)).zip(&distances.from_input);
    let own = parts.iter().flat_map(|part| part.positions.iter().copied()).zip(&distances.to_input);
    lost.extend(of_input.chain(own).filter(|(_, d)| **d > FAR * size).map(|(point, _)| point));
    let places = places(&lost, NEAR * size);
    if places.is_empty() {
        return None;
    }
    let follows = parts.iter().map(|part| follows(part, &places)).fold(0.7 * size, f64::min);
    let (count, them) = match places.len() {
        1 => ("1 place is".to_owned(), "it"),
        count => (format!("{} places are", words::group_digits(count)), "them"),
    };
    // Of a scan, panels of this size find smaller details at the same place.
    let what = match follows < least {
        true => format!("to follow {them} {}", takes(follows, least, units)),
        false => {
            format!("sides of {} or less may follow {them}", words::rough_length(follows, units))
        }
    };
    let words = format!("{count} smaller than a panel: {what}");
    Some(RemeshNote::new(words, places))
}

/// Says what panels of the side `size` take, unless it is below `least`.
fn takes(size: f64, least: f64, units: &str) -> String {
    if size < least {
        let most = words::group_digits(MOST_PANELS as usize);
        return format!("would take nearly {most} panels, or more");
    }
    format!("takes sides of {} or less", words::rough_length(size, units))
}

/// Names the openings over which panels run, and the size of panels that would leave them open.
fn covered(parts: &[Part], least: f64, units: &str) -> Option<RemeshNote> {
    let openings: Vec<Opening> =
        parts.iter().flat_map(|part| part.notes.openings.clone()).collect();
    let shortest = openings.iter().map(|opening| opening.length).reduce(f64::min)?;
    let takes = takes(SHORT * shortest, least, units);
    let words = match openings.len() {
        1 => format!("1 opening is too small for these panels and covered: keeping it {takes}"),
        count => {
            let count = words::group_digits(count);
            format!(
                "{count} openings are too small for these panels and covered: keeping them {takes}"
            )
        }
    };
    Some(RemeshNote::new(words, openings.iter().map(|opening| opening.at)))
}

/// Names the places with creases that are not followed.
fn dropped(parts: &[Part]) -> Option<RemeshNote> {
    let size = parts.first()?.size;
    let edges: Vec<Vec3<f64>> = parts.iter().flat_map(|part| part.notes.dropped.clone()).collect();
    let places = places(&edges, NEAR * size);
    let words = match places.len() {
        0 => return None,
        1 => "Creases that are nearer to each other than a panel are not followed".to_owned(),
        count => format!(
            "In {} places, creases that are nearer to each other than a panel are not followed",
            words::group_digits(count)
        ),
    };
    Some(RemeshNote::new(words, places))
}

/// The size of panels along which the surface turns by [`TURN`], at that of some places where it turns
/// most: by the mean curvature of the vertices of a part within a panel.
fn follows(part: &Part, places: &[Vec3<f64>]) -> f64 {
    let mut sums = vec![(0.0, 0.0); places.len()];
    let near = places_near(&part.positions, places, part.size);
    for (near, &[xx, yy, zz, xy, xz, yz]) in near.zip(&part.samples.tensors) {
        let square = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz);
        for place in near {
            let (sum, count) = &mut sums[place];
            (*sum, *count) = (*sum + square.sqrt(), *count + 1.0);
        }
    }
    let turns = sums.into_iter().filter(|(sum, _)| *sum > 0.0);
    turns.map(|(sum, count)| TURN * count / sum).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quads::PrepareNotes;
    use crate::quads::result::{Samples, Shape};

    #[test]
    fn no_side_is_advised_that_would_be_refused() {
        let part = Part {
            positions: Vec::new(),
            faces: Vec::new(),
            samples: Samples { normals: Vec::new(), tensors: Vec::new() },
            shape: Shape { euler: 0, loops: 0, parts: 0 },
            size: 0.12,
            level: 0,
            lost: vec![Vec3::zero()],
            folds: Vec::new(),
            notes: PrepareNotes::default(),
        };
        let parts = [part];
        let distances =
            Distances { to_input: Vec::new(), from_input: Vec::new(), largest: Default::default() };
        let said = |least: f64| {
            let note = not_followed(&parts, &Mesh::default(), &distances, least, "m");
            note.expect("a place is lost").words
        };
        let place = "1 place is smaller than a panel:";
        assert_eq!(said(0.05), format!("{place} sides of 80 mm or less may follow it"));
        let many = "to follow it would take nearly 100\u{2009}000 panels, or more";
        assert_eq!(said(0.1), format!("{place} {many}"));
    }
}
