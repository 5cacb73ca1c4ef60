//! Panels that leave the surface as fair as it was: rough results of a press are avoided, or named.

use crate::support::grid::grid;
use shape_up::mesh::{Mesh, mean_dihedral_angle};
use shape_up::scene::Scene;
use shape_up::session::{BendChange, PanelStart, Session, Verdict};
use std::f64::consts::{PI, TAU};

fn opened(mesh: Mesh) -> Session {
    Session::open(Scene::opened("own.obj"), mesh).unwrap()
}

/// A tower with a waist and three ridges, twisted by this angle, with an open seam.
fn tower(twist: f64) -> Mesh {
    grid(24, 30, |i, j| {
        let [around, height] = [TAU * f64::from(i) / 24.0, f64::from(j) / 30.0];
        let waist = 1.0 - 0.35 * libm::sin(0.8 * PI * height);
        let radius = 6.0 * waist * (1.0 + 0.12 * libm::cos(3.0 * around));
        let turn = around + twist * height;
        [radius * libm::cos(turn), radius * libm::sin(turn), 40.0 * height]
    })
}

/// A hyperbolic paraboloid over a square, divided along its straight lines.
fn hypar() -> Mesh {
    grid(8, 8, |i, j| {
        let [x, y] = [i, j].map(|k| f64::from(k) - 4.0);
        [x, y, 0.1 * x * y]
    })
}

fn press(session: &mut Session, kind: &str, from: PanelStart) -> Verdict {
    session.make_panels(kind, session.tolerance(), from).unwrap();
    while !session.step().unwrap().ended {}
    session.end_run();
    session.verdict(session.tolerance()).unwrap()
}

#[test]
fn a_press_that_would_leave_bumps_ends_with_a_fair_surface_and_the_weights_that_hold_it() {
    let mut session = opened(tower(PI / 2.0));
    let before = session.scene();
    let verdict = press(&mut session, "circle", PanelStart::Now);
    // With the smoothness of an opened mesh, neighbours met at 16 degrees instead of 9.
    assert_eq!((verdict.within, verdict.folded), (verdict.of, 0), "{verdict:?}");
    assert_eq!(verdict.bend.change, None, "{:?}", verdict.bend);
    assert!((8.0..11.0).contains(&verdict.bend.rest), "{:?}", verdict.bend);
    let smooth = session.document().weights.smooth;
    assert!(smooth > 1.0, "{smooth}");
    // The shape is the solution with these weights: another run changes nothing.
    let shape = session.positions();
    session.begin_run();
    while !session.step().unwrap().ended {}
    session.end_run();
    assert_eq!(session.positions(), shape);
    session.undo().unwrap();
    assert!(session.scene() == before);
}

#[test]
fn a_surface_that_becomes_flat_is_said_to() {
    let mut session = opened(hypar());
    let verdict = press(&mut session, "plane", PanelStart::Now);
    assert_eq!(verdict.within, verdict.of);
    assert_eq!(verdict.bend.change, Some(BendChange::Flatter), "{:?}", verdict.bend);
}

#[test]
fn a_rough_surface_is_said_to_be_and_a_smoother_one_is_fairer_and_one_step_of_undo() {
    // Soft constraints: no other attempts are made.
    let mut session = opened(tower(PI));
    session.make_panels("circle", f64::INFINITY, PanelStart::Now).unwrap();
    for _ in 0..2000 {
        session.step().unwrap();
    }
    session.end_run();
    let rough = session.verdict(session.tolerance()).unwrap();
    assert_eq!(rough.bend.change, Some(BendChange::Rougher), "{:?}", rough.bend);
    let before = session.scene();
    let fair = press(&mut session, "circle", PanelStart::Smoother);
    assert_eq!(fair.bend.change, None, "{:?}", fair.bend);
    session.undo().unwrap();
    assert!(session.scene() == before);
}

#[test]
fn the_angle_between_neighbours_is_that_of_a_prism_whatever_their_orientation() {
    let mut mesh = grid(6, 2, |i, j| {
        let turn = TAU * f64::from(i) / 6.0;
        [libm::cos(turn), libm::sin(turn), f64::from(j)]
    });
    // Half of the edges are between coplanar faces, the others on a hexagon: 5 of 2 rows each.
    let expected = 60.0 * 10.0 / 16.0;
    for _ in 0..2 {
        let session = opened(mesh.clone());
        let angle = mean_dihedral_angle(&mesh, session.topology(), &mesh.positions);
        assert!((angle - expected).abs() < 1e-9, "{angle}");
        let flipped = |(f, face): (usize, &[u32])| match f {
            3 => face.iter().rev().copied().collect(),
            _ => face.to_vec(),
        };
        mesh.faces = mesh.faces.iter().enumerate().map(flipped).collect();
    }
}
