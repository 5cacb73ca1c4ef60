//! The effect of each edit on a draft.

use super::closeness_weights::{set_closeness_weight, strengthen_closeness};
use super::constraint_target::ConstraintTarget;
use super::edit_list::{Edit, NewConstraint, PanelStart};
use super::locks::check_changes;
use super::settings;
use super::shapes::{
    back_to_rest, go_to_variant, keep_variant, remove_variant, renumber_variants, reset, set_steps,
    show_step,
};
use crate::constraint::{Kind, KindError, Set};
use crate::mesh::{Read, read};
use crate::scene::{
    BoundaryRequire, ChosenAttempt, ClosenessTo, ConstraintSpec, HANDLE_WEIGHT, Hold, PRESETS,
    Pose, RowNumber, Scene, SceneError, Target, UnitsAndUp, Variants, check_tolerance,
};
use crate::session::report::{check_lesson, check_presentation, panel_row};
use crate::session::state::{Draft, asks_otherwise, uses};
use crate::solve::{Handle, HandleIndex, Require};
use crate::words;
use serde_json::{Map, Value};
use std::rc::Rc;

/// The tolerance of a scene whose panels are judged within `length`: none if the constraint on them
/// has it.
fn explicit_tolerance(document: &Scene, length: f64) -> Option<f64> {
    let row = panel_row(document).map(|row| document.constraints[row].require);
    (row != Some(Require::Within(length))).then_some(length)
}

