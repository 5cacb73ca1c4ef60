//! Reads and writes STL: triangles without common vertices, as text or binary. Corners at equal
//! positions are one vertex. Each `solid` of a text file with several is an object.

use super::builder::{MeshBuilder, ReadFault};
use super::lines::{decode, lines, words};
use super::number::{Numbering, coordinate};
use crate::math::{Vec3, triangles_in_space};
use crate::mesh::{ElementKind, Group, GroupKeyword, Mesh, Point, ProblemKind};
use crate::words::count;
use std::borrow::Cow;
use std::collections::HashMap;

/// Bytes of a binary file before its triangles: a free header, and their number.
const HEADER: usize = 84;
/// Bytes of a triangle: normal and corners as `f32`, and two free bytes.
const TRIANGLE: usize = 50;

/// A coordinate, and its problem, if any.
type Coordinate = (f64, Option<ProblemKind>);

/// Reads a file. Many binary files begin as text does.
pub(super) fn read(bytes: &[u8]) -> Result<MeshBuilder, ReadFault> {
    let triangles = bytes.get(HEADER - 4..HEADER).and_then(|count| count.try_into().ok());
    let triangles = triangles.map(|count| u32::from_le_bytes(count) as usize);
    let is_whole = triangles.is_some_and(|count| HEADER + count * TRIANGLE == bytes.len());
    let mut corners = Corners::default();
    if !is_whole && is_solid(&beginning(bytes)) {
        read_text(&decode(bytes), &mut corners)?;
    } else {
        read_binary(bytes, triangles.unwrap_or(0), &mut corners)?;
    }
    Ok(corners.finish())
}

/// Whether a file is one, by its first bytes.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    let text = beginning(bytes);
    let is_facet = |word: &str| word.eq_ignore_ascii_case("facet");
    is_solid(&text) && text.split_ascii_whitespace().any(is_facet)
}

/// The beginning of a file as text: of a large binary file, no more is decoded.
fn beginning(bytes: &[u8]) -> Cow<'_, str> {
    decode(&bytes[..bytes.len().min(1024)])
}

/// Whether a text begins as STL does.
fn is_solid(text: &str) -> bool {
    text.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case("solid"))
}

fn read_binary(bytes: &[u8], triangles: usize, corners: &mut Corners) -> Result<(), ReadFault> {
    let body = bytes.get(HEADER..).ok_or_else(|| {
        ReadFault::whole("this is no STL file: expected `solid`, or 84 bytes and triangles")
    })?;
    if body.len() / TRIANGLE < triangles {
        let there = body.len() / TRIANGLE;
        return Err(ReadFault::whole(format!(
            "the file ends after {there} of {triangles} triangles: it is not whole, or no STL file"
        )));
    }
    for triangle in body.chunks_exact(TRIANGLE).take(triangles) {
        let (numbers, _) = triangle[12..48].as_chunks::<4>();
        for corner in numbers.chunks_exact(3) {
            let number = |i: usize| of_number(f64::from(f32::from_le_bytes(corner[i])));
            corners.push([number(0), number(1), number(2)], None);
        }
        corners.close(None);
    }
    Ok(())
}

/// A coordinate of a binary file.
pub(super) fn of_number(x: f64) -> Coordinate {
    match x.is_finite() {
        true => (x, None),
        false => (f64::NAN, Some(ProblemKind::NonFiniteCoordinate)),
    }
}

fn read_text(text: &str, corners: &mut Corners) -> Result<(), ReadFault> {
    let mut is_open = false;
    for (line, text) in lines(text) {
        let mut words = words(text);
        let Some(word) = words.next() else { continue };
        match word.to_ascii_lowercase().as_str() {
            "solid" => corners.begin(&words.collect::<Vec<_>>().join(" ")),
            "vertex" => {
                let place = std::array::from_fn(|_| coordinate(words.next().unwrap_or_default()));
                corners.push(place, Some(line));
                is_open = true;
            }
            "endloop" | "endfacet" if is_open => {
                corners.close(Some(line));
                is_open = false;
            }
            _ => {}
        }
    }
    match is_open {
        true => Err(ReadFault::whole("the file ends within a triangle: it is not whole")),
        false => Ok(()),
    }
}

/// The triangles so far, with one vertex for equal positions.
#[derive(Default)]
struct Corners {
    builder: MeshBuilder,
    vertices: HashMap<[u64; 3], u32>,
    row: Vec<u32>,
    /// Number of corners in all.
    read: usize,
    groups: Vec<Group>,
}

impl Corners {
    /// Appends a corner to the triangle.
    fn push(&mut self, place: [Coordinate; 3], line: Option<usize>) {
        self.read += 1;
        let new = self.builder.mesh.positions.len() as u32;
        // Adding zero turns -0 into +0. What is no number is equal to nothing.
        let key = place.map(|(x, _)| (x + 0.0).to_bits());
        let is_number = place.iter().all(|(x, _)| !x.is_nan());
        let vertex = if is_number { *self.vertices.entry(key).or_insert(new) } else { new };
        if vertex == new {
            self.builder.vertex_of(place, line);
        }
        self.row.push(vertex);
    }

    /// Ends the triangle.
    fn close(&mut self, line: Option<usize>) {
        let row = std::mem::take(&mut self.row);
        let numbers = row.iter().map(|&v| Some(v as i32));
        let face = self.builder.element(ElementKind::Face, numbers, Numbering::ZeroBased, line);
        if let (Some(face), Some(group)) = (face, self.groups.last_mut()) {
            group.faces.push(face);
        }
    }

    fn begin(&mut self, name: &str) {
        self.groups.push(Group {
            name: name.to_owned(),
            keyword: GroupKeyword::Object,
            faces: Vec::new(),
            curves: Vec::new(),
        });
    }

    fn finish(self) -> MeshBuilder {
        let Corners { mut builder, read, mut groups, .. } = self;
        groups.retain(|group| !group.faces.is_empty() && !group.name.is_empty());
        if groups.len() > 1 {
            builder.mesh.groups = groups;
        }
        let vertices = count(builder.mesh.positions.len(), "vertex", "vertices");
        let corners = count(read, "corner", "corners");
        builder.notes.push(format!("STL has no common vertices: {corners} are {vertices}"));
        builder
    }
}

/// Returns the faces at other positions (`#V by 3`) as a binary STL file; polygons are divided into
/// triangles. STL has neither curves, groups nor units, and about seven digits.
pub fn write_stl(mesh: &Mesh, positions: &[Point]) -> Vec<u8> {
    let mut body = Vec::new();
    let mut triangles: u32 = 0;
    for face in mesh.faces.iter() {
        let corners: Vec<Vec3<f64>> = face.iter().map(|&v| positions[v as usize].into()).collect();
        for own in triangles_in_space(&corners) {
            let [a, b, c] = own.map(|k| corners[k]);
            let normal = (b - a).cross(c - a).length_and_direction().1.unwrap_or(Vec3::zero());
            for point in [normal, a, b, c] {
                let numbers = [point.x, point.y, point.z];
                numbers.iter().for_each(|x| body.extend((*x as f32).to_le_bytes()));
            }
            body.extend([0; 2]);
            triangles += 1;
        }
    }
    // A header that begins with "solid" would look like text.
    let mut out = vec![0; HEADER - 4];
    out[..8].copy_from_slice(b"Shape-Up");
    out.extend(triangles.to_le_bytes());
    out.extend(body);
    out
}
