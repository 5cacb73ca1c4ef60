//! Computed meshes of the examples. Lengths are in metres.

mod archway;
mod blocks;
mod creature;
mod free_form;
mod halls;
mod lattice;
mod mask;
mod pavilion;
mod roofs;
mod sheets;
mod towers;
mod vault;

pub use archway::archway;
pub use blocks::Blocks;
pub use creature::creature;
pub use free_form::FreeForm;
pub use halls::{Hall, Mounds, honeycomb};
pub use mask::mask;
pub use pavilion::pavilion;
pub use roofs::{Canopy, Court, Dome};
pub use sheets::{Hypar, Net, Patch, Strip};
pub use towers::{Lantern, Tower, Vase};
pub use vault::vault;
