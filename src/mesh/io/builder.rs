//! Builder that the readers of all formats use to add vertices and elements; and the result of
//! reading: a mesh with its problems and notes, or an error.

use super::lines::{excerpt, lines};
use super::number::{Numbering, coordinate};
use crate::mesh::diagnostics::{coincident, examine};
use crate::mesh::problem::DiagnosticCounts;
use crate::mesh::{ElementKind, Mesh, MeshProblem, Point, ProblemKind};
use crate::words;

/// The mesh so far, with the source lines of its vertices and faces.
#[derive(Default)]
pub(crate) struct MeshBuilder {
    pub(crate) mesh: Mesh,
    pub(crate) counts: DiagnosticCounts,
    pub(crate) notes: Vec<String>,
    /// How a vertex is written in this format, for the message that there is none.
    pub(crate) example: &'static str,
    vertex_lines: Vec<u32>,
    face_lines: Vec<u32>,
    /// Elements deferred until all vertices are read: kind, line, and end in `deferred_corners`.
    deferred: Vec<(ElementKind, Option<u32>, u32)>,
    deferred_corners: Vec<Option<i32>>,
    row: Vec<u32>,
    /// `#V`: number, from one, of the last face or tetrahedron with this corner.
    visited: Vec<u32>,
    faces_seen: u32,
    /// The line of the last vertex or element that is not whole.
    last_partial: Option<usize>,
}

impl MeshBuilder {
    /// Appends a vertex. Bad coordinates are NaN until [`MeshBuilder::finish`].
    pub(crate) fn vertex(&mut self, words: [&str; 3], line: usize) {
        self.vertex_of(words.map(coordinate), Some(line));
    }

    /// Appends a vertex of these coordinates, each with its problem, if any; a binary file has no
    /// lines.
    pub(crate) fn vertex_of(
        &mut self,
        coordinates: [(f64, Option<ProblemKind>); 3],
        line: Option<usize>,
    ) {
        let problems = coordinates.map(|(_, problem)| problem);
        for (i, problem) in problems.iter().enumerate() {
            if let Some(new) = problem.filter(|_| !problems[..i].contains(problem)) {
                self.counts.add(new, line);
                if new == ProblemKind::MalformedCoordinate {
                    self.last_partial = line;
                }
            }
        }
        self.mesh.positions.push(coordinates.map(|(x, _)| x));
        self.vertex_lines.extend(line.map(|line| line as u32));
    }

    /// Appends an element on existing vertices and returns its index among the elements of its
    /// kind. If it has to be skipped, counts the problem and returns `None`. A binary file has no lines.
    pub(crate) fn element(
        &mut self,
        element: ElementKind,
        numbers: impl Iterator<Item = Option<i32>>,
        numbering: Numbering,
        line: Option<usize>,
    ) -> Option<u32> {
        match self.resolve(element, numbers, numbering) {
            Ok(true) => self.counts.add(ProblemKind::RepeatedCorner(element), line),
            Ok(false) => {}
            Err(problem) => {
                self.counts.add(problem, line);
                match problem {
                    ProblemKind::SelfTouchingFace => self.mesh.untouched.push(&self.row),
                    ProblemKind::MalformedCorner(_) | ProblemKind::TooFewCorners(_) => {
                        self.last_partial = line;
                    }
                    _ => {}
                }
                return None;
            }
        }
        let index = match element {
            ElementKind::Face => {
                self.mesh.faces.push(&self.row);
                self.face_lines.extend(line.map(|line| line as u32));
                self.mesh.faces.len()
            }
            ElementKind::Curve => {
                self.mesh.curves.push(&self.row);
                self.mesh.curves.len()
            }
            ElementKind::Tetrahedron => {
                self.mesh.tets.push([self.row[0], self.row[1], self.row[2], self.row[3]]);
                self.mesh.tets.len()
            }
        };
        Some(index as u32 - 1)
    }

    /// Writes the corners of an element to `row`; returns whether a repeated corner was dropped.
    fn resolve(
        &mut self,
        element: ElementKind,
        numbers: impl Iterator<Item = Option<i32>>,
        numbering: Numbering,
    ) -> Result<bool, ProblemKind> {
        let MeshBuilder { row, mesh, visited, .. } = self;
        let vertices = mesh.positions.len();
        row.clear();
        for number in numbers {
            row.push(numbering.vertex(number, vertices, element)?);
        }
        let corners = row.len();
        row.dedup();
        if element == ElementKind::Face && row.len() > 1 && row.first() == row.last() {
            row.pop();
        }
        let fewest = match element {
            ElementKind::Face => 3,
            ElementKind::Curve => 2,
            ElementKind::Tetrahedron => 4,
        };
        if row.len() < fewest {
            return Err(ProblemKind::TooFewCorners(element));
        }
        if element != ElementKind::Curve {
            self.faces_seen += 1;
            visited.resize(vertices, 0);
            let revisits = |&v: &u32| {
                std::mem::replace(&mut visited[v as usize], self.faces_seen) == self.faces_seen
            };
            if row.iter().any(revisits) {
                return Err(match element {
                    ElementKind::Face => ProblemKind::SelfTouchingFace,
                    _ => ProblemKind::TooFewCorners(element),
                });
            }
        }
        Ok(row.len() < corners)
    }

    /// Stores a corner of the next deferred element: see [`MeshBuilder::settle`].
    pub(crate) fn defer_corner(&mut self, number: Option<i32>) {
        self.deferred_corners.push(number);
    }

