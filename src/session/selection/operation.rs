//! Declarations of the selection operations: all that hosts show of them, but not what they do.

use super::request::Mode;
use crate::constraint::{Form, Param};
use crate::session::report::FACE_MEASURES;
use serde::Serialize;

/// The declaration of a selection operation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
pub struct Operation {
    /// The id in a request.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// The resulting selection, in one sentence.
    pub summary: &'static str,
    /// The heading under which hosts list it.
    pub group: &'static str,
    /// The kinds of element for which it is available.
    pub modes: &'static [Mode],
    /// The kind of element that it selects, if not the current one.
    pub gives: Option<Mode>,
    /// Whether it starts from the selection, and has no result without one.
    pub needs_selection: bool,
    /// Whether its parameter `name` is the name of a set or a group.
    pub takes_name: bool,
    /// Its parameters.
    pub params: &'static [Param],
    /// Its keyboard shortcuts on the page, such as "Ctrl+A".
    pub keys: &'static [&'static str],
    /// The kind of element on which a double-click triggers it.
    pub double_click: Option<Mode>,
    /// The kind of element on which a double-click with Shift triggers it.
    pub shift_double_click: Option<Mode>,
    /// The id of the operation that another double-click on its result triggers, if that contains the
    /// element.
    pub again: Option<&'static str>,
}

const ALL_MODES: &[Mode] = &[Mode::Vertices, Mode::Edges, Mode::Faces];
const CHANGE: &str = "Change the selection";
const FOLLOW: &str = "Follow the mesh";
const FIND: &str = "Find";

const PLAIN: Operation = Operation {
    id: "",
    label: "",
    summary: "",
    group: CHANGE,
    modes: ALL_MODES,
    gives: None,
    needs_selection: false,
    takes_name: false,
    params: &[],
    keys: &[],
    double_click: None,
    shift_double_click: None,
    again: None,
};

/// The ids of the measures of faces, with their names on the page.
const MEASURE_LABELS: [(&str, &str); FACE_MEASURES.len()] = {
    let mut labels = [("", ""); FACE_MEASURES.len()];
    let mut i = 0;
    while i < labels.len() {
        labels[i] = (FACE_MEASURES[i].id, FACE_MEASURES[i].label);
        i += 1;
    }
    labels
};

/// The ids alone.
const MEASURES: [Form; FACE_MEASURES.len()] = Form::words(&MEASURE_LABELS);

/// All selection operations, in the order in which hosts list them.
pub const OPERATIONS: &[Operation] = &[
    Operation {
        id: "all",
        label: "All",
        summary: "All vertices, edges or faces.",
        keys: &["Ctrl+A"],
        ..PLAIN
    },
    Operation {
        id: "invert",
        label: "Invert",
        summary: "Everything that is not selected.",
        keys: &["Ctrl+I"],
        ..PLAIN
    },
    Operation {
        id: "grow",
        label: "Grow",
        summary: "The selection and everything that touches it.",
        needs_selection: true,
        keys: &["+"],
        ..PLAIN
    },
    Operation {
        id: "shrink",
        label: "Shrink",
        summary: "The selection without the elements that touch the rest of the mesh.",
        needs_selection: true,
        keys: &["-"],
        ..PLAIN
    },
    Operation {
        id: "to-vertices",
        label: "Convert to vertices",
        summary: "The vertices of the selected edges or faces.",
        needs_selection: true,
        modes: &[Mode::Edges, Mode::Faces],
        gives: Some(Mode::Vertices),
        ..PLAIN
    },
    Operation {
        id: "to-edges",
        label: "Edges of the selection",
        summary: "The edges all of whose vertices are selected.",
        needs_selection: true,
        modes: &[Mode::Vertices, Mode::Faces],
        gives: Some(Mode::Edges),
        ..PLAIN
    },
    Operation {
        id: "to-faces",
        label: "Faces of the selection",
        summary: "The faces all of whose vertices are selected.",
        needs_selection: true,
        modes: &[Mode::Vertices, Mode::Edges],
        gives: Some(Mode::Faces),
        ..PLAIN
    },
    Operation {
        id: "connected",
        label: "Connected",
        summary: "Every connected part of the mesh that contains a selected element.",
        group: FOLLOW,
        needs_selection: true,
        keys: &["Shift+L"],
        ..PLAIN
    },
    Operation {
        id: "boundary",
        label: "Boundary loop",
        summary: "The boundary loops that the selection touches, or all of them if nothing is selected. Selected faces give edges.",
        group: FOLLOW,
        ..PLAIN
    },
    Operation {
        id: "boundary-faces",
        label: "Faces along the boundary",
        summary: "The faces along the boundary loops that the selection touches, or along all of them if nothing is selected.",
        group: FOLLOW,
        modes: &[Mode::Faces],
        ..PLAIN
    },
    Operation {
        id: "loop",
        label: "Edge loop",
        summary: "The straight lines of edges through the selection, on meshes of mostly quads.",
        group: FOLLOW,
        needs_selection: true,
        modes: &[Mode::Vertices, Mode::Edges],
        double_click: Some(Mode::Edges),
        again: Some("boundary"),
        ..PLAIN
    },
    Operation {
        id: "ring",
        label: "Edge ring",
        summary: "The edges opposite to the selected ones, from quad to quad.",
        group: FOLLOW,
        needs_selection: true,
        modes: &[Mode::Edges],
        shift_double_click: Some(Mode::Edges),
        ..PLAIN
    },
    Operation {
        id: "strip",
        label: "Face strip",
        summary: "The strips of quads through the selected faces: both strips through a single face, or the strip that joins several.",
        group: FOLLOW,
        needs_selection: true,
        modes: &[Mode::Faces],
        ..PLAIN
    },
    Operation {
        id: "flat",
        label: "Flat patch",
        summary: "The faces around the selected ones up to where the surface bends by more than the angle.",
        group: FOLLOW,
        needs_selection: true,
        modes: &[Mode::Faces],
        params: &[Param::number("angle", "Angle", "degrees", 5.0, [0.0, 180.0])],
        double_click: Some(Mode::Faces),
        ..PLAIN
    },
    Operation {
        id: "sides",
        label: "By number of sides",
        summary: "Faces with this many sides.",
        group: FIND,
        modes: &[Mode::Faces],
        params: &[Param::number("sides", "Sides", "", 4.0, [0.0, 1e6])],
        ..PLAIN
    },
    Operation {
        id: "valence",
        label: "By number of edges",
        summary: "Vertices with this many edges.",
        group: FIND,
        modes: &[Mode::Vertices],
        params: &[Param::number("edges", "Edges", "", 4.0, [0.0, 1e6])],
        ..PLAIN
    },
    Operation {
        id: "error",
        label: "By error",
        summary: "Faces whose error is above a tolerance.",
        group: FIND,
        modes: &[Mode::Faces],
        params: &[
            Param::word("measure", "Error", "planarity", &MEASURES).called(&MEASURE_LABELS),
            Param::number("tolerance", "Above", "", 0.001, [0.0, f64::INFINITY]),
        ],
        ..PLAIN
    },
    Operation {
        id: "free",
        label: "Vertices held by nothing",
        summary: "Vertices without constraint, closeness, smoothness or handle, which stay where they are.",
        group: FIND,
        gives: Some(Mode::Vertices),
        ..PLAIN
    },
    Operation {
        id: "named",
        label: "By set or group",
        summary: "The members of a set of the scene or of a group of the file.",
        group: FIND,
        takes_name: true,
        ..PLAIN
    },
];
