//! Execution of selection requests; what depends on numbers of sides, valences, errors and names.

use super::elements::{self, Elements, Marks};
use super::operation::{OPERATIONS, Operation};
use super::request::{Mode, SelectRequest, Selection, error};
use crate::constraint::{Param, Selector, Sets, resolve};
use crate::scene::SceneError;
use crate::session::Session;
use crate::session::state::RestMesh;
use serde_json::{Map, Value, json};

impl Session {
    /// Returns the selection after `request`, on the current shape; indices ascending.
    ///
    /// # Errors
    /// If it refers to an operation, a set or an element that does not exist, or if a parameter is
    /// not a number in its range.
    pub fn select(&mut self, request: &SelectRequest) -> Result<Selection, SceneError> {
        let operation = OPERATIONS
            .iter()
            .find(|operation| operation.id == request.operation)
            .ok_or_else(|| {
                error("operation", format!("unknown selection operation `{}`", request.operation))
            })?;
        check(&request.from, &Elements::new(self.mesh(), self.topology()))?;
        let mode = match operation.id {
            // The edges, because the faces along a boundary would add an inner ring of vertices.
            "boundary" if request.mode == Mode::Faces => Mode::Edges,
            _ => operation.gives.unwrap_or(request.mode),
        };
        let params = Params { operation, given: &request.params };
        let found = match operation.id {
            // These need more than the mesh: errors of faces, sets, or what acts on vertices.
            "error" => {
                with_error_above(self, params.word("measure")?, params.number("tolerance")?)?
            }
            "named" => named(params.word("name")?, &self.document().sets, &self.rest)?,
            "free" => Selection { vertices: self.free(), ..Selection::default() },
            _ => Selection::default(),
        };
        let elements = Elements::new(self.mesh(), self.topology());
        let positions = self.scene.positions();
        let seeds = elements.marks(mode, &request.from);
        let marks = match operation.id {
            "all" => vec![true; elements.count(mode)],
            "invert" => elements::not(seeds),
            "grow" => elements.around(mode, &seeds),
            "shrink" => elements::not(elements.around(mode, &elements::not(seeds))),
            "to-vertices" | "to-edges" | "to-faces" => seeds,
            "connected" => elements.connected(mode, &seeds),
            "boundary" | "boundary-faces" => elements.boundary(mode, &seeds),
            "loop" => elements.edge_loops(mode, &request.from),
            "ring" => elements.edge_rings(&seeds),
            "strip" => elements.strips(&seeds),
            "flat" => elements.flat_patch(&seeds, params.number("angle")?, positions),
            "sides" => elements.with_sides(params.number("sides")?),
            "valence" => elements.with_valence(params.number("edges")?),
            "error" | "named" | "free" => elements.marks(mode, &found),
            id => unreachable!("{id} is declared"),
        };
        Ok(elements::selection(mode, &marks))
    }
}

impl Elements<'_> {
    /// Returns the faces with this number of corners.
    fn with_sides(&self, sides: f64) -> Marks {
        self.mesh.faces.iter().map(|face| face.len() as f64 == sides).collect()
    }

    /// Returns the vertices with this number of edges.
    fn with_valence(&self, edges: f64) -> Marks {
        self.topology.neighbours().iter().map(|row| row.len() as f64 == edges).collect()
    }
}

/// Returns the faces of the current shape whose error is above `tolerance`; `measure` is one of
/// [`crate::session::FACE_MEASURES`], and the tolerance is in its unit.
fn with_error_above(
    session: &mut Session,
    measure: String,
    tolerance: f64,
) -> Result<Selection, SceneError> {
    let errors = session
        .face_errors(&measure)
        .ok_or_else(|| error("measure", format!("unknown measure of faces `{measure}`")))?;
    let above = (0..).zip(errors).filter(|&(_, error)| error > tolerance);
    Ok(Selection { faces: above.map(|(face, _)| face).collect(), ..Selection::default() })
}

/// Returns the members of a set or, if there is none of that name, of a group: its faces, and the
/// vertices of its curves.
fn named(name: String, sets: &Sets, rest: &RestMesh) -> Result<Selection, SceneError> {
    if let Some(set) = sets.get(&name) {
        let (vertices, faces) = (set.vertices.to_vec(), set.faces.to_vec());
        return Ok(Selection { vertices, faces, ..Selection::default() });
    }
    let mesh = rest.mesh();
    let mut found = Selection::default();
    for group in mesh.groups.iter().filter(|group| group.name == name) {
        found.faces.extend(&group.faces);
        let curves = group.curves.iter().map(|&curve| mesh.curves.row(curve as usize));
        found.vertices.extend(curves.flatten());
    }
    if found == Selection::default() {
        let selected = resolve(&Selector::Set(name), mesh, rest.topology(), sets);
        selected.map_err(|problem| error("name", problem.to_string()))?;
    }
    Ok(found)
}

/// Checks that all elements of a selection exist in the mesh.
fn check(from: &Selection, elements: &Elements<'_>) -> Result<(), SceneError> {
    for (name, mode, items) in [
        ("vertices", Mode::Vertices, &from.vertices),
        ("edges", Mode::Edges, &from.edges),
        ("faces", Mode::Faces, &from.faces),
    ] {
        let count = elements.count(mode);
        if let Some(item) = items.iter().find(|&&item| item as usize >= count) {
            let message = format!("{item} is out of range: the mesh has {count}");
            return Err(error(&format!("from.{name}"), message));
        }
    }
    Ok(())
}

/// The parameters of an operation: the given ones, and defaults for the rest.
struct Params<'a> {
    operation: &'a Operation,
    given: &'a Map<String, Value>,
}

impl Params<'_> {
    fn declared(&self, id: &str) -> Option<&Param> {
        self.operation.params.iter().find(|param| param.id == id)
    }

    /// The given value, or the default; null for a name, which has none.
    fn value(&self, id: &str) -> Value {
        let usual = || self.declared(id).map_or(Value::Null, |param| json!(param.default));
        self.given.get(id).cloned().unwrap_or_else(usual)
    }

    fn number(&self, id: &str) -> Result<f64, SceneError> {
        let param = self.declared(id).expect("the numbers of an operation are declared");
        let value = self.value(id).as_f64();
        value
            .filter(|&value| param.allows(value))
            .ok_or_else(|| error(id, format!("expected {}", param.range_in_words())))
    }

    fn word(&self, id: &str) -> Result<String, SceneError> {
        let value = self.value(id);
        value.as_str().map(str::to_owned).ok_or_else(|| error(id, "expected a word".to_owned()))
    }
}
