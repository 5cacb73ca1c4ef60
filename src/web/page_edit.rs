//! More edits as the page sends them: of rows as a whole, sets, settings, and how things are held.

use crate::constraint::Set;
use crate::scene::{Lesson, SceneError};
use crate::session::Edit;
use serde::Deserialize;
use serde_json::Value;

/// An edit as the page sends it.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
pub(super) enum OtherEdit {
    DuplicateConstraint {
        index: usize,
    },
    RenameConstraint {
        index: usize,
        name: String,
    },
    NameSet {
        name: String,
        #[serde(default)]
        vertices: Vec<u32>,
        #[serde(default)]
        faces: Vec<u32>,
    },
    RemoveSet {
        name: String,
    },
    Set {
        id: String,
        value: Value,
    },
    HoldClose {
        vertices: Option<Vec<u32>>,
        weight: f64,
    },
    WeighHandles {
        vertices: Vec<u32>,
        weight: f64,
    },
    SetLesson {
        lesson: Option<Value>,
    },
}

impl TryFrom<OtherEdit> for Edit {
    type Error = SceneError;

    fn try_from(edit: OtherEdit) -> Result<Edit, SceneError> {
        Ok(match edit {
            OtherEdit::DuplicateConstraint { index } => Edit::DuplicateConstraint { index },
            OtherEdit::RenameConstraint { index, name } => Edit::RenameConstraint { index, name },
            OtherEdit::NameSet { name, vertices, faces } => {
                Edit::NameSet { name, set: Set { vertices, faces } }
            }
            OtherEdit::RemoveSet { name } => Edit::RemoveSet { name },
            OtherEdit::Set { id, value } => Edit::Set { id, value },
            OtherEdit::HoldClose { vertices, weight } => Edit::HoldClose { vertices, weight },
            OtherEdit::WeighHandles { vertices, weight } => Edit::WeighHandles { vertices, weight },
            OtherEdit::SetLesson { lesson } => {
                let read = |lesson: Value| Lesson::from_json(&lesson.to_string());
                Edit::SetLesson(lesson.map(read).transpose()?)
            }
        })
    }
}
