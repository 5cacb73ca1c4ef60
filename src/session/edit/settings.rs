//! Declarations of the settings of a scene other than its weights: closeness, smoothness, solver.
//! Hosts build their controls from the list.

use crate::constraint::{Form, Param};
use crate::mesh::Topology;
use crate::scene::{
    Accelerator, AttemptSetting, BoundaryRequire, ClosenessTo, NamedEnum, Scene, SceneError,
    SmoothnessOf, Weighting,
};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// A declared setting.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Setting {
    /// Id, name and forms, as for a parameter of a kind.
    #[serde(flatten)]
    pub param: Param,
    /// A description in one sentence.
    pub summary: &'static str,
    /// The heading under which hosts list it.
    pub group: &'static str,
}

const NEAR: &str = "Close to the original";
const SMOOTH: &str = "Smoothness";
const SOLVER: &str = "Solver";
const OFF: Form = Form::Word("off");

impl NamedEnum for bool {
    const WORDS: &'static [(&'static str, bool)] = &[("on", true), ("off", false)];
}

/// All settings, in the order in which hosts list them.
pub const SETTINGS: &[Setting] = &[
    Setting {
        param: Param::word(
            "closeness",
            "Stay near",
            "surface",
            const { &Form::words::<_, 4>(ClosenessTo::WORDS) },
        )
        .called(&[("rest", "original position")]),
        summary: "Surface: vertices may glide along the original surface, or along its curves if the file has no faces. Original position: each stays near it. None: no closeness. Target: near another surface, read from a file.",
        group: NEAR,
    },
    Setting {
        param: Param::word(
            "boundary",
            "Boundary stays on its curve",
            "off",
            const { &Form::words::<_, 3>(BoundaryRequire::WORDS) },
        )
        .called(&[("exact", "exactly"), ("soft", "nearly")]),
        summary: "Boundary vertices glide along their own curve, and corners stay. Exactly: always. Nearly: weighed against the other terms.",
        group: NEAR,
    },
    Setting {
        param: Param::number("boundary-weight", "Nearly: weight", "", 1.0, [0.0, 1e12]),
        summary: "Closeness weight of the boundary to its curve, relative to that of other vertices to the original.",
        group: NEAR,
    },
    Setting {
        param: Param::number("corners", "Corners turn by more than", "degrees", 45.0, [0.0, 180.0]),
        summary: "Boundary vertices at which the boundary turns by more than this angle are corners.",
        group: NEAR,
    },
    Setting {
        param: Param::word(
            "smoothness",
            "Smooth",
            "surface",
            const { &Form::words::<_, 2>(SmoothnessOf::WORDS) },
        ),
        summary: "Smooths the surface itself, or only its displacement, which keeps bumps and creases.",
        group: SMOOTH,
    },
    Setting {
        param: Param::word(
            "weighting",
            "Neighbours count",
            "auto",
            const { &Form::words::<_, 4>(Weighting::WORDS) },
        ),
        summary: "Uniform: all alike. Cotangent (triangles) and polygon (any faces): by the shape of the faces between them. Auto: cotangent on triangle meshes, else uniform.",
        group: SMOOTH,
    },
    Setting {
        param: Param::word(
            "accelerator",
            "Accelerator",
            "quasi-newton",
            const { &Form::words::<_, 3>(Accelerator::WORDS) },
        ),
        summary: "How earlier steps speed up the next ones. None: the plain iteration of the paper.",
        group: SOLVER,
    },
    Setting {
        param: Param::number("window", "Steps remembered", "", 5.0, [0.0, 50.0]),
        summary: "Number of earlier steps the accelerator uses; 0 turns it off.",
        group: SOLVER,
    },
    Setting {
        param: Param::number("tolerance", "Stopping threshold", "", 1e-9, [0.0, 1.0]),
        summary: "The run stops when the total energy changes by less than this fraction; with 0 it goes on until Pause or, with a required constraint, to the limit of iterations.",
        group: SOLVER,
    },
    Setting {
        param: Param::word("mean-centring", "Mean centring", "on", &[Form::Word("on"), OFF]),
        summary: "Shapes are fitted about the means of their points, so that they can move freely. Off: slower, for comparison.",
        group: SOLVER,
    },
    Setting {
        param: Param::word("monotone", "Never increase energy", "off", &[OFF, Form::Word("on")]),
        summary: "Keeps the previous projection where the new one is farther away, so that the energy never rises, even with kinds that are not exact.",
        group: SOLVER,
    },
    Setting {
        param: Param {
            forms: &[Form::Number, OFF],
            ..Param::number("shortest-edge", "Shortest edge", "", 0.3, [0.0, 1.0])
        },
        summary: "Edges of what has to be exact or within a length keep at least this fraction of their original length. Off: they may vanish.",
        group: SOLVER,
    },
];

