//! The triangles around each vertex.

use crate::quads::grid_map::{Side, Triangulation};

/// For each vertex its corners, counterclockwise: a closed fan, or from boundary to boundary.
pub(super) struct Fans {
    /// `#V + 1`.
    offsets: Vec<usize>,
    corners: Vec<Side>,
    closed: Vec<bool>,
}

impl Fans {
    /// Walks around each vertex; a closed fan begins at the corner of lowest index.
    pub(super) fn of(surface: &Triangulation) -> Fans {
        let count = surface.positions.len();
        let mut first: Vec<Option<Side>> = vec![None; count];
        for side in surface.sides() {
            let place = &mut first[surface.corner(side.triangle, side.side)];
            // The clockwise end of an open fan has no neighbour over the side that begins here.
            if place.is_none() || surface.across(side).is_none() {
                *place = Some(side);
            }
        }
        let mut fans = Fans { offsets: vec![0], corners: Vec::new(), closed: vec![false; count] };
        for (v, first) in first.into_iter().enumerate() {
            let mut corner = first;
            while let Some(at) = corner {
                fans.corners.push(at);
                corner = next(surface, at);
                if corner == first {
                    fans.closed[v] = true;
                    break;
                }
            }
            fans.offsets.push(fans.corners.len());
        }
        fans
    }

    /// The corners at a vertex, counterclockwise, each as the side that begins at it.
    pub(super) fn of_vertex(&self, v: usize) -> &[Side] {
        &self.corners[self.offsets[v]..self.offsets[v + 1]]
    }

    /// Whether the fan of a vertex goes all around it.
    pub(super) fn is_closed(&self, v: usize) -> bool {
        self.closed[v]
    }
}

/// The next corner counterclockwise around the vertex of a corner.
fn next(surface: &Triangulation, Side { triangle, side }: Side) -> Option<Side> {
    surface.across(Side { triangle, side: (side + 2) % 3 })
}
