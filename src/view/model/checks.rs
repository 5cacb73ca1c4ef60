//! The checkerboard of a flat map: squares of the plane, mapped to the surface. Where they are
//! squares on the surface too, the map preserves angles.

use super::error::ViewError;
use super::lists::check_length;
use glam::{DVec2, Vec2};

/// A checkerboard on a surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Checks {
    /// #V, texture coordinates of the vertices about the centre of the map; empty without a map.
    pub uv: Vec<Vec2>,
    /// Number of squares per unit of length; none are drawn if it is 0.
    pub per_length: f32,
}

impl Checks {
    /// Creates a board from texture coordinates of `count` vertices, #V by 2, without squares yet.
    ///
    /// # Errors
    /// A wrong number of coordinates, or one that is not finite.
    pub fn new(uv: &[f64], count: usize) -> Result<Checks, ViewError> {
        check_length("flat map", uv.len(), 2 * count)?;
        let (pairs, _) = uv.as_chunks::<2>();
        if let Some(vertex) = pairs.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return Err(ViewError::NotFinite { vertex });
        }
        let uv = || pairs.iter().copied().map(DVec2::from);
        let low = uv().reduce(DVec2::min).unwrap_or_default();
        let high = uv().reduce(DVec2::max).unwrap_or_default();
        let middle = low + (high - low) * 0.5;
        Ok(Checks { uv: uv().map(|p| (p - middle).as_vec2()).collect(), per_length: 0.0 })
    }

    /// Returns the width and height of the map.
    pub fn extent(&self) -> Vec2 {
        let uv = || self.uv.iter().copied();
        let low = uv().reduce(Vec2::min).unwrap_or_default();
        uv().reduce(Vec2::max).unwrap_or_default() - low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lie_about_the_middle_of_the_map() {
        let checks = Checks::new(&[10.0, 5.0, 14.0, 5.0, 14.0, 7.0], 3).unwrap();
        assert_eq!(checks.uv[0], Vec2::new(-2.0, -1.0));
        assert_eq!(checks.extent(), Vec2::new(4.0, 2.0));
        assert_eq!(Checks::default().extent(), Vec2::ZERO);
    }

    #[test]
    fn places_that_do_not_fit_are_refused() {
        assert!(Checks::new(&[0.0; 4], 3).is_err());
        assert!(Checks::new(&[0.0; 7], 3).is_err());
        let error = Checks::new(&[0.0, 0.0, f64::NAN, 0.0], 2).unwrap_err();
        assert_eq!(error, ViewError::NotFinite { vertex: 1 });
    }
}
