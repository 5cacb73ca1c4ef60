//! Surfaces between curves that a file brings: its polylines, and the boundaries of its faces.
//!
//! | file | holds |
//! |---|---|
//! | `curve` | the curves of a file, and points in even steps along them |
//! | `error` | why there is no surface |
//! | `loft` | the surface between two curves |
//! | `fill` | the surface inside a closed one |

mod curve;
mod error;
mod fill;
mod loft;

pub use curve::{CurveWords, SpanCurve};
pub use error::SpanError;
pub use fill::fill;
pub use loft::loft;