/// Why closeness keeps no vertex near the original, but for a boundary that is held exactly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct UnusedCloseness {
    /// The reason, as a sentence.
    pub why: &'static str,
    /// The ids of the settings that have no effect for that reason.
    pub settings: Vec<&'static str>,
}

impl UnusedCloseness {
    /// Returns this for a scene on a mesh with this topology; none if closeness may keep some vertices
    /// near the original. A boundary that is held exactly on its curves needs no weight.
    pub fn of(scene: &Scene, topology: &Topology) -> Option<UnusedCloseness> {
        let boundary = match topology.boundary_loops().is_empty() {
            true => BoundaryRequire::Off,
            false => scene.closeness.boundary.require,
        };
        let is_nowhere = scene.closeness.to == ClosenessTo::None;
        if scene.weights.close == 0.0 {
            let why = match boundary {
                BoundaryRequire::Exact => {
                    "The weight of Close is 0: only the boundary is kept, exactly."
                }
                _ => "The weight of Close is 0: nothing is kept near the original.",
            };
            let mut settings = if is_nowhere { Vec::new() } else { vec!["closeness"] };
            if boundary == BoundaryRequire::Soft {
                settings.extend(["boundary", "boundary-weight", "corners"]);
            }
            return Some(UnusedCloseness { why, settings });
        }
        let is_free = is_nowhere && boundary == BoundaryRequire::Off;
        let why = "Stay near is none: nothing is kept near the original.";
        is_free.then(|| UnusedCloseness { why, settings: Vec::new() })
    }
}

/// Whether the setting `id` concerns the solver and not the problem.
pub(crate) fn is_of_solver(id: &str) -> bool {
    SETTINGS.iter().any(|setting| setting.param.id == id && setting.group == SOLVER)
}

/// The value of every setting in `scene`, by id.
pub fn settings_of(scene: &Scene) -> Map<String, Value> {
    let boundary = scene.closeness.boundary;
    let solver = scene.solver;
    [
        ("closeness", json!(scene.closeness.to.word())),
        ("boundary", json!(boundary.require.word())),
        ("boundary-weight", json!(boundary.weight)),
        ("corners", json!(boundary.corners)),
        ("smoothness", json!(scene.smoothness.of.word())),
        ("weighting", json!(scene.smoothness.weighting.word())),
        ("accelerator", json!(solver.accelerator.word())),
        ("window", json!(solver.window)),
        ("tolerance", json!(solver.tolerance)),
        ("mean-centring", json!(solver.mean_centring.word())),
        ("monotone", json!(solver.monotone.word())),
        ("shortest-edge", solver.shortest_edge.map_or(json!("off"), |ratio| json!(ratio))),
    ]
    .map(|(id, value)| (id.to_owned(), value))
    .into_iter()
    .collect()
}

/// Changes a setting of `scene`, and returns its label. It is then the user's, also where a search had
/// chosen this value.
///
/// # Errors
/// If there is no such setting, or the value has none of its forms or is out of range.
pub(crate) fn set(scene: &mut Scene, id: &str, value: &Value) -> Result<&'static str, SceneError> {
    let error = |message: String| SceneError { path: id.to_owned(), message };
    let setting = SETTINGS
        .iter()
        .find(|setting| setting.param.id == id)
        .ok_or_else(|| error(format!("there is no setting `{id}`")))?;
    let param = setting.param;
    let number = || {
        value
            .as_f64()
            .filter(|&number| param.allows(number))
            .ok_or_else(|| error(format!("found {value}, expected {}", param.range_in_words())))
    };
    match id {
        "closeness" => {
            scene.closeness.to = choice(id, value)?;
            scene.attempt.release(AttemptSetting::Closeness);
        }
        "boundary" => {
            scene.closeness.boundary.require = choice(id, value)?;
            scene.attempt.release(AttemptSetting::Boundary);
        }
        "boundary-weight" => scene.closeness.boundary.weight = number()?,
        "corners" => scene.closeness.boundary.corners = number()?,
        "smoothness" => scene.smoothness.of = choice(id, value)?,
        "weighting" => scene.smoothness.weighting = choice(id, value)?,
        "accelerator" => scene.solver.accelerator = choice(id, value)?,
        "window" => {
            let steps = number()?;
            if steps.fract() != 0.0 {
                return Err(error(format!("found {steps}, expected a whole number")));
            }
            scene.solver.window = steps as u32;
        }
        "tolerance" => scene.solver.tolerance = number()?,
        "mean-centring" => scene.solver.mean_centring = choice(id, value)?,
        "monotone" => scene.solver.monotone = choice(id, value)?,
        "shortest-edge" => {
            let off = value.as_str() == Some("off");
            scene.solver.shortest_edge = if off { None } else { Some(number()?) };
        }
        _ => unreachable!("{id} is declared"),
    }
    Ok(setting.param.label)
}

