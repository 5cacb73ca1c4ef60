//! Meshes from plans: sound, inside their outline, of the requested height, and refused for wrong
//! plans.

use proptest::prelude::*;
use shape_up::generate::{Plan, PlanError, PlanLayout, PlanPoint, PlanSurface, Support};
use shape_up::math::{Vec3, cosine, sine, twice_vector_area};
use shape_up::mesh::{Mesh, Topology, diagnose};
use std::collections::BTreeSet;

fn points(places: &[[f64; 2]]) -> Vec<PlanPoint> {
    places.iter().map(|&at| PlanPoint { at, bulge: 0.0, corner: true }).collect()
}

fn circle([x, y]: [f64; 2], radius: f64) -> Vec<PlanPoint> {
    let point = |x| PlanPoint { at: [x, y], bulge: 1.0, corner: false };
    vec![point(x - radius), point(x + radius)]
}

fn plan(outline: Vec<PlanPoint>, layout: PlanLayout) -> Plan {
    Plan {
        outline,
        holes: Vec::new(),
        layout,
        size: 1.0,
        turn: 0.0,
        height: 3.0,
        support: Support::Outline,
    }
}

const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [20.0, 0.0], [20.0, 12.0], [0.0, 12.0]];
const ELL: [[f64; 2]; 6] =
    [[0.0, 0.0], [20.0, 0.0], [20.0, 7.0], [9.0, 7.0], [9.0, 16.0], [0.0, 16.0]];

/// Areas of the faces projected onto the plan.
fn areas(mesh: &Mesh) -> Vec<f64> {
    let corners = |face: &[u32]| -> Vec<_> {
        face.iter().map(|&v| Vec3::from(mesh.positions[v as usize])).collect()
    };
    mesh.faces.iter().map(|face| 0.5 * twice_vector_area(corners(face)).z).collect()
}

fn assert_sound(mesh: &Mesh) {
    assert!(diagnose(mesh).is_empty(), "{:?}", diagnose(mesh));
    assert!(areas(mesh).iter().all(|&area| area > 0.0), "seen from above counterclockwise");
    let topology = Topology::new(mesh);
    assert!(topology.edge_faces().iter().all(|faces| faces.len() <= 2));
}

#[test]
fn a_rectangle_becomes_squares_in_both_layouts() {
    for layout in [PlanLayout::Follow, PlanLayout::Cut] {
        let mesh = plan(points(&RECTANGLE), layout).mesh().unwrap();
        assert_sound(&mesh);
        assert_eq!((mesh.positions.len(), mesh.faces.len()), (21 * 13, 240), "{layout:?}");
        assert!(areas(&mesh).iter().all(|area| (area - 1.0).abs() < 1e-9));
        let top = mesh.positions.iter().map(|p| p[2]).fold(0.0, f64::max);
        assert!((top - 3.0).abs() < 1e-12);
        let is_edge = |p: &[f64; 3]| (p[0] * (p[0] - 20.0) * p[1] * (p[1] - 12.0)).abs() < 1e-9;
        assert!(mesh.positions.iter().all(|p| is_edge(p) == (p[2] == 0.0)));
    }
}

#[test]
fn the_direction_of_the_points_does_not_matter() {
    let mut outline = points(&RECTANGLE);
    outline[1].bulge = 0.5;
    let there = plan(outline.clone(), PlanLayout::Cut).mesh().unwrap();
    // The bulge of a side is stored at its first point.
    let back: Vec<PlanPoint> =
        (0..4).map(|k| PlanPoint { bulge: outline[(6 - k) % 4].bulge, ..outline[3 - k] }).collect();
    let back = plan(back, PlanLayout::Cut).mesh().unwrap();
    assert_eq!(there.faces.len(), back.faces.len());
    let sum = |mesh: &Mesh| areas(mesh).iter().sum::<f64>();
    assert!((sum(&there) - sum(&back)).abs() < 1e-9);
    // The bay is outside the rectangle.
    assert!(sum(&there) > 240.0 + 10.0, "{}", sum(&there));
}

