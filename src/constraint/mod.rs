//! Shape constraints `C_i`: projection operators (paper section 3), the list of kinds, and which
//! vertices they act on.
//!
//! # Adding an operator
//!
//! 1. Write `kinds/<kind>.rs`: a struct whose fields are the parameters of the scene file, and its
//!    [`Projection`]. It sees its own mean-centred points and their rest points, and nothing else: no
//!    indices, no mesh, no weights.
//! 2. Add one line to the list in `kinds/mod.rs`.
//!
//! The scene format, the command line, the controls of the page, the property tests and the
//! operator table follow from the declaration.
//!
//! # Files
//!
//! | file or folder | holds |
//! |---|---|
//! | `projection` | the trait of an operator |
//! | `declaration` | what a kind declares: its id, texts, arity, parameters |
//! | `kinds` | the operators and their list |
//! | `parameter` | parameters from JSON, and values that kinds have in common |
//! | `select` | selectors and named sets |
//! | `resolve` | from a selector to the vertices of each constraint |
//! | `batch` | many constraints of one kind, projected in lanes |
//! | `reference` | the rest surface, for operators that ask for it |
//! | `fitted` | fitted circles and spheres, to be drawn |
//! | `target_shape` | what a selection is to the mesh, for which a kind is the usual choice |
//! | `sketch` | a drawing of what a kind asks, made by the operator itself |

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
pub use kinds::{KINDS, Kind, KindVisitor, USUAL_FOR};
pub use parameter::{Form, KindError, Param, ParamValue};
pub use projection::Projection;
pub use reference::{Reference, Row};
pub use resolve::resolve;
pub use select::{Element, SelectError, Selector, Set, Sets, describe};
pub use sketch::Sketch;
pub use target_shape::TargetShape;
