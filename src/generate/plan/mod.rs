//! A mesh from a plan: a closed outline on the ground, divided into panels and raised as a net that
//! hangs under its own weight, turned upside down.

mod cut;
mod declaration;
mod drawing;
mod follow;
mod kept;
mod outline;

pub use declaration::{Plan, PlanError, PlanLayout, PlanPoint, PlanSide, Support};
pub use drawing::{
    DrawnSide, PlanDrawing, PlanLoops, bulge_of, bulge_through, end_of_side, loop_through,
};

use crate::math::{Vec3, marked, twice_vector_area};
use crate::mesh::{Mesh, Topology};
use crate::sparse::{BlockMatrix, SymbolicAnalysis};
use declaration::entry;
use outline::{FlatPlan, Loop};
use std::collections::BTreeSet;

/// Force density of free edges relative to edges between panels: they are arches that carry the
/// rest.
const FREE_EDGE: f64 = 4.0;

/// The surface over a plan.
#[derive(Clone, Debug)]
pub struct PlanSurface {
    /// The mesh; `z = 0` is the ground.
    pub mesh: Mesh,
    /// The corners that it stands on, to be fixed by handles; empty if it stands on its outline.
    pub feet: Vec<u32>,
}

impl Plan {
    /// The surface over the plan: faces are counterclockwise seen from above, `z = 0` is the
    /// ground.
    ///
    /// # Errors
    /// If a number is out of its limits, sides cross, or the plan cannot be divided as requested.
    pub fn surface(&self) -> Result<PlanSurface, PlanError> {
        let expect = |path: &str, found: f64, is_good: bool, expected: &str| match is_good {
            true => Ok(()),
            false => Err(entry(path, format!("expected {expected}, found {found}"))),
        };
        let Plan { size, turn, height, .. } = *self;
        expect("size", size, (1e-6..=1e6).contains(&size), "a length from 0.000001 to 1000000")?;
        expect("height", height, (0.0..=1e6).contains(&height), "a length from 0 to 1000000")?;
        expect("turn", turn, (-360.0..=360.0).contains(&turn), "an angle in degrees")?;
        let outline = Loop::of(&self.outline, None)?;
        let holes = (0..).zip(&self.holes).map(|(k, hole)| Loop::of(hole, Some(k)));
        let holes = holes.collect::<Result<Vec<_>, _>>()?;
        let loops: Vec<&Loop> = std::iter::once(&outline).chain(&holes).collect();
        Loop::check_disjoint(&loops)?;
        let flat = match self.layout {
            PlanLayout::Follow if !holes.is_empty() => return Err(PlanError::Holes),
            PlanLayout::Follow => follow::mesh(&outline, size)?,
            PlanLayout::Cut => cut::mesh(&loops, size, turn)?,
        };
        raised(flat, self.support, height)
    }

    /// The mesh of the surface, without its supports.
    ///
    /// # Errors
    /// As [`Plan::surface`].
    pub fn mesh(&self) -> Result<Mesh, PlanError> {
        Ok(self.surface()?.mesh)
    }
}

/// Raises the mesh until its highest vertex is at `height`. All inner edges have the same force
/// density, loads are the areas around vertices (Schek 1974), and supported vertices stay at zero.
fn raised(flat: FlatPlan, support: Support, height: f64) -> Result<PlanSurface, PlanError> {
    let FlatPlan { mut mesh, outline, corners } = flat;
    let (held, feet) = match support {
        Support::Corners if corners.len() < 3 => {
            return Err(PlanError::TooFewCorners(corners.len()));
        }
        Support::Corners => {
            // Tips close to each other can have one foot, until panels are smaller.
            let mut feet = BTreeSet::new();
            if let Some((_, hole)) = corners.iter().find(|(v, _)| !feet.insert(*v)) {
                return Err(PlanError::TooCoarse(*hole));
            }
            let feet: Vec<u32> = corners.iter().map(|(v, _)| *v).collect();
            (feet.clone(), feet)
        }
        Support::Outline => (outline, Vec::new()),
    };
    let n = mesh.positions.len();
    let topology = Topology::new(&mesh);
    let analysis = SymbolicAnalysis::of_edges(n, topology.edges().iter().copied());
    let node_of = analysis.position_of();
    let fixed = marked(n, held.iter().map(|&v| node_of[v as usize]));
    // The blocks are multiples of the identity; the first coordinate is the height.
    let mut matrix = BlockMatrix::new(&analysis);
    for (e, ends) in (0..).zip(topology.edges()) {
        let density = if topology.is_boundary_edge(e) { FREE_EDGE } else { 1.0 };
        let [p, q] = ends.map(|v| node_of[v as usize]);
        let on_diagonal = |value: f64| move |r, c| if r == c { value } else { 0.0 };
        matrix.add(p, p, on_diagonal(density));
        matrix.add(q, q, on_diagonal(density));
        // Supported vertices are at zero: they add nothing to their neighbours' equations.
        if !fixed[p as usize] && !fixed[q as usize] {
            matrix.add(p.min(q), p.max(q), on_diagonal(-density));
        }
    }
    let mut loads = vec![[0.0; 4]; n];
    for face in mesh.faces.iter() {
        let area =
            twice_vector_area(face.iter().map(|&v| Vec3::from(mesh.positions[v as usize]))).z;
        for &v in face {
            let node = node_of[v as usize] as usize;
            if !fixed[node] {
                loads[node][0] += area / face.len() as f64;
            }
        }
    }
    // The height of a piece without support is undetermined.
    let components = analysis.components();
    let is_held = marked(n, (0..n).filter(|&k| fixed[k]).map(|k| components[k]));
    if components.iter().any(|&part| !is_held[part as usize]) {
        return Err(PlanError::NoSupport);
    }
    // Every piece has a support, so the matrix is not singular.
    matrix.factor(&fixed).map_err(|_| PlanError::NoSupport)?;
    matrix.solve(&mut loads);
    let top = loads.iter().map(|load| load[0]).fold(0.0, f64::max);
    if top > 0.0 {
        for (position, &node) in mesh.positions.iter_mut().zip(node_of) {
            position[2] = height * loads[node as usize][0] / top;
        }
    }
    Ok(PlanSurface { mesh, feet })
}
