//! Vertices, edges and faces as marks: one per element of the mesh, in its order.

use super::request::{Mode, Selection};
use crate::mesh::{Mesh, Topology};

/// Whether each element of one kind is meant.
pub(super) type Marks = Vec<bool>;

/// The elements of a mesh.
pub(super) struct Elements<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) topology: &'a Topology,
}

/// The others.
pub(super) fn not(mut marks: Marks) -> Marks {
    marks.iter_mut().for_each(|mark| *mark = !*mark);
    marks
}

/// Marks of `count` elements.
pub(super) fn marked(count: usize, items: impl IntoIterator<Item = u32>) -> Marks {
    let mut marks = vec![false; count];
    items.into_iter().for_each(|item| marks[item as usize] = true);
    marks
}

/// The marked elements, ascending.
pub(super) fn items(marks: &Marks) -> impl Iterator<Item = u32> + '_ {
    (0..).zip(marks).filter(|(_, mark)| **mark).map(|(item, _)| item)
}

/// The marked elements as a selection.
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

    /// How many elements there are of a kind.
    pub(super) fn count(&self, mode: Mode) -> usize {
        match mode {
            Mode::Vertices => self.mesh.positions.len(),
            Mode::Edges => self.topology.edges().len(),
            Mode::Faces => self.mesh.faces.len(),
        }
    }

    /// The vertices of an element; one vertex of itself.
    fn vertices_of(&self, mode: Mode, item: u32) -> Vec<u32> {
        match mode {
            Mode::Vertices => vec![item],
            Mode::Edges => self.topology.edges()[item as usize].to_vec(),
            Mode::Faces => self.mesh.faces.row(item as usize).to_vec(),
        }
    }

    /// The vertices of everything that is marked.
    pub(super) fn corners(&self, mode: Mode, marks: &Marks) -> Marks {
        let corners = items(marks).flat_map(|item| self.vertices_of(mode, item));
        marked(self.count(Mode::Vertices), corners)
    }

    /// The elements of a kind any (all, with `all`) of whose vertices are marked.
    pub(super) fn with_corners(&self, mode: Mode, corners: &Marks, all: bool) -> Marks {
        (0..self.count(mode) as u32)
            .map(|item| {
                let vertices = self.vertices_of(mode, item);
                let mut marks = vertices.iter().map(|&v| corners[v as usize]);
                if all { marks.all(|mark| mark) } else { marks.any(|mark| mark) }
            })
            .collect()
    }

    /// A selection in one kind of element: those of that kind, and those all of whose vertices are in
    /// the rest of it. As vertices: all vertices of it.
    pub(super) fn marks(&self, mode: Mode, selection: &Selection) -> Marks {
        let Selection { vertices, edges, faces } = selection;
        let mut corners = marked(self.count(Mode::Vertices), vertices.iter().copied());
        for (other, items) in [(Mode::Edges, edges), (Mode::Faces, faces)] {
            // What is of the kind itself stays as it is: not every face between selected ones is.
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

    /// The marked elements and their neighbours: vertices along an edge, edges and faces at a vertex.
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
