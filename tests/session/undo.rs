//! Undo: every sequence of operations on a session is reversed exactly.

use crate::session::asked::new;
use crate::support::grid::grid;
use proptest::prelude::*;
use serde_json::{Map, json};
use shape_up::constraint::Form;
use shape_up::mesh::{KEPT_TURN, Mesh, Scheme, write_obj};
use shape_up::scene::BuildSettings;
use shape_up::scene::{Goal, GoalOf, Lesson, MeshSource, Scene, Up, Weights};
use shape_up::session::{Edit, SETTINGS, Session};
use shape_up::solve::Require;

const SIDE: u32 = 4;
pub(crate) const VERTICES: u32 = (SIDE + 1) * (SIDE + 1);

/// A bumpy grid with coordinates as far from the origin as those of a building site.
fn site() -> Mesh {
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
    Lesson { text: "Make it flat.".to_owned(), goals: vec![goal], lock: Vec::new() }
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
            build: Box::new(BuildSettings { scale: scale.round(), ..BuildSettings::default() }),
        }),
        Just(Edit::Reset),
    ]
}

fn deed() -> impl Strategy<Value = Deed> {
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
            session.drag([(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, count);
            end(session, keep);
        }
        Deed::DragNew { vertex, by, steps: count, keep } => {
            let at = session.positions()[vertex as usize];
            session.begin_drag_of_new(vec![vertex]).expect("the vertex is there");
            session.drag([(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, count);
            end(session, keep);
        }
        Deed::CutDrag { vertex, by, edit } => {
            let at = session.positions()[vertex as usize];
            session.begin_drag_of_new(vec![vertex]).expect("the vertex is there");
            session.drag([(vertex, moved(at, by))]).expect("the targets are near");
            steps(session, 2);
            drop(session.edit(*edit));
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

/// Opens a saved session again, as the page does after a reload.
pub(crate) fn reopened(text: &str, iteration: u32, history: &[u8], progress: &[u8]) -> Session {
    let scene = Scene::from_json(text).expect("what was written can be read");
    let mut session = Session::open(scene, site()).expect("it can be opened");
    session.restore_iteration(iteration);
    session.restore(history, progress).expect("it was saved a moment ago");
    session
}

pub(crate) fn written(session: &Session) -> String {
    session.scene().to_json(session.mesh())
}

/// The scene as text, the bits of the positions, the iteration.
type State = (String, Vec<[u64; 3]>, u32);

/// All states back to the start and forward to the end, each with the name of its step.
fn all_states(session: &mut Session) -> Vec<(String, State)> {
    let mut states = Vec::new();
    while let Some(name) = session.undo().expect("the state was solvable") {
        states.push((name, everything(session)));
    }
    while let Some(name) = session.redo().expect("the state was solvable") {
        states.push((name, everything(session)));
    }
    states
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(48))]

    // The history was lost with every reload and with every replacement of the worker.
    #[test]
    fn a_session_that_is_opened_again_can_undo_and_redo_all_that_it_could(
        deeds in proptest::collection::vec(deed(), 1..24),
    ) {
        let mut session = open();
        deeds.into_iter().for_each(|deed| act(&mut session, deed));
        let (text, history) = (written(&session), session.saved_history());
        let mut again = reopened(&text, session.iteration(), &history, &[]);
        prop_assert_eq!(again.undo_and_redo(), session.undo_and_redo());
        prop_assert_eq!(again.saved_history(), history);
        prop_assert_eq!(all_states(&mut again), all_states(&mut session));
    }
}

#[test]
fn a_run_and_a_drag_that_were_cut_off_are_steps_of_undo() {
    let target = [482_114.0, -65_220.0, 433.0];
    let begin_new = |session: &mut Session| {
        session.begin_drag_of_new(vec![7]).expect("it is there");
        session.drag([(7, target)]).expect("it is near");
    };
    let begin_drag = |session: &mut Session| {
        session.begin_drag();
        session.drag([(6, target)]).expect("it is near");
    };
    type Begin<'a> = (&'a dyn Fn(&mut Session), &'a str);
    let begin: [Begin<'_>; 3] = [
        (&Session::begin_run, "Run, 3 iterations"),
        (&begin_drag, "Move handle"),
        (&begin_new, "Make and move handle"),
    ];
    for (begin, name) in begin {
        let mut session = open();
        session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
        session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is there");
        act(&mut session, Deed::Run(2));
        let (text, history) = (written(&session), session.saved_history());
        let before = everything(&session);
        begin(&mut session);
        for _ in 0..3 {
            session.step().expect("positions stay finite");
        }
        let mut again = reopened(&text, before.2, &history, &session.saved_progress());
        assert_eq!(everything(&again), everything(&session));
        assert_eq!(again.undo_and_redo(), [Some(name), None]);
        act(&mut again, Deed::Undo);
        assert_eq!(everything(&again), before);
    }
}

#[test]
fn what_is_written_while_something_is_under_way_leads_back_to_where_it_began() {
    // The steps fitted the scene before, and the text was that of the scene as it was: after a reload
    // Undo led to the shape of half a run, without its constraint.
    let target = [482_114.0, -65_220.0, 433.0];
    let begin_new = |session: &mut Session| {
        session.begin_drag_of_new(vec![7]).expect("it is there");
        session.drag([(7, target)]).expect("it is near");
    };
    let begin_drag = |session: &mut Session| {
        session.begin_drag();
        session.drag([(6, target)]).expect("it is near");
    };
    let begin_press = |session: &mut Session| {
        session.edit_and_run(new("circle", "\"faces\"")).expect("faces can be circles");
    };
    type Begin<'a> = (&'a dyn Fn(&mut Session), &'a str);
    let begin: [Begin<'_>; 4] = [
        (&Session::begin_run, "Run, 3 iterations"),
        (&begin_drag, "Move handle"),
        (&begin_new, "Make and move handle"),
        (&begin_press, "Add circle"),
    ];
    for (begin, name) in begin {
        let mut session = open();
        session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
        session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is there");
        act(&mut session, Deed::Run(2));
        let before = everything(&session);
        begin(&mut session);
        for _ in 0..3 {
            session.step().expect("positions stay finite");
        }
        let (text, iteration) = (written(&session), session.iteration());
        let (history, now) = (session.saved_history(), everything(&session));
        let mut again = reopened(&text, iteration, &history, &[]);
        assert_eq!(again.undo_and_redo(), [Some(name), None]);
        act(&mut again, Deed::Undo);
        assert_eq!(everything(&again), before, "{name}");
        act(&mut again, Deed::Redo);
        assert_eq!(everything(&again), now, "{name}");
        // It went on after that.
        session.step().expect("positions stay finite");
        let mut later = reopened(&text, iteration, &history, &session.saved_progress());
        assert_eq!(everything(&later), everything(&session), "{name}");
        act(&mut later, Deed::Undo);
        assert_eq!(everything(&later), now, "{name}");
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
fn saved_steps_that_are_damaged_are_refused_and_leave_the_scene_as_it_was() {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    act(&mut session, Deed::Run(2));
    let (text, history) = (written(&session), session.saved_history());
    let open_again = || {
        let scene = Scene::from_json(&text).expect("what was written can be read");
        Session::open(scene, site()).expect("it can be opened")
    };
    let mut again = open_again();
    for end in 1..history.len() {
        again.restore(&history[..end], &[]).expect_err("it is cut off");
        again.restore(&[], &history[..end]).expect_err("it is something else");
    }
    let error = again.restore(b"anything", &[]).expect_err("it is something else").to_string();
    assert!(error.starts_with("saved steps: damaged 8 bytes before their end"), "{error}");
    assert_eq!(again.undo_and_redo(), [None, None]);
    assert_eq!(everything(&again), everything(&open_again()));
    // A scene with fewer vertices.
    let small = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let scene = Scene::new(MeshSource::File("small.obj".to_owned()));
    let mut small = Session::open(scene, small).expect("the scene is valid");
    small.restore(&history, &[]).expect_err("it is of another mesh");
}

#[test]
fn of_a_long_history_of_a_large_mesh_the_newest_steps_are_saved() {
    let mesh = grid(99, 99, |i, j| [f64::from(i), f64::from(j), f64::from((i + j) % 3)]);
    let mut scene = Scene::new(MeshSource::File("large.obj".to_owned()));
    scene.weights = Weights { shape: 1.0, close: 0.1, smooth: 0.1 };
    let mut session = Session::open(scene, mesh).expect("the scene is valid");
    // Each step moves every vertex: 240 kB.
    for _ in 0..45 {
        act(&mut session, Deed::Run(1));
        act(&mut session, Deed::Edit(Box::new(Edit::Reset)));
    }
    let history = session.saved_history();
    assert!((19_000_000..=20_000_000).contains(&history.len()), "{}", history.len());
    let text = written(&session);
    let scene = Scene::from_json(&text).expect("what was written can be read");
    let mut again = Session::open(scene, session.mesh().clone()).expect("it can be opened");
    again.restore_iteration(session.iteration());
    again.restore(&history, &[]).expect("it was saved a moment ago");
    for _ in 0..9 {
        act(&mut again, Deed::Undo);
        act(&mut session, Deed::Undo);
    }
    assert_eq!(everything(&again), everything(&session));
}

#[test]
fn the_surface_that_panels_are_close_to_is_saved_once() {
    // It was written for every step: ten edits after new panels on a scan were all that was kept.
    let mut session = open();
    let before = session.saved_history().len();
    let target = grid(40, 40, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let text = write_obj(&target, &target.positions);
    let fit = Edit::FitTo { name: "scan.obj".to_owned(), text: text.clone() };
    session.edit(fit).expect("it has faces");
    let begun = session.saved_history().len();
    for scale in 1..20 {
        let build = BuildSettings { scale: f64::from(scale), ..BuildSettings::default() };
        session.edit(Edit::SetBuild { build: Box::new(build) }).expect("it is valid");
    }
    let after = session.saved_history().len();
    assert!(begun > before && after < begun + text.len(), "{before} {begun} {after}");
    let (scene, history) = (written(&session), session.saved_history());
    let mut again = reopened(&scene, session.iteration(), &history, &[]);
    assert_eq!(all_states(&mut again), all_states(&mut session));
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
