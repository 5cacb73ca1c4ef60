//! Perceptually uniform colour maps of errors, which are also readable with colour blindness:
//! viridis (van der Walt and Smith 2015) and cividis (Nuñez, Anderton and Renslow 2018) from their
//! light to their dark ends, a grey map, one that diverges at a tolerance, and one for values beyond
//! a tolerance. In all of them small errors are light and unobtrusive, and large errors stand out.
//! Turbo (Mikhailov 2019) is neither; it is there for those who compare with pictures of other programs.
//!
//! Values of both signs have a map that is pale at zero and equally dark at both ends.
//!
//! Values within the tolerance have the colour of the material, light or dark. Therefore the map of
//! values beyond it starts pale, but distinct from every grey, and ends before it is dark: a nearly
//! perfect shape looks calm, and the worst faces are visible on both themes. Our own maps follow
//! straight lines in Oklab (Ottosson 2020) at constant speed.

use crate::view::model::ViewError;
use glam::{DVec3, Vec3};

/// Number of texels of the map's texture.
pub const TEXELS: usize = 256;

/// A colour map, and the values that it applies to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ColourMap {
    /// For all values: from yellow over green to violet.
    #[default]
    Viridis,
    /// For all values: from yellow over grey to dark blue, nearly the same with red-green blindness.
    Cividis,
    /// For all values: from blue over green and yellow to red, as many programs have it. Not uniform,
    /// and not readable with red-green blindness.
    Turbo,
    /// For all values: from nearly white to dark.
    Grey,
    /// For all values: from light blue over nearly white, at this fraction of the range, and orange
    /// to dark red.
    Diverging(f64),
    /// For values beyond a tolerance: from apricot over coral and magenta to violet.
    Beyond,
    /// For values of both signs, with zero in the middle: from blue over pale grey to orange.
    AroundZero,
}

impl ColourMap {
    /// Returns the map for all values that is called `viridis`, `cividis`, `turbo`, `grey` or
    /// `diverging`; the last one about the middle of the range.
    ///
    /// # Errors
    /// Any other name.
    pub fn named(name: &str) -> Result<ColourMap, ViewError> {
        match name {
            "viridis" => Ok(ColourMap::Viridis),
            "cividis" => Ok(ColourMap::Cividis),
            "turbo" => Ok(ColourMap::Turbo),
            "grey" => Ok(ColourMap::Grey),
            "diverging" => Ok(ColourMap::Diverging(0.5)),
            _ => {
                let (got, known) = (name.to_owned(), "viridis, cividis, turbo, grey or diverging");
                Err(ViewError::Word { what: "colour map", got, known })
            }
        }
    }
}

/// Vertices of [`ColourMap::Beyond`] in Oklab.
const BEYOND: [DVec3; 4] = [
    DVec3::new(0.873, 0.040, 0.050),
    DVec3::new(0.737, 0.106, 0.078),
    DVec3::new(0.579, 0.184, -0.027),
    DVec3::new(0.432, 0.122, -0.150),
];
/// Vertices of [`ColourMap::Grey`].
const GREY: [DVec3; 2] = [DVec3::new(0.965, 0.0, 0.0), DVec3::new(0.32, 0.0, 0.0)];
/// Vertices of [`ColourMap::Diverging`], below the middle and above it.
const WITHIN: [DVec3; 2] = [DVec3::new(0.79, -0.045, -0.085), DVec3::new(0.97, 0.0, 0.008)];
const ABOVE: [DVec3; 4] = [
    WITHIN[1],
    DVec3::new(0.80, 0.065, 0.050),
    DVec3::new(0.60, 0.145, 0.055),
    DVec3::new(0.36, 0.125, 0.030),
];

/// Vertices of [`ColourMap::AroundZero`]; its two halves have similar lightness.
const AROUND_ZERO: [DVec3; 5] = [
    DVec3::new(0.42, -0.025, -0.135),
    DVec3::new(0.68, -0.045, -0.085),
    DVec3::new(0.945, 0.0, 0.004),
    DVec3::new(0.70, 0.075, 0.095),
    DVec3::new(0.44, 0.105, 0.085),
];

/// Returns the colour at a fraction of the length of a polyline in Oklab.
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

