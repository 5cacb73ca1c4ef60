//! Surfaces between the curves of a file: its polylines, and the boundaries of its faces.

mod curve;
mod fill;
mod loft;

pub use curve::{CurveLabel, SpanCurve, SpanError};
pub use fill::fill;
pub use loft::loft;