#[test]
fn inward_arcs_can_turn_an_outline_around() {
    // The arc of the first side passes beyond the other three, which form the inner side of an
    // arch.
    let mut outline = points(&[[0.0, 0.0], [20.0, 0.0], [18.0, 1.0], [2.0, 1.0]]);
    outline[0].bulge = -1.0;
    outline[2].bulge = 0.4;
    let mesh = plan(outline, PlanLayout::Follow).mesh().unwrap();
    assert_sound(&mesh);
    // The sine of four times the angle whose tangent is the bulge.
    let (angle, sine) = (4.0 * 0.4_f64.atan(), 4.0 * 0.4 * 0.84 / (1.16 * 1.16));
    let inner = 18.0 + 0.5 * 11.6 * 11.6 * (angle - sine);
    let expected = 50.0 * std::f64::consts::PI - inner;
    let area: f64 = areas(&mesh).iter().sum();
    assert!((area / expected - 1.0).abs() < 0.02, "{area} of {expected}");
}

#[test]
fn a_circle_is_as_large_as_it_is() {
    let mesh = plan(circle([3.0, -2.0], 8.0), PlanLayout::Cut).mesh().unwrap();
    assert_sound(&mesh);
    let area: f64 = areas(&mesh).iter().sum();
    assert!((area / (64.0 * std::f64::consts::PI) - 1.0).abs() < 0.01, "{area}");
    for p in &mesh.positions {
        let radius = ((p[0] - 3.0).powi(2) + (p[1] + 2.0).powi(2)).sqrt();
        assert!(radius < 8.0 + 1e-9);
        assert_eq!(p[2] == 0.0, radius > 8.0 - 2e-3, "it stands on its outline alone");
    }
}

#[test]
fn a_grid_follows_arcs_and_points_between_corners() {
    let mut outline = points(&[[0.0, 0.0], [10.0, -1.0], [20.0, 0.0], [20.0, 12.0], [0.0, 12.0]]);
    outline[1].corner = false;
    outline[2].bulge = 0.3;
    let plan = Plan { support: Support::Corners, ..plan(outline, PlanLayout::Follow) };
    let PlanSurface { mesh, feet } = plan.surface().unwrap();
    assert_sound(&mesh);
    let at = |x: f64, y: f64| mesh.positions.iter().filter(|p| p[0] == x && p[1] == y).count();
    assert_eq!([at(10.0, -1.0), at(20.0, 12.0), at(0.0, 0.0)], [1, 1, 1]);
    let on_ground = (0..).zip(&mesh.positions).filter(|(_, p)| p[2] == 0.0).map(|(v, _)| v);
    assert_eq!(on_ground.collect::<BTreeSet<u32>>(), feet.into_iter().collect());
    // The rise of the arc is its bulge times half its chord.
    let east = mesh.positions.iter().map(|p| p[0]).fold(0.0, f64::max);
    assert!((east - 21.8).abs() < 0.05, "{east}");
}

#[test]
fn a_plan_far_from_the_origin_is_followed_as_closely_as_one_at_it() {
    let mesh = |east: f64, north: f64| {
        let mut outline = points(&[[0.0, 0.0], [30.0, 0.0], [34.0, 20.0], [0.0, 22.0]]);
        for (point, bulge) in outline.iter_mut().zip([0.3, -0.2, 0.4, 0.1]) {
            point.at = [point.at[0] + east, point.at[1] + north];
            point.bulge = bulge;
        }
        plan(outline, PlanLayout::Follow).mesh().unwrap()
    };
    let near = mesh(0.0, 0.0);
    let far = mesh(450_000.0, 5_500_000.0);
    assert_eq!(near.faces, far.faces);
    for (p, q) in near.positions.iter().zip(&far.positions) {
        let by = [q[0] - 450_000.0 - p[0], q[1] - 5_500_000.0 - p[1]];
        assert!(by.iter().all(|x| x.abs() < 1e-4), "{p:?} is moved by {by:?}");
    }
}

