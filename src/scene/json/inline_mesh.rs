//! A mesh inside the scene file.
//!
//! Beyond the format's `"groups": {NAME: {"faces": LIST}}`, a group may have `"curves"` and the
//! statement of an OBJ file that named it, `"keyword": "o" | "g" | "usemtl"` (`g` when absent); groups
//! of one name under different statements are an array. So an OBJ that was saved in a scene comes
//! out of it as it went in.

use super::indices;
use super::node::{JsonCursor, Node, read_points};
use super::text::{field, object, point, rows, text};
use crate::mesh::{Group, GroupKeyword, Mesh, Ragged};
use crate::scene::{NamedEnum, SceneError};

pub(super) fn read(at: &JsonCursor<'_>) -> Result<Mesh, SceneError> {
    at.only_keys(&["positions", "faces", "curves", "tets", "groups", "file"])?;
    let list = at.need("positions", "an array of points, or \"file\" with the path of a mesh")?;
    let mut mesh = Mesh { positions: read_points(&list)?, ..Mesh::default() };
    if mesh.positions.is_empty() {
        return Err(list.error("the mesh is empty, expected at least one vertex"));
    }
    let count = mesh.positions.len();
    if let Some(faces) = at.get("faces") {
        mesh.faces = read_rows(&faces, 3, count)?;
    }
    if let Some(curves) = at.get("curves") {
        mesh.curves = read_rows(&curves, 2, count)?;
    }
    if let Some(tets) = at.get("tets") {
        for tet in tets.array("an array of tetrahedra")? {
            let corners = read_row(&tet, 4, count)?;
            let corners = corners.try_into();
            mesh.tets.push(corners.map_err(|_| tet.expected("the four corners of a tetrahedron"))?);
        }
    }
    if let Some(groups) = at.get("groups") {
        for (name, entry) in groups.entries("an object of named groups")? {
            if matches!(entry.node, Node::Array(_)) {
                for part in entry.array("an array of groups")? {
                    mesh.groups.push(read_group(name, &part, &mesh)?);
                }
            } else {
                mesh.groups.push(read_group(name, &entry, &mesh)?);
            }
        }
    }
    Ok(mesh)
}

fn read_rows(at: &JsonCursor<'_>, least: usize, count: usize) -> Result<Ragged, SceneError> {
    let rows = at.array("an array of lists of vertices")?;
    rows.iter().map(|row| read_row(row, least, count)).collect()
}

/// A list of at least `least` vertices of a mesh that has `count`.
fn read_row(at: &JsonCursor<'_>, least: usize, count: usize) -> Result<Vec<u32>, SceneError> {
    let row = indices::read(at)?;
    if row.len() < least {
        return Err(at.error(format!("found {} vertices, expected at least {least}", row.len())));
    }
    match row.iter().find(|&&vertex| vertex as usize >= count) {
        Some(vertex) => Err(
            at.error(format!("there is no vertex {vertex}: the mesh has {count}, counted from 0"))
        ),
        None => Ok(row),
    }
}

fn read_group(name: &str, at: &JsonCursor<'_>, mesh: &Mesh) -> Result<Group, SceneError> {
    at.only_keys(&["faces", "curves", "keyword"])?;
    let list = |key, what, count: usize| match at.get(key) {
        None => Ok(Vec::new()),
        Some(list) => {
            let mut found = indices::read(&list)?;
            found.sort_unstable();
            found.dedup();
            match found.last() {
                Some(&last) if last as usize >= count => {
                    Err(list.error(format!("there is no {what} {last}: the mesh has {count}")))
                }
                _ => Ok(found),
            }
        }
    };
    Ok(Group {
        name: name.to_owned(),
        keyword: at.get("keyword").map_or(Ok(GroupKeyword::Group), |k| k.choice())?,
        faces: list("faces", "face", mesh.faces.len())?,
        curves: list("curves", "curve", mesh.curves.len())?,
    })
}

/// The mesh as a JSON object whose lines are indented by `indent`.
pub(super) fn write(mesh: &Mesh, indent: &str) -> String {
    let row = |row: &[u32]| {
        let items: Vec<_> = row.iter().map(u32::to_string).collect();
        format!("[{}]", items.join(", "))
    };
    let mut fields = vec![("positions", rows(mesh.positions.iter().map(point), indent))];
    if !mesh.faces.is_empty() {
        fields.push(("faces", rows(mesh.faces.iter().map(row), indent)));
    }
    if !mesh.curves.is_empty() {
        fields.push(("curves", rows(mesh.curves.iter().map(row), indent)));
    }
    if !mesh.tets.is_empty() {
        fields.push(("tets", rows(mesh.tets.iter().map(|tet| row(tet)), indent)));
    }
    if !mesh.groups.is_empty() {
        fields.push(("groups", write_groups(&mesh.groups, indent)));
    }
    let fields: Vec<_> =
        fields.iter().map(|(key, value)| format!("{indent}  \"{key}\": {value}")).collect();
    format!("{{\n{}\n{indent}}}", fields.join(",\n"))
}

fn write_groups(groups: &[Group], indent: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for (i, group) in groups.iter().enumerate() {
        if groups[..i].iter().any(|earlier| earlier.name == group.name) {
            continue;
        }
        let same: Vec<_> =
            groups[i..].iter().filter(|g| g.name == group.name).map(write_group).collect();
        let value = match same.as_slice() {
            [one] => one.clone(),
            several => format!("[{}]", several.join(", ")),
        };
        lines.push(format!("{indent}    {}: {value}", text(&group.name)));
    }
    format!("{{\n{}\n{indent}  }}", lines.join(",\n"))
}

fn write_group(group: &Group) -> String {
    let mut fields = vec![field("faces", indices::write(&group.faces))];
    if !group.curves.is_empty() {
        fields.push(field("curves", indices::write(&group.curves)));
    }
    if group.keyword != GroupKeyword::Group {
        fields.push(field("keyword", text(group.keyword.word())));
    }
    object(fields)
}
