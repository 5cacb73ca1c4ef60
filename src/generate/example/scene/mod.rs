//! The example scenes.

mod beyond;
mod curves;
mod elements;
mod exercise;
mod exercise_parts;
mod first;
mod flat_maps;
mod new_panels;
mod overview;
mod panels;
mod parts;

use super::declaration::Example;

/// All examples; the page opens the first. The gallery begins with those before the first figure.
pub const EXAMPLES: &[Example] = &[
    first::CANOPY,
    first::DOME,
    first::HYPAR,
    new_panels::VAULT,
    new_panels::STATION,
    new_panels::PAVILION,
    new_panels::CHALICE,
    curves::SLABS,
    beyond::STRIPS,
    beyond::SPLINE,
    beyond::TRANSFER,
    curves::POINTS,
    overview::OVERVIEW,
    overview::TRIANGLES,
    overview::TETRAHEDRA,
    panels::SQUARES,
    panels::PLANAR,
    panels::CIRCULAR,
    panels::MIXED,
    curves::LANTERN,
    curves::WEB,
    panels::ARCHWAY,
    elements::PROTRUSIONS,
    elements::RINGS[0],
    elements::RINGS[1],
    elements::RINGS[2],
    elements::BLOCKS,
    elements::BAR_POLYGONS,
    elements::BAR_RINGS,
    elements::BAR_TETS,
    flat_maps::MASK,
    flat_maps::POLYGONS,
    elements::COLLAPSE,
    elements::RANDOM,
    panels::STRIP,
    exercise::PROJECTION,
    exercise::CIRCLES,
    exercise::CURVATURE,
    exercise_parts::SURFACE,
    exercise_parts::OFFSETS,
    exercise_parts::HEXAGONS,
    exercise_parts::PAPER,
    exercise_parts::EXACT,
    exercise::GLASS_ROOF,
    beyond::CHOICE,
    beyond::FIT,
];
