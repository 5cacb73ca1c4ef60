//! The statements of each example, measured after solving it with its own settings.

use crate::examples::gallery::{Results, compare_with_gallery};
use crate::examples::solved::{Measured, Run, halves_apart, with_own_vertices};
use shape_up::generate::example::EXAMPLES;

/// The id of an example, and the measurement of its statement.
type Statement = (&'static str, fn(&Run) -> Measured);

/// In the order of the examples.
const STATEMENTS: &[Statement] = &[
    ("canopy", |run| {
        vec![
            ("e_c before", run.e_c()[0], 5.5e-6..6.5e-6),
            ("farthest before", run.before.circularity.max_distance, 0.42..0.43),
            ("e_c", run.e_c()[1], 0.0..1e-20),
            ("corners", run.worst[0][1], 0.0..1e-9),
        ]
    }),
    ("dome", |run| {
        vec![
            ("crown before", run.worst[1][0], 0.18..0.2),
            ("crown", run.worst[1][1], 0.0..0.01),
            ("rim before", run.worst[2][0], 0.45..0.55),
            ("rim", run.worst[2][1], 0.0..0.002),
        ]
    }),
    ("hypar", |run| {
        vec![
            ("lines before", run.worst[0][0], 1.0..1.1),
            ("lines", run.worst[0][1], 0.0..0.02),
            ("e_p", run.e_p()[1], 2e-7..1e-6),
            ("warped", run.after.planarity.mean_distance, 0.0145..0.0155),
        ]
    }),
    ("other-new-panels", |run| run.new_panels([480, 0], [0.012..0.013, 0.15..0.16])),
    ("station-roof", |run| run.new_panels([576, 4], [0.032..0.033, 0.17..0.18])),
    ("ring-pavilion", |run| run.new_panels([567, 0], [0.016..0.017, 0.2..0.21])),
    ("chalice-roof", |run| run.new_panels([480, 8], [0.032..0.033, 0.1..0.11])),
    ("curves-slabs", |run| {
        vec![
            ("slabs before", run.worst[0][0], 0.565..0.575),
            ("slabs", run.worst[0][1], 0.0..0.002),
            ("ribs before", run.worst[1][0], 1.0..1.1),
            ("ribs", run.worst[1][1], 0.0..0.005),
        ]
    }),
    ("other-strips", |run| {
        let [length, width] = run.longest_strip();
        vec![
            ("worst panel before", run.before.planarity.max_distance, 0.02..0.021),
            ("worst panel", run.after.planarity.max_distance, 0.0..1e-9),
            ("length of a strip", length, 28.0..29.0),
            ("width of a strip", width, 3.0..3.6),
            ("Gauss curvature", run.gauss_curvature(), 0.035..0.045),
        ]
    }),
    ("other-spline", |run| {
        let [before, after] = run.rim_unevenness();
        vec![
            ("longest over shortest before", before, 6.0..6.5),
            ("longest over shortest", after, 1.0..1.02),
            ("from the curve", run.worst[1][1], 0.0..0.01),
            ("from the first edges", run.off_the_first_rim(), 0.1..0.5),
        ]
    }),
    ("other-transfer", |run| {
        vec![("rings before", run.worst[0][0], 0.8..0.83), ("rings", run.worst[0][1], 0.0..0.01)]
    }),
    ("points-pavilion", |run| {
        let [before, after] = run.worst_of_all();
        vec![("points before", before, 0.34..0.355), ("points", after, 0.0..0.005)]
    }),
    ("fig-01-overview", |run| {
        vec![
            ("e_c before", run.e_c()[0], 1.5e-6..2.5e-6),
            ("e_c", run.e_c()[1], 0.0..5e-7),
            ("panels before", run.off_circles()[0], 0.065..0.075),
            ("panels", run.off_circles()[1], 0.0..0.03),
            ("crown before", run.worst[1][0], 0.45..0.55),
            ("crown", run.worst[1][1], 0.0..0.02),
            ("rigid area", run.worst[2][1], 0.0..0.03),
        ]
    }),
    ("fig-01-triangles", |run| {
        vec![
            ("belly before", run.worst[0][0], 0.38..0.39),
            ("belly", run.worst[0][1], 0.0..0.01),
            ("rim before", run.worst[1][0], 2.15..2.25),
            ("rim", run.worst[1][1], 0.0..0.01),
            ("foot", run.worst[2][1], 0.0..0.002),
        ]
    }),
    ("fig-01-tets", |run| {
        vec![
            ("head before", run.worst[0][0], 2.0..2.5),
            ("head", run.worst[0][1], 0.0..0.15),
            ("collar before", run.worst[1][0], 0.475..0.485),
            ("collar", run.worst[1][1].max(run.worst[2][1]), 0.0..0.03),
            ("handle", run.worst[3][1], 0.0..0.01),
        ]
    }),
    ("fig-04-squares", |run| {
        vec![
            ("corners before", run.worst[0][0], 0.38..0.39),
            ("corners", run.worst[0][1], 0.0..0.02),
        ]
    }),
    ("fig-05-planar", |run| {
        vec![
            ("e_p before", run.e_p()[0], 1.7e-8..1.9e-8),
            ("e_p", run.e_p()[1], 0.0..2e-9),
            ("panels before", run.before.planarity.mean_distance, 0.0085..0.0086),
            ("panels", run.after.planarity.mean_distance, 0.0..0.0022),
        ]
    }),
    ("fig-05-circular", |run| {
        vec![
            ("e_c before", run.e_c()[0], 8.1e-6..9.1e-6),
            ("e_c", run.e_c()[1], 0.0..5e-9),
            ("panels before", run.off_circles()[0], 0.215..0.225),
            ("panels", run.off_circles()[1], 0.0..0.004),
        ]
    }),
    ("fig-05-mixed", |run| {
        vec![
            ("e_c before", run.e_c()[0], 7.5e-6..8.5e-6),
            ("e_c", run.e_c()[1], 0.0..5e-7),
            ("panels before", run.off_circles()[0], 0.285..0.295),
            ("panels", run.off_circles()[1], 0.0..0.05),
        ]
    }),
    ("fig-06-exploration", |run| {
        vec![
            ("e_c before", run.e_c()[0], 9e-7..2e-6),
            ("e_c", run.e_c()[1], 0.0..5e-8),
            ("panels", run.off_circles()[1], 0.0..0.004),
            ("corners", run.worst[0][1], 0.0..0.02),
        ]
    }),
    ("fig-06-web", |run| {
        vec![("lines before", run.worst[0][0], 5.5..6.5), ("lines", run.worst[0][1], 0.0..0.1)]
    }),
    ("fig-07-quality", |run| {
        vec![
            ("right angles before", run.right_angles()[0], 0.29..0.3),
            ("right angles", run.right_angles()[1], 0.9..1.0),
            ("creases", run.worst[1][1], 0.0..0.005),
        ]
    }),
    ("fig-08-protrusions", |run| vec![("corners", run.worst[0][1], 0.0..0.05)]),
    ("fig-08-similar-1", |run| vec![("width", run.width_at_middle(), 31.0..32.0)]),
    ("fig-08-similar-2", |run| vec![("width", run.width_at_middle(), 29.0..30.0)]),
    ("fig-08-similar-3", |run| vec![("width", run.width_at_middle(), 27.0..29.0)]),
    ("fig-08-similar-blocks", |run| vec![("width", run.width_at_middle(), 18.0..27.0)]),
    ("fig-08-bar-polygons", |run| vec![("volume", run.volume_left(), 0.0..0.5)]),
    ("fig-08-bar-rings", |run| vec![("volume", run.volume_left(), 0.85..0.93)]),
    ("fig-08-bar-tets", |run| vec![("volume", run.volume_left(), 0.95..1.0)]),
    ("fig-09-conformal", |run| run.flat_map(1.05)),
    ("fig-09-polygons", |run| run.flat_map(1.1)),
    ("fig-10-collapse", |run| {
        let iterations = run.iterations_to(1e-6).map_or(f64::INFINITY, |n| n as f64);
        vec![
            ("iterations to 1e-6 of the energy", iterations, 0.0..60.0),
            ("volume", run.volume_left(), 1.0 - 1e-6..1.0 + 1e-6),
            ("corners", run.worst[0][1], 0.0..1e-6),
        ]
    }),
    ("fig-10-random", |run| {
        let iterations = run.iterations_to(1e-9).map_or(f64::INFINITY, |n| n as f64);
        vec![
            ("iterations to 1e-9 of the energy", iterations, 0.0..400.0),
            ("volume", run.volume_left(), 1.0 - 1e-6..1.0 + 1e-6),
        ]
    }),
    ("fig-11-strip", |run| {
        let [before, after] = run.shortest_edge();
        vec![
            ("e_c before", run.e_c()[0], 3e-6..4e-6),
            ("e_c", run.e_c()[1], 0.0..6e-8),
            ("corners before", run.before.circularity.max_distance, 0.038..0.039),
            ("corners", run.after.circularity.max_distance, 0.0..0.007),
            ("shortest edge before", before, 0.23..0.24),
            ("shortest edge", after, 0.0..0.02),
        ]
    }),
    ("lesson-what-a-projection-is", |run| {
        let [before, after] = run.worst_of_all();
        vec![
            ("tiles before", before, 0.37..0.38),
            ("tiles", after, 0.03..0.04),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-circles", |run| {
        vec![
            ("panels before", run.before.planarity.max_distance, 0.009..0.0092),
            ("panels", run.after.planarity.max_distance, 0.0..0.001),
            ("corners", run.after.circularity.max_distance, 0.145..0.146),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-curvature-and-panels", |run| {
        vec![
            ("corners before", run.before.circularity.max_distance, 0.0165..0.0175),
            ("corners", run.after.circularity.max_distance, 0.003..0.004),
            ("left moved", run.first_half_moved(), 0.0..1e-9),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-from-surface-to-panels", |run| {
        vec![
            ("corners before", run.before.circularity.max_distance, 0.08..0.085),
            ("corners", run.after.circularity.max_distance, 1e-5..0.001),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-circles-and-offsets", |run| {
        let [before, after] = run.worst_of_all();
        vec![("corners before", before, 0.154..0.155), ("corners", after, 0.001..0.0012)]
    }),
    ("lesson-stiffness-of-hexagons", |run| {
        vec![
            ("plates before", run.before.planarity.max_distance, 0.0076..0.0077),
            ("plates", run.after.planarity.max_distance, 1e-5..0.001),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-paper-model", |run| {
        vec![
            ("worst panel before", run.before.planarity.max_distance, 0.0045..0.005),
            ("worst panel", run.after.planarity.max_distance, 1e-5..0.001),
        ]
    }),
    ("lesson-exact-and-variations", |run| {
        vec![
            ("worst pane before", run.before.planarity.max_distance, 0.0085..0.0095),
            ("worst pane", run.after.planarity.max_distance, 0.0..1e-9),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-glass-roof", |run| {
        vec![
            ("worst pane before", run.before.planarity.max_distance, 0.009..0.0095),
            ("worst pane", run.after.planarity.max_distance, 0.001..0.003),
            ("goals met", run.goals_met as f64, 0.0..0.5),
        ]
    }),
    ("limits-choice", |run| {
        vec![
            ("exchanged", halves_apart(&run.positions), 1.4..1.6),
            ("own", halves_apart(&with_own_vertices(run)), 0.0..0.001),
        ]
    }),
    ("other-registration", |run| {
        let [before, after] = run.off_the_other_surface();
        vec![
            ("vertices before", before, 2.0..3.0),
            ("vertices", after, 0.0..0.03),
            ("e_p", run.e_p()[1], 0.0..2e-8),
            ("panels before", run.before.planarity.max_distance, 0.125..0.135),
            ("panels", run.after.planarity.max_distance, 0.0..0.007),
        ]
    }),
];

#[test]
fn every_example_does_what_it_states_and_the_gallery_shows_its_results() {
    let ids: Vec<_> = STATEMENTS.iter().map(|(id, _)| *id).collect();
    assert!(ids.iter().eq(EXAMPLES.iter().map(|example| &example.id)), "{ids:?}");
    let mut failures = Vec::new();
    let mut results = Vec::new();
    for (example, (id, measure)) in EXAMPLES.iter().zip(STATEMENTS) {
        let run = Run::of(example);
        let (before, after) = (run.before.energy.initial, run.after.energy.last);
        assert_eq!(run.after.skipped, 0, "{id}");
        // An example without constraints shows a flat map.
        if !run.after.constraints.is_empty() {
            let pinned: &[u32] = if id.starts_with("fig-10") { &[0] } else { &[] };
            assert_eq!(run.after.pinned, pinned, "{id}");
            assert!(after.total < 0.5 * before.total, "{id}: {before:?} {after:?}");
            assert!(after.shape < 0.1 * before.shape, "{id}: {before:?} {after:?}");
        }
        results.push(Results::of(example, &run));
        println!("{id}, {} iterations: {}", run.after.iterations, example.statement);
        for (what, value, bounds) in measure(&run) {
            println!("    {what}: {value:.3e}, expected {bounds:?}");
            if !bounds.contains(&value) {
                failures.push(format!("{id}: {what} is {value:e}, expected {bounds:?}"));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    compare_with_gallery(&results);
}
