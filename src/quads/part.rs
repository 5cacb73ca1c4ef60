//! One connected part of the surface: mapped, extracted, repaired and checked, in several attempts.

use super::extract::{Extraction, Node, Place, extract};
use super::fault::ResultFault;
use super::glide::{glide, holds};
use super::grid_map::{GridMap, Triangulation};
use super::map::{GridMapper, MapNotes};
use super::repair::{Repaired, repair, trim};
use super::result::{NEAR, Samples, Shape, places, verify};
use super::surface::{PrepareNotes, Prepared};
use super::{Boundary, MapOptions, RemeshError, RemeshObserver};
use crate::math::{Vec3, mean, twice_vector_area};
use crate::mesh::{Measures, Mesh, Point, Ragged};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The result of one connected part.
pub(super) struct Part {
    pub(super) positions: Vec<Vec3<f64>>,
    pub(super) faces: Vec<Vec<usize>>,
    pub(super) samples: Samples,
    pub(super) shape: Shape,
    /// The side of a panel.
    pub(super) size: f64,
    pub(super) level: u32,
    /// Where faces were repaired or panels are turned over.
    pub(super) lost: Vec<Vec3<f64>>,
    /// Where the surface turns by more than a right angle from one panel to the next, other than at a
    /// crease that they follow.
    pub(super) folds: Vec<Vec3<f64>>,
    /// What the panels do not follow.
    pub(super) notes: PrepareNotes,
}

/// Maps with flipped triangles are tried up to this level if one gives a surface like the input:
/// those of later levels follow little of the curvature.
const LAST_RETRY: u32 = 1;
/// Other numbers of panels that are tried, as factors: integers fall differently, and of the results
/// that with the fewest flaws is taken, of these that whose panels are nearest to circles.
const NUMBERS: [f64; 2] = [0.96, 1.04];
/// The most integers of a map for which other numbers are tried, and the most panels: of many panels
/// the integers matter less.
const MOST_INTEGERS: usize = 60;
const MOST_PANELS_VARIED: f64 = 3000.0;
/// The number of panels may differ by this factor from the wanted one for the sake of circles.
const MOST_CHANGED: f64 = 1.08;

/// What is asked of a part.
pub(super) struct Asked<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) options: &'a MapOptions,
    /// Number of panels.
    pub(super) wanted: f64,
    /// The size of panels that is named if these cannot follow the part.
    pub(super) smaller: Option<f64>,
}

impl Asked<'_> {
    /// Remeshes a part: of the maps of one level after another that gives a surface like the part
    /// without a lost place, or with the fewest.
    pub(super) fn part(
        &self,
        mapper: &mut GridMapper,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Part, RemeshError> {
        let MapOptions { follow, direction, .. } = *self.options;
        let mut best: Option<(Part, MapNotes)> = None;
        // The first one, with its place.
        let mut fault: Option<(ResultFault, Option<Vec3<f64>>)> = None;
        let mapped =
            mapper.maps([follow, direction, self.wanted], observer, &mut |prepared, map, notes| {
                let level = notes.level;
                let mut is_whole = false;
                match self.result(prepared, &map, &notes) {
                    Ok(part) => {
                        is_whole = notes.flipped.is_empty() || part.lost.is_empty();
                        let loses_fewer =
                            best.as_ref().is_none_or(|(best, _)| part.lost.len() < best.lost.len());
                        if is_whole || loses_fewer {
                            best = Some((part, notes));
                        }
                    }
                    Err(own) => {
                        fault.get_or_insert_with(|| (own, Asked::place(prepared, &notes)));
                    }
                }
                let is_late = best.is_some() && level >= LAST_RETRY;
                !is_whole && !is_late
            });
        // What a later level fails at takes nothing from what was found.
        if best.is_none() {
            mapped.map_err(|fault| RemeshError::NotMapped { fault })?;
        }
        let Some((mut best, notes)) = best else {
            let (fault, at) = fault.expect("a map failed");
            return Err(RemeshError::NotFollowed { fault, smaller: self.smaller, at });
        };
        let is_small = notes.integers <= MOST_INTEGERS && self.wanted <= MOST_PANELS_VARIED;
        if notes.level == 0 && notes.flipped.is_empty() && is_small {
            for factor in NUMBERS {
                // Nor does what another number fails at.
                let Some((prepared, map, notes)) = mapper.vary(self.wanted * factor) else {
                    continue;
                };
                if !notes.flipped.is_empty() {
                    continue;
                }
                let Ok(found) = self.result(prepared, &map, &notes) else { continue };
                let count = found.faces.len() as f64 / self.wanted;
                let is_near = count.max(1.0 / count) < MOST_CHANGED;
                let is_better = match found.flaws().cmp(&best.flaws()) {
                    Ordering::Less => true,
                    Ordering::Equal => found.off_circles() < best.off_circles(),
                    Ordering::Greater => false,
                };
                if is_near && is_better {
                    best = found;
                }
            }
        }
        Ok(best)
    }

    /// The largest place where a map is flipped.
    fn place(prepared: &Prepared, notes: &MapNotes) -> Option<Vec3<f64>> {
        let at = |&triangle: &usize| prepared.surface.at(triangle, 0);
        let flipped: Vec<Vec3<f64>> = notes.flipped.iter().map(at).collect();
        places(&flipped, NEAR * prepared.size).first().copied()
    }

    /// What comes of a map: without lines through flipped triangles if not with them.
    fn result(
        &self,
        prepared: &Prepared,
        map: &GridMap,
        notes: &MapNotes,
    ) -> Result<Part, ResultFault> {
        let boundary = self.options.boundary;
        let expected = Shape::of(&prepared.surface.triangles);
        let mut fault = None;
        let ways: &[bool] = if notes.flipped.is_empty() { &[false] } else { &[false, true] };
        for &careful in ways {
            let extraction = extract(&prepared.surface, map, careful);
            let (part, at_boundary) = finish(self.mesh, prepared, extraction, notes, boundary);
            let fits = |face: &[usize]| {
                let trimmed = boundary == Boundary::Cut && face.iter().any(|&v| at_boundary[v]);
                face.len() == 4 || trimmed && (3..=5).contains(&face.len())
            };
            let (shape, faults) = verify(&part.faces, expected, fits);
            match faults.first() {
                None => return Ok(Part { shape, ..part }),
                Some(&first) => fault = fault.or(Some(first)),
            }
        }
        Err(fault.expect("a way failed"))
    }
}

