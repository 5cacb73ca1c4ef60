//! Reads and writes Wavefront OBJ (Appendix B1 of the Advanced Visualizer manual,
//! <https://paulbourke.net/dataformats/obj/>): vertices, polygons, polylines and groups. Polylines
//! are `l` statements and the free-form curves of degree one that Rhino writes. Texture
//! coordinates, normals, points and other free-form geometry are counted and ignored.

use super::builder::MeshBuilder;
use super::groups::Groups;
use super::lines::{Statement, joined_lines, words};
use super::number::{Numbering, whole};
use crate::mesh::file_order::FilePart;
use crate::mesh::{Decimal, ElementKind, Group, GroupKeyword, Mesh, Point, ProblemKind, Ragged};
use crate::words;
use std::fmt::{Display, Write};

pub(crate) fn read(text: &str) -> MeshBuilder {
    let mut builder = MeshBuilder::default();
    builder.example = ", such as `v 0 0 0` in OBJ";
    let mut ignored = Ignored::default();
    // Vertices are read first, since faces may precede their vertices.
    for (line, text) in joined_lines(text) {
        let mut words = words(&text);
        if words.next() == Some("v") {
            let coordinates = std::array::from_fn(|_| words.next().unwrap_or_default());
            builder.vertex(coordinates, line);
            ignored.vertex_extras += usize::from(words.next().is_some());
        }
    }

    let mut groups = Groups::default();
    let mut vertices_read = 0;
    let mut curve_type = String::new();
    let mut degree = String::new();
    for (line, text) in joined_lines(text) {
        let mut words = words(&text);
        let Some(statement) = words.next() else { continue };
        let element = match statement {
            "v" => {
                vertices_read += 1;
                continue;
            }
            "f" | "fo" => ElementKind::Face,
            "l" => ElementKind::Curve,
            "curv" if degree == "1" && ["bspline", "bezier"].contains(&curve_type.as_str()) => {
                // The parameter range precedes the control points.
                words.by_ref().take(2).for_each(drop);
                ElementKind::Curve
            }
            "cstype" => {
                curve_type = words.last().unwrap_or_default().to_owned();
                continue;
            }
            "deg" => {
                degree = words.next().unwrap_or_default().to_owned();
                continue;
            }
            "curv" | "curv2" => {
                ignored.curves += 1;
                continue;
            }
            "surf" => {
                ignored.surfaces += 1;
                continue;
            }
            "p" => {
                ignored.points += words.count();
                continue;
            }
            _ => {
                let opens = |(word, _): &&(&str, GroupKeyword)| *word == statement;
                let known = Statement::of(statement);
                // They are written again where they were.
                if matches!(known, Some(Statement::Name | Statement::Setting)) {
                    builder.mesh.order.push(FilePart::Statement(text.trim_ascii().into()));
                }
                if let Some(&(_, keyword)) = GroupKeyword::STATEMENTS.iter().find(opens) {
                    if groups.open(keyword, &text) {
                        builder.counts.add(ProblemKind::TooManyNames, Some(line));
                    }
                } else if known.is_none() {
                    builder.counts.add(ProblemKind::UnknownStatement, Some(line));
                }
                continue;
            }
        };
        let corners = words.map(|word| ignored.corner(word));
        let numbering = Numbering::OneBasedOrBack { read: vertices_read };
        let untouched = builder.mesh.untouched.len();
        if let Some(index) = builder.element(element, corners, numbering, Some(line)) {
            groups.add(element, index);
            builder.mesh.order.push(match element {
                ElementKind::Curve => FilePart::Curves(1),
                _ => FilePart::Faces(1),
            });
        } else if builder.mesh.untouched.len() > untouched {
            builder.mesh.order.push(FilePart::Untouched(1));
        }
    }
    builder.examine_end(text);
    builder.notes.extend(groups.note());
    builder.mesh.groups = groups.finish();
    builder.notes.extend(ignored.notes());
    builder
}

/// Counts of the ignored parts of the file.
#[derive(Default)]
struct Ignored {
    textures: usize,
    normals: usize,
    vertex_extras: usize,
    points: usize,
    curves: usize,
    surfaces: usize,
}

