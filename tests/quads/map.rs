//! Properties of integer-grid maps (`reference/quads.md`, section 7: 1, 3, 5 and 7), on surfaces whose lines of
//! curvature are known and on foreign ones.

use super::surfaces::{ellipsoid, hypar, parametric, plate, torus, tube, vault};
use crate::support::random::{Random, in_frame};
use crate::support::shared;
use shape_up::math::{Vec3, angle, cosine, sine};
use shape_up::mesh::Mesh;
use shape_up::quads::{
    Boundary, GridMap, GridMapper, InputSurface, MapNotes, MapOptions, PanelSize, Prepared, Side,
    UNIT,
};

/// A map with its surface.
struct Mapped {
    prepared: Prepared,
    map: GridMap,
    notes: MapNotes,
}

/// The first map without flipped triangles, else that with the fewest; with weights of curvature and of
/// directions, and the number of quads.
fn best(mapper: &mut GridMapper, asked: [f64; 3]) -> Mapped {
    let mut best: Option<Mapped> = None;
    let mapped = mapper.maps(asked, &mut |_| (), &mut |prepared, map, notes| {
        let is_whole = notes.flipped.is_empty();
        // Maps that follow more creases than the last one are of another surface.
        let is_better = best.as_ref().is_none_or(|Mapped { notes: best, .. }| {
            notes.dropped_creases > best.dropped_creases || notes.flipped.len() < best.flipped.len()
        });
        if is_better {
            best = Some(Mapped { prepared: prepared.clone(), map, notes });
        }
        !is_whole
    });
    mapped.unwrap();
    best.expect("the last level finds a map")
}

fn mapped(mesh: &Mesh, options: &MapOptions) -> Vec<Mapped> {
    let PanelSize::Count(count) = options.size else { panic!("tests give a number") };
    let parts = InputSurface::parts(mesh, &[]).unwrap().surfaces;
    let whole: f64 = parts.iter().map(InputSurface::area).sum();
    let of_part = |part: &InputSurface| {
        let prepared = part.prepare(2.0, (whole / count as f64).sqrt(), options).unwrap();
        let wanted = count as f64 * part.area() / whole;
        let asked = [options.follow, options.direction, wanted];
        best(&mut GridMapper::new(prepared), asked)
    };
    parts.iter().map(of_part).collect()
}

fn followed(mesh: &Mesh, count: usize) -> Vec<Mapped> {
    mapped(mesh, &MapOptions::of_size(PanelSize::Count(count)))
}

/// A dome over a rectangle with a bump, which has no symmetry.
fn bumpy() -> Mesh {
    parametric([30, 24], [false, false], |u, v| {
        let bump = 0.5 * sine(u) * sine(1.5 * v) + 0.3 * cosine(u + 0.5 * v);
        [5.0 * u, 4.0 * v, 2.0 * u * (1.0 - u) + bump]
    })
}

/// All meshes, with a number of panels.
fn meshes() -> Vec<(&'static str, Mesh, usize)> {
    let mut all = vec![
        ("torus", torus(), 300),
        ("tube", tube(), 200),
        ("ellipsoid", ellipsoid([3.0, 2.0, 1.5]), 300),
        ("plate", plate(), 300),
        ("hypar", hypar(), 200),
        ("vault", vault(), 250),
        ("bumpy", bumpy(), 300),
    ];
    // A scan with details smaller than a panel, a figure with creases, and what architects draw.
    for (name, count) in [
        ("M2_eq_quad2.obj", 500),
        ("halftunnel.off", 500),
        ("hemisphere.obj", 500),
        ("horse_quad.obj", 500),
        ("camelhead.off", 500),
        ("botanic-garden-bubble-0.obj", 500),
    ] {
        all.extend(shared::mesh(name).map(|mesh| (name, mesh, count)));
    }
    all
}

/// The number of quads by the area of the map.
fn quads(Mapped { map, .. }: &Mapped) -> f64 {
    let doubled: i64 = (0..map.corners.len()).map(|t| map.doubled_area(t) as i64).sum();
    0.5 * doubled as f64 / (UNIT * UNIT) as f64
}

