//! Comparison with the numbers of an independent implementation.

use super::{exact, fit};
use crate::support::shared;
use serde_json::Value;
use shape_up::fabricate::PanelSurface;
use shape_up::fabricate::beam::{end_cuts, nodes};
use shape_up::fabricate::offset::{OffsetCheck, check};
use shape_up::fabricate::panel::{inset, lay_flat, panel_types};
use shape_up::math::Vec3;
use shape_up::math::plane::area;
use shape_up::mesh::Mesh;
use shape_up::scene::OffsetKind;

const CASES: [&str; 4] = ["circular", "conical", "dodecahedron", "halftunnel"];

/// Expected values of a case, its mesh, and the tolerance in the unit of the mesh.
fn case(name: &str) -> Option<(Value, Mesh, f64)> {
    let expected = shared::expected(&format!("fabrication_{name}"))?;
    let mesh = match expected["mesh"]["file"].as_str() {
        Some(file) => shared::mesh(file)?,
        None => {
            let mut mesh = Mesh {
                positions: serde_json::from_value(expected["mesh"]["positions"].clone()).unwrap(),
                ..Mesh::default()
            };
            let faces: Vec<Vec<u32>> =
                serde_json::from_value(expected["mesh"]["faces"].clone()).unwrap();
            faces.iter().for_each(|face| mesh.faces.push(face));
            mesh
        }
    };
    let tolerance = 1e-6 * number(&expected["mean_edge_length"]);
    Some((expected, mesh, tolerance))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is a number"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is a list"))
}

fn close(found: f64, expected: &Value, tolerance: f64, what: &str) {
    let expected = number(expected);
    assert!((found - expected).abs() <= tolerance, "{what}: {found} {expected}");
}

#[test]
fn counts_edges_and_folds_agree() {
    for name in CASES {
        let Some((expected, mesh, tolerance)) = case(name) else { return };
        let surface = PanelSurface::new(&mesh).unwrap();
        let rim = surface.edges.iter().filter(|edge| edge.is_rim()).count();
        let counts = &expected["counts"];
        let found = [surface.faces.len(), surface.edges.len(), rim];
        let keys = ["faces", "edges", "boundary_edges"];
        assert_eq!(
            found.map(|n| n as u64),
            keys.map(|key| counts[key].as_u64().unwrap()),
            "{name}"
        );
        close(surface.mean_edge(), &expected["mean_edge_length"], tolerance, name);
        let folds = surface.edges.iter().filter_map(|edge| surface.fold(edge));
        let folds: Vec<f64> = folds.map(f64::to_degrees).collect();
        let fold = &expected["fold_deg"];
        close(folds.iter().copied().fold(f64::INFINITY, f64::min), &fold["min"], 1e-4, name);
        close(folds.iter().copied().fold(f64::NEG_INFINITY, f64::max), &fold["max"], 1e-4, name);
        close(folds.iter().map(|fold| fold.abs()).sum(), &fold["sum_abs"], 1e-2, name);
        for own in list(&expected["edges"]) {
            let ends: [u32; 2] = serde_json::from_value(own["edge"].clone()).unwrap();
            let edge = surface.edges.iter().find(|edge| edge.ends == ends).unwrap();
            close(surface.length(edge), &own["length"], tolerance, name);
            if own["fold_deg"].is_number() {
                let fold = surface.fold(edge).unwrap().to_degrees();
                close(fold, &own["fold_deg"], 1e-4, &format!("{name} {ends:?}"));
            }
        }
    }
}

#[test]
fn panels_laid_flat_and_their_types_agree() {
    for name in CASES {
        let Some((expected, mesh, tolerance)) = case(name) else { return };
        let surface = PanelSurface::new(&mesh).unwrap();
        let flat: Vec<_> = (0..mesh.faces.len() as u32).map(|f| lay_flat(&surface, f)).collect();
        let worst = flat.iter().flatten().map(|panel| panel.flatness).fold(0.0, f64::max);
        close(worst, &expected["planarity_max"], tolerance, name);
        let error = flat.iter().flatten().map(|panel| panel.flattening_error).fold(0.0, f64::max);
        close(error, &expected["flattening_error_max"], tolerance, name);
        let joint = number(&expected["inputs"]["joint_width"]);
        for own in list(&expected["panels"]) {
            let panel = flat[own["face"].as_u64().unwrap() as usize].as_ref().unwrap();
            let what = format!("{name}, face {}", own["face"]);
            close(panel.flatness, &own["planarity"], tolerance, &what);
            close(area(&panel.corners), &own["area"], tolerance, &what);
            let edges = |corners: &[[f64; 2]], key: &str, over: usize| {
                for (k, expected) in list(&own[key]).iter().enumerate() {
                    let [a, b] = [corners[k], corners[(k + over) % corners.len()]];
                    let length = ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
                    close(length, expected, tolerance, &format!("{what}, {key} {k}"));
                }
            };
            edges(&panel.corners, "flat_edges", 1);
            edges(&panel.corners, "flat_diagonals", 2);
            let cut = inset(&panel.corners, 0.5 * joint).unwrap();
            close(area(&cut), &own["inset_area"], tolerance, &what);
            edges(&cut, "inset_edges", 1);
        }
        for own in list(&expected["classes"]) {
            let of_edge = number(&own["tolerance_over_mean_edge"]);
            let setbacks = |f: usize| vec![0.0; surface.faces.row(f).len()];
            let of_edge = of_edge * surface.mean_edge();
            let types = panel_types(&flat, setbacks, of_edge, own["mirror"] == true);
            assert_eq!(types.leaders.len() as u64, own["count"].as_u64().unwrap(), "{name} {own}");
            let all: u32 = types.counts.iter().sum();
            assert_eq!(all as usize, mesh.faces.len());
        }
    }
}

