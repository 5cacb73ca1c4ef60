//! Parameters of kinds: what a kind declares of them, how they are read, and values that several kinds
//! take.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | key, unit, default, forms and range of a parameter |
//! | `range` | whether numbers are in their range |
//! | `kind_error` | why a kind or a parameter is refused |
//! | `limits`, `angle_range` | a number or a range; of lengths, of angles |
//! | `target` | a quantity relative to that at rest, or given |
//! | `direction` | a direction in space |

mod angle_range;
mod declaration;
mod direction;
mod kind_error;
mod limits;
mod range;
mod target;

pub(crate) use angle_range::AngleRange;
pub use declaration::{Form, Param, ParamValue};
pub(crate) use direction::Direction;
pub use kind_error::KindError;
pub(crate) use limits::Limits;
pub(crate) use range::check_ranges;
pub(crate) use target::Target;
