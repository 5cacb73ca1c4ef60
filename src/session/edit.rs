//! Edits of the document. Each is one step of undo, and fails without leaving a trace.

use super::history::Snapshot;
use super::holding::hold_close;
use super::lesson::check_lesson;
use super::same_problem::same_problem;
use super::{Session, resolve, settings, solver};
use crate::constraint::{Kind, KindError, Selector, Set};
use crate::error::Error;
use crate::mesh::Point;
use crate::scene::{
    Closeness, ConstraintSpec, HANDLE_WEIGHT, Hold, Lesson, Scene, SceneError, Up, Weights,
};
use crate::solve::Handle;
use serde_json::{Map, Value};

/// An edit of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Appends a row of constraints.
    AddConstraint(NewConstraint),
    /// Removes row `index`.
    RemoveConstraint {
        /// Which row.
        index: usize,
    },
    /// Changes row `index`.
    SetConstraint {
        /// Which row.
        index: usize,
        /// New `w_i`.
        weight: Option<f64>,
        /// Whether it counts.
        enabled: Option<bool>,
        /// New values of parameters, as in scene files; those that are not here stay.
        params: Map<String, Value>,
    },
    /// Adds a row like row `index` after it.
    DuplicateConstraint {
        /// Which row.
        index: usize,
    },
    /// Gives row `index` another name.
    RenameConstraint {
        /// Which row.
        index: usize,
        /// Empty for the label of its kind.
        name: String,
    },
    /// Gives a set a name, instead of what had that name.
    NameSet {
        /// Not empty.
        name: String,
        /// The set.
        set: Set,
    },
    /// Takes a set away.
    RemoveSet {
        /// Its name.
        name: String,
    },
    /// Gives one of the declared settings another value.
    Set {
        /// Its id.
        id: String,
        /// Its value, in one of its forms.
        value: Value,
    },
    /// Keeps some vertices close more or less than the others.
    HoldClose {
        /// Which vertices; all of them where there is no list.
        vertices: Option<Vec<u32>>,
        /// A factor of the weight of closeness, not negative; 1 is as the others.
        weight: f64,
    },
    /// Makes handles soft, with a weight.
    WeighHandles {
        /// Their vertices.
        vertices: Vec<u32>,
        /// Positive.
        weight: f64,
    },
    /// Replaces the weights of Eq. 13.
    SetWeights(Weights),
    /// Replaces what vertices are kept close to.
    SetCloseness(Closeness),
    /// Says in which unit the coordinates are; they stay as they are. Empty when not known.
    SetUnits(String),
    /// Says which axis points up; the coordinates stay as they are.
    SetUp(Up),
    /// Makes the scene an exercise, or no longer.
    SetLesson(Option<Lesson>),
    /// Makes vertices handles where they are now; those that are handles already change how they hold.
    AddHandles {
        /// Which vertices.
        vertices: Vec<u32>,
        /// Fixed or soft.
        fixed: bool,
    },
    /// Releases vertices.
    RemoveHandles {
        /// Which vertices.
        vertices: Vec<u32>,
    },
    /// Goes back to the rest shape; constraints, handles and weights stay.
    Reset,
}

/// A row of constraints to be added.
#[derive(Clone, Debug, PartialEq)]
pub struct NewConstraint {
    /// The row.
    pub spec: ConstraintSpec,
    /// What [`Place::UNNAMED`] stands for in the selector.
    pub set: Option<Set>,
}

impl NewConstraint {
    /// Adds the row to `document`, and its set under a name of its own.
    fn add_to(self, document: &mut Scene) {
        let NewConstraint { mut spec, set } = self;
        spec.on = Place { on: spec.on, set }.name_in(document);
        document.constraints.push(spec);
    }
}

/// Where constraints may be: what a selector says, which may be about a set that has no name yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The selector.
    pub on: Selector,
    /// What [`Place::UNNAMED`] stands for in the selector.
    pub set: Option<Set>,
}