impl Part {
    /// The number of places where panels are repaired, turned over or folded.
    fn flaws(&self) -> usize {
        self.lost.len() + self.folds.len()
    }

    /// The mean distance of the panels from circles, for panels of one size: it grows with their
    /// squared size.
    fn off_circles(&self) -> f64 {
        let positions: Vec<Point> = self.positions.iter().map(|&p| p.into()).collect();
        let face = |face: &Vec<usize>| face.iter().map(|&v| v as u32).collect::<Vec<u32>>();
        let faces: Ragged = self.faces.iter().map(face).collect();
        Measures::new(&positions, &faces, 1.0).circularity.mean_distance * self.faces.len() as f64
    }
}

/// Repairs what was extracted, and numbers the vertices that are left; whether each is on the
/// boundary.
fn finish(
    mesh: &Mesh,
    prepared: &Prepared,
    Extraction { mut nodes, faces }: Extraction,
    notes: &MapNotes,
    boundary: Boundary,
) -> (Part, Vec<bool>) {
    let is_boundary: Vec<bool> = nodes.iter().map(|node| node.boundary).collect();
    let is_trimmed =
        |face: &[usize]| boundary == Boundary::Cut && face.iter().any(|&node| is_boundary[node]);
    let faces = match boundary {
        Boundary::Followed => faces,
        Boundary::Cut => trim(&nodes, faces, prepared.size),
    };
    let extracted = nodes.len();
    let Repaired { mut faces, replaced } = repair(&mut nodes, faces, is_trimmed);
    nodes[extracted..].iter_mut().for_each(|node| onto_boundary(&prepared.surface, node));
    glide(&prepared.surface, &mut nodes, &faces);
    let middle = |face: &[usize]| mean(face.iter().map(|&node| nodes[node].position));
    let mut lost: Vec<Vec3<f64>> = replaced.iter().map(|face| middle(face)).collect();
    let samples = Samples::of(prepared, &nodes);
    let is_turned = |face: &[usize]| {
        let area = twice_vector_area(face.iter().map(|&node| nodes[node].position));
        let normal = face.iter().fold(Vec3::zero(), |sum, &node| sum + samples.normals[node]);
        area.dot(normal) <= 0.0
    };
    lost.extend(faces.iter().filter(|face| is_turned(face)).map(|face| middle(face)));
    let folds = folds(prepared, &nodes, &faces);
    // Only nodes of faces become vertices.
    let mut number = vec![usize::MAX; nodes.len()];
    let mut used: Vec<usize> = faces.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    used.iter().enumerate().for_each(|(k, &node)| number[node] = k);
    faces.iter_mut().flatten().for_each(|node| *node = number[*node]);
    let part = Part {
        positions: used
            .iter()
            .map(|&node| position(mesh, &prepared.surface, &nodes[node]))
            .collect(),
        faces,
        samples: Samples {
            normals: used.iter().map(|&node| samples.normals[node]).collect(),
            tensors: used.iter().map(|&node| samples.tensors[node]).collect(),
        },
        shape: Shape { euler: 0, loops: 0, parts: 0 },
        size: prepared.size,
        level: notes.level,
        lost,
        folds,
        notes: prepared.notes.clone(),
    };
    (part, used.iter().map(|&node| nodes[node].boundary).collect())
}

/// The middles of the edges over which the normals of panels turn by more than a right angle, without
/// those along features.
fn folds(prepared: &Prepared, nodes: &[Node], faces: &[Vec<usize>]) -> Vec<Vec3<f64>> {
    let held = holds(&prepared.surface, nodes);
    let normal = |face: &[usize]| twice_vector_area(face.iter().map(|&node| nodes[node].position));
    let mut first: BTreeMap<[usize; 2], Vec3<f64>> = BTreeMap::new();
    let mut found = Vec::new();
    for face in faces {
        let own = normal(face);
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            if held[a] && held[b] {
                continue;
            }
            if let Some(other) = first.insert([a.min(b), a.max(b)], own)
                && other.dot(own) < 0.0
            {
                found.push((nodes[a].position + nodes[b].position) * 0.5);
            }
        }
    }
    found
}

/// Moves a node to the nearest point of the boundary.
fn onto_boundary(surface: &Triangulation, node: &mut Node) {
    let mut best = f64::INFINITY;
    let given = node.position;
    for side in surface.sides().filter(|&side| surface.across(side).is_none()) {
        let (start, along) = (surface.at(side.triangle, side.side), surface.along(side));
        let share = ((given - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let point = start + along * share;
        let distance = (point - given).length();
        if distance < best {
            best = distance;
            (node.position, node.place) = (point, Place::Side(side));
        }
    }
}

/// The position of a node; exactly that of the vertex of the input on which it lies.
fn position(mesh: &Mesh, surface: &Triangulation, node: &Node) -> Vec3<f64> {
    let of_input = match node.place {
        Place::Vertex(v) if surface.positions[v] == node.position => surface.vertices[v],
        _ => None,
    };
    of_input.map_or(node.position, |v| mesh.positions[v as usize].into())
}
