//! Undo: every sequence of operations on a session is reversed exactly.

use crate::session::asked::new;
use crate::support::drag;
use crate::support::grid::grid;
use proptest::prelude::*;
use serde_json::{Map, json};
use shape_up::constraint::Form;
use shape_up::mesh::{KEPT_TURN, Mesh, Scheme};
use shape_up::scene::{Goal, GoalOf, Lesson, MeshSource, Scene, Up, Weights};
use shape_up::session::{DragPhase, Edit, SETTINGS, Session};
use shape_up::solve::Require;

const SIDE: u32 = 4;
pub(crate) const VERTICES: u32 = (SIDE + 1) * (SIDE + 1);

/// A bumpy grid with coordinates as far from the origin as those of a building site.
pub(crate) fn site() -> Mesh {
    grid(SIDE, SIDE, |i, j| {
        let bump = f64::from((i * 5 + j * 7) % 4) / 7.0;
        [f64::from(i) / 3.0 + 482_113.7, f64::from(j) / 3.0 - 65_220.1, bump + 431.9]
    })
}

/// An action of a user, drawn by a strategy.
#[derive(Clone, Debug)]
pub(crate) enum Deed {
    Edit(Box<Edit>),
    Drag {
        vertex: u32,
        by: [f64; 3],
        steps: usize,
        keep: bool,
    },
    DragNew {
        vertex: u32,
        by: [f64; 3],
        steps: usize,
        keep: bool,
    },
    /// A drag that an edit ends.
    CutDrag {
        vertex: u32,
        by: [f64; 3],
        edit: Box<Edit>,
    },
    Run(usize),
    Undo,
    Redo,
}

fn lesson() -> Lesson {
    let goal = Goal { of: GoalOf::Constraint("Plane".to_owned()), at_most: 0.1 };
    Lesson { text: "Make it flat.".to_owned(), goals: vec![goal], lock: Vec::new(), given: None }
}

/// One of the declared settings, with one of its values.
fn setting() -> impl Strategy<Value = Edit> {
    (0..SETTINGS.len(), 0..3usize, 0.0..1.0).prop_map(|(index, form, part)| {
        let param = SETTINGS[index].param;
        let [least, greatest] = param.range;
        let value = match param.forms[form % param.forms.len()] {
            Form::Word(word) => json!(word),
            // A run does not end at tolerance 0; windows are integers.
            _ => json!(f64::ceil(least + part * (greatest - least))),
        };
        Edit::Set { id: param.id.to_owned(), value }
    })
}

