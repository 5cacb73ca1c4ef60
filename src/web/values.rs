//! Values of Rust as those of JavaScript, with their TypeScript types, and back.
//!
//! A method says by [`Js`] which type it takes or returns; wasm-bindgen then writes that type, which
//! tsify has declared. [`plain`] and [`read`] convert, so that a value of another type is an error of
//! the compiler.

use super::thrown;
use crate::json::from_text;
use crate::mesh::Point;
use crate::scene::SceneError;
use crate::session::Error;
use js_sys::{Float32Array, Float64Array, JSON, Uint32Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use tsify::Tsify;
use wasm_bindgen::{JsCast, JsValue};

/// The JavaScript form of `T`.
pub(super) type Js<T> = <T as Tsify>::JsType;

/// Converts to a plain object: maps become objects, absent values null.
pub(super) fn plain<T: Tsify + Serialize>(value: &T) -> Result<Js<T>, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    Ok(value.serialize(&serializer).map_err(thrown)?.unchecked_into())
}

/// Converts each value to a plain object.
pub(super) fn plains<T: Tsify + Serialize>(values: &[T]) -> Result<Vec<Js<T>>, JsValue> {
    values.iter().map(plain).collect()
}

/// Reads a plain object of the page, by its JSON. serde-wasm-bindgen would ask the object for the
/// fields of the type only, so that others were ignored, and takes undefined for null.
///
/// # Errors
/// A value that does not fit, with its path, as in a scene file.
pub(super) fn read<T: Tsify + DeserializeOwned>(given: Js<T>) -> Result<T, JsValue> {
    let text: JsValue = JSON::stringify(&given.into())?.into();
    // Undefined has no text.
    from_text(&text.as_string().unwrap_or_default()).map_err(|error| thrown_at(&error.into()))
}

/// Reads a plain object that [`plain`] has made, with all of its numbers.
pub(super) fn read_back<T: Tsify + DeserializeOwned>(made: Js<T>) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(made.into()).map_err(thrown)
}

/// A typed array in an object: it is passed on as it is.
#[derive(Serialize, Tsify)]
pub(super) struct AsIs<T: JsCast>(#[serde(with = "serde_wasm_bindgen::preserve")] pub(super) T);

pub(super) fn indices(indices: &[u32]) -> AsIs<Uint32Array> {
    AsIs(Uint32Array::from(indices))
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

/// Returns the `Error` for an error in a scene or in a part of one, with its JSON path as `path`.
pub(super) fn thrown_at(error: &SceneError) -> JsValue {
    let thrown = thrown(error);
    // Setting a property of a new object cannot fail.
    let _ = js_sys::Reflect::set(&thrown, &"path".into(), &error.path.as_str().into());
    thrown
}

/// Returns the `Error` for a refused edit or question.
pub(super) fn refused(error: Error) -> JsValue {
    match error {
        Error::Scene(error) => thrown_at(&error),
        error => thrown(error),
    }
}
