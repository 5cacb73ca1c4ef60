//! Random disks with holes, spikes, zigzag boundaries, noise and slivers: each ends in a surface of
//! quads like the input, or in a refusal, after a bounded search.

use super::surfaces::{parametric, without_stray};
use super::{check_manifold, shape};
use crate::support::fuzz::cases;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use shape_up::mesh::Mesh;
use shape_up::quads::{Boundary, MapOptions, PanelSize, RemeshStage, remesh};
use std::cell::Cell;

/// A random disk.
#[derive(Clone, Debug)]
struct Disk {
    cells: [u32; 2],
    /// Heights of waves along x, y and both.
    waves: [f64; 3],
    /// Middles of holes, and their radii, as fractions of the sides.
    holes: Vec<[f64; 3]>,
    /// Angle of the corner at the origin, in degrees.
    spike: f64,
    /// Depth of the teeth of one side, in cells.
    zigzag: f64,
    /// Motion of vertices, in cells.
    noise: f64,
    /// Width of a row of thin triangles, as a fraction of a cell.
    sliver: f64,
    panels: usize,
    boundary: Boundary,
    seed: u64,
}

fn disks() -> impl Strategy<Value = Disk> {
    let cells = prop::array::uniform2(6_u32..11);
    let waves = prop::array::uniform3(-1.0..1.0);
    let holes = prop::collection::vec([0.2..0.8, 0.2..0.8, 0.05..0.2], 0..5);
    let spike = prop_oneof![Just(90.0), 10.0..80.0];
    let zigzag = prop_oneof![Just(0.0), 0.0..0.6];
    let rest = (prop_oneof![Just(0.0), 0.0..0.3], prop_oneof![Just(1.0), 0.001..1.0]);
    let boundary = prop_oneof![Just(Boundary::Followed), Just(Boundary::Cut)];
    let last = (24_usize..80, boundary, any::<u64>());
    (cells, waves, holes, spike, zigzag, rest, last).prop_map(
        |(cells, waves, holes, spike, zigzag, (noise, sliver), (panels, boundary, seed))| Disk {
            cells,
            waves,
            holes,
            spike,
            zigzag,
            noise,
            sliver,
            panels,
            boundary,
            seed,
        },
    )
}

fn mesh(disk: &Disk) -> Mesh {
    let [columns, rows] = disk.cells.map(f64::from);
    let mut random = crate::support::random::Random::new(disk.seed);
    let (cosine, sine) = {
        let turns = disk.spike / 360.0;
        (shape_up::math::cosine(turns), shape_up::math::sine(turns))
    };
    let mut mesh = parametric(disk.cells, [false, false], |u, v| {
        let (mut x, mut y) = (u * columns, v * rows);
        if (x.round() as u32) % 2 == 1 && v == 0.0 {
            y -= disk.zigzag;
        }
        if x > 2.5 {
            x -= 1.0 - disk.sliver;
        }
        let wave = |t: f64| shape_up::math::sine(0.7 * t);
        let height =
            disk.waves[0] * wave(u) + disk.waves[1] * wave(v) + disk.waves[2] * wave(u + v);
        // Sheared to the angle of the spike.
        [x + y * cosine, y * sine, height * 2.0]
    });
    for point in &mut mesh.positions {
        let by = random.vector() * (disk.noise * disk.sliver.min(1.0));
        *point = [point[0] + by.x, point[1] + by.y, point[2] + by.z];
    }
    let width = disk.cells[0] + 1;
    let in_hole = |face: &[u32]| {
        let share = |v: u32| [f64::from(v % width) / columns, f64::from(v / width) / rows];
        disk.holes.iter().any(|&[x, y, radius]| {
            face.iter().all(|&v| {
                let [u, w] = share(v);
                (u - x) * (u - x) + (w - y) * (w - y) < radius * radius
            })
        })
    };
    mesh.faces = mesh.faces.iter().filter(|face| !in_hole(face)).collect();
    without_stray(mesh)
}

#[test]
fn a_random_disk_becomes_quads_of_the_same_shape_or_is_refused() {
    let (done, refused) = (Cell::new(0), Cell::new(0));
    let mut runner = TestRunner::new(cases(40));
    let result = runner.run(&disks(), |disk| {
        let mesh = mesh(&disk);
        let size = PanelSize::Count(disk.panels);
        let options = MapOptions { boundary: disk.boundary, ..MapOptions::of_size(size) };
        let mut stages =
            [RemeshStage::Field, RemeshStage::Map, RemeshStage::Extract].map(|one| (one, 0));
        let found = remesh(&mesh, &options, "m", &mut |stage| {
            stages.iter_mut().filter(|(one, _)| *one == stage).for_each(|(_, count)| *count += 1);
        });
        // Of the first search, and of one with longer openings covered: each has as much as that takes for
        // all its fields, maps and judgements.
        let [fields, maps, judged] = stages.map(|(_, count)| count);
        prop_assert!(judged <= 2 * 3, "{} maps", judged);
        prop_assert!(
            fields.max(maps) <= 2 * 4,
            "{} fields, {} maps without integers",
            fields,
            maps
        );
        match found {
            Ok(found) => {
                check_manifold(&found.mesh);
                let fits = match disk.boundary {
                    Boundary::Followed => 4..=4,
                    Boundary::Cut => 3..=5,
                };
                prop_assert!(found.mesh.faces.iter().all(|face| fits.contains(&face.len())));
                // Openings that panels run over are none of the result.
                let covered = found.notes.iter().filter(|note| note.words.contains("covered"));
                let covered: usize = covered.map(|note| note.places.len()).sum();
                let (euler, loops) = shape(&mesh);
                let own = (found.measures.euler, found.measures.loops);
                prop_assert_eq!(own, (euler + covered as i64, loops - covered));
                done.set(done.get() + 1);
            }
            Err(error) => {
                prop_assert!(!error.to_string().is_empty());
                refused.set(refused.get() + 1);
            }
        }
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    let (done, refused) = (done.get(), refused.get());
    assert!(done >= 3 * refused, "{done} done, {refused} refused");
}
