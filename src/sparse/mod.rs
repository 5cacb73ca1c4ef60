//! Sparse `L D L^T` of symmetric positive definite matrices, on the types of [`sprs`]. Knows nothing of
//! meshes.
//!
//! A matrix is a [`sprs::CsMatI`] in compressed columns with `u32` indices, of which only the upper
//! triangle is stored, in the order of elimination: rows ascend, so that the diagonal entry is the last
//! of its column. The steps are those of Davis, *Direct Methods for Sparse Linear Systems* (2006): an
//! order that keeps the fill low, the analysis of the pattern, the numeric factor, triangular sweeps.
//!
//! There are two numeric factors, and [`Factorization`] chooses. That of `sprs-ldl` computes one column
//! after another and serves small systems, where it costs no more than a frame can spare; the other
//! computes dense blocks of columns (supernodes), which is several times faster where there are many.
//! Both fill the same panels, which are swept in single or double precision, and to which vertices can be
//! added by rank-1 updates.
//!
//! | file | holds |
//! |---|---|
//! | `matrix` | the types of matrices and of right-hand sides, and which pivots are positive |
//! | `order` | the fill-reducing permutation: approximate minimum degree, then a postorder |
//! | `elimination_tree` | the elimination tree, its postorder, and the column counts of `L` |
//! | `supernodes` | which columns of `L` have the same rows, and these rows |
//! | `analysis` | all that follows from the pattern of a matrix: permutation, supernodes, components |
//! | `simplicial` | the numeric factor of `sprs-ldl` |
//! | `dense`, `supernodal` | the supernodal numeric factor, and its dense kernels |
//! | `scalar`, `panels` | the factor in dense panels of either precision, and the triangular sweeps |
//! | `blocks` | matrices of 3 by 3 blocks in the pattern of a scalar one, and their factor |
//! | `rank_one` | the factor after one diagonal entry has grown |
//! | `f32_factor` | panels in single precision, with the scaling that this needs |
//! | `factor` | the choice between the numeric factors, and the panels that they fill |

mod analysis;
mod blocks;
mod dense;
mod elimination_tree;
mod f32_factor;
mod factor;
mod matrix;
mod order;
mod panels;
mod rank_one;
mod scalar;
mod simplicial;
mod supernodal;
mod supernodes;

pub(crate) use analysis::SymbolicAnalysis;
pub(crate) use blocks::BlockMatrix;
pub(crate) use f32_factor::{F32Factor, F32Row, round};
pub use factor::Factorization;
pub(crate) use factor::{Factor, Precision};
pub(crate) use matrix::UpperTriangle;
pub(crate) use panels::Panels;
pub(crate) use rank_one::Update;
#[cfg(test)]
pub(crate) use supernodal::factor as supernodal_factor;
