//! The scene file: what is read, what is refused and how it is said, and that writing loses nothing.

use crate::asked::constraint;
use shape_up::constraint::{Element, Selector, Set};
use shape_up::mesh::{Group, GroupKeyword, Mesh, Ragged};
use shape_up::scene::{
    Accelerator, BoundaryCloseness, BoundaryRequire, Closeness, ClosenessTo, ClosenessWeight,
    ConstraintSpec, EasedFaces, Factorization, HandleSpec, Hold, MeshSource, Require, Scene,
    SceneError, Smoothness, SmoothnessOf, SolverSettings, Up, Weighting, Weights,
};

/// Two squares side by side.
fn two_squares() -> Mesh {
    let positions = (0..6).map(|i| [f64::from(i % 3), f64::from(i / 3), 0.0]).collect();
    let faces = Ragged::from_iter([[0, 1, 4, 3], [1, 2, 5, 4]]);
    Mesh { positions, faces, ..Mesh::default() }
}

/// A scene file whose mesh is a file, with `rest` after the mesh.
fn file_with(rest: &str) -> String {
    format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "roof.obj" }}{rest} }}"#
    )
}

fn refused(text: &str) -> SceneError {
    Scene::from_json(text).expect_err(text)
}

#[test]
fn a_scene_without_settings_has_the_defaults() {
    let scene = Scene::from_json(&file_with("")).unwrap();
    assert_eq!(scene, Scene::new(MeshSource::File("roof.obj".into())));
    assert_eq!(scene.weights, Weights { shape: 1.0, close: 0.0, smooth: 0.0 });
    assert_eq!(scene.closeness, Closeness::default());
    assert_eq!(scene.closeness.to, ClosenessTo::Surface);
    assert_eq!(scene.solver.iterations, 200);
    assert_eq!(scene.solver.accelerator, Accelerator::QuasiNewton);
}

#[test]
fn everything_the_format_has_is_read() {
    let scene = Scene::from_json(&file_with(
        r#", "title": "Roof", "units": "m", "up": "y",
        "current": [[0, 0, 0.5]],
        "sets": { "eaves": { "vertices": "0-2,5" }, "skylight": { "faces": [1] } },
        "constraints": [
          { "kind": "circle", "on": "faces", "weight": 2.5 },
          { "kind": "sphere", "on": { "set": "eaves" }, "enabled": false },
          { "kind": "line", "on": { "each": "ring", "radius": 2, "in": "eaves" } },
          { "kind": "plane", "on": { "vertices": [3, 5, 4] } },
          { "kind": "plane", "on": { "each": "group" } },
          { "kind": "plane", "on": "rings" },
          { "kind": "plane", "on": "strips" },
          { "kind": "plane", "on": { "each": "strip", "in": "eaves" } } ],
        "handles": [ { "vertices": [2], "targets": [[1.25, 0.5, 2]], "weight": 10 },
                     { "vertices": "0-1", "fixed": true }, { "vertices": [4] } ],
        "weights": { "shape": 5, "close": 10, "smooth": 2 },
        "closeness": { "to": "rest", "boundary": { "corners": 30, "require": "exact", "weight": 4 },
                       "weights": [{ "on": { "set": "eaves" }, "weight": 10 },
                                   { "on": "boundary", "weight": 0 }] },
        "smoothness": { "of": "displacement", "weighting": "uniform" },
        "solver": { "iterations": 7, "tolerance": 0, "accelerator": "none", "window": 0,
                    "mean_centring": false, "monotone": true, "factorization": "sprs-ldl",
                    "shortest_edge": null }"#,
    ))
    .unwrap();
    assert_eq!((scene.title.as_str(), scene.units.as_str(), scene.up), ("Roof", "m", Up::Y));
    assert_eq!(scene.current, Some(vec![[0.0, 0.0, 0.5]]));
    assert_eq!(scene.sets["eaves"].vertices, [0, 1, 2, 5]);
    assert_eq!(scene.sets["skylight"].faces, [1]);
    let ons: Vec<_> = scene.constraints.iter().map(|spec| spec.on.clone()).collect();
    let each = |element, within: Option<&str>, radius| Selector::Each {
        element,
        within: within.map(str::to_owned),
        radius,
    };
    assert_eq!(
        ons,
        [
            each(Element::Face, None, 0),
            Selector::Set("eaves".into()),
            each(Element::Ring, Some("eaves"), 2),
            Selector::Vertices(vec![3, 5, 4]),
            each(Element::Group, None, 0),
            each(Element::Ring, None, 1),
            each(Element::Strip, None, 0),
            each(Element::Strip, Some("eaves"), 0),
        ]
    );
    assert_eq!(scene.constraints[0].weight, 2.5);
    assert_eq!(scene.constraints[0].kind.info().id, "circle");
    assert!(!scene.constraints[1].enabled && scene.constraints[2].enabled);
    assert_eq!(scene.handles[0].targets, Some(vec![[1.25, 0.5, 2.0]]));
    assert_eq!(scene.handles[0].hold, Hold::Soft { weight: 10.0 });
    assert_eq!(scene.handles[1].hold, Hold::Fixed);
    assert_eq!(scene.handles[2].hold, Hold::Soft { weight: 100.0 });
    assert_eq!(scene.weights, Weights { shape: 5.0, close: 10.0, smooth: 2.0 });
    assert_eq!(
        scene.closeness,
        Closeness {
            target: None,
            to: ClosenessTo::Rest,
            weights: vec![
                ClosenessWeight { on: Selector::Set("eaves".into()), weight: 10.0 },
                ClosenessWeight { on: each(Element::Boundary, None, 0), weight: 0.0 },
            ],
            boundary: Some(BoundaryCloseness {
                corners: 30.0,
                require: BoundaryRequire::Exact,
                weight: 4.0,
            }),
        }
    );
    assert_eq!(
        scene.smoothness,
        Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform }
    );
    assert_eq!(
        scene.solver,
        SolverSettings {
            iterations: 7,
            tolerance: 0.0,
            accelerator: Accelerator::None,
            window: 0,
            mean_centring: false,
            monotone: true,
            factorization: Factorization::SprsLdl,
            shortest_edge: None
        }
    );
}