impl Ignored {
    /// Returns the vertex number of a corner such as `3`, `3/1`, `3//2` or `3/1/2`.
    fn corner(&mut self, word: &str) -> Option<i32> {
        let mut parts = word.split('/');
        let number = parts.next().and_then(whole);
        let mut is_there = || usize::from(parts.next().is_some_and(|part| !part.is_empty()));
        self.textures += is_there();
        self.normals += is_there();
        number
    }

    fn notes(&self) -> impl Iterator<Item = String> {
        let all = [
            (self.textures, "texture index", "texture indices"),
            (self.normals, "normal index", "normal indices"),
            (self.vertex_extras, "weight or colour of a vertex", "weights or colours of vertices"),
            (self.points, "point element", "point elements"),
            (self.curves, "curve of a degree above one", "curves of a degree above one"),
            (self.surfaces, "free-form surface", "free-form surfaces"),
        ];
        all.into_iter()
            .filter(|(count, ..)| *count > 0)
            .map(|(count, one, many)| format!("{} ignored", words::count(count, one, many)))
    }
}

/// Returns the mesh at other positions (`#V by 3`, finite) as an OBJ file: vertices, faces, then
/// polylines, in order and with their groups. Numbers have the fewest digits that read back to the
/// same `f64`.
///
/// A mesh that came from an OBJ file and whose elements are still those has their order and its
/// statements as they came: empty groups, smoothing, and faces that were left as they are.
///
/// OBJ has no tetrahedra: they are left out. It has one `o` and one `usemtl` at a time: of several
/// such groups of an element, the first is written. White space in the name of a `g` becomes `_`.
pub fn write_obj(mesh: &Mesh, positions: &[Point]) -> String {
    write_obj_with(mesh, positions, &[], &[])
}

/// As [`write_obj`], with a flat map `uv` (`#V by 2`, or empty) as texture coordinates, one `vt` per
/// vertex, and with lines of comments first.
pub fn write_obj_with(
    mesh: &Mesh,
    positions: &[Point],
    uv: &[[f64; 2]],
    comments: &[String],
) -> String {
    assert_eq!(positions.len(), mesh.positions.len(), "one position for each vertex");
    assert!(uv.is_empty() || uv.len() == positions.len(), "one place in the map for each vertex");
    let indices = mesh.faces.indices().len() + mesh.curves.indices().len();
    let mut out = String::with_capacity(64 * positions.len() + 10 * indices);
    comments.iter().for_each(|line| out.extend(["# ", line, "\n"]));
    for position in positions {
        push_row(&mut out, "v", position);
    }
    for place in uv {
        push_row(&mut out, "vt", place);
    }
    let mut elements = Elements { out, has_map: !uv.is_empty() };
    if is_as_it_came(mesh) {
        let [mut faces, mut curves, mut untouched] =
            [&mesh.faces, &mesh.curves, &mesh.untouched].map(Ragged::iter);
        for part in mesh.order.parts() {
            let (statement, rows, count) = match part {
                FilePart::Faces(count) => ('f', &mut faces, *count),
                FilePart::Curves(count) => ('l', &mut curves, *count),
                FilePart::Untouched(count) => ('f', &mut untouched, *count),
                FilePart::Statement(text) => {
                    elements.out.push_str(text);
                    elements.out.push('\n');
                    continue;
                }
            };
            rows.take(count as usize).for_each(|row| elements.push(statement, row));
        }
        return elements.out;
    }
    let members = members(mesh);
    let mut members = members.chunk_by(|a, b| a.0 == b.0).peekable();
    let mut open: &[(u32, u32)] = &[];
    let faces = mesh.faces.iter().map(|row| ('f', row));
    let curves = mesh.curves.iter().map(|row| ('l', row));
    for (element, (statement, row)) in faces.chain(curves).enumerate() {
        let now = members.next_if(|run| run[0].0 as usize == element).unwrap_or_default();
        push_groups(&mut elements.out, &mesh.groups, open, now);
        open = now;
        elements.push(statement, row);
    }
    if !mesh.untouched.is_empty() {
        push_groups(&mut elements.out, &mesh.groups, open, &[]);
        mesh.untouched.iter().for_each(|row| elements.push('f', row));
    }
    elements.out
}

