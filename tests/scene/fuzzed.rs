//! No text makes the scene reader panic, hang, or allocate memory out of proportion to the text;
//! every scene that it accepts can be opened, iterated, reported and written, or is refused.

use proptest::collection::vec;
use proptest::prelude::*;
use shape_up::scene::{MeshSource, Scene};
use shape_up::session::{Edit, Session};

/// Scenes with all keys of the format, on a mesh of two squares and a tetrahedron.
const SOUND: [&str; 2] = [
    r#"{ "format": "shape-up-scene", "version": 1, "title": "Roof", "units": "m", "up": "z",
    "mesh": { "positions": [[0,0,0],[1,0,0],[2,0,0.1],[0,1,0],[1,1,0.2],[2,1,0],[1,1,1]],
        "faces": [[0,1,4,3],[1,2,5,4]], "curves": [[0,1,2]], "tets": [[0,1,3,6]],
        "groups": { "roof": { "faces": "0-1" }, "a": [{ "faces": [0], "keyword": "o" }, { "faces": "1" }] } },
    "sets": { "eaves": { "vertices": "0-2,5" }, "skylight": { "faces": "1" } },
    "constraints": [ { "kind": "circle", "on": "faces", "weight": 1 },
        { "kind": "similar", "on": { "each": "ring", "radius": 1, "in": "eaves" }, "scale": [0.8, 1.25] },
        { "kind": "sphere", "on": { "set": "eaves" }, "weight": 2, "name": "Eaves" },
        { "kind": "line-segment", "on": "edges", "length": "rest" },
        { "kind": "plane", "on": { "vertices": [3, 4, 5, 0] }, "enabled": false } ],
    "handles": [ { "vertices": [2], "targets": [[1.2, 0.4, 2.5]], "weight": 100 },
        { "vertices": "0-1", "fixed": true } ],
    "weights": { "shape": 5, "close": 10, "smooth": 2 } }"#,
    r#"{ "format": "shape-up-scene", "version": 1,
    "mesh": { "positions": [[0,0,0],[1,0,0],[1,1,0.2],[0,1,0]], "faces": [[0,1,2,3]] },
    "current": [[0,0,0],[1,0,0.1],[1,1,0.2],[0,1,0]],
    "constraints": [ { "kind": "rectangle", "on": "faces", "fit": "lines" },
        { "kind": "on-curve", "on": "boundary", "corners": 30 },
        { "kind": "angle", "on": "corners", "angle": [80, 100] } ],
    "closeness": { "to": "rest", "boundary": { "corners": 45 },
        "weights": [ { "on": "boundary", "weight": 10 } ] },
    "smoothness": { "of": "displacement", "weighting": "uniform" },
    "solver": { "iterations": 3, "tolerance": 0, "accelerator": "anderson", "window": 4,
        "mean_centring": false, "monotone": true },
    "lesson": { "text": "Make it flat.", "goals": [ { "measure": "planarity", "at_most": 0.001 } ] } }"#,
];

/// Tokens that mean something to the reader.
fn piece() -> impl Strategy<Value = String> {
    const PIECES: [&str; 40] = [
        "0",
        "-1",
        "1e308",
        "1e-308",
        "1e51",
        "99999998",
        "4294967295",
        "4294967296",
        "0.5",
        "null",
        "true",
        "[]",
        "{}",
        "\"\"",
        "\"0-99999998\"",
        "\"0-6\"",
        "\"6,0-5\"",
        "\"rest\"",
        "\"surface\"",
        "\"faces\"",
        "\"stars\"",
        "{ \"each\": \"ring\", \"radius\": 4294967295 }",
        "\"circle\"",
        "\"conical\"",
        "\"hinges\"",
        "\"bending\"",
        "\"incircle\"",
        "\"symmetry\"",
        "\"volume\"",
        "\"tets\"",
        "[0, 0, 0]",
        "[1, 2, 3]",
        "\"sprs-ldl\"",
        "\"cotangent\"",
        "\"none\"",
        ",",
        "{",
        "]",
        "\\u0000",
        "\u{feff}",
    ];
    prop_oneof![
        6 => prop::sample::select(PIECES.to_vec()).prop_map(str::to_owned),
        1 => "[ -~]{0,6}",
    ]
}

/// Approximate ranges of the values in a JSON text: words, numbers and brackets.
fn values(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut begin = None;
    let mut quoted = false;
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        let inside = quoted || c == '"' || c.is_ascii_alphanumeric() || "+-._".contains(c);
        match (begin, inside) {
            (None, true) => begin = Some(at),
            (Some(from), false) => {
                found.push((from, at));
                begin = None;
            }
            _ => {}
        }
        if "[]{}".contains(c) && !quoted {
            found.push((at, at + 1));
        }
    }
    found
}

/// Reads the text and uses the scene as a host does.
fn check(text: &str) {
    let scene = match Scene::from_json(text) {
        Ok(scene) => scene,
        Err(error) => return assert!(!error.to_string().contains('\n'), "{error}"),
    };
    let MeshSource::Inline(mesh) = &scene.mesh else { return };
    let mesh = (**mesh).clone();
    let again = Scene::from_json(&scene.to_json(&mesh)).expect("what is written is read");
    assert_eq!(again, scene);
    let Ok(mut session) = Session::open(scene, mesh) else { return };
    session.begin_run();
    for _ in 0..3 {
        // With weights of 1e308 positions may become non-finite: the last finite ones are kept.
        if session.step().is_err() {
            break;
        }
    }
    session.end_run();
    let finite = |session: &Session| session.positions().iter().flatten().all(|x| x.is_finite());
    assert!(finite(&session));
    drop(session.edit(Edit::Reset));
    while session.undo().expect("the state was solvable").is_some() {}
    assert!(finite(&session));
    assert!(serde_json::to_string(&session.report()).is_ok());
    assert!(session.errors_csv().starts_with("face,"));
}

/// Peak memory of this process in bytes, if the system reports it.
fn most_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<usize>().ok().map(|kilobytes| kilobytes << 10)
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(1500))]

    #[test]
    fn sound_scenes_with_other_values(
        scene in prop::sample::select(&SOUND[..]),
        faults in vec((any::<prop::sample::Index>(), piece()), 1..4),
    ) {
        let mut text = scene.to_owned();
        for (place, put) in faults {
            let places = values(&text);
            if places.is_empty() {
                break;
            }
            let (from, to) = places[place.index(places.len())];
            text.replace_range(from..to, &put);
        }
        check(&text);
        prop_assert!(most_memory().is_none_or(|most| most < 1 << 30), "memory is taken:\n{text}");
    }

    #[test]
    fn scenes_that_end_too_early(
        scene in prop::sample::select(&SOUND[..]),
        end in any::<prop::sample::Index>(),
    ) {
        check(&scene[..end.index(scene.len())]);
    }
}

#[test]
fn what_the_faults_are_put_into_is_sound() {
    for text in SOUND {
        let scene = Scene::from_json(text).expect("it is a scene");
        let MeshSource::Inline(mesh) = &scene.mesh else { panic!("the mesh is inline") };
        let mesh = (**mesh).clone();
        Session::open(scene, mesh).expect("it can be solved");
        check(text);
    }
}
