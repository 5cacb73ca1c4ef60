//! Constraints for the scene tests.

use shape_up::constraint::{Kind, Selector};
use shape_up::scene::{ConstraintSpec, RowNumber};
use shape_up::solve::Require;

/// A soft constraint of a kind without parameters.
pub(crate) fn constraint(id: &str, on: Selector) -> ConstraintSpec {
    let kind = Kind::new(id, serde_json::json!({})).expect("a kind without parameters");
    ConstraintSpec {
        kind,
        on,
        weight: 1.0,
        enabled: true,
        name: String::new(),
        require: Require::Soft,
        eased: None,
        number: RowNumber::default(),
    }
}
