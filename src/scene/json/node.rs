//! A JSON document as a tree that keeps the order of keys and refuses a key that occurs twice, and
//! [`JsonCursor`], a place in it: values are taken out by type, and what does not fit names the place.

use crate::scene::{NamedEnum, SceneError};
use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};
use std::cell::Cell;
use std::fmt;

/// A JSON value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Node {
    Null,
    Bool(bool),
    Number(Number),
    Text(String),
    Array(Vec<Node>),
    /// Keys in the order of the document, none twice.
    Object(Vec<(String, Node)>),
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Node, D::Error> {
        deserializer.deserialize_any(NodeVisitor)
    }
}

struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }
    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }
    fn visit_bool<E>(self, value: bool) -> Result<Node, E> {
        Ok(Node::Bool(value))
    }
    fn visit_u64<E>(self, value: u64) -> Result<Node, E> {
        Ok(Node::Number(value.into()))
    }
    fn visit_i64<E>(self, value: i64) -> Result<Node, E> {
        Ok(Node::Number(value.into()))
    }
    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Node, E> {
        Number::from_f64(value).map(Node::Number).ok_or_else(|| E::custom("number is not finite"))
    }
    fn visit_str<E>(self, value: &str) -> Result<Node, E> {
        Ok(Node::Text(value.to_owned()))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Node, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = array.next_element()? {
            items.push(item);
        }
        Ok(Node::Array(items))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Node, A::Error> {
        let mut entries = Vec::new();
        let mut seen = std::collections::BTreeSet::new();
        while let Some(key) = object.next_key::<String>()? {
            if !seen.insert(key.clone()) {
                return Err(de::Error::custom(format_args!("the key `{key}` occurs twice")));
            }
            entries.push((key, object.next_value()?));
        }
        Ok(Node::Object(entries))
    }
}

impl Node {
    /// The same value for serde.
    pub(crate) fn to_value(&self) -> Value {
        match self {
            Node::Null => Value::Null,
            Node::Bool(value) => Value::Bool(*value),
            Node::Number(value) => Value::Number(value.clone()),
            Node::Text(value) => Value::String(value.clone()),
            Node::Array(items) => items.iter().map(Node::to_value).collect(),
            Node::Object(entries) => {
                object(entries.iter().map(|(key, node)| (key.clone(), node.to_value())))
            }
        }
    }

    /// What it is, for the "found" of a message.
    fn describe(&self) -> String {
        match self {
            Node::Null => "null".to_owned(),
            Node::Bool(value) => value.to_string(),
            Node::Number(value) => value.to_string(),
            Node::Text(text) if text.chars().count() > 40 => {
                format!("{:?}...", text.chars().take(40).collect::<String>())
            }
            Node::Text(text) => format!("{text:?}"),
            Node::Array(items) => format!("an array of {}", items.len()),
            Node::Object(_) => "an object".to_owned(),
        }
    }
}

/// How many indices the ranges of a document may stand for, all together: a few bytes of text stand for
/// any number, and this many take 64 MiB.
const MOST_INDICES: usize = 1 << 24;

/// A value and where it stands in the document.
pub(crate) struct JsonCursor<'a> {
    parent: Option<&'a JsonCursor<'a>>,
    step: Step<'a>,
    pub(crate) node: &'a Node,
    /// How many indices ranges may still stand for; that of the root counts.
    indices_left: Cell<usize>,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    Root,
    Key(&'a str),
    Index(usize),
}

