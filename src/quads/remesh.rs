//! The whole way from a mesh to quads along its lines of curvature, part by part. A part that cannot
//! be covered stays as it is.

use super::map::GridMapper;
use super::options::MOST_PANELS;
use super::part::Asked;
use super::remeshed::{note_on_left_out, notes_on, together};
use super::surface::{InputParts, InputSurface, SHORTEST_LOOP, StayingPart};
use super::{Boundary, MapFault, MapOptions, PanelSize, RemeshError, RemeshObserver};
use super::{RemeshStage, Remeshed};
use crate::mesh::Mesh;

/// Sizes that are suggested exceed the least one by this factor: rounded for words, they are not less.
const SUGGESTED: f64 = 1.25;
/// Where panels cannot follow the surface, this part of their size is named.
const SMALLER: f64 = 0.7;
/// Where panels cannot follow a part, or it has too many openings, those less than this many panels around
/// are covered: a crack as long as a panel has no panels of its own on either side.
const LONGER_LOOP: f64 = 4.0;
/// If parts with more than this fraction of the area cannot be covered, nothing is.
const MOST_LEFT: f64 = 0.5;

/// A surface to be covered, with what other settings can use again: its curvature, and while size
/// and creases stay the same, for each choice at the boundary the prepared surface with its fields and maps.
pub struct Remesher {
    mesh: Mesh,
    surfaces: Vec<InputSurface>,
    /// The area of the surfaces.
    area: f64,
    /// Parts that cannot be covered, whatever the settings.
    staying_parts: Vec<StayingPart>,
    /// Faces that are to stay.
    stay: Vec<u32>,
    /// Faces that are left out.
    left_out: Vec<u32>,
    /// The last of each choice at the boundary: both are asked for in turn.
    kept: Vec<Kept>,
}

/// The maps of all parts for panels of one size.
struct Kept {
    size: f64,
    crease: Option<f64>,
    boundary: Boundary,
    /// Two for each part, the second with longer openings covered; none before it is asked for, or if
    /// the part cannot be prepared.
    mappers: Vec<[Option<GridMapper>; 2]>,
}

impl Remesher {
    /// Triangulates the faces of a mesh and measures their curvature.
    ///
    /// # Errors
    /// If no part of the faces is a surface, or if the mesh has tetrahedra.
    pub fn new(mesh: &Mesh) -> Result<Remesher, RemeshError> {
        Remesher::beside(mesh, &[])
    }

    /// The same without some faces, which are to stay as they are. Panels beside them share no vertices
    /// with them. Other faces with a vertex whose position is not in the file are left out.
    ///
    /// # Errors
    /// If no part of the other faces is a surface, or if the mesh has tetrahedra.
    pub fn beside(mesh: &Mesh, stay: &[u32]) -> Result<Remesher, RemeshError> {
        if !mesh.tets.is_empty() {
            return Err(RemeshError::Tetrahedra);
        }
        let mut stay = stay.to_vec();
        stay.sort_unstable();
        stay.dedup();
        let parts = InputSurface::parts(mesh, &stay)?;
        let InputParts { surfaces, staying: staying_parts, left_out } = parts;
        if surfaces.is_empty() {
            let largest = staying_parts.into_iter().max_by(|a, b| a.area.total_cmp(&b.area));
            return Err(largest.map_or(RemeshError::Empty, |part| part.error));
        }
        let area = surfaces.iter().map(InputSurface::area).sum();
        // Curves are not covered.
        let mesh = Mesh { unplaced: mesh.unplaced.clone(), ..mesh.without_faces(&[]) };
        let kept = Vec::new();
        Ok(Remesher { mesh, surfaces, area, staying_parts, stay, left_out, kept })
    }

    /// Number of faces that stay as they are whatever the settings.
    pub fn staying(&self) -> usize {
        self.stay.len() + self.staying_parts.iter().map(|part| part.faces.len()).sum::<usize>()
    }

    /// Covers the surface; see [`remesh`]. The result does not depend on what was asked before.
    ///
    /// # Errors
    /// If most of the surface cannot be covered.
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
        // Each part has the same limit for itself.
        let least = (self.area / MOST_PANELS).sqrt();
        if size < least {
            return Err(RemeshError::SizeTooSmall { least });
        }
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
            mappers: surfaces.iter().map(|_| [None, None]).collect(),
        });
        let mut parts = Vec::new();
        let mut staying_parts = self.staying_parts.clone();
        for (surface, [first, longer]) in surfaces.iter().zip(&mut kept.mappers) {
            observer(RemeshStage::Prepare);
            let smaller = (SMALLER * size > SUGGESTED * least).then_some(SMALLER * size);
            let wanted = surface.area() / (size * size);
            let asked = Asked { mesh, options, wanted, smaller };
            let mut cover = |place: &mut Option<GridMapper>, longest_loop: f64| {
                let mapper = match place {
                    Some(mapper) => mapper,
                    none => none.insert(GridMapper::new(surface.prepare(
                        longest_loop,
                        size,
                        options,
                    )?)),
                };
                asked.part(mapper, observer)
            };
            let mut found = cover(first, SHORTEST_LOOP);
            if let Err(
                RemeshError::NotFollowed { .. }
                | RemeshError::NotMapped { fault: MapFault::TooManyIntegers },
            ) = found
                && surface.covers_more([SHORTEST_LOOP, LONGER_LOOP].map(|panels| panels * size))
            {
                found = cover(longer, LONGER_LOOP).or(found);
            }
            match found {
                Ok(part) => parts.push(part),
                Err(error) if error.is_of_part() => staying_parts.push(surface.staying(error)),
                Err(error) => return Err(error),
            }
        }
        let areas: [f64; 2] =
            [&staying_parts, &self.staying_parts].map(|parts| parts.iter().map(|p| p.area).sum());
        if let Some(worst) = staying_parts.iter().max_by(|a, b| a.area.total_cmp(&b.area))
            && areas[0] > MOST_LEFT * (self.area + areas[1])
        {
            return Err(worst.error.clone());
        }
        observer(RemeshStage::Verify);
        // Of a face that touches itself, triangles can be in two parts.
        let mut stays = vec![false; mesh.faces.len()];
        let all = staying_parts.iter().flat_map(|part| &part.faces).chain(&self.stay).copied();
        let staying: Vec<u32> =
            all.filter(|&face| !std::mem::replace(&mut stays[face as usize], true)).collect();
        let cuts = options.boundary == Boundary::Cut;
        let covered = mesh.without_faces(&[&staying[..], &self.left_out].concat());
        let mut found = together(&covered, parts, cuts, SUGGESTED * least, units);
        found.append(mesh, &staying);
        found.notes.extend(notes_on(&staying_parts, units));
        found.notes.extend(note_on_left_out(mesh, &self.left_out, size));
        self.kept.push(kept);
        Ok(found)
    }
}

/// Covers the surface of a mesh with quads along its lines of curvature. `units` is the symbol of
/// the unit of the mesh, for sentences; empty if it is not known.
///
/// # Errors
/// If the mesh has tetrahedra, or most of the surface cannot be covered.
pub fn remesh(
    mesh: &Mesh,
    options: &MapOptions,
    units: &str,
    observer: &mut RemeshObserver<'_>,
) -> Result<Remeshed, RemeshError> {
    Remesher::new(mesh)?.remesh(options, units, observer)
}
