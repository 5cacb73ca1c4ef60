//! The panels as an oriented surface: faces with consistent orientation, area vectors, edges with
//! the panels on both sides.
//!
//! Coordinates are relative to the centre of the box of all panels, so that site coordinates cost no
//! digits.

use super::fault::Fault;
use crate::math::{Vec3, polygon_sides, twice_vector_area};
use crate::mesh::{Mesh, Ragged, Topology, components, orientation, rings_of, with_holes};

/// The largest area due to rounding, as a fraction of the square of the longest side; and the largest
/// length due to it, as a fraction of a side.
const ROUNDING: f64 = 1e-6;
/// The sides of a panel without area that are nearer than this to a line, relative to their length, lie
/// along it.
const NEAR: f64 = 1e-3;

/// An edge of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The vertices `i < j`.
    pub ends: [u32; 2],
    /// The panel that traverses it from `i` to `j`, and the one that traverses it backwards. One at
    /// the rim; none where more than two panels meet, or two traverse it in the same direction.
    pub panels: [Option<u32>; 2],
}

impl Edge {
    /// The panel across the edge from one of its panels.
    pub fn across(&self, panel: u32) -> Option<u32> {
        match self.panels {
            [Some(left), right] if left == panel => right,
            [left, _] => left,
        }
    }

    /// Whether it is a bridge between the outline of a panel and a hole in it, or between two holes.
    pub fn is_bridge(&self) -> bool {
        matches!(self.panels, [Some(left), Some(right)] if left == right)
    }

    /// Whether it has only one panel.
    pub fn is_rim(&self) -> bool {
        matches!(self.panels, [Some(_), None] | [None, Some(_)])
    }
}

/// The panels of a mesh, oriented.
#[derive(Clone, Debug)]
pub struct PanelSurface {
    /// Vertex positions (`#V by 3`) about `centre`.
    pub positions: Vec<Vec3<f64>>,
    /// The centre of the box.
    pub centre: Vec3<f64>,
    /// The corners of each panel, counterclockwise seen from outside. Its first side is that of the
    /// face in the mesh, or of its outline: see [`PanelSurface::rings`]. Panels with holes are the last
    /// ones.
    pub faces: Ragged,
    /// The sides of faces, each once, with the bridges of panels with holes.
    pub edges: Vec<Edge>,
    /// All panels of each edge.
    pub panels: Ragged,
    /// The edge of each side of each panel; side `k` goes from corner `k` to the next one.
    pub sides: Ragged,
    /// Area vectors: half the sum of the cross products of consecutive corners (Newell).
    pub areas: Vec<Vec3<f64>>,
    /// `N_i`: normalised sum of the area vectors of the panels at a vertex; zero at a vertex
    /// without panels.
    pub normals: Vec<Vec3<f64>>,
    /// The rims, as loops of vertices.
    pub rims: Ragged,
    /// Number of connected components.
    pub parts: usize,
    /// Number of faces of the mesh that are not among its panels: those of [`Mesh::untouched`] that are
    /// no panels with holes.
    pub untouched: usize,
    /// Panels that were reversed to agree with most of their component.
    pub turned: usize,
    /// Why the surface has no outside; none if it has one.
    pub one_sided: Option<Fault>,
}

