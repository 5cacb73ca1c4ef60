//! Edits as the page sends them, and what it asks before it sends one.

use super::plain::{plain, thrown_at};
use super::solver::Solver;
use super::thrown;
use crate::constraint::{Selector, Set};
use crate::error::Error;
use crate::scene::{ConstraintSpec, Lesson};
use crate::session::{Edit, NewConstraint, Place};
use serde::Deserialize;
use serde_json::{Map, Value};
use wasm_bindgen::prelude::*;

/// An edit as the page sends it: as it is, but for those that say less than the edit does, or that
/// hold a piece of a scene file.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
enum PageEdit {
    AddConstraint {
        kind: String,
        params: Map<String, Value>,
        on: Value,
        weight: f64,
    },
    /// Those that are not given stay.
    SetWeights {
        shape: Option<f64>,
        close: Option<f64>,
        smooth: Option<f64>,
    },
    SetLesson {
        lesson: Option<Value>,
    },
    #[serde(untagged)]
    AsItIs(Edit),
}

#[wasm_bindgen]
impl Solver {
    /// Makes an edit, one step of undo.
    pub fn edit(&mut self, edit: JsValue) -> Result<(), JsValue> {
        let edit: PageEdit = serde_wasm_bindgen::from_value(edit).map_err(thrown)?;
        let session = self.open_mut()?;
        let edit = match edit {
            PageEdit::AddConstraint { kind, params, on, weight } => {
                Edit::AddConstraint(new_constraint(kind, params, on, weight)?)
            }
            PageEdit::SetWeights { shape, close, smooth } => {
                let mut weights = session.document().weights;
                weights.shape = shape.unwrap_or(weights.shape);
                weights.close = close.unwrap_or(weights.close);
                weights.smooth = smooth.unwrap_or(weights.smooth);
                Edit::SetWeights(weights)
            }
            PageEdit::SetLesson { lesson } => {
                let read = |lesson: Value| Lesson::from_json(&lesson.to_string());
                let lesson = lesson.map(read).transpose();
                Edit::SetLesson(lesson.map_err(|error| thrown_at(&error))?)
            }
            PageEdit::AsItIs(edit) => edit,
        };
        session.edit(edit).map_err(|error| match error {
            Error::Scene(error) => thrown_at(&error),
            error => thrown(error),
        })
    }

    /// How many constraints a row of each kind would hold at each of the places, which are selectors as
    /// in an edit: `#kinds by #places`, null where nothing fits.
    pub fn previews(&self, places: JsValue) -> Result<JsValue, JsValue> {
        let places: Vec<Value> = serde_wasm_bindgen::from_value(places).map_err(thrown)?;
        let places: Vec<Place> = places.into_iter().map(place).collect::<Result<_, _>>()?;
        plain(&self.open()?.previews(&places).map_err(|error| thrown_at(&error))?)
    }
}

/// A constraint as the page describes it: like an entry of a scene file, on a [`place`].
fn new_constraint(
    kind: String,
    mut entry: Map<String, Value>,
    mut on: Value,
    weight: f64,
) -> Result<NewConstraint, JsValue> {
    let set = take_unnamed_set(&mut on)?;
    entry.insert("kind".to_owned(), kind.into());
    entry.insert("on".to_owned(), on);
    entry.insert("weight".to_owned(), weight.into());
    let entry = Value::Object(entry).to_string();
    let spec = ConstraintSpec::from_json(&entry).map_err(|error| thrown_at(&error))?;
    Ok(NewConstraint { spec, set })
}

/// A selector as the page describes it: like `on` of a scene file, but `in` may be a set without a
/// name, `{ faces }` or `{ vertices }`.
fn place(mut on: Value) -> Result<Place, JsValue> {
    let set = take_unnamed_set(&mut on)?;
    let on = Selector::from_json(&on.to_string()).map_err(|error| thrown_at(&error))?;
    Ok(Place { on, set })
}

fn take_unnamed_set(on: &mut Value) -> Result<Option<Set>, JsValue> {
    let Some(within) = on.get_mut("in").filter(|within| within.is_object()) else {
        return Ok(None);
    };
    let set = serde_json::from_value(within.take()).map_err(thrown)?;
    *within = Place::UNNAMED.into();
    Ok(Some(set))
}
