//! The choices of a conformal map: how polygons are weighed, and what is normalised.

/// The weights `w_i` of Eq. 14.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalWeights {
    /// The inverse of the area of the polygon, so that the map does not depend on the meshing.
    #[default]
    InverseArea,
    /// `w_i = 1`.
    One,
    /// `|z|^2 / area`: on triangles the map of least-squares conformal maps.
    Lscm,
}

/// The norm that is held at one, without which the map would shrink to a point: `u* B u = 1`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ConformalNorm {
    /// The boundary: the sum of squares over its vertices is one. A part without a boundary takes all its
    /// vertices.
    #[default]
    Boundary,
    /// The sum of squares over all vertices is one.
    Vertices,
}