impl PanelSurface {
    /// Orients the panels of a mesh.
    ///
    /// # Errors
    /// If the mesh has no faces, as points and curves have no panels, or a corner of a face has no
    /// position in the file.
    pub fn new(mesh: &Mesh) -> Result<PanelSurface, Fault> {
        let is_unplaced = |v: &&u32| mesh.unplaced.binary_search(v).is_ok();
        let mut own_faces = mesh.faces.clone();
        for face in mesh.untouched.iter().filter(|face| !face.iter().any(|v| is_unplaced(&v))) {
            if let Some(face) = with_holes(face, &mesh.positions) {
                own_faces.push(&face);
            }
        }
        let untouched = mesh.faces.len() + mesh.untouched.len() - own_faces.len();
        if own_faces.is_empty() {
            return Err(match untouched {
                0 => Fault::no_panels(mesh),
                faces => Fault::untouched(faces),
            });
        }
        if let Some(&vertex) = mesh.faces.indices().iter().find(is_unplaced) {
            return Err(Fault::unplaced(vertex));
        }
        let only_faces =
            Mesh { positions: mesh.positions.clone(), faces: own_faces, ..Mesh::default() };
        let topology = Topology::new(&only_faces);
        let (turned, contradictions) = orientation(&only_faces.faces, &topology);
        let crowded = topology.edge_faces().iter().filter(|faces| faces.len() > 2).count();
        let one_sided = match contradictions.last() {
            Some(&edge) => Some(Fault::one_sided(topology.edges()[edge as usize])),
            None => (crowded > 0).then(|| Fault::crowded_edges(crowded)),
        };
        let mut faces = Ragged::new();
        for (face, &turned) in only_faces.faces.iter().zip(&turned) {
            match turned {
                false => faces.push(face),
                true => faces.push(&reversed(face)),
            }
        }
        let (positions, centre) = about_the_centre(&mesh.positions, &faces);
        let (areas, normals) = areas_and_normals(&positions, &faces);
        let mut sides = Ragged::new();
        let mut edges: Vec<Edge> =
            topology.edges().iter().map(|&ends| Edge { ends, panels: [None; 2] }).collect();
        for (f, face) in faces.iter().enumerate() {
            let of_face: Vec<u32> =
                polygon_sides(face).filter_map(|[a, b]| topology.edge(a, b)).collect();
            for (&e, [a, b]) in of_face.iter().zip(polygon_sides(face)) {
                let side = usize::from(a > b);
                edges[e as usize].panels[side].get_or_insert(f as u32);
            }
            sides.push(&of_face);
        }
        let panels = topology.edge_faces().clone();
        for (edge, own) in edges.iter_mut().zip(panels.iter()) {
            if own.len() > edge.panels.iter().flatten().count() {
                edge.panels = [None; 2];
            }
        }
        Ok(PanelSurface {
            panels,
            rims: topology.boundary_loops().clone(),
            parts: count_parts(&positions, &faces),
            untouched,
            turned: turned.iter().filter(|&&turned| turned).count(),
            positions,
            centre,
            faces,
            edges,
            sides,
            areas,
            normals,
            one_sided,
        })
    }

    /// The sides of a panel, by the rings to which they belong: its outline, counterclockwise seen from
    /// outside, then its holes, clockwise. Side `k` begins at corner `k`.
    pub fn rings(&self, panel: u32) -> Vec<Vec<usize>> {
        let sides = self.sides.row(panel as usize);
        let bridge = |k: usize| Some(sides[k]).filter(|&e| self.edges[e as usize].is_bridge());
        rings_of(sides.len(), bridge).unwrap_or_else(|| vec![(0..sides.len()).collect()])
    }

    /// Whether a panel has holes.
    pub fn has_holes(&self, panel: u32) -> bool {
        self.sides.row(panel as usize).iter().any(|&e| self.edges[e as usize].is_bridge())
    }

