//! Shapes and numbers closest to given ones.
//!
//! | file | holds |
//! |---|---|
//! | `alignment` | the closest rotation and similarity (Umeyama) |
//! | `circle_fit` | circles in space |
//! | `round` | circles and spheres in the sense of Thomas and Chan |
//! | `round_within` | circles and spheres whose radius is within limits |
//! | `orthogonal_pair` | two vectors of equal length at right angles |
//! | `product` | numbers with a given product |

mod alignment;
mod circle_fit;
mod orthogonal_pair;
mod product;
mod round;
mod round_within;

pub use alignment::Alignment;
pub use circle_fit::{CircleFit, PrincipalCircle};
pub use orthogonal_pair::OrthogonalPair;
pub use product::{
    pair_with_product, pair_with_product_robust, triple_with_product, triple_with_product_robust,
};
pub use round::Round;
pub use round_within::{PrincipalRound, RoundWithin};
