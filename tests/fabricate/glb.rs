//! Binary glTF, read back.

use super::build;
use super::identities::revolution;
use serde_json::Value;
use shape_up::fabricate::file::{GlbLayer, GlbPart, glb};
use shape_up::math::Vec3;
use shape_up::math::plane::area;
use shape_up::scene::BuildSettings;
use std::collections::BTreeMap;

/// The JSON and the binary chunk of a file.
fn read(bytes: &[u8]) -> (Value, Vec<u8>) {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], number(4), number(8)), (&b"glTF"[..], 2, bytes.len()));
    let length = number(12);
    assert_eq!((&bytes[16..20], length % 4), (&b"JSON"[..], 0));
    let json = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let next = 20 + length;
    if next == bytes.len() {
        return (json, Vec::new());
    }
    assert_eq!((&bytes[next + 4..next + 8], number(next)), (&b"BIN\0"[..], bytes.len() - next - 8));
    (json, bytes[next + 8..].to_vec())
}

/// Triangles of a mesh of a file, checked against its metadata.
fn triangles((json, data): &(Value, Vec<u8>), mesh: usize) -> Vec<[Vec3<f64>; 3]> {
    let primitive = &json["meshes"][mesh]["primitives"][0];
    let accessor = |key: &Value| &json["accessors"][key.as_u64().unwrap() as usize];
    let chunks = |accessor: &Value| -> Vec<[u8; 4]> {
        let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let number = |of: &Value, key: &str| of[key].as_u64().unwrap() as usize;
        let from = number(accessor, "byteOffset");
        let size = if accessor["type"] == "VEC3" { 12 } else { 4 };
        let to = from + size * number(accessor, "count");
        assert!(to <= number(view, "byteLength"));
        // Views of several accessors have a stride, those of indices must not.
        assert_eq!(view["byteStride"].as_u64(), (size == 12).then_some(12));
        let start = view["byteOffset"].as_u64().unwrap_or(0) as usize;
        data[start + from..start + to].as_chunks().0.to_vec()
    };
    let points = accessor(&primitive["attributes"]["POSITION"]);
    let numbers: Vec<f32> = chunks(points).into_iter().map(f32::from_le_bytes).collect();
    let positions = numbers.as_chunks::<3>().0;
    assert_eq!(points["count"].as_u64().unwrap() as usize, positions.len());
    for k in 0..3 {
        let least = positions.iter().map(|p| p[k]).fold(f32::INFINITY, f32::min);
        assert_eq!(points["min"][k].as_f64().unwrap() as f32, least);
    }
    let corners = chunks(accessor(&primitive["indices"]));
    let corner =
        |bytes: &[u8; 4]| positions[u32::from_le_bytes(*bytes) as usize].map(f64::from).into();
    corners.as_chunks::<3>().0.iter().map(|three| three.each_ref().map(corner)).collect()
}

/// The points of a file, by their names.
fn points(json: &Value) -> BTreeMap<String, Vec3<f64>> {
    let point = |node: &Value| {
        let at = node["translation"].as_array()?.iter().map(|x| x.as_f64().unwrap());
        let at: [f64; 3] = at.collect::<Vec<_>>().try_into().unwrap();
        Some((node["name"].as_str().unwrap().to_owned(), Vec3::from(at)))
    };
    json["nodes"].as_array().unwrap().iter().filter_map(point).collect()
}

/// The layers of a file: for each, its name, and the names and meshes of its parts.
fn layers(json: &Value) -> Vec<(String, Vec<(String, usize)>)> {
    let nodes = json["nodes"].as_array().unwrap();
    let name = |node: &Value| node["name"].as_str().unwrap().to_owned();
    let children = |node: &Value| -> Vec<Value> {
        let of = node["children"].as_array().unwrap().iter();
        of.map(|child| nodes[child.as_u64().unwrap() as usize].clone()).collect()
    };
    let part = |node: &Value| Some((name(node), node["mesh"].as_u64()? as usize));
    children(&nodes[0])
        .iter()
        .map(|own| (name(own), children(own).iter().filter_map(part).collect()))
        .collect()
}

