//! A part of the input prepared for panels of one size: refined, with features and their tangents
//! (sections 4.1 and 4.2 of `reference/quads.md`).

use super::chains::Chains;
use super::edges::Edges;
use super::features;
use super::input::InputSurface;
use super::openings::{Opening, SHORTEST_LOOP};
use super::refine::{Line, Refined};
use super::wedges::wedges;
use crate::math::Vec3;
use crate::mesh::Tensor;
use crate::quads::options::MOST_PANELS;
use crate::quads::{Boundary, MapOptions, RemeshError, Side, Triangulation};

/// Connected creases shorter than this many panels are noise.
const SHORTEST_CREASE: f64 = 6.0;

/// A connected surface, ready for its field.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The refined surface.
    pub surface: Triangulation,
    /// Side of a panel, in the unit of the mesh.
    pub size: f64,
    /// `#V`: the second fundamental form, interpolated linearly.
    pub(crate) tensors: Vec<Tensor>,
    /// `#T by 3`: for feature sides the tangent of the feature, in the direction of the side.
    pub(crate) tangents: Vec<[Vec3<f64>; 3]>,
    /// `#T`: a direction of the field given by a sharp wedge.
    pub(crate) wedges: Vec<Option<Vec3<f64>>>,
    /// What the panels cannot follow.
    pub notes: PrepareNotes,
}

impl Prepared {
    /// Follows the features that the surface marks: tangents, wedges, and creases that are dropped
    /// beside other features.
    fn with_features(
        mut surface: Triangulation,
        tensors: Vec<Tensor>,
        size: f64,
        notes: PrepareNotes,
    ) -> Prepared {
        let edges = Edges::new(&surface.triangles);
        let mut is_feature: Vec<bool> =
            edges.sides.iter().map(|sides| surface.is_feature(sides[0])).collect();
        let is_crease = |e: usize| edges.sides[e].len() == 2;
        let mut tangents = vec![Vec3::zero(); edges.ends.len()];
        let chains = Chains::new(&surface.positions, &edges, &is_feature);
        chains.tangents(&edges, size, &mut tangents);
        let dropped = chains.too_close(size, is_crease);
        for &e in &dropped {
            is_feature[e] = false;
            edges.sides[e].iter().for_each(|s| surface.feature[s.triangle][s.side] = false);
        }
        // Beside a crease that is dropped there is no wedge.
        let wedges = wedges(&surface, size);
        let of_side = |t: usize| {
            [0, 1, 2].map(|k| {
                let e = edges.of_side[t][k];
                let ascends = surface.triangles[t][k] == edges.ends[e][0];
                if ascends { tangents[e] } else { -tangents[e] }
            })
        };
        let tangents = (0..surface.triangles.len()).map(of_side).collect();
        Prepared { surface, size, tensors, tangents, wedges, notes }
    }

    /// The same surface without the connected creases on which these sides lie: the grid cannot
    /// follow them with panels of this size.
    pub(crate) fn without_creases(&self, sides: &[Side]) -> Prepared {
        let edges = Edges::new(&self.surface.triangles);
        let is_crease =
            |e: usize| edges.sides[e].len() == 2 && self.surface.is_feature(edges.sides[e][0]);
        let mut at_vertex: Vec<Vec<usize>> = vec![Vec::new(); self.surface.positions.len()];
        for e in (0..edges.ends.len()).filter(|&e| is_crease(e)) {
            edges.ends[e].iter().for_each(|&v| at_vertex[v].push(e));
        }
        let mut surface = self.surface.clone();
        let mut queue: Vec<usize> =
            sides.iter().map(|side| edges.of_side[side.triangle][side.side]).collect();
        let mut notes = self.notes.clone();
        while let Some(e) = queue.pop() {
            let own = &edges.sides[e];
            if !is_crease(e) || !surface.is_feature(own[0]) {
                continue;
            }
            let [a, b] = edges.ends[e].map(|v| self.surface.positions[v]);
            notes.dropped.push((a + b) * 0.5);
            own.iter().for_each(|s| surface.feature[s.triangle][s.side] = false);
            queue.extend(edges.ends[e].iter().flat_map(|&v| &at_vertex[v]));
        }
        Prepared::with_features(surface, self.tensors.clone(), self.size, notes)
    }
}

/// What panels of the size cannot follow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PrepareNotes {
    /// The middles of crease edges of the surface that are dropped, because they are nearer to each
    /// other than a panel.
    pub dropped: Vec<Vec3<f64>>,
    /// Openings that are covered, because they are too short for a line of panels around them.
    pub openings: Vec<Opening>,
}

impl InputSurface {
    /// Prepares the surface for panels of the side `size`. Openings less than `longest_loop` panels around
    /// are covered, as far as they can be; those of less than two have to be.
    ///
    /// # Errors
    /// If the size is out of range for this surface.
    pub fn prepare(
        &self,
        longest_loop: f64,
        size: f64,
        options: &MapOptions,
    ) -> Result<Prepared, RemeshError> {
        self.check(size)?;
        let (covered, openings) =
            self.without_openings([SHORTEST_LOOP, longest_loop].map(|panels| panels * size))?;
        let InputSurface { positions, triangles, vertices, tensors, .. } = covered.into_owned();
        let shortest = SHORTEST_CREASE * size;
        let lines = features::lines(&positions, &triangles, options.crease, shortest);
        let vertices = vertices.into_iter().map(Some).collect();
        let mut refined = Refined { positions, tensors, vertices, triangles, lines };
        let on_feature = |line: Line| match line {
            Line::None => false,
            Line::Crease => true,
            Line::Boundary => options.boundary == Boundary::Followed,
        };
        refined.split_long(size);
        refined.separate(on_feature);
        let Refined { positions, tensors, vertices, triangles, lines } = refined;
        let surface = Triangulation {
            neighbours: Edges::new(&triangles).neighbours(),
            feature: lines.iter().map(|sides| sides.map(on_feature)).collect(),
            positions,
            triangles,
            vertices,
        };
        let notes = PrepareNotes { dropped: Vec::new(), openings };
        Ok(Prepared::with_features(surface, tensors, size, notes))
    }

    /// Checks the size against the area; the greatest size that it names leaves room for the openings
    /// that cannot be covered.
    fn check(&self, size: f64) -> Result<(), RemeshError> {
        let least = (self.area() / MOST_PANELS).sqrt();
        if !(size >= least && size.is_finite()) {
            return Err(RemeshError::SizeTooSmall { least });
        }
        let whole = 0.5 * self.area().sqrt();
        if size <= whole {
            return Ok(());
        }
        let (greatest, at) = match self.without_openings([SHORTEST_LOOP * whole; 2]) {
            Err(RemeshError::Opening { greatest, at, .. }) => (greatest, at),
            _ => (whole, self.positions[0]),
        };
        Err(RemeshError::SizeTooLarge { greatest, at })
    }
}
