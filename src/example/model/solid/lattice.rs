//! Points of a grid in space.

/// The index of a point of a grid of `#x, #y, #z` points, in the order of [`grid_points`].
pub(super) fn linear_index([x, y, z]: [u32; 3], [nx, ny, _]: [u32; 3]) -> u32 {
    (z * ny + y) * nx + x
}

/// All points of a grid, by z, then y, then x.
pub(super) fn grid_points([nx, ny, nz]: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    (0..nx * ny * nz).map(move |k| [k % nx, k / nx % ny, k / (nx * ny)])
}
