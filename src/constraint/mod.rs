//! Shape constraints `C_i`: projection operators (paper section 3), the list of kinds, and
//! selectors.
//!
//! # Adding an operator
//!
//! 1. Write `kinds/<kind>.rs`: a struct whose fields are the parameters of the scene file, and its
//!    [`Projection`]. The operator receives only its own mean-centred points and their rest points:
//!    no indices, no mesh, no weights.
//! 2. Add one line to the list in `kinds/mod.rs`.
//!
//! The scene format, the command line, the controls of the page, the property tests and the
//! operator table are derived from the declaration.
//!
//! # Files
//!
//! | file or folder | holds |
//! |---|---|
//! | `projection` | the trait of an operator, the geometry that it may use, the shapes that it fits |
//! | `declaration` | the declaration of a kind: id, texts, arity, the selections that it usually fits |
//! | `kinds` | the operators and their list |
//! | `parameter` | parameters from JSON, and value types shared by several kinds |
//! | `select` | selectors and named sets |
//! | `resolve` | from a selector to the vertices of each constraint |
//! | `batch` | many constraints of one kind, projected in lanes |
//! | `sketch` | a drawing of a kind, made by the operator itself |
//!
#![doc = include_str!("operators.md")]

mod batch;
mod declaration;
mod kinds;
mod parameter;
mod projection;
mod resolve;
mod select;
mod sketch;

pub use batch::{Batch, LocalStep, Projected, batches};
pub use declaration::TargetShape;
pub use declaration::{Arity, Centring, Info};
pub use kinds::{KINDS, Kind, KindVisitor};
pub use parameter::{Form, KindError, Param, ParamValue};
pub use projection::Projection;
pub use projection::{Fitted, Reference, Row};
pub use resolve::resolve;
pub use select::{Element, SelectError, Selector, Set, Sets, describe};
pub use sketch::Sketch;
