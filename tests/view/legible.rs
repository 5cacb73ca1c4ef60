//! Visibility of marks on the colour maps for all types of colour vision: a selected face, or a
//! face of a highlighted constraint, is filled and hatched, a selected vertex is a dot with a rim,
//! and at least one of the two colours contrasts with any value.

use glam::{Mat3, Vec3};
use shape_up::constraint::KINDS;
use shape_up::view::appearance::{ColourMap, DARK, DotKind, LIGHT, LineKind, Palette};

/// Clearly visible difference in CIELAB: seven times the just noticeable difference of 2.3.
const PLAIN: f32 = 16.1;
/// The hatching of `shaders/faces.wgsl`.
const HATCH: f32 = 0.92;
const HATCH_OF_SELECTED: Vec3 = Vec3::new(0.06, 0.08, 0.11);
const TINT: f32 = 0.55;

/// Linear light as perceived without one type of cones (Machado, Oliveira and Fernandes 2009).
fn visions() -> [(&'static str, Mat3); 4] {
    let rows = |r: [[f32; 3]; 3]| Mat3::from_cols_array_2d(&r).transpose();
    [
        ("usual", Mat3::IDENTITY),
        (
            "protanopia",
            rows([
                [0.152286, 1.052583, -0.204868],
                [0.114503, 0.786281, 0.099216],
                [-0.003882, -0.048116, 1.051998],
            ]),
        ),
        (
            "deuteranopia",
            rows([
                [0.367322, 0.860646, -0.227968],
                [0.280085, 0.672501, 0.047413],
                [-0.011820, 0.042940, 0.968881],
            ]),
        ),
        (
            "tritanopia",
            rows([
                [1.255528, -0.076749, -0.178779],
                [-0.078411, 0.930809, 0.147602],
                [0.004733, 0.691367, 0.303900],
            ]),
        ),
    ]
}

/// CIE L*a*b* of an sRGB colour for a type of vision, white D65.
fn seen(colour: Vec3, vision: Mat3) -> Vec3 {
    let linear = |part: f32| {
        if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
    };
    let light = vision * Vec3::from(colour.to_array().map(linear));
    let light = light.clamp(Vec3::ZERO, Vec3::ONE);
    let [x, y, z] = [
        Vec3::new(0.4124, 0.3576, 0.1805) / 0.9505,
        Vec3::new(0.2126, 0.7152, 0.0722),
        Vec3::new(0.0193, 0.1192, 0.9505) / 1.089,
    ]
    .map(|row| {
        let part = row.dot(light);
        if part > 0.008_856 { part.cbrt() } else { 7.787 * part + 16.0 / 116.0 }
    });
    Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
}

/// Colours of every map, in dim and in bright light.
fn values() -> Vec<(ColourMap, Vec3, f32)> {
    let maps = [ColourMap::Viridis, ColourMap::Grey, ColourMap::Diverging(0.4), ColourMap::Beyond];
    let texels = (0..=255).step_by(15);
    let lit = |map: ColourMap, texel: u8| {
        [0.72, 1.03].map(|light| (map, (map.colour(texel) * light).min(Vec3::ONE), light))
    };
    maps.into_iter().flat_map(|map| texels.clone().flat_map(move |texel| lit(map, texel))).collect()
}

/// Fails unless, for every value and vision, one of the mark's two colours is clearly different
/// from the value.
fn assert_seen(what: &str, mark: impl Fn(Vec3, f32) -> [Vec3; 2]) {
    for (name, vision) in visions() {
        for (map, value, light) in values() {
            let mark = mark(value, light).map(|colour| seen(colour, vision));
            let difference = mark
                .map(|colour| colour.distance(seen(value, vision)))
                .into_iter()
                .fold(0.0, f32::max);
            assert!(difference > PLAIN, "{what} on {value} of {map:?}, {name}: {difference}");
        }
    }
}

fn themes() -> [&'static Palette; 2] {
    [&LIGHT, &DARK]
}

fn rgb(colour: [f32; 4]) -> Vec3 {
    Vec3::new(colour[0], colour[1], colour[2])
}

#[test]
fn selected_faces_are_seen_on_every_value() {
    for palette in themes() {
        let [.., much] = palette.selected;
        assert_seen("a selected face", |value, light| {
            let fill = (rgb(palette.selected) * light).min(Vec3::ONE);
            [value.lerp(fill, much), value.lerp(HATCH_OF_SELECTED, HATCH)]
        });
    }
}

#[test]
fn faces_of_every_kind_of_constraint_are_seen_on_every_value() {
    for kind in KINDS {
        let colour = Vec3::from(kind.colour.map(f32::from)) / 255.0;
        assert_seen(kind.label, |value, light| {
            let fill = (colour * light).min(Vec3::ONE);
            [value.lerp(fill, TINT), value.lerp(Vec3::ONE, HATCH)]
        });
    }
}

#[test]
fn dots_of_selected_vertices_and_handles_are_seen_on_every_value() {
    for palette in themes() {
        for kind in [DotKind::Selected, DotKind::Handle, DotKind::Fixed, DotKind::Active] {
            let dot = palette.dots[kind as usize];
            assert_seen("a dot", |_, _| [rgb(dot.fill), rgb(dot.rim)]);
        }
    }
}

#[test]
fn edges_are_seen_on_lit_and_on_shaded_faces_and_are_lighter_than_these_in_the_dark() {
    // They were as dark as the shade of the dark theme, where they vanished.
    for palette in themes() {
        let [.., much] = palette.strokes[LineKind::Edge as usize].colour;
        let edge = rgb(palette.strokes[LineKind::Edge as usize].colour);
        for face in [rgb(palette.material), rgb(palette.shade)] {
            let [line, around] = [face.lerp(edge, much), face].map(|it| seen(it, Mat3::IDENTITY));
            assert!(line.distance(around) > PLAIN, "{line} on {around}");
            assert_eq!(line.x > around.x, palette.shade == DARK.shade, "{line} on {around}");
        }
    }
}
