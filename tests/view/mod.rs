//! The view without a GPU.

mod legible;
mod seeing;
mod selecting;
mod stage;
