//! Fig. 10: a model that recovers from a collapsed start, and from a scattered one.

use super::parts::constraint;
use crate::constraint::{Element, Selector};
use crate::example::Example;
use crate::example::model::{Creature, Noise};
use crate::mesh::{Mesh, Point};
use crate::scene::{ClosenessTo, Scene};

pub(super) const COLLAPSE: Example = Example {
    id: "fig-10-collapse",
    title: "Animal, pressed flat, recovers",
    summary: "All vertices start in one plane; rigid rings of neighbours are enough to raise the animal again.",
    statement: "With the quasi-Newton accelerator the energy falls to a millionth of that at the start in fewer than 60 iterations, and the animal regains all of its volume.",
    ending: "obj",
    make: collapse,
};

pub(super) const RANDOM: Example = Example {
    id: "fig-10-random",
    title: "Animal, scattered, recovers",
    summary: "All vertices start at random positions in a box: all that is left of the animal is which vertices are neighbours, and the shape of each piece.",
    statement: "With the quasi-Newton accelerator the energy falls to a billionth of that at the start in fewer than 400 iterations, and the animal regains all of its volume.",
    ending: "obj",
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
    Creature::default().mesh()
}
