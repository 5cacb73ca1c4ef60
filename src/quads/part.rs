//! One connected part of the surface: mapped, extracted, repaired and checked, in several attempts.

use super::extract::{Extraction, Node, Place, extract};
use super::fault::ResultFault;
use super::glide::glide;
use super::grid_map::Triangulation;
use super::map::{GridMapper, MapNotes};
use super::repair::{Repaired, repair, trim};
use super::result::{Samples, Shape, verify};
use super::surface::Prepared;
use super::{Boundary, MapOptions, RemeshError, RemeshObserver, RemeshStage};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Measures, Mesh, Point, Ragged};

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
}

/// Divisors of the weight of alignment, with their least levels, tried in turn if a result is not a
/// surface like its input.
const ATTEMPTS: [(f64, u32); 3] = [(1.0, 0), (16.0, 2), (f64::INFINITY, 3)];
/// Other numbers of panels that are tried, as factors: integers fall differently, and of the results
/// that whose panels are nearest to circles is taken.
const NUMBERS: [f64; 2] = [0.96, 1.04];
/// The most integers of a map for which other numbers are tried, and the most panels: of many panels
/// the integers matter less.
const MOST_INTEGERS: usize = 100;
const MOST_PANELS: f64 = 3000.0;
/// The number of panels may differ by this factor from the wanted one for the sake of circles.
const OFF: f64 = 1.08;

/// What is asked of a part.
pub(super) struct Asked<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) options: &'a MapOptions,
    /// Number of panels.
    pub(super) wanted: f64,
}

impl Asked<'_> {
    /// Remeshes a part, by several attempts if the result is not a surface like it.
    pub(super) fn part(
        &self,
        mapper: &mut GridMapper,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Part, RemeshError> {
        let mut fault: Option<ResultFault> = None;
        for (divisor, level) in ATTEMPTS {
            let (found, notes) = self.attempt(mapper, divisor, self.wanted, observer)?;
            let mut best = match found {
                Ok(found) => found,
                Err(first) => {
                    fault = fault.or(Some(first));
                    continue;
                }
            };
            let is_small = notes.integers <= MOST_INTEGERS && self.wanted <= MOST_PANELS;
            if notes.flipped.is_empty() && is_small {
                for (k, factor) in NUMBERS.into_iter().enumerate() {
                    let wanted = self.wanted * factor;
                    let share = (1 + k) as f64 / (1 + NUMBERS.len()) as f64;
                    let mut observed = |_, _| observer(RemeshStage::Extract, share);
                    let (found, _) = self.attempt(mapper, divisor, wanted, &mut observed)?;
                    let Ok(found) = found else { continue };
                    let count = found.faces.len() as f64 / self.wanted;
                    let is_near = count.max(1.0 / count) < OFF;
                    if is_near
                        && found.lost.len() <= best.lost.len()
                        && found.off_circles() < best.off_circles()
                    {
                        best = found;
                    }
                }
            }
            return Ok(Part { level: best.level.max(level), ..best });
        }
        Err(RemeshError::NotFollowed { fault: fault.expect("an attempt failed") })
    }

    /// One map, and what comes of it: without lines through flipped triangles if not with them.
    fn attempt(
        &self,
        mapper: &mut GridMapper,
        divisor: f64,
        wanted: f64,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(Result<Part, ResultFault>, MapNotes), RemeshError> {
        let MapOptions { follow, direction, boundary, .. } = *self.options;
        let (map, notes) = mapper.map(follow / divisor, direction, wanted, observer)?;
        if !observer(RemeshStage::Extract, 0.0) {
            return Err(RemeshError::Cancelled);
        }
        let prepared = mapper.prepared();
        let expected = Shape::of(&prepared.surface.triangles);
        let mut fault = None;
        let ways: &[bool] = if notes.flipped.is_empty() { &[false] } else { &[false, true] };
        for &careful in ways {
            let extraction = extract(&prepared.surface, &map, careful);
            let (part, at_boundary) = finish(self.mesh, prepared, extraction, &notes, boundary);
            let fits = |face: &[usize]| {
                let trimmed = boundary == Boundary::Cut && face.iter().any(|&v| at_boundary[v]);
                face.len() == 4 || trimmed && (3..=5).contains(&face.len())
            };
            let (shape, faults) = verify(&part.faces, expected, fits);
            match faults.first() {
                None => return Ok((Ok(Part { shape, ..part }), notes)),
                Some(&first) => fault = fault.or(Some(first)),
            }
        }
        Ok((Err(fault.expect("an attempt failed")), notes))
    }
}

impl Part {
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
    Extraction { mut nodes, cells, .. }: Extraction,
    notes: &MapNotes,
    boundary: Boundary,
) -> (Part, Vec<bool>) {
    let is_boundary: Vec<bool> = nodes.iter().map(|node| node.boundary).collect();
    let is_trimmed =
        |face: &[usize]| boundary == Boundary::Cut && face.iter().any(|&node| is_boundary[node]);
    let cells = match boundary {
        Boundary::Followed => cells.faces,
        Boundary::Cut => trim(&nodes, cells.faces, prepared.size),
    };
    let extracted = nodes.len();
    let Repaired { mut faces, replaced } = repair(&mut nodes, cells, is_trimmed);
    nodes[extracted..].iter_mut().for_each(|node| onto_boundary(&prepared.surface, node));
    glide(&prepared.surface, &mut nodes, &faces);
    let middle = |face: &[usize]| {
        let sum = face.iter().fold(Vec3::zero(), |sum, &node| sum + nodes[node].position);
        sum * (1.0 / face.len().max(1) as f64)
    };
    let mut lost: Vec<Vec3<f64>> = replaced.iter().map(|face| middle(face)).collect();
    let samples = Samples::of(prepared, &nodes);
    let is_turned = |face: &[usize]| {
        let area = twice_vector_area(face.iter().map(|&node| nodes[node].position));
        let normal = face.iter().fold(Vec3::zero(), |sum, &node| sum + samples.normals[node]);
        area.dot(normal) <= 0.0
    };
    lost.extend(faces.iter().filter(|face| is_turned(face)).map(|face| middle(face)));
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
        shape: Shape { euler: 0, loops: 0 },
        size: prepared.size,
        level: notes.level,
        lost,
    };
    (part, used.iter().map(|&node| nodes[node].boundary).collect())
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