impl Place {
    /// The name in the selector that stands for `set`.
    pub const UNNAMED: &str = "";

    /// The selector when the set is in `document`, which gets it under a name of its own.
    pub(super) fn name_in(self, document: &mut Scene) -> Selector {
        let Place { mut on, set } = self;
        if let Some(set) = set {
            let known = document.sets.iter().find(|(_, other)| **other == set);
            let name = match known {
                Some((name, _)) => name.clone(),
                None => (1..)
                    .map(|k| format!("selection {k}"))
                    .find(|name| !document.sets.contains_key(name))
                    .expect("some number is free"),
            };
            if let Selector::Each { within: Some(within), .. } = &mut on {
                within.clone_from(&name);
            }
            document.sets.insert(name, set);
        }
        on
    }
}

impl Session {
    /// Makes an edit.
    ///
    /// # Errors
    /// When it names a row or vertex that is not there, leaves a row without constraints, or makes the
    /// system singular; nothing has changed then.
    pub fn edit(&mut self, edit: Edit) -> Result<(), Error> {
        self.end_run();
        self.end_drag(true);
        let before = self.snapshot();
        let mut after = before.clone();
        let name = self.apply(edit, &mut after)?;
        self.go_to(after)?;
        self.history.push(name, before);
        Ok(())
    }

