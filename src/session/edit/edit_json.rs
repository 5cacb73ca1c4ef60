//! Edits, requests to select, and places, as hosts that speak JSON send them.

use super::constraint_target::ConstraintTarget;
use super::edit_list::{Edit, NewConstraint};
use crate::constraint::Set;
use crate::scene::{
    JsonCursor, Node, Scene, SceneError, Weights, parse, read_constraint, read_indices,
    read_lesson, read_selector,
};
use crate::session::selection::{SelectRequest, Selection};
use serde_json::{Map, Value};

impl Edit {
    /// Reads an edit of `document`: an object with its `type`, which is the name of the variant in camel
    /// case, and its fields. A constraint is described as in a scene file, but with its parameters in
    /// `params` and `on` as a [`ConstraintTarget`]; of weights, those that are not given stay.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str, document: &Scene) -> Result<Edit, SceneError> {
        let node = parse(text)?;
        let at = &JsonCursor::root(&node);
        let kind = at.need("type", "the type of an edit")?;
        Ok(match kind.text("the type of an edit")? {
            "addConstraint" => Edit::AddConstraint(new_constraint(at)?),
            "removeConstraint" => Edit::RemoveConstraint { index: index(at)? },
            "setConstraint" => Edit::SetConstraint {
                index: index(at)?,
                weight: given(at, "weight", weight)?,
                enabled: given(at, "enabled", |enabled| enabled.truth())?,
                params: params(at)?,
            },
            "duplicateConstraint" => Edit::DuplicateConstraint { index: index(at)? },
            "renameConstraint" => {
                Edit::RenameConstraint { index: index(at)?, name: word(at, "name")? }
            }
            "nameSet" => Edit::NameSet { name: word(at, "name")?, set: set(at)? },
            "removeSet" => Edit::RemoveSet { name: word(at, "name")? },
            "set" => Edit::Set {
                id: word(at, "id")?,
                value: at.need("value", "a value")?.node.to_value(),
            },
            "holdClose" => Edit::HoldClose {
                vertices: given(at, "vertices", read_indices)?,
                weight: weight(&at.need("weight", A_WEIGHT)?)?,
            },
            "holdCloser" => Edit::HoldCloser,
            "weighHandles" => Edit::WeighHandles {
                vertices: vertices(at)?,
                weight: weight(&at.need("weight", A_WEIGHT)?)?,
            },
            "setWeights" => {
                let Weights { shape, close, smooth } = document.weights;
                Edit::SetWeights(Weights {
                    shape: given(at, "shape", weight)?.unwrap_or(shape),
                    close: given(at, "close", weight)?.unwrap_or(close),
                    smooth: given(at, "smooth", weight)?.unwrap_or(smooth),
                })
            }
            "preset" => Edit::Preset { id: word(at, "id")? },
            "setUnits" => Edit::SetUnits { units: word(at, "units")? },
            "setUp" => Edit::SetUp { up: at.need("up", "an axis")?.choice()? },
            "setLesson" => Edit::SetLesson(given(at, "lesson", |lesson| {
                // Its paths are those within a lesson.
                read_lesson(&JsonCursor::root(lesson.node))
            })?),
            "addHandles" => Edit::AddHandles {
                vertices: vertices(at)?,
                fixed: at.need("fixed", "true or false")?.truth()?,
            },
            "removeHandles" => Edit::RemoveHandles { vertices: vertices(at)? },
            "reset" => Edit::Reset,
            other => return Err(kind.error(format!("`{other}` is no edit"))),
        })
    }
}

impl SelectRequest {
    /// Reads a request: its fields by their names; without `from` nothing is selected now.
    ///
    /// # Errors
    /// As [`Scene::from_json`].
    pub fn from_json(text: &str) -> Result<SelectRequest, SceneError> {
        let node = parse(text)?;
        let at = &JsonCursor::root(&node);
        let list =
            |from: &JsonCursor<'_>, key| Ok(given(from, key, read_indices)?.unwrap_or_default());
        let selection = |from: &JsonCursor<'_>| -> Result<Selection, SceneError> {
            Ok(Selection {
                vertices: list(from, "vertices")?,
                edges: list(from, "edges")?,
                faces: list(from, "faces")?,
            })
        };
        Ok(SelectRequest {
            operation: word(at, "operation")?,
            mode: at.need("mode", "what is picked")?.choice()?,
            from: given(at, "from", selection)?.unwrap_or_default(),
            params: params(at)?,
        })
    }
}

