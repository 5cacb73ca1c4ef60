//! The forms of `on`: which vertices a constraint acts on.

use super::indices;
use super::node::{JsonCursor, Node};
use super::parse::parse;
use super::text::{field, object, text};
use crate::constraint::{Element, Selector};
use crate::scene::SceneError;

/// The forms of a selector, for messages.
pub(super) fn what() -> String {
    let all = Element::ALL.into_iter().filter_map(Element::word_for_all);
    let all: Vec<_> = all.map(|word| format!("\"{word}\"")).collect();
    format!("{}, {{\"each\": ...}}, {{\"set\": NAME}} or {{\"vertices\": LIST}}", all.join(", "))
}

/// The radius of an element that does not say its own.
fn default_radius(element: Element) -> u32 {
    if element == Element::Ring { 1 } else { 0 }
}

impl Selector {
    /// Reads the `on` of a constraint.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<Selector, SceneError> {
        read(&JsonCursor::root(&parse(json)?))
    }
}

pub(crate) fn read(at: &JsonCursor<'_>) -> Result<Selector, SceneError> {
    match at.node {
        Node::Text(word) => {
            let element = Element::ALL.into_iter().find(|e| e.word_for_all() == Some(word));
            let element = element.ok_or_else(|| at.expected(&what()))?;
            Ok(Selector::Each { element, within: None, radius: default_radius(element) })
        }
        Node::Object(_) => read_object(at),
        _ => Err(at.expected(&what())),
    }
}

fn read_object(at: &JsonCursor<'_>) -> Result<Selector, SceneError> {
    if let Some(set) = at.get("set") {
        at.only_keys(&["set"])?;
        return Ok(Selector::Set(set.text("the name of a set or group")?.to_owned()));
    }
    if let Some(list) = at.get("vertices") {
        at.only_keys(&["vertices"])?;
        let vertices = indices::read(&list)?;
        if vertices.is_empty() {
            return Err(list.error("the list is empty, expected at least one vertex"));
        }
        return Ok(Selector::Vertices(vertices));
    }
    at.only_keys(&["each", "in", "radius", "set", "vertices"])?;
    let element = at.need("each", &what())?.one_of(&Element::ALL.map(|e| (e.id(), e)))?;
    let within = match at.get("in") {
        Some(name) => Some(name.text("the name of a set or group")?.to_owned()),
        None => None,
    };
    let radius = match at.get("radius") {
        Some(radius) => {
            let what = format!("a whole number from {}", default_radius(element));
            match radius.whole(&what)? {
                found if found < default_radius(element) => return Err(radius.expected(&what)),
                found => found,
            }
        }
        None => default_radius(element),
    };
    Ok(Selector::Each { element, within, radius })
}

/// The shortest form that reads back to the selector.
pub(super) fn write(selector: &Selector) -> String {
    match selector {
        Selector::Set(name) => object(vec![field("set", text(name))]),
        Selector::Vertices(vertices) => object(vec![field("vertices", indices::write(vertices))]),
        Selector::Each { element, within, radius } => {
            let plain = within.is_none() && *radius == default_radius(*element);
            if let Some(word) = element.word_for_all().filter(|_| plain) {
                return text(word);
            }
            let mut fields = vec![field("each", text(element.id()))];
            if let Some(name) = within {
                fields.push(field("in", text(name)));
            }
            if *radius != default_radius(*element) {
                fields.push(field("radius", radius.to_string()));
            }
            object(fields)
        }
    }
}
