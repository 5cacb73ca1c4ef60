//! Scenes with a known digest of the positions after 30 steps, for native and wasm tests.

use super::grid::grid;
use shape_up::constraint::{Element, Info, KINDS};
use shape_up::mesh::{Mesh, Point};
use shape_up::quads::Boundary;
use shape_up::scene::Scene;
use shape_up::session::{LayoutSettings, Session};

/// A grid of quads over a bumpy height field, made with exactly rounded operations only.
fn bumpy(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let (x, y) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
        let bump = f64::from((i * 31 + j * 17) % 23) / 23.0;
        let z = x * (1.0 - x) * y + 0.02 * bump;
        [x + 0.01 * bump, y - 0.013 * bump, z]
    })
}

/// Constraints and settings on the grid, with the digest for each accelerator (none, quasi-newton,
/// anderson) with the supernodal factor.
const SCENES: &[(&str, [u64; 3])] = &[
    (
        r#""constraints": [{ "kind": "circle", "on": "faces" }],
           "weights": { "shape": 5, "close": 10, "smooth": 2 }"#,
        [0x7886_89ca_48b9_348a, 0x654c_b3a2_c3e2_6471, 0xbebd_d294_7073_c506],
    ),
    (
        r#""constraints": [{ "kind": "plane", "on": "faces" },
                           { "kind": "line", "on": "curves", "weight": 0.5 },
                           { "kind": "sphere", "on": { "vertices": "0-12,40-90" }, "weight": 2 }],
           "handles": [{ "vertices": [0, 12], "fixed": true },
                       { "vertices": [168], "targets": [[1.2, 1.1, 0.4]] }],
           "weights": { "shape": 3, "smooth": 0.1 },
           "smoothness": { "of": "displacement" }"#,
        [0x45f5_7240_b030_2a3e, 0x9299_e1c9_3a9f_ab1f, 0xfc29_f76b_f2c9_503b],
    ),
    (
        r#""constraints": [{ "kind": "square", "on": "faces", "weight": 0.3 },
                           { "kind": "regular-polygon", "on": { "vertices": "0-11" } },
                           { "kind": "parallelogram", "on": "faces" },
                           { "kind": "rectangle", "on": "faces" },
                           { "kind": "rigid", "on": "rings" },
                           { "kind": "similar", "on": { "each": "ring", "radius": 2 }, "scale": [0.8, 1.25] },
                           { "kind": "planar-similar", "on": "faces" }],
           "handles": [{ "vertices": [0, 12] }, { "vertices": [168], "targets": [[1.2, 1.1, 0.4]] }]"#,
        [0xaa9e_b44a_29c3_0591, 0xb4ed_ae6f_2fa8_c029, 0xad1a_4675_d3d8_3e81],
    ),
    (
        r#""constraints": [{ "kind": "square", "on": "faces" }],
           "handles": [{ "vertices": [168] }],
           "weights": { "close": 0.1, "smooth": 0.01 },
           "closeness": { "boundary": { "corners": 40 },
                          "weights": [{ "on": "boundary", "weight": 30 },
                                      { "on": { "vertices": "80-90" }, "weight": 0 }] }"#,
        [0xa772_f1bd_fead_3113, 0x30bf_13d5_43e7_8702, 0xe941_e20f_fd53_4c83],
    ),
];

/// Digests of the same scenes with the factor of `sprs-ldl`, the default at this size, which sums
/// in another order.
const SPRS_LDL_DIGESTS: &[[u64; 3]] = &[
    [0x9fb0_5a7e_7d37_ea4e, 0x60ff_6af2_76b7_5e76, 0x2a3f_a789_f79f_9ea5],
    [0x96e3_0d30_446d_f889, 0x9299_e1c9_3a9f_ab1f, 0xfc29_f76b_f2c9_503b],
    [0x25db_0500_3f6d_17bb, 0xb4ed_ae6f_2fa8_c029, 0x4ca7_0079_bc32_0b3c],
    [0x872d_600e_80b9_4040, 0x30bf_13d5_43e7_8702, 0xe941_e20f_fd53_4c83],
];

