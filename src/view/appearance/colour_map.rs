//! The perceptually uniform colour maps of errors, which also read to colour-blind eyes: viridis (van
//! der Walt and Smith 2015) for all values, and a map of our own for those beyond a tolerance.
//!
//! Values within the tolerance have the colour of the material, light or dark. So the second map
//! begins pale, but where it differs from every grey, and ends before it is dark: a shape that is
//! nearly as asked is calm, and the worst faces are seen on both themes. It goes along straight lines
//! of Oklab (Ottosson 2020) at an even speed.

use glam::{DVec3, Vec3};

/// Texels of the map's texture.
pub const TEXELS: usize = 256;

/// Which values have which colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourMap {
    /// For all values: dark is least.
    Full,
    /// For values beyond a tolerance: from apricot over coral and magenta to violet.
    Beyond,
}

/// Where [`ColourMap::Beyond`] turns, in Oklab.
const BEYOND: [DVec3; 4] = [
    DVec3::new(0.879, 0.037, 0.044),
    DVec3::new(0.737, 0.106, 0.078),
    DVec3::new(0.579, 0.184, -0.027),
    DVec3::new(0.432, 0.122, -0.150),
];

/// The colour at a part of the way along a polyline in Oklab.
fn along(line: &[DVec3], part: f64) -> colorous::Color {
    let sides = || line.windows(2).map(|ends| (ends[0], ends[1]));
    let mut left = part * sides().map(|(from, to)| from.distance(to)).sum::<f64>();
    for (from, to) in sides() {
        let length = from.distance(to);
        if left <= length {
            return srgb(from.lerp(to, left / length));
        }
        left -= length;
    }
    srgb(line[line.len() - 1])
}

/// The sRGB colour of a colour of Oklab that has one.
fn srgb(oklab: DVec3) -> colorous::Color {
    let cone = |a: f64, b: f64| (oklab.x + a * oklab.y + b * oklab.z).powi(3);
    let long = cone(0.396_337_777_4, 0.215_803_757_3);
    let middle = cone(-0.105_561_345_8, -0.063_854_172_8);
    let short = cone(-0.089_484_177_5, -1.291_485_548_0);
    let byte = |l: f64, m: f64, s: f64| {
        let linear = (l * long + m * middle + s * short).clamp(0.0, 1.0);
        let part = if linear > 0.003_130_8 {
            // To the power of 5/12: the third root, times its fourth root.
            let root = linear.cbrt();
            1.055 * root * root.sqrt().sqrt() - 0.055
        } else {
            12.92 * linear
        };
        (255.0 * part).round() as u8
    };
    colorous::Color {
        r: byte(4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2),
        g: byte(-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5),
        b: byte(-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0),
    }
}

impl ColourMap {
    /// The colour of a place from 0 to 1.
    fn at(self, part: f64) -> colorous::Color {
        match self {
            ColourMap::Full => colorous::VIRIDIS.eval_continuous(part),
            ColourMap::Beyond => along(&BEYOND, part),
        }
    }

    fn of_texel(self, texel: usize) -> colorous::Color {
        match self {
            // The nearest of the 256 colours by which viridis is defined.
            ColourMap::Full => colorous::VIRIDIS.eval_rational(texel, TEXELS),
            ColourMap::Beyond => self.at(texel as f64 / (TEXELS - 1) as f64),
        }
    }

    /// The map as RGBA bytes, `TEXELS` by 4.
    pub fn texels(self) -> Vec<u8> {
        (0..TEXELS)
            .flat_map(|texel| {
                let colour = self.of_texel(texel);
                [colour.r, colour.g, colour.b, 255]
            })
            .collect()
    }

    /// The sRGB colour of a texel, each part 0 to 1.
    pub fn colour(self, texel: u8) -> Vec3 {
        let colour = self.of_texel(usize::from(texel));
        Vec3::new(f32::from(colour.r), f32::from(colour.g), f32::from(colour.b)) / 255.0
    }

