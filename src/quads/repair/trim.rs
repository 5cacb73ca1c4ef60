//! Panels at a boundary that cuts the grid: short edges are contracted, and panels of too many
//! corners divided, so that panels have 3 to 5 corners.

use super::quadrangulate::deviation;
use crate::math::{Vec3, twice_vector_area};
use crate::quads::extract::Node;

/// Edges at the boundary shorter than this fraction of a panel are contracted.
const SHORT: f64 = 0.3;
/// The most corners of a panel.
const MOST: usize = 5;

/// Contracts short edges at the boundary, and divides panels there with too many corners. `size` is
/// the side of a panel. Corners of the boundary stay.
pub(in crate::quads) fn trim(nodes: &[Node], faces: Vec<Vec<usize>>, size: f64) -> Vec<Vec<usize>> {
    let mut around = vec![Vec::new(); nodes.len()];
    for (index, face) in faces.iter().enumerate() {
        face.iter().for_each(|&node| around[node].push(index));
    }
    let mut trimming = Trimming { nodes, faces, around };
    for [a, b] in trimming.short_edges(SHORT * size) {
        trimming.contract(a, b);
    }
    let mut faces: Vec<Vec<usize>> = Vec::new();
    let at_boundary = |face: &[usize]| face.iter().any(|&node| nodes[node].boundary);
    for face in trimming.faces.into_iter().filter(|face| !face.is_empty()) {
        if at_boundary(&face) {
            divide(nodes, face, &mut faces);
        } else {
            faces.push(face);
        }
    }
    faces
}

struct Trimming<'a> {
    nodes: &'a [Node],
    /// Empty where a face vanished.
    faces: Vec<Vec<usize>>,
    /// `#N`: the faces at each node.
    around: Vec<Vec<usize>>,
}

impl Trimming<'_> {
    fn at(&self, node: usize) -> Vec3<f64> {
        self.nodes[node].position
    }

    /// The edges with an end on the boundary that are shorter than a length, the shortest first.
    fn short_edges(&self, length: f64) -> Vec<[usize; 2]> {
        let mut edges: Vec<(f64, [usize; 2])> = Vec::new();
        for face in &self.faces {
            for k in 0..face.len() {
                let (a, b) = (face[k], face[(k + 1) % face.len()]);
                let distance = (self.at(b) - self.at(a)).length();
                let at_boundary = self.nodes[a].boundary || self.nodes[b].boundary;
                if at_boundary && distance < length {
                    edges.push((distance, [a.min(b), a.max(b)]));
                }
            }
        }
        edges.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        edges.dedup();
        edges.into_iter().map(|(_, ends)| ends).collect()
    }

    /// Contracts an edge, if the surface stays one and no face turns over: to a corner of the
    /// boundary, else to the boundary.
    fn contract(&mut self, a: usize, b: usize) {
        let rank = |node: usize| (self.nodes[node].corner, self.nodes[node].boundary);
        let (kept, gone) = if rank(a) >= rank(b) { (a, b) } else { (b, a) };
        if self.nodes[gone].corner || !self.may_contract(kept, gone) {
            return;
        }
        for index in std::mem::take(&mut self.around[gone]) {
            let face = renamed(&self.faces[index], gone, kept);
            if face.len() < 3 {
                for &node in &face {
                    self.around[node].retain(|&other| other != index);
                }
                self.faces[index].clear();
                continue;
            }
            if !self.around[kept].contains(&index) {
                self.around[kept].push(index);
            }
            self.faces[index] = face;
        }
    }

    fn may_contract(&self, kept: usize, gone: usize) -> bool {
        let has = |index: &&usize| self.faces[**index].contains(&gone);
        let shared: Vec<usize> = self.around[kept].iter().filter(has).copied().collect();
        let sides = [[kept, gone], [gone, kept]];
        let is_side = |index: usize, [from, to]: [usize; 2]| {
            let face = &self.faces[index];
            (0..face.len()).any(|k| face[k] == from && face[(k + 1) % face.len()] == to)
        };
        let count = sides.map(|side| shared.iter().filter(|&&f| is_side(f, side)).count());
        // An edge of one face is on the boundary; between two boundary nodes it must be.
        let edge = match count {
            [1, 1] => !(self.nodes[kept].boundary && self.nodes[gone].boundary),
            [1, 0] | [0, 1] => true,
            _ => false,
        };
        if !edge || shared.len() != count[0] + count[1] {
            return false;
        }
        // Common neighbours only over triangles that vanish.
        let vanish = |&&f: &&usize| self.faces[f].len() == 3;
        let tips = shared.iter().filter(vanish).flat_map(|&f| self.faces[f].clone());
        let tips: Vec<usize> = tips.filter(|&node| node != kept && node != gone).collect();
        let neighbours = self.neighbours(gone);
        let of_kept = self.neighbours(kept);
        if neighbours.iter().any(|node| of_kept.contains(node) && !tips.contains(node)) {
            return false;
        }
        self.around[gone].iter().all(|&index| {
            let face = renamed(&self.faces[index], gone, kept);
            let area = |face: &[usize]| twice_vector_area(face.iter().map(|&node| self.at(node)));
            face.len() < 3 || area(&face).dot(area(&self.faces[index])) > 0.0
        })
    }

    fn neighbours(&self, node: usize) -> Vec<usize> {
        let mut found = Vec::new();
        for &index in &self.around[node] {
            let face = &self.faces[index];
            let count = face.len();
            for k in (0..count).filter(|&k| face[k] == node) {
                found.extend([face[(k + 1) % count], face[(k + count - 1) % count]]);
            }
        }
        found
    }
}

/// A face with one node in the place of another, once.
fn renamed(face: &[usize], gone: usize, kept: usize) -> Vec<usize> {
    let has_both = face.contains(&kept);
    let name = |&node: &usize| match node == gone {
        true if has_both => None,
        true => Some(kept),
        false => Some(node),
    };
    face.iter().filter_map(name).collect()
}

/// Cuts quads off a face until it has few enough corners, each the nearest to a square.
fn divide(nodes: &[Node], mut face: Vec<usize>, into: &mut Vec<Vec<usize>>) {
    while face.len() > MOST {
        let count = face.len();
        let normal = twice_vector_area(face.iter().map(|&node| nodes[node].position));
        let quad = |k: usize| [0, 1, 2, 3].map(|next| face[(k + next) % count]);
        let cost = |k: usize| deviation(quad(k).map(|node| nodes[node].position), normal);
        let costs: Vec<f64> = (0..count).map(cost).collect();
        let best = (0..count).min_by(|&i, &j| costs[i].total_cmp(&costs[j])).unwrap_or(0);
        into.push(quad(best).to_vec());
        let gone = [1, 2].map(|next| face[(best + next) % count]);
        face.retain(|node| !gone.contains(node));
    }
    into.push(face);
}
