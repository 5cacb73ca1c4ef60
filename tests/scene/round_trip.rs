//! Property: a scene that is written reads back the same, bit for bit.

use crate::scene::asked::constraint;
use proptest::prelude::*;
use shape_up::constraint::{Element, KINDS, Selector, Set};
use shape_up::mesh::Mesh;
use shape_up::scene::{
    Accelerator, AttemptStart, BoundaryCloseness, BoundaryRequire, ChosenAttempt, Closeness,
    ClosenessTo, ClosenessWeight, ConstraintSpec, EasedFaces, Factorization, Goal, GoalOf,
    HandleSpec, Hold, Lesson, Lock, MeshSource, NamedEnum, Pose, Require, RowNumber, Scene, Slide,
    Smoothness, SmoothnessOf, SolverSettings, Up, Variant, Variants, Weighting, Weights,
};
use shape_up::scene::{BuildSettings, CheckLimits, Dxf, OffsetKind};

fn require() -> impl Strategy<Value = Require> {
    prop_oneof![Just(Require::Soft), Just(Require::Exact), (1e-9..1e9f64).prop_map(Require::Within)]
}

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("JSON has finite numbers only", |x| x.is_finite()),
        -10.0..10.0f64,
        Just(-0.0),
        Just(1e22),
        Just(5e-324)
    ]
}

fn not_negative() -> impl Strategy<Value = f64> {
    finite().prop_map(f64::abs)
}

fn list(most: usize) -> impl Strategy<Value = Vec<u32>> {
    prop::collection::vec(0u32..40, 1..most)
}

fn selector() -> impl Strategy<Value = Selector> {
    let element = prop::sample::select(Element::ALL.to_vec());
    prop_oneof![
        (element, prop::option::of(".{0,4}"), 0u32..4).prop_map(|(element, within, radius)| {
            let radius = if element == Element::Ring { radius + 1 } else { radius };
            Selector::Each { element, within, radius }
        }),
        ".{0,6}".prop_map(Selector::Set),
        list(9).prop_map(|list| Selector::Vertices(list.into())),
    ]
}

prop_compose! {
    fn handle_spec()(
        vertices in list(6),
        targets in prop::option::of(prop::collection::vec(prop::array::uniform3(finite()), 6)),
        weight in prop::option::of(prop_oneof![Just(100.0), 1e-9..1e9f64]),
    ) -> HandleSpec {
        let n = vertices.len();
        HandleSpec {
            vertices,
            targets: targets.map(|t| t[..n].to_vec()),
            hold: weight.map_or(Hold::Fixed, |weight| Hold::Soft { weight }),
        }
    }
}

prop_compose! {
    fn step()(
        texts in (".{0,6}", "\\PC{0,6}", "\\PC{0,6}"),
        camera in prop::option::of(prop::array::uniform7(finite())),
        switches in prop::array::uniform3(any::<bool>()),
        measure in prop::option::of(".{0,6}"),
        variant in prop::option::of(0..20usize),
        weights in prop::option::of(prop::array::uniform3(not_negative())),
    ) -> Slide {
        Slide {
            title: texts.0,
            text: texts.1,
            notes: texts.2,
            camera,
            parallel: switches[0],
            measure,
            original: switches[1],
            variant,
            weights: weights.map(|[shape, close, smooth]| Weights { shape, close, smooth }),
            run: switches[2],
        }
    }
}

