//! The scene file: reading, refusals and their messages, and writing without loss.

use crate::scene::asked::constraint;
use crate::support::time::takes_less;
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

/// A scene file that refers to a mesh file, with the keys in `rest` appended.
pub(crate) fn file_with(rest: &str) -> String {
    format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "roof.obj" }}{rest} }}"#
    )
}

pub(crate) fn refused(text: &str) -> SceneError {
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
    assert_eq!(*scene.sets["eaves"].vertices, [0, 1, 2, 5]);
    assert_eq!(*scene.sets["skylight"].faces, [1]);
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
            Selector::Vertices([3, 5, 4].into()),
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
            boundary: BoundaryCloseness {
                corners: 30.0,
                require: BoundaryRequire::Exact,
                weight: 4.0,
            },
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
        let spec = serde_json::from_str::<ConstraintSpec>(&entry).expect("it is a constraint");
        assert_eq!(spec.require, require, "{words}");
    }
}

#[test]
fn a_byte_order_mark_is_no_syntax_error() {
    assert!(Scene::from_json(&format!("\u{feff}{}", file_with(""))).is_ok());
}

/// A mesh object, the JSON path below `mesh`, and required words of the message.
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
        (r#", "scale": [0.5, 2]"#, Some(r#""scale": [0.5, 2]"#)),
        (r#", "scale": [null, 1]"#, Some(r#""scale": [null, 1]"#)),
        (r#", "scale": [0, null]"#, Some(r#""scale": [0, null]"#)),
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

/// A change that makes the scene unfit for the two squares; used with the path of the error.
type Unfit = (&'static str, fn(&mut Scene));

const EACH_FACE: Selector = Selector::Each { element: Element::Face, within: None, radius: 0 };

const UNFIT: &[Unfit] = &[
    ("current", |s| s.current = Some(vec![[0.0; 3]; 5])),
    ("current[1]", |s| {
        s.current = Some(vec![[0.0; 3], [f64::NAN; 3], [0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]]);
    }),
    ("sets.a.vertices[1]", |s| {
        s.sets.insert("a".into(), Set { vertices: [0, 6].into(), faces: [].into() });
    }),
    ("constraints[0].eased", |s| {
        let eased = Some(EasedFaces { within: 2.0, faces: [0].into() });
        s.constraints = vec![ConstraintSpec { eased, ..constraint("plane", EACH_FACE) }];
    }),
    ("constraints[0].eased.faces[0]", |s| {
        let eased = Some(EasedFaces { within: 2.0, faces: [99].into() });
        let require = Require::Within(1.0);
        s.constraints = vec![ConstraintSpec { eased, require, ..constraint("plane", EACH_FACE) }];
    }),
    ("sets.a.faces[0]", |s| {
        s.sets.insert("a".into(), Set { vertices: [].into(), faces: [2].into() });
    }),
    ("sets.a.vertices[2]", |s| {
        s.sets.insert("a".into(), Set { vertices: [4, 3, 4].into(), faces: [].into() });
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
        s.constraints.push(constraint("plane", Selector::Vertices([0, 1, 2, 9].into())));
    }),
    ("constraints[0].weight", |s| {
        s.constraints.push(constraint("plane", Selector::Vertices([0, 1, 2, 3].into())));
        s.constraints[0].weight = f64::NAN;
    }),
    ("closeness.weights[1].on.set", |s| {
        let entry = |name: &str| ClosenessWeight { on: Selector::Set(name.into()), weight: 2.0 };
        s.closeness.weights = vec![entry("wall"), entry("nowhere")];
    }),
    ("closeness.weights[0].on.vertices[1]", |s| {
        let on = Selector::Vertices([5, 6].into());
        s.closeness.weights.push(ClosenessWeight { on, weight: 2.0 });
    }),
    ("closeness.weights[0].weight", |s| {
        let on = Selector::Vertices([5].into());
        s.closeness.weights.push(ClosenessWeight { on, weight: f64::INFINITY });
    }),
    ("closeness.boundary.corners", |s| {
        s.closeness.boundary.corners = f64::NAN;
    }),
    ("closeness.boundary.weight", |s| {
        s.closeness.boundary.weight = -1.0;
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
fn a_group_for_each_panel_takes_hardly_longer_to_write_than_the_panels() {
    let faces = Ragged::from_iter((0..20_000).map(|_| [0, 1, 4, 3]));
    let panels = Mesh { faces, ..two_squares() };
    let named = |face: u32| Group {
        name: format!("panel {face}"),
        keyword: GroupKeyword::Group,
        faces: vec![face],
        curves: Vec::new(),
    };
    let grouped = Mesh { groups: (0..20_000).map(named).collect(), ..panels.clone() };
    let scene = Scene::new(MeshSource::Inline(Box::default()));
    let write = |mesh: &Mesh| assert!(!scene.to_json(mesh).is_empty());
    takes_less(12.0, || write(&grouped), || write(&panels));
}

#[test]
fn names_of_sets_and_groups_may_be_keys_of_the_format() {
    let keys = [
        ["sets", "constraints", "handles", "goals", "kept", "steps", "groups", "mesh"],
        ["positions", "current", "faces", "curves", "tets", "vertices", "on", "\"faces\""],
    ];
    for name in keys.as_flattened() {
        for faces in [&[][..], &[1], &[0, 1]] {
            let mut mesh = two_squares();
            mesh.curves.push(&[0, 1, 2]);
            let group = |keyword| Group {
                name: (*name).into(),
                keyword,
                faces: faces.to_vec(),
                curves: vec![0],
            };
            mesh.groups = vec![group(GroupKeyword::Object)];
            for statements in 1..=2 {
                let mut scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
                let set = Set { vertices: [0].into(), faces: (*faces).into() };
                scene.sets.insert((*name).to_owned(), set);
                let text = scene.to_json(&mesh);
                assert_eq!(Scene::from_json(&text).unwrap(), scene, "{statements}: {text}");
                mesh.groups.push(group(GroupKeyword::Group));
            }
        }
    }
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
    mesh.untouched.push(&[0, 1, 2, 0, 3, 2]);
    mesh.unplaced = vec![1, 3];
    let scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
    let text = scene.to_json(&mesh);
    assert_eq!(Scene::from_json(&text).unwrap(), scene, "{text}");
    assert!(text.lines().count() < 30, "long lists go on few lines: {text}");
}

#[test]
fn a_file_keeps_its_layout_and_the_fingerprint_of_its_exercise() {
    let mut mesh = two_squares();
    mesh.groups = vec![Group {
        name: "wall".into(),
        keyword: GroupKeyword::Group,
        faces: vec![0],
        curves: vec![],
    }];
    let mut scene = Scene::from_json(&file_with(
        r#", "current": [[0.123456789, 0.123456789, 0.123456789], [1, 0, 0], [2, 0, 0],
            [0, 1, 0.123456789], [1, 1, 0.123456789], [2, 1, 0.123456789]],
        "sets": { "eaves": { "vertices": [0, 1] } },
        "constraints": [{ "kind": "plane", "on": "faces" }, { "kind": "plane", "on": "rings" }],
        "lesson": { "text": "", "goals": [{ "measure": "planarity", "at_most": 1 }] }"#,
    ))
    .unwrap();
    assert!(scene.to_json(&mesh).contains("\n  \"mesh\": { \"file\": \"roof.obj\" },\n"));
    // Results that were handed in have it.
    assert_eq!(scene.fingerprint(&mesh), "a7b58b737d5bd7de");
    scene.mesh = MeshSource::Inline(Box::default());
    let expected = r#"{
  "format": "shape-up-scene",
  "version": 1,
  "mesh": {
    "positions": [
      [0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]
    ],
    "faces": [
      [0, 1, 4, 3], [1, 2, 5, 4]
    ],
    "groups": {
      "wall": { "faces": [0] }
    }
  },
  "current": [
    [0.123456789, 0.123456789, 0.123456789], [1, 0, 0], [2, 0, 0], [0, 1, 0.123456789],
    [1, 1, 0.123456789], [2, 1, 0.123456789]
  ],
  "sets": {
    "eaves": { "vertices": [0, 1] }
  },
  "constraints": [
    { "kind": "plane", "on": "faces" },
    { "kind": "plane", "on": "rings" }
  ],
  "lesson": { "text": "", "goals": [
    { "measure": "planarity", "at_most": 1 }
  ] }
}
"#;
    assert_eq!(scene.to_json(&mesh), expected);
}
