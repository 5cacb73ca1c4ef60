//! An example solved with its own settings, and what is measured on it.

use shape_up::constraint::Selector;
use shape_up::fabricate::panel::smallest_box;
use shape_up::generate::example::Example;
use shape_up::generate::model::Court;
use shape_up::math::Vec3;
use shape_up::mesh::{
    MapErrors, Mesh, Point, QuasiConformal, Ragged, Surface, Topology, UnrolledStrip,
    angle_histogram, folded_faces, gauss_curvature, strips,
};
use shape_up::scene::{Scene, Target};
use shape_up::session::{Report, Session};
use shape_up::solve::{ConformalNorm, ConformalWeights, Parametrization};
use std::ops::Range;

/// Measured values of an example, with the bounds of its statement.
pub(super) type Measured = Vec<(&'static str, f64, Range<f64>)>;

/// A solved example.
pub(crate) struct Run {
    pub before: Report,
    pub after: Report,
    /// For each row of constraints, before and after: largest distance of a vertex from its
    /// projection.
    pub worst: Vec<[f64; 2]>,
    /// Total energy at the start and after each iteration.
    pub totals: Vec<f64>,
    pub mesh: Mesh,
    pub positions: Vec<Point>,
    pub scene: Scene,
    /// Met goals of the lesson, if it is one.
    pub goals_met: usize,
}

impl Run {
    pub(super) fn of(example: &Example) -> Run {
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
    pub(super) fn first_half_moved(&self) -> f64 {
        let half = self.positions.len() / 2;
        let pairs = self.positions[..half].iter().zip(&self.mesh.positions);
        pairs.map(|(now, rest)| (Vec3::from(*now) - Vec3::from(*rest)).length()).fold(0.0, f64::max)
    }

    /// Number of iterations until the total is this fraction of its initial value.
    pub(super) fn iterations_to(&self, part: f64) -> Option<usize> {
        self.totals.iter().position(|&total| total < part * self.totals[0])
    }

    /// Volume inside a closed surface, as a fraction of the rest volume.
    pub(super) fn volume_left(&self) -> f64 {
        volume(&self.mesh, &self.positions) / volume(&self.mesh, &self.mesh.positions)
    }

    /// Shortest edge, before and after.
    pub(super) fn shortest_edge(&self) -> [f64; 2] {
        let topology = Topology::new(&self.mesh);
        [&self.mesh.positions, &self.positions].map(|positions| {
            let at = |v: u32| Vec3::from(positions[v as usize]);
            topology.edges().iter().map(|&[a, b]| (at(b) - at(a)).length()).fold(f64::MAX, f64::min)
        })
    }

    /// Mean circularity error, before and after.
    pub(super) fn e_c(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.circularity.e_c_mean)
    }

    /// Mean over the panels of the largest distance of a corner from a circle, before and after.
    pub(super) fn off_circles(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.circularity.mean_distance)
    }

    /// Mean planarity error, before and after.
    pub(super) fn e_p(&self) -> [f64; 2] {
        [&self.before, &self.after].map(|report| report.planarity.e_p_mean)
    }

    /// Fraction of face corners with an angle within 10 degrees of a right angle, before and after.
    pub(super) fn right_angles(&self) -> [f64; 2] {
        [&self.mesh.positions, &self.positions].map(|positions| {
            let counts = angle_histogram(positions, &self.mesh.faces, 18);
            f64::from(counts[8] + counts[9]) / f64::from(counts.iter().sum::<u32>())
        })
    }

    /// Largest distance of a vertex from its projection over all rows, before and after.
    pub(super) fn worst_of_all(&self) -> [f64; 2] {
        [0, 1].map(|when| self.worst.iter().map(|row| row[when]).fold(0.0, f64::max))
    }

    /// Errors of the flat map of the mesh, with the initial settings of the page.
    pub(super) fn flat_map(&self, mean_below: f64) -> Measured {
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
    pub(super) fn off_the_other_surface(&self) -> [f64; 2] {
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

    /// Panels laid out on another surface: their number, that of their irregular vertices, how far
    /// they are from their kind before, and how far they leave the surface when they are exact.
    pub(super) fn new_panels(
        &self,
        [count, irregular]: [usize; 2],
        far: [Range<f64>; 2],
    ) -> Measured {
        let is_flat = self.scene.constraints[0].kind.info().id == "plane";
        let error = |report: &Report| match is_flat {
            true => report.planarity.max_distance,
            false => report.circularity.max_distance,
        };
        let about = |n: usize| n as f64 - 0.5..n as f64 + 0.5;
        let [error_before, off] = far;
        vec![
            ("panels", self.mesh.faces.len() as f64, about(count)),
            ("irregular vertices", self.irregular() as f64, about(irregular)),
            ("panels before", error(&self.before), error_before),
            ("panels", error(&self.after), 0.0..1e-9),
            (
                "folds",
                folded_faces(&self.mesh, &Topology::new(&self.mesh), &self.positions).len() as f64,
                about(0),
            ),
            ("off the surface before", self.off_the_other_surface()[0], 0.0..1e-9),
            ("off the surface", self.off_the_other_surface()[1], off),
        ]
    }

    /// Number of vertices inside the mesh at which other than four edges meet.
    fn irregular(&self) -> usize {
        let topology = Topology::new(&self.mesh);
        let at_edge = topology.boundary_loops().indices();
        let rows = (0..).zip(topology.neighbours().iter());
        rows.filter(|(v, near)| near.len() != 4 && !at_edge.contains(v)).count()
    }

    /// Longest edge of the rim of the court divided by the shortest, before and after.
    pub(super) fn rim_unevenness(&self) -> [f64; 2] {
        let rim = Court::ring(0);
        [&self.mesh.positions, &self.positions].map(|positions| {
            let at = |v: u32| Vec3::from(positions[v as usize]);
            let next = |v: u32| if v + 1 == rim.end { rim.start } else { v + 1 };
            let lengths = rim.clone().map(|v| (at(next(v)) - at(v)).length());
            lengths.clone().fold(0.0, f64::max) / lengths.fold(f64::MAX, f64::min)
        })
    }

    /// Distance of the rim of the court from its original edges.
    pub(super) fn off_the_first_rim(&self) -> f64 {
        let rim = Court::ring(0);
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
    pub(super) fn longest_strip(&self) -> [f64; 2] {
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
    pub(super) fn gauss_curvature(&self) -> f64 {
        let all = gauss_curvature(&self.positions, &self.mesh, &Topology::new(&self.mesh));
        all.into_iter().filter(|k| k.is_finite()).fold(0.0, |most, k| most.max(k.abs()))
    }

    /// Width of the stretched sheet at its middle; it was 18 m wide.
    pub(super) fn width_at_middle(&self) -> f64 {
        let middle = |&v: &usize| self.mesh.positions[v][0].abs() < 0.1;
        let ys = (0..self.positions.len()).filter(middle).map(|v| self.positions[v][1]);
        ys.clone().fold(f64::MIN, f64::max) - ys.fold(f64::MAX, f64::min)
    }
}

pub(super) fn volume(mesh: &Mesh, positions: &[Point]) -> f64 {
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let fans = mesh
        .faces
        .iter()
        .flat_map(|face| (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]));
    fans.map(|[a, b, c]| at(a).dot(at(b).cross(at(c)))).sum::<f64>() / 6.0
}

/// Greatest distance of a sheet of 25 by 17 vertices from its mirror image.
pub(super) fn halves_apart(positions: &[Point]) -> f64 {
    let apart = |k: usize| {
        let ([x, y, z], [u, v, w]) = (positions[k], positions[k / 25 * 25 + 24 - k % 25]);
        Vec3::new(x + u, y - v, z - w).length()
    };
    (0..positions.len()).map(apart).fold(0.0, f64::max)
}

/// Solution for the sheet if each of its constraints has the vertices of one column.
pub(super) fn with_own_vertices(run: &Run) -> Vec<Point> {
    let mut scene = run.scene.clone();
    for (i, row) in (1..).zip(&mut scene.constraints) {
        row.on = Selector::Vertices((0..17).map(|j| j * 25 + i).collect());
    }
    let mut session = Session::open(scene, run.mesh.clone()).expect("it is the same sheet");
    session.solve(false).expect("positions stay finite");
    session.positions()
}