impl<'a> JsonCursor<'a> {
    pub(crate) fn root(node: &'a Node) -> JsonCursor<'a> {
        JsonCursor { parent: None, step: Step::Root, node, indices_left: Cell::new(MOST_INDICES) }
    }

    fn below(&'a self, step: Step<'a>, node: &'a Node) -> JsonCursor<'a> {
        JsonCursor { parent: Some(self), step, node, indices_left: Cell::new(0) }
    }

    /// Whether the ranges of the document may stand for `count` more indices, which then count.
    pub(crate) fn takes_indices(&self, count: usize) -> bool {
        let mut root = self;
        while let Some(parent) = root.parent {
            root = parent;
        }
        let left = root.indices_left.get().checked_sub(count);
        left.inspect(|&left| root.indices_left.set(left)).is_some()
    }

    /// The JSON path, such as `constraints[2].on.set`; empty at the root.
    pub(crate) fn path(&self) -> String {
        let mut path = self.parent.map(JsonCursor::path).unwrap_or_default();
        match self.step {
            Step::Root => {}
            Step::Key(key) => push_key(&mut path, key),
            Step::Index(index) => path.push_str(&format!("[{index}]")),
        }
        path
    }

    pub(crate) fn error(&self, message: impl Into<String>) -> SceneError {
        SceneError { path: self.path(), message: message.into() }
    }

    /// "found ..., expected ..." at this place.
    pub(crate) fn expected(&self, what: &str) -> SceneError {
        self.error(format!("found {}, expected {what}", self.node.describe()))
    }

    /// The entries of an object, whatever their keys are.
    pub(crate) fn entries(
        &'a self,
        what: &str,
    ) -> Result<Vec<(&'a str, JsonCursor<'a>)>, SceneError> {
        let Node::Object(entries) = self.node else { return Err(self.expected(what)) };
        Ok(entries
            .iter()
            .map(|(key, node)| (key.as_str(), self.below(Step::Key(key), node)))
            .collect())
    }

    /// Checks that this is an object with no other keys than `known`.
    pub(crate) fn only_keys(&self, known: &[&str]) -> Result<(), SceneError> {
        let Node::Object(entries) = self.node else { return Err(self.expected("an object")) };
        match entries.iter().find(|(key, _)| !known.contains(&key.as_str())) {
            Some((key, _)) => Err(self.unknown_key(key, known)),
            None => Ok(()),
        }
    }

    /// The error for a key that has no meaning in this object.
    pub(crate) fn unknown_key(&self, key: &str, known: &[&str]) -> SceneError {
        self.error(format!("unknown key `{key}`, known here: {}", known.join(", ")))
    }

    /// The value of `key` when this is an object that has it.
    pub(crate) fn get(&'a self, key: &'a str) -> Option<JsonCursor<'a>> {
        let Node::Object(entries) = self.node else { return None };
        let (key, node) = entries.iter().find(|(k, _)| k == key)?;
        Some(self.below(Step::Key(key), node))
    }

    /// The value of `key`, which must be there; `what` says what it would be.
    pub(crate) fn need(&'a self, key: &'a str, what: &str) -> Result<JsonCursor<'a>, SceneError> {
        self.get(key).ok_or_else(|| self.error(format!("`{key}` is missing, expected {what}")))
    }

    pub(crate) fn array(&'a self, what: &str) -> Result<Vec<JsonCursor<'a>>, SceneError> {
        let Node::Array(items) = self.node else { return Err(self.expected(what)) };
        Ok(items.iter().enumerate().map(|(i, node)| self.below(Step::Index(i), node)).collect())
    }

    pub(crate) fn text(&self, what: &str) -> Result<&'a str, SceneError> {
        match self.node {
            Node::Text(text) => Ok(text),
            _ => Err(self.expected(what)),
        }
    }

    pub(crate) fn truth(&self) -> Result<bool, SceneError> {
        match self.node {
            Node::Bool(value) => Ok(*value),
            _ => Err(self.expected("true or false")),
        }
    }

    /// A finite number.
    pub(crate) fn number(&self, what: &str) -> Result<f64, SceneError> {
        match self.node {
            Node::Number(number) => {
                let value = number.as_f64().filter(|value| value.is_finite());
                value.ok_or_else(|| self.expected(what))
            }
            _ => Err(self.expected(what)),
        }
    }

    /// A whole number that an index or a count can have.
    pub(crate) fn whole(&self, what: &str) -> Result<u32, SceneError> {
        let Node::Number(number) = self.node else { return Err(self.expected(what)) };
        let whole = number.as_u64().and_then(|value| u32::try_from(value).ok());
        whole.ok_or_else(|| self.expected(what))
    }

    /// Three finite numbers.
    pub(crate) fn point(&'a self) -> Result<[f64; 3], SceneError> {
        const WHAT: &str = "a point [x, y, z]";
        let items = self.array(WHAT)?;
        let [x, y, z] = items.as_slice() else { return Err(self.expected(WHAT)) };
        Ok([x.number("a number")?, y.number("a number")?, z.number("a number")?])
    }

    /// The choice that a word stands for.
    pub(crate) fn choice<T: NamedEnum>(&self) -> Result<T, SceneError> {
        self.one_of(T::WORDS)
    }

    /// One of the words of `choices`.
    pub(crate) fn one_of<T: Copy>(&self, choices: &[(&str, T)]) -> Result<T, SceneError> {
        let found = match self.node {
            Node::Text(text) => choices.iter().find(|(word, _)| word == text),
            _ => None,
        };
        found.map(|&(_, value)| value).ok_or_else(|| {
            let words: Vec<_> = choices.iter().map(|(word, _)| format!("{word:?}")).collect();
            self.expected(&words.join(" or "))
        })
    }
}

/// An object of these entries. Collecting them would sort them first, in a copy of its own of the
/// standard library's sort wherever it is done.
pub(in crate::scene) fn object(entries: impl Iterator<Item = (String, Value)>) -> Value {
    let mut object = Map::new();
    object.extend(entries);
    Value::Object(object)
}

/// Appends a key to a JSON path; one that is not a plain word is quoted.
pub(in crate::scene) fn push_key(path: &mut String, key: &str) {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if key.is_empty() || !key.chars().all(plain) {
        path.push_str(&format!("[{key:?}]"));
    } else {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(key);
    }
}

/// An array of points.
pub(super) fn read_points(at: &JsonCursor<'_>) -> Result<Vec<crate::mesh::Point>, SceneError> {
    at.array("an array of points [x, y, z]")?.iter().map(JsonCursor::point).collect()
}
