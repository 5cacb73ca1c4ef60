//! Meshes to begin with: sound, of the requested size, and refused for wrong sizes.

use shape_up::generate::{NEW_KINDS, NewKind, NewMeshError};
use shape_up::math::{Vec3, twice_vector_area};
use shape_up::mesh::{CurvatureLines, Mesh, SizeError, SizeOf, Topology, diagnose};

fn of(id: &str) -> &'static NewKind {
    NewKind::of(id).unwrap()
}

/// The Euler number.
fn euler(mesh: &Mesh, topology: &Topology) -> i64 {
    mesh.positions.len() as i64 - topology.edges().len() as i64 + mesh.faces.len() as i64
}

/// Two sets of sizes: the defaults, and the fewest panels.
fn variants(kind: &NewKind) -> [Vec<f64>; 2] {
    let fewest = kind.sizes.iter().map(|size| match size.of {
        SizeOf::Count => size.least,
        _ => size.default,
    });
    [kind.defaults(), fewest.collect()]
}

#[test]
fn every_kind_is_a_sound_manifold_whose_faces_turn_one_way() {
    for kind in NEW_KINDS {
        for sizes in variants(kind) {
            let mesh = kind.mesh(&sizes).unwrap();
            let at = (kind.id, &sizes);
            assert!(diagnose(&mesh).is_empty(), "{at:?}: {:?}", diagnose(&mesh));
            let topology = Topology::new(&mesh);
            let whole = euler(&mesh, &topology);
            let ring = ["dome", "cone", "funnel", "tube"].contains(&kind.id);
            assert_eq!(whole, if ring { 0 } else { 1 }, "{at:?}");
            // The two faces of an edge traverse it in opposite directions.
            let mut walked = std::collections::BTreeSet::new();
            for face in mesh.faces.iter() {
                for i in 0..face.len() {
                    assert!(walked.insert((face[i], face[(i + 1) % face.len()])), "{at:?}");
                }
            }
            assert!(topology.edge_faces().iter().all(|faces| (1..=2).contains(&faces.len())));
        }
    }
}

#[test]
fn sheets_look_up_and_rounds_look_outwards() {
    for kind in NEW_KINDS {
        let mesh = kind.mesh(&kind.defaults()).unwrap();
        for face in mesh.faces.iter() {
            let corners = face.iter().map(|&v| Vec3::from(mesh.positions[v as usize]));
            let area = twice_vector_area(corners);
            let middle = mesh.positions[face[0] as usize];
            let out = area.x * middle[0] + area.y * middle[1];
            let is_sheet = !["cone", "tube", "funnel", "torus"].contains(&kind.id);
            assert!(if is_sheet { area.z > 0.0 } else { area.z.abs() + out.abs() > 0.0 });
            if ["cone", "tube"].contains(&kind.id) {
                assert!(out > 0.0, "{}", kind.id);
            }
        }
    }
}

#[test]
fn a_cone_and_a_dome_close_in_a_point() {
    for (id, sizes) in [("cone", [6.0, 0.0, 4.0, 12.0, 3.0]), ("dome", [6.0, 2.0, 0.0, 12.0, 3.0])]
    {
        let mesh = of(id).mesh(&sizes).unwrap();
        let topology = Topology::new(&mesh);
        assert_eq!(euler(&mesh, &topology), 1, "{id}");
        assert_eq!(mesh.faces.iter().filter(|face| face.len() == 3).count(), 12);
        assert_eq!(mesh.positions.last().unwrap()[..2], [0.0, 0.0]);
        assert!(
            (mesh.positions.last().unwrap()[2] - sizes[if id == "cone" { 2 } else { 1 }]).abs()
                < 1e-12
        );
    }
}

#[test]
fn a_barrel_lies_on_its_cylinder_and_a_dome_on_its_sphere() {
    let barrel = of("barrel").mesh(&[20.0, 12.0, 4.0, 16.0, 12.0]).unwrap();
    let radius: f64 = (36.0 + 16.0) / 8.0;
    for [_, y, z] in barrel.positions {
        assert!((y * y + (z + radius - 4.0).powi(2) - radius * radius).abs() < 1e-10);
    }
    let dome = of("dome").mesh(&[16.0, 5.0, 2.0, 24.0, 8.0]).unwrap();
    let radius: f64 = (64.0 + 25.0) / 10.0;
    for [x, y, z] in dome.positions {
        assert!((x * x + y * y + (z + radius - 5.0).powi(2) - radius * radius).abs() < 1e-10);
    }
}

#[test]
fn edges_of_what_is_turned_around_an_axis_follow_the_lines_of_curvature() {
    for id in ["barrel", "torus", "funnel", "tube"] {
        let mesh = of(id).mesh(&of(id).defaults()).unwrap();
        let topology = Topology::new(&mesh);
        let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &topology);
        assert!(lines.mean.unwrap() < 3.0, "{id}: {:?}", lines.mean);
    }
    let hypar = of("hypar").mesh(&of("hypar").defaults()).unwrap();
    let topology = Topology::new(&hypar);
    let lines = CurvatureLines::new(&hypar.positions, &hypar.faces, &topology);
    assert!(lines.mean.unwrap() > 35.0, "straight lines are asymptotic: {:?}", lines.mean);
}

#[test]
fn small_hexagons_are_as_exact_as_large_ones_and_counted_once() {
    let large = of("hexagons").mesh(&[20.0, 12.0, 3.0, 1.0]).unwrap();
    let small = of("hexagons").mesh(&[0.02, 0.012, 0.003, 0.001]).unwrap();
    assert_eq!(small.faces, large.faces);
    let pairs = small.positions.as_flattened().iter().zip(large.positions.as_flattened());
    pairs.for_each(|(small, large)| assert!((1000.0 * small - large).abs() < 1e-9));
    let many = of("hexagons").mesh(&[260.0, 222.0, 3.0, 1.0]).unwrap();
    assert!((60_000..70_000).contains(&many.faces.len()), "{}", many.faces.len());
}

#[test]
fn wrong_sizes_are_refused_with_what_was_expected() {
    for kind in NEW_KINDS {
        for (i, size) in kind.sizes.iter().enumerate() {
            for bad in [f64::NAN, f64::INFINITY, -1.0, size.most * 2.0] {
                let mut sizes = kind.defaults();
                sizes[i] = bad;
                let error = kind.mesh(&sizes).unwrap_err();
                assert!(matches!(error, NewMeshError::Size(SizeError::Outside { .. })), "{error}");
            }
        }
        let (expected, found) = (kind.sizes.len(), 0);
        assert_eq!(
            kind.mesh(&[]).unwrap_err(),
            NewMeshError::Size(SizeError::Number { expected, found })
        );
    }
    let message = |id: &str, sizes: &[f64]| of(id).mesh(sizes).unwrap_err().to_string();
    assert_eq!(
        message("grid", &[20.0, 12.0, 2.5, 3.0]),
        "Panels along: expected a whole number from 1 to 500, found 2.5"
    );
    assert!(message("dome", &[6.0, 2.0, 7.0, 12.0, 3.0]).contains("smaller than the diameter"));
    assert!(message("torus", &[5.0, 5.0, 90.0, 4.0, 4.0]).contains("smaller than that of the arc"));
    assert!(message("grid", &[1.0, 1.0, 500.0, 500.0]).contains("100\u{2009}000 faces"));
    assert!(
        message("hexagons", &[1000.0, 1000.0, 0.0, 0.001]).contains("more than 100\u{2009}000")
    );
}
