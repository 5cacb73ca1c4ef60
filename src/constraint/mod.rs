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
//! | `projection` | the trait of an operator |
//! | `declaration` | the declaration of a kind: id, texts, arity, parameters |
//! | `kinds` | the operators and their list |
//! | `parameter` | parameters from JSON, and value types shared by several kinds |
//! | `select` | selectors and named sets |
//! | `resolve` | from a selector to the vertices of each constraint |
//! | `batch` | many constraints of one kind, projected in lanes |
//! | `reference` | the rest surface, for operators that need it |
//! | `fitted` | fitted circles and spheres, for drawing |
//! | `target_shape` | the shape of a selection, which determines the usual kind for it |
//! | `sketch` | a drawing of a kind, made by the operator itself |

mod batch;
mod declaration;
mod fitted;
mod kinds;
mod parameter;
mod projection;
mod reference;
mod resolve;
mod select;
mod sketch;
mod target_shape;

pub use batch::{Batch, LocalStep, Projected, batches};
pub use declaration::{Arity, Centring, Info};
pub use fitted::Fitted;
pub use kinds::{DEFAULT_FOR, KINDS, Kind, KindVisitor};
pub use parameter::{Form, KindError, Param, ParamValue};
pub use projection::Projection;
pub use reference::{Reference, Row};
pub use resolve::resolve;
pub use select::{Element, SelectError, Selector, Set, Sets, describe};
pub use sketch::Sketch;
pub use target_shape::TargetShape;