/// Converts a colour inside the sRGB gamut from Oklab to sRGB.
fn srgb(oklab: DVec3) -> colorous::Color {
    let cone = |a: f64, b: f64| (oklab.x + a * oklab.y + b * oklab.z).powi(3);
    let long = cone(0.396_337_777_4, 0.215_803_757_3);
    let middle = cone(-0.105_561_345_8, -0.063_854_172_8);
    let short = cone(-0.089_484_177_5, -1.291_485_548_0);
    let byte = |l: f64, m: f64, s: f64| {
        let linear = (l * long + m * middle + s * short).clamp(0.0, 1.0);
        let part = if linear > 0.003_130_8 {
            // linear^(5/12) = linear^(1/3) * linear^(1/12).
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
    /// Returns the colour at a position from 0 to 1.
    fn at(self, part: f64) -> colorous::Color {
        match self {
            ColourMap::Viridis => colorous::VIRIDIS.eval_continuous(1.0 - part),
            ColourMap::Cividis => colorous::CIVIDIS.eval_continuous(1.0 - part),
            ColourMap::Turbo => colorous::TURBO.eval_continuous(part),
            ColourMap::Grey => along(&GREY, part),
            ColourMap::Diverging(middle) if part < middle => along(&WITHIN, part / middle),
            ColourMap::Diverging(middle) if middle >= 1.0 => along(&WITHIN, 1.0),
            ColourMap::Diverging(middle) => along(&ABOVE, (part - middle) / (1.0 - middle)),
            ColourMap::Beyond => along(&BEYOND, part),
            ColourMap::AroundZero => {
                // Zero is in the middle, whichever half is longer.
                let half = if part < 0.5 { &AROUND_ZERO[..3] } else { &AROUND_ZERO[2..] };
                along(half, if part < 0.5 { 2.0 * part } else { 2.0 * part - 1.0 })
            }
        }
    }

    fn of_texel(self, texel: usize) -> colorous::Color {
        match self {
            // The nearest of the 256 colours that define viridis.
            ColourMap::Viridis => colorous::VIRIDIS.eval_rational(TEXELS - 1 - texel, TEXELS),
            _ => self.at(texel as f64 / (TEXELS - 1) as f64),
        }
    }

    /// Returns the map as RGBA bytes, `TEXELS` by 4.
    pub fn texels(self) -> Vec<u8> {
        (0..TEXELS)
            .flat_map(|texel| {
                let colour = self.of_texel(texel);
                [colour.r, colour.g, colour.b, 255]
            })
            .collect()
    }

    /// Returns the sRGB colour of a texel, components from 0 to 1.
    pub fn colour(self, texel: u8) -> Vec3 {
        let colour = self.of_texel(usize::from(texel));
        Vec3::new(f32::from(colour.r), f32::from(colour.g), f32::from(colour.b)) / 255.0
    }

    /// Returns `count` CSS colours from the low to the high end of the map.
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

/// Returns the texel of a position from 0 to 1.
pub fn texel(part: f64) -> u8 {
    (part.clamp(0.0, 1.0) * (TEXELS - 1) as f64).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::appearance::{Colour, DARK, LIGHT};

    const ALL: [ColourMap; 5] = [
        ColourMap::Viridis,
        ColourMap::Cividis,
        ColourMap::Grey,
        ColourMap::Diverging(0.4),
        ColourMap::Beyond,
    ];

    #[test]
    fn places_fall_on_the_map_and_stay_on_it() {
        let texels = [0.0, 0.5, 1.0, 9.0, -9.0].map(texel);
        assert_eq!(texels, [0, 128, 255, 255, 0]);
    }

    #[test]
    fn the_legend_and_the_texture_show_the_same_colours() {
        for map in ALL.into_iter().chain([ColourMap::AroundZero]) {
            let texels = map.texels();
            assert_eq!(texels.len(), TEXELS * 4);
            let stops = map.stops(3);
            for (stop, texel) in [(0, 0), (2, 255)] {
                let [r, g, b] = [0, 1, 2].map(|part| texels[4 * texel + part]);
                assert_eq!(stops[stop], format!("rgb({r} {g} {b})"));
            }
            assert_eq!(map.stops(1).len(), 1);
        }
        assert!(ColourMap::Viridis.stops(3)[0].starts_with("rgb(253 231 "));
    }

    #[test]
    fn no_error_is_light_and_the_greatest_is_dark() {
        for map in ALL {
            let lightness = |texel: u8| lab(map.colour(texel)).x;
            assert!(lightness(0) > 72.0, "{map:?}: {}", lightness(0));
            assert!(lightness(255) < 40.0, "{map:?}: {}", lightness(255));
            // More is darker above the middle of a diverging map, and everywhere in the others.
            let first = if let ColourMap::Diverging(middle) = map { texel(middle) } else { 0 };
            let all: Vec<f32> = (first..=255).map(lightness).collect();
            assert!(all.windows(2).all(|pair| pair[1] < pair[0] + 0.25), "{map:?}");
        }
    }

    #[test]
    fn a_diverging_map_is_lightest_at_its_middle_wherever_that_is() {
        for middle in [0.0, 0.02, 0.3, 1.0] {
            let map = ColourMap::Diverging(middle);
            let lightest = lab(map.colour(texel(middle))).x;
            assert!(lightest > 93.0, "{middle}: {lightest}");
            assert!((0..=255).all(|texel| lab(map.colour(texel)).x <= lightest + 0.6));
        }
        let [below, above] = [0.0, 1.0].map(|part| ColourMap::Diverging(0.5).colour(texel(part)));
        assert!(below.z > below.x + 0.2 && above.x > above.z + 0.2, "blue below, red above");
    }

    #[test]
    fn maps_are_chosen_by_name() {
        assert_eq!(ColourMap::named("grey"), Ok(ColourMap::Grey));
        assert_eq!(ColourMap::named("diverging"), Ok(ColourMap::Diverging(0.5)));
        assert_eq!(ColourMap::named("cividis"), Ok(ColourMap::Cividis));
        assert_eq!(ColourMap::named("turbo"), Ok(ColourMap::Turbo));
        assert!(ColourMap::named("jet").is_err());
    }

    /// Returns the CIE L*a*b* coordinates of an sRGB colour, white D65.
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

    /// The just noticeable difference is about 2.3.
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

    /// In eighths of the map, or of each side of a diverging one, no step is much larger than
    /// another. Viridis is uniform in a newer colour space; in this one only its lightness is.
    #[test]
    fn equal_steps_look_equal() {
        let sides = [(0.0, 0.4), (0.4, 1.0)];
        let parts = [
            (ColourMap::Grey, (0.0, 1.0)),
            (ColourMap::Beyond, (0.0, 1.0)),
            (ColourMap::Diverging(0.4), sides[0]),
            (ColourMap::Diverging(0.4), sides[1]),
        ];
        for (map, (from, to)) in parts {
            let part = |i: usize| from + (to - from) * i as f64 / 8.0;
            let colour = |i: usize| map.at(part(i));
            let stops: Vec<Vec3> = (0..=8)
                .map(colour)
                .map(|c| lab(Vec3::new(f32::from(c.r), f32::from(c.g), f32::from(c.b)) / 255.0))
                .collect();
            let steps: Vec<f32> = stops.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
            let least = steps.iter().copied().fold(f32::MAX, f32::min);
            let most = steps.iter().copied().fold(0.0, f32::max);
            assert!(least > 3.0 && most < 1.5 * least, "{map:?} from {from}: {steps:?}");
        }
        let lightness = |i: usize| lab(ColourMap::Viridis.colour(texel(i as f64 / 8.0))).x;
        for i in 0..8 {
            let step = lightness(i) - lightness(i + 1);
            assert!((7.5..12.0).contains(&step), "{step} at {i}");
        }
    }

    #[test]
    fn around_zero_both_signs_are_alike_and_nothing_is_palest() {
        let at = |part: f64| lab(ColourMap::AroundZero.colour(texel(part)));
        let middle = at(0.5);
        assert!(middle.x > 88.0 && middle.y.abs() < 3.0 && middle.z.abs() < 5.0, "{middle}");
        let mut before = middle.x;
        for step in 1..=8 {
            let away = 0.0625 * f64::from(step);
            let [low, high] = [at(0.5 - away), at(0.5 + away)];
            assert!((low.x - high.x).abs() < 6.0, "{low} {high}");
            assert!(low.distance(high) > 8.0 * f32::from(step as u8).min(6.0), "{low} {high}");
            assert!(low.x < before && high.x < before + 3.0, "it grows darker");
            before = low.x;
        }
    }
}
