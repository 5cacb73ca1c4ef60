//! The enum of kinds and its generic methods, generated from the list.

use crate::constraint::Projection;

/// A computation that needs the concrete type of the operator, such as making a batch.
pub trait KindVisitor {
    /// The result.
    type Output;
    /// The computation for one operator.
    fn visit<P: Projection>(self, operator: &P) -> Self::Output;
}

/// Generates the enum of kinds and its generic methods, from the only list of kinds in the project.
macro_rules! kinds {
    ($($module:ident :: $Kind:ident),* $(,)?) => {
        $(mod $module;)*

        /// A kind of constraint with its parameters.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Kind {
            $(#[doc = concat!("See `kinds/", stringify!($module), ".rs`.")]
            $Kind($module::$Kind),)*
        }

        /// All kinds, in the order in which hosts list them.
        pub const KINDS: &[Info] = &[$($module::$Kind::INFO),*];

        impl Kind {
            /// Returns the kind named `id` with the parameters `params`.
            ///
            /// # Errors
            /// If the id is unknown, or a parameter is unknown, of the wrong type or out of range.
            pub fn new(id: &str, params: serde_json::Value) -> Result<Kind, KindError> {
                $(if id == $module::$Kind::INFO.id {
                    let kind = Kind::$Kind(crate::json::from_value(params)?);
                    parameter::check_ranges($module::$Kind::INFO.params, &kind.params())?;
                    return Ok(kind);
                })*
                Err(KindError::Unknown)
            }

            /// The declaration.
            pub fn info(&self) -> &'static Info {
                match self { $(Kind::$Kind(_) => &$module::$Kind::INFO),* }
            }

            /// The parameters as in a scene file.
            pub fn params(&self) -> serde_json::Value {
                match self { $(Kind::$Kind(p) => serde_json::to_value(p)),* }
                    .expect("parameters serialize")
            }

            /// The number of points of one constraint with rest positions `rest` that have a
            /// partner: see [`Projection::paired`].
            pub fn paired(&self, rest: &[Vec3<f64>]) -> Option<usize> {
                match self { $(Kind::$Kind(p) => p.paired(rest)),* }
            }

            /// Calls `visitor` with the operator.
            pub fn visit<V: KindVisitor>(&self, visitor: V) -> V::Output {
                match self { $(Kind::$Kind(p) => visitor.visit(p)),* }
            }
        }
    };
}