/// Applies an edit to a draft, and returns the name of the edit.
///
/// # Errors
/// If it refers to a row, a vertex or a value that does not exist, or changes what the lesson locks;
/// the draft may then contain a part of the edit.
pub(crate) fn apply(edit: Edit, draft: &mut Draft<'_>) -> Result<String, SceneError> {
    let handles = Rc::clone(&draft.handles);
    // A press leaves the search before it, and chooses the settings of the next one.
    let is_press = matches!(edit, Edit::MakePanels { .. });
    let name = match edit {
        Edit::AddConstraint(new) => add(new, draft),
        Edit::MakePanels { kind, within, from } => {
            if from != PanelStart::Now {
                reset(draft);
            }
            let require = within.map_or(Require::Soft, Require::Within);
            let document = &mut draft.document;
            let info = document.request_panels(&kind, require, draft.rest.mesh())?;
            let by =
                |smoother, on_surface| ChosenAttempt { smoother, on_surface, ..Default::default() };
            match from {
                PanelStart::Smoother => document.choose_attempt(by(PanelStart::SMOOTHER, false)),
                PanelStart::Surface => document.choose_attempt(by(1.0, true)),
                PanelStart::Boundary => document.hold_boundary(BoundaryRequire::Exact),
                PanelStart::Now | PanelStart::Original => {}
            }
            if let Some(length) = within {
                document.tolerance = explicit_tolerance(document, length);
            }
            format!("Make panels {}", info.panels.unwrap_or(info.id))
        }
        Edit::RemoveConstraint { index } => {
            let label = label_of(row(draft, index)?);
            draft.document.constraints.remove(index);
            format!("Remove {label}")
        }
        Edit::SetConstraint { index, weight, enabled, require, params } => {
            let spec = row(draft, index)?;
            let label = label_of(spec);
            let name = match (enabled, weight, require, params.is_empty()) {
                (Some(true), None, None, true) => format!("Switch on {label}"),
                (Some(false), None, None, true) => format!("Switch off {label}"),
                (None, None, Some(Require::Soft), true) => format!("Make {label} soft"),
                (None, None, Some(Require::Exact), true) => format!("Make {label} exact"),
                (None, None, Some(Require::Within(_)), true) => {
                    format!("Set a tolerance for {label}")
                }
                _ => format!("Change {label}"),
            };
            let was_exact = spec.require == Require::Exact;
            spec.kind = with_params(&spec.kind, index, params)?;
            spec.weight = weight.unwrap_or(spec.weight);
            spec.enabled = enabled.unwrap_or(spec.enabled);
            if let Some(require) = require {
                spec.require = require;
                // A new requirement applies to all elements.
                spec.eased = None;
            }
            // By which panels are judged: no other row has to do with it.
            let is_on_panels = panel_row(&draft.document) == Some(index);
            if matches!(require, Some(Require::Within(_))) && was_exact && is_on_panels {
                draft.document.tolerance = None;
            }
            name
        }
        Edit::DuplicateConstraint { index } => {
            let number = RowNumber::default();
            let copy = ConstraintSpec { number, ..row(draft, index)?.clone() };
            let name = format!("Duplicate {}", label_of(&copy));
            draft.document.constraints.insert(index + 1, copy);
            name
        }
        Edit::RenameConstraint { index, name } => {
            let spec = row(draft, index)?;
            spec.name = name;
            format!("Rename {}", label_of(spec))
        }
        Edit::NameSet { name, vertices, faces } => {
            let set = Set { vertices: vertices.into(), faces: faces.into() };
            if name.is_empty() || set == Set::default() {
                let message = "expected a name and at least one vertex or face".to_owned();
                return Err(SceneError { path: "sets".to_owned(), message });
            }
            if !draft.document.sets.contains_key(&name) {
                check_name_of_group(&name, draft)?;
            }
            let words = format!("Save set {name}");
            draft.document.sets.insert(name, set);
            draft.document.check_sets(draft.rest.mesh())?;
            words
        }
        Edit::RemoveSet { name } => {
            if uses(&name, &draft.document).contains(&true) {
                check_name_of_group(&name, draft)?;
            }
            draft.document.sets.remove(&name);
            format!("Remove set {name}")
        }
        Edit::Set { id, value } => {
            let label = settings::set(&mut draft.document, &id, &value)?;
            format!("Change setting: {label}")
        }
        Edit::HoldClose { vertices, weight } => {
            let weights = &mut draft.document.closeness.weights;
            match &vertices {
                Some(vertices) => set_closeness_weight(weights, vertices, weight),
                None => weights.clear(),
            }
            vertices.map_or("Same closeness for all".to_owned(), |vertices| {
                format!("Change closeness of {}", of_vertices(vertices.len()))
            })
        }
        Edit::FitTo { name, text } => {
            let read = read_second(&name, &text, &draft.document)?;
            let target = draft.document.closeness.target_mesh();
            // The curves that it is held on are those of the original, which new panels have beside its
            // surface; one that is held beside another surface is so by the user's choice.
            if target.is_none() || draft.rest.original(target).is_some() {
                draft.document.closeness.boundary.require = BoundaryRequire::Off;
            }
            let document = &mut draft.document;
            document.closeness.to = ClosenessTo::Target;
            document.closeness.target = Some(Target::Mesh(read.mesh.into()));
            // Without a weight nothing would be drawn to it.
            if document.weights.close == 0.0 {
                document.weights.close = 1.0;
            }
            format!("Fit to {name}")
        }
        Edit::TakePose { name, text } => {
            let read = read_second(&name, &text, &draft.document)?;
            draft.document.pose = Some(Pose::of(&name, read, draft.rest.mesh())?);
            format!("Take the pose of {name}")
        }
        Edit::LeavePose => {
            draft.document.pose = None;
            "Leave the other pose".to_owned()
        }
        Edit::HoldCloser => {
            strengthen_closeness(&mut draft.document);
            "Hold near original positions".to_owned()
        }
        Edit::WeighHandles { vertices, weight } => {
            if !(weight.is_finite() && weight > 0.0) {
                let message = format!("found {weight}, expected a number above 0");
                return Err(SceneError { path: "handles.weight".to_owned(), message });
            }
            let mut handles = draft.handles.to_vec();
            let places = HandleIndex::new(draft.positions.len(), &handles);
            for place in vertices.iter().filter_map(|&vertex| places.get(vertex)) {
                handles[place].hold = Hold::Soft { weight };
            }
            draft.handles = handles.into();
            format!("Weight of {}", words::count(vertices.len(), "handle", "handles"))
        }
        Edit::SetWeights(weights) => {
            weights.put_into(&mut draft.document);
            "Change weights".to_owned()
        }
        Edit::Preset { id } => {
            let preset = PRESETS.iter().find(|preset| preset.id == id).ok_or_else(|| {
                let message = format!("there is no preset `{id}`");
                SceneError { path: "id".to_owned(), message }
            })?;
            preset.set(&mut draft.document);
            format!("Use {}", preset.label)
        }
        Edit::SetUnits { units } => {
            draft.document.units = units;
            "Change unit".to_owned()
        }
        Edit::SetUp { up } => {
            draft.document.up = up;
            "Change up axis".to_owned()
        }
        Edit::SetLesson { mut lesson, unsolved } => {
            // One that is handed out is on the mesh that there is.
            let before = draft.document.lesson.as_ref().filter(|_| !unsolved);
            if let (Some(lesson), Some(before)) = (&mut lesson, before)
                && lesson.asks_the_same(before)
            {
                lesson.given.clone_from(&before.given);
            }
            draft.document.lesson = lesson;
            if unsolved {
                draft.document.as_asked();
                back_to_rest(Variants::default(), draft);
                renumber_variants(draft, |_| None);
            }
            "Change lesson".to_owned()
        }
        Edit::SetTolerance { tolerance } => {
            check_tolerance(tolerance)?;
            draft.document.tolerance = tolerance;
            "Change tolerance".to_owned()
        }
        Edit::SetBuild { values } => {
            let own = draft.document.build.clone().unwrap_or_default();
            draft.document.build = Some(Box::new(own.with_all(values)?));
            draft.document.check_build(draft.rest.mesh())?;
            "Change build settings".to_owned()
        }
        Edit::SetSteps { steps } => set_steps(steps, draft)?,
        Edit::ShowStep { index } => show_step(index, draft)?,
        Edit::KeepVariant { start } => keep_variant(start, draft)?,
        Edit::GoToVariant { index } => go_to_variant(index, draft)?,
        Edit::RemoveVariant { index } => {
            let words = remove_variant(index, draft)?;
            renumber_variants(draft, |variant| {
                (variant != index).then(|| variant - usize::from(variant > index))
            });
            words
        }
        Edit::AddHandles { vertices, fixed } => {
            let hold = if fixed { Hold::Fixed } else { Hold::Soft { weight: HANDLE_WEIGHT } };
            draft.handles = with_handles(&vertices, hold, draft)?.into();
            match fixed {
                true => format!("Fix {}", of_vertices(vertices.len())),
                false => format!("Make {}", words::count(vertices.len(), "handle", "handles")),
            }
        }
        Edit::RemoveHandles { vertices } => {
            let mut released = vec![false; draft.positions.len()];
            let known = vertices.iter().filter(|vertex| (**vertex as usize) < released.len());
            let known: Vec<usize> = known.map(|&vertex| vertex as usize).collect();
            known.into_iter().for_each(|vertex| released[vertex] = true);
            let mut handles = draft.handles.to_vec();
            let before = handles.len();
            handles.retain(|handle| !released[handle.vertex as usize]);
            let removed = before - handles.len();
            draft.handles = handles.into();
            format!("Remove {}", words::count(removed, "handle", "handles"))
        }
        Edit::Refine { .. } | Edit::Remesh(_) => {
            unreachable!("no draft makes another mesh")
        }
        Edit::Reset => {
            reset(draft);
            "Reset".to_owned()
        }
    };
    if !is_press {
        let Draft { before, document, .. } = draft;
        document.keep_user_changes(before);
        let is_elsewhere = document.attempt.from != before.attempt.from;
        if is_elsewhere || asks_otherwise(before, document) {
            let mut rows = document.constraints.iter();
            match rows.any(|row| row.enabled && row.require.is_hard()) {
                true => document.leave_search(),
                false => document.as_asked(),
            }
        }
    }
    check_changes(draft, &handles)?;
    // Renaming or removing a row can break these too; the saved scene could not be opened.
    check_lesson(&draft.document, draft.rest.mesh())?;
    check_presentation(&draft.document, draft.rest.mesh())?;
    Ok(name)
}

