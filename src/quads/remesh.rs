//! The whole way from a mesh to quads along its lines of curvature: part by part, checked, measured
//! and put into words.

use super::map::GridMapper;
use super::part::{Asked, Part};
use super::result::{Distances, RemeshMeasures, Tally, places};
use super::surface::InputSurface;
use super::{Boundary, MapOptions, PanelSize, RemeshError, RemeshObserver, RemeshStage};
use crate::math::Vec3;
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

/// A surface to be covered, with what other settings can use again: its curvature, and while size,
/// creases stay the same, for each choice at the boundary the prepared surface with its fields and maps.
pub struct Remesher {
    mesh: Mesh,
    surfaces: Vec<InputSurface>,
    area: f64,
    /// The last of each choice at the boundary: both are asked for in turn.
    kept: Vec<Kept>,
}

/// The maps of all parts for panels of one size.
struct Kept {
    size: f64,
    crease: Option<f64>,
    boundary: Boundary,
    /// One for each part; none if its last map gave creases up, which another one may need.
    mappers: Vec<Option<GridMapper>>,
}

impl Remesher {
    /// Triangulates the faces of a mesh and measures their curvature.
    ///
    /// # Errors
    /// If the faces are no surface.
    pub fn new(mesh: &Mesh) -> Result<Remesher, RemeshError> {
        let surfaces = InputSurface::components(mesh)?;
        let area = surfaces.iter().map(InputSurface::area).sum();
        // Curves and tetrahedra are not covered.
        let (positions, faces) = (mesh.positions.clone(), mesh.faces.clone());
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        Ok(Remesher { mesh, surfaces, area, kept: Vec::new() })
    }

    /// Covers the surface; see [`remesh`]. The result does not depend on what was asked before.
    ///
    /// # Errors
    /// If a part of the surface cannot be covered.
    pub fn remesh(
        &mut self,
        options: &MapOptions,
        units: &str,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Remeshed, RemeshError> {
        let size = match options.size {
            PanelSize::Length(length) => length,
            PanelSize::Count(count) => (self.area / count.max(1) as f64).sqrt(),
        };
        let Remesher { mesh, surfaces, .. } = self;
        let fits = |kept: &Kept| {
            (kept.size, kept.crease, kept.boundary) == (size, options.crease, options.boundary)
        };
        let last = self.kept.iter().position(|kept| kept.boundary == options.boundary);
        let last = last.map(|place| self.kept.swap_remove(place)).filter(fits);
        let mut kept = last.unwrap_or_else(|| Kept {
            size,
            crease: options.crease,
            boundary: options.boundary,
            mappers: surfaces.iter().map(|_| None).collect(),
        });
        let count = surfaces.len() as f64;
        let mut parts = Vec::new();
        for (k, (surface, place)) in surfaces.iter().zip(&mut kept.mappers).enumerate() {
            let mut of_part =
                |stage: RemeshStage, share: f64| observer(stage, (k as f64 + share) / count);
            if !of_part(RemeshStage::Prepare, 0.0) {
                return Err(RemeshError::Cancelled);
            }
            let mut mapper = match place.take() {
                Some(mapper) => mapper,
                None => GridMapper::new(surface.prepare(size, options)?),
            };
            let wanted = surface.area() / (size * size);
            let part = Asked { mesh, options, wanted }.part(&mut mapper, &mut of_part)?;
            parts.push(part);
            *place = (mapper.prepared().notes.abandoned == 0).then_some(mapper);
        }
        if !observer(RemeshStage::Verify, 1.0) {
            return Err(RemeshError::Cancelled);
        }
        let found = together(mesh, parts, options.boundary == Boundary::Cut, units);
        self.kept.push(kept);
        Ok(found)
    }
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
    Remesher::new(mesh)?.remesh(options, units, observer)
}

/// Input vertices farther than this many panels from the result are not followed.
const FAR: f64 = 1.0;
/// Places nearer to each other than this many panels are one.
const NEAR: f64 = 2.5;
/// A panel follows a surface that turns by no more than this along it, in radians.
const TURN: f64 = 1.0;

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

/// The size of panels along which the surface turns by [`TURN`], at that of some places where it turns
/// most: by the mean curvature of the vertices of a part within a panel.
fn follows(part: &Part, places: &[Vec3<f64>]) -> f64 {
    let of_place = |&place: &Vec3<f64>| {
        let is_near = |point: Vec3<f64>| (place - point).length() < part.size;
        let near = part.positions.iter().zip(&part.samples.tensors).filter(|(p, _)| is_near(**p));
        let curvature = near.map(|(_, &[xx, yy, zz, xy, xz, yz])| {
            (xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
        });
        let (sum, count) = curvature.fold((0.0, 0.0), |(sum, count), one| (sum + one, count + 1.0));
        if sum > 0.0 { TURN * count / sum } else { f64::INFINITY }
    };
    places.iter().map(of_place).fold(f64::INFINITY, f64::min)
}
