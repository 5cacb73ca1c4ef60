//! The statements of each example, measured after solving it with its own settings.

use crate::examples::gallery::{Results, compare_with_gallery};
use shape_up::constraint::Selector;
use shape_up::fabricate::panel::smallest_box;
use shape_up::generate::example::{EXAMPLES, Example};
use shape_up::generate::model::Court;
use shape_up::math::Vec3;
use shape_up::mesh::{
    MapErrors, Mesh, Point, QuasiConformal, Ragged, Surface, Topology, UnrolledStrip,
    angle_histogram, gauss_curvature, strips,
};
use shape_up::scene::{Scene, Target};
use shape_up::session::{Report, Session};
use shape_up::solve::{ConformalNorm, ConformalWeights, Parametrization};

/// A solved example.
pub(crate) struct Run {
    pub before: Report,
    pub after: Report,
    /// For each row of constraints, before and after: largest distance of a vertex from its
    /// projection.
    worst: Vec<[f64; 2]>,
    /// Total energy at the start and after each iteration.
    totals: Vec<f64>,
    pub mesh: Mesh,
    pub positions: Vec<Point>,
    pub scene: Scene,
    /// Met goals of the lesson, if it is one.
    goals_met: usize,
}

impl Run {
    fn of(example: &Example) -> Run {
        let (scene, mesh) = example.build();
        let original = scene.clone();
        let mut session = Session::open(scene, mesh).expect("the example fits its mesh");
        let worst = |session: &Session| -> Vec<f64> {
            session.solver().found().map(|found| found.worst_squared.sqrt()).collect()
        };
        let (before, far) = (session.report(), worst(&session));
        session.solve(true).expect("positions stay finite");
        let near = worst(&session);
        Run {
            before,
            after: session.report(),
            worst: far.into_iter().zip(near).map(|(far, near)| [far, near]).collect(),
            totals: session.trace().iter().map(|entry| entry.energy.total).collect(),
            mesh: session.mesh().clone(),
            positions: session.positions(),
            scene: original,
            goals_met: session.goals().iter().filter(|goal| goal.met).count(),
        }
    }

    /// Greatest displacement of a vertex of the first half of the mesh.
    fn first_half_moved(&self) -> f64 {
        let half = self.positions.len() / 2;
        let pairs = self.positions[..half].iter().zip(&self.mesh.positions);
        pairs.map(|(now, rest)| (Vec3::from(*now) - Vec3::from(*rest)).length()).fold(0.0, f64::max)
    }

    /// Number of iterations until the total is this fraction of its initial value.
    fn iterations_to(&self, part: f64) -> Option<usize> {
        self.totals.iter().position(|&total| total < part * self.totals[0])
    }

    /// Volume inside a closed surface, as a fraction of the rest volume.
    fn volume_left(&self) -> f64 {
        volume(&self.mesh, &self.positions) / volume(&self.mesh, &self.mesh.positions)
    }

    /// Shortest edge, before and after.
    fn shortest_edge(&self) -> [f64; 2] {
        let topology = Topology::new(&self.mesh);
        [&self.mesh.positions, &self.positions].map(|positions| {
            let at = |v: u32| Vec3::from(positions[v as usize]);
            topology.edges().iter().map(|&[a, b]| (at(b) - at(a)).length()).fold(f64::MAX, f64::min)
        })
    }

