//! The whole way from a mesh to quads along its lines of curvature: part by part, checked, measured
//! and put into words.

use super::extract::{Extraction, Node, Place, extract};
use super::fault::Fault;
use super::grid_map::Triangulation;
use super::map::{MapNotes, grid_map};
use super::repair::{Repaired, repair, trim};
use super::result::{Distances, RemeshMeasures, Samples, Shape, Tally, places, verify};
use super::surface::{InputSurface, Prepared};
use super::{Boundary, MapOptions, PanelSize, RemeshError, RemeshObserver, RemeshStage};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point};
use crate::words;

/// A mesh of quads along the lines of curvature of another mesh.
#[derive(Clone, Debug)]
pub struct Remeshed {
    /// Its parts are in the order of those of the input. Without curves and groups.
    pub mesh: Mesh,
    /// Measures of all parts together.
    pub measures: RemeshMeasures,
    /// The greatest level of retry of a part: 0 follows the curvature as asked, 3 not at all.
    pub level: u32,
    /// What the reader should know.
    pub notes: Vec<RemeshNote>,
}

/// A sentence about a result, with the places that it names.
#[derive(Clone, Debug, PartialEq)]
pub struct RemeshNote {
    /// The sentence.
    pub words: String,
    /// In the unit of the mesh; empty if it concerns the whole.
    pub places: Vec<Vec3<f64>>,
}

/// The result of one connected part.
struct Part {
    positions: Vec<Vec3<f64>>,
    faces: Vec<Vec<usize>>,
    samples: Samples,
    shape: Shape,
    size: f64,
    level: u32,
    /// Where faces were repaired or panels are turned over.
    lost: Vec<Vec3<f64>>,
}

/// Covers the surface of a mesh with quads along its lines of curvature. `units` is the symbol of
/// the unit of the mesh, for sentences; empty if it is not known.
///
/// # Errors
/// If a part of the surface cannot be covered; nothing is changed then.
pub fn remesh(
    mesh: &Mesh,
    options: &MapOptions,
    units: &str,
    observer: &mut RemeshObserver<'_>,
) -> Result<Remeshed, RemeshError> {
    let surfaces = InputSurface::components(mesh)?;
    let area: f64 = surfaces.iter().map(InputSurface::area).sum();
    let size = match options.size {
        PanelSize::Length(length) => length,
        PanelSize::Count(count) => (area / count.max(1) as f64).sqrt(),
    };
    let count = surfaces.len() as f64;
    let mut parts = Vec::new();
    for (k, surface) in surfaces.iter().enumerate() {
        let wanted = match options.size {
            PanelSize::Length(_) => None,
            PanelSize::Count(count) => Some(count as f64 * surface.area() / area),
        };
        let mut of_part =
            |stage: RemeshStage, share: f64| observer(stage, (k as f64 + share) / count);
        parts.push(part(mesh, surface, size, wanted, options, &mut of_part)?);
    }
    if !observer(RemeshStage::Verify, 1.0) {
        return Err(RemeshError::Cancelled);
    }
    Ok(together(mesh, parts, options.boundary == Boundary::Cut, units))
}

/// Divisors of the weight of alignment, tried in turn if a result is not a surface like its input.
const ATTEMPTS: [f64; 3] = [1.0, 16.0, f64::INFINITY];
/// Input vertices farther than this many panels from the result are not followed.
const FAR: f64 = 1.0;
/// Places nearer to each other than this many panels are one.
const NEAR: f64 = 2.5;
/// A panel follows a surface that turns by no more than this along it, in radians.
const TURN: f64 = 1.0;

