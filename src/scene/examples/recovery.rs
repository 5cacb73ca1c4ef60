//! Fig. 10: a model that comes back from a collapsed start.

use super::{Example, constraint};
use crate::constraint::{Element, Selector};
use crate::mesh::Mesh;
use crate::mesh::generate::Creature;
use crate::scene::{ClosenessTo, Scene};

pub(super) const COLLAPSE: Example = Example {
    id: "fig-10-collapse",
    title: "Animal, pressed flat, recovers",
    summary: "All vertices start in one plane; that each ring of neighbours is rigid is enough to raise the animal again.",
    statement: "With the quasi-Newton accelerator the energy falls to a millionth of that at the start in fewer than 60 iterations, and the animal has all of its volume again.",
    ending: "obj",
    make: collapse,
};

fn collapse(scene: &mut Scene) -> Mesh {
    let mesh = Creature::default().mesh();
    scene.current = Some(mesh.positions.iter().map(|&[x, y, _]| [x, y, 0.0]).collect());
    let rings = Selector::Each { element: Element::Ring, within: None, radius: 1 };
    scene.constraints = vec![constraint("rigid", rings, 1.0)];
    scene.closeness.to = ClosenessTo::None;
    mesh
}
