//! `shape-up check` of the results of a lesson: of one student, or of a class.
//!
//! | file | holds |
//! |---|---|
//! | `one` | check of one student's results against the goals |
//! | `class` | a table of all results in a folder |

mod class;
mod one;

pub(super) use class::check as check_class;
pub(super) use one::check;

use super::{Failure, input};
use shape_up::scene::Results;
use std::path::Path;

/// Reads a results file.
fn read(path: &Path) -> Result<Results, Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", path.display()));
    let text = String::from_utf8(input::bytes(path)?)
        .map_err(|_| at("the file is not UTF-8 text, expected results in JSON".to_owned()))?;
    Results::from_json(&text).map_err(|error| at(error.to_string()))
}
