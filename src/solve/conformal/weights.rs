//! The options of a conformal map: the weights of the polygons, and the norm.

/// The weights `w_i` of Eq. 14.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalWeights {
    /// The inverse area of the polygon, so that the map does not depend on the meshing.
    #[default]
    InverseArea,
    /// `w_i = 1`.
    One,
    /// `|z|^2 / area`: on triangles these give least-squares conformal maps.
    Lscm,
}

/// The norm `u* B u` that is fixed to one, without which the map would shrink to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalNorm {
    /// The sum of squares over the boundary vertices is one. A part without a boundary uses all its
    /// vertices.
    #[default]
    Boundary,
    /// The sum of squares over all vertices is one.
    Vertices,
}