#[test]
fn node_axes_and_the_build_check_agree() {
    let mut compared = 0;
    for name in CASES {
        let Some((expected, mesh, tolerance)) = case(name) else { return };
        let surface = PanelSurface::new(&mesh).unwrap();
        for own in list(&expected["normals"]) {
            let v = own["vertex"].as_u64().unwrap() as usize;
            let found: [f64; 3] = surface.normals[v].into();
            (0..3).for_each(|k| close(found[k], &own["N"][k], 1e-6, name));
        }
        let distance = number(&expected["inputs"]["offset_distance"]);
        let follow = number(&expected["inputs"]["follow"]);
        for kind in OffsetKind::ALL {
            let id = format!("{kind:?}").to_lowercase();
            for way in ["exact", "fit"] {
                let own = &expected["axes"][format!("{way}_{id}")];
                // On a mesh without exact axes the remainder of the proximal steps is not
                // comparable.
                if own.is_null() || (way == "exact" && name == "halftunnel") {
                    continue;
                }
                let axes = match way {
                    "exact" => exact(&surface, kind),
                    _ => fit(&surface, kind, follow),
                };
                let what = format!("{name}, {way} {id}");
                let per_axis = match (name, way) {
                    ("dodecahedron", _) => 1e-5,
                    (_, "exact") => 1e-7,
                    _ => 1e-6,
                };
                for sample in list(&own["samples"]) {
                    let found: [f64; 3] = axes[sample["vertex"].as_u64().unwrap() as usize].into();
                    (0..3).for_each(|k| close(found[k], &sample["n"][k], per_axis, &what));
                }
                for own in list(&own["nodes"]) {
                    compare_node(&surface, &axes, own, &expected["inputs"], tolerance, &what);
                }
                compare(&check(&surface, &axes, kind, distance), &own["report"], tolerance, &what);
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 11);
}

/// Compares the beams around a node, starting at the first expected one, and the steps of their
/// prisms.
fn compare_node(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    expected: &Value,
    inputs: &Value,
    tolerance: f64,
    what: &str,
) {
    let v = expected["vertex"].as_u64().unwrap() as usize;
    let node = nodes(surface, axes)[v].clone().unwrap();
    let cuts = end_cuts(surface, axes, &node, number(&inputs["beam_width"]));
    let ring: Vec<u32> = serde_json::from_value(expected["ring"].clone()).unwrap();
    let n = node.spokes.len();
    let first = node.spokes.iter().position(|spoke| spoke.to == ring[0]).unwrap();
    for (k, &to) in ring.iter().enumerate() {
        let what = format!("{what}, node {v}, beam {k}");
        let spoke = &node.spokes[(first + k) % n];
        assert_eq!(spoke.to, to, "{what}");
        let azimuth = spoke.azimuth_deg - node.spokes[first].azimuth_deg;
        let azimuth = if azimuth < 0.0 { azimuth + 360.0 } else { azimuth };
        close(azimuth, &expected["azimuth_deg"][k], 1e-4, &what);
        close(spoke.elevation_deg, &expected["elevation_deg"][k], 1e-4, &what);
        if expected["mitre_step"][k].is_number() {
            close(cuts[(first + k) % n].step, &expected["mitre_step"][k], tolerance, &what);
        }
    }
}

fn compare(found: &OffsetCheck, expected: &Value, tolerance: f64, what: &str) {
    let at = |key: &str| (&expected[key], format!("{what}, {key}"));
    let length = |value: f64, key: &str| {
        let (expected, what) = at(key);
        close(value, expected, tolerance, &what);
    };
    length(found.warp, "beam_warp_max");
    length(found.offset_flatness, "offset_planarity_max");
    length(found.edge_distance[0], "edge_distance_min");
    length(found.edge_distance[1], "edge_distance_max");
    for (value, key) in
        [(found.twist_deg, "beam_twist_deg_max"), (found.lean_deg, "axis_tilt_deg_max")]
    {
        let (expected, what) = at(key);
        close(value, expected, 1e-4, &what);
    }
    for (value, key) in
        found.safe_distance.into_iter().zip(["safe_distance_min", "safe_distance_max"])
    {
        let (expected, what) = at(key);
        match value {
            Some(value) => close(value, expected, 1e-5 * number(expected).abs(), &what),
            None => assert!(expected.is_null(), "{what}"),
        }
    }
}