#[test]
fn holes_stay_open_and_the_corners_of_all_loops_are_there() {
    let hole = points(&[[3.0, 3.0], [6.3, 3.0], [6.3, 6.1], [3.0, 6.1]]);
    let plan =
        Plan { holes: vec![hole, circle([15.0, 3.5], 1.7)], ..plan(points(&ELL), PlanLayout::Cut) };
    let mesh = plan.mesh().unwrap();
    assert_sound(&mesh);
    let topology = Topology::new(&mesh);
    assert_eq!(topology.boundary_loops().len(), 3);
    let area: f64 = areas(&mesh).iter().sum();
    let expected = 20.0 * 7.0 + 9.0 * 9.0 - 3.3 * 3.1 - std::f64::consts::PI * 1.7 * 1.7;
    assert!((area / expected - 1.0).abs() < 0.01, "{area} of {expected}");
    for corner in ELL.iter().chain(&[[6.3, 6.1]]) {
        let is_there = |p: &[f64; 3]| (p[0] - corner[0]).abs() + (p[1] - corner[1]).abs() < 1e-9;
        assert!(mesh.positions.iter().any(is_there), "{corner:?}");
    }
}

#[test]
fn what_is_wrong_is_said() {
    let of = |change: fn(&mut Plan)| {
        let mut plan = plan(points(&RECTANGLE), PlanLayout::Follow);
        change(&mut plan);
        plan.mesh().unwrap_err()
    };
    assert_eq!(of(|plan| plan.outline[1].corner = false), PlanError::FourCorners(3));
    assert_eq!(of(|plan| plan.holes = vec![circle([5.0, 5.0], 2.0)]), PlanError::Holes);
    let crossing = of(|plan| plan.outline.swap(0, 1));
    assert_eq!(
        crossing.to_string(),
        "side 2 of the outline (outline[1]) and side 4 of the outline (outline[3]) cross or touch"
    );
    assert_eq!(
        format!("{crossing:#}"),
        "side 2 of the outline and side 4 of the outline cross or touch"
    );
    let of_hole = PlanError::Outside(0);
    assert_eq!(of_hole.to_string(), "hole 1 (holes[0]) lies outside the outline");
    assert_eq!(format!("{of_hole:#}"), "hole 1 lies outside the outline");
    assert_eq!(
        of(|plan| {
            plan.layout = PlanLayout::Cut;
            plan.holes = vec![circle([50.0, 5.0], 2.0)];
        }),
        PlanError::Outside(0)
    );
    assert_eq!(
        of(|plan| {
            plan.layout = PlanLayout::Cut;
            plan.holes = vec![circle([5.4, 5.4], 0.1)];
        }),
        PlanError::TooCoarse(Some(0))
    );
    let island = of(|plan| {
        plan.layout = PlanLayout::Cut;
        plan.holes = vec![circle([10.0, 6.0], 5.0), circle([10.0, 6.0], 2.0)];
    });
    assert_eq!(format!("{island:#}"), "hole 2 lies inside hole 1");
    assert!(matches!(of(|plan| plan.size = 1e-3), PlanError::TooManyFaces(_)));
    assert!(of(|plan| plan.size = 1e9).to_string().contains("from 0.000001 to 1000000, found"));
    let text = r#"{"outline":[{"at":[0,0],"bulge":"x"}],"layout":"cut","size":1,"height":1,"stands":"outline"}"#;
    let error = Plan::from_json(text).unwrap_err().to_string();
    assert!(error.starts_with("outline[0].bulge: found \"x\", expected a number"), "{error}");
    // A point is an object everywhere.
    let text = r#"{"outline":[],"holes":[[[[0,0],0,false]]],"layout":"cut","size":1,"height":1,"stands":"outline"}"#;
    let error = Plan::from_json(text).unwrap_err().to_string();
    assert!(error.starts_with("holes[0][0]: ") && error.contains("expected an object"), "{error}");
}

#[test]
fn a_hole_or_a_notch_too_narrow_for_the_panels_is_refused_and_not_closed() {
    let cut = |plan: Plan| Plan { layout: PlanLayout::Cut, size: 2.0, ..plan }.mesh();
    let rectangle = || plan(points(&RECTANGLE), PlanLayout::Cut);
    // Around a vertex of the grid, which alone is moved onto it.
    let small = cut(Plan { holes: vec![circle([10.0, 6.0], 0.5)], ..rectangle() });
    assert_eq!(small, Err(PlanError::TooCoarse(Some(0))));
    // Along a line of the grid.
    let slot = [
        [0.0, 0.0],
        [9.9, 0.0],
        [9.9, 8.0],
        [10.1, 8.0],
        [10.1, 0.0],
        [20.0, 0.0],
        [20.0, 12.0],
        [0.0, 12.0],
    ];
    let notch = cut(plan(points(&slot), PlanLayout::Cut));
    assert_eq!(notch, Err(PlanError::TooCoarse(None)));
    let wide = cut(Plan { holes: vec![circle([10.0, 6.0], 2.5)], ..rectangle() }).unwrap();
    assert_eq!(Topology::new(&wide).boundary_loops().len(), 2);
}

