//! The effect of each edit on a state of the document. A failed edit changes nothing.

use super::closeness_weights::{set_closeness_weight, strengthen_closeness};
use super::edit_list::Edit;
use super::settings;
use crate::constraint::{Kind, KindError, Set};
use crate::mesh::{Point, counted};
use crate::scene::{ConstraintSpec, HANDLE_WEIGHT, Hold, PRESETS, Scene, SceneError};
use crate::session::report::check_lesson;
use crate::session::state::{Session, Snapshot};
use crate::solve::{Handle, HandleIndex};
use serde_json::{Map, Value};

impl Session {
    /// Applies an edit to a state, and gives its name.
    pub(crate) fn apply(&self, edit: Edit, state: &mut Snapshot) -> Result<String, SceneError> {
        let Snapshot { document, handles, positions, iteration, start } = state;
        let name = match edit {
            Edit::AddConstraint(new) => {
                let name = format!("Add {}", new.spec.kind.info().label.to_ascii_lowercase());
                new.add_to(document);
                name
            }
            Edit::MakePanels { kind } => {
                let info = document.ask_of_panels(&kind, &self.mesh)?;
                format!("Make panels {}", info.panels.unwrap_or(info.id))
            }
            Edit::RemoveConstraint { index } => {
                let label = row(document, index)?.kind.info().label.to_ascii_lowercase();
                document.constraints.remove(index);
                format!("Remove {label}")
            }
            Edit::SetConstraint { index, weight, enabled, params } => {
                let spec = row(document, index)?;
                let what = match (enabled, weight, params.is_empty()) {
                    (Some(true), None, true) => "Switch on",
                    (Some(false), None, true) => "Switch off",
                    _ => "Change",
                };
                set_params(spec, index, params)?;
                spec.weight = weight.unwrap_or(spec.weight);
                spec.enabled = enabled.unwrap_or(spec.enabled);
                format!("{what} {}", spec.kind.info().label.to_ascii_lowercase())
            }
            Edit::DuplicateConstraint { index } => {
                let copy = row(document, index)?.clone();
                let label = copy.kind.info().label.to_ascii_lowercase();
                document.constraints.insert(index + 1, copy);
                format!("Duplicate {label}")
            }
            Edit::RenameConstraint { index, name } => {
                let spec = row(document, index)?;
                spec.name = name;
                format!("Rename {}", spec.kind.info().label.to_ascii_lowercase())
            }
            Edit::NameSet { name, set } => {
                if name.is_empty() || set == Set::default() {
                    let message = "expected a name and something that it stands for".to_owned();
                    return Err(SceneError { path: "sets".to_owned(), message });
                }
                let words = format!("Save set {name}");
                document.sets.insert(name, set);
                words
            }
            Edit::RemoveSet { name } => {
                document.sets.remove(&name);
                format!("Remove set {name}")
            }
            Edit::Set { id, value } => {
                format!("Change setting: {}", settings::set(document, &id, &value)?)
            }
            Edit::HoldClose { vertices, weight } => {
                match &vertices {
                    Some(vertices) => {
                        set_closeness_weight(&mut document.closeness, vertices, weight);
                    }
                    None => document.closeness.weights.clear(),
                }
                vertices.map_or("Same closeness for all".to_owned(), |vertices| {
                    format!("Change closeness of {}", of_vertices(vertices.len()))
                })
            }
            Edit::HoldCloser => {
                strengthen_closeness(document);
                // From a shape without extent there is no way back.
                if let Some(start) = start.take() {
                    positions.clone_from(&start.positions);
                    *iteration = start.iteration;
                }
                "Hold closer".to_owned()
            }
            Edit::WeighHandles { vertices, weight } => {
                if !(weight.is_finite() && weight > 0.0) {
                    let message = format!("found {weight}, expected a number above 0");
                    return Err(SceneError { path: "handles.weight".to_owned(), message });
                }
                let places = HandleIndex::new(positions.len(), handles);
                for place in vertices.iter().filter_map(|&vertex| places.get(vertex)) {
                    handles[place].hold = Hold::Soft { weight };
                }
                format!("Weigh {}", counted(vertices.len(), "handle", "handles"))
            }
            Edit::SetWeights(weights) => {
                document.weights = weights;
                "Change weights".to_owned()
            }
            Edit::Preset { id } => {
                let preset = PRESETS.iter().find(|preset| preset.id == id).ok_or_else(|| {
                    let message = format!("there is no preset `{id}`");
                    SceneError { path: "id".to_owned(), message }
                })?;
                preset.set(document);
                format!("Use {}", preset.label)
            }
            Edit::SetUnits { units } => {
                document.units = units;
                "Change unit".to_owned()
            }
            Edit::SetUp { up } => {
                document.up = up;
                "Change up axis".to_owned()
            }
            Edit::SetLesson(lesson) => {
                document.lesson = lesson;
                "Change lesson".to_owned()
            }
            Edit::AddHandles { vertices, fixed } => {
                let hold = if fixed { Hold::Fixed } else { Hold::Soft { weight: HANDLE_WEIGHT } };
                self.hold(&vertices, hold, handles, positions)?;
                match fixed {
                    true => format!("Fix {}", of_vertices(vertices.len())),
                    false => format!("Make {}", counted(vertices.len(), "handle", "handles")),
                }
            }
            Edit::RemoveHandles { vertices } => {
                let mut released = vec![false; positions.len()];
                let known = vertices.iter().filter(|vertex| (**vertex as usize) < positions.len());
                known.for_each(|&vertex| released[vertex as usize] = true);
                handles.retain(|handle| !released[handle.vertex as usize]);
                format!("Release {}", of_vertices(vertices.len()))
            }
            Edit::Reset => {
                positions.clone_from(&self.mesh.positions);
                *iteration = 0;
                *start = None;
                "Reset".to_owned()
            }
        };
        // Also of a row that is renamed or taken away: the scene could not be opened again.
        check_lesson(document, &self.mesh)?;
        Ok(name)
    }

    /// Makes vertices handles where they are; those that are handles already change how they hold.
    fn hold(
        &self,
        vertices: &[u32],
        hold: Hold,
        handles: &mut Vec<Handle>,
        positions: &[Point],
    ) -> Result<(), SceneError> {
        let mut places = HandleIndex::new(positions.len(), handles);
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
        Ok(())
    }
}

fn row(document: &mut Scene, index: usize) -> Result<&mut ConstraintSpec, SceneError> {
    let count = document.constraints.len();
    document.constraints.get_mut(index).ok_or_else(|| SceneError {
        path: format!("constraints[{index}]"),
        message: format!("there is no such row: the scene has {count}"),
    })
}

/// Gives a row other values of some parameters.
fn set_params(
    spec: &mut ConstraintSpec,
    index: usize,
    changed: Map<String, Value>,
) -> Result<(), SceneError> {
    if changed.is_empty() {
        return Ok(());
    }
    let mut params = spec.kind.params();
    if let Some(params) = params.as_object_mut() {
        params.extend(changed);
    }
    spec.kind = Kind::new(spec.kind.info().id, params).map_err(|error| match error {
        KindError::Params { path, message } => {
            let below = if path.is_empty() { String::new() } else { format!(".{path}") };
            SceneError { path: format!("constraints[{index}]{below}"), message }
        }
        KindError::Unknown => unreachable!("the row has this kind"),
    })?;
    Ok(())
}

fn of_vertices(count: usize) -> String {
    counted(count, "vertex", "vertices")
}
