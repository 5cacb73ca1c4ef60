//! Reads and writes STL: triangles without common vertices, as text or binary. Corners at equal
//! positions are one vertex. Solids of one name in a text file are an object.
//!
//! Binary files have single precision. Where that is too little, as at the coordinates of a site, text
//! is written.

use super::builder::{MeshBuilder, ReadError};
use super::groups::Groups;
use super::lines::{decode, lines, words};
use super::number::{Decimal, Numbering, coordinate, of_number};
use crate::math::{Vec3, polygon_sides, triangles_in_space};
use crate::mesh::{ElementKind, GroupKeyword, Mesh, Point, ProblemKind};
use crate::words::{count, group_digits};
use std::borrow::Cow;
use std::collections::HashMap;

/// Bytes of a binary file before its triangles: a free header, and their number.
const HEADER: usize = 84;
/// Bytes of a triangle: normal and corners as `f32`, and two free bytes.
const TRIANGLE: usize = 50;

/// A coordinate, and its problem, if any.
type Coordinate = (f64, Option<ProblemKind>);

/// Reads a file.
pub(super) fn read(bytes: &[u8]) -> Result<MeshBuilder, ReadError> {
    let mut corners = Corners::default();
    match is_text(bytes) {
        true => read_text(&decode(bytes), &mut corners)?,
        false => read_binary(bytes, &mut corners)?,
    }
    Ok(corners.finish())
}

/// Whether a file of that name is text. Many binary files begin as text does, but the number of their
/// triangles has a zero byte.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let text = beginning(bytes);
    let word = text.trim_ascii_start().get(..5);
    word.is_some_and(|word| word.eq_ignore_ascii_case("solid")) && !text.contains('\0')
}

/// Whether a file is a text of STL, by its first bytes.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    let is_facet = |word: &str| word.eq_ignore_ascii_case("facet");
    is_text(bytes) && beginning(bytes).split_ascii_whitespace().any(is_facet)
}

/// The beginning of a file as text: of a large binary file, no more is decoded.
fn beginning(bytes: &[u8]) -> Cow<'_, str> {
    decode(&bytes[..bytes.len().min(1024)])
}

fn read_binary(bytes: &[u8], corners: &mut Corners) -> Result<(), ReadError> {
    let parts = bytes.split_first_chunk::<HEADER>();
    let (&[.., a, b, c, d], body) = parts.ok_or_else(|| {
        ReadError::whole("this is no STL file: expected `solid`, or 84 bytes and triangles")
    })?;
    let triangles = u32::from_le_bytes([a, b, c, d]) as usize;
    let there = body.len() / TRIANGLE;
    if there < triangles {
        let [there, triangles] = [there, triangles].map(group_digits);
        return Err(ReadError::whole(format!(
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

fn read_text(text: &str, corners: &mut Corners) -> Result<(), ReadError> {
    let mut is_open = false;
    let mut last = String::new();
    for (line, text) in lines(text) {
        let mut words = words(text);
        let Some(word) = words.next() else { continue };
        last = word.to_ascii_lowercase();
        match last.as_str() {
            "solid" => {
                corners.groups.open(GroupKeyword::Object, text);
            }
            // Without a name: what follows is in no object.
            "endsolid" => {
                corners.groups.open(GroupKeyword::Object, "");
            }
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
    if is_open {
        return Err(ReadError::whole("the file ends within a triangle: it is not whole"));
    }
    if last != "endsolid" && last != "end" {
        let note = "the file does not end with `endsolid`: more may be missing";
        corners.builder.notes.push(note.to_owned());
    }
    Ok(())
}

/// The triangles so far, with one vertex for equal positions.
#[derive(Default)]
struct Corners {
    builder: MeshBuilder,
    vertices: HashMap<[u64; 3], u32>,
    row: Vec<u32>,
    /// Number of corners in all.
    read: usize,
    groups: Groups,
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
        if let Some(face) = face {
            self.groups.add(ElementKind::Face, face);
        }
    }

    fn finish(self) -> MeshBuilder {
        let Corners { mut builder, read, groups, .. } = self;
        let note = groups.note();
        let groups = groups.finish();
        // One that is the whole mesh is named like the program that wrote it.
        let faces = builder.mesh.faces.len();
        if groups.iter().any(|group| group.faces.len() < faces) {
            builder.notes.extend(note);
            builder.mesh.groups = groups;
        }
        let vertices = count(builder.mesh.positions.len(), "vertex", "vertices");
        let corners = count(read, "corner", "corners");
        builder.notes.push(format!("STL has no common vertices: {corners} are {vertices}"));
        builder
    }
}

/// Single precision is enough if it moves corners at most by this fraction of the shortest edge.
const LOST: f64 = 1e-3;

/// Returns the faces at other positions (`#V by 3`) as an STL file; polygons are divided into
/// triangles. It is binary, or text if single precision is too little. STL has neither curves, groups
/// nor units.
pub fn write_stl(mesh: &Mesh, positions: &[Point]) -> Vec<u8> {
    let triangles = mesh.all_faces().flat_map(|face| {
        let corners: Vec<Vec3<f64>> = face.iter().map(|&v| positions[v as usize].into()).collect();
        triangles_in_space(&corners).into_iter().map(move |own| own.map(|k| corners[k]))
    });
    match is_single_enough(mesh.all_faces(), positions) {
        true => binary(triangles),
        false => text(triangles).into_bytes(),
    }
}

/// Whether single precision keeps the shape of the faces.
fn is_single_enough<'a>(
    faces: impl Iterator<Item = &'a [u32]> + Clone,
    positions: &[Point],
) -> bool {
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let sides = faces.clone().flat_map(polygon_sides);
    let lengths = sides.map(|[a, b]| (at(b) - at(a)).length()).filter(|length| *length > 0.0);
    let shortest = lengths.fold(f64::INFINITY, f64::min);
    let coordinates = faces.flatten().flat_map(|&v| positions[v as usize]);
    let lost = coordinates.map(|x| (f64::from(x as f32) - x).abs()).fold(0.0, f64::max);
    lost <= LOST * shortest
}

fn normal([a, b, c]: [Vec3<f64>; 3]) -> Vec3<f64> {
    (b - a).cross(c - a).direction_or_zero()
}

fn binary(triangles: impl Iterator<Item = [Vec3<f64>; 3]>) -> Vec<u8> {
    let mut count: u32 = 0;
    // A header that begins with "solid" would look like text.
    let mut out = vec![0; HEADER];
    out[..8].copy_from_slice(b"Shape-Up");
    for corners in triangles {
        let [a, b, c] = corners;
        for point in [normal(corners), a, b, c] {
            let numbers = [point.x, point.y, point.z];
            numbers.iter().for_each(|x| out.extend((*x as f32).to_le_bytes()));
        }
        out.extend([0; 2]);
        count += 1;
    }
    out[HEADER - 4..HEADER].copy_from_slice(&count.to_le_bytes());
    out
}

fn text(triangles: impl Iterator<Item = [Vec3<f64>; 3]>) -> String {
    let row =
        |Vec3 { x, y, z }: Vec3<f64>| format!("{} {} {}\n", Decimal(x), Decimal(y), Decimal(z));
    let mut out = "solid Shape-Up\n".to_owned();
    for corners in triangles {
        out += &format!("facet normal {}outer loop\n", row(normal(corners)));
        corners.into_iter().for_each(|corner| out += &format!("vertex {}", row(corner)));
        out += "endloop\nendfacet\n";
    }
    out + "endsolid Shape-Up\n"
}