    /// `count` CSS colours from the low to the high end of the map.
    pub fn stops(self, count: usize) -> Vec<String> {
        (0..count)
            .map(|i| {
                let part = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.0 };
                let colour = self.at(part);
                format!("rgb({} {} {})", colour.r, colour.g, colour.b)
            })
            .collect()
    }
}

/// The texel of a place from 0 to 1.
pub fn texel(part: f64) -> u8 {
    (part.clamp(0.0, 1.0) * (TEXELS - 1) as f64).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::appearance::{Colour, DARK, LIGHT};

    #[test]
    fn places_fall_on_the_map_and_stay_on_it() {
        let texels = [0.0, 0.5, 1.0, 9.0, -9.0].map(texel);
        assert_eq!(texels, [0, 128, 255, 255, 0]);
    }

    #[test]
    fn the_legend_and_the_texture_show_the_same_colours() {
        for map in [ColourMap::Full, ColourMap::Beyond] {
            let texels = map.texels();
            assert_eq!(texels.len(), TEXELS * 4);
            let stops = map.stops(3);
            for (stop, texel) in [(0, 0), (2, 255)] {
                let [r, g, b] = [0, 1, 2].map(|part| texels[4 * texel + part]);
                assert_eq!(stops[stop], format!("rgb({r} {g} {b})"));
            }
            assert_eq!(map.stops(1).len(), 1);
        }
        assert!(ColourMap::Full.stops(3)[2].starts_with("rgb(253 231 "));
    }

    #[test]
    fn the_map_grows_lighter_all_the_way() {
        let light = |t: &[u8]| 0.2126 * t[0] as f32 + 0.7152 * t[1] as f32 + 0.0722 * t[2] as f32;
        let texels = ColourMap::Full.texels();
        let lights: Vec<f32> = texels.chunks(4).map(light).collect();
        assert!(lights.windows(2).all(|w| w[1] > w[0] - 0.5));
        assert!(lights[255] - lights[0] > 150.0);
    }

    /// CIE L*a*b* of an sRGB colour, white D65.
    fn lab(colour: Vec3) -> Vec3 {
        let linear = colour.to_array().map(|part| {
            if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
        });
        let [x, y, z] = [
            [0.4124, 0.3576, 0.1805, 0.9505],
            [0.2126, 0.7152, 0.0722, 1.0],
            [0.0193, 0.1192, 0.9505, 1.089],
        ]
        .map(|[r, g, b, white]: [f32; 4]| {
            let part = (r * linear[0] + g * linear[1] + b * linear[2]) / white;
            if part > 0.008_856 { part.cbrt() } else { 7.787 * part + 16.0 / 116.0 }
        });
        Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    /// Just noticeable is a distance of about 2.3.
    #[test]
    fn beyond_the_tolerance_every_colour_differs_plainly_from_the_material_in_any_light() {
        let rgb = |[r, g, b, _]: Colour| Vec3::new(r, g, b);
        for palette in [LIGHT, DARK] {
            for light in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let modelled = 0.68 + 0.37 * light;
                let neutral = lab(rgb(palette.shade).lerp(rgb(palette.material), light));
                for texel in 0..=255 {
                    let colour = ColourMap::Beyond.colour(texel) * modelled;
                    let distance = lab(colour.min(Vec3::ONE)).distance(neutral);
                    assert!(distance > 20.0, "{distance} at {texel} in light {light}");
                }
            }
        }
    }

    #[test]
    fn beyond_the_tolerance_equal_steps_look_equal() {
        let stops: Vec<Vec3> =
            (0..=8).map(|i| lab(ColourMap::Beyond.colour(texel(f64::from(i) / 8.0)))).collect();
        let steps: Vec<f32> = stops.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
        let (least, most) = steps
            .iter()
            .fold((f32::MAX, 0.0_f32), |(least, most), &step| (least.min(step), most.max(step)));
        assert!(least > 10.0 && most < 1.4 * least, "{steps:?}");
        assert!(stops.windows(2).all(|pair| pair[1].x < pair[0].x), "it grows darker all the way");
    }
}
