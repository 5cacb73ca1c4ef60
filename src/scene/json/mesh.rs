//! Inline mesh of a scene file.
//!
//! In addition to `"groups": {NAME: {"faces": LIST}}`, a group may have `"curves"` and the OBJ
//! statement that named it, `"keyword": "o" | "g" | "usemtl"` (`g` if absent). Groups with the same
//! name but different statements form an array. This way the groups of an OBJ file survive saving
//! and loading a scene.

use super::text::{field, object, point, rows, text};
use crate::json::{JsonError, indices, present, read};
use crate::mesh::{Group, GroupKeyword, Mesh, Point, Ragged};
use crate::scene::{MeshSource, NamedEnum, Pose};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt;

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct MeshFile {
    #[serde(default, deserialize_with = "present")]
    file: Option<String>,
    #[serde(default, deserialize_with = "present")]
    positions: Option<Vec<Point>>,
    #[serde(default, deserialize_with = "present")]
    faces: Option<Vec<indices::Indices>>,
    #[serde(default, deserialize_with = "present")]
    curves: Option<Vec<indices::Indices>>,
    #[serde(default, deserialize_with = "present")]
    tets: Option<Vec<indices::Indices>>,
    #[serde(default, deserialize_with = "groups")]
    groups: Vec<(String, Value)>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct GroupFile {
    #[serde(default, deserialize_with = "indices::deserialize")]
    faces: Vec<u32>,
    #[serde(default, deserialize_with = "indices::deserialize")]
    curves: Vec<u32>,
    #[serde(default, deserialize_with = "present")]
    keyword: Option<GroupKeyword>,
}

fn groups<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(String, Value)>, D::Error> {
    struct InOrder;

    impl<'de> Visitor<'de> for InOrder {
        type Value = Vec<(String, Value)>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("an object of named groups")
        }
        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
            let mut entries = Vec::new();
            while let Some(entry) = map.next_entry()? {
                entries.push(entry);
            }
            Ok(entries)
        }
    }
    from.deserialize_map(InOrder)
}

impl<'de> Deserialize<'de> for MeshSource {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<MeshSource, D::Error> {
        source_of(MeshFile::deserialize(from)?).map_err(D::Error::custom)
    }
}

/// Reads a mesh and keeps its positions only.
impl<'de> Deserialize<'de> for Pose {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Pose, D::Error> {
        Ok(match MeshSource::deserialize(from)? {
            MeshSource::File(path) => Pose::File(path),
            MeshSource::Inline(mesh) => Pose::Positions(mesh.positions.into()),
        })
    }
}

fn source_of(file: MeshFile) -> Result<MeshSource, JsonError> {
    let MeshFile { file, positions, faces, curves, tets, groups } = file;
    if let Some(path) = file {
        let others = [
            ("positions", positions.is_some()),
            ("faces", faces.is_some()),
            ("curves", curves.is_some()),
            ("tets", tets.is_some()),
            ("groups", !groups.is_empty()),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, given)| *given) {
            return Err(JsonError::unknown_key(key, &["file"]));
        }
        if path.is_empty() {
            let message = "found \"\", expected the path of a mesh file, relative to the scene";
            return Err(JsonError::new("file", message));
        }
        return Ok(MeshSource::File(path));
    }
    let positions = positions.ok_or_else(|| JsonError::missing_field("positions"))?;
    let count = positions.len();
    if count == 0 {
        let message = "the mesh is empty, expected at least one vertex";
        return Err(JsonError::new("positions", message));
    }
    let mut mesh = Mesh {
        positions,
        faces: ragged("faces", faces, 3, count)?,
        curves: ragged("curves", curves, 2, count)?,
        ..Mesh::default()
    };
    for (i, tet) in ragged("tets", tets, 4, count)?.iter().enumerate() {
        mesh.tets.push(tet.try_into().map_err(|_| {
            let message = format!("found an array of {}, expected the four corners", tet.len());
            JsonError::new(format!("tets[{i}]"), message + " of a tetrahedron")
        })?);
    }
    for (name, value) in groups {
        let at = |error: JsonError| error.below_key(&name).below_key("groups");
        if let Value::Array(several) = &value {
            for (k, value) in several.iter().enumerate() {
                let group = group_of(&name, value, &mesh);
                let group = group.map_err(|error| at(error.below_index(k)))?;
                mesh.groups.push(group);
            }
        } else {
            let group = group_of(&name, &value, &mesh).map_err(at)?;
            mesh.groups.push(group);
        }
    }
    Ok(MeshSource::Inline(Box::new(mesh)))
}