/// The quarter turns of the map around each vertex.
fn turns(mapped: &Mapped) -> Vec<f64> {
    let surface = &mapped.prepared.surface;
    let mut turns = vec![0.0; surface.positions.len()];
    for (triangle, corners) in surface.triangles.iter().enumerate() {
        for k in 0..3 {
            let [p, q, r] = [0, 1, 2].map(|j| mapped.map.corners[triangle][(k + j) % 3]);
            let [a, b] = [q, r].map(|end| [0, 1].map(|axis| (end[axis] - p[axis]) as f64));
            let (dot, cross) = (a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]);
            // No triangle is flipped.
            let turn = angle(dot, cross).expect("the map has no sides without length");
            turns[corners[k]] += turn / std::f64::consts::FRAC_PI_2;
        }
    }
    turns
}

/// The inner vertices around which the field turns, and how many quads are missing there.
fn singular(mapped: &Mapped) -> Vec<(usize, i64)> {
    let on_boundary = mapped.prepared.surface.boundary_vertices();
    let missing = turns(mapped).into_iter().map(|turns| 4 - turns.round() as i64).enumerate();
    missing.filter(|&(v, missing)| !on_boundary[v] && missing % 4 != 0).collect()
}

/// The sum of the indices of inner vertices and of the quads missing or left over at the boundary.
fn turning(mapped: &Mapped) -> i64 {
    let on_boundary = mapped.prepared.surface.boundary_vertices();
    let missing = |(v, turns): (usize, f64)| {
        let quarters = turns.round();
        assert!((turns - quarters).abs() < 1e-6, "{turns} quarters at vertex {v}");
        if on_boundary[v] { 2 - quarters as i64 } else { 4 - quarters as i64 }
    };
    turns(mapped).into_iter().enumerate().map(missing).sum()
}

fn euler(prepared: &Prepared) -> i64 {
    let surface = &prepared.surface;
    let inner = surface.sides().filter(|&side| surface.across(side).is_some()).count() as i64;
    let triangles = surface.triangles.len() as i64;
    let edges = 3 * triangles - inner / 2;
    surface.positions.len() as i64 - edges + triangles
}

/// Every transition carries the coordinates exactly and keeps the grid; no triangle is flipped;
/// features are grid lines, and singular vertices grid points.
fn check(name: &str, mapped: &Mapped) {
    let Mapped { prepared, map, notes } = mapped;
    let surface = &prepared.surface;
    assert!(notes.flipped.is_empty(), "{name}: {:?}", notes.flipped);
    for side in surface.sides() {
        let Side { triangle, side: k } = side;
        assert!(map.doubled_area(triangle) > 0, "{name}: triangle {triangle}");
        let corner = |side: Side, k: usize| map.corners[side.triangle][(side.side + k) % 3];
        if let Some(back) = surface.across(side) {
            let there = map.transitions[triangle][k];
            assert_eq!(there.shift.map(|shift| shift % UNIT), [0; 2], "{name}");
            assert_eq!(there.apply(corner(side, 0)), corner(back, 1), "{name}: {side:?}");
            assert_eq!(there.apply(corner(side, 1)), corner(back, 0), "{name}: {side:?}");
            assert_eq!(map.transitions[back.triangle][back.side], there.inverse());
        }
        if surface.is_feature(side) {
            let [a, b] = [corner(side, 0), corner(side, 1)];
            let is_line = |axis: usize| a[axis] == b[axis] && a[axis] % UNIT == 0;
            assert!(is_line(0) || is_line(1), "{name}: feature from {a:?} to {b:?}");
        }
    }
    let singular = singular(mapped);
    for (triangle, corners) in surface.triangles.iter().enumerate() {
        for (k, &v) in corners.iter().enumerate() {
            let is_singular = singular.iter().any(|&(other, _)| other == v);
            let at = map.corners[triangle][k];
            assert!(!is_singular || at.iter().all(|x| x % UNIT == 0), "{name}: {at:?}");
        }
    }
}

#[test]
fn maps_keep_the_grid_and_their_indices_sum_up_to_the_euler_characteristic() {
    for (name, mesh, count) in meshes() {
        let parts = followed(&mesh, count);
        for part in &parts {
            check(name, part);
            assert_eq!(turning(part), 4 * euler(&part.prepared), "{name}");
        }
        let quads: f64 = parts.iter().map(quads).sum();
        let off = quads / count as f64;
        assert!((0.9..1.1).contains(&off), "{name}: {quads} quads for {count}");
    }
}

