//! Reading and writing mesh files: OBJ, OFF, Medit, PLY and STL, recognised by name or content.

mod builder;
mod formats;
mod groups;
mod lines;
mod medit;
mod number;
mod obj;
mod off;
mod ply;
mod stl;
mod stream;

pub use builder::{Read, ReadError};
pub use formats::{FILE_FORMATS, FileFormat, MeshPart};
pub(crate) use lines::{decode, lines};
pub use medit::write_medit;
pub use number::Decimal;
pub use obj::{write_obj, write_obj_with};
pub use ply::write_ply;
pub use stl::write_stl;

use super::{Mesh, Point};

/// Reads a mesh from the bytes of the file `name`: OBJ, OFF, Medit, PLY or STL, by the extension, else
/// by content. Vertices keep their order and numbers; faces, curves and tetrahedra keep their order,
/// without those reported as skipped in the problems. Time and memory are linear in the size of the
/// file, up to sorting.
///
/// # Errors
///
/// If the file is empty, larger than 4 GiB, of an unknown format, truncated, or has no vertices.
pub fn read(name: &str, bytes: &[u8]) -> Result<Read, ReadError> {
    let named = FileFormat::of_name(name).filter(|format| format.is_mesh());
    let format = named.map(|format| format.endings[0]).or_else(|| of_binary(bytes));
    // Messages have the line of a text; of a binary file, no more than its header is one.
    let text = match format {
        Some("ply") => decode(ply::text(bytes)),
        Some("stl") if !stl::is_text(bytes) => "".into(),
        _ => decode(bytes),
    };
    let found = match format {
        _ if bytes.is_empty() => Err(ReadError::whole("the file is empty")),
        _ if u32::try_from(bytes.len()).is_err() => {
            Err(ReadError::whole("the file is larger than 4 GiB"))
        }
        Some("ply") if ply::is_one(bytes) => ply::read(bytes),
        Some("ply") => Err(ReadError::whole("this is no PLY file: expected `ply` first")),
        Some("stl") => stl::read(bytes),
        _ => read_text(format, &text),
    };
    found.and_then(|builder| builder.finish(&text)).map_err(|fault| ReadError {
        file: name.to_owned(),
        text: fault.line.map(|line| lines::excerpt(&text, line)).unwrap_or_default(),
        ..fault
    })
}

/// Returns the mesh at other positions (`#V by 3`) as a file with this ending: `ply`, `stl`, `mesh`,
/// else OBJ. `comments` are lines for its header; STL and Medit have none.
pub fn write_with_ending(
    ending: &str,
    mesh: &Mesh,
    positions: &[Point],
    comments: &[String],
) -> Vec<u8> {
    match ending.to_ascii_lowercase().as_str() {
        "ply" => write_ply(mesh, positions, comments),
        "stl" => write_stl(mesh, positions),
        "mesh" => write_medit(&mesh.at(positions)).into_bytes(),
        _ => write_obj_with(mesh, positions, &[], comments).into_bytes(),
    }
}

fn read_text(format: Option<&str>, text: &str) -> Result<builder::MeshBuilder, ReadError> {
    if text.trim().is_empty() {
        return Err(ReadError::whole("the file is empty"));
    }
    let known = || format!("expected a file in the format {}", formats::mesh_endings());
    if text.contains('\0') {
        return Err(ReadError::whole(format!("this is not a text file; {}", known())));
    }
    match format.or_else(|| of_content(text)) {
        Some("obj") => Ok(obj::read(text)),
        Some("off") => off::read(text),
        Some("mesh") => medit::read(text),
        _ => Err(ReadError::whole(format!("the format is not known; {}", known()))),
    }
}

/// The first ending of the format of a file that may be binary.
fn of_binary(bytes: &[u8]) -> Option<&'static str> {
    match () {
        () if ply::is_one(bytes) => Some("ply"),
        () if stl::is_one(bytes) => Some("stl"),
        () => None,
    }
}

/// The first ending of the format of a text.
fn of_content(text: &str) -> Option<&'static str> {
    let first_words = || lines(text).filter_map(|(_, line)| lines::words(line).next());
    match first_words().next()? {
        medit::HEADER => Some("mesh"),
        word if off::Header::parse(word).is_some() => Some("off"),
        _ => first_words().any(|word| word == "v").then_some("obj"),
    }
}
