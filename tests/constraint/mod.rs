//! Operators and selectors: properties of every kind, and of single kinds.

mod cases;
mod conformance;
mod operations;
mod radius;
mod rectangle;
mod relative;
mod round;
mod selectors;
mod sketch;