#[test]
fn singularities_are_as_few_as_the_shape_asks_for() {
    let count = |mesh: &Mesh, quads| singular(&followed(mesh, quads)[0]).len();
    assert_eq!(count(&torus(), 300), 0);
    assert_eq!(count(&tube(), 200), 0);
    assert_eq!(count(&plate(), 300), 0);
    assert_eq!(count(&vault(), 250), 0);
    // Two at each of the four umbilic points.
    let found = singular(&followed(&ellipsoid([3.0, 2.0, 1.5]), 300)[0]);
    assert_eq!(found.len(), 8);
    assert!(found.iter().all(|&(_, missing)| missing == 1));
}

#[test]
fn a_cut_boundary_leaves_the_lines_of_curvature_alone() {
    let options = MapOptions::of_size(PanelSize::Count(300));
    let along = mapped(&hypar(), &options);
    let cut = mapped(&hypar(), &MapOptions { boundary: Boundary::Cut, ..options });
    check("cut", &cut[0]);
    assert!(singular(&cut[0]).is_empty());
    assert!(!singular(&along[0]).is_empty());
}

#[test]
fn a_moved_and_scaled_surface_has_the_same_map() {
    let mesh = bumpy();
    let [before] = &followed(&mesh, 300)[..] else { panic!("it is one part") };
    let frame = Random::new(7).frame();
    let mut moved = mesh.clone();
    for point in &mut moved.positions {
        let turned = in_frame(frame, Vec3::from(*point)) * 1000.0;
        *point = (turned + Vec3::new(3e3, -5e3, 2e3)).into();
    }
    let [after] = &followed(&moved, 300)[..] else { panic!("it is one part") };
    assert_eq!(singular(after), singular(before));
    assert_eq!(quads(after).round(), quads(before).round());
    let unit = UNIT as f64;
    let pairs = after.map.corners.as_flattened().iter().zip(before.map.corners.as_flattened());
    for (a, b) in pairs.flat_map(|(a, b)| [0, 1].map(|axis| (a[axis], b[axis]))) {
        assert!(((a - b) as f64 / unit).abs() < 1e-3, "{a} {b}");
    }
}

#[test]
fn the_order_of_vertices_and_faces_changes_no_singularity() {
    let mesh = bumpy();
    let before = &followed(&mesh, 300)[0];
    let n = mesh.positions.len() as u32;
    // Coprime to both numbers.
    let renamed = |v: u32| (v * 787) % n;
    let mut shuffled = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
    for v in 0..n {
        shuffled.positions[renamed(v) as usize] = mesh.positions[v as usize];
    }
    let faces = mesh.faces.len();
    for k in 0..faces {
        let face = mesh.faces.row((k * 787) % faces);
        shuffled.faces.push(&[face[1], face[2], face[0]].map(renamed));
    }
    let after = &followed(&shuffled, 300)[0];
    let places = |mapped: &Mapped| {
        let at = |(v, missing): (usize, i64)| (mapped.prepared.surface.positions[v], missing);
        singular(mapped).into_iter().map(at).collect::<Vec<_>>()
    };
    let (before, after) = (places(before), places(after));
    assert_eq!(before.len(), after.len());
    for (at, index) in before {
        let near = |&(other, same): &(Vec3<f64>, i64)| same == index && (other - at).length() < 0.3;
        assert!(after.iter().any(near), "{index} at {at:?}: {after:?}");
    }
}

#[test]
fn another_size_or_evenness_goes_on_from_what_is_kept() {
    let options = MapOptions::of_size(PanelSize::Count(300));
    let part = &InputSurface::parts(&bumpy(), &[]).unwrap().surfaces[0];
    let prepared = part.prepare(2.0, (part.area() / 300.0).sqrt(), &options).unwrap();
    let mut kept = GridMapper::new(prepared.clone());
    best(&mut kept, [20.0, 30.0, 300.0]);
    for asked in [[20.0, 30.0, 250.0], [20.0, 5.0, 250.0], [5.0, 5.0, 330.0]] {
        let again = best(&mut kept, asked);
        let new = best(&mut GridMapper::new(prepared.clone()), asked);
        assert_eq!((again.map, again.notes), (new.map, new.notes));
    }
}