prop_compose! {
    fn scene()(
        texts in ("\\PC{0,8}", ".{0,4}"),
        (up, tolerance) in (any::<bool>(), prop::option::of(1e-9..1e9f64)),
        current in prop::option::of(prop::collection::vec(prop::array::uniform3(finite()), 0..4)),
        sets in prop::collection::btree_map(".{0,6}", (list(9), list(3)), 0..3),
        constraints in prop::collection::vec(
            (0..KINDS.len(), selector(), not_negative(), any::<bool>(), ".{0,4}", require()), 0..4),
        handles in prop::collection::vec(handle_spec(), 0..3),
        weights in prop::array::uniform3(not_negative()),
        held in prop::collection::vec((selector(), not_negative()), 0..3),
        corners in prop::option::of(0.0..=180.0f64),
        choices in (0..3usize, 0..2usize, 0..3usize, 0..3usize),
        attempt in (0..4usize, 1e-3..1e3f64, any::<bool>(), any::<bool>()),
        solver in (any::<u32>(), not_negative(), 0..=50u32, any::<bool>(), any::<bool>(),
            prop::option::of(0.0..=1.0f64)),
        lesson in prop::option::of((".{0,9}",
            prop::collection::vec((any::<bool>(), ".{0,5}", not_negative()), 1..3))),
        build in prop::option::of((0..4usize, 1e-3..1e3f64, ".{0,5}", any::<bool>())),
        kept in prop::collection::vec(
            (".{0,4}", prop::collection::vec(prop::array::uniform3(finite()), 0..4)), 0..3),
        steps in prop::collection::vec(step(), 0..4),
    ) -> Scene {
        Scene {
            steps,
            tolerance,
            variants: Variants {
                design: kept.len().checked_sub(1),
                kept: kept.into_iter()
                    .map(|(name, positions)| Variant { name, positions: positions.into() })
                    .collect(),
            },
            attempt: ChosenAttempt {
                from: [AttemptStart::Soft, AttemptStart::Rest, AttemptStart::Exact, AttemptStart::Eased][attempt.0],
                smoother: attempt.1,
                on_surface: attempt.2,
                holds_boundary: attempt.3,
                hardens_boundary: attempt.2 && attempt.3,
            },
            title: texts.0,
            units: texts.1,
            up: if up { Up::Y } else { Up::Z },
            mesh: MeshSource::File("a/b \"c\".obj".into()),
            pose: match &current {
                Some(positions) if !up && !positions.is_empty() => Some(Pose::Positions(positions.clone().into())),
                current => current.as_ref().map(|_| Pose::File("pose.obj".into())),
            },
            current,
            sets: sets.into_iter().map(|(name, (vertices, faces))| (name, Set { vertices: vertices.into(), faces: faces.into() }))
                .collect(),
            constraints: constraints.into_iter().map(|(kind, on, weight, enabled, name, require)| ConstraintSpec {
                weight, enabled, name, require,
                number: RowNumber::default(),
                eased: match require {
                    Require::Within(within) if enabled => Some(EasedFaces { within, faces: [2, 3, 7].into() }),
                    _ => None,
                },
                ..constraint(KINDS[kind].id, on)
            }).collect(),
            handles,
            weights: Weights { shape: weights[0], close: weights[1], smooth: weights[2] },
            closeness: Closeness {
                to: [ClosenessTo::Surface, ClosenessTo::Rest, ClosenessTo::None][choices.0],
                target: None,
                weights: held.into_iter().map(|(on, weight)| ClosenessWeight { on, weight }).collect(),
                boundary: corners.map_or_else(BoundaryCloseness::default, |corners| BoundaryCloseness {
                    corners,
                    require: [BoundaryRequire::Off, BoundaryRequire::Exact, BoundaryRequire::Soft][choices.0],
                    weight: weights[0],
                }),
            },
            smoothness: Smoothness {
                of: [SmoothnessOf::Surface, SmoothnessOf::Displacement][choices.1],
                weighting: [Weighting::Auto, Weighting::Uniform, Weighting::Cotangent][choices.2],
            },
            solver: SolverSettings {
                iterations: solver.0,
                tolerance: solver.1,
                accelerator: Accelerator::WORDS[choices.3].1,
                window: solver.2,
                mean_centring: solver.3,
                monotone: solver.4,
                factorization: [Factorization::Auto, Factorization::Supernodal, Factorization::SprsLdl][choices.0 % 3],
                shortest_edge: solver.5,
            },
            lesson: lesson.map(|(text, goals)| Lesson {
                text,
                lock: Lock::WORDS.iter().map(|(_, lock)| *lock).take(goals.len()).collect(),
                given: None,
                goals: goals.into_iter().map(|(named, of, at_most)| Goal {
                    of: match named {
                        true => GoalOf::Constraint(of),
                        false if at_most < 1.0 => GoalOf::Measure(of),
                        false => GoalOf::Beyond { measure: of, tolerance: at_most / 2.0 },
                    },
                    at_most,
                }).collect(),
            }),
            build: build.map(|(kind, length, material, flag)| Box::new(BuildSettings {
                kind: OffsetKind::ALL.get(kind).copied(),
                distance: flag.then_some(-length),
                joint: length,
                material,
                sheet: [100.0 * length + 50.0, 60.0],
                mirror: flag,
                seams: (0..kind as u32).map(|k| [k + 1, k]).collect(),
                dxf: if flag { Dxf::R12 } else { Dxf::R2000 },
                limits: CheckLimits { lean: length, ..CheckLimits::default() },
                ..BuildSettings::default()
            })),
        }
    }
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(256))]

    #[test]
    fn what_is_written_reads_back_the_same(scene in scene()) {
        let text = scene.to_json(&Mesh::default());
        let again = Scene::from_json(&text).map_err(|e| TestCaseError::fail(format!("{e}\n{text}")))?;
        prop_assert_eq!(&again, &scene, "{}", text);
        prop_assert_eq!(again.to_json(&Mesh::default()), text);
    }

    #[test]
    fn numbers_keep_their_bits(points in prop::collection::vec(prop::array::uniform3(finite()), 1..9)) {
        let mesh = Mesh { positions: points, ..Mesh::default() };
        let scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
        let MeshSource::Inline(again) = Scene::from_json(&scene.to_json(&mesh)).unwrap().mesh else {
            panic!("the mesh was inline");
        };
        let bits = |mesh: &Mesh| -> Vec<_> { mesh.positions.as_flattened().iter().map(|x| x.to_bits()).collect() };
        prop_assert_eq!(bits(&again), bits(&mesh));
    }

    #[test]
    fn no_text_makes_it_panic(text in ".{0,80}") {
        let _ = Scene::from_json(&text);
        let scene = r#"{"format": "shape-up-scene", "version": 1, "mesh": {"file": "a.obj"}, "#;
        let _ = Scene::from_json(&format!("{scene}{text}}}"));
    }
}