#[test]
fn panels_and_beams_have_their_names_and_areas_in_metres() {
    let made = build(&revolution(9, 7), &BuildSettings::default());
    let file = read(&made.presentation(true));
    let area = |mesh: usize| -> f64 {
        let twice = |[a, b, c]: [Vec3<f64>; 3]| (b - a).cross(c - a).length();
        triangles(&file, mesh).into_iter().map(twice).sum::<f64>() * 0.5
    };
    let layers = layers(&file.0);
    let names: Vec<&str> = layers.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["panels", "offset", "beams", "nodes"]);
    let points = points(&file.0);
    assert_eq!(points.len(), made.surface.positions.len());
    for (v, at) in made.surface.positions.iter().enumerate() {
        assert!((points[&format!("N{v}")] - *at).length() < 1e-6);
    }
    let panels = &layers[0].1;
    assert_eq!(panels.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), made.names);
    for ((name, mesh), own) in panels.iter().zip(&made.surface.areas) {
        assert!((area(*mesh) / own.length() - 1.0).abs() < 1e-5, "{name}");
    }
    assert_eq!(layers[1].1.len(), 1, "it has no names of its own");
    assert!(area(layers[1].1[0].1) > 0.0);
    let (axes, _) = made.offset.as_ref().unwrap();
    assert_eq!(layers[2].1.len(), made.surface.edges.len());
    for ((name, mesh), edge) in layers[2].1.iter().zip(&made.surface.edges) {
        let [i, j] = edge.ends;
        let below = |v: u32| made.surface.at(v);
        let above = |v: u32| below(v) + axes.axes[v as usize] * made.distance();
        let half = |a: Vec3<f64>, b: Vec3<f64>, c: Vec3<f64>| 0.5 * (b - a).cross(c - a).length();
        let exact = half(below(i), below(j), above(j)) + half(below(i), above(j), above(i));
        assert!((area(*mesh) / exact - 1.0).abs() < 1e-2, "{name}: {} {exact}", area(*mesh));
        assert_eq!(*name, format!("B{i}-{j}"));
    }
    assert!(file.0["nodes"][0]["rotation"].is_array());
    assert!(read(&made.presentation(false)).0["nodes"][0]["rotation"].is_null());
}

#[test]
fn of_many_panels_each_layer_is_one_part_and_names_are_at_points() {
    let made = build(&revolution(60, 40), &BuildSettings::default());
    assert!(made.names.len() > 2000);
    let (json, _) = read(&made.presentation(true));
    let sizes: Vec<usize> = layers(&json).iter().map(|(_, parts)| parts.len()).collect();
    assert_eq!(sizes, [1, 1, 1, 0]);
    // Their names are at points.
    let points = points(&json);
    assert!(made.names.iter().all(|name| points.contains_key(name)));
}

fn layer_of(parts: Vec<GlbPart>) -> GlbLayer {
    GlbLayer { name: "layer", parts, ..GlbLayer::default() }
}

#[test]
fn an_arrow_is_split_without_turning_a_triangle() {
    let mut part = GlbPart::named("arrow");
    let corners = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
    part.add_polygon(&corners.map(|[x, y]| Vec3::new(x, y, 0.0)));
    let layers = [layer_of(vec![part, GlbPart::default()]), layer_of(vec![GlbPart::default()])];
    let file = read(&glb(&layers, false));
    assert_eq!(file.0["meshes"].as_array().unwrap().len(), 1, "no mesh without triangles");
    assert_eq!(file.0["materials"].as_array().unwrap().len(), 1, "no layer without meshes");
    let areas = triangles(&file, 0).into_iter().map(|[a, b, c]| (b - a).cross(c - a).z * 0.5);
    let areas: Vec<f64> = areas.collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert!((areas.iter().sum::<f64>() - 1.5).abs() < 1e-6);
    assert_eq!(read(&glb(&[], false)).0["meshes"], Value::Null);
}

/// A panel with two notches, which no fan fills.
pub(super) const TWO_NOTCHES: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [6.0, 0.0],
    [6.0, 4.0],
    [5.0, 1.0],
    [4.0, 4.0],
    [2.0, 4.0],
    [1.0, 1.0],
    [0.0, 4.0],
];

#[test]
fn a_polygon_that_no_fan_fills_is_split_without_turning_a_triangle() {
    let mut part = GlbPart::named("part");
    part.add_polygon(&TWO_NOTCHES.map(|[x, y]| Vec3::new(1.0, x, y)));
    let file = read(&glb(&[layer_of(vec![part])], false));
    let areas = triangles(&file, 0).into_iter().map(|[a, b, c]| (b - a).cross(c - a).x * 0.5);
    let areas: Vec<f64> = areas.collect();
    assert!(areas.iter().all(|own| *own > 0.0), "{areas:?}");
    let expected = area(&TWO_NOTCHES);
    assert!((areas.iter().sum::<f64>() - expected).abs() < 1e-5, "{areas:?} {expected}");
}