fn an_edit() -> impl Strategy<Value = Edit> {
    let vertices = || proptest::collection::vec(0..VERTICES, 1..4);
    prop_oneof![
        prop_oneof![
            Just(new("plane", "\"faces\"")),
            Just(new("circle", "\"faces\"")),
            Just(new("line-segment", "\"edges\"")),
            Just(new("sphere", r#"{ "vertices": [0, 1, 5, 6, 7] }"#)),
        ],
        (0..3usize).prop_map(|index| Edit::RemoveConstraint { index }),
        (0..3usize, 0.1..9.0).prop_map(|(index, weight)| Edit::SetConstraint {
            index,
            weight: Some(weight),
            require: None,
            enabled: None,
            params: Map::new(),
        }),
        (0..3usize, any::<bool>()).prop_map(|(index, on)| Edit::SetConstraint {
            index,
            weight: None,
            require: None,
            enabled: Some(on),
            params: Map::new(),
        }),
        (
            0..3usize,
            prop::sample::select(vec![Require::Soft, Require::Exact, Require::Within(0.1)])
        )
            .prop_map(|(index, require)| Edit::SetConstraint {
                index,
                weight: None,
                require: Some(require),
                enabled: None,
                params: Map::new(),
            }),
        (0..3usize, 0.2..2.0).prop_map(|(index, length)| {
            let params = json!({ "length": length }).as_object().cloned();
            let params = params.expect("it is an object");
            Edit::SetConstraint { index, weight: None, require: None, enabled: None, params }
        }),
        (0.1..9.0, 0.1..9.0, 0.0..9.0).prop_map(|(shape, close, smooth)| Edit::SetWeights(
            Weights { shape, close, smooth }.into()
        )),
        (proptest::collection::vec(0..VERTICES + 2, 0..4), 0.0..9.0)
            .prop_map(|(vertices, weight)| Edit::WeighHandles { vertices, weight }),
        (proptest::option::of(vertices()), 0.0..9.0)
            .prop_map(|(vertices, weight)| Edit::HoldClose { vertices, weight }),
        "[a-c]".prop_map(|name| Edit::RemoveSet { name }),
        ("[a-c]", vertices()).prop_map(|(name, vertices)| Edit::NameSet {
            name,
            vertices,
            faces: Vec::new(),
        }),
        (0..3usize).prop_map(|index| Edit::DuplicateConstraint { index }),
        setting(),
        "(m|mm|ft)".prop_map(|units| Edit::SetUnits { units }),
        any::<bool>().prop_map(|y| Edit::SetUp { up: if y { Up::Y } else { Up::Z } }),
        (vertices(), any::<bool>())
            .prop_map(|(vertices, fixed)| Edit::AddHandles { vertices, fixed }),
        vertices().prop_map(|vertices| Edit::RemoveHandles { vertices }),
        (0..3usize, "[a-c]{0,2}").prop_map(|(index, name)| Edit::RenameConstraint { index, name }),
        any::<bool>()
            .prop_map(|is_one| Edit::SetLesson { lesson: is_one.then(lesson), unsolved: false }),
        (1.0..3.0f64).prop_map(|scale| Edit::SetBuild {
            values: Map::from_iter([("scale".to_owned(), scale.round().into())]),
        }),
        proptest::option::of(0.1..9.0).prop_map(|tolerance| Edit::SetTolerance { tolerance }),
        Just(Edit::Reset),
    ]
}

pub(crate) fn deed() -> impl Strategy<Value = Deed> {
    // A handle may be taken and released where it is.
    let by = || prop_oneof![5 => prop::array::uniform3(-1.0..1.0), 1 => Just([0.0; 3])];
    prop_oneof![
        6 => an_edit().prop_map(|edit| Deed::Edit(Box::new(edit))),
        2 => (0..VERTICES, by(), 0..4usize, any::<bool>())
            .prop_map(|(vertex, by, steps, keep)| Deed::Drag { vertex, by, steps, keep }),
        1 => (0..VERTICES, by(), 0..4usize, any::<bool>())
            .prop_map(|(vertex, by, steps, keep)| Deed::DragNew { vertex, by, steps, keep }),
        1 => (0..VERTICES, by(), an_edit())
            .prop_map(|(vertex, by, edit)| Deed::CutDrag { vertex, by, edit: Box::new(edit) }),
        2 => (1..6usize).prop_map(Deed::Run),
        1 => Just(Deed::Undo),
        1 => Just(Deed::Redo),
    ]
}

/// One of these actions, or a refinement of the mesh.
fn deed_or_refine() -> impl Strategy<Value = Deed> {
    let schemes = prop::sample::select(vec![Scheme::CatmullClark, Scheme::Linear, Scheme::Loop]);
    let refine = schemes.prop_map(|scheme| Edit::Refine {
        scheme,
        levels: 1,
        keep: KEPT_TURN,
        adopt: false,
    });
    prop_oneof![12 => deed(), 1 => refine.prop_map(|edit| Deed::Edit(Box::new(edit)))]
}

/// Performs the action; an edit that makes no sense is refused and is not a step.
pub(crate) fn act(session: &mut Session, deed: Deed) {
    let steps = |session: &mut Session, count| {
        for _ in 0..count {
            session.step().expect("positions stay finite");
        }
    };
    let moved = |at: [f64; 3], by: [f64; 3]| std::array::from_fn(|axis| at[axis] + by[axis]);
    // With hard constraints a run follows, which meets them again.
    let end = |session: &mut Session, keep| {
        session.end_drag(keep);
        if session.is_running() {
            steps(session, 4);
            session.end_run();
        }
    };
    match deed {
        Deed::Edit(edit) => drop(session.edit(*edit)),
        Deed::Drag { vertex, by, steps: count, keep } => {
            let handles = session.solver().handles();
            let Some(handle) = handles.get(vertex as usize % handles.len().max(1)) else { return };
            let (vertex, at) = (handle.vertex, handle.target);
            session.begin_drag();
            drag(session, [(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, count);
            end(session, keep);
        }
        Deed::DragNew { vertex, by, steps: count, keep } => {
            let at = session.positions()[vertex as usize];
            session.drag_through(DragPhase::Make, &[vertex], &[]).expect("the vertex is there");
            drag(session, [(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, count);
            end(session, keep);
        }
        Deed::CutDrag { vertex, by, edit } => {
            let at = session.positions()[vertex as usize];
            session.drag_through(DragPhase::Make, &[vertex], &[]).expect("the vertex is there");
            drag(session, [(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, 2);
            // What is refused or changes nothing leaves the drag.
            if !session.edit(*edit).unwrap_or_default() {
                end(session, true);
            }
        }
        Deed::Run(count) => {
            session.begin_run();
            steps(session, count);
            session.end_run();
        }
        Deed::Undo => drop(session.undo().expect("the state was solvable")),
        Deed::Redo => drop(session.redo().expect("the state was solvable")),
    }
}

/// The whole state: document with handles, positions to the last bit, and iteration count.
pub(crate) fn everything(session: &Session) -> (String, Vec<[u64; 3]>, u32) {
    let scene = session.scene();
    let bits = session.positions().iter().map(|point| point.map(f64::to_bits)).collect();
    (scene.to_json(session.mesh()), bits, session.iteration())
}

pub(crate) fn open() -> Session {
    let mut scene = Scene::new(MeshSource::File("site.obj".to_owned()));
    scene.weights = Weights { shape: 1.0, close: 0.1, smooth: 0.1 };
    let mut session = Session::open(scene, site()).expect("the scene is valid");
    session.start_trace();
    session
}

#[test]
fn an_edit_that_changes_nothing_is_no_step() {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: true }).expect("it is there");
    let before = everything(&session);
    let same = |weight| Edit::SetConstraint {
        index: 0,
        weight,
        require: None,
        enabled: Some(true),
        params: Map::new(),
    };
    let document = session.document().clone();
    let nothing = [
        Edit::Reset,
        same(Some(1.0)),
        same(None),
        Edit::SetWeights(document.weights.into()),
        Edit::SetUnits { units: document.units },
        Edit::SetUp { up: document.up },
        Edit::SetLesson { lesson: None, unsolved: false },
        Edit::RenameConstraint { index: 0, name: String::new() },
        Edit::RemoveSet { name: "eaves".to_owned() },
        Edit::Set { id: "tolerance".to_owned(), value: json!(1e-9) },
        Edit::HoldClose { vertices: None, weight: 1.0 },
        Edit::AddHandles { vertices: vec![6], fixed: true },
        Edit::AddHandles { vertices: vec![], fixed: true },
        Edit::WeighHandles { vertices: vec![3], weight: 7.0 },
        Edit::RemoveHandles { vertices: vec![3, 7] },
    ];
    // The undone step can still be redone.
    act(&mut session, Deed::Run(2));
    act(&mut session, Deed::Undo);
    let steps = [Some("Fix 1 vertex"), Some("Run, 2 iterations")];
    assert_eq!(session.undo_and_redo(), steps);
    for edit in nothing {
        let words = format!("{edit:?}");
        session.edit(edit).expect("it does no harm");
        assert_eq!(everything(&session), before, "{words}");
        assert_eq!(session.undo_and_redo(), steps, "{words}");
    }
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(96))]

    #[test]
    fn every_sequence_of_deeds_is_taken_back_to_the_start_and_done_again(
        deeds in proptest::collection::vec(deed_or_refine(), 1..24),
    ) {
        let mut session = open();
        let start = everything(&session);
        for deed in deeds {
            act(&mut session, deed);
            prop_assert!(!session.is_running() && !session.is_dragging());
        }
        // Steps that were undone on the way are not part of the final state.
        while session.redo().expect("the state was solvable").is_some() {}
        // The tolerance is no part of a step: all of them get that of the start.
        session.edit(Edit::SetTolerance { tolerance: None }).expect("it is valid");
        let end = everything(&session);
        let again = Session::open(session.scene(), session.mesh().clone()).map(|_| ());
        prop_assert!(again.is_ok(), "what was made can be opened: {again:?}");
        let mut done = Vec::new();
        while let Some(name) = session.undo().expect("the state was solvable") {
            prop_assert!(!name.is_empty());
            done.push(name);
        }
        prop_assert_eq!(everything(&session), start);
        // The table of iterations ends at the iteration of the session.
        prop_assert_eq!(session.convergence_csv().lines().count(), 2);
        let mut again = Vec::new();
        while let Some(name) = session.redo().expect("the state was solvable") {
            again.push(name);
        }
        again.reverse();
        prop_assert_eq!(again, done);
        prop_assert_eq!(everything(&session), end);
    }
}

#[test]
fn nothing_is_repeated_after_a_run_that_is_under_way() {
    // Redo was offered, and did nothing.
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    act(&mut session, Deed::Undo);
    assert_eq!(session.undo_and_redo(), [None, Some("Add plane")]);
    session.begin_run();
    assert_eq!(session.undo_and_redo(), [Some("Run"), None]);
}

#[test]
fn saying_the_unit_and_the_axis_moves_nothing() {
    let mut session = open();
    act(&mut session, Deed::Run(2));
    let before = session.positions();
    session.edit(Edit::SetUnits { units: "ft".to_owned() }).expect("any unit will do");
    session.edit(Edit::SetUp { up: Up::Y }).expect("any axis will do");
    assert_eq!(session.positions(), before);
    assert!(session.obj().starts_with("# units: ft\n# up: y\nv "));
    let flat = vec![[0.0; 2]; session.mesh().positions.len()];
    let mapped = session.obj_with_uv(&flat).expect("each vertex has a place");
    assert!(mapped.starts_with("# units: ft\n# up: y\nv "));
    assert_eq!(session.undo_and_redo()[0], Some("Change up axis"));
}
