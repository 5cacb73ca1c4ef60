//! Constructors of constraints and handles.

use crate::constraint::{Element, Kind, Selector};
use crate::mesh::{Mesh, Point};
use crate::scene::{ConstraintSpec, HandleSpec, Hold, Require, RowNumber};

pub(super) fn each(element: Element) -> Selector {
    Selector::Each { element, within: None, radius: 0 }
}

pub(super) fn constraint(id: &str, on: Selector, weight: f64) -> ConstraintSpec {
    let kind = Kind::new(id, serde_json::json!({})).expect("the kind is in the list of kinds");
    ConstraintSpec {
        kind,
        on,
        weight,
        enabled: true,
        name: String::new(),
        require: Require::Soft,
        eased: None,
        number: RowNumber::default(),
    }
}

/// A handle that fixes vertices.
pub(super) fn fixed(vertices: Vec<u32>) -> HandleSpec {
    HandleSpec { vertices, targets: None, hold: Hold::Fixed }
}

/// A handle that moves vertices to other positions.
pub(super) fn moved(mesh: &Mesh, vertices: Vec<u32>, to: impl Fn(Point) -> Point) -> HandleSpec {
    let targets = vertices.iter().map(|&v| to(mesh.positions[v as usize])).collect();
    HandleSpec { vertices, targets: Some(targets), hold: Hold::Fixed }
}
