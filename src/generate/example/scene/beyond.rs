//! A limit from section 5 of the paper, and other uses from section 6.

use super::parts::{constraint, each, fixed, moved};
use crate::constraint::Kind;
use crate::constraint::{Element, Selector};
use crate::generate::example::Example;
use crate::generate::model::{Court, Patch, Strip, Tower};
use crate::mesh::{Mesh, Ragged};
use crate::scene::{
    ClosenessTo, ConstraintSpec, Pose, Require, Scene, Smoothness, SmoothnessOf, Target, Weighting,
    Weights,
};

pub(super) const CHOICE: Example = Example {
    id: "limits-choice",
    title: "Two vertices exchanged",
    summary: "Drag the two handles by the same amount: every line across the sheet is to become an arc, but on the right two neighbouring lines have exchanged one vertex, and the surface responds differently.",
    statement: "Both halves start as mirror images and are pulled by the same amount; with two vertices exchanged between two constraints they end up to 1.5 m from mirror images, and without the exchange within a millimetre.",
    make: choice,
};

pub(super) const FIT: Example = Example {
    id: "other-registration",
    title: "Panels fitted to another surface",
    summary: "The rough panels are near another surface, made of triangles: run, and they settle on it and become flat.",
    statement: "Vertices that are up to 3 m from the other surface come within 3 cm of it, and the panels, up to 13 cm from flat, within 7 mm.",
    make: fit,
};

pub(super) const TRANSFER: Example = Example {
    id: "other-transfer",
    title: "A tower takes the pose of another",
    summary: "Each ring of the upright tower takes the shape of the same ring of a leaning tower; the rings may turn and grow freely, and so the whole tower takes the pose.",
    statement: "Rings that are up to 83 cm from their shapes in the other pose come within 1 cm of them.",
    make: transfer,
};

pub(super) const SPLINE: Example = Example {
    id: "other-spline",
    title: "Rim that glides on a spline",
    summary: "The corners around the court are crowded on one side, and spread until they are equally far apart: they glide along the smooth curve through their original positions, not along the straight edges.",
    statement: "The longest edge of the rim is 6 times as long as the shortest one before, and at most 2 % longer after; the rim stays within 1 cm of the curve, and moves more than 10 cm away from its original edges.",
    make: spline,
};

pub(super) const STRIPS: Example = Example {
    id: "other-strips",
    title: "Strips that unroll",
    summary: "Long rows of panels, each exactly flat: every row unrolls into a strip of sheet metal or paper without stretching, though the whole surface does not. To lay them out, choose Build, Paper model, Strips.",
    statement: "Panels that are warped by up to 2 cm become flat, and each of the eight rows unrolls into a strip at most 29 m long and 3.6 m wide; the surface keeps a Gauss curvature of up to 0.04 per square metre, so it would not unroll as one piece.",
    make: strips,
};

/// The panels of the sheet of [`CHOICE`], along x and along y.
const SHEET: [usize; 2] = [24, 16];

/// A flat sheet of square panels, one metre wide.
fn flat(panels: [usize; 2]) -> Mesh {
    Patch { panels, width: 1.0, shear: 0.0, jitter: 0.0, rise: 0.0 }.mesh()
}

fn choice(scene: &mut Scene) -> Mesh {
    let mesh = flat(SHEET);
    let row = SHEET[0] + 1;
    let at = |i: usize, j: usize| (j * row + i) as u32;
    scene.constraints = (1..SHEET[0])
        .map(|i| {
            let own = |j: usize| match (i, j) {
                (17, 5) => at(18, 5),
                (18, 5) => at(17, 5),
                _ => at(i, j),
            };
            constraint("circle", Selector::Vertices((0..=SHEET[1]).map(own).collect()), 1.0)
        })
        .collect();
    let sides = (0..row).flat_map(|i| [at(i, 0), at(i, SHEET[1])]).collect();
    let raised = moved(&mesh, vec![at(6, 8), at(18, 8)], |[x, y, _]| [x, y, 4.0]);
    scene.handles = vec![fixed(sides), raised];
    scene.weights = Weights { shape: 10.0, close: 0.0, smooth: 1.0 };
    scene.closeness.to = ClosenessTo::None;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    scene.solver.iterations = 500;
    mesh
}

fn fit(scene: &mut Scene) -> Mesh {
    let mut quads = flat([26, 18]);
    for [x, y, z] in &mut quads.positions {
        let [across, along] = [*x / 13.0, *y / 9.0];
        *z = 1.0 - 2.0 * across * across + 1.2 * across * along - 1.5 * along * along;
    }
    let corners = quads.faces.iter();
    let triangles = corners.flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]);
    let triangles = Ragged::from_iter(triangles);
    let surface = Mesh { positions: quads.positions, faces: triangles, ..Mesh::default() };
    scene.closeness.to = ClosenessTo::Target;
    scene.closeness.target = Some(Target::Mesh(surface.into()));
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 10.0, close: 1.0, smooth: 0.02 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    scene.solver.iterations = 500;
    let mut rough = flat([22, 15]);
    for (k, [_, _, z]) in rough.positions.iter_mut().enumerate() {
        *z = 0.1 * (7 * k % 5) as f64;
    }
    rough
}

fn transfer(scene: &mut Scene) -> Mesh {
    let tower = Tower { meridians: 32, rows: 20 };
    let upright = tower.mesh();
    // The leaning pose; its foot stays in place, for the handles.
    let mut posed = upright.positions.clone();
    for [x, y, z] in &mut posed {
        let above = (*z - 5.0).max(0.0);
        *x += 0.012 * above * above;
        *y -= 0.0001 * above * above * above;
    }
    scene.pose = Some(Pose::Positions(posed.into()));
    scene.constraints = vec![constraint(
        "similar",
        Selector::Each { element: Element::Ring, within: None, radius: 1 },
        1.0,
    )];
    scene.handles = vec![fixed((0..2).flat_map(|k| tower.ring(k)).collect())];
    scene.weights = Weights { shape: 1.0, close: 0.0, smooth: 0.0 };
    scene.closeness.to = ClosenessTo::None;
    scene.solver.iterations = 1000;
    upright
}

fn spline(scene: &mut Scene) -> Mesh {
    let rim = || Selector::Vertices(Court::ring(0).collect());
    let glides = Kind::new("on-curve", serde_json::json!({ "closed": "yes", "between": "spline" }));
    let glides = glides.expect("the kind is in the list of kinds");
    scene.constraints = vec![
        constraint("equal-length", rim(), 1.0),
        // Weighted higher, so that the rim stays on the curve.
        ConstraintSpec { kind: glides, ..constraint("on-curve", rim(), 5.0) },
    ];
    scene.handles = vec![fixed(Court::ring(Court::ROWS).collect())];
    scene.weights = Weights { shape: 100.0, close: 0.0, smooth: 0.1 };
    scene.closeness.to = ClosenessTo::None;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    scene.solver.iterations = 500;
    Court::mesh()
}

fn strips(scene: &mut Scene) -> Mesh {
    let strip = Strip { panels: [48, 8], size: [24.0, 6.0], swing: 3.0, twist: 5.0 };
    let flat = constraint("plane", each(Element::Face), 1.0);
    scene.constraints = vec![ConstraintSpec { require: Require::Exact, ..flat }];
    scene.weights = Weights { shape: 1000.0, close: 1.0, smooth: 1.0 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    strip.mesh()
}
