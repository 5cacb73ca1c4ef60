//! Reads and writes Medit's `.mesh` (INRIA Technical Report 0253) in its text form, the only format
//! here with tetrahedra: named sections, each with its number of rows. Vertices are numbered from
//! one. The reference number at the end of each row is ignored. Triangles and quadrilaterals are
//! read as faces, edges as curves. Solids other than tetrahedra are ignored with a note.

use super::builder::MeshBuilder;
use super::builder::ReadError;
use super::number::Numbering;
use super::stream::Stream;
use crate::mesh::{ElementKind, Mesh};
use crate::words::group_digits;
use std::fmt::Write;

/// The first word of a file.
pub(crate) const HEADER: &str = "MeshVersionFormatted";

pub(crate) fn read(text: &str) -> Result<MeshBuilder, ReadError> {
    let mut stream = Stream::new(text);
    let mut builder = MeshBuilder::default();
    let mut dimension = 3;
    let mut section = "";
    while let Some(word) = stream.word() {
        let (element, corners) = match word {
            HEADER => {
                stream.count("the version")?;
                continue;
            }
            "Dimension" => {
                dimension = stream.count("the dimension")?;
                if !(2..=3).contains(&dimension) {
                    return Err(stream.fault("expected dimension 2 or 3".to_owned()));
                }
                continue;
            }
            "Vertices" => {
                section = word;
                let count = stream.count("the number of vertices")?;
                stream.vertices(count, dimension, true, &mut builder)?;
                continue;
            }
            "Edges" => (ElementKind::Curve, 2),
            "Triangles" => (ElementKind::Face, 3),
            "Quadrilaterals" => (ElementKind::Face, 4),
            "Tetrahedra" => (ElementKind::Tetrahedron, 4),
            "Hexahedra" | "Prisms" | "Pyramids" => {
                let count = stream.count(format_args!("the number of {word}"))?;
                if count > 0 {
                    let count = group_digits(count);
                    let note = format!(
                        "{word} ignored: {count}, since the only solids read are tetrahedra"
                    );
                    builder.notes.push(note);
                }
                section = "";
                continue;
            }
            "End" => break,
            _ if word.starts_with(|c: char| c.is_ascii_alphabetic()) => {
                section = "";
                continue;
            }
            // A number in a section that is not read.
            _ if section.is_empty() => continue,
            _ => {
                let message = format!("`{section}` has more rows than its count: found `{word}`");
                return Err(stream.fault(message));
            }
        };
        section = word;
        let count = stream.count(format_args!("the number of {word}"))?;
        for row in 1..=count {
            stream.element(
                element,
                corners,
                true,
                format_args!("row {row} of {count} of {word}"),
                &mut builder,
            )?;
        }
    }
    builder.settle(Numbering::OneBased);
    Ok(builder)
}

/// Returns the mesh as the text of a Medit file: vertices, then the segments of curves as edges,
/// triangles, quadrilaterals and tetrahedra, each in order, with the reference number 0. Numbers have the
/// fewest digits that read back to the same `f64`.
///
/// Faces of more corners, faces with holes and groups, which Medit does not support, are left out.
pub fn write_medit(mesh: &Mesh) -> String {
    let mut out = String::with_capacity(64 * mesh.positions.len());
    out.push_str("MeshVersionFormatted 2\nDimension 3\n");
    let positions = mesh.positions.iter().map(|p| p.map(|x| x.to_string()).join(" "));
    push_section(&mut out, "Vertices", positions);
    let corners = |row: &[u32]| {
        let numbers: Vec<_> = row.iter().map(|&v| (u64::from(v) + 1).to_string()).collect();
        numbers.join(" ")
    };
    push_section(&mut out, "Edges", mesh.curves.iter().flat_map(|c| c.windows(2)).map(corners));
    for (name, n) in [("Triangles", 3), ("Quadrilaterals", 4)] {
        push_section(&mut out, name, mesh.faces.iter().filter(|f| f.len() == n).map(corners));
    }
    push_section(&mut out, "Tetrahedra", mesh.tets.iter().map(|tet| corners(tet)));
    out.push_str("End\n");
    out
}

/// Appends a section with its rows, unless there are none.
fn push_section(out: &mut String, name: &str, rows: impl Iterator<Item = String>) {
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return;
    }
    writeln!(out, "{name}\n{}", rows.len()).expect("a string takes all that is written to it");
    for row in rows {
        out.push_str(&row);
        out.push_str(" 0\n");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Ragged, read};

    #[test]
    fn what_is_written_reads_back() {
        let faces: [&[u32]; 3] = [&[0, 2, 1], &[0, 1, 4, 3], &[0, 1, 2, 3, 4]];
        let mesh = Mesh {
            positions: vec![[0.1, 0.0, -0.0], [1e-7, 2.0, 3e20], [1.0; 3], [2.0; 3], [3.0; 3]],
            faces: Ragged::from_iter(faces),
            curves: [&[0, 4][..], &[1, 2, 3]].into_iter().collect(),
            tets: vec![[0, 1, 2, 3], [4, 1, 2, 3]],
            ..Mesh::default()
        };
        let again = read("bar.mesh", write_medit(&mesh).as_bytes()).expect("it is a Medit file");
        let faces = Ragged::from_iter(&faces[..2]);
        let kept = Mesh { faces, curves: [[0, 4], [1, 2], [2, 3]].iter().collect(), ..mesh };
        assert_eq!(again.mesh, kept);
        assert_eq!(again.problems, []);
    }

    #[test]
    fn a_set_of_points_has_no_other_sections() {
        let mesh = Mesh { positions: vec![[1.0, 2.0, 3.0]], ..Mesh::default() };
        let text = "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n1 2 3 0\nEnd\n";
        assert_eq!(write_medit(&mesh), text);
    }
}