/// Refuses that a name stands for the group of the mesh no longer, or from now on: what is on it would
/// be on other elements.
fn check_name_of_group(name: &str, draft: &Draft<'_>) -> Result<(), SceneError> {
    if !draft.rest.mesh().has_group(name) {
        return Ok(());
    }
    let message =
        format!("found {name:?}, the name of a group of the mesh, expected one that no group has");
    Err(SceneError { path: "sets".to_owned(), message })
}

/// Reads the text of a second mesh file, which has the coordinates of the model.
fn read_second(name: &str, text: &str, document: &Scene) -> Result<Read, SceneError> {
    // What the file of the model states is known no longer; the user sees, and can set, what it has.
    let own = UnitsAndUp { units: None, up: Some(document.up) };
    UnitsAndUp::stated(text.as_bytes()).check_second(name, &own, document)?;
    read(name, text.as_bytes())
        .map_err(|error| SceneError { path: String::new(), message: error.to_string() })
}

/// Appends a row, and adds its set under a new name.
fn add(new: NewConstraint, draft: &mut Draft<'_>) -> String {
    let NewConstraint { mut spec, set } = new;
    // The same edit may be made again.
    spec.number = RowNumber::default();
    let name = format!("Add {}", label_of(&spec));
    let target = ConstraintTarget { on: spec.on, set };
    let (on, named) = target.named_in(&draft.document.sets, draft.rest.mesh());
    spec.on = on;
    draft.document.sets.extend(named);
    draft.document.constraints.push(spec);
    name
}