impl ConstraintTarget {
    /// Reads an array of places: each a selector as in a scene file, in which `in` may also be a set
    /// without a name, `{"faces": ...}` or `{"vertices": ...}`.
    ///
    /// # Errors
    /// As [`Scene::from_json`], with the path within the place.
    pub fn all_from_json(text: &str) -> Result<Vec<ConstraintTarget>, SceneError> {
        let node = parse(text)?;
        let root = JsonCursor::root(&node);
        let places = root.array("an array of places")?;
        let read = |at: &JsonCursor<'_>| {
            let (on, set) = with_set_named(at)?;
            Ok(ConstraintTarget { on: read_selector(&JsonCursor::root(&on))?, set })
        };
        places.iter().map(read).collect()
    }
}

const A_WEIGHT: &str = "a weight";

/// What `read` makes of the value of `key`, where there is one that is not null.
fn given<T>(
    at: &JsonCursor<'_>,
    key: &str,
    read: impl Fn(&JsonCursor<'_>) -> Result<T, SceneError>,
) -> Result<Option<T>, SceneError> {
    at.get(key).filter(|value| *value.node != Node::Null).as_ref().map(read).transpose()
}

fn word(at: &JsonCursor<'_>, key: &str) -> Result<String, SceneError> {
    Ok(at.need(key, "a text")?.text("a text")?.to_owned())
}

fn weight(at: &JsonCursor<'_>) -> Result<f64, SceneError> {
    at.number(A_WEIGHT)
}

fn index(at: &JsonCursor<'_>) -> Result<usize, SceneError> {
    const WHAT: &str = "the index of a row";
    Ok(at.need("index", WHAT)?.whole(WHAT)? as usize)
}

fn vertices(at: &JsonCursor<'_>) -> Result<Vec<u32>, SceneError> {
    read_indices(&at.need("vertices", "a list of vertices")?)
}

fn set(at: &JsonCursor<'_>) -> Result<Set, SceneError> {
    Ok(Set {
        vertices: given(at, "vertices", read_indices)?.unwrap_or_default(),
        faces: given(at, "faces", read_indices)?.unwrap_or_default(),
    })
}

fn params(at: &JsonCursor<'_>) -> Result<Map<String, Value>, SceneError> {
    match at.get("params").map(|params| params.node.to_value()) {
        None => Ok(Map::new()),
        Some(Value::Object(params)) => Ok(params),
        Some(_) => Err(at.error("found other `params` than an object of parameters")),
    }
}

/// The row that an edit adds, read as an entry of a scene file.
fn new_constraint(at: &JsonCursor<'_>) -> Result<NewConstraint, SceneError> {
    let mut entry = Vec::new();
    if let Some(params) = at.get("params") {
        let own = params.entries("an object of parameters")?;
        entry.extend(own.iter().map(|(key, value)| ((*key).to_owned(), value.node.clone())));
    }
    let (on, set) = with_set_named(&at.need("on", "a place")?)?;
    entry.push(("kind".to_owned(), at.need("kind", "a kind")?.node.clone()));
    entry.push(("on".to_owned(), on));
    entry.push(("weight".to_owned(), at.need("weight", A_WEIGHT)?.node.clone()));
    let spec = read_constraint(&JsonCursor::root(&Node::Object(entry)))?;
    Ok(NewConstraint { spec, set })
}

/// A selector with [`ConstraintTarget::UNNAMED`] where it has a set without a name, and this set.
fn with_set_named(on: &JsonCursor<'_>) -> Result<(Node, Option<Set>), SceneError> {
    let mut named = on.node.clone();
    let mut unnamed = None;
    if let Node::Object(entries) = &mut named
        && let Some((_, within)) = entries.iter_mut().find(|(key, _)| key == "in")
        && let Node::Object(_) = within
    {
        unnamed = Some(set(&JsonCursor::root(within))?);
        *within = Node::Text(ConstraintTarget::UNNAMED.to_owned());
    }
    Ok((named, unnamed))
}