/// Digest of each kind with its defaults, on every type of element that fits it.
const KIND_DIGESTS: &[(&str, u64)] = &[
    ("line", 0x4643_e80b_2071_e317),
    ("plane", 0xf3ff_95bc_d509_1c0d),
    ("circle", 0xcf64_356a_59c1_ca31),
    ("sphere", 0xf9d7_f0d9_fc28_fb8c),
    ("rigid", 0x347c_1285_80b6_563a),
    ("similar", 0xbb98_0f31_fe4a_80f7),
    ("planar-similar", 0x62d2_6780_744a_fae4),
    ("line-segment", 0x850b_0900_8d7e_7042),
    ("equal-length", 0x9c37_26fd_e409_b942),
    ("angle", 0x00f2_4acf_54b0_57bb),
    ("area", 0x3134_6fe2_c12e_78f5),
    ("volume", 0xff41_02ad_cf6d_1d73),
    ("bending", 0x60e0_4bd2_5ba3_18ac),
    ("regular-polygon", 0xb9d3_b4c1_9386_ce29),
    ("square", 0x9200_5673_8e19_5d8b),
    ("parallelogram", 0x4005_c2ec_ebad_c572),
    ("rectangle", 0xe9ab_535e_dcf1_c101),
    ("symmetry", 0x895c_1e9f_d914_d9de),
    ("on-curve", 0x9fbf_95e0_5bf9_056f),
    ("on-surface", 0xda04_2423_817c_7988),
    ("tangent-incircles", 0x1f75_3300_6383_7eda),
    ("incircle", 0x2d2f_eaa3_9f27_3b1e),
    ("conical", 0x7f83_a4e3_fb28_eb0a),
];

/// Separate quads, triangles and tetrahedra.
fn sampler() -> Mesh {
    let mut mesh = bumpy(5);
    let quads = mesh.faces.clone();
    let n = mesh.positions.len() as u32;
    let beside: Vec<Point> = mesh.positions.iter().map(|[x, y, z]| [x + 2.0, *y, *z]).collect();
    mesh.positions.extend(beside);
    for face in quads.iter() {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| face[k] + n);
        mesh.faces.push(&[a, b, c]);
        mesh.faces.push(&[a, c, d]);
    }
    // A prism on each of some triangles, split into three tetrahedra.
    for face in 0..4 {
        let first = mesh.positions.len() as u32;
        let triangle = mesh.faces.row(quads.len() + 2 * face);
        let corners: Vec<Point> = triangle.iter().map(|&v| mesh.positions[v as usize]).collect();
        for height in [1.0, 1.3] {
            mesh.positions
                .extend(corners.iter().map(|[x, y, z]| [x + 2.0, y * height, z + height]));
        }
        mesh.tets.extend(
            [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]].map(|tet| tet.map(|k: u32| first + k)),
        );
    }
    mesh
}

/// Digest of ten steps with a kind on each type of element that fits it.
fn kind_digest(info: &Info) -> u64 {
    let elements = if info.elements.is_empty() { &Element::ALL } else { info.elements };
    // Curves are polylines and edge lines.
    let parts = [Element::Polyline, Element::EdgeLine];
    let elements = elements.iter().filter(|element| !parts.contains(element));
    let mesh = sampler();
    elements.fold(0, |combined, element| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "sampler.obj" }},
                  "constraints": [{{ "kind": "{}", "on": {{ "each": "{}" }} }}],
                  "handles": [{{ "vertices": [7, 40, 75], "targets": [[1, 2, 0.3], [2, 1, 1], [4, 0, 1]] }}],
                  "weights": {{ "shape": 1, "close": 0.1 }}, "closeness": {{ "to": "rest" }},
                  "solver": {{ "tolerance": 0, "factorization": "supernodal" }} }}"#,
            info.id,
            element.id()
        );
        let scene = Scene::from_json(&text).expect("the scene is valid");
        let Ok(mut session) = Session::open(scene, mesh.clone()) else {
            // No element has a suitable number of vertices.
            return combined;
        };
        for _ in 0..10 {
            session.step().expect("positions stay finite");
        }
        combined.rotate_left(7) ^ digest(&session.positions())
    })
}

