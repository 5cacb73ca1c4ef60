//! All native tests in one program, which links once: a room has the tests of the room of `src/` of
//! that name.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

mod support;

mod cli;
mod constraint;
mod documentation;
mod examples;
mod experiments;
mod fabricate;
mod golden;
mod library;
mod mesh;
mod quads;
mod rooms;
mod scene;
mod session;
mod solve;
mod undo_cost;
#[cfg(feature = "view")]
mod view;
mod words;