    /// Mean circularity error, before and after.
    fn e_c(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.circularity.e_c_mean)
    }

    /// Mean over the panels of the largest distance of a corner from a circle, before and after.
    fn off_circles(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.circularity.mean_distance)
    }

    /// Mean planarity error, before and after.
    fn e_p(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.planarity.e_p_mean)
    }

    /// Fraction of face corners with an angle within 10 degrees of a right angle, before and after.
    fn right_angles(&self) -> [f64; 2] {
        [&self.mesh.positions, &self.positions].map(|positions| {
            let counts = angle_histogram(positions, &self.mesh.faces, 18);
            f64::from(counts[8] + counts[9]) / f64::from(counts.iter().sum::<u32>())
        })
    }

    /// Largest distance of a vertex from its projection over all rows, before and after.
    fn worst_of_all(&self) -> [f64; 2] {
        [0, 1].map(|when| self.worst.iter().map(|row| row[when]).fold(0.0, f64::max))
    }

    /// Errors of the flat map of the mesh, with the initial settings of the page.
    fn flat_map(&self, mean_below: f64) -> Measured {
        let (weights, norm) = (ConformalWeights::default(), ConformalNorm::default());
        let map = Parametrization::new(&self.mesh, &Topology::new(&self.mesh), weights, norm);
        let errors = map.expect("the mesh has a map").errors;
        let MapErrors { quasi_conformal: QuasiConformal { mean, max }, flipped, .. } = errors;
        vec![
            ("mean", mean, 1.0..mean_below),
            ("worst", max, 1.0..4.0),
            ("flipped", flipped as f64, 0.0..0.5),
        ]
    }

    /// Greatest distance from the target surface of the scene, before and after.
    fn off_the_other_surface(&self) -> [f64; 2] {
        let target = self
            .scene
            .closeness
            .target
            .as_ref()
            .and_then(Target::mesh)
            .expect("there is another surface");
        let surface = Surface::new(&target.positions, target);
        [&self.mesh.positions, &self.positions].map(|positions| {
            let off = positions.iter().map(|&p| {
                let closest = Vec3::from(surface.closest(p, &mut { Surface::NO_HINT }));
                (closest - p.into()).length()
            });
            off.fold(0.0, f64::max)
        })
    }

    /// Longest edge of the rim of the court divided by the shortest, before and after.
    fn rim_unevenness(&self) -> [f64; 2] {
        let rim = Court::default().ring(0);
        [&self.mesh.positions, &self.positions].map(|positions| {
            let at = |v: u32| Vec3::from(positions[v as usize]);
            let next = |v: u32| if v + 1 == rim.end { rim.start } else { v + 1 };
            let lengths = rim.clone().map(|v| (at(next(v)) - at(v)).length());
            lengths.clone().fold(0.0, f64::max) / lengths.fold(f64::MAX, f64::min)
        })
    }

    /// Distance of the rim of the court from its original edges.
    fn off_the_first_rim(&self) -> f64 {
        let rim = Court::default().ring(0);
        let around = Ragged::from_iter([rim.clone().chain([rim.start]).collect::<Vec<_>>()]);
        let edges = Mesh { curves: around, ..Mesh::default() };
        let edges = Surface::new(&self.mesh.positions, &edges);
        let off = rim.map(|v| {
            let p = self.positions[v as usize];
            (Vec3::from(edges.closest(p, &mut { Surface::NO_HINT })) - p.into()).length()
        });
        off.fold(0.0, f64::max)
    }

    /// Length and width of the smallest rectangles that contain the unrolled strips of most panels.
    fn longest_strip(&self) -> [f64; 2] {
        let topology = Topology::new(&self.mesh);
        let strips = strips(&self.mesh, &topology);
        let flat = strips.iter().map(|strip| UnrolledStrip::new(&self.positions, strip, &topology));
        let flat: Vec<UnrolledStrip> = flat.map(|flat| flat.expect("edges have lengths")).collect();
        let most = flat.iter().map(|flat| flat.quads).max();
        let sizes = flat.iter().filter(|flat| Some(flat.quads) == most);
        let sizes = sizes.map(|flat| smallest_box(&flat.outline).1);
        sizes.fold([0.0, 0.0], |[a, b], [c, d]| [f64::max(a, c), f64::max(b, d)])
    }

    /// Greatest magnitude of the Gauss curvature.
    fn gauss_curvature(&self) -> f64 {
        let all = gauss_curvature(&self.positions, &self.mesh, &Topology::new(&self.mesh));
        all.into_iter().filter(|k| k.is_finite()).fold(0.0, |most, k| most.max(k.abs()))
    }

    /// Width of the stretched sheet at its middle; it was 18 m wide.
    fn width_at_middle(&self) -> f64 {
        let middle = |&v: &usize| self.mesh.positions[v][0].abs() < 0.1;
        let ys = (0..self.positions.len()).filter(middle).map(|v| self.positions[v][1]);
        ys.clone().fold(f64::MIN, f64::max) - ys.fold(f64::MAX, f64::min)
    }
}

