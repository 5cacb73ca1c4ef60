//! The solver: energies, factors, hard constraints and maps, against definitions and an independent
//! implementation.

mod conformal;
mod descent;
mod energies;
mod exact;
mod exact_boundary;
mod exact_limits;
mod expected;
mod factor;
mod improve;
mod precision;
mod registration;
mod variation;
