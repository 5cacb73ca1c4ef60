//! Limits the size of a canvas to what an adapter can draw.

/// Returns the largest size of the same proportions with no side over `limit`, and none under 1.
pub fn clamp_size(width: u32, height: u32, limit: u32) -> (u32, u32) {
    let longer = width.max(height);
    if longer <= limit {
        return (width.max(1), height.max(1));
    }
    let scale = |side: u32| (u64::from(side) * u64::from(limit) / u64::from(longer)).max(1) as u32;
    (scale(width), scale(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_canvas_over_the_limit_keeps_its_proportions() {
        assert_eq!(clamp_size(1440, 900, 8192), (1440, 900));
        assert_eq!(clamp_size(10240, 5760, 8192), (8192, 4608));
        assert_eq!(clamp_size(0, 5, 8192), (1, 5));
        assert_eq!(clamp_size(100_000, 1, 2048), (2048, 1));
    }
}
