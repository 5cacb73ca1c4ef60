//! Names in the order of assembly: by rows from the supports, and along each row.

use super::beams::cube;
use super::identities::revolution;
use super::{build, metres, text_of};
use crate::support::grid::grid;
use crate::support::shared;
use shape_up::fabricate::{Build, Stand};
use shape_up::math::{cosine, sine};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Names, Product, UnitsAndUp, Up};
use std::collections::BTreeSet;

fn named(mesh: &Mesh, stand: Option<&Stand>) -> Build {
    let own = BuildSettings {
        names: Names::Assembly,
        scale: 100.0,
        outlines_only: true,
        ..BuildSettings::default()
    };
    let guessed = Stand { up: UnitsAndUp::guess_up(mesh), held: Vec::new() };
    let made = Build::new(mesh, &own, metres(), stand.unwrap_or(&guessed));
    made.expect("it can be built")
}

fn names(mesh: &Mesh) -> Vec<String> {
    named(mesh, None).names
}

/// A dome whose panels stand above each other, `around` in each of `rows`, and one at its top.
fn dome(around: u32, rows: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for j in 0..=rows {
        let height = 0.23 * f64::from(j) / f64::from(rows);
        mesh.positions.extend((0..around).map(|i| {
            let turns = f64::from(i) / f64::from(around);
            let radius = 5.0 * cosine(height);
            [radius * cosine(turns), radius * sine(turns), 5.0 * sine(height)]
        }));
    }
    for j in 0..rows {
        for i in 0..around {
            let [a, b] = [i, (i + 1) % around].map(|i| j * around + i);
            mesh.faces.push(&[a, b, b + around, a + around]);
        }
    }
    mesh.faces.push(&(0..around).map(|i| rows * around + i).collect::<Vec<_>>());
    mesh
}

#[test]
fn a_dome_is_named_ring_by_ring_from_the_ground_with_its_columns_in_order() {
    let mesh = dome(12, 3);
    let found = names(&mesh);
    for (row, letter) in ["A", "B", "C"].into_iter().enumerate() {
        for i in 0..12 {
            assert_eq!(found[12 * row + i], format!("{letter}{}", i + 1));
        }
    }
    assert_eq!(found[36], "D1");
    // Whatever the order of faces, and with the noise of a file.
    let mut other = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
    let faces: Vec<&[u32]> = mesh.faces.iter().collect();
    faces.iter().rev().for_each(|face| other.faces.push(face));
    for (k, at) in other.positions.iter_mut().enumerate() {
        at.iter_mut().for_each(|x| *x += 1e-9 * f64::from(k as u32 % 7));
    }
    let mut again = names(&other);
    again.reverse();
    assert_eq!(again, found);
}

#[test]
fn a_row_leads_from_neighbour_to_neighbour() {
    // A vault with two rows on the ground, seven panels long.
    let mesh = grid(6, 7, |i, j| {
        let turns = f64::from(i) / 12.0;
        [3.0 * cosine(turns), f64::from(j), 3.0 * sine(turns)]
    });
    let made = named(&mesh, None);
    let mut of_row: Vec<(u32, usize)> = Vec::new();
    for (f, name) in made.names.iter().enumerate() {
        if let Some(number) = name.strip_prefix('A') {
            of_row.push((number.parse().unwrap(), f));
        }
    }
    of_row.sort_unstable();
    assert_eq!(
        of_row.iter().map(|(number, _)| *number).collect::<Vec<_>>(),
        (1..=14).collect::<Vec<_>>()
    );
    let shares_a_side = |f: usize, g: usize| {
        made.surface
            .sides
            .row(f)
            .iter()
            .any(|&e| made.surface.edges[e as usize].across(f as u32) == Some(g as u32))
    };
    let joined = of_row.windows(2).filter(|pair| shares_a_side(pair[0].1, pair[1].1)).count();
    assert_eq!(joined, 12, "two rows of seven: {of_row:?}");
}