/// Parses a value of setting `id` as one of its choices.
fn choice<T: NamedEnum>(id: &str, value: &Value) -> Result<T, SceneError> {
    value.as_str().and_then(T::of_word).ok_or_else(|| SceneError {
        path: id.to_owned(),
        message: format!("found {value}, expected {}", T::list(" or ")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::scene::MeshSource;

    fn scene() -> Scene {
        Scene::new(MeshSource::File(String::new()))
    }

    #[test]
    fn a_new_scene_has_the_declared_defaults() {
        let now = settings_of(&scene());
        assert_eq!(now.len(), SETTINGS.len());
        for Setting { param, .. } in SETTINGS {
            let declared = serde_json::to_value(param.default).expect("it is plain");
            assert_eq!(now[param.id].as_f64(), declared.as_f64(), "{}", param.id);
            assert_eq!(now[param.id].as_str(), declared.as_str(), "{}", param.id);
        }
    }

    #[test]
    fn every_declared_word_and_number_can_be_set_and_is_read_back() {
        for Setting { param, .. } in SETTINGS {
            for form in param.forms {
                let value = match form {
                    Form::Word(word) => json!(word),
                    _ => json!(param.range[1]),
                };
                let mut scene = scene();
                set(&mut scene, param.id, &value).expect("it is declared");
                let read = &settings_of(&scene)[param.id];
                assert_eq!(read.as_str(), value.as_str(), "{}", param.id);
                assert_eq!(read.as_f64(), value.as_f64(), "{}", param.id);
            }
        }
    }

    #[test]
    fn numbers_of_a_boundary_that_is_free_are_kept_and_leave_it_free() {
        // Each of them held the boundary, and `off` took them away.
        let mut scene = scene();
        for (id, value) in [
            ("corners", json!(30.0)),
            ("boundary-weight", json!(4.0)),
            ("boundary", json!("exact")),
            ("boundary", json!("off")),
        ] {
            set(&mut scene, id, &value).expect("it is declared");
            let file = serde_json::to_value(&scene.closeness).expect("it is plain");
            scene.closeness = serde_json::from_value(file).expect("it is written so");
            let now = settings_of(&scene);
            assert_eq!(now[id], value);
            assert_eq!(now["boundary"] == json!("exact"), value == json!("exact"));
            assert_eq!(now["corners"], json!(30.0));
        }
        assert_eq!(settings_of(&scene)["boundary-weight"], json!(4.0));
    }

    #[test]
    fn settings_that_need_the_weight_of_closeness_say_so_without_it() {
        // A boundary that was to stay nearly on its curve left it, and nothing said why.
        let mut scene = scene();
        let triangle = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let of = |scene: &Scene, faces: &[[u32; 3]]| {
            let faces = faces.iter().copied().collect();
            let mesh = Mesh { positions: triangle.to_vec(), faces, ..Mesh::default() };
            UnusedCloseness::of(scene, &Topology::new(&mesh))
        };
        let unused = |scene: &Scene| of(scene, &[[0, 1, 2]]).map(|unused| unused.settings);
        assert_eq!(unused(&scene), Some(vec!["closeness"]));
        scene.closeness.boundary.require = BoundaryRequire::Soft;
        let all = vec!["closeness", "boundary", "boundary-weight", "corners"];
        assert_eq!(unused(&scene), Some(all));
        scene.closeness.boundary.require = BoundaryRequire::Exact;
        let exact = of(&scene, &[[0, 1, 2]]).expect("closeness has no weight");
        assert!(exact.why.ends_with("only the boundary is kept, exactly."), "it was denied");
        let closed = of(&scene, &[[0, 1, 2], [0, 2, 1]]).expect("closeness has no weight");
        assert!(closed.why.ends_with("nothing is kept near the original."), "it has no boundary");
        scene.weights.close = 1.0;
        assert_eq!(unused(&scene), None);
        scene.closeness.to = ClosenessTo::None;
        assert_eq!(unused(&scene), None);
        scene.closeness.boundary.require = BoundaryRequire::Off;
        assert_eq!(unused(&scene), Some(Vec::new()));
    }

    #[test]
    fn what_a_setting_cannot_be_is_refused_at_its_place() {
        for (id, value) in [
            ("closeness", json!("roof")),
            ("boundary", json!(45)),
            ("corners", json!(181)),
            ("window", json!(2.5)),
            ("tolerance", json!(-1)),
            ("monotone", json!(true)),
            ("colour", json!("red")),
        ] {
            let mut changed = scene();
            let refused = set(&mut changed, id, &value).expect_err(id);
            assert_eq!(refused.path, id);
            assert_eq!(changed, scene());
        }
    }
}
