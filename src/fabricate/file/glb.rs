//! Binary glTF 2.0, for presentations and augmented reality viewers: one buffer, and a node and a
//! material for each part. There are no normals, so that viewers shade faces flat, as panels are.

use crate::fabricate::panel::triangles_in_space;
use crate::math::Vec3;

/// Faces of one colour.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GlbPart {
    /// Its name.
    pub name: &'static str,
    /// Red, green, blue and opacity, linear, from 0 to 1.
    pub colour: [f32; 4],
    /// Positions in metres.
    pub positions: Vec<[f32; 3]>,
    /// The corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl GlbPart {
    /// Adds a polygon as triangles.
    pub fn add_polygon(&mut self, corners: &[Vec3<f64>]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]));
        let own = triangles_in_space(corners).into_iter();
        self.triangles.extend(own.map(|corners| corners.map(|k| first + k as u32)));
    }
}

/// Writes parts, without those that have no triangles. In glTF y points up: if z points up in the
/// model, the root node is rotated.
pub fn glb(parts: &[GlbPart], z_up: bool) -> Vec<u8> {
    let parts: Vec<_> = parts.iter().filter(|part| !part.triangles.is_empty()).collect();
    let mut bytes: Vec<u8> = Vec::new();
    let [mut nodes, mut meshes, mut materials, mut accessors, mut views] =
        [(); 5].map(|()| Vec::new());
    for (k, part) in parts.iter().enumerate() {
        let GlbPart { name, colour: [r, g, b, a], positions, triangles } = part;
        let (points, corners) = (2 * k, 2 * k + 1);
        nodes.push(format!("{{\"name\":\"{name}\",\"mesh\":{k}}}"));
        meshes.push(format!(
            "{{\"name\":\"{name}\",\"primitives\":[{{\"attributes\":{{\"POSITION\":{points}}},\"indices\":{corners},\"material\":{k}}}]}}"
        ));
        let alpha = if *a < 1.0 { ",\"alphaMode\":\"BLEND\"" } else { "" };
        materials.push(format!(
            "{{\"name\":\"{name}\",\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{r},{g},{b},{a}],\"metallicFactor\":0,\"roughnessFactor\":0.8}},\"doubleSided\":true{alpha}}}"
        ));
        let bound = |pick: fn(f32, f32) -> f32| {
            let all = positions.iter().copied();
            all.reduce(|a, b| std::array::from_fn(|k| pick(a[k], b[k]))).unwrap_or_default()
        };
        let ([a, b, c], [d, e, f]) = (bound(f32::min), bound(f32::max));
        accessors.push(format!(
            "{{\"bufferView\":{points},\"componentType\":5126,\"count\":{},\"type\":\"VEC3\",\"min\":[{a},{b},{c}],\"max\":[{d},{e},{f}]}}",
            positions.len()
        ));
        accessors.push(format!(
            "{{\"bufferView\":{corners},\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}}",
            3 * triangles.len()
        ));
        let mut add = |target: u32, data: Vec<[u8; 4]>| {
            views.push(format!(
                "{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{target}}}",
                bytes.len(),
                4 * data.len()
            ));
            bytes.extend(data.as_flattened());
        };
        add(34962, positions.iter().flatten().map(|x| x.to_le_bytes()).collect());
        add(34963, triangles.iter().flatten().map(|v| v.to_le_bytes()).collect());
    }
    let children: Vec<_> = (1..=parts.len()).map(|k| k.to_string()).collect();
    let turn = if z_up { ",\"rotation\":[-0.70710677,0,0,0.70710677]" } else { "" };
    let children = match children.is_empty() {
        true => String::new(),
        false => format!(",\"children\":[{}]", children.join(",")),
    };
    nodes.insert(0, format!("{{\"name\":\"model\"{turn}{children}}}"));
    let mut json = format!(
        "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"shape-up {}\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{}]",
        env!("CARGO_PKG_VERSION"),
        nodes.join(",")
    );
    // glTF does not allow empty lists.
    if !parts.is_empty() {
        for (key, list) in [
            ("meshes", &meshes),
            ("materials", &materials),
            ("accessors", &accessors),
            ("bufferViews", &views),
        ] {
            json += &format!(",\"{key}\":[{}]", list.join(","));
        }
        json += &format!(",\"buffers\":[{{\"byteLength\":{}}}]", bytes.len());
    }
    json.push('}');
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunks = [(*b"JSON", json), (*b"BIN\0", bytes)];
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
