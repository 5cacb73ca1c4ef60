//! Hard constraints on quad meshes, natively: a table row for each mesh and kind.
//!
//! `bench_exact MESH[:KIND]... grid:N:JITTER[:KIND]...`: circle and plane if no kind is given. A
//! grid has N by N vertices over bumps, displaced at random by JITTER of an edge. Closeness to rest
//! with weight 10, smoothness of the displacement with weight 2, edges at least 0.3 of their
//! length; energies and distances are for a bounding sphere of diameter 1.

#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/hard.rs"]
mod hard;

use hard::Case;
use libm::{cos, sin};
use shape_up::mesh::{Mesh, read};
use shape_up::solve::{Exact, Require, Stage, clock};

fn main() {
    println!(
        "{:<40} {:<7} {:>6} {:>8} {:>5} {:>7} {:>8} {:>10} {:>6} {:>5} {:>6}  (approach, polish) {:>10} {:>8} {:>3} {:>6}",
        "mesh",
        "kind",
        "n",
        "soft",
        "its",
        "blocks",
        "end",
        "f",
        "edge",
        "unmet",
        "s",
        "improved",
        "end",
        "blk",
        "s"
    );
    for argument in std::env::args().skip(1) {
        let mut parts: Vec<&str> = argument.split(':').collect();
        let (mesh, name, kinds);
        if parts[0] == "grid" {
            let number = |k: usize| parts.get(k).and_then(|it| it.parse().ok()).unwrap_or(0.0_f64);
            (mesh, name) =
                (bumps(number(1) as u32, number(2)), format!("grid {} {}", number(1), number(2)));
            kinds = parts.split_off(parts.len().min(3));
        } else {
            let bytes = std::fs::read(parts[0]).expect("the mesh can be read");
            mesh = read(parts[0], &bytes).expect("it is a mesh").mesh;
            name = parts[0].rsplit('/').next().unwrap_or_default().to_owned();
            kinds = parts.split_off(1);
        }
        let kinds = if kinds.is_empty() { vec!["circle", "plane"] } else { kinds };
        for kind in kinds {
            row(&name, kind, mesh.clone());
        }
    }
}

/// A square of bumps with `n` by `n` vertices, displaced at random by `jitter` of an edge, and by
/// half of it in height.
fn bumps(n: u32, jitter: f64) -> Mesh {
    let edge = 1.0 / f64::from(n - 1);
    let mut state = 1_u64;
    let random = std::cell::RefCell::new(move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    });
    grid::grid(n - 1, n - 1, |i, j| {
        let (x, y) = (f64::from(i) * edge, f64::from(j) * edge);
        let height = 0.1 * sin(3.0 * x) * cos(4.0 * y) + 0.05 * sin(7.0 * x * y);
        let by = |part: f64| 2.0 * part * jitter * edge * (random.borrow_mut())();
        [x + by(1.0), y + by(1.0), height + by(0.5)]
    })
}

fn row(name: &str, kind: &str, mesh: Mesh) {
    let case = Case::new(mesh).on_faces(kind, Require::Exact);
    let size = case.size();
    let start = case.soft();
    let mut exact: Exact = case.exact(&start);
    let soft = exact.worst_excess() / size;
    let (mut approach, mut polish) = (0.0, 0.0);
    loop {
        let started = clock::now();
        let stage = exact.step();
        let seconds = clock::now() - started;
        match stage {
            Ok(Stage::Approach | Stage::Round) => approach += seconds,
            Ok(_) => polish += seconds,
            Err(error) => println!("{error}"),
        }
        if exact.stage() == Stage::Ended {
            break;
        }
    }
    let energy = exact.energy();
    let f = (10.0 * energy.close + 2.0 * energy.smooth) / (size * size);
    let answer = exact.answer();
    let improved = clock::now();
    exact.improve();
    exact.run().expect("its systems are regular");
    let energy = exact.energy();
    let better = (10.0 * energy.close + 2.0 * energy.smooth) / (size * size);
    let improved = clock::now() - improved;
    let end = exact.answer();
    println!(
        "{name:<40} {kind:<7} {:>6} {soft:>8.1e} {:>5} {:>3}/{:<3} {:>8.1e} {f:>10.5} {:>6.3} {:>5} {:>6.2}  ({approach:.2}, {polish:.2}) {better:>10.5} {:>8.1e} {:>3} {improved:>6.2}",
        case.mesh.positions.len(),
        answer.iterations,
        answer.block_factors,
        answer.steps,
        answer.max_distance / size,
        answer.shortest_edge.unwrap_or(f64::NAN),
        answer.unmet.len(),
        answer.seconds,
        end.max_distance / size,
        end.block_factors - answer.block_factors,
    );
}
