//! The vertical axis.

/// Which axis points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// y, as in most viewers.
    Y,
    /// z, as in Rhino.
    #[default]
    Z,
}
