//! Reads Wavefront OBJ (Appendix B1 of the Advanced Visualizer manual,
//! <https://paulbourke.net/dataformats/obj/>): vertices, polygons, polylines and groups. Polylines
//! are `l` statements and the free-form curves of degree one that Rhino writes. Texture
//! coordinates, normals, points and other free-form geometry are counted and ignored.

use super::builder::MeshBuilder;
use super::groups::Groups;
use super::lines::{joined_lines, words};
use super::number::{Numbering, whole};
use crate::mesh::{ElementKind, GroupKeyword, ProblemKind};
use crate::words;

/// Statements ignored without a message: they do not affect the shape, or only free-form elements.
const SILENT: &str = "vt vn vp s mg mtllib maplib usemap parm trim hole scrv sp end con bmat step \
    ctech stech bevel c_interp d_interp lod shadow_obj trace_obj call csh";

pub(crate) fn read(text: &str) -> MeshBuilder {
    let mut builder = MeshBuilder::default();
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
                if let Some(&(_, keyword)) = GroupKeyword::STATEMENTS.iter().find(opens) {
                    if groups.open(keyword, &text) {
                        builder.counts.add(ProblemKind::TooManyNames, Some(line));
                    }
                } else if !SILENT.split(' ').any(|silent| silent == statement) {
                    builder.counts.add(ProblemKind::UnknownStatement, Some(line));
                }
                continue;
            }
        };
        let corners = words.map(|word| ignored.corner(word));
        let numbering = Numbering::OneBasedOrBack { read: vertices_read };
        if let Some(index) = builder.element(element, corners, numbering, line) {
            groups.add(element, index);
        }
    }
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
