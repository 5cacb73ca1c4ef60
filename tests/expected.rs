//! Agreement with an independent implementation (slow, direct, double precision), whose energies
//! over the iterations of the plain scheme lie in `../shared/expected`. Says so where they are absent.

#[path = "support/shared.rs"]
mod shared;

use serde_json::Value;
use shape_up::scene::{Accelerator, MeshSource, Scene};
use shape_up::session::Session;

/// One case: the energies of `name`, a kind on every face.
struct Case {
    name: &'static str,
    mesh: &'static str,
    kind: &'static str,
    closeness: &'static str,
    smoothness: &'static str,
    guarded: bool,
    /// Iterations to compare, and the relative tolerance of the total.
    agreement: &'static [(u64, f64)],
}

const HALFTUNNEL: &str = "halftunnel.off";
const HYPAR: &str = "compas_hypar.obj";
const SHELL: &str = "M2_eq_quad2.obj";
const HORSE: &str = "horse_quad.obj";
const EXACT: &[(u64, f64)] = &[(20, 1e-9), (100, 1e-9)];

#[rustfmt::skip]
const CASES: &[Case] = &[
    Case { name: "halftunnel_circle_5_10_2_surface_surface", mesh: HALFTUNNEL, kind: "circle", closeness: "surface", smoothness: "surface", guarded: false, agreement: EXACT },
    Case { name: "halftunnel_plane_5_10_2_surface_surface", mesh: HALFTUNNEL, kind: "plane", closeness: "surface", smoothness: "surface", guarded: false, agreement: EXACT },
    Case { name: "halftunnel_circle_5_10_2_surface_displacement", mesh: HALFTUNNEL, kind: "circle", closeness: "surface", smoothness: "displacement", guarded: false, agreement: EXACT },
    Case { name: "halftunnel_circle_5_10_2_vertex_displacement", mesh: HALFTUNNEL, kind: "circle", closeness: "rest", smoothness: "displacement", guarded: false, agreement: EXACT },
    Case { name: "halftunnel_circle_5_10_2_vertex_displacement_guarded", mesh: HALFTUNNEL, kind: "circle", closeness: "rest", smoothness: "displacement", guarded: true, agreement: EXACT },
    Case { name: "compas_hypar_circle_5_10_2_surface_displacement", mesh: HYPAR, kind: "circle", closeness: "surface", smoothness: "displacement", guarded: false, agreement: EXACT },
    Case { name: "compas_hypar_circle_5_10_2_vertex_displacement", mesh: HYPAR, kind: "circle", closeness: "rest", smoothness: "displacement", guarded: false, agreement: EXACT },
    // The mesh is its own mirror image in x = y, and six of its vertices come to lie exactly above
    // a valley of the triangulated surface, where two points are equally close. Rounding decides
    // which one is taken, and the two choices part from the second iteration on.
    Case { name: "compas_hypar_plane_5_10_2_surface_displacement", mesh: HYPAR, kind: "plane", closeness: "surface", smoothness: "displacement", guarded: false, agreement: &[(1, 1e-9), (20, 1e-6), (100, 1e-4)] },
    Case { name: "M2_eq_quad2_circle_5_10_2_surface_displacement", mesh: SHELL, kind: "circle", closeness: "surface", smoothness: "displacement", guarded: false, agreement: EXACT },
    Case { name: "M2_eq_quad2_plane_5_10_2_surface_displacement", mesh: SHELL, kind: "plane", closeness: "surface", smoothness: "displacement", guarded: false, agreement: EXACT },
    Case { name: "square_horse_quad_5_1_0_surface", mesh: HORSE, kind: "square", closeness: "surface", smoothness: "surface", guarded: false, agreement: EXACT },
    Case { name: "square_horse_quad_5_1_0_vertex", mesh: HORSE, kind: "square", closeness: "rest", smoothness: "surface", guarded: false, agreement: EXACT },
];

fn scene(case: &Case, weights: &Value) -> Scene {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "{}" }},
            "constraints": [{{ "kind": "{}", "on": "faces" }}],
            "weights": {{ "shape": {}, "close": {}, "smooth": {} }},
            "closeness": {{ "to": "{}" }},
            "smoothness": {{ "of": "{}", "weighting": "uniform" }},
            "solver": {{ "tolerance": 0, "monotone": {} }} }}"#,
        case.mesh,
        case.kind,
        weights[0],
        weights[1],
        weights[2],
        case.closeness,
        case.smoothness,
        case.guarded
    );
    let mut scene = Scene::from_json(&text).expect("the scene is valid");
    scene.solver.accelerator = Accelerator::None;
    assert_eq!(scene.mesh, MeshSource::File(case.mesh.to_owned()));
    scene
}

#[test]
fn energies_agree_with_an_independent_implementation() {
    for case in CASES {
        let (Some((expected, diameter)), Some(mut mesh)) =
            (shared::expected(case.name), shared::mesh(case.mesh))
        else {
            continue;
        };
        for coordinate in mesh.positions.as_flattened_mut() {
            *coordinate /= diameter;
        }
        let mut session = Session::open(scene(case, &expected["weights"]), mesh)
            .expect("the scene fits the mesh");
        for energies in expected["energies"].as_array().expect("a list") {
            let iteration = energies["iter"].as_u64().expect("a number");
            while u64::from(session.iteration()) < iteration {
                session.step().expect("positions stay finite");
            }
            let found = session.solver().energy().total;
            let total = energies["total"].as_f64().expect("a number");
            let tolerance = case.agreement.iter().find(|(until, _)| iteration <= *until);
            let &(_, tolerance) = tolerance.expect("the last tolerance covers all iterations");
            assert!(
                (found - total).abs() <= tolerance * total,
                "{}: iteration {iteration}: {found} is not {total}",
                case.name
            );
        }
    }
}
