//! Scenes whose positions after 30 steps have a known digest, for native and wasm tests alike.

#[path = "../support/grid.rs"]
mod grid;

use grid::grid;
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
        [0x1109_2e35_0ad0_ef35, 0xae1c_c25a_01b8_484b, 0x09af_e087_8812_771b],
    ),
    (
        r#""constraints": [{ "kind": "plane", "on": "faces" },
                           { "kind": "line", "on": "curves", "weight": 0.5 },
                           { "kind": "sphere", "on": { "vertices": "0-12,40-90" }, "weight": 2 }],
           "handles": [{ "vertices": [0, 12], "fixed": true },
                       { "vertices": [168], "targets": [[1.2, 1.1, 0.4]] }],
           "weights": { "shape": 3, "smooth": 0.1 },
           "smoothness": { "of": "displacement" }"#,
        [0xa65d_543d_ccf2_c3e3, 0x15ed_4570_0d12_a3bf, 0xcc85_2e86_a1b2_bfdf],
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
        [0x4cc5_4b30_6759_d56c, 0xc146_5698_d303_03ff, 0x54d9_d8af_f382_b92b],
    ),
];

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
    assert!(wrong.is_empty(), "digests differ:\n{}", wrong.join("\n"));
}
