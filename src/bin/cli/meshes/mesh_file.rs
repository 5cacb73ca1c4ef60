//! Mesh files of sessions, with the format by extension: Medit (`.mesh`), else OBJ.

use crate::cli::input;
use shape_up::mesh::{Mesh, Weld, write_medit};
use shape_up::session::Session;
use shape_up::words;
use std::path::Path;

/// Returns the text of the file `path`, with the original vertices and faces of a welded mesh.
pub(in crate::cli) fn text(path: &Path, session: &Session, weld: Option<&Weld>) -> String {
    let now = session.positions();
    match (is_medit(path), weld) {
        (false, None) => session.obj(),
        (false, Some(weld)) => session.obj_unwelded(weld),
        (true, None) => write_medit(&Mesh { positions: now, ..session.mesh().clone() }),
        (true, Some(weld)) => {
            let positions = weld.original_positions(&session.mesh().positions, &now);
            write_medit(&Mesh { positions, ..weld.original.clone() })
        }
    }
}

/// Adds to `files` the changed mesh of a session or, if the name ends in .json, the scene with the
/// mesh. Returns a remark on parts that the format cannot represent.
pub(in crate::cli) fn write_changed<'a>(
    path: &'a Path,
    session: &Session,
    files: &mut Vec<(&'a Path, String)>,
) -> Option<String> {
    if input::is_scene(path) {
        files.push((path, session.scene_with_mesh()));
        return None;
    }
    files.push((path, text(path, session, None)));
    left_out(path, session.mesh())
}

/// Returns a remark on the parts of the mesh that the format of `path` cannot represent, if any.
pub(in crate::cli) fn left_out(path: &Path, mesh: &Mesh) -> Option<String> {
    let larger = mesh.faces.iter().filter(|face| face.len() > 4).count();
    let (format, parts) = if is_medit(path) {
        let faces = (larger, "face of more than four corners", "faces of more than four corners");
        let curves = (mesh.curves.len(), "curve", "curves");
        ("Medit", vec![faces, curves, (mesh.groups.len(), "group", "groups")])
    } else {
        ("OBJ", vec![(mesh.tets.len(), "tetrahedron", "tetrahedra")])
    };
    let parts = parts.into_iter().filter(|(count, ..)| *count > 0);
    let parts: Vec<_> = parts.map(|(count, one, many)| words::count(count, one, many)).collect();
    let parts = (!parts.is_empty()).then(|| parts.join(", "))?;
    Some(format!("{} is {format}, which cannot store {parts}", path.display()))
}

fn is_medit(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("mesh"))
}
