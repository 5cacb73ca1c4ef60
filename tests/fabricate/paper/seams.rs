//! Seams: edges along which a paper model is cut since the user says so.

use super::{assert_whole, cases, model, scale, settings};
use crate::fabricate::{build, metres, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::paper::{JointKind, PaperModel};
use shape_up::fabricate::{Build, Stand};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Fold, Pieces};
use std::rc::Rc;

/// Those of the edges between two panels that are chosen by their numbers.
fn chosen(mesh: &Mesh, is_chosen: impl Fn(usize) -> bool) -> Rc<[[u32; 2]]> {
    let surface = build(mesh, &settings(Pieces::Nets)).surface;
    let inner = surface.edges.iter().filter(|edge| !edge.is_rim());
    // Their order does not count, nor that of their ends.
    let inner = inner.enumerate().filter(|(k, _)| is_chosen(*k)).map(|(_, edge)| edge.ends);
    inner.map(|[a, b]| if a % 2 == 0 { [a, b] } else { [b, a] }).collect()
}

/// Whether each joint of a model is at one of the seams of its settings.
fn at_seams(made: &Build) -> Vec<bool> {
    let is_seam =
        |ends: [u32; 2]| made.settings.seams.iter().any(|&[a, b]| ends == [a, b] || ends == [b, a]);
    let edges = model(made).net.joints.iter().map(|joint| joint.edge);
    edges.map(|edge| edge.is_some_and(|e| is_seam(made.surface.edges[e as usize].ends))).collect()
}

/// A vault of 8 by 5 panels along y, which unrolls into one piece.
fn vault() -> Mesh {
    grid(8, 5, |i, j| {
        let x = f64::from(i) - 4.0;
        [x, f64::from(j), 2.0 - 0.1 * x * x]
    })
}

/// The edges of the vault along its ridge.
fn ridge() -> Rc<[[u32; 2]]> {
    (0..5).map(|j| [9 * j + 4, 9 * (j + 1) + 4]).collect()
}

#[test]
fn no_seam_is_a_fold_and_every_facet_is_on_one_piece() {
    for (name, mesh, pieces) in cases() {
        for (fold, step) in [(Fold::Crease, 3), (Fold::Crease, 1), (Fold::Score, 4)] {
            let seams = chosen(&mesh, |k| k % step == 0);
            let own =
                BuildSettings { scale: scale(&mesh), fold, thickness: 1.0, ..settings(pieces) };
            let free = build(&mesh, &own);
            let made = build(&mesh, &BuildSettings { seams: Rc::clone(&seams), ..own });
            let PaperModel { net, joint_kinds, .. } = model(&made);
            let at_seams = at_seams(&made);
            assert_eq!(at_seams.iter().filter(|is_seam| **is_seam).count(), seams.len(), "{name}");
            for ((&is_seam, &folded), kind) in at_seams.iter().zip(&net.folded).zip(joint_kinds) {
                assert!(!is_seam || !folded && !matches!(kind, JointKind::Folded), "{name}");
            }
            assert_eq!(net.facets.len(), model(&free).net.facets.len(), "{name}");
            let mut placed: Vec<u32> = net.pieces.concat();
            placed.sort_unstable();
            assert!(placed.into_iter().eq(0..net.facets.len() as u32), "{name}");
            assert_whole(name, &made);
        }
    }
}

#[test]
fn a_vault_cut_along_its_ridge_is_two_pieces_as_large_as_they_can_be() {
    let own = BuildSettings { scale: 40.0, ..settings(Pieces::Nets) };
    assert_eq!(build(&vault(), &own).parts.len(), 1);
    let made = build(&vault(), &BuildSettings { seams: ridge(), ..own });
    let panels: Vec<usize> = made.parts.iter().map(|part| part.panels.len()).collect();
    assert_eq!(panels, [20, 20]);
    let report = made.report().paper.expect("it is of paper");
    assert_eq!((report.seams, report.tabs, report.without_tab.len()), (5, 5, 0));
    // Of the ridge nothing is folded, of the other edges everything.
    for (is_seam, folded) in at_seams(&made).iter().zip(&model(&made).net.folded) {
        assert_ne!(is_seam, folded);
    }
    assert!(
        text_of(&made, "summary.csv").contains("Seams (seams),B4-13 B13-22 B22-31 B31-40 B40-")
    );
    assert!(!text_of(&build(&vault(), &settings(Pieces::Nets)), "summary.csv").contains("Seams"));
}

#[test]
fn strips_end_at_seams_and_are_divided_evenly_between_them() {
    // 23 panels of 30 mm, of which about 13 fit on a sheet of A3.
    let vault = grid(23, 3, |i, j| [f64::from(i), f64::from(j), 0.002 * f64::from(i * i)]);
    let seams = (0..3).map(|j| [24 * j + 3, 24 * (j + 1) + 3]).collect();
    let own = BuildSettings { scale: 1000.0 / 30.0, tab: 6.0, ..settings(Pieces::Across) };
    let made = build(&vault, &BuildSettings { seams, ..own });
    let mut lengths: Vec<usize> = made.parts.iter().map(|part| part.panels.len()).collect();
    lengths.sort_unstable();
    assert_eq!(lengths, [3, 3, 3, 10, 10, 10, 10, 10, 10]);
}

#[test]
fn a_seam_in_a_plane_is_cut_and_has_a_tab_where_it_gets_one() {
    let plane = grid(5, 4, |i, j| [f64::from(i), f64::from(j), 0.0]);
    // From the rim to the middle: it parts nothing.
    let seams: Rc<[[u32; 2]]> = [[2, 8], [8, 14]].into();
    for tab in [0.0, 8.0] {
        let own = BuildSettings { tab, seams: Rc::clone(&seams), ..settings(Pieces::Nets) };
        let made = build(&plane, &own);
        assert_whole("a plane", &made);
        let model = model(&made);
        for (is_seam, kind) in at_seams(&made).iter().zip(&model.joint_kinds) {
            match kind {
                JointKind::Folded => assert!(!is_seam),
                JointKind::Tab(_) => assert!(tab > 0.0),
                JointKind::Tongue(_) => unreachable!("tabs are asked for"),
                JointKind::Bare => assert!(tab == 0.0),
            }
        }
        // A slit is enough without tabs; they need room between the two sides.
        assert_eq!(made.parts.len(), if tab == 0.0 { 1 } else { 2 });
    }
}

#[test]
fn a_seam_that_is_no_edge_is_named_by_its_path() {
    for (seams, path) in
        [([[0, 1], [0, 10]], "build.seams[1]: found [0, 10]"), ([[0, 1], [0, 999]], "seams[1]")]
    {
        let own = BuildSettings { seams: seams.into(), ..settings(Pieces::Nets) };
        let fault = Build::new(&vault(), &own, metres(), &Stand::default()).expect_err("no edge");
        assert!(fault.to_string().contains(path), "{fault}");
        assert!(fault.to_string().contains("expected the ends of an edge"), "{fault}");
    }
}
