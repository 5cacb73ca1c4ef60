//! Fig. 8 and 10: rigid and similar elements of different sizes, under handles, and from a
//! collapsed or scattered start.

use super::parts::{constraint, each, fixed, moved};
use crate::constraint::{Element, Selector};
use crate::generate::example::Example;
use crate::generate::finish::{Noise, soften};
use crate::generate::model::{Blocks, Patch, creature};
use crate::math::{cosine, sine};
use crate::mesh::{Group, GroupKeyword, Mesh, Point};
use crate::scene::{ClosenessTo, ConstraintSpec, Scene};

pub(super) const PROTRUSIONS: Example = Example {
    id: "fig-08-protrusions",
    title: "Plate with pegs",
    summary: "The plate bends as its right end is turned, and the pegs turn with it and keep their shape, because every polygon is rigid.",
    statement: "No corner of a panel is further than 5 cm from its place on a rigid copy of the panel; the plate is 34 m long.",
    make: protrusions,
};

pub(super) const RINGS: [Example; 3] = [
    Example {
        id: "fig-08-similar-1",
        title: "Stretched sheet, elements of one ring",
        summary: "Each vertex with its neighbours may turn and grow but not shear: with such small elements the sheet swells most at its middle, and narrows towards its fixed ends.",
        statement: "Stretched from 30 m to 42 m, the sheet, 18 m wide at first, becomes more than 31 m wide at its middle.",
        make: |scene| sheet(scene, 1),
    },
    Example {
        id: "fig-08-similar-2",
        title: "Stretched sheet, elements of two rings",
        summary: "Larger elements overlap more and spread the growth: the middle swells less than with one ring, and the ends narrow less.",
        statement: "Stretched from 30 m to 42 m, the sheet, 18 m wide at first, becomes between 29 m and 30 m wide at its middle.",
        make: |scene| sheet(scene, 2),
    },
    Example {
        id: "fig-08-similar-3",
        title: "Stretched sheet, elements of three rings",
        summary: "Elements of three rings spread the growth widest: the middle swells least of the three sheets.",
        statement: "Stretched from 30 m to 42 m, the sheet, 18 m wide at first, becomes less than 29 m wide at its middle.",
        make: |scene| sheet(scene, 3),
    },
];

pub(super) const BLOCKS: Example = Example {
    id: "fig-08-similar-blocks",
    title: "Stretched sheet, elements of blocks",
    summary: "Blocks of six by six panels that overlap by two: each may turn and grow but not shear, so the whole sheet grows almost evenly.",
    statement: "Stretched from 30 m to 42 m, the sheet, 18 m wide at first, becomes less than 27 m wide at its middle.",
    make: blocks,
};

pub(super) const BAR_POLYGONS: Example = Example {
    id: "fig-08-bar-polygons",
    title: "Bent bar of rigid polygons",
    summary: "Rigid quads of the surface alone: nothing fills the bar, and it caves in where it is bent.",
    statement: "The bar loses more than half of its volume.",
    make: |scene| bar(scene, Blocks::surface, Element::Face, 0),
};

pub(super) const BAR_RINGS: Example = Example {
    id: "fig-08-bar-rings",
    title: "Bent bar of rigid rings",
    summary: "Each vertex with its neighbours is rigid, and these rings overlap, which makes a stiff shell of the same surface: it bends more evenly, with a dent inside the bend.",
    statement: "The bar keeps between 85 and 93 per cent of its volume.",
    make: |scene| bar(scene, Blocks::surface, Element::Ring, 1),
};

pub(super) const BAR_TETS: Example = Example {
    id: "fig-08-bar-tets",
    title: "Bent bar of rigid tetrahedra",
    summary: "Rigid tetrahedra fill the bar: under the same handles it keeps its cross-section and its volume.",
    statement: "The bar keeps more than 95 per cent of its volume.",
    make: |scene| bar(scene, Blocks::tetrahedra, Element::Tet, 0),
};

/// Cubes of a plate along x and y, and the height of its pegs.
const PLATE: [u32; 2] = [34, 16];
const PEG: u32 = 4;

fn protrusions(scene: &mut Scene) -> Mesh {
    let [nx, ny] = PLATE;
    // Pegs of two by two cubes, in two rows.
    let is_peg = |x: u32, y: u32| {
        let (column, row) = (x % 8, y % 8);
        (3..31).contains(&x) && (3..5).contains(&column) && (3..5).contains(&row)
    };
    let blocks = Blocks::new([nx, ny, 1 + PEG], |[x, y, z]| z == 0 || is_peg(x, y));
    let mut mesh = blocks.surface();
    soften(&mut mesh, 3);
    free(scene, vec![constraint("rigid", each(Element::Face), 1.0)]);
    let far = f64::from(nx) - 1.5;
    scene.handles = vec![
        fixed(vertices(&mesh, |p| p[0] < 1.5)),
        moved(&mesh, vertices(&mesh, |p| p[0] > far), |p| bent(p, [1.5, far], 0.22)),
    ];
    mesh
}

/// Panels of the sheet along x and y.
const SHEET: [u32; 2] = [30, 18];

fn sheet(scene: &mut Scene, radius: u32) -> Mesh {
    let ring = Selector::Each { element: Element::Ring, within: None, radius };
    stretched(scene, ring)
}

