//! The example scenes.
//!
//! | file | holds |
//! |---|---|
//! | `first` | canopy, dome and hypar |
//! | `overview` | Fig. 1 |
//! | `squares` | Fig. 4 |
//! | `panels` | Fig. 5: planar and circular panels |
//! | `exploration` | Fig. 6: shapes of circular meshes and webs under handles |
//! | `quality` | Fig. 7: better quads on a surface with creases |
//! | `deformation` | Fig. 8: rigid and similar elements under handles |
//! | `flat_maps` | Fig. 9: conformal parametrisation |
//! | `recovery` | Fig. 10: from a collapsed start, and from a scattered one |
//! | `strip` | Fig. 11: edges that collapse |
//! | `curves_and_points` | curves on a mesh, points without faces |
//! | `exercise` | lessons to hand in |
//! | `beyond` | a limit from section 5, and other uses from section 6 |
//! | `parts` | constructors of constraints and handles |

mod beyond;
mod curves_and_points;
mod deformation;
mod exercise;
mod exploration;
mod first;
mod flat_maps;
mod overview;
mod panels;
mod parts;
mod quality;
mod recovery;
mod squares;
mod strip;

use super::declaration::Example;

/// All examples; the page opens the first.
pub const EXAMPLES: &[Example] = &[
    first::CANOPY,
    first::DOME,
    first::HYPAR,
    overview::OVERVIEW,
    overview::TRIANGLES,
    overview::TETRAHEDRA,
    squares::SQUARES,
    panels::PLANAR,
    panels::CIRCULAR,
    panels::MIXED,
    exploration::LANTERN,
    exploration::WEB,
    quality::ARCHWAY,
    deformation::PROTRUSIONS,
    deformation::RINGS[0],
    deformation::RINGS[1],
    deformation::RINGS[2],
    deformation::BLOCKS,
    deformation::BAR_POLYGONS,
    deformation::BAR_RINGS,
    deformation::BAR_TETS,
    flat_maps::MASK,
    flat_maps::POLYGONS,
    recovery::COLLAPSE,
    recovery::RANDOM,
    strip::STRIP,
    curves_and_points::SLABS,
    curves_and_points::POINTS,
    exercise::GLASS_ROOF,
    exercise::OFFSETS,
    exercise::CURVATURE,
    exercise::HEXAGONS,
    beyond::CHOICE,
    beyond::FIT,
    beyond::TRANSFER,
    beyond::SPLINE,
    beyond::STRIPS,
];