/// Whether the faces, curves and groups of the mesh are those of the file that its order is of.
fn is_as_it_came(mesh: &Mesh) -> bool {
    let counts = [&mesh.faces, &mesh.curves, &mesh.untouched].map(Ragged::len);
    if mesh.order.parts().is_empty() || !mesh.order.has(counts) {
        return false;
    }
    let mut groups = Groups::default();
    let mut next = [0; 2];
    for part in mesh.order.parts() {
        let (element, count) = match part {
            FilePart::Faces(count) => (ElementKind::Face, *count),
            FilePart::Curves(count) => (ElementKind::Curve, *count),
            FilePart::Untouched(_) => continue,
            FilePart::Statement(text) => {
                let word = text.split_ascii_whitespace().next();
                let opens = |(known, _): &&(&str, GroupKeyword)| word == Some(*known);
                if let Some(&(_, keyword)) = GroupKeyword::STATEMENTS.iter().find(opens) {
                    groups.open(keyword, text);
                }
                continue;
            }
        };
        let first = &mut next[usize::from(element == ElementKind::Curve)];
        (*first..*first + count).for_each(|index| groups.add(element, index));
        *first += count;
    }
    groups.finish() == mesh.groups
}

/// A file with its vertices, to which elements are appended.
struct Elements {
    out: String,
    /// Whether each vertex has texture coordinates of its number.
    has_map: bool,
}

impl Elements {
    fn push(&mut self, statement: char, row: &[u32]) {
        self.out.push(statement);
        for &vertex in row {
            self.out.push(' ');
            push(&mut self.out, u64::from(vertex) + 1);
            if self.has_map {
                push(&mut self.out, format_args!("/{}", u64::from(vertex) + 1));
            }
        }
        self.out.push('\n');
    }
}

fn push_row(out: &mut String, statement: &str, numbers: &[f64]) {
    out.push_str(statement);
    for &x in numbers {
        out.push(' ');
        push(out, Decimal(x));
    }
    out.push('\n');
}

fn push(out: &mut String, value: impl Display) {
    write!(out, "{value}").expect("a string takes all that is written to it");
}

/// Returns all memberships as pairs of element (faces, then curves) and group, ascending.
fn members(mesh: &Mesh) -> Vec<(u32, u32)> {
    let first_curve = mesh.faces.len() as u32;
    let mut members = Vec::new();
    for (group, Group { faces, curves, .. }) in (0..).zip(&mesh.groups) {
        members.extend(faces.iter().map(|&face| (face, group)));
        members.extend(curves.iter().map(|&curve| (first_curve + curve, group)));
    }
    members.sort_unstable();
    members
}

/// Appends the statements that change from the groups of one element to those of the next.
fn push_groups(out: &mut String, groups: &[Group], open: &[(u32, u32)], now: &[(u32, u32)]) {
    for (statement, keyword) in GroupKeyword::STATEMENTS {
        let (most, gap) = match keyword {
            GroupKeyword::Group => (usize::MAX, '_'),
            GroupKeyword::Object | GroupKeyword::Material => (1, ' '),
        };
        let of_keyword = |&&(_, group): &&(u32, u32)| groups[group as usize].keyword == keyword;
        let names = now.iter().filter(of_keyword).take(most);
        if names.clone().map(|m| m.1).eq(open.iter().filter(of_keyword).take(most).map(|m| m.1)) {
            continue;
        }
        out.push_str(statement);
        for &(_, group) in names {
            out.push(' ');
            push_name(out, &groups[group as usize].name, gap);
        }
        out.push('\n');
    }
}

/// Appends a name with each run of white space and control characters, and the backslashes before
/// it, replaced by `gap`.
fn push_name(out: &mut String, name: &str, gap: char) {
    let parts = name.split(|c: char| c.is_ascii_whitespace() || c.is_control());
    let parts = parts.map(|part| part.trim_end_matches('\\')).filter(|part| !part.is_empty());
    for (index, part) in parts.enumerate() {
        if index > 0 {
            out.push(gap);
        }
        out.push_str(part);
    }
}