fn volume(mesh: &Mesh, positions: &[Point]) -> f64 {
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let fans = mesh
        .faces
        .iter()
        .flat_map(|face| (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]));
    fans.map(|[a, b, c]| at(a).dot(at(b).cross(at(c)))).sum::<f64>() / 6.0
}

/// Greatest distance of a sheet of 25 by 17 vertices from its mirror image.
fn halves_apart(positions: &[Point]) -> f64 {
    let apart = |k: usize| {
        let ([x, y, z], [u, v, w]) = (positions[k], positions[k / 25 * 25 + 24 - k % 25]);
        Vec3::new(x + u, y - v, z - w).length()
    };
    (0..positions.len()).map(apart).fold(0.0, f64::max)
}

/// Solution for the sheet if each of its constraints has the vertices of one column.
fn with_own_vertices(run: &Run) -> Vec<Point> {
    let mut scene = run.scene.clone();
    for (i, row) in (1..).zip(&mut scene.constraints) {
        row.on = Selector::Vertices((0..17).map(|j| j * 25 + i).collect());
    }
    let mut session = Session::open(scene, run.mesh.clone()).expect("it is the same sheet");
    session.solve(false).expect("positions stay finite");
    session.positions()
}

/// Measured values of an example, with the bounds of its statement.
type Measured = Vec<(&'static str, f64, std::ops::Range<f64>)>;

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
    ("curves-slabs", |run| {
        vec![
            ("slabs before", run.worst[0][0], 0.565..0.575),
            ("slabs", run.worst[0][1], 0.0..0.002),
            ("ribs before", run.worst[1][0], 1.0..1.1),
            ("ribs", run.worst[1][1], 0.0..0.005),
        ]
    }),
    ("points-pavilion", |run| {
        let [before, after] = run.worst_of_all();
        vec![("points before", before, 0.34..0.355), ("points", after, 0.0..0.005)]
    }),
    ("lesson-what-a-projection-is", |run| {
        let [before, after] = run.worst_of_all();
        vec![
            ("tiles before", before, 0.37..0.38),
            ("tiles", after, 0.03..0.04),
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
    ("lesson-circles-and-offsets", |run| {
        let [before, after] = run.worst_of_all();
        vec![
            ("corners before", before, 0.154..0.155),
            ("corners", after, 1e-5..0.001),
            ("goals met", run.goals_met as f64, 1.0..1.5),
        ]
    }),
    ("lesson-curvature-and-panels", |run| {
        vec![
            ("panels before", run.before.planarity.max_distance, 0.0075..0.0076),
            ("panels", run.after.planarity.max_distance, 0.001..0.002),
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
    ("other-transfer", |run| {
        vec![("rings before", run.worst[0][0], 0.8..0.83), ("rings", run.worst[0][1], 0.0..0.01)]
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
    ("other-new-panels", |run| {
        vec![
            ("panels", run.mesh.faces.len() as f64, 479.5..480.5),
            ("from circles before", run.before.circularity.max_distance, 0.012..0.013),
            ("from circles", run.after.circularity.max_distance, 0.0..1e-9),
            ("off the triangles before", run.off_the_other_surface()[0], 0.0..1e-9),
            ("off the triangles", run.off_the_other_surface()[1], 0.15..0.16),
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
