//! Selecting along the mesh: connected parts, boundaries, loops, rings, strips, flat patches.

use super::elements::{Elements, Marks, items};
use super::request::{Mode, Selection};
use crate::math::{Vec3, cosine_and_sine_of_degrees, marked, polygon_sides, twice_vector_area};
use crate::mesh::{Point, components, edge_lines, strips};

impl Elements<'_> {
    /// Returns every connected part of the mesh with a marked element. A face connects its corners.
    pub(super) fn connected(&self, mode: Mode, seeds: &Marks) -> Marks {
        let edges = self.topology.edges().iter().map(|ends| &ends[..]);
        let part = components(self.count(Mode::Vertices), edges.chain(self.mesh.faces.iter()));
        let corners = self.corners(mode, seeds);
        let wanted = marked(part.len(), items(&corners).map(|vertex| part[vertex as usize]));
        let corners = part.iter().map(|&part| wanted[part as usize]).collect();
        self.with_corners(mode, &corners, true)
    }

    /// Returns the boundary loops that contain a vertex of a marked element, or all loops if
    /// nothing is marked: their vertices, their edges, or the faces along them.
    pub(super) fn boundary(&self, mode: Mode, seeds: &Marks) -> Marks {
        let corners = self.corners(mode, seeds);
        let anything = seeds.contains(&true);
        let mut marks = vec![false; self.count(mode)];
        for along in self.topology.boundary_loops().iter() {
            if anything && !along.iter().any(|&v| corners[v as usize]) {
                continue;
            }
            for [a, b] in polygon_sides(along) {
                let edge = self.topology.edge(a, b).filter(|&e| self.topology.is_boundary_edge(e));
                match (mode, edge) {
                    (Mode::Vertices, _) => marks[a as usize] = true,
                    (Mode::Edges, Some(edge)) => marks[edge as usize] = true,
                    (Mode::Faces, Some(edge)) => {
                        marks[self.topology.edge_faces().row(edge as usize)[0] as usize] = true;
                    }
                    // The two ends of an open chain share no edge.
                    (_, None) => {}
                }
            }
        }
        marks
    }

    /// Returns the straight lines of edges through selected edges, as in [`edge_lines`]; for
    /// vertices, the lines through selected neighbours.
    pub(super) fn edge_loops(&self, mode: Mode, from: &Selection) -> Marks {
        let seeds = self.marks(Mode::Edges, from);
        let mut marks = vec![false; self.count(mode)];
        for line in edge_lines(self.topology).iter() {
            let edges: Vec<u32> =
                line.windows(2).filter_map(|ends| self.topology.edge(ends[0], ends[1])).collect();
            if edges.iter().any(|&edge| seeds[edge as usize]) {
                let members = if mode == Mode::Vertices { line } else { &edges };
                members.iter().for_each(|&item| marks[item as usize] = true);
            }
        }
        marks
    }

    /// Returns the edges crossed by the strips of quads that cross a marked edge.
    pub(super) fn edge_rings(&self, seeds: &Marks) -> Marks {
        let crossed = self.crossed_edges();
        let met = crossed.iter().filter(|edges| edges.iter().any(|&e| seeds[e as usize]));
        marked(self.count(Mode::Edges), met.flatten())
    }

    /// Returns the strips of quads with the most marked faces: for one face both of its strips, for
    /// several in a row the strip that joins them.
    pub(super) fn strips(&self, seeds: &Marks) -> Marks {
        let mut best = 1;
        let mut chosen: Vec<Vec<u32>> = Vec::new();
        for edges in self.crossed_edges() {
            let mut faces = self.faces_between(&edges);
            faces.sort_unstable();
            faces.dedup();
            let hits = faces.iter().filter(|&&face| seeds[face as usize]).count();
            if hits > best {
                best = hits;
                chosen.clear();
            }
            if hits == best {
                chosen.push(faces);
            }
        }
        marked(self.count(Mode::Faces), chosen.into_iter().flatten())
    }

    /// Returns the edges crossed by each strip of quads.
    fn crossed_edges(&self) -> Vec<Vec<u32>> {
        let rows = strips(self.mesh, self.topology);
        let edges = |strip: &[u32]| {
            let pairs = strip.chunks_exact(2);
            pairs.filter_map(|ends| self.topology.edge(ends[0], ends[1])).collect()
        };
        rows.iter().map(edges).collect()
    }

    /// Returns the quads between consecutive edges, in a closed strip also the last and first.
    fn faces_between(&self, edges: &[u32]) -> Vec<u32> {
        let faces = |edge: u32| self.topology.edge_faces().row(edge as usize);
        let between = polygon_sides(edges).flat_map(|[a, b]| {
            let is_quad = |face: &u32| self.mesh.faces.row(*face as usize).len() == 4;
            faces(a).iter().copied().filter(move |f| faces(b).contains(f)).filter(is_quad)
        });
        between.collect()
    }

    /// Returns the faces connected to marked ones across edges with two faces, if the surface at
    /// `positions` bends there by at most `angle` degrees. A face of zero area counts as bent
    /// everywhere.
    pub(super) fn flat_patch(&self, seeds: &Marks, angle: f64, positions: &[Point]) -> Marks {
        let [least, _] = cosine_and_sine_of_degrees(angle);
        // Rounding must not separate coplanar faces.
        let least = least - 1e-12;
        let normals: Vec<Vec3<f64>> =
            self.mesh.faces.iter().map(|face| normal(face, positions)).collect();
        let mut marks = seeds.clone();
        let mut reached: Vec<u32> = items(seeds).collect();
        while let Some(face) = reached.pop() {
            let corners = self.mesh.faces.row(face as usize);
            for [a, b] in polygon_sides(corners) {
                let Some(edge) = self.topology.edge(a, b) else { continue };
                let &[first, second] = self.topology.edge_faces().row(edge as usize) else {
                    continue;
                };
                let next = if first == face { second } else { first };
                // Faces that run the same way along their edge have opposite orientations.
                let ascends = self.topology.edge_ascends(edge);
                let same_way = ascends[0] == ascends[1];
                let (n, m) = (normals[face as usize], normals[next as usize]);
                let cosine = if same_way { -n.dot(m) } else { n.dot(m) };
                if !marks[next as usize] && cosine >= least && m.dot(m) > 0.0 {
                    marks[next as usize] = true;
                    reached.push(next);
                }
            }
        }
        marks
    }
}

/// Returns the unit normal; zero if the face has no area.
fn normal(face: &[u32], positions: &[Point]) -> Vec3<f64> {
    let area = twice_vector_area(face.iter().map(|&v| Vec3::from(positions[v as usize])));
    let length = area.length();
    if length > 0.0 { area * (1.0 / length) } else { Vec3::zero() }
}