/// Digests of the positions with panels required to be exact, and after a step along the softest
/// variation.
const EXACT_DIGESTS: [(&str, [u64; 2]); 2] = [
    ("circle", [0x9377_1fda_7cb0_5e54, 0x9a9a_9100_e5a6_3c3f]),
    ("plane", [0xe779_4e2c_b0e1_8e9f, 0xdd2e_f391_84c2_7859]),
];

fn exact_digests(kind: &str) -> [u64; 2] {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
              "constraints": [{{ "kind": "{kind}", "on": "faces", "require": "exact" }}],
              "weights": {{ "shape": 5, "close": 10, "smooth": 2 }}, "closeness": {{ "to": "rest" }} }}"#
    );
    let scene = Scene::from_json(&text).expect("the scene is valid");
    let mut session = Session::open(scene, bumpy(12)).expect("the scene fits the grid");
    session.begin_run();
    while !session.step().expect("positions stay finite").ended {}
    session.end_run();
    let exact = digest(&session.positions());
    let mut variations =
        session.variations().expect("its systems are regular").expect("all panels are exact");
    while !variations.are_found() {
        variations.step().expect("its systems are regular");
    }
    let varied = variations.go(&[0.02]).expect("its systems are regular");
    assert!(session.show_variation(variations.generation(), &varied.positions, None));
    [exact, digest(&session.positions())]
}

/// Digest of the panels along the lines of curvature of a bumpy surface: with the boundary followed, and
/// cut.
const LAYOUT_DIGESTS: [(Boundary, u64); 2] =
    [(Boundary::Followed, 0x1b46_edb2_1181_e7db), (Boundary::Cut, 0x06ac_6088_5aec_2309)];

fn layout_digest(boundary: Boundary) -> u64 {
    let scene = Scene::opened("grid.obj");
    let session = Session::open(scene, bumpy(12)).expect("the scene fits the grid");
    let (follow, even) = (2.0 / 3.0, 0.25);
    let settings =
        LayoutSettings { count: Some(60), size: None, follow, even, boundary: Some(boundary) };
    let mut layouts = session.panel_layouts(&[]).expect("no face is kept");
    let layout = layouts.lay_out(&settings, &mut |_| ());
    digest(&layout.expect("the surface can be covered").mesh.positions)
}

/// FNV-1a over the bits of all coordinates.
fn digest(positions: &[Point]) -> u64 {
    let bytes = positions.as_flattened().iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Compares every digest.
pub(crate) fn check() {
    let mut wrong = Vec::new();
    let digests =
        SCENES.iter().zip(SPRS_LDL_DIGESTS).flat_map(|((scene, supernodal), sprs_ldl)| {
            [(scene, "supernodal", supernodal), (scene, "sprs-ldl", sprs_ldl)]
        });
    for (scene, factorization, expected) in digests {
        for (accelerator, expected) in ["none", "quasi-newton", "anderson"].iter().zip(expected) {
            let text = format!(
                r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}, {scene},
                      "solver": {{ "accelerator": "{accelerator}", "tolerance": 0,
                                   "factorization": "{factorization}" }} }}"#
            );
            let scene = Scene::from_json(&text).expect("the scene is valid");
            let mut session = Session::open(scene, bumpy(12)).expect("the scene fits the grid");
            for _ in 0..30 {
                session.step().expect("positions stay finite");
            }
            let found = digest(&session.positions());
            if found != *expected {
                wrong.push(format!(
                    "{factorization}, {accelerator}: {found:#018x}, expected {expected:#018x}"
                ));
            }
        }
    }
    for info in KINDS {
        let found = kind_digest(info);
        let expected = KIND_DIGESTS.iter().find(|(id, _)| *id == info.id);
        if expected.is_none_or(|(_, digest)| *digest != found) {
            wrong.push(format!("    (\"{}\", {found:#018x}),", info.id));
        }
    }
    for (kind, expected) in EXACT_DIGESTS {
        let found = exact_digests(kind);
        if found != expected {
            wrong.push(format!("    (\"{kind}\", {found:#018x?}),"));
        }
    }
    for (boundary, expected) in LAYOUT_DIGESTS {
        let found = layout_digest(boundary);
        if found != expected {
            wrong.push(format!("    (Boundary::{boundary:?}, {found:#018x}),"));
        }
    }
    assert!(wrong.is_empty(), "digests differ:\n{}", wrong.join("\n"));
}
