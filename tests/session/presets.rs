//! Presets of settings: each keeps real meshes intact if its requirements are met.

use shape_up::math::{cosine, sine};
use shape_up::mesh::{Mesh, Topology};
use shape_up::scene::{PRESETS, Preset, Scene};
use shape_up::session::{Edit, PanelStart, Session};

fn opened(mesh: Mesh) -> Session {
    Session::open(Scene::opened("own.obj"), mesh).unwrap()
}

#[test]
fn a_preset_is_one_step_and_known_by_its_settings() {
    let mut session = opened(crate::support::grid::bumpy(4));
    assert_eq!(Preset::of(session.document()).unwrap().id, "opened");
    for preset in PRESETS {
        session.edit(Edit::Preset { id: preset.id.to_owned() }).unwrap();
        assert_eq!(Preset::of(session.document()), Some(preset));
    }
    // The weights alone are not the preset of the figure.
    session.edit(Edit::Preset { id: "fig-5".to_owned() }).unwrap();
    let weights = session.document().weights;
    session.edit(Edit::Preset { id: "opened".to_owned() }).unwrap();
    session.edit(Edit::SetWeights(weights.into())).unwrap();
    assert_eq!(Preset::of(session.document()), None);
    session.undo().unwrap();
    session.undo().unwrap();
    assert_eq!(Preset::of(session.document()).unwrap().id, "fig-5");
    assert!(session.edit(Edit::Preset { id: "fig-99".to_owned() }).is_err());
}

#[test]
fn a_preset_says_what_the_mesh_lacks() {
    let open = Topology::new(&crate::support::grid::bumpy(3));
    let closed = Topology::new(&Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].into_iter().collect(),
        ..Mesh::default()
    });
    let warned = |topology: &Topology, handles: usize| -> Vec<&str> {
        let offers = PRESETS.iter().map(|preset| preset.offer(topology, handles));
        offers.filter(|offer| offer.warning.is_some()).map(|offer| offer.id).collect()
    };
    assert_eq!(warned(&open, 1), [""; 0]);
    assert_eq!(warned(&open, 0), ["fig-6"]);
    assert_eq!(warned(&closed, 1), ["fig-5"]);
}

#[test]
fn presets_of_the_paper_keep_real_meshes_whole_when_they_do_not_warn() {
    for file in
        ["botanic-garden-bubble-0.obj", "compas_hypar.obj", "M2_eq_quad2.obj", "pillow_1.obj"]
    {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        for preset in PRESETS {
            let mut session = opened(mesh.clone());
            if preset.offer(session.topology(), 0).warning.is_some() {
                continue;
            }
            session
                .edit(Edit::MakePanels {
                    kind: "plane".to_owned(),
                    within: None,
                    from: PanelStart::Now,
                })
                .unwrap();
            session.edit(Edit::Preset { id: preset.id.to_owned() }).unwrap();
            session.begin_run();
            for _ in 0..300 {
                session.step().unwrap();
            }
            session.end_run();
            assert_eq!(session.collapse(), None, "{file} {}", preset.id);
        }
    }
}

/// Points near a sphere of radius 5, along a spiral.
fn spiral() -> Vec<[f64; 3]> {
    let point = |k: u32| {
        let (turn, t) = (0.11 * f64::from(k), f64::from(k) / 20.0 - 1.0);
        let radius = (25.0 - 20.0 * t * t).sqrt() + 0.02 * f64::from(7 * k % 5);
        [radius * cosine(turn), radius * sine(turn), 4.5 * t]
    };
    (0..40).map(point).collect()
}

#[test]
fn points_and_curves_stay_near_what_they_are_without_a_surface() {
    // Files with only `v`, or `v` and `l`: "surface" was refused for them, although it is the
    // default of scenes and part of presets.
    let points = Mesh { positions: spiral(), ..Mesh::default() };
    let curve: Vec<u32> = (0..40).collect();
    let curve = Mesh { curves: [curve].into_iter().collect(), ..points.clone() };
    for (what, mesh) in [("points", points), ("curve", curve)] {
        // The other presets need handles, or a boundary against the smoothing.
        for id in ["opened", "fig-7"] {
            let mut session = opened(mesh.clone());
            session.edit(Edit::Preset { id: id.to_owned() }).unwrap();
            let row = r#"{ "addConstraint": { "kind": "sphere", "on": { "vertices": "0-39" }, "weight": 1 } }"#;
            let row = Edit::from_json(row).unwrap();
            session.edit(row).unwrap();
            let before = session.solver().energy().shape;
            session.solve(false).unwrap();
            let report = session.report();
            let (shape, moved) = (report.energy.last.shape, report.moved.max);
            assert!(shape < 0.6 * before, "{what}, {id}: {before} becomes {shape}");
            assert!(moved < 2.0, "{what}, {id}: moved {moved}");
        }
    }
}
