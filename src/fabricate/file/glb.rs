//! Binary glTF 2.0, for presentations and augmented reality viewers: a node for each layer and each of
//! its parts and points, and one buffer. There are no normals, so that viewers shade faces flat, as panels are.

use crate::fabricate::panel::triangles_in_space;
use crate::math::Vec3;
use serde_json::{Value, json};

/// Parts of one colour.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GlbLayer {
    /// Its name.
    pub name: &'static str,
    /// Red, green, blue and opacity, linear, from 0 to 1.
    pub colour: [f32; 4],
    /// What is on it.
    pub parts: Vec<GlbPart>,
    /// Named points on it, in metres, of which nothing is drawn.
    pub points: Vec<(String, [f32; 3])>,
}

/// Faces that are one object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GlbPart {
    /// Its name.
    pub name: String,
    /// Positions in metres.
    pub positions: Vec<[f32; 3]>,
    /// The corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl GlbPart {
    /// Returns a part without faces.
    pub fn named(name: &str) -> GlbPart {
        GlbPart { name: name.to_owned(), ..GlbPart::default() }
    }

    /// Adds a polygon as triangles.
    pub fn add_polygon(&mut self, corners: &[Vec3<f64>]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]));
        let own = triangles_in_space(corners).into_iter();
        self.triangles.extend(own.map(|corners| corners.map(|k| first + k as u32)));
    }
}

/// What buffers hold, by the numbers of glTF.
const POINTS: u32 = 34962;
const CORNERS: u32 = 34963;

/// Writes layers of parts, without parts that have no triangles and layers that have nothing. In glTF
/// y points up: if z points up in the model, the root node is rotated.
pub fn glb(layers: &[GlbLayer], z_up: bool) -> Vec<u8> {
    // The first node is the root.
    let mut nodes = vec![Value::Null];
    let [mut meshes, mut materials, mut accessors] = [(); 3].map(|()| Vec::new());
    let mut roots: Vec<usize> = Vec::new();
    let (mut points, mut corners): (Vec<u8>, Vec<u8>) = Default::default();
    for GlbLayer { name, colour, parts, points: named } in layers {
        let mut children = Vec::new();
        for part in parts.iter().filter(|part| !part.triangles.is_empty()) {
            let at = accessors.len();
            let bound = |pick: fn(f32, f32) -> f32| {
                let all = part.positions.iter().copied();
                all.reduce(|a, b| std::array::from_fn(|k| pick(a[k], b[k]))).unwrap_or_default()
            };
            accessors.push(json!({
                "bufferView": 0, "byteOffset": points.len(), "componentType": 5126, "type": "VEC3",
                "count": part.positions.len(), "min": bound(f32::min), "max": bound(f32::max),
            }));
            accessors.push(json!({
                "bufferView": 1, "byteOffset": corners.len(), "componentType": 5125,
                "type": "SCALAR", "count": 3 * part.triangles.len(),
            }));
            points.extend(part.positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            corners.extend(part.triangles.as_flattened().iter().flat_map(|v| v.to_le_bytes()));
            children.push(nodes.len());
            nodes.push(json!({ "name": part.name, "mesh": meshes.len() }));
            meshes.push(json!({ "name": part.name, "primitives": [{
                "attributes": { "POSITION": at }, "indices": at + 1, "material": materials.len(),
            }] }));
        }
        let has_parts = !children.is_empty();
        for (name, at) in named {
            children.push(nodes.len());
            nodes.push(json!({ "name": name, "translation": at }));
        }
        if children.is_empty() {
            continue;
        }
        let mut material = json!({
            "name": name, "doubleSided": true,
            "pbrMetallicRoughness":
                { "baseColorFactor": colour, "metallicFactor": 0, "roughnessFactor": 0.8 },
        });
        if colour[3] < 1.0 {
            material["alphaMode"] = "BLEND".into();
        }
        if has_parts {
            materials.push(material);
        }
        roots.push(nodes.len());
        nodes.push(json!({ "name": name, "children": children }));
    }
    nodes[0] = json!({ "name": "model" });
    if z_up {
        nodes[0]["rotation"] = json!([-0.707_106_77_f32, 0, 0, 0.707_106_77_f32]);
    }
    let mut json = json!({
        "asset": {
            "version": "2.0", "generator": concat!("shape-up ", env!("CARGO_PKG_VERSION")),
        },
        "scene": 0, "scenes": [{ "nodes": [0] }],
    });
    // glTF does not allow empty lists.
    if !roots.is_empty() {
        nodes[0]["children"] = roots.into();
    }
    if !accessors.is_empty() {
        json["meshes"] = meshes.into();
        json["materials"] = materials.into();
        json["accessors"] = accessors.into();
        // Several accessors of points share a view, which then must have a stride.
        json["bufferViews"] = json!([
            { "buffer": 0, "byteLength": points.len(), "byteStride": 12, "target": POINTS },
            { "buffer": 0, "byteOffset": points.len(), "byteLength": corners.len(),
                "target": CORNERS },
        ]);
        json["buffers"] = json!([{ "byteLength": points.len() + corners.len() }]);
    }
    json["nodes"] = nodes.into();
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunks = [(*b"JSON", json), (*b"BIN\0", [points, corners].concat())];
    let chunks = chunks.iter().filter(|(_, data)| !data.is_empty());
    let body: Vec<u8> = chunks
        .flat_map(|(kind, data)| {
            let length = (data.len() as u32).to_le_bytes();
            [&length[..], kind, data].concat()
        })
        .collect();
    let (version, length) = (2_u32.to_le_bytes(), (12 + body.len() as u32).to_le_bytes());
    [&b"glTF"[..], &version, &length, &body].concat()
}
