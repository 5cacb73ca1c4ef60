//! Conversions between Rust and the page: plain objects, typed arrays, errors with JSON paths.

use super::thrown;
use crate::mesh::Point;
use crate::scene::{NamedEnum, SceneError};
use js_sys::{Float32Array, Float64Array, Uint32Array};
use wasm_bindgen::JsValue;

pub(super) use super::plain_object as plain;

/// Returns a plain object of the page as JSON text.
pub(super) fn text(value: &JsValue) -> Result<String, JsValue> {
    Ok(String::from(js_sys::JSON::stringify(value)?))
}

pub(super) fn object<const N: usize>(entries: [(&str, JsValue); N]) -> Result<JsValue, JsValue> {
    let object = js_sys::Object::new();
    for (key, value) in entries {
        js_sys::Reflect::set(&object, &key.into(), &value)?;
    }
    Ok(object.into())
}

/// Returns the coordinates of points, `#points by 3`.
pub(super) fn flat(points: &[Point]) -> Float64Array {
    Float64Array::from(points.as_flattened())
}

/// Converts to single precision, for drawing.
pub(super) fn narrow(numbers: &[f64]) -> Float32Array {
    let narrow: Vec<f32> = numbers.iter().map(|&number| number as f32).collect();
    Float32Array::from(&narrow[..])
}

pub(super) fn indices(indices: &[u32]) -> JsValue {
    Uint32Array::from(indices).into()
}

pub(super) fn selection(
    vertices: &[u32],
    edges: &[u32],
    faces: &[u32],
) -> Result<JsValue, JsValue> {
    object([("vertices", indices(vertices)), ("edges", indices(edges)), ("faces", indices(faces))])
}

/// Returns the `Error` for an error in a scene or in a part of one, with its JSON path as `path`.
pub(super) fn thrown_at(error: &SceneError) -> JsValue {
    let thrown = thrown(error);
    // Setting a property of a new object cannot fail.
    let _ = js_sys::Reflect::set(&thrown, &"path".into(), &error.path.as_str().into());
    thrown
}

/// Returns the choice with the given word of the command line.
pub(super) fn of_word<T: NamedEnum>(what: &str, word: &str) -> Result<T, JsValue> {
    let unknown = || thrown(format!("{what} \"{word}\", expected one of {}", T::list(", ")));
    T::of_word(word).ok_or_else(unknown)
}
