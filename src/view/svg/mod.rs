//! Pictures as SVG, for a page that cannot draw yet.
//!
//! | file | holds |
//! |---|---|
//! | `picture` | the picture that the page begins with |
//! | `circles` | its fitted circles |
//! | `thumbnail` | small pictures for the gallery |
//! | `light` | the colour of a face in the light |

mod circles;
pub mod light;
pub mod picture;
pub mod thumbnail;
