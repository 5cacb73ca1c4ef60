//! Selecting by properties of the mesh: neighbours, loops, strips, patches, errors, sets.
//!
//! | file | holds |
//! |---|---|
//! | `request` | selections and requests for them |
//! | `select` | execution of a request; by number of sides, by valence, by error, by name |
//! | `operation` | the declared selection operations |
//! | `elements` | vertices, edges and faces as marks: conversion and neighbours |
//! | `follow` | along the mesh: connected parts, boundary loops, edge loops and rings, strips, flat patches |

mod elements;
mod follow;
mod operation;
mod request;
mod select;

pub use operation::{OPERATIONS, Operation};
pub use request::{Mode, SelectRequest, Selection};
