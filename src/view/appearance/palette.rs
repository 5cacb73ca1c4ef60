//! All colours and sizes of the picture, for both themes. Colours are sRGB, sizes CSS pixels.

/// An sRGB colour with opacity, components from 0 to 1.
pub type Colour = [f32; 4];

/// The style of a line.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// Colour and opacity.
    pub colour: Colour,
    /// Width.
    pub width: f32,
    /// Width of the casing on each side, which has the colour `colour`; the line has its own.
    pub casing: f32,
    /// Factor of the opacity where the surface hides the line.
    pub hidden: f32,
}

/// The style of a dot.
#[derive(Clone, Copy, Debug)]
pub struct Dot {
    /// The colour of the inside.
    pub fill: Colour,
    /// The colour of the rim.
    pub rim: Colour,
    /// Radius to the outside of the rim.
    pub radius: f32,
    /// Width of the rim.
    pub rim_width: f32,
    /// 0 for round, 1 for square.
    pub square: f32,
}

/// The meaning of a line; its value is its index in [`Palette::strokes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// An edge between two faces.
    Edge = 0,
    /// An edge on the boundary of the surface.
    Boundary = 1,
    /// A segment of a polyline.
    Curve = 2,
    /// From a handle to its target.
    Pull = 3,
    /// The outline of a projected shape; the shader uses its number.
    Outline = 4,
    /// From a vertex to its projection; the shader uses its number.
    Arrow = 5,
    /// A selected edge.
    Selected = 6,
    /// An edge of the mesh as it was opened; the shader uses its number.
    Ghost = 7,
    /// A line of the grid on the ground.
    Ground = 8,
    /// The measuring tape.
    Tape = 9,
    /// Between faces whose values are in different bands.
    Band = 10,
    /// A side of a face that the flat map flips.
    Flipped = 11,
    /// A line of the layer beside the surface; the shader uses its number.
    Layer = 12,
    /// A line of the layer where it cannot be built.
    Failed = 13,
    /// Over the surface, along the larger principal curvature; the shader uses its number.
    Larger = 14,
    /// Over the surface, along the smaller principal curvature; the shader uses its number.
    Smaller = 15,
    /// An edge along which a paper model is cut.
    Seam = 16,
}

/// The meaning of a dot; its value is its index in [`Palette::dots`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DotKind {
    /// A vertex.
    Vertex = 0,
    /// A member of a constraint that covers no face; its inside has the colour of the row.
    Member = 1,
    /// A member of the highlighted constraint; its inside has the tint.
    Tinted = 2,
    /// A selected vertex.
    Selected = 3,
    /// The target of a handle.
    Target = 4,
    /// A soft handle.
    Handle = 5,
    /// A fixed handle.
    Fixed = 6,
    /// The handle that is being moved.
    Active = 7,
    /// A mark on a selected handle.
    Chosen = 8,
    /// An end of the measuring tape.
    Tape = 9,
}

/// Number of kinds of lines.
pub const LINE_KINDS: usize = 17;
/// Number of kinds of dots.
pub const DOT_KINDS: usize = 10;

/// The colours and sizes of one theme.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// Background at the bottom; the page has the same gradient behind the canvas.
    pub background: Colour,
    /// Background at the top.
    pub backdrop: Colour,
    /// The shadow on the ground; its opacity applies where all light is blocked.
    pub shadow: Colour,
    /// Factor of the light on back faces.
    pub back: Colour,
    /// Faces in full light.
    pub material: Colour,
    /// Faces in shade; lighting interpolates between shade and material.
    pub shade: Colour,
    /// Faces whose value is NaN.
    pub no_value: Colour,
    /// Selected faces; the opacity is the fraction that is mixed in.
    pub selected: Colour,
    /// Indexed by [`LineKind`].
    pub strokes: [Stroke; LINE_KINDS],
    /// Edges between faces that have values. Dark, because the colour of a small error is light,
    /// and most faces have it in the end. Where errors are large, neighbouring faces differ anyway.
    pub edge_of_values: Colour,
    /// Dark squares of the checkerboard of a flat map.
    pub check: Colour,
    /// Edges between faces with a checkerboard: visible on both kinds of squares, but fainter.
    pub edge_of_checks: Colour,
    /// Indexed by [`DotKind`].
    pub dots: [Dot; DOT_KINDS],
    /// Fitted circles.
    pub circle: Stroke,
    /// Fitted spheres.
    pub sphere: Colour,
    /// The surface of the ghost; its opacity applies to a face seen from the front.
    pub ghost: Colour,
    /// The surface of the layer, likewise.
    pub layer: Colour,
    /// Arrows of the gizmo along x, y, z, and the squares perpendicular to them.
    pub axes: [Colour; 3],
    /// The casing that separates the gizmo from its background.
    pub axis_casing: Colour,
}

