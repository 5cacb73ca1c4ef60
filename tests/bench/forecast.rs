//! Forecasts for meshes against their solutions: a row for each mesh and kind of panel.
//!
//! `bench_forecast MESH...`: mean angle of the edges to the lines of curvature, estimated
//! displacement and its wording, and mean displacement when all panels are exact; distances are
//! relative to the mean edge.

use shape_up::mesh::{Topology, read};
use shape_up::scene::{Forecast, HowFar, Scene};
use shape_up::session::Session;
use shape_up::solve::Require;

fn main() {
    println!(
        "{:<32} {:>6} {:>6} {:<7} {:<9} {:>8} {:>8} {:>5}  is right",
        "mesh", "faces", "angle", "panels", "said", "estimate", "moved", "exact"
    );
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).expect("the mesh can be read");
        let mesh = read(&path, &bytes).expect("it is a mesh").mesh;
        let name = path.rsplit('/').next().unwrap_or_default();
        let Some(forecast) = Forecast::of(&mesh, &Topology::new(&mesh)) else {
            println!("{name:<32} {:>6} no shape of panels is offered", mesh.faces.len());
            continue;
        };
        let angle = forecast.off_curvature_lines.map_or("-".to_owned(), |it| format!("{it:.1}"));
        for kind in &forecast.kinds {
            let mut scene = Scene::opened(name);
            scene.request_panels(kind.kind, Require::Exact, &mesh).expect("it is offered");
            let mut session = Session::open(scene, mesh.clone()).expect("it can be solved");
            session.solve(false).expect("positions stay finite");
            let moved = session.moved().mean / session.mean_edge();
            let met = session.exact().is_some_and(|report| report.met);
            let is_right = match kind.how_far {
                HowFar::Lot => moved > 0.19,
                HowFar::Little => (0.03..0.21).contains(&moved),
                HowFar::Hardly => moved < 0.04,
                HowFar::Nothing => moved < 1e-6,
            };
            println!(
                "{name:<32} {:>6} {angle:>6} {:<7} {:<9} {:>8.3} {moved:>8.3} {:>5}  {}",
                mesh.faces.len(),
                kind.kind,
                format!("{:?}", kind.how_far),
                kind.least_move,
                if met { "yes" } else { "no" },
                if is_right { "yes" } else { "no" },
            );
        }
    }
}