/// Checks that each list has at least `least` vertices, all of a mesh with `count` vertices. Drops
/// vertices of faces and curves repeated in a row, as the readers of mesh files do; otherwise no
/// face or tetrahedron may have one twice.
fn ragged(
    key: &str,
    lists: Option<Vec<indices::Indices>>,
    least: usize,
    count: usize,
) -> Result<Ragged, JsonError> {
    let mut rows = Ragged::new();
    for (i, indices::Indices(mut row)) in lists.unwrap_or_default().into_iter().enumerate() {
        let error = |message| Err(JsonError::new(format!("{key}[{i}]"), message));
        if row.len() < least {
            return error(format!("found {} vertices, expected at least {least}", row.len()));
        }
        if let Some(vertex) = row.iter().find(|&&vertex| vertex as usize >= count) {
            return error(format!(
                "there is no vertex {vertex}: the mesh has {count}, counted from 0"
            ));
        }
        let found = row.len();
        if key != "tets" {
            row.dedup();
        }
        if key == "faces" && row.len() > 1 && row.first() == row.last() {
            row.pop();
        }
        if row.len() < least {
            return error(format!(
                "found {found} vertices with repeats, expected at least {least} different ones"
            ));
        }
        let mut sorted = row.clone();
        sorted.sort_unstable();
        let twice = sorted.windows(2).find(|pair| pair[0] == pair[1]);
        // A list of five is no tetrahedron in any case, and a curve may return to a vertex.
        let is_simple = key == "faces" || (key == "tets" && found == least);
        if let Some(pair) = twice.filter(|_| is_simple) {
            return error(format!("vertex {} is in it twice, expected it once", pair[0]));
        }
        rows.push(&row);
    }
    Ok(rows)
}

fn group_of(name: &str, value: &Value, mesh: &Mesh) -> Result<Group, JsonError> {
    let GroupFile { mut faces, mut curves, keyword } = read(value)?;
    for (key, what, list, count) in [
        ("faces", "face", &mut faces, mesh.faces.len()),
        ("curves", "curve", &mut curves, mesh.curves.len()),
    ] {
        list.sort_unstable();
        list.dedup();
        if let Some(last) = list.last().filter(|&&last| last as usize >= count) {
            let message = format!("there is no {what} {last}: the mesh has {count}");
            return Err(JsonError::new(key, message));
        }
    }
    let keyword = keyword.unwrap_or(GroupKeyword::Group);
    Ok(Group { name: name.to_owned(), keyword, faces, curves })
}

/// Returns the mesh as a JSON object with lines indented by `indent`.
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
    let mut places = BTreeMap::new();
    let mut named: Vec<(&str, Vec<String>)> = Vec::new();
    for group in groups {
        let place = *places.entry(&*group.name).or_insert(named.len());
        if place == named.len() {
            named.push((&group.name, Vec::new()));
        }
        named[place].1.push(write_group(group));
    }
    let line = |(name, same): &(&str, Vec<String>)| {
        let value = match same.as_slice() {
            [one] => one.clone(),
            several => format!("[{}]", several.join(", ")),
        };
        format!("{indent}    {}: {value}", text(name))
    };
    let lines: Vec<String> = named.iter().map(line).collect();
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
