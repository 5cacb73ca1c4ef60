//! Refused scene files: the error, its JSON path, and its message.

use crate::scene::file::{file_with, refused};
use shape_up::mesh::Mesh;
use shape_up::scene::{MeshSource, Scene};

/// The faulty keys, the JSON path, and required words of the message.
#[rustfmt::skip]
const REFUSED: &[(&str, &str, &[&str])] = &[
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": "hard" }]"#, "constraints[0].require", &["found \"hard\"", "soft", "exact", "within"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": { "within": 0 } }]"#, "constraints[0].require.within", &["found 0", "above 0"]),
    (r#", "constraints": [{ "kind": "plane", "on": "faces", "require": { "within": 1 }, "eased": { "within": -2, "faces": [0] } }]"#, "constraints[0].eased.within", &["found -2", "above 0"]),
    (r#", "solver": { "shortest_edge": 2 }"#, "solver.shortest_edge", &["found 2", "from 0 to 1"]),
    (r#", "titel": "x""#, "", &["`titel`", "title", "constraints"]),
    (r#", "title": 3"#, "title", &["found 3", "a string"]),
    (r#", "up": "x""#, "up", &["found \"x\"", "\"z\" or \"y\""]),
    (r#", "up": "0123456789012345678901234567890123456789x""#, "up", &["found \"0123456789012345678901234567890123456789\"..., expected \"z\""]),
    (r#", "current": [[0, 1]]"#, "current[0]", &["an array of 2", "[x, y, z]"]),
    (r#", "sets": { "a": { "vertex": [0] } }"#, "sets.a", &["`vertex`", "vertices, faces"]),
    (r#", "sets": { "two words": { "vertices": [0.5] } }"#, "sets[\"two words\"].vertices[0]", &["found 0.5", "index"]),
    (r#", "sets": { "a": {} }"#, "sets.a", &["empty"]),
    (r#", "sets": { "a": { "vertices": "5-2" } }"#, "sets.a.vertices", &["\"5-2\"", "is reversed"]),
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
    (r#", "handles": [{ "vertices": [0], "weight": "x" }]"#, "handles[0].weight", &["found \"x\"", "a number above 0"]),
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
    // An optional key must not be null if it is present.
    (r#", "current": null"#, "current", &["found null"]),
    (r#", "lesson": null"#, "lesson", &["found null"]),
    (r#", "build": null"#, "build", &["found null"]),
    (r#", "build": { "kind": "corners" }"#, "build.kind", &["corners", "corner", "face", "edge"]),
    (r#", "build": { "scale": 0 }"#, "build.scale", &["found 0", "above 0"]),
    (r#", "build": { "joint": -1 }"#, "build.joint", &["found -1", "from 0"]),
    (r#", "build": { "sheet": [600] }"#, "build.sheet", &["1", "expected"]),
    (r#", "build": { "sheet": [600, "400"] }"#, "build.sheet[1]", &["\"400\"", "number"]),
    (r#", "build": { "seams": "0-1" }"#, "build.seams", &["\"0-1\"", "array"]),
    (r#", "build": { "seams": [[0, 1], 5] }"#, "build.seams[1]", &["found 5", "a pair of indices"]),
    (r#", "build": { "seams": [[0, -1]] }"#, "build.seams[0][1]", &["found -1", "an index"]),
    (r#", "build": { "seams": [[0, 1], [2, 2]] }"#, "build.seams[1]", &["[2, 2]", "two ends of an edge"]),
    (r#", "build": { "seams": [[0, 1], [1, 0]] }"#, "build.seams[1]", &["[1, 0]", "twice"]),
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
    (r#", "closeness": { "to": { "mesh": "" } }"#, "closeness.to.mesh", &["found \"\"", "path of a mesh file"]),
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
    (r#", "solver": { "iterations": -3 }"#, "solver.iterations", &["found -3", "0 or more"]),
    (r#", "solver": { "iterations": 1.5 }"#, "solver.iterations", &["found 1.5", "whole"]),
    (r#", "tolerance": 0"#, "tolerance", &["found 0", "above 0"]),
    (r#", "solver": { "tolerance": -1e-9 }"#, "solver.tolerance", &["-0.000000001", "from 0"]),
    (r#", "solver": { "factorization": "dense" }"#, "solver.factorization", &["\"dense\"", "\"supernodal\" or \"sprs-ldl\""]),
    (r#", "solver": { "accelerator": "newton" }"#, "solver.accelerator", &["\"newton\"", "\"anderson\""]),
    (r#", "solver": { "iterations": 4294967296 }"#, "solver.iterations", &["found 4294967296", "whole"]),
    // An object is not an array of its values, and an array of numbers is neither shorter nor longer.
    (r#", "weights": [5, 10, 2]"#, "weights", &["found an array", "an object"]),
    (r#", "handles": [[[0]]]"#, "handles[0]", &["found an array", "an object"]),
    (r#", "sets": { "a": [[0]] }"#, "sets.a", &["found an array", "an object"]),
    (r#", "steps": [["a"]]"#, "steps[0]", &["found an array", "an object"]),
    (r#", "build": { "limits": [1, 2, 3, 4] }"#, "build.limits", &["found an array", "an object"]),
    (r#", "build": { "sheet": [600, 400, 3] }"#, "build.sheet", &["an array of 3", "2 numbers"]),
    (r#", "build": { "seams": [[0, 1, 2]] }"#, "build.seams[0]", &["an array of 3", "a pair"]),
    (r#", "build": { "seams": [[0]] }"#, "build.seams[0]", &["an array of 1", "a pair"]),
    (r#", "build": { "kind": { "corner": null } }"#, "build.kind", &["found an object", "a word"]),
    (r#", "build": { "page": [] }"#, "build.page", &["found an array", "a word"]),
    (r#", "build": { "kind": 5 }"#, "build.kind", &["found 5", "a word"]),
    (r#", "current": [[0, 1, 2, 3]]"#, "current[0]", &["an array of 4", "[x, y, z]"]),
    (r#", "steps": [{ "title": "a", "camera": [1, 2] }]"#, "steps[0].camera", &["an array of 2", "7 numbers"]),
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
    for (text, words) in [
        ("{\n \"a\": tru }", "line 2, column 10: not JSON: expected a value"),
        ("{ \"a\": 1,\n}", "line 2, column 1: not JSON: trailing comma"),
        ("{ \"a\": [1", "not JSON: the text ends within a list"),
        ("{ \"a\": \"x", "not JSON: the text ends within a string"),
        ("{ \"a\": \"\\x\" }", "not JSON: invalid escape"),
        ("{ \"a\": 01 }", "not JSON: invalid number"),
        ("{ a: 1 }", "line 1, column 3: not JSON: key must be a string"),
        ("{} {}", "line 1, column 4: not JSON: trailing characters"),
    ] {
        let error = refused(text);
        assert!(error.path.is_empty() && error.message.contains(words), "{text}: {error}");
    }
    assert!(refused("").message.contains("empty"));
    assert!(refused(" \n").message.contains("empty"));
    let error = refused(&file_with(r#", "title": "a", "title": "b""#));
    assert!(error.message.contains("`title` occurs twice"), "{error}");
    let error = refused(&file_with(r#", "weights": { "shape": 1e999 }"#));
    assert!(error.message.contains("line 1") && error.message.contains("number"), "{error}");
}

#[test]
fn a_deep_document_is_refused_and_takes_no_more_stack_than_another() {
    let deep = "[".repeat(100_000);
    assert!(refused(&deep).message.contains("expected a scene"));
    assert!(refused(&file_with(&format!(r#", "title": {deep}"#))).message.contains("line 1"));
    let closed = format!("{deep}{}", "]".repeat(100_000));
    let error = refused(&file_with(&format!(r#", "title": {closed}"#)));
    assert!(error.path == "title" && error.message.contains("a string"), "{error}");
    // Only parameters of constraints are read before it is known what they should be.
    let entry =
        format!(r#", "constraints": [{{ "kind": "plane", "on": "faces", "normal": {closed} }}]"#);
    assert!(refused(&file_with(&entry)).message.contains("recursion"));
}

#[test]
fn a_repeated_key_is_refused_with_its_place() {
    for (rest, path, key) in [
        (r#", "title": "a", "title": "b""#, "", "title"),
        (r#", "weights": { "shape": 1, "shape": 1 }"#, "weights", "shape"),
        (r#", "sets": { "a": { "faces": [0] }, "a": { "faces": [1] } }"#, "sets", "a"),
        (
            r#", "constraints": [{ "kind": "plane", "on": "faces", "kind": "line" }]"#,
            "constraints[0]",
            "kind",
        ),
        (
            r#", "constraints": [{ "kind": "plane", "on": "faces", "normal": [0, 0, 1], "normal": [0, 0, 1] }]"#,
            "constraints[0]",
            "normal",
        ),
        (
            r#", "constraints": [{ "kind": "plane", "on": { "set": "a", "set": "a" } }]"#,
            "constraints[0].on",
            "set",
        ),
    ] {
        let error = refused(&file_with(rest));
        assert_eq!(
            (&*error.path, &*error.message),
            (path, &*format!("the key `{key}` occurs twice"))
        );
    }
    let groups =
        r#", "faces": [[0,1,2]], "groups": { "a": { "faces": [0] }, "a": { "faces": [] } }"#;
    let error = refused(&inline(groups));
    assert_eq!((&*error.path, &*error.message), ("mesh.groups", "the key `a` occurs twice"));
    let error =
        refused(r#"{ "format": "shape-up-scene", "format": "shape-up-scene", "version": 1 }"#);
    assert_eq!((&*error.path, &*error.message), ("", "the key `format` occurs twice"));
}

#[test]
fn no_size_in_a_file_takes_memory_that_the_file_cannot_fill() {
    // Each list was checked separately: forty of them, in 1.5 kB of text, requested 16 GB.
    for last in [99_999_998, 999_999] {
        let set = |k: u32| format!(r#""s{k}": {{ "vertices": "0-{last}" }}"#);
        let sets = (0..40).map(set).collect::<Vec<_>>().join(", ");
        let error = refused(&file_with(&format!(r#", "sets": {{ {sets} }}"#)));
        assert!(error.path.starts_with("sets.s") && error.path.ends_with(".vertices"), "{error}");
        assert!(error.message.contains("too many indices"), "{error}");
    }
    // As many vertices as in a large mesh are accepted.
    let one = file_with(r#", "sets": { "all": { "vertices": "0-999999" } }"#);
    assert_eq!(Scene::from_json(&one).unwrap().sets["all"].vertices.len(), 1_000_000);
    // An accelerator stores as many shapes as its window is wide.
    let error = refused(&file_with(r#", "solver": { "window": 4294967295 }"#));
    assert_eq!(error.path, "solver.window");
    assert!(error.message.contains("from 0 to 50"), "{error}");
}

#[test]
fn corners_repeated_in_a_row_are_dropped_and_others_are_refused() {
    let read = |mesh: &str| Scene::from_json(&inline(mesh));
    let scene = read(r#", "faces": [[0,1,2,2],[1,3,2,1]], "curves": [[0,0,3,0]]"#).unwrap();
    let mesh = mesh_of(&scene);
    assert_eq!(mesh.faces.iter().collect::<Vec<_>>(), [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(mesh.curves.row(0), [0, 3, 0]);
    for (mesh, path, words) in [
        (r#", "faces": [[0,1,2],[0,1,0,1]]"#, "mesh.faces[1]", "vertex 0 is in it twice"),
        (r#", "faces": [[0,0,0]]"#, "mesh.faces[0]", "found 3 vertices with repeats"),
        (r#", "tets": [[0,1,2,0]]"#, "mesh.tets[0]", "vertex 0 is in it twice"),
        (r#", "curves": [[3,3]]"#, "mesh.curves[0]", "expected at least 2 different ones"),
    ] {
        let error = read(mesh).unwrap_err();
        assert_eq!(error.path, path);
        assert!(error.message.contains(words), "{error}");
    }
}

fn inline(mesh: &str) -> String {
    let points = r#""positions": [[0,0,0],[1,0,0],[0,1,0],[1,1,0.3]]"#;
    format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ {points}{mesh} }},
            "smoothness": {{ "weighting": "cotangent" }} }}"#
    )
}

fn mesh_of(scene: &Scene) -> &Mesh {
    let MeshSource::Inline(mesh) = &scene.mesh else { panic!("the mesh is in the scene") };
    mesh
}

#[test]
fn cotangent_weights_need_triangles_and_nothing_else() {
    let checked = |mesh: &str| {
        let scene = Scene::from_json(&inline(mesh)).unwrap();
        scene.validate(mesh_of(&scene))
    };
    checked(r#", "faces": [[0,1,2],[1,3,2]], "curves": [[0,3]]"#).unwrap();
    for mesh in ["", r#", "curves": [[0,3]]"#, r#", "tets": [[0,1,2,3]]"#] {
        let error = checked(mesh).unwrap_err();
        assert_eq!(error.path, "smoothness.weighting");
        assert!(error.message.contains("the mesh has no faces"), "{error}");
    }
}
