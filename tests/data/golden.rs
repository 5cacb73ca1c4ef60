//! Scenes whose positions after 30 steps have a known digest, for native and wasm tests alike.

#[path = "../support/grid.rs"]
mod grid;

use grid::grid;
use shape_up::constraint::{Element, Info, KINDS};
use shape_up::mesh::{Mesh, Point};
use shape_up::scene::Scene;
use shape_up::session::Session;

/// A grid of quads over a bumpy height field, made with exactly rounded operations only.
fn bumpy(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let (x, y) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
        let bump = f64::from((i * 31 + j * 17) % 23) / 23.0;
        let z = x * (1.0 - x) * y + 0.02 * bump;
        [x + 0.01 * bump, y - 0.013 * bump, z]
    })
}

/// What is put on the grid, with the digest for each accelerator (none, quasi-newton, anderson) where the
/// supernodal factor is used.
const SCENES: &[(&str, [u64; 3])] = &[
    (
        r#""constraints": [{ "kind": "circle", "on": "faces" }],
           "weights": { "shape": 5, "close": 10, "smooth": 2 }"#,
        [0x7886_89ca_48b9_348a, 0xd53f_0633_8e09_9aa1, 0xe7b2_4d66_3895_4eb1],
    ),
    (
        r#""constraints": [{ "kind": "plane", "on": "faces" },
                           { "kind": "line", "on": "curves", "weight": 0.5 },
                           { "kind": "sphere", "on": { "vertices": "0-12,40-90" }, "weight": 2 }],
           "handles": [{ "vertices": [0, 12], "fixed": true },
                       { "vertices": [168], "targets": [[1.2, 1.1, 0.4]] }],
           "weights": { "shape": 3, "smooth": 0.1 },
           "smoothness": { "of": "displacement" }"#,
        [0x45f5_7240_b030_2a3e, 0x15ed_4570_0d12_a3bf, 0xcc85_2e86_a1b2_bfdf],
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
        [0xaa9e_b44a_29c3_0591, 0xc146_5698_d303_03ff, 0xb6b3_b038_025a_6395],
    ),
    (
        r#""constraints": [{ "kind": "square", "on": "faces" }],
           "handles": [{ "vertices": [168] }],
           "weights": { "close": 0.1, "smooth": 0.01 },
           "closeness": { "boundary": { "corners": 40 },
                          "weights": [{ "on": "boundary", "weight": 30 },
                                      { "on": { "vertices": "80-90" }, "weight": 0 }] }"#,
        [0xa772_f1bd_fead_3113, 0xae5f_059a_9e1d_917e, 0x7d6b_9987_cabf_d388],
    ),
];

/// The same of each scene with the factor of `sprs-ldl`, the default of scenes of this size: it sums in
/// another order.
const SPRS_LDL_DIGESTS: &[[u64; 3]] = &[
    [0x9fb0_5a7e_7d37_ea4e, 0xef4b_a934_f254_5e08, 0x1503_4237_be8a_1eb9],
    [0x96e3_0d30_446d_f889, 0x15ed_4570_0d12_a3bf, 0xcc85_2e86_a1b2_bfdf],
    [0x25db_0500_3f6d_17bb, 0xc146_5698_d303_03ff, 0x273f_5c9b_d36e_a0ff],
    [0x872d_600e_80b9_4040, 0xae5f_059a_9e1d_917e, 0x7d6b_9987_cabf_d388],
];

/// The digest of each kind with its defaults, on every sort of element that fits it.
const KIND_DIGESTS: &[(&str, u64)] = &[
    ("line", 0x345f_63a7_ad89_4438),
    ("plane", 0x0520_cec6_d699_e6fe),
    ("circle", 0x722d_1c50_5d49_2198),
    ("sphere", 0xd01b_c884_c1f4_6bfb),
    ("rigid", 0x96d4_82e3_7773_570c),
    ("similar", 0x5e4d_1d38_a68a_6557),
    ("planar-similar", 0x3d57_3d29_087a_614a),
    ("line-segment", 0xb1a7_5a3c_d9e1_76d7),
    ("equal-length", 0x7eb6_8043_bc88_2901),
    ("angle", 0x73c3_466a_3e79_658d),
    ("area", 0x9e6a_6803_2b56_11d9),
    ("volume", 0x9bbf_7753_d498_d7da),
    ("bending", 0xbacd_5e9d_c284_3a58),
    ("regular-polygon", 0x9e3f_973f_a1cd_ac26),
    ("square", 0x37da_03f7_29ae_a68b),
    ("parallelogram", 0x2a0c_e344_2b03_8a7d),
    ("rectangle", 0x17be_630e_20ea_4853),
    ("symmetry", 0xb290_98b5_42ae_0bd2),
    ("on-curve", 0x9fbf_95e0_5bf9_056f),
    ("on-surface", 0x4db4_38a4_a0e2_e0d5),
    ("tangent-incircles", 0xbc5e_f99e_76dc_a28b),
    ("incircle", 0xf25b_0d93_b82a_e5db),
    ("conical", 0xa55c_9d83_376a_ae8e),
];

/// Quads, triangles and tetrahedra, apart from each other.
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
    // A prism on each of some triangles, cut into three tetrahedra.
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

/// The digest of ten steps with a kind on each sort of element that fits it.
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
            // No element has as many vertices as the kind takes.
            return combined;
        };
        for _ in 0..10 {
            session.step().expect("positions stay finite");
        }
        combined.rotate_left(7) ^ digest(&session.positions())
    })
}

/// Panels that are required to be exact, and what their positions are then, and after a step along the softest
/// variation.
const EXACT_DIGESTS: [(&str, [u64; 2]); 2] = [
    ("circle", [0x6381_7706_2bb4_3913, 0x3674_5030_4a2a_5995]),
    ("plane", [0xfabe_c47c_60b1_aff4, 0xd243_1f6a_61eb_5063]),
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
    session.reach_variation(&mut variations, &[0.02]).expect("its systems are regular");
    [exact, digest(&session.positions())]
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
    assert!(wrong.is_empty(), "digests differ:\n{}", wrong.join("\n"));
}