#[test]
fn a_closed_surface_begins_at_its_lowest_panel_and_a_strip_at_an_end() {
    let made = named(&cube(), None);
    let height = |f: usize| {
        let face = made.surface.faces.row(f);
        face.iter().map(|&v| made.surface.at(v).z).sum::<f64>()
    };
    let mut by_name: Vec<(&str, usize)> =
        made.names.iter().enumerate().map(|(f, name)| (&**name, f)).collect();
    by_name.sort_unstable();
    let all: Vec<&str> = by_name.iter().map(|(name, _)| *name).collect();
    assert_eq!(all, ["A1", "B1", "B2", "B3", "B4", "C1"]);
    assert!(
        height(by_name[0].1) < height(by_name[1].1) && height(by_name[5].1) > height(by_name[4].1)
    );
    // A wall of panels beside each other, and a tower of 28 above each other.
    let stand = Stand { up: Up::Z, held: Vec::new() };
    let wall = grid(5, 1, |i, j| [f64::from(i), 0.1 * f64::from(i * i), 2.0 * f64::from(j)]);
    let wall = named(&wall, Some(&stand)).names;
    let mut either = [wall.clone(), wall.into_iter().rev().collect()];
    either.sort();
    assert_eq!(either[0], ["A1", "A2", "A3", "A4", "A5"]);
    let tower = grid(1, 28, |i, j| [f64::from(i), 0.0, f64::from(j)]);
    let tower = named(&tower, Some(&stand));
    assert_eq!([0, 1, 22, 23, 24].map(|f| &*tower.names[f]), ["A1", "B1", "Z1", "AA1", "AB1"]);
    // Those are names of nodes, of pieces of paper, and of types.
    let others = ["N1", "S1", "T1"].map(str::to_owned);
    assert!(others.iter().all(|other| !tower.names.contains(other)));
    assert_eq!(tower.order(), (1..=28).collect::<Vec<_>>());
}

#[test]
fn every_component_stands_by_itself_and_what_is_held_is_where_it_begins() {
    let one = dome(8, 2);
    let mut two = one.clone();
    let count = one.positions.len() as u32;
    // The second one stands on a hill.
    two.positions.extend(one.positions.iter().map(|[x, y, z]| [x + 20.0, *y, z + 7.0]));
    one.faces.iter().for_each(|face| {
        two.faces.push(&face.iter().map(|v| v + count).collect::<Vec<_>>());
    });
    let found = names(&two);
    let first: BTreeSet<&str> = found[..8].iter().map(|name| &**name).collect();
    let other: BTreeSet<&str> = found[17..25].iter().map(|name| &**name).collect();
    assert_eq!(
        first,
        (1..=8).map(|k| format!("A{k}")).collect::<Vec<_>>().iter().map(|name| &**name).collect()
    );
    assert_eq!(
        other,
        (9..=16).map(|k| format!("A{k}")).collect::<Vec<_>>().iter().map(|name| &**name).collect()
    );
    assert_eq!([&*found[16], &*found[33]], ["C1", "C2"]);
    // Hung from its top, the panel there comes first.
    let held = Stand { up: Up::Z, held: vec![16] };
    let hung = named(&one, Some(&held)).names;
    assert_eq!(hung[16], "A1");
    assert!(hung[8..16].iter().filter(|name| name.starts_with('A')).count() == 2);
}

#[test]
fn the_names_of_real_meshes_are_short_and_no_two_are_the_same() {
    for file in ["halftunnel.off", "gc_dodecahedron_poly.obj"] {
        let Some(mesh) = shared::mesh(file) else { continue };
        let made = named(&mesh, None);
        let distinct: BTreeSet<&String> = made.names.iter().collect();
        assert_eq!(distinct.len(), made.names.len(), "{file}");
        assert!(made.names.iter().all(|name| (2..=5).contains(&name.len())), "{file}");
        let mut order = made.order();
        order.sort_unstable();
        assert!(order.iter().copied().eq(1..=made.names.len() as u32), "{file}");
    }
}

