//! The example scenes, on meshes that the project's own generators make: first three models to play
//! with, then the figures of the paper, whose numbers begin their ids, and lessons.
//!
//! | file | holds |
//! |---|---|
//! | `first` | canopy, dome and hypar |
//! | `overview` | Fig. 1 |
//! | `squares` | Fig. 4 |
//! | `panels` | Fig. 5: planar and circular panels |
//! | `exploration` | Fig. 6: shapes of circular meshes and webs under handles |
//! | `quality` | Fig. 7: better quads on a surface with creases |
//! | `deformation` | Fig. 8: rigid and similar elements under handles |
//! | `flat_maps` | Fig. 9: conformal parametrisation |
//! | `recovery` | Fig. 10: from a collapsed start, and from a scattered one |
//! | `strip` | Fig. 11: edges that collapse |
//! | `suggestions` | what some offer to look at |
//! | `curves_and_points` | curves on a mesh, points without faces |
//! | `exercise` | a lesson to hand in |

mod curves_and_points;
mod deformation;
mod exercise;
mod exploration;
mod first;
mod flat_maps;
mod overview;
mod panels;
mod quality;
mod recovery;
mod squares;
mod strip;
mod suggestions;

pub use suggestions::{Shows, Side, Suggestion, suggestions};

use super::{ConstraintSpec, HandleSpec, Hold, MeshSource, Scene};
use crate::constraint::{Element, Kind, Selector};
use crate::mesh::{Mesh, Point};

/// A scene to start from.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The name of its files without their endings; that of a figure begins with its number.
    pub id: &'static str,
    /// Shown as the name of the model.
    pub title: &'static str,
    /// What to look for, in one sentence.
    pub summary: &'static str,
    /// What is measured when it is solved with its own settings, in one sentence; tests check it.
    pub statement: &'static str,
    /// How the name of its mesh file ends: `obj`, or `mesh` (Medit) where there are tetrahedra.
    ending: &'static str,
    make: fn(&mut Scene) -> Mesh,
}

/// All examples; the page opens the first.
pub const EXAMPLES: &[Example] = &[
    first::CANOPY,
    first::DOME,
    first::HYPAR,
    overview::OVERVIEW,
    overview::TRIANGLES,
    overview::TETRAHEDRA,
    squares::SQUARES,
    panels::PLANAR,
    panels::CIRCULAR,
    panels::MIXED,
    exploration::LANTERN,
    exploration::WEB,
    quality::ARCHWAY,
    deformation::PROTRUSIONS,
    deformation::RINGS[0],
    deformation::RINGS[1],
    deformation::RINGS[2],
    deformation::BLOCKS,
    deformation::BAR_POLYGONS,
    deformation::BAR_RINGS,
    deformation::BAR_TETS,
    flat_maps::MASK,
    flat_maps::POLYGONS,
    recovery::COLLAPSE,
    recovery::RANDOM,
    strip::STRIP,
    curves_and_points::SLABS,
    curves_and_points::POINTS,
    exercise::GLASS_ROOF,
];

impl Example {
    /// The name of its scene file.
    pub fn file(&self) -> String {
        format!("{}.shapeup.json", self.id)
    }

    /// The name of its mesh file, beside the scene.
    pub fn mesh_file(&self) -> String {
        format!("{}.{}", self.id, self.ending)
    }

    /// The scene, which names its mesh as a file beside it, and that mesh.
    pub fn build(&self) -> (Scene, Mesh) {
        let mut scene = Scene::new(MeshSource::File(self.mesh_file()));
        scene.title = self.title.to_owned();
        scene.units = "m".to_owned();
        let mesh = (self.make)(&mut scene);
        (scene, mesh)
    }
}

fn each(element: Element) -> Selector {
    Selector::Each { element, within: None, radius: 0 }
}

fn constraint(id: &str, on: Selector, weight: f64) -> ConstraintSpec {
    let kind = Kind::new(id, serde_json::json!({})).expect("the kind is in the list of kinds");
    ConstraintSpec { kind, on, weight, enabled: true, name: String::new() }
}

/// Vertices that stay where they are.
fn fixed(vertices: Vec<u32>) -> HandleSpec {
    HandleSpec { vertices, targets: None, hold: Hold::Fixed }
}

/// Vertices that are put elsewhere.
fn moved(mesh: &Mesh, vertices: Vec<u32>, to: impl Fn(Point) -> Point) -> HandleSpec {
    let targets = vertices.iter().map(|&v| to(mesh.positions[v as usize])).collect();
    HandleSpec { vertices, targets: Some(targets), hold: Hold::Fixed }
}
