//! Short constructors of scenes and constraints for the session tests.

use shape_up::scene::{ConstraintSpec, Scene};
use shape_up::session::{Edit, NewConstraint};

/// A scene of `grid.obj` with the keys in `rest` appended.
pub(crate) fn scene(rest: &str) -> Scene {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}{rest} }}"#
    );
    Scene::from_json(&text).expect("the scene is valid")
}

/// The edit that adds a constraint of `kind` on `on`.
pub(crate) fn new(kind: &str, on: &str) -> Edit {
    let text = format!(r#"{{ "kind": "{kind}", "on": {on} }}"#);
    let spec = serde_json::from_str::<ConstraintSpec>(&text).expect("the constraint is valid");
    Edit::AddConstraint(NewConstraint { spec, set: None })
}
