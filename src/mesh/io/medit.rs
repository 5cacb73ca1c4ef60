//! Reads Medit's `.mesh` (INRIA Technical Report 0253) in its text form: named sections, each with
//! its number of rows. Vertices are numbered from one. The reference number at the end of each row
//! is ignored. Triangles and quadrilaterals are read as faces, edges as curves. Solids
//! other than tetrahedra are ignored with a note.

use super::builder::MeshBuilder;
use super::number::Numbering;
use super::outcome::ReadFault;
use super::stream::Stream;
use crate::mesh::ElementKind;

/// The first word of a file.
pub(crate) const HEADER: &str = "MeshVersionFormatted";

pub(crate) fn read(text: &str) -> Result<MeshBuilder, ReadFault> {
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
                stream.vertices(count, dimension, &mut builder)?;
                continue;
            }
            "Edges" => (ElementKind::Curve, 2),
            "Triangles" => (ElementKind::Face, 3),
            "Quadrilaterals" => (ElementKind::Face, 4),
            "Tetrahedra" => (ElementKind::Tetrahedron, 4),
            "Hexahedra" | "Prisms" | "Pyramids" => {
                let count = stream.count(format_args!("the number of {word}"))?;
                if count > 0 {
                    let note = format!("{count} {word} ignored: solids are read as tetrahedra");
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
                format_args!("row {row} of {count} of {word}"),
                &mut builder,
            )?;
        }
    }
    builder.settle(Numbering::OneBased);
    Ok(builder)
}
