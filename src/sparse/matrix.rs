//! The types of matrices and of right-hand sides.

use sprs::CsMatI;

/// The upper triangle of a symmetric matrix in compressed columns, rows ascending, with every diagonal
/// entry: it is the last one of its column.
pub(crate) type UpperTriangle = CsMatI<f64, u32>;

/// Coordinates x, y, z of one unknown, and a zero that fills two 128-bit registers.
pub(crate) type Row = [f64; 4];
