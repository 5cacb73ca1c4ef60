//! New panels along the lines of curvature of a roof that came as triangles.

use super::parts::{constraint, each};
use crate::constraint::Element;
use crate::generate::example::Example;
use crate::generate::model::Vault;
use crate::mesh::Mesh;
use crate::quads::{MapOptions, PanelSize, remesh};
use crate::scene::{ConstraintSpec, Require, Scene};
use std::rc::Rc;
use std::sync::OnceLock;

pub(super) const VAULT: Example = Example {
    id: "other-new-panels",
    title: "Vault of triangles in circular panels",
    summary: "This vault came as 2,288 irregular triangles. Quads were laid out along its lines of curvature, as New panels does with your own mesh: press Run, and every panel becomes exactly circular. The triangles stay the surface that they are kept close to.",
    statement: "The 480 panels, up to 13 mm from circular, become exactly circular; their corners stay within 16 cm of the triangles.",
    make: vault,
};

/// The number of panels that are asked for.
const PANELS: usize = 500;

/// Panels on the vault as the page and the command line lay them out, which stay close to the triangles.
fn vault(scene: &mut Scene) -> Mesh {
    let triangles = Vault::default().mesh();
    let panels = panels(&triangles);
    let circles = constraint("circle", each(Element::Face), 1.0);
    scene.set_opened_defaults();
    scene.constraints = vec![ConstraintSpec { require: Require::Exact, ..circles }];
    scene.closeness.stay_on(&Rc::new(triangles));
    panels
}

/// The panels, which take a fraction of a second: they are laid out once.
fn panels(triangles: &Mesh) -> Mesh {
    static LAID_OUT: OnceLock<Mesh> = OnceLock::new();
    let lay_out = || {
        let options = MapOptions::of_size(PanelSize::Count(PANELS));
        let found = remesh(triangles, &options, "m", &mut |_, _| true);
        found.expect("the vault is a surface larger than a panel").mesh
    };
    LAID_OUT.get_or_init(lay_out).clone()
}
