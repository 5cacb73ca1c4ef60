//! The view without a GPU.

mod first_picture;
mod legible;
mod seeing;
mod stage;
