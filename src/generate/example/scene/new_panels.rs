//! New panels along the lines of curvature of surfaces that came as triangles.

use super::parts::{constraint, each};
use crate::constraint::Element;
use crate::generate::example::Example;
use crate::generate::model::{FreeForm, vault};
use crate::mesh::Mesh;
use crate::quads::{MapOptions, PanelSize, remesh};
use crate::scene::{ConstraintSpec, Require, Scene};
use std::rc::Rc;
use std::sync::OnceLock;

pub(super) const VAULT: Example = Example {
    id: "other-new-panels",
    title: "Vault of triangles in circular panels",
    summary: "This vault came as 2288 irregular triangles. Quads were laid out along its lines of curvature, as New panels does with your own mesh: press Run, and every panel becomes exactly circular. The triangles stay the surface that they are kept close to.",
    statement: "The 480 panels, up to 13 mm from circular, become exactly circular; their corners stay within 16 cm of the triangles.",
    make: |scene| {
        static PANELS: OnceLock<Mesh> = OnceLock::new();
        laid_out(scene, vault(), 500, "circle", &PANELS)
    },
};

pub(super) const STATION: Example = Example {
    id: "station-roof",
    title: "Station roof with two bulges",
    summary: "A free-form glass roof that came as triangles. The new panels follow its lines of curvature: a grid in the middle, which at each end turns around two points where only three lines meet. Press Run, and every pane becomes exactly flat.",
    statement: "The 576 panes, up to 33 mm from flat, become exactly flat; their corners stay within 18 cm of the triangles.",
    make: |scene| {
        static PANELS: OnceLock<Mesh> = OnceLock::new();
        laid_out(scene, FreeForm::STATION.mesh(), 600, "plane", &PANELS)
    },
};

pub(super) const PAVILION: Example = Example {
    id: "ring-pavilion",
    title: "Pavilion around a court",
    summary: "An arch runs around a court, high on one side and low on the other. The new panels follow its lines of curvature and close without an irregular point. Press Run, and every panel becomes exactly circular, so that beams meet in nodes without twist.",
    statement: "The 567 panels, up to 17 mm from circular, become exactly circular; their corners stay within 21 cm of the triangles.",
    make: |scene| {
        static PANELS: OnceLock<Mesh> = OnceLock::new();
        laid_out(scene, FreeForm::PAVILION.mesh(), 600, "circle", &PANELS)
    },
};

pub(super) const CHALICE: Example = Example {
    id: "chalice-roof",
    title: "Funnel roof on one column",
    summary: "A roof with four corners falls to its middle and becomes the column that carries it. The new panels follow its lines of curvature: rings around the column, a grid in the roof, and between them four points where five lines meet. Press Run, and every panel becomes exactly circular.",
    statement: "The 480 panels, up to 33 mm from circular, become exactly circular; their corners stay within 11 cm of the triangles.",
    make: |scene| {
        static PANELS: OnceLock<Mesh> = OnceLock::new();
        laid_out(scene, FreeForm::CHALICE.mesh(), 480, "circle", &PANELS)
    },
};

/// About as many panels on a surface as the page and the command line lay them out, which are to be
/// exactly of a `kind` and stay close to the triangles. It takes a fraction of a second, and is done
/// `once`.
fn laid_out(
    scene: &mut Scene,
    triangles: Mesh,
    count: usize,
    kind: &str,
    once: &OnceLock<Mesh>,
) -> Mesh {
    let lay_out = || {
        let options = MapOptions::of_size(PanelSize::Count(count));
        let found = remesh(&triangles, &options, "m", &mut |_| ());
        found.expect("it is a surface larger than a panel").mesh
    };
    let panels = once.get_or_init(lay_out).clone();
    let row = constraint(kind, each(Element::Face), 1.0);
    scene.set_opened_defaults();
    scene.constraints = vec![ConstraintSpec { require: Require::Exact, ..row }];
    scene.closeness.stay_on(&Rc::new(triangles));
    panels
}
