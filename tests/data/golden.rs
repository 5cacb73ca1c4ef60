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

/// What is put on the grid, with the digest for each accelerator: none, quasi-newton, anderson.
const SCENES: &[(&str, [u64; 3])] = &[
    (
        r#""constraints": [{ "kind": "circle", "on": "faces" }],
           "weights": { "shape": 5, "close": 10, "smooth": 2 }"#,
        [0x1109_2e35_0ad0_ef35, 0x1e00_a19c_c3ad_6ad0, 0xf9bb_24cc_2bf5_7e28],
    ),
    (
        r#""constraints": [{ "kind": "plane", "on": "faces" },
                           { "kind": "line", "on": "curves", "weight": 0.5 },
                           { "kind": "sphere", "on": { "vertices": "0-12,40-90" }, "weight": 2 }],
           "handles": [{ "vertices": [0, 12], "fixed": true },
                       { "vertices": [168], "targets": [[1.2, 1.1, 0.4]] }],
           "weights": { "shape": 3, "smooth": 0.1 },
           "smoothness": { "of": "displacement" }"#,
        [0xa65d_543d_ccf2_c3e3, 0x773c_218a_30a7_3220, 0x25ba_0bd4_7e64_2f95],
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
        [0x4cc5_4b30_6759_d56c, 0xda57_ff12_b0b8_97bf, 0x7ad4_bbf1_c473_11b2],
    ),
    (
        r#""constraints": [{ "kind": "square", "on": "faces" }],
           "handles": [{ "vertices": [168] }],
           "weights": { "close": 0.1, "smooth": 0.01 },
           "closeness": { "boundary": { "corners": 40 },
                          "weights": [{ "on": "boundary", "weight": 30 },
                                      { "on": { "vertices": "80-90" }, "weight": 0 }] }"#,
        [0x1152_9ec1_d71b_9324, 0xfd00_9de0_36b0_d227, 0x727d_2bac_4c96_be27],
    ),
];

/// The digest of each kind with its defaults, on every sort of element that fits it.
const KIND_DIGESTS: &[(&str, u64)] = &[
    ("line", 0x30cd_1105_4308_f891),
    ("plane", 0x360a_98e3_d648_1338),
    ("circle", 0xb653_90c8_b184_fdb1),
    ("sphere", 0x9da6_5261_7d58_8b77),
    ("rigid", 0x4f3e_3c16_93f5_87eb),
    ("similar", 0x56a7_2418_2b77_a359),
    ("planar-similar", 0x18d1_e6c8_7592_7e36),
    ("line-segment", 0xa324_0920_7b55_a7b0),
    ("equal-length", 0xa16f_d325_2558_dae6),
    ("angle", 0xcccc_d9c7_9819_dde4),
    ("area", 0x5fd8_9d29_fdfa_54a8),
    ("volume", 0xcfc8_7654_cc4c_c09d),
    ("bending", 0x0a15_d52a_098e_ba91),
    ("regular-polygon", 0xd03d_f0c1_d86c_ae26),
    ("square", 0x1e2d_d133_9dae_3c2c),
    ("parallelogram", 0xa9a2_3c1b_8fbd_c692),
    ("rectangle", 0xd9ef_70cb_e306_142e),
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
    let mesh = sampler();
    elements.iter().fold(0, |combined, element| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "sampler.obj" }},
                  "constraints": [{{ "kind": "{}", "on": {{ "each": "{}" }} }}],
                  "handles": [{{ "vertices": [7, 40, 75], "targets": [[1, 2, 0.3], [2, 1, 1], [4, 0, 1]] }}],
                  "weights": {{ "shape": 1, "close": 0.1 }}, "closeness": {{ "to": "rest" }},
                  "solver": {{ "tolerance": 0 }} }}"#,
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
    for (scene, expected) in SCENES {
        for (accelerator, expected) in ["none", "quasi-newton", "anderson"].iter().zip(expected) {
            let text = format!(
                r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}, {scene},
                      "solver": {{ "accelerator": "{accelerator}", "tolerance": 0 }} }}"#
            );
            let scene = Scene::from_json(&text).expect("the scene is valid");
            let mut session = Session::open(scene, bumpy(12)).expect("the scene fits the grid");
            for _ in 0..30 {
                session.step().expect("positions stay finite");
            }
            let found = digest(&session.positions());
            if found != *expected {
                wrong.push(format!("{accelerator}: {found:#018x}, expected {expected:#018x}"));
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
    assert!(wrong.is_empty(), "digests differ:\n{}", wrong.join("\n"));
}
