//! The view without a GPU.

#![cfg(feature = "view")]
#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

mod legible;
mod seeing;
mod stage;
