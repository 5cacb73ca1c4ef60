//! Nanoseconds per constraint of every operator: gather, centring, projection and scatter, as in
//! the local step. In lanes, as in the solver, against one constraint after the other with the same
//! formulas.
//!
//! `cargo bench --bench operators` measures natively; `npm run bench` also in the browser, for
//! which `browser.rs` exports the same to a page.

#[path = "../support/random.rs"]
mod random;

use random::Random;
use shape_up::constraint::{
    Arity, Batch, Centring, Info, KINDS, Kind, KindVisitor, Projection, Reference, Row, batches,
};
use shape_up::math::{Vec3, centre};
use shape_up::mesh::{Mesh, Ragged, Surface};
use shape_up::solve::clock;
use std::fmt::Write;
use std::rc::Rc;

/// Number of constraints measured together.
const COUNT: u32 = 2048;
/// Rounds, whose median counts; each is long compared to the resolution of a browser's clock.
const ROUNDS: usize = 9;
const SECONDS_PER_ROUND: f64 = 0.02;

/// Constraints of one kind on vertices that nearly have its shape, as in typical use.
struct Work {
    kind: Kind,
    members: Ragged,
    rest: Vec<Row>,
    x: Vec<Row>,
    mesh: Mesh,
}

impl Work {
    /// Constraints of `n` vertices each.
    fn new(info: &Info, n: usize) -> Work {
        let kind = Kind::new(info.id, serde_json::json!({})).expect("defaults are valid");
        let mut random = Random::new(1);
        let mut cloud = |around: &dyn Fn(u32) -> Vec3<f64>, noise: f64| -> Vec<Row> {
            let points = (0..COUNT * n as u32).map(|k| around(k) + random.vector() * noise);
            points.map(|v| [v.x, v.y, v.z, 0.0]).collect()
        };
        let rest = cloud(&|k| Vec3::new(f64::from(k / n as u32), 0.0, 0.0) * 4.0, 1.0);
        let members: Ragged =
            (0..COUNT * n as u32).collect::<Vec<_>>().chunks(n).map(<[u32]>::to_vec).collect();
        let mut mesh = Mesh::default();
        mesh.positions.extend(rest.iter().map(|row| [row[0], row[1], row[2]]));
        members.iter().for_each(|row| mesh.faces.push(&row[..n.min(3)]));
        let mut work = Work { kind, members, rest, x: Vec::new(), mesh };
        // The residual is the vector from the projection to the point.
        work.x = cloud(
            &|k| {
                let [x, y, z, _] = work.rest[k as usize];
                Vec3::new(x, y, z)
            },
            0.2,
        );
        let mut residuals = vec![[0.0; 4]; work.x.len()];
        for batch in &mut work.batches() {
            batch.local_step(&work.x, &mut residuals, 1.0);
        }
        let noise = cloud(&|_| Vec3::zero(), 0.1);
        for ((x, residual), noise) in work.x.iter_mut().zip(&residuals).zip(&noise) {
            *x = std::array::from_fn(|i| x[i] - residual[i] + noise[i]);
        }
        work
    }

    /// Calls `run` with the reference data that operators may use.
    fn with_reference<T>(&self, run: impl FnOnce(&Reference<'_>) -> T) -> T {
        let surface = Rc::new(Surface::new(&self.mesh.positions, &self.mesh));
        run(&Reference { surface: &|| Rc::clone(&surface), pose: None })
    }

    fn batches(&self) -> Vec<Batch> {
        self.with_reference(|reference| {
            batches(&self.kind, &self.members, &self.rest, 1.0, false, reference)
        })
    }

    /// Nanoseconds per constraint in lanes.
    fn lanes(&self) -> f64 {
        let mut gradient = self.x.clone();
        let mut batches = self.batches();
        self.measure(|| {
            for batch in &mut batches {
                batch.local_step(&self.x, &mut gradient, 1.0);
            }
        })
    }

    /// Nanoseconds per constraint, one after the other.
    fn scalar(&self) -> f64 {
        self.kind.visit(Scalar(self))
    }

    /// The median over rounds.
    fn measure(&self, mut step: impl FnMut()) -> f64 {
        let mut timed = |repeats: usize| {
            let started = clock::now();
            (0..repeats).for_each(|_| step());
            clock::now() - started
        };
        let mut repeats = 1;
        while timed(repeats) < SECONDS_PER_ROUND {
            repeats *= 2;
        }
        let mut rounds: Vec<f64> = (0..ROUNDS).map(|_| timed(repeats)).collect();
        rounds.sort_by(f64::total_cmp);
        1e9 * rounds[ROUNDS / 2] / (repeats * self.members.len()) as f64
    }
}

/// The local step without lanes.
struct Scalar<'a>(&'a Work);

impl KindVisitor for Scalar<'_> {
    type Output = f64;
    fn visit<P: Projection>(self, operator: &P) -> f64 {
        let Work { members, rest, x, .. } = self.0;
        let mut operator = operator.clone();
        self.0.with_reference(|reference| operator.bind(reference));
        let gather = |rows: &[Row], nodes: &[u32]| -> Vec<Vec3<f64>> {
            let points = nodes.iter().map(|&node| rows[node as usize]);
            let mut points: Vec<_> = points.map(|row| Vec3::new(row[0], row[1], row[2])).collect();
            centre_as::<P>(&mut points);
            points
        };
        let prepared: Vec<Vec<Vec3<f64>>> = members
            .iter()
            .map(|nodes| {
                let mut rest = gather(rest, nodes);
                operator.prepare(&mut rest);
                rest
            })
            .collect();
        let mut gradient = x.clone();
        let mut projected = Vec::new();
        self.0.measure(|| {
            for (nodes, rest) in members.iter().zip(&prepared) {
                let v = gather(x, nodes);
                projected.clear();
                projected.resize(v.len(), Vec3::zero());
                operator.project(rest, &v, &mut projected);
                centre_as::<P>(&mut projected);
                for ((v, p), &node) in v.iter().zip(&projected).zip(nodes) {
                    let residual = *v - *p;
                    let row = &mut gradient[node as usize];
                    row[0] += residual.x;
                    row[1] += residual.y;
                    row[2] += residual.z;
                }
            }
        })
    }
}

fn centre_as<P: Projection>(points: &mut [Vec3<f64>]) {
    match P::INFO.centring {
        Centring::Together => {
            centre(points);
        }
        Centring::ByEdge => points.chunks_exact_mut(2).for_each(|ends| {
            centre(ends);
        }),
        Centring::Placed => {}
    }
}

/// A Markdown table of every kind.
pub(crate) fn table() -> String {
    let mut table =
        "| kind | vertices | ns in lanes | ns one by one | ratio |\n|---|---|---|---|---|\n"
            .to_owned();
    for info in KINDS {
        let sizes = match info.arity {
            Arity::Exactly(n) => vec![n],
            Arity::AtLeast(least) if least > 4 => vec![least],
            Arity::AtLeast(_) if info.centring == Centring::ByEdge => vec![4, 8],
            Arity::AtLeast(_) => vec![4, 7],
        };
        for n in sizes {
            let work = Work::new(info, n);
            let (lanes, scalar) = (work.lanes(), work.scalar());
            let ratio = scalar / lanes;
            writeln!(table, "| {} | {n} | {lanes:.0} | {scalar:.0} | {ratio:.1} |", info.id)
                .expect("a string takes everything");
        }
    }
    table
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    // `cargo test` runs it too, with `--test`, only to check that it compiles.
    if std::env::args().any(|word| word == "--bench") {
        print!("{}", table());
    }
}
