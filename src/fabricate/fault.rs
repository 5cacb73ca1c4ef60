//! Reasons why something cannot be built, and the products that are still available.

use crate::mesh::Mesh;
use crate::words::{self, UNITS};
use std::fmt;

/// One sentence: the problem, and what is available nevertheless.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub String);

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

impl Fault {
    /// The reason as a sentence.
    pub fn sentence(&self) -> String {
        format!("{}.", words::sentence(&self.0))
    }

    /// Points, curves and tetrahedra have nothing to cut.
    pub(super) fn no_panels(mesh: &Mesh) -> Fault {
        let what = match (mesh.curves.is_empty(), mesh.tets.is_empty()) {
            (false, true) => "curves",
            (true, false) => "tetrahedra",
            (false, false) => "curves and tetrahedra",
            (true, true) => "points",
        };
        Fault(format!(
            "the model has {what} but no faces: there is nothing to cut, expected a surface of panels"
        ))
    }

    /// A corner whose position is not in the file.
    pub(super) fn unplaced(vertex: u32) -> Fault {
        Fault(format!(
            "a coordinate of vertex {vertex} in the file is not a number, and where the vertex is now is a guess: nothing is built of it. Correct the file, or delete the faces at the vertex"
        ))
    }

    /// A unit of length that is not known.
    pub(super) fn unknown_unit(symbol: &str) -> Fault {
        let known = UNITS.map(|unit| unit.symbol).join(" or ");
        Fault(format!(
            "the unit {symbol:?} is not known, so parts would have a wrong size: expected {known}"
        ))
    }

    /// A kerf that outlines of paper do not allow for.
    pub(super) fn wide_kerf(kerf: f64) -> Fault {
        let kerf = words::millimetres_limit(kerf);
        Fault(format!(
            "a cut that is {kerf} wide is too wide for the slits of paper models: outlines are drawn without it. Cut them with a laser or a knife"
        ))
    }

    /// Faces of the mesh that visit a vertex twice and are no panels with holes.
    pub(super) fn untouched(faces: usize) -> Fault {
        let faces = words::count(faces, "face has", "faces have");
        Fault(format!(
            "{faces} the same vertex at two corners, and not only at bridges to holes: left unchanged, not built"
        ))
    }

    /// A closed part of the surface whose panels face inwards; `all` parts do, or only some.
    pub(super) fn inside_out(all: bool) -> Fault {
        let words = match all {
            true => {
                "the surface is closed and its panels face inwards, so what is called outside here is its inside: apply Flip faces, in Edit mesh"
            }
            false => {
                "a closed part of the surface has panels that face inwards, so what is called outside there is its inside: turn its faces around in the program that it comes from"
            }
        };
        Fault(words.to_owned())
    }

    /// Names by rows and columns without rows and columns.
    pub(super) fn no_rows() -> Fault {
        Fault(
            "names by rows and columns need one grid of quads, which this is not: panels have numbers instead"
                .to_owned(),
        )
    }

    /// The surface has only one side, such as a Moebius strip.
    pub(super) fn one_sided([a, b]: [u32; 2]) -> Fault {
        Fault(format!(
            "the surface has one side only (seen at the edge of vertices {a} and {b}), so it has no outside: panels can still be cut and folded; offsets and beams are not available"
        ))
    }

    /// Edges with more than two panels.
    pub(super) fn crowded_edges(edges: usize) -> Fault {
        let edges = match edges {
            1 => "1 edge has".to_owned(),
            many => format!("{many} edges have"),
        };
        Fault(format!(
            "{edges} more than two panels, so the surface has no outside there: panels can still be cut and folded; offsets and beams are not available"
        ))
    }

    /// More pages than are written.
    pub(super) fn too_many_pages(pages: u64) -> Fault {
        Fault(format!(
            "the sheets would be {pages} pages: in the PDF each sheet is one page of its own size instead"
        ))
    }

    /// Material of which no slots can be cut: without thickness, or thinner than the cut is wide.
    pub(super) fn no_slots(has_thickness: bool) -> Fault {
        let why = match has_thickness {
            true => "the kerf is at least as wide as its thickness with the clearance",
            false => "its thickness is 0",
        };
        Fault(format!(
            "the slots of node discs cannot be cut from this material: {why}, so there are no discs"
        ))
    }

    /// There are no quads for strips to follow.
    pub(super) fn no_strips() -> Fault {
        Fault(
            "strips need panels with four edges, and there are none: nets are made instead"
                .to_owned(),
        )
    }

    /// A number of panels that are folded over, of which the first has this name.
    pub(super) fn folded_over(panels: usize, first: &str) -> Fault {
        let what = match panels {
            1 => {
                format!("panel {first} is folded over, facing the opposite way to its neighbours")
            }
            many => format!(
                "{many} panels are folded over (the first is {first}), facing the opposite way to their neighbours"
            ),
        };
        Fault(format!(
            "{what}: panels can still be cut and folded; offsets and beams are not available"
        ))
    }
}