    /// The other panels of an edge of a panel, also where there are several.
    pub fn others(&self, edge: u32, panel: u32) -> impl Iterator<Item = u32> + '_ {
        self.panels.row(edge as usize).iter().copied().filter(move |&other| other != panel)
    }

    /// The panels that a panel meets at an edge: those beyond it, and beyond panels without area.
    pub fn neighbours_across(&self, edge: u32, panel: u32) -> Vec<u32> {
        let mut found: Vec<u32> = Vec::new();
        for f in
            self.others(edge, panel).flat_map(|other| self.panels_beyond_degenerate(edge, other))
        {
            if f != panel && !found.contains(&f) {
                found.push(f);
            }
        }
        found
    }

    /// A panel, as one of its edges sees it: itself, or if it has no area, so that nothing is made of it,
    /// those that lie along the edge beyond it.
    pub fn panels_beyond_degenerate(&self, edge: u32, panel: u32) -> Vec<u32> {
        if self.has_area(panel) {
            return vec![panel];
        }
        let own = &self.edges[edge as usize];
        let (t, origin) = (self.direction(own), self.at(own.ends[0]));
        let length = self.length(own);
        let is_beside = |e: u32| {
            let other = &self.edges[e as usize];
            let steps = other.ends.map(|v| self.at(v) - origin);
            let [a, b] = steps.map(|step| step.dot(t));
            // One that is twisted has no area either, and its sides lie apart.
            let aside = steps.map(|step| (step - t * step.dot(t)).length());
            a.max(b).min(length) - a.min(b).max(0.0) > ROUNDING * length
                && aside[0].max(aside[1]) < NEAR * length.max(self.length(other))
        };
        let (mut found, mut reached, mut next) = (Vec::new(), vec![(panel, edge)], 0);
        while let Some(&(f, entered)) = reached.get(next) {
            next += 1;
            if self.has_area(f) {
                found.push(f);
                continue;
            }
            let sides = self.sides.row(f as usize).iter().copied();
            for side in sides.filter(|&side| side != entered && is_beside(side)) {
                for other in self.others(side, f) {
                    if reached.iter().all(|(known, _)| *known != other) {
                        reached.push((other, side));
                    }
                }
            }
        }
        found
    }

    /// Whether a panel has an area; of one without, nothing is made.
    pub fn has_area(&self, panel: u32) -> bool {
        self.areas[panel as usize] != Vec3::zero()
    }

    /// Whether two panels that are made can be joined along an edge: one on either side.
    pub fn is_joined(&self, edge: &Edge) -> bool {
        edge.panels.iter().all(|panel| panel.is_some_and(|f| self.has_area(f)))
    }

    /// The edges where panels meet that are not one on either side, with these panels: more than two
    /// meet there, two traverse it in the same direction, or there is one without area between them.
    /// Such panels can be cut but not joined.
    pub fn unpaired(&self) -> impl Iterator<Item = (u32, Vec<u32>)> {
        let apart = (0..).zip(&self.edges).filter(|(_, edge)| !self.is_joined(edge));
        apart.filter_map(|(e, _)| {
            // What lies along a panel without area is on one side of it: at the rim it meets nothing.
            let own =
                self.panels.row(e as usize).iter().map(|&f| self.panels_beyond_degenerate(e, f));
            let sides: Vec<Vec<u32>> = own.filter(|made| !made.is_empty()).collect();
            let mut panels = sides.concat();
            panels.sort_unstable();
            panels.dedup();
            (sides.len() > 1 && panels.len() > 1).then_some((e, panels))
        })
    }

    /// Moves its vertices to `positions` (`#V by 3`).
    pub fn move_to(&mut self, positions: &[[f64; 3]]) {
        (self.positions, self.centre) = about_the_centre(positions, &self.faces);
        (self.areas, self.normals) = areas_and_normals(&self.positions, &self.faces);
    }

    /// The panels at each vertex, `#V`.
    pub fn panels_around(&self) -> Vec<Vec<u32>> {
        let mut around = vec![Vec::new(); self.positions.len()];
        for (face, f) in self.faces.iter().zip(0..) {
            for &v in face {
                let own: &mut Vec<u32> = &mut around[v as usize];
                // At the end of a bridge a panel has two corners.
                if own.last() != Some(&f) {
                    own.push(f);
                }
            }
        }
        around
    }

    /// The position of a vertex, relative to `centre`.
    pub fn at(&self, v: u32) -> Vec3<f64> {
        self.positions[v as usize]
    }

    /// From the first to the second end of an edge.
    pub fn along(&self, edge: &Edge) -> Vec3<f64> {
        self.at(edge.ends[1]) - self.at(edge.ends[0])
    }

    /// The length of an edge.
    pub fn length(&self, edge: &Edge) -> f64 {
        self.along(edge).length()
    }

    /// `t_e`: the unit vector along an edge; zero if it has no length, or is a bridge, along which nothing
    /// is made.
    pub fn direction(&self, edge: &Edge) -> Vec3<f64> {
        if edge.is_bridge() { Vec3::zero() } else { unit(self.along(edge)) }
    }

    /// The edges that are no bridges.
    pub fn real_edges(&self) -> impl Iterator<Item = &Edge> {
        self.edges.iter().filter(|edge| !edge.is_bridge())
    }

    /// The edges with a length, along which beams are, with their `t_e`.
    pub fn beams(&self) -> impl Iterator<Item = (&Edge, Vec3<f64>)> {
        let all = self.edges.iter().map(|edge| (edge, self.direction(edge)));
        all.filter(|(_, t)| *t != Vec3::zero())
    }

    /// The mean length of the edges.
    pub fn mean_edge(&self) -> f64 {
        let total: f64 = self.real_edges().map(|edge| self.length(edge)).sum();
        total / self.real_edges().count().max(1) as f64
    }

    /// `N_f`: the unit normal of a panel; zero if it has no area.
    pub fn normal(&self, panel: u32) -> Vec3<f64> {
        unit(self.areas[panel as usize])
    }

    /// The fold of an edge in radians: 180 degrees minus the dihedral angle, positive for a ridge
    /// seen from outside; the largest one where several panels meet beyond one without area. None at
    /// the rim, and without length.
    pub fn fold(&self, edge: &Edge) -> Option<f64> {
        let ([Some(left), Some(right)], t) = (edge.panels, self.direction(edge)) else {
            return None;
        };
        let mut sides = self.sides.row(left as usize).iter().copied();
        let e = sides.find(|&e| self.edges[e as usize].ends == edge.ends)?;
        let [left, right] = [left, right].map(|panel| self.panels_beyond_degenerate(e, panel));
        let fold = |(f, g): (u32, u32)| {
            let (n, m) = (self.normal(f), self.normal(g));
            libm::atan2(t.dot(n.cross(m)), n.dot(m))
        };
        let both = left.iter().flat_map(|&f| right.iter().map(move |&g| (f, g)));
        let folds = both.filter(|_| t != Vec3::zero()).map(fold);
        folds.max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// The bevel of the sides of both panels at an edge in radians, from square, so that they meet in the
    /// plane between them: half of the fold. Positive at a ridge, where the inside is cut back. None where
    /// more than two panels meet.
    pub fn bevel(&self, e: u32) -> Option<f64> {
        let is_of_two = self.panels.row(e as usize).len() <= 2;
        self.fold(&self.edges[e as usize]).filter(|_| is_of_two).map(|fold| 0.5 * fold)
    }
}

