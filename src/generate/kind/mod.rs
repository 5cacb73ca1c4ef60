//! New meshes by kind and sizes: the list of kinds.

mod declaration;
mod round;
mod sheets;

pub use declaration::{NewKind, NewMeshError};

use crate::mesh::{Size, SizeOf};

const fn length(id: &'static str, label: &'static str, default: f64) -> Size {
    Size::length(id, label, default, [1e-3, 1e6])
}

/// A length that may be zero.
const fn from_zero(id: &'static str, label: &'static str, default: f64) -> Size {
    Size::length(id, label, default, [0.0, 1e6])
}

const fn count(id: &'static str, label: &'static str, default: f64, least: f64) -> Size {
    Size { id, label, of: SizeOf::Count, default, least, most: 500.0 }
}

const ALONG: Size = count("along", "Panels along", 16.0, 1.0);
const ACROSS: Size = count("across", "Panels across", 12.0, 1.0);
const AROUND: Size = count("around", "Panels around", 24.0, 3.0);
const ROWS: Size = count("rows", "Rows of panels", 8.0, 1.0);
const LENGTH: Size = length("length", "Length", 20.0);
const WIDTH: Size = length("width", "Width", 12.0);
const HEIGHT: Size = length("height", "Height", 8.0);
const DIAMETER: Size = length("diameter", "Diameter", 16.0);

/// All kinds, in the order in which hosts list them.
pub const NEW_KINDS: &[NewKind] = &[
    NewKind {
        id: "grid",
        label: "Grid",
        summary: "A flat sheet of quads on the ground.",
        sizes: &[LENGTH, WIDTH, ALONG, ACROSS],
        make: sheets::flat,
    },
    NewKind {
        id: "barrel",
        label: "Barrel vault",
        summary: "A vault over a rectangle, a piece of a cylinder.",
        sizes: &[LENGTH, length("span", "Span", 12.0), length("rise", "Rise", 4.0), ALONG, ACROSS],
        make: sheets::barrel,
    },
    NewKind {
        id: "dome",
        label: "Dome",
        summary: "A cap of a sphere, with a round opening on top.",
        sizes: &[
            DIAMETER,
            length("rise", "Rise", 5.0),
            from_zero("opening", "Opening", 2.0),
            AROUND,
            ROWS,
        ],
        make: round::dome,
    },
    NewKind {
        id: "cone",
        label: "Cone",
        summary: "A cone, pointed if the diameter of its top is 0.",
        sizes: &[DIAMETER, from_zero("top", "Diameter of the top", 4.0), HEIGHT, AROUND, ROWS],
        make: round::cone,
    },
    NewKind {
        id: "funnel",
        label: "Funnel",
        summary: "A column that opens to a roof, saddle-shaped everywhere.",
        sizes: &[
            length("rim", "Diameter of the rim", 16.0),
            length("neck", "Diameter of the neck", 2.0),
            HEIGHT,
            AROUND,
            ROWS,
        ],
        make: round::funnel,
    },
    NewKind {
        id: "torus",
        label: "Torus segment",
        summary: "A vault along an arc: the upper half of a torus segment.",
        sizes: &[
            length("radius", "Radius of the arc", 15.0),
            length("section", "Radius of the section", 5.0),
            Size::degrees("turn", "Turn", 120.0, [5.0, 330.0]),
            ALONG,
            ACROSS,
        ],
        make: sheets::torus,
    },
    NewKind {
        id: "hypar",
        label: "Hypar",
        summary: "A saddle between four straight sides.",
        sizes: &[
            length("span", "Length of a side", 20.0),
            HEIGHT,
            count("panels", "Panels along a side", 12.0, 1.0),
        ],
        make: sheets::hypar,
    },
    NewKind {
        id: "tube",
        label: "Tube",
        summary: "A round tower.",
        sizes: &[DIAMETER, length("height", "Height", 20.0), AROUND, ROWS],
        make: round::tube,
    },
    NewKind {
        id: "hexagons",
        label: "Hexagons",
        summary: "A low dome of hexagons over a rectangle.",
        sizes: &[
            LENGTH,
            WIDTH,
            from_zero("rise", "Rise", 3.0),
            length("size", "Width of a hexagon", 1.5),
        ],
        make: sheets::hexagons,
    },
    NewKind {
        id: "triangles",
        label: "Triangles",
        summary: "A low dome of triangles over a rectangle.",
        sizes: &[
            LENGTH,
            WIDTH,
            from_zero("rise", "Rise", 3.0),
            length("size", "Side of a triangle", 1.5),
        ],
        make: sheets::triangles,
    },
];

impl NewKind {
    /// The kind with this id.
    pub fn of(id: &str) -> Option<&'static NewKind> {
        NEW_KINDS.iter().find(|kind| kind.id == id)
    }
}