/// Remeshes one part, by several attempts if the result is not a surface like it.
fn part(
    mesh: &Mesh,
    input: &InputSurface,
    size: f64,
    wanted: Option<f64>,
    options: &MapOptions,
    observer: &mut RemeshObserver<'_>,
) -> Result<Part, RemeshError> {
    let prepared = input.prepare(size, options)?;
    let expected = Shape::of(&prepared.surface.triangles);
    let mut first: Option<Fault> = None;
    for divisor in ATTEMPTS {
        let options = MapOptions { follow: options.follow / divisor, ..*options };
        let (map, notes) = grid_map(&prepared, &options, wanted, observer)?;
        for careful in [false, true] {
            if !observer(RemeshStage::Extract, if careful { 0.5 } else { 0.0 }) {
                return Err(RemeshError::Cancelled);
            }
            let extraction = extract(&prepared.surface, &map, careful);
            let (part, boundary) = finish(mesh, &prepared, extraction, &notes, options.boundary);
            let fits = |face: &[usize]| {
                let trimmed =
                    options.boundary == Boundary::Cut && face.iter().any(|&v| boundary[v]);
                face.len() == 4 || trimmed && (3..=5).contains(&face.len())
            };
            let (shape, faults) = verify(&part.faces, expected, fits);
            if faults.is_empty() {
                return Ok(Part { shape, ..part });
            }
            first = first.or(faults.first().copied());
        }
    }
    let fault = first.expect("an attempt failed");
    Err(RemeshError::NotFollowed { fault })
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
    let Repaired { mut faces, replaced } = repair(&mut nodes, cells, is_trimmed);
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

/// The position of a node; exactly that of the vertex of the input on which it lies.
fn position(mesh: &Mesh, surface: &Triangulation, node: &Node) -> Vec3<f64> {
    let of_input = match node.place {
        Place::Vertex(v) if surface.positions[v] == node.position => surface.vertices[v],
        _ => None,
    };
    of_input.map_or(node.position, |v| mesh.positions[v as usize].into())
}

/// One mesh of all parts, measured and described.
fn together(input: &Mesh, parts: Vec<Part>, cuts: bool, units: &str) -> Remeshed {
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
    let distances = Distances::between(&mesh, input);
    let mut notes = Vec::new();
    notes.extend(not_followed(&parts, input, &distances, units));
    let measures = tally.measures(
        distances.largest(),
        parts.iter().map(|part| part.shape.loops).sum(),
        parts.iter().map(|part| part.shape.euler).sum(),
    );
    let level = parts.iter().map(|part| part.level).max().unwrap_or(0);
    Remeshed { mesh, measures, level, notes }
}

/// Names the places that the panels cannot follow, and the size of panels that would.
fn not_followed(
    parts: &[Part],
    input: &Mesh,
    distances: &Distances,
    units: &str,
) -> Option<RemeshNote> {
    let size = parts.first()?.size;
    let mut lost: Vec<Vec3<f64>> = parts.iter().flat_map(|part| part.lost.clone()).collect();
    let used = input.used_positions();
    let far = used.iter().zip(&distances.from_input).filter(|(_, d)| **d > FAR * size);
    lost.extend(far.map(|(&point, _)| Vec3::from(point)));
    let places = places(&lost, NEAR * size);
    if places.is_empty() {
        return None;
    }
    let follows = parts.iter().map(|part| follows(part, &places)).fold(0.7 * size, f64::min);
    let count = match places.len() {
        1 => "1 place is".to_owned(),
        count => format!("{} places are", words::group_digits(count)),
    };
    let follows = words::rough_length(follows, units);
    let words = format!("{count} smaller than a panel: {follows} or less follows them");
    Some(RemeshNote { words, places })
}

/// The size of panels along which the surface near some places turns by no more than [`TURN`].
fn follows(part: &Part, places: &[Vec3<f64>]) -> f64 {
    let is_near =
        |point: Vec3<f64>| places.iter().any(|&place| (place - point).length() < NEAR * part.size);
    let curvature = part.positions.iter().zip(&part.samples.tensors).map(|(&point, tensor)| {
        let [xx, yy, zz, xy, xz, yz] = *tensor;
        let square = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz);
        if is_near(point) { square.sqrt() } else { 0.0 }
    });
    TURN / curvature.fold(0.0, f64::max).max(1e-300)
}