/// Normalises a vector; zero if it has no direction.
pub(super) fn unit(v: Vec3<f64>) -> Vec3<f64> {
    v.length_and_direction().1.unwrap_or(Vec3::zero())
}

/// The area vectors of panels, and the normals of vertices. Panels whose area is due to rounding
/// have none: its direction is random.
fn areas_and_normals(positions: &[Vec3<f64>], faces: &Ragged) -> (Vec<Vec3<f64>>, Vec<Vec3<f64>>) {
    let at = |v: u32| positions[v as usize];
    let area = |face: &[u32]| {
        let area = twice_vector_area(face.iter().map(|&v| at(v))) * 0.5;
        let sides = polygon_sides(face).map(|[a, b]| (at(b) - at(a)).length());
        let longest = sides.fold(0.0, f64::max);
        if area.length() > ROUNDING * longest * longest { area } else { Vec3::zero() }
    };
    let areas: Vec<_> = faces.iter().map(area).collect();
    let mut normals = vec![Vec3::zero(); positions.len()];
    for (face, area) in faces.iter().zip(&areas) {
        face.iter().for_each(|&v| normals[v as usize] += *area);
    }
    normals.iter_mut().for_each(|normal| *normal = unit(*normal));
    (areas, normals)
}

/// Positions relative to the centre of the box of all panels, and that centre.
fn about_the_centre(positions: &[[f64; 3]], faces: &Ragged) -> (Vec<Vec3<f64>>, Vec3<f64>) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for &v in faces.indices() {
        let point = positions[v as usize];
        for k in 0..3 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    let centre = Vec3::from(std::array::from_fn(|k| 0.5 * low[k] + 0.5 * high[k]));
    (positions.iter().map(|&point| Vec3::from(point) - centre).collect(), centre)
}

fn count_parts(positions: &[Vec3<f64>], faces: &Ragged) -> usize {
    let labels = components(positions.len(), faces.iter());
    distinct(faces.iter().map(|face| labels[face[0] as usize])).len()
}

/// The distinct indices in ascending order.
pub(super) fn distinct(indices: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut is_there: Vec<bool> = Vec::new();
    for index in indices {
        let needed = index as usize + 1;
        if is_there.len() < needed {
            is_there.resize(needed, false);
        }
        is_there[index as usize] = true;
    }
    (0..).zip(is_there).filter(|(_, is_there)| *is_there).map(|(index, _)| index).collect()
}

/// The corners of a face backwards. Its first side stays the first one, from which rotations and strips
/// are counted.
fn reversed(face: &[u32]) -> Vec<u32> {
    let (first, rest) = face.split_at(face.len().min(2));
    first.iter().rev().chain(rest.iter().rev()).copied().collect()
}
