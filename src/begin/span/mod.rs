//! Surfaces between the curves of a file: its polylines, and the boundaries of its faces.
//!
//! | file | holds |
//! |---|---|
//! | `curve` | the curves of a file, and points in equal steps along them |
//! | `error` | why there is no surface |
//! | `loft` | the surface between two curves |
//! | `fill` | the surface inside a closed curve |

mod curve;
mod error;
mod fill;
mod loft;

pub use curve::{CurveLabel, SpanCurve};
pub use error::SpanError;
pub use fill::fill;
pub use loft::loft;