    /// Stores a deferred element whose corners are those stored since the last one.
    pub(crate) fn defer_element(&mut self, element: ElementKind, line: Option<usize>) {
        let line = line.map(|line| line as u32);
        self.deferred.push((element, line, self.deferred_corners.len() as u32));
    }

    pub(crate) fn deferred_corners(&self) -> impl Iterator<Item = i32> {
        self.deferred_corners.iter().copied().flatten()
    }

    /// Appends the deferred elements, once all vertices are read.
    pub(crate) fn settle(&mut self, numbering: Numbering) {
        let corners = std::mem::take(&mut self.deferred_corners);
        let mut begin = 0;
        for (element, line, end) in std::mem::take(&mut self.deferred) {
            let row = corners[begin..end as usize].iter().copied();
            self.element(element, row, numbering, line.map(|line| line as usize));
            begin = end as usize;
        }
    }

    /// Counts the last line of a `text` that ends without a line end in an element which is not whole,
    /// or has fewer corners than all the others.
    pub(crate) fn examine_end(&mut self, text: &str) {
        let Some(line) = unfinished_line(text) else { return };
        let is_face = self.face_lines.last() == Some(&(line as u32));
        let corners: Vec<usize> = self.mesh.faces.iter().map(<[u32]>::len).collect();
        let last = corners.split_last().filter(|_| is_face);
        let is_shorter = last
            .is_some_and(|(last, others)| others.iter().min().is_some_and(|least| last < least));
        if self.last_partial == Some(line) || is_shorter {
            self.counts.add(ProblemKind::CutOff, Some(line));
        }
    }

    /// Returns the mesh with its problems and notes, or a fault if it has no usable vertices.
    pub(crate) fn finish(mut self, text: &str) -> Result<Read, ReadError> {
        let positions = &mut self.mesh.positions;
        if positions.is_empty() {
            let expected = format!("expected at least one{}", self.example);
            return Err(ReadError::whole(format!("the file has no vertices: {expected}")));
        }
        if positions.as_flattened().iter().all(|x| x.is_nan()) {
            return Err(ReadError::whole("no coordinate in the file is a number"));
        }
        let mut coincident = coincident(positions);
        let is_unplaced = |v: &u32| positions[*v as usize].iter().any(|x| x.is_nan());
        self.mesh.unplaced = (0..positions.len() as u32).filter(is_unplaced).collect();
        fill_in(positions);
        positions.shrink_to_fit();
        let Self { mesh, vertex_lines, face_lines, counts, .. } = &mut self;
        let at_seams = examine(mesh, vertex_lines, face_lines, counts);
        // Those at seams, ascending, are reported as a problem.
        coincident.retain(|&v| at_seams.binary_search(&(v as u32)).is_err());
        let on_coincident = coincident.iter().min().map(|&first| {
            let vertices = words::count(coincident.len(), "vertex lies", "vertices lie");
            let line = self.vertex_lines.get(first);
            let place = line.map_or_else(String::new, |line| format!(", first at line {line}"));
            self.notes.push(format!("{vertices} exactly on an earlier one{place}"));
            self.notes.len() - 1
        });
        let problems = self.counts.problems(|line| excerpt(text, line));
        Ok(Read { mesh: self.mesh, problems, notes: self.notes, on_coincident })
    }
}

/// Returns the number of the last line if no line end follows it.
fn unfinished_line(text: &str) -> Option<usize> {
    let has_end = text.ends_with(['\n', '\r']);
    lines(text).last().map(|(number, _)| number).filter(|_| !has_end)
}

/// Replaces every NaN coordinate by the middle of the extent, so that vertices keep their numbers
/// and the mesh keeps its size.
fn fill_in(positions: &mut [Point]) {
    for axis in 0..3 {
        let extent = positions.iter().map(|p| p[axis]).filter(|x| !x.is_nan());
        let (low, high) = extent
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let middle = if low <= high { 0.5 * low + 0.5 * high } else { 0.0 };
        for x in positions.iter_mut().map(|p| &mut p[axis]).filter(|x| x.is_nan()) {
            *x = middle;
        }
    }
}

/// A mesh read from a file, with problems and notes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Read {
    /// The mesh.
    pub mesh: Mesh,
    /// Problems of the file or the mesh that did not stop reading.
    pub problems: Vec<MeshProblem>,
    /// Notes, a sentence each, such as ignored statements and assumptions made.
    pub notes: Vec<String>,
    /// The place in the notes of that on coincident vertices, which is out of date once they are welded.
    pub(crate) on_coincident: Option<usize>,
}

/// Reason why a mesh file was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from one; `None` if the file as a whole is at fault.
    pub line: Option<usize>,
    /// The text of that line, shortened; empty if the file as a whole is at fault.
    pub text: String,
    /// The fault, and what was expected instead.
    pub message: String,
}

impl ReadError {
    /// Returns a fault at this line, or of the file as a whole; `read` adds the name and the text.
    pub(crate) fn at(line: Option<usize>, message: impl Into<String>) -> Self {
        ReadError { line, message: message.into(), file: String::new(), text: String::new() }
    }

    pub(crate) fn whole(message: impl Into<String>) -> Self {
        ReadError::at(None, message)
    }
}

impl std::fmt::Display for ReadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: `{}`: {}", self.file, self.text, self.message),
            None => write!(f, "{}: {}", self.file, self.message),
        }
    }
}

impl std::error::Error for ReadError {}
