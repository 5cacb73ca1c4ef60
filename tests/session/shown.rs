//! Data for the display of constraints: the elements that they act on, and their projections.

use crate::session::asked::{new, scene};
use crate::support::grid::bumpy;
use shape_up::math::Vec3;
use shape_up::mesh::{Measures, Ragged, Surface};
use shape_up::session::{Edit, Session};

#[test]
fn a_face_shows_the_row_that_says_the_most_about_it() {
    // Three by three quads: a plane on all of them, a sphere on the middle one, and a line along
    // one side, which covers no face.
    let sets = r#", "sets": { "middle": { "faces": [4] }, "side": { "vertices": [0, 1, 2, 3] } }"#;
    let mut session = Session::open(scene(sets), bumpy(3)).expect("it is regular");
    let shown = |session: &Session| {
        let acting = session.acting_rows();
        let used = |row| acting.faces.iter().filter(|face| **face == Some(row)).count();
        let dots: Vec<usize> =
            (0..16).filter(|&vertex| acting.vertices[vertex].is_some()).collect();
        ([used(0), used(1), used(2)], acting.faces[4], dots)
    };
    assert_eq!(shown(&session), ([0; 3], None, vec![]));
    session.edit(new("sphere", r#"{ "set": "middle" }"#)).expect("four vertices fit");
    session.edit(new("plane", r#""faces""#)).expect("quads fit");
    session.edit(new("line", r#"{ "set": "side" }"#)).expect("four vertices fit");
    assert_eq!(shown(&session), ([1, 8, 0], Some(0), vec![0, 1, 2, 3]));
    // The vertices of the side are face corners too, but no face is on the line.
    assert_eq!(session.members(2), [vec![], vec![0, 1, 2, 3]]);
    let [faces, vertices] = session.members(1);
    assert_eq!((faces.len(), vertices.len()), (9, 16));

    let off = |index| Edit::SetConstraint {
        index,
        weight: None,
        require: None,
        enabled: Some(false),
        params: Default::default(),
    };
    session.edit(off(0)).expect("the row is there");
    session.edit(off(2)).expect("the row is there");
    assert_eq!(shown(&session), ([0, 9, 0], Some(1), vec![]));
}

#[test]
fn projections_are_those_that_the_energy_measures() {
    // Translation-invariant kinds and a kind on edges; with the guard, a projection may be from an
    // earlier step.
    for guard in ["", r#", "solver": { "monotone": true }"#] {
        let constraints = r#", "constraints": [
            { "kind": "circle", "on": "faces", "weight": 2 },
            { "kind": "plane", "on": "faces", "enabled": false },
            { "kind": "line", "on": { "each": "curve" } },
            { "kind": "line-segment", "on": { "each": "edge" }, "length": 0.9 },
            { "kind": "equal-length", "on": "faces" } ]"#;
        let mut session =
            Session::open(scene(&format!("{constraints}{guard}")), bumpy(4)).expect("it is valid");
        for _ in 0..4 {
            session.step().expect("positions stay finite");
        }
        let found = session.projections();
        // An equal-length constraint has two points of its own for each side of a panel.
        let counts = [(0, 16 * 4), (1, 0), (3, 40 * 2), (4, 16 * 8)];
        for (row, count) in counts {
            assert_eq!(found.rows.iter().filter(|&&r| r == row).count(), count, "row {row}");
        }
        let weight_of = |row: u32| session.rows()[row as usize].constraints.weight;
        let energy: f64 = found
            .displacements
            .iter()
            .zip(&found.rows)
            .map(|(way, &row)| weight_of(row) * way.iter().map(|x| x * x).sum::<f64>())
            .sum();
        let expected = session.solver().energy().shape;
        assert!((energy - expected).abs() < 1e-12 * expected, "{energy} is not {expected}");

        // A panel is coloured by its worst corner in any of its constraints.
        let worst = |points: &mut dyn Iterator<Item = usize>| {
            points
                .map(|k| found.displacements[k].iter().map(|x| x * x).sum::<f64>().sqrt())
                .fold(0.0, f64::max)
        };
        let residuals = session.face_values("residual").expect("it is a measure");
        for (face, &residual) in session.mesh().faces.iter().zip(&residuals) {
            let on_face = |k: &usize| face.contains(&found.vertices[*k]);
            let expected = worst(&mut (0..found.displacements.len()).filter(on_face));
            assert!(
                (residual - expected).abs() <= 1e-15 * expected,
                "{residual} is not {expected}"
            );
        }

        // The outline of a panel is its four sides, between its own four points.
        let outlines_of = |row: u32| {
            let of_row = |ends: &&[u32; 2]| found.rows[ends[0] as usize] == row;
            found.outlines.iter().filter(of_row).count()
        };
        assert_eq!([0, 3, 4].map(outlines_of), [16 * 4, 40, 16 * 4]);
        for [a, b] in found.outlines.iter().map(|ends| ends.map(|end| end as usize)) {
            assert_eq!(found.rows[a], found.rows[b]);
            let ends = (found.vertices[a], found.vertices[b]);
            assert!(session.topology().edge(ends.0, ends.1).is_some());
        }
        // The circle of the first panel: four coplanar points at equal distance from a centre.
        let at = |point: usize| -> [f64; 3] {
            let vertex = session.positions()[found.vertices[point] as usize];
            std::array::from_fn(|i| vertex[i] + found.displacements[point][i])
        };
        let corners: Vec<_> = (0..4).map(at).collect();
        let faces: Ragged = [[0, 1, 2, 3]].iter().collect();
        let spread = Measures::new(&corners, &faces, 1.0);
        assert!(spread.circularity.max_distance < 1e-9, "{spread:?}");
    }
}

#[test]
fn distances_to_the_original_are_those_of_its_surface_in_every_state() {
    let mut session = Session::open(scene(""), bumpy(6)).expect("it is regular");
    session.edit(new("plane", r#""faces""#)).expect("quads fit");
    let surface = Surface::new(&session.mesh().positions, session.mesh());
    for step in 0..4 {
        let values = session.corner_values("surface").expect("it is of vertices");
        for (found, p) in values.iter().zip(session.positions()) {
            let foot = surface.closest(p, &mut { Surface::NO_HINT });
            let expected = (Vec3::from(foot) - Vec3::from(p)).length();
            assert!((found - expected).abs() < 1e-12, "step {step}: {found}, {expected}");
        }
        assert_eq!(session.corner_values("surface"), Some(values), "asked for twice");
        let measures = Measures::new(&session.positions(), &session.mesh().faces, 1.0);
        assert_eq!(session.measures().planarity_distances, measures.planarity_distances);
        session.step().expect("positions stay finite");
    }
    session.edit(Edit::Reset).expect("it can be reset");
    let largest = session.corner_values("surface").into_iter().flatten().fold(0.0, f64::max);
    assert!(largest < 1e-12, "{largest}");
}