const BLUE: Colour = [0.13, 0.40, 0.93, 1.0];
const DEEP_BLUE: Colour = [0.07, 0.19, 0.47, 1.0];
const ORANGE: Colour = [0.96, 0.52, 0.07, 1.0];
const TAPE: Colour = [0.80, 0.09, 0.36, 1.0];
const WHITE: Colour = [1.0, 1.0, 1.0, 1.0];
const INK: Colour = [0.06, 0.08, 0.11, 1.0];

/// Factor of the opacity of most lines where they are hidden.
const HIDDEN: f32 = 0.38;

const fn stroke(colour: Colour, width: f32) -> Stroke {
    Stroke { colour, width, casing: 0.0, hidden: HIDDEN }
}

const fn seen_through(hidden: f32, colour: Colour, width: f32) -> Stroke {
    Stroke { colour, width, casing: 0.0, hidden }
}

/// Returns a line in the colour of a row of constraints.
const fn cased(width: f32) -> Stroke {
    Stroke { colour: [1.0, 1.0, 1.0, 0.7], width, casing: 0.8, hidden: HIDDEN }
}

const fn dot(fill: Colour, rim: Colour, radius: f32, rim_width: f32) -> Dot {
    Dot { fill, rim, radius, rim_width, square: 0.0 }
}

/// The light theme.
pub const LIGHT: Palette = Palette {
    background: [0.863, 0.875, 0.878, 1.0],
    backdrop: [0.965, 0.969, 0.965, 1.0],
    shadow: [0.165, 0.188, 0.235, 0.62],
    back: [0.875, 0.918, 0.985, 1.0],
    material: [1.0, 0.992, 0.975, 1.0],
    shade: [0.665, 0.665, 0.690, 1.0],
    no_value: [0.72, 0.72, 0.73, 1.0],
    selected: [0.99, 0.62, 0.16, 0.72],
    strokes: [
        stroke([0.22, 0.26, 0.33, 0.72], 1.0),
        stroke([0.13, 0.16, 0.21, 1.0], 1.9),
        stroke([0.10, 0.12, 0.16, 1.0], 2.4),
        stroke([0.13, 0.40, 0.93, 0.9], 1.5),
        cased(1.7),
        cased(1.5),
        stroke(ORANGE, 3.4),
        seen_through(0.26, [0.00, 0.50, 0.50, 0.80], 1.2),
        stroke([0.36, 0.41, 0.46, 0.34], 1.0),
        seen_through(0.75, TAPE, 2.2),
        stroke([0.05, 0.06, 0.09, 0.85], 1.8),
        stroke([0.84, 0.16, 0.20, 1.0], 2.6),
        seen_through(0.26, [0.40, 0.22, 0.70, 0.80], 1.2),
        seen_through(0.45, [0.84, 0.16, 0.20, 0.9], 2.0),
        stroke([0.78, 0.20, 0.10, 1.0], 2.0),
        stroke([0.05, 0.33, 0.72, 1.0], 2.0),
        stroke([0.00, 0.45, 0.36, 1.0], 3.0),
    ],
    edge_of_values: [0.10, 0.12, 0.17, 0.50],
    check: [0.20, 0.26, 0.36, 0.94],
    edge_of_checks: [0.45, 0.49, 0.56, 0.45],
    dots: [
        dot([0.16, 0.19, 0.24, 1.0], [0.985, 0.985, 0.985, 0.9], 3.1, 0.8),
        dot(WHITE, [1.0, 1.0, 1.0, 0.75], 3.3, 0.6),
        dot(WHITE, INK, 4.2, 1.2),
        dot(ORANGE, WHITE, 5.0, 1.3),
        dot([0.13, 0.40, 0.93, 0.12], BLUE, 5.0, 1.5),
        dot(BLUE, WHITE, 6.2, 1.4),
        Dot { fill: DEEP_BLUE, rim: WHITE, radius: 5.6, rim_width: 1.4, square: 1.0 },
        dot(BLUE, WHITE, 8.2, 1.8),
        dot(ORANGE, WHITE, 3.6, 1.0),
        dot(TAPE, WHITE, 4.6, 1.4),
    ],
    circle: stroke([0.07, 0.24, 0.53, 0.84], 1.1),
    sphere: [0.10, 0.36, 0.72, 1.0],
    ghost: [0.00, 0.50, 0.50, 0.13],
    layer: [0.46, 0.28, 0.78, 0.12],
    axes: [[0.82, 0.14, 0.18, 1.0], [0.10, 0.52, 0.16, 1.0], [0.14, 0.30, 0.86, 1.0]],
    axis_casing: [1.0, 1.0, 1.0, 0.85],
};

