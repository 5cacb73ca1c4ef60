//! Vertices, edges and faces as marks: one per element of the mesh, in its order.

use super::request::{Mode, Selection};
use crate::math::marked;
use crate::mesh::{Mesh, Topology};

/// Whether each element of one kind is marked.
pub(super) type Marks = Vec<bool>;

/// The elements of a mesh.
pub(super) struct Elements<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) topology: &'a Topology,
}

pub(super) fn not(mut marks: Marks) -> Marks {
    marks.iter_mut().for_each(|mark| *mark = !*mark);
    marks
}

/// Returns the marked elements, ascending.
pub(super) fn items(marks: &Marks) -> impl Iterator<Item = u32> + '_ {
    (0..).zip(marks).filter(|(_, mark)| **mark).map(|(item, _)| item)
}

pub(super) fn selection(mode: Mode, marks: &Marks) -> Selection {
    let mut selection = Selection::default();
    let chosen = match mode {
        Mode::Vertices => &mut selection.vertices,
        Mode::Edges => &mut selection.edges,
        Mode::Faces => &mut selection.faces,
    };
    chosen.extend(items(marks));
    selection
}

impl<'a> Elements<'a> {
    pub(super) fn new(mesh: &'a Mesh, topology: &'a Topology) -> Self {
        Elements { mesh, topology }
    }

    pub(super) fn count(&self, mode: Mode) -> usize {
        match mode {
            Mode::Vertices => self.mesh.positions.len(),
            Mode::Edges => self.topology.edges().len(),
            Mode::Faces => self.mesh.faces.len(),
        }
    }

    /// Returns the vertices of an element; a vertex is its own.
    fn vertices_of(&self, mode: Mode, item: u32) -> Vec<u32> {
        match mode {
            Mode::Vertices => vec![item],
            Mode::Edges => self.topology.edges()[item as usize].to_vec(),
            Mode::Faces => self.mesh.faces.row(item as usize).to_vec(),
        }
    }

    /// Returns the vertices of all marked elements.
    pub(super) fn corners(&self, mode: Mode, marks: &Marks) -> Marks {
        let corners = items(marks).flat_map(|item| self.vertices_of(mode, item));
        marked(self.count(Mode::Vertices), corners)
    }

    /// Returns the elements of a kind with any (or, with `all`, only) marked vertices.
    pub(super) fn with_corners(&self, mode: Mode, corners: &Marks, all: bool) -> Marks {
        (0..self.count(mode) as u32)
            .map(|item| {
                let vertices = self.vertices_of(mode, item);
                let mut marks = vertices.iter().map(|&v| corners[v as usize]);
                if all { marks.all(|mark| mark) } else { marks.any(|mark| mark) }
            })
            .collect()
    }

    /// Converts a selection to one kind of element: its elements of that kind, and those whose
    /// vertices all belong to the rest of the selection. As vertices: all its vertices.
    pub(super) fn marks(&self, mode: Mode, selection: &Selection) -> Marks {
        let Selection { vertices, edges, faces } = selection;
        let mut corners = marked(self.count(Mode::Vertices), vertices);
        for (other, items) in [(Mode::Edges, edges), (Mode::Faces, faces)] {
            // A face between selected faces is not selected itself.
            if other != mode {
                for vertex in items.iter().flat_map(|&item| self.vertices_of(other, item)) {
                    corners[vertex as usize] = true;
                }
            }
        }
        let own = match mode {
            Mode::Vertices => return corners,
            Mode::Edges => edges,
            Mode::Faces => faces,
        };
        let mut marks = self.with_corners(mode, &corners, true);
        own.iter().for_each(|&item| marks[item as usize] = true);
        marks
    }

    /// The marked elements and their neighbours: vertices along an edge, others at a vertex.
    pub(super) fn around(&self, mode: Mode, marks: &Marks) -> Marks {
        if mode != Mode::Vertices {
            return self.with_corners(mode, &self.corners(mode, marks), false);
        }
        let mut grown = marks.clone();
        for &[a, b] in self.topology.edges() {
            if marks[a as usize] || marks[b as usize] {
                (grown[a as usize], grown[b as usize]) = (true, true);
            }
        }
        grown
    }
}