/// A tip that is narrower than a cell up to its other end was taken as cut off, though all was closed.
#[test]
fn a_needle_and_a_pointed_notch_are_kept_by_small_panels_and_else_refused() {
    let cut = |plan: Plan, size: f64| Plan { size, layout: PlanLayout::Cut, ..plan }.mesh();
    let needle = points(&[[5.0, 5.0], [15.0, 5.2], [5.0, 5.4]]);
    let needle = Plan { holes: vec![needle], ..plan(points(&RECTANGLE), PlanLayout::Cut) };
    assert_eq!(cut(needle.clone(), 1.0), Err(PlanError::TooCoarse(Some(0))));
    let open = cut(needle, 0.25).unwrap();
    assert_eq!(Topology::new(&open).boundary_loops().len(), 2);

    let with_notch = |half: f64| {
        let mouth = [[10.0 - half, 0.0], [10.0, 8.0], [10.0 + half, 0.0]];
        let around = [[20.0, 0.0], [20.0, 12.0], [0.0, 12.0], [0.0, 0.0]];
        plan(points(&[&mouth[..], &around].concat()), PlanLayout::Cut)
    };
    assert_eq!(cut(with_notch(0.1), 1.0), Err(PlanError::TooCoarse(None)));
    // Where it is wider than a panel it stays; so does a thorn.
    let area = |half: f64| areas(&cut(with_notch(half), 1.0).unwrap()).iter().sum::<f64>();
    assert!((area(1.5) - (240.0 - 12.0)).abs() < 3.0, "{}", area(1.5));
    let thorn = [[20.0, 4.0], [26.0, 4.2], [20.0, 4.4], [20.0, 12.0], [0.0, 12.0], [0.0, 0.0]];
    let thorn = points(&[&thorn[..], &[[20.0, 0.0]]].concat());
    assert_eq!(cut(plan(thorn, PlanLayout::Cut), 1.0), Err(PlanError::TooCoarse(None)));
}

#[test]
fn a_tip_thinner_than_any_cell_is_cut_off_and_the_rest_is_made() {
    // It was refused at every size, since the tip looks the same in cells of any.
    for size in [1.0, 0.5, 0.25] {
        let outline = points(&[[0.0, 0.0], [10.0, 0.0], [0.0, 3.0]]);
        let mesh = Plan { size, ..plan(outline, PlanLayout::Cut) }.mesh().unwrap();
        assert_sound(&mesh);
        let area: f64 = areas(&mesh).iter().sum();
        assert!((14.0..15.0 + 1e-9).contains(&area), "{size} {area}");
    }
}

prop_compose! {
    /// A star-shaped outline with straight sides and arcs.
    fn outlines()(
        radii in prop::collection::vec((4.0..12.0_f64, -0.2..0.6_f64, any::<bool>()), 4..11),
        turn in 0.0..1.0_f64,
    ) -> Vec<PlanPoint> {
        let n = radii.len() as f64;
        let at = |k: usize, radius: f64| {
            let turns = turn + k as f64 / n;
            [radius * cosine(turns), radius * sine(turns)]
        };
        radii.iter().enumerate().map(|(k, &(radius, bulge, corner))| {
            PlanPoint { at: at(k, radius), bulge, corner }
        }).collect()
    }
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(128))]

    #[test]
    fn any_outline_is_a_sound_mesh_inside_it_or_is_refused(
        outline in outlines(),
        hole in prop::option::of((0.5..2.5_f64, -1.0..1.0_f64)),
        size in 0.4..2.0_f64,
        turn in -90.0..90.0_f64,
        follows in any::<bool>(),
    ) {
        let holes = hole.map(|(radius, at)| circle([at, 0.0], radius)).into_iter().collect();
        let layout = if follows { PlanLayout::Follow } else { PlanLayout::Cut };
        let plan = Plan { holes, size, turn, ..plan(outline, layout) };
        if let Ok(mesh) = plan.mesh() {
            assert_sound(&mesh);
            prop_assert!(mesh.positions.iter().all(|p| (0.0..=3.0 + 1e-9).contains(&p[2])));
        }
    }
}