/// The dark theme.
pub const DARK: Palette = Palette {
    background: [0.094, 0.106, 0.114, 1.0],
    backdrop: [0.208, 0.224, 0.243, 1.0],
    shadow: [0.0, 0.004, 0.012, 0.85],
    back: [0.830, 0.900, 1.0, 1.0],
    material: [0.660, 0.655, 0.640, 1.0],
    shade: [0.190, 0.200, 0.230, 1.0],
    no_value: [0.40, 0.41, 0.43, 1.0],
    selected: [0.96, 0.56, 0.10, 0.72],
    strokes: [
        stroke([0.93, 0.95, 0.98, 0.60], 1.0),
        stroke([0.80, 0.83, 0.88, 1.0], 1.7),
        stroke([0.90, 0.92, 0.95, 1.0], 2.4),
        stroke([0.45, 0.65, 1.0, 0.95], 1.5),
        cased(1.7),
        cased(1.5),
        stroke([1.0, 0.60, 0.15, 1.0], 3.4),
        seen_through(0.26, [0.38, 0.86, 0.82, 0.72], 1.2),
        stroke([0.62, 0.68, 0.74, 0.30], 1.0),
        seen_through(0.75, [1.0, 0.42, 0.62, 1.0], 2.2),
        stroke([0.02, 0.02, 0.03, 0.9], 1.8),
        stroke([1.0, 0.40, 0.38, 1.0], 2.6),
        seen_through(0.26, [0.74, 0.62, 1.0, 0.75], 1.2),
        seen_through(0.45, [1.0, 0.47, 0.43, 0.9], 2.0),
        stroke([1.0, 0.58, 0.36, 1.0], 2.0),
        stroke([0.50, 0.76, 1.0, 1.0], 2.0),
        stroke([0.25, 0.88, 0.70, 1.0], 3.0),
    ],
    edge_of_values: [0.05, 0.06, 0.09, 0.60],
    check: [0.125, 0.145, 0.185, 0.95],
    edge_of_checks: [0.40, 0.43, 0.48, 0.45],
    dots: [
        dot([0.93, 0.95, 0.97, 1.0], [0.08, 0.09, 0.11, 0.9], 3.1, 0.8),
        dot(WHITE, [0.08, 0.09, 0.11, 0.75], 3.3, 0.6),
        dot(WHITE, INK, 4.2, 1.2),
        dot([1.0, 0.60, 0.15, 1.0], INK, 5.0, 1.3),
        dot([0.45, 0.65, 1.0, 0.15], [0.45, 0.65, 1.0, 1.0], 5.0, 1.5),
        dot([0.22, 0.50, 1.0, 1.0], WHITE, 6.2, 1.4),
        Dot { fill: [0.11, 0.26, 0.62, 1.0], rim: WHITE, radius: 5.6, rim_width: 1.4, square: 1.0 },
        dot([0.22, 0.50, 1.0, 1.0], WHITE, 8.2, 1.8),
        dot([1.0, 0.60, 0.15, 1.0], INK, 3.6, 1.0),
        dot([1.0, 0.42, 0.62, 1.0], INK, 4.6, 1.4),
    ],
    circle: stroke([0.62, 0.78, 0.97, 0.68], 1.1),
    sphere: [0.52, 0.76, 1.0, 1.0],
    ghost: [0.38, 0.86, 0.82, 0.13],
    layer: [0.74, 0.62, 1.0, 0.13],
    axes: [[1.0, 0.42, 0.42, 1.0], [0.45, 0.86, 0.42, 1.0], [0.48, 0.68, 1.0, 1.0]],
    axis_casing: [0.05, 0.06, 0.08, 0.80],
};