#[test]
fn a_constraint_says_whether_it_is_weighed_or_met() {
    let cases = [
        ("", Require::Soft),
        (r#", "require": "soft""#, Require::Soft),
        (r#", "require": "exact""#, Require::Exact),
        (r#", "require": { "within": 0.005 }"#, Require::Within(0.005)),
    ];
    for (words, require) in cases {
        let entry = format!(r#"{{ "kind": "plane", "on": "faces"{words} }}"#);
        let spec = ConstraintSpec::from_json(&entry).expect("it is a constraint");
        assert_eq!(spec.require, require, "{words}");
    }
}

/// What is wrong, the JSON path, and words that the message must have.
#[rustfmt::skip]
const REFUSED: &[(&str, &str, &[&str])] = &[
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": "hard" }]"#, "constraints[0].require", &["found \"hard\"", "soft", "exact", "within"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": { "within": 0 } }]"#, "constraints[0].require.within", &["found 0", "above 0"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": { "within": 1 }, "eased": { "within": -2, "faces": [0] } }]"#, "constraints[0].eased.within", &["found -2", "above 0"]),
    (r#", "solver": { "shortest_edge": 2 }"#, "solver.shortest_edge", &["found 2", "from 0 to 1"]),
    (r#", "titel": "x""#, "", &["`titel`", "title", "constraints"]),
    (r#", "title": 3"#, "title", &["found 3", "a text"]),
    (r#", "up": "x""#, "up", &["found \"x\"", "\"z\" or \"y\""]),
    (r#", "current": [[0, 1]]"#, "current[0]", &["an array of 2", "[x, y, z]"]),
    (r#", "sets": { "a": { "vertex": [0] } }"#, "sets.a", &["`vertex`", "vertices, faces"]),
    (r#", "sets": { "two words": { "vertices": [0.5] } }"#, "sets[\"two words\"].vertices[0]", &["found 0.5", "index"]),
    (r#", "sets": { "a": {} }"#, "sets.a", &["empty"]),
    (r#", "sets": { "a": { "vertices": "5-2" } }"#, "sets.a.vertices", &["\"5-2\"", "backwards"]),
    (r#", "sets": { "a": { "vertices": "1,x" } }"#, "sets.a.vertices", &["\"x\"", "0-199"]),
    (r#", "sets": { "a": { "vertices": [-1] } }"#, "sets.a.vertices[0]", &["found -1"]),
    (r#", "sets": { "a": { "vertices": [4294967296] } }"#, "sets.a.vertices[0]", &["found 4294967296"]),
    (r#", "sets": { "a": { "faces": {} } }"#, "sets.a.faces", &["an object", "list of indices"]),
    (r#", "constraints": {}"#, "constraints", &["an object", "array"]),
    (r#", "constraints": [7]"#, "constraints[0]", &["found 7", "\"kind\""]),
    (r#", "constraints": [{ "on": "faces" }]"#, "constraints[0]", &["`kind` is missing", "circle"]),
    (r#", "constraints": [{ "kind": "circel", "on": "faces" }]"#, "constraints[0].kind", &["\"circel\"", "line", "plane", "circle", "sphere"]),
    (r#", "constraints": [{ "kind": "plane" }]"#, "constraints[0]", &["`on` is missing", "\"faces\""]),
    (r#", "constraints": [{ "kind": "plane", "on": "face" }]"#, "constraints[0].on", &["\"face\"", "\"faces\""]),
    (r#", "constraints": [{ "kind": "plane", "on": { "each": "faces" } }]"#, "constraints[0].on.each", &["\"faces\"", "\"face\""]),
    (r#", "constraints": [{ "kind": "plane", "on": { "set": 4 } }]"#, "constraints[0].on.set", &["found 4"]),
    (r#", "constraints": [{ "kind": "plane", "on": { "set": "a", "radius": 2 } }]"#, "constraints[0].on", &["`radius`", "set"]),
    (r#", "constraints": [{ "kind": "plane", "on": { "each": "ring", "radius": 0 } }]"#, "constraints[0].on.radius", &["found 0", "from 1"]),
    (r#", "constraints": [{ "kind": "plane", "on": { "vertices": [] } }]"#, "constraints[0].on.vertices", &["empty"]),
    (r#", "constraints": [{ "kind": "plane", "on": { "in": "a" } }]"#, "constraints[0].on", &["`each` is missing"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces" }, { "kind": "plane", "on": "faces", "wieght": 2 }]"#, "constraints[1]", &["`wieght`", "weight"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "weight": -1 }]"#, "constraints[0].weight", &["found -1", "from 0"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "weight": "1" }]"#, "constraints[0].weight", &["found \"1\"", "number"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "enabled": 1 }]"#, "constraints[0].enabled", &["found 1", "true or false"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "sclae": [1, 2] }]"#, "constraints[0]", &["`sclae`", "scale"]),
    (r#", "constraints": [{ "kind": "rigid", "on": "faces", "scale": [1, 2] }]"#, "constraints[0]", &["`scale`", "weight"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": "big" }]"#, "constraints[0].scale", &["big", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "line-segment", "on": "edges", "length": "rset" }]"#, "constraints[0].length", &["rset", "\"rest\"", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "line-segment", "on": "edges", "length": -1 }]"#, "constraints[0].length", &["found -1", "from 0"]),
    (r#", "constraints": [{ "kind": "line-segment", "on": "edges", "length": [2, 1] }]"#, "constraints[0].length[1]", &["found 1", "from 2"]),
    (r#", "constraints": [{ "kind": "equal-length", "on": "faces", "length": 1 }]"#, "constraints[0]", &["`length`", "weight"]),
    (r#", "constraints": [{ "kind": "angle", "on": "corners", "angle": 181 }]"#, "constraints[0].angle", &["found 181", "from 0 to 180"]),
    (r#", "constraints": [{ "kind": "angle", "on": "corners", "angle": [90, 80] }]"#, "constraints[0].angle[1]", &["found 80", "from 90"]),
    (r#", "constraints": [{ "kind": "area", "on": "faces", "area": "now" }]"#, "constraints[0].area", &["now", "\"rest\""]),
    (r#", "constraints": [{ "kind": "volume", "on": "tets", "strain": -1 }]"#, "constraints[0].strain", &["found -1", "from 0"]),
    (r#", "constraints": [{ "kind": "bending", "on": "hinges", "bend": "flat" }]"#, "constraints[0].bend", &["flat", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "symmetry", "on": "boundary", "mirror": [0, 0, 0] }]"#, "constraints[0].mirror", &["[0, 0, 0]", "direction"]),
    (r#", "constraints": [{ "kind": "symmetry", "on": "boundary", "axis": [0, 0, 1], "fold": 2.5 }]"#, "constraints[0].fold", &["found 2.5", "whole number from 2 to 360"]),
    (r#", "constraints": [{ "kind": "symmetry", "on": "boundary", "axis": "z" }]"#, "constraints[0].axis", &["\"z\"", "direction"]),
    (r#", "constraints": [{ "kind": "on-curve", "on": "boundary", "corners": 200 }]"#, "constraints[0].corners", &["found 200", "from 0 to 180"]),
    (r#", "constraints": [{ "kind": "on-curve", "on": "boundary", "closed": "maybe" }]"#, "constraints[0].closed", &["maybe", "auto", "yes", "no"]),
    (r#", "constraints": [{ "kind": "on-surface", "on": "boundary", "surface": null }]"#, "constraints[0]", &["`surface`", "weight"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "normal": [0, 0, 0] }]"#, "constraints[0].normal", &["found [0, 0, 0]", "[x, y, z], not all zero"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "along": [0, "1", 0] }]"#, "constraints[0].along[1]", &["\"1\"", "a number"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "normal": [0, 0, 1], "along": [1, 0, 0] }]"#, "constraints[0]", &["both `normal` and `along`"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "norml": [0, 0, 1] }]"#, "constraints[0]", &["`norml`", "normal, along"]),
    (r#", "constraints": [{ "kind": "line", "on": "faces", "direction": "up" }]"#, "constraints[0].direction", &["\"up\"", "[x, y, z]"]),
    (r#", "constraints": [{ "kind": "rectangle", "on": "faces", "fit": "line" }]"#, "constraints[0].fit", &["`line`", "`closest`", "`lines`"]),
    (r#", "constraints": [{ "kind": "circle", "on": "faces", "radius": -1 }]"#, "constraints[0].radius", &["found -1", "from 0"]),
    (r#", "constraints": [{ "kind": "sphere", "on": "faces", "radius": [2, 1] }]"#, "constraints[0].radius[1]", &["found 1", "from 2"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": null }]"#, "constraints[0].scale", &["null", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [1] }]"#, "constraints[0].scale", &["1", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [1, 2, 3] }]"#, "constraints[0].scale", &["more than two", "[least, greatest]"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [-1, 2] }]"#, "constraints[0].scale[0]", &["found -1", "from 0", "null"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [1, "2"] }]"#, "constraints[0].scale[1]", &["\"2\"", "number", "null"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [2, 1] }]"#, "constraints[0].scale[1]", &["found 1", "from 2"]),
    (r#", "constraints": [{ "kind": "similar", "on": "faces", "scale": [null, -0.5] }]"#, "constraints[0].scale[1]", &["found -0.5", "from 0"]),
    (r#", "handles": [{ "vertices": [0], "target": [[0, 0, 0]] }]"#, "handles[0]", &["`target`", "targets"]),
    (r#", "handles": [{ "targets": [[0, 0, 0]] }]"#, "handles[0]", &["`vertices` is missing"]),
    (r#", "handles": [{ "vertices": [] }]"#, "handles[0].vertices", &["empty"]),
    (r#", "handles": [{ "vertices": [0, 1], "targets": [[0, 0, 0]] }]"#, "handles[0].targets", &["found 1", "2 vertices"]),
    // A key that may be absent is not null where it is there.
    (r#", "current": null"#, "current", &["found null"]),
    (r#", "lesson": null"#, "lesson", &["found null"]),
    (r#", "build": null"#, "build", &["found null"]),
    (r#", "build": { "kind": "corners" }"#, "build.kind", &["corners", "corner", "face", "edge"]),
    (r#", "build": { "scale": 0 }"#, "build.scale", &["found 0", "above 0"]),
    (r#", "build": { "joint": -1 }"#, "build.joint", &["found -1", "from 0"]),
    (r#", "build": { "sheet": [600] }"#, "build.sheet", &["1", "expected"]),
    (r#", "build": { "sheet": [600, "400"] }"#, "build.sheet[1]", &["\"400\"", "number"]),
    (r#", "build": { "limits": { "wrap": 1 } }"#, "build.limits", &["`wrap`", "warp"]),
    (r#", "closeness": { "boundary": null }"#, "closeness.boundary", &["found null"]),
    (r#", "handles": [{ "vertices": [0], "weight": null }]"#, "handles[0].weight", &["found null", "number"]),
    (r#", "handles": [{ "vertices": [0], "targets": [[0, null, 0]] }]"#, "handles[0].targets[0][1]", &["found null", "number"]),
    (r#", "handles": [{ "vertices": [0], "weight": 0 }]"#, "handles[0].weight", &["found 0", "above 0"]),
    (r#", "handles": [{ "vertices": [0], "weight": 2, "fixed": true }]"#, "handles[0].weight", &["fixed"]),
    (r#", "weights": { "shape": -0.5 }"#, "weights.shape", &["found -0.5", "from 0"]),
    (r#", "weights": { "closeness": 1 }"#, "weights", &["`closeness`", "shape, close, smooth"]),
    (r#", "closeness": { "to": "curve" }"#, "closeness.to", &["\"curve\"", "\"surface\"", "\"none\""]),
    (r#", "closeness": { "to": { "mesh": 5 } }"#, "closeness.to.mesh", &["found 5", "path"]),
    (r#", "closeness": { "corners": 45 }"#, "closeness", &["`corners`", "to, weights, boundary"]),
    (r#", "closeness": { "weights": { "eaves": 3 } }"#, "closeness.weights", &["an object", "array"]),
    (r#", "closeness": { "weights": [{ "weight": 3 }] }"#, "closeness.weights[0]", &["`on` is missing", "\"faces\""]),
    (r#", "closeness": { "weights": [{ "on": "boundary" }] }"#, "closeness.weights[0]", &["`weight` is missing", "from 0"]),
    (r#", "closeness": { "weights": [{ "on": "faces", "weight": 1 }, { "on": "edge", "weight": 1 }] }"#, "closeness.weights[1].on", &["\"edge\"", "\"edges\""]),
    (r#", "closeness": { "weights": [{ "on": "faces", "weight": -2 }] }"#, "closeness.weights[0].weight", &["found -2", "from 0"]),
    (r#", "closeness": { "weights": [{ "on": "faces", "factor": 2 }] }"#, "closeness.weights[0]", &["`factor`", "on, weight"]),
    (r#", "closeness": { "boundary": true }"#, "closeness.boundary", &["found true", "an object"]),
    (r#", "closeness": { "boundary": { "angle": 45 } }"#, "closeness.boundary", &["`angle`", "corners"]),
    (r#", "closeness": { "boundary": { "corners": "45" } }"#, "closeness.boundary.corners", &["\"45\"", "degrees"]),
    (r#", "closeness": { "boundary": { "corners": 181 } }"#, "closeness.boundary.corners", &["found 181", "0 to 180"]),
    (r#", "closeness": { "boundary": { "corners": -1 } }"#, "closeness.boundary.corners", &["found -1", "0 to 180"]),
    (r#", "smoothness": { "of": 1 }"#, "smoothness.of", &["found 1", "\"displacement\""]),
    (r#", "smoothness": { "weighting": "cot" }"#, "smoothness.weighting", &["\"cot\"", "\"cotangent\""]),
    (r#", "solver": { "iterations": -3 }"#, "solver.iterations", &["found -3", "from 0"]),
    (r#", "solver": { "iterations": 1.5 }"#, "solver.iterations", &["found 1.5", "whole"]),
    (r#", "solver": { "tolerance": -1e-9 }"#, "solver.tolerance", &["-0.000000001", "from 0"]),
    (r#", "solver": { "factorization": "dense" }"#, "solver.factorization", &["\"dense\"", "\"supernodal\" or \"sprs-ldl\""]),
    (r#", "solver": { "accelerator": "newton" }"#, "solver.accelerator", &["\"newton\"", "\"anderson\""]),
    (r#", "solver": { "threads": 4 }"#, "solver", &["`threads`", "iterations"]),
];

#[test]
fn what_does_not_fit_is_refused_with_its_path() {
    for (rest, path, words) in REFUSED {
        let error = refused(&file_with(rest));
        assert_eq!(error.path, *path, "{rest}: {error}");
        for word in *words {
            assert!(error.message.contains(word), "{rest}: {error}: expected {word}");
        }
        assert!(!error.to_string().contains('\n'), "{error}");
    }
}

#[test]
fn another_format_or_version_is_refused_before_its_keys_are_looked_at() {
    let error = refused(r#"{ "format": "svg", "shapes": [] }"#);
    assert_eq!(error.path, "format");
    assert!(error.message.contains("\"svg\"") && error.message.contains("\"shape-up-scene\""));
    let error = refused(r#"{ "vertices": [] }"#);
    assert!(error.path.is_empty() && error.message.contains("`format` is missing"), "{error}");
    let error = refused(r#"{ "format": "shape-up-scene", "version": 2, "threads": 4 }"#);
    assert_eq!(error.path, "version");
    assert!(error.message.contains("version 2") && error.message.contains("version 1"), "{error}");
    for version in ["0", "\"1\"", "1.5", "null"] {
        let error = refused(&format!(r#"{{ "format": "shape-up-scene", "version": {version} }}"#));
        assert_eq!(error.path, "version", "{error}");
    }
    for text in ["[]", "3", "null", "\"scene\""] {
        let error = refused(text);
        assert!(error.path.is_empty() && error.message.contains("expected a scene"), "{error}");
    }
}

#[test]
fn what_is_not_json_is_refused_with_line_and_column() {
    let error = refused("{\n  \"format\": shape,\n}");
    assert!(error.message.contains("line 2, column 13"), "{error}");
    assert!(refused("").message.contains("empty"));
    assert!(refused(" \n").message.contains("empty"));
    let error = refused(&file_with(r#", "title": "a", "title": "b""#));
    assert!(error.message.contains("`title` occurs twice"), "{error}");
    let error = refused(&file_with(r#", "weights": { "shape": 1e999 }"#));
    assert!(error.message.contains("line 1") && error.message.contains("number"), "{error}");
    let deep = "[".repeat(5000);
    assert!(refused(&deep).message.contains("recursion"));
}

#[test]
fn no_size_in_a_file_takes_memory_that_the_file_cannot_fill() {
    // Each list was checked by itself: forty of them, 1.5 kB of text, asked for 16 GB.
    for last in [99_999_998, 999_999] {
        let set = |k: u32| format!(r#""s{k}": {{ "vertices": "0-{last}" }}"#);
        let sets = (0..40).map(set).collect::<Vec<_>>().join(", ");
        let error = refused(&file_with(&format!(r#", "sets": {{ {sets} }}"#)));
        assert!(error.path.starts_with("sets.s") && error.path.ends_with(".vertices"), "{error}");
        assert!(error.message.contains("longer than any mesh"), "{error}");
    }
    // As many as a large mesh has are no matter.
    let one = file_with(r#", "sets": { "all": { "vertices": "0-999999" } }"#);
    assert_eq!(Scene::from_json(&one).unwrap().sets["all"].vertices.len(), 1_000_000);
    // An accelerator keeps as many shapes as its window is wide.
    let error = refused(&file_with(r#", "solver": { "window": 4294967295 }"#));
    assert_eq!(error.path, "solver.window");
    assert!(error.message.contains("from 0 to 50"), "{error}");
}

#[test]
fn a_byte_order_mark_is_no_syntax_error() {
    assert!(Scene::from_json(&format!("\u{feff}{}", file_with(""))).is_ok());
}

/// A mesh object, the JSON path below `mesh`, and words that the message must have.
#[rustfmt::skip]
const REFUSED_MESHES: &[(&str, &str, &[&str])] = &[
    (r#"{}"#, "mesh", &["`positions` is missing", "\"file\""]),
    (r#"{ "file": "" }"#, "mesh.file", &["path"]),
    (r#"{ "file": "a.obj", "positions": [] }"#, "mesh", &["`positions`", "file"]),
    (r#"{ "positions": [] }"#, "mesh.positions", &["empty"]),
    (r#"{ "positions": [[0, 0, "0"]] }"#, "mesh.positions[0][2]", &["found \"0\""]),
    (r#"{ "positions": [[0,0,0],[1,0,0]], "faces": [[0, 1]] }"#, "mesh.faces[0]", &["found 2", "at least 3"]),
    (r#"{ "positions": [[0,0,0],[1,0,0]], "faces": [[0, 1, 2]] }"#, "mesh.faces[0]", &["no vertex 2", "has 2"]),
    (r#"{ "positions": [[0,0,0],[1,0,0]], "curves": [[0]] }"#, "mesh.curves[0]", &["at least 2"]),
    (r#"{ "positions": [[0,0,0],[1,0,0]], "tets": [[0,1,0,1,0]] }"#, "mesh.tets[0]", &["four"]),
    (r#"{ "positions": [[0,0,0]], "groups": { "wall": { "faces": [0] } } }"#, "mesh.groups.wall.faces", &["no face 0"]),
    (r#"{ "positions": [[0,0,0]], "groups": { "wall": { "keyword": "s" } } }"#, "mesh.groups.wall.keyword", &["\"s\"", "\"usemtl\""]),
];

#[test]
fn an_inline_mesh_that_is_none_is_refused_with_its_path() {
    for (mesh, path, words) in REFUSED_MESHES {
        let error =
            refused(&format!(r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {mesh} }}"#));
        assert_eq!(error.path, *path, "{mesh}: {error}");
        for word in *words {
            assert!(error.message.contains(word), "{mesh}: {error}: expected {word}");
        }
    }
}

#[test]
fn the_limits_of_a_scale_are_written_where_there_are_any() {
    for (scale, written) in [
        (r#", "scale": [0.5, 2]"#, Some(r#""scale": [0.5,2.0]"#)),
        (r#", "scale": [null, 1]"#, Some(r#""scale": [null,1.0]"#)),
        (r#", "scale": [0, null]"#, Some(r#""scale": [0.0,null]"#)),
        (r#", "scale": [null, null]"#, None),
        ("", None),
    ] {
        let constraints =
            format!(r#", "constraints": [{{ "kind": "similar", "on": "faces"{scale} }}]"#);
        let scene = Scene::from_json(&file_with(&constraints)).expect("the scene is valid");
        let text = scene.to_json(&Mesh::default());
        match written {
            Some(written) => assert!(text.contains(written), "{text}"),
            None => assert!(!text.contains("scale"), "{text}"),
        }
        assert_eq!(Scene::from_json(&text).expect("it reads back"), scene, "{text}");
    }
}

/// A change that makes the scene unfit for the two squares, and the path of what is then wrong.
type Unfit = (&'static str, fn(&mut Scene));

const EACH_FACE: Selector = Selector::Each { element: Element::Face, within: None, radius: 0 };

const UNFIT: &[Unfit] = &[
    ("current", |s| s.current = Some(vec![[0.0; 3]; 5])),
    ("current[1]", |s| {
        s.current = Some(vec![[0.0; 3], [f64::NAN; 3], [0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]]);
    }),
    ("sets.a.vertices[1]", |s| {
        s.sets.insert("a".into(), Set { vertices: vec![0, 6], faces: vec![] });
    }),
    ("constraints[0].eased", |s| {
        let eased = Some(EasedFaces { within: 2.0, faces: vec![0] });
        s.constraints = vec![ConstraintSpec { eased, ..constraint("plane", EACH_FACE) }];
    }),
    ("constraints[0].eased.faces[0]", |s| {
        let eased = Some(EasedFaces { within: 2.0, faces: vec![99] });
        let require = Require::Within(1.0);
        s.constraints = vec![ConstraintSpec { eased, require, ..constraint("plane", EACH_FACE) }];
    }),
    ("sets.a.faces[0]", |s| {
        s.sets.insert("a".into(), Set { vertices: vec![], faces: vec![2] });
    }),
    ("sets.a.vertices[2]", |s| {
        s.sets.insert("a".into(), Set { vertices: vec![4, 3, 4], faces: vec![] });
    }),
    ("constraints[0].on.set", |s| {
        s.constraints.push(constraint("plane", Selector::Set("nowhere".into())));
    }),
    ("constraints[1].on.in", |s| {
        let each =
            |w| Selector::Each { element: Element::Face, within: Some(String::from(w)), radius: 0 };
        s.constraints = vec![constraint("plane", each("wall")), constraint("plane", each("eaves"))];
    }),
    ("constraints[0].on.vertices[3]", |s| {
        s.constraints.push(constraint("plane", Selector::Vertices(vec![0, 1, 2, 9])));
    }),
    ("constraints[0].weight", |s| {
        s.constraints.push(constraint("plane", Selector::Vertices(vec![0, 1, 2, 3])));
        s.constraints[0].weight = f64::NAN;
    }),
    ("closeness.weights[1].on.set", |s| {
        let entry = |name: &str| ClosenessWeight { on: Selector::Set(name.into()), weight: 2.0 };
        s.closeness.weights = vec![entry("wall"), entry("nowhere")];
    }),
    ("closeness.weights[0].on.vertices[1]", |s| {
        let on = Selector::Vertices(vec![5, 6]);
        s.closeness.weights.push(ClosenessWeight { on, weight: 2.0 });
    }),
    ("closeness.weights[0].weight", |s| {
        let on = Selector::Vertices(vec![5]);
        s.closeness.weights.push(ClosenessWeight { on, weight: f64::INFINITY });
    }),
    ("closeness.boundary.corners", |s| {
        s.closeness.boundary = Some(BoundaryCloseness { corners: f64::NAN, ..Default::default() });
    }),
    ("closeness.boundary.weight", |s| {
        s.closeness.boundary = Some(BoundaryCloseness { weight: -1.0, ..Default::default() });
    }),
    ("handles[0].vertices[0]", |s| s.handles.push(handle(&[6]))),
    ("handles[1].vertices[0]", |s| s.handles = vec![handle(&[1, 2]), handle(&[2])]),
    ("handles[0].targets", |s| {
        s.handles = vec![handle(&[1, 2])];
        s.handles[0].targets = Some(vec![[0.0; 3]]);
    }),
    ("handles[0].targets[0]", |s| {
        s.handles = vec![handle(&[1])];
        s.handles[0].targets = Some(vec![[0.0, f64::INFINITY, 0.0]]);
    }),
    ("weights.close", |s| s.weights.close = f64::INFINITY),
    ("smoothness.weighting", |s| s.smoothness.weighting = Weighting::Cotangent),
];

fn handle(vertices: &[u32]) -> HandleSpec {
    HandleSpec { vertices: vertices.to_vec(), targets: None, hold: Hold::Fixed }
}

#[test]
fn what_the_mesh_does_not_have_is_named() {
    let mut mesh = two_squares();
    mesh.groups.push(Group {
        name: "wall".into(),
        keyword: GroupKeyword::Group,
        faces: vec![0],
        curves: vec![],
    });
    let good = Scene::new(MeshSource::File("roof.obj".into()));
    good.validate(&mesh).unwrap();
    for (path, change) in UNFIT {
        let mut scene = good.clone();
        change(&mut scene);
        let error = scene.validate(&mesh).expect_err(path);
        assert_eq!(&error.path, path, "{error}");
    }
}

#[test]
fn a_mesh_without_faces_is_close_to_its_curves_or_its_points() {
    let mesh = Mesh { positions: vec![[0.0; 3], [1.0, 0.0, 0.0]], ..Mesh::default() };
    let mut scene = Scene::new(MeshSource::File("curve.obj".into()));
    scene.validate(&mesh).unwrap();
    scene.weights.close = 1.0;
    for to in [ClosenessTo::Surface, ClosenessTo::Rest] {
        scene.closeness.to = to;
        scene.validate(&mesh).unwrap();
    }
}

#[test]
fn only_what_is_not_the_default_is_written() {
    let scene = Scene::new(MeshSource::File("roof.obj".into()));
    assert_eq!(
        scene.to_json(&Mesh::default()),
        "{\n  \"format\": \"shape-up-scene\",\n  \"version\": 1,\n  \
         \"mesh\": { \"file\": \"roof.obj\" },\n  \"constraints\": []\n}\n"
    );
}

#[test]
fn an_inline_mesh_is_written_with_its_groups() {
    let mut mesh = two_squares();
    mesh.curves.push(&[0, 1, 2]);
    mesh.tets.push([0, 1, 2, 3]);
    let group = |name: &str, keyword, faces: &[u32]| Group {
        name: name.into(),
        keyword,
        faces: faces.to_vec(),
        curves: vec![],
    };
    mesh.groups = vec![
        group("wall \"east\"", GroupKeyword::Object, &[0]),
        group("wall \"east\"", GroupKeyword::Material, &[0, 1]),
        Group { curves: vec![0], ..group("rail", GroupKeyword::Group, &[]) },
    ];
    let scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
    let text = scene.to_json(&mesh);
    assert_eq!(Scene::from_json(&text).unwrap(), scene, "{text}");
    assert!(text.lines().count() < 30, "long lists go on few lines: {text}");
}