/// The roof stood on the others without a word, or too few were said to be marked; then it was refused at
/// every size.
#[test]
fn a_roof_stands_next_to_a_marked_corner_that_is_cut_off() {
    let standing = |outline: Vec<PlanPoint>, size: f64| {
        let plan = Plan { size, support: Support::Corners, ..plan(outline, PlanLayout::Cut) };
        plan.surface()
    };
    let distance =
        |p: &[f64; 3], [x, y]: [f64; 2]| ((p[0] - x).powi(2) + (p[1] - y).powi(2)).sqrt();
    for tips in [
        [[0.0, 0.0], [20.0, 0.0], [0.0, 8.0]],
        [[0.0, 0.0], [20.0, 0.0], [0.0, 12.0]],
        [[0.0, 0.0], [20.0, 0.0], [10.0, 5.0]],
    ] {
        for size in [2.0, 1.25, 1.0, 0.5, 0.25] {
            let PlanSurface { mesh, feet } = standing(points(&tips), size).unwrap();
            assert_sound(&mesh);
            assert_eq!(feet.len(), 3, "{tips:?} {size}");
            for (&foot, &tip) in feet.iter().zip(&tips) {
                let foot = mesh.positions[foot as usize];
                assert_eq!(foot[2], 0.0);
                assert!(distance(&foot, tip) < 3.0 * size, "{foot:?} is far from {tip:?}");
            }
        }
    }
    for k in 1..40 {
        let tip = [20.0 + 0.1 * f64::from(k), 6.0];
        let outline = points(&[[0.0, 0.0], [20.0, 5.7], tip, [20.0, 6.2], [0.0, 12.0]]);
        match standing(outline, 1.0) {
            Ok(surface) => assert_eq!(surface.feet.len(), 5, "{tip:?}"),
            Err(error) => assert_eq!(error, PlanError::TooCoarse(None), "{tip:?}"),
        }
        // In a hole, it is the hole that is too small.
        let holes = vec![points(&[[5.0, 1.0], [20.0, 5.7], tip, [20.0, 6.2], [5.0, 11.0]])];
        let outline = points(&[[-2.0, -2.0], [30.0, -2.0], [30.0, 14.0], [-2.0, 14.0]]);
        let support = Support::Corners;
        match (Plan { holes, support, ..plan(outline, PlanLayout::Cut) }).surface() {
            Ok(surface) => assert_eq!(surface.feet.len(), 9, "{tip:?}"),
            Err(error) => assert_eq!(error, PlanError::TooCoarse(Some(0)), "{tip:?}"),
        }
    }
}

/// Its cells were counted over the whole extent, and it was refused.
#[test]
fn a_narrow_ring_has_as_many_panels_as_fit_inside_it() {
    let ring = |size: f64| {
        let holes = vec![circle([0.0, 0.0], 48.0)];
        Plan { size, holes, ..plan(circle([0.0, 0.0], 50.0), PlanLayout::Cut) }.mesh()
    };
    let mesh = ring(0.3).unwrap();
    assert!((6_000..9_000).contains(&mesh.faces.len()), "{}", mesh.faces.len());
    let crowded = ring(0.09).unwrap_err();
    assert_eq!(crowded, PlanError::TooManyCells);
    let said = format!("{crowded:#}");
    assert!(said.ends_with("1\u{2009}000\u{2009}000 panels: increase their size, Panel"), "{said}");
    assert!(matches!(ring(0.02), Err(PlanError::TooManyFaces(_))));
    // Its area is that of 99 905 panels, and more are cut along its sides.
    let square = points(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let turned = Plan { size: 0.03164, turn: 45.0, ..plan(square, PlanLayout::Cut) };
    assert!(matches!(turned.mesh(), Err(PlanError::TooManyFaces(_))));
}