#[test]
fn fins_and_discs_named_in_the_order_of_assembly_have_the_numbers_of_their_nodes_in_it() {
    let of = |product, names| BuildSettings {
        product,
        names,
        disc: None,
        thickness: 3.0,
        scale: 10.0,
        sheet: [1200.0, 600.0],
        ..BuildSettings::default()
    };
    let mesh = revolution(5, 4);
    let made = build(&mesh, &of(Product::Fins, Names::Assembly));
    let mut numbers = made.nodes.clone();
    numbers.sort_unstable();
    assert!(numbers.iter().copied().eq(1..=mesh.positions.len() as u32));
    // The first panels have the first nodes, and each panel no node beyond those of the panels before it.
    let number = |v: &u32| made.nodes[*v as usize];
    let panels = made.rows.concat();
    let mut seen = BTreeSet::new();
    for &f in &panels {
        seen.extend(mesh.faces.row(f as usize).iter().map(number));
        assert!(seen.iter().copied().eq(1..=seen.len() as u32), "{seen:?}");
    }
    // A panel stands on the nodes with its lowest numbers.
    let mut own = mesh.faces.row(panels[0] as usize).to_vec();
    own.sort_by_key(number);
    let heights: Vec<f64> = own.iter().map(|&v| mesh.positions[v as usize][2]).collect();
    assert!(heights[..2].iter().all(|low| heights[2..].iter().all(|high| high - low > 0.1)));
    for (&edge, part) in made.fins.iter().zip(&made.parts) {
        let [a, b] = made.surface.edges[edge as usize].ends.map(|v| number(&v));
        assert_eq!(part.name, format!("B{a}-{b}"));
    }
    for disc in &made.discs {
        assert_eq!(made.parts[disc.part].name, format!("N{}", number(&disc.vertex)));
    }
    let names: BTreeSet<&str> = made.parts.iter().map(|part| &*part.name).collect();
    assert_eq!(names.len(), made.parts.len());
    // The key and the tables have no other names.
    let nodes: BTreeSet<String> = numbers.iter().map(|number| format!("N{number}")).collect();
    for table in ["nodes.csv", "discs.csv", "node-beams.csv"] {
        let text = text_of(&made, table);
        let names = text.lines().skip(1).map(|row| row.split(',').next().unwrap().to_owned());
        assert!(names.collect::<BTreeSet<_>>().is_subset(&nodes), "{table}");
    }
    // Panels keep the numbers of vertices, which panels.obj has.
    let panels = build(&mesh, &of(Product::Panels, Names::Assembly));
    assert!(panels.nodes.iter().copied().eq(0..mesh.positions.len() as u32));
}

#[test]
fn fins_are_ordered_with_their_panels_and_discs_with_their_first_fin() {
    let own = BuildSettings {
        product: Product::Fins,
        disc: None,
        thickness: 3.0,
        scale: 10.0,
        sheet: [1200.0, 600.0],
        ..BuildSettings::default()
    };
    let made = build(&revolution(5, 4), &own);
    let column = |table: &str, name: &str| -> Vec<String> {
        let text = text_of(&made, table);
        let at = text.lines().next().unwrap().split(',').position(|own| own == name).unwrap();
        text.lines().skip(1).map(|row| row.split(',').nth(at).unwrap().to_owned()).collect()
    };
    let numbers = |table: &str| -> Vec<usize> {
        column(table, "order").iter().map(|number| number.parse().unwrap()).collect()
    };
    let fins = numbers("fins.csv");
    let mut sorted = fins.clone();
    sorted.sort();
    assert_eq!(sorted, (1..=made.fins.len()).collect::<Vec<_>>());
    let order = made.order();
    let with = |k: usize| made.parts[k].panels.iter().map(|&f| order[f as usize]).min();
    for (a, b) in (0..fins.len()).flat_map(|a| (0..fins.len()).map(move |b| (a, b))) {
        assert!(with(a) >= with(b) || fins[a] < fins[b], "{a} {b}");
    }
    assert!(!made.discs.is_empty());
    for (disc, order) in made.discs.iter().zip(numbers("discs.csv")) {
        let there = made.fins.iter().zip(&fins);
        let there =
            there.filter(|(e, _)| made.surface.edges[**e as usize].ends.contains(&disc.vertex));
        assert_eq!(there.map(|(_, number)| *number).min(), Some(order));
    }
}
