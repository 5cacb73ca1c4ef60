//! Problems of a mesh or its file that do not stop reading, with counts and first lines by kind.

use crate::words;
use std::fmt;

/// Kinds of elements of a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ElementKind {
    /// A polygon.
    Face,
    /// A polyline.
    Curve,
    /// A tetrahedron.
    Tetrahedron,
}

/// Kinds of problems. A skipped element is skipped as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ProblemKind {
    /// A coordinate is missing or not a number. It is set to the middle of the extent of all
    /// vertices, so that the vertex keeps its number.
    MalformedCoordinate,
    /// A coordinate is infinite or NaN. It is replaced in the same way.
    NonFiniteCoordinate,
    /// A coordinate such as `0,046`, read as `0.046`.
    DecimalComma,
    /// A corner is not a whole number; the element is skipped.
    MalformedCorner(ElementKind),
    /// A corner is zero where vertices are counted from one; the element is skipped.
    CornerZero(ElementKind),
    /// A corner refers to a vertex that the file does not contain; the element is skipped.
    CornerOutOfRange(ElementKind),
    /// Fewer than three (faces), two (curves) or four (tetrahedra) distinct corners; skipped.
    TooFewCorners(ElementKind),
    /// The same corner twice in a row; it is kept once.
    RepeatedCorner(ElementKind),
    /// A face visits one of its corners twice, as around a hole; it is left as it is.
    SelfTouchingFace,
    /// A statement that is not part of the format; it is ignored.
    UnknownStatement,
    /// One `g` statement has more names than the limit; the rest is ignored.
    TooManyNames,
    /// The file ends within a line.
    CutOff,
    /// A vertex that no element uses.
    UnusedVertex,
    /// A boundary vertex that lies on another one without being joined to it.
    UnjoinedVertex,
    /// A face on the same vertices as an earlier one.
    DuplicateFace,
    /// An edge of more than two faces.
    NonManifoldEdge,
    /// An edge that both its faces traverse in the same direction.
    FlippedNeighbour,
}

impl ProblemKind {
    /// Whether it is of the mesh as a whole, which [`crate::mesh::diagnose`] finds, not of its file.
    pub(crate) fn is_of_mesh(self) -> bool {
        use ProblemKind::*;
        let of_mesh =
            [UnusedVertex, UnjoinedVertex, DuplicateFace, NonManifoldEdge, FlippedNeighbour];
        of_mesh.contains(&self)
    }

    /// Returns the counted element, singular and plural, and its defect; empty if the element says
    /// it all.
    fn description(self) -> (&'static str, &'static str, &'static str) {
        use ProblemKind::*;
        let (one, many) = match self {
            MalformedCoordinate | NonFiniteCoordinate | DecimalComma => ("vertex", "vertices"),
            MalformedCorner(element)
            | CornerZero(element)
            | CornerOutOfRange(element)
            | TooFewCorners(element)
            | RepeatedCorner(element) => match element {
                ElementKind::Face => ("face", "faces"),
                ElementKind::Curve => ("polyline", "polylines"),
                ElementKind::Tetrahedron => ("tetrahedron", "tetrahedra"),
            },
            SelfTouchingFace | DuplicateFace => ("face", "faces"),
            CutOff => ("line", "lines"),
            UnknownStatement => ("unknown statement", "unknown statements"),
            UnusedVertex => ("unused vertex", "unused vertices"),
            UnjoinedVertex => ("boundary vertex", "boundary vertices"),
            TooManyNames => ("`g` statement", "`g` statements"),
            NonManifoldEdge | FlippedNeighbour => ("edge", "edges"),
        };
        let defect = match self {
            MalformedCoordinate => {
                "with a coordinate that is not a number, set to the middle of the mesh"
            }
            NonFiniteCoordinate => {
                "with a coordinate that is not finite, set to the middle of the mesh"
            }
            DecimalComma => "with decimal commas, read as decimal points",
            MalformedCorner(_) => "with a corner that is not a vertex number, skipped",
            CornerZero(_) => "with vertex number 0, skipped: vertices count from 1",
            CornerOutOfRange(_) => "with the number of a missing vertex, skipped",
            TooFewCorners(ElementKind::Face) => "with fewer than three different corners, skipped",
            TooFewCorners(ElementKind::Curve) => "with fewer than two different vertices, skipped",
            TooFewCorners(ElementKind::Tetrahedron) => {
                "with fewer than four different corners, skipped"
            }
            RepeatedCorner(_) => "with the same vertex twice in a row, which is kept once",
            SelfTouchingFace => {
                "with the same vertex at two corners, as around a hole: exported unchanged and, as panels \
                 with holes, built, but neither shown nor solved"
            }
            UnknownStatement => "ignored",
            CutOff => "perhaps cut off by the end of the file: more may be missing",
            TooManyNames => "with too many names, of which the first are kept",
            UnusedVertex => "",
            UnjoinedVertex => "that lies on another without being joined to it: the seam can open",
            DuplicateFace => "on the same vertices as an earlier face",
            NonManifoldEdge => "with more than two faces",
            FlippedNeighbour => "whose two faces have opposite orientations",
        };
        (one, many, defect)
    }
}

/// Says why of these many faces, which a mesh has left as they are, no panels are made by the solver.
pub fn untouched_words(faces: usize) -> String {
    let faces = words::count(faces, "face has", "faces have");
    format!(
        "{faces} the same vertex at two corners, as around a hole: left unchanged, and not solved"
    )
}

/// All problems of one kind in a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshProblem {
    /// Kind of the problem.
    pub kind: ProblemKind,
    /// Number of occurrences, at least one.
    pub count: usize,
    /// Line of the first in the file, counted from one; `None` if the mesh is not from a file.
    pub line: Option<usize>,
    /// The text of that line, shortened; empty without a line.
    pub text: String,
}

impl fmt::Display for MeshProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (one, many, defect) = self.kind.description();
        f.write_str(&words::count(self.count, one, many))?;
        let defect = match self.kind {
            ProblemKind::UnjoinedVertex if self.count > 1 => {
                "that lie on others without being joined to them: the seam can open"
            }
            _ => defect,
        };
        if !defect.is_empty() {
            write!(f, " {defect}")?;
        }
        if let Some(line) = self.line {
            let first = if self.count == 1 { "at" } else { "first at" };
            write!(f, ", {first} line {line}: `{}`", self.text)?;
        }
        Ok(())
    }
}

/// Count and first line of each kind of problem found so far, sorted by kind.
#[derive(Default)]
pub(super) struct DiagnosticCounts(Vec<(ProblemKind, usize, Option<usize>)>);

impl DiagnosticCounts {
    /// Counts one problem.
    pub(super) fn add(&mut self, kind: ProblemKind, line: Option<usize>) {
        let place = self.0.partition_point(|&(other, ..)| other < kind);
        match self.0.get_mut(place) {
            Some((same, count, first)) if *same == kind => {
                *count += 1;
                *first = (*first).min(line);
            }
            _ => self.0.insert(place, (kind, 1, line)),
        }
    }

    /// Returns the problems by kind; `text` returns the text of a line.
    pub(super) fn problems(self, text: impl Fn(usize) -> String) -> Vec<MeshProblem> {
        let problems = self.0.into_iter();
        let text = |line: Option<usize>| line.map(&text).unwrap_or_default();
        problems
            .map(|(kind, count, line)| MeshProblem { kind, count, line, text: text(line) })
            .collect()
    }
}