/// Returns the handles with `vertices` added at their current positions; if a vertex is a handle
/// already, only its hold changes.
fn with_handles(
    vertices: &[u32],
    hold: Hold,
    draft: &Draft<'_>,
) -> Result<Vec<Handle>, SceneError> {
    let (mut handles, positions) = (draft.handles.to_vec(), &draft.positions);
    let mut places = HandleIndex::new(positions.len(), &handles);
    for &vertex in vertices {
        let Some(&target) = positions.get(vertex as usize) else {
            let message =
                format!("vertex {vertex} is out of range: the mesh has {}", positions.len());
            return Err(SceneError { path: "handles".to_owned(), message });
        };
        match places.get(vertex) {
            Some(place) => handles[place].hold = hold,
            None => {
                places.insert(vertex, handles.len());
                handles.push(Handle { vertex, target, hold });
            }
        }
    }
    Ok(handles)
}

fn row<'a>(draft: &'a mut Draft<'_>, index: usize) -> Result<&'a mut ConstraintSpec, SceneError> {
    let rows = &mut draft.document.constraints;
    let count = rows.len();
    rows.get_mut(index).ok_or_else(|| SceneError {
        path: format!("constraints[{index}]"),
        message: format!("there is no such row: the scene has {count}"),
    })
}

/// The label of a row's kind, for use within a sentence.
fn label_of(row: &ConstraintSpec) -> String {
    row.kind.info().label.to_ascii_lowercase()
}

/// Returns the kind of row `index` with some parameters changed.
fn with_params(kind: &Kind, index: usize, changed: Map<String, Value>) -> Result<Kind, SceneError> {
    if changed.is_empty() {
        return Ok(kind.clone());
    }
    let mut params = kind.params();
    if let Some(params) = params.as_object_mut() {
        params.extend(changed);
    }
    Kind::new(kind.info().id, params).map_err(|error| match error {
        KindError::Params { path, message } => {
            let below = if path.is_empty() { String::new() } else { format!(".{path}") };
            SceneError { path: format!("constraints[{index}]{below}"), message }
        }
        KindError::Unknown => unreachable!("the row has this kind"),
    })
}

fn of_vertices(count: usize) -> String {
    words::count(count, "vertex", "vertices")
}
