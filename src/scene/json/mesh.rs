//! Inline mesh of a scene file.
//!
//! In addition to `"groups": {NAME: {"faces": LIST}}`, a group may have `"curves"` and the OBJ
//! statement that named it, `"keyword": "o" | "g" | "usemtl"` (`g` if absent). Groups with the same
//! name but different statements form an array. This way the groups of an OBJ file survive saving
//! and loading a scene. So do the faces that are left as they are, `"untouched": [[0, 1, 2, 0, 3, 4]]`,
//! and the vertices without a position in the file, `"unplaced": LIST`.

use crate::json::indices::{self, Indices};
use crate::json::{Either, Entries, JsonError, object, points, present, word_or};
use crate::mesh::{Group, GroupKeyword, Mesh, Point, Ragged};
use crate::scene::{MeshSource, Pose};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::collections::BTreeMap;
use std::fmt;

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct MeshFile {
    #[serde(default, deserialize_with = "present")]
    file: Option<String>,
    #[serde(default, deserialize_with = "points")]
    positions: Option<Vec<Point>>,
    #[serde(default, deserialize_with = "present")]
    faces: Option<Vec<Indices>>,
    #[serde(default, deserialize_with = "present")]
    curves: Option<Vec<Indices>>,
    #[serde(default, deserialize_with = "present")]
    tets: Option<Vec<Indices>>,
    #[serde(default)]
    groups: Entries<SameName>,
    #[serde(default, deserialize_with = "present")]
    untouched: Option<Vec<Indices>>,
    #[serde(default, deserialize_with = "indices::deserialize")]
    unplaced: Vec<u32>,
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

/// The groups of one name.
enum SameName {
    One(GroupFile),
    Several(Vec<GroupFile>),
}

impl<'de> Deserialize<'de> for SameName {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<SameName, D::Error> {
        from.deserialize_any(GroupsVisitor)
    }
}

struct GroupsVisitor;

impl<'de> Visitor<'de> for GroupsVisitor {
    type Value = SameName;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object, or an array of objects")
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SameName, A::Error> {
        GroupFile::deserialize(MapAccessDeserializer::new(map)).map(SameName::One)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<SameName, A::Error> {
        let mut groups = Vec::new();
        while let Some(group) = array.next_element()? {
            groups.push(group);
        }
        Ok(SameName::Several(groups))
    }
}

impl<'de> Deserialize<'de> for MeshSource {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<MeshSource, D::Error> {
        source_of(object(from)?).map_err(D::Error::custom)
    }
}

/// Reads a mesh as in "mesh" of the scene, or only the path of its file.
pub(super) fn mesh_or_path<'de, D: Deserializer<'de>>(from: D) -> Result<MeshSource, D::Error> {
    match word_or(from, "the path of a mesh file, or a mesh")? {
        Either::Word(path) => file_at(path, "").map_err(D::Error::custom),
        Either::Object(mesh) => Ok(mesh),
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

/// The source at a `path`, which is given as the value of `key`.
fn file_at(path: String, key: &str) -> Result<MeshSource, JsonError> {
    if path.is_empty() {
        let message = "found \"\", expected the path of a mesh file, relative to the scene";
        return Err(JsonError::new(key, message));
    }
    Ok(MeshSource::File(path))
}

fn source_of(file: MeshFile) -> Result<MeshSource, JsonError> {
    let MeshFile { file, positions, faces, curves, tets, groups, untouched, mut unplaced } = file;
    let Entries(groups) = groups;
    if let Some(path) = file {
        let others = [
            ("positions", positions.is_some()),
            ("faces", faces.is_some()),
            ("curves", curves.is_some()),
            ("tets", tets.is_some()),
            ("groups", !groups.is_empty()),
            ("untouched", untouched.is_some()),
            ("unplaced", !unplaced.is_empty()),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, given)| *given) {
            return Err(JsonError::unknown_key(key, &["file"]));
        }
        return file_at(path, "file");
    }
    let positions = positions.ok_or_else(|| JsonError::missing_key("positions"))?;
    let count = positions.len();
    if count == 0 {
        let message = "the mesh is empty, expected at least one vertex";
        return Err(JsonError::new("positions", message));
    }
    let mut mesh = Mesh {
        positions,
        faces: ragged("faces", faces, 3, count)?,
        curves: ragged("curves", curves, 2, count)?,
        untouched: ragged("untouched", untouched, 3, count)?,
        ..Mesh::default()
    };
    unplaced.sort_unstable();
    unplaced.dedup();
    if let Some(last) = unplaced.last().filter(|&&last| last as usize >= count) {
        let message = format!("there is no vertex {last}: the mesh has {count}, counted from 0");
        return Err(JsonError::new("unplaced", message));
    }
    mesh.unplaced = unplaced;
    for (i, tet) in ragged("tets", tets, 4, count)?.iter().enumerate() {
        mesh.tets.push(tet.try_into().map_err(|_| {
            let message = format!("found an array of {}, expected the four corners", tet.len());
            JsonError::new(format!("tets[{i}]"), message + " of a tetrahedron")
        })?);
    }
    for (name, same) in groups {
        let at = |error: JsonError| error.below_key(&name).below_key("groups");
        match same {
            SameName::One(group) => {
                let group = group_of(&name, group, &mesh).map_err(at)?;
                mesh.groups.push(group);
            }
            SameName::Several(groups) => {
                for (k, group) in groups.into_iter().enumerate() {
                    let group = group_of(&name, group, &mesh);
                    mesh.groups.push(group.map_err(|error| at(error.below_index(k)))?);
                }
            }
        }
    }
    Ok(MeshSource::Inline(Box::new(mesh)))
}

/// Checks that each list has at least `least` vertices, all of a mesh with `count` vertices. Drops
/// vertices of faces and curves repeated in a row, as the readers of mesh files do; otherwise no
/// face or tetrahedron may have one twice.
fn ragged(
    key: &str,
    lists: Option<Vec<Indices>>,
    least: usize,
    count: usize,
) -> Result<Ragged, JsonError> {
    let mut rows = Ragged::new();
    for (i, Indices(mut row)) in lists.unwrap_or_default().into_iter().enumerate() {
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

fn group_of(name: &str, file: GroupFile, mesh: &Mesh) -> Result<Group, JsonError> {
    let GroupFile { mut faces, mut curves, keyword } = file;
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

impl Serialize for MeshSource {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            MeshSource::File(path) => to.collect_map([("file", path)]),
            MeshSource::Inline(mesh) => write(mesh, to),
        }
    }
}

impl Serialize for Pose {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Pose::File(path) => to.collect_map([("file", path)]),
            Pose::Positions(positions) => to.collect_map([("positions", positions)]),
        }
    }
}

/// Writes an inline mesh.
pub(super) fn write<S: Serializer>(mesh: &Mesh, to: S) -> Result<S::Ok, S::Error> {
    let mut map = to.serialize_map(None)?;
    map.serialize_entry("positions", &mesh.positions)?;
    for (key, rows) in [("faces", &mesh.faces), ("curves", &mesh.curves)] {
        if !rows.is_empty() {
            map.serialize_entry(key, &Rows(rows))?;
        }
    }
    if !mesh.tets.is_empty() {
        map.serialize_entry("tets", &mesh.tets)?;
    }
    if !mesh.groups.is_empty() {
        map.serialize_entry("groups", &Groups(&mesh.groups))?;
    }
    if !mesh.untouched.is_empty() {
        map.serialize_entry("untouched", &Rows(&mesh.untouched))?;
    }
    if !mesh.unplaced.is_empty() {
        map.serialize_entry("unplaced", &Indices(&mesh.unplaced[..]))?;
    }
    map.end()
}

struct Rows<'a>(&'a Ragged);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.0.iter())
    }
}

struct Groups<'a>(&'a [Group]);

impl Serialize for Groups<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut places = BTreeMap::new();
        let mut named: Vec<(&str, Vec<WrittenGroup<'_>>)> = Vec::new();
        for group in self.0 {
            let place = *places.entry(&*group.name).or_insert(named.len());
            if place == named.len() {
                named.push((&group.name, Vec::new()));
            }
            named[place].1.push(WrittenGroup(group));
        }
        let mut map = to.serialize_map(None)?;
        for (name, same) in named {
            match &same[..] {
                [one] => map.serialize_entry(name, one)?,
                several => map.serialize_entry(name, several)?,
            }
        }
        map.end()
    }
}

struct WrittenGroup<'a>(&'a Group);

impl Serialize for WrittenGroup<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Group { faces, curves, keyword, .. } = self.0;
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("faces", &Indices(&faces[..]))?;
        if !curves.is_empty() {
            map.serialize_entry("curves", &Indices(&curves[..]))?;
        }
        if *keyword != GroupKeyword::Group {
            map.serialize_entry("keyword", keyword)?;
        }
        map.end()
    }
}
