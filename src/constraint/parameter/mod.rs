//! Parameters of kinds: declaration, deserialisation, and value types of several kinds.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | key, unit, default, forms and range of a parameter |
//! | `range` | range checks of numbers |
//! | `kind_error` | errors of a kind or a parameter |
//! | `limits`, `angle_range` | a number or a range, of amounts or angles |
//! | `target` | an amount, given or as at rest |
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
