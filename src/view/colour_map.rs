//! The perceptually uniform colour map of errors: viridis (van der Walt and Smith 2015), which also
//! reads in grey and to colour-blind eyes.

use glam::Vec3;

/// Texels of the map's texture.
pub const TEXELS: usize = 256;

/// The map as RGBA bytes, `TEXELS` by 4.
pub fn texels() -> Vec<u8> {
    (0..TEXELS)
        .flat_map(|i| {
            let colour = colorous::VIRIDIS.eval_rational(i, TEXELS);
            [colour.r, colour.g, colour.b, 255]
        })
        .collect()
}

/// The sRGB colour of a texel, each part 0 to 1.
pub fn colour(texel: u8) -> Vec3 {
    let colour = colorous::VIRIDIS.eval_rational(usize::from(texel), TEXELS);
    Vec3::new(f32::from(colour.r), f32::from(colour.g), f32::from(colour.b)) / 255.0
}

/// The texel of a value between `low` and `high`; values beyond take the end of the map, and `None`
/// stands for a value that is not a number. Where there is no range, everything is at the low end.
pub fn texel(value: f32, low: f32, high: f32) -> Option<u8> {
    if value.is_nan() {
        return None;
    }
    let part = if high > low { (value - low) / (high - low) } else { 0.0 };
    Some((part.clamp(0.0, 1.0) * (TEXELS - 1) as f32).round() as u8)
}

/// `count` CSS colours from the low to the high end of the map.
pub fn stops(count: usize) -> Vec<String> {
    (0..count)
        .map(|i| {
            let part = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.0 };
            let colour = colorous::VIRIDIS.eval_continuous(part);
            format!("rgb({} {} {})", colour.r, colour.g, colour.b)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_fall_on_the_map_and_stay_on_it() {
        assert_eq!(texel(2.0, 2.0, 4.0), Some(0));
        assert_eq!(texel(3.0, 2.0, 4.0), Some(128));
        assert_eq!(texel(9.0, 2.0, 4.0), Some(255));
        assert_eq!(texel(-9.0, 2.0, 4.0), Some(0));
        assert_eq!(texel(f32::NAN, 2.0, 4.0), None);
        assert_eq!(texel(f32::INFINITY, 2.0, 4.0), Some(255));
        assert_eq!(texel(1.0, 1.0, 1.0), Some(0));
    }

    #[test]
    fn the_legend_and_the_texture_show_the_same_colours() {
        let texels = texels();
        assert_eq!(texels.len(), TEXELS * 4);
        let stops = stops(3);
        let first = format!("rgb({} {} {})", texels[0], texels[1], texels[2]);
        assert_eq!(stops[0], first);
        assert!(stops[2].starts_with("rgb(253 231 "));
        assert_eq!(super::stops(1).len(), 1);
    }

    #[test]
    fn the_map_grows_lighter_all_the_way() {
        let light = |t: &[u8]| 0.2126 * t[0] as f32 + 0.7152 * t[1] as f32 + 0.0722 * t[2] as f32;
        let texels = texels();
        let lights: Vec<f32> = texels.chunks(4).map(light).collect();
        assert!(lights.windows(2).all(|w| w[1] > w[0] - 0.5));
        assert!(lights[255] - lights[0] > 150.0);
    }
}
