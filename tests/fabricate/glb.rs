//! Binary glTF, read back.

use super::build;
use super::identities::revolution;
use serde_json::Value;
use shape_up::fabricate::file::{GlbPart, glb};
use shape_up::math::Vec3;
use shape_up::math::plane::area;
use shape_up::scene::BuildSettings;

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
        let [from, length] =
            ["byteOffset", "byteLength"].map(|k| view[k].as_u64().unwrap() as usize);
        data[from..from + length].as_chunks().0.to_vec()
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

#[test]
fn panels_offset_and_beams_are_parts_in_metres_with_the_areas_of_the_mesh() {
    let made = build(&revolution(9, 7), &BuildSettings::default());
    let file = read(&made.presentation(true));
    let area = |mesh: usize| -> f64 {
        let twice = |[a, b, c]: [Vec3<f64>; 3]| (b - a).cross(c - a).length();
        triangles(&file, mesh).into_iter().map(twice).sum::<f64>() * 0.5
    };
    let panels: f64 = made.surface.areas.iter().map(|area| area.length()).sum();
    assert!((area(0) / panels - 1.0).abs() < 1e-5, "{} {panels}", area(0));
    let names = ["panels", "offset", "beams"];
    for (k, name) in names.into_iter().enumerate() {
        assert_eq!(file.0["nodes"][k + 1]["name"], name);
        assert!(area(k) > 0.0);
    }
    // The depth of a beam is the offset distance.
    let deep =
        made.distance() * made.surface.edges.iter().map(|e| made.surface.length(e)).sum::<f64>();
    assert!((area(2) / deep - 1.0).abs() < 0.2, "{} {deep}", area(2));
    assert!(file.0["nodes"][0]["rotation"].is_array());
    assert!(read(&made.presentation(false)).0["nodes"][0]["rotation"].is_null());
}

#[test]
fn an_arrow_is_split_without_turning_a_triangle() {
    let mut part = GlbPart { name: "arrow", ..GlbPart::default() };
    let corners = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
    part.add_polygon(&corners.map(|[x, y]| Vec3::new(x, y, 0.0)));
    let file = read(&glb(&[part, GlbPart::default()], false));
    assert_eq!(file.0["meshes"].as_array().unwrap().len(), 1, "no mesh without triangles");
    let areas = triangles(&file, 0).into_iter().map(|[a, b, c]| (b - a).cross(c - a).z * 0.5);
    let areas: Vec<f64> = areas.collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert!((areas.iter().sum::<f64>() - 1.5).abs() < 1e-6);
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
    let mut part = GlbPart { name: "part", ..GlbPart::default() };
    part.add_polygon(&TWO_NOTCHES.map(|[x, y]| Vec3::new(1.0, x, y)));
    let file = read(&glb(&[part], false));
    let areas = triangles(&file, 0).into_iter().map(|[a, b, c]| (b - a).cross(c - a).x * 0.5);
    let areas: Vec<f64> = areas.collect();
    assert!(areas.iter().all(|own| *own > 0.0), "{areas:?}");
    let expected = area(&TWO_NOTCHES);
    assert!((areas.iter().sum::<f64>() - expected).abs() < 1e-5, "{areas:?} {expected}");
}