/// A sheet with blocks of panels as elements, each a group of the file.
fn blocks(scene: &mut Scene) -> Mesh {
    const SIDE: u32 = 6;
    const APART: usize = 4;
    let [nx, ny] = SHEET;
    let mut mesh = stretched(scene, each(Element::Group));
    let corners = (0..=ny - SIDE).step_by(APART);
    let corners = corners.flat_map(|y| (0..=nx - SIDE).step_by(APART).map(move |x| [x, y]));
    mesh.groups = corners
        .map(|[x, y]| Group {
            name: format!("block-{x}-{y}"),
            keyword: GroupKeyword::Group,
            faces: (y..y + SIDE).flat_map(|y| (x..x + SIDE).map(move |x| y * nx + x)).collect(),
            curves: Vec::new(),
        })
        .collect();
    mesh
}

/// A flat sheet of similar elements. Both short sides are fixed; the right one is pulled away.
fn stretched(scene: &mut Scene, elements: Selector) -> Mesh {
    let sheet = Patch {
        panels: SHEET.map(|side| side as usize),
        shear: 0.0,
        jitter: 0.0,
        rise: 0.0,
        ..Patch::default()
    };
    let mesh = sheet.mesh();
    free(scene, vec![constraint("similar", elements, 1.0)]);
    scene.handles = vec![
        fixed(vertices(&mesh, |p| p[0] == -15.0)),
        moved(&mesh, vertices(&mesh, |p| p[0] == 15.0), |[x, y, z]| [x + 12.0, y, z]),
    ];
    mesh
}

fn bar(scene: &mut Scene, mesh: fn(&Blocks) -> Mesh, element: Element, radius: u32) -> Mesh {
    const LENGTH: u32 = 32;
    const WIDTH: u32 = 5;
    let mesh = mesh(&Blocks::bar([LENGTH, WIDTH, WIDTH]));
    let on = Selector::Each { element, within: None, radius };
    free(scene, vec![constraint("rigid", on, 1.0)]);
    let far = f64::from(LENGTH) - 2.5;
    scene.handles = vec![
        fixed(vertices(&mesh, |p| p[0] < 2.5)),
        moved(&mesh, vertices(&mesh, |p| p[0] > far), |p| bent(p, [2.5, far], 0.25)),
    ];
    mesh
}

/// Only constraints and handles: neither closeness nor smoothness, as in Fig. 8.
fn free(scene: &mut Scene, constraints: Vec<ConstraintSpec>) {
    scene.constraints = constraints;
    scene.closeness.to = ClosenessTo::None;
}

fn vertices(mesh: &Mesh, is_meant: impl Fn(Point) -> bool) -> Vec<u32> {
    (0..mesh.positions.len() as u32).filter(|&v| is_meant(mesh.positions[v as usize])).collect()
}

/// Position of the end of a bar along x that bends upwards in an arc between two coordinates, by an
/// angle in turns.
fn bent([x, y, z]: Point, [from, to]: [f64; 2], turns: f64) -> Point {
    let (c, s) = (cosine(turns), sine(turns));
    let radius = (to - from) / (turns * std::f64::consts::TAU);
    let along = x - to;
    [from + radius * s + c * along - s * z, y, radius * (1.0 - c) + s * along + c * z]
}

pub(super) const COLLAPSE: Example = Example {
    id: "fig-10-collapse",
    title: "Animal, pressed flat, recovers",
    summary: "All vertices start in one plane; rigid rings of neighbours are enough to raise the animal again.",
    statement: "With the quasi-Newton accelerator the energy falls to a millionth of that at the start in fewer than 60 iterations, and the animal regains all of its volume.",
    make: collapse,
};

pub(super) const RANDOM: Example = Example {
    id: "fig-10-random",
    title: "Animal, scattered, recovers",
    summary: "All vertices start at random positions in a box: all that is left of the animal is which vertices are neighbours, and the shape of each piece.",
    statement: "With the quasi-Newton accelerator the energy falls to a billionth of that at the start in fewer than 400 iterations, and the animal regains all of its volume.",
    make: random,
};

fn collapse(scene: &mut Scene) -> Mesh {
    let mesh = rings(scene, 1);
    scene.current = Some(mesh.positions.iter().map(|&[x, y, _]| [x, y, 0.0]).collect());
    mesh
}

fn random(scene: &mut Scene) -> Mesh {
    /// Half the sides of the box, about the size of the animal.
    const BOX: Point = [3.2, 1.0, 1.7];
    // From a random start, rings of radius one stay folded; larger ones overlap enough to unfold.
    let mesh = rings(scene, 2);
    let mut noise = Noise { state: 10 };
    let mut place = || BOX.map(|half| half * noise.next());
    scene.current = Some(mesh.positions.iter().map(|_| place()).collect());
    mesh
}

/// The animal, with rigid rings of this radius as its only constraints.
fn rings(scene: &mut Scene, radius: u32) -> Mesh {
    let rings = Selector::Each { element: Element::Ring, within: None, radius };
    scene.solver.iterations = 500;
    scene.constraints = vec![constraint("rigid", rings, 1.0)];
    scene.closeness.to = ClosenessTo::None;
    creature()
}
