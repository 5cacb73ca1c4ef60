//! Sparse `L D L^T` of symmetric positive definite matrices, on the types of [`sprs`]. Independent
//! of meshes.
//!
//! A matrix is a [`sprs::CsMatI`] in compressed columns with `u32` indices. Only the upper triangle
//! is stored, in the elimination order: rows ascend, so that the diagonal entry is the last of its
//! column. The steps are those of Davis, *Direct Methods for Sparse Linear Systems* (2006):
//! fill-reducing order, symbolic analysis, numeric factorisation, triangular sweeps.
//!
//! [`Factorization`] chooses between two numeric factorisations. `sprs-ldl` computes one column
//! after another and serves small systems, which it factors in the time that a frame can spare; the
//! other computes dense blocks of columns (supernodes), which is several times faster for many
//! unknowns. Both fill the same panels, which are swept in single or double precision and support
//! rank-1 updates that add vertices.
//!
//! | file | holds |
//! |---|---|
//! | `matrix` | the types of matrices and right-hand sides, positive pivots, the two precisions |
//! | `elimination_tree` | the elimination tree, its postorder, and the column counts of `L` |
//! | `supernodes` | runs of columns of `L` with the same rows, and these rows |
//! | `analysis` | symbolic analysis of a pattern: fill-reducing order, supernodes, components |
//! | `dense`, `supernodal` | the supernodal numeric factor, and its dense kernels |
//! | `panels` | the factor in dense panels of either precision, and the triangular sweeps |
//! | `blocks` | matrices of 3 by 3 blocks in the pattern of a scalar one, and their factor |
//! | `rank_one` | updates of the factor after one diagonal entry has grown |
//! | `f32_factor` | panels in single precision, with the scaling that they need |
//! | `factor` | the choice between the numeric factorisations, that of `sprs-ldl`, and the panels that both fill |

mod analysis;
mod blocks;
mod dense;
mod elimination_tree;
mod f32_factor;
mod factor;
mod matrix;
mod panels;
mod rank_one;
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
