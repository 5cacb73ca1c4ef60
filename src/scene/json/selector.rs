//! The forms of `on`, the selector of the vertices of a constraint.

use crate::constraint::{Element, Selector};
use crate::json::indices::{self, Indices};
use crate::json::{Either, JsonError, Words, present, word_or};
use crate::scene::error::forms_of_selectors;
use serde::de::{Deserialize, Deserializer, Error, Unexpected};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The keys of all forms.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct SelectorFile {
    #[serde(default, deserialize_with = "present")]
    set: Option<String>,
    #[serde(default, deserialize_with = "indices::some")]
    vertices: Option<Vec<u32>>,
    #[serde(default, deserialize_with = "present")]
    each: Option<Element>,
    #[serde(default, deserialize_with = "present")]
    r#in: Option<String>,
    #[serde(default, deserialize_with = "present")]
    radius: Option<u32>,
}

impl<'de> Deserialize<'de> for Element {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Element, D::Error> {
        from.deserialize_str(Words(&Element::ALL.map(|element| (element.id(), element))))
    }
}

impl<'de> Deserialize<'de> for Selector {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Selector, D::Error> {
        let forms = forms_of_selectors();
        match word_or(from, &forms)? {
            Either::Object(file) => selector_of(file).map_err(D::Error::custom),
            Either::Word(word) => {
                let is_all = |element: &Element| element.word_for_all() == Some(&*word);
                let element = Element::ALL.into_iter().find(is_all).ok_or_else(|| {
                    D::Error::invalid_value(Unexpected::Str(&word), &forms.as_str())
                })?;
                Ok(Selector::Each { element, within: None, radius: element.least_radius() })
            }
        }
    }
}

fn selector_of(file: SelectorFile) -> Result<Selector, JsonError> {
    let SelectorFile { set, vertices, each, r#in: within, radius } = file;
    let given = [
        ("set", set.is_some()),
        ("vertices", vertices.is_some()),
        ("each", each.is_some()),
        ("in", within.is_some()),
        ("radius", radius.is_some()),
    ];
    let alone = |own: &str| match given.into_iter().find(|(key, given)| *given && *key != own) {
        Some((key, _)) => Err(JsonError::unknown_key(key, &[own])),
        None => Ok(()),
    };
    if let Some(name) = set {
        return alone("set").map(|()| Selector::Set(name));
    }
    if let Some(vertices) = vertices {
        alone("vertices")?;
        if vertices.is_empty() {
            let message = "the list is empty, expected at least one vertex";
            return Err(JsonError::new("vertices", message));
        }
        return Ok(Selector::Vertices(vertices.into()));
    }
    let element = each.ok_or_else(|| JsonError::missing_key("each"))?;
    let least = element.least_radius();
    let radius = radius.unwrap_or(least);
    if radius < least {
        let message = format!("found {radius}, expected a whole number from {least}");
        return Err(JsonError::new("radius", message));
    }
    Ok(Selector::Each { element, within, radius })
}

/// Writes the shortest form that reads back to the selector.
impl Serialize for Selector {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Selector::Set(name) => to.collect_map([("set", name)]),
            Selector::Vertices(vertices) => to.collect_map([("vertices", Indices(&**vertices))]),
            Selector::Each { element, within, radius } => {
                let is_default = *radius == element.least_radius();
                let plain = within.is_none() && is_default;
                if let Some(word) = element.word_for_all().filter(|_| plain) {
                    return to.serialize_str(word);
                }
                let mut map = to.serialize_map(None)?;
                map.serialize_entry("each", element.id())?;
                if let Some(within) = within {
                    map.serialize_entry("in", within)?;
                }
                if !is_default {
                    map.serialize_entry("radius", radius)?;
                }
                map.end()
            }
        }
    }
}