    /// Takes back the last step; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn undo(&mut self) -> Result<Option<String>, Error> {
        self.end_run();
        self.end_drag(true);
        let now = self.snapshot();
        self.history.undo(now).map(|(name, to)| self.go_to(to).map(|()| name)).transpose()
    }

    /// Repeats the step that was last undone; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn redo(&mut self) -> Result<Option<String>, Error> {
        self.end_run();
        self.end_drag(true);
        let now = self.snapshot();
        self.history.redo(now).map(|(name, to)| self.go_to(to).map(|()| name)).transpose()
    }

    /// The names of the steps that undo and redo would take.
    pub fn undo_and_redo(&self) -> [Option<&str>; 2] {
        [self.history.undo_name(), self.history.redo_name()]
    }

    pub(super) fn snapshot(&self) -> Snapshot {
        Snapshot {
            document: self.document.clone(),
            handles: self.solver.handles().to_vec(),
            positions: self.positions(),
            iteration: self.iteration,
        }
    }

    /// Applies an edit to a state, and gives its name.
    pub(super) fn apply(&self, edit: Edit, state: &mut Snapshot) -> Result<String, SceneError> {
        let Snapshot { document, handles, positions, iteration } = state;
        let name = match edit {
            Edit::AddConstraint(new) => {
                let name = format!("Add {}", new.spec.kind.info().label.to_ascii_lowercase());
                new.add_to(document);
                name
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
                format!("Rename {}", spec.kind.info().label.to_lowercase())
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
                    Some(vertices) => hold_close(&mut document.closeness, vertices, weight),
                    None => document.closeness.weights.clear(),
                }
                vertices.map_or("Hold all alike".to_owned(), |vertices| {
                    format!("Hold {} close", counted(vertices.len()))
                })
            }
            Edit::WeighHandles { vertices, weight } => {
                if !(weight.is_finite() && weight > 0.0) {
                    let message = format!("found {weight}, expected a number above 0");
                    return Err(SceneError { path: "handles.weight".to_owned(), message });
                }
                for handle in handles.iter_mut().filter(|h| vertices.contains(&h.vertex)) {
                    handle.hold = Hold::Soft { weight };
                }
                format!("Weigh {}", counted(vertices.len()))
            }
            Edit::SetWeights(weights) => {
                document.weights = weights;
                "Change weights".to_owned()
            }
            Edit::SetCloseness(closeness) => {
                document.closeness = closeness;
                "Change closeness".to_owned()
            }
            Edit::SetUnits(units) => {
                document.units = units;
                "Change unit".to_owned()
            }
            Edit::SetUp(up) => {
                document.up = up;
                "Change up axis".to_owned()
            }
            Edit::SetLesson(lesson) => {
                document.lesson = lesson;
                check_lesson(document, &self.mesh)?;
                "Change lesson".to_owned()
            }
            Edit::AddHandles { vertices, fixed } => {
                let hold = if fixed { Hold::Fixed } else { Hold::Soft { weight: HANDLE_WEIGHT } };
                self.hold(&vertices, hold, handles, positions)?;
                format!("{} {}", if fixed { "Fix" } else { "Hold" }, counted(vertices.len()))
            }
            Edit::RemoveHandles { vertices } => {
                handles.retain(|handle| !vertices.contains(&handle.vertex));
                format!("Release {}", counted(vertices.len()))
            }
            Edit::Reset => {
                positions.clone_from(&self.mesh.positions);
                *iteration = 0;
                "Reset".to_owned()
            }
        };
        Ok(name)
    }

    fn hold(
        &self,
        vertices: &[u32],
        hold: Hold,
        handles: &mut Vec<Handle>,
        positions: &[Point],
    ) -> Result<(), SceneError> {
        for &vertex in vertices {
            let Some(&target) = positions.get(vertex as usize) else {
                let message =
                    format!("vertex {vertex} is out of range: the mesh has {}", positions.len());
                return Err(SceneError { path: "handles".to_owned(), message });
            };
            match handles.iter_mut().find(|handle| handle.vertex == vertex) {
                Some(handle) => handle.hold = hold,
                None => handles.push(Handle { vertex, target, hold }),
            }
        }
        Ok(())
    }

    /// Makes `state` the current one at the least cost.
    pub(super) fn go_to(&mut self, state: Snapshot) -> Result<(), Error> {
        let Snapshot { document, handles, positions, iteration } = state;
        let moved = self.positions() != positions;
        if same_problem(&document, &self.document) {
            let same_holds = handles.len() == self.solver.handles().len()
                && handles
                    .iter()
                    .zip(self.solver.handles())
                    .all(|(a, b)| a.vertex == b.vertex && a.hold == b.hold);
            if same_holds {
                self.solver.move_handles(handles.iter().map(|h| (h.vertex, h.target)));
            } else {
                let old = self.solver.handles().to_vec();
                if let Err(error) = self.solver.hold(handles) {
                    self.solver.hold(old)?;
                    return Err(error.into());
                }
            }
            if moved {
                self.solver.set_positions(&positions);
            }
            self.document = document;
        } else if self.differs_in_weights(&document) {
            document.validate(&self.mesh)?;
            let old = self.solver.handles().to_vec();
            if let Err(error) = self.solver.reweigh(document.weights, handles) {
                self.solver.reweigh(self.document.weights, old)?;
                return Err(error.into());
            }
            if moved {
                self.solver.set_positions(&positions);
            }
            self.document = document;
        } else {
            document.validate(&self.mesh)?;
            let rows = resolve::rows(&document, &self.mesh, &self.topology)?;
            // A set that nothing uses needs no other solver.
            let mut as_before = document.clone();
            as_before.sets.clone_from(&self.document.sets);
            let unused = same_problem(&as_before, &self.document)
                && rows == self.rows
                && !moved
                && as_before.closeness.weights.is_empty()
                && handles == self.solver.handles();
            if !unused {
                let (mesh, topology) = (&self.mesh, &self.topology);
                let kept = self.solver.kept();
                self.solver = solver(&document, mesh, topology, &rows, kept, handles, &positions)?;
            }
            self.rows = rows;
            self.document = document;
        }
        self.arrive(iteration);
        Ok(())
    }

    /// Whether a document is the current one but for weights that the solver can replace.
    fn differs_in_weights(&self, document: &Scene) -> bool {
        let same = Scene { weights: self.document.weights, ..document.clone() };
        same_problem(&same, &self.document) && self.solver.can_reweigh(document.weights)
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

fn counted(vertices: usize) -> String {
    if vertices == 1 { "1 vertex".to_owned() } else { format!("{vertices} vertices") }
}
