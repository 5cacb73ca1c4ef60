//! Reading and writing mesh files: OBJ, OFF and Medit, recognised by name or content.

mod builder;
mod groups;
mod lines;
mod medit;
mod number;
mod obj;
mod off;
mod stream;

pub use builder::{Read, ReadError};
pub(crate) use lines::{decode, lines};
pub use medit::write_medit;
pub use number::Decimal;
pub use obj::{write_obj, write_obj_with_uv};

use builder::ReadFault;

/// Reads a mesh from the bytes of the file `name`: OBJ, OFF or Medit, by the extension, else by
/// content. Vertices keep their order and numbers; faces, curves and tetrahedra keep their order,
/// without those reported as skipped in the problems. Time and memory are linear in the size of the
/// file, up to sorting.
///
/// # Errors
///
/// If the file is empty, larger than 4 GiB, not text, of an unknown format, truncated, or has no
/// vertices.
pub fn read(name: &str, bytes: &[u8]) -> Result<Read, ReadError> {
    let text = decode(bytes);
    read_text(name, &text).map_err(|fault| ReadError {
        file: name.to_owned(),
        line: fault.line,
        text: fault.line.map(|line| lines::excerpt(&text, line)).unwrap_or_default(),
        message: fault.message,
    })
}

fn read_text(name: &str, text: &str) -> Result<Read, ReadFault> {
    if text.trim().is_empty() {
        return Err(ReadFault::whole("the file is empty"));
    }
    if u32::try_from(text.len()).is_err() {
        return Err(ReadFault::whole("the file is larger than 4 GiB"));
    }
    if text.contains('\0') {
        return Err(ReadFault::whole(format!("this is not a text file; {KNOWN}")));
    }
    let format = Format::of_name(name).or_else(|| Format::of_content(text));
    let builder = match format {
        Some(Format::Obj) => obj::read(text),
        Some(Format::Off) => off::read(text)?,
        Some(Format::Medit) => medit::read(text)?,
        None => return Err(ReadFault::whole(format!("the format is not known; {KNOWN}"))),
    };
    builder.finish(text)
}

/// The known formats, for messages.
const KNOWN: &str = "expected a text file in the format .obj (Wavefront), .off or .mesh (Medit)";

#[derive(Clone, Copy)]
enum Format {
    Obj,
    Off,
    Medit,
}

impl Format {
    fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        match extension.to_ascii_lowercase().as_str() {
            "obj" => Some(Format::Obj),
            "off" => Some(Format::Off),
            "mesh" => Some(Format::Medit),
            _ => None,
        }
    }

    fn of_content(text: &str) -> Option<Self> {
        let first_words = || lines(text).filter_map(|(_, line)| lines::words(line).next());
        match first_words().next()? {
            medit::HEADER => Some(Format::Medit),
            word if off::Header::parse(word).is_some() => Some(Format::Off),
            _ => first_words().any(|word| word == "v").then_some(Format::Obj),
        }
    }
}
